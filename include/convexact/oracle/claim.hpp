// SPDX-License-Identifier: MIT
// claim.hpp - what the oracle says about a candidate: one claim at a time, each with its witness.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "convexact/geometry/halfspace.hpp"

namespace convexact {

/// What can be claimed of a candidate; docs/verdicts has a page for each.
enum class ClaimCode {
  CandidateReadable,  ///< Its bytes spell a mesh or a list of halfspaces.
  CandidateFinite,    ///< No NaN, no infinity, no decimal beyond the largest double.
  CandidateSolid,     ///< It has a 3D interior.
  CandidateBounded,   ///< It does not extend to infinity.
  MeshClosed,         ///< Each edge is shared by exactly two faces.
  MeshOriented,       ///< All faces look outward.
  MeshPlanar,         ///< Each face is a simple polygon in one plane.
  MeshConvex,         ///< The faces are the surface of the hull of the vertices.
  ContainsInput,      ///< No input point lies outside.
  MaxFacets,          ///< At most so many facets; of a mesh, as meant.
  MaxVertices,        ///< At most so many vertices, those inside a facet or an edge not counted.
  MaxFacetVertices,   ///< No facet has more corners.
};
inline constexpr std::array kAllClaims = {
    ClaimCode::CandidateReadable, ClaimCode::CandidateFinite, ClaimCode::CandidateSolid,
    ClaimCode::CandidateBounded,  ClaimCode::MeshClosed,      ClaimCode::MeshOriented,
    ClaimCode::MeshPlanar,        ClaimCode::MeshConvex,      ClaimCode::ContainsInput,
    ClaimCode::MaxFacets,         ClaimCode::MaxVertices,     ClaimCode::MaxFacetVertices};

/// "contains-input" and the like: stable, in messages, in JSON and as the names of the pages.
[[nodiscard]] const char* name_of(ClaimCode code);
/// The claim of that name, if there is one.
[[nodiscard]] std::optional<ClaimCode> claim_of_name(const std::string& name);

enum class Status {
  Holds,
  Violated,
  NotAsked,       ///< Nobody wants to know.
  NotApplicable,  ///< It has no meaning for this candidate; the sentence says why.
};
[[nodiscard]] const char* name_of(Status status);

/// What refutes a claim. Which fields are set depends on the claim, see docs/verdicts; ids count
/// from 0, faces and rows in the order of the candidate's file.
struct Witness {
  std::optional<std::size_t> input_point;    ///< A point of the input.
  std::vector<std::size_t> vertices;         ///< Points of the candidate.
  std::vector<std::size_t> faces;            ///< Faces of the candidate's mesh.
  std::vector<std::size_t> rows;             ///< Rows of the candidate's list of halfspaces.
  std::optional<std::size_t> line;           ///< Of the candidate's file, from 1.
  std::optional<Halfspace> plane;            ///< The plane that something is beyond.
  std::optional<RationalPoint> point;        ///< The coordinates of what is beyond it.
  std::optional<RationalPoint> nearest;      ///< Of the candidate, the point nearest to `point`.
  std::optional<RationalVector3> direction;  ///< In which the candidate is unbounded.
  std::optional<Rational>
      squared_distance;              ///< Of `point` to `nearest`, else to `plane`; positive.
  std::optional<std::size_t> count;  ///< How much was found where a budget allows less.
};

struct Claim {
  ClaimCode code;
  Status status;
  std::string sentence;  ///< What was found, for people.
  Witness witness;       ///< Empty unless violated, or let pass by a tolerance.
  /// Whether the request named it, so that it is no success if it is not applicable.
  bool is_named = false;
  /// Whether it is violated by `witness.squared_distance` alone, so that such a tolerance lets it
  /// pass.
  bool is_by_distance = false;

  bool is_undecided() const { return is_named && status == Status::NotApplicable; }
};

}  // namespace convexact
