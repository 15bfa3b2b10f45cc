// SPDX-License-Identifier: MIT
// definitional_decomposition.hpp - the claims of a decomposition's proof, and whether they are true
// by the definition. Witnesses (facets, bounds, convex combinations, the rays of pairs) are no
// claims.
#pragma once
#include <algorithm>
#include <set>

#include "convexact/cluster.hpp"
#include "convexact/measure.hpp"
#include "definitional_proof.hpp"

namespace definition {

/// The claims of a proof of docs/decomposition-proof.md that has been accepted, so is well-formed.
class DecompositionClaims {
 public:
  explicit DecompositionClaims(const std::string& text) : words_(text) {
    for (int k = 0; k < 4; ++k) words_.take();  // the kind, and the word measure
    measure_ = words_.take() == "surface" ? ConcavityMeasure::Surface : ConcavityMeasure::Vertices;
    words_.take();
    limit_.is_share = words_.take() == "share";
    limit_.value = words_.number();
    words_.take();
    by_edges_ = words_.take() == "edges";
    std::vector<RationalPoint> points;
    while (is_next("point")) points.push_back(words_.point());
    surface_.points = PointSet(points);
    while (is_next("triangle")) {
      std::array<PointId, 3> corners;
      for (PointId& corner : corners) corner = PointId(words_.id());
      surface_.triangles.push_back(corners);
      words_.id();
    }
    while (is_next("cluster")) read_cluster();
    while (is_next("part")) read_part();
  }
  std::size_t size() const { return surface_.points.size() + surface_.triangles.size(); }

  /// Whether all claims are true. For a dozen points and two dozen triangles.
  bool are_true() const {
    const ExactConcavity concavity(surface_, measure_);
    const Rational limit = limit_.squared(bounding_box(surface_.points).squared_diameter());
    std::vector<std::size_t> clusters(surface_.triangles.size()), owners(clusters.size());
    for (const Cluster& cluster : clusters_) {
      for (const TriangleId t : cluster.triangles) ++clusters[t.index()];
      if (of(cluster.triangles, concavity) != length(cluster, concavity)) return false;
      if (by_edges_ && !is_connected(cluster.triangles)) return false;
    }
    for (const Part& part : parts_) {
      for (const TriangleId t : part.owns) ++owners[t.index()];
      const ConvexPart solid = convex_part(
          part.corners.empty()
              ? subset(surface_.points, points_of(surface_, clusters_[part.cluster].triangles))
              : PointSet(part.corners));
      for (const PointId p : points_of(surface_, part.owns)) {
        if (!holds(solid, surface_.points[p])) return false;
      }
    }
    for (std::size_t a = 0; by_edges_ && a < clusters_.size(); ++a) {
      for (std::size_t b = a + 1; b < clusters_.size(); ++b) {
        std::vector<TriangleId> both = clusters_[a].triangles;
        both.insert(both.end(), clusters_[b].triangles.begin(), clusters_[b].triangles.end());
        if (is_connected(both) && of(both, concavity) <= limit) return false;
      }
    }
    const auto once = [](std::size_t times) { return times == 1; };
    return std::all_of(clusters.begin(), clusters.end(), once) &&
           std::all_of(owners.begin(), owners.end(), once);
  }

 private:
  struct Cluster {
    std::vector<TriangleId> triangles;
    std::size_t deepest = 0;  // a triangle or a point
    Rational multiple = 0;    // of its direction
  };
  struct Part {
    std::size_t cluster;
    std::vector<RationalPoint> corners;  // none if it is the cluster's hull
    std::vector<TriangleId> owns;
  };

  bool is_next(const std::string& keyword) {
    const bool found = words_.next() == keyword;
    if (found) words_.take();
    return found;
  }
  std::vector<TriangleId> triangles() {
    std::vector<TriangleId> list;
    for (const std::size_t t : words_.ids()) list.emplace_back(t);
    return list;
  }
  void skip_numbers() {
    while (words_.at_number()) words_.take();
  }
  void read_cluster() {
    Cluster cluster;
    cluster.triangles = triangles();
    while (is_next("facet") || is_next("side")) skip_numbers();
    if (is_next("deepest")) {
      cluster.deepest = words_.id();
      for (int k = 0; k < 2 && measure_ == ConcavityMeasure::Surface; ++k) words_.number();
      cluster.multiple = words_.number();
      skip_numbers();
    }
    while (is_next("within") || is_next("combined")) skip_numbers();
    clusters_.push_back(cluster);
  }
  void read_part() {
    Part part;
    words_.take();
    part.cluster = words_.id();
    while (is_next("corner")) part.corners.push_back(words_.point());
    while (is_next("facet")) skip_numbers();
    words_.take();
    part.owns = triangles();
    while (is_next("between")) skip_numbers();
    parts_.push_back(part);
  }

  Rational of(const std::vector<TriangleId>& triangles, const ExactConcavity& concavity) const {
    std::vector<TriangleId> sorted = triangles;
    std::sort(sorted.begin(), sorted.end());
    return concavity(sorted, convex_part(subset(surface_.points, points_of(surface_, sorted))))
        .squared;
  }
  Rational length(const Cluster& cluster, const ExactConcavity& concavity) const {
    if (cluster.multiple == 0) return 0;
    for (const TriangleId t : cluster.triangles) {
      for (int k = 0; k < 3; ++k) {
        const std::size_t item = measure_ == ConcavityMeasure::Surface
                                     ? t.index()
                                     : surface_.triangles[t.index()][std::size_t(k)].index();
        const IntegerVector3 n = concavity.direction(t, k);
        if (item == cluster.deepest)
          return cluster.multiple * cluster.multiple * Rational(n.dot(n));
      }
    }
    return -1;
  }
  bool is_connected(const std::vector<TriangleId>& triangles) const {
    std::vector<std::set<std::set<PointId>>> edges;
    for (const TriangleId t : triangles) {
      const auto& [a, b, c] = surface_.triangles[t.index()];
      edges.emplace_back();
      if (a != b && b != c && c != a) edges.back() = {{a, b}, {b, c}, {c, a}};
    }
    std::vector<bool> reached(triangles.size(), false);
    reached[0] = true;
    for (bool grows = true; grows;) {
      grows = false;
      for (std::size_t s = 0; s < edges.size(); ++s) {
        for (std::size_t t = 0; t < edges.size(); ++t) {
          if (!reached[s] || reached[t]) continue;
          reached[t] = std::any_of(edges[s].begin(), edges[s].end(),
                                   [&](const auto& edge) { return edges[t].count(edge) == 1; });
          grows = grows || reached[t];
        }
      }
    }
    return std::all_of(reached.begin(), reached.end(), [](bool is) { return is; });
  }

  ProofWords words_;
  ConcavityMeasure measure_;
  ConcavityLimit limit_;
  bool by_edges_ = false;
  Surface surface_;
  std::vector<Cluster> clusters_;
  std::vector<Part> parts_;
};

}  // namespace definition
