// SPDX-License-Identifier: MIT
// The measures of a hull of points, without its planes: coordinates are integers times a common
// factor, and the normal of a facet is the sum of the cross products of its triangles.
#include <cmath>
#include <optional>
#include <vector>

#include "convexact/measure.hpp"
#include "number/arithmetic.hpp"

namespace convexact {
namespace {

// The extreme points as integers: hull.vertices[v] has 3 entries from 3 v on, times 1 / scale.
struct IntegerPoints {
  std::vector<Integer> coordinates;
  Rational scale;
};

// Doubles times one power of two, where their spread lets that power stay within doubles.
std::optional<IntegerPoints> scale_doubles(const Hull& hull, const PointSet& points) {
  constexpr int kWidestSpread = 900;
  int lowest = 2000, highest = -2000;
  for (const PointId id : hull.vertices) {
    for (const double x : points.doubles()[id.index()]) {
      if (x == 0) continue;
      lowest = std::min(lowest, unit_exponent(x));
      highest = std::max(highest, unit_exponent(x));
    }
  }
  if (!points.is_binary() || highest - lowest > kWidestSpread) return std::nullopt;
  IntegerPoints scaled{std::vector<Integer>(3 * hull.vertices.size()),
                       scale_by_power_of_two(Rational(1), -lowest)};
  for (std::size_t v = 0; v < hull.vertices.size(); ++v) {
    const Point& p = points.doubles()[hull.vertices[v].index()];
    for (std::size_t k = 0; k < 3; ++k) {
      mpz_set_d(raw(scaled.coordinates[3 * v + k]), std::ldexp(p[static_cast<long>(k)], -lowest));
    }
  }
  return scaled;
}

IntegerPoints scale_rationals(const Hull& hull, const PointSet& points) {
  std::vector<Rational> coordinates;
  for (const PointId id : hull.vertices) {
    const RationalPoint p = points[id];
    coordinates.insert(coordinates.end(), p.begin(), p.end());
  }
  IntegerPoints scaled{std::vector<Integer>(coordinates.size()), 1};
  scaled.scale = clear_denominators(coordinates, scaled.coordinates);
  return scaled;
}

// A hull with the coordinates of its vertices as integers.
class IntegerHull {
 public:
  IntegerHull(const Hull& hull, const PointSet& points) : hull_(hull), vertex_(points.size()) {
    auto doubles = scale_doubles(hull, points);
    points_ = doubles ? std::move(*doubles) : scale_rationals(hull, points);
    for (std::size_t v = 0; v < hull.vertices.size(); ++v) {
      vertex_[hull.vertices[v].index()] = static_cast<std::uint32_t>(v);
    }
  }

  const FacetList& facets() const { return hull_.facets; }
  /// Caller's lengths times this are lengths between these integers.
  const Rational& scale() const { return points_.scale; }
  /// Coordinate k modulo 3.
  const Integer& coordinate(PointId id, std::size_t k) const {
    return points_.coordinates[3 * vertex_[id.index()] + k % 3];
  }
  IntegerVector3 between(PointId tail, PointId head) const {
    IntegerVector3 along;
    for (std::size_t k = 0; k < 3; ++k) {
      mpz_sub(raw(along[static_cast<long>(k)]), raw(coordinate(head, k)), raw(coordinate(tail, k)));
    }
    return along;
  }
  /// The outward normal of a facet that is as long as twice its area.
  IntegerVector3 twice_area(std::size_t facet) const {
    const auto corners = hull_.facets[facet];
    IntegerVector3 normal = IntegerVector3::Zero(), last = between(corners[0], corners[1]);
    for (std::size_t m = 2; m < corners.size(); ++m) {
      IntegerVector3 next = between(corners[0], corners[m]);
      for (int k = 0; k < 3; ++k) {
        const int k1 = (k + 1) % 3, k2 = (k + 2) % 3;
        add_product(normal[k], last[k1], next[k2]);
        subtract_product(normal[k], last[k2], next[k1]);
      }
      last = std::move(next);
    }
    return normal;
  }

 private:
  const Hull& hull_;
  IntegerPoints points_;
  std::vector<std::uint32_t> vertex_;  // of a PointId, its place in hull.vertices
};

Enclosure area_of(const IntegerHull& hull, long precision) {
  Enclosure sum(precision);
  for (std::size_t f = 0; f < hull.facets().size(); ++f) {
    const IntegerVector3 normal = hull.twice_area(f);
    sum += sqrt(Enclosure(dot(normal, normal), precision));
  }
  return sum / Enclosure(Rational(2 * hull.scale() * hull.scale()), precision);
}

// As mean_width() of a polytope: each edge with the angle between its facets.
Enclosure mean_width_of(const IntegerHull& hull, long precision) {
  Polytope topology;
  std::vector<IntegerVector3> normals;
  for (std::size_t f = 0; f < hull.facets().size(); ++f) {
    std::vector<std::uint32_t>& corners = topology.facets.emplace_back();
    for (const PointId corner : hull.facets()[f]) corners.push_back(corner.value);
    normals.push_back(hull.twice_area(f));
  }
  std::vector<AngleTerm> terms;
  for (const Edge& edge : edges(topology)) {
    const IntegerVector3 along = hull.between(PointId(edge.tail), PointId(edge.head));
    const IntegerVector3 &m = normals[edge.left], &n = normals[edge.right];
    const IntegerVector3 cross = m.cross(n);
    terms.push_back({1, Rational(dot(along, along)), dot(cross, cross), dot(m, n)});
  }
  return AngleSum(std::move(terms)).enclose(precision) /
         (Enclosure(Rational(4 * hull.scale()), precision) * Enclosure::pi(precision));
}

}  // namespace

Rational volume(const Hull& hull, const PointSet& points) {
  const IntegerHull integers(hull, points);
  // The sum of det(a, b, c) over a fan of each facet, in place: most of the time went to
  // temporaries.
  Integer six_volumes = 0, minor;
  for (std::size_t f = 0; f < hull.facets.size(); ++f) {
    const auto corners = hull.facets[f];
    for (std::size_t m = 2; m < corners.size(); ++m) {
      const PointId a = corners[0], b = corners[m - 1], c = corners[m];
      for (std::size_t k = 0; k < 3; ++k) {
        mpz_mul(raw(minor), raw(integers.coordinate(b, k + 1)), raw(integers.coordinate(c, k + 2)));
        subtract_product(minor, integers.coordinate(b, k + 2), integers.coordinate(c, k + 1));
        add_product(six_volumes, integers.coordinate(a, k), minor);
      }
    }
  }
  const Rational& scale = integers.scale();
  return Rational(six_volumes) / (6 * scale * scale * scale);
}

Enclosure enclose_measure(const Hull& hull, const PointSet& points, CostMeasure measure,
                          long precision) {
  if (measure == CostMeasure::Volume) return Enclosure(volume(hull, points), precision);
  const IntegerHull integers(hull, points);
  return measure == CostMeasure::Area ? area_of(integers, precision)
                                      : mean_width_of(integers, precision);
}

}  // namespace convexact
