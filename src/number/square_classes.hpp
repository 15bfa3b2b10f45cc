// SPDX-License-Identifier: MIT
// square_classes.hpp - positive integers by square class.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/number.hpp"

namespace convexact {

/// Positive integers, sorted into classes: two are in one class if their product is a square, so
/// that their roots are rational multiples of each other.
struct SquareClasses {
  /// number = multiple^2 * representatives[index].
  struct Member {
    std::size_t index;
    Integer multiple;
  };
  /// One for each class: the greatest common divisor of its members, so not always squarefree. The
  /// first class, which may be empty, is that of the squares, with the representative 1.
  std::vector<Integer> representatives;
  std::vector<Member> members;  ///< Of each number, in their order.
};

/// Sorts n >= 0 integers > 0 into square classes, without factoring them.
/// @throws Error Stopped when the watch ends the call.
/// @par Cost  Residues of each number modulo 32 primes, which tell most classes apart; then a gcd
///            and two integer roots for each pair that they leave.
[[nodiscard]] SquareClasses square_classes(std::span<const Integer> numbers,
                                           const Watch& watch = {});

}  // namespace convexact
