// SPDX-License-Identifier: MIT
// Statistics of repeated measurements and sizes of errors, against closed forms.
#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "lab/report/errors.hpp"
#include "lab/report/tightness_curve.hpp"
#include "lab/report/timing.hpp"

using namespace convexact;

TEST_CASE("statistics: the median is the middle one, or half way between the two") {
  CHECK(median({7}) == 7);
  CHECK(median({3, 1, 2}) == 2);
  CHECK(median({4, 1, 3, 2}) == 2.5);
  const Spread spread = spread_of({5, 1, 9});
  CHECK(spread.least == 1);
  CHECK(spread.median == 5);
  CHECK(spread.most == 9);
  CHECK(spread.repetitions == 3);
}

TEST_CASE("statistics: a power law is found exactly, with no error of its exponent") {
  const std::array<std::pair<double, double>, 4> points{{{1, 3}, {2, 12}, {4, 48}, {8, 192}}};
  const auto law = fit_power_law(points);
  REQUIRE(law.has_value());
  CHECK(law->exponent == doctest::Approx(2));
  CHECK(law->factor == doctest::Approx(3));
  CHECK(std::abs(law->standard_error) < 1e-12);
}

// With logarithms x = -1, 0, 1 and y = 0, a, 0 (base e): slope 0, mean a/3, residuals
// -a/3, 2a/3, -a/3, their squares sum to 6 a^2 / 9; over n - 2 = 1 and sum x^2 = 2: a / sqrt(3).
TEST_CASE("statistics: the standard error of an exponent is that of the textbook") {
  const double e = std::exp(1.0), a = 0.3;
  const std::array<std::pair<double, double>, 3> points{{{1 / e, 1}, {1, std::exp(a)}, {e, 1}}};
  const auto law = fit_power_law(points);
  REQUIRE(law.has_value());
  CHECK(std::abs(law->exponent) < 1e-12);
  CHECK(law->factor == doctest::Approx(std::exp(a / 3)));
  CHECK(law->standard_error == doctest::Approx(a / std::sqrt(3.0)));
}

TEST_CASE("statistics: no law through fewer than three sizes") {
  const std::array<std::pair<double, double>, 4> points{{{1, 3}, {2, 12}, {2, 13}, {1, 4}}};
  CHECK_FALSE(fit_power_law(points).has_value());
  CHECK_FALSE(fit_power_law({}).has_value());
}

TEST_CASE("error size: powers of two, also far below the smallest double") {
  CHECK(error_size(Rational(0)).is_exact());
  CHECK(error_size(Rational(0)).value == 0);
  const ErrorSize half = error_size(Rational(-1, 2));
  CHECK(half.value == 0.5);
  CHECK(half.bits == 1);
  const ErrorSize tiny = error_size(scale_by_power_of_two(Rational(1), -5000));
  CHECK(tiny.value == 0);
  CHECK(tiny.bits == 5000);
  CHECK_FALSE(tiny.is_exact());
  CHECK(error_size(Rational(3)).bits == doctest::Approx(-std::log2(3.0)));
  CHECK(root_size(Rational(1, 16)).value == 0.25);
  CHECK(root_size(Rational(0)).is_exact());
  CHECK(relative_error(Rational(9), Rational(8)).value == 0.125);
  CHECK(relative_error(Rational(-9), Rational(-8)).bits == 3);
  CHECK(relative_error(Rational(0), Rational(0)).is_exact());
  CHECK(tiny < half);  // the larger error is the worse one
}

TEST_CASE("spaced by ratio: both ends, ascending, each once") {
  CHECK(spaced_by_ratio(4, 64, 5) == std::vector<std::size_t>{4, 8, 16, 32, 64});
  CHECK(spaced_by_ratio(4, 6, 28) == std::vector<std::size_t>{4, 5, 6});
  CHECK(spaced_by_ratio(4, 4, 28) == std::vector<std::size_t>{4});
}
