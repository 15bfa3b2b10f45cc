// SPDX-License-Identifier: MIT
// scene.hpp - from a shape to its solid, in stages that are timed or skipped.
#pragma once
#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "convexact/dual.hpp"
#include "convexact/error.hpp"
#include "convexact/halfspace.hpp"
#include "convexact/hull.hpp"
#include "convexact/linear_program.hpp"
#include "convexact/number.hpp"
#include "convexact/stored.hpp"
#include "convexact/watch.hpp"

namespace convexact {

enum class StageKind { Io, Compute };

struct Stage {
  std::string name;
  StageKind kind = StageKind::Compute;
  double seconds = 0;   ///< Wall time; 0 for a skipped stage.
  std::string skipped;  ///< Why the stage was not needed; empty if it ran.
};

/// Points that span no volume, or halfspaces whose intersection is empty, flat or unbounded.
using NotSolid = std::variant<FlatInput, EmptyProof, FlatProof, RecessionRay>;

/// A proof about the halfspaces of a list, told of its rows as typed: the multipliers are theirs,
/// so that y'N = 0 holds with the numbers of the file, and rows count from 0, dropped ones
/// included.
/// @param rows  Of the list; without any, the proof stays as it is.
[[nodiscard]] NotSolid of_typed_rows(NotSolid reason, const TypedRows& rows);

/// One sentence for people: what the input is, and what the proof consists of. Points and
/// halfspaces count from 0.
[[nodiscard]] std::string describe(const NotSolid& reason);

/// What is to be enclosed: the hull of points, or an intersection of halfspaces.
using Shape = std::variant<PointSet, std::vector<Halfspace>>;

/// Formats to store a solid in, beside the exact integers, which are always there.
struct StoreRequest {
  std::optional<Precision> planes;
  std::optional<Precision> mesh;
};

struct StoredSolid {
  Polytope exact;
  PointSet points;  ///< What it holds: the input's points, or the vertices of the input's polytope.
  std::optional<StoredPlanes> planes;
  std::optional<StoredMesh> mesh;
};

}  // namespace convexact
