// SPDX-License-Identifier: MIT
// verify.hpp - is a candidate a convex solid that contains the input? Decided exactly, with
// witnesses.
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/geometry.hpp"
#include "convexact/io.hpp"
#include "convexact/number.hpp"
#include "convexact/scene.hpp"

namespace convexact {

/// A distance, absolute in length units or relative to the diameter of the input. 0 by default:
/// nothing passes.
struct Tolerance {
  Rational value = 0;
  bool relative = false;

  /// Its square in squared length units; exact.
  Rational squared(const Rational& squared_diameter) const;
  /// Whether a distance with this square is within the tolerance; exact.
  bool allows(const Rational& squared_distance, const Rational& squared_diameter) const;
};

/// "1.00e-9", or "1.00e-9 of the diameter": to three digits.
[[nodiscard]] std::string describe(const Tolerance& tolerance);

/// The root of an exact square to so many digits: "3.47e-16".
[[nodiscard]] std::string decimal_of_root(const Rational& squared, int digits = 3);

/// "1e-9" is absolute, "1e-9d" relative to the diameter; decimals mean what they spell.
/// @throws Error InvalidArgument for anything else, and for negative numbers.
[[nodiscard]] Tolerance parse_tolerance(std::string_view text);

/// The least decimal of three significant digits that, as an absolute tolerance, allows distances
/// with this square: "3.15e-16".
/// @param squared_distance  Positive.
[[nodiscard]] std::string least_tolerance(const Rational& squared_distance);

/// A mesh, which stands for the convex hull of its points; halfspaces, which stand for their
/// intersection; or the error (Malformed or NotFinite) that reading it met.
using Candidate = std::variant<Mesh, HalfspaceList, Error>;

/// The claims about a candidate; docs/verdicts.md has a section for each.
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
  MaxFacets,          ///< At most so many facets; for a mesh, facets as meant.
  MaxVertices,        ///< At most so many vertices, those inside a facet or an edge not counted.
  MaxFacetVertices,   ///< No facet has more corners.
  InsideInput,        ///< Of an inner solid: no vertex lies outside of the input's hull.
  IsHull,             ///< Of a hull: it is the input's hull, both distances within the tolerance.
  NoGaps,  ///< Of the parts of a scene: each face of the input lies in the candidate of its part.
  // Of a decomposition: see verify_parts.hpp.
  PartsReadable,         ///< Its bytes spell meshes.
  PartsFinite,           ///< No NaN, no infinity, no decimal beyond the largest double.
  PartsSolid,            ///< Each part has a 3D interior.
  PartsConvex,           ///< The faces of each part are the surface of the hull of its points.
  CoversPoints,          ///< Each point of the input lies in some part.
  CoversSurface,         ///< Each point of the input's faces lies in some part.
  CoversSolid,           ///< Each point of the solid that the faces enclose lies in some part.
  WithinSolid,           ///< No point of a part is farther than a distance from the input's solid.
  PartsDisjoint,         ///< No two parts have a common interior point, up to a tolerance.
  PartsNeeded,           ///< No part lies in another one.
  MaxParts,              ///< At most so many parts.
  MaxPartFacets,         ///< No part has more facets; of a mesh, as meant.
  MaxPartVertices,       ///< No part has more vertices.
  MaxPartFacetVertices,  ///< No facet of a part has more corners.
  TreeNested,            ///< The parts are the leaves of a tree of hulls that hold their children.
};
/// The claims about an enclosure. A hull has IsHull besides; an inner solid has InsideInput
/// besides, and ContainsInput is asked of it by name only.
inline constexpr std::array kAllClaims = {
    ClaimCode::CandidateReadable, ClaimCode::CandidateFinite, ClaimCode::CandidateSolid,
    ClaimCode::CandidateBounded,  ClaimCode::MeshClosed,      ClaimCode::MeshOriented,
    ClaimCode::MeshPlanar,        ClaimCode::MeshConvex,      ClaimCode::ContainsInput,
    ClaimCode::MaxFacets,         ClaimCode::MaxVertices,     ClaimCode::MaxFacetVertices};
