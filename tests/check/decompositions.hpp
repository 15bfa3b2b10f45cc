// SPDX-License-Identifier: MIT
// decompositions.hpp - decompositions and their proofs, as the program writes them.
#pragma once
#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

#include "cells.hpp"
#include "convexact/decompose.hpp"
#include "scene/decomposition_proof.hpp"

inline convexact::Decomposition decomposed(const convexact::Mesh& mesh,
                                           convexact::DecomposeRequest request) {
  request.measures = false;
  convexact::DecomposeOutcome outcome = convexact::decompose(mesh, request);
  REQUIRE(std::holds_alternative<convexact::Decomposition>(outcome));
  return std::get<convexact::Decomposition>(std::move(outcome));
}

inline std::string proof_of_parts(const convexact::Mesh& mesh,
                                  const convexact::DecomposeRequest& request) {
  return convexact::write_decomposition_proof(decomposed(mesh, request), request);
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
