// SPDX-License-Identifier: MIT
#include "parts/stored_part.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "convexact/error.hpp"
#include "convexact/measure.hpp"
#include "convexact/simplify.hpp"
#include "parts/flat_part.hpp"
#include "parts/request_rules.hpp"
#include "task/parallel.hpp"

namespace convexact {
namespace {

constexpr const char* kStore = "store parts";

// Whether every coordinate is a number of the format.
bool is_representable(const PointSet& points, Precision precision) {
  if (!points.is_binary()) return false;
  if (precision == Precision::Binary64) return true;
  return std::all_of(points.doubles().begin(), points.doubles().end(), [](const Point& p) {
    return std::all_of(p.begin(), p.end(), [](double x) {
      return std::abs(x) <= std::numeric_limits<float>::max() && double(float(x)) == x;
    });
  });
}

std::vector<PointId> all_ids(const PointSet& points) {
  std::vector<PointId> ids;
  for (std::size_t i = 0; i < points.size(); ++i) ids.emplace_back(i);
  return ids;
}

// A part with a volume on its way to its stored form.
struct Making {
  Part* part = nullptr;
  PointSet corners;  // that it must hold
  Polytope solid;    // their hull, or around it
  bool is_simplified = false;
};

Making begin(Part& part, const Rational& squared_diameter, Precision precision,
             const Watch& watch) {
  Making making{&part, {}, {}, false};
  if (part.hull.solid) {
    making.corners = PointSet(part.hull.vertices);
    making.solid = *part.hull.solid;
    part.form = is_representable(making.corners, precision) ? PartForm::Hull : PartForm::Rounded;
  } else {
    making.corners = thicken(part.hull, squared_diameter, precision);
    making.solid = *convex_part(making.corners, watch).solid;
    part.form = PartForm::Thickened;
  }
  part.faces = making.solid.planes.size();
  return making;
}

bool limits_each(const DecomposeRequest& request) {
  return request.faces || request.max_vertices || request.max_facet_vertices;
}

// The faces to keep of a part: a solid of F faces has at most 2 F - 4 corners, and at most F - 1 at
// a face.
std::size_t faces_to_keep(const Polytope& solid, const DecomposeRequest& request) {
  std::size_t faces = solid.planes.size(), longest = 0;
  for (const auto& facet : solid.facets) longest = std::max(longest, facet.size());
  const auto allow = [&](std::size_t most) { faces = std::min(faces, most); };
  if (request.faces) allow(*request.faces);
  if (request.max_vertices && solid.vertices.size() > *request.max_vertices) {
    allow(*request.max_vertices / 2 + 2);
  }
  if (request.max_facet_vertices && longest > *request.max_facet_vertices) {
    allow(*request.max_facet_vertices + 1);
  }
  return faces;
}

SimplifyRequest simplify_request(const DecomposeRequest& request,
                                 std::optional<std::size_t> faces) {
  SimplifyRequest own;
  own.faces = faces;
  own.engine = request.engine;
  own.seed = request.seed;
  own.watch.stop = request.watch.stop;
  return own;
}

// The result takes the part's place, if there was anything to remove.
void take(SimplifyResult result, Making& making) {
  if (result.steps == 0) return;
  Part& part = *making.part;
  if (part.form != PartForm::Thickened) part.form = PartForm::Simplified;
  making.is_simplified = true;
  making.solid = std::move(result.solid.exact);
  part.faces = making.solid.planes.size();
}

void simplify_each(std::vector<Making>& makings, const DecomposeRequest& request, StageLog& log) {
  log.run(stage::kSimplify, [&] {
    const auto simplify_one = [&](std::size_t k, const Watch&) {
      Making& making = makings[k];
      const std::size_t faces = faces_to_keep(making.solid, request);
      if (making.solid.planes.size() <= faces) return;
      auto outcome = simplify(making.corners, simplify_request(request, faces));
      take(std::get<SimplifyResult>(std::move(outcome)), making);
    };
    for_each_in_parallel(makings.size(), jobs_of(request), log.watch(stage::kSimplify),
                         simplify_one);
  });
}

void simplify_together(std::vector<Making>& makings, const DecomposeRequest& request,
                       StageLog& log) {
  const std::size_t budget = *request.total_faces;
  if (budget / 4 < makings.size()) {
    throw Error(
        ErrorCode::InvalidArgument,
        fmt::format("{} parts need at least {} faces, 4 for each; {} are too few: allow more "
                    "faces, fewer parts, or more concavity",
                    makings.size(), 4 * makings.size(), budget));
  }
  const std::size_t faces = std::accumulate(
      makings.begin(), makings.end(), std::size_t{0},
      [](std::size_t sum, const Making& making) { return sum + making.part->faces; });
  if (faces <= budget)
    return log.skip(stage::kSimplify, "the parts have no more faces than allowed");
  log.run(stage::kSimplify, [&] {
    std::vector<Shape> shapes;
    for (const Making& making : makings) shapes.push_back(making.corners);
    SceneRequest scene{.each = simplify_request(request, {}), .total_faces = budget};
    if (request.watch.progress) scene.each.watch.progress = request.watch.progress;
    auto outcome = simplify_scene(shapes, scene);
    auto& results = std::get<SceneResult>(outcome).parts;
    for (std::size_t k = 0; k < makings.size(); ++k) take(std::move(results[k]), makings[k]);
  });
}

void simplify_parts(std::vector<Making>& makings, const DecomposeRequest& request, StageLog& log) {
  if (makings.empty()) return log.skip(stage::kSimplify, "no part has a volume");
  if (limits_each(request)) return simplify_each(makings, request, log);
  if (request.total_faces) return simplify_together(makings, request, log);
  log.skip(stage::kSimplify, "no number of faces was requested");
}

// The corners of the smallest box around points whose coordinates the format has; nothing if it
// ends before.
std::optional<PointSet> box_around(const PointSet& points, Precision precision) {
  const BoundingBox box = bounding_box(points);
  Point low, high;
  for (int k = 0; k < 3; ++k) {
    low[k] = round_to(precision, box.low[k], Rounding::Down);
    high[k] = round_to(precision, box.high[k], Rounding::Up);
  }
  if (!low.allFinite() || !high.allFinite()) return {};
  std::vector<Point> corners;
  for (int c = 0; c < 8; ++c) {
    corners.emplace_back((c & 1 ? high : low)[0], (c & 2 ? high : low)[1], (c & 4 ? high : low)[2]);
  }
  return PointSet(std::move(corners));
}

// Points of the format whose hull holds the corners. Where the part is so small that the format's
// numbers are too far apart for its shape, the points are those of a box.
PointSet stored_points(Making& making, Precision precision) {
  if (!making.is_simplified && is_representable(making.corners, precision)) return making.corners;
  try {
    return store_mesh(making.solid, making.corners, all_ids(making.corners), precision).mesh.points;
  } catch (const Error& error) {
    if (error.code() != ErrorCode::Unrepresentable) throw;
    auto box = box_around(making.corners, precision);
    if (!box) {
      // The message of the stored formats suggests exact integers, which parts do not have.
      const std::string what = error.what();
      throw Error(error.code(), what.substr(0, what.find("; exact integers")));
    }
    making.part->faces = 6;
    return std::move(*box);
  }
}

// Every stored part counts as the hull of its points.
ConvexPart finish(Making& making, Precision precision, const Watch& watch) {
  Part& part = *making.part;
  const bool is_as_it_was = part.form == PartForm::Hull;
  ConvexPart stored =
      is_as_it_was ? part.hull : convex_part(stored_points(making, precision), watch);
  part.mesh.points = PointSet(stored.vertices);
  part.mesh.polygons = stored.solid->facets;
  part.mesh.parts = {{"", 0, part.mesh.polygons.size()}};
  part.halfspaces = stored.halfspaces;
  return stored;
}

// Those of some corners that are outside of the hull of some points.
std::vector<PointId> outside_of_hull(const PointSet& corners, std::span<const PointId> asked,
                                     const std::vector<Point>& hull, const Watch& watch) {
  if (asked.empty()) return {};
  std::vector<PointId> outside =
      find_outside(convex_part(PointSet(hull), watch).halfspaces, subset(corners, asked));
  for (PointId& p : outside) p = asked[p.index()];
  return outside;
}

ConvexPart keep_flat(Part& part, Precision precision) {
  part.form = PartForm::Flat;
  part.mesh.points = PointSet(part.hull.vertices);
  if (!is_representable(part.mesh.points, precision)) {
    throw Error(ErrorCode::Unrepresentable,
                "a flat part has a corner that the format cannot hold, and cannot be rounded "
                "outward in its plane: let flat parts be thickened");
  }
  if (part.hull.dimension == 2) {
    auto& polygon = part.mesh.polygons.emplace_back(part.hull.vertices.size());
    std::iota(polygon.begin(), polygon.end(), 0u);
  }
  part.mesh.parts = {{"", 0, part.mesh.polygons.size()}};
  part.halfspaces = part.hull.halfspaces;
  return part.hull;
}

}  // namespace

// A corner that is no number of the format is rounded to nearest. Those that are outside of the
// hull then are rounded away from its middle as well; and those that still are, in all eight ways,
// which have them in their middle.
PointSet stored_corners(const PointSet& corners, bool is_flat, const Rational& squared_diameter,
                        Precision precision, const Watch& watch) {
  if (is_flat) {
    const PointSet thick = thicken(convex_part(corners, watch), squared_diameter, precision);
    return stored_corners(PointSet(convex_part(thick, watch).vertices), false, squared_diameter,
                          precision, watch);
  }
  if (is_representable(corners, precision)) return corners;
  const RationalPoint middle = bounding_box(corners).middle();
  const auto round = [&](const RationalPoint& x, const auto& rounding_of) {
    Point y;
    for (int k = 0; k < 3; ++k) y[k] = round_to(precision, x[k], rounding_of(k));
    if (!y.allFinite()) {
      throw Error(ErrorCode::Unrepresentable, "a corner of a part is beyond the format's numbers");
    }
    return y;
  };
  std::vector<Point> stored;
  std::vector<PointId> moved;
  for (const PointId p : all_ids(corners)) {
    const RationalPoint x = corners[p];
    stored.push_back(round(x, [](int) { return Rounding::Nearest; }));
    if (to_rational(stored.back()) != x) moved.push_back(p);
  }
  const std::vector<PointId> outside = outside_of_hull(corners, moved, stored, watch);
  for (const PointId p : outside) {
    const RationalPoint x = corners[p];
    stored.push_back(
        round(x, [&](int k) { return x[k] < middle[k] ? Rounding::Down : Rounding::Up; }));
  }
  for (const PointId p : outside_of_hull(corners, outside, stored, watch)) {
    for (int way = 0; way < 8; ++way) {
      stored.push_back(round(
          corners[p], [&](int k) { return (way >> k & 1) != 0 ? Rounding::Up : Rounding::Down; }));
    }
  }
  return PointSet(std::move(stored));
}

std::vector<ConvexPart> store_parts(std::vector<Part>& parts, const Rational& squared_diameter,
                                    const DecomposeRequest& request, StageLog& log) {
  const bool keeps_flat = request.flat == FlatParts::Keep;
  const std::size_t jobs = jobs_of(request);
  std::vector<std::size_t> solid, flat;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    (parts[k].hull.solid || !keeps_flat ? solid : flat).push_back(k);
  }
  std::vector<Making> makings(solid.size());
  log.run(kStore, [&] {
    for_each_in_parallel(
        solid.size(), jobs, log.watch(kStore), [&](std::size_t i, const Watch& watch) {
          makings[i] = begin(parts[solid[i]], squared_diameter, request.precision, watch);
        });
  });
  simplify_parts(makings, request, log);
  std::vector<ConvexPart> stored(parts.size());
  log.run(kStore, [&] {
    for_each_in_parallel(solid.size(), jobs, log.watch(kStore),
                         [&](std::size_t i, const Watch& watch) {
                           stored[solid[i]] = finish(makings[i], request.precision, watch);
                         });
    for (const std::size_t k : flat) stored[k] = keep_flat(parts[k], request.precision);
  });
  return stored;
}

}  // namespace convexact
