// SPDX-License-Identifier: MIT
// Trees of hulls: what joins make, that every hull holds its children by the definition of a hull,
// and each thing that can be wrong with a tree.
#include "convexact/hull_tree.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <set>

#include "assembled_meshes.hpp"
#include "cells.hpp"
#include "convexact/io.hpp"
#include "convexact/measure.hpp"
#include "expect_error.hpp"
#include "scene/objects.hpp"
#include "supporting_planes.hpp"
#include "sweep.hpp"

using namespace convexact;
using namespace support;

namespace {

using Nodes = std::vector<std::size_t>;

// A child in each halfspace that three points of the parent span and that holds all of these.
void check_nested(const HullTree& tree) {
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    if (tree.nodes[i].children.empty()) continue;
    const auto planes = supporting_planes(points_in(tree.mesh_of(i).points));
    for (const std::size_t child : tree.nodes[i].children) {
      CHECK(tree.nodes[child].parent == i);
      for (const RationalPoint& x : points_in(tree.mesh_of(child).points)) {
        CHECK(std::all_of(planes.begin(), planes.end(),
                          [&](const Halfspace& h) { return h(x) <= 0; }));
      }
    }
  }
}

// The parts below each branch.
std::set<Nodes> parts_below(const HullTree& tree) {
  std::vector<Nodes> below(tree.nodes.size());
  std::set<Nodes> sets;
  for (std::size_t i = tree.nodes.size(); i-- > 0;) {
    const HullTreeNode& node = tree.nodes[i];
    if (node.part) below[i] = {*node.part};
    for (const std::size_t child : node.children) {
      CHECK(child > i);  // level by level
      below[i].insert(below[i].end(), below[child].begin(), below[child].end());
    }
    std::sort(below[i].begin(), below[i].end());
    if (!node.part) sets.insert(below[i]);
  }
  return sets;
}

Box at_x(double x) { return {{x, 0, 0}, {x + 1, 1, 1}}; }

std::vector<NamedPart> balls(int count, int points) {
  std::vector<NamedPart> parts;
  for (int k = 0; k < count; ++k) {
    const Point center(3.0 * (k % 3), 3.0 * (k / 3), 0.25 * k);
    parts.push_back({"ball", ball(center, points)});
  }
  return parts;
}

bool is_float(const PointSet& points) {
  return points.is_binary() &&
         std::all_of(points.doubles().begin(), points.doubles().end(), [](const Point& p) {
           return std::all_of(p.begin(), p.end(), [](double x) { return double(float(x)) == x; });
         });
}

Decomposition decomposed(const Mesh& mesh, DecomposeRequest request) {
  request.for_tree = true;
  request.measures = PartMeasures::None;
  return std::get<Decomposition>(decompose(mesh, request));
}

// A wall with steps, which both methods cut into several parts.
Mesh stairs() {
  std::set<Cell> cells;
  for (int x = 0; x < 4; ++x) {
    for (int y = 0; y <= x; ++y) cells.insert({x, y, 0});
  }
  return mesh_of_cells(cells);
}

}  // namespace

TEST_CASE("build_tree: two boxes under the box around both; its levels by hand") {
  const BuiltTree built = build_tree(parts_of_boxes({at_x(0), at_x(2)}), {});
  const auto& nodes = built.tree.nodes;
  REQUIRE(nodes.size() == 3);
  CHECK_FALSE(nodes[0].parent);
  CHECK(nodes[0].children == Nodes{1, 2});
  CHECK(nodes[1].part == 0u);
  CHECK(nodes[2].part == 1u);
  check_nested(built.tree);
  REQUIRE(built.levels.size() == 2);
  CHECK(built.levels[0].nodes == 1);
  CHECK(built.levels[0].leaves == 0);
  CHECK(built.levels[0].volume.contains(Rational(3)));
  CHECK(built.levels[0].area.contains(Rational(14)));
  CHECK(built.levels[1].leaves == 2);
  CHECK(built.levels[1].volume.contains(Rational(2)));
  CHECK(built.levels[1].area.contains(Rational(12)));
  CHECK(built.facets == Nodes{6, 6, 6});
  CHECK(built.given_joins == 0);
  // Stored without rounding: the corners are those of the input.
  CHECK(points_in(nodes[0].mesh.points).size() == 8);
}

