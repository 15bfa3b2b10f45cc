// SPDX-License-Identifier: MIT
// Randomised incremental linear programming [Seidel1991]. Infinity is a symbol M: each variable
// starts in the box -M <= x_j <= M, so that every subproblem has an optimal vertex. The box rows in
// the final basis decide which of the three outcomes it is (docs/design/lp.md).
#include <numeric>

#include "convexact/error.hpp"
#include "convexact/linear_program.hpp"
#include "lp/flat.hpp"
#include "lp/lp_observer.hpp"
#include "number/arithmetic.hpp"
#include "number/random.hpp"

namespace convexact {
namespace {

using detail::Flat;
using detail::kFinite;
using detail::kFirstNormal;
using detail::kInfinite;
using detail::RowView;
using detail::Vertex;

using RowId = std::uint32_t;
using RowIds = std::vector<RowId>;

// The factors y with target = sum of y_i basis[i]; m independent vectors of length k >= m, and a
// target that they span. Gauss-Jordan elimination on the columns (basis | target), O(k m^2).
std::vector<Rational> combination(const std::vector<RationalVector>& basis,
                                  const RationalVector& target) {
  const auto size = static_cast<Eigen::Index>(basis.size());
  Eigen::Matrix<Rational, Eigen::Dynamic, Eigen::Dynamic> system(target.size(), size + 1);
  for (Eigen::Index j = 0; j < size; ++j) system.col(j) = basis[static_cast<std::size_t>(j)];
  system.col(size) = target;
  for (Eigen::Index j = 0; j < size; ++j) {
    Eigen::Index pivot = j;
    while (system(pivot, j) == 0) ++pivot;  // exists: the vectors are independent
    system.row(j).swap(system.row(pivot));
    const Rational divisor = system(j, j);
    for (Eigen::Index c = j; c <= size; ++c) system(j, c) /= divisor;
    for (Eigen::Index i = 0; i < target.size(); ++i) {
      const Rational factor = system(i, j);
      if (i == j || factor == 0) continue;
      for (Eigen::Index c = j; c <= size; ++c) system(i, c) -= factor * system(j, c);
    }
  }
  std::vector<Rational> factors;
  for (Eigen::Index j = 0; j < size; ++j) factors.push_back(system(j, size));
  for (Eigen::Index i = size; i < target.size(); ++i) CONVEXACT_ASSERT(system(i, size) == 0);
  return factors;
}

struct Solution {
  Vertex vertex;
  RowIds basis;  // as many independent tight rows as there are coordinates, box rows included
};
struct Conflict {
  RowIds rows;  // no point satisfies them all; all but the last are independent
};

class Solver {
 public:
  Solver(const LinearProgram& lp, const LpOptions& options);
  LpOutcome solve();

 private:
  RowView row(RowId id) const { return {rows_.data() + id * width_, width_}; }
  RowId box_row(std::size_t coordinate, bool top) const {
    return static_cast<RowId>(count_ + 2 * coordinate + (top ? 0 : 1));
  }
  RationalVector normal(RowId id) const;

  bool is_violated(RowView row, const Vertex& vertex);
  Solution corner(const Flat& flat) const;
  std::variant<Solution, Conflict> maximise_on(const Flat& flat, const RowIds& order);

  std::vector<Multiplier> multipliers(const RowIds& basis, const std::vector<Rational>& y) const;
  LpOutcome certify(const Solution& solution) const;
  Infeasible certify(const Conflict& conflict) const;
  RationalVector feasible_point(const Vertex& vertex) const;
  LpPoint to_point(const Vertex& vertex) const;

