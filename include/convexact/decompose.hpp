// SPDX-License-Identifier: MIT
// decompose.hpp - a shape as the union of few convex parts, and what is proven of it. Cut parts
// hold the solid, and none is farther from it than a distance. Hacd and Acd make hulls of clusters
// of triangles whose concavity is small: they hold the surface, and what they leave uncovered of
// the solid is measured.
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "convexact/cluster.hpp"
#include "convexact/error.hpp"
#include "convexact/io.hpp"
#include "convexact/measure.hpp"
#include "convexact/number.hpp"
#include "convexact/partition.hpp"
#include "convexact/reach.hpp"
#include "convexact/scene.hpp"
#include "convexact/simplify.hpp"
#include "convexact/stored.hpp"

namespace convexact {

/// Where the parts come from.
enum class DecomposeMethod {
  Hacd,  ///< cluster(): triangles are merged.
  Acd,   ///< split(): the surface is split at notches.
  Cut,   ///< cut(): the solid is cut by planes. Its parts hold the solid, and are guarded and
         ///< merged by reach always.
  Auto,  ///< What with_method() chooses.
};

/// The treatment of clusters that lie in a plane.
enum class FlatParts {
  Auto,     ///< As Thicken, but a shape that is flat as a whole is not decomposed.
  Thicken,  ///< A part with a volume: both sides moved by about 2^-20 of the diameter, or by some
            ///< units in the last place of the coordinates if that is more.
  Keep,     ///< A polygon, a segment or a point.
  Merge,    ///< They join a neighbour, the one with which they are least concave, even beyond the
            ///< limit. Those without a neighbour are thickened.
};

/// The treatment of points that no face uses.
enum class LoosePoints {
  Part,    ///< Each goes to the part whose hull is nearest.
  Refuse,  ///< They are an error.
};

/// Whether parts are kept near the solid, or merged as long as they are (reach.hpp).
enum class ReachUse { None, Reach };

/// How much Cut tries to make fewer parts.
enum class CutEffort {
  Low,     ///< Leaves are merged once.
  Normal,  ///< And again with other preferences.
  High,    ///< And the solid is cut several times, into finer and coarser leaves, and across rings.
};

/// The distance from the solid that no point of a part may exceed, if the request says none.
inline const ConcavityLimit kDefaultDistance{Rational(3, 100), true};

struct DecomposeRequest {
  DecomposeMethod method = DecomposeMethod::Hacd;
  ConcavityLimit limit = {};
  /// Reach: no merge of Hacd makes a cluster whose hull reaches farther from the solid than
  /// `distance`, and Acd splits one that does.
  ReachUse guard = ReachUse::None;
  /// Reach: parts are merged in the end, adjacent or not, as long as their common hull reaches no
  /// farther than `distance`, whatever its concavity; those that add the least volume first. Until
  /// then they are guarded by half the distance, since finer parts merge into fewer.
  ReachUse merge = ReachUse::None;
  /// Of the solid, or of the surface if it is open; at least kLeastReach, or, of Cut, 0: no part
  /// has a volume outside of the solid, exactly. Without: kDefaultDistance.
  std::optional<ConcavityLimit> distance = {};
  Close close = Close::Auto;             ///< Of a surface for a guard, or for merging by reach.
  CutEffort effort = CutEffort::Normal;  ///< Of Cut.
  /// Of Cut, for a closed surface: how much larger the parts' volumes together may be than the
  /// solid's, as a share of it; >= 0. The excess, and what parts overlap, are within it, unless
  /// DecompositionExcess says that it is not held: by `max_parts`, by loose points, or because no
  /// attempt, with a quarter of the distance at last, was within it.
  std::optional<Rational> max_excess = {};
  /// Of Cut: parts have no common interior, but for what rounding moves their corners, and what
  /// `faces`, `max_parts`, thickening and loose points make of them: DecompositionApart tells.
  bool disjoint = false;
  /// >= 1. May lead beyond the limit; the result then says so.
  std::optional<std::size_t> max_parts = {};
  ConcavityMeasure measure = ConcavityMeasure::Surface;  ///< Of Hacd.
  BridgeChoice bridge = BridgeChoice::Farther;           ///< Of Acd.
  Rational coplanar{99, 100};                            ///< Of Acd: as SplitOptions.
  Connect connect = Connect::Edge;
  Orient orient = Orient::Auto;
  FlatParts flat = FlatParts::Auto;
  LoosePoints loose = LoosePoints::Part;
  bool keep_inner = false;           ///< Whether parts that lie in another part stay.
  Engine engine = Engine::Filtered;  ///< Of Hacd.
  /// Halfspaces to keep in each part, >= 4, or in all parts together, >= 4 for each part with a
  /// volume: the parts are simplified and still hold what they own. Thickened parts have a volume.
  /// A part keeps more if every removal is unbounded, as from a box.
  std::optional<std::size_t> faces = {}, total_faces = {};
  /// Corners that a part may have (>= 4), and those of each of its faces (>= 3), before they are
  /// rounded: a part with more keeps so few faces that it cannot have more, unless every removal is
  /// unbounded. Not with `total_faces`.
  std::optional<std::size_t> max_vertices = {}, max_facet_vertices = {};
  Precision precision = Precision::Binary64;
  PartMeasures measures = PartMeasures::All;
  bool exact_volumes = false;  ///< Volumes also as fractions.
  /// Of Hacd: as ClusterOptions. Without, `merges` of the result are not all.
  bool every_merge = true;
  /// Fill in the data of a trace: concavity and cost of each merge, associations of each node.
  bool for_trace = false;
  /// For Hacd: find the further merges of the clusters, for joins_of().
  bool for_tree = false;
  std::uint64_t seed = 1;  ///< Of every random order. The answer does not depend on it.
  /// Threads for cutting, for merging by reach and for what is made, proven and written of each
  /// part, >= 1; as many as the machine has cores if it is not given. The answer does not depend on
  /// it.
  std::optional<std::size_t> jobs = {};
  StageWatch watch = {};
};

/// How the stored solid of a part came from the hull of its points.
enum class PartForm {
  Hull,     ///< It is the hull: every corner is a point of the input, bit by bit, or, of Cut, one
            ///< where planes meet, without rounding.
  Rounded,  ///< The hull with its corners rounded outward: input with fractions, or binary32.
            ///< A box if it is too small for the numbers of the format.
  Simplified,  ///< Fewer halfspaces around it.
  Thickened,   ///< A flat hull, thickened; and simplified if it had more halfspaces than it may.
  Flat,        ///< A flat hull as it is.
};

/// A convex part. Its stored numbers, taken exactly, hold every triangle that it owns and its loose
/// points.
struct Part {
  std::vector<TriangleId> owns;     ///< Ascending. Every triangle has one owner.
  std::vector<TriangleId> cluster;  ///< That it was made of: `owns` and perhaps fewer.
  /// Of Cut: the leaves of the partition whose hulls it holds, ascending; each leaf has one part.
  /// Then `owns` are the triangles that lie in these leaves, and a triangle that planes cut may
  /// have no owner.
  std::vector<std::uint32_t> leaves = {};
  /// Of `surface.unused`: they go where they are nearest to the clusters' hulls. Each point has one
  /// part.
  std::vector<PointId> loose;
  /// The lowest triangles of further clusters that were merged with it by reach, ascending.
  std::vector<TriangleId> merged = {};
  bool is_widened = false;  ///< Whether some of these lay outside of the cluster's hull.
  ConvexPart hull;          ///< Of the cluster, of those merged with it, and the loose points.
  Concavity concavity;      ///< Of the cluster.
  bool is_within_limit = true;
  /// Of Acd: no association of points to facets gives a smaller squared concavity. None for a
  /// cluster that a flat one joined.
  std::optional<Rational> least_squared_concavity = {};
  /// Of Acd: no plane through its deepest notch leaves something on both sides.
  bool is_unsplittable = false;
  PartForm form = PartForm::Hull;
  /// The faces of the part before its corners were rounded, since rounding may bend faces: the
  /// number that a budget counts. 0 for a flat part.
  std::size_t faces = 0;
  /// Corners and faces as stored. A flat one has one polygon (its points are counter-clockwise seen
  /// from one side), or a segment or point and no polygon.
  Mesh mesh;
  std::vector<Halfspace> halfspaces;  ///< The hull of mesh.points, proven to hold what it owns.
};

/// A cluster that lies in the hull of another one, or in its part as stored, and so becomes no
/// part.
struct InnerCluster {
  TriangleId lowest;  ///< Of its triangles.
  std::size_t part;   ///< The part that holds it.
};

/// How far the parts as stored reach from the solid.
struct DecompositionReach {
  Rational squared_distance;  ///< That was allowed.
  /// The parts that are not proven to be within it, ascending, with a point that is farther, or
  /// with bounds. Parts may reach farther if they were simplified or thickened, if a single
  /// triangle or `max_parts` made them, or if loose points widened them.
  struct Farther {
    std::size_t part;
    PartReach reach;
  };
  std::vector<Farther> farther;
  std::size_t refused = 0;  ///< Merges, or leaves of splits, that the guard refused.
  std::size_t merged = 0;   ///< Parts that became a piece of another one in the end.
  std::size_t cells = 0;    ///< Of the octree that decided.
};

/// How much larger the volumes of the parts as stored are together than the solid's.
struct DecompositionExcess {
  Rational most;    ///< That was allowed, as a share of the solid's volume.
  Enclosure share;  ///< That it is.
  bool holds;       ///< Whether it is no more than allowed: decided exactly.
};

/// How far parts that are to be disjoint reach into one another, as stored.
struct DecompositionApart {
  /// The most that a part reaches beyond a plane between it and another one, squared.
  Rational squared_push = 0;
  /// A plane between two parts, `first` < `second`.
  struct Between {
    std::size_t first, second;
    PlaneBetween plane;
  };
  std::vector<Between> planes;  ///< Between each two parts, ascending.
};

/// Of a triangle that several parts hold together.
inline constexpr std::uint32_t kNoOwner = ~std::uint32_t{0};

struct Decomposition {
  Surface surface;
  std::size_t caps = 0;              ///< That closed it, as in ClosedSurface.
  Rational squared_largest_cap = 0;  ///< The squared diagonal of the box of the largest border.
  std::variant<Clustering, SplitTree, Partition> origin;  ///< Where the parts come from.
  std::vector<Part> parts;           ///< In the order of the lowest triangles of their
                                     ///< clusters.
  std::vector<std::uint32_t> owner;  ///< By triangle: into `parts`, or kNoOwner.
  std::vector<InnerCluster> inner;   ///< Clusters that were dropped.
  std::vector<TriangleId>
      flat_merged;                   ///< Flat clusters that joined a neighbour (FlatParts::Merge).
  bool limit_holds = true;           ///< Whether every cluster is within the limit.
  std::size_t tested_triangles = 0;  ///< Whose corners were tested against their owner.
  std::optional<DecompositionReach> reach;        ///< With a guard, or merges by reach.
  std::optional<DecompositionExcess> excess;      ///< With `max_excess`.
  std::optional<DecompositionApart> apart;        ///< With `disjoint`.
  std::optional<DecompositionMeasures> measures;  ///< Beside the proof, of the parts as stored.
  std::vector<Stage> stages;

