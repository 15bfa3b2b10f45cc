// SPDX-License-Identifier: MIT
// Concavity by its definition: planes through all triples of points, and linear programs by
// enumerating their corners; against the exact one, and against the bounds in doubles.
#include <doctest/doctest.h>

#include <optional>

#include "convexact/cluster.hpp"
#include "decompose/near_concavity.hpp"
#include "fractions.hpp"
#include "small_surfaces.hpp"
#include "sweep.hpp"

using namespace convexact;
using namespace support;

namespace {

// The planes through three of the points that have none beyond them.
std::vector<Halfspace> facets_by_definition(const std::vector<RationalPoint>& points) {
  std::vector<Halfspace> planes;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < points.size(); ++j) {
      for (std::size_t k = 0; k < points.size(); ++k) {
        const RationalVector3 e = points[j] - points[i], f = points[k] - points[i];
        const RationalVector3 normal = e.cross(f);
        if (normal.isZero()) continue;
        const Halfspace plane(normal, Rational(-normal.dot(points[i])));
        bool holds = true;
        for (const RationalPoint& p : points) holds = holds && plane(p) <= 0;
        if (holds && std::find(planes.begin(), planes.end(), plane) == planes.end()) {
          planes.push_back(plane);
        }
      }
    }
  }
  return planes;
}

using Row = std::array<Rational, 4>;  // x u + y w + z t + d <= 0

Rational determinant(const Row& a, const Row& b, const Row& c, std::array<std::size_t, 3> k) {
  return a[k[0]] * (b[k[1]] * c[k[2]] - b[k[2]] * c[k[1]]) -
         a[k[1]] * (b[k[0]] * c[k[2]] - b[k[2]] * c[k[0]]) +
         a[k[2]] * (b[k[0]] * c[k[1]] - b[k[1]] * c[k[0]]);
}

// The largest t, at a corner of the feasible set.
Rational largest_t(const std::vector<Row>& rows) {
  std::optional<Rational> best;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = i + 1; j < rows.size(); ++j) {
      for (std::size_t k = j + 1; k < rows.size(); ++k) {
        const Rational whole = determinant(rows[i], rows[j], rows[k], {0, 1, 2});
        if (whole == 0) continue;
        const Rational u = -determinant(rows[i], rows[j], rows[k], {3, 1, 2}) / whole;
        const Rational w = -determinant(rows[i], rows[j], rows[k], {0, 3, 2}) / whole;
        const Rational t = -determinant(rows[i], rows[j], rows[k], {0, 1, 3}) / whole;
        bool holds = true;
        for (const Row& row : rows)
          holds = holds && row[0] * u + row[1] * w + row[2] * t + row[3] <= 0;
        if (holds && (!best || t > *best)) best = t;
      }
    }
  }
  return *best;
}

RationalVector3 area_of(const Surface& surface, std::size_t t) {
  const auto& [a, b, c] = surface.triangles[t];
  const RationalVector3 e = surface.points[b] - surface.points[a];
  const RationalVector3 f = surface.points[c] - surface.points[a];
  return e.cross(f);
}

Rational square_by_definition(const Surface& surface, const std::vector<TriangleId>& cluster,
                              const std::vector<Halfspace>& planes, ConcavityMeasure measure) {
  Rational largest = 0;
  for (const TriangleId t : cluster) {
    const auto& triangle = surface.triangles[t.index()];
    std::array<RationalPoint, 3> corner;
    for (std::size_t k = 0; k < 3; ++k) corner[k] = surface.points[triangle[k]];
    for (std::size_t k = 0; k < (measure == ConcavityMeasure::Surface ? 1u : 3u); ++k) {
      RationalVector3 n = RationalVector3::Zero();
      for (std::size_t s = 0; s < surface.triangles.size(); ++s) {
        const auto& other = surface.triangles[s];
        const bool counts = measure == ConcavityMeasure::Surface
                                ? s == t.index()
                                : std::find(other.begin(), other.end(), triangle[k]) != other.end();
        if (counts) n += area_of(surface, s);
      }
      std::vector<Row> rows{{-1, 0, 0, 0}, {0, -1, 0, 0}, {1, 1, 0, -1}};
      std::optional<Rational> ray;
      for (const Halfspace& plane : planes) {
        const Rational along = n.dot(plane.normal().cast<Rational>());
        if (along <= 0) continue;
        rows.push_back({plane(corner[1]) - plane(corner[0]), plane(corner[2]) - plane(corner[0]),
                        along, plane(corner[0])});
        const Rational t_here = -plane(corner[k]) / along;
        if (!ray || t_here < *ray) ray = t_here;
      }
      if (!ray) continue;
      const Rational t_max = measure == ConcavityMeasure::Surface ? largest_t(rows) : *ray;
      largest = std::max<Rational>(largest, t_max * t_max * n.dot(n));
    }
  }
  return largest;
}

