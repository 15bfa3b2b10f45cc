// SPDX-License-Identifier: MIT
// known_caps.hpp - the volumes of caps that a search has measured, which bound those of others.
#pragma once
#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "convexact/geometry.hpp"
#include "fast/ring_determinants.hpp"

namespace convexact {

/// The cap beyond a halfspace is determined by its ring: the halfspaces that bound it. So it is the
/// same in all solids in which the halfspace has this ring, and no larger in any other solid that
/// has all halfspaces of the ring: there, more of them can only cut it.
class KnownCaps {
 public:
  explicit KnownCaps(std::size_t halfspaces) : of_(halfspaces) {}

  /// Null if this cap of i is not known. Valid until the next call of add().
  const CostBounds<double>* find(HalfspaceId i, std::span<const HalfspaceId> ring) const {
    for (const Cap& cap : of_[i.index()].caps) {
      if (is_rotated(ring, cap.ring())) return &cap.bounds;
    }
    return nullptr;
  }
  void add(HalfspaceId i, std::span<const HalfspaceId> ring, const CostBounds<double>& bounds) {
    if (ring.size() > kLongestRing) return;
    auto& [caps, oldest] = of_[i.index()];
    if (caps.size() < kMost) caps.emplace_back();
    Cap& cap = caps[oldest];
    oldest = (oldest + 1) % kMost;
    cap.bounds = bounds;
    cap.suspect = ring.front();
    cap.size = ring.size();
    std::copy(ring.begin(), ring.end(), cap.ids.begin());
  }
  /// Whether the cap of i in a solid is known to be at most `most`.
  /// @param has  Whether the solid has a halfspace.
  template <class Has>
  bool is_at_most(HalfspaceId i, double most, Has has) {
    for (Cap& cap : of_[i.index()].caps) {
      // An unbounded cap has no upper bound to speak of.
      if (cap.bounds.kind != Boundedness::Bounded || cap.bounds.upper > most) continue;
      if (!has(cap.suspect)) continue;
      const auto ring = cap.ring();
      const auto missing = std::find_if_not(ring.begin(), ring.end(), has);
      if (missing == ring.end()) return true;
      cap.suspect = *missing;
    }
    return false;
  }

 private:
  // Searches come back to what they saw a short time ago. To look through more caps takes as long
  // as they save. Few rings are longer than this.
  static constexpr std::size_t kMost = 8, kLongestRing = 12;
  struct Cap {
    CostBounds<double> bounds;
    HalfspaceId suspect;  // of the ring: a solid did not have it, and the next may not have it
    std::size_t size;     // of the ring
    std::array<HalfspaceId, kLongestRing> ids;
    std::span<const HalfspaceId> ring() const { return std::span(ids).first(size); }
  };
  struct Caps {
    std::vector<Cap> caps;
    std::size_t oldest = 0;  // the next to be replaced, or the end while there is room
  };

  // Whether two cycles are equal.
  static bool is_rotated(std::span<const HalfspaceId> a, std::span<const HalfspaceId> b) {
    if (a.size() != b.size()) return false;
    const auto start = std::find(b.begin(), b.end(), a.front());
    const auto until_end = static_cast<std::size_t>(b.end() - start);
    return until_end > 0 && std::equal(start, b.end(), a.begin()) &&
           std::equal(b.begin(), start, a.begin() + static_cast<std::ptrdiff_t>(until_end));
  }

  std::vector<Caps> of_;
};

}  // namespace convexact
