// SPDX-License-Identifier: MIT
// expect_error.hpp - runs an action that must be refused, and returns the error.
#pragma once
#include <doctest/doctest.h>

#include "convexact/error.hpp"

/// The Error that `action` throws. Anything else fails the test case.
template <class Action>
convexact::Error error_of(Action&& action) {
  try {
    (void)action();
  } catch (const convexact::Error& error) {
    return error;
  }
  FAIL("nothing was thrown");
  return {convexact::ErrorCode::Internal, ""};
}
