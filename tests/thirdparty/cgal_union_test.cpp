// SPDX-License-Identifier: MIT
// Volumes of unions against CGAL's Nef polyhedra, third-party truth: parts of the shipped meshes,
// cut along a grid, and random solids on a grid, which share planes, edges and vertices.
#include <doctest/doctest.h>

#include <sstream>

#include "convexact/io.hpp"
#include "grid_parts.hpp"
#include "nef_union.hpp"
#include "number/random.hpp"
#include "shipped_meshes.hpp"
using namespace convexact;

namespace {

Rational volume_by_nef(const std::vector<ConvexPart>& parts) {
  std::vector<NefPolyhedron> solids;
  for (const ConvexPart& part : parts) {
    if (part.solid) solids.push_back(to_nef(part));
  }
  std::ostringstream text;
  text << CGAL::exact(nef_volume(nef_union(solids)));
  return parse_rational(text.str());
}

}  // namespace

TEST_CASE("CGAL: unions of random solids on a grid have the same volume") {
  Random random(4);
  for (int round = 0; round < 40; ++round) {
    CAPTURE(round);
    std::vector<ConvexPart> parts;
    for (int i = 0; i < 6; ++i) {
      std::vector<Point> points;
      for (int k = 0; k < 6; ++k) {
        Point& p = points.emplace_back();
        for (double& x : p) x = static_cast<double>(uniform_below(random, 6));
      }
      parts.push_back(convex_part(PointSet(points)));
    }
    CHECK(*union_volume(parts, 64, true).exact == volume_by_nef(parts));
  }
}

TEST_CASE("CGAL: unions of parts of meshes have the same volume") {
  for (const std::string& path : shipped_meshes()) {
    CAPTURE(path);
    const std::vector<ConvexPart> parts = grid_parts(read_mesh(path), 3, 0);
    CHECK(*union_volume(parts, 64, true).exact == volume_by_nef(parts));
  }
}
