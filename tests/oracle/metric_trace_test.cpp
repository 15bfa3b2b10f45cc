// SPDX-License-Identifier: MIT
// Orders of removals judged by area and by mean width. Costs are closed forms of cut corners, or
// decimals of 50-digit arithmetic on the definition. A cut of depth t from the corner of a cube
// costs (3 - sqrt 3) t^2 / 2 of area and a multiple of t of mean width.
#include <doctest/doctest.h>

#include "convexact/error.hpp"
#include "convexact/measure.hpp"
#include "expect_error.hpp"
#include "fast/engines.hpp"
#include "oracle/order/removal_cost.hpp"
#include "removal_orders.hpp"
#include "shapes/makers.hpp"
#include "sweep.hpp"
#include "wire/removal_order_file.hpp"
#include "wire/trace_json.hpp"
#include "wire/trace_verdict.hpp"

using namespace convexact;

namespace {

constexpr CostMeasure kMetrics[] = {CostMeasure::Area, CostMeasure::MeanWidth};

RemovalOrder by(CostMeasure measure, RemovalOrder order) {
  order.measure = measure;
  return order;
}

Halfspace row(int x, int y, int z, int d) { return {IntegerVector3(x, y, z), Integer(d)}; }

Cost area_of_cut(const Rational& depth) {
  RootSum area(Rational(3 * depth * depth / 2));
  area.add(Rational(-depth * depth / 2), 3);
  return Cost(area);
}

// The edges of length t along the cube, at right angles; those of the base of length t sqrt 2, at
// the angle between (1, 1, 1) and an axis.
Cost width_of_cut(const Rational& depth) {
  AngleSum sum = AngleSum::pi(3 * depth / 2);
  return Cost(sum -= AngleSum(std::vector<AngleTerm>{{3, 2 * depth * depth, 2, 1}}));
}

bool is_equal(const std::optional<Cost>& a, const Cost& b) {
  return a && compare(*a, b).order == Order::Equal;
}

// To the digits of the decimal.
bool is_near(const std::optional<Cost>& cost, const std::string& decimal) {
  const auto digits = static_cast<int>(decimal.size()) - 1;
  return cost && cost->decimal(digits) == decimal;
}

std::vector<HalfspaceId> first_removals(const Run& run, std::size_t count) {
  return removed_in(run, count);
}

const std::vector<Rational> kDepths = {Rational(1, 2), Rational(1), Rational(3, 2)};

// A cut of the corner (4, 4, 0) of the cube with legs s, s, 2 s.
Halfspace long_cut(const Rational& s) {
  const Rational y = 1 / s;
  return {RationalVector3(y, y, -y / 2), 1 - 8 * y};
}

// The mean width that is lost by it.
Cost width_of_long_cut(const Rational& s) {
  std::vector<Halfspace> planes = cube_sides();
  planes.push_back(long_cut(s));
  const RemovalOracle oracle(planes, kCutBoxCenter, CostMeasure::MeanWidth);
  return oracle.without(planes.back()).cost.value();
}

// Its size where it costs less than a cut of depth 1, by a part in 2^400 at most: they have no
// angle in common, so nothing cancels.
Rational size_of_close_cut() {
  const Enclosure ratio = width_of_cut(1).enclose(450) / width_of_long_cut(1).enclose(450);
  return ratio.low();
}

}  // namespace

TEST_CASE("judge trace: cut corners in order of depth are greedy by every measure") {
  const DualHull solid = cut_box(kDepths);
  for (const CostMeasure measure : kMetrics) {
    CAPTURE(static_cast<int>(measure));
    const TraceVerdict verdict = judge(solid, by(measure, cuts_in_order(solid, kDepths)));
    CHECK(verdict.holds());
    CHECK(verdict.rating == TraceRating::Greedy);
    CHECK(verdict.measure == measure);
    CHECK(verdict.undecided == 0);
    REQUIRE(verdict.steps.size() == 3);
    for (std::size_t s = 0; s < 3; ++s) {
      const Cost expected =
          measure == CostMeasure::Area ? area_of_cut(kDepths[s]) : width_of_cut(kDepths[s]);
      CHECK(is_equal(verdict.steps[s].cost, expected));
      CHECK(is_equal(verdict.steps[s].minimum, expected));
      CHECK(verdict.steps[s].regret == Rational(0));
    }
  }
}

