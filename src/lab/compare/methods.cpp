// SPDX-License-Identifier: MIT
// The table of all methods, and the hull in the form that they use.

#include "convexact/measure.hpp"
#include "lab/compare/method.hpp"
#include "number/arithmetic.hpp"

namespace convexact {

std::span<const Method> methods() {
  static constexpr Method kMethods[] = {
      {.name = "greedy",
       .propose = propose_greedy,
       .takes_faces = true,
       .summary = "the removals of convexact simplify, by volume",
       .source = "Jacobson2026",
       .is_own = true},
      {"greedy-area", propose_greedy_area, true, "the same by area", "Jacobson2026"},
      {"greedy-mean-width", propose_greedy_mean_width, true, "the same by mean width",
       "Jacobson2026"},
      {"search", propose_search, true,
       "greedy, then exchanges of convexact simplify --search local; beyond the paper", ""},
      {"bloom", propose_bloom, true, "edges of the hull collapsed by quadrics",
       "GarlandHeckbert1997"},
      {"qem-dual", propose_qem_dual, true, "edges of the dual hull collapsed by quadrics",
       "GarlandHeckbert1997"},
      {"tlg", propose_tlg, true, "edges collapsed to points beyond all their planes", "Sander2000"},
      {"mck", propose_mck, true, "vertices selected by the volume that they recover",
       "MuellerChentanezKim2013"},
      {"stl", propose_stl, true, "k-means of unweighted facet normals", "ArthurVassilvitskii2007"},
      {"aabb", propose_aabb, false, "the box of the axes: 6 planes", "Klosowski1998"},
      {"kdop14", propose_kdop14, false, "axes and space diagonals: 14 planes", "Klosowski1998"},
      {"kdop18", propose_kdop18, false, "axes and face diagonals: 18 planes", "Klosowski1998"},
      {"kdop26", propose_kdop26, false, "axes, face and space diagonals: 26 planes",
       "Klosowski1998"},
      {"obb", propose_obb, false, "the least box of 100,000 orientations, then downhill: 6 planes",
       "Alexa2022"},
      {"random", propose_random, true, "bounded removals in a random order", "Jacobson2026"},
  };
  return kMethods;
}

std::span<const Method> inner_methods() {
  static constexpr Method kMethods[] = {
      {.name = "drop",
       .propose = nullptr,
       .takes_faces = false,
       .summary = "the removals of convexact simplify --inner",
       .source = "Jacobson2026",
       .select = select_drop,
       .is_own = true},
      {.name = "qem-ends",
       .propose = nullptr,
       .takes_faces = false,
       .summary = "edges of the hull collapsed onto an end by quadrics",
       .source = "GarlandHeckbert1997",
       .select = select_qem_ends},
  };
  return kMethods;
}

HullToFit hull_to_fit(const Solid& solid, const Watch& watch) {
  const Polytope& polytope = solid.polytope;
  const BoundingBox box = bounding_box(polytope.vertices);
  const RationalPoint middle = box.middle();
  const long exponent =
      exponent_of(Rational(box.size().maxCoeff())) - 1;  // of half the widest side
  HullToFit hull{solid, {}, {}, watch};
  for (const RationalPoint& vertex : polytope.vertices) {
    Point near;
    for (const int k : {0, 1, 2}) {
      near[k] =
          to_double(scale_by_power_of_two(vertex[k] - middle[k], -exponent), Rounding::Nearest);
    }
    hull.vertices.push_back(near);
  }
  for (const auto& facet : polytope.facets) {
    for (std::size_t k = 2; k < facet.size(); ++k) {
      hull.triangles.push_back({facet[0], facet[k - 1], facet[k]});
    }
  }
  return hull;
}

}  // namespace convexact
