// SPDX-License-Identifier: MIT
// Splitting, step by step and as a whole, against the definitions: lengths, paths, borders,
// bridges, labels, depths, planes and halves.
#include <doctest/doctest.h>

#include "convexact/cluster.hpp"
#include "convexact/io.hpp"
#include "decompose/divide.hpp"
#include "definitional_tree.hpp"
#include "shipped_meshes.hpp"
#include "small_surfaces.hpp"
#include "split_laws.hpp"

using namespace convexact;
using namespace support;

namespace {

std::vector<TriangleId> all_triangles(const Surface& surface) {
  std::vector<TriangleId> all;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) all.emplace_back(t);
  return all;
}

// With each coordinate mapped.
template <class Map>
Mesh mapped(const Mesh& mesh, const Map& map) {
  std::vector<RationalPoint> points;
  for (std::size_t p = 0; p < mesh.points.size(); ++p) {
    points.push_back(mesh.points[PointId(p)]);
    for (Rational& x : points.back()) x = map(x);
  }
  return {PointSet(points), mesh.polygons, {}};
}

// Surfaces of many kinds, one for each number.
Surface surface_of(unsigned number) {
  std::mt19937 random(1000 + number);
  switch (number % 7) {
    case 0:
      return make_surface(soup(5 + random() % 5, 4 + random() % 9, 1 + random() % 4, random));
    case 1:
      return make_surface(soup(9, 14, 9, random));
    case 2:
      return make_surface(terrain(4, 3, 1 + random() % 4, random() % 6, random));
    case 3: {  // with more triangles over its edges, many of them without area
      Mesh mesh = number % 2 == 0 ? soup(8, 10, 2, random) : terrain(3, 2, 2, 1, random);
      for (int k = 0; k < 4; ++k) {
        const auto face = mesh.polygons[random() % mesh.polygons.size()];
        mesh.polygons.push_back({face[0], face[1], std::uint32_t(random() % mesh.points.size())});
      }
      return make_surface(mesh, {Orient::Keep});
    }
    case 4:
      return make_surface(mesh_of_cells(random_cells(2 + random() % 3, random)));
    case 5:  // fractions, which no double is
      return make_surface(mapped(terrain(3, 3, 3, random() % 4, random),
                                 [](const Rational& x) { return Rational(x * 5 / 3); }));
    default:  // so close to ties that bounds in doubles leave them open
      return make_surface(mapped(terrain(3, 3, 2, random() % 4, random), [&](const Rational& x) {
        return Rational(x + Rational(int(random() % 3) - 1, Integer(1) << 70));
      }));
  }
}

SplitOptions options_of(unsigned number) {
  SplitOptions options;
  options.limit.value = std::array{Rational(0), Rational(1, 100), Rational(1, 10)}[number % 3];
  options.bridge =
      std::array{BridgeChoice::Farther, BridgeChoice::Region, BridgeChoice::Nearer}[number / 3 % 3];
  options.coplanar = std::array{Rational(99, 100), Rational(1, 2), Rational(1)}[number / 9 % 3];
  options.connect = std::array{Connect::Edge, Connect::Overlap, Connect::Touching}[number / 2 % 3];
  options.associations = true;
  return options;
}

// A surface with everything that the product and the definition measure of it.
struct Both {
  explicit Both(unsigned number)
      : surface(surface_of(number)),
        near(surface),
        lengths(surface.points, near),
        patch(surface, all_triangles(surface), lengths),
        defined(surface, all_triangles(surface), near.frame.exponent) {}
  Surface surface;
  NearSurface near;
  EdgeLengths lengths;
  Patch patch;
  definition::Patch defined;
};

}  // namespace

