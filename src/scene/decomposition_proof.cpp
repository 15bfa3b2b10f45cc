// SPDX-License-Identifier: MIT
#include "scene/decomposition_proof.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "convexact/error.hpp"
#include "convexact/hull.hpp"
#include "decompose/near_concavity.hpp"
#include "number/arithmetic.hpp"

namespace convexact {
namespace {

// ---- In doubles: only to choose what is tried first

struct ClusterPlane {
  Point normal;
  double offset;
};

Point unit_vector(const IntegerVector3& v) {
  Integer largest = 0;
  for (const Integer& x : v) largest = std::max<Integer>(largest, abs(x));
  Point near = Point::Zero();
  if (largest == 0) return near;
  for (int k = 0; k < 3; ++k) near[k] = to_double(Rational(v[k], largest), Rounding::Nearest);
  return near / near.norm();
}

ClusterPlane cluster_plane(const Halfspace& plane, const Point& on_it) {
  const Point normal = unit_vector(plane.normal());
  return {normal, -normal.dot(on_it)};
}

// ---- Hulls of clusters

// The hull of the points of a cluster, with its planes as the proof numbers them.
struct ClusterHull {
  std::vector<PointId> points;
  std::vector<std::array<PointId, 3>> facets;  // fans of the facets; none if it is flat
  std::vector<Halfspace> planes;               // each once
  std::vector<std::size_t> number;             // by plane: in the proof, where each fan has several
  std::vector<std::vector<PointId>> corners;   // by plane: of the facet; all points if it is flat
  std::vector<ClusterPlane> near;              // by plane
};

ClusterHull hull_of(const Surface& surface, std::span<const TriangleId> triangles) {
  ClusterHull made;
  made.points = points_of(surface, triangles);
  const PointSet points = subset(surface.points, made.points);
  const auto near = surface.points.doubles();
  const HullOutcome outcome = convex_hull(points);
  if (const auto* hull = std::get_if<Hull>(&outcome)) {
    made.planes = facet_halfspaces(*hull, points);
    for (std::size_t f = 0; f < hull->facets.size(); ++f) {
      std::vector<PointId> corners;
      for (const PointId p : hull->facets[f]) corners.push_back(made.points[p.index()]);
      made.number.push_back(made.facets.size());
      for (std::size_t k = 2; k < corners.size(); ++k) {
        made.facets.push_back({corners[0], corners[k - 1], corners[k]});
      }
      made.near.push_back(cluster_plane(made.planes[f], near[corners[0].index()]));
      made.corners.push_back(std::move(corners));
    }
    return made;
  }
  made.planes = convex_part(points).halfspaces;
  for (std::size_t f = 0; f < made.planes.size(); ++f) {
    made.number.push_back(f);
    made.corners.push_back(made.points);
    // Of its planes only the value at the points counts, so any point near the plane will do.
    const auto on_it = std::find_if(made.points.begin(), made.points.end(), [&](PointId p) {
      return made.planes[f](surface.points[p]) == 0;
    });
    made.near.push_back(cluster_plane(made.planes[f], near[on_it->index()]));
  }
  return made;
}

// ---- HullRays

// Where concavity is taken: at all points of a triangle, or at one point.
struct RaySource {
  std::uint32_t id;  // of the triangle or the point
  std::vector<PointId> corners;
  IntegerVector3 direction;
  Point near_direction;  // of length 1
  Rational squared_length;
};

struct HullRay {
  Rational u = 0, w = 0;  // from a + u (b - a) + w (c - a)
  Rational length = 0;    // in multiples of the direction
  std::size_t plane = 0;  // where it leaves the hull
};

// A bound of the rays of a source: a combination of planes.
using PlaneSum = std::vector<std::pair<std::size_t, Rational>>;

class HullRays {
 public:
  HullRays(const Surface& surface, const ClusterHull& hull) : surface_(surface), hull_(hull) {}

  // The length of a ray as the plane cuts it, in doubles; infinity if it runs away from the plane.
  double near_length(const RaySource& source, std::size_t plane, const Point& from) const {
    const ClusterPlane& near = hull_.near[plane];
    const double speed = near.normal.dot(source.near_direction);
    if (!(speed > 1e-12)) return std::numeric_limits<double>::infinity();
    return -(near.normal.dot(from) + near.offset) / speed;
  }
  Point near_point(PointId p) const { return surface_.points.doubles()[p.index()]; }

