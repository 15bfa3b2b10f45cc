// SPDX-License-Identifier: MIT
#include "parts/merge_by_reach.hpp"

#include <algorithm>
#include <set>
#include <tuple>

#include "convexact/measure.hpp"

namespace convexact {
namespace {

constexpr long kVolumeBits = 64;

double volume_of(const ConvexPart& part) {
  return part.solid ? enclose_volume(*part.solid, kVolumeBits).high_double() : 0;
}

bool are_near(const BoundingBox& a, const BoundingBox& b, const Rational& distance) {
  for (int k = 0; k < 3; ++k) {
    if (a.high[k] + distance < b.low[k] || b.high[k] + distance < a.low[k]) return false;
  }
  return true;
}

// Parts that are merged are named by the lower one of the two.
class ReachMerger {
 public:
  ReachMerger(std::vector<Part>& parts, ReachLimit& limit, const Rational& distance,
              const Watch& watch)
      : parts_(parts), limit_(limit), distance_(distance), watch_(watch) {
    for (const Part& part : parts) volumes_.push_back(volume_of(part.hull));
    for (std::size_t k = 0; k < parts.size(); ++k) holder_.push_back(k);
    for (std::size_t b = 0; b < parts.size(); ++b) {
      for (std::size_t a = 0; a < b; ++a) add(a, b);
    }
  }

  std::vector<std::size_t> run() {
    while (!queue_.empty()) {
      watch_.ask();
      const auto [added, a, b] = *queue_.begin();
      queue_.erase(queue_.begin());
      ConvexPart hull = hull_of(a, b);
      if (!limit_.allows(hull, watch_)) {
        refused_.emplace(a, b);
        continue;
      }
      merge(a, b, std::move(hull));
    }
    // A part merges with a lower one only, whose place is known by then.
    std::vector<std::size_t> places(parts_.size());
    std::size_t next = 0;
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      if (holder_[k] != k) {
        places[k] = places[holder_[k]];
        continue;
      }
      if (next != k) parts_[next] = std::move(parts_[k]);
      places[k] = next++;
    }
    parts_.resize(next);
    return places;
  }

 private:
  using Pair = std::pair<std::size_t, std::size_t>;  // the lower one first

  ConvexPart hull_of(std::size_t a, std::size_t b) const {
    std::vector<RationalPoint> points = parts_[a].hull.vertices;
    const auto& more = parts_[b].hull.vertices;
    points.insert(points.end(), more.begin(), more.end());
    return convex_part(PointSet(points), watch_);
  }

  void add(std::size_t a, std::size_t b) {
    watch_.ask();
    if (!are_near(parts_[a].hull.box, parts_[b].hull.box, distance_)) return;
    const double added = volume_of(hull_of(a, b)) - volumes_[a] - volumes_[b];
    queue_.emplace(added, a, b);
  }

  void merge(std::size_t a, std::size_t b, ConvexPart hull) {
    Part &kept = parts_[a], &gone = parts_[b];
    const auto take = [](auto& to, const auto& from) {
      to.insert(to.end(), from.begin(), from.end());
      std::sort(to.begin(), to.end());
    };
    take(kept.owns, gone.owns);
    take(kept.loose, gone.loose);
    take(kept.merged, gone.merged);
    take(kept.merged, std::vector{gone.cluster.front()});
    kept.is_widened = kept.is_widened || gone.is_widened;
    kept.hull = std::move(hull);
    volumes_[a] = volume_of(kept.hull);
    holder_[b] = a;
    std::erase_if(queue_, [&](const auto& entry) {
      const auto [added, x, y] = entry;
      return x == a || y == a || x == b || y == b;
    });
    // What holds a hull that was refused is refused.
    std::set<Pair> refused;
    for (const auto& [x, y] : refused_) {
      const Pair now = std::minmax(x == b ? a : x, y == b ? a : y);
      if (now.first != now.second) refused.insert(now);
    }
    refused_ = std::move(refused);
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      const Pair pair = std::minmax(a, k);
      if (k != a && holder_[k] == k && !refused_.contains(pair)) add(pair.first, pair.second);
    }
  }

  std::vector<Part>& parts_;
  ReachLimit& limit_;
  const Rational& distance_;
  const Watch& watch_;
  std::vector<double> volumes_;
  std::vector<std::size_t> holder_;  // itself, or the lower part that it merged with
  std::set<std::tuple<double, std::size_t, std::size_t>> queue_;  // by added volume
  std::set<Pair> refused_;
};

}  // namespace

std::vector<std::size_t> merge_by_reach(std::vector<Part>& parts, ReachLimit& limit,
                                        const Rational& distance, const Watch& watch) {
  return ReachMerger(parts, limit, distance, watch).run();
}

}  // namespace convexact