TEST_CASE("build_tree: one part is its own root") {
  const BuiltTree built = build_tree(parts_of_boxes({at_x(0)}), {});
  REQUIRE(built.tree.nodes.size() == 1);
  CHECK(built.tree.nodes[0].part == 0u);
  CHECK(built.levels.size() == 1);
  CHECK_FALSE(find_tree_fault(built.tree));
}

TEST_CASE("build_tree: where the common hull has the least volume is joined first") {
  // Of neighbours 2 1/4, 7 and 2 1/2.
  const auto parts = parts_of_boxes({at_x(0), at_x(1.25), at_x(7.25), at_x(8.75)});
  const BuiltTree built = build_tree(parts, {});
  CHECK(parts_below(built.tree) == std::set<Nodes>{{0, 1}, {2, 3}, {0, 1, 2, 3}});
  // In another order, with another seed, and scaled by a power of two: the same tree.
  std::vector<NamedPart> turned = {parts[2], parts[0], parts[3], parts[1]};
  CHECK(parts_below(build_tree(turned, {}, {.seed = 9}).tree) ==
        std::set<Nodes>{{1, 3}, {0, 2}, {0, 1, 2, 3}});
  for (NamedPart& part : turned) {
    std::vector<Point> points(part.mesh.points.doubles().begin(), part.mesh.points.doubles().end());
    for (Point& p : points) p *= 0x1p-300;
    std::reverse(points.begin(), points.end());
    points.push_back(points.front());
    part.mesh = {PointSet(points), {}, {}};
  }
  CHECK(parts_below(build_tree(turned, {}).tree) == std::set<Nodes>{{1, 3}, {0, 2}, {0, 1, 2, 3}});
}

TEST_CASE("build_tree: joins of the caller come first, the rest by volume; others are refused") {
  const auto parts = parts_of_boxes({at_x(0), at_x(1.25), at_x(7.25), at_x(8.75)});
  const std::vector<Join> joins = {{0, 3}};
  const BuiltTree built = build_tree(parts, joins);
  CHECK(built.given_joins == 1);
  CHECK(parts_below(built.tree).contains({0, 3}));
  CHECK(parts_below(built.tree).contains({0, 1, 2, 3}));
  check_nested(built.tree);
  for (const std::vector<Join>& wrong :
       {std::vector<Join>{{0, 4}}, {{1, 1}}, {{0, 1}, {1, 2}}, {{0, 1}, {4, 4}}}) {
    CHECK(error_of([&] { return build_tree(parts, wrong); }).code() == ErrorCode::InvalidArgument);
  }
  CHECK(error_of([&] { return build_tree(std::vector<NamedPart>(), {}); }).code() ==
        ErrorCode::InvalidArgument);
  CHECK(error_of([&] { return build_tree(parts, {}, {.faces = 3}); }).code() ==
        ErrorCode::InvalidArgument);
  CHECK(error_of([&] { return build_tree(parts, {}, {.leaf_faces = 3}); }).code() ==
        ErrorCode::InvalidArgument);
}

TEST_CASE("build_tree: simplified branches and leaves still hold what is below them") {
  const auto parts = balls(5, 24);
  for (const Precision precision : {Precision::Binary64, Precision::Binary32}) {
    const TreeRequest request{.faces = 9, .leaf_faces = 12, .precision = precision};
    const BuiltTree built = build_tree(parts, {}, request);
    check_nested(built.tree);
    for (std::size_t i = 0; i < built.tree.nodes.size(); ++i) {
      const HullTreeNode& node = built.tree.nodes[i];
      CHECK(built.facets[i] == (node.part ? 12 : 9));
      if (precision == Precision::Binary32) CHECK(is_float(built.tree.mesh_of(i).points));
    }
    // Leaves hold the parts that were given.
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const auto planes = supporting_planes(points_in(built.tree.parts[k].mesh.points));
      for (const RationalPoint& x : points_in(parts[k].mesh.points)) {
        CHECK(std::all_of(planes.begin(), planes.end(),
                          [&](const Halfspace& h) { return h(x) <= 0; }));
      }
    }
  }
}

