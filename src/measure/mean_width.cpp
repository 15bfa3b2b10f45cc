// SPDX-License-Identifier: MIT
#include "convexact/error.hpp"
#include "convexact/measure.hpp"
#include "convexact/polytope.hpp"
#include "number/arithmetic.hpp"

namespace convexact {
namespace {

// The angle between two outward normals: 0 would be coplanar, pi a knife.
Enclosure angle_between(const IntegerVector3& a, const IntegerVector3& b, long precision) {
  const IntegerVector3 cross = a.cross(b);
  return atan2(sqrt(Enclosure(dot(cross, cross), precision)), Enclosure(dot(a, b), precision));
}

}  // namespace

Enclosure mean_width(const Polytope& polytope, long precision, const Watch& watch) {
  Enclosure sum(precision);
  const std::vector<Edge> all = edges(polytope);
  for (std::size_t i = 0; i < all.size(); ++i) {
    watch.at(i, all.size());
    const Edge& edge = all[i];
    const RationalVector3 along = polytope.vertices[edge.head] - polytope.vertices[edge.tail];
    const Enclosure length = sqrt(Enclosure(along.squaredNorm(), precision));
    sum += length * angle_between(polytope.planes[edge.left].normal(),
                                  polytope.planes[edge.right].normal(), precision);
  }
  return sum / (Enclosure(Integer(4), precision) * Enclosure::pi(precision));
}

}  // namespace convexact