// Regrets are rational here although no cost is: (3/2)^2 / 1^2 - 1 and (3/2) / 1 - 1.
TEST_CASE("judge trace: the limit on regret is exact and inclusive for roots and angles") {
  const DualHull solid = cut_box(kDepths);
  const RemovalOrder order = order_of(
      solid, {id_of(solid, corner_cut(0, kDepths[0])), id_of(solid, corner_cut(2, kDepths[2])),
              id_of(solid, corner_cut(1, kDepths[1]))});
  const Rational tiny = scale_by_power_of_two(Rational(1), -500);
  for (const CostMeasure measure : {CostMeasure::Area, CostMeasure::MeanWidth}) {
    const Rational regret = measure == CostMeasure::Area ? Rational(5, 4) : Rational(1, 2);
    CAPTURE(static_cast<int>(measure));
    TraceVerdict verdict = judge(solid, by(measure, order));
    CHECK(verdict.rating == TraceRating::NotGreedy);
    CHECK(violated(verdict) == Codes{"trace-greedy"});
    CHECK(verdict.at == 1);
    CHECK(verdict.worst == 1);
    REQUIRE(verdict.worst_regret.has_value());
    CHECK(verdict.worst_regret->bounds().contains(regret));
    CHECK(verdict.steps[2].regret == Rational(0));
    CHECK(judge(solid, by(measure, order), regret).holds());
    CHECK(judge(solid, by(measure, order), regret).rating == TraceRating::UpToRegret);
    CHECK(judge(solid, by(measure, order), regret + tiny).holds());
    CHECK_FALSE(judge(solid, by(measure, order), regret - tiny).holds());
  }
}

// Costs that a queue keeps from before a removal are no bounds: docs/design/costs.md.
TEST_CASE("judge trace: the choice of a stale queue is not greedy, by area") {
  const std::vector<Point> points = {{-2, 3, 0}, {1, 3, -1},  {-4, 1, 0},  {1, 0, 0},
                                     {1, 4, -1}, {-3, -1, 2}, {-3, -2, 4}, {-4, 3, -3}};
  const DualHull solid = dual_of_doubles(points);
  std::vector<HalfspaceId> ids =
      first_removals(simplify_points(points, {.cost = CostMeasure::Area}), 4);
  const HalfspaceId cheapest = id_of(solid, row(-3, -22, -17, 3));
  const HalfspaceId stale = id_of(solid, row(0, -2, -1, 0));
  ids.push_back(cheapest);
  const TraceVerdict right = judge(solid, by(CostMeasure::Area, order_of(solid, ids)));
  CHECK(right.rating == TraceRating::Greedy);
  CHECK(is_near(right.steps.at(4).cost, "2.5728647"));
  ids.back() = stale;
  const TraceVerdict wrong = judge(solid, by(CostMeasure::Area, order_of(solid, ids)));
  CHECK(verdict_line(wrong) == "not greedy from step 4 by area");
  CHECK(is_near(wrong.steps.at(4).cost, "2.6971834"));
  CHECK(is_near(wrong.steps.at(4).minimum, "2.5728647"));
  CHECK(wrong.steps.at(4).tie == std::vector<HalfspaceId>{cheapest});
}

