// SPDX-License-Identifier: MIT
#include <algorithm>
#include <memory>
#include <set>

#include "convexact/cluster.hpp"
#include "convexact/error.hpp"
#include "decompose/divide.hpp"

namespace convexact {
namespace {

constexpr std::size_t kMostPoints = std::size_t(1) << 22;  // so that lengths of paths have 64 bits

void require_sensible(const Surface& surface, const SplitOptions& options) {
  if (options.coplanar <= 0 || options.coplanar > 1) {
    throw Error(ErrorCode::InvalidArgument,
                "the cosine from which facets are coplanar is above 0, and at most 1");
  }
  if (surface.points.size() > kMostPoints) {
    throw Error(ErrorCode::InvalidArgument,
                "the surface has more than 4,194,304 points, for which lengths of paths are exact");
  }
}

struct Evaluated {
  Patch patch;
  PatchHull hull;
  std::optional<Notch> notch;
  Association association;
};

class PartMeasure {
 public:
  PartMeasure(const Surface& surface, const SplitOptions& options)
      : surface_(surface), options_(options), near_(surface), lengths_(surface.points, near_) {}

  Evaluated operator()(std::span<const TriangleId> triangles) const {
    Evaluated made{Patch(surface_, triangles, lengths_), {}, {}, {}};
    made.hull = hull_of(surface_, made.patch, options_.watch);
    if (made.hull.facets.empty()) {  // flat: every point lies on the hull
      made.association.points.assign(made.patch.points().begin(), made.patch.points().end());
      made.association.bridges_of.resize(made.association.points.size());
      return made;
    }
    made.association = associate(surface_, made.patch, made.hull, near_, options_);
    made.notch = deepest_notch(surface_, made.patch, made.hull, made.association, options_.bridge,
                               near_, options_.watch);
    return made;
  }

  Concavity concavity(const Evaluated& part) const {
    Concavity found;
    found.normal = IntegerVector3::Zero();
    found.triangle = part.patch.triangles().front();
    found.at = found.leaves = surface_.points[part.patch.points().front()];
    if (!part.notch) return found;
    found.squared = part.notch->squared;
    found.at = surface_.points[part.notch->point];
    found.leaves = part.notch->on_bridge;
    const auto triangles = part.patch.triangles();
    found.triangle = *std::find_if(triangles.begin(), triangles.end(), [&](TriangleId t) {
      const auto& corners = surface_.triangles[t.index()];
      return std::find(corners.begin(), corners.end(), part.notch->point) != corners.end();
    });
    return found;
  }

  const NearSurface& near() const { return near_; }

 private:
  const Surface& surface_;
  const SplitOptions& options_;
  NearSurface near_;
  EdgeLengths lengths_;
};

class Splitter {
 public:
  Splitter(const Surface& surface, const SplitOptions& options, ClusterStart start)
      : surface_(surface), options_(options), units_(surface, start), measure_(surface, options) {
    made_.squared_diameter = std::move(start.squared_diameter);
    made_.squared_limit = std::move(start.squared_limit);
    made_.united = std::move(start.united);
  }

  SplitTree run() {
    for (const auto& triangles : groups()) add_node(triangles, {});
    made_.roots = made_.nodes.size();
    while (!waiting_.empty()) {
      if (options_.max_parts && leaf_count_ >= *options_.max_parts) {
        made_.stopped_by_count = true;
        break;
      }
      options_.watch.at(settled_ - settled_ % 256, surface_.triangles.size());
      split(*waiting_.begin());
    }
    for (std::uint32_t n = 0; n < made_.nodes.size(); ++n) {
      if (!made_.nodes[n].is_split) add_leaf(n);
    }
    std::sort(made_.leaves.begin(), made_.leaves.end(), [](const SplitLeaf& a, const SplitLeaf& b) {
      return a.triangles.front() < b.triangles.front();
    });
    return std::move(made_);
  }

 private:
  // The most concave first, of equal ones that with the lowest triangle.
  struct DeeperFirst {
    const std::vector<SplitNode>* nodes;
    bool operator()(std::uint32_t a, std::uint32_t b) const {
      const SplitNode &x = (*nodes)[a], &y = (*nodes)[b];
      if (x.concavity.squared != y.concavity.squared) {
        return x.concavity.squared > y.concavity.squared;
      }
      return x.lowest < y.lowest;
    }
  };

  // Units joined over neighbours, by their lowest triangles.
  std::vector<std::vector<TriangleId>> groups() const {
    std::vector<std::vector<TriangleId>> found;
    std::vector<bool> is_seen(surface_.triangles.size(), false);
    for (std::uint32_t t = 0; t < is_seen.size(); ++t) {
      if (is_seen[t] || units_.of(TriangleId(t)) != t) continue;
      std::vector<std::uint32_t> group{t};
      is_seen[t] = true;
      std::vector<TriangleId>& triangles = found.emplace_back();
      for (std::size_t k = 0; k < group.size(); ++k) {
        const auto& unit = units_.triangles(group[k]);
        triangles.insert(triangles.end(), unit.begin(), unit.end());
        for (const std::uint32_t other : units_.beside(group[k])) {
          if (!is_seen[other]) group.push_back(other);
          is_seen[other] = true;
        }
      }
      std::sort(triangles.begin(), triangles.end());
    }
    return found;
  }

