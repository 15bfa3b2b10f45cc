// SPDX-License-Identifier: MIT
// judge_run(): how a run ended and, if there is an output, its faults: the claims of verify(), the
// volume, and the program's promises.
#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <tuple>

#include "conform/conformance_judge.hpp"
#include "conform/tied_removals.hpp"
#include "convexact/conform.hpp"
#include "convexact/error.hpp"
#include "convexact/linear_program.hpp"
#include "convexact/measure.hpp"
#include "convexact/number.hpp"
#include "convexact/simplify.hpp"
#include "convexact/verify.hpp"
#include "number/text.hpp"
#include "solid/solid.hpp"

namespace convexact {

bool is_graver(const Failure& a, const Failure& b) {
  return std::tie(a.is_rounding, a.outcome, b.size) < std::tie(b.is_rounding, b.outcome, a.size);
}

VerifyRequest request_of(const Promise& promise) {
  VerifyRequest request;
  const bool is_any_number = promise.asks == Asks::Simplify && !promise.max_facets;
  request.asks = is_any_number ? Asks::Enclosure : promise.asks;
  request.tolerance = promise.tolerance;
  static_cast<Budgets&>(request) = promise;
  return request;
}

namespace {

using namespace oracle;

// ---- The output

constexpr std::uint64_t kSeed = 1;
constexpr long kShownBits = 96;  // of measures that are compared or printed
constexpr int kShownDigits = 6;  // of numbers in sentences

void judge_claims(Case& c) {
  const Verdict& verdict = c.verdict;
  const auto violated = [&](ClaimCode code) { return verdict[code].status == Status::Violated; };
  const auto sentence = [&](ClaimCode code) {
    return std::string(name_of(code)) + ": " + verdict[code].sentence;
  };
  const auto distance = [&](ClaimCode code) {
    return c.relative(verdict[code].witness.squared_distance.value_or(0));
  };
  using enum ClaimCode;
  for (const auto& [code, outcome] :
       {std::pair(CandidateReadable, Outcome::UnreadableOutput),
        std::pair(CandidateFinite, Outcome::UnreadableOutput),
        std::pair(CandidateSolid, Outcome::NoSolid), std::pair(CandidateBounded, Outcome::NoSolid),
        std::pair(MeshClosed, Outcome::BrokenMesh), std::pair(MeshOriented, Outcome::BrokenMesh),
        std::pair(MaxVertices, Outcome::TooManyVertices),
        std::pair(MaxFacetVertices, Outcome::TooManyFacetVertices)}) {
    if (violated(code)) c.fail(outcome, sentence(code));
  }
  if (violated(ContainsInput) && c.solid) {
    c.fail(Outcome::NotEnclosing, sentence(ContainsInput), distance(ContainsInput),
           leak_is_rounding(c));
  }
  if (c.asks(Asks::Inner) && c.solid && violated(InsideInput)) {
    c.fail(Outcome::NotInside, sentence(InsideInput), distance(InsideInput));
  }
  // Where a point of the input is worst, contains-input says so.
  if (c.asks(Asks::Hull) && c.solid && violated(IsHull) && !verdict[IsHull].witness.input_point) {
    c.fail(Outcome::NotTheHull, sentence(IsHull), distance(IsHull),
           is_moved_corner(c, verdict[IsHull].witness.squared_distance.value()));
  }
  if (!c.solid || (!violated(MeshPlanar) && !violated(MeshConvex))) return;
  // A face that crosses itself, and faces that cover the hull twice, are faults without a distance.
  const auto is_gross = [&](ClaimCode code) {
    return violated(code) && !verdict[code].is_by_distance;
  };
  const bool is_sound = !violated(MeshClosed) && !violated(MeshOriented) && !is_gross(MeshPlanar) &&
                        !is_gross(MeshConvex);
  if (is_sound && faces_are_rounded(c)) {
    c.result.notes.push_back("the faces are planar and convex up to the rounding of their corners");
    return;
  }
  for (const ClaimCode code : {MeshConvex, MeshPlanar}) {
    if (violated(code)) c.fail(Outcome::NotConvex, sentence(code), distance(code));
  }
}

// How many times as large as the box of the input an enclosure may be. A tetrahedron of 4.5 times
// its volume holds a box, and six faces hold it exactly; twice these factors are allowed.
int most_boxes(const Case& c) {
  const auto* question = c.simplification();
  return c.asks(Asks::Simplify) && question != nullptr && question->faces >= 6 ? 2 : 9;
}

SimplifyResult greedy_run(const Case& c, std::size_t faces) {
  SimplifyRequest request;
  request.faces = faces;
  request.exact_volumes = true;
  request.jobs = 1;  // vectors are judged beside each other
  request.watch = c.watch;
  return std::get<SimplifyResult>(simplify(c.given.points, request));
}

// The volume of the exact greedy run: from the vector, or computed.
Rational greedy_volume(const Case& c, std::size_t faces) {
  if (const auto* question = c.simplification(); question->volume) return *question->volume;
  return greedy_run(c, faces).output_volume.exact.value();
}

// For enclosures only: an inner solid may be of any size.
void judge_volume(Case& c) {
  const Enclosure about = enclose_volume(*c.solid, kShownBits);
  const Enclosure hull = enclose_volume(c.given.hull, kShownBits);
  const auto* question = c.simplification();
  const bool is_greedy = c.asks(Asks::Simplify) && question != nullptr;
  const auto middle = [](const Enclosure& x) { return Rational((x.low() + x.high()) / 2); };
  if (!is_greedy) {
    c.result.tightness = middle(about / hull);
  } else if (question->volume) {
    c.result.tightness = middle(about) / *question->volume;
  }
  if (c.asks(Asks::Inner)) return;
  const RationalVector3 size = bounding_box(c.given.points).size();
  Rational most = most_boxes(c) * size[0] * size[1] * size[2];
  if (about.high() <= most) return;
  std::string limit = fmt::format("{} times the axis-aligned box", most_boxes(c));
  if (is_greedy) {
    const Rational twice = 2 * greedy_volume(c, question->faces);
    if (twice > most) {
      most = twice;
      limit = "twice the exact greedy result";
    }
  }
  const Rational exact = volume(*c.solid);
  if (exact <= most) return;
  c.fail(Outcome::TooLoose,
         fmt::format("its volume is {}; acceptable is up to {}, {}",
                     to_decimal(exact, kShownDigits), to_decimal(most, kShownDigits), limit),
         exact / most);
}

// Whether no facet can be removed: for each of them, the others bound an unbounded set.
bool is_stuck(const std::vector<Halfspace>& planes, const Watch& watch) {
  for (std::size_t gone = 0; gone < planes.size(); ++gone) {
    watch.ask();
    std::vector<Halfspace> others = planes;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(gone));
    if (std::holds_alternative<BoundedProof>(find_recession(others))) return false;
  }
  return true;
}

std::optional<std::size_t> most_facets(const TestVector& vector, const Promise& promise) {
  std::optional<std::size_t> most = promise.max_facets;
  const auto* question = std::get_if<SimplifyQuestion>(&vector.question);
  if (promise.asks == Asks::Simplify && question != nullptr) {
    const std::size_t wanted = std::max(question->faces, question->facets);
    most = std::min(most.value_or(wanted), wanted);
  }
  return most;
}

// The facets of the input's hull that a solid keeps, if it has no others, up to rounding: removals
// leave no others, so another solid, such as the bounding box, is no end of a greedy run.
std::optional<std::vector<Halfspace>> kept_facets(const CandidateSize& size) {
  const std::optional<std::size_t> facets =
      size.facets_as_meant ? size.facets_as_meant : size.facets;
  if (!facets || !size.planes_of_the_input || size.planes_of_the_input->size() != *facets)
    return {};
  return size.planes_of_the_input;
}

constexpr std::size_t kMostTieStates = 10000;

// Whether greedy removals end with this solid: no facet of it can be removed, and the exact run
// ends with as many, or other choices among removals of the same cost lead to it.
ByTies is_end_of_removals(Case& c, std::size_t found) {
  const std::optional<std::vector<Halfspace>> kept = kept_facets(c.verdict.size);
  if (!kept || !is_stuck(*kept, Watch(c.watch.stop))) return ByTies::DoNotLead;
  // Where the volume is known, so is the number of facets, and more of them are allowed already.
  if (const auto* question = c.simplification(); question != nullptr && !question->volume) {
    if (found <= greedy_run(c, question->faces).solid.exact.planes.size()) return ByTies::Lead;
  }
  StageLog log(c.watch);
  const auto solid = make_solid(Shape(c.given.points), {.seed = kSeed}, log);
  return do_ties_lead(std::get<Solid>(solid), *kept, kMostTieStates, c.watch.stop);
}

// A simplification with too many facets is accepted if it is an end of removals, unless it breaks
// the program's promise.
void judge_facets(Case& c) {
  const Claim& claim = c.verdict[ClaimCode::MaxFacets];
  if (claim.status != Status::Violated || !c.solid) return;
  const std::size_t found = claim.witness.count.value_or(0);
  const bool is_promised = !c.promise.max_facets || found <= *c.promise.max_facets;
  const std::string sentence = std::string(name_of(claim.code)) + ": " + claim.sentence;
  if (c.asks(Asks::Simplify) && is_promised) {
    switch (is_end_of_removals(c, found)) {
      case ByTies::Lead:
        return;
      case ByTies::Undecided:
        return c.fail(
            Outcome::Undecided,
            fmt::format("{}; {} solids to which ties lead were compared, and this one may "
                        "be a further one",
                        sentence, with_separators(kMostTieStates)));
      case ByTies::DoNotLead:
        break;
    }
  }
  c.fail(Outcome::TooManyFacets, sentence, found);
}

// The least k such that the root of the square is at most 10^k.
int decade_of(const Rational& squared) {
  int k = 0;
  Rational power = 1;
  for (; power < squared; power *= 100) ++k;
  for (; power / 100 >= squared; power /= 100) --k;
  return k;
}

void measure(Case& c) {
  c.result.outside = c.verdict.outside;
  if (c.verdict.tightness) {
    c.result.relative_squared_hausdorff = c.relative(c.verdict.tightness->squared_hausdorff);
  }
  if (!c.result.outside || c.result.outside->points == 0) return;
  const NearestPoint nearest(*c.solid);
  for (const RationalPoint& corner : c.given.hull.vertices) {
    Watch(c.watch.stop).ask();
    const Rational squared = (nearest(corner) - corner).squaredNorm();
    if (squared != 0) ++c.result.outside_by_decade[decade_of(c.relative(squared))];
  }
}

// The solid that points or halfspaces stand for; nothing if there is none.
std::optional<Polytope> solid_of(const PointSet& points) {
  StageLog log;
  const auto made = make_hull(points, {.seed = kSeed, .check = false}, log);
  const auto* hull = std::get_if<Hull>(&made);
  return hull == nullptr ? std::nullopt : std::optional(to_polytope(*hull, points));
}

std::optional<Polytope> solid_of(const HalfspaceList& list) {
  if (list.impossible_row) return std::nullopt;
  StageLog log;
  auto made = make_polytope(list.halfspaces, kSeed, log);
  auto* polytope = std::get_if<Polytope>(&made);
  return polytope == nullptr ? std::nullopt : std::optional(std::move(*polytope));
}

std::optional<Polytope> solid_of(const Candidate& output) {
  if (const auto* mesh = std::get_if<Mesh>(&output)) return solid_of(mesh->points);
  const auto* list = std::get_if<HalfspaceList>(&output);
  return list == nullptr ? std::nullopt : solid_of(*list);
}

const char* sentence_of_success(Asks asks) {
  switch (asks) {
    case Asks::Hull:
      return "is the hull of the input";
    case Asks::Inner:
      return "is inside the hull of the input";
    case Asks::Enclosure:
    case Asks::Simplify:
      break;
  }
  return "encloses the input";
}

Conformance judge_output(const TestVector& vector, const Promise& promise, const Candidate& output,
                         const StageWatch& watch) {
  std::optional<Given> given = given_by(vector);
  if (!given)
    throw Error(ErrorCode::InvalidArgument, "a vector asks to enclose an input without volume");
  const auto* points = std::get_if<PointSet>(&vector.input);
  const Shape input =
      points != nullptr ? Shape(*points) : Shape(std::get<HalfspaceList>(vector.input).halfspaces);
  Promise promised = promise;
  promised.max_facets = most_facets(vector, promise);
  VerifyRequest request = request_of(promised);
  request.slack_ulps = kRoundingUlps;
  request.watch = watch;
  VerifyOutcome outcome = verify(input, output, request);
  Case c{.vector = vector,
         .promise = promise,
         .output = output,
         .given = std::move(*given),
         .verdict = std::get<Verdict>(std::move(outcome)),
         .solid = solid_of(output),
         .watch = watch,
         .result = {}};
  c.result.notes = c.verdict.notes;
  judge_claims(c);
  if (c.solid) {
    judge_volume(c);
    judge_facets(c);
    measure(c);
  }
  std::stable_sort(c.result.failures.begin(), c.result.failures.end(), is_graver);
  c.result.sentence = c.result.failures.empty() ? sentence_of_success(promise.asks)
                                                : c.result.failures.front().sentence;
  return c.result;
}

// ---- The run

// A program that runs out of memory may end in any way. It is recognised by its message, by the
// kernel's SIGKILL, or because it used most of its limit.
bool ran_out_of_memory(const ProgramRun& run, const ProgramLimits& limits) {
  if (run.end == ProgramEnd::Crashed && run.signal == SIGKILL) return true;
  if (limits.memory != 0 && run.peak_memory > limits.memory / 4 * 3) return true;
  for (const char* words : {"bad_alloc", "out of memory", "Out of memory", "MemoryError",
                            "Cannot allocate memory", "memory allocation of"}) {
    if (run.printed.find(words) != std::string::npos) return true;
  }
  return false;
}

Conformance failed(Outcome outcome, const std::string& sentence) {
  Conformance result;
  result.failures = {{outcome, sentence}};
  result.sentence = sentence;
  return result;
}

Conformance passed(const std::string& sentence) {
  Conformance result;
  result.sentence = sentence;
  return result;
}

// The end of the run, unless it is exit code 0.
std::optional<Conformance> judge_end(const ProgramRun& run, const ProgramLimits& limits,
                                     bool may_refuse) {
  if (run.end == ProgramEnd::NotStarted) return failed(Outcome::NotStarted, describe(run));
  if (run.end == ProgramEnd::TimedOut) return failed(Outcome::TimedOut, describe(run));
  if (run.succeeded()) return std::nullopt;
  if (ran_out_of_memory(run, limits)) {
    return failed(Outcome::OutOfMemory, describe(run) + ", out of memory");
  }
  if (run.end == ProgramEnd::Crashed) return failed(Outcome::Crashed, describe(run));
  if (may_refuse) return passed("refused with " + describe(run));
  return failed(Outcome::WrongExit, describe(run) + " for a usable input");
}

// A program that ended with exit code 0 where a refusal is expected.
Conformance judge_acceptance(const RefuseQuestion& question, const Promise& promise,
                             const std::optional<Candidate>& output, const StageWatch& watch) {
  if (promise.allow_flat && question.error == ErrorCode::NoInterior &&
      question.dimension.value_or(-1) >= 0) {
    return passed("accepted an input without volume, as the program may");
  }
  if (!question.points || !output) {
    return failed(Outcome::AcceptedUnusable, "exit code 0 for an input that must be refused");
  }
  TestVector sound;
  sound.input = *question.points;
  sound.question = SimplifyQuestion{.faces = kFacesOfRefusals,
                                    .facets = kFacesOfRefusals,
                                    .reached = true,
                                    .volume = {},
                                    .costs = {},
                                    .ties = {}};
  Conformance result = judge_output(sound, promise, *output, watch);
  if (result.failures.empty()) {
    result.sentence =
        "only the faces of the file are malformed, and for its points the output is "
        "right: " +
        result.sentence;
    return result;
  }
  return failed(Outcome::AcceptedUnusable,
                "exit code 0 for a file with malformed faces, and an output that is wrong for its "
                "points: " +
                    result.sentence);
}

}  // namespace

std::optional<Given> oracle::given_by(const TestVector& vector) {
  const auto* points = std::get_if<PointSet>(&vector.input);
  std::optional<Polytope> hull =
      points != nullptr ? solid_of(*points) : solid_of(std::get<HalfspaceList>(vector.input));
  if (!hull) return std::nullopt;
  return Given{points != nullptr ? *points : PointSet(hull->vertices), std::move(*hull)};
}

Conformance judge_run(const TestVector& vector, const Promise& promise, const ProgramRun& run,
                      const ProgramLimits& limits, const std::optional<Candidate>& output,
                      const StageWatch& watch) {
  const auto* refusal = std::get_if<RefuseQuestion>(&vector.question);
  if (const auto ended = judge_end(run, limits, refusal != nullptr)) return *ended;
  if (refusal != nullptr) return judge_acceptance(*refusal, promise, output, watch);
  if (!output) return failed(Outcome::MissingOutput, "exit code 0, but no output");
  return judge_output(vector, promise, *output, watch);
}

}  // namespace convexact
