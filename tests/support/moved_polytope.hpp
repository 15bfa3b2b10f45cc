// SPDX-License-Identifier: MIT
// moved_polytope.hpp - the same solid elsewhere, larger, or with its lists in another order.
#pragma once
#include <algorithm>
#include <numeric>
#include <span>

#include "convexact/geometry.hpp"
#include "number/random.hpp"

/// Times 2^k.
inline convexact::Polytope scaled(convexact::Polytope polytope, long k) {
  using namespace convexact;
  for (RationalPoint& v : polytope.vertices) {
    for (int i = 0; i < 3; ++i) v[i] = scale_by_power_of_two(v[i], k);
  }
  for (Halfspace& plane : polytope.planes) {
    plane = Halfspace(RationalVector3(plane.normal().cast<Rational>()),
                      scale_by_power_of_two(Rational(plane.offset()), k));
  }
  return polytope;
}

inline convexact::Polytope translated(convexact::Polytope polytope,
                                      const convexact::RationalVector3& by) {
  using namespace convexact;
  for (RationalPoint& v : polytope.vertices) v += by;
  for (Halfspace& plane : polytope.planes) {
    const RationalVector3 normal = plane.normal().cast<Rational>();
    plane = Halfspace(normal, Rational(Rational(plane.offset()) - normal.dot(by)));
  }
  return polytope;
}

/// Vertices and facets in a random order, each facet from a random corner.
inline convexact::Polytope shuffled(const convexact::Polytope& polytope, std::uint64_t seed) {
  using namespace convexact;
  Random random(seed);
  std::vector<std::uint32_t> place(polytope.vertices.size()), order(polytope.facets.size());
  std::iota(place.begin(), place.end(), 0u);
  std::iota(order.begin(), order.end(), 0u);
  shuffle(std::span(place), random);
  shuffle(std::span(order), random);
  Polytope result;
  result.vertices.resize(polytope.vertices.size());
  for (std::size_t v = 0; v < place.size(); ++v) result.vertices[place[v]] = polytope.vertices[v];
  for (const std::uint32_t f : order) {
    std::vector<std::uint32_t> corners = polytope.facets[f];
    for (std::uint32_t& c : corners) c = place[c];
    const auto start = static_cast<std::ptrdiff_t>(uniform_below(random, corners.size()));
    std::rotate(corners.begin(), corners.begin() + start, corners.end());
    result.facets.push_back(std::move(corners));
    result.planes.push_back(polytope.planes[f]);
  }
  return result;
}
