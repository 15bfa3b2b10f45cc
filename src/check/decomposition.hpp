// SPDX-License-Identifier: MIT
// decomposition.hpp - proofs of decompositions: clusters of triangles and the concavity of each,
// that no two of them can be merged, and convex parts that hold the triangles that they own. For
// clusters made by splitting only the depth of points, for any choice of bridges over them.
//
// The numbers in parentheses are the steps of docs/decomposition-proof.md.
#pragma once
#include <map>
#include <set>

#include "surface.hpp"

namespace check {

class DecompositionProof : public SurfaceProof {
 public:
  explicit DecompositionProof(const std::string& bytes) : SurfaceProof(bytes) {}

 private:
  struct Cluster {
    Ids triangles;
    IdSet points;
    std::vector<Row> planes;  // each holds the points
    std::size_t facets = 0;   // this many planes come first, and bound the hull of the points
    Rational concavity = 0;   // squared
    bool has_part = false;
  };

  std::string check_statements() override {
    expect(
        words_.take_if("convexact-proof") && words_.take_if("4") && words_.take_if("decomposition"),
        "convexact-proof 4 decomposition");
    read_question();
    read_surface();
    while (words_.take_if("cluster")) read_cluster();
    for (const std::size_t c : cluster_of_) require(c != kNone, "a triangle is in no cluster");
    while (words_.take_if("part")) read_part();
    for (const std::size_t p : owner_) require(p != kNone, "a triangle has no owner");
    const std::size_t pairs = read_pairs();
    const std::string reach = read_reach(parts_);
    words_.end();
    return "proven: each of " + count(triangles_.size(), " triangles is in one of ") +
           count(clusters_.size(), " clusters") + (by_edges_ ? ", connected over edges" : "") +
           (by_bridges_ ? depths_text() : concavities_text(pairs)) +
           "\nproven: each triangle lies in its owner, one of " +
           count(parts_.size(), " convex parts, ") +
           count(hulls_, " of them exactly hulls of clusters\n") + reach;
  }

  std::string concavities_text(std::size_t pairs) const {
    std::size_t within = 0;
    for (const Cluster& cluster : clusters_) within += cluster.concavity <= squared_limit_ ? 1 : 0;
    return std::string("\nproven: each cluster is as concave as stated, ") +
           (at_corners_ ? "at its corners, " : "at all of its points, ") +
           count(within, " of them within the limit of ") + limit_ +
           (by_edges_ ? "\nproven: each of " +
                            count(pairs, " pairs of neighbours is beyond it, as one cluster")
                      : "\nnot claimed: that clusters are connected, or that neighbours are beyond "
                        "it, as one cluster");
  }
  std::string depths_text() const {
    std::size_t deeper = 0;
    for (const Cluster& cluster : clusters_) deeper += cluster.concavity > squared_limit_ ? 1 : 0;
    return "\nproven: corners lie as deep in the hulls of their clusters as stated, " +
           count(deeper, " clusters deeper than the limit of ") + limit_ +
           "\nnot claimed: concavities to bridges, which are at least as large" +
           (by_edges_ ? "" : "; that clusters are connected");
  }

  // The kind of concavity, the limit, and the definition of neighbours.
  void read_question() {
    expect(words_.take_if("measure"), "measure");
    at_corners_ = words_.take_if("vertices");
    by_bridges_ = !at_corners_ && words_.take_if("bridges");
    expect(at_corners_ || by_bridges_ || words_.take_if("surface"), "surface, vertices or bridges");
    expect(words_.take_if("limit"), "limit");
    limit_is_share_ = words_.take_if("share");
    expect(limit_is_share_ || words_.take_if("length"), "share or length");
    const Rational limit = words_.rational();
    expect(limit >= 0, "a limit that is not negative");
    limit_ = limit.get_str() + (limit_is_share_ ? " of the diameter" : "");
    squared_limit_ = limit * limit;
    expect(words_.take_if("neighbours"), "neighbours");
    by_edges_ = words_.take_if("edges");
    expect(by_edges_ || words_.take_if("unclaimed"), "edges or unclaimed");
  }

  void read_surface() {
    read_triangles();
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      const Corners& at = triangles_[t];
      for (std::size_t e = 0; e < 3 && !has_repeats(at); ++e) {
        at_edge_[sorted(at[e], at[(e + 1) % 3])].push_back(t);
      }
    }
    if (limit_is_share_) squared_limit_ *= squared_diameter();
    find_directions();
    cluster_of_.resize(triangles_.size(), kNone);
    owner_.resize(triangles_.size(), kNone);
  }

