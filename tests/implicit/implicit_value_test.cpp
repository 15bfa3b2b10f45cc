// SPDX-License-Identifier: MIT
// The function of each node against its definition in plain doubles, and the bounds on it.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "convexact/implicit.hpp"
#include "expect_error.hpp"
#include "number/random.hpp"

using namespace convexact;

namespace {

const std::array<Rational, 4> kTurn = {Rational(1) / 5, Rational(2) / 5, Rational(2) / 5,
                                       Rational(4) / 5};

Point back(const Point& x) {
  const Point u(-0.4, -0.4, -0.8), t = 2 * u.cross(x);
  return x + 0.2 * t + u.cross(t);
}

double box_value(const Point& x, const Point& low, const Point& high, double radius) {
  const Point center = (low + high) / 2, half = (high - low) / 2;
  const Point q = (x - center).cwiseAbs() - (half - Point::Constant(radius));
  return q.cwiseMax(0).norm() + std::min(q.maxCoeff(), 0.0) - radius;
}

struct Sample {
  const char* name;
  ImplicitShape shape;
  std::function<double(const Point&)> value;
};

std::vector<Sample> samples() {
  using namespace implicit;
  const Point a(-0.75, 0.25, -1), b(0.5, 1, 0.25), u = b - a;
  const ImplicitShape ball(Sphere{a, 0.75}), cube(Box{{-1, -0.5, -1}, {0.5, 1, 0.75}});
  const auto ball_value = [=](const Point& x) { return (x - a).norm() - 0.75; };
  const auto cube_value = [](const Point& x) {
    return box_value(x, {-1, -0.5, -1}, {0.5, 1, 0.75}, 0);
  };
  return {{"sphere", ball, ball_value},
          {"capsule", ImplicitShape(Capsule{a, b, 0.5}),
           [=](const Point& x) {
             const double t = std::clamp((x - a).dot(u) / u.squaredNorm(), 0.0, 1.0);
             return (x - a - t * u).norm() - 0.5;
           }},
          {"box", cube, cube_value},
          {"rounded-box", ImplicitShape(Box{{-1, -0.5, -1}, {0.5, 1, 0.75}, 0.5}),
           [](const Point& x) {
             return box_value(x, {-1, -0.5, -1}, {0.5, 1, 0.75}, 0.5);
           }},
          {"torus", ImplicitShape(Torus{a, u, 1, 0.25}),
           [=](const Point& x) {
             const double axial = (x - a).dot(u.normalized());
             const double radial = (x - a - axial * u.normalized()).norm();
             return std::hypot(radial - 1, axial) - 0.25;
           }},
          {"cylinder", ImplicitShape(Cylinder{a, b, 0.5}),
           [=](const Point& x) {
             const double axial = (x - a).dot(u.normalized());
             const double side = (x - a - axial * u.normalized()).norm() - 0.5;
             const double end = std::abs(axial - u.norm() / 2) - u.norm() / 2;
             if (side <= 0 || end <= 0) return std::max(side, end);
             return std::hypot(side, end);
           }},
          {"half-space", ImplicitShape(Plane{{1, -2, 3}, 0.5}),
           [](const Point& x) { return (x[0] - 2 * x[1] + 3 * x[2] + 0.5) / std::sqrt(14); }},
          {"union", ImplicitShape(Union{{ball, cube}}),
           [=](const Point& x) { return std::min(ball_value(x), cube_value(x)); }},
          {"intersection", ImplicitShape(Intersection{{ball, cube}}),
           [=](const Point& x) { return std::max(ball_value(x), cube_value(x)); }},
          {"difference", ImplicitShape(Difference{{ball, cube}}),
           [=](const Point& x) { return std::max(ball_value(x), -cube_value(x)); }},
          {"smooth-union", ImplicitShape(SmoothUnion{{ball, cube}, 0.5}),
           [=](const Point& x) {
             const double f = ball_value(x), g = cube_value(x);
             const double h = std::max(0.5 - std::abs(f - g), 0.0) / 0.5;
             return std::min(f, g) - h * h * 0.5 / 4;
           }},
          {"translate", ImplicitShape(Translate{{cube}, {0.5, -1, 2}}),
           [=](const Point& x) { return cube_value(x - Point(0.5, -1, 2)); }},
          {"rotate", ImplicitShape(Rotate{{cube}, kTurn}),
           [=](const Point& x) { return cube_value(back(x)); }},
          {"scale", ImplicitShape(Scale{{cube}, {2, 0.5, 3}}),
           [=](const Point& x) {
             return 0.5 * cube_value({x[0] / 2, x[1] / 0.5, x[2] / 3});
           }},
          {"offset", ImplicitShape(Offset{{cube}, 0.25}),
           [=](const Point& x) { return cube_value(x) - 0.25; }}};
}

Point draw(Random& random) {
  const auto coordinate = [&] { return 6 * uniform_unit(random) - 3; };
  const double x = coordinate(), y = coordinate();
  return {x, y, coordinate()};
}

}  // namespace

