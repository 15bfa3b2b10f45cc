// SPDX-License-Identifier: MIT
// unless_refused.hpp - the result of a reader on some bytes, or nothing if it refused them as
// documented.
#pragma once
#include <optional>

#include "convexact/error.hpp"
#include "fuzz_check.hpp"

/// The result of `read`, or nothing if it threw an Error of exit code 3 that says something.
template <class Read>
auto unless_refused(Read&& read) -> std::optional<decltype(read())> {
  try {
    return read();
  } catch (const convexact::Error& error) {
    FUZZ_CHECK(convexact::exit_code(error.code()) == 3);
    FUZZ_CHECK(error.what()[0] != '\0');
    return {};
  }
}
