// SPDX-License-Identifier: MIT
// chapters.hpp - the recorders of a lesson: each watches one algorithm and records its steps, as
// docs/schema/lesson.schema.json describes them.
#pragma once
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "convexact/stored.hpp"
#include "hull/hull_observer.hpp"
#include "io/json_document.hpp"
#include "lp/lp_observer.hpp"
#include "simplify/exact_engine.hpp"
#include "solid/solid.hpp"
#include "teach/frame.hpp"
#include "teach/lesson.hpp"

namespace convexact {

/// Parts of a lesson that are missing, each with its reason.
class LeftOutParts {
 public:
  void add(const char* chapter, const std::string& why) {
    list_.push_back({{"chapter", chapter}, {"why", why}});
  }
  const Json& list() const { return list_; }

 private:
  Json list_ = Json::array();
};

/// Integers of a dual point: n1, n2, n3, w.
[[nodiscard]] Json dual_point_json(const DualPoint& point);

/// A cost as a trace has it, or null for an unbounded removal.
[[nodiscard]] Json cost_or_null(const std::optional<Cost>& cost);

/// Records how a hull grows; beyond kMostLessonInsertions it only counts.
class HullRecorder : public HullObserver {
 public:
  void start(const HullStart& start) override;
  void inserted(const HullInsertion& insertion) override;
  void finished(const Hull& hull) override;

  std::size_t insertions() const { return count_; }
  /// The keys from "triangles" on. Facets are in the order of the hull.
  Json take() { return std::move(chapter_); }

 private:
  Json chapter_;
  std::size_t count_ = 0;
};

/// Records how the linear program of chebyshev_center() is solved.
class CenterRecorder : public LpObserver {
 public:
  explicit CenterRecorder(std::span<const Halfspace> halfspaces);
  void start(const LpPoint& optimum) override;
  void inserted(const LpInsertion& insertion) override;

  Json take(const ChebyshevCenter& center);

 private:
  bool is_tight(std::size_t row, const LpPoint& point) const;
  Json name_of(std::size_t row) const;

  std::span<const Halfspace> halfspaces_;
  std::vector<Rational> norms_;  // upper bounds, as the program has them
  std::set<std::size_t> rows_;   // inserted so far
  Json chapter_;
};

/// Records the removals, starting when at most kMostLessonHalfspaces are left.
class RemovalRecorder : public RunObserver {
 public:
  /// The arguments must outlive the object.
  RemovalRecorder(const DualHull& dual, const LessonFrame& frame, const LessonRequest& request);

  void started(const DualTriangle& first) override;
  void inserted(HalfspaceId corner, std::span<const DualTriangle> lost,
                std::span<const DualTriangle> gained) override;
  void evaluated(std::size_t step, const Removal& removal) override;
  void chosen(const Step& step) override;
  void checked(const TestedCondition& check, bool holds) override;
  /// To be called when the run has ended, even if it failed. @param why  If it failed: the engine's
  /// reason.
  void finish(const std::optional<std::string>& why = {});

  /// {"step", "check"} of the check that did not hold, or the other reason why the engine gave up;
  /// null if the run succeeded.
  const Json& failed() const { return failed_; }
  std::size_t steps() const { return steps_; }
  /// The halfspaces left after the steps that were made.
  std::vector<HalfspaceId> present() const;
  /// The first costs of all halfspaces; empty if there are too many of these.
  const std::vector<std::optional<Cost>>& first_costs() const { return first_costs_; }
  /// Whether the run got so far that there is anything to show.
  bool has_begun() const { return has_begun_; }
  /// How many removals are not shown.
  std::size_t skipped() const { return skipped_; }

  Json topology = {};
  Json evaluations = Json::array();
  Json removals = Json::array();

 private:
  struct Seen {
    std::size_t step = 0;
    Removal removal;
    DualTriangle first;
    Json insertions;  // Chew's
  };

  void make_chosen_step();
  void begin();
  Json evaluation_json(const Seen& seen) const;
  Json others_of(const Removal& removal) const;
  Json removal_json(const Step& step);

  const DualHull& dual_;
  const LessonFrame& frame_;
  const LessonRequest& request_;
  std::vector<DualPoint> points_;
  std::vector<IntegerVector3> directions_;
  AdjacencyMatrix surface_;
  std::vector<bool> is_present_;
  std::size_t skipped_;
  std::size_t steps_ = 0;  // made
  std::optional<Step> chosen_;
  Seen current_;              // the evaluation at hand
  std::vector<Seen> latest_;  // by halfspace
  std::vector<std::optional<Cost>> first_costs_;
  bool has_begun_ = false;
  Rational volume_;
  Json failed_;
};

/// How a result is rounded outward, plane by plane, against rounding to nearest. Null, and a reason
/// in `left_out`, if the format cannot hold it.
/// @param ids  Of the planes of `exact`.
[[nodiscard]] Json storing_chapter(const Polytope& exact, std::span<const HalfspaceId> ids,
                                   const Solid& solid, Precision precision, LeftOutParts& left_out);

}  // namespace convexact