TEST_CASE("split: lengths are the least integers that are not less, in units near 2^-40") {
  std::mt19937 random(3);
  for (int round = 0; round < 200; ++round) {
    CAPTURE(round);
    // Coordinates of a few bits, of which many lengths are whole; any doubles; and their thirds.
    std::vector<RationalPoint> points;
    for (int k = 0; k < 8; ++k) {
      RationalPoint p;
      for (Rational& x : p) {
        x = round % 2 == 0 ? Rational(random() % 5)
                           : to_rational(std::ldexp(double(random()), -32));
        if (round % 3 == 2) x /= 3;
      }
      points.push_back(p);
    }
    Mesh mesh{PointSet(points), {}, {}};
    for (std::uint32_t k = 0; k < 6; ++k) mesh.polygons.push_back({k, k + 1, k + 2});
    const Surface surface = make_surface(mesh);
    const NearSurface near(surface);
    const EdgeLengths lengths(surface.points, near);
    const BoundingBox box = bounding_box(surface.points);
    const Rational longest = RationalVector3(box.high - box.low).maxCoeff();
    const Rational frame = scale_by_power_of_two(1, near.frame.exponent);
    CHECK(longest < frame);
    CHECK(longest > frame / 4);
    const definition::Patch defined(surface, all_triangles(surface), near.frame.exponent);
    for (const PointId a : defined.points) {
      for (const PointId b : defined.points) {
        CHECK(Integer(lengths(a, b)) == defined.length(a, b));
        CHECK(lengths(a, b) < std::uint64_t(1) << 42);
      }
    }
  }
}

TEST_CASE("split: edges next to whole lengths are rounded up") {
  // Along an axis, by an ulp or by far less more or less than a whole number of units.
  for (const Rational& more : {Rational(0), Rational(1, Integer(1) << 60), Rational(1, 3),
                               Rational(-1, Integer(1) << 200)}) {
    const Rational unit = scale_by_power_of_two(1, -40);  // of a longest side near 3/4
    std::vector<RationalPoint> points{{0, 0, 0}, {Rational(3, 4), 0, 0}, {0, Rational(1, 2), 0}};
    for (int k = 1; k < 5; ++k) points.push_back({0, 0, unit * (k * k * k * 12345 + more)});
    Mesh mesh{PointSet(points), {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6}}, {}};
    const Surface surface = make_surface(mesh);
    const NearSurface near(surface);
    const EdgeLengths lengths(surface.points, near);
    const definition::Patch defined(surface, all_triangles(surface), near.frame.exponent);
    for (const PointId a : defined.points) {
      for (const PointId b : defined.points) {
        CHECK(Integer(lengths(a, b)) == defined.length(a, b));
      }
    }
  }
}

TEST_CASE("split: paths are as short as those of Floyd, over the lowest points") {
  std::size_t joined = 0;
  for (unsigned number = 0; number < 100; ++number) {
    CAPTURE(number);
    const Both both(number);
    ShortestPaths paths(both.patch, both.near.points);
    const auto points = both.patch.points();
    REQUIRE(std::equal(points.begin(), points.end(), both.defined.points.begin(),
                       both.defined.points.end()));
    for (std::uint32_t a = 0; a < points.size(); ++a) {
      CHECK(both.patch.number_of(points[a]) == a);
      for (std::uint32_t b = 0; b < points.size(); ++b) {
        CHECK(both.patch.is_edge(a, b) == both.defined.is_edge(points[a], points[b]));
        std::vector<PointId> path;
        Integer length = 0;
        for (const std::uint32_t p : paths(a, b)) {
          if (!path.empty()) length += both.defined.length(path.back(), points[p]);
          path.push_back(points[p]);
        }
        CHECK(path.empty() != both.defined.is_reached(points[a], points[b]));
        if (!path.empty()) CHECK(length == both.defined.distance(points[a], points[b]));
        CHECK(path == both.defined.path(points[a], points[b]));
        joined += path.size() > 2;
      }
    }
  }
  CHECK(joined > 1000);
}

