// SPDX-License-Identifier: MIT
#include "hard_inputs.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "perturb.hpp"
#include "shapes/makers.hpp"

namespace hard {
namespace {

using namespace convexact;
using namespace perturb;
using std::uint32_t;

Points lattice(uint32_t i) { return shapes::lattice(6 + i % 19, 1 + i / 19 % 5, i); }

// A random part of {0, .., n-1}^3, n = 3 or 4, from sparse to nearly all.
Points grid_part(uint32_t i) {
  Random random(i);
  Points points;
  const double density = 0.3 + 0.6 * uniform_unit(random);
  for (const Point& p : shapes::grid(3 + i % 2)) {
    if (uniform_unit(random) < density) points.push_back(p);
  }
  return points;
}

// Lattice solids tie often; an ulp more or less turns these ties into near-ties and near-coplanar
// facets.
Points nudged_lattice(uint32_t i) { return nudged(lattice(i), i); }
Points nudged_grid(uint32_t i) { return nudged(grid_part(i), i); }

// A k-gon of radius 1 and another one of half or a tenth of that above.
Points frustum(uint32_t k, double upper) {
  Points points;
  for (uint32_t c = 0; c < k; ++c) {
    const shapes::CirclePoint p = shapes::on_circle(c, k);
    points.emplace_back(p.cosine, p.sine, 0);
    points.emplace_back(upper * p.cosine, upper * p.sine, 1);
  }
  return points;
}

Points over_polygon(uint32_t i) {
  const uint32_t k = 3 + i / 8 % 22;
  switch (i % 8) {
    case 0:
      return shapes::prism(k);
    case 1:
      return shapes::antiprism(k);
    case 2:
      return shapes::pyramid(k);
    case 3:
      return shapes::bipyramid(k);
    case 4:
      return frustum(k, 0.5);
    case 5:
      return frustum(k, 0.1);
    case 6:
      return shapes::cylinder(k, 3);
    default:
      return shapes::cone(k, 3);
  }
}
Points nudged_over_polygon(uint32_t i) { return nudged(over_polygon(i), i); }
Points turned_over_polygon(uint32_t i) { return turned(over_polygon(i)); }

Points box(uint32_t i) {
  const double width = std::ldexp(1 + i % 7, -4);
  const Point half(1, 1 + i % 3, 1 + i / 3 % 3);
  switch (i % 4) {
    case 0:
      return shapes::rounded_box(half, width, 1 + i / 4 % 3);
    case 1:
      return shapes::chamfered_box(half, width);
    case 2:
      return shapes::cut_cube(i / 4 % 9, width);
    default:
      return shapes::rounded_box(half, 0.1 * (1 + i % 9), 1 + i / 4 % 3);
  }
}
Points nudged_box(uint32_t i) { return nudged(box(i), i); }

// Planes that differ by 2^-1074: vertices and volumes beyond the range of doubles.
Points barely_nudged(uint32_t i) {
  return nudged(i % 2 == 0 ? shapes::grid(2 + i / 2 % 2) : box(i % 12), i, 0x1p-1074);
}

Points symmetric(uint32_t i) {
  const uint32_t n = 4 + i / 4 % 8;
  switch (i % 4) {
    case 0:
      return shapes::centrally_symmetric(n, i);
    case 1:
      return with_opposites(shapes::lattice(n, 1 + i % 6, i));
    case 2:
      return with_opposites(nudged(shapes::lattice(n, 2, i), i));
    default:
      return i % 40 == 3 ? shapes::cube_symmetric(1, 3, i)
                         : with_opposites(shapes::on_sphere(n, i));
  }
}

Points needle(uint32_t i) {
  const double aspect = std::pow(10.0, 3 + i / 4 % 13);  // 1e3 to 1e15
  const uint32_t n = 8 + i % 16;
  switch (i % 4) {
    case 0:
      return shapes::needle(n, aspect, i);
    case 1:
      return turned(shapes::needle(n, aspect, i));
    case 2:
      return shapes::slab(n, aspect, i);
    default:
      return turned(shapes::slab(n, aspect, i));
  }
}

// Shapes with the stated aspect and with ties: lattice solids squeezed by powers of two are exact.
Points squeezed(uint32_t i) {
  const int thin = -40 - static_cast<int>(i % 3);
  const Points points = i % 2 == 0 ? lattice(i) : over_polygon(i);
  switch (i / 2 % 4) {
    case 0:
      return stretched(points, {0, thin, thin});
    case 1:
      return turned(stretched(points, {0, thin, thin}));
    case 2:
      return stretched(points, {0, 0, thin});
    default:
      return turned(stretched(points, {0, 0, thin}));
  }
}

Points far_away(uint32_t i) {
  switch (i % 4) {
    case 0:
      return shapes::offset_ball(8 + i % 16, 1e8, i);
    case 1:
      return shifted(lattice(i), {1e8, -1e8, 1e8});
    case 2:
      return shifted(over_polygon(i), {1e8, 1e8, 1e8});
    default:
      return shifted(turned(shapes::in_ball(8 + i % 16, i)), {1e8, 0, -3e8});
  }
}

Points scaled(uint32_t i) {
  const int e = i % 2 == 0 ? 300 : -300;
  switch (i / 2 % 6) {
    case 0:
      return stretched(lattice(i), {e, e, e});
    case 1:
      return stretched(over_polygon(i), {e, e, e});
    case 2:
      return stretched(shapes::in_ball(8 + i % 16, i), {e, e, e});
    case 3:
      return stretched(lattice(i), {e, -e, 0});
    case 4:
      return stretched(nudged_lattice(i), {e, 0, e});
    default:
      return shapes::scaled_ball(8 + i % 16, e, i);
  }
}

Points mixed_exponents(uint32_t i) {
  const uint32_t n = 8 + i % 9;
  switch (i % 5) {
    case 0:
      return shapes::wide_exponents(n, 10, i);
    case 1:
      return shapes::wide_exponents(n, 40, i);
    case 2:
      return shapes::wide_exponents(n, 300, i);
    case 3:
      return shapes::subnormal(n, 1 + i % 9, i);
    default:
      return shapes::huge(n, i);
  }
}

// All integer points of the sphere x^2 + y^2 + z^2 = n, or a random part of them: facets with many
// corners, exact ties.
Points integer_sphere(uint32_t i) {
  constexpr std::array<int, 8> kSquares{9, 17, 26, 29, 41, 50, 54, 89};
  const int square = kSquares[i % kSquares.size()];
  const double density = i < kSquares.size() ? 1 : 0.2 + 0.05 * (i % 7);
  Random random(i);
  Points points;
  for (int x = -9; x <= 9; ++x) {
    for (int y = -9; y <= 9; ++y) {
      for (int z = -9; z <= 9; ++z) {
        if (x * x + y * y + z * z != square) continue;
        if (uniform_unit(random) < density) points.emplace_back(x, y, z);
      }
    }
  }
  return points;
}

Points sphere(uint32_t i) {
  switch (i % 4) {
    case 0:
      return shapes::on_sphere(8 + i % 24, i);
    case 1:
      return shapes::fibonacci_sphere(5 + i / 4 % 50);
    case 2:
      return nudged(integer_sphere(i), i);
    default:
      return shifted(shapes::fibonacci_sphere(5 + i / 4 % 50), {1, 2, 4});
  }
}

Points repeated(uint32_t i) {
  const Points points = i % 3 == 0 ? over_polygon(i) : i % 3 == 1 ? lattice(i) : box(i);
  return with_repeats(points, points.size(), i);
}

Points near_a_plane(uint32_t i) {
  switch (i % 5) {
    case 0:
      return shapes::nearly_flat(6 + i % 20, i);
    case 1:
      return shapes::nearly_coplanar(6 + i % 20, i);
    case 2:
      return with_points_near_planes(shapes::lattice(8, 2, i), 12, i);
    case 3:
      return with_points_near_planes(shapes::in_ball(8, i), 12, i);
    default:
      return with_points_near_planes(over_polygon(i % 64), 8, i);
  }
}

// The most regular solids, up to rounding; after nudging, their costs differ by an ulp or two.
Points regular(uint32_t i) {
  const auto solid = [&] {
    switch (i % 6) {
      case 0:
        return shapes::tetrahedron();
      case 1:
        return shapes::cube();
      case 2:
        return shapes::octahedron();
      case 3:
        return shapes::dodecahedron();
      case 4:
        return shapes::rounded_dodecahedron();
      default:
        return shapes::icosahedron();
    }
  };
  const Points points = solid();
  switch (i / 6 % 4) {
    case 0:
      return points;
    case 1:
      return nudged(points, i);
    case 2:
      return turned(nudged(points, i));
    default:
      return with_points_near_planes(points, 6, i);
  }
}

// Rings of 500 and the facets between them. An odd valence too: no two edges parallel.
Points high_valence(uint32_t i) {
  switch (i) {
    case 0:
      return shapes::pyramid(500);
    case 1:
      return shapes::cone(500, 3);
    case 2:
      return nudged(shapes::pyramid(500), 1);
    case 3:
      return stretched(shapes::pyramid(499), {0, 0, -40});
    default:
      return shifted(shapes::pyramid(500), {1e8, 1e8, 1e8});
  }
}

constexpr Inputs kInputs[] = {
    {"lattice", 570, lattice},
    {"grid part", 200, grid_part},
    {"nudged lattice", 285, nudged_lattice},
    {"nudged grid", 120, nudged_grid},
    {"over a polygon", 176, over_polygon},
    {"nudged over a polygon", 176, nudged_over_polygon},
    {"turned over a polygon", 176, turned_over_polygon},
    {"box", 108, box},
    {"nudged box", 108, nudged_box},
    {"barely nudged", 40, barely_nudged},
    {"symmetric", 240, symmetric},
    {"needle", 208, needle},
    {"squeezed", 240, squeezed},
    {"far away", 200, far_away},
    {"scaled", 240, scaled},
    {"mixed exponents", 100, mixed_exponents},
    {"integer sphere", 80, integer_sphere},
    {"sphere", 160, sphere},
    {"repeated", 90, repeated},
    {"near a plane", 250, near_a_plane},
    {"regular", 120, regular},
    {"high valence", 5, high_valence},
};

}  // namespace

std::span<const Inputs> inputs() { return kInputs; }

const Inputs& named(std::string_view name) {
  for (const Inputs& kind : kInputs) {
    if (kind.name == name) return kind;
  }
  throw std::out_of_range("no hard inputs are called '" + std::string(name) + "'");
}

std::uint32_t stride() {
  const char* text = std::getenv("CONVEXACT_STRIDE");
  return text == nullptr ? 1 : static_cast<std::uint32_t>(std::stoul(text));
}

}  // namespace hard
