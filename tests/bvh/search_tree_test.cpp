// SPDX-License-Identifier: MIT
// Questions to trees: pruned answers are those of asking every part, and a claim that leaves out or
// changes something is refused.
#include <doctest/doctest.h>

#include <cstdlib>
#include <random>
#include <string>

#include "assembled_meshes.hpp"
#include "cells.hpp"
#include "convexact/hull_tree.hpp"
#include "expect_error.hpp"
#include "sweep.hpp"

using namespace convexact;
using namespace support;

namespace {

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random_(seed) {}
  // 0, 1/4, ..., `most`, so that touching is frequent.
  double quarter(int most) { return double(random_() % std::uint64_t(4 * most + 1)) / 4; }
  // Of integers, so that faces of several boxes often lie in one plane.
  Box box(std::uint64_t within, std::uint64_t size) {
    Box made;
    for (int k = 0; k < 3; ++k) {
      made.low[k] = double(random_() % within);
      made.high[k] = made.low[k] + 1 + double(random_() % size);
    }
    return made;
  }
  // Every other one is parallel to an axis.
  Ray ray(int within) {
    Point from(quarter(within), quarter(within), quarter(within)), to = from;
    const auto axis = random_() % 6;
    if (axis < 3) {
      from[Eigen::Index(axis)] = -1;
      to[Eigen::Index(axis)] = 1;
    } else {
      to = Point(quarter(within), quarter(within), quarter(within)) + Point(0.125, 0, 0);
    }
    return {to_rational(from), to_rational(Point(to - from))};
  }

 private:
  std::mt19937_64 random_;
};

Polytope solid_of(const Mesh& mesh) { return *convex_part(mesh.points).solid; }

struct Scene {
  HullTree tree;
  std::vector<Polytope> parts;
};

Scene random_scene(std::uint64_t seed, std::optional<std::size_t> faces) {
  Draw draw(seed);
  std::vector<Box> boxes;
  for (int k = 0; k < 12; ++k) boxes.push_back(draw.box(8, 3));
  Scene scene{build_tree(parts_of_boxes(boxes), {}, {.faces = faces}).tree, {}};
  for (const NamedPart& part : scene.tree.parts) scene.parts.push_back(solid_of(part.mesh));
  return scene;
}

// CONVEXACT_TREE_SCENES=500 for 200,000 rays and 100,000 boxes.
std::uint64_t scenes() {
  const char* wanted = std::getenv("CONVEXACT_TREE_SCENES");
  return wanted == nullptr ? 4 : std::stoul(wanted);
}

constexpr int kQueries = 200;  // of each scene

}  // namespace

TEST_CASE("cast_ray: the first hit of a tree is the first of all parts") {
  std::size_t ties = 0;
  for (const std::optional<std::size_t> faces : {std::optional<std::size_t>(), {5}}) {
    for (std::uint64_t seed = 1; seed <= scenes(); ++seed) {
      const Scene scene = random_scene(seed, faces);
      const SearchTree tree(scene.tree);
      Draw draw(100 + seed);
      std::size_t hits = 0, visited = 0;
      for (int i = 0; i < kQueries; ++i) {
        const Ray ray = draw.ray(10);
        std::optional<Rational> first;
        std::vector<std::size_t> parts;
        for (std::size_t k = 0; k < scene.parts.size(); ++k) {
          const RayAnswer met = cast_ray(scene.parts[k], ray);
          if (!met.is_hit() || (first && met.first() > *first)) continue;
          if (!first || met.first() < *first) parts.clear();
          first = met.first();
          parts.push_back(k);
        }
        const TreeRayAnswer answer = cast_ray(tree, ray);
        CHECK(answer.first == first);
        CHECK(answer.parts == parts);
        CHECK(check(tree, ray, answer));
        hits += first ? 1 : 0;
        ties += parts.size() > 1 ? 1 : 0;
        visited += answer.visited.size();
      }
      CHECK(hits > 30);
      CHECK(visited < kQueries * tree.nodes().size());  // something was pruned
    }
  }
  CHECK(ties > 0);
}

TEST_CASE("find_overlap: the parts of a tree that overlap are those that do alone" * sweep) {
  for (std::uint64_t seed = 1; seed <= scenes(); ++seed) {
    const Scene scene = random_scene(seed, {});
    const SearchTree tree(scene.tree);
    Draw draw(200 + seed);
    std::size_t visited = 0, found = 0;
    for (int i = 0; i < kQueries; ++i) {
      const Polytope solid = solid_of(box_mesh(draw.box(10, 1)));
      std::vector<std::size_t> parts;
      for (std::size_t k = 0; k < scene.parts.size(); ++k) {
        if (std::holds_alternative<CommonPoint>(find_overlap(scene.parts[k], solid))) {
          parts.push_back(k);
        }
      }
      const TreeOverlap answer = find_overlap(tree, solid);
      CHECK(answer.parts == parts);
      CHECK(check(tree, solid, answer));
      visited += answer.visited.size();
      found += parts.size();
    }
    CHECK(found > 0);
    CHECK(visited < kQueries * tree.nodes().size());
  }
}

