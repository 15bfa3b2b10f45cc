// SPDX-License-Identifier: MIT
// Changes that must not change a verdict: scaling by a power of two, the order of points, repeats,
// interior points, seeds. On thousands of hard inputs, each enclosed by its own hull, whole and
// with one vertex taken away.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "convexact/measure.hpp"
#include "convexact/verify.hpp"
#include "hard_inputs.hpp"
#include "perturb.hpp"

using namespace convexact;

namespace {

using Points = std::vector<Point>;

Verdict judge(const Points& input, const Mesh& candidate, std::uint64_t seed = 1) {
  VerifyRequest request;
  request.seed = seed;
  return std::get<Verdict>(verify(PointSet(input), candidate, request));
}

Mesh cloud(Points points) {
  Mesh mesh;
  mesh.points = PointSet(std::move(points));
  return mesh;
}

struct SolidInput {
  Points points;
  Hull hull;
};

template <class Visit>
void for_each_solid(const Visit& visit) {
  for (const hard::Inputs& kind : hard::inputs()) {
    CAPTURE(kind.name);
    hard::for_each(kind.name, [&](std::uint32_t i, const Points& points) {
      CAPTURE(i);
      const HullOutcome outcome = convex_hull(PointSet(points));
      if (const auto* hull = std::get_if<Hull>(&outcome)) visit(SolidInput{points, *hull});
    });
  }
}

// The hull as a mesh, its polygons the facets.
Mesh hull_mesh(const SolidInput& solid) {
  Mesh mesh = cloud(solid.points);
  for (std::size_t f = 0; f < solid.hull.facets.size(); ++f) {
    auto& polygon = mesh.polygons.emplace_back();
    for (const PointId p : solid.hull.facets[f]) {
      polygon.push_back(static_cast<std::uint32_t>(p.index()));
    }
  }
  return mesh;
}

// The extreme points but one: it is outside, whatever else is.
Points without_one(const SolidInput& solid, std::size_t gone) {
  Points rest;
  for (const PointId p : solid.hull.vertices) {
    if (p != solid.hull.vertices[gone]) rest.push_back(solid.points[p.index()]);
  }
  return rest;
}

bool same_statuses(const Verdict& a, const Verdict& b) {
  for (const ClaimCode code : kAllClaims) {
    if (a[code].status != b[code].status) return false;
  }
  return true;
}

// Whether 2^exponent times every coordinate is a normal double.
bool scales_exactly(const Points& points, int exponent) {
  for (const Point& p : points) {
    for (int k = 0; k < 3; ++k) {
      const double scaled = std::ldexp(p[k], exponent);
      if (p[k] != 0 && (!std::isnormal(scaled) || !std::isnormal(p[k]))) return false;
    }
  }
  return true;
}

// By definition: the first plane in canonical order that all corners of the patch are near.
std::optional<Halfspace> plane_of_patch(const std::vector<std::uint32_t>& patch,
                                        const Polytope& candidate, const Rational& slack,
                                        const std::vector<Halfspace>& planes) {
  for (const std::uint32_t f : patch) {
    if (std::ranges::count(planes, candidate.planes[f]) > 0) return candidate.planes[f];
  }
  for (const Halfspace& plane : planes) {
    Rational most = 0;
    for (const Integer& n : plane.normal()) most += Rational(abs(n)) * slack;
    const bool is_near = std::ranges::all_of(patch, [&](std::uint32_t f) {
      return std::ranges::all_of(candidate.facets[f], [&](std::uint32_t v) {
        return abs(plane(candidate.vertices[v])) <= most;
      });
    });
    if (is_near) return plane;
  }
  return {};
}

}  // namespace

TEST_CASE("verify: planes of the input are those by definition where vertices move by an ulp") {
  std::uint64_t seed = 0;
  std::size_t found = 0, lost = 0;
  for_each_solid([&](const SolidInput& solid) {
    Mesh mesh = hull_mesh(solid);
    const Points moved = perturb::nudged(solid.points, ++seed);
    if (!std::ranges::all_of(moved, [](const Point& p) { return p.allFinite(); })) return;
    mesh.points = PointSet(moved);
    const HullOutcome outcome = convex_hull(mesh.points);
    const auto* hull = std::get_if<Hull>(&outcome);
    if (hull == nullptr) return;
    const Verdict verdict = judge(solid.points, mesh);
    const Polytope candidate = to_polytope(*hull, mesh.points);
    const Rational slack =
        kRoundingUlps * unit_in_last_place(verdict.size.slack.precision,
                                           bounding_box(candidate.vertices).largest_coordinate());
    const std::vector<Halfspace> planes = to_polytope(solid.hull, PointSet(solid.points)).planes;
    std::vector<Halfspace> expected;
    const auto patches = planar_patches(candidate, verdict.size.slack);
    for (const auto& patch : patches) {
      if (auto plane = plane_of_patch(patch, candidate, slack, planes)) {
        expected.push_back(std::move(*plane));
      }
    }
    CHECK(*verdict.size.planes_of_the_input == expected);
    found += expected.size();
    lost += patches.size() - expected.size();
  });
  CHECK(found > 1000);
  CHECK(lost > 5);
}

TEST_CASE("verify: every hard input is enclosed by its own hull, exactly") {
  for_each_solid([](const SolidInput& solid) {
    const Verdict verdict = judge(solid.points, hull_mesh(solid));
    CHECK(verdict.holds());
    CHECK(verdict.size.planes_of_the_input->size() == verdict.size.facets_as_meant);
    CHECK(verdict.tightness->squared_hausdorff == 0);
    CHECK(verdict.tightness->volume_ratio.contains(1));
  });
}

TEST_CASE(
    "verify: an extreme point that is left out is outside; what is irrelevant changes nothing") {
  for_each_solid([](const SolidInput& solid) {
    const Points rest = without_one(solid, solid.hull.vertices.size() / 2);
    const Verdict verdict = judge(solid.points, cloud(rest));
    CHECK(verdict[ClaimCode::ContainsInput].status == Status::Violated);
    CHECK(verdict.outside->points >= 1);

    const Verdict repeated = judge(solid.points, cloud(perturb::with_repeats(rest, 5, 3)), 7);
    CHECK(same_statuses(verdict, repeated));
    CHECK(verdict[ClaimCode::ContainsInput].witness.squared_distance ==
          repeated[ClaimCode::ContainsInput].witness.squared_distance);

    for (const int exponent : {300, -300}) {
      if (!scales_exactly(solid.points, exponent)) continue;
      const auto scale = [&](const Points& points) {
        return perturb::stretched(points, {exponent, exponent, exponent});
      };
      const Verdict scaled = judge(scale(solid.points), cloud(scale(rest)));
      CHECK(same_statuses(verdict, scaled));
      CHECK(verdict.outside->relative_squared_distance ==
            scaled.outside->relative_squared_distance);
    }
  });
}