// A square root of the number is in the bounds, which are in units of 2^exponent.
bool bounds_hold(const LengthBounds& bounds, const Rational& square, long exponent) {
  const Rational scaled = scale_by_power_of_two(square, -2 * exponent);
  const Rational low = to_rational(bounds.low);
  return low * low <= scaled &&
         (std::isinf(bounds.high) || scaled <= to_rational(bounds.high) * to_rational(bounds.high));
}

// All nonempty sets of triangles that hang together.
std::vector<std::vector<TriangleId>> connected_sets(const Surface& surface) {
  const auto pairs = neighbours(surface, Connect::Edge);
  std::vector<std::vector<TriangleId>> sets;
  for (unsigned mask = 1; mask < 1u << surface.triangles.size(); ++mask) {
    unsigned reached = mask & -mask, before = 0;
    while (reached != before) {
      before = reached;
      for (const auto& [a, b] : pairs) {
        const unsigned x = 1u << a.index(), y = 1u << b.index();
        if ((mask & x) && (mask & y) && (reached & (x | y))) reached |= x | y;
      }
    }
    if (reached != mask) continue;
    auto& set = sets.emplace_back();
    for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
      if (mask & 1u << t) set.push_back(TriangleId(t));
    }
  }
  return sets;
}

}  // namespace

TEST_CASE("the concavity of all connected sets of triangles is that of the definition" * sweep) {
  std::mt19937 random(7);
  std::size_t solid = 0, flat = 0;
  for (int round = 0; round < 12; ++round) {
    const Surface surface = make_surface(terrain(3, 2, 3, 3, random));
    for (const ConcavityMeasure measure : {ConcavityMeasure::Surface, ConcavityMeasure::Vertices}) {
      const ExactConcavity exact(surface, measure);
      const NearConcavity near(surface, measure, false);
      for (const auto& cluster : connected_sets(surface)) {
        const PointSet points = subset(surface.points, points_of(surface, cluster));
        const ConvexPart hull = convex_part(points);
        const Concavity found = exact(cluster, hull);
        CHECK((found.leaves - found.at).squaredNorm() == found.squared);
        CHECK(holds(hull, found.leaves));
        NearCluster bounded = near.cluster(cluster);
        CHECK(bounds_hold(bounded.concavity, found.squared, near.exponent()));
        NearCluster squared = bounded;
        CHECK(near.squared(squared, cluster) == found.squared);
        const Concavity again = near.exact(bounded, cluster);
        CHECK(again.squared == found.squared);
        CHECK(again.triangle == found.triangle);
        CHECK(again.at == found.at);
        // Once it is known, its bounds are narrow, or even one double.
        CHECK(near.exact(bounded, cluster).squared == found.squared);
        if (hull.dimension < 3) {
          if (measure == ConcavityMeasure::Surface) CHECK(found.squared == 0);
          ++flat;
          continue;
        }
        std::vector<RationalPoint> corners;
        for (std::size_t k = 0; k < points.size(); ++k) corners.push_back(points[PointId(k)]);
        CHECK(found.squared ==
              square_by_definition(surface, cluster, facets_by_definition(corners), measure));
        ++solid;
      }
    }
  }
  CHECK(solid > 500);
  CHECK(flat > 50);
}

TEST_CASE("unions are bounded by what their halves know") {
  std::mt19937 random(11);
  std::size_t tight = 0, all = 0;
  for (int round = 0; round < 60; ++round) {
    const Surface surface = make_surface(terrain(6, 5, 1 + unsigned(round) % 5, 0, random));
    const auto measure = round % 2 == 0 ? ConcavityMeasure::Surface : ConcavityMeasure::Vertices;
    const ExactConcavity exact(surface, measure);
    const NearConcavity near(surface, measure, false);
    std::vector<TriangleId> one, other, both;
    const std::size_t middle = 1 + random() % (surface.triangles.size() - 1);
    for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
      (t < middle ? one : other).push_back(TriangleId(t));
      both.push_back(TriangleId(t));
    }
    NearCluster bounded = near.unite(near.cluster(one), near.cluster(other), kNoBound);
    const Rational square =
        exact(both, convex_part(subset(surface.points, points_of(surface, both)))).squared;
    CHECK(bounds_hold(bounded.concavity, square, near.exponent()));
    CHECK(near.exact(bounded, both).squared == square);
    ++all;
    tight += bounded.concavity.high - bounded.concavity.low <= 1e-6 * bounded.concavity.high;
  }
  CHECK(tight > all * 9 / 10);  // bounds that say nothing would hold, too
}