TEST_CASE("split: borders are closed walks, and which edges span them") {
  std::size_t loops = 0, holes = 0, edges = 0;
  for (unsigned number = 0; number < 400; ++number) {
    CAPTURE(number);
    const Both both(number);
    const auto points = both.patch.points();
    std::set<std::vector<PointId>> found;
    for (const auto& loop : both.patch.border_loops()) {
      std::vector<PointId> ids;
      for (const std::uint32_t p : loop) ids.push_back(points[p]);
      // From its lowest step, as a walk may pass a point twice.
      std::set<std::vector<PointId>> turned;
      for (std::size_t k = 0; k < ids.size(); ++k) {
        std::rotate(ids.begin(), ids.begin() + 1, ids.end());
        turned.insert(ids);
      }
      const auto by_step = [](const auto& x, const auto& y) {
        return std::pair(x[0], x[1]) < std::pair(y[0], y[1]);
      };
      CHECK(found.insert(*std::min_element(turned.begin(), turned.end(), by_step)).second);
    }
    CHECK(found == std::set<std::vector<PointId>>(both.defined.border_loops.begin(),
                                                  both.defined.border_loops.end()));
    loops += found.size();
    if (number % 2 == 1) continue;
    const IntegerVector3 up(1, 2, 3), aside(-2, 1, 3);
    for (std::uint32_t a = 0; a < points.size() && !found.empty(); ++a) {
      for (std::uint32_t b = 0; b < points.size(); ++b) {
        const bool spans = spans_hole(both.surface, both.patch, a, b, {up, aside});
        CHECK(spans == both.defined.spans_hole(points[a], points[b], up.cast<Rational>(),
                                               aside.cast<Rational>()));
        holes += spans;
        ++edges;
      }
    }
  }
  CHECK(loops > 200);
  CHECK(holes > 100);
  CHECK(holes < edges / 2);
}

TEST_CASE("split: the nearest point of a polygon is a corner, or a foot") {
  std::mt19937 random(8);
  for (int round = 0; round < 200; ++round) {
    CAPTURE(round);
    std::vector<RationalPoint> list;
    for (int k = 0; k < 8; ++k) list.emplace_back(random() % 4, random() % 4, random() % 3);
    if (affine_dimension(list) < 3) continue;
    const PointSet points(list);
    const auto hull = std::get<Hull>(convex_hull(points));
    const std::vector<Halfspace> planes = facet_halfspaces(hull, points);
    for (std::size_t f = 0; f < planes.size(); ++f) {
      const Association::Facet facet(hull.facets[f].begin(), hull.facets[f].end());
      std::vector<RationalPoint> corners;
      for (const PointId p : facet) corners.push_back(points[p]);
      for (int k = 0; k < 8; ++k) {
        const RationalPoint x(Rational(int(random() % 13) - 4, 2), int(random() % 8) - 2,
                              int(random() % 6) - 2);
        CHECK(nearest_on_facet(points, facet, planes[f], x) ==
              definition::nearest_on_polygon(corners, x));
      }
    }
  }
}

TEST_CASE("split: bridges, paths, labels and the notch of a part are those of the definitions") {
  std::size_t deep = 0, paths = 0;
  for (unsigned number = 0; number < 270; ++number) {
    CAPTURE(number);
    const Surface surface = surface_of(number);
    const SplitOptions options = options_of(number);
    const BridgeMeasure made = measure_by_bridges(surface, all_triangles(surface), options);
    const definition::SplitPart defined(surface, all_triangles(surface),
                                        NearSurface(surface).frame.exponent, options);
    CHECK(difference(made.association, defined.association) == "");
    CHECK(made.concavity.squared == defined.concavity.squared);
    CHECK(made.concavity.at == defined.concavity.at);
    CHECK(made.concavity.leaves == defined.concavity.leaves);
    CHECK(made.concavity.triangle == defined.concavity.triangle);
    CHECK(made.least_squared_concavity == defined.least_squared);
    if (defined.notch) CHECK(made.notch == *defined.notch);
    deep += defined.notch.has_value();
    for (const BridgePath& path : made.association.paths) paths += path.points.size() > 2;
  }
  CHECK(deep > 100);
  CHECK(paths > 100);
}

TEST_CASE("split: planes at a notch stand in the order of the definition") {
  std::size_t count = 0;
  for (unsigned number = 0; number < 120; ++number) {
    CAPTURE(number);
    const Both both(number);
    for (const PointId notch : both.defined.points) {
      const auto made = split_planes(both.surface, both.patch, notch);
      const auto defined = definition::SplitPlanes(both.surface, both.defined, notch).planes;
      REQUIRE(made.size() == defined.size());
      for (std::size_t k = 0; k < made.size(); ++k) {
        CHECK(made[k].to == defined[k].to);
        CHECK(made[k].triangles == defined[k].triangles);
        CHECK(made[k].plane == defined[k].plane);
        ++count;
      }
    }
  }
  CHECK(count > 1000);
}

