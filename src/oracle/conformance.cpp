// SPDX-License-Identifier: MIT
#include "convexact/oracle/conformance.hpp"

#include <fmt/format.h>

#include <csignal>

#include "convexact/lp/feasibility.hpp"
#include "convexact/number/rounding.hpp"
#include "convexact/oracle/verify.hpp"

namespace convexact {
namespace {

// A program that runs out of memory ends as it likes. It is told by what it says, by the kernel's
// SIGKILL, or by having used most of what it was allowed.
bool ran_out_of_memory(const ProgramRun& run, const ProgramLimits& limits) {
  if (run.end == ProgramEnd::Crashed && run.signal == SIGKILL) return true;
  if (limits.memory != 0 && run.peak_memory > limits.memory / 4 * 3) return true;
  for (const char* words : {"bad_alloc", "out of memory", "Out of memory", "MemoryError",
                            "Cannot allocate memory", "memory allocation of"}) {
    if (run.printed.find(words) != std::string::npos) return true;
  }
  return false;
}

// The end of the run, unless it is exit code 0.
std::optional<Conformance> judge_end(const ProgramRun& run, const ProgramLimits& limits,
                                     bool may_refuse) {
  switch (run.end) {
    case ProgramEnd::NotStarted:
      return Conformance{Outcome::NotStarted, describe(run), {}};
    case ProgramEnd::TimedOut:
      return Conformance{Outcome::TimedOut, describe(run), {}};
    case ProgramEnd::Crashed:
    case ProgramEnd::Exited:
      break;
  }
  if (run.succeeded()) return std::nullopt;
  if (ran_out_of_memory(run, limits)) {
    return Conformance{Outcome::OutOfMemory, describe(run) + ", for want of memory", {}};
  }
  if (run.end == ProgramEnd::Crashed) return Conformance{Outcome::Crashed, describe(run), {}};
  if (may_refuse) return Conformance{Outcome::Passed, "refused with " + describe(run), {}};
  return Conformance{Outcome::WrongExit, describe(run) + " for a usable input", {}};
}

std::optional<double> tightness_of(const Verdict& verdict, const SimplifyQuestion& question) {
  if (!verdict.tightness || !question.volume) return std::nullopt;
  Rational hull = *question.volume;
  for (const Rational& cost : question.costs) hull -= cost;
  const Enclosure& ratio = verdict.tightness->volume_ratio;
  return to_double((ratio.low() + ratio.high()) / 2 * hull / *question.volume, Rounding::Nearest);
}

// Whether no facet can go: what the others bound reaches to infinity, for each of them.
bool is_stuck(const std::vector<Halfspace>& planes) {
  for (std::size_t gone = 0; gone < planes.size(); ++gone) {
    std::vector<Halfspace> others = planes;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(gone));
    if (std::holds_alternative<BoundedProof>(find_recession(others))) return false;
  }
  return true;
}

// The solid that an output stands for; it is known to be one. Its vertices may be beyond doubles.
Polytope polytope_of(const Candidate& output) {
  constexpr std::uint64_t kSeed = 1;
  StageLog log;
  if (const auto* mesh = std::get_if<Mesh>(&output)) {
    return to_polytope(std::get<Hull>(make_hull(mesh->points, kSeed, false, log)), mesh->points);
  }
  const auto& list = std::get<HalfspaceList>(output);
  return std::get<Polytope>(make_polytope(list.halfspaces, kSeed, log));
}

bool has_too_many_facets(const Verdict& verdict, std::size_t wanted, const Candidate& output) {
  const std::size_t facets = verdict.size.facets.value_or(0);
  if (verdict.size.facets_as_meant.value_or(facets) <= wanted) return false;
  return !is_stuck(polytope_of(output).planes);
}

Conformance judge_output(const Shape& input, const SimplifyQuestion& question,
                         const Candidate& output, const Tolerance& tolerance) {
  VerifyRequest request;
  request.tolerance = tolerance;
  request.slack_ulps = kRoundingUlps;
  StageLog log;
  const VerifyOutcome outcome = verify(input, output, request, log);
  const auto* verdict = std::get_if<Verdict>(&outcome);
  if (verdict == nullptr) {
    throw Error(ErrorCode::InvalidArgument, "a vector asks to simplify what has no volume");
  }
  Conformance result{Outcome::Passed, "encloses the input", tightness_of(*verdict, question)};
  constexpr std::pair<ClaimCode, Outcome> kNeeded[] = {
      {ClaimCode::CandidateReadable, Outcome::UnreadableOutput},
      {ClaimCode::CandidateFinite, Outcome::UnreadableOutput},
      {ClaimCode::CandidateSolid, Outcome::NoSolid},
      {ClaimCode::CandidateBounded, Outcome::NoSolid},
      {ClaimCode::ContainsInput, Outcome::NotEnclosing},
      {ClaimCode::MeshClosed, Outcome::BrokenMesh},
      {ClaimCode::MeshOriented, Outcome::BrokenMesh}};
  for (const auto& [code, failure] : kNeeded) {
    const Claim& claim = (*verdict)[code];
    if (claim.status != Status::Violated) continue;
    result.outcome = failure;
    result.sentence = std::string(name_of(code)) + ": " + claim.sentence;
    return result;
  }
  const std::size_t wanted = std::max(question.faces, question.facets);
  if (has_too_many_facets(*verdict, wanted, output)) {
    result.outcome = Outcome::TooManyFacets;
    result.sentence = fmt::format("{} facets and {} vertices, {} facets asked for",
                                  *verdict->size.facets, *verdict->size.vertices, wanted);
  }
  return result;
}

}  // namespace

const char* name_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::NotStarted:
      return "not-started";
    case Outcome::TimedOut:
      return "timed-out";
    case Outcome::OutOfMemory:
      return "out-of-memory";
    case Outcome::Crashed:
      return "crashed";
    case Outcome::AcceptedUnusable:
      return "accepted-unusable";
    case Outcome::WrongExit:
      return "wrong-exit";
    case Outcome::MissingOutput:
      return "missing-output";
    case Outcome::UnreadableOutput:
      return "unreadable-output";
    case Outcome::NoSolid:
      return "no-solid";
    case Outcome::NotEnclosing:
      return "not-enclosing";
    case Outcome::BrokenMesh:
      return "broken-mesh";
    case Outcome::TooManyFacets:
      return "too-many-facets";
    case Outcome::Passed:
      break;
  }
  return "passed";
}

Conformance judge_run(const TestVector& vector, const ProgramRun& run, const ProgramLimits& limits,
                      const std::optional<Candidate>& output, const Tolerance& tolerance) {
  const auto* question = std::get_if<SimplifyQuestion>(&vector.question);
  if (const auto ended = judge_end(run, limits, question == nullptr)) return *ended;
  if (question == nullptr) {
    return {Outcome::AcceptedUnusable, "exit code 0 for an input that is to be refused", {}};
  }
  if (!output) return {Outcome::MissingOutput, "exit code 0, but no output", {}};
  const auto* points = std::get_if<PointSet>(&vector.input);
  const Shape input =
      points != nullptr ? Shape(*points) : Shape(std::get<HalfspaceList>(vector.input).halfspaces);
  return judge_output(input, *question, *output, tolerance);
}

}  // namespace convexact
