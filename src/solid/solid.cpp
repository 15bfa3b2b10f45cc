// SPDX-License-Identifier: MIT
#include "solid/solid.hpp"

#include "convexact/error.hpp"
#include "convexact/linear_program.hpp"
#include "convexact/scene.hpp"
#include "lp/interior_point.hpp"
#include "number/arithmetic.hpp"

namespace convexact {
namespace {

void require_proven(bool proven, const char* claim) {
  if (!proven) throw Error(ErrorCode::Internal, std::string("the certificate fails: ") + claim);
}

SolidOutcome solid_of_points(const PointSet& points, const SolidOptions& options, StageLog& log) {
  auto outcome = make_hull(points, options, log);
  if (const auto* reason = std::get_if<NotSolid>(&outcome)) return *reason;
  auto& hull = std::get<Hull>(outcome);
  Solid solid;
  if (options.wants_dual) {
    solid.dual = log.run("dual", [&] { return dual_of(hull, points); });
  } else {
    log.skip("dual", "only removals need it");
  }
  solid.polytope = log.run("polytope", [&] { return to_polytope(hull, points); });
  solid.points = points;
  solid.extreme = hull.vertices;
  solid.input_points = points.size();
  solid.certificate = std::move(hull.certificate);
  return solid;
}

// Tests for empty or flat sets first, then for unbounded ones: the second test looks at normals
// only, and says nothing about an empty set.
std::variant<RationalPoint, NotSolid> interior_of(std::span<const Halfspace> halfspaces,
                                                  const LpOptions& options) {
  const InteriorOutcome interior = find_interior(halfspaces, options);
  if (const auto* empty = std::get_if<EmptyProof>(&interior)) {
    require_proven(check(halfspaces, *empty), "the halfspaces have no common point");
    return NotSolid(*empty);
  }
  if (const auto* flat = std::get_if<FlatProof>(&interior)) {
    require_proven(check(halfspaces, *flat), "the halfspaces have no interior");
    return NotSolid(*flat);
  }
  const auto& inside = std::get<InteriorPoint>(interior);
  require_proven(check(halfspaces, inside), "the point is strictly inside");
  const BoundedOutcome bounded = find_recession(halfspaces, options);
  if (const auto* ray = std::get_if<RecessionRay>(&bounded)) {
    require_proven(check(halfspaces, *ray), "the ray stays inside");
    return NotSolid(*ray);
  }
  require_proven(check(halfspaces, std::get<BoundedProof>(bounded)), "the intersection is bounded");
  return inside.point;
}

// All but the points.
SolidOutcome bounded_solid(std::span<const Halfspace> halfspaces, std::uint64_t seed, StageLog& log,
                           HullObserver* observer = nullptr) {
  const auto interior = log.run("empty, flat, bounded",
                                [&] { return interior_of(halfspaces, LpOptions{.seed = seed}); });
  if (const auto* reason = std::get_if<NotSolid>(&interior)) return *reason;
  Solid solid;
  solid.interior = std::get<RationalPoint>(interior);
  HalfspaceDual dual = log.run(
      "hull of dual points", [&] { return dual_of(halfspaces, *solid.interior, seed, observer); });
  solid.dual = std::move(dual.dual);
  solid.redundant = std::move(dual.redundant);
  solid.hull_rows = std::move(dual.hull_rows);
  solid.polytope =
      log.run("polytope", [&] { return to_polytope(solid.dual.halfspaces, solid.dual.triangles); });
  return solid;
}

SolidOutcome solid_of_halfspaces(std::span<const Halfspace> halfspaces, std::uint64_t seed,
                                 StageLog& log, HullObserver* observer) {
  log.skip(stage::kHull, "the input is halfspaces");
  SolidOutcome outcome = bounded_solid(halfspaces, seed, log, observer);
  auto* made = std::get_if<Solid>(&outcome);
  if (made == nullptr) return outcome;
  Solid& solid = *made;
  solid.points = PointSet(solid.polytope.vertices);
  solid.extreme.reserve(solid.points.size());
  for (std::size_t i = 0; i < solid.points.size(); ++i) solid.extreme.emplace_back(i);
  return outcome;
}

}  // namespace

std::variant<Hull, NotSolid> make_hull(const PointSet& points, const SolidOptions& options,
                                       StageLog& log) {
  HullOutcome outcome = log.run(stage::kHull, [&] {
    return convex_hull(points, {.seed = options.seed,
                                .jobs = options.jobs,
                                .watch = log.watch().stop,
                                .observer = options.observer});
  });
  if (const auto* flat = std::get_if<FlatInput>(&outcome)) {
    require_proven(check_flat(*flat, points), "every point lies on these planes");
    return NotSolid(*flat);
  }
  auto& hull = std::get<Hull>(outcome);
  if (options.check) {
    log.run("hull certificate", [&] {
      require_proven(check_hull(hull, points), "the hull is convex and holds every point");
    });
  } else {
    log.skip("hull certificate", "not requested: the result itself is tested against every point");
  }
  log.skip("empty, flat, bounded", "the hull of points that span a volume is none of these");
  log.skip("hull of dual points", "the input is points: the dual is read off its hull");
  return std::move(hull);
}

std::variant<Polytope, NotSolid> make_polytope(std::span<const Halfspace> halfspaces,
                                               std::uint64_t seed, StageLog& log) {
  SolidOutcome outcome = bounded_solid(halfspaces, seed, log);
  if (const auto* reason = std::get_if<NotSolid>(&outcome)) return *reason;
  return std::get<Solid>(std::move(outcome)).polytope;
}

SolidOutcome make_solid(const Shape& shape, const SolidOptions& options, StageLog& log) {
  if (const auto* points = std::get_if<PointSet>(&shape)) {
    return solid_of_points(*points, options, log);
  }
  return solid_of_halfspaces(std::get<std::vector<Halfspace>>(shape), options.seed, log,
                             options.observer);
}

// The mean of the solid's vertices on a short grid: as deep inside as the centers that the fast
// engines choose themselves.
RationalPoint interior_point_of(const Solid& solid) {
  if (solid.interior) return *solid.interior;
  RationalPoint mean;
  for (int k = 0; k < 3; ++k) {
    std::vector<Rational> coordinates;
    for (const RationalPoint& vertex : solid.dual.vertices) coordinates.push_back(vertex[k]);
    mean[k] = balanced_sum(std::move(coordinates)) / Rational(solid.dual.vertices.size());
  }
  const auto center = short_dyadic_interior_point(solid.dual.halfspaces, mean);
  if (!center) throw Error(ErrorCode::Internal, "the mean of the vertices is not inside");
  return *center;
}

RationalPoint given_center(const RationalPoint& center, std::span<const Halfspace> halfspaces,
                           StageLog& log) {
  log.skip("Chebyshev center", "the caller gave a center");
  if (!is_strictly_inside(halfspaces, center)) {
    throw Error(ErrorCode::InvalidArgument, "the center is not strictly inside the input's hull");
  }
  return center;
}

ChebyshevCenter certified_center(std::span<const Halfspace> halfspaces, const LpOptions& options,
                                 StageLog& log) {
  return log.run("Chebyshev center", [&] {
    const auto outcome = chebyshev_center(halfspaces, options);
    const auto* center = std::get_if<ChebyshevCenter>(&outcome);
    if (center == nullptr || !check(halfspaces, *center)) {
      throw Error(ErrorCode::Internal, "the certificate fails: a largest ball in the hull");
    }
    return *center;
  });
}

std::vector<std::array<double, 4>> Stored::planes_in_doubles() const {
  if (planes && planes->precision == Precision::Binary64) return planes->planes;
  std::vector<PointId> all;
  for (std::size_t i = 0; i < points.size(); ++i) all.emplace_back(i);
  return store_planes(exact, points, all, Precision::Binary64).planes;
}

Stored store(Polytope exact, const PointSet& points, std::span<const PointId> extreme,
             const StoreRequest& request, StageLog& log) {
  Stored solid{std::move(exact), points, {}, {}};
  if (request.planes) {
    solid.planes = log.run("store planes", [&] {
      return store_planes(solid.exact, points, extreme, *request.planes);
    });
  } else {
    log.skip("store planes", "exact integers need no rounding");
  }
  if (request.mesh) {
    solid.mesh = log.run("store mesh",
                         [&] { return store_mesh(solid.exact, points, extreme, *request.mesh); });
  } else {
    log.skip("store mesh", "no mesh was requested");
  }
  return solid;
}

}  // namespace convexact
