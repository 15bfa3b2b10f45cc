// SPDX-License-Identifier: MIT
// verify(): which claims are asked, the order in which they are decided, and the verdict.
#include "convexact/verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/io.hpp"
#include "convexact/measure.hpp"
#include "io/file_beside.hpp"
#include "io/file_kind.hpp"
#include "io/names.hpp"
#include "number/arithmetic.hpp"
#include "number/text.hpp"
#include "oracle/solid/judge.hpp"
#include "solid/solid.hpp"

namespace convexact {
namespace oracle {

const std::optional<std::size_t>* budget_of(const VerifyRequest& request, ClaimCode code) {
  switch (code) {
    case ClaimCode::MaxFacets:
      return &request.max_facets;
    case ClaimCode::MaxVertices:
      return &request.max_vertices;
    case ClaimCode::MaxFacetVertices:
      return &request.max_facet_vertices;
    default:
      return nullptr;
  }
}

std::optional<ClaimCode> own_claim(Asks asks) {
  switch (asks) {
    case Asks::Inner:
      return ClaimCode::InsideInput;
    case Asks::Hull:
      return ClaimCode::IsHull;
    case Asks::Enclosure:
    case Asks::Simplify:
      break;
  }
  return {};
}

Trial::Trial(const Input& given, const Candidate& judged, const VerifyRequest& asked,
             StageLog& stages)
    : ClaimSheet(asked.claims, asked.tolerance, given.squared_diameter),
      input(given),
      candidate(judged),
      request(asked),
      log(stages) {
  for (const ClaimCode code : kAllClaims) {
    const auto* budget = budget_of(request, code);
    add(code, budget != nullptr ? std::optional(budget->has_value()) : std::nullopt,
        code != ClaimCode::ContainsInput || request.asks != Asks::Inner);
  }
  if (const auto own = own_claim(request.asks)) add(*own, std::nullopt, true);
}

}  // namespace oracle

namespace {

using namespace oracle;

// The points that faces use, by number; none if all points are asked.
std::vector<PointId> asked_points(const VerifyRequest& request) {
  std::vector<PointId> asked;
  if (request.points == MeshPoints::All) return asked;
  for (std::size_t p = 0; p < request.used.size(); ++p) {
    if (request.used[p]) asked.emplace_back(p);
  }
  return asked;
}

std::variant<Input, NotSolid> whole_input(const Shape& shape, std::uint64_t seed, StageLog& log) {
  StageLog within(StageWatch{.stop = log.watch().stop});
  if (const auto* points = std::get_if<PointSet>(&shape)) {
    const auto outcome =
        log.run("input's hull", [&] { return make_hull(*points, {.seed = seed}, within); });
    if (const auto* reason = std::get_if<NotSolid>(&outcome)) return *reason;
    const auto& hull = std::get<Hull>(outcome);
    return Input{*points, hull.vertices, to_polytope(hull, *points),
                 bounding_box(*points).squared_diameter()};
  }
  SolidOutcome outcome =
      log.run("input's vertices", [&] { return make_solid(shape, {.seed = seed}, within); });
  if (const auto* reason = std::get_if<NotSolid>(&outcome)) return *reason;
  auto& solid = std::get<Solid>(outcome);
  const Rational squared = bounding_box(solid.points).squared_diameter();
  return Input{std::move(solid.points), std::move(solid.extreme), std::move(solid.polytope),
               squared};
}

std::variant<Input, NotSolid> input_of(const Shape& shape, const VerifyRequest& request,
                                       StageLog& log) {
  std::vector<PointId> asked = asked_points(request);
  const auto* points = std::get_if<PointSet>(&shape);
  if (points == nullptr || asked.empty()) return whole_input(shape, request.seed, log);
  auto made = whole_input(subset(*points, asked), request.seed, log);
  if (auto* input = std::get_if<Input>(&made)) {
    input->numbers = std::move(asked);
  } else if (auto* flat = std::get_if<FlatInput>(&std::get<NotSolid>(made))) {
    for (PointId& p : flat->basis) p = asked[p.index()];
  }
  return made;
}

// A distance that rounding in a program explains.
Rational rounding_of(const Trial& trial) {
  const Mesh* mesh = trial.mesh();
  const PointSet& points = mesh != nullptr ? mesh->points : trial.input.points;
  const Precision precision = mesh != nullptr ? precision_of(points) : Precision::Binary64;
  return kRoundingUlps * unit_in_last_place(precision, bounding_box(points).largest_coordinate());
}

// After all claims: the tolerance with which they hold, if there is one.
void find_smallest_tolerance(Trial& trial) {
  Verdict& verdict = trial.verdict;
  Rational worst = 0;
  for (const Claim& claim : trial.claims) {
    if (claim.is_unanswered()) return;
    if (claim.status != Status::Violated) continue;
    if (!claim.is_by_distance) return;
    worst = std::max(worst, *claim.witness.squared_distance);
  }
  if (worst == 0) return;
  const Rational rounding = rounding_of(trial);
  const SmallestTolerance least{least_tolerance(worst), worst <= rounding * rounding};
  verdict.smallest_tolerance = least;
  verdict.notes.push_back((least.is_rounding
                               ? "every violation is no larger than rounding explains, " +
                                     std::to_string(kRoundingUlps) +
                                     " units in the last place of the largest coordinate; "
                               : std::string()) +
                          "with --tolerance " + least.decimal + " every claim holds");
}

// Corners in lexicographic order: doubles decide unless they are equal.
class SortedCorners {
 public:
  explicit SortedCorners(const std::vector<RationalPoint>& corners) : corners_(corners) {
    for (const RationalPoint& x : corners) near_.push_back(nearest(x));
    order_.resize(corners.size());
    std::iota(order_.begin(), order_.end(), 0u);
    std::sort(order_.begin(), order_.end(),
              [&](std::uint32_t a, std::uint32_t b) { return is_before(a, b); });
  }
  friend bool operator==(const SortedCorners& a, const SortedCorners& b) {
    return std::equal(a.order_.begin(), a.order_.end(), b.order_.begin(), b.order_.end(),
                      [&](std::uint32_t i, std::uint32_t j) {
                        return a.near_[i] == b.near_[j] && a.corners_[i] == b.corners_[j];
                      });
  }

