// SPDX-License-Identifier: MIT
// memory.hpp - how much memory the program may take, and how it ends where there is no more.
#pragma once
#include <cstdint>
#include <functional>

namespace convexact::cli {

/// Makes GMP and MPFR allocate through here. To be called before any number exists.
void install_memory_functions();

/// From now on at most `bytes` of heap may be in use; what is in use already is not counted.
///
/// C++ gets std::bad_alloc from seven eighths of that on, so that a run ends by unwinding, as after
/// any error. No exception may pass through GMP: it may go on into the last eighth, and if that is
/// full as well the process ends there, after `last_words`, with the exit code of Stopped.
void limit_memory(std::uint64_t bytes, std::function<void()> last_words);

/// Before an error is told: that takes memory, too.
void lift_memory_limit() noexcept;

}  // namespace convexact::cli
