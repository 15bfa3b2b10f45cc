// SPDX-License-Identifier: MIT
// progress.hpp - the present activity of the program, on one line of a terminal.
#pragma once
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "cli/time_left.hpp"
#include "convexact/scene.hpp"

namespace convexact::cli {

/// One line of standard error, written anew five times a second by a separate thread, once the work
/// takes over a second; nothing if standard error is no terminal. The destructor removes the line.
class Progress {
 public:
  Progress();
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `done` of `total` steps of the activity that began with the first such call under that name.
  void operator()(const std::string& what, std::size_t done, std::size_t total);
  /// Removes the line for good.
  void clear();
  /// Stages show as they begin; an interrupt ends them. Must not outlive this.
  [[nodiscard]] StageWatch watch();
  /// The same for work that is no request, of one activity.
  [[nodiscard]] Watch watch(const std::string& what);

 private:
  using Clock = std::chrono::steady_clock;

  void begin(const std::string& what);
  void paint();
  std::string line();

  bool is_shown_;
  std::mutex mutex_;  // of the five below
  std::condition_variable changed_;
  bool is_over_ = false;
  std::string what_;
  Clock::time_point began_ = Clock::now();
  TimeLeft time_left_;
  std::atomic<std::size_t> done_ = 0, total_ = 0;  // set far more often than they are read
  std::thread painter_;
};

}  // namespace convexact::cli
