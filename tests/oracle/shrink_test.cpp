// SPDX-License-Identifier: MIT
// Shrinking: predicates whose minimum is known in closed form, and the promises of shrink.hpp
// tested on the result by the definition.
#include "convexact/shrink.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

#include "convexact/error.hpp"
#include "convexact/hull.hpp"
#include "shapes/makers.hpp"

using namespace convexact;

namespace {

using Fails = std::function<bool(const PointSet&)>;

Shrunk shrunk(const PointSet& points, const Fails& fails) {
  return shrink(points, [&](const PointSet& set, std::span<const PointId> origin) {
    REQUIRE(origin.size() == set.size());
    REQUIRE(std::is_sorted(origin.begin(), origin.end()));
    return fails(set);
  });
}

// The promises, by trying every way to break them.
void check_minimal(const Shrunk& result, const Fails& fails) {
  std::vector<RationalPoint> points;
  for (std::size_t i = 0; i < result.points.size(); ++i)
    points.push_back(result.points[PointId(i)]);
  CHECK(fails(result.points));
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::vector<RationalPoint> fewer = points;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    CHECK_FALSE(fails(PointSet(fewer)));
    for (int k = 0; k < 3; ++k) {
      const Rational x = points[i][k];
      std::vector<Rational> values{0, 1, -1};
      if (denominator(x) == 1) values.emplace_back(Integer(numerator(x) / 2));
      for (const Rational& value : values) {
        if (coordinate_bits(value) >= coordinate_bits(x) || (value * x < 0)) continue;
        std::vector<RationalPoint> simpler = points;
        simpler[i][k] = value;
        CHECK_FALSE(fails(PointSet(simpler)));
      }
    }
  }
}

std::vector<Point> cloud(std::uint32_t count, std::uint64_t seed = 1) {
  return shapes::in_box(count, seed);
}

}  // namespace

TEST_CASE("coordinate_bits: numerator and denominator") {
  CHECK(coordinate_bits(Rational(0)) == 0);
  CHECK(coordinate_bits(Rational(-1)) == 1);
  CHECK(coordinate_bits(Rational(5)) == 3);
  CHECK(coordinate_bits(Rational(1, 4)) == 3);
  CHECK(coordinate_bits(Rational(Integer(1) << 999)) == 1000);
  CHECK(coordinate_bits(PointSet(std::vector<Point>{{0, 1, 5}, {0.25, 0, 0}})) == 7);
}

TEST_CASE("shrink: what always fails becomes nothing") {
  const Fails always = [](const PointSet&) { return true; };
  CHECK(shrunk(PointSet(cloud(100)), always).points.size() == 0);
}

TEST_CASE("shrink: what does not fail is refused") {
  CHECK_THROWS_AS((void)shrunk(PointSet(cloud(9)), [](const PointSet&) { return false; }), Error);
}

TEST_CASE("shrink: k points needed, whichever, are k points at the origin") {
  for (const std::size_t k : {1u, 2u, 7u, 50u}) {
    const Fails fails = [k](const PointSet& set) { return set.size() >= k; };
    const Shrunk result = shrunk(PointSet(cloud(200)), fails);
    CHECK(result.points.size() == k);
    CHECK(coordinate_bits(result.points) == 0);
    check_minimal(result, fails);
  }
}

TEST_CASE("shrink: single points needed, far apart in a large set, are found quickly") {
  std::vector<Point> points = cloud(5000);
  for (Point& p : points) p += Point(3, 3, 3);
  const std::vector<std::size_t> culprits = {17, 2500, 4999};
  for (std::size_t c = 0; c < culprits.size(); ++c)
    points[culprits[c]][0] = -1000.5 - static_cast<double>(c);
  const auto fails = [](const PointSet& set, std::span<const PointId>) {
    std::size_t negative = 0;
    for (const Point& p : set.doubles()) negative += p[0] < -100;
    return negative >= 3;
  };
  const Shrunk result = shrink(PointSet(points), fails);
  CHECK(result.origin == std::vector{PointId(17), PointId(2500), PointId(4999)});
  CHECK(result.tries < 400);
  // Below -100, but no more so when it is halved.
  for (const Point& p : result.points.doubles()) {
    CHECK(p[0] < -100);
    CHECK(p[0] > -202);
    CHECK(p[1] == 0);
    CHECK(p[2] == 0);
  }
}

TEST_CASE("shrink: a solid is four points, of coordinates 0 and +-1") {
  const Fails spans = [](const PointSet& set) {
    return std::holds_alternative<Hull>(convex_hull(set));
  };
  for (const auto& points :
       {cloud(60, 3), shapes::cut_cube(8, 0.25),
        std::vector<Point>{
            {1e300, 0, 0}, {0, 1e-300, 0}, {0.1, 0.2, 0.3}, {-7, 1e16, 2}, {5, 5, 5}}}) {
    const Shrunk result = shrunk(PointSet(points), spans);
    CHECK(result.points.size() == 4);
    check_minimal(result, spans);
    for (const Point& p : result.points.doubles()) CHECK(p.cwiseAbs().maxCoeff() <= 1);
  }
}

