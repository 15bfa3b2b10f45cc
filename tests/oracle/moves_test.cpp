// SPDX-License-Identifier: MIT
// Moves after a removal order, on boxes with cut corners, whose measures are closed forms.
#include <doctest/doctest.h>

#include "removal_orders.hpp"

using namespace convexact;

namespace {

// [0, 4]^3 with cuts of depth 1, 1 and 3/2, of which the order leaves the first: 64 - 1/6. Only
// that one bounds the solid without the side x = 0.
struct CutBox {
  CutBox() : solid(cut_box(depths)), side(id_of(solid, cube_sides()[1])) {
    for (std::size_t c = 0; c < depths.size(); ++c) {
      cuts.push_back(id_of(solid, corner_cut(c, depths[c])));
    }
  }

  TraceVerdict judge_moves(const std::vector<Move>& moves,
                           const std::vector<HalfspaceId>& kept = {}) const {
    RemovalOrder order = order_of(solid, {cuts[1], cuts[2]});
    order.moves = moves;
    JudgeOptions options;
    options.max_regret = 10;
    options.kept = kept;
    return judge_trace(solid, center_of(solid), order, options);
  }
  TraceWitness fault(const std::vector<Move>& moves,
                     const std::vector<HalfspaceId>& kept = {}) const {
    const TraceVerdict verdict = judge_moves(moves, kept);
    CHECK(violated(verdict) == Codes{"trace-moves"});
    return witness(verdict, "trace-moves");
  }

  const std::vector<Rational> depths{1, 1, Rational(3, 2)};
  DualHull solid;
  HalfspaceId side;
  std::vector<HalfspaceId> cuts;
};

}  // namespace

TEST_CASE("moves of a trace: one that makes the solid smaller holds") {
  const CutBox box;
  CHECK(status(box.judge_moves({}), "trace-moves") == Status::NotAsked);
  const Cost measure(Rational(64 - Rational(9, 16)));
  const TraceVerdict good = box.judge_moves({{{box.cuts[0]}, {box.cuts[2]}, measure}});
  CHECK(good.holds());
  CHECK(status(good, "trace-moves") == Status::Holds);
}

TEST_CASE("moves of a trace: each fault has its witness") {
  const CutBox box;
  const Move shrinks{{box.cuts[0]}, {box.cuts[2]}};
  const TraceWitness level = box.fault({{{box.cuts[0]}, {box.cuts[1]}}});
  CHECK(level.row == 1);
  CHECK_FALSE(level.step.has_value());
  CHECK(level.found == "leaves the measure 63.833333333333333");
  CHECK(level.expected == "less than 63.833333333333333");
  CHECK(box.fault({shrinks, {{box.cuts[2]}, {box.cuts[1]}}}).row == 2);
  CHECK(box.fault({shrinks, {{box.cuts[0]}, {box.cuts[1]}}}).expected == "a facet that is there");
  CHECK(box.fault({{{box.side}, {box.cuts[0]}}}).expected == "a facet that is not there");
  CHECK(box.fault({{{box.side, box.cuts[0]}, {box.cuts[1], box.cuts[2]}}}).found ==
        "leaves the solid unbounded");
  CHECK(box.fault({{{box.cuts[0]}, {HalfspaceId(99)}}}).expected == "a facet");
  CHECK(box.fault({{{box.cuts[0]}, {box.cuts[1], box.cuts[2]}}}).expected ==
        "as many, and at least one");
  CHECK(box.fault({{{}, {}}}).expected == "as many, and at least one");
  CHECK(box.fault({{{box.cuts[0]}, {box.cuts[2]}, Cost(Rational(63))}}).found ==
        "states the measure 63");
  CHECK(box.fault({shrinks}, {box.cuts[0]}).expected == "a facet that is not to be kept");
}

TEST_CASE("moves of a trace: behind a removal that cannot be followed they are not judged") {
  const CutBox box;
  RemovalOrder order = order_of(box.solid, {box.cuts[1], box.cuts[1]});
  order.moves = {{{box.cuts[0]}, {box.cuts[2]}}};
  CHECK(status(judge(box.solid, order), "trace-moves") == Status::NotAsked);
}
