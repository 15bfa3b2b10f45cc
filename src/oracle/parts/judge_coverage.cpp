// SPDX-License-Identifier: MIT
// Whether the union of some parts covers the points, the surface and the solid of an input, and the
// measures reported with these claims.
#include <fmt/format.h>

#include "convexact/error.hpp"
#include "convexact/measure.hpp"
#include "convexact/overlay.hpp"
#include "convexact/stored.hpp"
#include "number/precision.hpp"
#include "number/text.hpp"
#include "oracle/parts/judge.hpp"
#include "parts/part_volumes.hpp"
#include "surface/box_tree.hpp"
#include "task/parallel.hpp"

namespace convexact::oracle {
namespace {

using enum ClaimCode;

// Doubles around the box of a part.
NearBox box_around(const BoundingBox& box) {
  NearBox near;
  for (int k = 0; k < 3; ++k) {
    near.low[k] = to_double(box.low[k], Rounding::Down);
    near.high[k] = to_double(box.high[k], Rounding::Up);
  }
  return near;
}

// The points that no part holds, by the definition: every point in the box of a part against every
// plane of it.
std::vector<PointId> points_outside(const PartsTrial& trial, const Watch& watch) {
  std::vector<NearBox> boxes;
  for (std::uint32_t p = 0; p < trial.points.size(); ++p) {
    const PointId id(p);
    boxes.push_back(box_of(trial.points, {id, id, id}));
  }
  const BoxTree tree(std::move(boxes));
  std::vector<bool> is_held(trial.points.size(), false);
  std::vector<std::uint32_t> near;
  const std::vector<ConvexPart>& parts = trial.verdict.hulls;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    watch.at(k, parts.size());
    tree.find(box_around(parts[k].box), near);
    std::vector<PointId> asked;
    for (const std::uint32_t p : near) {
      if (!is_held[p]) asked.emplace_back(p);
    }
    for (const PointId p : asked) is_held[p.index()] = true;
    for (const PointId p :
         find_outside(parts[k].halfspaces, subset(trial.points, asked), trial.log.watch().stop)) {
      is_held[asked[p.index()].index()] = false;
    }
  }
  std::vector<PointId> left;
  for (std::size_t p = 0; p < is_held.size(); ++p) {
    if (!is_held[p]) left.emplace_back(p);
  }
  return left;
}

Witness witness_of(const RationalPoint& point, const NearestPart& nearest) {
  Witness witness;
  witness.point = point;
  witness.nearest = nearest.nearest;
  witness.squared_distance = nearest.squared;
  witness.parts = {nearest.part};
  return witness;
}

// A point of the input's file at the place of a point that is to be covered; none for the middle of
// a cap.
std::optional<std::size_t> input_point(const PartsTrial& trial, const RationalPoint& point) {
  const PointSet& points = trial.input.points;
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (points[PointId(p)] == point) return p;
  }
  return std::nullopt;
}

// The points that no face uses follow those of the surface.
void note_unused(std::span<const PointId> outside, PartsTrial& trial) {
  if (trial.input.polygons.empty()) return;
  PartsVerdict& verdict = trial.verdict;
  const PointId first_unused(verdict.surface.points.size());
  verdict.unused_outside = static_cast<std::size_t>(
      std::count_if(outside.begin(), outside.end(), [&](PointId p) { return p >= first_unused; }));
  if (verdict.unused_outside == 0) return;
  verdict.notes.push_back(unused_outside_text(verdict.unused_outside, outside.size()));
}

void judge_points(PartsTrial& trial) {
  PartsVerdict& verdict = trial.verdict;
  const Watch watch = trial.watch("covered points");
  const std::vector<PointId> outside = points_outside(trial, watch);
  verdict.points = trial.points.size();
  verdict.points_outside = outside.size();
  note_unused(outside, trial);
  if (outside.empty()) {
    return trial.holds(CoversPoints,
                       "each of " + counted(verdict.points, "point", "points") + " lies in a part");
  }
  const std::string count = fmt::format("{} of {} in no part", with_separators(outside.size()),
                                        counted(verdict.points, "point", "points"));
  if (verdict.hulls.empty()) return trial.violated(CoversPoints, count);
  const UnionDistance distance(verdict.hulls);
  PointId farthest = outside.front();
  NearestPart worst = distance(trial.points[farthest]);
  for (const PointId p : std::span(outside).subspan(1)) {
    watch.ask();
    NearestPart nearest = distance(trial.points[p]);
    if (nearest.squared <= worst.squared) continue;
    farthest = p;
    worst = std::move(nearest);
  }
  const RationalPoint point = trial.points[farthest];
  Witness witness = witness_of(point, worst);
  witness.input_point = input_point(trial, point);
  verdict.worst_part = worst.part;
  const std::string which = witness.input_point ? fmt::format("point {}", *witness.input_point)
                                                : std::string("the middle of a cap");
  const std::string sentence =
      fmt::format("{}; {} is {} away from {}", count, which, trial.distance_text(worst.squared),
                  trial.part_text(worst.part));
  trial.violated_by(worst.squared, CoversPoints, sentence, std::move(witness));
}

