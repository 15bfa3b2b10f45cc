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
