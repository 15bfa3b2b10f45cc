// SPDX-License-Identifier: MIT
// The octree of an implicit shape: the capsule of the specification, a sphere decided by integers,
// points of the surface by rational parametrisations, and what is refused.
#include "convexact/implicit.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "convexact/hull.hpp"
#include "convexact/measure.hpp"
#include "expect_error.hpp"
#include "number/random.hpp"
#include "sweep.hpp"

using namespace convexact;

namespace {

using Cell = std::array<std::uint32_t, 3>;

ImplicitShape capsule() {
  return ImplicitShape(implicit::Capsule{{-0.75, -0.25, -0.5}, {0.75, 0.25, 0.5}, 0.5});
}

const ImplicitBox kBox{{-2, -2, -2}, 4};

struct HullOfCells {
  PointSet points;
  Hull hull;
  std::vector<Halfspace> planes;

  explicit HullOfCells(const ImplicitCells& cells)
      : points(cells.corners),
        hull(std::get<Hull>(convex_hull(points))),
        planes(facet_halfspaces(hull, points)) {}

  bool holds(const RationalPoint& x) const {
    for (const Halfspace& plane : planes) {
      if (plane(x) > 0) return false;
    }
    return true;
  }
};

// A point of the unit sphere with rational coordinates, by stereographic projection.
RationalPoint on_unit_sphere(Random& random) {
  const auto draw = [&] {
    return Rational(static_cast<long>(uniform_below(random, 401)) - 200) / 50;
  };
  const Rational s = draw(), t = draw(), w = 1 + s * s + t * t;
  return {2 * s / w, 2 * t / w, (w - 2) / w};
}

// A point of the unit circle.
std::array<Rational, 2> on_unit_circle(Random& random) {
  const Rational t = Rational(static_cast<long>(uniform_below(random, 401)) - 200) / 50;
  return {(1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)};
}

Rational share(Random& random) {
  return Rational(static_cast<long>(uniform_below(random, 101))) / 100;
}

// Whether the hull of the cells holds 200 points that `draw` makes.
template <class Draw>
bool holds_all(const ImplicitShape& shape, const ImplicitBox& box, Draw&& draw) {
  Random random(7);
  const HullOfCells hull(kept_cells(shape, box, 5));
  for (int k = 0; k < 200; ++k) {
    if (!hull.holds(draw(random))) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("kept_cells: the capsule has the counts of the specification") {
  // Leaves, hull facets and volume ratios were computed for the specification by other code.
  struct Row {
    std::size_t depth, kept, facets;
    double ratio;
  };
  const Row rows[] = {{4, 240, 42, 3.02891}, {5, 992, 74, 1.92835}, {6, 3880, 248, 1.44790}};
  for (const Row& row : rows) {
    CAPTURE(row.depth);
    const ImplicitCells cells = kept_cells(capsule(), kBox, row.depth);
    CHECK(cells.levels.size() == row.depth + 1);
    CHECK(cells.levels.back().kept == row.kept);
    CHECK(cells.leaves.size() == row.kept);
    CHECK(cells.levels[0].tested == 1);
    for (std::size_t k = 1; k <= row.depth; ++k) {
      CHECK(cells.levels[k].tested == 8 * cells.levels[k - 1].kept);
    }
    const HullOfCells hull(cells);
    CHECK(hull.hull.facets.size() == row.facets);
    // l = sqrt(3.5), r = 1/2: pi r^2 l + 4/3 pi r^3
    const double solid = M_PI * std::sqrt(3.5) / 4 + M_PI / 6;
    const double found = to_double(volume(hull.hull, hull.points), Rounding::Nearest);
    CHECK(std::abs(found / solid - row.ratio) < 0.6e-5);
  }
}

TEST_CASE("kept_cells: the capsule at depth 7, its farthest corner and Steiner's bound") {
  const ImplicitCells cells = kept_cells(capsule(), kBox, 7);
  CHECK(cells.levels.back().kept == 15632);
  const HullOfCells hull(cells);
  CHECK(hull.hull.facets.size() == 526);
  // sqrt(3) 4 / 128
  REQUIRE(cells.distance);
  CHECK(*cells.distance == doctest::Approx(std::sqrt(3) / 32).epsilon(1e-14));
  CHECK(to_rational(*cells.distance) * to_rational(*cells.distance) >= Rational(3) / 1024);
  double farthest = 0;
  for (const Point& corner : cells.corners) {
    // The distance from the segment by its definition.
    const Point u(1.5, 0.5, 1.0), v = corner - Point(-0.75, -0.25, -0.5);
    const double t = std::clamp(u.dot(v) / u.squaredNorm(), 0.0, 1.0);
    farthest = std::max(farthest, (v - t * u).norm() - 0.5);
  }
  CHECK(std::abs(farthest - 0.05129) < 0.6e-5);
  CHECK(farthest <= *cells.distance);
  const auto measures = closed_measures(capsule(), 128);
  REQUIRE(measures);
  CHECK(measures->volume.high_double() == doctest::Approx(1.992944).epsilon(1e-6));
  CHECK(measures->area.high_double() == doctest::Approx(9.018974).epsilon(1e-6));
  CHECK(measures->mean_width.high_double() == doctest::Approx(1.935414).epsilon(1e-6));
  const double bound = steiner_bound(*measures, *cells.distance) / measures->volume.high_double();
  CHECK(std::abs(bound - 1.26316) < 0.6e-5);
  const double ratio =
      to_double(volume(hull.hull, hull.points), Rounding::Nearest) / measures->volume.high_double();
  CHECK(std::abs(ratio - 1.21753) < 0.6e-5);
  CHECK(ratio <= bound);
}

TEST_CASE("kept_cells: a sphere keeps the cells that integers keep") {
  // Sphere of radius 5 around 0 in the box [-8, 8]^3. In units of half a cell, with n = 2^depth
  // cells, m = 2 i + 1 - n, the center is m * 8 / n and rho = sqrt(3) * 8 / n. So the cell is kept
  // iff | |m| - R | <= sqrt(3) with R = 5 n / 8. With q = m.m + R^2 - 3, that is: |m|^2 + R^2 - 3
  // <= 2 R |m|, so q <= 0 or q^2 <= 4 R^2 m.m. All is integer after a multiplication by 64.
  const ImplicitShape sphere(implicit::Sphere{{0, 0, 0}, 5});
  for (std::int64_t depth = 3; depth <= 6; ++depth) {
    CAPTURE(depth);
    const std::int64_t n = std::int64_t(1) << depth, r = 5 * n;  // r = 8 R
    std::vector<Cell> expected;
    for (std::int64_t i = 0; i < n; ++i) {
      for (std::int64_t j = 0; j < n; ++j) {
        for (std::int64_t k = 0; k < n; ++k) {
          const std::int64_t x = 2 * i + 1 - n, y = 2 * j + 1 - n, z = 2 * k + 1 - n;
          const std::int64_t m = 64 * (x * x + y * y + z * z), q = m + r * r - 192;
          if (q > 0 && q * q > 4 * r * r * m) continue;
          expected.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j),
                              static_cast<std::uint32_t>(k)});
        }
      }
    }
    CHECK(kept_cells(sphere, {{-8, -8, -8}, 16}, static_cast<std::size_t>(depth)).leaves ==
          expected);
  }
}

