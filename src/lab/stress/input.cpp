// SPDX-License-Identifier: MIT
#include "lab/stress/input.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <memory>

#include "convexact/error.hpp"
#include "convexact/shapes.hpp"
#include "number/random.hpp"

namespace convexact {
namespace {

// Halfspaces n.x <= reach with the origin strictly inside.
struct Bound {
  RationalVector3 normal;
  Rational reach;
};

int exponent(Random& random, std::span<const int> largest) {
  const int most = largest[uniform_below(random, largest.size())];
  return static_cast<int>(uniform_below(random, 2 * static_cast<std::uint64_t>(most) + 1)) - most;
}

// In [-1, 1], of 53 bits or of 300 digits.
Rational number(Random& random, bool is_long) {
  if (!is_long) return to_rational(2 * uniform_unit(random) - 1);
  Integer p = 0;
  for (int k = 0; k < 16; ++k) p = p * Integer(std::uint64_t(1) << 63) + Integer(random() >> 1);
  return 2 * Rational(p, Integer(1) << (16 * 63)) - 1;
}

RationalVector3 direction(Random& random, bool is_long) {
  for (;;) {
    RationalVector3 n(number(random, is_long), number(random, is_long), number(random, is_long));
    if (!n.isZero()) return n;
  }
}

Bound some_bound(Random& random, const std::vector<Bound>& others) {
  constexpr std::array kReach{0, 0, 0, 3, 60, 500};
  constexpr std::array kTilt{1, 20, 52, 53, 120, 300};
  const bool is_long = uniform_below(random, 8) == 0;
  const Bound& other = others[uniform_below(random, others.size())];
  switch (uniform_below(random, 6)) {
    case 0:
      return other;
    case 1: {  // tilted
      const int tilt = -kTilt[uniform_below(random, kTilt.size())];
      const RationalVector3 by = direction(random, is_long);
      Bound bound = other;
      for (int k = 0; k < 3; ++k) bound.normal[k] += scale_by_power_of_two(by[k], tilt);
      if (bound.normal.isZero()) bound.normal = by;
      return bound;
    }
    case 2: {  // moved in or out
      const int share = -kTilt[uniform_below(random, kTilt.size())];
      return {other.normal,
              other.reach * (1 + scale_by_power_of_two(number(random, is_long), share - 1))};
    }
    default: {
      const Rational size = 2 + number(random, is_long);
      return {direction(random, is_long), scale_by_power_of_two(size, exponent(random, kReach))};
    }
  }
}

std::vector<Bound> random_box(Random& random) {
  constexpr std::array kSize{0, 0, 3, 60, 500};
  std::vector<Bound> bounds;
  for (int k = 0; k < 3; ++k) {
    for (const int side : {-1, 1}) {
      RationalVector3 normal = RationalVector3::Zero();
      normal[k] = side;
      bounds.push_back({normal, scale_by_power_of_two(1, exponent(random, kSize))});
    }
  }
  return bounds;
}

// A box, then `parts` groups of halfspaces that all hold one point: at random distances of it from
// 2^-500 to 2^500, copies tilted or moved by as little as 2^-300, repeats, and normals and offsets
// of 300 digits. Then everything is moved, perhaps far away. Bounded, not empty.
std::vector<Halfspace> mixed_halfspaces(std::uint32_t parts, std::uint64_t seed) {
  constexpr std::array kAway{0, 0, 30, 300};
  Random random(seed);
  std::vector<Bound> bounds = random_box(random);
  for (std::uint32_t k = 0; k < 8 * parts; ++k) bounds.push_back(some_bound(random, bounds));
  RationalVector3 away = RationalVector3::Zero();
  if (uniform_below(random, 2) == 0) {
    const RationalVector3 by = direction(random, uniform_below(random, 4) == 0);
    const int e = exponent(random, kAway);
    for (int k = 0; k < 3; ++k) away[k] = scale_by_power_of_two(by[k], e);
  }
  std::vector<Halfspace> halfspaces;
  for (const Bound& bound : bounds) {
    halfspaces.emplace_back(bound.normal, Rational(-bound.reach - bound.normal.dot(away)));
  }
  return halfspaces;
}

using Values = std::vector<double>;

std::ptrdiff_t index_of(const shapes::Family& family, const std::string& parameter) {
  const auto& all = family.parameters;
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const shapes::Parameter& p) { return p.name == parameter; });
  return found == all.end() ? -1 : found - all.begin();
}