/// The claims about a decomposition. Parts under a tree have TreeNested besides.
inline constexpr std::array kPartsClaims = {
    ClaimCode::PartsReadable,   ClaimCode::PartsFinite,
    ClaimCode::PartsSolid,      ClaimCode::PartsConvex,
    ClaimCode::CoversPoints,    ClaimCode::CoversSurface,
    ClaimCode::CoversSolid,     ClaimCode::WithinSolid,
    ClaimCode::PartsDisjoint,   ClaimCode::PartsNeeded,
    ClaimCode::MaxParts,        ClaimCode::MaxPartFacets,
    ClaimCode::MaxPartVertices, ClaimCode::MaxPartFacetVertices};
[[nodiscard]] constexpr bool is_of_parts(ClaimCode code) {
  return code >= ClaimCode::PartsReadable;
}

/// "contains-input" and the like: stable, in messages, in JSON and as headings of docs/verdicts.md.
[[nodiscard]] const char* name_of(ClaimCode code);
/// The claim of that name, if there is one.
[[nodiscard]] std::optional<ClaimCode> claim_of_name(const std::string& name);

enum class Status {
  Holds,
  Violated,
  NotAsked,       ///< Not among the claims to decide.
  NotApplicable,  ///< It has no meaning for this candidate; the sentence says why.
  Undecided,      ///< Neither proven nor refuted: for removal orders by mean width, for surfaces at
                  ///< a tolerance, and for parts at a distance.
};
[[nodiscard]] const char* name_of(Status status);

/// The refutation of a claim. The claim decides which fields are set, see docs/verdicts.md; ids
/// count from 0, faces and rows in the order of the candidate's file.
struct Witness {
  std::optional<std::size_t> input_point;    ///< A point of the input.
  std::vector<std::size_t> vertices;         ///< Points of the candidate.
  std::vector<std::size_t> faces;            ///< Faces of the candidate's mesh.
  std::vector<std::size_t> rows;             ///< Rows of the candidate's list of halfspaces.
  std::optional<std::size_t> line;           ///< Of the candidate's file, from 1.
  std::optional<Halfspace> plane;            ///< The plane that a point or corner is beyond.
  std::optional<RationalPoint> point;        ///< The coordinates of that point or corner.
  std::optional<RationalPoint> nearest;      ///< Of the candidate, the point nearest to `point`.
  std::optional<RationalVector3> direction;  ///< In which the candidate is unbounded.
  std::optional<Rational>
      squared_distance;                   ///< Of `point` to `nearest`, else to `plane`; positive.
  std::optional<std::size_t> count;       ///< The count that exceeds a budget.
  std::vector<std::size_t> parts;         ///< Of a decomposition, counted from 0.
  std::optional<std::size_t> input_face;  ///< A face of the input's mesh.
  std::optional<long> winding;            ///< Of the input's surface about `point`.
  std::vector<std::size_t> nodes;         ///< Of a tree, counted from 0; a parent before its child.
};

struct Claim {
  ClaimCode code;
  Status status;
  std::string sentence;  ///< The finding, for people.
  Witness witness;       ///< Empty unless violated, or let pass by a tolerance.
  /// Whether the request named it; it is then no success if it is not applicable.
  bool is_named = false;
  /// Whether it is violated by `witness.squared_distance` alone, so that such a tolerance lets it
  /// pass.
  bool is_by_distance = false;

  /// Whether the request asked for what does not apply to this candidate.
  bool is_unanswered() const { return is_named && status == Status::NotApplicable; }
};

/// A candidate against the hull of the input. Ratios are candidate over hull; at least 1 if it
/// contains the input, since all three measures grow with the set.
struct Tightness {
  Enclosure volume_ratio, area_ratio, mean_width_ratio;
  /// Hausdorff distance between the two solids, in squared length units; exact.
  Rational squared_hausdorff;
};