TEST_CASE("build_tree: a flat part on the root's facet is thickened, and the root holds that") {
  auto parts = parts_of_boxes({at_x(0), at_x(4)});
  // A square in the plane of the top of the box around both: z = 1.
  parts.push_back({"lid", mesh_of({{2, 0, 1}, {3, 0, 1}, {3, 1, 1}, {2, 1, 1}}, {{0, 1, 2, 3}})});
  for (const TreeRequest& request : {TreeRequest{}, TreeRequest{.faces = 4}}) {
    const BuiltTree built = build_tree(parts, {}, request);
    check_nested(built.tree);
    const auto lid = points_in(built.tree.parts[2].mesh.points);
    CHECK(std::any_of(lid.begin(), lid.end(), [](const RationalPoint& x) { return x.z() > 1; }));
    const auto root = points_in(built.tree.nodes[0].mesh.points);
    CHECK(std::any_of(root.begin(), root.end(), [](const RationalPoint& x) { return x.z() > 1; }));
  }
  parts.push_back({"point", {PointSet(std::vector<Point>{{9, 9, 9}}), {}, {}}});
  check_nested(build_tree(parts, {}).tree);
}

TEST_CASE("joins_of: the branches are the groups that acd split") {
  // Without parts that lie in others each leaf is a part of its own.
  const Decomposition d = decomposed(
      stairs(), {.method = DecomposeMethod::Acd, .limit = {Rational(1, 100)}, .keep_inner = true});
  const auto& tree = std::get<SplitTree>(d.origin);
  REQUIRE(d.parts.size() >= 3);
  std::vector<Nodes> below(tree.nodes.size());
  for (const SplitLeaf& leaf : tree.leaves) {
    below[leaf.node] = {d.owner[leaf.triangles.front().index()]};
  }
  std::set<Nodes> split;
  for (std::size_t i = tree.nodes.size(); i-- > 0;) {
    if (!tree.nodes[i].is_split) continue;
    for (const std::uint32_t child : tree.nodes[i].children) {
      below[i].insert(below[i].end(), below[child].begin(), below[child].end());
    }
    std::sort(below[i].begin(), below[i].end());
    split.insert(below[i]);
  }
  const auto joins = joins_of(d);
  CHECK(joins.size() == d.parts.size() - 1);
  const BuiltTree built = build_tree(d, std::vector<std::string>(d.parts.size(), "part"));
  CHECK(parts_below(built.tree) == split);
  CHECK(built.given_joins == joins.size());
  check_nested(built.tree);
}

TEST_CASE("joins_of: hacd merges on to one group of each component, in either engine") {
  Mesh mesh = stairs();
  std::vector<Point> moved(mesh.points.doubles().begin(), mesh.points.doubles().end());
  for (Point& p : moved) p += Point(9, 0, 0);
  const Mesh two = joined({mesh, {PointSet(moved), mesh.polygons, {}}});
  DecomposeRequest request{.limit = {Rational(1, 100)}};
  const Decomposition d = decomposed(two, request);
  const auto& clustering = std::get<Clustering>(d.origin);
  CHECK(clustering.further_merges.size() == clustering.clusters.size() - 2);
  // The same clusters as without a tree, and as the exact engine finds them.
  request.engine = Engine::Exact;
  const Decomposition exact = decomposed(two, request);
  CHECK(std::get<Clustering>(exact.origin).further_merges == clustering.further_merges);
  const Clustering plain = cluster(d.surface, {.limit = request.limit});
  CHECK(plain.further_merges.empty());
  CHECK(plain.clusters == clustering.clusters);
  CHECK(plain.merges == clustering.merges);
  // Of the next merges none has a pair of lesser concavity: by the definition, the first one.
  const auto joins = joins_of(d);
  CHECK(joins.size() <= d.parts.size() - 2);
  std::vector<NamedPart> parts;
  for (const Part& part : d.parts) parts.push_back({"part", part.mesh});
  const BuiltTree built = build_tree(parts, joins);
  check_nested(built.tree);
  CHECK(built.given_joins == joins.size());
}

