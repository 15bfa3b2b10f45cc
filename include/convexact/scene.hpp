// SPDX-License-Identifier: MIT
// scene.hpp - from a shape to its solid, in stages that are timed or skipped.
#pragma once
#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "convexact/dual.hpp"
#include "convexact/error.hpp"
#include "convexact/halfspace.hpp"
#include "convexact/hull.hpp"
#include "convexact/linear_program.hpp"
#include "convexact/number.hpp"
#include "convexact/stored.hpp"

namespace convexact {

enum class StageKind { Io, Compute };

struct Stage {
  std::string name;
  StageKind kind = StageKind::Compute;
  double seconds = 0;   ///< Wall time; 0 for a skipped stage.
  std::string skipped;  ///< Why the stage was not needed; empty if it ran.
};

/// Who looks on while stages run, and may end them.
struct StageWatch {
  std::function<void(const std::string& name)> begins;  ///< Called as a stage begins.
  const std::atomic<bool>* stop = nullptr;  ///< When it becomes true, the next stage does not
                                            ///< begin; long ones look at it, too.
};

/// Runs stages one after another and keeps the record.
class StageLog {
 public:
  StageLog() = default;
  explicit StageLog(StageWatch watch) : watch_(std::move(watch)) {}

  /// Runs `work` and returns what it returns. Work under a name that ran before is added to it.
  /// @throws Error Stopped if the watch says so.
  template <class Work>
  decltype(auto) run(const std::string& name, StageKind kind, Work&& work) {
    if (watch_.stop != nullptr && *watch_.stop) throw Error(ErrorCode::Stopped, "interrupted");
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
  /// Adds another object's stages: times add up, and what was not needed for any is said once.
  void add(const StageLog& other) {
    for (const Stage& stage : other.stages_) {
      if (stage.skipped.empty()) {
        stages_[index_of(stage.name, stage.kind)].seconds += stage.seconds;
      } else if (!mentions(stage.name)) {
        stages_.push_back(stage);
      }
    }
  }
  const std::vector<Stage>& stages() const { return stages_; }
  const StageWatch& watch() const { return watch_; }

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

/// Points that span no volume, or halfspaces whose intersection is empty, flat or unbounded.
using NotSolid = std::variant<FlatInput, EmptyProof, FlatProof, RecessionRay>;

/// A proof about the halfspaces of a list, told of its rows as typed: the multipliers are theirs,
/// so that y'N = 0 holds with the numbers of the file, and rows count from 0, dropped ones
/// included.
/// @param rows  Of the list; without any, the proof stays as it is.
[[nodiscard]] NotSolid of_typed_rows(NotSolid reason, const TypedRows& rows);

/// One sentence for people: what the input is, and what the proof consists of. Points and
/// halfspaces count from 0.
[[nodiscard]] std::string describe(const NotSolid& reason);

/// What is to be enclosed: the hull of points, or an intersection of halfspaces.
using Shape = std::variant<PointSet, std::vector<Halfspace>>;

/// A shape that has a volume, with the stages that showed it.
struct Solid {
  Polytope polytope;
  DualHull dual;
  /// The points that a result must hold: the input's, or the vertices of the input's polytope.
  PointSet points;
  std::vector<PointId> extreme;               ///< Of `points`: those whose hull holds the rest.
  std::size_t input_points = 0;               ///< 0 where the input is halfspaces.
  std::vector<RedundantHalfspace> redundant;  ///< Of halfspace input.
  HullCertificate certificate;                ///< Of point input.
  /// Strictly inside; known beforehand only where the way to the dual needed it.
  std::optional<RationalPoint> interior;
};

using SolidOutcome = std::variant<Solid, NotSolid>;

/// The hull of points with its certificate checked if asked for, or why there is none.
/// @throws Error Internal if a certificate fails.
[[nodiscard]] std::variant<Hull, NotSolid> make_hull(const PointSet& points, std::uint64_t seed,
                                                     bool check, StageLog& log);

/// The intersection of halfspaces, whose vertices may be beyond the largest double, or why it is no
/// bounded solid. @throws Error Internal if a certificate fails.
[[nodiscard]] std::variant<Polytope, NotSolid> make_polytope(std::span<const Halfspace> halfspaces,
                                                             std::uint64_t seed, StageLog& log);

/// Runs the stages that the shape needs and notes in `log` those that it does not.
/// @param check  Whether the certificates of the stages are checked, each a stage of its own.
/// @throws Error Internal if a certificate fails.
[[nodiscard]] SolidOutcome make_solid(const Shape& shape, std::uint64_t seed, bool check,
                                      StageLog& log);

/// A point strictly inside for programs that need no deeper one: the one that is known, or the mean
/// of the solid's vertices on a short grid.
[[nodiscard]] RationalPoint interior_point_of(const Solid& solid);

/// Formats to store a solid in, beside the exact integers, which are always there.
struct StoreRequest {
  std::optional<Precision> planes;
  std::optional<Precision> mesh;
};

struct StoredSolid {
  Polytope exact;
  PointSet points;  ///< What it holds: the input's points, or the vertices of the input's polytope.
  std::optional<StoredPlanes> planes;
  std::optional<StoredMesh> mesh;
};

/// Rounds outward to each format asked for, and proves it. @param extreme  Of `points`: those whose
/// hull holds the rest.
/// @throws Error Unrepresentable if a format cannot hold the solid; Internal if a proof fails.
[[nodiscard]] StoredSolid store(Polytope exact, const PointSet& points,
                                std::span<const PointId> extreme, const StoreRequest& request,
                                StageLog& log);

}  // namespace convexact