  // The plane that cuts the ray first, likewise, and its length.
  std::pair<std::size_t, double> near_exit(const RaySource& source, const Point& from) const {
    std::pair<std::size_t, double> first{0, std::numeric_limits<double>::infinity()};
    for (std::size_t h = 0; h < hull_.planes.size(); ++h) {
      const double length = near_length(source, h, from);
      if (length < first.second) first = {h, length};
    }
    return first;
  }
  // The plane for which the longest ray from a corner is shortest, and that length.
  std::pair<std::size_t, double> near_bound(const RaySource& source) const {
    std::pair<std::size_t, double> best{0, std::numeric_limits<double>::infinity()};
    for (std::size_t h = 0; h < hull_.planes.size(); ++h) {
      double longest = 0;
      for (const PointId p : source.corners) {
        longest = std::max(longest, near_length(source, h, near_point(p)));
      }
      if (longest < best.second) best = {h, longest};
    }
    return best;
  }

  RationalPoint point(const RaySource& source, const HullRay& ray) const {
    RationalPoint a = surface_.points[source.corners[0]];
    if (source.corners.size() == 1) return a;
    return a + ray.u * (surface_.points[source.corners[1]] - a) +
           ray.w * (surface_.points[source.corners[2]] - a);
  }
  RationalPoint end(const RaySource& source, const HullRay& ray) const {
    return point(source, ray) + ray.length * source.direction.cast<Rational>();
  }

  // Exactly, with length and plane filled in.
  HullRay leave(const RaySource& source, HullRay ray) const {
    const RationalPoint from = point(source, ray);
    std::optional<Rational> least;
    for (std::size_t h = 0; h < hull_.planes.size(); ++h) {
      const Integer speed = dot(hull_.planes[h].normal(), source.direction);
      if (speed <= 0) continue;
      Rational length = -hull_.planes[h](from) / Rational(speed);
      if (least && *least <= length) continue;
      least = std::move(length);
      ray.plane = h;
    }
    ray.length = least.value_or(Rational(0));
    return ray;
  }

  // Whether no ray of the source that stays behind the plane (n, d) is longer than the limit.
  bool is_bound(const RaySource& source, const RationalVector3& n, const Rational& d,
                const Rational& squared_limit) const {
    const Rational speed = n.dot(source.direction.cast<Rational>());
    if (speed <= 0) return false;
    return std::all_of(source.corners.begin(), source.corners.end(), [&](PointId p) {
      const Rational length = (n.dot(surface_.points[p]) + d) / speed;
      return length * length * source.squared_length <= squared_limit;
    });
  }
  bool is_bound(const RaySource& source, std::size_t plane, const Rational& squared_limit) const {
    const Halfspace& h = hull_.planes[plane];
    return is_bound(source, h.normal().cast<Rational>(), Rational(h.offset()), squared_limit);
  }
  bool is_bound(const RaySource& source, const PlaneSum& combination,
                const Rational& squared_limit) const {
    RationalVector3 n = RationalVector3::Zero();
    Rational d = 0;
    for (const auto& [plane, factor] : combination) {
      n += factor * hull_.planes[plane].normal().cast<Rational>();
      d += factor * Rational(hull_.planes[plane].offset());
    }
    return is_bound(source, n, d, squared_limit);
  }

  // The longest ray of a triangle, or a bound that is within the limit: as few planes as decide it.
  struct Longest {
    HullRay ray;
    bool is_within;
    PlaneSum bound;  // no ray is longer than the limit, or than this one
  };
  Longest longest(const RaySource& source, const Rational& squared_limit) const;