  // (2) The direction in which concavity is taken, in coprime integers: for a triangle its normal,
  // for a point the sum of the area vectors around it. Zero if there is none.
  void find_directions() {
    if (by_bridges_) return;
    std::vector<Numbers> sums(at_corners_ ? points_.size() : 0);
    for (const Corners& t : triangles_) {
      const Row &a = points_[t[0]], &b = points_[t[1]], &c = points_[t[2]];
      const Row plane = plane_of(a, b, c);
      const Integer w = a[3] * b[3] * c[3];
      const Numbers area{quotient(plane[0], w), quotient(plane[1], w), quotient(plane[2], w), 0};
      if (!at_corners_) {
        directions_.push_back(direction(area));
      } else {
        for (const std::size_t p : t) {
          for (std::size_t k = 0; k < 3; ++k) sums[p][k] += area[k];
        }
      }
    }
    for (const Numbers& sum : sums) directions_.push_back(direction(sum));
  }
  static Row direction(const Numbers& v) {
    const Row row = scaled(v);
    return has_normal(row) ? primitive(row) : row;
  }

  // (3) The cluster: each triangle is in one, and its triangles are connected over edges.
  void read_cluster() {
    Cluster cluster;
    cluster.triangles = words_.ids(triangles_.size());
    expect(!cluster.triangles.empty(), "the triangles of a cluster");
    for (const std::size_t t : cluster.triangles) {
      require(cluster_of_[t] == kNone, "a triangle is in a cluster already");
      cluster_of_[t] = clusters_.size();
      cluster.points.insert(triangles_[t].begin(), triangles_[t].end());
    }
    if (by_edges_) require_connected(cluster);
    read_planes(cluster);
    if (by_bridges_) {
      read_depth(cluster);
    } else {
      if (words_.take_if("deepest")) {
        cluster.concavity = read_ray(cluster.triangles, cluster.points);
      }
      read_bounds(cluster);
    }
    clusters_.push_back(cluster);
  }
  void require_connected(const Cluster& cluster) const {
    const std::size_t c = clusters_.size();
    IdSet reached;
    Ids next{cluster.triangles[0]};
    while (!next.empty()) {
      const Corners t = triangles_[next.back()];
      const bool is_new = reached.insert(next.back()).second;
      next.pop_back();
      for (std::size_t e = 0; e < 3 && is_new && !has_repeats(t); ++e) {
        for (const std::size_t other : at_edge_.at(sorted(t[e], t[(e + 1) % 3]))) {
          if (cluster_of_[other] == c) next.push_back(other);
        }
      }
    }
    require(reached.size() == cluster.triangles.size(), "the cluster is not connected");
  }

  // Facets of the cluster's hull, or else some halfspaces that hold its points.
  void read_planes(Cluster& cluster) {
    std::vector<Row> points;
    for (const std::size_t p : cluster.points) points.push_back(points_[p]);
    std::vector<std::array<Row, 3>> facets;
    while (words_.take_if("facet")) {
      const Corners f = corners(points_.size());
      for (const std::size_t p : f)
        require(cluster.points.count(p) == 1, "a corner of no triangle");
      facets.push_back({points_[f[0]], points_[f[1]], points_[f[2]]});
    }
    cluster.facets = facets.size();
    if (cluster.facets > 0) cluster.planes = planes_of_hull(points, facets);
    while (words_.take_if("side")) {
      const Row plane = primitive(scaled(words_.halfspace()));
      for (const Row& p : points) require(dot(plane, p) <= 0, "a point is beyond a side");
      cluster.planes.push_back(plane);
    }
  }

  // (5) A ray from a point M of the triangles, in the direction there, to a convex combination of
  // points: so it runs inside of their hull. Its squared length.
  Rational read_ray(const Ids& triangles, const IdSet& points) {
    const std::size_t item = words_.id(directions_.size());
    const bool is_theirs =
        at_corners_ ? points.count(item) == 1
                    : std::find(triangles.begin(), triangles.end(), item) != triangles.end();
    require(is_theirs, "the ray starts elsewhere");
    Numbers x = at_corners_ ? numbers(points_[item]) : read_place(triangles_[item]);
    const Rational s = words_.rational();
    require(s >= 0, "the ray runs inward");
    const Row& n = directions_[item];
    for (std::size_t k = 0; k < 3; ++k) x[k] += s * n[k];
    require(read_combination(points_, points) == x, "the ray ends elsewhere");
    return s * s * dot3(n, n);
  }
  static Numbers numbers(const Row& p) {
    return {quotient(p[0], p[3]), quotient(p[1], p[3]), quotient(p[2], p[3]), 1};
  }
  // a + u (b - a) + w (c - a)
  Numbers read_place(const Corners& t) {
    const Rational u = words_.rational(), w = words_.rational();
    require(u >= 0 && w >= 0 && u + w <= 1, "the ray starts outside of the triangle");
    const Numbers a = numbers(points_[t[0]]), b = numbers(points_[t[1]]),
                  c = numbers(points_[t[2]]);
    Numbers x;
    for (std::size_t k = 0; k < 4; ++k) x[k] = a[k] + u * (b[k] - a[k]) + w * (c[k] - a[k]);
    return x;
  }
  // A sum of points times weights, none negative; the fourth number is the sum of the weights.
  Numbers read_combination(const std::vector<Row>& rows, const IdSet& allowed) {
    Numbers sum;
    while (words_.at_number()) {
      const std::size_t p = words_.id(rows.size());
      require(allowed.count(p) == 1, "a point of the combination is not allowed");
      const Rational weight = words_.rational();
      require(weight >= 0, "a weight is negative");
      const Numbers x = numbers(rows[p]);
      for (std::size_t k = 0; k < 4; ++k) sum[k] += weight * x[k];
    }
    return sum;
  }