TEST_CASE("enclose_value: both kinds of intervals hold the definition's value") {
  Random random(3);
  for (const Sample& sample : samples()) {
    CAPTURE(sample.name);
    for (int k = 0; k < 300; ++k) {
      const Point x = draw(random);
      const double expected = sample.value(x);
      const ImplicitRange range = enclose_value(sample.shape, x);
      // Plain doubles are a few units off, and the interval is as narrow.
      CHECK(range.low <= expected + 1e-13);
      CHECK(range.high >= expected - 1e-13);
      CHECK(range.high - range.low < 1e-12);
      const Enclosure exact = enclose_value(sample.shape, to_rational(x), 200);
      CHECK(exact.low() >= to_rational(range.low));
      CHECK(exact.high() <= to_rational(range.high));
      CHECK(exact.width() < Rational(1) / (Integer(1) << 150));
    }
  }
}

TEST_CASE("enclose_value: no value grows faster than its Lipschitz constant") {
  Random random(4);
  for (const Sample& sample : samples()) {
    CAPTURE(sample.name);
    CHECK(sample.shape.bounds().lipschitz == 1);
    for (int k = 0; k < 300; ++k) {
      const Point x = draw(random), y = k % 2 == 0 ? draw(random) : Point(x + draw(random) / 64);
      CHECK(std::abs(sample.value(x) - sample.value(y)) <= (x - y).norm() + 1e-13);
    }
  }
}

TEST_CASE("bounds: tightness by the rules of each node") {
  using namespace implicit;
  const ImplicitShape ball(Sphere{{0, 0, 0}, 1}), cube(Box{{2, 0, 0}, {3, 1, 1}});
  const auto tightness = [](implicit::Node node) {
    return ImplicitShape(std::move(node)).bounds().tightness;
  };
  for (const Sample& sample : samples()) {
    const std::string name = sample.name;
    const bool is_known = name != "intersection" && name != "difference" && name != "smooth-union";
    CHECK(sample.shape.bounds().tightness.has_value() == is_known);
  }
  const ImplicitShape flat(Scale{{ball}, {3, 1, 2}});
  CHECK(flat.bounds().tightness == Rational(1) / 3);
  CHECK(tightness(Scale{{flat}, {2, 2, 2}}) == Rational(1) / 3);
  CHECK(tightness(Scale{{flat}, {1, 2, 1}}) == Rational(1) / 6);
  CHECK(tightness(Union{{cube, flat}}) == Rational(1) / 3);
  CHECK(tightness(Translate{{flat}, {1, 0, 0}}) == Rational(1) / 3);
  CHECK(tightness(Rotate{{flat}, kTurn}) == Rational(1) / 3);
  const ImplicitShape both(Intersection{{ball, cube}});
  CHECK_FALSE(tightness(Union{{ball, both}}));
  CHECK(tightness(Offset{{ball}, 0.5}) == Rational(1));
  CHECK_FALSE(tightness(Offset{{ball}, -0.5}));
  CHECK_FALSE(tightness(Offset{{flat}, 0.5}));
  CHECK_FALSE(tightness(Offset{{both}, 0.5}));
}

TEST_CASE("bounds: an ellipsoid's value is at least a third of its distance") {
  // Outside of the ellipsoid (x/3)^2 + y^2 + (z/2)^2 <= 1: along an axis the distance is known.
  const ImplicitShape flat(
      implicit::Scale{{ImplicitShape(implicit::Sphere{{0, 0, 0}, 1})}, {3, 1, 2}});
  CHECK(enclose_value(flat, Point(6, 0, 0)).low == doctest::Approx(3.0 / 3));
  CHECK(enclose_value(flat, Point(0, 4, 0)).low == doctest::Approx(3.0));
  CHECK(enclose_value(flat, Point(0, 0, 6)).low == doctest::Approx(4.0 / 2));
}

