// SPDX-License-Identifier: MIT
// Thousands of decompositions of shapes of unit cells, each broken in some way. The verdict must be
// the one that counting gives: all boxes have coordinates in quarters, so that a small cube of the
// grid of quarters lies wholly in a box or has no interior point in it, and likewise a small square
// of the surface. Shapes and boxes are also sheared together, which changes no answer.
#include <doctest/doctest.h>

#include <cstdlib>

#include "cells.hpp"
#include "convexact/verify_parts.hpp"
#include "number/random.hpp"

using namespace convexact;
using namespace support;
using enum ClaimCode;

namespace {

constexpr int kFine = 4;  // small cubes along a cell

// In quarters.
struct FineBox {
  std::array<int, 3> low, high;

  bool is_solid() const { return low[0] < high[0] && low[1] < high[1] && low[2] < high[2]; }
  bool holds(const std::array<double, 3>& x) const {
    for (int k = 0; k < 3; ++k) {
      if (x[k] < low[k] || high[k] < x[k]) return false;
    }
    return true;
  }
  bool holds(const FineBox& other) const {
    for (int k = 0; k < 3; ++k) {
      if (other.low[k] < low[k] || high[k] < other.high[k]) return false;
    }
    return true;
  }
};

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

bool in_some(const std::vector<FineBox>& boxes, const std::array<double, 3>& x) {
  return std::any_of(boxes.begin(), boxes.end(), [&](const FineBox& b) { return b.holds(x); });
}

struct Expected {
  bool points = true, surface = true, solid = true, disjoint = true, needed = true;
};

// By counting.
Expected counted(const std::set<Cell>& cells, const std::vector<FineBox>& boxes) {
  Expected expected;
  for (const Cell& c : cells) {
    const std::array<double, 3> at{c[0] * 4.0, c[1] * 4.0, c[2] * 4.0};
    for (int i = 0; i < kFine * kFine * kFine; ++i) {
      const std::array<double, 3> middle{at[0] + i % 4 + 0.5, at[1] + i / 4 % 4 + 0.5,
                                         at[2] + i / 16 + 0.5};
      expected.solid = expected.solid && in_some(boxes, middle);
    }
    for (int face = 0; face < 6; ++face) {
      const int axis = face / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
      Cell beside = c;
      beside[axis] += face % 2 == 0 ? -1 : 1;
      if (cells.contains(beside)) continue;
      for (int i = 0; i < kFine * kFine; ++i) {
        std::array<double, 3> middle = at;
        middle[axis] += face % 2 == 0 ? 0 : kFine;
        middle[u] += i % 4 + 0.5;
        middle[v] += i / 4 + 0.5;
        expected.surface = expected.surface && in_some(boxes, middle);
      }
      for (int corner = 0; corner < 4; ++corner) {
        std::array<double, 3> point = at;
        point[axis] += face % 2 == 0 ? 0 : kFine;
        point[u] += corner % 2 * kFine;
        point[v] += corner / 2 * kFine;
        expected.points = expected.points && in_some(boxes, point);
      }
    }
  }
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      if (i == k) continue;
      FineBox common;
      for (int axis = 0; axis < 3; ++axis) {
        common.low[axis] = std::max(boxes[i].low[axis], boxes[k].low[axis]);
        common.high[axis] = std::min(boxes[i].high[axis], boxes[k].high[axis]);
      }
      expected.disjoint = expected.disjoint && !common.is_solid();
      expected.needed = expected.needed && !boxes[k].holds(boxes[i]);
    }
  }
  return expected;
}

// Integers with determinant 1.
Mesh sheared(Mesh mesh, int how) {
  std::vector<Point> points;
  for (const Point& p : mesh.points.doubles()) {
    const double x = p[0] + (how & 1 ? 2 * p[1] : 0), y = p[1] + (how & 2 ? 3 * p[2] : 0);
    points.emplace_back(x, y, p[2] + (how & 4 ? x - y : 0));
  }
  mesh.points = PointSet(points);
  return mesh;
}

std::vector<NamedPart> parts_of(const std::vector<FineBox>& boxes, int how) {
  std::vector<NamedPart> parts;
  for (const FineBox& b : boxes) {
    const Box box{{b.low[0] / 4.0, b.low[1] / 4.0, b.low[2] / 4.0},
                  {b.high[0] / 4.0, b.high[1] / 4.0, b.high[2] / 4.0}};
    parts.push_back({"", sheared(box_mesh(box), how)});
  }
  return parts;
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
  request.measures = seed % 8 == 0;
  request.exact_volumes = true;
  const Mesh mesh = sheared(mesh_of_cells(cells), how);
  const PartsVerdict verdict = verify_parts(mesh, parts_of(boxes, how), request);
  const Expected expected = counted(cells, boxes);
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
  if (!request.measures) return;
  FineBox all = boxes.front();
  for (const FineBox& box : boxes) {
    for (int k = 0; k < 3; ++k) {
      all.low[k] = std::min(all.low[k], box.low[k]);
      all.high[k] = std::max(all.high[k], box.high[k]);
    }
  }
  const auto cell = [](int q) { return q >= 0 ? q / kFine : -((kFine - 1 - q) / kFine); };
  std::size_t in_union = 0, covered = 0;
  for (int x = all.low[0]; x < all.high[0]; ++x) {
    for (int y = all.low[1]; y < all.high[1]; ++y) {
      for (int z = all.low[2]; z < all.high[2]; ++z) {
        if (!in_some(boxes, {x + 0.5, y + 0.5, z + 0.5})) continue;
        ++in_union;
        covered += cells.contains({cell(x), cell(y), cell(z)}) ? 1 : 0;
      }
    }
  }
  const PartsMeasures& m = *verdict.measures;
  CHECK(m.solid_volume->exact == Rational(cells.size()));
  CHECK(m.union_volume.exact == Rational(in_union, 64));
  CHECK(m.uncovered_volume->exact == Rational(Rational(cells.size()) - Rational(covered, 64)));
  CHECK(m.excess_volume->exact == Rational(in_union - covered, 64));
}

}  // namespace

TEST_CASE("verify_parts: corrupted decompositions") {
  const char* stride = std::getenv("CONVEXACT_STRIDE");
  const std::size_t step = stride != nullptr ? std::stoul(stride) : 1;
  for (std::size_t seed = 0; seed < 10000; seed += step) check_case(seed);
}
