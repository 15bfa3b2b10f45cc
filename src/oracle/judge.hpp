// SPDX-License-Identifier: MIT
// judge.hpp - the judges of verify() and of verify_parts(): each decides some claims about one
// candidate.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "convexact/verify.hpp"
#include "convexact/verify_parts.hpp"
#include "solid/stage_log.hpp"

namespace convexact::oracle {

/// The claims about one candidate: which are asked, what is found, and how far off may pass.
class ClaimSheet {
 public:
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
  /// Violated by so much, unless the tolerance allows it.
  void violated_by(const Rational& squared_distance, ClaimCode code, const std::string& sentence,
                   Witness witness);
  /// Reading has failed: `finite` is violated by a number that is not, otherwise `readable`, and no
  /// other claim applies.
  /// @param what  "the candidate".
  void unreadable(const Error& error, ClaimCode readable, ClaimCode finite,
                  const std::string& what);

  /// Whether a distance with this square is within the tolerance.
  bool allows(const Rational& squared_distance) const {
    return tolerance.allows(squared_distance, squared_diameter);
  }
  /// "1.5e-9 (2e-12 of the diameter)" of the square of a distance.
  std::string distance_text(const Rational& squared) const;

  std::vector<Claim> claims;  ///< As added, each NotAsked until it is decided.
  const Tolerance tolerance;
  Rational squared_diameter;  ///< Of the input; 0 of a point.

 protected:
  /// @param named  The claims that the request names, which outlive this; none: the usual ones.
  ClaimSheet(const std::vector<ClaimCode>& named, const Tolerance& allowed, Rational squared)
      : tolerance(allowed), squared_diameter(std::move(squared)), named_(named) {}
  /// @param has_number  Of a claim that is asked for by a number: whether that is given.
  void add(ClaimCode code, std::optional<bool> has_number, bool is_usual);

 private:
  Claim* find_asked(ClaimCode code);
  void decide(ClaimCode code, Status status, std::string sentence, Witness witness);

  const std::vector<ClaimCode>& named_;
  std::vector<ClaimCode> asked_;
};

// ---- Points that no face of the input uses

/// Of those that are not asked about, for people.
[[nodiscard]] std::string unused_text(std::size_t unused);
/// How many of the points outside no face uses, for people.
[[nodiscard]] std::string unused_outside_text(std::size_t unused, std::size_t outside);

// ---- One solid

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
  const std::atomic<bool>* stop() const { return log.watch().stop; }
  /// For the stages within a stage, which are not recorded.
  StageLog unrecorded() const { return StageLog(StageWatch{.stop = stop()}); }

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

// ---- A decomposition

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
};

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