TEST_CASE("check: a claim of a tree that is not true, or not proven, is refused") {
  const HullTree built =
      build_tree(parts_of_boxes({box_of({0, 0, 0}), box_of({2, 0, 0}), box_of({9, 0, 0})}), {})
          .tree;
  const SearchTree tree(built);
  const Ray along{RationalPoint(-1, Rational(1, 2), Rational(1, 2)), RationalVector3(1, 0, 0)};
  const TreeRayAnswer answer = cast_ray(tree, along);
  REQUIRE(answer.first == Rational(1));
  REQUIRE(answer.parts == std::vector<std::size_t>{0});
  REQUIRE(check(tree, along, answer));
  CHECK(answer.visited.size() == 5);  // both children of each branch that the ray meets first
  for (std::size_t i = 0; i < answer.visited.size(); ++i) {
    // A node that was not visited, or twice, or whose answer is another node's.
    TreeRayAnswer claim = answer;
    claim.visited.erase(claim.visited.begin() + std::ptrdiff_t(i));
    const std::size_t node = answer.visited[i].first;
    CHECK_FALSE(check(tree, along, claim));
    claim = answer;
    claim.visited.push_back(claim.visited[i]);
    CHECK_FALSE(check(tree, along, claim));
    claim = answer;
    claim.visited[i].second = answer.visited[(i + 1) % answer.visited.size()].second;
    const bool is_equal = tree.nodes()[node].hull.planes ==
                          tree.nodes()[answer.visited[(i + 1) % 5].first].hull.planes;
    CHECK((is_equal || !check(tree, along, claim)));
  }
  const auto refused = [&](auto change) {
    TreeRayAnswer claim = answer;
    change(claim);
    CHECK_FALSE(check(tree, along, claim));
  };
  refused([](TreeRayAnswer& c) { c.first = Rational(3); });
  refused([](TreeRayAnswer& c) { c.first = Rational(1, 2); });
  refused([](TreeRayAnswer& c) { c.first.reset(); });
  refused([](TreeRayAnswer& c) { c.parts = {0, 1}; });
  refused([](TreeRayAnswer& c) { c.parts = {1}; });
  refused([](TreeRayAnswer& c) { c.parts.clear(); });
  refused([](TreeRayAnswer& c) {
    c.first.reset();
    c.parts.clear();
  });
  refused([](TreeRayAnswer& c) {
    c.first = Rational(3);
    c.parts = {1};
  });
  refused([](TreeRayAnswer& c) {
    c.first = Rational(3);  // where the ray meets part 1, and part 0 before
    c.parts = {0, 1};
  });
  refused([](TreeRayAnswer& c) { c.visited[0].first = 77; });
  // A first hit before every hull is a hit of nothing.
  refused([](TreeRayAnswer& c) {
    c.first = Rational(1, 2);
    c.parts.clear();
  });
  refused([&](TreeRayAnswer& c) {
    c.first = Rational(1, 2);
    c.parts.clear();
    c.visited.resize(1);
  });
  const HullTree one = build_tree(parts_of_boxes({{{-1, -1, -1}, {1, 1, 1}}}), {}).tree;
  const SearchTree alone(one);
  const Ray from_left{{-3, 0, 0}, {1, 0, 0}};
  TreeRayAnswer hit = cast_ray(alone, from_left);
  REQUIRE(hit.first == Rational(2));
  hit.first = Rational(1);
  hit.parts.clear();
  CHECK_FALSE(check(alone, from_left, hit));

  const Polytope beside = solid_of(box_mesh({{1.5, 0, 0}, {2.5, 1, 1}}));
  const TreeOverlap met = find_overlap(tree, beside);
  REQUIRE(met.parts == std::vector<std::size_t>{1});
  REQUIRE(check(tree, beside, met));
  for (std::size_t i = 0; i < met.visited.size(); ++i) {
    TreeOverlap claim = met;
    claim.visited.erase(claim.visited.begin() + std::ptrdiff_t(i));
    CHECK_FALSE(check(tree, beside, claim));
  }
  TreeOverlap claim = met;
  claim.parts = {};
  CHECK_FALSE(check(tree, beside, claim));
  claim.parts = {0, 1};
  CHECK_FALSE(check(tree, beside, claim));
  // The root as apart, by what separates another hull.
  const Overlap apart = find_overlap(solid_of(box_mesh(box_of({0, 9, 0}))), beside);
  REQUIRE(std::holds_alternative<Separation>(apart));
  claim.parts = {};
  claim.visited = {{tree.root(), apart}};
  CHECK_FALSE(check(tree, beside, claim));
}

TEST_CASE("SearchTree: a flat part is refused by its name; a ray without direction, too") {
  HullTree flat;
  flat.parts.push_back({"sheet", mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}})});
  flat.nodes.push_back({{}, {}, 0, {}});
  CHECK_FALSE(find_tree_fault(flat));
  const Error error = error_of([&] { return SearchTree(flat); });
  CHECK(error.code() == ErrorCode::NoInterior);
  CHECK(std::string(error.what()).find("'sheet'") != std::string::npos);
  const SearchTree one(build_tree(parts_of_boxes({box_of({0, 0, 0})}), {}).tree);
  CHECK(error_of([&] {
          return cast_ray(one, Ray{{0, 0, 0}, {0, 0, 0}});
        }).code() == ErrorCode::InvalidArgument);
}
