// SPDX-License-Identifier: MIT
// verify.hpp - the oracle: is a candidate a convex solid that contains the input, and how tight?
#pragma once
#include <optional>
#include <variant>
#include <vector>

#include "convexact/oracle/candidate.hpp"
#include "convexact/oracle/claim.hpp"
#include "convexact/oracle/planar_patches.hpp"
#include "convexact/oracle/tightness.hpp"
#include "convexact/oracle/tolerance.hpp"
#include "convexact/pipeline/solid.hpp"

namespace convexact {

struct VerifyRequest {
  /// The claims to decide; the budgets are asked by their numbers. Empty: all. Claims that stand
  /// here and budgets must apply to the candidate for the verdict to hold.
  std::vector<ClaimCode> claims = {};
  /// Violations of planarity and convexity up to this distance from a plane, and of containment up
  /// to this distance from the candidate, pass; they are reported all the same.
  Tolerance tolerance = {};
  std::optional<std::size_t> max_facets = {}, max_vertices = {}, max_facet_vertices = {};
  /// Whether `max_facets` is for the facets of a mesh as they are, not as they were meant.
  bool exact_facets = false;
  /// The facets as meant are also looked for with this Slack::ulps_of_largest, if it is not 0; the
  /// fewer count.
  unsigned slack_ulps = 0;
  bool tightness = true;   ///< Whether to measure volume, area, mean width and distance.
  std::uint64_t seed = 1;  ///< Of every random order. The verdict does not depend on it.
};

/// The input points that lie outside a candidate.
struct Outside {
  std::size_t points = 0;  ///< How many.
  std::size_t tested = 0;  ///< Of how many.
  /// (squared distance of the worst one to the candidate) / (squared diameter); nothing if the
  /// candidate is no bounded solid.
  std::optional<Rational> relative_squared_distance;
};

/// What a candidate consists of.
struct CandidateSize {
  std::size_t stored_faces = 0;     ///< Faces of the mesh, or rows of the list.
  std::size_t stored_vertices = 0;  ///< Points of the mesh; 0 for halfspaces.
  /// Of the solid, if there is one: coplanar faces as one facet, and its corners.
  std::optional<std::size_t> facets, vertices, most_facet_vertices;
  /// Of a mesh: the number of planar_patches() with this slack.
  std::optional<std::size_t> facets_as_meant;
  Slack slack;
  /// How many of its facets (of a mesh: as meant) are in facet planes of the input's hull, up to
  /// kRoundingUlps.
  std::optional<std::size_t> planes_of_the_input;
};

/// The least tolerance with which a violated verdict holds.
struct SmallestTolerance {
  std::string decimal;  ///< Absolute, rounded up.
  /// Whether rounding explains it: at most kRoundingUlps of the candidate's largest coordinate (of
  /// halfspaces: of the largest coordinate of the input).
  bool is_rounding;
};

struct Verdict {
  std::vector<Claim> claims;  ///< One for each of kAllClaims, in that order.
  CandidateSize size;
  std::optional<Outside> outside;      ///< If containment was decided.
  std::optional<Tightness> tightness;  ///< If asked for, and the candidate is a bounded solid.
  Rational squared_diameter;           ///< Of the input: what tolerances refer to.
  /// If some claim is violated, and all that are by a distance only.
  std::optional<SmallestTolerance> smallest_tolerance;
  std::vector<std::string> notes;  ///< What else people should know; decides nothing.

  const Claim& operator[](ClaimCode code) const;
  /// Whether no claim is violated, and each that was named is decided.
  bool holds() const;
};

using VerifyOutcome = std::variant<Verdict, NotSolid>;

/// Decides every claim about `candidate` exactly. Containment is decided in two ways that share no
/// predicate: every input point against every plane (find_outside()), and the vertices of the
/// input's hull each against the candidate's triangle in its direction, or by a linear program for
/// each of its planes.
/// @return NotSolid if the *input* has no volume. Whatever is wrong with the candidate is a claim.
/// @throws Error InvalidArgument for a negative tolerance, and for a budget that `claims` names
///               without a number; Internal if the two ways disagree or a certificate fails.
/// @par Cost    Points times planes in doubles, the two hulls, and the measures asked for.
[[nodiscard]] VerifyOutcome verify(const Shape& input, const Candidate& candidate,
                                   const VerifyRequest& request, StageLog& log);

}  // namespace convexact
