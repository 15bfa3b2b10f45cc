// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "convexact/error.hpp"
#include "convexact/shapes.hpp"
#include "shapes/makers.hpp"

namespace convexact::shapes {
namespace {

using Values = std::span<const double>;
using Seed = std::uint64_t;
using Whole = std::uint32_t;

Whole whole(double value) { return static_cast<Whole>(value); }

Parameter count(double usual) { return {"points", "how many points", 1, 10e6, usual, true}; }
Parameter corners(double usual) { return {"k", "corners of the polygon", 3, 1e6, usual, true}; }
Parameter range(double usual, double most) {
  return {"range", "largest absolute coordinate, as an integer", 1, most, usual, true};
}
Parameter aspect(double usual) {
  return {"aspect", "length over thickness", 1, 1e300, usual, false};
}
Parameter side(std::string_view name) { return {name, "half the side", 1e-300, 1e300, 1, false}; }

void add_solids(std::vector<Family>& list) {
  list.push_back(
      {"tetrahedron", "regular, exact", 3, {}, [](Values, Seed) { return tetrahedron(); }});
  list.push_back({"cube", "regular, exact", 3, {}, [](Values, Seed) { return cube(); }});
  list.push_back(
      {"octahedron", "regular, exact", 3, {}, [](Values, Seed) { return octahedron(); }});
  list.push_back({"dodecahedron",
                  "regular up to 2^-25, with exactly plane pentagons",
                  3,
                  {},
                  [](Values, Seed) { return dodecahedron(); }});
  list.push_back({"rounded-dodecahedron",
                  "regular, in nearest doubles: pentagons not quite plane",
                  3,
                  {},
                  [](Values, Seed) { return rounded_dodecahedron(); }});
  list.push_back({"icosahedron", "regular, in nearest doubles", 3, {}, [](Values, Seed) {
                    return icosahedron();
                  }});
}

void add_prisms(std::vector<Family>& list) {
  list.push_back({"prism", "two k-gons and k rectangles", 3, {corners(6)}, [](Values v, Seed) {
                    return prism(whole(v[0]));
                  }});
  list.push_back(
      {"antiprism", "two k-gons, turned, and 2k triangles", 3, {corners(6)}, [](Values v, Seed) {
         return antiprism(whole(v[0]));
       }});
  list.push_back({"pyramid", "a k-gon and an apex", 3, {corners(6)}, [](Values v, Seed) {
                    return pyramid(whole(v[0]));
                  }});
  list.push_back({"bipyramid", "a k-gon between two apexes", 3, {corners(6)}, [](Values v, Seed) {
                    return bipyramid(whole(v[0]));
                  }});
  list.push_back({"cone",
                  "a pyramid of high valence, with points on its edges",
                  3,
                  {corners(500), {"rings", "copies of the k-gon", 1, 50, 2, true}},
                  [](Values v, Seed) { return cone(whole(v[0]), whole(v[1])); }});
  list.push_back({"cylinder",
                  "a prism of high valence, with points on its edges",
                  3,
                  {corners(1000), {"rings", "copies of the k-gon", 2, 1000, 3, true}},
                  [](Values v, Seed) { return cylinder(whole(v[0]), whole(v[1])); }});
}

void add_boxes(std::vector<Family>& list) {
  list.push_back(
      {"box", "sides 2a, 2b, 2c", 3, {side("a"), side("b"), side("c")}, [](Values v, Seed) {
         return box({v[0], v[1], v[2]});
       }});
  list.push_back({"chamfered-box",
                  "a cube with flat edges and corners",
                  3,
                  {{"width", "of the chamfer, half the side being 1", 0x1p-50, 0.999, 0.25, false}},
                  [](Values v, Seed) {
                    return chamfered_box({1, 1, 1}, v[0]);
                  }});
  list.push_back({"rounded-box",
                  "a box plus a ball, in a grid of steps per octant",
                  3,
                  {side("a"),
                   side("b"),
                   side("c"),
                   {"radius", "of the ball", 1e-300, 1e300, 0.25, false},
                   {"segments", "steps per octant", 1, 1000, 4, true}},
                  [](Values v, Seed) {
                    return rounded_box({v[0], v[1], v[2]}, v[3], whole(v[4]));
                  }});
  list.push_back({"cut-cube",
                  "a cube with equal cuts at some corners: exact ties",
                  3,
                  {{"corners", "how many are cut", 0, 8, 1, true},
                   {"depth", "of a cut, the side being 1", 0x1p-50, 0.5, 0.25, false}},
                  [](Values v, Seed) { return cut_cube(whole(v[0]), v[1]); }});
  list.push_back({"grid",
                  "all lattice points of a cube",
                  3,
                  {{"n", "points a side", 2, 200, 5, true}},
                  [](Values v, Seed) { return grid(whole(v[0])); }});
}

void add_random(std::vector<Family>& list) {
  list.push_back({"random-box", "uniform in a cube", 3, {count(100)}, [](Values v, Seed s) {
                    return in_box(whole(v[0]), s);
                  }});
  list.push_back({"random-ball", "uniform in a ball", 3, {count(100)}, [](Values v, Seed s) {
                    return in_ball(whole(v[0]), s);
                  }});
  list.push_back({"random-sphere",
                  "uniform on a sphere, up to rounding",
                  3,
                  {count(100)},
                  [](Values v, Seed s) { return on_sphere(whole(v[0]), s); }});
  list.push_back(
      {"lattice",
       "random lattice points: repeats and coplanar points",
       3,
       {count(30), range(3, 0x1p52)},
       [](Values v, Seed s) { return lattice(whole(v[0]), static_cast<std::uint64_t>(v[1]), s); }});
  list.push_back({"repeated-sphere",
                  "points of a sphere, each several times",
                  3,
                  {count(20), {"copies", "of each point", 1, 1000, 3, true}},
                  [](Values v, Seed s) { return repeated_sphere(whole(v[0]), whole(v[1]), s); }});
  list.push_back({"fibonacci-sphere",
                  "a spiral on a sphere: nearly equal costs",
                  3,
                  {count(100)},
                  [](Values v, Seed) { return fibonacci_sphere(whole(v[0])); }});
  list.push_back({"centrally-symmetric",
                  "random points and their opposites: ties in pairs",
                  3,
                  {count(20)},
                  [](Values v, Seed s) { return centrally_symmetric(whole(v[0]), s); }});
  list.push_back({"cube-symmetric",
                  "random points and their images in 48 symmetries: exact ties",
                  3,
                  {count(2), range(100, 0x1p52)},
                  [](Values v, Seed s) {
                    return cube_symmetric(whole(v[0]), static_cast<std::uint64_t>(v[1]), s);
                  }});
}

void add_integer(std::vector<Family>& list) {
  list.push_back({"cospherical",
                  "integer points on a sphere, exactly: many of them coplanar",
                  3,
                  {{"points", "how many at most", 4, 1e6, 24, true},
                   {"squared-radius", "x^2 + y^2 + z^2; some have no points", 1, 1e6, 41, true}},
                  [](Values v, Seed s) { return cospherical(whole(v[0]), whole(v[1]), s); }});
  list.push_back({"nearly-cospherical",
                  "integer points on a sphere, moved by a few ulps",
                  3,
                  {{"points", "how many at most", 4, 1e6, 24, true},
                   {"squared-radius", "x^2 + y^2 + z^2; some have no points", 1, 1e6, 41, true},
                   {"ulps", "how far a coordinate is moved at most", 0, 0x1p20, 1, true}},
                  [](Values v, Seed s) {
                    return nearly_cospherical(whole(v[0]), whole(v[1]), whole(v[2]), s);
                  }});
  list.push_back({"moment-curve",
                  "(t, t^2, t^3): a cyclic polytope, n vertices and 2n - 4 triangles",
                  3,
                  {{"points", "how many", 4, 1e5, 12, true}},
                  [](Values v, Seed) { return moment_curve(whole(v[0])); }});
}

void add_extreme(std::vector<Family>& list) {
  list.push_back({"needle",
                  "a ball, thin in two directions",
                  3,
                  {count(50), aspect(1e8)},
                  [](Values v, Seed s) { return needle(whole(v[0]), v[1], s); }});
  list.push_back(
      {"slab", "a ball, thin in one direction", 3, {count(50), aspect(1e8)}, [](Values v, Seed s) {
         return slab(whole(v[0]), v[1], s);
       }});
  list.push_back({"offset-ball",
                  "a ball far from the origin",
                  3,
                  {count(50), {"distance", "added to each coordinate", -1e15, 1e15, 1e8, false}},
                  [](Values v, Seed s) { return offset_ball(whole(v[0]), v[1], s); }});
  list.push_back(
      {"scaled-ball",
       "a ball times a power of two",
       3,
       {count(50), {"exponent", "of two", -1000, 1000, 300, true}},
       [](Values v, Seed s) { return scaled_ball(whole(v[0]), static_cast<int>(v[1]), s); }});
  list.push_back({"subnormal",
                  "lattice points times 2^-1074",
                  3,
                  {count(30), range(100, 0x1p52 - 1)},
                  [](Values v, Seed s) {
                    return subnormal(whole(v[0]), static_cast<std::uint64_t>(v[1]), s);
                  }});
  list.push_back({"huge", "coordinates up to 1e300", 3, {count(50)}, [](Values v, Seed s) {
                    return huge(whole(v[0]), s);
                  }});
  list.push_back({"wide-exponents",
                  "each coordinate with its own power of two",
                  3,
                  {count(50), {"exponent", "largest power", 0, 1000, 300, true}},
                  [](Values v, Seed s) { return wide_exponents(whole(v[0]), whole(v[1]), s); }});
  list.push_back({"nearly-flat",
                  "a plane, every second point a few ulps above it",
                  3,
                  {count(30), {"ulps", "how many, of 2^-52", 1, 0x1p52 - 1, 1, true}},
                  [](Values v, Seed s) {
                    return nearly_flat(whole(v[0]), s, static_cast<std::uint64_t>(v[1]));
                  }});
  list.push_back({"nearly-coplanar",
                  "a lid of points within one rounding of a plane",
                  3,
                  {count(30)},
                  [](Values v, Seed s) { return nearly_coplanar(whole(v[0]), s); }});
  list.push_back({"tilted-lid",
                  "a box under planes that are hardly tilted",
                  3,
                  {count(30), {"tilt", "of the planes", 0x1p-52, 1, 0x1p-20, false}},
                  [](Values v, Seed s) { return tilted_lid(whole(v[0]), v[1], s); }});
  list.push_back({"mixed-scales",
                  "balls of radius 1, 2^-e and 2^-2e in one hull",
                  3,
                  {count(20), {"exponent", "e", 0, 500, 100, true}},
                  [](Values v, Seed s) { return mixed_scales(whole(v[0]), whole(v[1]), s); }});
}

void add_mixture(std::vector<Family>& list) {
  list.push_back({"mixture",
                  "random families, squeezed, moved and put together",
                  3,
                  {{"parts", "how many", 1, 64, 3, true}},
                  [](Values v, Seed s) { return mixture(whole(v[0]), s); }});
}

void add_flat(std::vector<Family>& list) {
  list.push_back({"all-equal", "copies of one point", 0, {count(5)}, [](Values v, Seed) {
                    return all_equal(whole(v[0]));
                  }});
  list.push_back({"collinear", "points of a line, exactly", 1, {count(20)}, [](Values v, Seed s) {
                    return collinear(whole(v[0]), s);
                  }});
  list.push_back({"coplanar", "points of a plane, exactly", 2, {count(30)}, [](Values v, Seed s) {
                    return coplanar(whole(v[0]), s);
                  }});
}

std::vector<Family> make_families() {
  std::vector<Family> list;
  add_solids(list);
  add_prisms(list);
  add_boxes(list);
  add_random(list);
  add_integer(list);
  add_extreme(list);
  add_mixture(list);
  add_flat(list);
  return list;
}

[[noreturn]] void reject(const std::string& message) {
  throw Error(ErrorCode::InvalidArgument, message);
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
  if (found == all.end()) reject("there is no family of shapes called '" + std::string(name) + "'");
  return *found;
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
    reject(name + " takes " + std::to_string(family.parameters.size()) + " parameters");
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Parameter& p = family.parameters[i];
    const bool inside = values[i] >= p.least && values[i] <= p.most;  // false for NaN
    if (!inside || (p.whole && values[i] != std::floor(values[i]))) {
      reject(fmt::format("{}: {} is {}{} to {}, not {}", name, p.name,
                         p.whole ? "an integer from " : "a number from ", p.least, p.most,
                         values[i]));
    }
  }
  return family.make(values, seed);
}

}  // namespace convexact::shapes
