// SPDX-License-Identifier: MIT
#include "oracle/support_program.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "convexact/error.hpp"
#include "convexact/number.hpp"
#include "number/arithmetic.hpp"

namespace convexact {
namespace {

// In the direction of n, of a length that doubles hold.
Vector3<double> to_direction(const IntegerVector3& n) {
  const auto bits = static_cast<long>(bit_length(n));
  Vector3<double> direction;
  for (int k = 0; k < 3; ++k) {
    direction[k] = to_double(scale_by_power_of_two(Rational(n[k]), -bits), Rounding::Nearest);
  }
  return direction;
}

}  // namespace

SupportProgram::SupportProgram(const Polytope& polytope)
    : polytope_(polytope), around_(polytope.vertices.size()), neighbors_(polytope.vertices.size()) {
  for (const RationalPoint& v : polytope.vertices) {
    Vector3<double> near;
    for (int k = 0; k < 3; ++k) near[k] = to_double(v[k], Rounding::Nearest);
    near_.push_back(near);
  }
  // Counter-clockwise around a vertex, a facet is followed by the one that leaves the vertex along
  // the edge by which the facet itself enters it.
  struct Corner {
    std::uint32_t vertex, next, previous, facet;
  };
  std::vector<Corner> corners;
  for (std::uint32_t f = 0; f < polytope.facets.size(); ++f) {
    const auto& around = polytope.facets[f];
    for (std::size_t k = 0, n = around.size(); k < n; ++k) {
      corners.push_back({around[k], around[(k + 1) % n], around[(k + n - 1) % n], f});
    }
  }
  const auto place = [](const Corner& c) { return std::pair(c.vertex, c.next); };
  std::sort(corners.begin(), corners.end(),
            [&](const Corner& a, const Corner& b) { return place(a) < place(b); });
  for (const Corner& start : corners) {
    const std::uint32_t v = start.vertex;
    if (!around_[v].empty()) continue;
    const Corner* at = &start;
    do {
      around_[v].push_back(at->facet);
      neighbors_[v].push_back(at->next);
      const std::pair wanted(v, at->previous);
      const auto found =
          std::lower_bound(corners.begin(), corners.end(), wanted,
                           [&](const Corner& c, const auto& key) { return place(c) < key; });
      CONVEXACT_ASSERT(found != corners.end() && place(*found) == wanted);
      at = &*found;
    } while (at != &start);
  }
}

Rational SupportProgram::maximum(const IntegerVector3& n) {
  last_ = climb_in_doubles(to_direction(n));
  const RationalVector3 exact = n.cast<Rational>();
  while (!is_optimal(last_, n)) last_ = better_neighbor(last_, exact);
  return polytope_.vertices[last_].dot(exact);
}

std::uint32_t SupportProgram::climb_in_doubles(const Vector3<double>& direction) const {
  std::uint32_t at = last_;
  double highest = direction.dot(near_[at]);
  for (bool climbs = true; climbs;) {
    climbs = false;
    for (const std::uint32_t v : neighbors_[at]) {
      const double height = direction.dot(near_[v]);
      if (height <= highest || std::isnan(height)) continue;
      at = v;
      highest = height;
      climbs = true;
      break;
    }
  }
  return at;
}

// A vertex that is not optimal has an edge that leads strictly higher.
std::uint32_t SupportProgram::better_neighbor(std::uint32_t vertex,
                                              const RationalVector3& n) const {
  const Rational height = polytope_.vertices[vertex].dot(n);
  for (const std::uint32_t v : neighbors_[vertex]) {
    if (polytope_.vertices[v].dot(n) > height) return v;
  }
  throw Error(ErrorCode::Internal, "no vertex of a polytope is the largest one");
}

// The normals of the facets at a vertex, counter-clockwise, span the cone of the functionals that
// are largest there; it falls into the cones of a fan of triples (0, k, k + 1). Of the three signs
// that place n in one of them, det(k + 1, 0, n) is the first sign of the next one, turned around.
bool SupportProgram::is_optimal(std::size_t vertex, const IntegerVector3& n) const {
  const auto normal = [&](std::size_t k) -> const IntegerVector3& {
    return polytope_.planes[around_[vertex][k]].normal();
  };
  IntegerVector3 turned = normal(1).cross(n);
  Sign from_first = sign_of(Integer(normal(0).dot(turned)));  // of det(0, k, n)
  for (std::size_t k = 1; k + 1 < around_[vertex].size(); ++k) {
    turned = normal(k + 1).cross(n);
    const Sign from_next = sign_of(Integer(normal(0).dot(turned)));
    if (from_first != Sign::Negative && from_next != Sign::Positive &&
        sign_of(Integer(normal(k).dot(turned))) != Sign::Negative) {
      return true;
    }
    from_first = from_next;
  }
  return false;
}

}  // namespace convexact
