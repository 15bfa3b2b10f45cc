// SPDX-License-Identifier: MIT
// checks.hpp - proves a removal, and a whole surface, again: from plain lists and exact signs.
#pragma once
#include <span>
#include <vector>

#include "fast/dual.hpp"
#include "fast/signs.hpp"

namespace convexact {

/// The claim of a removal: the ring of `removed`, counter-clockwise from outside; for each edge
/// ring[m] -> ring[m + 1] the third corner of the dual triangle across it; the ring's new
/// triangles.
struct ClaimedStep {
  HalfspaceId removed;
  std::span<const HalfspaceId> ring;
  std::span<const HalfspaceId> across;
  std::span<const DualTriangle> triangles;
};

/// The local checks of docs/verification.md, with filtered signs in place of integers. They use no
/// mesh, no queue and no volume, and share only the predicates with the step.
class StepCheck {
 public:
  explicit StepCheck(const FastDual& dual)
      : dual_(dual), signs_(dual), position_(dual.size(), kNotInRing) {}

  /// @throws Error Internal, naming the check that failed.
  /// @par Cost     4 k signs for a ring of k.
  void check(const ClaimedStep& step);

 private:
  void check_disk(const ClaimedStep& step);
  void measure(const ClaimedStep& step);
  void check_triangles(const ClaimedStep& step) const;
  HalfspaceId owner_of_edge(const ClaimedStep& step, std::size_t m) const;
  void check_rim(const ClaimedStep& step) const;
  bool is_beyond(const DualTriangle& triangle, HalfspaceId p, double height) const;

  static constexpr std::uint32_t kNotInRing = 0xffffffff;
  // A new triangle, found by its middle corner; all are places in the ring.
  struct Piece {
    std::uint32_t low = 0, high = 0;
    // The third corner of the triangle on which it hangs with its edge (low, high).
    std::uint32_t across = 0;
    // What hangs on its sides (low, middle) and (middle, high).
    std::uint32_t at_left = kNotInRing, at_right = kNotInRing;
  };
  const FastDual& dual_;
  DualSigns signs_;
  PlaneFilter filter_;                   // for all dual points of the step
  std::vector<std::uint32_t> position_;  // in the ring, while a step is checked
  std::vector<Piece> pieces_;            // of the step
  std::uint32_t root_ = kNotInRing;      // the piece with the edge from the ring's last place to 0
};

/// Whether the triangles, counter-clockwise from outside, are the surface of the convex hull of
/// their corners, and the center is strictly inside: then the planes of the corners bound a solid
/// whose vertices and edges they describe. It does not matter how the triangles were found.
/// @par Cost    O(n log n) for n triangles; exact numbers only where doubles cannot decide.
/// @par Source  [Mehlhorn1999]; the argument is that of docs/design/hull.md
[[nodiscard]] bool is_dual_hull(const FastDual& dual, std::span<const DualTriangle> triangles);

}  // namespace convexact