  const Rational& squared_limit() const {
    return std::visit([](const auto& x) -> const Rational& { return x.squared_limit; }, origin);
  }
  const Rational& squared_diameter() const {
    return std::visit([](const auto& x) -> const Rational& { return x.squared_diameter; }, origin);
  }
  /// The clusters of the origin (of Cut: none), in the order of their lowest triangles, before flat
  /// ones joined others and inner ones joined the parts of others.
  std::vector<std::span<const TriangleId>> clusters() const;
  /// Whether the number of parts ended the run, not the limit.
  bool stopped_by_count() const {
    return std::visit([](const auto& x) { return x.stopped_by_count; }, origin);
  }
};

/// The request with a method, if it has none: Cut for a closed surface, or one that is closed by
/// caps; for an open one Hacd, guarded and merged by reach. Hacd as it is published if the request
/// has an option that Cut has not: a concavity, a measure, a connection, a guard, merging.
/// @throws Error as make_surface(), which it asks.
[[nodiscard]] DecomposeRequest with_method(const Mesh& mesh, DecomposeRequest request);

using DecomposeOutcome = std::variant<Decomposition, NotSolid>;

/// Decomposes a mesh and proves on the stored numbers that every triangle lies in its owner.
/// @return NotSolid if all points of faces lie in one plane, unless `flat` is Thicken or Keep.
/// @throws Error NoInterior if the mesh has no face; InvalidArgument for points that no face uses
///               if these are refused, for what cluster(), split() and simplify() refuse, for an
///               option of the other method, for a `max_excess` without a solid, and for budgets
///               that cannot hold; Unrepresentable if the format cannot hold a part; Stopped;
///               Internal if a proof fails.
[[nodiscard]] DecomposeOutcome decompose(const Mesh& mesh, const DecomposeRequest& request = {});

// ---- Convex parts as files give them, alone or under a tree of hulls.

/// A part as its file gives it. It stands for the convex hull of its points.
struct NamedPart {
  std::string name;
  Mesh mesh;
};

/// A node of a tree as its file gives it, whether or not it is valid. Nodes are named by their
/// positions in HullTree::nodes.
struct HullTreeNode {
  std::optional<std::size_t> parent;  ///< None of the root.
  std::vector<std::size_t> children;  ///< None of a leaf.
  std::optional<std::size_t> part;    ///< For a leaf: its part, whose hull is the node's.
  Mesh mesh;                          ///< For a branch: its hull is that of these points.
};

/// Parts, and a tree whose leaves they are. Each hull is meant to hold the hulls of the children.
struct HullTree {
  std::vector<NamedPart> parts;
  std::vector<HullTreeNode> nodes;

