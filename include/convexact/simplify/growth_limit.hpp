// SPDX-License-Identifier: MIT
// growth_limit.hpp - how long a run may go on before its volume has grown too much.
#pragma once
#include <optional>
#include <vector>

#include "convexact/dual/dual_hull.hpp"
#include "convexact/number/rational.hpp"

namespace convexact {

/// Decides V <= (1 + g) V0, where V is V0 plus the costs of the steps so far.
class GrowthLimit {
 public:
  /// @param solid       Its volume is V0; must outlive this object.
  /// @param max_growth  g >= 0; none allows everything.
  /// @throws Error      InvalidArgument if g < 0.
  GrowthLimit(const DualHull& solid, std::optional<Rational> max_growth);

  /// Whether a further step of this cost stays within the limit; if so, it counts from now on.
  [[nodiscard]] bool allows(const Rational& cost);

 private:
  const DualHull& solid_;
  std::optional<Rational> max_growth_;
  std::optional<Rational> allowance_;  // g V0, computed when first asked for
  std::vector<Rational> costs_;
};

}  // namespace convexact
