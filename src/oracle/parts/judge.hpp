// SPDX-License-Identifier: MIT
// judge.hpp - the judges of verify_parts(): each decides some claims about one decomposition.
#pragma once
#include <optional>
#include <string>

#include "convexact/verify_parts.hpp"
#include "oracle/solid/claim_sheet.hpp"
#include "solid/stage_log.hpp"

namespace convexact::oracle {

/// A decomposition on trial: what was asked, and the verdict so far, without its claims. The
/// references outlive it.
class PartsTrial : public ClaimSheet {
 public:
  PartsTrial(const Mesh& input, bool has_tree, const PartsRequest& request, StageLog& log);

  /// "part 3 ("arm")".
  std::string part_text(std::size_t part) const;
  Watch watch(const std::string& stage) const { return log.watch(stage); }

  const Mesh& input;
  const PartsRequest& request;
  StageLog& log;
  PointSet points;  ///< Of the input, to be covered.
  PartsVerdict verdict;
  bool is_solid_held = false;  ///< Proven.
};

/// The number that a budget allows, which may be unset; nullptr for other claims.
[[nodiscard]] const std::optional<std::size_t>* budget_of(const PartsRequest& request,
                                                          ClaimCode code);

// In their order, after each part on its own. Each takes what the ones before it found.

/// Whether the union covers the points, the surface and the solid of the input.
void judge_coverage(PartsTrial& trial);
/// Whether the parts reach no farther from the solid than the distance.
void judge_reach(PartsTrial& trial);
/// Whether parts overlap, and whether one lies in another.
void judge_pairs(PartsTrial& trial);
/// Whether the tree is one, and nested. @param tree  Null if there is none.
void judge_tree(const HullTree* tree, PartsTrial& trial);
/// The numbers beside the claims.
void measure_parts(PartsTrial& trial);

}  // namespace convexact::oracle
