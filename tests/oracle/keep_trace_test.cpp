// SPDX-License-Identifier: MIT
// Removal orders of runs that keep facets: on the cut cube of docs/construction.md, where one side
// at 1 goes at 25/48 if the cut is kept, and on small shapes, whose runs the definition judges.
#include <doctest/doctest.h>

#include "convexact/error.hpp"
#include "definitional_greedy.hpp"
#include "expect_error.hpp"
#include "integer_halfspace.hpp"
#include "lab/diff/diff.hpp"
#include "lab/diff/divergence.hpp"
#include "removal_orders.hpp"
#include "shapes/makers.hpp"
#include "sweep.hpp"

using namespace convexact;

namespace {

using Ids = std::vector<HalfspaceId>;

const HalfspaceId kCut(6), kTop(3);

DualHull cut_cube() {
  return dual_of({{halfspace(-1, 0, 0, 0), halfspace(0, -1, 0, 0), halfspace(0, 0, -1, 0),
                   halfspace(0, 0, 1, -1), halfspace(0, 1, 0, -1), halfspace(1, 0, 0, -1),
                   halfspace(2, 2, 2, -5)}},
                 RationalPoint::Constant(Rational(1, 2)))
      .dual;
}

TraceVerdict judge_kept(const DualHull& solid, const RemovalOrder& order, const Ids& kept) {
  JudgeOptions options;
  options.kept = kept;
  return judge_trace(solid, center_of(solid), order, options);
}

// As a trace file gives it.
RemovalOrder stated(const Run& run) {
  RemovalOrder order = order_of(run);
  if (!run.kept.empty()) order.kept = run.kept;
  return order;
}

Run kept_run(const DualHull& solid, const Ids& keep, std::size_t faces,
             CostMeasure measure = CostMeasure::Volume) {
  return simplify_exact(solid, center_of(solid), {.faces = faces, .keep = keep, .cost = measure});
}

}  // namespace

TEST_CASE("kept in a trace: the cheapest of the others is greedy, with the same selectors") {
  const DualHull solid = cut_cube();
  const RemovalOrder order = stated(kept_run(solid, {kCut}, 6));
  const TraceVerdict good = judge_kept(solid, order, {kCut});
  CHECK(good.holds());
  CHECK(good.rating == TraceRating::Greedy);
  CHECK(status(good, "trace-kept") == Status::Holds);
  CHECK(good.steps[0].cost == Rational(25, 48));
  CHECK(good.steps[0].tie == Ids{kTop, HalfspaceId(4), HalfspaceId(5)});
  // A trace is not believed: without selectors the cut is cheaper, at 1/48.
  const TraceVerdict free = judge(solid, order);
  CHECK(violated(free) == Codes{"trace-greedy", "trace-ties", "trace-kept"});
  CHECK(free.steps[0].minimum == Rational(1, 48));
  CHECK(witness(free, "trace-kept").found == "keeps {6}");
  // Other selectors than the trace states.
  CHECK(violated(judge_kept(solid, order, {HalfspaceId(4), kCut})) ==
        Codes{"trace-ties", "trace-kept"});
}

TEST_CASE("kept in a trace: removed all the same, or in a tie") {
  const DualHull solid = cut_cube();
  RemovalOrder order = order_of(solid, {kCut});
  TraceVerdict verdict = judge_kept(solid, order, {kCut});
  CHECK(violated(verdict) == Codes{"trace-kept"});
  CHECK(verdict.rating == TraceRating::Meaningless);
  CHECK(witness(verdict, "trace-kept").step == 0);

  // The sides at 1 tie; one of them is kept, and no entry of the tie.
  order = stated(kept_run(solid, {kCut, HalfspaceId(4)}, 6));
  CHECK(order.steps[0].step.tie == Ids{kTop, HalfspaceId(5)});
  CHECK(judge_kept(solid, order, {HalfspaceId(4), kCut}).holds());
  order.steps[0].step.tie = {kTop, HalfspaceId(4), HalfspaceId(5)};
  CHECK(violated(judge_kept(solid, order, {HalfspaceId(4), kCut})) == Codes{"trace-ties"});
}

TEST_CASE("kept in a trace: the end") {
  const DualHull solid = cut_cube();
  const Ids all{kTop, HalfspaceId(4), HalfspaceId(5), kCut};
  RemovalOrder order = stated(kept_run(solid, all, 4));
  CHECK(order.stop == StopReason::AllKeptOrUnbounded);
  CHECK(status(judge_kept(solid, order, all), "trace-stop") == Status::Holds);
  order.kept = Ids{kTop, kCut};
  CHECK(violated(judge_kept(solid, order, {kTop, kCut})) == Codes{"trace-stop"});
  order.kept = Ids{HalfspaceId(7)};
  CHECK(violated(judge_kept(solid, order, {kTop, kCut})) == Codes{"trace-kept", "trace-stop"});
}

TEST_CASE("kept in a trace: runs by all measures hold, and steps that cost more do not" * sweep) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const DualHull solid = dual_of_doubles(shapes::lattice(14, 3, seed));
    const Ids keep{HalfspaceId(1), HalfspaceId(4)};
    for (const CostMeasure measure :
         {CostMeasure::Volume, CostMeasure::Area, CostMeasure::MeanWidth}) {
      const Run run = kept_run(solid, keep, 4, measure);
      definition::check_against_definition(run, measure);
      CHECK(judge_kept(solid, stated(run), keep).holds());
      CHECK(check_greedy(solid, center_of(solid), run).empty());
      if (run.steps.size() < 2 || definition::in_order(*run.steps[1].cost, *run.steps[0].cost) == 0)
        continue;
      Run swapped = run;
      std::swap(swapped.steps[0].removed, swapped.steps[1].removed);
      RemovalOrder order = stated(swapped);
      CHECK_FALSE(judge_kept(solid, order, keep).holds());
    }
  }
}

TEST_CASE("kept and left out at once is refused") {
  const DualHull solid = cut_cube();
  JudgeOptions options;
  options.kept = options.left_out = {kCut};
  const Error error = error_of(
      [&] { return judge_trace(solid, center_of(solid), order_of(solid, Ids{}), options); });
  CHECK(error.code() == ErrorCode::InvalidArgument);
}

TEST_CASE("kept ids that do not exist, repeat or descend are refused") {
  const DualHull solid = cut_cube();
  for (const Ids& wrong : {Ids{HalfspaceId(7)}, Ids{kCut, kCut}, Ids{kCut, kTop}}) {
    const Error error = error_of([&] { return judge_kept(solid, order_of(solid, Ids{}), wrong); });
    CHECK(error.code() == ErrorCode::InvalidArgument);
  }
}

TEST_CASE("kept facets in all engines at once") {
  DiffRequest request;
  request.keep = {{KeepNormal{{0, 0, 1}, {}}, "the top"}, {KeepIds{{HalfspaceId(0)}}, "the first"}};
  for (const CostMeasure measure :
       {CostMeasure::Volume, CostMeasure::Area, CostMeasure::MeanWidth}) {
    request.cost = measure;
    const auto report =
        std::get<DiffReport>(diff_engines(PointSet(shapes::on_sphere(40, 7)), request));
    CHECK(report.holds());
    CHECK(report.kept.size() == 2);
    for (const Run& run : report.runs) {
      CHECK(run.kept == report.kept);
      const Ids removed = removed_in(run);
      for (const HalfspaceId i : report.kept) {
        CHECK(std::find(removed.begin(), removed.end(), i) == removed.end());
      }
    }
  }
}
