// SPDX-License-Identifier: MIT
#include "decompose/bridges.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <queue>

#include "number/arithmetic.hpp"

namespace convexact {

// ---- The hull and its bridges

PatchHull hull_of(const Surface& surface, const Patch& patch, const Watch& watch) {
  watch.ask();
  PatchHull made;
  const PointSet points = subset(surface.points, patch.points());
  const HullOutcome outcome = convex_hull(points);
  const auto* hull = std::get_if<Hull>(&outcome);
  if (hull == nullptr) return made;
  for (const PointId p : hull->vertices) made.corners.push_back(patch.points()[p.index()]);
  const std::vector<Halfspace> planes = facet_halfspaces(*hull, points);
  std::vector<std::pair<Association::Facet, std::size_t>> facets;
  for (std::size_t f = 0; f < hull->facets.size(); ++f) {
    Association::Facet corners;
    for (const PointId p : hull->facets[f]) corners.push_back(patch.points()[p.index()]);
    facets.emplace_back(std::move(corners), f);
  }
  std::sort(facets.begin(), facets.end());
  for (auto& [corners, f] : facets) {
    made.facets.push_back(std::move(corners));
    made.planes.push_back(planes[f]);
  }
  return made;
}

bool is_cosine_above(const IntegerVector3& a, const IntegerVector3& b, const Rational& cosine) {
  const Integer along = dot(a, b);
  if (along <= 0) return false;
  return Rational(along * along) > cosine * cosine * Rational(dot(a, a) * dot(b, b));
}

namespace {

// An edge of the hull, low < high, with the facet that runs from low to high, and the other one.
struct HullEdge {
  PointId low, high;
  std::array<std::uint32_t, 2> facets;
};

std::vector<HullEdge> edges_of(const PatchHull& hull) {
  std::map<std::pair<PointId, PointId>, std::array<std::uint32_t, 2>> found;
  for (std::uint32_t f = 0; f < hull.facets.size(); ++f) {
    const Association::Facet& facet = hull.facets[f];
    for (std::size_t k = 0; k < facet.size(); ++k) {
      const PointId a = facet[k], b = facet[(k + 1) % facet.size()];
      found[std::minmax(a, b)][a < b ? 0 : 1] = f;
    }
  }
  std::vector<HullEdge> edges;
  for (const auto& [ends, facets] : found) edges.push_back({ends.first, ends.second, facets});
  return edges;
}

// By facet: its bridge. Numbers ascend with the first facets of bridges.
std::vector<std::uint32_t> join_facets(const PatchHull& hull, const std::vector<HullEdge>& edges,
                                       const Rational& coplanar) {
  std::vector<std::uint32_t> first(hull.facets.size());
  std::iota(first.begin(), first.end(), 0u);
  const auto find = [&](std::uint32_t f) {
    while (first[f] != f) f = first[f] = first[first[f]];
    return f;
  };
  for (const HullEdge& edge : edges) {
    const auto& [f, g] = edge.facets;
    if (!is_cosine_above(hull.planes[f].normal(), hull.planes[g].normal(), coplanar)) continue;
    const auto [low, high] = std::minmax({find(f), find(g)});
    first[high] = low;
  }
  std::vector<std::uint32_t> bridge(first.size());
  std::uint32_t count = 0;
  for (std::uint32_t f = 0; f < first.size(); ++f) {
    bridge[f] = find(f) == f ? count++ : bridge[find(f)];
  }
  return bridge;
}

void add_sorted(std::vector<std::uint32_t>& list, std::uint32_t item) {
  const auto place = std::lower_bound(list.begin(), list.end(), item);
  if (place == list.end() || *place != item) list.insert(place, item);
}

}  // namespace

// ---- Paths

namespace {
constexpr std::uint64_t kUnreached = std::numeric_limits<std::uint64_t>::max();
}

ShortestPaths::ShortestPaths(const Patch& patch, std::span<const Point> near)
    : patch_(patch), distances_(patch.points().size()), search_(patch.points().size(), 0) {
  for (const PointId p : patch.points()) near_.push_back(near[p.index()]);
}

std::uint64_t& ShortestPaths::distance(std::uint32_t point) {
  if (search_[point] != current_) {
    search_[point] = current_;
    distances_[point] = kUnreached;
  }
  return distances_[point];
}

// Less than the distance of two distinct points, which is at least 1; 0 if they are the same point.
std::uint64_t ShortestPaths::at_least(std::uint32_t from, std::uint32_t to) const {
  const double length = EdgeLengths::unrounded(near_[from], near_[to]) - 2;
  return length > 0 ? static_cast<std::uint64_t>(length) : 0;
}

// The distance of each point of a shortest path, plus the lower bound of the rest of the path, is
// less than the distance of the end. So all these points come out of the queue, with their final
// distances, before the end.
std::vector<std::uint32_t> ShortestPaths::operator()(std::uint32_t from, std::uint32_t to) {
  using Entry = std::pair<std::uint64_t, std::uint32_t>;  // at least the whole length, a point
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  ++current_;
  distance(from) = 0;
  queue.emplace(at_least(from, to), from);
  while (!queue.empty() && queue.top().second != to) {
    const auto [length, p] = queue.top();
    queue.pop();
    const std::uint64_t here = distance(p);
    if (length > here + at_least(p, to)) continue;  // it has been reached on a shorter path since
    for (const Patch::Way& way : patch_.ways(p)) {
      if (here + way.length >= distance(way.to)) continue;
      distance(way.to) = here + way.length;
      queue.emplace(here + way.length + at_least(way.to, to), way.to);
    }
  }
  std::vector<std::uint32_t> path;
  if (queue.empty()) return path;
  for (std::uint32_t p = to; p != from;) {
    path.push_back(p);
    const auto ways = patch_.ways(p);  // ascending by their ends
    p = std::find_if(ways.begin(), ways.end(), [&](const Patch::Way& way) {
          const std::uint64_t before = distance(way.to);
          return before != kUnreached && before + way.length == distance(p);
        })->to;
  }
  path.push_back(from);
  std::reverse(path.begin(), path.end());
  return path;
}

// ---- Holes

namespace {

// The sign of a / |n| + b / |m|.
Sign sign_of_sum(const Rational& a, const IntegerVector3& n, const Rational& b,
                 const IntegerVector3& m) {
  const Sign first = sign_of(a), second = sign_of(b);
  if (first == second || second == Sign::Zero) return first;
  if (first == Sign::Zero) return second;
  const Rational difference = a * a * Rational(dot(m, m)) - b * b * Rational(dot(n, n));
  return sign_of(difference) * first;
}

// Positive on the left of the path from a to b, seen from the side to which the sum of the unit
// normals points.
Sign left_of(const Surface& surface, PointId a, PointId b, PointId x,
             const std::array<IntegerVector3, 2>& normals) {
  const RationalPoint from = surface.points[a];
  const RationalVector3 across = (surface.points[b] - from).cross(surface.points[x] - from);
  const auto along = [&](const IntegerVector3& n) { return across.dot(n.cast<Rational>()); };
  return sign_of_sum(along(normals[0]), normals[0], along(normals[1]), normals[1]);
}

}  // namespace

bool spans_hole(const Surface& surface, const Patch& patch, std::uint32_t a, std::uint32_t b,
                const std::array<IntegerVector3, 2>& normals) {
  const auto side = [&](std::uint32_t x) {
    const auto points = patch.points();
    return left_of(surface, points[a], points[b], points[x], normals);
  };
  for (const auto& loop : patch.border_loops()) {
    const std::size_t size = loop.size();
    for (std::size_t start = 0; start < size; ++start) {
      if (loop[start] != a) continue;
      std::size_t k = start + 1;
      while (loop[k % size] != a && loop[k % size] != b) ++k;
      if (loop[k % size] != b) continue;
      const std::uint32_t before = loop[(k + size - 1) % size], after = loop[(k + 1) % size];
      if (side(before) == Sign::Positive && side(after) == Sign::Negative) return true;
    }
  }
  return false;
}

// ---- Association

namespace {

class Associator {
 public:
  Associator(const Surface& surface, const Patch& patch, const PatchHull& hull,
             const NearSurface& near, const SplitOptions& options)
      : surface_(surface),
        patch_(patch),
        hull_(hull),
        options_(options),
        paths_(patch, near.points) {
    made_.points.assign(patch.points().begin(), patch.points().end());
    made_.bridges_of.resize(made_.points.size());
  }

