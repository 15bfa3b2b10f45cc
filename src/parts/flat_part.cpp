// SPDX-License-Identifier: MIT
#include "parts/flat_part.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "near/near_plane.hpp"
#include "number/arithmetic.hpp"

namespace convexact {
namespace {

class FlatMerger {
 public:
  FlatMerger(const Surface& surface, const ExactConcavity& concavity, bool skips_inner,
             std::vector<HulledCluster>& clusters, const Watch& watch)
      : surface_(surface), concavity_(concavity), skips_inner_(skips_inner), watch_(watch) {
    for (HulledCluster& cluster : clusters) {
      const TriangleId name = cluster.triangles.front();
      clusters_.emplace(name, std::move(cluster));
    }
  }

  std::vector<TriangleId> run(Connect connect) {
    find_neighbours(connect);
    std::vector<TriangleId> joined;
    for (auto flat = find_flat(); flat; flat = find_flat()) {
      joined.push_back(*flat);
      join(*flat, best_neighbour(*flat));
    }
    return joined;
  }

  std::vector<HulledCluster> take_clusters() {
    std::vector<HulledCluster> left;
    for (auto& [name, cluster] : clusters_) left.push_back(std::move(cluster));
    return left;
  }

 private:
  void find_neighbours(Connect connect) {
    std::vector<TriangleId> name(surface_.triangles.size());
    for (const auto& [lowest, cluster] : clusters_) {
      for (const TriangleId t : cluster.triangles) name[t.index()] = lowest;
    }
    for (const auto& [a, b] : neighbours(surface_, connect, watch_)) {
      const TriangleId x = name[a.index()], y = name[b.index()];
      if (x == y) continue;
      beside_[x].insert(y);
      beside_[y].insert(x);
    }
  }

  // The lowest one that is to join another.
  std::optional<TriangleId> find_flat() const {
    for (const auto& [name, cluster] : clusters_) {
      watch_.ask();
      if (cluster.hull.dimension == 3 || !beside_.contains(name)) continue;
      if (!skips_inner_ || !is_inner(name, cluster.hull)) return name;
    }
    return {};
  }

  bool is_inner(TriangleId name, const ConvexPart& flat) const {
    for (const auto& [other, cluster] : clusters_) {
      if (other == name || !lies_in(flat, cluster.hull)) continue;
      if (other < name || !lies_in(cluster.hull, flat)) return true;
    }
    return false;
  }

  HulledCluster unite(TriangleId a, TriangleId b) const {
    const std::vector<TriangleId>&x = clusters_.at(a).triangles, &y = clusters_.at(b).triangles;
    HulledCluster both;
    std::merge(x.begin(), x.end(), y.begin(), y.end(), std::back_inserter(both.triangles));
    both.hull = convex_part(subset(surface_.points, points_of(surface_, both.triangles)), watch_);
    return both;
  }

  TriangleId best_neighbour(TriangleId flat) const {
    std::optional<std::pair<Rational, TriangleId>> best;
    for (const TriangleId neighbour : beside_.at(flat)) {
      const HulledCluster both = unite(flat, neighbour);
      const std::pair squared_and_name(concavity_(both.triangles, both.hull, watch_).squared,
                                       neighbour);
      if (!best || squared_and_name < *best) best = squared_and_name;
    }
    return best->second;
  }

  void join(TriangleId a, TriangleId b) {
    HulledCluster both = unite(a, b);
    const auto [kept, gone] = std::minmax(a, b);
    clusters_.erase(gone);
    clusters_.at(kept) = std::move(both);
    std::set<TriangleId> beside = std::move(beside_[kept]);
    beside.merge(beside_[gone]);
    beside.erase(kept);
    beside.erase(gone);
    beside_.erase(kept);
    beside_.erase(gone);
    for (const TriangleId other : beside) {
      beside_[other].erase(gone);
      beside_[other].insert(kept);
    }
    if (!beside.empty()) beside_[kept] = std::move(beside);
  }

  const Surface& surface_;
  const ExactConcavity& concavity_;
  bool skips_inner_;
  const Watch& watch_;
  std::map<TriangleId, HulledCluster> clusters_;       // by their lowest triangles
  std::map<TriangleId, std::set<TriangleId>> beside_;  // of those that have neighbours
};

// ---- Thickening

// 2^exponent times a unit vector rounded to multiples of 2^-bits.
RationalVector3 dyadic_vector(const IntegerVector3& direction, long exponent, int bits) {
  const Point near = scaled_direction(direction);
  const double length = std::sqrt(near.dot(near));
  RationalVector3 vector;
  for (int k = 0; k < 3; ++k) {
    const double multiple = std::nearbyint(std::ldexp(near[k] / length, bits));
    vector[k] = scale_by_power_of_two(to_rational(multiple), exponent - bits);
  }
  return vector;
}

// Directions that span what is perpendicular to the hull.
std::vector<IntegerVector3> directions_across(const ConvexPart& flat) {
  if (flat.dimension == 0) {
    return {IntegerVector3(1, 0, 0), IntegerVector3(0, 1, 0), IntegerVector3(0, 0, 1)};
  }
  const IntegerVector3 normal = flat.halfspaces.front().normal();
  if (flat.dimension == 2) return {normal};
  const RationalVector3 along = flat.vertices[1] - flat.vertices[0];
  const IntegerVector3 across = clear_denominators(along).n.cross(normal);
  return {normal, across};
}

long floor_half(long x) { return (x - (x < 0 ? 1 : 0)) / 2; }

}  // namespace

std::vector<TriangleId> merge_flat(const Surface& surface, Connect connect,
                                   const ExactConcavity& concavity, bool skips_inner,
                                   std::vector<HulledCluster>& clusters, const Watch& watch) {
  FlatMerger merger(surface, concavity, skips_inner, clusters, watch);
  std::vector<TriangleId> joined = merger.run(connect);
  clusters = merger.take_clusters();
  return joined;
}

PointSet thicken(const ConvexPart& flat, const Rational& squared_diameter, Precision precision) {
  const Rational largest = flat.box.largest_coordinate();
  const Rational squared_size = squared_diameter > 0 ? squared_diameter
                                : largest > 0        ? Rational(largest * largest)
                                                     : Rational(1);
  // With x^2 in (2^(e-2), 2^e), 2^floor(e / 2) is between 0.7 x and 2 x.
  long exponent = floor_half(exponent_of(squared_size)) - 20;
  int bits = 10;
  if (largest > 0) {
    const long unit = exponent_of(largest) - significand_bits(precision);
    exponent = std::max(exponent, unit + 3);
    bits = static_cast<int>(std::min<long>(bits, exponent - unit));
  }
  std::vector<RationalPoint> points = flat.vertices;
  for (const IntegerVector3& direction : directions_across(flat)) {
    const RationalVector3 w = dyadic_vector(direction, exponent, bits);
    std::vector<RationalPoint> moved;
    for (const RationalPoint& p : points) {
      moved.push_back(p + w);
      moved.push_back(p - w);
    }
    points = std::move(moved);
  }
  return PointSet(std::move(points));
}

}  // namespace convexact
