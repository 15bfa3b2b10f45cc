// SPDX-License-Identifier: MIT
#include "proof/decomposition_proof.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "convexact/error.hpp"
#include "convexact/hull.hpp"
#include "convexact/linear_program.hpp"
#include "decompose/near_concavity.hpp"
#include "near/near_plane.hpp"
#include "number/arithmetic.hpp"
#include "proof/hull_rays.hpp"
#include "proof/partition_proof.hpp"
#include "proof/proof_lines.hpp"

namespace convexact {
namespace {

class DecompositionWriter {
 public:
  DecompositionWriter(const Decomposition& made, const DecomposeRequest& request);
  std::string write();

 private:
  struct Cluster {
    std::vector<TriangleId> triangles;
    const Part* part;  // none if it lies in another one
  };

  void find_clusters();
  void write_cluster(const Cluster& cluster);
  void write_bounds(const std::vector<TriangleId>& triangles, const ClusterHull& hull,
                    const Rational& squared);
  void write_combined(const RaySource& source, const HullRays& rays, const ClusterHull& hull,
                      const Rational& squared);
  void write_part(std::size_t number, const Cluster& cluster);
  bool write_pair(std::size_t a, std::size_t b);
  bool write_pairs();

  bool at_corners() const { return request_.measure == ConcavityMeasure::Vertices; }
  bool by_bridges() const { return request_.method == DecomposeMethod::Acd; }
  Rational least_concavity(const Cluster& cluster) const;
  std::vector<RaySource> sources(const std::vector<TriangleId>& triangles) const;
  RaySource source_of(const Concavity& concavity) const;
  std::optional<std::pair<RaySource, HullRay>> beyond_limit(
      const std::vector<TriangleId>& triangles, const HullRays& rays) const;
  void write_ray(const char* keyword, const std::vector<std::size_t>& clusters,
                 const RaySource& source, const HullRay& ray, const HullRays& rays,
                 const ClusterHull& hull);

