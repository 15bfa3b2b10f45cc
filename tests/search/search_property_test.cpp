// SPDX-License-Identifier: MIT
// Searches against the definition and against each other, over families of shapes: few halfspaces
// with many ties, and some without.
#include <doctest/doctest.h>

#include <string>

#include "definitional_search.hpp"
#include "searched.hpp"
#include "shapes/makers.hpp"

using namespace convexact;

namespace {

struct NamedPoints {
  std::string name;
  std::vector<Point> points;
};

std::vector<NamedPoints> small_shapes() {
  std::vector<NamedPoints> list = {{"octahedron", shapes::octahedron()},
                                   {"icosahedron", shapes::icosahedron()},
                                   {"chamfered box", shapes::chamfered_box({1, 2, 3}, 0.25)},
                                   {"cut cube", shapes::cut_cube(8, 0.25)},
                                   {"antiprism", shapes::antiprism(6)},
                                   {"bipyramid", shapes::bipyramid(7)}};
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    list.push_back({"lattice " + std::to_string(seed), shapes::lattice(12, 3, seed)});
    list.push_back({"ball " + std::to_string(seed), shapes::in_ball(11, seed)});
    list.push_back({"symmetric " + std::to_string(seed), shapes::centrally_symmetric(5, seed)});
  }
  return list;
}

template <class Visit>
void for_each_start(Visit&& visit) {
  for (const NamedPoints& shape : small_shapes()) {
    CAPTURE(shape.name);
    for (const CostMeasure measure : kMeasures) {
      CAPTURE(static_cast<int>(measure));
      for (const std::size_t faces : {4u, 5u, 6u, 8u}) {
        CAPTURE(faces);
        visit(Greedy(shape.points, faces, measure), measure);
      }
    }
  }
}

}  // namespace

TEST_CASE("search: a walk makes the exchanges of the definition, in both engines") {
  std::size_t moves = 0;
  for_each_start([&](const Greedy& greedy, CostMeasure measure) {
    const definition::HalfspaceArrangement arrangement(greedy.dual.halfspaces);
    const auto expected =
        definition::walk_by_definition(arrangement, definition::facets_next_to(greedy.input),
                                       definition::subset_of(greedy.left), measure);
    for (const Engine engine : {Engine::Exact, Engine::Filtered}) {
      const SearchRun found = greedy.search({.engine = engine, .cost = measure});
      REQUIRE(found.moves.size() == expected.size());
      for (std::size_t k = 0; k < expected.size(); ++k) {
        REQUIRE(found.moves[k].removed == expected[k].removed);
        REQUIRE(found.moves[k].inserted == expected[k].inserted);
      }
    }
    moves += expected.size();
  });
  CHECK(moves > 100);
  MESSAGE(moves << " exchanges");
}

TEST_CASE("search: kicks lead both engines the same way, and every move shrinks the solid") {
  std::size_t moves = 0, kicks = 0;
  for_each_start([&](const Greedy& greedy, CostMeasure measure) {
    SearchOptions options{.request = {SearchKind::Local, 25}, .cost = measure, .seed = 7};
    const SearchRun filtered = greedy.search(options);
    options.engine = Engine::Exact;
    REQUIRE(same_moves(greedy.search(options), filtered));
    const definition::HalfspaceArrangement arrangement(greedy.dual.halfspaces);
    definition::Subset kept = definition::subset_of(greedy.left);
    Cost before = arrangement.measure(kept, measure).value();
    for (const Move& move : filtered.moves) {
      const auto removed = definition::subset_of(move.removed);
      const auto inserted = definition::subset_of(move.inserted);
      REQUIRE(move.removed.size() == move.inserted.size());
      REQUIRE((removed & ~kept) == 0);
      REQUIRE((inserted & kept) == 0);
      kept = (kept & ~removed) | inserted;
      const std::optional<Cost> after = arrangement.measure(kept, measure);
      REQUIRE(after.has_value());
      REQUIRE(compare(*after, before).order == Order::Less);
      before = *after;
      kicks += move.removed.size() > 1;
    }
    moves += filtered.moves.size();
  });
  CHECK(moves > 100);
  CHECK(kicks > 10);
  MESSAGE(moves << " moves, " << kicks << " of several halfspaces");
}

// Its doubles are not quite regular, so that regular tetrahedra differ in the last bits.
TEST_CASE("search: no four planes of an icosahedron bound less than what is found") {
  const Greedy greedy(shapes::icosahedron(), 4, CostMeasure::Volume);
  const definition::HalfspaceArrangement arrangement(greedy.dual.halfspaces);
  definition::Subset found = definition::subset_of(greedy.left);
  for (const Move& move : greedy.search({.request = {SearchKind::Local, 200}}).moves) {
    found = (found & ~definition::subset_of(move.removed)) | definition::subset_of(move.inserted);
  }
  const Rational nearly = arrangement.volume(found).value() * Rational(999999999, 1000000000);
  std::size_t bounded = 0;
  for (definition::Subset four = 15; four < arrangement.all();) {
    if (const std::optional<Rational> volume = arrangement.volume(four)) {
      ++bounded;
      REQUIRE(*volume >= nearly);
    }
    // The next number with as many bits.
    const definition::Subset low = four & -four, up = four + low;
    four = up | ((four ^ up) / low >> 2);
  }
  CHECK(bounded > 100);
}
