// SPDX-License-Identifier: MIT
// Everything that the filtered engine decides without exact numbers is decided again: signs by a
// determinant of rationals, caps by the exact engine's explicit polytopes.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <variant>

#include "convexact/dual/polar.hpp"
#include "convexact/fast/filtered_loop.hpp"
#include "convexact/hull/hull.hpp"
#include "convexact/io/read_mesh.hpp"
#include "convexact/shapes/extreme.hpp"
#include "convexact/shapes/prisms.hpp"
#include "convexact/shapes/random_points.hpp"
#include "convexact/simplify/cap.hpp"
#include "exact_determinant.hpp"

using namespace convexact;

namespace {

// Decides again every `stride`-th sign and cap that it hears of.
class Auditor {
 public:
  Auditor(const FastDual& dual, std::size_t stride) : dual_(dual), stride_(stride) {}

  void height(HalfspaceId a, HalfspaceId b, HalfspaceId c, HalfspaceId p, Verdict verdict) {
    if (verdict == Verdict::Unknown) {
      ++unknown_signs;
      return;
    }
    if (++signs % stride_ != 0) return;
    std::vector<std::vector<Rational>> rows;
    for (const HalfspaceId i : {a, b, c, p}) {
      const Halfspace& h = dual_.exact(i);
      rows.push_back({Rational(h.normal()[0]), Rational(h.normal()[1]), Rational(h.normal()[2]),
                      Rational(h.offset())});
    }
    CHECK(static_cast<int>(sign_of(exact_determinant(rows))) == static_cast<int>(verdict));
    ++signs_checked;
  }

  template <class Scalar>
  void cap(HalfspaceId i, const OneRing& ring, const std::vector<RingTriangle>& triangles,
           const CapRange<Scalar>& range) {
    using Kind = typename CapRange<Scalar>::Kind;
    unenclosed_caps += range.kind == Kind::Doubtful;
    if (range.kind == Kind::Doubtful || ++caps % stride_ != 0) return;
    const auto point = [&](HalfspaceId v) { return polar(dual_.exact(v), dual_.center()); };
    const std::size_t k = ring.vertices.size();
    std::vector<DualPlane> base;
    for (std::size_t m = 0; m < k; ++m) {
      base.push_back(
          plane_through(point(i), point(ring.vertices[m]), point(ring.vertices[(m + 1) % k])));
    }
    RingTriangulation roof;
    for (const RingTriangle& t : triangles) {
      const DualTriangle corners{ring.vertices[t.low], ring.vertices[t.middle],
                                 ring.vertices[t.high]};
      roof.triangles.push_back(corners);
      roof.planes.push_back(plane_through(point(corners[0]), point(corners[1]), point(corners[2])));
    }
    REQUIRE(roof.is_bounded() == (range.kind == Kind::Bounded));
    ++caps_checked;
    if (range.kind != Kind::Bounded) return;
    const Rational six_times = scale_by_power_of_two(
        volume(make_cap(ring.vertices, base, roof)) * 6, -dual_.volume_exponent());
    CHECK(exactly(range.lower) <= six_times);
    CHECK(six_times <= exactly(range.upper));
  }

  std::size_t signs = 0, unknown_signs = 0, signs_checked = 0;
  std::size_t caps = 0, unenclosed_caps = 0, caps_checked = 0;

 private:
  static Rational exactly(double x) { return to_rational(x); }
  static Rational exactly(const DoubleDouble& x) {
    return to_rational(x.hi()) + to_rational(x.lo());
  }

  const FastDual& dual_;
  std::size_t stride_;
};

// Runs the loop to the end under an audit; returns the auditor and the counts.
std::pair<Auditor, FastCounts> audit(const std::vector<Point>& points, std::size_t stride,
                                     std::size_t faces = 4) {
  const PointSet set(points);
  const HullOutcome outcome = convex_hull(set);
  REQUIRE(std::holds_alternative<Hull>(outcome));
  const FastDual dual = FastDual::of(std::get<Hull>(outcome), set);
  Auditor auditor(dual, stride);
  const SimplifyOptions options{.faces = faces};
  const FastResult result = FilteredLoop<Auditor>(dual, options, auditor).run();
  return {auditor, result.counts};
}

std::vector<Point> mesh(const std::string& name) {
  const Mesh mesh = read_mesh(std::string(std::getenv("CONVEXACT_TEST_DATA")) + "/" + name);
  const auto points = mesh.points.doubles();
  return {points.begin(), points.end()};
}

}  // namespace

