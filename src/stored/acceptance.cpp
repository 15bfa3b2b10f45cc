// SPDX-License-Identifier: MIT
#include "stored/acceptance.hpp"

#include <cmath>

#include "convexact/error.hpp"
#include "convexact/linear_program.hpp"
#include "convexact/measure.hpp"
#include "convexact/stored.hpp"
#include "lp/interior_point.hpp"
#include "number/arithmetic.hpp"

namespace convexact::stored {

RationalPoint interior_point(const PointSet& points, std::span<const PointId> witnesses,
                             std::span<const Halfspace> halfspaces) {
  Point mean = Point::Zero();
  const auto count = static_cast<double>(witnesses.size());
  for (const PointId id : witnesses) mean += points.doubles()[id.index()] / count;
  if (mean.allFinite()) {
    RationalPoint rounded = to_rational(mean);
    if (is_strictly_inside(halfspaces, rounded)) return rounded;
  }
  RationalPoint exact;
  for (int k = 0; k < 3; ++k) {
    std::vector<Rational> terms;
    for (const PointId id : witnesses) terms.push_back(points[id][k]);
    exact[k] = balanced_sum(std::move(terms)) / witnesses.size();
  }
  return exact;
}

void refuse(Precision precision, const std::string& why) {
  const std::string name = precision == Precision::Binary64 ? "binary64" : "binary32";
  throw Error(ErrorCode::Unrepresentable, name + " cannot hold the result: " + why +
                                              "; exact integers hold it (.json or .ine)");
}

std::size_t final_pass(std::span<const Halfspace> halfspaces, const PointSet& input) {
  const std::size_t violations = count_outside(halfspaces, input);
  if (violations > 0) {
    throw Error(ErrorCode::Internal,
                std::to_string(violations) + " input points are outside the rounded result");
  }
  return violations;
}

Growth checked_growth(const Polytope& exact, const Polytope& polytope, const PointSet& input,
                      std::span<const PointId> witnesses, Precision precision) {
  std::vector<Halfspace> both = exact.planes;
  both.insert(both.end(), polytope.planes.begin(), polytope.planes.end());
  const RationalPoint center = interior_point(input, witnesses, both);
  const Rational squared = bounding_box(input).squared_diameter();
  const Growth result = growth(exact, polytope, center, squared);
  const char* const too_far = "rounded, it lies farther from the exact one than that one is long";
  if (!std::isfinite(result.push)) refuse(precision, too_far);
  const Rational push = to_rational(result.push);
  if (push * push * squared > bounding_box(exact.vertices).squared_diameter())
    refuse(precision, too_far);
  return result;
}

}  // namespace convexact::stored
