// SPDX-License-Identifier: MIT
#include "scene/time_limit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace convexact {

TimeLimit::TimeLimit(std::optional<double> seconds, const std::atomic<bool>* interrupt) {
  if (!seconds) return;
  waiter_ = std::thread([this, seconds = *seconds, interrupt] {
    using Clock = std::chrono::steady_clock;
    using Seconds = std::chrono::duration<double>;
    constexpr Seconds kBetweenLooks(0.05);
    const Clock::time_point begin = Clock::now();
    std::unique_lock lock(mutex_);
    while (!has_ended_ && !is_over_) {
      const Seconds left = Seconds(seconds) - (Clock::now() - begin);
      const bool is_interrupted = interrupt != nullptr && interrupt->load();
      is_over_ = left <= Seconds(0) || is_interrupted;
      if (is_over_) return;
      ended_.wait_for(lock, interrupt != nullptr ? std::min(left, kBetweenLooks) : left);
    }
  });
}

TimeLimit::~TimeLimit() {
  if (!waiter_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    has_ended_ = true;
  }
  ended_.notify_one();
  waiter_.join();
}

Error beyond_time_limit(const char* sought, double seconds) {
  return {ErrorCode::Stopped, fmt::format("no {} within the time limit of {} s", sought, seconds)};
}

}  // namespace convexact
