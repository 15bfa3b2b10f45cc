// SPDX-License-Identifier: MIT
#include "convexact/pipeline/simplify.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "convexact/error.hpp"
#include "convexact/lp/chebyshev_center.hpp"
#include "convexact/lp/interior_point.hpp"
#include "convexact/measure/volume.hpp"
#include "convexact/stored/containment.hpp"

namespace convexact {
namespace {

void require_sensible(const SimplifyRequest& request) {
  if (!request.faces && !request.max_growth) {
    throw Error(ErrorCode::InvalidArgument,
                "say where to stop: a number of faces, a growth of volume, or both");
  }
  if (request.faces && *request.faces < 4) {
    throw Error(ErrorCode::InvalidArgument, "no bounded solid has fewer than 4 faces");
  }
  if (request.max_growth && *request.max_growth < 0) {
    throw Error(ErrorCode::InvalidArgument, "the growth of volume cannot be negative");
  }
}

RationalPoint find_center(const Solid& solid, const SimplifyRequest& request, StageLog& log) {
  const std::vector<Halfspace>& halfspaces = solid.dual.halfspaces;
  if (request.center) {
    log.skip("Chebyshev center", "the caller gave a center");
    if (!is_strictly_inside(halfspaces, *request.center)) {
      throw Error(ErrorCode::InvalidArgument, "the center is not strictly inside the input's hull");
    }
    return *request.center;
  }
  return log.run("Chebyshev center", [&] {
    const auto outcome = chebyshev_center(halfspaces, LpOptions{.seed = request.seed});
    const auto* center = std::get_if<ChebyshevCenter>(&outcome);
    if (center == nullptr || !check(halfspaces, *center)) {
      throw Error(ErrorCode::Internal, "the certificate fails: a largest ball in the hull");
    }
    return center->center;
  });
}

SimplifyOptions options_of(const SimplifyRequest& request, std::size_t at_start) {
  SimplifyOptions options;
  options.faces = request.faces.value_or(4);
  options.max_growth = request.max_growth;
  options.seed = request.seed;
  options.verify = request.verify;
  options.stop = request.stop;
  if (request.progress) {
    options.progress = [&request, at_start](std::size_t left) { request.progress(left, at_start); };
  }
  return options;
}

// The last word, by the definition of containment alone. Returns how many points were tested.
std::size_t verify_containment(const Solid& solid, const Polytope& result, VerifyLevel level,
                               StageLog& log) {
  if (level == VerifyLevel::None) {
    log.skip("containment", "nothing is to be verified");
    return 0;
  }
  const std::size_t outside =
      log.run("containment", [&] { return count_outside(result.planes, solid.points); });
  if (outside != 0) {
    throw Error(ErrorCode::Internal,
                fmt::format("{} input points lie outside the result", outside));
  }
  return solid.points.size();
}

Measured measure_volume(const Polytope& polytope, bool exact) {
  if (!exact) return {enclose_volume(polytope, kVolumeBits), std::nullopt};
  const Rational value = volume(polytope);
  return {Enclosure(value, kVolumeBits), value};
}

}  // namespace

SimplifyOutcome simplify(const Shape& shape, const SimplifyRequest& request, StageLog& log) {
  require_sensible(request);
  SolidOutcome outcome = make_solid(shape, request.seed, request.verify != VerifyLevel::None, log);
  if (const auto* reason = std::get_if<NotSolid>(&outcome)) return *reason;
  const auto& solid = std::get<Solid>(outcome);
  const RationalPoint center = find_center(solid, request, log);

  Simplification simplification = log.run("simplify", [&] {
    return simplify_exact(solid.dual, center, options_of(request, solid.dual.halfspaces.size()));
  });
  Trace& trace = simplification.trace;
  Polytope polytope =
      log.run("polytope", [&] { return to_polytope(trace.halfspaces, simplification.triangles); });
  const auto [input_volume, output_volume] = log.run("volume", [&] {
    return std::pair(measure_volume(solid.polytope, request.exact_volumes),
                     measure_volume(polytope, request.exact_volumes));
  });
  if (!request.exact_volumes) log.skip("exact volume", "nobody asked for the fraction");
  log.skip("area and mean width", "simplify does not report them; hull does");
  const std::size_t tested = verify_containment(solid, polytope, request.verify, log);
  StoredSolid stored = store(std::move(polytope), solid.points, solid.extreme, request.store, log);
  return SimplifyResult{solid.input_points, solid.extreme.size(), solid.redundant, std::move(trace),
                        std::move(stored),  input_volume,         output_volume,   tested,
                        request.verify};
}

}  // namespace convexact
