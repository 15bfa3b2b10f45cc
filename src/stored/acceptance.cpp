// SPDX-License-Identifier: MIT
#include "stored/acceptance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

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

using EnclosedVector = std::array<Enclosure, 3>;

EnclosedVector enclose(const RationalVector3& v) {
  return {Enclosure(v[0], kMeasureBits), Enclosure(v[1], kMeasureBits),
          Enclosure(v[2], kMeasureBits)};
}

Enclosure dot(const EnclosedVector& a, const EnclosedVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// A vector exactly, in an enclosure, and as doubles on the scale of both solids.
struct SeenVector {
  RationalVector3 exact;
  EnclosedVector enclosed;
  Point near;

  explicit SeenVector(RationalVector3 v)
      : exact(std::move(v)), enclosed(enclose(exact)), near(Point::Zero()) {}
};

// A solid seen from a point strictly inside it.
struct CenteredSolid {
  std::vector<SeenVector> vertices;  // minus the center
  std::vector<SeenVector> polars;    // n / w, w = -(n.center + d) > 0: the solid is polar.x <= 1

  CenteredSolid(const Polytope& polytope, const RationalPoint& center) {
    for (const RationalPoint& v : polytope.vertices) vertices.emplace_back(v - center);
    for (const Halfspace& h : polytope.planes) {
      const Rational w = -h(center);
      if (w <= 0) throw Error(ErrorCode::InvalidArgument, "the center is not inside the solid");
      polars.emplace_back(h.normal().cast<Rational>() / w);
    }
  }

  void set_scale(long exponent) {
    for (SeenVector& v : vertices) v.near = to_local(v.exact, exponent);
    for (SeenVector& y : polars) y.near = to_local(y.exact, -exponent);
  }
};

long largest_exponent_of(const CenteredSolid& solid) {
  std::optional<long> largest;
  for (const SeenVector& v : solid.vertices) {
    largest = std::max(largest, largest_exponent(std::span(&v.exact, 1)));
  }
  return largest.value();
}

// The nearest of some vertices, up to rounding, by their order along one direction. A symmetric
// solid has many vertices at one height over a coordinate plane, but seldom over an oblique one.
class NearestVertex {
 public:
  explicit NearestVertex(const std::vector<SeenVector>& vertices) : vertices_(vertices) {
    for (std::size_t j = 0; j < vertices.size(); ++j)
      order_.emplace_back(height(vertices[j].near), j);
    std::sort(order_.begin(), order_.end());
  }

  // The first of several.
  // @par Cost  A search in n heights, and those vertices that are nearer to p in height than the
  //            nearest is to p.
  std::size_t operator()(const Point& p) const {
    const double at_p = height(p);
    auto above = std::lower_bound(order_.begin(), order_.end(), std::pair(at_p, std::size_t{0}));
    auto below = above;
    std::size_t best = 0;
    double least = kInfinite;
    for (;;) {
      const double up = above == order_.end() ? kInfinite : above->first - at_p,
                   down = below == order_.begin() ? kInfinite : at_p - std::prev(below)->first;
      const double gap = std::min(up, down);
      if (gap == kInfinite || gap * gap > least) return best;
      const std::size_t j = up <= down ? (above++)->second : (--below)->second;
      const double distance = (vertices_[j].near - p).squaredNorm();
      if (distance < least || (distance == least && j < best)) least = distance, best = j;
    }
  }

 private:
  static constexpr double kInfinite = std::numeric_limits<double>::infinity();
  static double height(const Point& p) { return Point(0.48, 0.6, 0.64).dot(p); }  // a unit vector

  const std::vector<SeenVector>& vertices_;
  std::vector<std::pair<double, std::size_t>> order_;
};

// Doubles around a number.
struct Bounds {
  double low = 0, high = 0;
};

// Bounds max over the vertices of `from` of the distance to `to`.
class OneSidedBound {
 public:
  OneSidedBound(const CenteredSolid& from, const CenteredSolid& to)
      : from_(from), to_(to), nearest_vertex_(to.vertices) {}

  // Most vertices are certainly nearer than another one; exact numbers are for the others.
  Rational squared() const {
    std::vector<Candidate> candidates;
    double least = 0;  // a lower bound of the result
    for (Candidate& c : by_reach()) {
      if (c.squared.high <= least) break;  // and so have all that follow
      const Bounds way = squared_way_in_bounds(c.vertex);
      c.squared = {std::min(c.squared.low, way.low), std::min(c.squared.high, way.high)};
      least = std::max(least, c.squared.low);
      candidates.push_back(c);
    }
    Rational largest = 0;
    for (const Candidate& c : candidates) {
      if (c.squared.high < least || c.squared.high == 0) continue;
      largest = std::max(largest, std::min(squared_reach(c), squared_way_in(c.vertex)));
    }
    return largest;
  }

 private:
  // A vertex of `from`, the vertex of `to` that seems nearest, and bounds of the squared distance.
  struct Candidate {
    std::size_t vertex, nearest;
    Bounds squared;
  };

  // With the distance to the nearest vertex, from the vertex that seems farthest on.
  std::vector<Candidate> by_reach() const {
    std::vector<Candidate> all;
    for (std::size_t i = 0; i < from_.vertices.size(); ++i) {
      const std::size_t j = nearest_vertex_(from_.vertices[i].near);
      EnclosedVector way = from_.vertices[i].enclosed;
      for (std::size_t k = 0; k < 3; ++k) way[k] -= to_.vertices[j].enclosed[k];
      const Enclosure squared = dot(way, way);
      all.push_back({i, j, {squared.low_double(), squared.high_double()}});
    }
    std::sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) {
      return a.squared.high > b.squared.high;
    });
    return all;
  }

  Rational squared_reach(const Candidate& c) const {
    return squared_norm(from_.vertices[c.vertex].exact - to_.vertices[c.nearest].exact);
  }

  // With g = max over the planes of polar.v the point v/g is in the solid, and v is if g <= 1.
  Rational squared_way_in(std::size_t i) const {
    std::optional<Rational> g;
    for (const std::size_t k : top_planes(i)) {
      const Rational value = to_.polars[k].exact.dot(from_.vertices[i].exact);
      if (!g || value > *g) g = value;
    }
    CONVEXACT_ASSERT(g.has_value());
    if (*g <= 1) return 0;
    const Rational part = 1 - 1 / *g;
    return squared_norm(from_.vertices[i].exact) * part * part;
  }

  // The same for each plane on its own: the way in is the longest of them.
  Bounds squared_way_in_bounds(std::size_t i) const {
    const Enclosure one(Integer(1), kMeasureBits);
    const EnclosedVector& v = from_.vertices[i].enclosed;
    Bounds longest;
    for (const std::size_t k : top_planes(i)) {
      const Enclosure g = dot(to_.polars[k].enclosed, v);
      const Enclosure beyond = g - one;
      if (beyond.high_double() <= 0) continue;
      if (g.sign() != Sign::Positive) return {0, std::numeric_limits<double>::infinity()};
      const Enclosure part = beyond / g, squared = dot(v, v) * part * part;
      longest = {std::max(longest.low, squared.low_double()),
                 std::max(longest.high, squared.high_double())};
    }
    return longest;
  }

  // The planes that may have the largest polar.v.
  std::vector<std::size_t> top_planes(std::size_t i) const {
    std::vector<double> upper(to_.polars.size());
    double best_lower = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < upper.size(); ++k) {
      const Point& y = to_.polars[k].near;
      const Point product = y.cwiseProduct(from_.vertices[i].near);
      const double value = product[0] + product[1] + product[2];
      const double error = kRelativePlaneError * product.cwiseAbs().sum() +
                           absolute_plane_error(std::max(1.0, y.cwiseAbs().maxCoeff()));
      upper[k] = value + error;
      best_lower = std::max(best_lower, value - error);
    }
    std::vector<std::size_t> top;
    for (std::size_t k = 0; k < upper.size(); ++k) {
      if (upper[k] < best_lower) continue;  // false for NaN
      top.push_back(k);
    }
    return top;
  }

  const CenteredSolid& from_;
  const CenteredSolid& to_;
  NearestVertex nearest_vertex_;  // a guess is enough: that to any vertex is an upper bound
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
  CenteredSolid a(exact, center), b(stored, center);
  const long exponent = std::max(largest_exponent_of(a), largest_exponent_of(b));
  a.set_scale(exponent);
  b.set_scale(exponent);
  Rational squared = OneSidedBound(b, a).squared();
  // Rounded outward, the stored solid mostly holds the exact one.
  if (count_outside(stored.planes, PointSet(exact.vertices)) > 0) {
    squared = std::max(squared, OneSidedBound(a, b).squared());
  }
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
