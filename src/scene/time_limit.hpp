// SPDX-License-Identifier: MIT
// time_limit.hpp - ends work after some seconds.
#pragma once
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

#include "convexact/error.hpp"

namespace convexact {

/// Sets a flag after some seconds, or soon after another flag is set, unless it is destroyed
/// before.
class TimeLimit {
 public:
  /// @param seconds  None: no limit. @param interrupt  May be null.
  TimeLimit(std::optional<double> seconds, const std::atomic<bool>* interrupt);
  ~TimeLimit();
  TimeLimit(const TimeLimit&) = delete;
  TimeLimit& operator=(const TimeLimit&) = delete;

  const std::atomic<bool>& is_over() const { return is_over_; }

 private:
  std::mutex mutex_;  // of has_ended_
  std::condition_variable ended_;
  bool has_ended_ = false;
  std::atomic<bool> is_over_ = false;
  std::thread waiter_;
};

/// "no verdict within the time limit of 2 s". @param sought  "verdict".
[[nodiscard]] Error beyond_time_limit(const char* sought, double seconds);

/// The result of `find`, which is given the watch that stops it.
/// @param interrupt  Another flag that stops it; null for none.
/// @throws Error Stopped, beyond_time_limit() if that is why, and what `find` throws.
template <class Find>
auto in_time(std::optional<double> seconds, const char* sought, const Find& find,
             const std::atomic<bool>* interrupt = nullptr) {
  if (!seconds) return find(StageWatch{.stop = interrupt});
  const TimeLimit limit(seconds, interrupt);
  try {
    return find(StageWatch{.stop = &limit.is_over()});
  } catch (const Error& error) {
    const bool is_interrupted = interrupt != nullptr && interrupt->load();
    if (error.code() != ErrorCode::Stopped || is_interrupted) throw;
    throw beyond_time_limit(sought, *seconds);
  }
}

}  // namespace convexact
