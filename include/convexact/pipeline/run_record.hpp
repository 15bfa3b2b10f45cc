// SPDX-License-Identifier: MIT
// run_record.hpp - everything of a run that its proof needs.
#pragma once
#include <vector>

#include "convexact/dual/dual_hull.hpp"
#include "convexact/hull/hull.hpp"
#include "convexact/simplify/trace.hpp"

namespace convexact {

struct RunRecord {
  std::vector<Halfspace> input_halfspaces;  ///< Where the input is halfspaces: all of them.
  DualHull solid;                           ///< What the run started from.
  RationalPoint interior;                   ///< Strictly inside the solid.
  std::vector<InsideProof> inside;          ///< As in HullCertificate.
  std::vector<PointId> extreme;             ///< The points that are the solid's vertices.
  bool is_greedy = true;                    ///< Whether each removal is claimed to be the cheapest.
  std::vector<Step> steps;                  ///< With ties where it is greedy.
  std::vector<Evaluation> evaluations;      ///< In the order in which they were made.
};

}  // namespace convexact
