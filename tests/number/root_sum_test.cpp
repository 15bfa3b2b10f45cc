// SPDX-License-Identifier: MIT
// Sums of roots. Expected orders come from squaring, from differences of sqrt of any order, from
// Pell's equation, from sums that are made to be equal, and from MPFR at 2,000 bits.
#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <tuple>
#include <vector>

#include "convexact/cost.hpp"
#include "expect_error.hpp"
#include "property.hpp"
using namespace convexact;

namespace {

RootSum root(const Rational& radicand, const Rational& factor = 1) {
  RootSum sum;
  sum.add(factor, radicand);
  return sum;
}

RootSum roots(const std::vector<int>& radicands) {
  RootSum sum;
  for (const int n : radicands) sum.add(1, n);
  return sum;
}

// The sign in MPFR's own arithmetic, rounded to nearest. No sum in this file that is not zero comes
// closer to it than 2^-1900.
int sign_at_2000_bits(const RootSum& sum) {
  BigFloat total(2000), term(2000);
  for (const auto& [factor, radicand] : sum.terms()) {
    mpfr_set_z(term.data(), radicand.backend().data(), MPFR_RNDN);
    mpfr_sqrt(term.data(), term.data(), MPFR_RNDN);
    mpfr_mul_q(term.data(), term.data(), factor.backend().data(), MPFR_RNDN);
    mpfr_add(total.data(), total.data(), term.data(), MPFR_RNDN);
  }
  BigFloat least(53);
  mpfr_set_ui_2exp(least.data(), 1, -1900, MPFR_RNDN);
  return mpfr_cmpabs(total.data(), least.data()) < 0 ? 0 : mpfr_sgn(total.data());
}

Order order_of_sign(int sign) {
  return sign < 0 ? Order::Less : sign > 0 ? Order::Greater : Order::Equal;
}

void check_tie(const RootSum& a, const RootSum& b, TieProof proof) {
  const Ordering comparison = compare(a, b);
  CHECK(comparison.order == Order::Equal);
  CHECK(comparison.tie_proof == proof);
}

// A factor over another number, a radicand, and a number whose square enlarges it.
using Draw = std::tuple<std::int16_t, std::uint8_t, std::uint32_t, std::uint16_t>;

Rational factor_of(const Draw& d) { return Rational(int(std::get<0>(d)), int(std::get<1>(d)) + 1); }
Integer radicand_of(const Draw& d) { return Integer(std::get<2>(d)) + 1; }
Integer square_of(const Draw& d) { return Integer(std::get<3>(d)) + 1; }

}  // namespace

TEST_CASE("root_sum: terms are sorted, merged, and never zero") {
  RootSum sum = root(3) + root(2) + root(3, 2);
  REQUIRE(sum.terms().size() == 2);
  CHECK(sum.terms()[0].radicand == 2);
  CHECK(sum.terms()[1].factor == 3);
  CHECK((sum - sum).terms().empty());
  CHECK((sum *= 0).terms().empty());
  CHECK(root(0).terms().empty());
  CHECK(root(2, 0).terms().empty());
  CHECK((root(5) + root(5, -1)).terms().empty());
  CHECK(RootSum({{1, 7}, {2, 5}, {-1, 7}}).terms().size() == 1);
  CHECK(error_of([] { return root(-1); }).code() == ErrorCode::InvalidArgument);
  CHECK(error_of([] {
          return RootSum(std::vector<RootTerm>{{1, 0}});
        }).code() == ErrorCode::InvalidArgument);
}

TEST_CASE("root_sum: the root of a fraction is one of an integer") {
  const RootSum half = root(Rational(1, 2));  // sqrt(2) / 2
  REQUIRE(half.terms().size() == 1);
  CHECK(half.terms()[0].factor == Rational(1, 2));
  CHECK(half.terms()[0].radicand == 2);
}

TEST_CASE("root_sum: an enclosure holds the number, as its square says") {
  const Enclosure sum = (root(2) + root(3)).enclose(300);  // its square is 5 + 2 sqrt(6)
  const Enclosure difference = sum * sum - (RootSum(5) + root(6, 2)).enclose(300);
  CHECK(difference.low() <= 0);
  CHECK(difference.high() >= 0);
  CHECK(difference.width() < scale_by_power_of_two(Rational(1), -290));
  CHECK(RootSum().enclose(10).sign() == Sign::Zero);
}

TEST_CASE("root_sum: order to fractions as near as one likes, by squaring") {
  // x = sqrt(2) + sqrt(3) > p/q if and only if sqrt(6) > (p^2/q^2 - 5)/2, whose sides are positive.
  const RootSum x = root(2) + root(3);
  for (const long bits : {10, 50, 53, 60, 120, 127, 128, 250, 1000, 5000}) {
    CAPTURE(bits);
    const Rational low = x.enclose(bits).low(), high = x.enclose(bits).high();
    for (const Rational& y : {low, high}) {
      const Rational half = (y * y - 5) / 2;
      REQUIRE(half > 0);
      CHECK(compare(x, y).order == (half * half < 6 ? Order::Greater : Order::Less));
      CHECK(compare(y, x).order == (half * half < 6 ? Order::Less : Order::Greater));
    }
  }
}

