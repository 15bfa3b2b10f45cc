// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lab/stress/stress_report.hpp"
#include "simplify/run_names.hpp"

namespace convexact {
namespace {

// The worst of some runs. Errors are unset where nothing was judged.
struct Worst {
  std::size_t runs = 0, faulty = 0, early = 0, no_volume = 0, other_order = 0;
  std::size_t claims = 0, vouched = 0, stored = 0, refused = 0, missed = 0;
  std::optional<double> cost_error, regret, volume_error;
  double push = 0, seconds = 0;
};

void raise(std::optional<double>& worst, const std::optional<double>& x) {
  if (x && (!worst || std::abs(*worst) < std::abs(*x))) worst = x;
}

void add(Worst& worst, const StressRun& run) {
  ++worst.runs;
  worst.faulty += !run.passes();
  worst.early += run.end == StressEnd::AllUnbounded;
  worst.no_volume += run.end == StressEnd::NoVolume;
  worst.other_order += run.first_difference.has_value();
  worst.claims += run.claim.has_value();
  worst.vouched += run.claim && run.claim->vouched;
  raise(worst.cost_error, run.cost_error);
  raise(worst.regret, run.regret);
  raise(worst.volume_error, run.volume_error);
  worst.seconds = std::max(worst.seconds, run.seconds);
  for (const StressStored& stored : run.stored) {
    ++worst.stored;
    worst.refused += stored.outcome == StressStored::Outcome::Refused;
    worst.missed += stored.violations;
    if (stored.precision == Precision::Binary64) worst.push = std::max(worst.push, stored.push);
  }
}

std::string error_text(const std::optional<double>& x) {
  if (!x) return "-";
  if (*x == 0) return "0";
  return std::isfinite(*x) ? fmt::format("{:.0e}", *x) : "inf";
}

constexpr int kOfMany = 7, kOfOne = 3;  // width of "110/320", "1/1"

std::string numbers_of(const Worst& w, int vouched_width) {
  const std::string vouched = w.claims == 0 ? "-" : fmt::format("{}/{}", w.vouched, w.claims);
  return fmt::format(" {:>5} {:>6} {:>6} {:>{}} {:>6} {:>4} {:>5} {:>5} {}\n",
                     error_text(w.cost_error), error_text(w.regret), error_text(w.volume_error),
                     vouched, vouched_width, w.refused, w.missed, error_text(w.push),
                     error_text(w.seconds), w.faulty == 0 ? "ok" : "NO");
}

std::string header_of_numbers(int vouched_width) {
  return fmt::format(" {:>5} {:>6} {:>6} {:>{}} {:>6} {:>4} {:>5} {:>5}\n", "cost", "regret",
                     "volume", vouched_width == kOfOne ? "own" : "vouched", vouched_width, "refuse",
                     "miss", "push", "secs");
}

std::string label_of(const StressRun& run) {
  if (run.parameter.empty()) return run.family;
  return fmt::format("{} {}={:.3g}", run.family, run.parameter, run.value);
}

// Short enough for a column, like the ends.
std::string short_label(const StressRun& run) {
  if (run.parameter.empty()) return run.family;
  return fmt::format("{} {:.3g}", run.family, run.value);
}

const char* short_end(StressEnd end) {
  switch (end) {
    case StressEnd::AllUnbounded:
      return "stuck";
    case StressEnd::OutOfMemory:
      return "memory";
    default:
      return name_of(end);
  }
}

std::string faults_of(const StressReport& report) {
  std::string text;
  for (const StressRun& run : report.runs) {
    for (const std::string& fault : run.faults) {
      text += fmt::format("\n{} (seed {}), {}: {}", label_of(run), run.seed, name_of(run.engine),
                          fault);
    }
  }
  return text.empty() ? text : text + "\n";
}

std::string total_of(const StressReport& report) {
  const auto faulty = std::count_if(report.runs.begin(), report.runs.end(),
                                    [](const StressRun& run) { return !run.passes(); });
  return fmt::format("\n{} runs in {:.1f} s, {}\n", report.runs.size(), report.seconds,
                     faulty == 0 ? "all as promised" : fmt::format("{} WRONG", faulty));
}

}  // namespace

std::string stress_table(const StressReport& report) {
  std::string text =
      fmt::format("{:<20} {:<8} {:>4} {:>5} {:>4}", "family", "engine", "runs", "early", "diff") +
      header_of_numbers(kOfMany);
  std::vector<const StressRun*> rest;
  for (const StressRun& run : report.runs) rest.push_back(&run);
  while (!rest.empty()) {
    const StressRun& first = *rest.front();
    const auto other = std::stable_partition(rest.begin(), rest.end(), [&](const StressRun* run) {
      return run->family == first.family && run->engine == first.engine;
    });
    Worst worst;
    std::for_each(rest.begin(), other, [&](const StressRun* run) { add(worst, *run); });
    text += fmt::format("{:<20} {:<8} {:>4} {:>5} {:>4}", first.family, name_of(first.engine),
                        worst.runs, worst.early, worst.other_order) +
            numbers_of(worst, kOfMany);
    rest.erase(rest.begin(), other);
  }
  return text + faults_of(report) + total_of(report);
}

std::string stress_case_table(const StressReport& report) {
  std::string text = fmt::format("{:<24} {:<8} {:<9} {:>5}", "input", "engine", "end", "steps") +
                     header_of_numbers(kOfOne);
  for (const StressRun& run : report.runs) {
    Worst worst;
    add(worst, run);
    text += fmt::format("{:<24} {:<8} {:<9} {:>5}", short_label(run), name_of(run.engine),
                        short_end(run.end), run.steps) +
            numbers_of(worst, kOfOne);
  }
  return text + faults_of(report) + total_of(report);
}

}  // namespace convexact
