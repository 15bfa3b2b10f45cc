// SPDX-License-Identifier: MIT
// What an observer of rows sees rebuilds the optimum: each step is judged by the definition.
#include <doctest/doctest.h>

#include <algorithm>
#include <utility>

#include "linear_programs.hpp"
#include "lp/lp_observer.hpp"
#include "lp_certificates.hpp"

using namespace convexact;

namespace {

// a + b M for a symbol M above every number.
using Value = std::pair<Rational, Rational>;  // (b, a): ordered as the values are

Value at(const RationalVector& normal, const Rational& offset, const LpPoint& point) {
  return {normal.dot(point.direction), normal.dot(point.x) + offset};
}

class Replay : public LpObserver {
 public:
  explicit Replay(const LinearProgram& lp) : lp_(lp) {}

  std::size_t starts = 0;
  std::vector<std::size_t> rows;
  std::optional<LpPoint> optimum;

  void start(const LpPoint& corner) override {
    ++starts;
    optimum = corner;
  }

  void inserted(const LpInsertion& insertion) override {
    REQUIRE(optimum.has_value());  // there is no insertion after a conflict
    CHECK(std::find(rows.begin(), rows.end(), insertion.row) == rows.end());
    rows.push_back(insertion.row);
    CHECK(insertion.moved == !holds(insertion.row, *optimum));
    if (!insertion.moved) {
      CHECK(insertion.optimum->x == optimum->x);
      CHECK(insertion.optimum->direction == optimum->direction);
    } else if (insertion.optimum) {
      CHECK(value_of(insertion.row, *insertion.optimum) == Value(0, 0));
      for (const std::size_t row : rows) CHECK(holds(row, *insertion.optimum));
      CHECK(at(lp_.objective, 0, *insertion.optimum) <= at(lp_.objective, 0, *optimum));
    }
    optimum = insertion.optimum;
  }

 private:
  Value value_of(std::size_t row, const LpPoint& point) const {
    const auto i = static_cast<Eigen::Index>(row);
    return at(lp_.normals.row(i).transpose(), lp_.offsets[i], point);
  }
  bool holds(std::size_t row, const LpPoint& point) const {
    return value_of(row, point) <= Value(0, 0);
  }

  const LinearProgram& lp_;
};

void check_replay(const LinearProgram& lp, std::uint64_t seed) {
  Replay replay(lp);
  const LpOutcome outcome = maximise(lp, {.seed = seed, .observer = &replay});
  CHECK(replay.starts == 1);
  CHECK(outcome.index() == maximise(lp, {.seed = seed}).index());
  if (std::holds_alternative<Infeasible>(outcome)) {
    CHECK_FALSE(replay.optimum.has_value());
    // The rows that were inserted are the conflict's, or more.
    for (const Multiplier& m : std::get<Infeasible>(outcome).farkas) {
      CHECK(std::find(replay.rows.begin(), replay.rows.end(), m.row) != replay.rows.end());
    }
    return;
  }
  REQUIRE(replay.optimum.has_value());
  CHECK(replay.rows.size() == static_cast<std::size_t>(lp.normals.rows()));
  const Value value = at(lp.objective, 0, *replay.optimum);
  if (const auto* best = std::get_if<Optimal>(&outcome)) {
    CHECK(value == Value(0, lp.objective.dot(best->x)));
    if (replay.optimum->direction.isZero(0)) CHECK(replay.optimum->x == best->x);
  } else {
    CHECK(value.first > 0);
  }
}

}  // namespace

TEST_CASE("observer: a square, row by row") {
  // Maximise x + 2y in the unit square: the optimum ends in (1, 1).
  const LinearProgram lp =
      data::linear_program({1, 2}, {{1, 0, -1}, {0, 1, -1}, {-1, 0, 0}, {0, -1, 0}});
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Replay replay(lp);
    (void)maximise(lp, {.seed = seed, .observer = &replay});
    REQUIRE(replay.optimum.has_value());
    CHECK(replay.optimum->direction.isZero(0));
    CHECK(replay.optimum->x == RationalVector::Ones(2));
    CHECK(replay.rows.size() == 4);
  }
}

TEST_CASE("observer: the rows that it sees rebuild the optimum of small programs") {
  Random random(5);
  for (int repeat = 0; repeat < 600; ++repeat) {
    CAPTURE(repeat);
    const auto size = static_cast<Eigen::Index>(1 + uniform_below(random, 4));
    const auto rows = static_cast<Eigen::Index>(uniform_below(random, 12));
    LinearProgram lp = data::random_linear_program(random, size, rows, 1 + repeat % 3);
    if (repeat % 3 != 0) lp.offsets = -lp.offsets.cwiseAbs();
    check_replay(lp, random());
  }
}