TEST_CASE("closed_measures: closed forms of convex shapes, and nothing of others") {
  using namespace implicit;
  const auto check = [](const ImplicitShape& shape, double v, double a, double b) {
    const auto measures = closed_measures(shape, 128);
    REQUIRE(measures);
    CHECK(measures->volume.high_double() == doctest::Approx(v).epsilon(1e-14));
    CHECK(measures->area.high_double() == doctest::Approx(a).epsilon(1e-14));
    CHECK(measures->mean_width.high_double() == doctest::Approx(b).epsilon(1e-14));
  };
  const ImplicitShape ball(Sphere{{1, 2, 3}, 2}), cube(Box{{0, 0, 0}, {1, 2, 3}});
  check(ball, 4.0 / 3 * M_PI * 8, 16 * M_PI, 4);
  check(cube, 6, 22, 3);
  check(ImplicitShape(Cylinder{{0, 0, 0}, {0, 3, 4}, 2}), 20 * M_PI, 28 * M_PI, 2.5 + M_PI);
  check(ImplicitShape(Scale{{cube}, {2, 2, 2}}), 48, 88, 6);
  check(ImplicitShape(Offset{{ball}, 1}), 36 * M_PI, 36 * M_PI, 6);
  check(ImplicitShape(Rotate{{cube}, kTurn}), 6, 22, 3);
  // A box of sides 2 with edges rounded by 1 is a ball.
  check(ImplicitShape(Box{{-1, -1, -1}, {1, 1, 1}, 1}), 4.0 / 3 * M_PI, 4 * M_PI, 2);
  CHECK_FALSE(closed_measures(ImplicitShape(Scale{{cube}, {2, 2, 1}}), 128));
  CHECK_FALSE(closed_measures(ImplicitShape(Union{{cube}}), 128));
  CHECK_FALSE(closed_measures(ImplicitShape(Offset{{cube}, -0.25}), 128));
  CHECK_FALSE(closed_measures(ImplicitShape(Torus{{0, 0, 0}, {0, 0, 1}, 2, 1}), 128));
}

TEST_CASE("ImplicitShape: numbers out of the range of their node are refused") {
  using namespace implicit;
  const ImplicitShape ball(Sphere{{0, 0, 0}, 1});
  const auto code = [](implicit::Node node) {
    return error_of([&] { return ImplicitShape(node); }).code();
  };
  const double nan = std::nan("");
  CHECK(code(Sphere{{0, nan, 0}, 1}) == ErrorCode::NotFinite);
  CHECK(code(Sphere{{0, 0, 0}, nan}) == ErrorCode::NotFinite);
  for (const Node& node : std::vector<Node>{
           Sphere{{0, 0, 0}, 0}, Sphere{{0, 0, 0}, -1}, Capsule{{1, 1, 1}, {1, 1, 1}, 1},
           Box{{0, 0, 0}, {1, 0, 1}}, Box{{0, 0, 0}, {1, 2, 3}, 0.51},
           Box{{0, 0, 0}, {1, 2, 3}, -1}, Torus{{0, 0, 0}, {0, 0, 0}, 1, 1},
           Torus{{0, 0, 0}, {0, 0, 1}, 1, 0}, Cylinder{{0, 0, 0}, {1, 0, 0}, -2},
           Plane{{0, 0, 0}, 1}, Union{}, Intersection{}, Difference{}, SmoothUnion{{ball}, 1},
           SmoothUnion{{ball, ball}, 0}, SmoothUnion{{ball, ball, ball}, 1},
           Translate{{}, {0, 0, 0}}, Scale{{ball}, {1, 0, 1}},
           Rotate{{ball}, {Rational(1), Rational(1), Rational(0), Rational(0)}}}) {
    CHECK(code(node) == ErrorCode::InvalidArgument);
  }
  ImplicitShape deep = ball;
  for (int k = 0; k < 63; ++k) deep = ImplicitShape(Offset{{deep}, 0});
  CHECK(deep.levels() == 64);
  CHECK(code(Offset{{deep}, 0}) == ErrorCode::InvalidArgument);
}
