// SPDX-License-Identifier: MIT
// growth_watch.hpp - how far a volume may grow, decided by enclosures and in doubt by rationals.
#pragma once
#include <functional>
#include <optional>
#include <span>

#include "convexact/number.hpp"
#include "fast/dual.hpp"

namespace convexact {

/// Volume of the solid whose dual hull the triangles are, exactly, in the caller's cubed units.
[[nodiscard]] Rational exact_volume(const FastDual& dual, std::span<const DualTriangle> triangles);

/// Watches that the sum of costs stays within max_growth times the initial volume.
class GrowthWatch {
 public:
  /// @param max_growth  None: everything is allowed, and no volume is computed.
  /// @throws Error      InvalidArgument if negative.
  GrowthWatch(const FastDual& dual, const std::optional<Rational>& max_growth);

  /// Whether a step of this cost, in units of FastDual::volume_exponent(), may follow the allowed
  /// ones. If so it counts from now on.
  /// @param volume_after  The exact volume after the step; asked for where enclosures overlap.
  bool allows(double lower, double upper, const std::function<Rational()>& volume_after);

 private:
  const FastDual& dual_;
  std::optional<Rational> max_growth_;
  double limit_lower_ = 0, limit_upper_ = 0;  // of max_growth times the initial volume
  double grown_lower_ = 0, grown_upper_ = 0;  // of the costs so far
  std::optional<Rational> exact_limit_;       // of (1 + max_growth) times that volume
};

}  // namespace convexact
