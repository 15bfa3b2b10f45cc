// SPDX-License-Identifier: MIT
// stored_solid.hpp - a resulting solid with the points it must hold, in the formats asked for.
#pragma once
#include <optional>
#include <span>

#include "convexact/pipeline/stage.hpp"
#include "convexact/stored/stored_mesh.hpp"
#include "convexact/stored/stored_planes.hpp"

namespace convexact {

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

/// Rounds outward to each format asked for, and proves it. @param extreme  Of `points`: those whose
/// hull holds the rest.
/// @throws Error Unrepresentable if a format cannot hold the solid; Internal if a proof fails.
[[nodiscard]] StoredSolid store(Polytope exact, const PointSet& points,
                                std::span<const PointId> extreme, const StoreRequest& request,
                                StageLog& log);

}  // namespace convexact