  // (6) No ray from a triangle, or from a corner, is longer than the concavity. A non-negative
  // combination of planes holds the cluster, too: so a ray from M leaves the hull at that plane at
  // the latest, after a length that is affine in M, and largest at a corner.
  void read_bounds(const Cluster& cluster) {
    IdSet open;
    if (at_corners_) {
      open = cluster.points;
    } else {
      open.insert(cluster.triangles.begin(), cluster.triangles.end());
    }
    for (auto item = open.begin(); item != open.end();) {
      item = has_normal(directions_[*item]) ? std::next(item) : open.erase(item);
    }
    for (;;) {
      if (words_.take_if("within")) {
        const Row& plane = cluster.planes[words_.id(cluster.planes.size())];
        for (const std::size_t item : words_.ids(directions_.size())) {
          bound(cluster, plane, item, open);
        }
      } else if (words_.take_if("combined")) {
        const std::size_t item = words_.id(directions_.size());
        bound(cluster, read_combined(cluster), item, open);
      } else {
        break;
      }
    }
    require(open.empty(), "the concavity is not bounded everywhere");
  }
  Row read_combined(const Cluster& cluster) {
    Numbers sum;
    while (words_.at_number()) {
      const Row& plane = cluster.planes[words_.id(cluster.planes.size())];
      const Rational factor = words_.rational();
      require(factor >= 0, "a multiplier is negative");
      for (std::size_t k = 0; k < 4; ++k) sum[k] += factor * plane[k];
    }
    return scaled(sum);
  }
  void bound(const Cluster& cluster, const Row& plane, std::size_t item, IdSet& open) const {
    require(open.erase(item) == 1, "nothing is to be bounded there");
    const Row& n = directions_[item];
    const Integer speed = dot3(plane, n);
    require(speed > 0, "the rays do not run towards the plane");
    const Corners single{item, item, item};
    for (const std::size_t corner : at_corners_ ? single : triangles_[item]) {
      const Row& p = points_[corner];
      const Rational t = quotient(-dot(plane, p), speed * p[3]);
      require(t * t * dot3(n, n) <= cluster.concavity, "a ray may be longer than the concavity");
    }
  }

  // Whether some plane holds the points.
  bool is_flat(const IdSet& ids) const {
    Row plane;  // through the first point, the first other one, and the first off the line of both
    const Row &first = points_[*ids.begin()], *second = nullptr;
    for (const std::size_t id : ids) {
      const Row& p = points_[id];
      if (second == nullptr) {
        if (p != first) second = &p;
      } else if (!has_normal(plane)) {
        plane = plane_of(first, *second, p);
      } else if (dot(plane, p) != 0) {
        return false;
      }
    }
    return true;
  }

  // (10) The largest distance of a point of the cluster to the nearest facet of its hull, squared.
  // The points are inside, so that is the distance to the nearest of the facets' planes.
  // Only a flat cluster, whose points are all on its boundary, has no facets.
  void read_depth(Cluster& cluster) {
    if (words_.take_if("depth")) cluster.concavity = words_.rational();
    require(cluster.facets > 0 || is_flat(cluster.points),
            "a cluster that is not flat has no facets");
    Rational deepest = 0;
    for (const std::size_t p : cluster.points) {
      std::vector<Rational> squared;
      for (std::size_t f = 0; f < cluster.facets; ++f) {
        const Row& plane = cluster.planes[f];
        const Rational value = quotient(dot(plane, points_[p]), points_[p][3]);
        squared.push_back(value * value / dot3(plane, plane));
      }
      if (!squared.empty()) {
        deepest = std::max(deepest, *std::min_element(squared.begin(), squared.end()));
      }
    }
    require(deepest == cluster.concavity, "its points lie deeper, or less deep");
  }

