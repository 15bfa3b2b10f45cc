// SPDX-License-Identifier: MIT
// verify_parts.hpp - does the union of some convex parts hold a mesh? Decided exactly, with
// witnesses.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "convexact/decompose.hpp"
#include "convexact/io.hpp"
#include "convexact/overlay.hpp"
#include "convexact/surface.hpp"
#include "convexact/verify.hpp"

namespace convexact {

/// The budgets are those of each part.
struct PartsRequest : Budgets {
  /// The claims to decide; a budget and within-solid are asked for by their numbers. Empty: all but
  /// covers-solid, parts-disjoint and parts-needed; tree-nested if there is a tree. Claims listed
  /// here must apply for the verdict to hold.
  std::vector<ClaimCode> claims = {};
  /// Distances of faces to their planes (parts-convex), and of points of the input to the union
  /// (covers-points, covers-surface), that pass; and of points of two parts beyond a plane between
  /// them (parts-disjoint). Relative ones refer to the input's diameter.
  Tolerance tolerance = {};
  /// How far a point of a part may be from the input's solid, or from its surface if that is open
  /// (within-solid). Asks for covers-solid as well, unless `claims` lists some: both together are a
  /// bound in both directions. Relative ones refer to the input's diameter.
  std::optional<Tolerance> distance = {};
  Close close = Close::Never;  ///< Auto: of the input's surface.
  std::optional<std::size_t> max_parts = {};
  /// Which points of an input with faces covers-points asks about.
  MeshPoints points = MeshPoints::All;
  bool exact_facets = false;     ///< As VerifyRequest::exact_facets.
  Orient orient = Orient::Auto;  ///< Of the input's faces.
  PartMeasures measures = PartMeasures::All;
  bool exact_volumes = false;  ///< Whether volumes are fractions, too.
  std::uint64_t seed = 1;      ///< Of every random order. The verdict does not depend on it.
  /// Threads, >= 1; as many as the machine has cores if it is not given. The verdict does not
  /// depend on it.
  std::optional<std::size_t> jobs = {};
  StageWatch watch = {};
};

/// The same questions about a decomposition: each budget is one of every part, and `tightness` asks
/// for all measures. `inner` and `slack_ulps` have no meaning there.
[[nodiscard]] PartsRequest parts_request(const VerifyRequest& request);

/// A part on its own.
struct JudgedPart {
  std::string name;
  CandidateSize size;
  /// Its claims, as far as they were asked: solid, closed, oriented, planar, convex, and the
  /// budgets.
  std::vector<Claim> claims;
};

/// Numbers beside the claims. Volumes and distances of the solid where the input encloses one.
struct PartsMeasures : DecompositionMeasures {
  Enclosure surface_area, uncovered_area;
  /// Largest distance of a point of the input's surface to the union.
  Enclosure surface_to_union;
  /// Of PartMeasures::All, or with a distance: the largest distance of a point of the union to the
  /// input's solid, or to its surface if it encloses none. The larger one of both is the Hausdorff
  /// distance.
  std::optional<Enclosure> union_to_input;
};

struct PartsVerdict {
  /// One for each of kPartsClaims, in that order; then TreeNested, if there is a tree or it was
  /// named.
  std::vector<Claim> claims;
  Surface surface;  ///< Of the input.
  std::vector<JudgedPart> parts;
  std::vector<ConvexPart> hulls;  ///< By part: what it stands for.
  /// If covers-points was decided: how many were asked, how many of these lie in no part, and how
  /// many of the latter no face of the input uses. Points at one place count once.
  std::size_t points = 0, points_outside = 0, unused_outside = 0;
  std::optional<SurfaceCoverage> coverage;  ///< If covers-surface or covers-solid was.
  /// The part nearest to the uncovered point that is farthest among those found.
  std::optional<std::size_t> worst_part;
  std::optional<Tolerance> distance;  ///< As it was asked for.
  std::optional<PartsMeasures> measures;
  Rational squared_diameter;  ///< Of the input's points.
  std::vector<std::string> notes;
  std::vector<Stage> stages;

  const Claim& operator[](ClaimCode code) const;
  /// Whether no claim is violated or undecided, and each that was named is decided.
  bool holds() const;
};

/// "3% of the diameter", or "0.05", to six digits.
[[nodiscard]] std::string describe_distance(const Tolerance& distance);

/// Decides the claims about a decomposition exactly. Parts are closed sets: touching counts as
/// inside. For flat parts the other claims are still decided.
/// @param input  Without faces there is no surface, and its points are to be covered.
/// @throws Error NoInterior if the input has no point; InvalidArgument for a negative tolerance, a
///               tolerance together with covers-solid, a budget that `claims` names without a
///               number, within-solid without a distance, a distance below 0, and a claim of
///               another kind; Stopped when the watch ends the call.
[[nodiscard]] PartsVerdict verify_parts(const Mesh& input, const CandidateParts& candidate,
                                        const PartsRequest& request = {});

}  // namespace convexact
