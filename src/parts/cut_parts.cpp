// SPDX-License-Identifier: MIT
#include "parts/cut_parts.hpp"

#include <algorithm>
#include <numeric>
#include <optional>

#include "near/frame.hpp"
#include "number/arithmetic.hpp"
#include "parts/merge_by_reach.hpp"
#include "parts/request_rules.hpp"
#include "parts/stored_part.hpp"
#include "task/parallel.hpp"

namespace convexact {
namespace {

constexpr const char* kCut = "cuts";
constexpr const char* kStoreLeaves = "store leaves";
constexpr const char* kMerge = "merge by reach";

// One way to cut, of which more effort tries several.
struct Way {
  Rational fineness;  // how many times the leaves' distance goes into that of the parts
  CutPlanes planes = CutPlanes::All;
};

// Up to so many triangles a second way is tried without being asked for: it takes seconds at most,
// and of a tube, a cup or a house it makes fewer parts.
constexpr std::size_t kSmallSurface = 512;

std::vector<Way> ways(CutEffort effort, bool is_exact, std::size_t triangles) {
  const Way bisectors{2, CutPlanes::Bisectors};
  if (is_exact) return {{2, CutPlanes::Facets}};
  if (effort == CutEffort::High) return {{2}, {Rational(14, 5)}, {Rational(8, 5)}, {4}, bisectors};
  if (effort == CutEffort::Normal && triangles <= kSmallSurface) return {{2}, bisectors};
  return {{2}};
}

int rounds_of(CutEffort effort) {
  return effort == CutEffort::Low ? 1 : effort == CutEffort::Normal ? 3 : 12;
}

std::size_t exchanges_of(CutEffort effort) {
  return effort == CutEffort::Low ? 0 : effort == CutEffort::Normal ? 4 : 16;
}

class PartCutter {
 public:
  PartCutter(const Surface& surface, const Winding* winding, const Rational& squared_distance,
             const VolumeLimit* volume_limit, const DecomposeRequest& request, StageLog& log)
      : surface_(surface),
        winding_(winding),
        squared_(squared_distance),
        box_(bounding_box(surface.points)),
        squared_diameter_(box_.squared_diameter()),
        volume_limit_(volume_limit),
        request_(request),
        log_(log) {}

  CutParts run() {
    const std::vector<Way> tried = ways(request_.effort, squared_ == 0, surface_.triangles.size());
    const std::vector<Rational> coarser = shares();
    std::optional<CutParts> kept;
    Rational least_share;
    for (const Rational& share : coarser) {
      std::optional<CutParts> best;
      for (const Way& way : tried) {
        CutParts made = cut_and_merge(Rational(share * share * squared_), way);
        if (!best || made.parts.size() < best->parts.size()) best = std::move(made);
      }
      const auto [is_held, volume_share] = fit(*best);
      if (is_held) return std::move(*best);
      if (kept && volume_limit_ != nullptr && volume_share >= least_share) continue;
      kept = std::move(best);
      least_share = volume_share;
    }
    return std::move(*kept);
  }

 private:
  inline static const std::vector<Rational> kShares{1, Rational(7, 8), Rational(3, 4),
                                                    Rational(1, 2), Rational(1, 4)};

  bool is_limited() const {
    return request_.faces || request_.total_faces || request_.max_vertices ||
           request_.max_facet_vertices || volume_limit_;
  }
  std::vector<Rational> shares() const {
    return is_limited() && squared_ > 0 ? kShares : std::vector{kShares.front()};
  }

  CutParts cut_and_merge(const Rational& squared, const Way& way) {
    CutParts made;
    made.partition = log_.run(kCut, [&] {
      const Watch watch = log_.watch(kCut);
      ReachLimit fine(surface_, winding_, Rational(squared / (way.fineness * way.fineness)));
      Partition partition = cut(surface_, winding_, fine,
                                {.is_exact = request_.engine == Engine::Exact,
                                 .planes = way.planes,
                                 .jobs = jobs_of(request_),
                                 .watch = watch});
      made.cells = fine.cells();
      return partition;
    });
    const std::vector<PointSet> leaves =
        log_.run(kStoreLeaves, [&] { return stored_leaves(made.partition); });
    log_.run(kMerge, [&] { merge(squared, leaves, made); });
    return made;
  }