TEST_CASE("split: the whole tree is the one that the definitions make") {
  std::size_t splits = 0, islands = 0, refused = 0, unsplittable = 0, spanned = 0, bounded = 0;
  for (unsigned number = 0; number < 400; ++number) {
    CAPTURE(number);
    const Surface surface = surface_of(number);
    SplitOptions options = options_of(number * 7);
    if (number % 4 == 3) {
      options.max_parts = count_groups(surface, neighbours(surface, options.connect)) + number % 3;
    }
    const SplitTree made = split(surface, options);
    const SplitTree defined =
        definition::SplitReplay(surface, options, NearSurface(surface).frame.exponent, made.united)
            .run();
    CHECK(made.united == cluster(surface, {.connect = options.connect}).united);
    REQUIRE(difference_in_place(made, defined) == "");
    CHECK(SplitLaws(surface, options, made).broken() == "");
    for (std::size_t n = 0; n < made.nodes.size(); ++n) {
      REQUIRE(made.nodes[n].association);
      CHECK(difference(*made.nodes[n].association, *defined.nodes[n].association) == "");
      for (const BridgePath& path : made.nodes[n].association->paths) spanned += path.spans_hole;
    }
    splits += made.splits.size();
    for (const Split& split : made.splits) {
      islands += split.islands.size();
      refused += split.refused;
    }
    for (const SplitLeaf& leaf : made.leaves)
      unsplittable += leaf.status == LeafStatus::Unsplittable;
    bounded += made.stopped_by_count;
  }
  // All of it came up.
  CHECK(splits > 300);
  CHECK(islands > 10);
  CHECK(refused > 10);
  CHECK(unsplittable > 10);
  CHECK(spanned > 10);
  CHECK(bounded > 10);
}

TEST_CASE("split: the trees of pieces of shipped meshes are those of the definitions") {
  std::size_t splits = 0;
  for (const std::string& path : shipped_meshes()) {
    CAPTURE(path);
    const Surface surface = first_triangles(make_surface(read_mesh(path)), 48);
    for (const unsigned number : {0u, 3u, 6u}) {
      SplitOptions options = options_of(number);
      options.connect = Connect::Edge;
      const SplitTree made = split(surface, options);
      definition::SplitReplay replay(surface, options, NearSurface(surface).frame.exponent,
                                     made.united);
      CHECK(difference_in_place(made, replay.run()) == "");
      splits += made.splits.size();
    }
  }
  CHECK(splits > 5);
}

// The notch of the U is 1 deep: between x = 1 and x = 2 it reaches from z = 2 down to z = 1.
TEST_CASE("split: a part that is as concave as the limit allows stays whole") {
  const Mesh u{PointSet(std::vector<Point>{{0, 0, 0},
                                           {3, 0, 0},
                                           {3, 0, 2},
                                           {2, 0, 2},
                                           {2, 0, 1},
                                           {1, 0, 1},
                                           {1, 0, 2},
                                           {0, 0, 2},
                                           {0, 1, 0},
                                           {3, 1, 0},
                                           {3, 1, 2},
                                           {2, 1, 2},
                                           {2, 1, 1},
                                           {1, 1, 1},
                                           {1, 1, 2},
                                           {0, 1, 2}}),
               {{0, 1, 2, 3, 4, 5, 6, 7},
                {15, 14, 13, 12, 11, 10, 9, 8},
                {1, 0, 8, 9},
                {2, 1, 9, 10},
                {3, 2, 10, 11},
                {4, 3, 11, 12},
                {5, 4, 12, 13},
                {6, 5, 13, 14},
                {7, 6, 14, 15},
                {0, 7, 15, 8}},
               {}};
  const Surface surface = make_surface(u);
  SplitOptions options;
  options.limit = {Rational(1), false};
  CHECK(split(surface, options).leaves.size() == 1);
  options.limit.value -= Rational(1, 1000000000);
  CHECK(split(surface, options).leaves.size() > 1);
}