TEST_CASE("kept_cells: equal numbers keep the cell, and every precision leaves it undecided") {
  // The plane x + y + z = c has f = (x + y + z - c) / sqrt(3) at the center (4, 4, 4) of a box of
  // edge 8, and L rho = 4 sqrt(3): equal for c = 0, so the cell is kept, at the surface of the box.
  const ImplicitShape plane(implicit::Plane{{1, 1, 1}, 0});
  const Error error = error_of([&] { return kept_cells(plane, {{0, 0, 0}, 8}, 0); });
  CHECK(error.code() == ErrorCode::NoInterior);
  CHECK(std::string(error.what()).find("may leave the box") != std::string::npos);
  // A little farther away, doubles decide that it is outside.
  const ImplicitShape farther(implicit::Plane{{1, 1, 1}, 0x1p-20});
  const Error empty = error_of([&] { return kept_cells(farther, {{0, 0, 0}, 8}, 0); });
  CHECK(std::string(empty.what()).find("empty") == 0);
  // So little that doubles do not see it: more bits do.
  const ImplicitShape barely(implicit::Plane{{1, 1, 1}, 0x1p-60});
  const Error also = error_of([&] { return kept_cells(barely, {{0, 0, 0}, 8}, 0); });
  CHECK(std::string(also.what()).find("empty") == 0);
}

