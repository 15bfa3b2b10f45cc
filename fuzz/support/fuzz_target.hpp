// SPDX-License-Identifier: MIT
// fuzz_target.hpp - all targets by name, in one program: each file of targets adds those that it
// defines.
#pragma once
#include <string_view>
#include <vector>

#include "fuzz_input.hpp"

/// A property that must hold for every input; it is violated by ending the process.
struct FuzzTarget {
  /// Adds the target to the list of all. For objects that live as long as the program.
  FuzzTarget(const char* called, void (*held)(FuzzInput& in));

  const char* name;
  void (*hold)(FuzzInput& in);

  static const std::vector<const FuzzTarget*>& all();
  /// Nothing if there is no such target.
  static const FuzzTarget* find(std::string_view name);
};