TEST_CASE("joins_of: clusters that became no part of their own are in no join") {
  // A box with a fin, whose cluster lies in a plane and joins another one; and stairs, some of
  // whose clusters lie in the parts of others.
  std::vector<Mesh> pieces = {box_mesh(at_x(0)), box_mesh({{0, 0, 1}, {0.5, 0.5, 3}})};
  pieces.push_back(mesh_of({{1, 0, 0}, {4, 0, 0}, {4, 1, 0}, {1, 1, 0}}, {{0, 1, 2, 3}}));
  const Mesh finned = joined(pieces);
  std::size_t dropped = 0;
  for (const DecomposeMethod method : {DecomposeMethod::Hacd, DecomposeMethod::Acd}) {
    for (const Mesh& mesh : {finned, stairs()}) {
      const Decomposition d =
          decomposed(mesh, {.method = method, .limit = {Rational(0)}, .flat = FlatParts::Merge});
      std::vector<NamedPart> parts;
      for (const Part& part : d.parts) parts.push_back({"part", part.mesh});
      const auto joins = joins_of(d);
      CHECK(joins.size() < d.parts.size());
      dropped += d.clusters().size() - d.parts.size();
      const BuiltTree built = build_tree(parts, joins);
      CHECK(built.given_joins == joins.size());
      check_nested(built.tree);
    }
  }
  CHECK(dropped >= 3);
}

TEST_CASE("joins_of: merges of clusters whose parts were joined before, by hand") {
  // Cluster 3 joined the part of cluster 0, and cluster 4 lies in another part.
  Decomposition d;
  d.surface.triangles.resize(5);
  const auto ids = [](std::vector<std::uint32_t> numbers) {
    std::vector<TriangleId> triangles;
    for (const std::uint32_t number : numbers) triangles.emplace_back(number);
    return triangles;
  };
  for (const auto& cluster : {ids({0, 3}), ids({1}), ids({2})}) {
    d.parts.emplace_back().cluster = cluster;
  }
  Clustering clustering;
  for (std::uint32_t t = 0; t < 5; ++t) clustering.clusters.push_back(ids({t}));
  const auto merge = [&](std::uint32_t kept, std::uint32_t gone) {
    clustering.further_merges.push_back({.kept = TriangleId(kept), .gone = TriangleId(gone)});
  };
  merge(1, 4);  // nothing to join
  merge(0, 1);  // parts 0 and 1 become group 3
  merge(2, 3);  // part 2, and that group, to which part 0 belongs
  merge(0, 2);  // one group already
  d.origin = clustering;
  CHECK(joins_of(d) == std::vector<Join>{{0, 1}, {2, 3}});
}

TEST_CASE("further merges: with a number of parts they begin where that ends") {
  const Surface surface = make_surface(stairs());
  for (const Engine engine : {Engine::Exact, Engine::Filtered}) {
    const Clustering all =
        cluster(surface, {.limit = {Rational(0)}, .max_parts = 1, .engine = engine});
    const Clustering some = cluster(
        surface, {.limit = {Rational(0)}, .max_parts = 3, .engine = engine, .further = true});
    REQUIRE(all.clusters.size() == 1);
    CHECK(some.clusters.size() == 3);
    CHECK(some.further_merges.size() == 2);
    auto merges = some.merges;
    merges.insert(merges.end(), some.further_merges.begin(), some.further_merges.end());
    CHECK(merges == all.merges);
  }
}

// ---- The greedy choice, by its definition

