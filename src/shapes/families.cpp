// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include "convexact/error.hpp"
#include "convexact/shapes.hpp"
#include "number/random.hpp"
#include "shapes/makers.hpp"

namespace convexact::shapes {
namespace {

using Seed = std::uint64_t;

// Calls the maker with the values in order, each converted to the type that it takes, and with the
// seed if it takes one argument more.
template <class... Arguments, std::size_t... K>
std::vector<Point> call(std::vector<Point> (*maker)(Arguments...),
                        [[maybe_unused]] std::span<const double> values, [[maybe_unused]] Seed seed,
                        std::index_sequence<K...>) {
  return maker(
      (K < values.size() ? static_cast<Arguments>(values[K]) : static_cast<Arguments>(seed))...);
}

template <class... Arguments>
Family entry(std::string_view name, std::string_view description, int dimension,
             std::vector<Parameter> parameters, std::vector<Point> (*maker)(Arguments...)) {
  const auto make = [maker](std::span<const double> values, Seed seed) {
    return call(maker, values, seed, std::index_sequence_for<Arguments...>());
  };
  return {name, description, dimension, std::move(parameters), make};
}

Parameter count(double usual) { return {"points", "how many points", 1, 10e6, usual, true}; }
Parameter corners(double usual) { return {"k", "corners of the polygon", 3, 1e6, usual, true}; }
Parameter range(double usual, double most) {
  return {"range", "largest absolute coordinate, as an integer", 1, most, usual, true};
}
Parameter aspect(double usual) {
  return {"aspect", "length over thickness", 1, 1e300, usual, false};
}
Parameter most_points() { return {"points", "how many at most", 4, 1e6, 24, true}; }
Parameter squared_radius() {
  return {"squared-radius", "x^2 + y^2 + z^2; some have no points", 1, 1e6, 41, true};
}
Parameter side(std::string_view name) { return {name, "half the side", 1e-300, 1e300, 1, false}; }

// Makers that take other arguments than a family's values.

std::vector<Point> box_of_sides(double a, double b, double c) { return box({a, b, c}); }
std::vector<Point> chamfered_cube(double width) { return chamfered_box({1, 1, 1}, width); }
std::vector<Point> rounded_box_of_sides(double a, double b, double c, double radius,
                                        std::uint32_t segments) {
  return rounded_box({a, b, c}, radius, segments);
}
std::vector<Point> every_second_above(std::uint32_t n, std::uint64_t ulps, Seed seed) {
  return nearly_flat(n, seed, ulps);
}

std::vector<Family> regular_solids() {
  return {entry("tetrahedron", "regular, exact", 3, {}, tetrahedron),
          entry("cube", "regular, exact", 3, {}, cube),
          entry("octahedron", "regular, exact", 3, {}, octahedron),
          entry("dodecahedron", "regular up to 2^-25, with exactly plane pentagons", 3, {},
                dodecahedron),
          entry("rounded-dodecahedron", "regular, in nearest doubles: pentagons not quite plane", 3,
                {}, rounded_dodecahedron),
          entry("icosahedron", "regular, in nearest doubles", 3, {}, icosahedron)};
}

std::vector<Family> prisms() {
  return {entry("prism", "two k-gons and k rectangles", 3, {corners(6)}, prism),
          entry("antiprism", "two k-gons, turned, and 2k triangles", 3, {corners(6)}, antiprism),
          entry("pyramid", "a k-gon and an apex", 3, {corners(6)}, pyramid),
          entry("bipyramid", "a k-gon between two apexes", 3, {corners(6)}, bipyramid),
          entry("cone", "a pyramid of high valence, with points on its edges", 3,
                {corners(500), {"rings", "copies of the k-gon", 1, 50, 2, true}}, cone),
          entry("cylinder", "a prism of high valence, with points on its edges", 3,
                {corners(1000), {"rings", "copies of the k-gon", 2, 1000, 3, true}}, cylinder)};
}

std::vector<Family> boxes() {
  return {entry("box", "sides 2a, 2b, 2c", 3, {side("a"), side("b"), side("c")}, box_of_sides),
          entry("chamfered-box", "a cube with flat edges and corners", 3,
                {{"width", "of the chamfer, half the side being 1", 0x1p-50, 0.999, 0.25, false}},
                chamfered_cube),
          entry("rounded-box", "a box plus a ball, in a grid of steps per octant", 3,
                {side("a"),
                 side("b"),
                 side("c"),
                 {"radius", "of the ball", 1e-300, 1e300, 0.25, false},
                 {"segments", "steps per octant", 1, 1000, 4, true}},
                rounded_box_of_sides),
          entry("cut-cube", "a cube with equal cuts at some corners: exact ties", 3,
                {{"corners", "how many are cut", 0, 8, 1, true},
                 {"depth", "of a cut, the side being 1", 0x1p-50, 0.5, 0.25, false}},
                cut_cube),
          entry("grid", "all lattice points of a cube", 3,
                {{"n", "points a side", 2, 200, 5, true}}, grid)};
}

std::vector<Family> random_points() {
  return {entry("random-box", "uniform in a cube", 3, {count(100)}, in_box),
          entry("random-ball", "uniform in a ball", 3, {count(100)}, in_ball),
          entry("random-sphere", "uniform on a sphere, up to rounding", 3, {count(100)}, on_sphere),
          entry("lattice", "random lattice points: repeats and coplanar points", 3,
                {count(30), range(3, 0x1p52)}, lattice),
          entry("repeated-sphere", "points of a sphere, each several times", 3,
                {count(20), {"copies", "of each point", 1, 1000, 3, true}}, repeated_sphere),
          entry("fibonacci-sphere", "a spiral on a sphere: nearly equal costs", 3, {count(100)},
                fibonacci_sphere),
          entry("centrally-symmetric", "random points and their opposites: ties in pairs", 3,
                {count(20)}, centrally_symmetric),
          entry("cube-symmetric", "random points and their images in 48 symmetries: exact ties", 3,
                {count(2), range(100, 0x1p52)}, cube_symmetric)};
}

std::vector<Family> integer_points() {
  return {entry("cospherical", "integer points on a sphere, exactly: many of them coplanar", 3,
                {most_points(), squared_radius()}, cospherical),
          entry("nearly-cospherical", "integer points on a sphere, moved by a few ulps", 3,
                {most_points(),
                 squared_radius(),
                 {"ulps", "how far a coordinate is moved at most", 0, 0x1p20, 1, true}},
                nearly_cospherical),
          entry("moment-curve", "(t, t^2, t^3): a cyclic polytope, n vertices and 2n - 4 triangles",
                3, {{"points", "how many", 4, 1e5, 12, true}}, moment_curve)};
}

std::vector<Family> extreme_shapes() {
  return {entry("needle", "a ball, thin in two directions", 3, {count(50), aspect(1e8)}, needle),
          entry("slab", "a ball, thin in one direction", 3, {count(50), aspect(1e8)}, slab),
          entry("offset-ball", "a ball far from the origin", 3,
                {count(50), {"distance", "added to each coordinate", -1e15, 1e15, 1e8, false}},
                offset_ball),
          entry("scaled-ball", "a ball times a power of two", 3,
                {count(50), {"exponent", "of two", -1000, 1000, 300, true}}, scaled_ball),
          entry("subnormal", "lattice points times 2^-1074", 3, {count(30), range(100, 0x1p52 - 1)},
                subnormal),
          entry("huge", "coordinates up to 1e300", 3, {count(50)}, huge),
          entry("wide-exponents", "each coordinate with its own power of two", 3,
                {count(50), {"exponent", "largest power", 0, 1000, 300, true}}, wide_exponents),
          entry("nearly-flat", "a plane, every second point a few ulps above it", 3,
                {count(30), {"ulps", "how many, of 2^-52", 1, 0x1p52 - 1, 1, true}},
                every_second_above),
          entry("nearly-coplanar", "a lid of points within one rounding of a plane", 3, {count(30)},
                nearly_coplanar),
          entry("tilted-lid", "a box under planes that are hardly tilted", 3,
                {count(30), {"tilt", "of the planes", 0x1p-52, 1, 0x1p-20, false}}, tilted_lid),
          entry("mixed-scales", "balls of radius 1, 2^-e and 2^-2e in one hull", 3,
                {count(20), {"exponent", "e", 0, 500, 100, true}}, mixed_scales),
          entry("mixture", "random families, squeezed, moved and put together", 3,
                {{"parts", "how many", 1, 64, 3, true}}, mixture)};
}

std::vector<Family> flat_shapes() {
  return {entry("all-equal", "copies of one point", 0, {count(5)}, all_equal),
          entry("collinear", "points of a line, exactly", 1, {count(20)}, collinear),
          entry("coplanar", "points of a plane, exactly", 2, {count(30)}, coplanar)};
}

std::vector<Family> make_families() {
  std::vector<Family> list;
  for (const auto& group : {regular_solids(), prisms(), boxes(), random_points(), integer_points(),
                            extreme_shapes(), flat_shapes()}) {
    list.insert(list.end(), group.begin(), group.end());
  }
  return list;
}

}  // namespace

std::span<const Family> families() {
  static const std::vector<Family> list = make_families();
  return list;
}

const Family& family(std::string_view name) {
  const auto all = families();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Family& f) { return f.name == name; });
  if (found == all.end())
    reject_argument("there is no family of shapes called '" + std::string(name) + "'");
  return *found;
}

