// SPDX-License-Identifier: MIT
// verify_parts(): which claims are asked, the order in which they are decided, and the judgement of
// each part alone.
#include "convexact/verify_parts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "convexact/error.hpp"
#include "convexact/measure.hpp"
#include "number/text.hpp"
#include "oracle/parts/judge.hpp"
#include "oracle/solid/judge.hpp"
#include "task/parallel.hpp"

namespace convexact {
namespace oracle {

using enum ClaimCode;

const std::optional<std::size_t>* budget_of(const PartsRequest& request, ClaimCode code) {
  switch (code) {
    case MaxParts:
      return &request.max_parts;
    case MaxPartFacets:
      return &request.max_facets;
    case MaxPartVertices:
      return &request.max_vertices;
    case MaxPartFacetVertices:
      return &request.max_facet_vertices;
    default:
      return nullptr;
  }
}

namespace {

// Of a claim that is asked for by a number: whether that is given.
std::optional<bool> has_number(const PartsRequest& request, ClaimCode code) {
  if (code == WithinSolid) return request.distance.has_value();
  const auto* budget = budget_of(request, code);
  return budget != nullptr ? std::optional(budget->has_value()) : std::nullopt;
}

// A distance asks about both directions; a tolerance is for the surface alone.
bool is_usual(ClaimCode code, const PartsRequest& request) {
  if (code == CoversSolid) return request.distance && request.tolerance.value == 0;
  return code != PartsDisjoint && code != PartsNeeded;
}

// The claim about a single solid that corresponds to a budget of each part.
ClaimCode of_one_part(ClaimCode code) {
  return code == MaxPartFacets     ? MaxFacets
         : code == MaxPartVertices ? MaxVertices
                                   : MaxFacetVertices;
}

// The claims of a solid that make up parts-convex, and parts-solid first.
constexpr ClaimCode kOwnClaims[] = {CandidateSolid, MeshClosed, MeshOriented, MeshPlanar,
                                    MeshConvex};

VerifyRequest request_for_a_part(const PartsTrial& trial) {
  const PartsRequest& asked = trial.request;
  VerifyRequest request;
  if (trial.asks(PartsConvex)) {
    request.claims.assign(std::begin(kOwnClaims), std::end(kOwnClaims));
  } else {
    request.claims = {CandidateSolid};
  }
  request.tolerance = asked.tolerance;
  static_cast<Budgets&>(request) = asked;
  request.exact_facets = asked.exact_facets;
  request.tightness = false;
  request.seed = asked.seed;
  return request;
}

// What a flat part counts: a polygon has two sides, a segment two ends, a point itself.
void count_flat(const ConvexPart& part, CandidateSize& size) {
  const bool is_polygon = part.dimension == 2;
  size.vertices = part.vertices.size();
  size.facets = is_polygon ? 2 : 0;
  size.most_facet_vertices = is_polygon ? part.vertices.size() : 0;
}

// The oracle's judgement of a solid, except for the claims about the input.
JudgedPart judge_part(const NamedPart& part, const ConvexPart& hull, const VerifyRequest& request,
                      const PartsTrial& trial) {
  const Input nothing{{}, {}, {}, trial.squared_diameter};
  const Candidate candidate = part.mesh;
  StageLog within(StageWatch{.stop = trial.log.watch().stop});
  Trial own(nothing, candidate, request, within);
  judge_set(own);
  // The faces of a flat part bound nothing, in any position; that it is flat has been reported.
  if (own.set.hull) judge_faces(own);
  find_facets_as_meant(own);
  if (hull.dimension < 3) count_flat(hull, own.verdict.size);
  judge_budgets(own);
  std::erase_if(own.claims, [](const Claim& claim) { return claim.status == Status::NotAsked; });
  return {part.name, own.verdict.size, std::move(own.claims)};
}

const Claim* find_violated(const JudgedPart& part, std::span<const ClaimCode> codes) {
  const auto found = std::find_if(part.claims.begin(), part.claims.end(), [&](const Claim& claim) {
    return claim.status == Status::Violated &&
           std::find(codes.begin(), codes.end(), claim.code) != codes.end();
  });
  return found == part.claims.end() ? nullptr : &*found;
}

// Violated if one of some claims of a part is; the first such part is the witness.
void judge_all(ClaimCode code, std::span<const ClaimCode> of_each, const std::string& all_hold,
               PartsTrial& trial) {
  const std::vector<JudgedPart>& parts = trial.verdict.parts;
  std::vector<std::size_t> violated;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (find_violated(parts[k], of_each) != nullptr) violated.push_back(k);
  }
  if (violated.empty()) return trial.holds(code, all_hold);
  const Claim& first = *find_violated(parts[violated.front()], of_each);
  Witness witness = first.witness;
  witness.parts = {violated.front()};
  trial.violated(
      code,
      fmt::format("{} of {}; {}: {}", violated.size(), counted(parts.size(), "part", "parts"),
                  trial.part_text(violated.front()), first.sentence),
      std::move(witness));
}

void judge_count_of_parts(PartsTrial& trial) {
  if (!trial.asks(MaxParts)) return;
  const std::size_t found = trial.verdict.parts.size(), most = *trial.request.max_parts;
  if (found == 0) return trial.not_applicable(MaxParts, "there is no part");
  const std::string sentence = fmt::format("parts: {}, at most {} allowed", found, most);
  if (found <= most) return trial.holds(MaxParts, sentence);
  Witness witness;
  witness.count = found;
  trial.violated(MaxParts, sentence, std::move(witness));
}

void judge_each_budget(PartsTrial& trial) {
  for (const ClaimCode code : {MaxPartFacets, MaxPartVertices, MaxPartFacetVertices}) {
    if (!trial.asks(code)) continue;
    if (trial.verdict.parts.empty()) {
      trial.not_applicable(code, "there is no part");
      continue;
    }
    const ClaimCode own = of_one_part(code);
    std::size_t most = 0;
    for (const JudgedPart& part : trial.verdict.parts) {
      const auto& counted = own == MaxFacets
                                ? (trial.request.exact_facets || !part.size.facets_as_meant
                                       ? part.size.facets
                                       : part.size.facets_as_meant)
                            : own == MaxVertices ? part.size.vertices
                                                 : part.size.most_facet_vertices;
      most = std::max(most, counted.value());
    }
    judge_all(code, std::span(&own, 1),
              fmt::format("the most of a part: {}, at most {} allowed", most,
                          **budget_of(trial.request, code)),
              trial);
  }
}

// Solid, convex, and the budgets: what each part is on its own.
void judge_each_part(std::span<const NamedPart> parts, PartsTrial& trial) {
  const VerifyRequest request = request_for_a_part(trial);
  trial.log.run("each part", [&] {
    trial.verdict.hulls.resize(parts.size());
    trial.verdict.parts.resize(parts.size());
    for_each_in_parallel(parts.size(), jobs_of(trial.request), trial.watch("each part"),
                         [&](std::size_t k, const Watch& watch) {
                           ConvexPart& hull = trial.verdict.hulls[k];
                           hull = convex_part(parts[k].mesh.points, watch);
                           trial.verdict.parts[k] = judge_part(parts[k], hull, request, trial);
                         });
  });
  if (parts.empty()) {
    trial.violated(PartsSolid, "there is no part");
    trial.not_applicable(PartsConvex, "there is no part");
  } else {
    judge_all(PartsSolid, std::span(kOwnClaims, 1), "each part spans a volume", trial);
    judge_all(PartsConvex, std::span(kOwnClaims).subspan(1),
              "the faces of each part are the surface of the hull of its points", trial);
  }
  judge_count_of_parts(trial);
  judge_each_budget(trial);
}

void check_request(const PartsRequest& request) {
  if (request.tolerance.value < 0) {
    throw Error(ErrorCode::InvalidArgument, "a tolerance cannot be negative");
  }
  if (request.distance && request.distance->value < 0) {
    throw Error(ErrorCode::InvalidArgument, "a distance cannot be negative");
  }
  require_threads(request.jobs);
  for (const ClaimCode code : request.claims) {
    const std::string name = name_of(code);
    if (!is_of_parts(code)) {
      throw Error(ErrorCode::InvalidArgument,
                  "the claim " + name + " is of one solid, not of a decomposition");
    }
    if (code == CoversSolid && request.tolerance.value > 0) {
      throw Error(ErrorCode::InvalidArgument,
                  "covers-solid is decided without a tolerance: leave out one of them");
    }
    if (!has_number(request, code).value_or(true)) {
      throw Error(ErrorCode::InvalidArgument, "the claim " + name +
                                                  " needs the number that it allows: set " +
                                                  (code == WithinSolid ? "a distance" : name));
    }
  }
}

// Returns the parts, if there is anything to judge.
const std::vector<NamedPart>* judge_reading(const CandidateParts& candidate, PartsTrial& trial) {
  if (const auto* parts = parts_of(candidate)) {
    trial.holds(PartsReadable, counted(parts->size(), "part", "parts"));
    trial.holds(PartsFinite, "every number is finite");
    return parts;
  }
  trial.unreadable(std::get<Error>(candidate), PartsReadable, PartsFinite, "the parts");
  return nullptr;
}

// How the surface differs from a proper mesh of a solid, and how it was read.
void note_surface(const Surface& surface, std::vector<std::string>& notes) {
  const auto note = [&](std::size_t count, const char* one, const char* many,
                        const std::string& rest) {
    if (count > 0) notes.push_back(counted(count, one, many) + rest);
  };
  std::size_t reversed = 0, turned = 0, twisted = 0;
  for (const SurfaceComponent& component : surface.components) {
    reversed += component.is_reversed ? 1 : 0;
    turned += component.is_reversed ? 0 : component.turned;
    twisted += component.is_orientable ? 0 : 1;
  }
  note(reversed, "component of the input was", "components of the input were",
       " inside out, and turned");
  note(turned, "triangle of the input was", "triangles of the input were",
       " turned to match the neighbours");
  note(twisted, "component of the input has", "components of the input have",
       " a single side, like a Moebius strip");
  note(surface.ambiguous_edges, "edge of the input joins", "edges of the input join",
       " sheets of which it is not clear how they belong together");
  note(surface.bent_faces, "face of the input is", "faces of the input are",
       " not planar, and cut as a fan from the lowest corner");
  note(surface.fans.size() - surface.bent_faces, "face of the input is", "faces of the input are",
       " not simple, as edges cross, and cut as a fan from the lowest corner");
  note(surface.flat_triangles, "triangle of the input has", "triangles of the input have",
       " no area; its points are to be held all the same");
  note(surface.repeated_triangles, "triangle of the input repeats", "triangles of the input repeat",
       " an earlier one");
  note(count_near_corners(surface), "corner of the input lies", "corners of the input lie",
       " within a millionth of the diameter of another one, and most components are open: the file "
       "may repeat corners with other roundings; join them before");
}

// Behind those of the surface.
void add_unused_points(PartsTrial& trial) {
  const PointSet& unused = trial.verdict.surface.unused;
  if (unused.size() == 0) return;
  if (trial.request.points == MeshPoints::Used) {
    trial.verdict.notes.push_back(unused_text(unused.size()));
  } else {
    trial.points = concatenated(trial.points, unused);
  }
}

void find_points(PartsTrial& trial) {
  if (trial.input.points.size() == 0) {
    throw Error(ErrorCode::NoInterior, "the input is empty: it has no point");
  }
  if (trial.input.polygons.empty()) {
    trial.points = trial.input.points;
    trial.log.skip("input's surface", "the input has no faces");
  } else {
    trial.log.run("input's surface", [&] {
      const SurfaceOptions options{.orient = trial.request.orient};
      const Watch watch = trial.watch("input's surface");
      if (trial.request.close == Close::Never) {
        trial.verdict.surface = make_surface(trial.input, options, watch);
        if (trial.request.distance && !trial.verdict.surface.is_closed) {
          trial.verdict.notes.emplace_back(
              "the faces do not close, so that distances are from them alone; --close auto judges "
              "with caps over small borders, as decompose puts them");
        }
        return;
      }
      ClosedSurface closed = make_closed_surface(trial.input, options, watch);
      if (closed.caps > 0) {
        trial.verdict.notes.push_back(fmt::format(
            "the input was closed by {}, the largest {} wide; they are its faces from {} "
            "on",
            counted(closed.caps, "cap", "caps"), decimal_of_root(closed.squared_largest),
            trial.input.polygons.size()));
      }
      trial.verdict.surface = std::move(closed.surface);
    });
    trial.points = trial.verdict.surface.points;
    note_surface(trial.verdict.surface, trial.verdict.notes);
    add_unused_points(trial);
  }
  trial.squared_diameter = bounding_box(trial.points).squared_diameter();
  trial.verdict.distance = trial.request.distance;
}

}  // namespace

PartsTrial::PartsTrial(const Mesh& given, bool has_tree, const PartsRequest& asked,
                       StageLog& stages)
    : ClaimSheet(asked.claims, asked.tolerance, 0), input(given), request(asked), log(stages) {
  for (const ClaimCode code : kPartsClaims) {
    add(code, has_number(request, code), is_usual(code, request));
  }
  const auto& named = request.claims;
  const bool names_tree = std::find(named.begin(), named.end(), TreeNested) != named.end();
  if (has_tree || names_tree) add(TreeNested, std::nullopt, true);
}

std::string PartsTrial::part_text(std::size_t part) const {
  return fmt::format("part {} ({})", part, in_quotes(verdict.parts[part].name));
}

}  // namespace oracle

