// SPDX-License-Identifier: MIT
#include "lab/stress/judge.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "convexact/measure.hpp"
#include "convexact/number.hpp"
#include "convexact/verify.hpp"
#include "number/precision.hpp"
#include "oracle/order/removal_cost.hpp"
#include "solid/solid.hpp"

namespace convexact {
namespace {

bool has_result(const EngineAnswer& answer) {
  return answer.end == StressEnd::Reached || answer.end == StressEnd::AllUnbounded;
}

std::size_t size_of(const Shape& shape) {
  if (const auto* points = std::get_if<PointSet>(&shape)) return points->size();
  return std::get<std::vector<Halfspace>>(shape).size();
}

void append(std::vector<std::string>& faults, const std::vector<std::string>& more) {
  faults.insert(faults.end(), more.begin(), more.end());
}

// Whether the run without a record, where there is one, made as many steps.
bool is_complete(const EngineAnswer& answer) {
  return answer.engine == Engine::Exact || answer.lean.size() == answer.run.steps.size();
}

StressRun begin_run(const StressInput& input, const EngineAnswer& answer) {
  StressRun run;
  run.family = input.family;
  run.parameter = input.parameter;
  run.value = input.value;
  run.seed = input.seed;
  run.engine = answer.engine;
  run.end = answer.end;
  run.why = answer.why;
  run.at_start = answer.run.halfspaces.size();
  run.steps = answer.run.steps.size();
  run.seconds = answer.seconds;
  run.memory = answer.memory;
  run.claim = answer.claim;
  return run;
}

bool is_of(Precision precision, const Rational& x) {
  return to_rational(round_to(precision, x, Rounding::Nearest)) == x;
}

// Whether every number is of the precision. Planes are read as primitive integers, so of their
// numbers only directions and offsets up to a common factor are left: this is tested for meshes
// only.
bool is_of_precision(const Candidate& candidate, Precision precision) {
  const auto* mesh = std::get_if<Mesh>(&candidate);
  if (mesh == nullptr) return true;
  for (const Point& p : mesh->points.doubles()) {
    for (const double x : p) {
      if (!is_of(precision, to_rational(x))) return false;
    }
  }
  return true;
}

void find_fault(const Verdict& verdict, StressStored& found) {
  for (const ClaimCode code :
       {ClaimCode::CandidateReadable, ClaimCode::CandidateFinite, ClaimCode::CandidateSolid,
        ClaimCode::CandidateBounded, ClaimCode::ContainsInput, ClaimCode::MeshClosed,
        ClaimCode::MeshOriented, ClaimCode::MeshConvex}) {
    const Claim& claim = verdict[code];
    if (claim.status != Status::Violated) continue;
    found.outcome = StressStored::Outcome::Wrong;
    found.why = fmt::format("{}: {}", name_of(code), claim.sentence);
    return;
  }
}

// Reads the bytes as any reader would and decides whether they are a bounded solid that holds every
// point of the input (or every vertex of the halfspaces' solid), all its numbers of the precision.
StressStored judge_stored(const Shape& shape, const StoredBytes& kept) {
  StressStored found = kept.stored;
  if (found.outcome == StressStored::Outcome::Refused) return found;
  const bool planes = found.form == StressStored::Form::Planes;
  const Candidate candidate = read_candidate_bytes(kept.bytes, planes ? "a.json" : "a.obj");
  VerifyRequest request;
  request.tightness = false;
  const VerifyOutcome outcome = verify(shape, candidate, request);
  const auto* verdict = std::get_if<Verdict>(&outcome);
  if (verdict == nullptr) {
    found.outcome = StressStored::Outcome::Wrong;
    found.why = "the oracle finds no volume in the input";
    return found;
  }
  find_fault(*verdict, found);
  if (verdict->outside) found.violations = verdict->outside->points;
  if (found.outcome == StressStored::Outcome::Holds &&
      !is_of_precision(candidate, found.precision)) {
    found.outcome = StressStored::Outcome::Wrong;
    found.why = "a coordinate is no number of the format";
  }
  return found;
}

// The engines' answers about a solid.
class Judge {
 public:
  Judge(const CenteredDual& solid, const Shape& shape, std::span<const EngineAnswer> answers)
      : solid_(solid), shape_(shape), answers_(answers) {}