 private:
  const Surface& surface_;
  const ClusterHull& hull_;
};

// A linear program in u, w and the length; of the planes that do not bound it, the one that is
// passed farthest joins, until there is none.
HullRays::Longest HullRays::longest(const RaySource& source, const Rational& squared_limit) const {
  const RationalPoint a = surface_.points[source.corners[0]],
                      b = surface_.points[source.corners[1]],
                      c = surface_.points[source.corners[2]];
  std::vector<std::size_t> planes{leave(source, {Rational(1, 3), Rational(1, 3)}).plane};
  for (;;) {
    const auto rows = static_cast<Eigen::Index>(planes.size());
    LinearProgram lp{RationalMatrix::Zero(rows + 3, 3), RationalVector::Zero(rows + 3),
                     RationalVector::Zero(3)};
    for (Eigen::Index k = 0; k < rows; ++k) {
      const Halfspace& plane = hull_.planes[planes[static_cast<std::size_t>(k)]];
      const Rational at_a = plane(a);
      lp.normals(k, 0) = plane(b) - at_a;
      lp.normals(k, 1) = plane(c) - at_a;
      lp.normals(k, 2) = Rational(dot(plane.normal(), source.direction));
      lp.offsets[k] = at_a;
    }
    lp.normals(rows, 0) = -1;      // u >= 0
    lp.normals(rows + 1, 1) = -1;  // w >= 0
    lp.normals(rows + 2, 0) = lp.normals(rows + 2, 1) = 1;
    lp.offsets[rows + 2] = -1;  // u + w <= 1
    lp.objective[2] = 1;
    const Optimal best = std::get<Optimal>(maximise(lp));
    Longest found{{best.x[0], best.x[1], best.x[2]}, false, {}};
    for (const auto& [row, factor] : best.tight) {
      if (row < planes.size()) found.bound.emplace_back(planes[row], factor);
    }
    found.is_within = best.x[2] * best.x[2] * source.squared_length <= squared_limit;
    if (found.is_within) return found;
    const HullRay exact = leave(source, found.ray);
    if (exact.length == found.ray.length) {
      found.ray.plane = exact.plane;
      return found;
    }
    planes.push_back(exact.plane);
  }
}

// ---- The proof

class DecompositionWriter {
 public:
  DecompositionWriter(const Decomposition& made, const DecomposeRequest& request);
  std::string write();

 private:
  struct Cluster {
    std::vector<TriangleId> triangles;
    const Part* part;  // none if it lies in another one
  };

  template <class... Fields>
  void line(const std::string& keyword, const Fields&... fields) {
    text_ += keyword;
    (add(fields), ...);
    text_ += '\n';
  }
  void add(const char* word) { text_ += std::string(" ") + word; }
  void add(std::size_t number) { text_ += fmt::format(" {}", number); }
  void add(std::uint32_t number) { text_ += fmt::format(" {}", number); }
  void add(double number) { text_ += fmt::format(" {:a}", number); }
  void add(const Rational& number) { add_word(to_string(number)); }
  void add_word(const std::string& word) { text_ += ' ' + word; }
  template <class Tag>
  void add(Id<Tag> id) {
    add(id.value);
  }
  template <class Number>
  void add(const Vector3<Number>& v) {
    for (int k = 0; k < 3; ++k) add(v[k]);
  }
  template <class Item>
  void add(const std::vector<Item>& items) {
    for (const Item& item : items) add(item);
  }
  template <class Item, std::size_t size>
  void add(const std::array<Item, size>& items) {
    for (const Item& item : items) add(item);
  }
  void add(const Halfspace& plane) {
    for (const Integer& n : plane.normal()) add_word(to_string(n));
    add_word(to_string(plane.offset()));
  }
  void add(const std::vector<Multiplier>& weights) {
    for (const auto& [row, value] : weights) {
      add(row);
      add(value);
    }
  }

  void write_points(const char* keyword, const PointSet& points) {
    for (std::size_t p = 0; p < points.size(); ++p) {
      if (points.is_binary()) {
        line(keyword, points.doubles()[p]);
      } else {
        line(keyword, points[PointId(p)]);
      }
    }
  }