namespace {

struct Root {
  std::size_t id;
  Nodes parts;
  std::vector<RationalPoint> points;
};

Rational common_box(const Root& a, const Root& b) {
  std::vector<RationalPoint> points = a.points;
  points.insert(points.end(), b.points.begin(), b.points.end());
  const RationalVector3 size = bounding_box(points).size();
  return size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
}

Root joined_root(const Root& a, const Root& b, std::size_t id) {
  Root both{id, a.parts, a.points};
  both.parts.insert(both.parts.end(), b.parts.begin(), b.parts.end());
  both.points.insert(both.points.end(), b.points.begin(), b.points.end());
  std::sort(both.parts.begin(), both.parts.end());
  return both;
}

// Of all pairs in which one is among the eight nearest of the other, the one of least common hull,
// all looked for anew at each step.
std::set<Nodes> greedy_by_definition(const std::vector<NamedPart>& parts) {
  std::vector<Root> roots;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    roots.push_back({k, {k}, points_in(parts[k].mesh.points)});
  }
  std::set<Nodes> made;
  for (std::size_t id = parts.size(); roots.size() > 1; ++id) {
    std::optional<std::pair<Rational, Join>> best;
    for (std::size_t i = 0; i < roots.size(); ++i) {
      std::vector<std::pair<Rational, std::size_t>> near;
      for (std::size_t k = 0; k < roots.size(); ++k) {
        if (k != i) near.emplace_back(common_box(roots[i], roots[k]), k);
      }
      std::sort(near.begin(), near.end());
      near.resize(std::min<std::size_t>(near.size(), 8));
      for (const auto& [box, k] : near) {
        const PointSet points(joined_root(roots[i], roots[k], id).points);
        const Join pair = std::minmax({i, k});
        std::pair<Rational, Join> found(volume(*convex_part(points).solid), pair);
        if (!best || found < *best) best = std::move(found);
      }
    }
    const auto [i, k] = best->second;
    Root both = joined_root(roots[i], roots[k], id);
    made.insert(both.parts);
    roots.erase(roots.begin() + std::ptrdiff_t(k));
    roots.erase(roots.begin() + std::ptrdiff_t(i));
    roots.push_back(std::move(both));  // ascending by id, as positions are
  }
  return made;
}

}  // namespace

TEST_CASE("build_tree: the greedy choice is that of its definition" * sweep) {
  std::mt19937_64 random(11);
  for (int run = 0; run < 6; ++run) {
    std::vector<Box> boxes(16);
    for (Box& box : boxes) {
      for (int k = 0; k < 3; ++k) {
        box.low[k] = double(random() % 20);
        box.high[k] = box.low[k] + 1 + double(random() % 3);
      }
    }
    const auto parts = parts_of_boxes(boxes);
    CHECK(parts_below(build_tree(parts, {}).tree) == greedy_by_definition(parts));
  }
}

TEST_CASE("build_tree: the greedy choice is that of its definition, also in flat layers") {
  // More than nine parts, so that not all are neighbours; flat along each axis in turn, so that
  // each term of the surface of a common box decides.
  std::mt19937_64 random(9);
  for (int run = 0; run < 9; ++run) {
    std::vector<Box> boxes(12);
    for (Box& box : boxes) {
      for (int k = 0; k < 3; ++k) {
        box.low[k] = k == run % 3 ? 0 : double(random() % 30);
        box.high[k] = box.low[k] + 1;
      }
    }
    const auto parts = parts_of_boxes(boxes);
    CAPTURE(run);
    CHECK(parts_below(build_tree(parts, {}).tree) == greedy_by_definition(parts));
  }
  const char* folder = std::getenv("CONVEXACT_TEST_DATA");
  REQUIRE(folder != nullptr);
  std::vector<NamedPart> parts;
  const Mesh mesh = read_mesh(std::string(folder) + "/faults/m9c.obj");
  for (const SceneObject& object : parts_of(mesh, "m9c.obj")) {
    parts.push_back({object.part, {std::get<PointSet>(object.shape), object.polygons, {}}});
  }
  const std::set<Nodes> below = parts_below(build_tree(parts, {}).tree);
  CHECK(below.contains(Nodes{0, 9}));
  CHECK(below == greedy_by_definition(parts));
}

// ---- What can be wrong

namespace {

struct Damage {
  const char* what;
  void (*apply)(HullTree&);
  const char* sentence;  // how the fault's begins
  Nodes nodes;
  std::optional<std::size_t> part;
};

}  // namespace

