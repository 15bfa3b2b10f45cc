// SPDX-License-Identifier: MIT
// Thousands of decompositions of shapes of unit cells, each broken in some way. The verdict must be
// the one that counting gives (tests/support/fine_boxes.hpp). Shapes and boxes are also sheared
// together, which changes no answer.
#include <doctest/doctest.h>

#include <cstdlib>

#include "convexact/verify_parts.hpp"
#include "fine_boxes.hpp"
#include "number/random.hpp"

using namespace convexact;
using namespace support;
using enum ClaimCode;

namespace {

int below(Random& random, int n) { return static_cast<int>(uniform_below(random, std::size_t(n))); }

std::set<Cell> random_cells(Random& random) {
  std::set<Cell> cells{{0, 0, 0}};
  const int count = 1 + below(random, 7);
  while (static_cast<int>(cells.size()) < count) {
    auto at = cells.begin();
    std::advance(at, below(random, static_cast<int>(cells.size())));
    Cell next = *at;
    next[below(random, 3)] += below(random, 2) * 2 - 1;
    cells.insert(next);
  }
  return cells;
}

// A box for each cell, and some of these joined with a neighbour.
std::vector<FineBox> good_boxes(const std::set<Cell>& cells, Random& random) {
  std::vector<FineBox> boxes;
  for (const Cell& c : cells) {
    FineBox box{{c[0] * kFine, c[1] * kFine, c[2] * kFine}, {}};
    const int axis = below(random, 3);
    Cell next = c;
    ++next[axis];
    const bool joins = below(random, 3) == 0 && cells.contains(next);
    for (int k = 0; k < 3; ++k) box.high[k] = box.low[k] + kFine * (joins && k == axis ? 2 : 1);
    boxes.push_back(box);
  }
  return boxes;
}

// In none, one or several of the ways in which decompositions go wrong; some do no harm.
void corrupt(std::vector<FineBox>& boxes, Random& random) {
  for (int k = below(random, 4); k > 0 && !boxes.empty(); --k) {
    const auto victim = boxes.begin() + below(random, static_cast<int>(boxes.size()));
    const int axis = below(random, 3), by = 1 + below(random, 2);
    switch (below(random, 6)) {
      case 0:
        boxes.erase(victim);
        break;
      case 1:
        victim->low[axis] += by;
        break;
      case 2:
        victim->high[axis] -= by;
        break;
      case 3:
        victim->low[axis] -= by;
        break;
      case 4:
        boxes.push_back(*victim);
        break;
      case 5:  // cut in two, with a gap or without
        boxes.push_back(*victim);
        boxes.back().low[axis] += by;
        boxes[std::size_t(&*victim - boxes.data())].high[axis] -= kFine - by + below(random, 2);
        break;
    }
  }
  std::erase_if(boxes, [](const FineBox& box) { return !box.is_solid(); });
}

void check_case(std::size_t seed) {
  CAPTURE(seed);
  Random random(seed);
  const std::set<Cell> cells = random_cells(random);
  std::vector<FineBox> boxes = good_boxes(cells, random);
  corrupt(boxes, random);
  if (boxes.empty()) return;
  const int how = below(random, 8);
  PartsRequest request;
  request.claims = {CoversPoints, CoversSurface, CoversSolid, PartsDisjoint, PartsNeeded};
  request.measures = seed % 8 == 0 ? PartMeasures::All : PartMeasures::None;
  request.exact_volumes = true;
  const Mesh mesh = sheared(mesh_of_cells(cells), how);
  const PartsVerdict verdict = verify_parts(mesh, parts_of(boxes, how), request);
  const ExpectedCoverage expected = counted(cells, boxes);
  const auto agrees = [&](ClaimCode code, bool holds) {
    const std::string name = name_of(code);
    CAPTURE(name);
    // Cells that touch along an edge or a corner only still close: each directed edge cancels.
    CHECK(verdict[code].status == (holds ? Status::Holds : Status::Violated));
  };
  agrees(CoversPoints, expected.points);
  agrees(CoversSurface, expected.surface);
  agrees(CoversSolid, expected.solid);
  agrees(PartsDisjoint, expected.disjoint);
  agrees(PartsNeeded, expected.needed);
  if (request.measures == PartMeasures::None) return;
  const FineVolumes expected_volumes = volumes(cells, boxes);
  const std::size_t in_union = expected_volumes.in_union, covered = expected_volumes.covered;
  const PartsMeasures& m = *verdict.measures;
  CHECK(m.solid_volume->exact == Rational(cells.size()));
  CHECK(m.union_volume->exact == Rational(in_union, 64));
  CHECK(m.uncovered_volume->exact == Rational(Rational(cells.size()) - Rational(covered, 64)));
  CHECK(m.excess_volume->exact == Rational(in_union - covered, 64));
}

}  // namespace

TEST_CASE("verify_parts: corrupted decompositions") {
  const char* stride = std::getenv("CONVEXACT_STRIDE");
  const std::size_t step = stride != nullptr ? std::stoul(stride) : 1;
  for (std::size_t seed = 0; seed < 10000; seed += step) check_case(seed);
}
