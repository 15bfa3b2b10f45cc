// SPDX-License-Identifier: MIT
// machine.hpp - the machine of a measurement: enough to compare, and no names of hosts or users.
#pragma once
#include <cstdint>
#include <string>

namespace convexact {

struct Machine {
  std::string processor;     ///< As the system calls it; "unknown" where it does not say.
  unsigned cores = 0;        ///< That the process may use; 0 if unknown.
  std::uint64_t memory = 0;  ///< Bytes; 0 if unknown.
};

/// Of Linux, from /proc.
[[nodiscard]] Machine this_machine();

}  // namespace convexact