namespace {

// Parameters that say how many points there are: a few times the usual number at most.
bool is_count(const Parameter& p) {
  constexpr std::array<std::string_view, 8> kCounts = {"points",   "k", "rings",   "copies",
                                                       "segments", "n", "corners", "parts"};
  return std::find(kCounts.begin(), kCounts.end(), p.name) != kCounts.end();
}

// A size of any order of magnitude between two positive numbers: exponents are equally likely.
double any_magnitude(double least, double most, Random& random) {
  const int low = std::ilogb(least), high = std::ilogb(most);
  const auto exponents = static_cast<std::uint64_t>(high - low) + 1;
  const int exponent = low + static_cast<int>(uniform_below(random, exponents));
  return std::clamp(std::ldexp(1 + uniform_unit(random), exponent), least, most);
}

// Often the usual value or an end of the range, where programs break.
double any_value(const Parameter& p, Random& random) {
  constexpr double kTimesUsual = 4;
  const double most = is_count(p) ? std::min(p.most, kTimesUsual * p.usual) : p.most;
  const std::uint64_t kind = uniform_below(random, 8);
  if (kind == 0) return p.usual;
  if (kind == 1) return p.least;
  if (kind == 2 && !is_count(p)) return p.most;
  double value = 0;
  if (p.least > 0) {
    value = any_magnitude(p.least, most, random);
  } else if (p.least == 0) {
    value = any_magnitude(p.whole ? 1 : 0x1p-60, most, random);
  } else {
    value = any_magnitude(p.whole ? 1 : 0x1p-60, most, random);
    if (uniform_below(random, 2) == 0) value = std::max(-value, p.least);
  }
  return p.whole ? std::floor(value) : value;
}

}  // namespace