TEST_CASE("find_tree_fault: each kind of damage, and which node or part it names") {
  // 0 over 1 and 2; each of these over two of the leaves 3 to 6, parts 0 to 3.
  const std::vector<Join> joins = {{0, 1}, {2, 3}};
  const HullTree good =
      build_tree(parts_of_boxes({at_x(0), at_x(2), at_x(4), at_x(6)}), joins).tree;
  REQUIRE(good.nodes.size() == 7);
  REQUIRE(good.nodes[1].children == Nodes{3, 4});
  CHECK_FALSE(find_tree_fault(good));
  const Damage damages[] = {
      {"empty", [](HullTree& t) { t.nodes.clear(); }, "there is no node", {}, {}},
      {"parent",
       [](HullTree& t) { t.nodes[3].parent = 7; },
       "node 3 names 7 as its parent",
       {3},
       {}},
      {"child",
       [](HullTree& t) { t.nodes[2].children[0] = 99; },
       "node 2 names 99 as a child",
       {2},
       {}},
      {"part", [](HullTree& t) { t.nodes[4].part = 4; }, "node 4 names part 4", {4}, 4},
      {"two roots",
       [](HullTree& t) { t.nodes[2].parent = {}; },
       "nodes 0, 2 have no parent",
       {0, 2},
       {}},
      {"no root",
       [](HullTree& t) {
         t.nodes[0].parent = 1;
         t.nodes[1].children.push_back(0);
       },
       "no node is the root",
       {0, 1},
       {}},
      {"twice",
       [](HullTree& t) {
         t.nodes[1].children = {3, 3};
       },
       "node 1 names child 3 twice",
       {1, 3},
       {}},
      {"not mutual",
       [](HullTree& t) { t.nodes[3].parent = 2; },
       "node 1 names node 3 as a child",
       {1, 3},
       {}},
      {"forgotten",
       [](HullTree& t) { t.nodes[1].children = {3}; },
       "node 4 names node 1 as its parent",
       {1, 4},
       {}},
      {"cycle",
       [](HullTree& t) {
         t.nodes[0].children = {2};
         t.nodes[1].parent = 3;
         t.nodes[3].children = {1};
       },
       "nodes 1, 3 form a cycle",
       {1, 3},
       {}},
      {"branch with a part",
       [](HullTree& t) { t.nodes[1].part = 0; },
       "node 1 names part 0, but it has children",
       {1},
       0},
      {"childless",
       [](HullTree& t) { t.nodes[3].part = {}; },
       "node 3 has neither children nor a part",
       {3},
       {}},
      {"part twice",
       [](HullTree& t) { t.nodes[4].part = 0; },
       "nodes 3 and 4 are both the leaf of part 0",
       {3, 4},
       0},
      {"part missing",
       [](HullTree& t) { t.parts.push_back(t.parts[0]); },
       "part 4 ('box_0') is missing",
       {},
       4},
      {"escape",
       [](HullTree& t) {
         std::vector<Point> points(t.nodes[1].mesh.points.doubles().begin(),
                                   t.nodes[1].mesh.points.doubles().end());
         // By one unit in the last place, at a corner that a child has, too.
         for (Point& p : points) {
           if (p == Point(0, 1, 1)) p.y() = std::nextafter(1.0, 0.0);
         }
         t.nodes[1].mesh.points = PointSet(points);
       },
       "node 1 does not hold its child 3: ",
       {1, 3},
       0},
  };
  for (const Damage& damage : damages) {
    CAPTURE(damage.what);
    HullTree tree = good;
    damage.apply(tree);
    const auto fault = find_tree_fault(tree);
    REQUIRE(fault);
    CHECK_MESSAGE(fault->sentence.starts_with(damage.sentence), fault->sentence);
    CHECK(fault->nodes == damage.nodes);
    CHECK(fault->part == damage.part);
    const Error error = error_of([&] { return SearchTree(tree); });
    CHECK(error.code() == ErrorCode::Malformed);
    CHECK(std::string(error.what()).find(fault->sentence) != std::string::npos);
  }
}

TEST_CASE("find_tree_fault: the witness of a point outside") {
  HullTree tree = build_tree(parts_of_boxes({at_x(0), at_x(2)}), {}).tree;
  tree.nodes[0].mesh = box_mesh({{0, 0, 0}, {2.5, 1, 1}});
  const auto fault = find_tree_fault(tree);
  REQUIRE(fault);
  REQUIRE(fault->point);
  REQUIRE(fault->plane);
  const RationalPoint x = tree.parts[1].mesh.points[PointId(*fault->point)];
  CHECK(x.x() == 3);
  CHECK((*fault->plane)(x) > 0);
  CHECK((*fault->plane)(RationalPoint(Rational(5, 2), 0, 0)) == 0);
}