  Association run() {
    const std::vector<HullEdge> edges = edges_of(hull_);
    const std::vector<std::uint32_t> bridge = join_facets(hull_, edges, options_.coplanar);
    for (std::size_t f = 0; f < bridge.size(); ++f) {
      if (bridge[f] == made_.bridges.size()) made_.bridges.emplace_back();
      made_.bridges[bridge[f]].push_back(hull_.facets[f]);
      for (const PointId p : hull_.facets[f]) add(patch_.number_of(p), bridge[f]);
    }
    for (const HullEdge& edge : edges) {
      if (bridge[edge.facets[0]] != bridge[edge.facets[1]]) project(edge, bridge);
    }
    for (const BridgePath& path : made_.paths) {
      for (const PointId p : path.points) {
        for (const std::uint32_t b : path.bridges) add(patch_.number_of(p), b);
      }
    }
    options_.bridge == BridgeChoice::Region ? label_regions() : spread_labels();
    return std::move(made_);
  }

 private:
  void add(std::uint32_t point, std::uint32_t bridge) {
    add_sorted(made_.bridges_of[point], bridge);
  }

  void project(const HullEdge& edge, const std::vector<std::uint32_t>& bridge) {
    options_.watch.ask();
    const auto& [f, g] = edge.facets;
    BridgePath& path = made_.paths.emplace_back();
    path.bridges = {std::min(bridge[f], bridge[g]), std::max(bridge[f], bridge[g])};
    path.points = {edge.low, edge.high};
    const std::uint32_t a = patch_.number_of(edge.low), b = patch_.number_of(edge.high);
    if (patch_.is_edge(a, b)) return;  // the edge is the shortest path
    path.spans_hole =
        spans_hole(surface_, patch_, a, b, {hull_.planes[f].normal(), hull_.planes[g].normal()});
    path.is_joined = false;
    if (path.spans_hole) return;
    const std::vector<std::uint32_t> found = paths_(a, b);
    if (found.empty()) return;
    path.is_joined = true;
    path.points.clear();
    for (const std::uint32_t p : found) path.points.push_back(patch_.points()[p]);
  }

