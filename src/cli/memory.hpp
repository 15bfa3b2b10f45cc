// SPDX-License-Identifier: MIT
// memory.hpp - how much memory the program may use, and how it ends when there is no more.
#pragma once
#include <cstdint>
#include <functional>

namespace convexact::cli {

/// Makes GMP and MPFR allocate through here. To be called before any number exists.
void install_memory_functions();

/// From now on at most `bytes` of heap may be in use; memory in use already is not counted.
///
/// C++ gets std::bad_alloc from seven eighths of that on, so that a run ends by unwinding, as after
/// any error. No exception may pass through GMP: it may use the last eighth, and if that is full as
/// well the process ends, after `last_words`, with the exit code of Stopped.
void limit_memory(std::uint64_t bytes, std::function<void()> last_words);

/// To be called before an error is reported, which takes memory, too.
void lift_memory_limit() noexcept;

}  // namespace convexact::cli