  void judge(const EngineAnswer& answer, StressRun& run);

 private:
  void judge_promised_order(const EngineAnswer& answer, StressRun& run);
  void judge_lean_run(const EngineAnswer& answer, StressRun& run) const;
  void judge_search(const EngineAnswer& answer, StressRun& run) const;
  void compare_with_others(const EngineAnswer& answer, StressRun& run) const;
  const EngineAnswer* reference(std::size_t steps) const;
  void measure_volume_error(const EngineAnswer& answer, StressRun& run) const;

  const CenteredDual& solid_;
  const Shape& shape_;
  std::span<const EngineAnswer> answers_;
};

void Judge::judge(const EngineAnswer& answer, StressRun& run) {
  if (answer.run.halfspaces != solid_.dual.halfspaces) {
    run.faults.push_back("the facets of the hull are wrong");
    return;
  }
  if (!is_complete(answer)) {
    run.faults.push_back("with a record it makes another number of steps than without");
    return;
  }
  append(run.faults, faults_of_volume(solid_, answer));
  if (answer.engine == Engine::Float) {
    judge_float(answer, follow(solid_, answer), run);
  } else {
    judge_promised_order(answer, run);
    judge_lean_run(answer, run);
    if (answer.search) judge_search(answer, run);
  }
  compare_with_others(answer, run);
  measure_volume_error(answer, run);
  for (const StoredBytes& kept : answer.stored) {
    run.stored.push_back(judge_stored(shape_, kept));
    const StressStored& found = run.stored.back();
    if (found.outcome == StressStored::Outcome::Wrong) run.faults.push_back(found.why);
  }
}

void Judge::judge_promised_order(const EngineAnswer& answer, StressRun& run) {
  const TraceVerdict verdict = follow(solid_, answer);
  append(run.faults, faults_of_order(answer, verdict));
  append(run.faults, faults_by_definition(solid_, answer));
  double regret = 0;
  for (std::size_t s = 0; s < verdict.steps.size(); ++s) {
    const JudgedStep& step = verdict.steps[s];
    if (!run.first_difference && step.is_dearer()) run.first_difference = s;
    if (step.regret) regret = std::max(regret, step.regret->high_double());
  }
  run.regret = regret;
  run.other_ties = verdict.other_ties;
  run.undecided = verdict.undecided;
}

// The run without a record makes the same removals; its ranges hold the costs.
void Judge::judge_lean_run(const EngineAnswer& answer, StressRun& run) const {
  if (answer.engine == Engine::Exact) {
    run.cost_error = 0;
    return;
  }
  const std::vector<Step>& steps = answer.run.steps;
  const auto same_removal = [](const Step& a, const LeanStep& b) { return a.removed == b.removed; };
  if (!std::equal(steps.begin(), steps.end(), answer.lean.begin(), same_removal)) {
    run.faults.push_back("with a record it removes others than without");
    return;
  }
  double largest = 0;
  for (std::size_t s = 0; s < steps.size(); ++s) {
    const ReportedVolume& reported = answer.lean[s].cost;
    const Cost& cost = steps[s].cost.value();
    largest = std::max(largest, error_of_cost(reported, cost));
    if (!holds(reported, cost) || answer.lean[s].tied != steps[s].tie.size()) {
      run.faults.push_back(
          fmt::format("the range of the cost of step {} or its ties are wrong", s));
      break;
    }
  }
  run.cost_error = largest;
}

// Judges the search by its statements, and against the other engine's if that starts from the same
// halfspaces.
void Judge::judge_search(const EngineAnswer& answer, StressRun& run) const {
  append(run.faults, faults_of_search(solid_, answer));
  run.moves = answer.search->moves.size();
  const auto is_same = [](const Move& a, const Move& b) {
    return a.removed == b.removed && a.inserted == b.inserted;
  };
  for (const EngineAnswer& other : answers_) {
    if (!other.search || other.left != answer.left) continue;
    const std::vector<Move>&ours = answer.search->moves, &theirs = other.search->moves;
    if (!std::equal(ours.begin(), ours.end(), theirs.begin(), theirs.end(), is_same)) {
      run.faults.push_back("the searches of exact and filtered differ");
    }
  }
}

// Exact and filtered promise the same, step by step, as far as both went.
void Judge::compare_with_others(const EngineAnswer& answer, StressRun& run) const {
  for (const EngineAnswer& other : answers_) {
    if (!has_result(other) || other.engine == answer.engine) continue;
    const std::size_t common = std::min(answer.run.steps.size(), other.run.steps.size());
    if (other.engine == Engine::Exact) run.compared = common;
    if (other.engine == Engine::Float || answer.engine == Engine::Float) continue;
    for (std::size_t s = 0; s < common; ++s) {
      const Step &a = answer.run.steps[s], &b = other.run.steps[s];
      if (a.removed == b.removed && a.tie == b.tie && may_be_same(a.cost, b.cost)) continue;
      run.faults.push_back(fmt::format("exact and filtered differ at step {}", s));
      return;
    }
    const EngineAnswer& shorter = answer.run.steps.size() == common ? answer : other;
    if (shorter.end == StressEnd::AllUnbounded &&
        (answer.run.steps.size() != other.run.steps.size() || answer.end != other.end)) {
      run.faults.push_back("one of exact and filtered ends before the other");
    }
  }
}

// The answer whose removals count as right: the exact engine's or, if it was stopped before, the
// filtered engine's, which is judged too.
const EngineAnswer* Judge::reference(std::size_t steps) const {
  for (const Engine engine : {Engine::Exact, Engine::Filtered}) {
    for (const EngineAnswer& answer : answers_) {
      if (answer.engine == engine && has_result(answer) && answer.run.steps.size() >= steps &&
          is_valid_order(answer.run)) {
        return &answer;
      }
    }
  }
  return nullptr;
}

void Judge::measure_volume_error(const EngineAnswer& answer, StressRun& run) const {
  const EngineAnswer* right = reference(answer.run.steps.size());
  if (right == nullptr || !is_valid_order(answer.run)) return;
  run.volume_error = 0;
  const std::vector<Halfspace> left = left_after(right->run, run.steps);
  if (left == left_after(answer.run, run.steps)) return;
  const auto ours = intersect(answer.left, solid_.center), best = intersect(left, solid_.center);
  if (!ours || !best) {
    run.volume_error.reset();
    return;
  }
  const CostMeasure measure = answer.run.measure;
  if (measure == CostMeasure::Volume) {
    run.volume_error = to_double(Rational(volume(*ours) / volume(*best) - 1), Rounding::Nearest);
    return;
  }
  const Enclosure ratio = exact_measure(*ours, measure).enclose(kMeasureBits) /
                          exact_measure(*best, measure).enclose(kMeasureBits);
  run.volume_error = to_double(Rational(ratio.low() - 1), Rounding::Nearest);
}

}  // namespace

std::vector<StressRun> judge_answers(const StressInput& input, const Shape& shape,
                                     std::span<const EngineAnswer> answers) {
  StageLog log;
  const SolidOutcome outcome = make_solid(shape, {.seed = input.seed + 1}, log);
  const Solid* solid = std::get_if<Solid>(&outcome);
  std::vector<StressRun> runs;
  for (const EngineAnswer& answer : answers) {
    StressRun& run = runs.emplace_back(begin_run(input, answer));
    run.input = size_of(shape);
    if (!has_result(answer) && answer.end != StressEnd::NoVolume) {
      run.faults.push_back(answer.why);
    } else if ((answer.end == StressEnd::NoVolume) != (solid == nullptr)) {
      run.faults.push_back(solid == nullptr ? "finds a solid where there is none"
                                            : "finds no solid where there is one");
    } else if (solid != nullptr) {
      const CenteredDual judged{solid->dual, interior_point_of(*solid)};
      Judge(judged, shape, answers).judge(answer, run);
    }
  }
  return runs;
}

std::vector<StressRun> unjudged(const StressInput& input, std::span<const EngineAnswer> answers,
                                const std::string& why) {
  std::vector<StressRun> runs;
  for (const EngineAnswer& answer : answers) {
    StressRun& run = runs.emplace_back(begin_run(input, answer));
    run.faults.push_back(has_result(answer) ? why : answer.why);
  }
  return runs;
}

}  // namespace convexact
