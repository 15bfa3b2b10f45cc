// SPDX-License-Identifier: MIT
// checker.hpp - convexact-check within the test's own process, for thousands of proofs a second.
#pragma once
#include <string>

struct CheckerVerdict {
  int exit_code;
  std::string said;  ///< What it would print.
};

/// What convexact-check says of a proof: its source, compiled here, from after its main().
CheckerVerdict check_proof(const std::string& text);
