// SPDX-License-Identifier: MIT
// timing.hpp - repeated measurements of time: their number, their budget, their spread, and the
// power law behind a series of them.
#pragma once
#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/run.hpp"

namespace convexact {

/// The middle value, or half way between the two middle ones. Precondition: at least one value.
[[nodiscard]] double median(std::vector<double> values);

/// Repeated measurements of one quantity.
struct Spread {
  double least = 0, median = 0, most = 0;
  std::size_t repetitions = 0;
};

/// Precondition: at least one value.
[[nodiscard]] Spread spread_of(const std::vector<double>& values);

/// y = factor x^exponent.
struct PowerLaw {
  double exponent, factor;
  double standard_error;  ///< Of the exponent, from the residuals; n - 2 degrees
                          ///< of freedom.
};

/// The straight line of least squares through (log x, log y). None for fewer than three different
/// x.
/// @param points  (x, y), all positive.
/// @par Source    [DraperSmith1998, sec. 1.2 to 1.4]
[[nodiscard]] std::optional<PowerLaw> fit_power_law(
    std::span<const std::pair<double, double>> points);

struct Effort {
  std::size_t repetitions = 5;  ///< Of every timed run; >= 1.
  /// Seconds for the repetitions of one run: none begins after that, and a first run that takes
  /// longer is given up.
  double budget = 60;
  std::uint64_t seed = 1;
  /// Called with the name of the present measurement.
  std::function<void(const std::string& what)> progress = {};
  const std::atomic<bool>* stop = nullptr;  ///< When it becomes true: Error Stopped.
};

class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Stops engines when the time is up, or on an interrupt.
class Deadline {
 public:
  explicit Deadline(const Effort& effort) : effort_(effort) {}
  Deadline(const Deadline&) = delete;

  bool has_passed() const { return watch_.seconds() > effort_.budget; }
  bool is_interrupted() const { return effort_.stop != nullptr && *effort_.stop; }
  /// Makes a request end with Error Stopped soon after the time is up.
  StageWatch watch() {
    return {.progress = [this](const std::string&, std::size_t done,
                               std::size_t) { look_at_the_clock(done); },
            .stop = &ring_};
  }
  /// The same for an engine. @param told  Called after each removal as well.
  Watch engine_watch(Watch::Progress told = {}) {
    return {&ring_, [this, told = std::move(told)](std::size_t done, std::size_t total) {
              if (told) told(done, total);
              look_at_the_clock(done);
            }};
  }

 private:
  // The clock is read so rarely that the times of the quickest engine do not show it.
  void look_at_the_clock(std::size_t step) {
    if (step % 64 == 0 && (has_passed() || is_interrupted())) ring_ = true;
  }

  const Effort& effort_;
  Stopwatch watch_;
  std::atomic<bool> ring_ = false;
};

/// Times `work(deadline)` repeatedly, as the effort allows. None if even the first run did not
/// end in time. @throws Error Stopped after an interrupt; otherwise as work.
template <class Work>
std::optional<Spread> time_repeatedly(const Effort& effort, Work&& work) {
  std::vector<double> seconds;
  Deadline deadline(effort);
  do {
    if (deadline.is_interrupted()) throw Error(ErrorCode::Stopped, "interrupted");
    const Stopwatch watch;
    try {
      work(deadline);
    } catch (const Error& error) {
      if (error.code() != ErrorCode::Stopped || deadline.is_interrupted()) throw;
      break;
    }
    seconds.push_back(watch.seconds());
  } while (seconds.size() < effort.repetitions && !deadline.has_passed());
  if (seconds.empty()) return std::nullopt;
  return spread_of(seconds);
}

}  // namespace convexact
