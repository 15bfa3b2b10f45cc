// SPDX-License-Identifier: MIT
// parts_trial.hpp - the parts of verify_parts(): each decides some claims about a decomposition.
#pragma once
#include <string>

#include "convexact/verify_parts.hpp"
#include "scene/stage_log.hpp"

namespace convexact::oracle {

/// The judgement of a decomposition: the request, and the verdict so far. The references outlive
/// it.
class PartsTrial {
 public:
  PartsTrial(const Mesh& input, bool has_tree, const PartsRequest& request, StageLog& log);

  bool asks(ClaimCode code) const;
  /// Each of these is ignored if the claim was not asked for.
  void holds(ClaimCode code, std::string sentence, Witness witness = {}) {
    decide(code, Status::Holds, std::move(sentence), std::move(witness));
  }
  void violated(ClaimCode code, std::string sentence, Witness witness = {}) {
    decide(code, Status::Violated, std::move(sentence), std::move(witness));
  }
  void undecided(ClaimCode code, std::string sentence, Witness witness) {
    decide(code, Status::Undecided, std::move(sentence), std::move(witness));
  }
  void not_applicable(ClaimCode code, std::string sentence) {
    decide(code, Status::NotApplicable, std::move(sentence), {});
  }
  /// "1.5e-9 (2e-12 of the diameter)" of the square of a distance.
  std::string distance_text(const Rational& squared) const;
  /// "part 3 ("arm")".
  std::string part_text(std::size_t part) const;
  /// The square of the tolerance.
  Rational squared_tolerance() const;
  Watch watch(const std::string& stage) const { return log.watch(stage); }

  const Mesh& input;
  const PartsRequest& request;
  StageLog& log;
  PointSet points;  ///< Of the input, to be covered.
  PartsVerdict verdict;

 private:
  void decide(ClaimCode code, Status status, std::string sentence, Witness witness);
};

// The parts, in their order. Each uses the results of those before it.

/// Solid, convex, and the budgets, for each part alone.
void judge_each_part(std::span<const NamedPart> parts, PartsTrial& trial);
/// Whether the union covers the points, the surface and the solid of the input.
void judge_coverage(PartsTrial& trial);
/// Whether parts overlap, and whether one lies in another.
void judge_pairs(PartsTrial& trial);
/// Whether the tree is a tree, and nested. @param tree  Null if there is none.
void judge_tree(const HullTree* tree, PartsTrial& trial);
/// The measures reported with the claims.
void measure_parts(PartsTrial& trial);

}  // namespace convexact::oracle