TEST_CASE("bounds hold where rounding moves the points, and are not vacuous") {
  std::mt19937 random(12);
  for (const Fractions kind : kFractions) {
    CAPTURE(static_cast<int>(kind));
    std::size_t tight = 0, all = 0;
    for (unsigned round = 0; round < 24; ++round) {
      Mesh mesh = terrain(5, 3, 1 + round % 5, 0, random);
      mesh.points = as_fractions(mesh.points, kind);
      const Surface surface = make_surface(mesh);
      const auto measure = round % 2 == 0 ? ConcavityMeasure::Surface : ConcavityMeasure::Vertices;
      const ExactConcavity exact(surface, measure);
      const NearConcavity near(surface, measure, false);
      std::vector<TriangleId> some;
      const std::size_t first = random() % 8, count = 6 + random() % 16;
      for (std::size_t t = first; t < first + count; ++t) some.emplace_back(t);
      const Concavity found =
          exact(some, convex_part(subset(surface.points, points_of(surface, some))));
      NearCluster bounded = near.cluster(some);
      CHECK(bounds_hold(bounded.concavity, found.squared, near.exponent()));
      ++all;
      tight += bounded.concavity.high - bounded.concavity.low <= 1e-2 * bounded.concavity.high;
      const Concavity again = near.exact(bounded, some);
      CHECK(again.squared == found.squared);
      CHECK(again.at == found.at);
    }
    // A needle as thin as rounding, and points below normal doubles, are left to exact numbers.
    const bool is_hopeless =
        kind == Fractions::Needle || kind == Fractions::Hair || kind == Fractions::Tiny;
    if (!is_hopeless) CHECK(tight > all / 2);
  }
}

TEST_CASE("normals are within their errors, wherever the true points are") {
  std::mt19937 random(13);
  std::uniform_real_distribution<double> spread(-1, 1);
  double most = 0;
  for (int round = 0; round < 4000; ++round) {
    // Edges from 1 down to the sizes of rounding.
    const double size = std::ldexp(1, -int(random() % 54)), off = kUnitRoundoff;
    std::array<Point, 3> near;
    std::array<RationalPoint, 3> exact;
    for (std::size_t k = 0; k < 3; ++k) {
      for (int axis = 0; axis < 3; ++axis) {
        near[k][axis] = 0.5 + (k == 0 ? 0 : size * spread(random) / 2);
        const double corner = random() % 2 == 0 ? off : -off;
        exact[k][axis] = to_rational(near[k][axis]) + to_rational(corner);
      }
    }
    const NearNormal normal = near_normal(near[0], near[1], near[2], off);
    const RationalVector3 e = exact[1] - exact[0], f = exact[2] - exact[0], true_one = e.cross(f);
    for (int axis = 0; axis < 3; ++axis) {
      const Rational error = abs(Rational(true_one[axis] - to_rational(normal.value[axis])));
      CHECK(error <= to_rational(normal.error));
      most = std::max(most, to_double(error / to_rational(normal.error), Rounding::Nearest));
    }
  }
  CHECK(most > 0.4);
}

TEST_CASE("a closed form: the notch of an L") {
  // The corner of the notch is at (1, 1), and the hull's side beyond it runs from (2, 1) to (1, 2).
  const Surface surface = make_surface(mesh_of_cells(l_cells()));
  std::vector<TriangleId> all;
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) all.push_back(TriangleId(t));
  const ConvexPart hull = convex_part(surface.points);
  // Along the notch's sides, rays run in x or y, the longest from the corner: of length 1.
  CHECK(ExactConcavity(surface, ConcavityMeasure::Surface)(all, hull).squared == 1);
  // Each vertex is on the bottom or the top of the hull, and its normal points through that: a
  // measure at vertices does not see the notch.
  CHECK(ExactConcavity(surface, ConcavityMeasure::Vertices)(all, hull).squared == 0);
}

TEST_CASE("a closed form: a dent that is lost in rounding") {
  // The middle of a square is lower by h. The normals beside it are (0, h, 1 / 2) and the like, so
  // a ray from it rises to the square after 2 h times its normal: by h^2 (1 + 4 h^2), squared.
  const double h = 0x1p-52;
  const Surface surface = make_surface(
      {PointSet(std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, -h}}),
       {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}},
       {}},
      {Orient::Keep});
  const std::vector<TriangleId> all{TriangleId(0), TriangleId(1), TriangleId(2), TriangleId(3)};
  const Rational square = to_rational(h) * to_rational(h);
  const Rational expected = square * (1 + 4 * square);
  const ConvexPart hull = convex_part(surface.points);
  CHECK(ExactConcavity(surface, ConcavityMeasure::Surface)(all, hull).squared == expected);
  CHECK(NearConcavity(surface, ConcavityMeasure::Surface, false).exact(all).squared == expected);
}