TEST_CASE("judge trace: the choice of a stale queue is not greedy, by mean width") {
  const std::vector<Point> points = {{4, -2, -3}, {-1, -2, 2}, {-2, -4, -2}, {3, -4, 0},
                                     {-4, 3, -2}, {0, 1, 1},   {1, -2, 0}};
  const DualHull solid = dual_of_doubles(points);
  std::vector<HalfspaceId> ids =
      first_removals(simplify_points(points, {.cost = CostMeasure::MeanWidth}), 2);
  ids.push_back(id_of(solid, row(-2, -9, 5, -30)));
  const TraceVerdict right = judge(solid, by(CostMeasure::MeanWidth, order_of(solid, ids)));
  CHECK(right.rating == TraceRating::Greedy);
  CHECK(is_near(right.steps.at(2).cost, "1.3291680"));
  ids.back() = id_of(solid, row(4, -17, -10, -80));
  const TraceVerdict wrong = judge(solid, by(CostMeasure::MeanWidth, order_of(solid, ids)));
  CHECK(verdict_line(wrong) == "not greedy from step 2 by mean width");
  CHECK(is_near(wrong.steps.at(2).cost, "1.3822448"));
  CHECK(is_near(wrong.steps.at(2).minimum, "1.3291680"));
}

// Legs 3, 1, 3 and 1, 1, 7: (15 - sqrt 99) / 2 each; volumes 3/2 and 7/6.
TEST_CASE("judge trace: an accidental tie of areas is greedy in both orders") {
  const std::vector<Halfspace> planes = {row(1, 0, 0, -20), row(-1, 0, 0, 0),  row(0, 1, 0, -20),
                                         row(0, -1, 0, 0),  row(0, 0, 1, -20), row(0, 0, -1, 0),
                                         row(1, 3, 1, -97), row(-7, -7, -1, 7)};
  const DualHull solid = dual_of(planes, RationalPoint(10, 10, 10)).dual;
  RootSum cost(Rational(15, 2));
  cost.add(Rational(-1, 2), 99);
  const HalfspaceId a = id_of(solid, planes[6]), b = id_of(solid, planes[7]);
  std::size_t other_ties = 0;
  for (const auto& ids : {std::vector{a, b}, std::vector{b, a}}) {
    const TraceVerdict verdict = judge(solid, by(CostMeasure::Area, order_of(solid, ids)));
    CHECK(verdict.holds());
    CHECK(verdict.rating == TraceRating::Greedy);
    CHECK(verdict.steps[0].tie_evidence.proof == TieProof::SquareClasses);
    CHECK(is_equal(verdict.steps[0].cost, Cost(cost)));
    CHECK(is_equal(verdict.steps[1].cost, Cost(cost)));
    other_ties += verdict.other_ties;
  }
  CHECK(other_ties == 1);
  CHECK(judge(solid, order_of(solid, {b, a})).holds());
  const TraceVerdict by_volume = judge(solid, order_of(solid, {a, b}));
  CHECK(by_volume.steps[0].regret == Rational(2, 7));  // (3/2) / (7/6) - 1
}

// Cuts along the edges of a prism: both cost 1, by complementary angles; volumes 90 and 72.
TEST_CASE("judge trace: an accidental tie of mean widths is greedy in both orders") {
  const std::vector<Halfspace> planes = {row(1, 0, 0, -40),   row(-1, 0, 0, 0),  row(0, 1, 0, -40),
                                         row(0, -1, 0, 0),    row(0, 0, 1, -3),  row(0, 0, -1, 0),
                                         row(-12, -5, 0, 60), row(4, 3, 0, -256)};
  const DualHull solid = dual_of(planes, RationalPoint(20, 20, Rational(3, 2))).dual;
  const HalfspaceId a = id_of(solid, planes[6]), b = id_of(solid, planes[7]);
  for (const auto& ids : {std::vector{a, b}, std::vector{b, a}}) {
    const TraceVerdict verdict = judge(solid, by(CostMeasure::MeanWidth, order_of(solid, ids)));
    CHECK(verdict.rating == TraceRating::Greedy);
    CHECK(verdict.undecided == 0);
    CHECK(verdict.steps[0].tie_evidence.proof == TieProof::NormalForm);
    CHECK(is_equal(verdict.steps[0].cost, Cost(AngleSum::pi(4))));
    CHECK(is_equal(verdict.steps[1].cost, Cost(AngleSum::pi(4))));
  }
  CHECK(judge(solid, order_of(solid, {b, a})).holds());
  CHECK(violated(judge(solid, order_of(solid, {a, b}))) == Codes{"trace-greedy"});
}