  void add_node(std::span<const TriangleId> triangles, std::optional<std::uint32_t> parent) {
    const auto n = static_cast<std::uint32_t>(made_.nodes.size());
    Evaluated part = measure_(triangles);
    SplitNode& node = made_.nodes.emplace_back();
    node.parent = parent;
    node.lowest = triangles.front();
    node.triangle_count = triangles.size();
    node.concavity = measure_.concavity(part);
    if (part.notch) node.notch = part.notch->point;
    if (options_.associations) node.association = std::move(part.association);
    part.association = {};
    parts_.push_back(std::make_unique<Evaluated>(std::move(part)));
    ++leaf_count_;
    const bool is_too_concave = node.concavity.squared > made_.squared_limit;
    const bool is_refused = !is_too_concave && options_.guard && !options_.guard(triangles);
    made_.refused += is_refused ? 1 : 0;
    if (is_too_concave || is_refused) {
      waiting_.insert(n);
    } else {
      settled_ += node.triangle_count;
    }
  }

  void split(std::uint32_t n) {
    waiting_.erase(n);
    const Evaluated& part = *parts_[n];
    std::size_t refused = 0;
    if (part.notch) {
      const PointId notch = made_.nodes[n].notch;
      for (const SplitPlane& plane : split_planes(surface_, part.patch, notch)) {
        if (split_at(n, notch, plane, refused)) return;
        ++refused;
      }
    }
    if (split_anywhere(n, refused)) return;
    unsplittable_.insert(n);
    settled_ += made_.nodes[n].triangle_count;
  }

  bool split_at(std::uint32_t n, PointId notch, const SplitPlane& plane, std::size_t refused) {
    auto division = divide(surface_, units_, parts_[n]->patch, notch, plane, measure_.near());
    if (!division) return false;
    std::vector<TriangleId> gone;
    std::merge(division->moved.begin(), division->moved.end(), division->islands.begin(),
               division->islands.end(), std::back_inserter(gone));
    made_.splits.push_back({.node = n,
                            .edge = {notch, plane.to},
                            .plane = plane.plane,
                            .refused = refused,
                            .moved = std::move(division->moved),
                            .islands = std::move(division->islands)});
    SplitNode& node = made_.nodes[n];
    node.is_split = true;
    const auto first = static_cast<std::uint32_t>(made_.nodes.size());
    node.children = {first, first + 1};
    parts_[n].reset();
    --leaf_count_;
    add_node(division->kept, n);
    add_node(gone, n);
    return true;
  }

  // What the guard refuses is split at the edge where it is most concave, or least convex, if its
  // notch does not divide it, or it has none: at the edge of two triangles some plane always does.
  bool split_anywhere(std::uint32_t n, std::size_t refused) {
    const Patch& patch = parts_[n]->patch;
    if (!options_.guard || options_.guard(patch.triangles())) return false;
    std::vector<std::pair<PointId, SplitPlane>> planes;
    for (const PointId p : patch.points()) {
      options_.watch.ask();
      for (SplitPlane& plane : split_planes(surface_, patch, p)) {
        planes.emplace_back(p, std::move(plane));
      }
    }
    std::stable_sort(planes.begin(), planes.end(), [](const auto& a, const auto& b) {
      return std::tie(a.second.is_convex, a.second.cosine) <
             std::tie(b.second.is_convex, b.second.cosine);
    });
    return std::any_of(planes.begin(), planes.end(), [&](const auto& plane) {
      return split_at(n, plane.first, plane.second, refused);
    });
  }

  void add_leaf(std::uint32_t n) {
    const Evaluated& part = *parts_[n];
    const auto triangles = part.patch.triangles();
    made_.leaves.push_back(
        {n,
         status_of(n),
         {triangles.begin(), triangles.end()},
         least_concavity(surface_, part.patch, part.hull, measure_.near(), options_.watch)});
  }

  LeafStatus status_of(std::uint32_t n) const {
    if (unsplittable_.count(n) > 0) return LeafStatus::Unsplittable;
    return waiting_.count(n) > 0 ? LeafStatus::MaxParts : LeafStatus::WithinLimit;
  }

  const Surface& surface_;
  const SplitOptions& options_;
  const Units units_;
  const PartMeasure measure_;
  SplitTree made_;
  std::vector<std::unique_ptr<Evaluated>> parts_;  // by node; of leaves
  std::set<std::uint32_t, DeeperFirst> waiting_{DeeperFirst{&made_.nodes}};
  std::set<std::uint32_t> unsplittable_;
  std::size_t leaf_count_ = 0;
  std::size_t settled_ = 0;  // triangles of leaves that are not waiting
};

}  // namespace

SplitTree split(const Surface& surface, const SplitOptions& options) {
  require_sensible(surface, options);
  ClusterStart start = start_clusters(surface, {.limit = options.limit,
                                                .max_parts = options.max_parts,
                                                .connect = options.connect,
                                                .watch = options.watch});
  return Splitter(surface, options, std::move(start)).run();
}

BridgeMeasure measure_by_bridges(const Surface& surface, std::span<const TriangleId> triangles,
                                 const SplitOptions& options) {
  require_sensible(surface, options);
  const PartMeasure measure(surface, options);
  Evaluated part = measure(triangles);
  Concavity concavity = measure.concavity(part);
  Rational least = least_concavity(surface, part.patch, part.hull, measure.near(), options.watch);
  return {std::move(concavity), part.notch ? part.notch->point : PointId(0), std::move(least),
          std::move(part.association)};
}

}  // namespace convexact