AnyFamily any_family(std::uint64_t seed) {
  Random random(seed);
  for (;;) {
    const Family& family = families()[uniform_below(random, families().size())];
    std::vector<double> values;
    for (const Parameter& p : family.parameters) values.push_back(any_value(p, random));
    try {
      (void)family.make(values, seed);
      return {&family, std::move(values)};
    } catch (const Error&) {  // some values do not go together
    }
  }
}

std::vector<double> usual_values(const Family& family) {
  std::vector<double> values;
  for (const Parameter& p : family.parameters) values.push_back(p.usual);
  return values;
}

std::vector<Point> generate(const Family& family, std::span<const double> values,
                            std::uint64_t seed) {
  const std::string name(family.name);
  if (values.size() != family.parameters.size()) {
    reject_argument(name + " takes " + std::to_string(family.parameters.size()) + " parameters");
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Parameter& p = family.parameters[i];
    const bool inside = values[i] >= p.least && values[i] <= p.most;  // false for NaN
    if (!inside || (p.whole && values[i] != std::floor(values[i]))) {
      reject_argument(fmt::format("{}: {} is {}{} to {}, not {}", name, p.name,
                                  p.whole ? "an integer from " : "a number from ", p.least, p.most,
                                  values[i]));
    }
  }
  return family.make(values, seed);
}

}  // namespace convexact::shapes
