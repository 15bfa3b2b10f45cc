// SPDX-License-Identifier: MIT
// implicit.hpp - implicit shapes, and the cells of an octree that may hold their surface.
//
// A shape is the solid {f <= 0} of a function f that is Lipschitz: |f(x) - f(y)| <= L |x - y|. So a
// ball of radius |f(m)| / L around m holds no point of the surface. docs/implicit.md has the idea,
// docs/formats.md the formula of each node.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/geometry.hpp"
#include "convexact/number.hpp"

namespace convexact {

class ImplicitShape;

/// The nodes that a shape is made of. Lengths are in the caller's unit, directions need not be
/// normalised, and all numbers are exactly the doubles that they are.
namespace implicit {

struct Sphere {
  Point center;
  double radius;  ///< Above 0.
};
/// All points within `radius` of a segment.
struct Capsule {
  Point from, to;  ///< Different points.
  double radius;   ///< Above 0.
};
/// low <= x <= high in each coordinate; with a radius, its edges and corners are rounded off.
struct Box {
  Point low, high;    ///< low < high in each coordinate.
  double radius = 0;  ///< From 0 to half of the shortest side.
};
/// All points within `minor` of the circle of radius `major` around the axis.
struct Torus {
  Point center;
  Point axis;           ///< Not zero.
  double major, minor;  ///< Above 0.
};
struct Cylinder {
  Point from, to;  ///< Centers of its ends; different points.
  double radius;   ///< Above 0.
};
/// normal . x + offset <= 0, as all halfspaces of the library.
struct Plane {
  Point normal;  ///< Not zero.
  double offset;
};
/// The least value of its parts.
struct Union {
  std::vector<ImplicitShape> of;  ///< At least one, as in the following two.
};
/// The greatest value of its parts.
struct Intersection {
  std::vector<ImplicitShape> of;
};
/// The first part without all others: the greatest of f_0, -f_1, -f_2, ...
struct Difference {
  std::vector<ImplicitShape> of;
};
/// min(a, b) - max(radius - |a - b|, 0)^2 / (4 radius): the joint of both is filled.
struct SmoothUnion {
  std::vector<ImplicitShape> of;  ///< Two.
  double radius;                  ///< Above 0.
};
struct Translate {
  std::vector<ImplicitShape> of;  ///< One, as in the following three.
  Point by;
};
/// The rotation by a quaternion (w, x, y, z) around the origin.
struct Rotate {
  std::vector<ImplicitShape> of;
  std::array<Rational, 4> quaternion;  ///< w^2 + x^2 + y^2 + z^2 is exactly 1.
};
/// Each coordinate times a factor. The value is that at the point before scaling times the least
/// factor, so a Lipschitz constant stays one.
struct Scale {
  std::vector<ImplicitShape> of;
  Point factors;  ///< Above 0.
};
/// The value less `by`: all points within `by` of the shape, where the value is a distance.
struct Offset {
  std::vector<ImplicitShape> of;
  double by;  ///< Of either sign.
};

using Node = std::variant<Sphere, Capsule, Box, Torus, Cylinder, Plane, Union, Intersection,
                          Difference, SmoothUnion, Translate, Rotate, Scale, Offset>;

}  // namespace implicit

/// How far f follows the distance from the shape.
struct ImplicitBounds {
  /// |f(x) - f(y)| <= lipschitz |x - y| for all x and y. 1 for every node here.
  Rational lipschitz = 1;
  /// Where it is known: f(x) >= tightness dist(x, {f <= 0}) for every x outside.
  std::optional<Rational> tightness;
};

/// A real number between two doubles; an end may be infinite.
struct ImplicitRange {
  double low, high;
};

/// A rotation matrix, row by row.
struct ImplicitRotation {
  std::array<Rational, 9> exact;
  std::array<ImplicitRange, 9> rounded;  ///< The same entries.
};

/// A tree of nodes, and what is known about its function. Copies share the tree.
class ImplicitShape {
 public:
  /// @throws Error NotFinite for NaN and infinity; InvalidArgument for a number out of the range of
  ///               its node, and for a tree of more than 64 levels.
  explicit ImplicitShape(implicit::Node node);