// The legs of one cut are 19/20 of 3, 1, 3, so its area is 361/400 of the other's; its volume is
// still larger: 3/2 (19/20)^3 > 7/6. A program that is greedy by volume is wrong by area.
TEST_CASE("judge trace: greedy by volume is not greedy by area") {
  const std::vector<Halfspace> planes = {
      row(1, 0, 0, -20),
      row(-1, 0, 0, 0),
      row(0, 1, 0, -20),
      row(0, -1, 0, 0),
      row(0, 0, 1, -20),
      row(0, 0, -1, 0),
      Halfspace(RationalVector3(1, 3, 1), Rational(57, 20) - 100),
      row(-7, -7, -1, 7)};
  const DualHull solid = dual_of(planes, RationalPoint(10, 10, 10)).dual;
  const HalfspaceId less_area = id_of(solid, planes[6]), less_volume = id_of(solid, planes[7]);
  const RemovalOrder order = order_of(solid, {less_volume, less_area});
  CHECK(judge(solid, order).rating == TraceRating::Greedy);
  const TraceVerdict verdict = judge(solid, by(CostMeasure::Area, order));
  CHECK(verdict.rating == TraceRating::NotGreedy);
  CHECK(verdict.at == 0);
  REQUIRE(verdict.worst_regret.has_value());
  CHECK(verdict.worst_regret->bounds().contains(Rational(400, 361) - 1));
  CHECK(judge(solid, by(CostMeasure::Area, order_of(solid, {less_area, less_volume}))).holds());
}

TEST_CASE("judge trace: stated roots and edges are compared exactly") {
  const DualHull solid = cut_box(kDepths);
  const Rational tiny = scale_by_power_of_two(Rational(1), -300);
  for (const CostMeasure measure : kMetrics) {
    CAPTURE(static_cast<int>(measure));
    const auto right = [&](std::size_t s) {
      return measure == CostMeasure::Area ? area_of_cut(kDepths[s]) : width_of_cut(kDepths[s]);
    };
    RemovalOrder order = by(measure, cuts_in_order(solid, kDepths));
    for (std::size_t s = 0; s < 3; ++s) order.steps[s].step.cost = right(s);
    CHECK(status(judge(solid, order), "trace-cost") == Status::Holds);
    Cost wrong = right(1);
    wrong *= 1 + tiny;
    order.steps[1].step.cost = wrong;
    const TraceVerdict verdict = judge(solid, order);
    CHECK(violated(verdict) == Codes{"trace-cost"});
    const TraceWitness found = witness(verdict, "trace-cost");
    CHECK(found.step == 1);
    CHECK(found.found != found.expected);  // however many digits that takes
  }
  // Equal numbers in other words: 3 (1 - sqrt(1/3)) / 2, and sqrt 12 is 2 sqrt 3.
  RootSum other(Rational(3, 2));
  other.add(Rational(-1, 4), 12);
  RemovalOrder order = by(CostMeasure::Area, cuts_in_order(solid, kDepths));
  order.steps[1].step.cost = Cost(other);
  CHECK(judge(solid, order).holds());
  // The complement of the angle, and the edge in two pieces.
  AngleSum pieces(std::vector<AngleTerm>{{1, 2, 1, 1}});  // sqrt 2 pi / 4
  pieces *= 0;
  pieces += AngleSum::pi(Rational(3, 2));
  pieces -= AngleSum(std::vector<AngleTerm>{{6, Rational(1, 2), 2, 1}});
  order = by(CostMeasure::MeanWidth, cuts_in_order(solid, kDepths));
  order.steps[1].step.cost = Cost(pieces);
  CHECK(judge(solid, order).holds());
}

