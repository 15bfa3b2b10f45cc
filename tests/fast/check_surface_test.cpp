// SPDX-License-Identifier: MIT
// The checker of dual surfaces: true surfaces pass, and each way of being wrong is found.
#include <doctest/doctest.h>

#include "convexact/error.hpp"
#include "convexact/hull.hpp"
#include "fast/checks.hpp"
#include "fast/engines.hpp"
#include "shapes/makers.hpp"

using namespace convexact;

namespace {

// Dual points in the directions of a regular pentagon's corners, as closely as it matters, and at
// the poles: the planes of a prism.
DualHull pentagonal_prism() {
  const std::vector<Halfspace> planes{
      {IntegerVector3(0, 0, 1), -100},    {IntegerVector3(0, 0, -1), -100},
      {IntegerVector3(100, 0, 0), -100},  {IntegerVector3(31, 95, 0), -100},
      {IntegerVector3(-81, 59, 0), -100}, {IntegerVector3(-81, -59, 0), -100},
      {IntegerVector3(31, -95, 0), -100}};
  return dual_of(planes, RationalPoint(0, 0, 0)).dual;
}

// The bipyramid over corners that are visited in steps of `stride`.
std::vector<DualTriangle> bipyramid(const DualHull& solid, std::size_t stride) {
  std::vector<HalfspaceId> rim;
  HalfspaceId top, bottom;
  for (std::size_t i = 0; i < solid.halfspaces.size(); ++i) {
    const Integer& z = solid.halfspaces[i].normal()[2];
    if (z != 0) (z > 0 ? top : bottom) = HalfspaceId(i);
  }
  for (const auto& [x, y] : {std::pair{1, 0}, {31, 95}, {-81, 59}, {-81, -59}, {31, -95}}) {
    for (std::size_t i = 0; i < solid.halfspaces.size(); ++i) {
      const IntegerVector3& n = solid.halfspaces[i].normal();
      if (n[0] == x && n[1] == y && n[2] == 0) rim.emplace_back(i);
    }
  }
  REQUIRE(rim.size() == 5);
  std::vector<DualTriangle> triangles;
  for (std::size_t i = 0; i < 5; ++i) {
    const HalfspaceId a = rim[i * stride % 5], b = rim[(i + 1) * stride % 5];
    triangles.push_back({top, a, b});
    triangles.push_back({bottom, b, a});
  }
  return triangles;
}

}  // namespace

TEST_CASE("is_dual_hull: the duals of hulls, degenerate ones too") {
  for (const auto& points : {shapes::in_ball(40, 1), shapes::lattice(30, 3, 2), shapes::prism(9),
                             shapes::cylinder(12, 3), shapes::on_sphere(200, 3)}) {
    const PointSet set(points);
    const HullOutcome hull = convex_hull(set);
    const FastDual dual = FastDual::of(std::get<Hull>(hull), set);
    CHECK(is_dual_hull(dual, dual.triangles()));
    const DualHull solid = dual_of(std::get<Hull>(hull), set);
    const FastDual exact = FastDual::of(solid, dual.center());
    CHECK(is_dual_hull(exact, exact.triangles()));
  }
}

TEST_CASE("is_dual_hull: what is open, turned inside out or doubled") {
  const DualHull solid = pentagonal_prism();
  const FastDual dual = FastDual::of(solid, RationalPoint(0, 0, 0));
  const std::vector<DualTriangle> whole = bipyramid(solid, 1);
  CHECK(is_dual_hull(dual, whole));
  CHECK_FALSE(is_dual_hull(dual, {}));
  std::vector<DualTriangle> changed(whole.begin(), whole.end() - 1);
  CHECK_FALSE(is_dual_hull(dual, changed));
  changed = whole;
  for (DualTriangle& t : changed) std::swap(t[0], t[1]);
  CHECK_FALSE(is_dual_hull(dual, changed));
  changed = whole;
  changed.insert(changed.end(), whole.begin(), whole.end());
  CHECK_FALSE(is_dual_hull(dual, changed));
}

TEST_CASE("is_dual_hull: one triangle missing, or there twice, away from the ray") {
  const DualHull solid = pentagonal_prism();
  const FastDual dual = FastDual::of(solid, RationalPoint(0, 0, 0));
  const std::vector<DualTriangle> whole = bipyramid(solid, 1);
  for (std::size_t t = 1; t < whole.size(); ++t) {
    std::vector<DualTriangle> changed = whole;
    changed.push_back(whole[t]);
    CHECK_FALSE(is_dual_hull(dual, changed));
    changed = whole;
    changed.erase(changed.begin() + static_cast<std::ptrdiff_t>(t));
    CHECK_FALSE(is_dual_hull(dual, changed));
  }
}

