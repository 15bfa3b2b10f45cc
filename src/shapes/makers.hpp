// SPDX-License-Identifier: MIT
// makers.hpp - the functions that make the families of shapes.
#pragma once
#include <cstdint>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/geometry.hpp"

namespace convexact::shapes {

/// @throws Error InvalidArgument if a parameter is not `allowed`.
inline void require_parameter(bool allowed, const char* rule) {
  if (!allowed) throw Error(ErrorCode::InvalidArgument, rule);
}

// The five regular solids.

/// Edges sqrt(8); exactly regular. 4 vertices, 4 facets.
[[nodiscard]] std::vector<Point> tetrahedron();
/// [-1, 1]^3; exactly regular. 8 vertices, 6 facets.
[[nodiscard]] std::vector<Point> cube();
/// Edges sqrt(2); exactly regular. 6 vertices, 8 facets.
[[nodiscard]] std::vector<Point> octahedron();
/// In doubles, so regular up to 2^-25, but its pentagons are exactly plane and it has exactly the
/// symmetries of a pyritohedron (sign changes and cyclic shifts). 20 vertices, 12 facets.
[[nodiscard]] std::vector<Point> dodecahedron();
/// The nearest doubles to a regular dodecahedron: 20 vertices whose pentagons are not quite plane,
/// so they break into triangles that one ulp decides.
[[nodiscard]] std::vector<Point> rounded_dodecahedron();
/// The nearest doubles to a regular icosahedron with edges 2, exactly symmetric under sign changes
/// and cyclic shifts. 12 vertices, 20 facets.
[[nodiscard]] std::vector<Point> icosahedron();

// Boxes: whole, with cut corners, with flat and with round edges.

/// [-a, a] x [-b, b] x [-c, c] for half = (a, b, c) > 0. 8 vertices, 6 facets.
[[nodiscard]] std::vector<Point> box(const Point& half);

/// box(half) with every edge and corner cut off, 0 < width < half: 6 rectangles, 12 rectangles at
/// 45 degrees along the edges, 8 triangles. 24 vertices, 26 facets, exactly plane if half - width
/// is exact.
[[nodiscard]] std::vector<Point> chamfered_box(const Point& half, double width);

/// The sum of box(half) and a ball of `radius` > 0 of which each octant is a grid of `segments` >=
/// 1 steps: 8 (segments (segments + 1) + 1) points, all extreme. The 6 sides and the 12 * segments
/// rectangles along edges are exactly plane; the cells of the corners are plane up to rounding.
[[nodiscard]] std::vector<Point> rounded_box(const Point& half, double radius,
                                             std::uint32_t segments);

/// [0, 1]^3 with `corners` <= 8 of its corners cut off by planes through the points at distance
/// 0 < `depth` <= 1/2 along the three edges: equal cuts, so exact ties if depth and 1 - depth are
/// exact. 8 + 2 * corners points (repeats at depth 1/2), 6 + corners facets.
[[nodiscard]] std::vector<Point> cut_cube(std::uint32_t corners, double depth);

/// The lattice points {0, ..., n-1}^3, n >= 2: most lie inside facets and edges of a cube.
[[nodiscard]] std::vector<Point> grid(std::uint32_t n);

// Solids over a k-gon, k >= 3, inscribed in the unit circle of the xy-plane.

// The polygon's corners are on_circle(i, k): regular up to rounding, with exact mirror images.

/// z from -1/2 to 1/2; all facets exactly plane. 2k vertices, k + 2 facets.
[[nodiscard]] std::vector<Point> prism(std::uint32_t k);
/// The upper k-gon turned by half a side; both k-gons exactly plane. 2k vertices, 2k + 2 facets.
[[nodiscard]] std::vector<Point> antiprism(std::uint32_t k);
/// Apex (0, 0, 1); the base exactly plane. k + 1 vertices, k + 1 facets.
[[nodiscard]] std::vector<Point> pyramid(std::uint32_t k);
/// Apexes (0, 0, +-1). k + 2 vertices, 2k facets.
[[nodiscard]] std::vector<Point> bipyramid(std::uint32_t k);
/// The prism's hull from `rings` >= 2 copies of the k-gon: rings * k points of which those of the
/// inner rings lie exactly on edges. 2k vertices, k + 2 facets.
[[nodiscard]] std::vector<Point> cylinder(std::uint32_t k, std::uint32_t rings);
/// The pyramid's hull from 1 <= `rings` <= 50 copies of the k-gon, each half as large as the one
/// below and exactly on the edges to the apex. rings * k + 1 points, k + 1 vertices, k + 1 facets.
[[nodiscard]] std::vector<Point> cone(std::uint32_t k, std::uint32_t rings);

// Points of a circle as doubles that are the same on every platform.

struct CirclePoint {
  double cosine;
  double sine;
};

/// Cosine and sine of the angle 2 pi k / n, each rounded to a nearest double from 128 bits. They
/// come from MPFR, not from the C library, whose last bits differ between platforms, and from one
/// octant: mirrored angles have exactly mirrored points, and the axes and diagonals are met
/// exactly. Precondition: n >= 1 and k, n < 2^61.
[[nodiscard]] CirclePoint on_circle(std::uint64_t k, std::uint64_t n);

// Seeded points in and on simple solids; the same doubles on every platform.

// Only +, -, *, / and sqrt of doubles are used, which IEEE 754 rounds correctly, or MPFR.

/// n points uniform in [-1, 1)^3, coordinates multiples of 2^-52.
[[nodiscard]] std::vector<Point> in_box(std::uint32_t n, std::uint64_t seed);
/// n points uniform in the unit ball.
[[nodiscard]] std::vector<Point> in_ball(std::uint32_t n, std::uint64_t seed);
/// n points uniform on the unit sphere, up to rounding.
[[nodiscard]] std::vector<Point> on_sphere(std::uint32_t n, std::uint64_t seed);
/// n points of on_sphere(), each `copies` >= 1 times, in random order: exact duplicates.
[[nodiscard]] std::vector<Point> repeated_sphere(std::uint32_t n, std::uint32_t copies,
                                                 std::uint64_t seed);
/// n points uniform in {-range, ..., range}^3: repeats, coplanar and collinear points.
/// Precondition: range <= 2^52.
[[nodiscard]] std::vector<Point> lattice(std::uint32_t n, std::uint64_t range, std::uint64_t seed);
/// n points on the unit sphere along a spiral of golden angles: all costs nearly equal.
/// @par Source  [Gonzalez2010]
[[nodiscard]] std::vector<Point> fibonacci_sphere(std::uint32_t n);

/// n points of in_box() and their images under x -> -x: exact ties in pairs. 2n points.
[[nodiscard]] std::vector<Point> centrally_symmetric(std::uint32_t n, std::uint64_t seed);
/// n points of lattice(range) and their images under all 48 symmetries of the cube: exact ties of
/// up to 48. 48 n points, repeats where a point lies on a mirror.
[[nodiscard]] std::vector<Point> cube_symmetric(std::uint32_t n, std::uint64_t range,
                                                std::uint64_t seed);

// Integer points in exactly special positions: on a sphere, on the moment curve.

/// At most n of the integer points with x^2 + y^2 + z^2 = `squared_radius` <= 10^6, drawn without
/// repeats: exactly cospherical, so all of them are extreme, and many are coplanar.
/// @throws Error InvalidArgument if fewer than 4 such points exist; there are none for
///         4^a (8 b + 7), by Legendre's theorem.
[[nodiscard]] std::vector<Point> cospherical(std::uint32_t n, std::uint32_t squared_radius,
                                             std::uint64_t seed);

/// The points (t, t^2, t^3) for 4 <= n <= 10^5 consecutive integers t around 0: no four coplanar.
/// The hull is the cyclic polytope: n vertices, 2n - 4 triangles, of which n - 1 meet in each of
/// the first and the last point.
/// @par Source  [Ziegler1995, sec. 0]
[[nodiscard]] std::vector<Point> moment_curve(std::uint32_t n);

// Points that span no volume, exactly, in no special position.

/// n copies of one point: affine dimension 0.
[[nodiscard]] std::vector<Point> all_equal(std::uint32_t n);
/// n points of a line that no coordinate plane is parallel to, repeats possible. The first two
/// differ, so that n >= 2 have affine dimension 1.
[[nodiscard]] std::vector<Point> collinear(std::uint32_t n, std::uint64_t seed);
/// n points of a plane that no axis is parallel to, repeats possible. The first three are not
/// collinear, so that n >= 3 have affine dimension 2.
[[nodiscard]] std::vector<Point> coplanar(std::uint32_t n, std::uint64_t seed);

// Stiff inputs: needles, slabs, far offsets, the ends of the exponent range, one ulp.

/// n points of in_ball() with y and z divided by `aspect` >= 1.
[[nodiscard]] std::vector<Point> needle(std::uint32_t n, double aspect, std::uint64_t seed);
/// n points of in_ball() with z divided by `aspect` >= 1.
[[nodiscard]] std::vector<Point> slab(std::uint32_t n, double aspect, std::uint64_t seed);
/// n points of in_ball() with `distance` added to each coordinate, so that few of their bits are
/// left.
[[nodiscard]] std::vector<Point> offset_ball(std::uint32_t n, double distance, std::uint64_t seed);
/// n points of in_ball() times 2^exponent; exact while nothing leaves the range of normal doubles.
[[nodiscard]] std::vector<Point> scaled_ball(std::uint32_t n, int exponent, std::uint64_t seed);
/// n points of lattice(range) times 2^-1074: every coordinate is subnormal.
/// Precondition: range < 2^52.
[[nodiscard]] std::vector<Point> subnormal(std::uint32_t n, std::uint64_t range,
                                           std::uint64_t seed);
/// n points of in_box() times 1e300: squares overflow.
[[nodiscard]] std::vector<Point> huge(std::uint32_t n, std::uint64_t seed);
/// n points of in_box(), each coordinate times a separate power of two from 2^-exponent to
/// 2^exponent.
[[nodiscard]] std::vector<Point> wide_exponents(std::uint32_t n, std::uint32_t exponent,
                                                std::uint64_t seed);
/// n points of the plane z = 1, every second of them `ulps` >= 1 units in the last place (2^-52)
/// above it. Precondition: ulps < 2^52.
[[nodiscard]] std::vector<Point> nearly_flat(std::uint32_t n, std::uint64_t seed,
                                             std::uint64_t ulps = 1);
/// n points (x, y, (x + y) / 3) with x and y uniform in [0, 1), off that plane by the rounding of
/// z, and the apex (1, 0, -1): a lid of many facets that hardly differ.
[[nodiscard]] std::vector<Point> nearly_coplanar(std::uint32_t n, std::uint64_t seed);

/// The box [-1, 1]^2 x [-1, 1] under a lid: n points (x, y, 1 + tilt (1 - (x^2 + y^2) / 2)) with x
/// and y uniform in [-1, 1). Planes of the lid are tilted by about 0 < `tilt` <= 1 against each
/// other; at 2^-52, one ulp of 1, by the rounding of z. n + 8 points.
[[nodiscard]] std::vector<Point> tilted_lid(std::uint32_t n, double tilt, std::uint64_t seed);
/// cospherical(), each coordinate other than 0 moved up or down by at most `ulps` units in its last
/// place, 0 <= ulps <= 2^20: facets with many corners break up.
[[nodiscard]] std::vector<Point> nearly_cospherical(std::uint32_t n, std::uint32_t squared_radius,
                                                    std::uint32_t ulps, std::uint64_t seed);
/// Three balls with their centers on one ray from the origin, n points in each, of radii 1, 2^-e
/// and 2^-2e, 0 <= e <= 500, each 4 radii from the origin: detail at three scales in one hull.
[[nodiscard]] std::vector<Point> mixed_scales(std::uint32_t n, std::uint32_t exponent,
                                              std::uint64_t seed);

// Random families, squeezed, moved and put together.

/// 1 <= `parts` <= 64 random shapes of the other families, few points each, with random values.
/// Each may be turned, stretched by random powers of two along the axes, and moved; its points may
/// occur twice, the second time one ulp off. All coordinates are at most 2^1000. May span no
/// volume.
[[nodiscard]] std::vector<Point> mixture(std::uint32_t parts, std::uint64_t seed);

}  // namespace convexact::shapes