/// How far each stored coordinate may be from the one that was meant: u.
struct Slack {
  Precision precision = Precision::Binary64;  ///< Whose units in the last place count.
  unsigned ulps_of_largest = 0;  ///< Of the largest coordinate; 0: half one of each coordinate.
};

/// "half a unit in the last place of each coordinate in binary64" and the like.
[[nodiscard]] std::string describe(const Slack& slack);

/// The format to whose numbers the coordinates were presumably rounded: binary32 if all are numbers
/// of binary32 and one of them needs more than 16 of its 24 bits; otherwise binary64.
[[nodiscard]] Precision precision_of(const PointSet& points);

/// The most that roundings in a program may add up to, in units in the last place of the largest
/// coordinate.
inline constexpr unsigned kRoundingUlps = 16;

/// One unit in the last place of a number of the format; of 0, the least positive number.
[[nodiscard]] Rational unit_in_last_place(Precision precision, const Rational& x);

/// The facets as they were meant, each a list of facets of the solid: the fewest *patches* found. A
/// patch is a set of facets, connected by edges, all of whose corners some plane comes near:
/// |n.p + d| <= |n_1| u_1 + |n_2| u_2 + |n_3| u_3, that is, they become coplanar when each
/// coordinate moves by at most its u. Such a plane is found by linear programs, exactly.
///
/// Where the solid is thinner along n than 1024 times the right side, rounding might explain
/// anything. There facets stay single, unless all corners of the patch remain corners of the solid
/// meant: three patches or more meet in each. The vertices of a solid of k facets that were rounded
/// pass that test; points of a thin cloud, whose facets happen to be nearly coplanar, do not.
///
/// Patches grow greedily from the largest facet down (where the solid is thin, once more from the
/// smallest up), so a smaller number of patches may exist. There are at most as many patches as
/// facets.
/// @par Cost  Doubles for each edge; for each that may lie inside a patch linear programs with the
///            patch's corners as rows.
/// @throws Error Stopped when the watch ends the call.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> planar_patches(const Polytope& polytope,
                                                                     const Slack& slack,
                                                                     const Watch& watch = {});

/// What a program was asked for, and so what is asked of its output.
enum class Asks {
  Enclosure,  ///< A convex solid that contains the input.
  Hull,       ///< The input's hull: the claim IsHull besides.
  Inner,     ///< A convex solid inside the hull of the input: InsideInput instead of ContainsInput.
  Simplify,  ///< An enclosure with at most a given number of facets, which the request must name.
};
/// "enclosure" and the like.
[[nodiscard]] const char* name_of(Asks asks);

/// Counts that a solid must not exceed; each one given is a claim.
struct Budgets {
  std::optional<std::size_t> max_facets = {}, max_vertices = {}, max_facet_vertices = {};
};

struct VerifyRequest : Budgets {
  /// The claims to decide; a budget is asked for by its number. Empty: all. Claims listed here and
  /// budgets must apply to the candidate for the verdict to hold.
  std::vector<ClaimCode> claims = {};
  /// Violations of planarity and convexity up to this distance from a plane, and of containment up
  /// to this distance from the candidate, pass; they are still reported.
  Tolerance tolerance = {};
  /// Whether `max_facets` is for the facets of a mesh as they are, not as they were meant.
  bool exact_facets = false;
  Asks asks = Asks::Enclosure;  ///< Which claims are the usual ones.
  /// The facets as meant are also looked for with this Slack::ulps_of_largest, if it is not 0; the
  /// smaller number counts.
  unsigned slack_ulps = 0;
  /// Of an input with faces, by point, whether a face uses it: used_points(). Empty: no faces.
  std::vector<bool> used = {};
  MeshPoints points = MeshPoints::All;  ///< Which points of an input with faces are asked.
  bool tightness = true;   ///< Whether to measure volume, area, mean width and distance.
  std::uint64_t seed = 1;  ///< Of every random order. The verdict does not depend on it.
  StageWatch watch = {};
};