  const Decomposition& made_;
  const DecomposeRequest& request_;
  const Surface& surface_;
  const ExactConcavity concavity_;
  const NearConcavity near_;
  std::vector<Cluster> clusters_;
  std::vector<std::size_t> cluster_of_;  // by triangle
  ProofLines out_;
};

DecompositionWriter::DecompositionWriter(const Decomposition& made, const DecomposeRequest& request)
    : made_(made),
      request_(request),
      surface_(made.surface),
      concavity_(made.surface, request.measure),
      near_(made.surface, request.measure, false) {
  find_clusters();
}

// Those of the parts, and those that lie in other parts.
void DecompositionWriter::find_clusters() {
  constexpr std::size_t kNone = ~std::size_t{0};
  cluster_of_.assign(surface_.triangles.size(), kNone);
  const auto add_cluster = [&](const std::vector<TriangleId>& triangles, const Part* part) {
    for (const TriangleId t : triangles) cluster_of_[t.index()] = clusters_.size();
    clusters_.push_back({triangles, part});
  };
  for (const Part& part : made_.parts) add_cluster(part.cluster, &part);
  for (const auto triangles : made_.clusters()) {
    if (cluster_of_[triangles[0].index()] == kNone) {
      add_cluster({triangles.begin(), triangles.end()}, nullptr);
    }
  }
}

std::string DecompositionWriter::write() {
  // The claim, which comes first, depends on whether all pairs are beyond the limit.
  // A guard leaves neighbours apart that are within the limit together.
  const bool asks_for_pairs =
      request_.connect == Connect::Edge && !by_bridges() && !made_.reach.has_value();
  const bool shows_pairs = asks_for_pairs && write_pairs();
  if (asks_for_pairs && !shows_pairs && request_.engine != Engine::Float) {
    throw Error(ErrorCode::Internal, "two neighbours are within the limit together");
  }
  const ProofLines pairs = std::exchange(out_, {});
  out_.line("convexact-proof", "4", "decomposition");
  out_.line("measure", by_bridges() ? "bridges" : at_corners() ? "vertices" : "surface");
  out_.line("limit", request_.limit.is_share ? "share" : "length", request_.limit.value);
  const bool shows_edges = shows_pairs || (by_bridges() && request_.connect == Connect::Edge);
  out_.line("neighbours", shows_edges ? "edges" : "unclaimed");
  write_surface(surface_, out_);
  for (const Cluster& cluster : clusters_) write_cluster(cluster);
  for (std::size_t c = 0; c < clusters_.size(); ++c) {
    if (clusters_[c].part != nullptr) write_part(c, clusters_[c]);
  }
  if (shows_pairs) out_.append(pairs);
  if (made_.reach) write_reach(made_, request_, out_);
  return out_.finish();
}

// ---- Clusters

// Those that have a direction.
std::vector<RaySource> DecompositionWriter::sources(
    const std::vector<TriangleId>& triangles) const {
  std::vector<RaySource> list;
  std::set<std::uint32_t> seen;
  const auto add_source = [&](std::uint32_t id, std::vector<PointId> corners,
                              const IntegerVector3& direction) {
    if (direction.isZero() || !seen.insert(id).second) return;
    list.push_back({id, std::move(corners), direction, unit_vector(direction),
                    Rational(dot(direction, direction))});
  };
  for (const TriangleId t : triangles) {
    const auto& corners = surface_.triangles[t.index()];
    if (!at_corners()) {
      add_source(t.value, {corners.begin(), corners.end()}, concavity_.direction(t, 0));
      continue;
    }
    for (int k = 0; k < 3; ++k) {
      const PointId p = corners[static_cast<std::size_t>(k)];
      add_source(p.value, {p}, concavity_.direction(t, k));
    }
  }
  return list;
}

RaySource DecompositionWriter::source_of(const Concavity& concavity) const {
  for (const RaySource& source : sources({concavity.triangle})) {
    if (!at_corners() || surface_.points[source.corners[0]] == concavity.at) return source;
  }
  throw Error(ErrorCode::Internal, "the concavity is taken nowhere");
}

// A point of a hull as a convex combination of at most four of its extreme points. It comes from
// the dual of this program: which plane has all of them on one side, and this point farthest on the
// other?
std::vector<Multiplier> convex_combination(const std::vector<RationalPoint>& points,
                                           const RationalPoint& x) {
  const auto rows = static_cast<Eigen::Index>(points.size());
  LinearProgram lp{RationalMatrix::Zero(rows, 4), RationalVector::Zero(rows),
                   RationalVector::Zero(4)};
  for (Eigen::Index k = 0; k < rows; ++k) {
    for (int c = 0; c < 3; ++c) lp.normals(k, c) = points[static_cast<std::size_t>(k)][c];
    lp.normals(k, 3) = -1;
  }
  for (int c = 0; c < 3; ++c) lp.objective[c] = x[c];
  lp.objective[3] = -1;
  const LpOutcome outcome = maximise(lp);
  const auto* best = std::get_if<Optimal>(&outcome);
  if (best == nullptr) throw Error(ErrorCode::Internal, "a point is outside of the hull");
  return best->tight;
}

// Barycentric coordinates of a point of a triangle without the first.
std::pair<Rational, Rational> coordinates(const std::array<RationalPoint, 3>& corners,
                                          const RationalPoint& x) {
  const RationalVector3 b = corners[1] - corners[0], c = corners[2] - corners[0],
                        v = x - corners[0];
  const RationalVector3 n = b.cross(c);
  const Rational nn = n.dot(n);
  return {v.cross(c).dot(n) / nn, b.cross(v).dot(n) / nn};
}

Rational DecompositionWriter::least_concavity(const Cluster& cluster) const {
  if (cluster.part != nullptr && cluster.part->least_squared_concavity) {
    return *cluster.part->least_squared_concavity;
  }
  return measure_by_bridges(surface_, cluster.triangles, {.watch = request_.watch.stop})
      .least_squared_concavity;
}

void DecompositionWriter::write_cluster(const Cluster& cluster) {
  Watch(request_.watch.stop).ask();
  out_.line("cluster", cluster.triangles);
  const ClusterHull hull = hull_of_cluster(surface_, cluster.triangles);
  for (const auto& facet : hull.facets) out_.line("facet", facet);
  for (const Halfspace& plane : hull.planes) {
    if (hull.facets.empty()) out_.line("side", plane);
  }
  if (by_bridges()) {
    const Rational depth = least_concavity(cluster);
    if (depth > 0) out_.line("depth", depth);
    return;
  }
  const Concavity deepest =
      cluster.part != nullptr ? cluster.part->concavity : near_.exact(cluster.triangles);
  const HullRays rays(surface_, hull);
  if (deepest.squared > 0) {
    const RaySource source = source_of(deepest);
    HullRay start;
    if (!at_corners()) {
      std::tie(start.u, start.w) =
          coordinates({surface_.points[source.corners[0]], surface_.points[source.corners[1]],
                       surface_.points[source.corners[2]]},
                      deepest.at);
    }
    write_ray("deepest", {}, source, rays.leave(source, start), rays, hull);
  }
  write_bounds(cluster.triangles, hull, deepest.squared);
}

void DecompositionWriter::write_ray(const char* keyword, const std::vector<std::size_t>& clusters,
                                    const RaySource& source, const HullRay& ray,
                                    const HullRays& rays, const ClusterHull& hull) {
  const std::vector<PointId>& corners = hull.corners[ray.plane];
  std::vector<RationalPoint> points;
  for (const PointId p : corners) points.push_back(surface_.points[p]);
  std::vector<Multiplier> weights = convex_combination(points, rays.end(source, ray));
  for (Multiplier& weight : weights) weight.row = corners[weight.row].index();
  if (at_corners()) {
    out_.line(keyword, clusters, source.id, ray.length, weights);
  } else {
    out_.line(keyword, clusters, source.id, ray.u, ray.w, ray.length, weights);
  }
}

// Most triangles are bounded by a single plane: one line serves all triangles with the same plane.
void DecompositionWriter::write_bounds(const std::vector<TriangleId>& triangles,
                                       const ClusterHull& hull, const Rational& squared) {
  const HullRays rays(surface_, hull);
  std::map<std::size_t, std::vector<std::uint32_t>> by_plane;
  std::vector<RaySource> open;
  for (RaySource& source : sources(triangles)) {
    std::size_t plane = rays.near_bound(source).first;
    bool is_bound = rays.is_bound(source, plane, squared);
    if (!is_bound && at_corners()) {
      plane = rays.leave(source, {}).plane;
      is_bound = rays.is_bound(source, plane, squared);
      if (!is_bound) throw Error(ErrorCode::Internal, "a corner lies deeper than its cluster");
    }
    if (is_bound) {
      by_plane[hull.number[plane]].push_back(source.id);
    } else {
      open.push_back(std::move(source));
    }
  }
  for (const auto& [plane, ids] : by_plane) out_.line("within", plane, ids);
  for (const RaySource& source : open) write_combined(source, rays, hull, squared);
}

// Factors of 53 bits, if they suffice.
void DecompositionWriter::write_combined(const RaySource& source, const HullRays& rays,
                                         const ClusterHull& hull, const Rational& squared) {
  const HullRays::Longest longest = rays.longest(source, squared);
  if (!longest.is_within) {
    throw Error(ErrorCode::Internal, "a triangle lies deeper than its cluster");
  }
  long exponent = exponent_of(longest.bound.front().second);
  for (const auto& [plane, factor] : longest.bound) {
    exponent = std::max(exponent, exponent_of(factor));
  }
  PlaneSum rounded = longest.bound;
  std::vector<std::pair<std::size_t, double>> short_terms;
  for (auto& [plane, factor] : rounded) {
    const double near = to_double(scale_by_power_of_two(factor, -exponent), Rounding::Nearest);
    factor = to_rational(near);
    short_terms.emplace_back(hull.number[plane], near);
  }
  if (rays.is_bound(source, rounded, squared)) {
    out_.line("combined", source.id, short_terms);
    return;
  }
  PlaneSum terms = longest.bound;
  for (auto& [plane, factor] : terms) plane = hull.number[plane];
  out_.line("combined", source.id, terms);
}

// ---- Parts

void DecompositionWriter::write_part(std::size_t number, const Cluster& cluster) {
  const Part& part = *cluster.part;
  const PointSet& stored = part.mesh.points;
  const auto same_points = [&] {
    const ClusterHull hull = hull_of_cluster(surface_, cluster.triangles);
    std::set<std::uint32_t> extreme;
    for (const auto& facet : hull.facets) {
      for (const PointId p : facet) extreme.insert(p.value);
    }
    if (hull.facets.empty() || extreme.size() != stored.size()) return false;
    std::vector<std::array<double, 3>> theirs, mine;
    for (const std::uint32_t p : extreme) {
      const Point& x = surface_.points.doubles()[p];
      theirs.push_back({x[0], x[1], x[2]});
    }
    for (const Point& x : stored.doubles()) mine.push_back({x[0], x[1], x[2]});
    std::sort(theirs.begin(), theirs.end());
    std::sort(mine.begin(), mine.end());
    return mine == theirs;
  };
  if (surface_.points.is_binary() && stored.is_binary() && same_points()) {
    out_.line("part", "hull", number);
    out_.line("owns", part.owns);
    return;
  }
  const HullOutcome outcome = convex_hull(stored);
  const auto* hull = std::get_if<Hull>(&outcome);
  out_.line("part", hull != nullptr ? "stored" : "flat", number);
  out_.points("corner", stored);
  if (hull != nullptr) {
    for (std::size_t f = 0; f < hull->facets.size(); ++f) {
      const std::span<const PointId> facet = hull->facets[f];
      for (std::size_t k = 2; k < facet.size(); ++k)
        out_.line("facet", facet[0], facet[k - 1], facet[k]);
    }
    out_.line("owns", part.owns);
    return;
  }
  out_.line("owns", part.owns);
  std::vector<RationalPoint> corners;
  for (std::size_t k = 0; k < stored.size(); ++k) corners.push_back(stored[PointId(k)]);
  for (const PointId p : points_of(surface_, part.owns)) {
    const RationalPoint x = surface_.points[p];
    if (std::find(corners.begin(), corners.end(), x) != corners.end()) continue;
    out_.line("between", p, convex_combination(corners, x));
  }
}

// ---- Pairs

bool DecompositionWriter::write_pairs() {
  std::set<std::pair<std::size_t, std::size_t>> pairs;
  for (const auto& [s, t] : neighbours(surface_, Connect::Edge)) {
    const auto [a, b] = std::minmax(cluster_of_[s.index()], cluster_of_[t.index()]);
    if (a != b) pairs.emplace(a, b);
  }
  return std::all_of(pairs.begin(), pairs.end(),
                     [&](const auto& pair) { return write_pair(pair.first, pair.second); });
}

bool DecompositionWriter::write_pair(std::size_t a, std::size_t b) {
  Watch(request_.watch.stop).ask();
  std::vector<TriangleId> both = clusters_[a].triangles;
  both.insert(both.end(), clusters_[b].triangles.begin(), clusters_[b].triangles.end());
  const ClusterHull hull = hull_of_cluster(surface_, both);
  const HullRays rays(surface_, hull);
  const auto found = beyond_limit(both, rays);
  if (found) write_ray("apart", {a, b}, found->first, found->second, rays, hull);
  return found.has_value();
}

// Centroids are tried first, since they are fewest, and corners next; of each the longest rays
// according to doubles; then all points.
std::optional<std::pair<RaySource, HullRay>> DecompositionWriter::beyond_limit(
    const std::vector<TriangleId>& triangles, const HullRays& rays) const {
  const Rational& limit = made_.squared_limit();
  const std::vector<RaySource> all = sources(triangles);
  struct Trial {
    double length;
    std::size_t source;
    HullRay start;
  };
  for (const bool from_centroids : {true, false}) {
    if (from_centroids && at_corners()) continue;
    std::vector<Trial> trials;
    for (std::size_t k = 0; k < all.size(); ++k) {
      const std::vector<PointId>& corners = all[k].corners;
      if (from_centroids) {
        const Point sum =
            rays.near_point(corners[0]) + rays.near_point(corners[1]) + rays.near_point(corners[2]);
        trials.push_back(
            {rays.near_exit(all[k], sum / 3).second, k, {Rational(1, 3), Rational(1, 3)}});
        continue;
      }
      for (std::size_t c = 0; c < corners.size(); ++c) {
        trials.push_back({rays.near_exit(all[k], rays.near_point(corners[c])).second,
                          k,
                          {c == 1 ? 1 : 0, c == 2 ? 1 : 0}});
      }
    }
    std::stable_sort(trials.begin(), trials.end(),
                     [](const Trial& x, const Trial& y) { return x.length > y.length; });
    if (!at_corners() && trials.size() > 2) trials.resize(2);
    for (const Trial& trial : trials) {
      const RaySource& source = all[trial.source];
      const HullRay ray = rays.leave(source, trial.start);
      if (ray.length * ray.length * source.squared_length > limit) return std::pair(source, ray);
    }
  }
  if (at_corners()) return std::nullopt;
  std::vector<std::pair<double, std::size_t>> bounds;
  for (std::size_t k = 0; k < all.size(); ++k)
    bounds.emplace_back(rays.near_bound(all[k]).second, k);
  std::stable_sort(bounds.begin(), bounds.end(),
                   [](const auto& x, const auto& y) { return x.first > y.first; });
  for (const auto& [bound, k] : bounds) {
    const HullRays::Longest longest = rays.longest(all[k], limit);
    if (!longest.is_within) return std::pair(all[k], longest.ray);
  }
  return std::nullopt;
}

}  // namespace

std::string write_decomposition_proof(const Decomposition& made, const DecomposeRequest& request) {
  if (std::holds_alternative<Partition>(made.origin)) return write_partition_proof(made, request);
  return DecompositionWriter(made, request).write();
}

bool claims_reach(const std::string& proof) { return proof.find("\nreach ") != std::string::npos; }

}  // namespace convexact
