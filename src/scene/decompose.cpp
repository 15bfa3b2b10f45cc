// SPDX-License-Identifier: MIT
// decompose(): the stages from a mesh to its parts, and the proof that they hold it.
#include "convexact/decompose.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "convexact/error.hpp"
#include "decompose/near_concavity.hpp"
#include "scene/flat_part.hpp"
#include "scene/part_volumes.hpp"
#include "scene/stage_log.hpp"
#include "scene/stored_part.hpp"

namespace convexact {
namespace {

[[noreturn]] void refuse_request(const std::string& message) {
  throw Error(ErrorCode::InvalidArgument, message);
}

void require_sensible(const DecomposeRequest& request) {
  if (request.max_parts && *request.max_parts == 0) refuse_request("at least one part is needed");
  if (request.faces && request.total_faces) {
    refuse_request("give the faces of each part or the faces of all parts, not both");
  }
  if (request.faces && *request.faces < 4) {
    refuse_request("no bounded part has fewer than 4 faces: allow at least 4 for each");
  }
  if (request.total_faces && *request.total_faces < 4) {
    refuse_request("no bounded part has fewer than 4 faces: allow at least 4 in all");
  }
}

// The proof that all points of faces lie in one plane, if they do; of points of the mesh.
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

  Decomposition run(Surface surface) {
    made_.surface = std::move(surface);
    made_.clustering = log_.run("clusters", [&] { return cluster_surface(); });
    hull_clusters();
    concavity_.emplace(made_.surface, request_.measure);
    merge_flat_clusters();
    const std::vector<Concavity> concavities = measure_concavities();
    choose_parts(concavities);
    const std::vector<ConvexPart> stored =
        store_parts(made_.parts, made_.clustering.squared_diameter, request_, log_);
    log_.run("coverage by owners", [&] { prove_coverage(); });
    if (request_.measures) {
      made_.measures = measure_volumes(made_.surface, stored, request_.exact_volumes, log_);
    } else {
      log_.skip("union's volume", "not requested");
      log_.skip("solid's volumes", "not requested");
    }
    made_.stages = log_.stages();
    return std::move(made_);
  }

 private:
  Clustering cluster_surface() const {
    return cluster(made_.surface, {.limit = request_.limit,
                                   .max_parts = request_.max_parts,
                                   .measure = request_.measure,
                                   .connect = request_.connect,
                                   .engine = request_.engine,
                                   .costs = request_.costs,
                                   .watch = log_.watch("clusters")});
  }