// 256 bits do not tell the mean widths apart, and no normal form proves them equal, because they
// are not.
TEST_CASE("judge trace: an undecided comparison neither violates nor holds") {
  std::vector<Halfspace> planes = cube_sides();
  planes.push_back(corner_cut(0, 1));
  planes.push_back(long_cut(size_of_close_cut()));
  const DualHull solid = dual_of(planes, kCutBoxCenter).dual;
  const std::vector<HalfspaceId> right = {id_of(solid, planes[7])};
  RemovalOrder order =  // the dearer one first
      by(CostMeasure::MeanWidth, order_of(solid, {id_of(solid, planes[6]), right[0]}));
  order.steps[0].step.tie = right;
  order.steps[0].claims_tie = true;
  order.steps[0].step.cost = width_of_long_cut(size_of_close_cut());
  JudgeOptions options;
  options.compare = {.bits = 256, .angle_basis = false};
  const TraceVerdict open = judge_trace(solid, kCutBoxCenter, order, options);
  CHECK(violated(open).empty());
  CHECK(open.rating == TraceRating::Undecided);
  CHECK(open.at == 0);
  CHECK(open.undecided == 1);
  CHECK(open.steps[0].tie.size() == 2);
  CHECK_FALSE(open.steps[0].is_greedy());
  CHECK_FALSE(open.steps[0].is_dearer());
  CHECK_FALSE(open.worst.has_value());
  for (const char* code : {"trace-greedy", "trace-ties", "trace-cost"}) {
    CHECK(status(open, code) == Status::Undecided);
  }
  CHECK(verdict_line(open) == "undecided at step 0 by mean width");
  CHECK(trace_verdict_text(open).find("UNDECIDED at step 0") != std::string::npos);
  CHECK(trace_verdict_text(open).find("1 of 2 steps are not decided") != std::string::npos);
  // A limit far above the difference decides.
  options.max_regret = Rational(1, 1000);
  const TraceVerdict near = judge_trace(solid, kCutBoxCenter, order, options);
  CHECK(status(near, "trace-greedy") == Status::Holds);
  CHECK(near.undecided == 0);
  // Proofs of difference decide as well, and so do more bits.
  for (const CompareLimits& limits :
       {CompareLimits{}, CompareLimits{.bits = 1024, .angle_basis = false}}) {
    options.max_regret = 0;
    options.compare = limits;
    const TraceVerdict decided = judge_trace(solid, kCutBoxCenter, order, options);
    CHECK(violated(decided) == Codes{"trace-greedy", "trace-cost"});
    CHECK(decided.rating == TraceRating::NotGreedy);
    CHECK(decided.steps[0].tie == right);
  }
}

TEST_CASE("judge trace: traces of both exact engines are accepted by their measure" * sweep) {
  for (const CostMeasure measure :
       {CostMeasure::Volume, CostMeasure::Area, CostMeasure::MeanWidth}) {
    CAPTURE(static_cast<int>(measure));
    for (const std::vector<Point>& points :
         {shapes::dodecahedron(), shapes::cut_cube(8, 0.3), shapes::prism(7),
          shapes::lattice(12, 3, 5), shapes::in_ball(40, 3)}) {
      const DualHull solid = dual_of_doubles(points);
      const SimplifyOptions options{.cost = measure};
      const Run runs[] = {simplify_exact(solid, center_of(solid), options),
                          simplify_filtered(solid, center_of(solid), options)};
      for (const Run& run : runs) {
        const TraceVerdict verdict = judge(solid, order_of(run));
        CHECK(verdict.holds());
        CHECK(verdict.rating == TraceRating::Greedy);
        CHECK(verdict.other_ties == 0);
        CHECK(status(verdict, "trace-cost") == Status::Holds);
        CHECK(status(verdict, "trace-ties") == Status::Holds);
        // The same from its file.
        const RemovalOrder read = read_removal_order(write_trace_json(run), {}, solid.halfspaces);
        CHECK(read.measure == measure);
        CHECK(judge(solid, read).holds());
      }
    }
  }
}

