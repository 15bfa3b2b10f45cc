// SPDX-License-Identifier: MIT
// The whole dual's certificate, its table of edges and its volume modulo primes: each condition is
// met by a surface that nothing else refuses.
#include "simplify/whole_dual.hpp"

#include <doctest/doctest.h>

#include "convexact/dual.hpp"
#include "convexact/error.hpp"
#include "shapes/makers.hpp"
#include "simplify_points.hpp"

using namespace convexact;

namespace {

// A surface of triangles over the planes of a solid, and what its certificate says.
struct Certified {
  std::vector<Halfspace> planes;
  std::vector<DualTriangle> triangles;
  std::vector<bool> present;

  explicit Certified(const DualHull& solid)
      : planes(solid.halfspaces),
        triangles(solid.triangles),
        present(solid.halfspaces.size(), true) {}
  bool holds() const {
    const PlainSurface surface(planes.size(), triangles);
    // The volume is not asked for, so an empty surface serves to start from.
    const WholeDual whole(planes, {}, PlainSurface(planes.size(), {}), 1);
    return whole.is_certified(surface, present);
  }
};

// Planes that touch a sphere in random points: no four of them meet.
DualHull sphere() {
  std::vector<Halfspace> planes;
  for (const Point& p : shapes::on_sphere(14, 4)) planes.emplace_back(to_rational(p), Rational(-1));
  return dual_of(planes, RationalPoint::Zero()).dual;
}

}  // namespace

TEST_CASE("WholeDual: true duals are certified") {
  CHECK(Certified(sphere()).holds());
  CHECK(Certified(dual_of_doubles(shapes::cut_cube(3, 0.25))).holds());
}

TEST_CASE("WholeDual: the surface has the survivors, all of them and no other") {
  Certified extra(sphere());
  extra.present[3] = false;  // and yet it has a ring
  CHECK_FALSE(extra.holds());
  Certified missing(sphere());
  missing.planes.emplace_back(IntegerVector3(1, 2, 3), Integer(-100));
  missing.present.push_back(true);  // and has no ring
  CHECK_FALSE(missing.holds());
  missing.present.back() = false;
  CHECK(missing.holds());
}

TEST_CASE("WholeDual: a surface with a hole") {
  const Certified whole(sphere());
  for (std::size_t t = 0; t < whole.triangles.size(); ++t) {
    Certified open = whole;
    open.triangles.erase(open.triangles.begin() + static_cast<std::ptrdiff_t>(t));
    CHECK_FALSE(open.holds());
  }
}

TEST_CASE("WholeDual: an edge turned the other way is a dent") {
  const Certified whole(sphere());
  const PlainSurface surface(whole.planes.size(), whole.triangles);
  std::size_t dents = 0;
  for (std::size_t t = 0; t < whole.triangles.size(); ++t) {
    const auto [a, b, c] = whole.triangles[t];
    const HalfspaceId d = *surface.third(b, a);
    if (surface.third(c, d)) continue;
    Certified dented = whole;
    std::erase_if(dented.triangles, [&, a = a, b = b, c = c](const DualTriangle& s) {
      const auto has = [&](HalfspaceId i) { return std::ranges::count(s, i) == 1; };
      return has(a) && has(b) && (has(c) || has(d));
    });
    dented.triangles.push_back({a, d, c});
    dented.triangles.push_back({d, b, c});
    REQUIRE(dented.triangles.size() == whole.triangles.size());
    CHECK_FALSE(dented.holds());
    ++dents;
  }
  CHECK(dents > 5);
}

TEST_CASE("WholeDual: planes that bound nothing, though each edge is convex") {
  // The normals lie in an open halfspace, so no solid is bounded: D <= 0 for some triangle. The
  // duals are a tetrahedron, which one of its two orientations makes convex at every edge.
  const auto plane = [](int a, int b, int c, int d) {
    return Halfspace(IntegerVector3(a, b, c), Integer(d));
  };
  Certified open(sphere());
  open.planes = {plane(-1, 0, 0, 0), plane(0, -1, 0, 0), plane(0, 0, -1, 0), plane(-3, -1, -1, -1)};
  open.present.assign(4, true);
  std::size_t refused = 0;
  for (const bool turned : {false, true}) {
    open.triangles = {{HalfspaceId(0), HalfspaceId(1), HalfspaceId(2)},
                      {HalfspaceId(1), HalfspaceId(0), HalfspaceId(3)},
                      {HalfspaceId(2), HalfspaceId(1), HalfspaceId(3)},
                      {HalfspaceId(0), HalfspaceId(2), HalfspaceId(3)}};
    if (turned) {
      for (DualTriangle& t : open.triangles) std::swap(t[0], t[1]);
    }
    refused += open.holds() ? 0 : 1;
  }
  CHECK(refused == 2);
}

TEST_CASE("WholeDual: a surface that winds around twice is convex at every edge, and no hull") {
  // The prism over a pentagram: sides 2 to 6, joined to every second one.
  const auto plane = [](int a, int b, int c, int d) {
    return Halfspace(IntegerVector3(a, b, c), Integer(d));
  };
  Certified star(sphere());
  star.planes = {plane(0, 0, 1, -100),   plane(0, 0, -1, -100),   plane(100, 0, 0, -100),
                 plane(31, 95, 0, -100), plane(-81, 59, 0, -100), plane(-81, -59, 0, -100),
                 plane(31, -95, 0, -100)};
  star.present.assign(7, true);
  for (const std::size_t stride : {1u, 2u}) {
    star.triangles.clear();
    for (std::size_t i = 0; i < 5; ++i) {
      const HalfspaceId a(2 + i * stride % 5), b(2 + (i + 1) * stride % 5);
      star.triangles.push_back({HalfspaceId(0), a, b});
      star.triangles.push_back({HalfspaceId(1), b, a});
    }
    CHECK(star.holds() == (stride == 1));
  }
}

TEST_CASE("PlainSurface: each directed edge is there once") {
  const HalfspaceId a(0), b(1), c(2), d(3), e(4);
  const DualTriangle first{a, b, c};
  const std::vector<DualTriangle> sharing = {{a, b, d}, {d, a, b}, {b, d, a}};
  for (const DualTriangle& second : sharing) {
    PlainSurface surface(5, {});
    CHECK(surface.add(first));
    CHECK_FALSE(surface.add(second));
    CHECK(surface.directed_edges() == 3);
    CHECK_THROWS_AS(PlainSurface(5, std::vector<DualTriangle>{first, second}), Error);
  }
  PlainSurface surface(5, {});
  CHECK(surface.add(first));
  CHECK(surface.add({b, a, d}));
  CHECK(surface.add({c, b, e}));
}

TEST_CASE("ModularVolume: a denominator that the prime divides is told, and not divided by") {
  Random random(3);
  const ModularVolume volume({}, random);
  const Integer prime = Integer(volume.residue(Rational(-1))) + 1;
  CHECK(volume.residue(Rational(Integer(1), Integer(2))) != 0);
  CHECK_THROWS_WITH_AS((void)volume.residue(Rational(Integer(1), Integer(3 * prime))),
                       doctest::Contains("multiple of the random prime"), Error);
}
