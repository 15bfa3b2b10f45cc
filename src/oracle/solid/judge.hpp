// SPDX-License-Identifier: MIT
// judge.hpp - the judges of verify(): each decides some claims about one solid.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "convexact/verify.hpp"
#include "oracle/solid/claim_sheet.hpp"
#include "solid/stage_log.hpp"

namespace convexact::oracle {

/// The input, as far as the claims need it.
struct Input {
  PointSet points;               ///< All that the candidate must contain.
  std::vector<PointId> extreme;  ///< Of `points`: those whose hull holds the rest.
  Polytope hull;
  Rational squared_diameter;
  /// By point, its number in the file; empty if these are the numbers of `points`.
  std::vector<PointId> numbers = {};

  std::size_t number_of(PointId p) const {
    return numbers.empty() ? p.index() : numbers[p.index()].index();
  }
};

/// The set that a readable candidate stands for.
struct CandidateSet {
  /// The set is where all of these hold. For a flat mesh: the planes that hold it, both sides of
  /// each.
  std::vector<Halfspace> planes;
  bool is_empty = false;             ///< No point at all: a mesh without points, or 0 <= -1.
  std::optional<Hull> hull;          ///< Of a mesh that spans a volume.
  std::optional<Polytope> polytope;  ///< If it is a bounded solid, and a claim needs it.
  std::vector<std::vector<std::uint32_t>> patches;  ///< Of a mesh: planar_patches() of that.
  bool is_examined = false;                         ///< Whether find_vertices() has run.
  /// The input points outside of it, once they were looked for.
  std::optional<std::vector<PointId>> missed;
};

/// One candidate on trial: what was asked, what is known, and the verdict so far, without its
/// claims. The references outlive it.
class Trial : public ClaimSheet {
 public:
  Trial(const Input& input, const Candidate& candidate, const VerifyRequest& request,
        StageLog& log);

  /// The candidate, if it is a mesh.
  const Mesh* mesh() const { return std::get_if<Mesh>(&candidate); }
  const HalfspaceList* list() const { return std::get_if<HalfspaceList>(&candidate); }
  Watch stop() const { return log.watch().stop; }
  /// For the stages within a stage, which are not recorded.
  StageLog unrecorded() const { return StageLog(StageWatch{.stop = log.watch().stop}); }

  const Input& input;
  const Candidate& candidate;
  const VerifyRequest& request;
  StageLog& log;
  CandidateSet set;
  Verdict verdict;
};

/// The number that a budget allows, which may be unset; nullptr for other claims.
[[nodiscard]] const std::optional<std::size_t>* budget_of(const VerifyRequest& request,
                                                          ClaimCode code);

/// The claim that only this question has: of an inner solid or of a hull.
[[nodiscard]] std::optional<ClaimCode> own_claim(Asks asks);

// The parts, in their order. Each uses the results of those before it.

/// Readable, finite: from the error of the reader. Returns whether there is anything to judge.
bool judge_reading(Trial& trial);
/// Solid, bounded: the kind of set that the candidate is.
void judge_set(Trial& trial);
/// Closed, oriented, planar, convex.
void judge_faces(Trial& trial);
/// The facets that rounded vertices of a mesh were meant to have, if they are asked for.
void find_facets_as_meant(Trial& trial);
/// Contains the input. Where it does not, the candidate's polytope is found, to measure how far.
void judge_containment(Trial& trial);
/// For an inner solid: no vertex lies outside of the input's hull.
void judge_inside_input(Trial& trial);
/// For a hull: how far the candidate and the input's hull reach out of each other.
void judge_is_hull(Trial& trial);
/// The three budgets.
void judge_budgets(Trial& trial);
/// The facets that are in a facet plane of the input's hull. Precondition: there is a polytope.
void count_planes_of_the_input(Trial& trial);

/// Finds the polytope of a list of halfspaces, or returns why there is none.
std::optional<NotSolid> find_vertices(Trial& trial);

}  // namespace convexact::oracle
