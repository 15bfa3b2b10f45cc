// SPDX-License-Identifier: MIT
// growth_limit.hpp - how long a run may go on before its measure has grown too much.
#pragma once
#include <optional>
#include <vector>

#include "convexact/cost.hpp"
#include "convexact/geometry.hpp"
#include "convexact/run.hpp"

namespace convexact {

/// Decides M <= (1 + g) M0, where M is M0, the measure of the input, plus what the steps so far
/// have added to it.
class GrowthLimit {
 public:
  /// @param polytope  The input.
  /// @param options   The measure, growth_measure(); g = max_growth; how far mean widths are
  ///                  compared.
  /// @throws Error    InvalidArgument if g < 0.
  GrowthLimit(Polytope polytope, const SimplifyOptions& options);

  /// Whether a further step of this cost, in the measure of the limit, stays within it; if so, it
  /// counts from now on. An undecided comparison counts as beyond.
  /// @par Cost  Constant while enclosures decide; an exact sum of all costs where they do not.
  [[nodiscard]] bool allows(const Cost& cost);
  /// If the last comparison was undecided: the bits of its enclosures; else 0.
  long undecided_bits() const { return undecided_bits_; }

 private:
  bool allows_exactly(const Cost& cost);

  Polytope polytope_;
  const SimplifyOptions& options_;
  Enclosure allowance_;  // g M0
  Enclosure spent_;      // the costs so far
  std::vector<Cost> costs_;
  long undecided_bits_ = 0;
  std::optional<Cost> exact_allowance_;  // once it was needed
};

}  // namespace convexact