TEST_CASE("kept_cells: the hull holds rational points of the surface of every primitive") {
  const auto scaled = [](const RationalPoint& p, const Rational& r) {
    return RationalPoint(p * r);
  };
  const RationalPoint zero = RationalPoint::Zero();
  CHECK(
      holds_all(ImplicitShape(implicit::Sphere{{0.25, 0, -0.5}, 1.25}), kBox, [&](Random& random) {
        return RationalPoint(scaled(on_unit_sphere(random), Rational(5) / 4) +
                             to_rational(Point(0.25, 0, -0.5)));
      }));
  CHECK(holds_all(capsule(), kBox, [&](Random& random) {
    const RationalPoint axis = to_rational(Point(1.5, 0.5, 1.0)) * (2 * share(random) - 1) / 2;
    return RationalPoint(axis + scaled(on_unit_sphere(random), Rational(1) / 2));
  }));
  CHECK(holds_all(
      ImplicitShape(implicit::Box{{-1, -0.5, -0.25}, {1, 0.75, 1.5}}), kBox, [&](Random& random) {
        const auto pick = [&] { return Rational(static_cast<long>(uniform_below(random, 2))); };
        return RationalPoint(2 * pick() - 1, pick() * 5 / 4 - Rational(1) / 2,
                             pick() * 7 / 4 - Rational(1) / 4);
      }));
  CHECK(holds_all(
      ImplicitShape(implicit::Box{{-1, -1, -1}, {1, 1, 1}, 0.25}), kBox, [&](Random& random) {
        const auto pick = [&] {
          return (2 * Rational(static_cast<long>(uniform_below(random, 2))) - 1) * 3 / 4;
        };
        return RationalPoint(RationalPoint(pick(), pick(), pick()) + on_unit_sphere(random) / 4);
      }));
  CHECK(holds_all(ImplicitShape(implicit::Torus{{0, 0, 0}, {0, 0, 3}, 1, 0.5}), kBox,
                  [&](Random& random) {
                    const auto [c, s] = on_unit_circle(random);
                    const auto [radial, axial] = on_unit_circle(random);
                    const Rational r = 1 + radial / 2;
                    return RationalPoint(c * r, s * r, axial / 2);
                  }));
  CHECK(holds_all(ImplicitShape(implicit::Cylinder{{0, 0, -1}, {0, 0, 1.5}, 0.75}), kBox,
                  [&](Random& random) {
                    const auto [c, s] = on_unit_circle(random);
                    return RationalPoint(c * 3 / 4, s * 3 / 4, share(random) * 5 / 2 - 1);
                  }));
  CHECK(holds_all(
      ImplicitShape(implicit::Intersection{{ImplicitShape(implicit::Plane{{1, 1, 1}, -1}),
                                            ImplicitShape(implicit::Plane{{-1, 0, 0}, 0}),
                                            ImplicitShape(implicit::Plane{{0, -1, 0}, 0}),
                                            ImplicitShape(implicit::Plane{{0, 0, -1}, 0})}}),
      kBox, [&](Random& random) {
        // Corners of the tetrahedron x, y, z >= 0, x + y + z <= 1.
        RationalPoint corner = zero;
        const std::uint64_t axis = uniform_below(random, 4);
        if (axis < 3) corner[static_cast<Eigen::Index>(axis)] = 1;
        return corner;
      }));
}

TEST_CASE("kept_cells: the hull holds surfaces that are moved, joined and grown") {
  const ImplicitShape unit(implicit::Sphere{{0, 0, 0}, 1});
  // An ellipsoid, rotated by the quaternion (1, 2, 2, 4) / 5 and moved by (1/4, 0, 0).
  const ImplicitShape ellipsoid(implicit::Scale{{unit}, {1.5, 0.5, 1}});
  const std::array<Rational, 4> q = {Rational(1) / 5, Rational(2) / 5, Rational(2) / 5,
                                     Rational(4) / 5};
  const ImplicitShape moved(
      implicit::Translate{{ImplicitShape(implicit::Rotate{{ellipsoid}, q})}, {0.25, 0, 0}});
  const auto on_ellipsoid = [&](Random& random) {
    const RationalPoint p = on_unit_sphere(random);
    const RationalPoint before(p[0] * 3 / 2, p[1] / 2, p[2]);
    // v + 2 w (u x v) + 2 u x (u x v) rotates v by (w, u).
    const RationalPoint u(q[1], q[2], q[3]), t = u.cross(before) * Rational(2);
    return RationalPoint(before + t * q[0] + u.cross(t) + to_rational(Point(0.25, 0, 0)));
  };
  CHECK(holds_all(moved, kBox, on_ellipsoid));
  CHECK(moved.bounds().tightness == Rational(1) / 3);

  const ImplicitShape far_ball(implicit::Sphere{{1, 0.5, 0}, 0.75});
  const auto on_far_ball = [](Random& random) {
    return RationalPoint(on_unit_sphere(random) * (Rational(3) / 4) +
                         to_rational(Point(1, 0.5, 0)));
  };
  const std::vector<ImplicitShape> both = {moved, far_ball};
  for (const ImplicitShape& joined :
       {ImplicitShape(implicit::Union{both}), ImplicitShape(implicit::SmoothUnion{both, 0.25})}) {
    CHECK(holds_all(joined, kBox, on_ellipsoid));
    CHECK(holds_all(joined, kBox, on_far_ball));
  }
  CHECK(holds_all(ImplicitShape(implicit::Offset{{far_ball}, 0.125}), ImplicitBox{{-3, -3, -3}, 6},
                  [](Random& random) {
                    return RationalPoint(on_unit_sphere(random) * (Rational(7) / 8) +
                                         to_rational(Point(1, 0.5, 0)));
                  }));
  // The lower half of a ball: what is left when the upper one is taken away.
  const ImplicitShape half(
      implicit::Difference{{unit, ImplicitShape(implicit::Plane{{0, 0, -1}, 0})}});
  CHECK(holds_all(half, kBox, [](Random& random) {
    RationalPoint p = on_unit_sphere(random);
    if (p[2] > 0) p[2] = -p[2];
    return p;
  }));
}