 private:
  bool is_before(std::uint32_t a, std::uint32_t b) const {
    for (int k = 0; k < 3; ++k) {
      if (near_[a][k] != near_[b][k]) return near_[a][k] < near_[b][k];
      if (const int c = corners_[a][k].compare(corners_[b][k])) return c < 0;
    }
    return false;
  }

  const std::vector<RationalPoint>& corners_;
  std::vector<Point> near_;
  std::vector<std::uint32_t> order_;
};

// Two polytopes are the same set iff they have the same corners.
bool is_same(const Polytope& candidate, const Polytope& hull) {
  return candidate.facets.size() == hull.facets.size() &&
         candidate.vertices.size() == hull.vertices.size() &&
         SortedCorners(candidate.vertices) == SortedCorners(hull.vertices);
}

// If the candidate is known to contain the hull, the distance is measured in one direction only,
// and nothing is measured if it is the hull.
Tightness measure_tightness(const Polytope& candidate, const Polytope& hull, bool contained,
                            const Watch& watch) {
  constexpr long kBits = 96;  // some twenty certain decimal digits of each ratio
  if (contained && is_same(candidate, hull)) {
    const Enclosure one(Rational(1), kBits);
    return {one, one, one, 0};
  }
  Rational squared = hausdorff_distance(candidate, hull, watch).squared;
  if (!contained) squared = std::max(squared, hausdorff_distance(hull, candidate, watch).squared);
  return {enclose_volume(candidate, kBits) / enclose_volume(hull, kBits),
          surface_area(candidate, kBits) / surface_area(hull, kBits),
          mean_width(candidate, kBits, watch) / mean_width(hull, kBits, watch), std::move(squared)};
}

void measure(Trial& trial) {
  StageLog& log = trial.log;
  Verdict& verdict = trial.verdict;
  if (!trial.request.tightness) {
    log.skip("tightness", "not requested");
  } else if (!trial.set.polytope) {
    log.skip("tightness", "the candidate is no bounded solid");
  } else {
    const bool contained = verdict.outside && verdict.outside->points == 0;
    log.run("planes of the input", [&] { count_planes_of_the_input(trial); });
    verdict.tightness = log.run("tightness", [&] {
      return measure_tightness(*trial.set.polytope, trial.input.hull, contained, trial.stop());
    });
  }
}

void judge(Trial& trial) {
  if (!judge_reading(trial)) return;
  judge_set(trial);
  judge_faces(trial);
  find_facets_as_meant(trial);
  judge_containment(trial);
  judge_inside_input(trial);
  judge_is_hull(trial);
  judge_budgets(trial);
  find_smallest_tolerance(trial);
  measure(trial);
}

constexpr auto kClaimNames =
    name_table<ClaimCode>({{ClaimCode::CandidateReadable, "candidate-readable"},
                           {ClaimCode::CandidateFinite, "candidate-finite"},
                           {ClaimCode::CandidateSolid, "candidate-solid"},
                           {ClaimCode::CandidateBounded, "candidate-bounded"},
                           {ClaimCode::MeshClosed, "mesh-closed"},
                           {ClaimCode::MeshOriented, "mesh-oriented"},
                           {ClaimCode::MeshPlanar, "mesh-planar"},
                           {ClaimCode::MeshConvex, "mesh-convex"},
                           {ClaimCode::ContainsInput, "contains-input"},
                           {ClaimCode::MaxFacets, "max-facets"},
                           {ClaimCode::MaxVertices, "max-vertices"},
                           {ClaimCode::MaxFacetVertices, "max-facet-vertices"},
                           {ClaimCode::InsideInput, "inside-input"},
                           {ClaimCode::IsHull, "is-hull"},
                           {ClaimCode::NoGaps, "no-gaps"},
                           {ClaimCode::PartsReadable, "parts-readable"},
                           {ClaimCode::PartsFinite, "parts-finite"},
                           {ClaimCode::PartsSolid, "parts-solid"},
                           {ClaimCode::PartsConvex, "parts-convex"},
                           {ClaimCode::CoversPoints, "covers-points"},
                           {ClaimCode::CoversSurface, "covers-surface"},
                           {ClaimCode::CoversSolid, "covers-solid"},
                           {ClaimCode::WithinSolid, "within-solid"},
                           {ClaimCode::PartsDisjoint, "parts-disjoint"},
                           {ClaimCode::PartsNeeded, "parts-needed"},
                           {ClaimCode::MaxParts, "max-parts"},
                           {ClaimCode::MaxPartFacets, "max-part-facets"},
                           {ClaimCode::MaxPartVertices, "max-part-vertices"},
                           {ClaimCode::MaxPartFacetVertices, "max-part-facet-vertices"},
                           {ClaimCode::TreeNested, "tree-nested"}});
// In addition to those of every solid and every decomposition: inside-input, is-hull, no-gaps and
// tree-nested.
static_assert(kClaimNames.size() == kAllClaims.size() + 3 + kPartsClaims.size() + 1);

constexpr auto kStatusNames = name_table<Status>({{Status::Holds, "holds"},
                                                  {Status::Violated, "violated"},
                                                  {Status::NotAsked, "not-asked"},
                                                  {Status::NotApplicable, "not-applicable"},
                                                  {Status::Undecided, "undecided"}});

}  // namespace

const char* name_of(ClaimCode code) { return name_in(kClaimNames, code); }
std::optional<ClaimCode> claim_of_name(const std::string& name) {
  return value_in(kClaimNames, name);
}
const char* name_of(Status status) { return name_in(kStatusNames, status); }

const Claim& Verdict::operator[](ClaimCode code) const {
  const auto found = std::find_if(claims.begin(), claims.end(),
                                  [&](const Claim& claim) { return claim.code == code; });
  return claims.at(static_cast<std::size_t>(found - claims.begin()));
}

bool Verdict::holds() const {
  return std::none_of(claims.begin(), claims.end(), [](const Claim& claim) {
    return claim.status == Status::Violated || claim.is_unanswered();
  });
}

VerifyOutcome verify(const Shape& shape, const Candidate& candidate, const VerifyRequest& request) {
  if (request.tolerance.value < 0) {
    throw Error(ErrorCode::InvalidArgument, "a tolerance cannot be negative");
  }
  if (request.asks == Asks::Simplify && !request.max_facets) {
    throw Error(ErrorCode::InvalidArgument,
                "asking simplify needs the number of facets that it allows: set max-facets");
  }
  for (const ClaimCode code : request.claims) {
    for (const Asks asks : {Asks::Inner, Asks::Hull}) {
      if (code != own_claim(asks) || request.asks == asks) continue;
      throw Error(ErrorCode::InvalidArgument,
                  fmt::format("the claim {} needs the question {}: ask {}", name_of(code),
                              name_of(asks), name_of(asks)));
    }
    if (code == ClaimCode::NoGaps) {
      throw Error(ErrorCode::InvalidArgument,
                  "the claim no-gaps is of the parts of a scene, not of one solid");
    }
    if (is_of_parts(code)) {
      throw Error(ErrorCode::InvalidArgument, "the claim " + std::string(name_of(code)) +
                                                  " is of a decomposition, not of one solid");
    }
    const auto* budget = budget_of(request, code);
    if (budget == nullptr || *budget) continue;
    const std::string name(name_of(code));
    throw Error(ErrorCode::InvalidArgument,
                "the claim " + name + " needs the number that it allows: set " + name);
  }
  if (const auto* points = std::get_if<PointSet>(&shape);
      points != nullptr && !request.used.empty() && request.used.size() != points->size()) {
    throw Error(ErrorCode::InvalidArgument, "used: expected a flag for each point of the input");
  }
  StageLog log(request.watch);
  const auto made = input_of(shape, request, log);
  if (const auto* reason = std::get_if<NotSolid>(&made)) return *reason;
  Trial trial(std::get<Input>(made), candidate, request, log);
  judge(trial);
  Verdict verdict = std::move(trial.verdict);
  verdict.claims = std::move(trial.claims);
  verdict.squared_diameter = trial.squared_diameter;
  verdict.stages = log.stages();
  return verdict;
}

Candidate read_candidate_bytes(std::string_view bytes, const std::string& path, Decimal decimal) {
  try {
    const auto [mesh, halfspaces] = kind_of_file(bytes, path);
    if (halfspaces) return read_halfspaces_bytes(bytes, *halfspaces, decimal);
    return read_mesh_bytes(
        bytes,
        {.decimal = decimal, .format = mesh, .strict = true, .folder = folder_of_file(path)});
  } catch (const Error& error) {
    return fault_of_candidate(error, path);
  }
}

Candidate read_candidate(const std::string& path, Decimal decimal) {
  return read_candidate_bytes(read_bytes(path), path, decimal);
}

}  // namespace convexact