  /// The points whose hull a node stands for. Precondition: a part, if it names one, exists.
  const Mesh& mesh_of(std::size_t node) const {
    const HullTreeNode& of = nodes[node];
    return of.part ? parts[*of.part].mesh : of.mesh;
  }
};

/// Parts, with or without a tree; or the error (Malformed or NotFinite) that reading them met.
using CandidateParts = std::variant<std::vector<NamedPart>, HullTree, Error>;

/// The parts in a file: in an OBJ the objects or groups that have faces, in an STL the solids; in
/// JSON the entries of "parts", each with "vertices" and possibly "name" and "faces", and the tree
/// under "hull_tree", if there is one; any other mesh is a single part. A part of several
/// has the points of its faces and its loose points (MeshPart); a single one has all points.
[[nodiscard]] CandidateParts read_parts_bytes(std::string_view bytes, const std::string& path,
                                              Decimal decimal = Decimal::Nearest);

/// The parts in the file, or in the meshes of the folder, by their names: "part_2.obj" before
/// "part_10.obj". Other files of a folder are not read; "-" is standard input.
/// @throws Error Unreadable if there is no such file or folder, or no mesh in the folder.
[[nodiscard]] CandidateParts read_parts(const std::string& path,
                                        Decimal decimal = Decimal::Nearest);

/// The parts that were read; null if reading met an error.
[[nodiscard]] const std::vector<NamedPart>* parts_of(const CandidateParts& candidate);

}  // namespace convexact
