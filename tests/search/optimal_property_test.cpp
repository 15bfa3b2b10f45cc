// SPDX-License-Identifier: MIT
// The least volume of families of shapes: every number of halfspaces.
#include <doctest/doctest.h>

#include <string>

#include "convexact/measure.hpp"
#include "convexact/search.hpp"
#include "least_volume.hpp"
#include "searched.hpp"
#include "shapes/makers.hpp"

using namespace convexact;

namespace {

struct Sample {
  std::string name;
  std::vector<Point> points;
};

std::vector<Sample> samples() {
  std::vector<Sample> list = {{"prism", shapes::prism(14)},
                              {"antiprism", shapes::antiprism(7)},
                              {"bipyramid", shapes::bipyramid(7)},
                              {"chamfered box", shapes::chamfered_box({1, 1, 1}, 0.25)},
                              {"icosahedron", shapes::icosahedron()},
                              {"dodecahedron", shapes::dodecahedron()}};
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    list.push_back({"sphere", shapes::on_sphere(14, seed)});
    list.push_back({"ball", shapes::in_ball(20, seed)});
    list.push_back({"lattice", shapes::lattice(20, 9, seed)});
    list.push_back({"symmetric", shapes::centrally_symmetric(6, seed)});
  }
  return list;
}

}  // namespace

TEST_CASE("optimal: proven for every number of halfspaces, and never above a local search") {
  std::size_t cases = 0, better = 0, nodes = 0;
  for (const Sample& sample : samples()) {
    CAPTURE(sample.name);
    const std::size_t most = Greedy(sample.points, 4, CostMeasure::Volume).dual.halfspaces.size();
    Rational fewer;  // the least volume of one halfspace less
    for (std::size_t faces = 4; faces < most; ++faces) {
      CAPTURE(faces);
      const Greedy greedy(sample.points, faces, CostMeasure::Volume);
      if (greedy.left.size() > faces) continue;
      const SearchRun local = greedy.search({.request = {SearchKind::Local, 20}});
      const SearchRun run = find_optimum(greedy, {.request = {SearchKind::Optimal, 20}});
      REQUIRE(run.optimality->is_proven);
      const definition::HalfspaceArrangement arrangement(greedy.dual.halfspaces);
      const Rational volume = arrangement.volume(definition::left_by(run, greedy.left)).value();
      CHECK(volume == run.optimality->lower_bound);
      CHECK(volume <= arrangement.volume(definition::left_by(local, greedy.left)).value());
      // More halfspaces can cut off more.
      if (fewer != 0) CHECK(volume < fewer);
      fewer = volume;
      ++cases;
      better += run.moves.size() > local.moves.size();
      nodes += run.optimality->nodes;
    }
  }
  CHECK(cases > 100);
  CHECK(better > 0);
  MESSAGE(cases << " cases, " << better << " better than local search, " << nodes << " states");
}

// A shear by quarters moves these corners without rounding and keeps every volume, but none of the
// symmetries except the point reflection.
TEST_CASE("optimal: symmetries save states, and change no volume") {
  std::size_t symmetric = 0, sheared = 0;
  for (const std::vector<Point>& points :
       {shapes::octahedron(), shapes::dodecahedron(), shapes::cut_cube(8, 0.25),
        shapes::chamfered_box({1, 1, 1}, 0.25), shapes::chamfered_box({1, 1, 2}, 0.25)}) {
    std::vector<Point> moved = points;
    for (Point& p : moved) p = {p[0] + p[1] / 4 + p[2] / 2, p[1] + p[2] / 4, p[2]};
    const std::size_t most = Greedy(points, 4, CostMeasure::Volume).dual.halfspaces.size();
    for (std::size_t faces = 4; faces < most; ++faces) {
      CAPTURE(most);
      CAPTURE(faces);
      const Greedy here(points, faces, CostMeasure::Volume);
      const Greedy there(moved, faces, CostMeasure::Volume);
      if (here.left.size() != there.left.size()) continue;  // greedy ends at one of several ties
      const Optimality a = *find_optimum(here, {.request = {SearchKind::Optimal, 5}}).optimality;
      const Optimality b = *find_optimum(there, {.request = {SearchKind::Optimal, 5}}).optimality;
      REQUIRE(a.is_proven);
      REQUIRE(b.is_proven);
      CHECK(a.lower_bound == b.lower_bound);
      symmetric += a.nodes;
      sheared += b.nodes;
    }
  }
  CHECK(2 * symmetric < sheared);
  MESSAGE(symmetric << " states, " << sheared << " without symmetries");
}

TEST_CASE("optimal: both engines find the same planes, and the definition no smaller volume") {
  for (const std::vector<Point>& points : {shapes::in_ball(8, 3), shapes::dodecahedron(),
                                           shapes::prism(10), shapes::lattice(10, 5, 4)}) {
    const std::size_t most = Greedy(points, 4, CostMeasure::Volume).dual.halfspaces.size();
    REQUIRE(most <= 14);
    for (std::size_t faces = 4; faces < most; faces += 2) {
      CAPTURE(faces);
      const Greedy greedy(points, faces, CostMeasure::Volume);
      const definition::HalfspaceArrangement arrangement(greedy.dual.halfspaces);
      SearchOptions options{.request = {SearchKind::Optimal, 0}};
      const SearchRun filtered = find_optimum(greedy, options);
      options.engine = Engine::Exact;
      CHECK(same_moves(filtered, find_optimum(greedy, options)));
      CHECK(filtered.optimality->lower_bound ==
            definition::least_volume(arrangement, greedy.left.size()).volume);
    }
  }
}
