// SPDX-License-Identifier: MIT
// growth_limit.hpp - how long a run may go on before its volume has grown too much.
#pragma once
#include <optional>
#include <vector>

#include "convexact/number.hpp"
#include "convexact/polytope.hpp"

namespace convexact {

/// Decides V <= (1 + g) V0, where V is V0 plus the costs of the steps so far.
class GrowthLimit {
 public:
  /// @param polytope    The input, of volume V0.
  /// @param max_growth  g >= 0.
  /// @throws Error      InvalidArgument if g < 0.
  GrowthLimit(Polytope polytope, Rational max_growth);

  /// Whether a further step of this cost stays within the limit; if so, it counts from now on.
  /// @par Cost  Constant while enclosures decide; an exact sum of all costs where they do not.
  [[nodiscard]] bool allows(const Rational& cost);

 private:
  Polytope polytope_;
  Rational max_growth_;
  Enclosure allowance_;  // g V0
  Enclosure spent_;      // the costs so far
  std::vector<Rational> costs_;
  std::optional<Rational> exact_allowance_;  // once it was needed
};

}  // namespace convexact