const Claim& PartsVerdict::operator[](ClaimCode code) const {
  return claims.at(static_cast<std::size_t>(code) -
                   static_cast<std::size_t>(ClaimCode::PartsReadable));
}

bool PartsVerdict::holds() const {
  return std::none_of(claims.begin(), claims.end(), [](const Claim& claim) {
    return claim.status == Status::Violated || claim.status == Status::Undecided ||
           claim.is_unanswered();
  });
}

PartsRequest parts_request(const VerifyRequest& request) {
  PartsRequest asked;
  static_cast<Budgets&>(asked) = request;
  asked.claims = request.claims;
  asked.tolerance = request.tolerance;
  asked.points = request.points;
  asked.exact_facets = request.exact_facets;
  asked.measures = request.tightness ? PartMeasures::All : PartMeasures::None;
  asked.seed = request.seed;
  asked.watch = request.watch;
  return asked;
}

std::string describe_distance(const Tolerance& distance) {
  constexpr int kDigits = 6;
  if (!distance.relative) return to_decimal(distance.value, kDigits);
  return to_decimal(distance.value * 100, kDigits) + "% of the diameter";
}

PartsVerdict verify_parts(const Mesh& input, const CandidateParts& candidate,
                          const PartsRequest& request) {
  using namespace oracle;
  check_request(request);
  StageLog log(request.watch);
  const auto* tree = std::get_if<HullTree>(&candidate);
  PartsTrial trial(input, tree != nullptr, request, log);
  find_points(trial);
  if (const std::vector<NamedPart>* parts = judge_reading(candidate, trial)) {
    judge_each_part(*parts, trial);
    judge_coverage(trial);
    judge_reach(trial);
    judge_pairs(trial);
    judge_tree(tree, trial);
    measure_parts(trial);
  }
  PartsVerdict verdict = std::move(trial.verdict);
  verdict.claims = std::move(trial.claims);
  verdict.squared_diameter = trial.squared_diameter;
  verdict.stages = log.stages();
  return verdict;
}

}  // namespace convexact
