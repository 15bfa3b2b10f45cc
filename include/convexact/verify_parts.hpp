// SPDX-License-Identifier: MIT
// verify_parts.hpp - does the union of some convex parts hold a mesh? Decided exactly, with
// witnesses.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "convexact/mesh.hpp"
#include "convexact/overlay.hpp"
#include "convexact/parts.hpp"
#include "convexact/surface.hpp"
#include "convexact/verify.hpp"

namespace convexact {

struct PartsRequest {
  /// The claims to decide; a budget is asked for by its number. Empty: all but covers-solid,
  /// parts-disjoint and parts-needed; tree-nested if there is a tree. Claims listed here must apply
  /// for the verdict to hold.
  std::vector<ClaimCode> claims = {};
  /// Distances of faces to their planes (parts-convex), and of points of the input to the union
  /// (covers-points, covers-surface), that pass. Relative ones refer to the input's diameter.
  Tolerance tolerance = {};
  std::optional<std::size_t> max_parts = {};
  /// Of each part.
  std::optional<std::size_t> max_facets = {}, max_vertices = {}, max_facet_vertices = {};
  bool exact_facets = false;     ///< As VerifyRequest::exact_facets.
  Orient orient = Orient::Auto;  ///< Of the input's faces.
  bool measures = true;          ///< Whether to measure areas, volumes and distances.
  bool exact_volumes = false;    ///< Whether volumes are fractions, too.
  std::uint64_t seed = 1;        ///< Of every random order. The verdict does not depend on it.
  StageWatch watch = {};
};

/// The judgement of a single part.
struct JudgedPart {
  std::string name;
  CandidateSize size;
  /// Its claims, as far as they were asked: solid, closed, oriented, planar, convex, and the
  /// budgets.
  std::vector<Claim> claims;
};

/// Numbers beside the claims. Volumes and distances of the solid where the input encloses one.
struct PartsMeasures {
  Enclosure surface_area, uncovered_area;
  std::optional<Measured> solid_volume;      ///< Of the input.
  std::optional<Measured> uncovered_volume;  ///< Of the solid outside of the union.
  std::optional<Measured> excess_volume;     ///< Of the union outside of the solid.
  Measured union_volume;
  Measured overlap_volume;  ///< The sum of the parts' volumes, less the union's.
  /// Largest distance of a point of the input's surface to the union, and of a point of the union
  /// to the input's solid, or to its surface if it encloses none. The larger one is the Hausdorff
  /// distance.
  Enclosure surface_to_union, union_to_input;
};

struct PartsVerdict {
  /// One for each of kPartsClaims, in that order; then TreeNested, if there is a tree or it was
  /// named.
  std::vector<Claim> claims;
  Surface surface;  ///< Of the input.
  std::vector<JudgedPart> parts;
  std::vector<ConvexPart> hulls;               ///< By part: what it stands for.
  std::size_t points = 0, points_outside = 0;  ///< If covers-points was decided.
  std::optional<SurfaceCoverage> coverage;     ///< If covers-surface or covers-solid was.
  /// The part nearest to the uncovered point that is farthest among those found.
  std::optional<std::size_t> worst_part;
  std::optional<PartsMeasures> measures;
  Rational squared_diameter;  ///< Of the input's points.
  std::vector<std::string> notes;
  std::vector<Stage> stages;

  const Claim& operator[](ClaimCode code) const;
  /// Whether no claim is violated or undecided, and each that was named is decided.
  bool holds() const;
};

/// Decides the claims about a decomposition exactly. Parts are closed sets: touching counts as
/// inside. For flat parts the other claims are still decided.
/// @param input  With faces, the points that they use are to be covered; without, all points, and
///               there is no surface.
/// @throws Error NoInterior if the input has no point; InvalidArgument for a negative tolerance, a
///               tolerance together with covers-solid, a budget that `claims` names without a
///               number, and a claim of another kind; Stopped when the watch ends the call.
[[nodiscard]] PartsVerdict verify_parts(const Mesh& input, const CandidateParts& candidate,
                                        const PartsRequest& request = {});

}  // namespace convexact
