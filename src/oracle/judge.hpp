// SPDX-License-Identifier: MIT
// judge.hpp - the parts of verify(): each decides some claims about one candidate.
#pragma once
#include "convexact/verify.hpp"
#include "convexact/watch.hpp"
#include "oracle/mesh_surface.hpp"
#include "scene/stage_log.hpp"

namespace convexact::oracle {

/// The input, as far as the claims need it.
struct Input {
  PointSet points;               ///< All that the candidate must contain.
  std::vector<PointId> extreme;  ///< Of `points`: those whose hull holds the rest.
  Polytope hull;
  Rational squared_diameter;
};

/// What a readable candidate stands for.
struct CandidateSet {
  /// The set is where all of these hold. Of a flat mesh: the planes that hold it, both sides.
  std::vector<Halfspace> planes;
  bool is_empty = false;             ///< No point at all: a mesh without points, or 0 <= -1.
  std::optional<Hull> hull;          ///< Of a mesh that spans a volume.
  std::optional<Polytope> polytope;  ///< If it is a bounded solid, and a claim needs it.
  std::vector<std::vector<std::uint32_t>> patches;  ///< Of a mesh: planar_patches() of that.
  bool is_examined = false;                         ///< Whether it is known if it is one.
};

/// Which claims were asked, and the verdict so far.
class Docket {
 public:
  Docket(const VerifyRequest& request, Verdict& verdict);

  bool asks(ClaimCode code) const;
  /// Each is ignored if the claim was not asked for.
  void holds(ClaimCode code, std::string sentence, Witness witness = {});
  void violated(ClaimCode code, std::string sentence, Witness witness);
  void not_applicable(ClaimCode code, std::string sentence);
  /// Whether a distance with this square is within the tolerance.
  bool allows(const Rational& squared_distance) const;
  /// Violated by so much, unless the tolerance allows it.
  void violated_by(const Rational& squared_distance, ClaimCode code, const std::string& sentence,
                   Witness witness);
  /// "1.5e-9 (2e-12 of the diameter)" of the square of a distance.
  std::string distance_text(const Rational& squared) const;

  const VerifyRequest& request;
  Verdict& verdict;

 private:
  void set(ClaimCode code, Status status, std::string sentence, Witness witness);
};

/// Readable, finite: from the error of the reader. Returns whether there is anything to judge.
bool judge_reading(const Candidate& candidate, Docket& docket);
/// Solid, bounded.
CandidateSet judge_mesh_set(const Mesh& mesh, Docket& docket, StageLog& log);
CandidateSet judge_halfspace_set(const HalfspaceList& list, Docket& docket, StageLog& log);
/// The facets that rounded vertices were meant to have, if they are asked for.
void find_facets_as_meant(const Mesh& mesh, CandidateSet& set, Docket& docket, StageLog& log);
/// How many of these are in a facet plane of the input's hull. @param set  Has a polytope.
void count_planes_of_the_input(const Input& input, const CandidateSet& set, Docket& docket);
/// Closed, oriented, planar, convex.
void judge_faces(const Mesh& mesh, const CandidateSet& set, Docket& docket, const Watch& watch);
/// Contains the input. Where it does not, the candidate's polytope is found, to measure how far.
void judge_containment(const Input& input, const Candidate& candidate, CandidateSet& set,
                       Docket& docket, StageLog& log);
/// The three budgets.
void judge_budgets(Docket& docket);

/// @throws Error InvalidArgument if a budget is among the claims without its number.
void require_numbers(const VerifyRequest& request);
/// After all claims: the tolerance with which they hold. @param rounding  A distance.
void judge_tolerance(const Rational& rounding, Docket& docket);

/// "1 point", "18 halfspaces".
std::string counted(std::size_t count, const char* one, const char* many);

}  // namespace convexact::oracle