  void find_clusters();
  void write_surface();
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
  std::string text_;
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
  // Whether all pairs are beyond the limit decides on the claim, which stands before.
  const bool asks_for_pairs = request_.connect == Connect::Edge && !by_bridges();
  const bool shows_pairs = asks_for_pairs && write_pairs();
  if (asks_for_pairs && !shows_pairs && request_.engine != Engine::Float) {
    throw Error(ErrorCode::Internal, "two neighbours are within the limit together");
  }
  const std::string pairs = shows_pairs ? std::move(text_) : "";
  text_.clear();
  line("convexact-proof", "4", "decomposition");
  line("measure", by_bridges() ? "bridges" : at_corners() ? "vertices" : "surface");
  line("limit", request_.limit.is_share ? "share" : "length", request_.limit.value);
  const bool shows_edges = shows_pairs || (by_bridges() && request_.connect == Connect::Edge);
  line("neighbours", shows_edges ? "edges" : "unclaimed");
  write_surface();
  for (const Cluster& cluster : clusters_) write_cluster(cluster);
  for (std::size_t c = 0; c < clusters_.size(); ++c) {
    if (clusters_[c].part != nullptr) write_part(c, clusters_[c]);
  }
  text_ += pairs;
  const auto lines = static_cast<std::size_t>(std::count(text_.begin(), text_.end(), '\n'));
  line("end", lines + 1);
  return std::move(text_);
}

void DecompositionWriter::write_surface() {
  write_points("point", surface_.points);
  for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
    line("triangle", surface_.triangles[t], surface_.face[t]);
  }
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

// A point of a hull as a convex combination of at most four of its extreme points, by the dual of:
// which plane has all of them on one side, and this point farthest on the other one?
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
  line("cluster", cluster.triangles);
  const ClusterHull hull = hull_of(surface_, cluster.triangles);
  for (const auto& facet : hull.facets) line("facet", facet);
  for (const Halfspace& plane : hull.planes) {
    if (hull.facets.empty()) line("side", plane);
  }
  if (by_bridges()) {
    const Rational depth = least_concavity(cluster);
    if (depth > 0) line("depth", depth);
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
    line(keyword, clusters, source.id, ray.length, weights);
  } else {
    line(keyword, clusters, source.id, ray.u, ray.w, ray.length, weights);
  }
}

// Most triangles are bounded by a single plane: a line for all that have the same one.
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
  for (const auto& [plane, ids] : by_plane) line("within", plane, ids);
  for (const RaySource& source : open) write_combined(source, rays, hull, squared);
}

// Factors of 53 bits, if they will do.
void DecompositionWriter::write_combined(const RaySource& source, const HullRays& rays,
                                         const ClusterHull& hull, const Rational& squared) {
  const HullRays::Longest longest = rays.longest(source, squared);
  if (!longest.is_within) {
    throw Error(ErrorCode::Internal, "a triangle lies deeper than its cluster");
  }
  const auto number = [&](std::size_t plane) { return hull.number[plane]; };
  long exponent = exponent_of(longest.bound.front().second);
  for (const auto& [plane, factor] : longest.bound) {
    exponent = std::max(exponent, exponent_of(factor));
  }
  PlaneSum rounded = longest.bound;
  for (auto& [plane, factor] : rounded) {
    factor = to_rational(to_double(scale_by_power_of_two(factor, -exponent), Rounding::Nearest));
  }
  const bool is_short = rays.is_bound(source, rounded, squared);
  text_ += fmt::format("combined {}", source.id);
  for (const auto& [plane, factor] : is_short ? rounded : longest.bound) {
    add(number(plane));
    if (is_short) {
      add(to_double(factor, Rounding::Nearest));
    } else {
      add(factor);
    }
  }
  text_ += '\n';
}

// ---- Parts

void DecompositionWriter::write_part(std::size_t number, const Cluster& cluster) {
  const Part& part = *cluster.part;
  const PointSet& stored = part.mesh.points;
  const auto same_points = [&] {
    const ClusterHull hull = hull_of(surface_, cluster.triangles);
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
    line("part", "hull", number);
    line("owns", part.owns);
    return;
  }
  const HullOutcome outcome = convex_hull(stored);
  const auto* hull = std::get_if<Hull>(&outcome);
  line("part", hull != nullptr ? "stored" : "flat", number);
  write_points("corner", stored);
  if (hull != nullptr) {
    for (std::size_t f = 0; f < hull->facets.size(); ++f) {
      const std::span<const PointId> facet = hull->facets[f];
      for (std::size_t k = 2; k < facet.size(); ++k)
        line("facet", facet[0], facet[k - 1], facet[k]);
    }
    line("owns", part.owns);
    return;
  }
  line("owns", part.owns);
  std::vector<RationalPoint> corners;
  for (std::size_t k = 0; k < stored.size(); ++k) corners.push_back(stored[PointId(k)]);
  for (const PointId p : points_of(surface_, part.owns)) {
    const RationalPoint x = surface_.points[p];
    if (std::find(corners.begin(), corners.end(), x) != corners.end()) continue;
    line("between", p, convex_combination(corners, x));
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
  const ClusterHull hull = hull_of(surface_, both);
  const HullRays rays(surface_, hull);
  const auto found = beyond_limit(both, rays);
  if (found) write_ray("apart", {a, b}, found->first, found->second, rays, hull);
  return found.has_value();
}

// Centroids are tried first, since they are fewest, and corners next; of each the longest rays, as
// doubles tell; then all points.
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
  return DecompositionWriter(made, request).write();
}

}  // namespace convexact