TEST_CASE("kept_cells: what is refused" * sweep) {
  const ImplicitShape ball(implicit::Sphere{{0, 0, 0}, 1});
  const auto refusal = [&](const ImplicitShape& shape, const ImplicitBox& box, std::size_t depth) {
    return error_of([&] { return kept_cells(shape, box, depth); });
  };
  CHECK(refusal(ball, {{-1, -1, -1}, 2}, 4).code() == ErrorCode::NoInterior);
  CHECK(refusal(ball, {{-0.5, -0.5, -0.5}, 1}, 2).code() == ErrorCode::NoInterior);  // inside
  CHECK(refusal(ball, {{0, 0, 0}, 4}, 3).code() == ErrorCode::NoInterior);
  CHECK(refusal(ImplicitShape(implicit::Sphere{{9, 9, 9}, 1}), kBox, 3).code() ==
        ErrorCode::NoInterior);
  CHECK(refusal(ball, kBox, 21).code() == ErrorCode::InvalidArgument);
  CHECK(refusal(ball, {{-2, -2, -2}, 0}, 3).code() == ErrorCode::InvalidArgument);
  CHECK(refusal(ball, {{-2, -2, -2}, -4}, 3).code() == ErrorCode::InvalidArgument);
  CHECK(refusal(ball, {{-2, -2, -2}, INFINITY}, 3).code() == ErrorCode::NotFinite);
  // The last bit of 0.1 is 2^-56, and 4.4 with that bit has more than 53.
  CHECK(refusal(ball, {{-0.1, -2, -2}, 4.5}, 3).code() == ErrorCode::InvalidArgument);
  CHECK(refusal(ball, {{-2, -2, -2}, 0x1p-1070}, 5).code() == ErrorCode::InvalidArgument);
  // From 2^52 on, doubles are whole: at depth 3 the centers of cells are, at depth 4 they are not.
  const ImplicitShape far(implicit::Sphere{{0x1p52 + 8, 8, 8}, 3});
  const ImplicitBox far_box{{0x1p52, 0, 0}, 16};
  CHECK(kept_cells(far, far_box, 3).corners.size() > 0);
  CHECK(refusal(far, far_box, 4).code() == ErrorCode::InvalidArgument);
  // About 4^depth / 2 leaves.
  const Error many = refusal(ball, kBox, 12);
  CHECK(many.code() == ErrorCode::InvalidArgument);
  CHECK(std::string(many.what()).find("choose a smaller depth") != std::string::npos);

  const std::atomic<bool> stop = true;
  CHECK(error_of([&] { return kept_cells(ball, kBox, 5, Watch(&stop)); }).code() ==
        ErrorCode::Stopped);
}

TEST_CASE("kept_cells: overflow of doubles keeps what it cannot decide") {
  // Squares of 1e200 overflow, so only numbers of more bits decide: a ball of radius 1e200 in a box
  // of whole powers of two.
  const ImplicitShape ball(implicit::Sphere{{0, 0, 0}, 0x1p600});
  const ImplicitBox box{{-0x1p601, -0x1p601, -0x1p601}, 0x1p602};
  const ImplicitShape small(implicit::Sphere{{0, 0, 0}, 1});
  CHECK(kept_cells(ball, box, 4).leaves == kept_cells(small, {{-2, -2, -2}, 4}, 4).leaves);
}
