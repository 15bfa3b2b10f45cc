// SPDX-License-Identifier: MIT
// stage_log.hpp - runs stages and keeps their record.
#pragma once
#include <algorithm>
#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/scene.hpp"

namespace convexact {

/// Runs stages one after another and keeps the record.
class StageLog {
 public:
  StageLog() = default;
  explicit StageLog(StageWatch watch) : watch_(std::move(watch)) {}

  /// Runs `work` and returns what it returns. Work under a name that ran before is added to it.
  /// @throws Error Stopped when the watch ends the run.
  template <class Work>
  decltype(auto) run(const std::string& name, StageKind kind, Work&& work) {
    Watch(watch_.stop).ask();
    if (watch_.begins) watch_.begins(name);
    const Clock clock(*this, name, kind);
    return std::forward<Work>(work)();
  }
  template <class Work>
  decltype(auto) run(const std::string& name, Work&& work) {
    return run(name, StageKind::Compute, std::forward<Work>(work));
  }
  void skip(const std::string& name, const std::string& reason) {
    stages_.push_back({name, StageKind::Compute, 0, reason});
  }
  /// Adds another object's stages: times add up, and a stage that no object needed is listed once.
  void add(const std::vector<Stage>& stages) {
    for (const Stage& stage : stages) {
      if (stage.skipped.empty()) {
        stages_[index_of(stage.name, stage.kind)].seconds += stage.seconds;
      } else if (!mentions(stage.name)) {
        stages_.push_back(stage);
      }
    }
  }
  const std::vector<Stage>& stages() const { return stages_; }
  const StageWatch& watch() const { return watch_; }
  /// For the loops of one stage.
  Watch watch(const std::string& stage) const { return watch_.of(stage); }

 private:
  // Adds the time between its making and its end to a stage, also when the work throws.
  class Clock {
   public:
    Clock(StageLog& log, const std::string& name, StageKind kind)
        : stages_(log.stages_), index_(log.index_of(name, kind)) {}
    ~Clock() {
      const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start_;
      stages_[index_].seconds += spent.count();
    }
    Clock(const Clock&) = delete;
    Clock& operator=(const Clock&) = delete;

   private:
    std::vector<Stage>& stages_;
    std::size_t index_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  };

  std::size_t index_of(const std::string& name, StageKind kind) {
    for (std::size_t i = 0; i < stages_.size(); ++i) {
      if (stages_[i].name == name && stages_[i].skipped.empty()) return i;
    }
    stages_.push_back({name, kind, 0, {}});
    return stages_.size() - 1;
  }

  bool mentions(const std::string& name) const {
    return std::any_of(stages_.begin(), stages_.end(),
                       [&](const Stage& stage) { return stage.name == name; });
  }

  StageWatch watch_;
  std::vector<Stage> stages_;
};

}  // namespace convexact