TEST_CASE("FilteredLoop: certified signs and enclosures are true on a scan, and most suffice") {
  const auto [auditor, counts] = audit(mesh("bunny.obj"), 40, 18);
  CHECK(auditor.signs_checked > 1000);
  CHECK(auditor.caps_checked > 150);
  // 7 to 12 in a hundred signs are zeros of planes with a common vertex; hardly any other is left.
  CHECK(counts.signs.filtered > 0.85 * double(counts.signs.filtered + counts.signs.incident));
  CHECK(counts.signs.incident > 0);
  CHECK(counts.signs.extended + counts.signs.exact < 0.001 * double(counts.signs.filtered));
  CHECK(counts.doubtful + counts.exact < 0.01 * double(counts.evaluations));
}

TEST_CASE("FilteredLoop: certified signs and enclosures are true on a symmetric mesh with ties") {
  const auto [auditor, counts] = audit(mesh("spot.obj"), 10, 18);
  CHECK(auditor.signs_checked > 1000);
  CHECK(auditor.caps_checked > 100);
  CHECK(counts.exact > 0);  // its mirror images tie exactly
  CHECK(counts.signs.filtered > 0.85 * double(counts.signs.filtered + counts.signs.incident));
}

TEST_CASE("FilteredLoop: certified signs and enclosures are true near the worst case") {
  std::size_t signs = 0, unknown = 0, caps = 0;
  const auto add = [&](const std::vector<Point>& points) {
    const auto [auditor, counts] = audit(points, 1);
    signs += auditor.signs_checked;
    unknown += auditor.unknown_signs;
    caps += auditor.caps_checked;
  };
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    CAPTURE(seed);
    add(shapes::nearly_coplanar(24, seed));
    add(shapes::needle(24, 1e12, seed));
    add(shapes::slab(24, 1e9, seed));
    add(shapes::offset_ball(24, 1e8, seed));
    add(shapes::scaled_ball(24, -300, seed));
    add(shapes::wide_exponents(16, 40, seed));
    add(shapes::lattice(24, 2, seed));
  }
  add(shapes::prism(17));
  add(shapes::antiprism(20));
  add(shapes::cylinder(12, 4));
  add(shapes::fibonacci_sphere(80));
  CHECK(signs > 4000);
  CHECK(unknown > 500);
  CHECK(caps > 2000);
}

TEST_CASE("FastDual: rounded dual points are as close as promised") {
  for (const std::vector<Point>& points :
       {shapes::in_ball(60, 1), shapes::offset_ball(40, 1e8, 2), shapes::needle(40, 1e12, 3),
        shapes::lattice(40, 3, 4), shapes::huge(30, 5), shapes::subnormal(30, 9, 6),
        shapes::wide_exponents(20, 300, 7)}) {
    const PointSet set(points);
    const HullOutcome outcome = convex_hull(set);
    REQUIRE(std::holds_alternative<Hull>(outcome));
    const FastDual dual = FastDual::of(std::get<Hull>(outcome), set);
    // The powers of two by which the axes were scaled multiply up to the unit of volume.
    long exponent_sum = 0;
    for (int k = 0; k < 3; ++k) {
      const auto coordinate = [&](const Triple<double>& p) {
        return k == 0 ? p.x : k == 1 ? p.y : p.z;
      };
      std::size_t largest = 0;
      for (std::size_t i = 0; i < dual.size(); ++i) {
        if (std::abs(coordinate(dual.near(HalfspaceId(i)))) >
            std::abs(coordinate(dual.near(HalfspaceId(largest))))) {
          largest = i;
        }
      }
      const auto exact = [&](std::size_t i) {
        const Halfspace& h = dual.exact(HalfspaceId(i));
        return Rational(Rational(h.normal()[k]) / -h(dual.center()));
      };
      const double top = coordinate(dual.near(HalfspaceId(largest)));
      CHECK(std::abs(top) <= 1);
      CHECK(std::abs(top) >= 0.5);
      // The power of two that brings the exact coordinate to the rounded one.
      const Rational ratio = abs(exact(largest) / to_rational(top));
      long exponent = static_cast<long>(bit_length(numerator(ratio))) -
                      static_cast<long>(bit_length(denominator(ratio))) - 1;
      while (scale_by_power_of_two(ratio, -exponent) > Rational(5, 4)) ++exponent;
      exponent_sum += exponent;
      for (std::size_t i = 0; i < dual.size(); ++i) {
        const Rational q = scale_by_power_of_two(exact(i), -exponent);
        const Rational near = to_rational(coordinate(dual.near(HalfspaceId(i))));
        const Rational both = near + to_rational(coordinate(dual.rest(HalfspaceId(i))));
        const Rational underflow = scale_by_power_of_two(Rational(1), -1074);
        CHECK(abs(near - q) <= abs(near) * to_rational(FastDual::kNearError) + underflow);
        CHECK(abs(both - q) <= abs(near) * to_rational(FastDual::kLongError) + underflow);
      }
    }
    CHECK(dual.volume_exponent() == -exponent_sum);
  }
}
