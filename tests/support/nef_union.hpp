// SPDX-License-Identifier: MIT
// nef_union.hpp - unions of convex parts by CGAL's Nef polyhedra, and their volumes, exactly.
#pragma once
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_nary_union_3.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/convex_hull_3.h>

#include <vector>

#include "convexact/overlay.hpp"

using NefKernel = CGAL::Exact_predicates_exact_constructions_kernel;
using NefPolyhedron = CGAL::Nef_polyhedron_3<NefKernel>;

/// Precondition: solid, with vertices that are doubles.
inline NefPolyhedron to_nef(const convexact::ConvexPart& part) {
  std::vector<NefKernel::Point_3> points;
  for (const convexact::RationalPoint& v : part.vertices) {
    const auto x = [&](int k) { return to_double(v[k], convexact::Rounding::Nearest); };
    points.emplace_back(x(0), x(1), x(2));
  }
  CGAL::Polyhedron_3<NefKernel> hull;
  CGAL::convex_hull_3(points.begin(), points.end(), hull);
  return NefPolyhedron(hull);
}

inline NefPolyhedron nef_union(const std::vector<NefPolyhedron>& solids) {
  CGAL::Nef_nary_union_3<NefPolyhedron> sum;
  for (const NefPolyhedron& solid : solids) sum.add_polyhedron(solid);
  return sum.get_union();
}

/// Cones from the origin over the boundary: a cycle p_1, p_2, ... of a facet adds
/// p_1 . (sum of p_i x p_{i+1}) / 6, holes with the other sign, as they turn the other way.
inline NefKernel::FT nef_volume(const NefPolyhedron& solid) {
  NefKernel::FT six_volumes = 0;
  for (auto f = solid.halffacets_begin(); f != solid.halffacets_end(); ++f) {
    if (!f->incident_volume()->mark()) continue;
    for (auto cycle = f->facet_cycles_begin(); cycle != f->facet_cycles_end(); ++cycle) {
      if (!cycle.is_shalfedge()) continue;
      std::vector<NefKernel::Vector_3> corners;
      const NefPolyhedron::SHalfedge_const_handle first(cycle);
      auto at = first;
      do {
        corners.push_back(at->source()->center_vertex()->point() - CGAL::ORIGIN);
        at = at->next();
      } while (at != first);
      NefKernel::Vector_3 sum(0, 0, 0);
      for (std::size_t i = 0; i < corners.size(); ++i) {
        sum = sum + CGAL::cross_product(corners[i], corners[(i + 1) % corners.size()]);
      }
      six_volumes += corners.front() * sum;
    }
  }
  return CGAL::abs(six_volumes) / 6;
}