/// The input points that lie outside a candidate.
struct Outside {
  std::size_t points = 0;  ///< How many.
  std::size_t tested = 0;  ///< Of how many.
  std::size_t unused = 0;  ///< How many of those outside no face of the input uses.
  /// (squared distance of the worst one to the candidate) / (squared diameter); nothing if the
  /// candidate is no bounded solid.
  std::optional<Rational> relative_squared_distance = {};
};

/// The counts of a candidate.
struct CandidateSize {
  std::size_t stored_faces = 0;     ///< Faces of the mesh, or rows of the list.
  std::size_t stored_vertices = 0;  ///< Points of the mesh; 0 for halfspaces.
  /// Of the solid, if there is one: coplanar faces as one facet, and its corners.
  std::optional<std::size_t> facets, vertices, most_facet_vertices;
  /// Of a mesh: the number of planar_patches() with this slack.
  std::optional<std::size_t> facets_as_meant;
  Slack slack;
  /// For each of its facets (of a mesh: as meant) that is in a facet plane of the input's hull, up
  /// to kRoundingUlps: that plane.
  std::optional<std::vector<Halfspace>> planes_of_the_input;
};

/// The least tolerance with which a violated verdict holds.
struct SmallestTolerance {
  std::string decimal;  ///< Absolute, rounded up.
  /// Whether rounding explains it: at most kRoundingUlps of the candidate's largest coordinate (of
  /// halfspaces: of the largest coordinate of the input).
  bool is_rounding;
};

struct Verdict {
  /// One for each of kAllClaims, in that order; then InsideInput or IsHull, if an inner solid or
  /// the hull was asked for.
  std::vector<Claim> claims;
  CandidateSize size;
  std::optional<Outside> outside;      ///< If containment was decided.
  std::optional<Tightness> tightness;  ///< If asked for, and the candidate is a bounded solid.
  Rational squared_diameter;           ///< Of the input: relative tolerances refer to it.
  /// If some claim is violated, and all that are by a distance only.
  std::optional<SmallestTolerance> smallest_tolerance;
  std::vector<std::string> notes;  ///< Further facts for people; they decide nothing.
  std::vector<Stage> stages;       ///< Each with its time, or the reason why it was left out.

  /// @throws std::out_of_range for a claim that is not among them.
  const Claim& operator[](ClaimCode code) const;
  /// Whether no claim is violated, and each that was named is decided.
  bool holds() const;
};

using VerifyOutcome = std::variant<Verdict, NotSolid>;

/// Decides every claim about `candidate` exactly. Containment is decided in two ways that share no
/// predicate: every input point against every plane (find_outside()), and the vertices of the
/// input's hull each against the candidate's triangle in its direction, or by a linear program for
/// each of its planes.
/// Points of the input keep their numbers, whichever are asked.
/// @return NotSolid if the *input* has no volume. Any fault of the candidate is a violated claim.
/// @throws Error InvalidArgument for a negative tolerance, for a budget that `claims` names without
///               a number, for a simplification without max_facets, and for a claim of another
///               question; Internal if the two ways disagree or a certificate fails.
/// @par Cost    Points times planes in doubles, the two hulls, and the measures asked for.
[[nodiscard]] VerifyOutcome verify(const Shape& input, const Candidate& candidate,
                                   const VerifyRequest& request = {});

/// A mesh or halfspaces: by the extension of `path` if it is a known one, otherwise by content. An
/// error in the bytes becomes the candidate's error.
/// @throws Error Unreadable for a format that is not read, with what to do.
[[nodiscard]] Candidate read_candidate_bytes(std::string_view bytes, const std::string& path,
                                             Decimal decimal = Decimal::Nearest);

/// The candidate in a file; "-" is standard input.
/// @throws Error Unreadable if there is no such file, as read_bytes.
[[nodiscard]] Candidate read_candidate(const std::string& path, Decimal decimal = Decimal::Nearest);

}  // namespace convexact