// A family of shapes, swept over one of its parameters, or over none if nothing can be varied.
// `points` applies to families with a plain number of points.
StressFamily sweep(const std::string& name, const std::string& parameter, Values values,
                   Values large = {}) {
  const shapes::Family& family = shapes::family(name);
  const std::ptrdiff_t swept = index_of(family, parameter);
  const std::ptrdiff_t points = name == "cube-symmetric" ? -1 : index_of(family, "points");
  if (values.empty()) values = {0};
  const auto make = [&family, swept, points](double value, std::uint32_t count,
                                             std::uint64_t seed) -> Shape {
    std::vector<double> v = shapes::usual_values(family);
    if (points >= 0) v[static_cast<std::size_t>(points)] = count;
    if (swept >= 0) v[static_cast<std::size_t>(swept)] = value;
    return PointSet(shapes::generate(family, v, seed));
  };
  return {.name = name,
          .description = std::string(family.description),
          .parameter = parameter,
          .values = std::move(values),
          .large_values = std::move(large),
          .make = make};
}

Values powers_of_two(std::initializer_list<int> exponents) {
  Values values;
  for (const int e : exponents) values.push_back(std::ldexp(1.0, e));
  return values;
}

// Shapes that are thin, nearly flat or round, or of large valences or extreme scales.
void add_extreme(std::vector<StressFamily>& list) {
  const Values aspects{1,    10,   1e2,  1e4,  1e6,  1e8,   1e10,  1e12,  1e14,  1e15,
                       1e16, 1e17, 1e20, 1e30, 1e60, 1e100, 1e150, 1e200, 1e250, 1e300};
  list.push_back(sweep("needle", "aspect", aspects));
  list.push_back(sweep("slab", "aspect", aspects));
  list.push_back(
      sweep("offset-ball", "distance", {1, 1e2, 1e4, 1e6, 1e8, 1e10, 1e12, 1e13, 1e14, 1e15}));
  list.push_back(sweep("tilted-lid", "tilt",
                       powers_of_two({0, -1, -2, -4, -8, -12, -16, -20, -24, -28, -32, -36, -40,
                                      -44, -48, -50, -51, -52})));
  const Values counts{5, 8, 12, 20, 50, 100, 300, 1000};
  list.push_back(sweep("nearly-flat", "points", {8, 12, 20, 50, 100, 300, 1000}));
  list.push_back(sweep("nearly-coplanar", "points", counts, {3000}));
  list.push_back(sweep("random-sphere", "points", counts, {3000, 10000}));
  list.push_back(sweep("fibonacci-sphere", "points", counts, {3000, 10000}));
  list.push_back(sweep("nearly-cospherical", "ulps", {0, 1, 2, 16, 256, 4096, 65536, 0x1p20}));
  const Values valences{10, 30, 100, 300, 1000}, large{3000, 10000, 30000, 100000};
  list.push_back(sweep("pyramid", "k", valences, large));
  list.push_back(sweep("bipyramid", "k", valences, large));
  list.push_back(sweep("moment-curve", "points", valences, large));
  list.push_back(sweep("cone", "k", {10, 100, 1000}));
  list.push_back(sweep("cylinder", "k", {10, 100, 1000}, {10000}));
  list.push_back(
      sweep("scaled-ball", "exponent", {-1000, -800, -537, -400, -340, -300, -150, -126, -30, 0, 30,
                                        100,   126,  150,  300,  340,  400,  537,  800,  1000}));
  list.push_back(sweep("subnormal", "range", {1, 3, 10, 100, 1e4, 1e8, 0x1p40, 0x1p52 - 1}));
  list.push_back(sweep("huge", "points", {8, 50, 200}));
  list.push_back(sweep("wide-exponents", "exponent",
                       {0, 1, 5, 10, 30, 52, 53, 100, 200, 300, 400, 500, 800, 1000}));
  list.push_back(sweep("mixed-scales", "exponent",
                       {0, 1, 5, 10, 20, 26, 27, 52, 53, 100, 200, 300, 400, 500}));
}

// Shapes with large facets, symmetries and repeats.
void add_regular(std::vector<StressFamily>& list) {
  const Values corners{3, 4, 5, 6, 7, 8, 12, 24, 60, 100, 360};
  list.push_back(sweep("prism", "k", corners, {1000, 10000, 100000}));
  list.push_back(sweep("antiprism", "k", corners, {1000, 10000, 100000}));
  list.push_back(sweep("box", "a", {1e-300, 1e-100, 1e-8, 1, 1e8, 1e100, 1e300}));
  list.push_back(sweep("rounded-box", "segments", {1, 2, 3, 4, 6, 8, 12}));
  StressFamily edges = sweep("rounded-box", "radius",
                             {1e-300, 1e-100, 1e-20, 1e-16, 1e-12, 1e-8, 1e-4, 1, 1e4, 1e8, 1e16});
  edges.name = "rounded-edges";
  edges.description = "a box plus a ball that is much smaller or larger";
  list.push_back(edges);
  list.push_back(
      sweep("chamfered-box", "width", powers_of_two({-50, -48, -40, -30, -20, -10, -4, -2, -1})));
  list.push_back(sweep("cut-cube", "corners", {0, 1, 2, 3, 4, 5, 6, 7, 8}));
  for (const char* solid : {"tetrahedron", "cube", "octahedron", "dodecahedron",
                            "rounded-dodecahedron", "icosahedron"}) {
    list.push_back(sweep(solid, "", {}));
  }
  list.push_back(
      sweep("cospherical", "squared-radius", {9, 17, 26, 29, 41, 50, 54, 89, 146, 1001}));
  list.push_back(sweep("centrally-symmetric", "points", {3, 5, 10, 20, 50, 100}));
  list.push_back(sweep("cube-symmetric", "points", {1, 2, 3, 5}));
  list.push_back(sweep("grid", "n", {2, 3, 5, 10}));
  list.push_back(sweep("lattice", "range", {1, 2, 3, 5, 10, 100, 1e6, 0x1p52}));
  list.push_back(sweep("repeated-sphere", "copies", {1, 2, 5, 50}));
}

