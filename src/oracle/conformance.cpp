// SPDX-License-Identifier: MIT
#include <algorithm>
#include <csignal>
#include <tuple>

#include "convexact/conform.hpp"
#include "oracle/conformance_judge.hpp"
#include "oracle/profiles.hpp"

namespace convexact {
namespace {

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
    return failed(Outcome::OutOfMemory, describe(run) + ", for want of memory");
  }
  if (run.end == ProgramEnd::Crashed) return failed(Outcome::Crashed, describe(run));
  if (may_refuse) return passed("refused with " + describe(run));
  return failed(Outcome::WrongExit, describe(run) + " for a usable input");
}

// A program that ended with exit code 0 where a refusal is expected.
Conformance judge_acceptance(const RefuseQuestion& question, const Promise& promise,
                             const std::optional<Candidate>& output,
                             const std::atomic<bool>* stop) {
  if (promise.allow_flat && question.error == ErrorCode::NoInterior &&
      question.dimension.value_or(-1) >= 0) {
    return passed("accepted an input without volume, which the program may");
  }
  if (!question.points || !output) {
    return failed(Outcome::AcceptedUnusable, "exit code 0 for an input that must be refused");
  }
  TestVector sound;
  sound.input = *question.points;
  sound.question = SimplifyQuestion{kFacesOfRefusals, kFacesOfRefusals, true, {}, {}, {}};
  Conformance result = oracle::judge_output(sound, promise, *output, stop);
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

const char* name_of(Asks asks) { return name_in(kAsksNames, asks); }

const char* name_of(NotRun reason) {
  constexpr auto kNames = name_table<NotRun>({{NotRun::AsksOtherwise, "asks-otherwise"},
                                              {NotRun::OtherFormat, "other-format"},
                                              {NotRun::OtherNumbers, "other-numbers"},
                                              {NotRun::BeyondTheProgram, "beyond-the-program"}});
  static_assert(kNames.size() == kAllNotRun.size());
  return name_in(kNames, reason);
}

const char* name_of(Outcome outcome) {
  constexpr auto kNames =
      name_table<Outcome>({{Outcome::NotStarted, "not-started"},
                           {Outcome::TimedOut, "timed-out"},
                           {Outcome::OutOfMemory, "out-of-memory"},
                           {Outcome::Crashed, "crashed"},
                           {Outcome::AcceptedUnusable, "accepted-unusable"},
                           {Outcome::WrongExit, "wrong-exit"},
                           {Outcome::MissingOutput, "missing-output"},
                           {Outcome::UnreadableOutput, "unreadable-output"},
                           {Outcome::NoSolid, "no-solid"},
                           {Outcome::NotEnclosing, "not-enclosing"},
                           {Outcome::NotInside, "not-inside"},
                           {Outcome::TooLoose, "too-loose"},
                           {Outcome::BrokenMesh, "broken-mesh"},
                           {Outcome::NotConvex, "not-convex"},
                           {Outcome::NotTheHull, "not-the-hull"},
                           {Outcome::TooManyFacets, "too-many-facets"},
                           {Outcome::TooManyVertices, "too-many-vertices"},
                           {Outcome::TooManyFacetVertices, "too-many-facet-vertices"},
                           {Outcome::Passed, "passed"}});
  static_assert(kNames.size() == kAllOutcomes.size());
  return name_in(kNames, outcome);
}

bool is_graver(const Failure& a, const Failure& b) {
  return std::tie(a.is_rounding, a.outcome, b.size) < std::tie(b.is_rounding, b.outcome, a.size);
}

Conformance judge_run(const TestVector& vector, const Promise& promise, const ProgramRun& run,
                      const ProgramLimits& limits, const std::optional<Candidate>& output,
                      const std::atomic<bool>* stop) {
  const auto* refusal = std::get_if<RefuseQuestion>(&vector.question);
  if (const auto ended = judge_end(run, limits, refusal != nullptr)) return *ended;
  if (refusal != nullptr) return judge_acceptance(*refusal, promise, output, stop);
  if (!output) return failed(Outcome::MissingOutput, "exit code 0, but no output");
  return oracle::judge_output(vector, promise, *output, stop);
}

}  // namespace convexact
