// SPDX-License-Identifier: MIT
// decompositions.hpp - decompositions and their proofs, as the program writes them.
#pragma once
#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

#include "cells.hpp"
#include "convexact/decompose.hpp"
#include "proof/decomposition_proof.hpp"

inline convexact::Decomposition decomposed(const convexact::Mesh& mesh,
                                           convexact::DecomposeRequest request) {
  request.measures = convexact::PartMeasures::None;
  convexact::DecomposeOutcome outcome = convexact::decompose(mesh, request);
  REQUIRE(std::holds_alternative<convexact::Decomposition>(outcome));
  return std::get<convexact::Decomposition>(std::move(outcome));
}

inline std::string proof_of_parts(const convexact::Mesh& mesh,
                                  const convexact::DecomposeRequest& request) {
  return convexact::write_decomposition_proof(decomposed(mesh, request), request);
}

// A mesh of integers, turned and three times as large: along no edge of a cell.
inline convexact::Mesh turned(convexact::Mesh mesh) {
  std::vector<convexact::Point> points;
  for (const convexact::Point& p : mesh.points.doubles()) {
    points.emplace_back(2 * p[0] - 2 * p[1] + p[2], 2 * p[0] + p[1] - 2 * p[2],
                        p[0] + 2 * p[1] + 2 * p[2]);
  }
  mesh.points = convexact::PointSet(std::move(points));
  return mesh;
}

// A cube of side 4 whose top is dented to its middle, 1 deep: the other facets are farther away.
inline convexact::Mesh dented_cube() {
  return {convexact::PointSet(std::vector<convexact::Point>{{0, 0, 0},
                                                            {4, 0, 0},
                                                            {4, 4, 0},
                                                            {0, 4, 0},
                                                            {0, 0, 4},
                                                            {4, 0, 4},
                                                            {4, 4, 4},
                                                            {0, 4, 4},
                                                            {2, 2, 3}}),
          {{3, 2, 1, 0},
           {0, 1, 5, 4},
           {1, 2, 6, 5},
           {2, 3, 7, 6},
           {3, 0, 4, 7},
           {4, 5, 8},
           {5, 6, 8},
           {6, 7, 8},
           {7, 4, 8}},
          {{"", 0, 9}}};
}

// A ridge from (-100, 0, 4) to (100, 0, 4) above the triangle (-1, -1, 0), (1, -1, 0), (0, 1, 0):
// straight up it is 4 - |y| / 2 to the hull, so 4 from its points with y = 0, the farthest of all.
// Either plane of the roof alone allows 4.5 at a corner; half of each allows 4 everywhere.
inline convexact::Mesh hip_roof() {
  return {
      convexact::PointSet(std::vector<convexact::Point>{
          {-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, {0, -8, 0}, {100, 0, 4}, {-100, 0, 4}, {0, 8, 0}}),
      {{0, 1, 2}, {1, 0, 3}, {1, 3, 4}, {3, 0, 5}, {4, 3, 6}},
      {{"", 0, 5}}};
}
