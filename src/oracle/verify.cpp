// SPDX-License-Identifier: MIT
#include "convexact/verify.hpp"

#include <algorithm>

#include "convexact/error.hpp"
#include "convexact/measure.hpp"
#include "oracle/judge.hpp"
#include "scene/solid.hpp"

namespace convexact {
namespace {

using namespace oracle;

std::variant<Input, NotSolid> input_of_points(const PointSet& points, std::uint64_t seed,
                                              StageLog& log) {
  StageLog within(StageWatch{.stop = log.watch().stop});
  auto outcome = log.run("input's hull", [&] { return make_hull(points, seed, true, within); });
  if (const auto* reason = std::get_if<NotSolid>(&outcome)) return *reason;
  const auto& hull = std::get<Hull>(outcome);
  return Input{points, hull.vertices, to_polytope(hull, points),
               bounding_box(points).squared_diameter()};
}

std::variant<Input, NotSolid> input_of(const Shape& shape, std::uint64_t seed, StageLog& log) {
  if (const auto* points = std::get_if<PointSet>(&shape)) {
    return input_of_points(*points, seed, log);
  }
  StageLog within(StageWatch{.stop = log.watch().stop});
  SolidOutcome outcome =
      log.run("input's vertices", [&] { return make_solid(shape, seed, true, within); });
  if (const auto* reason = std::get_if<NotSolid>(&outcome)) return *reason;
  auto& solid = std::get<Solid>(outcome);
  const Rational squared = bounding_box(solid.points).squared_diameter();
  return Input{std::move(solid.points), std::move(solid.extreme), std::move(solid.polytope),
               squared};
}

// A distance that rounding in a program explains.
Rational rounding_of(const Input& input, const Candidate& candidate) {
  const auto* mesh = std::get_if<Mesh>(&candidate);
  const PointSet& points = mesh != nullptr ? mesh->points : input.points;
  Rational largest = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (const Rational& x : points[PointId(i)]) largest = std::max<Rational>(largest, abs(x));
  }
  const Precision precision = mesh != nullptr ? precision_of(points) : Precision::Binary64;
  return kRoundingUlps * unit_in_last_place(precision, largest);
}

void judge(const Input& input, const Candidate& candidate, Docket& docket, StageLog& log) {
  if (!judge_reading(candidate, docket)) return;
  CandidateSet set;
  if (const auto* mesh = std::get_if<Mesh>(&candidate)) {
    set = judge_mesh_set(*mesh, docket, log);
    log.run("faces", [&] { judge_faces(*mesh, set, docket, log.watch().stop); });
    find_facets_as_meant(*mesh, set, docket, log);
  } else {
    set = judge_halfspace_set(std::get<HalfspaceList>(candidate), docket, log);
    for (const ClaimCode code : {ClaimCode::MeshClosed, ClaimCode::MeshOriented,
                                 ClaimCode::MeshPlanar, ClaimCode::MeshConvex}) {
      docket.not_applicable(code, "halfspaces have no faces of their own");
    }
  }
  judge_containment(input, candidate, set, docket, log);
  judge_budgets(docket);
  if (!docket.verdict.holds()) judge_tolerance(rounding_of(input, candidate), docket);
  Verdict& verdict = docket.verdict;
  if (!docket.request.tightness) {
    log.skip("tightness", "not requested");
  } else if (!set.polytope) {
    log.skip("tightness", "the candidate is no bounded solid");
  } else {
    const bool contained = verdict.outside && verdict.outside->points == 0;
    log.run("planes of the input", [&] { count_planes_of_the_input(input, set, docket); });
    verdict.tightness = log.run("tightness", [&] {
      return measure_tightness(*set.polytope, input.hull, contained, log.watch().stop);
    });
  }
}

}  // namespace

const Claim& Verdict::operator[](ClaimCode code) const {
  return claims[static_cast<std::size_t>(code)];
}

bool Verdict::holds() const {
  return std::none_of(claims.begin(), claims.end(), [](const Claim& claim) {
    return claim.status == Status::Violated || claim.is_undecided();
  });
}

VerifyOutcome verify(const Shape& shape, const Candidate& candidate, const VerifyRequest& request) {
  if (request.tolerance.value < 0) {
    throw Error(ErrorCode::InvalidArgument, "a tolerance cannot be negative");
  }
  require_numbers(request);
  StageLog log(request.watch);
  auto made = input_of(shape, request.seed, log);
  if (const auto* reason = std::get_if<NotSolid>(&made)) return *reason;
  const auto& input = std::get<Input>(made);
  Verdict verdict;
  verdict.squared_diameter = input.squared_diameter;
  Docket docket(request, verdict);
  judge(input, candidate, docket, log);
  verdict.stages = log.stages();
  return verdict;
}

}  // namespace convexact
