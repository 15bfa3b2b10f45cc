// SPDX-License-Identifier: MIT
// property.hpp - a rapidcheck property as a doctest assertion: on failure the shrunk counterexample
// is printed to stderr and the case fails.
#pragma once
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <string>

template <class Testable>
void check_property(const std::string& claim, Testable&& testable) {
  CHECK_MESSAGE(rc::check(claim, std::forward<Testable>(testable)), claim);
}
