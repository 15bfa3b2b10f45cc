// SPDX-License-Identifier: MIT
// decompose(): the stages from a mesh to its parts, and the proof that they hold it.
#include "convexact/decompose.hpp"

#include <algorithm>
#include <set>

#include "convexact/error.hpp"
#include "convexact/overlay.hpp"
#include "decompose/near_concavity.hpp"
#include "near/frame.hpp"
#include "number/arithmetic.hpp"
#include "number/text.hpp"
#include "parts/coverage_proof.hpp"
#include "parts/cut_parts.hpp"
#include "parts/flat_part.hpp"
#include "parts/inner_parts.hpp"
#include "parts/merge_by_reach.hpp"
#include "parts/part_reach.hpp"
#include "parts/part_volumes.hpp"
#include "parts/request_rules.hpp"
#include "parts/stored_part.hpp"
#include "solid/stage_log.hpp"
#include "task/parallel.hpp"

namespace convexact {
namespace {

// The proof that all points of faces lie in one plane, if they do, in terms of the mesh's points.
std::optional<FlatInput> find_flat(const Mesh& mesh, const Watch& watch) {
  std::vector<PointId> used;
  for (const auto& polygon : mesh.polygons) {
    for (const std::uint32_t corner : polygon) used.emplace_back(corner);
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  watch.ask();
  const PointSet points = subset(mesh.points, used);
  HullOutcome outcome = convex_hull(points);
  auto* flat = std::get_if<FlatInput>(&outcome);
  if (flat == nullptr) return {};
  if (!check_flat(*flat, points)) {
    throw Error(ErrorCode::Internal, "the certificate fails: every point lies on these planes");
  }
  for (PointId& id : flat->basis) id = used[id.index()];
  return std::move(*flat);
}

class Decomposer {
 public:
  Decomposer(const DecomposeRequest& request, StageLog& log) : request_(request), log_(log) {}

  Decomposition run(ClosedSurface closed) {
    made_.surface = std::move(closed.surface);
    made_.caps = closed.caps;
    made_.squared_largest_cap = std::move(closed.squared_largest);
    start_reach();
    if (cuts(request_)) {
      cut_solid();
    } else {
      log_.run("clusters", [&] { find_clusters(); });
      hull_clusters();
      concavity_.emplace(made_.surface, request_.measure);
      merge_flat_clusters();
      const std::vector<Concavity> concavities = measure_concavities();
      choose_parts(concavities);
    }
    take_in_loose_points();
    drop_inner_hulls();
    if (!cuts(request_)) merge_near_parts();
    std::vector<ConvexPart> stored =
        store_parts(made_.parts, made_.squared_diameter(), request_, log_);
    if (cuts(request_)) tell_new_corners();
    drop_inner_as_stored(stored);
    log_.run("coverage by owners", [&] {
      const auto prove = cuts(request_) ? prove_leaves : prove_owners;
      prove(made_, jobs_of(request_), log_.watch("coverage by owners"));
    });
    decide_reach(stored);
    if (volume_limit_) {
      made_.excess = log_.run("parts' volumes", [&] {
        return volume_limit_->excess_of(stored, log_.watch("parts' volumes"));
      });
    }
    if (cuts(request_)) find_planes_between(stored);
    if (request_.measures != PartMeasures::None) {
      made_.measures = measure_volumes(made_.surface, stored,
                                       {.wanted = request_.measures,
                                        .exact = request_.exact_volumes,
                                        .hold_solid = cuts(request_),
                                        .with_solid = false,
                                        .jobs = jobs_of(request_)},
                                       log_);
    } else {
      log_.skip("union's volume", "not requested");
      log_.skip("solid's volumes", "not requested");
    }
    made_.stages = log_.stages();
    return std::move(made_);
  }

 private:
  // ---- Reach

  void start_reach() {
    if (!uses_reach(request_)) return;
    const Rational squared_diameter = bounding_box(made_.surface.points).squared_diameter();
    if (squared_diameter == 0) return;  // one point, which no part can leave
    made_.reach.emplace();
    made_.reach->squared_distance =
        request_.distance.value_or(kDefaultDistance).squared(squared_diameter);
    require_told(made_.reach->squared_distance / squared_diameter, made_.surface.is_closed);
    if (made_.surface.is_closed) winding_.emplace(made_.surface);
    if (cuts(request_)) return;  // cutting has limits of its own
    limit_.emplace(reach_limit(made_.reach->squared_distance, {}));
    // Finer than asked: what is merged in the end makes use of it.
    if (request_.merge == ReachUse::Reach) {
      half_limit_.emplace(reach_limit(made_.reach->squared_distance / 4, {}));
    }
  }

  // Loose points may lie far away from the surface, and widen parts.
  ReachLimit reach_limit(const Rational& squared, std::vector<BoundingBox> boxes) const {
    if (made_.surface.unused.size() > 0) boxes.push_back(bounding_box(made_.surface.unused));
    return ReachLimit(made_.surface, winding_ ? &*winding_ : nullptr, squared, boxes);
  }

  ClusterGuard guard(const Watch& watch) {
    if (!limit_) return {};
    return [this, watch](std::span<const TriangleId> triangles) {
      ReachLimit& guard_limit = half_limit_ ? *half_limit_ : *limit_;
      return guard_limit.allows_hull(points_of(made_.surface, triangles), watch);
    };
  }

  void merge_near_parts() {
    constexpr const char* kStage = "merge by reach";
    if (request_.merge != ReachUse::Reach || !limit_) return log_.skip(kStage, "not requested");
    log_.run(kStage, [&] {
      std::vector<std::vector<Point>> pieces;
      for (const Part& part : made_.parts) {
        std::vector<Point>& points = pieces.emplace_back();
        for (const RationalPoint& v : part.hull.vertices) points.push_back(limit_->frame()(v));
      }
      const ReachMergeOptions options{.seed = request_.seed, .jobs = jobs_of(request_)};
      const Watch watch = log_.watch(kStage);
      const ReachMerged merged = merge_by_reach(pieces, *limit_, options, watch);
      join_parts(merged.parts, watch);
    });
    if (made_.reach->merged > 0) drop_inner_hulls();
  }

  // Each part of several takes the place of the lowest of them.
  void join_parts(const std::vector<std::vector<std::uint32_t>>& groups, const Watch& watch) {
    const auto take = [](auto& to, const auto& from) {
      to.insert(to.end(), from.begin(), from.end());
      std::sort(to.begin(), to.end());
    };
    std::vector<Part> joined;
    std::vector<std::size_t> place(made_.parts.size());
    for (const auto& group : groups) {
      std::vector<RationalPoint> points;
      for (const std::uint32_t k : group) {
        place[k] = joined.size();
        const auto& vertices = made_.parts[k].hull.vertices;
        points.insert(points.end(), vertices.begin(), vertices.end());
      }
      Part& kept = joined.emplace_back(std::move(made_.parts[group.front()]));
      if (group.size() == 1) continue;
      kept.hull = convex_part(PointSet(std::move(points)), watch);
      for (const std::uint32_t k : std::span(group).subspan(1)) {
        const Part& gone = made_.parts[k];
        take(kept.owns, gone.owns);
        take(kept.leaves, gone.leaves);
        take(kept.loose, gone.loose);
        take(kept.merged, gone.merged);
        if (!gone.cluster.empty()) take(kept.merged, std::vector{gone.cluster.front()});
        kept.is_widened = kept.is_widened || gone.is_widened;
      }
    }
    for (InnerCluster& inner : made_.inner) inner.part = place[inner.part];
    made_.reach->merged = made_.parts.size() - joined.size();
    made_.parts = std::move(joined);
  }

  // Of the parts as stored: those that are farther, or may be.
  void decide_reach(const std::vector<ConvexPart>& stored) {
    constexpr const char* kStage = "reach";
    if (!made_.reach) return log_.skip(kStage, "not requested");
    log_.run(kStage, [&] {
      const Watch watch = log_.watch(kStage);
      std::vector<BoundingBox> boxes;
      for (const ConvexPart& part : stored) boxes.push_back(part.box);
      const bool are_hulls = std::all_of(made_.parts.begin(), made_.parts.end(), [](const Part& p) {
        return (p.form == PartForm::Hull || p.form == PartForm::Flat) && p.loose.empty();
      });
      const std::size_t cells = limit_ ? limit_->cells() : 0;
      if (!limit_ || !are_hulls) limit_.emplace(reach_limit(made_.reach->squared_distance, boxes));
      made_.reach->farther = farther_parts(made_, stored, *limit_, jobs_of(request_),
                                           StageWatch{.stop = request_.watch.stop}, watch);
      made_.reach->cells = std::max({made_.reach->cells, cells, limit_->cells()});
      if (const auto* clustering = std::get_if<Clustering>(&made_.origin)) {
        made_.reach->refused = clustering->refused;
      } else if (const auto* tree = std::get_if<SplitTree>(&made_.origin)) {
        made_.reach->refused = tree->refused;
      } else {
        made_.limit_holds = made_.reach->farther.empty();
      }
    });
  }

  void find_planes_between(const std::vector<ConvexPart>& stored) {
    constexpr const char* kStage = "planes between parts";
    if (!request_.disjoint) return log_.skip(kStage, "not requested");
    log_.run(kStage, [&] {
      // About what the merging lets pass. It is only where the search for a plane may end.
      const Rational enough = scale_by_power_of_two(made_.squared_diameter(), -80);
      const Watch watch = log_.watch(kStage);
      DecompositionApart& apart = made_.apart.emplace();
      for (std::size_t k = 0; k < stored.size(); ++k) {
        watch.at(k, stored.size());
        for (std::size_t j = k + 1; j < stored.size(); ++j) {
          PlaneBetween plane = plane_between(stored[k], stored[j], enough, watch);
          apart.squared_push = std::max(apart.squared_push, plane.squared);
          apart.planes.push_back({k, j, std::move(plane)});
        }
      }
    });
  }

  // ---- Leaves

  void cut_solid() {
    if (!made_.reach) throw Error(ErrorCode::NoInterior, "all points are the same one");
    limit_volume();
    CutParts made = cut_into_parts(made_.surface, winding_ ? &*winding_ : nullptr,
                                   made_.reach->squared_distance,
                                   volume_limit_ ? &*volume_limit_ : nullptr, request_, log_);
    made_.origin = std::move(made.partition);
    made_.parts = std::move(made.parts);
    made_.reach->merged = made.merged;
    made_.reach->cells = made.cells;
  }

  void limit_volume() {
    constexpr const char* kStage = "solid's volume";
    if (!request_.max_excess) return;
    if (!made_.surface.is_closed) {
      throw Error(ErrorCode::InvalidArgument,
                  "an open surface bounds no solid whose volume parts could exceed: close it, or "
                  "leave the excess out");
    }
    log_.run(kStage, [&] {
      volume_limit_.emplace(made_.surface, *request_.max_excess, log_.watch(kStage),
                            jobs_of(request_));
    });
  }

  // Corners that are none of the input's points or of the leaves were rounded as they were stored.
  void tell_new_corners() {
    std::set<std::array<double, 3>> given;
    for (const Point& x : made_.surface.points.doubles()) given.insert({x[0], x[1], x[2]});
    for (const PartitionLeaf& leaf : std::get<Partition>(made_.origin).leaves) {
      for (std::size_t k = 0; k < leaf.corners.size(); ++k) {
        const Point& x = leaf.corners.doubles()[k];
        if (leaf.corners.is_binary() || to_rational(x) == leaf.corners[PointId(k)]) {
          given.insert({x[0], x[1], x[2]});
        }
      }
    }
    for (Part& part : made_.parts) {
      const auto corners = part.mesh.points.doubles();
      const bool is_given = std::all_of(corners.begin(), corners.end(), [&](const Point& x) {
        return given.contains({x[0], x[1], x[2]});
      });
      if (part.form == PartForm::Hull && !is_given) part.form = PartForm::Rounded;
    }
  }

  // ---- Clusters

  void find_clusters() {
    const Watch watch = log_.watch("clusters");
    if (request_.method == DecomposeMethod::Hacd) {
      made_.origin = cluster(made_.surface, {.limit = request_.limit,
                                             .guard = guard(watch),
                                             .max_parts = request_.max_parts,
                                             .measure = request_.measure,
                                             .connect = request_.connect,
                                             .engine = request_.engine,
                                             .every_merge = request_.every_merge,
                                             .costs = request_.for_trace,
                                             .further = request_.for_tree,
                                             .watch = watch});
    } else {
      SplitOptions options = split_options(watch);
      options.guard = guard(watch);
      made_.origin = split(made_.surface, options);
    }
  }

  SplitOptions split_options(const Watch& watch) const {
    return {.limit = request_.limit,
            .guard = {},
            .max_parts = request_.max_parts,
            .bridge = request_.bridge,
            .coplanar = request_.coplanar,
            .connect = request_.connect,
            .associations = request_.for_trace,
            .watch = watch};
  }

  void hull_clusters() {
    log_.run("hulls", [&] {
      const Watch watch = log_.watch("hulls");
      const auto clusters = made_.clusters();
      for (const auto triangles : clusters) {
        watch.at(clusters_.size(), clusters.size());
        const PointSet points = subset(made_.surface.points, points_of(made_.surface, triangles));
        clusters_.push_back({{triangles.begin(), triangles.end()}, convex_part(points, watch)});
      }
    });
  }

  void merge_flat_clusters() {
    constexpr const char* kStage = "flat clusters";
    if (request_.flat != FlatParts::Merge) {
      return log_.skip(kStage, "they need not join their neighbours");
    }
    log_.run(kStage, [&] {
      made_.flat_merged = merge_flat(made_.surface, request_.connect, *concavity_,
                                     !request_.keep_inner, clusters_, log_.watch(kStage));
    });
  }

  // By the definition, for every engine: the other ways only leave out triangles with shorter rays.
  std::vector<Concavity> measure_concavities() {
    return log_.run("concavities", [&] {
      const Watch watch = log_.watch("concavities");
      const NearConcavity near(made_.surface, request_.measure, false);
      std::vector<Concavity> concavities;
      for (const HulledCluster& cluster : clusters_) {
        watch.at(concavities.size(), clusters_.size());
        concavities.push_back(request_.method == DecomposeMethod::Acd
                                  ? by_bridges(cluster.triangles, watch)
                              : request_.engine == Engine::Exact
                                  ? (*concavity_)(cluster.triangles, cluster.hull, watch)
                                  : near.exact(cluster.triangles, watch));
        made_.limit_holds = made_.limit_holds && is_within_limit(concavities.back());
      }
      return concavities;
    });
  }

  bool is_within_limit(const Concavity& concavity) const {
    return concavity.squared <= made_.squared_limit();
  }

  // The leaf of a tree with these triangles, unless others joined them.
  const SplitLeaf* leaf_of(const std::vector<TriangleId>& triangles) const {
    const auto* tree = std::get_if<SplitTree>(&made_.origin);
    if (tree == nullptr) return nullptr;
    const auto leaf =
        std::lower_bound(tree->leaves.begin(), tree->leaves.end(), triangles.front(),
                         [](const SplitLeaf& x, TriangleId t) { return x.triangles.front() < t; });
    return leaf != tree->leaves.end() && leaf->triangles == triangles ? &*leaf : nullptr;
  }

  Concavity by_bridges(const std::vector<TriangleId>& triangles, const Watch& watch) const {
    if (const SplitLeaf* leaf = leaf_of(triangles)) {
      return std::get<SplitTree>(made_.origin).nodes[leaf->node].concavity;
    }
    return measure_by_bridges(made_.surface, triangles, split_options(watch)).concavity;
  }

  // Every cluster becomes a part, at first.
  void choose_parts(const std::vector<Concavity>& concavities) {
    for (std::size_t k = 0; k < clusters_.size(); ++k) {
      Part& part = made_.parts.emplace_back();
      part.owns = part.cluster = std::move(clusters_[k].triangles);
      part.hull = std::move(clusters_[k].hull);
      part.concavity = concavities[k];
      part.is_within_limit = is_within_limit(part.concavity);
      if (const SplitLeaf* leaf = leaf_of(part.cluster)) {
        part.least_squared_concavity = leaf->least_squared_concavity;
        part.is_unsplittable = leaf->status == LeafStatus::Unsplittable;
      }
    }
  }

  void take_in_loose_points() {
    constexpr const char* kStage = "loose points";
    const PointSet& points = made_.surface.unused;
    if (points.size() == 0) return log_.skip(kStage, "a face uses each point");
    log_.run(kStage, [&] {
      const Watch watch = log_.watch(kStage);
      const std::vector<PointId> outside = assign_points_inside(points, watch);
      std::vector<ConvexPart> hulls;
      for (const Part& part : made_.parts) hulls.push_back(part.hull);
      const UnionDistance distance(hulls);
      for (const PointId p : outside) {
        watch.ask();
        Part& part = made_.parts[distance(points[p]).part];
        part.loose.push_back(p);
        part.is_widened = true;
      }
      for (Part& part : made_.parts) {
        if (!part.is_widened) continue;
        const PointSet own(part.hull.vertices);
        part.hull = convex_part(concatenated(own, subset(points, part.loose)), watch);
      }
    });
  }

  // To the first part that holds them. Returns the others.
  std::vector<PointId> assign_points_inside(const PointSet& points, const Watch& watch) {
    std::vector<PointId> left;
    for (std::size_t p = 0; p < points.size(); ++p) left.emplace_back(p);
    for (Part& part : made_.parts) {
      watch.ask();
      std::vector<PointId> outside;
      for (const PointId p : find_outside(part.hull.halfspaces, subset(points, left))) {
        outside.push_back(left[p.index()]);
      }
      std::set_difference(left.begin(), left.end(), outside.begin(), outside.end(),
                          std::back_inserter(part.loose));
      left = std::move(outside);
    }
    return left;
  }

  void drop_inner_hulls() {
    std::vector<const ConvexPart*> hulls;
    for (const Part& part : made_.parts) hulls.push_back(&part.hull);
    drop_inner(hulls);
  }

  // The stored parts may be larger than the hulls, and may then hold other parts.
  void drop_inner_as_stored(std::vector<ConvexPart>& stored) {
    const bool is_larger = std::any_of(made_.parts.begin(), made_.parts.end(), [](const Part& p) {
      return p.form != PartForm::Hull && p.form != PartForm::Flat;
    });
    if (!is_larger || request_.keep_inner) return;
    std::vector<const ConvexPart*> solids;
    for (const ConvexPart& solid : stored) solids.push_back(&solid);
    keep_those(drop_inner(solids), stored);
  }

  // Returns which parts stay.
  std::vector<bool> drop_inner(const std::vector<const ConvexPart*>& solids) {
    constexpr const char* kStage = "inner parts";
    if (request_.keep_inner) {
      log_.skip(kStage, "they are kept");
      return std::vector<bool>(solids.size(), true);
    }
    return log_.run(kStage, [&] { return give_up_inner_parts(made_, solids, log_.watch(kStage)); });
  }

  const DecomposeRequest& request_;
  StageLog& log_;
  Decomposition made_;
  std::optional<Winding> winding_;                // of a closed surface, for the reach
  std::optional<ReachLimit> limit_, half_limit_;  // by the distance, and by half of it
  std::optional<VolumeLimit> volume_limit_;
  std::optional<ExactConcavity> concavity_;
  std::vector<HulledCluster> clusters_;
};

}  // namespace

std::vector<std::span<const TriangleId>> Decomposition::clusters() const {
  std::vector<std::span<const TriangleId>> list;
  if (const auto* clustering = std::get_if<Clustering>(&origin)) {
    for (const auto& triangles : clustering->clusters) list.emplace_back(triangles);
  } else if (const auto* tree = std::get_if<SplitTree>(&origin)) {
    for (const SplitLeaf& leaf : tree->leaves) list.emplace_back(leaf.triangles);
  }
  return list;
}

DecomposeRequest with_method(const Mesh& mesh, DecomposeRequest request) {
  if (request.method != DecomposeMethod::Auto) return request;
  request.method = DecomposeMethod::Hacd;
  if (has_clusters(request) || request.engine == Engine::Float || mesh.polygons.empty()) {
    return request;
  }
  const SurfaceOptions options{.orient = request.orient};
  const Watch watch(request.watch.stop);
  const bool is_closed = request.close == Close::Auto
                             ? make_closed_surface(mesh, options, watch).surface.is_closed
                             : make_surface(mesh, options, watch).is_closed;
  if (is_closed) {
    request.method = DecomposeMethod::Cut;
  } else {
    request.guard = request.merge = ReachUse::Reach;
  }
  return request;
}

DecomposeOutcome decompose(const Mesh& mesh, const DecomposeRequest& request) {
  if (request.method == DecomposeMethod::Auto) return decompose(mesh, with_method(mesh, request));
  require_sensible(request);
  if (mesh.polygons.empty()) {
    throw Error(ErrorCode::NoInterior, "the input has no faces, so there is no surface");
  }
  StageLog log(request.watch);
  const bool closes = request.close == Close::Auto && uses_reach(request);
  ClosedSurface closed = log.run("surface", [&]() -> ClosedSurface {
    const SurfaceOptions options{.orient = request.orient};
    if (closes) return make_closed_surface(mesh, options, log.watch("surface"));
    return {make_surface(mesh, options, log.watch("surface")), 0, 0};
  });
  const Surface& surface = closed.surface;
  if (request.loose == LoosePoints::Refuse && surface.unused.size() > 0) {
    throw Error(ErrorCode::InvalidArgument,
                counted(surface.unused.size(), "point is", "points are") +
                    " used by no face: let each go to the nearest part, or leave them out");
  }
  if (request.flat == FlatParts::Thicken || request.flat == FlatParts::Keep) {
    log.skip("flat input", "flat parts are thickened or kept");
  } else {
    auto flat = log.run("flat input", [&] { return find_flat(mesh, log.watch("flat input")); });
    if (flat) return NotSolid(std::move(*flat));
  }
  return Decomposer(request, log).run(std::move(closed));
}

}  // namespace convexact
