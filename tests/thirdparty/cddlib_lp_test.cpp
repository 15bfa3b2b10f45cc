// SPDX-License-Identifier: MIT
// Kinds and values of linear programs, and Chebyshev radii, against cddlib's exact simplex
// [Fukuda, cddlib, built on GMP]: third-party truth.
#include <doctest/doctest.h>

#include "cddlib.hpp"
#include "convexact/linear_program.hpp"
#include "halfspaces.hpp"
#include "linear_programs.hpp"
#include "lp/interior_point.hpp"

using namespace convexact;

namespace {

struct CddAnswer {
  dd_LPStatusType status;
  Rational value;
};

CddAnswer solve_with_cddlib(const LinearProgram& lp) {
  const CddGlobals globals;
  const auto rows = lp.normals.rows(), size = lp.normals.cols();
  dd_MatrixPtr matrix = dd_CreateMatrix(rows, size + 1);
  matrix->representation = dd_Inequality;
  matrix->numbtype = dd_Rational;
  matrix->objective = dd_LPmax;
  // cddlib's rows are (b, A) with b + A x >= 0, so (-d, -N).
  const auto set = [](mpq_t& entry, const Rational& value) {
    mpq_set(entry, value.backend().data());
  };
  for (Eigen::Index i = 0; i < rows; ++i) {
    set(matrix->matrix[i][0], -lp.offsets[i]);
    for (Eigen::Index k = 0; k < size; ++k) set(matrix->matrix[i][k + 1], -lp.normals(i, k));
  }
  for (Eigen::Index k = 0; k < size; ++k) set(matrix->rowvec[k + 1], lp.objective[k]);
  dd_ErrorType error = dd_NoError;
  dd_LPPtr problem = dd_Matrix2LP(matrix, &error);
  REQUIRE(error == dd_NoError);
  dd_LPSolve(problem, dd_CrissCross, &error);
  REQUIRE(error == dd_NoError);
  CddAnswer answer{problem->LPS, 0};
  mpq_set(answer.value.backend().data(), problem->optvalue);
  dd_FreeLPData(problem);
  dd_FreeMatrix(matrix);
  return answer;
}

// cddlib may stop at "no dual solution", which leaves infeasible or unbounded: asked again without
// an objective it can only say optimal (feasible) or inconsistent.
void check_same_outcome(LinearProgram lp) {
  const LpOutcome ours = maximise(lp);
  const CddAnswer theirs = solve_with_cddlib(lp);
  if (const auto* best = std::get_if<Optimal>(&ours)) {
    REQUIRE(theirs.status == dd_Optimal);
    REQUIRE(lp.objective.dot(best->x) == theirs.value);
    return;
  }
  REQUIRE(theirs.status != dd_Optimal);
  lp.objective.setZero();
  const bool feasible = solve_with_cddlib(lp).status == dd_Optimal;
  REQUIRE(feasible == std::holds_alternative<Unbounded>(ours));
}

}  // namespace

TEST_CASE("maximise: cddlib finds the same kind and value") {
  Random random(23);
  for (int repeat = 0; repeat < 1500; ++repeat) {
    CAPTURE(repeat);
    const auto size = static_cast<Eigen::Index>(1 + uniform_below(random, 4));
    const auto rows = static_cast<Eigen::Index>(1 + uniform_below(random, 20));
    LinearProgram lp = data::random_linear_program(random, size, rows, 1 + repeat % 4);
    if (repeat % 3 != 0) lp.offsets = -lp.offsets.cwiseAbs();
    check_same_outcome(lp);
  }
}

TEST_CASE("maximise: cddlib finds the same value for planes close to a sphere") {
  Random random(29);
  for (const Eigen::Index rows : {50, 200}) {
    LinearProgram lp = data::random_linear_program(random, 4, rows, 1000000);
    lp.offsets = -lp.normals.rowwise().squaredNorm() * Rational(1, 1000000);
    lp.normals.col(3) = lp.normals.rowwise().lpNorm<1>();
    check_same_outcome(lp);
  }
}

TEST_CASE("chebyshev_center: cddlib finds the same radius") {
  Random random(31);
  for (int repeat = 0; repeat < 100; ++repeat) {
    auto list = data::centered_box(50, 60, 70);
    for (const Halfspace& h : data::random_halfspaces(random, 20, 30)) {
      if (h.offset() < 0) list.push_back(h);
    }
    LinearProgram lp;
    lp.normals.resize(static_cast<Eigen::Index>(list.size()), 4);
    lp.offsets.resize(lp.normals.rows());
    lp.objective = RationalVector::Unit(4, 3);
    for (std::size_t i = 0; i < list.size(); ++i) {
      for (int k = 0; k < 3; ++k) lp.normals(i, k) = list[i].normal()[k];
      lp.normals(i, 3) = enclose_norm(list[i].normal()).upper;
      lp.offsets[i] = list[i].offset();
    }
    const CddAnswer theirs = solve_with_cddlib(lp);
    REQUIRE(theirs.status == dd_Optimal);
    REQUIRE(theirs.value == std::get<ChebyshevCenter>(chebyshev_center(list)).optimum_radius);
  }
}