TEST_CASE("root_sum: ties within a square class") {
  check_tie(root(8), root(2, 2), TieProof::SquareClasses);
  check_tie(root(50) + root(18), root(2, 8), TieProof::SquareClasses);
  check_tie(root(3 * 49), root(3, 7), TieProof::SquareClasses);
  check_tie(root(Rational(1, 12)) + root(Rational(3, 4)), root(Rational(16, 12)),
            TieProof::SquareClasses);
  check_tie(root(2) + root(3), root(3) + root(2), TieProof::SquareClasses);
  check_tie(root(4) + root(9), RootSum(5), TieProof::EqualRationals);
  check_tie(root(Rational(1, 9)), RootSum(Rational(1, 3)), TieProof::EqualRationals);
  check_tie(RootSum(), RootSum(), TieProof::EqualRationals);
}

TEST_CASE("root_sum: mirror images have the radicands 1 and 25") {
  // A facet of area 2 with the normal (1, 0, 0), and its image under (3, 4; 4, -3)/5: its primitive
  // normal is (3, 4, 0), so that its area is (2/5) sqrt(25).
  check_tie(RootSum(2) + root(7), root(25, Rational(2, 5)) + root(7), TieProof::SquareClasses);
  check_tie(RootSum(2), root(25, Rational(2, 5)), TieProof::EqualRationals);
  CHECK(compare(RootSum(2), root(25, Rational(2, 5)) + root(2, scale_by_power_of_two(1, -400)))
            .order == Order::Less);
}

TEST_CASE("root_sum: the areas of two corners of a box tie by accident") {
  // Legs 3, 1, 3 and 1, 1, 7: (xy + yz + zx - sqrt(x^2 y^2 + y^2 z^2 + z^2 x^2)) / 2.
  const auto corner = [](int x, int y, int z) {
    const Rational half(1, 2);
    return RootSum(half * (x * y + y * z + z * x)) -
           root(x * x * y * y + y * y * z * z + z * z * x * x, half);
  };
  check_tie(corner(3, 1, 3), corner(1, 1, 7), TieProof::SquareClasses);
  CHECK(compare(corner(3, 1, 3), corner(1, 1, 6)).order == Order::Greater);
}

TEST_CASE("root_sum: sums that agree in 40 digits") {
  // Two sums of nine roots whose difference is -3.3134865714985754e-37. [TOPP, problem 33]
  const RootSum a = roots({1000001, 1000025, 1000031, 1000084, 1000087, 1000134, 1000158, 1000182,
                           1000198}),
                b = roots({1000002, 1000018, 1000042, 1000066, 1000113, 1000116, 1000169, 1000175,
                           1000199});
  const Ordering comparison = compare(a, b);
  CHECK(comparison.order == Order::Less);
  CHECK(comparison.bits == 256);
  CHECK(!comparison.tie_proof);
  CHECK(to_decimal(a - b, 15) == "-3.31348657149858e-37");
}

TEST_CASE("root_sum: differences of sqrt of high order") {
  // The k-th forward difference of f is f^(k) somewhere between, and the derivatives of sqrt have
  // the signs +, -, +, ... Its size is about n^(1/2 - k).
  const Integer n("1000000000000");
  for (const int k : {1, 2, 5, 10, 20, 40}) {
    CAPTURE(k);
    RootSum even, odd;
    Integer binomial = 1;
    for (int i = 0; i <= k; ++i) {
      ((k - i) % 2 == 0 ? even : odd).add(Rational(binomial), Rational(n + i));
      binomial = binomial * (k - i) / (i + 1);
    }
    const Ordering comparison = compare(even, odd);
    CHECK(comparison.order == (k % 2 == 1 ? Order::Greater : Order::Less));
    if (k == 40) CHECK(comparison.bits == 2048);  // 10^(12 * 39.5) is 2^1575
    CHECK(compare(even, even + odd - odd).order == Order::Equal);
  }
}

TEST_CASE("root_sum: solutions of Pell's equation, near the ends of each precision") {
  // p^2 - 2 q^2 = +-1 in turn, so p - q sqrt(2) has that sign and the size 1/(2p).
  Integer p = 1, q = 1;  // p^2 - 2 q^2 = -1
  for (int sign = -1; p < Integer(1) << 1100; sign = -sign) {
    const Ordering comparison = compare(Rational(p), root(2, Rational(q)));
    CAPTURE(p);
    CHECK(comparison.order == order_of_sign(sign));
    // The difference is about 2^-(2 b) of its terms, p having b bits.
    const auto b = static_cast<long>(bit_length(p));
    CHECK(comparison.bits > 2 * b - 8);
    CHECK(comparison.bits <= std::max(2 * (2 * b + 16), 2 * 128L));
    const Integer next = p + 2 * q;
    q = p + q;
    p = next;
  }
}