  const implicit::Node& node() const;
  const ImplicitBounds& bounds() const;
  /// The levels of the tree: 1 for a primitive.
  std::size_t levels() const;
  /// Of a Rotate node: the matrix that rotates a point back. Null for other nodes.
  const ImplicitRotation* rotation_back() const;

 private:
  struct Tree;
  std::shared_ptr<const Tree> tree_;
};

/// f(x), in doubles that are rounded outward. An end is infinite where doubles overflow.
[[nodiscard]] ImplicitRange enclose_value(const ImplicitShape& shape, const Point& x);

/// f(x) in numbers of `precision` bits.
/// @throws Error Unrepresentable beyond 2^(2^30).
[[nodiscard]] Enclosure enclose_value(const ImplicitShape& shape, const RationalPoint& x,
                                      long precision);

/// Volume, area and mean width of a convex shape.
struct ImplicitMeasures {
  Enclosure volume, area, mean_width;
};

/// These measures in closed form, for a sphere, capsule, box, rounded box and cylinder, moved,
/// scaled by one factor or offset outward. Nothing for any other shape.
[[nodiscard]] std::optional<ImplicitMeasures> closed_measures(const ImplicitShape& shape,
                                                              long precision);

/// A cube with its edges along the axes.
struct ImplicitBox {
  Point low;
  double edge;  ///< Above 0.
};

/// Cells of an octree. A cell of center m and edge h is dropped if it is proven that
/// |f(m)| > L sqrt(3) h / 2: then it holds no point of the surface.
struct ImplicitCells {
  /// One level: how many cells of edge `edge` / 2^level were tested, and how many kept.
  struct Level {
    std::size_t tested = 0;
    std::size_t kept = 0;
    std::size_t undecided = 0;  ///< Of the kept ones: the bounds decide neither way.
  };
  std::vector<Level> levels;                        ///< From 0, the box, to the depth.
  std::vector<std::array<std::uint32_t, 3>> leaves; /**< The kept cells of the last level, by number
                                                         along each axis, in ascending order. */
  std::vector<Point> corners;                       ///< Of all leaves, each once, exactly.
  double leaf_edge = 0;
  /// Where the tightness is known: each corner is within this distance of the solid, rounded up.
  std::optional<double> distance;
};

/// Beyond this many cells of one level the answer is an error: their corners and the hull of them
/// would take gigabytes.
inline constexpr std::size_t kMostImplicitCells = std::size_t(1) << 21;
inline constexpr std::size_t kMostImplicitDepth = 20;

/// Splits the cells that are kept, level by level. The hull of the corners holds the solid.
/// @param depth  Of the leaves; 0 is the box itself. At most kMostImplicitDepth.
/// @param watch  Receives the numbers of cells tested and to be tested on each level.
/// @throws Error NoInterior if no leaf is kept, and if a cell at the surface of the box is not
///               proven to lie outside of the shape: then the shape may leave the box.
///               InvalidArgument for a box without an edge, or whose corners or centers of cells
///               are no doubles at this depth; for a depth beyond the limit; and if more than
///               kMostImplicitCells are kept. NotFinite. Stopped when the watch ends the call.
/// @par Cost     One value of f in doubles for each cell tested; where these leave it open, in 128
///               and 512 bits. About 4^depth times the area of the surface over that of a face.
/// @par Source   [Jacobson2026, fig. 8]; docs/implicit.md
[[nodiscard]] ImplicitCells kept_cells(const ImplicitShape& shape, const ImplicitBox& box,
                                       std::size_t depth, const Watch& watch = {});

/// An upper bound of the volume of the hull of the corners by Steiner's formula, rounded up:
/// V + A t + 2 pi b t^2 + 4/3 pi t^3 with t = `distance`.
/// @par Source  [Schneider2014, sec. 4.2]
[[nodiscard]] double steiner_bound(const ImplicitMeasures& measures, double distance);

/// A shape from its JSON text (docs/formats.md#implicit-shapes).
/// @throws Error Malformed, with the line or the JSON pointer of the node; NotFinite for a number
///               beyond the largest double.
[[nodiscard]] ImplicitShape read_implicit_bytes(std::string_view bytes);

}  // namespace convexact