  // (7) A part is the hull of its cluster, or of the stored corners; in the latter case with facets
  // or, if it is flat, without. It owns at least the triangles of its cluster, and holds their
  // corners.
  void read_part() {
    const std::string form = words_.take();
    expect(is_one_of(form, {"hull", "stored", "flat"}), "hull, stored or flat");
    Cluster& cluster = clusters_[words_.id(clusters_.size())];
    require(!cluster.has_part, "the cluster has a part already");
    cluster.has_part = true;
    std::vector<Row> stored, planes;
    PlacedPart placed;
    if (form == "hull") {
      require(cluster.facets > 0, "the cluster has no facets");
      planes = cluster.planes;
      for (const std::size_t p : cluster.points) placed.corners.push_back(vector_of(points_[p]));
      ++hulls_;
    }
    while (form != "hull" && words_.take_if("corner")) stored.push_back(words_.point());
    if (form == "stored") {
      std::vector<std::array<Row, 3>> facets;
      while (words_.take_if("facet")) {
        const Corners f = corners(stored.size());
        facets.push_back({stored[f[0]], stored[f[1]], stored[f[2]]});
      }
      planes = planes_of_hull(stored, facets);
    }
    expect(words_.take_if("owns"), "owns");
    IdSet held;  // points
    for (const std::size_t t : words_.ids(triangles_.size())) {
      require(owner_[t] == kNone, "a triangle has an owner already");
      owner_[t] = parts_.size();
      held.insert(triangles_[t].begin(), triangles_[t].end());
    }
    for (const std::size_t t : cluster.triangles) {
      require(owner_[t] == parts_.size(), "it does not own its cluster");
    }
    if (form == "flat") {
      require_combinations(held, stored);
    } else {
      for (const std::size_t p : held) {
        if (form == "hull" && cluster.points.count(p) == 1) continue;  // by (4)
        for (const Row& plane : planes) {
          require(dot(plane, points_[p]) <= 0, "a triangle reaches out of its owner");
        }
      }
    }
    for (const Row& corner : stored) placed.corners.push_back(vector_of(corner));
    placed.planes = std::move(planes);
    parts_.push_back(std::move(placed));
  }
  // Each point is a convex combination of the corners: the proof gives the combination of each one
  // that is no corner.
  void require_combinations(const IdSet& points, const std::vector<Row>& stored) {
    std::set<Row> known(stored.begin(), stored.end());
    IdSet all;
    for (std::size_t k = 0; k < stored.size(); ++k) all.insert(k);
    while (words_.take_if("between")) {
      const Row& p = points_[words_.id(points_.size())];
      require(read_combination(stored, all) == numbers(p), "the combination is another point");
      known.insert(p);
    }
    for (const std::size_t p : points) {
      require(known.count(points_[p]) == 1, "a triangle reaches out of its owner");
    }
  }

  // (8) For every two clusters with a common edge, a ray that is longer than the limit runs inside
  // of the hull of both. Returns the number of such pairs.
  std::size_t read_pairs() {
    std::set<Pair> open;
    for (const auto& [edge, triangles] : at_edge_) {
      for (const std::size_t s : triangles) {
        for (const std::size_t t : triangles) {
          if (by_edges_ && !by_bridges_ && cluster_of_[s] < cluster_of_[t]) {
            open.insert({cluster_of_[s], cluster_of_[t]});
          }
        }
      }
    }
    const std::size_t pairs = open.size();
    while (words_.take_if("apart")) {
      const std::size_t a = words_.id(clusters_.size()), b = words_.id(clusters_.size());
      require(open.erase({a, b}) == 1, "no neighbours, or they are apart already");
      Ids triangles = clusters_[a].triangles;
      IdSet points = clusters_[a].points;
      triangles.insert(triangles.end(), clusters_[b].triangles.begin(),
                       clusters_[b].triangles.end());
      points.insert(clusters_[b].points.begin(), clusters_[b].points.end());
      require(read_ray(triangles, points) > squared_limit_, "the ray is within the limit");
    }
    require(open.empty(), "two neighbours may be within the limit together");
    return pairs;
  }

  static constexpr std::size_t kNone = ~std::size_t{0};
  bool at_corners_ = false, by_bridges_ = false, limit_is_share_ = false, by_edges_ = false;
  std::string limit_;
  Rational squared_limit_;
  std::map<Pair, Ids> at_edge_;  // its triangles
  std::vector<Row> directions_;  // by triangle, or by point
  std::vector<Cluster> clusters_;
  Ids cluster_of_, owner_;  // by triangle
  std::vector<PlacedPart> parts_;
  std::size_t hulls_ = 0;
};

}  // namespace check
