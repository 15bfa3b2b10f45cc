// SPDX-License-Identifier: MIT
// checker.hpp - convexact-check within the test's own process, for thousands of proofs a second.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

struct CheckerVerdict {
  int exit_code;
  std::string said;  ///< What it would print.
};

/// What convexact-check says of a proof, and of a mesh file if one is given: its source, compiled
/// here, from after its main().
CheckerVerdict check_proof(const std::string& text, const std::string& mesh = "");

/// The sign, -1, 0 or 1, of a sum of square roots as the checker finds it.
/// @param terms  Of each its factor, p/q, and its radicand, an integer > 0.
int sign_by_checker(const std::vector<std::array<std::string, 2>>& terms);

/// The points ("x y z") or primitive halfspaces ("n1 n2 n3 d") of a mesh file as the checker reads
/// it, as fractions, sorted and without repeats; none if it refuses the file.
/// @param path  Only its extension matters.
std::optional<std::vector<std::string>> rows_by_checker(const std::string& bytes,
                                                        const std::string& path, bool as_spelt);

/// The faces of a mesh file as the checker reads them: of each the points in a row, "x y z, x y z,
/// ...", as fractions; none if it refuses the file.
std::optional<std::vector<std::string>> faces_by_checker(const std::string& bytes,
                                                         const std::string& path, bool as_spelt);
