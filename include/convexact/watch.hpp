// SPDX-License-Identifier: MIT
// watch.hpp - how a caller watches a long loop, and ends it.
#pragma once
#include <atomic>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>

#include "convexact/error.hpp"

namespace convexact {

/// How a caller watches a request while its stages run, and ends it.
struct StageWatch {
  /// Called as a stage begins.
  std::function<void(const std::string& stage)> begins = {};
  /// Called from time to time with the number of steps done and the number of all steps of a long
  /// stage.
  std::function<void(const std::string& stage, std::size_t done, std::size_t total)> progress = {};
  /// When it becomes true, the request ends with Error Stopped. A signal handler may set it.
  const std::atomic<bool>* stop = nullptr;
  /// When it becomes true, a search for the least volume ends with the best so far.
  const std::atomic<bool>* settle = nullptr;
};

/// A check at each step of a loop that may take seconds; without arguments it does nothing.
class Watch {
 public:
  using Progress = std::function<void(std::size_t done, std::size_t total)>;

  Watch(const std::atomic<bool>* stop = nullptr, Progress progress = {})
      : stop_(stop), progress_(std::move(progress)) {}

  /// @throws Error Stopped when the flag has become true.
  void ask() const {
    if (stop_ != nullptr && stop_->load(std::memory_order_relaxed)) {
      throw Error(ErrorCode::Stopped, "interrupted");
    }
  }
  /// Calls ask(), and from time to time reports the number of steps done and of all steps.
  void at(std::size_t done, std::size_t total) const {
    ask();
    if (progress_ && done % 256 == 0) progress_(done, total);
  }

 private:
  const std::atomic<bool>* stop_;
  Progress progress_;
};

}  // namespace convexact
