// SPDX-License-Identifier: MIT
// DoubleDouble: every operation against rationals, never further off than its unit, and far enough
// off at the worst operands that a search finds for the unit to be needed.
#include "number/double_double.hpp"

#include <doctest/doctest.h>

#include "hill_climb.hpp"

using namespace convexact;

namespace {

Rational exactly(const DoubleDouble& x) { return to_rational(x.hi()) + to_rational(x.lo()); }

// hi + t ulp(hi) / 2 for t in [-1, 1].
DoubleDouble number(double hi, double t) {
  const double half_ulp = std::ldexp(1.0, std::ilogb(hi) - 53);
  return DoubleDouble(hi) + DoubleDouble(t * half_ulp);
}

double ratio_of(const DoubleDouble& computed, const Rational& truth) {
  const Rational error = abs(Rational(exactly(computed) - truth));
  if (truth == 0) return error == 0 ? 0 : 2;
  return Rational(error / abs(truth) / to_rational(DoubleDouble::kUnit)).convert_to<double>();
}

template <class Operation>
void check_operation(const char* name, double least, const Operation& ratio) {
  const double highest =
      hill_climb::highest(4, 30, 800, 7, [&](const std::vector<double>& x) -> double {
        if (x[0] == 0 || x[2] == 0) return 0;
        return ratio(number(x[0], x[1]), number(x[2], x[3]));
      });
  MESSAGE(std::string(name) << ": " << highest << " of the unit is reached");
  CHECK(highest <= 1);
  CHECK(highest > least);
}

}  // namespace

// Sums, products and quotients are proven to 3, 7 and 15 of the sixteen 2^-106 in the unit.
TEST_CASE("DoubleDouble: the unit holds for the worst operands found, and is not vacuous") {
  check_operation("sum", 1.0 / 16, [](const DoubleDouble& x, const DoubleDouble& y) {
    return ratio_of(x + y, exactly(x) + exactly(y));
  });
  check_operation("difference", 1.0 / 16, [](const DoubleDouble& x, const DoubleDouble& y) {
    return ratio_of(x - y, exactly(x) - exactly(y));
  });
  check_operation("product", 1.0 / 8, [](const DoubleDouble& x, const DoubleDouble& y) {
    return ratio_of(x * y, exactly(x) * exactly(y));
  });
  check_operation("quotient", 1.0 / 8, [](const DoubleDouble& x, const DoubleDouble& y) {
    return ratio_of(x / y, exactly(x) / exactly(y));
  });
}

TEST_CASE("DoubleDouble: differences and products of doubles are exact") {
  Random random(3);
  for (int i = 0; i < 2000; ++i) {
    const std::vector<double> x = hill_climb::start(2, random);
    CHECK(exactly(DoubleDouble::difference(x[0], x[1])) == to_rational(x[0]) - to_rational(x[1]));
    CHECK(exactly(DoubleDouble::product(x[0], x[1])) == to_rational(x[0]) * to_rational(x[1]));
  }
}

TEST_CASE("DoubleDouble: order, signs and magnitudes") {
  const DoubleDouble one(1.0), above(1.0, 0x1p-60), below(1.0, -0x1p-60);
  CHECK(below < one);
  CHECK(one < above);
  CHECK(above > below);
  CHECK_FALSE(one < one);
  CHECK_FALSE(above < one);
  CHECK(DoubleDouble(-2.0) < below);
  CHECK(exactly(-above) == -exactly(above));
  CHECK(exactly(abs(-below)) == exactly(below));
  CHECK(exactly(abs(below)) == exactly(below));
  DoubleDouble sum = above;
  sum += below;
  CHECK(exactly(sum) == 2);
}
