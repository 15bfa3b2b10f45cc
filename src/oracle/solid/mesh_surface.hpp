// SPDX-License-Identifier: MIT
// mesh_surface.hpp - faults in the faces of a mesh that should bound a convex solid.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/hull.hpp"
#include "convexact/io.hpp"
#include "task/lazy.hpp"

namespace convexact {

/// An edge between two points of a mesh and the faces that have it.
struct MeshEdge {
  std::uint32_t tail, head;
  std::vector<std::size_t> faces;
};

/// A face that is no simple polygon.
struct CrossedFace {
  std::size_t face;
  /// The ends of two of its edges that meet (in a bent face: seen along the axis on which its area
  /// is largest); none if all its corners lie on a line.
  std::vector<std::uint32_t> corners;
};

/// A point of the mesh off the plane of a face: a corner of the face, or a point beyond it.
struct PointOffFace {
  std::size_t face;
  PointId point;
  Halfspace plane;            ///< Through the face's first corner, normal to its area vector.
  Rational squared_distance;  ///< Of the point to the plane; positive.
};

/// Superfluous elements of a mesh, without which the surface is the same.
struct Surplus {
  std::size_t zero_edges = 0;                 ///< Edges between points at the same place.
  std::vector<std::size_t> degenerate_faces;  ///< Fewer than three different corners.
  std::vector<std::size_t> slivers;           ///< Three corners or more, all on a line.
};

/// The faces of a mesh: points at the same place are one, edges between them are gone, and so are
/// the faces that are left with fewer than three different corners. Faces keep their numbers.
class MeshSurface {
 public:
  /// Keeps a reference. @par Cost  O(n log n).
  explicit MeshSurface(const Mesh& mesh);

  const Surplus& surplus() const { return surplus_; }
  /// Whether no face is left.
  bool is_empty() const { return edges_.empty(); }
  /// An edge that does not have exactly two faces, or the same face twice.
  [[nodiscard]] std::optional<MeshEdge> open_edge() const;
  /// An edge along which two faces run in the same direction, so that one of them is turned over.
  [[nodiscard]] std::optional<MeshEdge> twisted_edge() const;
  /// A face that crosses or touches itself, exactly; if the corners lie on a line, they must run
  /// along it once to and fro. @throws Error Stopped when the watch ends the call.
  [[nodiscard]] std::optional<CrossedFace> crossed_face(const Watch& watch) const;
  /// The corner that is farthest from the plane of its face.
  [[nodiscard]] std::optional<PointOffFace> most_bent() const;
  /// Six times the volume that the faces enclose, positive if they look outward. Meaningful if
  /// there is neither an open nor a twisted edge.
  [[nodiscard]] const Rational& enclosed() const;

  /// Among the faces that are bent or not in a facet plane of the hull of the mesh's points, the
  /// one that a point is farthest beyond; if no point is beyond any of them, the one that is most
  /// bent.
  /// @param hull  Of the mesh's points. @param planes  Those of its facets.
  struct OffHull {
    std::size_t faces = 0;              ///< How many faces are off.
    std::optional<PointOffFace> worst;  ///< Set if there are any.
  };
  [[nodiscard]] OffHull faces_off(const Hull& hull, std::span<const Halfspace> planes) const;

 private:
  struct DirectedEdge {
    std::uint32_t from, to;
    std::size_t face;
  };
  using Edges = std::span<const DirectedEdge>;
  template <class IsFault>
  std::optional<MeshEdge> find_edge(const IsFault& is_fault) const;
  bool is_on_a_line(std::size_t face) const;
  bool goes_to_and_fro(std::size_t face) const;
  std::optional<CrossedFace> crossing_of(std::size_t face, const Watch& watch) const;
  std::optional<PointOffFace> bend_of(std::size_t face) const;
  const Mesh& mesh_;
  std::vector<std::vector<std::uint32_t>> faces_;  // corners by the first point at their place
  std::vector<RationalVector3> area_vectors_;
  std::vector<DirectedEdge> edges_;  // sorted by their ends, whichever comes first
  Surplus surplus_;
  Lazy<Rational> enclosed_;
};

}  // namespace convexact