  std::vector<PointSet> stored_leaves(const Partition& partition) const {
    std::vector<PointSet> stored(partition.leaves.size());
    for_each_in_parallel(stored.size(), jobs_of(request_), log_.watch(kStoreLeaves),
                         [&](std::size_t k, const Watch& watch) {
                           const PartitionLeaf& leaf = partition.leaves[k];
                           stored[k] = stored_corners(leaf.corners, leaf.is_flat, squared_diameter_,
                                                      request_.precision, watch);
                         });
    return stored;
  }

  // On stored numbers, so that nothing grows later.
  void merge(const Rational& squared, const std::vector<PointSet>& leaves, CutParts& made) const {
    const Watch watch = log_.watch(kMerge);
    std::vector<BoundingBox> boxes;
    for (const PointSet& leaf : leaves) {
      BoundingBox box = bounding_box(leaf);
      if (is_far_out(box)) boxes.push_back(std::move(box));
    }
    ReachLimit limit(surface_, winding_, squared, boxes);
    std::vector<std::vector<Point>> pieces;
    for (const PointSet& leaf : leaves) pieces.push_back(limit.frame()(leaf));
    ReachMergeOptions options{.rounds = rounds_of(request_.effort),
                              .seed = request_.seed,
                              .exchanges = exchanges_of(request_.effort),
                              .keeps_apart = request_.disjoint,
                              .jobs = jobs_of(request_)};
    if (request_.max_parts) options.most_parts = *request_.max_parts;
    if (volume_limit_ != nullptr) {
      options.most_volume =
          to_double(scale_by_power_of_two(volume_limit_->least(), -3 * limit.frame().exponent),
                    Rounding::Down);
    }
    const auto groups = merge_by_reach(pieces, limit, options, watch).parts;
    made.parts.resize(groups.size());
    for_each_in_parallel(groups.size(), jobs_of(request_), [&](std::size_t p) {
      std::vector<Point> points;
      for (const std::uint32_t k : groups[p]) {
        points.insert(points.end(), leaves[k].doubles().begin(), leaves[k].doubles().end());
      }
      made.parts[p].leaves = groups[p];
      made.parts[p].hull = convex_part(PointSet(std::move(points)), watch.without_reports());
    });
    made.cells = std::max(made.cells, limit.cells());
    made.merged = leaves.size() - made.parts.size();
  }

  // Whether binary32 made a leaf larger than the frame of the surface alone, which has room for
  // half of the surface's size on each side.
  bool is_far_out(const BoundingBox& leaf) const {
    const Rational room = box_.size().maxCoeff() / 4;
    return (box_.low - leaf.low).maxCoeff() > room || (leaf.high - box_.high).maxCoeff() > room;
  }

  // Whether the parts are still within the distance when they are stored as the request wants them,
  // and their volume within what is allowed; and what share of the solid's it exceeds that by.
  std::pair<bool, Rational> fit(const CutParts& made) {
    if (!is_limited()) return {true, 0};
    std::vector<Part> parts = made.parts;
    const std::vector<ConvexPart> stored = store_parts(parts, squared_diameter_, request_, log_);
    std::vector<BoundingBox> boxes;
    for (const ConvexPart& part : stored) boxes.push_back(part.box);
    Rational volume_share = 0;
    if (volume_limit_ != nullptr) {
      const DecompositionExcess excess = volume_limit_->excess_of(stored, log_.watch(kMerge));
      volume_share = excess.share.high();
      if (!excess.holds) return {false, volume_share};
    }
    ReachLimit limit(surface_, winding_, squared_, boxes);
    return {limit.allows_all(stored, jobs_of(request_), log_.watch(kMerge)), volume_share};
  }

  const Surface& surface_;
  const Winding* winding_;
  const Rational& squared_;
  const BoundingBox box_;
  const Rational squared_diameter_;
  const VolumeLimit* volume_limit_;
  const DecomposeRequest& request_;
  StageLog& log_;
};

}  // namespace

CutParts cut_into_parts(const Surface& surface, const Winding* winding,
                        const Rational& squared_distance, const VolumeLimit* volume_limit,
                        const DecomposeRequest& request, StageLog& log) {
  return PartCutter(surface, winding, squared_distance, volume_limit, request, log).run();
}

}  // namespace convexact
