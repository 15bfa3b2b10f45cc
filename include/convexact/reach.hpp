// SPDX-License-Identifier: MIT
// reach.hpp - how far convex parts reach away from the solid that they stand for: whether every
// point of a part lies within a distance T of it, decided with witnesses and proofs.
//
// The solid S is what a closed surface winds about, together with the surface itself; an open
// surface is a solid of its own, without an inside. docs/design/reach.md has the method.
#pragma once
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/overlay.hpp"
#include "convexact/surface.hpp"

namespace convexact {

/// A point of a part, and how far it is from the solid: exactly, and not zero.
struct FarthestPoint {
  RationalPoint point;
  RationalPoint nearest;  ///< The point of the surface that is nearest to it.
  Rational squared;       ///< The squared distance of the two, in squared length units.
};

/// Whether a part lies within T of the solid.
struct PartReach {
  Reach reach = Reach::Within;
  /// Beyond: a point of the part that is farther than T. Undecided: the farthest one that was
  /// found, if one is outside of the solid.
  std::optional<FarthestPoint> witness;
  /// Undecided: bounds of the largest squared distance; squared.low <= T^2 < squared.high.
  std::optional<SquaredBracket> bracket;
};

/// What a proof tells of the cells that hold some parts, as a tree in preorder. Parts with an
/// interior are made smaller by so little that cells along their facets need not be as small as T;
/// in return, cells are near if they are within (1 - slack) T.
struct ReachCertificate {
  enum class Kind {
    Split,   ///< Eight cells of half the size follow, with their trees: x fastest, low first.
    Near,    ///< All corners of the cell are within (1 - slack) T of one triangle.
    Inside,  ///< No triangle meets the cell, and the surface winds about its center.
    Open,    ///< No part meets the cell.
  };
  struct Cell {
    Kind kind = Kind::Open;
    TriangleId triangle = {};  ///< Of Near.
    /// Of Inside: an earlier cell of this kind that touches this one, if there is one.
    std::optional<std::size_t> beside = {};
  };
  /// A part's points x move to x + share (middle - x), by at most slack T each.
  struct Inner {
    std::size_t part;
    RationalPoint middle;  ///< Inside of the part.
    Rational share;
  };
  /// No triangle meets the interior of what a part and a cell have in common, and the surface winds
  /// about `point` in there.
  struct Clear {
    std::size_t cell, part;
    RationalPoint point;
  };
  /// A cell and a part lie on different sides of a plane across `direction`: each point of the cell
  /// is farther along it than each point of the part.
  struct Apart {
    std::size_t cell, part;
    Point direction;
  };
  RationalPoint center;  ///< Of the root, the first cell.
  Rational half_width;   ///< Of the root.
  Rational slack;
  std::vector<Inner> inner;  ///< By part, those that are made smaller.
  std::vector<Cell> cells;
  std::vector<Clear> clear;  ///< By cell.
  std::vector<Apart> apart;  ///< By part, and for each by cell.
};

struct NearFrame;

/// About the farthest point of a hull from the solid: in doubles of a ReachLimit's frame.
struct FarPlace {
  Point point;
  double distance;
};

/// The least T > 0 that cells tell well, as a share of the surface's diameter. Smaller ones may
/// take more cells than can be kept.
inline const Rational kLeastReach{1, 1 << 20};

/// Decides for convex parts whether they lie within T of a solid. What it learns of the space
/// around the solid serves all parts, and may be forgotten between them: calls are not for several
/// threads at once.
/// @par Method  A lazy octree of cells. A cell is fine if all its corners are within T of one
///              triangle (a convex set around a triangle, dilated, is convex), or if it lies in the
///              solid. A part is within T if it meets fine cells only, and beyond it if some point
///              of it is outside of the solid and farther than T from all triangles. If T is 0,
///              a part that is within may still have a volume outside, but so thin that no point
///              there is certain, and nowhere farther out than 2 kLeastReach: volumes decide.
class ReachLimit {
 public:
  /// Keeps references.
  /// @param winding  Of the surface; null if it is open.
  /// @param squared_limit  T^2 >= 0, in squared length units.
  /// @param boxes  Of parts that may lie outside of the surface's box.
  /// @throws Error InvalidArgument if squared_limit < 0, or the surface has no triangle.
  ReachLimit(const Surface& surface, const Winding* winding, const Rational& squared_limit,
             std::span<const BoundingBox> boxes = {});
  ~ReachLimit();
  ReachLimit(ReachLimit&&) noexcept;
  ReachLimit& operator=(ReachLimit&&) noexcept;

  /// Decides for a part. Cells that are neither proven nor refuted when they are small are decided
  /// by what they have in common with the part, in exact numbers.
  /// @throws Error InvalidArgument for a part beyond the boxes; Stopped when the watch ends the
  ///               call.
  /// @par Cost  Cells that the part meets and that are not fine: those deep inside of the solid and
  ///            those far outside of the part cost nothing.
  [[nodiscard]] PartReach operator()(const ConvexPart& part, const Watch& watch = {});

  /// Whether the part is proven to be within T by cells alone: quicker, and enough for a guard. It
  /// is certain to be if its reach is at most T - 2 sqrt(3) h - T / 4096, with h the least half
  /// width of cells, T / 128 to T / 64; and what contains a part that is refused is refused, up to
  /// rounding.
  /// @throws As above.
  [[nodiscard]] bool allows(const ConvexPart& part, const Watch& watch = {});

  /// The same for the hull of points of the surface, at least one: quicker than to make a part of
  /// them first.
  [[nodiscard]] bool allows_hull(std::span<const PointId> points, const Watch& watch = {});

  /// The same for the hull of points of the frame, at least one.
  [[nodiscard]] bool allows_near(std::span<const Point> points, const Watch& watch = {});

  /// Of each of several parts whether allows() it; up to four are asked about at the same time. The
  /// watch is told of those done.
  /// @param jobs  Threads, 1 to 256, on which the answer does not depend.
  /// @throws As above.
  [[nodiscard]] std::vector<bool> allows_each(std::span<const ConvexPart> parts, std::size_t jobs,
                                              const Watch& watch = {});

  /// Whether allows() all of them; ends soon after one that is refused.
  [[nodiscard]] bool allows_all(std::span<const ConvexPart> parts, std::size_t jobs,
                                const Watch& watch = {});

  /// For the hull of each list of such points: about its farthest point from the solid, up to 3% of
  /// its distance; nothing if cells alone prove that the hull is within T.
  /// @param jobs  Threads, 1 to 256, on which the answer does not depend.
  /// @throws As above.
  [[nodiscard]] std::vector<std::optional<FarPlace>> farthest_of_each(
      std::span<const std::vector<Point>> parts, std::size_t jobs = 1, const Watch& watch = {});

  /// A proof that parts that are all within T > 0 by cells alone are so.
  /// @throws Error Unrepresentable if one of them is not, or if that takes more than kReachCells
  ///               cells.
  ///               Stopped when the watch ends the call.
  [[nodiscard]] ReachCertificate certificate(std::span<const ConvexPart* const> parts,
                                             const Watch& watch = {});

  const Rational& squared_limit() const;
  /// The frame of the cells.
  const NearFrame& frame() const;
  /// Cells that were needed so far; each takes less than 100 bytes.
  std::size_t cells() const;

 private:
  class Search;
  std::unique_ptr<Search> search_;
};

/// The largest number of cells that a walk down to a part opens; parts that need more are
/// Undecided. Up to half as many are kept for the next part; four parts may be asked about at the
/// same time.
inline constexpr std::size_t kReachCells = std::size_t{1} << 22;

}  // namespace convexact
