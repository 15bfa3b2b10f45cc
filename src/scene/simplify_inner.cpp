// SPDX-License-Identifier: MIT
#include <algorithm>

#include "convexact/error.hpp"
#include "convexact/simplify.hpp"
#include "convexact/stored.hpp"
#include "fast/filtered_inner.hpp"
#include "number/arithmetic.hpp"
#include "number/precision.hpp"
#include "simplify/exact_inner.hpp"
#include "solid/solid.hpp"
#include "task/parallel.hpp"

namespace convexact {
namespace {

void require_sensible(const InnerRequest& request) {
  const auto reject = [](const char* message) { throw Error(ErrorCode::InvalidArgument, message); };
  if (!request.vertices && !request.max_loss) {
    reject("give a number of vertices, a limit of the loss, or both");
  }
  if (request.vertices && *request.vertices < 4) reject("no solid has fewer than 4 vertices");
  if (request.max_loss && *request.max_loss < 0) reject("the loss cannot be negative");
  if (request.engine == Engine::Float) {
    reject("an inner run has no float engine: filtered is as fast, and exact");
  }
}

InnerOptions options_of(const InnerRequest& request) {
  InnerOptions options;
  options.vertices = request.vertices.value_or(4);
  options.max_loss = request.max_loss;
  options.seed = request.seed;
  options.watch = request.watch.of(stage::kSimplify);
  return options;
}

Measured measured(const Rational& value) { return {Enclosure(value, kMeasureBits), value}; }

void require_inner(bool holds, const char* claim) {
  if (!holds) throw Error(ErrorCode::Internal, std::string("the inner hull fails: ") + claim);
}

// A separate hull of the points that are left, which describes the result independently of the run.
Hull hull_of_result(const PointSet& vertices, const InnerRequest& request) {
  HullOutcome outcome =
      convex_hull(vertices, HullOptions{.seed = request.seed, .watch = request.watch.stop});
  require_inner(std::holds_alternative<Hull>(outcome), "it has a volume");
  Hull& hull = std::get<Hull>(outcome);
  require_inner(hull.vertices.size() == vertices.size(), "each of its points is a vertex");
  return std::move(hull);
}

bool keeps_costs(const InnerRequest& request) {
  return request.costs || request.engine == Engine::Exact || request.verify == VerifyLevel::Full;
}

Rational lost_in(const InnerRun& run) {
  std::vector<Rational> costs;
  for (const Step& step : run.steps) costs.push_back(step.cost.value().rational());
  return balanced_sum(std::move(costs));
}

// The input's doubles as they are: nothing is rounded.
Mesh mesh_of(const PointSet& vertices, const Hull& hull) {
  if (!vertices.is_binary()) {
    throw Error(ErrorCode::Unrepresentable,
                "a vertex of the result is no double, and a mesh in binary64 would have to move "
                "it; planes (.json, .ine, .txt) hold the result exactly");
  }
  Mesh mesh;
  mesh.points = vertices;
  mesh.polygons = polygons_of(hull.facets);
  return mesh;
}

InnerResult finish(const PointSet& points, const Hull& hull, InnerResult result,
                   const InnerRequest& request, StageLog& log) {
  for (const VertexId v : vertices_left(result.run, result.start.points.size())) {
    result.kept.push_back(result.start.ids[v.index()]);
  }
  std::sort(result.kept.begin(), result.kept.end());
  const PointSet vertices = subset(points, result.kept);
  const Hull inner =
      log.run("hull of the result", [&] { return hull_of_result(vertices, request); });
  result.solid = log.run("polytope", [&] { return to_polytope(inner, vertices); });
  const Rational before = log.run("volume", [&] { return volume(hull, points); });
  const Rational after = log.run("volume", [&] { return volume(inner, vertices); });
  result.input_volume = measured(before);
  result.output_volume = measured(after);
  if (request.verify == VerifyLevel::None) {
    log.skip("containment", "no verification was requested");
  } else {
    log.run("containment", [&] {
      require_inner(
          find_outside(result.hull, vertices, request.watch.stop, jobs_of(request)).empty(),
          "its vertices lie in every halfspace of the input's hull");
      require_inner(!keeps_costs(request) || before - lost_in(result.run) == after,
                    "its volume is that of the input's hull less all costs");
    });
  }
  if (request.mesh) {
    result.mesh = log.run("store mesh", [&] { return mesh_of(vertices, inner); });
  } else {
    log.skip("store mesh", "no mesh was requested");
  }
  result.engine = request.engine;
  result.verified = request.verify;
  result.stages = log.stages();
  return result;
}

}  // namespace

InnerOutcome simplify_inner(const PointSet& points, const InnerRequest& request) {
  require_sensible(request);
  require_threads(request.jobs);
  StageLog log(request.watch);
  auto outcome = make_hull(points,
                           {.seed = request.seed,
                            .check = request.verify == VerifyLevel::Full,
                            .jobs = jobs_of(request)},
                           log);
  if (const auto* reason = std::get_if<NotSolid>(&outcome)) return *reason;
  const Hull& hull = std::get<Hull>(outcome);
  InnerResult result;
  result.input_points = points.size();
  result.hull = log.run("halfspaces", [&] { return facet_halfspaces(hull, points); });
  result.input_halfspaces = result.hull.size();
  result.start = log.run("triangles", [&] { return vertex_hull(hull, points); });
  result.run = log.run(stage::kSimplify, [&] {
    const InnerOptions options = options_of(request);
    return request.engine == Engine::Exact ? simplify_inner_exact(result.start, options)
                                           : simplify_inner_filtered(result.start, options);
  });
  if (keeps_costs(request)) {
    log.run("costs", [&] { result.run = with_costs(result.start, std::move(result.run)); });
  } else {
    log.skip("costs", "neither a trace nor full verification was requested");
  }
  if (request.verify == VerifyLevel::None) {
    log.skip("steps", "no verification was requested");
  } else {
    log.run("steps", [&] {
      verify_inner_run(result.start, result.run, request.verify, request.watch.stop);
    });
  }
  return finish(points, hull, std::move(result), request, log);
}

}  // namespace convexact