  const LinearProgram& lp_;
  LpObserver* observer_;
  std::size_t dimension_, count_, width_;
  std::vector<Integer> rows_;       // the rows as integers, then two box rows per coordinate
  std::vector<Integer> objective_;  // integers
  RowIds order_;                    // random
  RowIds tight_;                    // the rows that cut the current flat
  Integer sum_;                     // scratch of is_violated()
};

Solver::Solver(const LinearProgram& lp, const LpOptions& options)
    : lp_(lp),
      observer_(options.observer),
      dimension_(static_cast<std::size_t>(lp.normals.cols())),
      count_(static_cast<std::size_t>(lp.normals.rows())),
      width_(dimension_ + kFirstNormal),
      rows_((count_ + 2 * dimension_) * width_),
      objective_(dimension_),
      order_(count_) {
  make_primitive({lp.objective.data(), dimension_}, objective_);
  std::vector<Rational> values(width_);  // (offset, 0, normal)
  for (std::size_t i = 0; i < count_; ++i) {
    values[kFinite] = lp.offsets[i];
    for (std::size_t k = 0; k < dimension_; ++k) values[kFirstNormal + k] = lp.normals(i, k);
    make_primitive(values, {rows_.data() + i * width_, width_});
  }
  for (std::size_t k = 0; k < dimension_; ++k) {
    for (const bool top : {true, false}) {
      Integer* box = rows_.data() + box_row(k, top) * width_;
      box[kInfinite] = -1;
      box[kFirstNormal + k] = top ? 1 : -1;
    }
  }
  std::iota(order_.begin(), order_.end(), RowId(0));
  Random random(options.seed);
  shuffle(std::span(order_), random);
}

bool Solver::is_violated(RowView row, const Vertex& vertex) {
  if (!vertex.is_finite || row[kInfinite] != 0) {
    mpz_mul(raw(sum_), raw(row[kInfinite]), raw(vertex.denominator));
    for (std::size_t k = 0; k < dimension_; ++k) {
      add_product(sum_, row[kFirstNormal + k], vertex.infinite[k]);
    }
    if (sum_ != 0) return sum_ > 0;
  }
  mpz_mul(raw(sum_), raw(row[kFinite]), raw(vertex.denominator));
  for (std::size_t k = 0; k < dimension_; ++k) {
    add_product(sum_, row[kFirstNormal + k], vertex.finite[k]);
  }
  return sum_ > 0;
}

Solution Solver::corner(const Flat& flat) const {
  std::vector<bool> at_top(dimension_);
  RowIds basis = tight_;
  for (std::size_t j = 0; j < dimension_; ++j) {
    if (!flat.is_free(j)) continue;
    at_top[j] = flat.grows_with(j, objective_);
    basis.push_back(box_row(j, at_top[j]));
  }
  return {flat.corner(at_top), std::move(basis)};
}

// The lexicographic maximum of (objective, x_1, x_2, ...) on `flat`, under the rows `order` and the
// box rows of the free coordinates. The maximum is one point, a function of the set of rows, even
// where rows or optima are tied. The expected time depends on this.
std::variant<Solution, Conflict> Solver::maximise_on(const Flat& flat, const RowIds& order) {
  // (1) Without rows, the maximum is a corner of the box.
  Solution best = corner(flat);
  // An observer sees the program itself, not the subprograms on the walls.
  LpObserver* const observer = tight_.empty() ? observer_ : nullptr;
  if (observer != nullptr) observer->start(to_point(best.vertex));
  for (std::size_t i = 0; i < order.size(); ++i) {
    // (2) The maximum stays while it satisfies the next row.
    if (!is_violated(row(order[i]), best.vertex)) {
      if (observer != nullptr) observer->inserted({order[i], false, to_point(best.vertex)});
      continue;
    }
    // (3) Otherwise the new maximum lies on the hyperplane of that row. Degenerate: on the flat the
    //     row may be a constant; then it is positive and no point satisfies it.
    const std::optional<Flat> wall = flat.cut_by(row(order[i]));
    tight_.push_back(order[i]);
    if (!wall) {
      if (observer != nullptr) observer->inserted({order[i], true, std::nullopt});
      return Conflict{tight_};
    }
    // (4) There, solve for the rows so far. A coordinate became dependent: its box rows are now
    //     rows like others.
    RowIds earlier{box_row(wall->last_pivot(), true), box_row(wall->last_pivot(), false)};
    earlier.insert(earlier.end(), order.begin(), order.begin() + static_cast<std::ptrdiff_t>(i));
    std::variant<Solution, Conflict> on_wall = maximise_on(*wall, earlier);
    if (std::holds_alternative<Conflict>(on_wall)) {
      if (observer != nullptr) observer->inserted({order[i], true, std::nullopt});
      return on_wall;
    }
    best = std::get<Solution>(std::move(on_wall));
    tight_.pop_back();
    if (observer != nullptr) observer->inserted({order[i], true, to_point(best.vertex)});
  }
  return best;
}

// As the caller gave it; box rows are +-e_k.
RationalVector Solver::normal(RowId id) const {
  // Eigen would take a row of no columns by an offset from a null pointer, which is undefined.
  if (dimension_ == 0) return RationalVector(0);
  if (id < count_) return lp_.normals.row(id).transpose();
  RationalVector axis = RationalVector::Zero(static_cast<Eigen::Index>(dimension_));
  const RowId box = id - static_cast<RowId>(count_);
  axis[box / 2] = box % 2 == 0 ? 1 : -1;
  return axis;
}

std::vector<Multiplier> Solver::multipliers(const RowIds& basis,
                                            const std::vector<Rational>& y) const {
  std::vector<Multiplier> positive;
  for (std::size_t i = 0; i < basis.size(); ++i) {
    CONVEXACT_ASSERT(y[i] >= 0);
    if (y[i] == 0) continue;
    CONVEXACT_ASSERT(basis[i] < count_);  // no proof uses a box row
    positive.push_back({basis[i], y[i]});
  }
  return positive;
}

// The point for a value of M that is large enough for every row.
RationalVector Solver::feasible_point(const Vertex& vertex) const {
  Integer infinity = 0;
  for (RowId id = 0; id < count_; ++id) {
    Integer here = row(id)[kFinite] * vertex.denominator, growth = 0;
    for (std::size_t k = 0; k < dimension_; ++k) {
      add_product(here, row(id)[kFirstNormal + k], vertex.finite[k]);
      add_product(growth, row(id)[kFirstNormal + k], vertex.infinite[k]);
    }
    CONVEXACT_ASSERT(growth < 0 || (growth == 0 && here <= 0));
    if (here <= 0) continue;
    Integer needed;
    growth = -growth;
    mpz_cdiv_q(raw(needed), raw(here), raw(growth));
    if (needed > infinity) infinity = needed;
  }
  RationalVector x(static_cast<Eigen::Index>(dimension_));
  for (std::size_t k = 0; k < dimension_; ++k) {
    x[k] = Rational(Integer(vertex.finite[k] + infinity * vertex.infinite[k]), vertex.denominator);
  }
  return x;
}

LpPoint Solver::to_point(const Vertex& vertex) const {
  const auto size = static_cast<Eigen::Index>(dimension_);
  LpPoint point{RationalVector(size), RationalVector(size)};
  for (std::size_t k = 0; k < dimension_; ++k) {
    point.x[k] = Rational(vertex.finite[k], vertex.denominator);
    point.direction[k] = Rational(vertex.infinite[k], vertex.denominator);
  }
  return point;
}

// c = sum of y_i n_i over the basis, y >= 0. The maximum is -sum of y_i d_i, whose part in M is the
// sum of y_i over the box rows: zero, or the direction of growth is a ray.
LpOutcome Solver::certify(const Solution& solution) const {
  std::vector<RationalVector> normals;
  for (const RowId id : solution.basis) normals.push_back(normal(id));
  const std::vector<Rational> y = combination(normals, lp_.objective);
  bool bounded = true;
  for (std::size_t i = 0; i < y.size(); ++i) {
    bounded = bounded && (solution.basis[i] < count_ || y[i] == 0);
  }
  const Vertex& vertex = solution.vertex;
  if (bounded) return Optimal{feasible_point(vertex), multipliers(solution.basis, y)};
  const std::vector<Rational> direction(vertex.infinite.begin(), vertex.infinite.end());
  std::vector<Integer> ray(dimension_);
  make_primitive(direction, ray);
  RationalVector rational_ray(static_cast<Eigen::Index>(dimension_));
  for (std::size_t k = 0; k < dimension_; ++k) rational_ray[k] = ray[k];
  return Unbounded{feasible_point(vertex), std::move(rational_ray)};
}

// On the flat of the others the last row is a positive constant: y'N = 0 and y'd > 0.
Infeasible Solver::certify(const Conflict& conflict) const {
  std::vector<RationalVector> normals;
  for (const RowId id : conflict.rows) normals.push_back(normal(id));
  const RationalVector target = -normals.back();
  normals.pop_back();
  std::vector<Rational> y = combination(normals, target);
  y.push_back(1);
  return Infeasible{multipliers(conflict.rows, y)};
}

LpOutcome Solver::solve() {
  const auto result = maximise_on(Flat(dimension_), order_);
  if (const auto* conflict = std::get_if<Conflict>(&result)) return certify(*conflict);
  return certify(std::get<Solution>(result));
}

}  // namespace

LpOutcome maximise(const LinearProgram& lp, const LpOptions& options) {
  if (lp.offsets.size() != lp.normals.rows() || lp.objective.size() != lp.normals.cols()) {
    throw Error(ErrorCode::InvalidArgument,
                "a linear program needs one offset per row and one objective entry per column");
  }
  return Solver(lp, options).solve();
}

}  // namespace convexact
