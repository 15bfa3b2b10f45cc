// SPDX-License-Identifier: MIT
// point_merger.hpp - gathers points and merges those that are exactly equal, for formats that
// repeat a point in every face that has it.
#pragma once
#include <bit>
#include <unordered_set>
#include <utility>

#include "io/point_collector.hpp"

namespace convexact {

/// Mixed in 64 bits, of which the lower half depends on every bit of the point, so std::size_t may
/// have 32: small integers as doubles differ in their upper halves only.
[[nodiscard]] inline std::size_t hash_of(const Point& point) {
  std::uint64_t hash = 0;
  for (const double x : point) {
    // x + 0.0 turns -0 into the 0 that it equals; the multiplier is 2^64 over the golden ratio.
    hash = (hash ^ std::bit_cast<std::uint64_t>(x + 0.0)) * 0x9E3779B97F4A7C15u;
    hash ^= hash >> 32;
  }
  return static_cast<std::size_t>(hash);
}

/// Collects points and gives equal ones the index of the first.
class PointMerger {
 public:
  explicit PointMerger(Decimal decimal) : points_(decimal) {}

  template <class... Place>
  std::uint32_t add(Place&&... place) {
    points_.add(std::forward<Place>(place)...);
    const auto [found, is_new] = known_.insert(static_cast<std::uint32_t>(points_.size() - 1));
    if (!is_new) points_.drop_last();
    return *found;
  }
  const Point& double_at(std::size_t index) const { return points_.double_at(index); }
  PointSet finish() { return points_.finish(); }

 private:
  struct Hash {
    const PointCollector* points;
    std::size_t operator()(std::uint32_t index) const { return hash_of(points->double_at(index)); }
  };
  struct Equal {
    const PointCollector* points;
    bool operator()(std::uint32_t a, std::uint32_t b) const { return points->equal(a, b); }
  };

  PointCollector points_;
  std::unordered_set<std::uint32_t, Hash, Equal> known_{16, Hash{&points_}, Equal{&points_}};
};

}  // namespace convexact