TEST_CASE("is_dual_hull: a tetrahedron beside the center is convex at every edge") {
  // The top and three sides, of which one lies between the others: all normals lie in an open
  // halfspace, so their planes bound nothing.
  const DualHull solid = pentagonal_prism();
  const FastDual dual = FastDual::of(solid, RationalPoint(0, 0, 0));
  const DualSigns signs(dual);
  const auto id_of = [&](int x, int y, int z) {
    for (std::size_t i = 0; i < solid.halfspaces.size(); ++i) {
      const IntegerVector3& n = solid.halfspaces[i].normal();
      if (n[0] == x && n[1] == y && n[2] == z) return HalfspaceId(i);
    }
    FAIL("no such plane");
    return HalfspaceId(0);
  };
  const HalfspaceId top = id_of(0, 0, 1), a = id_of(31, -95, 0), b = id_of(1, 0, 0),
                    c = id_of(31, 95, 0);
  std::vector<DualTriangle> triangles;
  for (const auto& [corners, other] : {std::pair{DualTriangle{top, a, b}, c},
                                       {DualTriangle{top, b, c}, a},
                                       {DualTriangle{top, c, a}, b},
                                       {DualTriangle{a, c, b}, top}}) {
    triangles.push_back(corners);
    const auto& [p, q, r] = corners;
    if (signs.height(p, q, r, other) == Sign::Positive)
      std::swap(triangles.back()[0], triangles.back()[1]);
    const auto& [x, y, z] = triangles.back();
    REQUIRE(signs.height(x, y, z, other) == Sign::Negative);
  }
  const auto& [x, y, z] = triangles[0];
  REQUIRE(signs.determinant(x, y, z) == Sign::Positive);  // the ray goes through this one
  CHECK_FALSE(is_dual_hull(dual, triangles));
}

TEST_CASE("is_dual_hull: an edge that is turned the other way is a dent") {
  const PointSet set(shapes::in_ball(30, 5));
  const HullOutcome hull = convex_hull(set);
  const FastDual dual = FastDual::of(std::get<Hull>(hull), set);
  std::size_t turned = 0;
  const auto all = dual.triangles();
  for (std::uint32_t h = 0; h < 3 * all.size(); ++h) {
    const std::uint32_t g = dual.twins()[h];
    const DualTriangle &s = all[h / 3], &t = all[g / 3];
    const HalfspaceId a = s[h % 3], b = s[(h + 1) % 3], c = s[(h + 2) % 3], d = t[(g + 2) % 3];
    std::vector<DualTriangle> changed(all.begin(), all.end());
    changed[h / 3] = {a, d, c};
    changed[g / 3] = {d, b, c};
    // Corners of one dual face lie in a plane, and may be joined either way.
    const bool flat = [&] {
      for (const std::uint32_t x : dual.incidences(a)) {
        const auto on = [&](HalfspaceId i) {
          const auto list = dual.incidences(i);
          return std::find(list.begin(), list.end(), x) != list.end();
        };
        if (on(b) && on(c) && on(d)) return true;
      }
      return false;
    }();
    if (flat) continue;
    CHECK_FALSE(is_dual_hull(dual, changed));
    ++turned;
  }
  CHECK(turned > 30);
}

TEST_CASE("is_dual_hull: a surface that winds around the center twice is convex at every edge") {
  // The bipyramid over a pentagram: closed, counter-clockwise and convex everywhere, yet no hull.
  const DualHull solid = pentagonal_prism();
  const FastDual dual = FastDual::of(solid, RationalPoint(0, 0, 0));
  CHECK_FALSE(is_dual_hull(dual, bipyramid(solid, 2)));
}

// The loop takes its surface as it is given; only the verification of a step looks at it. One step,
// as nothing is promised of what follows a wrong one.
TEST_CASE("simplify_filtered: a surface with a dent is found by the verification of the step") {
  const PointSet set(shapes::on_sphere(14, 6));
  const DualHull solid = dual_of(std::get<Hull>(convex_hull(set)), set);
  const FastDual dual = FastDual::of(solid, RationalPoint::Zero());
  const auto refusal_of = [&](const DualHull& surface, VerifyLevel level) -> std::string {
    try {
      const std::size_t faces = solid.halfspaces.size() - 1;
      (void)simplify_filtered(surface, RationalPoint::Zero(), {.faces = faces, .verify = level});
      return "";
    } catch (const Error& error) {
      return error.what();
    }
  };
  CHECK(refusal_of(solid, VerifyLevel::Local).empty());
  std::size_t refused = 0;
  for (std::uint32_t h = 0; h < 3 * solid.triangles.size(); ++h) {
    const std::uint32_t g = dual.twins()[h];
    const DualTriangle &s = solid.triangles[h / 3], &t = solid.triangles[g / 3];
    const HalfspaceId a = s[h % 3], b = s[(h + 1) % 3], c = s[(h + 2) % 3], d = t[(g + 2) % 3];
    if (h > g || DualSigns(dual).height(a, b, c, d) == Sign::Zero) continue;
    DualHull dented = solid;
    dented.triangles[h / 3] = {a, d, c};
    dented.triangles[g / 3] = {d, b, c};
    // Else another ring was removed, or the turned edge was there already.
    const std::string refusal = refusal_of(dented, VerifyLevel::Local);
    if (refusal.find("verification of a step failed") != 0) continue;
    CHECK(refusal_of(dented, VerifyLevel::None).empty());
    ++refused;
  }
  CHECK(refused > 0);
}
