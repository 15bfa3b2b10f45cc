// SPDX-License-Identifier: MIT
// Solids to which ties lead: a cube whose eight corners are cut alike, where each cut removed costs
// the same as long as cuts do not meet, and each side costs more than all cuts.
#include "conform/tied_removals.hpp"

#include <doctest/doctest.h>

#include <atomic>

#include "expect_error.hpp"
#include "shapes/makers.hpp"

using namespace convexact;
using namespace convexact::oracle;

namespace {

constexpr std::size_t kMany = 10000;

struct CutCube {
  CutCube() {
    std::vector<Halfspace> planes;
    for (int axis = 0; axis < 3; ++axis) {
      for (const int side : {1, -1}) {
        IntegerVector3 n = IntegerVector3::Zero();
        n[axis] = side;
        sides.emplace_back(n, Integer(-4));
      }
    }
    for (int corner = 0; corner < 8; ++corner) {
      const IntegerVector3 n(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
      cuts.emplace_back(n, Integer(-11));  // one of 12 is cut off
    }
    planes = sides;
    planes.insert(planes.end(), cuts.begin(), cuts.end());
    StageLog log;
    solid = std::get<Solid>(make_solid(Shape(planes), {}, log));
  }

  ByTies leads(const std::vector<Halfspace>& to, std::size_t most_states = kMany) const {
    return do_ties_lead(solid, to, most_states, nullptr);
  }
  // All sides, and some of the cuts.
  std::vector<Halfspace> with_cuts(std::initializer_list<std::size_t> kept) const {
    std::vector<Halfspace> planes = sides;
    for (const std::size_t k : kept) planes.push_back(cuts[k]);
    return planes;
  }

  std::vector<Halfspace> sides, cuts;
  Solid solid;
};

}  // namespace

TEST_CASE("ties: any of the cut corners may be left, and the whole is where they begin") {
  const CutCube cube;
  CHECK(cube.leads(cube.with_cuts({0, 1, 2, 3, 4, 5, 6, 7})) == ByTies::Lead);
  CHECK(cube.leads(cube.with_cuts({})) == ByTies::Lead);
  CHECK(cube.leads(cube.with_cuts({5})) == ByTies::Lead);
  CHECK(cube.leads(cube.with_cuts({0, 3, 6})) == ByTies::Lead);
}

TEST_CASE("ties: no side goes while a cut is left, and other planes were never there") {
  const CutCube cube;
  std::vector<Halfspace> planes = cube.with_cuts({2});
  planes.erase(planes.begin());
  CHECK(cube.leads(planes) == ByTies::DoNotLead);
  planes = cube.with_cuts({});
  planes[0] = Halfspace(IntegerVector3(1, 0, 0), Integer(-5));
  CHECK(cube.leads(planes) == ByTies::DoNotLead);
}

TEST_CASE("ties: beyond so many solids it is undecided, and the watch ends the search") {
  const CutCube cube;
  // From 14 to 6 facets there are eight solids on the way.
  CHECK(cube.leads(cube.with_cuts({}), 8) == ByTies::Lead);
  CHECK(cube.leads(cube.with_cuts({}), 7) == ByTies::Undecided);
  // A side must go before the last cut: all 255 sets of other cuts are met first, none leads there.
  std::vector<Halfspace> planes = cube.with_cuts({0});
  planes.erase(planes.begin());
  CHECK(cube.leads(planes, 127) == ByTies::Undecided);
  CHECK(cube.leads(planes, 128) == ByTies::DoNotLead);
  const std::atomic<bool> stop = true;
  const Error error = error_of([&] { return do_ties_lead(cube.solid, cube.sides, kMany, &stop); });
  CHECK(error.code() == ErrorCode::Stopped);
}
