// SPDX-License-Identifier: MIT
#include "lab/stress/child.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <csignal>

#include "convexact/error.hpp"
#include "io/json.hpp"

namespace convexact {
namespace {

// A busy machine may give a process only a small share of its time; beyond this factor, the process
// must be waiting.
constexpr double kWallPerProcessorTime = 20;

}  // namespace

std::unique_ptr<ChildProcess> start_child(const std::function<Json()>& work,
                                          const StressLimits& limits) {
  const double seconds = limits.seconds;
  const auto limited = [seconds, &work] {
    const auto whole = static_cast<rlim_t>(std::ceil(seconds));
    const rlimit processor{whole, whole + 1};
    (void)setrlimit(RLIMIT_CPU, &processor);
    return write_json(work());
  };
  return std::make_unique<ChildProcess>(
      limited, ProgramLimits{.seconds = kWallPerProcessorTime * seconds, .memory = limits.memory});
}

ChildEnd end_of(const ProgramRun& run, const ChildProcess& process, const StressLimits& limits) {
  ChildEnd end;
  end.memory = run.peak_memory;
  if (run.succeeded()) {
    end.answer = process.result();
    return end;
  }
  constexpr std::size_t kMost = 500;
  const std::string said =
      run.printed.substr(run.printed.size() - std::min(kMost, run.printed.size()));
  const bool has_crashed = run.end == ProgramEnd::Crashed;
  if (run.end == ProgramEnd::TimedOut || (has_crashed && run.signal == SIGXCPU)) {
    end.end = StressEnd::TimedOut;
    end.why = fmt::format("no end within {:g} s", limits.seconds);
  } else if (has_crashed) {
    const bool no_memory = said.find("annot allocate memory") != std::string::npos;
    end.end = no_memory ? StressEnd::OutOfMemory : StressEnd::Crashed;
    end.why = describe(run) + ": " + said;
  } else if (run.exit_code == exit_code(ErrorCode::Stopped)) {
    end.end = StressEnd::OutOfMemory;
    end.why = "out of memory";
  } else {
    end.end = StressEnd::Failed;
    end.why = said;
  }
  return end;
}

}  // namespace convexact
