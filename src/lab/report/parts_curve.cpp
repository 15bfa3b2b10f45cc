// SPDX-License-Identifier: MIT
#include "lab/report/parts_curve.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "convexact/verify_parts.hpp"
#include "number/precision.hpp"
#include "wire/decompose_options.hpp"

namespace convexact {
namespace {

double rounded_up(const Enclosure& x) { return to_double(x.high(), Rounding::Up); }

double share_of(const Measured& volume, const Measured& whole) {
  return volume.bounds.high() <= 0 ? 0 : rounded_up(volume.bounds / whole.bounds);
}

DecomposeRequest request_for(DecomposeMethod method, const Rational& limit, const Effort& effort) {
  DecomposeRequest request;
  request.method = method;
  (method == DecomposeMethod::Cut ? request.distance.emplace() : request.limit) = {limit, true};
  request.measures = PartMeasures::None;
  request.seed = effort.seed;
  request.jobs = 1;  // as all other methods, whose times stand beside it
  return request;
}

// What the oracle finds, which knows nothing of how the parts came about.
void judge(const Mesh& mesh, const Decomposition& made, const Effort& effort, PartsPoint& point) {
  std::vector<NamedPart> parts;
  for (const Part& part : made.parts) parts.push_back({"part", part.mesh});
  Deadline deadline(effort);
  PartsRequest asked;
  asked.claims = {ClaimCode::CoversSurface};
  asked.close = made.caps > 0 ? Close::Auto : Close::Never;
  asked.watch = deadline.watch();
  const PartsVerdict verdict = verify_parts(mesh, parts, asked);
  const PartsMeasures& found = *verdict.measures;
  const Enclosure diameter = sqrt(Enclosure(verdict.squared_diameter, kMeasureBits));
  point.distance = rounded_up(found.surface_to_union / diameter);
  if (found.union_to_input) {
    point.distance = std::max(*point.distance, rounded_up(*found.union_to_input / diameter));
  }
  if (!found.solid_volume || found.solid_volume->bounds.low() <= 0) return;
  if (found.excess_volume) point.excess = share_of(*found.excess_volume, *found.solid_volume);
  point.uncovered = share_of(*found.uncovered_volume, *found.solid_volume);
}

PartsPoint measure_parts(const Mesh& mesh, const DecomposeRequest& request, double limit,
                         const Effort& effort) {
  PartsPoint point{.method = request.method, .limit = limit};
  std::optional<Decomposition> made;
  point.seconds = time_repeatedly(effort, [&](Deadline& deadline) {
    DecomposeRequest own = request;
    own.watch = deadline.watch();
    auto outcome = decompose(mesh, own);
    if (auto* result = std::get_if<Decomposition>(&outcome)) made = std::move(*result);
  });
  if (!point.seconds || !made) return point;
  point.parts = made->parts.size();
  try {
    judge(mesh, *made, effort, point);
  } catch (const Error& error) {
    const bool is_interrupted = effort.stop != nullptr && *effort.stop;
    if (error.code() != ErrorCode::Stopped || is_interrupted) throw;
  }
  return point;
}

}  // namespace

std::vector<PartsPoint> measure_parts_curve(const Mesh& mesh, const Effort& effort) {
  const std::pair<Rational, double> limits[] = {{Rational(1, 10), 0.1},
                                                {Rational(3, 100), 0.03},
                                                {Rational(1, 100), 0.01},
                                                {Rational(3, 1000), 0.003}};
  std::vector<PartsPoint> points;
  for (const DecomposeMethod method :
       {DecomposeMethod::Cut, DecomposeMethod::Hacd, DecomposeMethod::Acd}) {
    for (const auto& [limit, share] : limits) {
      if (effort.progress) {
        effort.progress(
            fmt::format("{} at {}%", name_in(kDecomposeMethodNames, method), 100 * share));
      }
      points.push_back(measure_parts(mesh, request_for(method, limit, effort), share, effort));
      if (!points.back().seconds) break;
    }
  }
  return points;
}

}  // namespace convexact