  void hull_clusters() {
    log_.run("hulls", [&] {
      const Watch watch = log_.watch("hulls");
      const auto& clusters = made_.clustering.clusters;
      for (const auto& triangles : clusters) {
        watch.at(clusters_.size(), clusters.size());
        const PointSet points = subset(made_.surface.points, points_of(made_.surface, triangles));
        clusters_.push_back({triangles, convex_part(points, watch)});
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

  // By the definition, whatever the engine: the others only leave out triangles with shorter rays.
  std::vector<Concavity> measure_concavities() {
    return log_.run("concavities", [&] {
      const Watch watch = log_.watch("concavities");
      const NearConcavity near(made_.surface, request_.measure, false);
      std::vector<Concavity> concavities;
      for (const HulledCluster& cluster : clusters_) {
        watch.at(concavities.size(), clusters_.size());
        concavities.push_back(
            request_.engine == Engine::Exact
                ? (*concavity_)(cluster.triangles, cluster.hull, watch)
                : near.exact(near.cluster(cluster.triangles), cluster.triangles, watch));
        made_.limit_holds = made_.limit_holds && is_within_limit(concavities.back());
      }
      return concavities;
    });
  }

  bool is_within_limit(const Concavity& concavity) const {
    return concavity.squared <= made_.clustering.squared_limit;
  }

  // By cluster: the first one that makes it needless and is itself needed.
  std::vector<std::optional<std::size_t>> find_holders() {
    std::vector<std::optional<std::size_t>> holder(clusters_.size());
    if (request_.keep_inner) {
      log_.skip("inner parts", "they are kept");
      return holder;
    }
    log_.run("inner parts", [&] {
      const Watch watch = log_.watch("inner parts");
      std::vector<std::vector<std::size_t>> holders(clusters_.size());
      for (std::size_t k = 0; k < clusters_.size(); ++k) {
        watch.at(k, clusters_.size());
        for (std::size_t j = 0; j < clusters_.size(); ++j) {
          if (j != k && makes_needless(clusters_[j], clusters_[k])) holders[k].push_back(j);
        }
      }
      // To make needless is transitive and no circle: one of the holders has none of its own.
      for (std::size_t k = 0; k < clusters_.size(); ++k) {
        for (const std::size_t j : holders[k]) {
          if (!holder[k] && holders[j].empty()) holder[k] = j;
        }
      }
    });
    return holder;
  }

  void choose_parts(const std::vector<Concavity>& concavities) {
    const auto holder = find_holders();
    std::vector<std::size_t> part_of(clusters_.size());
    for (std::size_t k = 0; k < clusters_.size(); ++k) {
      if (holder[k]) continue;
      part_of[k] = made_.parts.size();
      Part& part = made_.parts.emplace_back();
      part.owns = part.cluster = clusters_[k].triangles;
      part.hull = clusters_[k].hull;
      part.concavity = concavities[k];
      part.is_within_limit = is_within_limit(part.concavity);
    }
    for (std::size_t k = 0; k < clusters_.size(); ++k) {
      if (!holder[k]) continue;
      const std::size_t part = part_of[*holder[k]];
      const auto& triangles = clusters_[k].triangles;
      made_.inner.push_back({triangles.front(), part});
      auto& owns = made_.parts[part].owns;
      owns.insert(owns.end(), triangles.begin(), triangles.end());
    }
    for (Part& part : made_.parts) std::sort(part.owns.begin(), part.owns.end());
  }

  // On the stored numbers: each corner of each triangle in all halfspaces of the triangle's owner.
  void prove_coverage() {
    constexpr std::uint32_t kNone = ~0u;
    made_.owner.assign(made_.surface.triangles.size(), kNone);
    for (std::uint32_t k = 0; k < made_.parts.size(); ++k) {
      const Part& part = made_.parts[k];
      const auto corners = points_of(made_.surface, part.owns);
      const std::size_t outside =
          find_outside(part.halfspaces, subset(made_.surface.points, corners), request_.watch.stop)
              .size();
      if (outside > 0) {
        throw Error(ErrorCode::Internal,
                    fmt::format("{} corners of triangles lie outside of their part", outside));
      }
      for (const TriangleId t : part.owns) {
        if (made_.owner[t.index()] != kNone) {
          throw Error(ErrorCode::Internal, "a triangle has two owners");
        }
        made_.owner[t.index()] = k;
        ++made_.tested_triangles;
      }
    }
    if (made_.tested_triangles != made_.surface.triangles.size()) {
      throw Error(ErrorCode::Internal, "a triangle has no owner");
    }
  }

  const DecomposeRequest& request_;
  StageLog& log_;
  Decomposition made_;
  std::optional<ExactConcavity> concavity_;
  std::vector<HulledCluster> clusters_;
};

}  // namespace

DecomposeOutcome decompose(const Mesh& mesh, const DecomposeRequest& request) {
  require_sensible(request);
  if (mesh.polygons.empty()) {
    throw Error(ErrorCode::NoInterior, "the input has no faces, so there is no surface");
  }
  StageLog log(request.watch);
  Surface surface = log.run("surface", [&] {
    return make_surface(mesh, {.orient = request.orient}, log.watch("surface"));
  });
  if (request.flat == FlatParts::Thicken || request.flat == FlatParts::Keep) {
    log.skip("flat input", "flat parts are thickened or kept");
  } else {
    auto flat = log.run("flat input", [&] { return find_flat(mesh, log.watch("flat input")); });
    if (flat) return NotSolid(std::move(*flat));
  }
  return Decomposer(request, log).run(std::move(surface));
}

}  // namespace convexact
