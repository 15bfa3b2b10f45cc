// SPDX-License-Identifier: MIT
#include "convexact/cluster.hpp"

#include <algorithm>
#include <map>

#include "convexact/error.hpp"
#include "convexact/measure.hpp"
#include "decompose/cluster_engines.hpp"
#include "decompose/near_concavity.hpp"
#include "number/groups.hpp"
#include "surface/edges.hpp"

namespace convexact {
namespace {

void require_sensible(const ClusterOptions& options) {
  const ConcavityLimit& limit = options.limit;
  if (limit.value < 0 || (limit.is_share && limit.value > 1)) {
    throw Error(ErrorCode::InvalidArgument,
                limit.is_share ? "the concavity allowed is a share of the diameter: from 0 to 1"
                               : "the concavity allowed is a length: at least 0");
  }
  if (options.max_parts && *options.max_parts == 0) {
    throw Error(ErrorCode::InvalidArgument, "at least one part is needed");
  }
}

void require_possible(const ClusterOptions& options, std::size_t groups) {
  if (!options.max_parts || groups <= *options.max_parts) return;
  const std::string hint = options.connect == Connect::Touching
                               ? "not even a point connects them"
                               : "connect touching also joins components that have a common point";
  throw Error(ErrorCode::InvalidArgument,
              "at most " + std::to_string(*options.max_parts) + " parts: the surface has " +
                  std::to_string(groups) +
                  " components that are not connected, and no part holds two of them; " + hint);
}

// Groups of triangles; those without area join a neighbour, as long as there is one.
class AreaGroups {
 public:
  explicit AreaGroups(const Surface& surface) {
    for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
      groups_.push_back({{t}, !has_no_area(surface.points, surface.triangles[t])});
      group_.push_back(t);
    }
    ways_.resize(group_.size());
    EdgeTable(surface.triangles).for_each([&](std::span<const EdgeUse> uses) {
      for (const EdgeUse& use : uses) {
        if (groups_[use.triangle].has_area) continue;
        const RationalVector3 along = surface.points[use.high] - surface.points[use.low];
        for (const EdgeUse& other : uses) {
          if (other.triangle == use.triangle) continue;
          ways_[use.triangle].push_back({along.squaredNorm(), other.triangle});
        }
      }
    });
  }

  std::vector<std::pair<TriangleId, TriangleId>> unite() {
    std::vector<std::pair<TriangleId, TriangleId>> united;
    for (std::uint32_t t = 0; t < group_.size(); ++t) {
      while (!groups_[group_[t]].has_area) {
        const auto way = longest_way_out(groups_[group_[t]]);
        if (!way) break;
        united.emplace_back(TriangleId(way->first), TriangleId(way->second));
        join(group_[way->first], group_[way->second]);
      }
    }
    return united;
  }

  std::vector<std::uint32_t> lowest() const {
    std::vector<std::uint32_t> names(group_.size());
    for (const Group& group : groups_) {
      if (group.triangles.empty()) continue;
      const std::uint32_t name = *std::min_element(group.triangles.begin(), group.triangles.end());
      for (const std::uint32_t t : group.triangles) names[t] = name;
    }
    return names;
  }

 private:
  struct Group {
    std::vector<std::uint32_t> triangles;
    bool has_area;
  };
  struct Way {
    Rational squared_length;  // of an edge of a triangle without area
    std::uint32_t to;         // another triangle there
  };

  // Of equal edges the one of the lowest triangle, to the lowest.
  std::optional<std::pair<std::uint32_t, std::uint32_t>> longest_way_out(const Group& group) const {
    std::optional<std::pair<std::uint32_t, std::uint32_t>> best;
    const Rational* longest = nullptr;
    for (const std::uint32_t t : group.triangles) {
      for (const Way& way : ways_[t]) {
        if (group_[way.to] == group_[t]) continue;
        const std::pair ends(t, way.to);
        if (longest &&
            (way.squared_length < *longest || (way.squared_length == *longest && ends >= *best))) {
          continue;
        }
        longest = &way.squared_length;
        best = ends;
      }
    }
    return best;
  }

