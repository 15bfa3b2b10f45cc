// SPDX-License-Identifier: MIT
#include "convexact/oracle/planar_patches.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace convexact {
namespace {

using Facet = std::uint32_t;

// Four times the square of the area.
Rational squared_area(const Polytope& polytope, Facet facet) {
  const std::vector<std::uint32_t>& corners = polytope.facets[facet];
  const RationalPoint& first = polytope.vertices[corners[0]];
  RationalVector3 sum(0, 0, 0);
  for (std::size_t k = 2; k < corners.size(); ++k) {
    const RationalVector3 u = polytope.vertices[corners[k - 1]] - first;
    const RationalVector3 v = polytope.vertices[corners[k]] - first;
    sum += u.cross(v);
  }
  return sum.dot(sum);
}

std::vector<std::vector<Facet>> neighbours_of(const Polytope& polytope) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, Facet> left_of;  // of each directed edge
  for (Facet f = 0; f < polytope.facets.size(); ++f) {
    const auto& corners = polytope.facets[f];
    for (std::size_t k = 0; k < corners.size(); ++k) {
      left_of[{corners[k], corners[(k + 1) % corners.size()]}] = f;
    }
  }
  std::vector<std::vector<Facet>> neighbours(polytope.facets.size());
  for (const auto& [edge, facet] : left_of) {
    neighbours[facet].push_back(left_of.at({edge.second, edge.first}));
  }
  return neighbours;
}

bool lies_near(const Polytope& polytope, Facet facet, const Halfspace& plane,
               const Rational& squared_tolerance) {
  const RationalVector3 normal = plane.normal().cast<Rational>();
  const Rational limit = squared_tolerance * normal.dot(normal);
  const auto& corners = polytope.facets[facet];
  return std::all_of(corners.begin(), corners.end(), [&](std::uint32_t corner) {
    const Rational value = plane(polytope.vertices[corner]);
    return value * value <= limit;
  });
}

}  // namespace

std::size_t count_planar_patches(const Polytope& polytope, const Rational& squared_tolerance) {
  const auto neighbours = neighbours_of(polytope);
  std::vector<Rational> areas;
  for (Facet f = 0; f < polytope.facets.size(); ++f) areas.push_back(squared_area(polytope, f));
  std::vector<Facet> order(areas.size());
  std::iota(order.begin(), order.end(), Facet{0});
  std::sort(order.begin(), order.end(), [&](Facet a, Facet b) { return areas[a] > areas[b]; });
  std::vector<bool> taken(order.size(), false);
  std::size_t patches = 0;
  for (const Facet seed : order) {
    if (taken[seed]) continue;
    ++patches;
    taken[seed] = true;
    std::vector<Facet> rim{seed};
    while (!rim.empty()) {
      const Facet facet = rim.back();
      rim.pop_back();
      for (const Facet next : neighbours[facet]) {
        if (taken[next] || !lies_near(polytope, next, polytope.planes[seed], squared_tolerance)) {
          continue;
        }
        taken[next] = true;
        rim.push_back(next);
      }
    }
  }
  return patches;
}

}  // namespace convexact