void add_others(std::vector<StressFamily>& list) {
  list.push_back(sweep("random-box", "points", {4, 5, 6, 8, 20, 100, 1000}));
  list.push_back(sweep("random-ball", "points", {4, 5, 6, 8, 20, 100, 1000}));
  for (const char* flat : {"all-equal", "collinear", "coplanar"}) {
    list.push_back(sweep(flat, "points", {1, 2, 3, 4, 50}));
  }
  list.push_back(sweep("mixture", "parts", {1, 2, 3, 4, 5, 6, 7, 8}));
  list.push_back({"mixed-halfspaces",
                  "halfspaces: tiny tilts, huge offsets, repeats, numbers of 300 digits",
                  "parts",
                  {1, 2, 3, 4, 5, 6, 7, 8},
                  {},
                  [](double value, std::uint32_t, std::uint64_t seed) -> Shape {
                    if (!(value >= 0 && value <= 1000)) {
                      throw Error(ErrorCode::InvalidArgument, "0 to 1000 parts");
                    }
                    return mixed_halfspaces(static_cast<std::uint32_t>(value), seed);
                  }});
}

std::vector<StressFamily> make_families() {
  std::vector<StressFamily> list;
  add_extreme(list);
  add_regular(list);
  add_others(list);
  return list;
}

double diameter_of(std::span<const Point> points) {
  Point low = points[0], high = points[0];
  for (const Point& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).norm();
}

}  // namespace

std::span<const StressFamily> stress_families() {
  static const std::vector<StressFamily> list = make_families();
  return list;
}

const StressFamily& stress_family(const std::string& name) {
  const auto all = stress_families();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const StressFamily& f) { return f.name == name; });
  if (found == all.end()) {
    throw Error(ErrorCode::InvalidArgument,
                "there is no family called '" + name + "'; convexact stress --list names them");
  }
  return *found;
}

StressFamily mesh_family(const std::string& name, std::vector<Point> points) {
  if (points.empty()) throw Error(ErrorCode::InvalidArgument, name + ": the mesh has no points");
  const auto shared = std::make_shared<const std::vector<Point>>(std::move(points));
  return {name,
          "a mesh, scaled; below 0 also moved by 1e8",
          "diameter",
          {1e-6, 1e-3, 1, 1e3, 1e6, 1e9, -1e-6, -1e-3, -1, -1e3, -1e6, -1e9},
          {},
          [shared](double value, std::uint32_t, std::uint64_t) -> Shape {
            const double diameter = diameter_of(*shared);
            if (!(diameter > 0)) return PointSet(*shared);
            const double factor = std::abs(value) / diameter, offset = value < 0 ? 1e8 : 0;
            std::vector<Point> moved = *shared;
            for (Point& p : moved) p = factor * p + Point::Constant(offset);
            return PointSet(std::move(moved));
          }};
}

std::vector<StressInput> inputs_of(const StressFamily& family, const SweepOptions& options) {
  if (!options.values.empty() && family.parameter.empty()) {
    throw Error(ErrorCode::InvalidArgument, family.name + " takes no values");
  }
  Values values = options.values.empty() ? family.values : options.values;
  if (options.large && options.values.empty()) {
    values.insert(values.end(), family.large_values.begin(), family.large_values.end());
  }
  std::vector<StressInput> inputs;
  for (const double value : values) {
    for (std::uint64_t k = 0; k < options.seeds; ++k) {
      const std::uint64_t seed = options.seed + k;
      const auto make = [make = family.make, value, points = options.points, seed] {
        return make(value, points, seed);
      };
      inputs.push_back({.family = family.name,
                        .parameter = family.parameter,
                        .value = value,
                        .seed = seed,
                        .faces = options.faces,
                        .make = make});
      if (!options.values.empty() && k == 0) (void)make();  // whether the family takes the value
    }
  }
  return inputs;
}

}  // namespace convexact