TEST_CASE("root_sum: doubles do not decide what their rounding may have decided") {
  const Rational nearest = to_rational(1.4142135623730951);  // above sqrt(2), by 10^-16
  CHECK(compare(root(2), nearest).order == Order::Less);
  CHECK(compare(root(2), nearest).bits == 128);
  CHECK(compare(root(2), nearest * 2).bits == 53);
  CHECK(compare(root(2), Rational(1)).order == Order::Greater);
}

TEST_CASE("root_sum: numbers beyond doubles") {
  const Rational huge = scale_by_power_of_two(1, 5000), tiny = scale_by_power_of_two(1, -5000);
  CHECK(compare(root(huge), root(huge + 1)).order == Order::Less);
  CHECK(compare(root(2, tiny), root(3, tiny)).order == Order::Less);
  CHECK(compare(root(2, huge) + root(3), root(2, huge) + root(2)).order == Order::Greater);
  CHECK(compare(root(2, huge) + root(3, tiny), root(2, huge)).order == Order::Greater);
  CHECK(compare(root(huge * huge * 2), root(2, huge)).tie_proof == TieProof::SquareClasses);
  CHECK(compare(root(2, tiny), RootSum()).order == Order::Greater);
}

TEST_CASE("root_sum: random sums that are made to be equal, and nudged") {
  check_property("ties", [](const std::vector<Draw>& drawn, std::uint16_t shift) {
    RootSum a, b;
    bool has_term = false;
    for (const Draw& d : drawn) {
      const Rational factor = factor_of(d);
      const Integer radicand = radicand_of(d), square = square_of(d);
      a.add(factor, Rational(radicand));
      // The same in two parts, with other radicands.
      const Rational part = factor / 3;
      b.add(part / Rational(square), Rational(Integer(radicand * square * square)));
      b.add(factor - part, Rational(radicand));
      has_term = true;
    }
    const Ordering tie = compare(a, b);
    RC_ASSERT(tie.order == Order::Equal);
    RC_ASSERT(tie.tie_proof.has_value());
    RC_ASSERT(a.normalized().terms().size() == b.normalized().terms().size());
    RC_ASSERT((a - b).normalized().terms().empty());
    if (!has_term) return;
    RootSum nudge;
    nudge.add(scale_by_power_of_two(1, -(shift % 1500)), 7);
    RC_ASSERT(compare(a + nudge, b).order == Order::Greater);
    RC_ASSERT(compare(a, b + nudge).order == Order::Less);
  });
}

TEST_CASE("root_sum: signs of random sums are those of 2,000 bits") {
  check_property("signs", [](const std::vector<Draw>& drawn, std::uint8_t bits) {
    RootSum sum;
    for (const Draw& d : drawn) sum.add(factor_of(d), Rational(radicand_of(d)));
    // Less a number close to it, so that doubles seldom decide.
    const RootSum near = sum.enclose(40 + bits).low();
    RC_ASSERT(compare(sum, RootSum()).order == order_of_sign(sign_at_2000_bits(sum)));
    RC_ASSERT(compare(sum, near).order == order_of_sign(sign_at_2000_bits(sum - near)));
  });
}

TEST_CASE("root_sum: one term for each square class") {
  const RootSum sum =
      (root(49) + root(147) + root(12) + root(Rational(1, 3)) + RootSum(1)).normalized();
  REQUIRE(sum.terms().size() == 2);
  CHECK(sum.terms()[0].radicand == 1);
  CHECK(sum.terms()[0].factor == 8);
  CHECK(sum.terms()[1].radicand == 3);
  CHECK(sum.terms()[1].factor == Rational(28, 3));  // 7 + 2 + 1/3
}

TEST_CASE("root_sum: decimals") {
  CHECK(to_decimal(root(2) + root(3), 20) == "3.1462643699419723423");
  CHECK(to_decimal(RootSum(Rational(1, 2)), 20) == "0.5");
  CHECK(to_decimal(root(4), 20) == "2");
  CHECK(to_decimal(root(8) - root(2, 2), 20) == "0");
  CHECK(to_decimal(RootSum(Rational(3, 8)) - root(3, Rational(1, 8)), 18) ==
        "0.158493649053890338");
}

TEST_CASE("root_sum: a comparison can be stopped") {
  const std::atomic<bool> stop = true;
  const RootSum a = root(2), b = to_rational(1.4142135623730951);
  CHECK(error_of([&] { return compare(a, b, Watch(&stop)); }).code() == ErrorCode::Stopped);
}
