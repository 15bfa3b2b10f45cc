// SPDX-License-Identifier: MIT
#include "stored/acceptance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "convexact/error.hpp"
#include "convexact/linear_program.hpp"
#include "convexact/measure.hpp"
#include "convexact/number.hpp"
#include "convexact/stored.hpp"
#include "lp/interior_point.hpp"
#include "near/near_plane.hpp"
#include "number/arithmetic.hpp"
#include "number/precision.hpp"

namespace convexact::stored {
namespace {

Rational squared_norm(const RationalVector3& v) { return v.dot(v); }

// Coordinates about the center, scaled by 2^-exponent so that they are at most about 1.
Point to_local(const RationalVector3& v, long exponent) {
  Point p;
  for (int k = 0; k < 3; ++k) {
    p[k] = to_double(scale_by_power_of_two(v[k], -exponent), Rounding::Nearest);
  }
  return p;
}

// A solid seen from a point strictly inside it.
struct CenteredSolid {
  std::vector<RationalVector3> vertices;  // minus the center
  std::vector<RationalVector3> polars;  // n / w, w = -(n.center + d) > 0: the solid is polar.x <= 1

  CenteredSolid(const Polytope& polytope, const RationalPoint& center) {
    for (const RationalPoint& v : polytope.vertices) vertices.push_back(v - center);
    for (const Halfspace& h : polytope.planes) {
      const Rational w = -h(center);
      if (w <= 0) throw Error(ErrorCode::InvalidArgument, "the center is not inside the solid");
      polars.push_back(h.normal().cast<Rational>() / w);
    }
  }
};

// Bounds max over the vertices of `from` of the distance to `to`.
class OneSidedBound {
 public:
  OneSidedBound(const CenteredSolid& from, const CenteredSolid& to, long exponent)
      : from_(from), to_(to) {
    for (const RationalVector3& v : to.vertices) near_.push_back(to_local(v, exponent));
    for (const RationalVector3& y : to.polars) polars_.push_back(to_local(y, -exponent));
    for (const RationalVector3& v : from.vertices) locals_.push_back(to_local(v, exponent));
  }

  Rational squared() {
    // From the vertex that seems farthest on; no later one can raise the bound once the distance to
    // its nearest vertex is below it.
    std::vector<std::size_t> nearest(locals_.size());
    std::vector<Rational> reach(locals_.size());
    std::vector<std::size_t> order(locals_.size());
    std::iota(order.begin(), order.end(), 0);
    for (const std::size_t i : order) {
      nearest[i] = nearest_vertex(locals_[i]);
      reach[i] = squared_norm(from_.vertices[i] - to_.vertices[nearest[i]]);
    }
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return reach[a] > reach[b]; });
    Rational bound = 0;
    for (const std::size_t i : order) {
      if (reach[i] <= bound) break;
      bound = std::max(bound, std::min(reach[i], squared_way_in(i)));
    }
    return bound;
  }

 private:
  // A good guess is enough: the distance to any vertex is an upper bound.
  std::size_t nearest_vertex(const Point& p) const {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < near_.size(); ++j) {
      const double distance = (near_[j] - p).squaredNorm();
      if (distance < least) least = distance, best = j;
    }
    return best;
  }

  // With g = max over the planes of polar.v the point v/g is in the solid, and v is if g <= 1.
  Rational squared_way_in(std::size_t i) const {
    const Rational g = gauge(i);
    if (g <= 1) return 0;
    const Rational part = 1 - 1 / g;
    return squared_norm(from_.vertices[i]) * part * part;
  }

  // The largest polar.v, exactly; doubles only exclude planes.
  Rational gauge(std::size_t i) const {
    std::vector<double> upper(polars_.size());
    double best_lower = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < polars_.size(); ++k) {
      const Point& y = polars_[k];
      const Point product = y.cwiseProduct(locals_[i]);
      const double value = product[0] + product[1] + product[2];
      const double error = kRelativePlaneError * product.cwiseAbs().sum() +
                           absolute_plane_error(std::max(1.0, y.cwiseAbs().maxCoeff()));
      upper[k] = value + error;
      best_lower = std::max(best_lower, value - error);
    }
    std::optional<Rational> largest;
    for (std::size_t k = 0; k < polars_.size(); ++k) {
      if (upper[k] < best_lower) continue;  // false for NaN
      const Rational value = to_.polars[k].dot(from_.vertices[i]);
      if (!largest || value > *largest) largest = value;
    }
    CONVEXACT_ASSERT(largest.has_value());
    return *largest;
  }

  const CenteredSolid& from_;
  const CenteredSolid& to_;
  std::vector<Point> near_;    // vertices of `to`
  std::vector<Point> polars_;  // of `to`
  std::vector<Point> locals_;  // vertices of `from`
};

// sqrt(x) rounded up: the square root of a double is within half an ulp.
double root_up(const Rational& x) {
  if (x == 0) return 0;
  const double root = std::sqrt(to_double(x, Rounding::Up));
  return std::nextafter(root, std::numeric_limits<double>::infinity());
}

}  // namespace

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

Growth growth(const Polytope& exact, const Polytope& stored, const RationalPoint& center,
              const Rational& squared_diameter) {
  const CenteredSolid a(exact, center), b(stored, center);
  const long exponent =
      std::max(largest_exponent(a.vertices), largest_exponent(b.vertices)).value();
  const Rational squared =
      std::max(OneSidedBound(a, b, exponent).squared(), OneSidedBound(b, a, exponent).squared());
  Growth growth;
  growth.push = root_up(squared / squared_diameter);
  // The exact quotient would be as long as all denominators together: over a second for 3,000
  // halfspaces.
  growth.volume_ratio =
      (enclose_volume(stored, kMeasureBits) / enclose_volume(exact, kMeasureBits)).high_double();
  return growth;
}

Growth checked_growth(const Polytope& exact, const Polytope& polytope, const PointSet& input,
                      std::span<const PointId> witnesses, Precision precision) {
  std::vector<Halfspace> both = exact.planes;
  both.insert(both.end(), polytope.planes.begin(), polytope.planes.end());
  const RationalPoint center = interior_point(input, witnesses, both);
  const Rational squared = bounding_box(input).squared_diameter();
  const Growth result = growth(exact, polytope, center, squared);
  const char* const too_far =
      "after rounding, its distance from the exact solid exceeds the length of that solid";
  if (!std::isfinite(result.push)) refuse(precision, too_far);
  const Rational push = to_rational(result.push);
  if (push * push * squared > bounding_box(exact.vertices).squared_diameter())
    refuse(precision, too_far);
  return result;
}

}  // namespace convexact::stored
