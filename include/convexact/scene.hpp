// SPDX-License-Identifier: MIT
// scene.hpp - from a shape to its solid, in stages that are timed or skipped.
#pragma once
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "convexact/dual.hpp"
#include "convexact/error.hpp"
#include "convexact/geometry.hpp"
#include "convexact/hull.hpp"
#include "convexact/io.hpp"
#include "convexact/linear_program.hpp"
#include "convexact/number.hpp"
#include "convexact/stored.hpp"

namespace convexact {

enum class StageKind { Io, Compute };

/// The names of the stages that a caller may look for.
namespace stage {
inline constexpr const char* kHull = "hull";          ///< From points to the facets of their hull.
inline constexpr const char* kSimplify = "simplify";  ///< The removals.
inline constexpr const char* kSearch = "search";      ///< Exchanges after them.
inline constexpr const char* kOptimum = "optimum";    ///< The same, and the search for the least.
}  // namespace stage

struct Stage {
  std::string name;
  StageKind kind = StageKind::Compute;
  double seconds = 0;   ///< Wall time; 0 for a skipped stage.
  std::string skipped;  ///< Why the stage was not needed; empty if it ran.
};

/// Points that span no volume, or halfspaces whose intersection is empty, flat or unbounded.
using NotSolid = std::variant<FlatInput, EmptyProof, FlatProof, RecessionRay>;

/// A proof about the halfspaces of a list, in terms of its rows as typed: the multipliers are
/// theirs, so that y'N = 0 holds with the numbers of the file, and rows count from 0, dropped ones
/// included.
/// @param rows  Of the list; without any, the proof stays as it is.
[[nodiscard]] NotSolid of_typed_rows(NotSolid reason, const TypedRows& rows);

/// One sentence for people: the kind of the input, and its proof. Points and halfspaces
/// count from 0.
[[nodiscard]] std::string describe(const NotSolid& reason);

/// What was found of a solid, for callers to whom any other input is an error.
/// @throws Error NoInterior, saying what describe() says.
template <class Result>
[[nodiscard]] Result require_solid(std::variant<Result, NotSolid> outcome) {
  if (auto* result = std::get_if<Result>(&outcome)) return std::move(*result);
  throw Error(ErrorCode::NoInterior, describe(std::get<NotSolid>(outcome)));
}

/// A shape to be enclosed: the hull of points, or an intersection of halfspaces.
using Shape = std::variant<PointSet, std::vector<Halfspace>>;

/// Formats to store a solid in, beside the exact integers, which are always there.
struct StoreRequest {
  std::optional<Precision> planes;
  std::optional<Precision> mesh;
};

struct Stored {
  Polytope exact;
  PointSet points;  ///< The points that it holds: the input's points, or the vertices of the
                    ///< input's polytope.
  std::optional<StoredPlanes> planes;
  std::optional<StoredMesh> mesh;

  /// n1, n2, n3, d of each halfspace in doubles, rounded outward and proven to hold every point:
  /// `planes` if they are stored in binary64, otherwise made now, as store_planes().
  /// @throws Error Unrepresentable if doubles cannot hold them.
  [[nodiscard]] std::vector<std::array<double, 4>> planes_in_doubles() const;
};

/// One object, to be enclosed separately.
struct SceneObject {
  std::string name;  ///< The file, or "file: part".
  std::string part;  ///< The part's name; the file's stem without parts.
  Shape shape;
  std::vector<std::vector<std::uint32_t>> polygons;  ///< Of point input, for its picture.
  TypedRows rows = {};                               ///< Of halfspace input.
  std::vector<MeshPart> groups = {};                 ///< Of its polygons, by name.
};

struct SceneOptions {
  Decimal decimal = Decimal::Nearest;
  bool parts = false;  ///< Whether each object of a file is separate.
  /// Of a file, or with `parts` of each of its objects.
  MeshPoints points = MeshPoints::All;
  bool skip_bad = false;  ///< As ReadOptions::skip_bad.
  /// Leave polygons and groups out of objects, unless `parts` or `points` needs them.
  bool points_only = false;
  /// Called with the name of the file and each of Mesh::notes.
  std::function<void(const std::string& name, const std::string& note)> on_note = {};
  /// Called with the name and the bytes of each file before it is parsed. To keep the bytes costs
  /// no copy.
  std::function<void(const std::string& name, std::shared_ptr<const std::string> bytes)> on_read =
      {};
};

/// Redundant halfspaces of a list by their rows in the file, counted from 0.
/// @param rows  Of the list; without any, the numbers stay as they are.
[[nodiscard]] std::vector<std::size_t> to_typed_rows(std::vector<std::size_t> redundant,
                                                     const TypedRows& rows);

/// Reads files one after another: meshes, or halfspaces (.json, .ine, or by content).
/// @throws Error as the readers; Unreadable for a format that is not read, with what to do;
/// NoInterior if a halfspace list has a row that no point satisfies;
///         InvalidArgument for parts of a file that has none, or standard input twice.
[[nodiscard]] std::vector<SceneObject> read_scene(const std::vector<std::string>& paths,
                                                  const SceneOptions& options = {});

/// The solid that encloses an object, under its name in a file of several.
struct NamedSolid {
  std::string name;
  const Stored* solid;  ///< With a mesh, if the file is one.
};

/// The bytes of a mesh or halfspace file, by the extension of `path`: read back from them, every
/// solid holds the points that it must hold. Only an OBJ holds several solids, a part for each.
/// @throws Error Internal if the bytes miss a point.
[[nodiscard]] std::string proven_bytes(std::span<const NamedSolid> solids, const std::string& path);

}  // namespace convexact