TEST_CASE("confirm_costs: areas and mean widths are computed again, by the definition") {
  const DualHull solid = cut_box(kDepths);
  for (const CostMeasure measure : kMetrics) {
    CAPTURE(static_cast<int>(measure));
    const TraceVerdict right = judge(solid, by(measure, cuts_in_order(solid, kDepths)));
    CHECK_NOTHROW(confirm_sum(right, kCutBoxCenter));
    for (std::size_t s = 0; s < 3; ++s) {
      CHECK_NOTHROW(confirm_step(right, kCutBoxCenter, s));
      const Rational more = 1 + scale_by_power_of_two(Rational(1), -200);
      TraceVerdict wrong = right;
      *wrong.steps[s].cost *= more;
      CHECK_THROWS_AS(confirm_step(wrong, kCutBoxCenter, s), Error);
      CHECK_THROWS_AS(confirm_sum(wrong, kCutBoxCenter), Error);
      wrong = right;
      *wrong.steps[s].minimum *= more;
      CHECK_THROWS_AS(confirm_step(wrong, kCutBoxCenter, s), Error);
    }
  }
}

TEST_CASE("judge trace: facets that are left out are found by every measure") {
  const DualHull solid = cut_box(kDepths);
  for (const CostMeasure measure : kMetrics) {
    const RemovalOrder order = by(measure, cuts_in_order(solid, {Rational(1, 2)}));
    RemovalOrder without = order;
    without.steps[0].step.removed = id_of(solid, corner_cut(1, Rational(1)));
    const TraceVerdict verdict = judge(solid, without);
    CHECK(violated(verdict) == Codes{"trace-greedy"});
    REQUIRE(verdict.never_removed.has_value());
    CHECK(verdict.never_removed->facets ==
          std::vector<HalfspaceId>{id_of(solid, corner_cut(0, Rational(1, 2)))});
    CHECK(verdict.never_removed->rating == TraceRating::Greedy);
  }
}

TEST_CASE("judge trace: an interrupt ends a judgement by every measure") {
  const DualHull solid = cut_box(kDepths);
  const std::atomic<bool> stop{true};
  JudgeOptions options;
  options.watch = &stop;
  for (const CostMeasure measure : kMetrics) {
    const RemovalOrder order = by(measure, cuts_in_order(solid, kDepths));
    CHECK(error_of([&] { return judge_trace(solid, kCutBoxCenter, order, options); }).code() ==
          ErrorCode::Stopped);
  }
}

TEST_CASE("relative regret: a proven 0, an interval, or an interval around 0") {
  CHECK(relative_regret(area_of_cut(1), area_of_cut(1)) == Rational(0));
  const auto half = relative_regret(width_of_cut(Rational(3, 2)), width_of_cut(1));
  REQUIRE(half.has_value());
  CHECK(half->exact() == nullptr);
  CHECK(half->is_positive());
  CHECK(half->bounds().contains(Rational(1, 2)));
  CHECK(half->bounds().width() < scale_by_power_of_two(Rational(1), -120));
  CHECK_THROWS_AS((void)half->rational(), Error);
  const Cost close = width_of_long_cut(size_of_close_cut());
  const auto open = relative_regret(width_of_cut(1), close, {.bits = 256, .angle_basis = false});
  REQUIRE(open.has_value());
  CHECK_FALSE(open->is_positive());
  CHECK(open->bounds().contains(0));
  CHECK(open->bounds().width() < scale_by_power_of_two(Rational(1), -250));
  CHECK_FALSE(half->is_above(*half));
  CHECK(half->is_above(*open));
  CHECK_THROWS_AS((void)relative_regret(area_of_cut(1), width_of_cut(1)), Error);
}