  void join(std::uint32_t a, std::uint32_t b) {
    if (groups_[a].triangles.size() < groups_[b].triangles.size()) std::swap(a, b);
    for (const std::uint32_t t : groups_[b].triangles) group_[t] = a;
    auto& triangles = groups_[a].triangles;
    triangles.insert(triangles.end(), groups_[b].triangles.begin(), groups_[b].triangles.end());
    groups_[b].triangles.clear();
    groups_[a].has_area = groups_[a].has_area || groups_[b].has_area;
  }

  std::vector<Group> groups_;
  std::vector<std::uint32_t> group_;    // by triangle
  std::vector<std::vector<Way>> ways_;  // by triangle; of those without area
};

}  // namespace

ClusterStart start_clusters(const Surface& surface, const ClusterOptions& options) {
  require_sensible(options);
  ClusterStart start;
  const auto pairs = neighbours(surface, options.connect, options.watch);
  require_possible(options, count_groups(surface, pairs));
  start.squared_diameter = bounding_box(surface.points).squared_diameter();
  start.squared_limit = options.limit.squared(start.squared_diameter);
  start.squared_weight =
      std::max<Rational>(start.squared_limit, start.squared_diameter / Rational(1 << 20));
  AreaGroups groups(surface);
  start.united = groups.unite();
  start.lowest = groups.lowest();
  for (const auto& [first, second] : pairs) {
    const auto [low, high] = std::minmax(start.lowest[first.index()], start.lowest[second.index()]);
    if (low != high) start.pairs.emplace_back(low, high);
  }
  std::sort(start.pairs.begin(), start.pairs.end());
  start.pairs.erase(std::unique(start.pairs.begin(), start.pairs.end()), start.pairs.end());
  return start;
}

std::vector<std::vector<TriangleId>> clusters_of(const std::vector<std::uint32_t>& lowest) {
  std::map<std::uint32_t, std::vector<TriangleId>> found;
  for (std::uint32_t t = 0; t < lowest.size(); ++t) found[lowest[t]].push_back(TriangleId(t));
  std::vector<std::vector<TriangleId>> clusters;
  for (auto& [name, triangles] : found) clusters.push_back(std::move(triangles));
  return clusters;
}

namespace {

// Makes each group of neighbours that is within the limit as a whole one cluster; returns how many.
std::size_t join_whole_groups(const Surface& surface, const ClusterOptions& options,
                              ClusterStart& start) {
  constexpr std::size_t kFewest = 3;  // clusters: two are one merge
  const auto count = static_cast<std::uint32_t>(surface.triangles.size());
  Groups groups(count);
  for (std::uint32_t t = 0; t < count; ++t) groups.join(t, start.lowest[t]);
  for (const auto& [a, b] : start.pairs) groups.join(a, b);
  std::map<std::uint32_t, std::vector<TriangleId>> members;
  for (std::uint32_t t = 0; t < count; ++t) members[groups.root(t)].push_back(TriangleId(t));
  const NearConcavity near(surface, options.measure, false);
  const LengthBounds limit = near.root_bounds(start.squared_limit);
  std::vector<bool> is_whole(count, false);  // by lowest triangle of a group
  std::size_t whole = 0;
  for (const auto& [lowest, triangles] : members) {
    options.watch.ask();
    const auto is_first = [&](TriangleId t) { return start.lowest[t.index()] == t.value; };
    const auto clusters = std::count_if(triangles.begin(), triangles.end(), is_first);
    if (static_cast<std::size_t>(clusters) < kFewest || !near.is_within(triangles, limit)) continue;
    if (options.guard && !options.guard(triangles)) continue;
    is_whole[lowest] = true;
    ++whole;
    for (const TriangleId t : triangles) start.lowest[t.index()] = lowest;
  }
  std::erase_if(start.pairs,
                [&](const ClusterPair& pair) { return is_whole[groups.root(pair.first)]; });
  return whole;
}

}  // namespace

Clustering cluster(const Surface& surface, const ClusterOptions& options) {
  ClusterStart start = start_clusters(surface, options);
  std::size_t whole_groups = 0;
  if (!options.every_merge && options.engine == Engine::Filtered) {
    whole_groups = join_whole_groups(surface, options, start);
  }
  Clustering made = options.engine == Engine::Exact ? cluster_exact(surface, options, start)
                                                    : cluster_filtered(surface, options, start);
  made.whole_groups = whole_groups;
  made.united = std::move(start.united);
  made.squared_limit = std::move(start.squared_limit);
  made.squared_diameter = std::move(start.squared_diameter);
  return made;
}

}  // namespace convexact
