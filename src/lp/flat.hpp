// SPDX-License-Identifier: MIT
// flat.hpp - the intersection of hyperplanes of a linear program, as a map from its free
// coordinates; and numbers with a symbolic infinity.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "convexact/number.hpp"

namespace convexact::detail {

// Numbers here are a + b M with integers a, b and one symbol M above every rational, so they
// compare by b, then by a. Only offsets and points have a part b; normals do not.
enum Column : std::size_t { kFinite = 0, kInfinite = 1, kFirstNormal = 2 };

/// One constraint n.x + (a + b M) <= 0 as k + 2 integers (a, b, n_1, ..., n_k).
using RowView = std::span<const Integer>;

/// The point (finite + infinite M) / denominator.
struct Vertex {
  std::vector<Integer> finite;
  std::vector<Integer> infinite;
  Integer denominator;  ///< > 0
  bool is_finite;       ///< Whether `infinite` is zero.
};

/// x_i = (F(i, kFinite) + F(i, kInfinite) M + sum over free j of F(i, kFirstNormal + j) x_j) / W.
/// All entries are minors of the rows that cut it, so they stay short and each division by the
/// previous denominator is exact (fraction-free elimination [Bareiss1968]).
class Flat {
 public:
  /// The whole space of k coordinates.
  explicit Flat(std::size_t dimension);

  /// Where the hyperplane of `row` meets the flat, with one free coordinate less; nothing if the
  /// normal vanishes on the flat.
  std::optional<Flat> cut_by(RowView row) const;

  bool is_free(std::size_t coordinate) const { return free_[coordinate]; }
  /// The coordinate that the last cut_by() made dependent.
  std::size_t last_pivot() const { return last_pivot_; }

  /// Whether (objective, x_1, x_2, ...), compared lexicographically, grows with a free coordinate.
  /// (If not, it falls: x_j itself is among them.)
  bool grows_with(std::size_t coordinate, std::span<const Integer> objective) const;

  /// The point whose free coordinate j is +M where `at_top[j]`, else -M.
  Vertex corner(const std::vector<bool>& at_top) const;

 private:
  std::size_t width() const { return free_.size() + kFirstNormal; }
  const Integer& form(std::size_t i, std::size_t column) const {
    return forms_[i * width() + column];
  }
  // A row restricted to the flat, as a function of the free coordinates, times W.
  std::vector<Integer> restrict(RowView row) const;

  std::vector<Integer> forms_;  // F, row by row
  Integer denominator_;         // W > 0
  std::vector<bool> free_;
  std::size_t last_pivot_ = 0;
};

}  // namespace convexact::detail
