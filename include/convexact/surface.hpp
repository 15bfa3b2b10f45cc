// SPDX-License-Identifier: MIT
// surface.hpp - the surface that a mesh spells: triangles on distinct points, how they are joined
// and turned, winding numbers, and the solid that a closed surface bounds.
//
// Nothing depends on the order in which a file lists its points and faces: points stand in
// lexicographic order, triangles in the order of their sorted points.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/geometry.hpp"
#include "convexact/io.hpp"
#include "convexact/number.hpp"

namespace convexact {

using TriangleId = Id<struct TriangleTag>;  ///< Into the triangles of a surface.

/// Which triangles may be turned.
enum class Orient {
  Auto,  ///< Along edges with two triangles; closed components so that they bound the solid
         ///< correctly.
  Keep,  ///< None.
};

struct SurfaceOptions {
  Orient orient = Orient::Auto;
};

/// Triangles joined along their edges, over any number of triangles. A border edge has one.
struct SurfaceComponent {
  std::size_t triangles = 0;
  std::size_t border_edges = 0;
  std::size_t branching_edges = 0;  ///< With more than two triangles.
  bool is_closed = false;           ///< Every directed edge cancels.
  /// Whether the triangles can be turned so that all edges with two triangles cancel; not so for a
  /// Moebius strip and a Klein bottle.
  bool is_orientable = true;
  std::size_t turned = 0;    ///< Triangles that were turned.
  bool is_reversed = false;  ///< Closed, and all were turned: it was inside out.
  bool is_flat = false;      ///< No triangle has an area.
};

struct Surface {
  /// Distinct points that triangles use, in lexicographic order.
  PointSet points;
  /// Corners counter-clockwise from outside, lowest id first; ascending by sorted corners. A
  /// repeated triangle is repeated here. Triangles without area are kept, as their points must be
  /// held: two or three of their corners may be one point.
  std::vector<std::array<PointId, 3>> triangles;
  std::vector<std::uint32_t> face;           ///< By triangle: the polygon of the mesh, from 0.
  std::vector<std::uint32_t> component;      ///< By triangle: into `components`.
  std::vector<SurfaceComponent> components;  ///< By their lowest triangles.

  // How it came about.
  std::size_t repeated_points = 0;  ///< Points of the mesh equal to an earlier one.
  PointSet unused;                  ///< Distinct points of the mesh that no face uses.
  /// Faces of the mesh, from 0, that are not planar, or whose boundary crosses itself: cut as a fan
  /// from their lowest corner. (A face with a hole, whose loop goes to the hole and back, is
  /// neither.)
  std::vector<std::size_t> fans;
  std::size_t bent_faces = 0;          ///< Of these: not planar.
  std::size_t flat_triangles = 0;      ///< Without area.
  std::size_t repeated_triangles = 0;  ///< With the corners of an earlier one, in any direction.
  /// Edges between two triangles that cannot cancel, of components that are not orientable, or that
  /// were left as they are.
  std::size_t contradictions = 0;
  /// Edges of four triangles or more at which the patches that meet there can be turned so that
  /// they cancel in several ways, or in none.
  std::size_t ambiguous_edges = 0;

  /// Whether every directed edge cancels, so that winding numbers exist. The solid is then the
  /// closure of the points whose winding number is not 0.
  bool is_closed = false;
};

/// Welds equal points, cuts faces into triangles (planar ones that bound a region exactly, others
/// as a fan), finds components, and turns triangles, patch by patch: a patch is connected over
/// edges of exactly two triangles. Patches are made consistent, and those that are not closed by
/// themselves are joined at edges of four if exactly one choice makes these cancel. Most of the
/// area keeps its direction. What is closed then and lies in nothing else is turned so that its
/// signed volume is positive; what lies in something, which holds a vertex of it off its own
/// surface, is turned if the outermost was, so that voids stay voids.
/// @throws Error InvalidArgument if the mesh has no face; Stopped when the watch ends the call.
/// @par Cost  O(n log n), and for several closed components the tests of one in another.
[[nodiscard]] Surface make_surface(const Mesh& mesh, const SurfaceOptions& options = {},
                                   const Watch& watch = {});

/// A surface, perhaps with caps over its borders.
struct ClosedSurface {
  Surface surface;
  std::size_t caps = 0;          ///< Fans over borders; their faces follow those of the mesh.
  Rational squared_largest = 0;  ///< The squared diagonal of the box of the largest border.
};

/// The square of how many times larger the surface's box must be than that of each border.
inline constexpr long kBorderShare = 16;

/// make_surface(); and if some borders are open, each no larger than a quarter of the diameter,
/// with a fan of triangles over each, from the mean of its corners, rounded to doubles. As it was
/// if a border is larger, or if that does not close it.
/// @throws Error as make_surface().
[[nodiscard]] ClosedSurface make_closed_surface(const Mesh& mesh,
                                                const SurfaceOptions& options = {},
                                                const Watch& watch = {});

/// Whether small borders are closed before anything else.
enum class Close {
  Auto,   ///< By make_closed_surface().
  Never,  ///< Not at all.
};

/// How many points lie within a millionth of the diameter of another one, if more than half of the
/// components are open, and there are several; otherwise 0. So it is where a file repeats the
/// corners of each face, but rounded differently.
/// @par Cost  O(n log n) if the points are spread.
[[nodiscard]] std::size_t count_near_corners(const Surface& surface);

/// A mesh whose faces have common corners where they had near ones. All points are still there:
/// those that no face uses any more are loose.
struct WeldedMesh {
  Mesh mesh;
  std::size_t moved = 0;      ///< Corners that became another point, elsewhere.
  Rational squared_move = 0;  ///< The largest of these distances, squared.
};

/// In lexicographic order, each corner of a face that is still free takes all free ones within a
/// distance. So there are no chains, and none moves farther. Exact.
/// @param squared_reach  The square of that distance, >= 0.
/// @throws Error InvalidArgument if it is negative; Stopped when the watch ends the call.
/// @par Cost  O(n log n), and the pairs that are near.
[[nodiscard]] WeldedMesh weld(const Mesh& mesh, const Rational& squared_reach,
                              const Watch& watch = {});

/// Winding numbers of points about a closed surface, exactly.
class Winding {
 public:
  /// Keeps a reference. @throws Error InvalidArgument unless surface.is_closed.
  explicit Winding(const Surface& surface);
  ~Winding();

  /// How often the surface winds about x; nothing if x lies on it.
  /// @par Cost  The triangles above or below x, found by a tree; most by doubles.
  std::optional<long> operator()(const RationalPoint& x) const;

  /// Beside a point x in the interior of a triangle with an area: the winding numbers just before
  /// it (where its normal points) and just behind it. Other triangles may hold x, too. Exact.
  std::pair<long, long> beside(TriangleId triangle, const RationalPoint& x) const;

  /// The winding number of the points just beside x along a direction, which is not 0: x may lie
  /// on the surface, but points along the direction are taken to be off it. Where they are not, as
  /// if the direction were turned a little. Exact.
  long towards(const RationalPoint& x, const RationalVector3& direction) const;

 private:
  class Search;
  std::unique_ptr<const Search> search_;
};

}  // namespace convexact