// ---- The surface

Witness witness_of(const FarPoint& far, const Surface& surface) {
  Witness witness = witness_of(far.point, far.nearest);
  witness.input_face = surface.face[far.triangle.index()];
  return witness;
}

std::string far_text(const FarPoint& far, const PartsTrial& trial) {
  return fmt::format("a point of face {} is {} away from {}",
                     trial.verdict.surface.face[far.triangle.index()],
                     trial.distance_text(far.nearest.squared), trial.part_text(far.nearest.part));
}

void judge_tolerance(const std::string& count, PartsTrial& trial, const UnionDistance& distance) {
  const Watch watch = trial.watch("covered surface");
  const auto& uncovered = trial.verdict.coverage->uncovered;
  const Surface& surface = trial.verdict.surface;
  const WithinDistance within =
      is_within(uncovered, distance, trial.tolerance.squared(trial.squared_diameter), watch);
  const std::string tolerance = describe(trial.tolerance);
  switch (within.reach) {
    case Reach::Within:
      return trial.holds(CoversSurface, "within the tolerance of " + tolerance + ": " + count);
    case Reach::Beyond:
      return trial.violated(CoversSurface, count + "; " + far_text(*within.witness, trial),
                            witness_of(*within.witness, surface));
    case Reach::Undecided:
      return trial.undecided(CoversSurface,
                             count + "; whether all of it is within the tolerance of " + tolerance +
                                 " is not decided: pieces around a point of face " +
                                 std::to_string(surface.face[within.witness->triangle.index()]) +
                                 " are neither proven to be nor shown not to be",
                             witness_of(*within.witness, surface));
  }
}

void judge_surface(PartsTrial& trial) {
  PartsVerdict& verdict = trial.verdict;
  const Watch watch = trial.watch("covered surface");
  verdict.coverage = find_uncovered(verdict.surface, verdict.hulls, watch, jobs_of(trial.request));
  const auto& uncovered = verdict.coverage->uncovered;
  if (uncovered.empty()) {
    return trial.holds(CoversSurface, fmt::format("each of {} lies in the union",
                                                  counted(verdict.surface.triangles.size(),
                                                          "triangle", "triangles")));
  }
  std::size_t triangles = 0;
  for (std::size_t k = 0; k < uncovered.size(); ++k) {
    triangles += k == 0 || uncovered[k].triangle != uncovered[k - 1].triangle ? 1 : 0;
  }
  const std::string count =
      fmt::format("{} of {} not in the union", with_separators(triangles),
                  counted(verdict.surface.triangles.size(), "triangle is", "triangles are"));
  if (verdict.hulls.empty()) return trial.violated(CoversSurface, count);
  if (!trial.asks(CoversSurface)) return;
  const UnionDistance distance(verdict.hulls);
  const std::optional<FarPoint> far = farthest_found(uncovered, distance, watch);
  if (far) verdict.worst_part = far->nearest.part;
  if (trial.tolerance.value > 0) return judge_tolerance(count, trial, distance);
  trial.violated(CoversSurface, count + "; " + far_text(*far, trial),
                 witness_of(*far, verdict.surface));
}

// ---- The solid

void judge_solid(const Winding& winding, PartsTrial& trial) {
  PartsVerdict& verdict = trial.verdict;
  const auto found =
      find_uncovered_solid(verdict.surface, winding, verdict.hulls, *verdict.coverage,
                           trial.watch("covered solid"), jobs_of(trial.request));
  trial.is_solid_held = !found;
  if (!found) {
    return trial.holds(CoversSolid, "each point that the surface encloses lies in a part");
  }
  Witness witness;
  witness.point = found->point;
  witness.winding = found->winding;
  std::string sentence =
      fmt::format("a point that the surface winds about {} lies in no part",
                  found->winding == 1 ? "once" : std::to_string(found->winding) + " times");
  if (!verdict.hulls.empty()) {
    const NearestPart nearest = UnionDistance(verdict.hulls)(found->point);
    witness = witness_of(found->point, nearest);
    witness.winding = found->winding;
    sentence += fmt::format("; it is {} away from {}", trial.distance_text(nearest.squared),
                            trial.part_text(nearest.part));
  }
  trial.violated(CoversSolid, std::move(sentence), std::move(witness));
}

