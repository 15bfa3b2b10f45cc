// SPDX-License-Identifier: MIT
// sweep.hpp - marks test cases that builds with sanitizers leave out.
#pragma once
#include <doctest/doctest.h>

/// Thousands of runs against a definition, or hundreds of the program: a second or more without
/// sanitizers, minutes with them, through product code that other cases run with sanitizers as
/// well. TEST_CASE("name" * sweep)
inline const doctest::test_suite sweep{"sweep"};
