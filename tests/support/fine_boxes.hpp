// SPDX-License-Identifier: MIT
// fine_boxes.hpp - how much of a shape of unit cells a decomposition into boxes covers, by
// counting. All boxes have coordinates in quarters, so a small cube of the grid of quarters lies
// wholly in a box or has no interior point in it, and likewise a small square of the surface.
#pragma once
#include <algorithm>

#include "cells.hpp"

namespace support {

inline constexpr int kFine = 4;  ///< Small cubes along a cell.

/// In quarters.
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

inline bool in_some(const std::vector<FineBox>& boxes, const std::array<double, 3>& x) {
  return std::any_of(boxes.begin(), boxes.end(), [&](const FineBox& b) { return b.holds(x); });
}

/// Which claims hold.
struct ExpectedCoverage {
  bool points = true, surface = true, solid = true, disjoint = true, needed = true;
};

inline ExpectedCoverage counted(const std::set<Cell>& cells, const std::vector<FineBox>& boxes) {
  ExpectedCoverage expected;
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

/// All coordinates, by one of eight linear maps of determinant 1 in integers.
inline Mesh sheared(Mesh mesh, int how) {
  std::vector<Point> points;
  for (const Point& p : mesh.points.doubles()) {
    const double x = p[0] + (how & 1 ? 2 * p[1] : 0), y = p[1] + (how & 2 ? 3 * p[2] : 0);
    points.emplace_back(x, y, p[2] + (how & 4 ? x - y : 0));
  }
  mesh.points = PointSet(points);
  return mesh;
}

inline std::vector<convexact::NamedPart> parts_of(const std::vector<FineBox>& boxes, int how) {
  std::vector<convexact::NamedPart> parts;
  for (const FineBox& b : boxes) {
    const Box box{{b.low[0] / 4.0, b.low[1] / 4.0, b.low[2] / 4.0},
                  {b.high[0] / 4.0, b.high[1] / 4.0, b.high[2] / 4.0}};
    parts.push_back({"", sheared(box_mesh(box), how)});
  }
  return parts;
}

/// The volumes of the union, and of its part in the cells, in small cubes.
struct FineVolumes {
  std::size_t in_union = 0, covered = 0;
};

inline FineVolumes volumes(const std::set<Cell>& cells, const std::vector<FineBox>& boxes) {
  FineBox all = boxes.front();
  for (const FineBox& box : boxes) {
    for (int k = 0; k < 3; ++k) {
      all.low[k] = std::min(all.low[k], box.low[k]);
      all.high[k] = std::max(all.high[k], box.high[k]);
    }
  }
  const auto cell = [](int q) { return q >= 0 ? q / kFine : -((kFine - 1 - q) / kFine); };
  FineVolumes found;
  for (int x = all.low[0]; x < all.high[0]; ++x) {
    for (int y = all.low[1]; y < all.high[1]; ++y) {
      for (int z = all.low[2]; z < all.high[2]; ++z) {
        if (!in_some(boxes, {x + 0.5, y + 0.5, z + 0.5})) continue;
        ++found.in_union;
        found.covered += cells.contains({cell(x), cell(y), cell(z)}) ? 1 : 0;
      }
    }
  }
  return found;
}

}  // namespace support
