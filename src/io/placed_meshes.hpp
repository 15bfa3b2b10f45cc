// SPDX-License-Identifier: MIT
// placed_meshes.hpp - the meshes of a scene where its nodes put them: each instance is an object.
#pragma once
#include <string>
#include <vector>

#include "convexact/io.hpp"
#include "io/placement.hpp"
#include "io/point_merger.hpp"

namespace convexact {

/// A mesh in its own coordinates.
struct LocalMesh {
  PointSet points;
  std::vector<std::vector<std::uint32_t>> polygons;
  std::vector<std::uint32_t> loose;  ///< Points that count without a polygon.
};

/// How deep nodes of a scene may lie within each other: coordinates grow by some 200 bits a level.
inline constexpr std::size_t kMaxSceneDepth = 256;

class PlacedMeshes {
 public:
  explicit PlacedMeshes(const ReadOptions& options)
      : decimal_(options.decimal), points_(options.decimal) {}

  /// A mesh at its place: computed in rationals and rounded once, as the options say. Equal points
  /// become one; a mirror image has its polygons turned, so that its outside stays outside.
  /// @throws Error Malformed for a placement that flattens, and beyond 100 million corners in all
  ///               instances; NotFinite beyond the largest number.
  void add(const std::string& name, const LocalMesh& mesh, const Placement& placement);

  /// With a note of the largest move by rounding.
  [[nodiscard]] Mesh finish();

 private:
  std::uint32_t add_point(const PointSet& points, std::uint32_t index, const Placement& placement,
                          bool is_placed);

  Decimal decimal_;
  PointMerger points_;
  Mesh mesh_;
  std::size_t corners_ = 0;
  std::size_t moved_ = 0;    // instances with a coordinate that was rounded
  double largest_move_ = 0;  // of a coordinate
};

}  // namespace convexact
