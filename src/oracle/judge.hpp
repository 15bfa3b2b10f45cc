// SPDX-License-Identifier: MIT
// judge.hpp - the parts of verify(): each decides some claims about one candidate.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "convexact/verify.hpp"
#include "scene/stage_log.hpp"

namespace convexact::oracle {

/// The input, as far as the claims need it.
struct Input {
  PointSet points;               ///< All that the candidate must contain.
  std::vector<PointId> extreme;  ///< Of `points`: those whose hull holds the rest.
  Polytope hull;
  Rational squared_diameter;
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
};

/// The judgement of one candidate: the request, the data found, and the verdict so far. The
/// references outlive it.
class Trial {
 public:
  Trial(const Input& input, const Candidate& candidate, const VerifyRequest& request,
        StageLog& log);

  /// The candidate, if it is a mesh.
  const Mesh* mesh() const { return std::get_if<Mesh>(&candidate); }
  const HalfspaceList* list() const { return std::get_if<HalfspaceList>(&candidate); }
  const std::atomic<bool>* stop() const { return log.watch().stop; }
  /// For the stages within a stage, which are not recorded.
  StageLog unrecorded() const { return StageLog(StageWatch{.stop = stop()}); }

  bool asks(ClaimCode code) const;
  /// Each of these is ignored if the claim was not asked for.
  void holds(ClaimCode code, std::string sentence, Witness witness = {}) {
    decide(code, Status::Holds, std::move(sentence), std::move(witness));
  }
  void violated(ClaimCode code, std::string sentence, Witness witness) {
    decide(code, Status::Violated, std::move(sentence), std::move(witness));
  }
  void not_applicable(ClaimCode code, std::string sentence) {
    decide(code, Status::NotApplicable, std::move(sentence), {});
  }
  /// Violated by this distance, unless the tolerance allows it.
  void violated_by(const Rational& squared_distance, ClaimCode code, const std::string& sentence,
                   Witness witness);
  /// Whether a distance with this square is within the tolerance.
  bool allows(const Rational& squared_distance) const {
    return request.tolerance.allows(squared_distance, input.squared_diameter);
  }
  /// "1.5e-9 (2e-12 of the diameter)" of the square of a distance.
  std::string distance_text(const Rational& squared) const;

  const Input& input;
  const Candidate& candidate;
  const VerifyRequest& request;
  StageLog& log;
  CandidateSet set;
  Verdict verdict;

 private:
  void decide(ClaimCode code, Status status, std::string sentence, Witness witness);
};

/// The number that a budget allows, which may be unset; nullptr for other claims.
[[nodiscard]] const std::optional<std::size_t>* budget_of(const VerifyRequest& request,
                                                          ClaimCode code);

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
/// The three budgets.
void judge_budgets(Trial& trial);
/// How many facets are in a facet plane of the input's hull. Precondition: there is a polytope.
void count_planes_of_the_input(Trial& trial);

/// Finds the polytope of a list of halfspaces, or returns why there is none.
std::optional<NotSolid> find_vertices(Trial& trial);

}  // namespace convexact::oracle