TEST_CASE("shrink: a difference that only the last bits hold keeps them") {
  // Fails iff two points differ in x by less than 2^-20 of the larger, but differ.
  const Fails close = [](const PointSet& set) {
    for (const Point& p : set.doubles()) {
      for (const Point& q : set.doubles()) {
        if (p[0] < q[0] && q[0] - p[0] < std::abs(q[0]) * 0x1p-20) return true;
      }
    }
    return false;
  };
  std::vector<Point> points = cloud(40, 5);
  points.push_back({points[7][0] * (1 + 0x1p-22), 3, 4});
  const Shrunk result = shrunk(PointSet(points), close);
  CHECK(result.points.size() == 2);
  check_minimal(result, close);
  // As integers, q > 2^20 (q - p) >= 2^20: never less than 21 bits each; 53 to begin with.
  CHECK(coordinate_bits(result.points) >= 42);
  CHECK(coordinate_bits(result.points) <= 56);
}

TEST_CASE("shrink: rationals, and that a binary set stays binary") {
  const Fails thirds = [](const PointSet& set) {
    for (std::size_t i = 0; i < set.size(); ++i) {
      if (denominator(Rational(set[PointId(i)][0])) % 3 == 0) return true;
    }
    return false;
  };
  const std::vector<RationalPoint> points(9, RationalPoint(Rational(22, 21), Rational(1, 7), 5));
  const Shrunk result = shrunk(PointSet(points), thirds);
  CHECK(result.points.size() == 1);
  CHECK(result.points[PointId(0)] == RationalPoint(Rational(11, 21), 0, 0));
  const Fails any = [](const PointSet& set) { return set.is_binary() && set.size() > 2; };
  CHECK(shrunk(PointSet(std::vector<Point>{{1e308, 5e-324, 0.1}, {-1e308, 0, 1}, {1, 2, 3}}), any)
            .points.is_binary());
}

TEST_CASE("shrink: points near the largest double, whose differences are beyond it") {
  const double most = std::numeric_limits<double>::max();
  const Fails any = [](const PointSet& set) { return set.size() > 2; };
  const Shrunk result =
      shrunk(PointSet(std::vector<Point>{{most, 0, 0}, {-most, 1, 0}, {1.7e308, 0, 1}}), any);
  CHECK(result.points.size() == 3);
}

TEST_CASE("shrink: the same again, whenever it is asked") {
  const Fails fails = [](const PointSet& set) {
    double sum = 0;
    for (const Point& p : set.doubles()) sum += p[0] * p[1];
    return sum > 1.5;
  };
  std::vector<Point> points = cloud(100, 9);
  for (Point& p : points) p *= 4;
  if (!fails(PointSet(points))) points.push_back({100, 100, 100});
  const Shrunk one = shrunk(PointSet(points), fails), two = shrunk(PointSet(points), fails);
  CHECK(one.origin == two.origin);
  CHECK(one.tries == two.tries);
  CHECK(std::ranges::equal(one.points.doubles(), two.points.doubles()));
  check_minimal(one, fails);
}

TEST_CASE("shrink: halfspaces, few and of short numbers; the promises by the definition (#13)") {
  using HalfspacesFail = std::function<bool(std::span<const Halfspace>)>;
  std::vector<Halfspace> halfspaces;
  for (const Point& p : cloud(40)) {
    halfspaces.emplace_back(
        RationalVector3(to_rational(p.x()), to_rational(p.y()), to_rational(p.z())), Rational(-1));
  }
  const RationalPoint far(1000, 0, 0);
  const HalfspacesFail cuts_far = [&](std::span<const Halfspace> rows) {
    return std::any_of(rows.begin(), rows.end(), [&](const Halfspace& h) { return h(far) > 0; });
  };
  const HalfspacesFail is_many = [](std::span<const Halfspace> rows) { return rows.size() >= 5; };
  const HalfspacesFail needs_bits = [](std::span<const Halfspace> rows) {
    return std::count_if(rows.begin(), rows.end(), [](const Halfspace& h) {
             return h.normal()[0] > 1000 && h.normal()[1] < -1000;
           }) >= 2;
  };
  REQUIRE(needs_bits(halfspaces));
  CHECK(shrink(halfspaces, cuts_far).size() == 1);
  CHECK(coordinate_bits(shrink(halfspaces, cuts_far)) == 1);  // x <= 0
  CHECK(shrink(halfspaces, is_many).size() == 5);
  CHECK(coordinate_bits(shrink(halfspaces, is_many)) == 5);
  for (const HalfspacesFail& fails : {cuts_far, is_many, needs_bits}) {
    const std::vector<Halfspace> result = shrink(halfspaces, fails);
    CHECK(fails(result));
    for (std::size_t i = 0; i < result.size(); ++i) {
      std::vector<Halfspace> fewer = result;
      fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
      CHECK_FALSE(fails(fewer));
      for (int k = 0; k < 4; ++k) {
        IntegerVector3 normal = result[i].normal();
        Integer offset = result[i].offset();
        Integer& x = k < 3 ? normal[k] : offset;
        const Integer was = x;
        for (const Integer& value : {Integer(0), Integer(was < 0 ? -1 : 1), Integer(was / 2)}) {
          x = value;
          const bool is_simpler = coordinate_bits(Rational(value)) < coordinate_bits(Rational(was));
          if (!is_simpler || (normal[0] == 0 && normal[1] == 0 && normal[2] == 0)) continue;
          std::vector<Halfspace> simpler = result;
          simpler[i] = Halfspace(normal, offset);
          CHECK_FALSE(fails(simpler));
        }
        x = was;
      }
    }
  }
}