  // Each point takes the bridges of the nearest one that has any, by the number of edges; of
  // several equally near ones, those of the lowest.
  void spread_labels() {
    constexpr std::uint32_t kNone = ~0u;
    std::vector<std::uint32_t> source(made_.points.size(), kNone), front, next;
    for (std::uint32_t p = 0; p < source.size(); ++p) {
      if (made_.bridges_of[p].empty()) continue;
      source[p] = p;
      front.push_back(p);
    }
    while (!front.empty()) {
      next.clear();
      std::vector<std::pair<std::uint32_t, std::uint32_t>> reached;  // point, source
      for (const std::uint32_t p : front) {
        for (const Patch::Way& way : patch_.ways(p)) {
          if (source[way.to] == kNone) reached.emplace_back(way.to, source[p]);
        }
      }
      std::sort(reached.begin(), reached.end());
      for (const auto& [p, from] : reached) {
        if (source[p] != kNone) continue;
        source[p] = from;
        next.push_back(p);
      }
      std::swap(front, next);
    }
    for (std::uint32_t p = 0; p < source.size(); ++p) {
      if (source[p] != kNone && source[p] != p) {
        made_.bridges_of[p] = made_.bridges_of[source[p]];
      }
    }
  }

  // Points without a bridge that are joined by edges are a region. Its bridge is the one that most
  // points around it have; of several, the lowest.
  void label_regions() {
    std::vector<bool> is_seen(made_.points.size(), false);
    for (std::uint32_t p = 0; p < is_seen.size(); ++p) is_seen[p] = !made_.bridges_of[p].empty();
    const std::vector<bool> is_labelled = is_seen;
    for (std::uint32_t first = 0; first < is_seen.size(); ++first) {
      if (is_seen[first]) continue;
      std::vector<std::uint32_t> region{first}, around;
      is_seen[first] = true;
      for (std::size_t k = 0; k < region.size(); ++k) {
        for (const Patch::Way& way : patch_.ways(region[k])) {
          if (is_labelled[way.to]) {
            around.push_back(way.to);
          } else if (!is_seen[way.to]) {
            is_seen[way.to] = true;
            region.push_back(way.to);
          }
        }
      }
      std::sort(around.begin(), around.end());
      around.erase(std::unique(around.begin(), around.end()), around.end());
      std::map<std::uint32_t, std::size_t> votes;
      for (const std::uint32_t p : around) {
        for (const std::uint32_t b : made_.bridges_of[p]) ++votes[b];
      }
      const auto most =
          std::max_element(votes.begin(), votes.end(),
                           [](const auto& a, const auto& b) { return a.second < b.second; });
      if (most == votes.end()) continue;
      for (const std::uint32_t p : region) made_.bridges_of[p] = {most->first};
    }
  }

  const Surface& surface_;
  const Patch& patch_;
  const PatchHull& hull_;
  const SplitOptions& options_;
  ShortestPaths paths_;
  Association made_;
};

}  // namespace

Association associate(const Surface& surface, const Patch& patch, const PatchHull& hull,
                      const NearSurface& near, const SplitOptions& options) {
  return Associator(surface, patch, hull, near, options).run();
}

}  // namespace convexact
