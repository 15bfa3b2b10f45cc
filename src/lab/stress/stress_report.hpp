// SPDX-License-Identifier: MIT
// stress_report.hpp - the run of each engine on each hard input and the findings of the judge, for
// people and for machines.
#pragma once
#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "convexact/number.hpp"
#include "convexact/simplify.hpp"
#include "io/json_document.hpp"
#include "io/names.hpp"

namespace convexact {

/// How an engine's run on a hard input ended.
enum class StressEnd {
  Reached,       ///< With as many halfspaces as were wanted.
  AllUnbounded,  ///< Above that: every further removal is unbounded (or may be, as the float engine
                 ///< then states).
  NoVolume,      ///< The input encloses no volume, and the engine's pipeline says why.
  Failed,        ///< With an error. The only documented one is Unrepresentable, see StressStored.
  Crashed,       ///< A signal ended it.
  TimedOut,
  OutOfMemory,
};

inline constexpr auto kStressEndNames =
    name_table<StressEnd>({{StressEnd::Reached, "reached"},
                           {StressEnd::AllUnbounded, "all-unbounded"},
                           {StressEnd::NoVolume, "no-volume"},
                           {StressEnd::Failed, "failed"},
                           {StressEnd::Crashed, "crashed"},
                           {StressEnd::TimedOut, "timed-out"},
                           {StressEnd::OutOfMemory, "out-of-memory"}});
inline const char* name_of(StressEnd end) { return name_in(kStressEndNames, end); }

/// One way of writing a result, judged on the bytes, read back.
struct StressStored {
  enum class Form { Planes, Mesh };
  enum class Outcome {
    Holds,    ///< A bounded solid that holds every input point, exactly.
    Refused,  ///< Error Unrepresentable: this format cannot hold the solid. Documented.
    Wrong,    ///< It is no bounded solid, or misses input points.
  };
  Form form = Form::Planes;
  Precision precision = Precision::Binary64;
  bool whole = false;  ///< The input's hull itself, nothing removed.
  Outcome outcome = Outcome::Refused;
  std::size_t violations = 0;  ///< Input points outside of it.
  double push = 0;             ///< Relative to the diameter, see Growth; 0 if refused.
  double volume_ratio = 1;     ///< Likewise.
  std::string why;             ///< If it does not hold: why not.
};

/// The float engine's bounds on its errors (FloatBound).
struct StressClaim {
  double cost = 0;           ///< Largest relative error of a reported cost.
  double regret = 0;         ///< Each removal costs at most (1 + regret) times the cheapest.
  std::size_t doubtful = 0;  ///< Steps for which these two are not proven.
  bool end_proven = true;    ///< Whether exact numbers would have ended the run there, too.
  bool vouched = false;      ///< Whether it vouches for the run: no doubt of either kind.
};

/// One engine on one input. Relative errors are rounded up to doubles; none where not judged.
struct StressRun {
  std::string family;     ///< Of the sweep, see `convexact stress --list`.
  std::string parameter;  ///< The parameter that is varied: "aspect", "points", "exponent", ...
  double value = 0;       ///< Its value.
  std::uint64_t seed = 1;
  Engine engine = Engine::Exact;

  StressEnd end = StressEnd::Failed;
  std::string why;           ///< Of an end with an error, and of NoVolume.
  std::size_t input = 0;     ///< Points, or rows of halfspaces.
  std::size_t at_start = 0;  ///< Halfspaces of the solid.
  std::size_t steps = 0;     ///< Halfspaces removed.
  std::size_t compared = 0;  ///< Steps that were compared with the exact engine's.
  double seconds = 0;        ///< Processor time of the pipeline, to the exact result.
  std::uint64_t memory = 0;  ///< Peak of the process, bytes.

  /// Measure of the run after `steps` over that of the exact engine's run after as many steps,
  /// minus 1.
  std::optional<double> volume_error;
  /// Largest relative error of a reported cost.
  std::optional<double> cost_error;
  /// First step that removes none of the cheapest, in the state that this run had reached.
  std::optional<std::size_t> first_difference;
  std::size_t other_ties = 0;  ///< Steps that remove another one of exactly tied halfspaces.
  std::size_t undecided = 0;   ///< Steps by mean width that the judge neither accepts nor refutes.
  std::optional<std::size_t> moves;  ///< Of a search after the removals.
  std::optional<double> regret;  ///< Largest (cost - minimum) / minimum of a step; may be infinite.
  std::optional<StressClaim> claim;  ///< Of the float engine.

  /// Planes and mesh in binary64 and binary32, in that order; empty if there is no result. For the
  /// filtered engine's run, the input's hull in the same four forms follows.
  std::vector<StressStored> stored;
  /// The faults, a sentence each. Empty: passed.
  std::vector<std::string> faults;

  bool passes() const { return faults.empty(); }
};

struct StressReport {
  std::vector<StressRun> runs;             ///< By family and value; for one input by engine.
  double seconds = 0;                      ///< Wall time of the sweep.
  CostMeasure cost = CostMeasure::Volume;  ///< Of all runs.

  bool passes() const {
    return std::all_of(runs.begin(), runs.end(), [](const StressRun& r) { return r.passes(); });
  }
};

/// Everything: docs/schema/stress.schema.json. Infinite numbers are the string "infinite".
[[nodiscard]] Json stress_json(const StressReport& report);
/// One of its runs.
[[nodiscard]] Json stress_run_json(const StressRun& run);

/// The runs in the text of such a report.
[[nodiscard]] std::vector<StressRun> stress_runs_in(std::string_view text);

/// One line for each family and engine with the worst of its runs, then the faults; at most 100
/// columns except for the faults' sentences.
[[nodiscard]] std::string stress_table(const StressReport& report);
/// One line for each run, then the faults.
[[nodiscard]] std::string stress_case_table(const StressReport& report);

}  // namespace convexact