const char* no_solid_text(const Surface& surface) {
  return surface.triangles.empty() ? "the input has no faces"
                                   : "the faces of the input do not close: they bound no solid";
}

}  // namespace

void judge_coverage(PartsTrial& trial) {
  PartsVerdict& verdict = trial.verdict;
  const Surface& surface = verdict.surface;
  if (trial.asks(CoversPoints)) {
    trial.log.run("covered points", [&] { judge_points(trial); });
  } else {
    trial.log.skip("covered points", "not requested");
  }
  const bool has_faces = !surface.triangles.empty();
  if (!has_faces) trial.not_applicable(CoversSurface, "the input has no faces");
  if (!surface.is_closed) trial.not_applicable(CoversSolid, no_solid_text(surface));
  const bool measures = trial.request.measures != PartMeasures::None;
  const bool needs_solid = trial.asks(CoversSolid) && surface.is_closed;
  if (!has_faces || !(trial.asks(CoversSurface) || needs_solid || measures)) {
    trial.log.skip("covered surface", has_faces ? "not requested" : "the input has no faces");
    return;
  }
  trial.log.run("covered surface", [&] { judge_surface(trial); });
  if (!needs_solid) return trial.log.skip("covered solid", "not requested");
  trial.log.run("covered solid", [&] { judge_solid(Winding(surface), trial); });
}

// ---- Numbers

namespace {

// The area of all triangles, each times its share.
template <class Share>
Enclosure area(const Surface& surface, const Share& share_of) {
  Enclosure total(kMeasureBits);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const Rational share = share_of(t);
    if (share == 0) continue;
    const auto& [a, b, c] = surface.triangles[t];
    const RationalPoint corner = surface.points[a];
    const RationalVector3 cross = RationalVector3(surface.points[b] - corner)
                                      .cross(RationalVector3(surface.points[c] - corner));
    total += Enclosure(Rational(share / 2), kMeasureBits) *
             sqrt(Enclosure(Rational(cross.squaredNorm()), kMeasureBits));
  }
  return total;
}

}  // namespace

void measure_parts(PartsTrial& trial) {
  PartsVerdict& verdict = trial.verdict;
  const Surface& surface = verdict.surface;
  const PartMeasures wanted = trial.request.measures;
  if (wanted == PartMeasures::None) return trial.log.skip("measures", "not requested");
  if (verdict.hulls.empty()) return trial.log.skip("measures", "there is no part");
  if (surface.triangles.empty()) return trial.log.skip("measures", "the input has no faces");
  if (trial.squared_diameter == 0) return trial.log.skip("measures", "the input is a point");
  const std::vector<ConvexPart>& parts = verdict.hulls;
  StageLog& log = trial.log;
  std::vector<Rational> shares(surface.triangles.size(), 0);
  for (const UncoveredPiece& piece : verdict.coverage->uncovered) {
    shares[piece.triangle.index()] += piece.share;
  }
  const VolumesAsked volumes{.wanted = wanted,
                             .exact = trial.request.exact_volumes,
                             .hold_solid = trial.is_solid_held,
                             .jobs = jobs_of(trial.request)};
  PartsMeasures found{measure_volumes(surface, parts, volumes, log),
                      area(surface, [](std::size_t) { return Rational(1); }),
                      area(surface, [&](std::size_t t) { return shares[t]; }),
                      Enclosure(kMeasureBits),
                      {}};
  log.run("distances", [&] {
    const Watch watch = trial.watch("distances");
    found.surface_to_union = surface_to_union(verdict.coverage->uncovered, UnionDistance(parts),
                                              trial.squared_diameter, watch)
                                 .bounds;
    if (wanted != PartMeasures::All && !trial.asks(WithinSolid)) return;
    std::optional<Winding> winding;
    if (surface.is_closed) winding.emplace(surface);
    found.union_to_input = union_to_surface(parts, surface, winding ? &*winding : nullptr,
                                            trial.squared_diameter, watch, volumes.jobs)
                               .bounds;
  });
  verdict.measures = std::move(found);
}

}  // namespace convexact::oracle
