// SPDX-License-Identifier: MIT
// Sums of roots times angles. Expected orders come from identities of elementary geometry and of
// complex numbers (arguments of a product add up), and from MPFR at 2,000 bits.
#include <doctest/doctest.h>

#include <atomic>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include "convexact/cost.hpp"
#include "expect_error.hpp"
#include "property.hpp"
#include "sweep.hpp"
using namespace convexact;

namespace {

// The angle with tan = sqrt(squared_cross) / dot.
AngleSum angle(const Integer& squared_cross, const Integer& dot, const Rational& factor = 1,
               const Rational& squared_length = 1) {
  return AngleSum({{factor, squared_length, squared_cross, dot}});
}
// factor * atan(1 / n).
AngleSum inverse(int n, int factor) { return angle(1, n, factor); }
AngleSum pi(const Rational& factor) { return AngleSum::pi(factor); }

AngleSum stretched(const AngleSum& sum, const Rational& squared_length) {
  std::vector<AngleTerm> terms = sum.terms();
  for (AngleTerm& term : terms) term.squared_length *= squared_length;
  return AngleSum(std::move(terms));
}

// The sign in MPFR's own arithmetic, rounded to nearest. No sum in this file that is not zero comes
// closer to it than 2^-1800.
int sign_at_2000_bits(const AngleSum& sum) {
  BigFloat total(2000), root(2000), x(2000);
  for (const AngleTerm& term : sum.terms()) {
    mpfr_set_z(root.data(), term.squared_cross.backend().data(), MPFR_RNDN);
    mpfr_sqrt(root.data(), root.data(), MPFR_RNDN);
    mpfr_set_z(x.data(), term.dot.backend().data(), MPFR_RNDN);
    mpfr_atan2(x.data(), root.data(), x.data(), MPFR_RNDN);
    mpfr_set_q(root.data(), term.squared_length.backend().data(), MPFR_RNDN);
    mpfr_sqrt(root.data(), root.data(), MPFR_RNDN);
    mpfr_mul(x.data(), x.data(), root.data(), MPFR_RNDN);
    mpfr_mul_q(x.data(), x.data(), term.factor.backend().data(), MPFR_RNDN);
    mpfr_add(total.data(), total.data(), x.data(), MPFR_RNDN);
  }
  BigFloat least(53);
  mpfr_set_ui_2exp(least.data(), 1, -1800, MPFR_RNDN);
  return mpfr_cmpabs(total.data(), least.data()) < 0 ? 0 : mpfr_sgn(total.data());
}

Order order_at_2000_bits(const AngleSum& a, const AngleSum& b) {
  const int sign = sign_at_2000_bits(a - b);
  return sign < 0 ? Order::Less : sign > 0 ? Order::Greater : Order::Equal;
}

// A tie, and none any more once one side is larger by a little.
void check_tie(const AngleSum& a, const AngleSum& b, TieProof proof) {
  const Ordering tie = compare(a, b);
  CHECK(tie.order == Order::Equal);
  CHECK(tie.tie_proof == proof);
  CHECK(tie.bits <= 256);
  const AngleSum nudge = pi(scale_by_power_of_two(1, -300));
  const Ordering after = compare(a, b + nudge), before = compare(a, b - nudge);
  CHECK(after.order == Order::Less);
  CHECK(before.order == Order::Greater);
  CHECK(!after.tie_proof);
}

// x + y sqrt(-d), y > 0, whose argument is that of (x, sqrt(d y^2)).
struct Number {
  Integer x, y;
};
AngleSum argument(const Number& z, const Integer& d, const Rational& factor = 1) {
  return angle(d * z.y * z.y, z.x, factor);
}
Number product(const Number& z, const Number& w, const Integer& d) {
  return {z.x * w.x - d * z.y * w.y, z.x * w.y + z.y * w.x};
}
// The sum of the arguments of two numbers from that of their product, which is in (0, 2 pi).
AngleSum argument_of_product(const Number& z, const Number& w, const Integer& d) {
  const Number p = product(z, w, d);
  if (p.y > 0) return argument(p, d);
  if (p.y < 0) return pi(2) - argument({p.x, -p.y}, d);
  return pi(1);
}

}  // namespace

TEST_CASE("angle_sum: terms are merged, and never zero") {
  CHECK(AngleSum().terms().empty());
  CHECK(angle(0, 5).terms().empty());
  CHECK(angle(1, 1, 0).terms().empty());
  CHECK(angle(1, 1, 1, 0).terms().empty());
  CHECK((angle(2, 3) - angle(2, 3)).terms().empty());
  CHECK((angle(2, 3) + angle(2, -3) + angle(2, 3)).terms().size() == 2);
  CHECK((angle(2, 3) *= 0).terms().empty());
  CHECK(error_of([] { return angle(0, 0); }).code() == ErrorCode::InvalidArgument);
  CHECK(error_of([] { return angle(-1, 1); }).code() == ErrorCode::InvalidArgument);
  CHECK(error_of([] { return angle(1, 1, 1, -1); }).code() == ErrorCode::InvalidArgument);
}

TEST_CASE("angle_sum: an enclosure holds the number") {
  const Enclosure x = (pi(1) - angle(3, 1, 3)).enclose(200);  // 3 pi/3 = pi
  CHECK(x.contains(0));
  CHECK(x.width() < scale_by_power_of_two(1, -190));
  // Of the cube with edge 1: 12 edges with pi/2, 4 pi times 3/2.
  CHECK((angle(1, 0, 12) - pi(6)).enclose(64).contains(0));
  CHECK(AngleSum().enclose(10).sign() == Sign::Zero);
}

TEST_CASE("angle_sum: order of plain numbers") {
  CHECK(compare(angle(1, 2), angle(1, 1)).order == Order::Less);
  CHECK(compare(angle(1, 2), angle(1, 1)).bits == 128);
  CHECK(compare(angle(1, 1), angle(1, 2)).order == Order::Greater);
  CHECK(compare(angle(1, 1, 1, 4), pi(1)).order == Order::Less);
  CHECK(compare(AngleSum(), AngleSum()).order == Order::Equal);
  CHECK(compare(AngleSum(), AngleSum()).tie_proof == TieProof::NormalForm);
}

TEST_CASE("angle_sum: the normal form proves supplements, complements and multiples of pi") {
  check_tie(angle(5, -3), pi(1) - angle(5, 3), TieProof::NormalForm);
  check_tie(angle(1, 2) + angle(4, 1), pi(Rational(1, 2)), TieProof::NormalForm);
  check_tie(angle(144, 5) + angle(25, 12), pi(Rational(1, 2)), TieProof::NormalForm);
  check_tie(angle(3, 1), pi(Rational(1, 3)), TieProof::NormalForm);
  check_tie(angle(1, 3) - angle(4, 6), AngleSum(), TieProof::NormalForm);
  check_tie(angle(1, -1), pi(Rational(3, 4)), TieProof::NormalForm);
  check_tie(angle(4, -2) + angle(27, 9) + angle(3, 1), pi(Rational(3, 4) + Rational(1, 2)),
            TieProof::NormalForm);
  check_tie(angle(3, -1) + angle(1, 0) + angle(3, -3), pi(2), TieProof::NormalForm);
}

TEST_CASE("angle_sum: lengths of one square class are multiples of each other") {
  check_tie(angle(2, 3, 1, 8), angle(2, 3, 2, 2), TieProof::NormalForm);
  check_tie(angle(2, 3, 1, Rational(1, 12)), angle(8, 6, Rational(1, 6), 3), TieProof::NormalForm);
  check_tie(angle(1, 5, 1, 147) + angle(25, 1, 7, 3), stretched(pi(Rational(7, 2)), 3),
            TieProof::NormalForm);
  // Lengths of different classes never cancel.
  CHECK(compare(angle(1, 5, 1, 2), angle(1, 5, 1, 3)).order == Order::Less);
}

TEST_CASE("angle_sum: mirror images tie by the normal form") {
  // Between the normals (1, 1, 1) and (1, 0, 2), and their images under (3, 4, 0; 4, -3, 0; 0, 0,
  // 5) over 5, with the primitive normals (7, 1, 5) and (3, 4, 10); lengths are the same.
  check_tie(angle(6, 3, 1, 6), angle(3750, 75, 1, 6), TieProof::NormalForm);
}

TEST_CASE("angle_sum: two cuts of a prism tie by accident") {
  // Removing the cut of a vertical edge of a box of height 3 adds two legs above and two below,
  // takes two hypotenuses away, and turns two vertical edges into one.
  const auto cut = [](int x, int y, int hypotenuse) {
    return angle(1, 0, 2 * (x + y - hypotenuse)) + angle(1, 0, 1, 9) -
           angle(Integer(x) * x, y, 1, 9) - angle(Integer(y) * y, x, 1, 9);
  };
  check_tie(cut(5, 12, 13), cut(6, 8, 10), TieProof::NormalForm);
  check_tie(cut(5, 12, 13), pi(4), TieProof::NormalForm);  // 4 pi times 1
}

TEST_CASE("angle_sum: the tetrahedron and the cuboctahedron have the same mean width") {
  // Vertices (+-1, +-1, +-1) with an even number of -1: 6 edges of sqrt(8), acos(-1/3).
  // Permutations of (+-1, +-1, 0): 24 edges of sqrt(2), acos(1/sqrt(3)).
  const AngleSum tetrahedron = angle(8, -1, 6, 8), cuboctahedron = angle(2, 1, 24, 2);
  check_tie(tetrahedron, cuboctahedron, TieProof::AngleBasis);
  check_tie(angle(8, -1), angle(2, 1, 2), TieProof::AngleBasis);  // acos(-1/3) = 2 acos(1/sqrt(3))
  const Enclosure width =
      tetrahedron.enclose(128) / (Enclosure(Integer(4), 128) * Enclosure::pi(128));
  CHECK(to_decimal(width, 19) == "2.580261415180569185");
  const Ordering undecided = compare(tetrahedron, cuboctahedron, {1000, false});
  CHECK(undecided.order == Order::Undecided);
  CHECK(undecided.tie_proof == TieProof::Undecided);
  CHECK(undecided.bits == 1000);
  // The octahedron with vertices +-e_i is no such case.
  CHECK(compare(angle(8, 1, 12, 2), cuboctahedron).order == Order::Less);
}

TEST_CASE("angle_sum: formulas of Machin's kind") {
  const AngleSum quarter = pi(Rational(1, 4));
  check_tie(inverse(5, 4) - inverse(239, 1), quarter, TieProof::AngleBasis);  // Machin
  check_tie(inverse(2, 1) + inverse(3, 1), quarter, TieProof::AngleBasis);    // Euler
  check_tie(inverse(3, 2) + inverse(7, 1), quarter, TieProof::AngleBasis);    // Hutton
  check_tie(inverse(2, 2) - inverse(7, 1), quarter, TieProof::AngleBasis);    // Hermann
  check_tie(inverse(18, 12) + inverse(57, 8) - inverse(239, 5), quarter, TieProof::AngleBasis);
  check_tie(inverse(57, 44) + inverse(239, 7) - inverse(682, 12) + inverse(12943, 24), quarter,
            TieProof::AngleBasis);  // Stormer
  // Off by a multiple of pi, or by the last bit of a factor.
  CHECK(compare(inverse(5, 4) - inverse(239, 1), pi(Rational(5, 4))).order == Order::Less);
  CHECK(compare(inverse(2, 1) + inverse(3, 2), quarter).order == Order::Greater);
  CHECK(compare(angle(1, 5, 4 + scale_by_power_of_two(1, -700)) - inverse(239, 1), quarter).order ==
        Order::Greater);
}

TEST_CASE("angle_sum: the angle basis looks at each square class of lengths alone") {
  const AngleSum machin = inverse(5, 4) - inverse(239, 1) - pi(Rational(1, 4)),
                 euler = inverse(2, 1) + inverse(3, 1) - pi(Rational(1, 4));
  check_tie(stretched(machin, 2) + stretched(euler, 3), AngleSum(), TieProof::AngleBasis);
  check_tie(stretched(machin, 2), stretched(euler, Rational(5, 7)), TieProof::AngleBasis);
  check_tie(stretched(machin, 8) + stretched(euler, 2), AngleSum(), TieProof::AngleBasis);
  const AngleSum nudge = stretched(pi(scale_by_power_of_two(1, -400)), 3);
  CHECK(compare(stretched(machin, 2) + nudge, stretched(euler, 3)).order == Order::Greater);
}

TEST_CASE("angle_sum: powers of a number whose norm is a power of 2") {
  // In Q(sqrt(-7)), 2 splits: (1 + sqrt(-7))/2 has the norm 2, its square is (-3 + sqrt(-7))/2.
  check_tie(angle(7, -3), angle(7, 1, 2), TieProof::AngleBasis);
  // Its cube is (-5 - sqrt(-7))/2, beyond pi.
  check_tie(pi(2) - angle(7, -5), angle(7, 1, 3), TieProof::AngleBasis);
  check_tie(angle(28, 2, 3) + angle(63, -15), pi(2), TieProof::AngleBasis);
  // In Q(sqrt(-15)), (1 + sqrt(-15))/2 has the norm 4 and the square (-7 + sqrt(-15))/2.
  check_tie(angle(15, -7), angle(15, 1, 2), TieProof::AngleBasis);
  CHECK(compare(angle(15, -7), angle(7, 1, 2)).order ==
        order_at_2000_bits(angle(15, -7), angle(7, 1, 2)));
}

TEST_CASE("angle_sum: arguments of products add up, in every field") {
  check_property(
      "products", [](std::uint8_t field, const std::tuple<std::int32_t, std::uint16_t>& a,
                     const std::tuple<std::int32_t, std::uint16_t>& b, std::uint8_t s) {
        const Integer d = Integer(field) + 1;  // with squares, too
        const Number z{std::get<0>(a), Integer(std::get<1>(a)) + 1},
            w{std::get<0>(b), Integer(std::get<1>(b)) + 1};
        const AngleSum sum = argument(z, d) + argument(w, d), same = argument_of_product(z, w, d);
        const Ordering tie = compare(stretched(sum, s + 1), stretched(same, s + 1));
        RC_ASSERT(tie.order == Order::Equal);
        RC_ASSERT(tie.bits <= 256);
        const AngleSum other = argument_of_product({z.x + 1, z.y}, w, d);
        RC_ASSERT(compare(sum, other).order == order_at_2000_bits(sum, other));
        RC_ASSERT(compare(sum, other).order != Order::Equal);
      });
}

TEST_CASE("angle_sum: norms that no one factors" * sweep) {
  check_property("long products", [](const std::tuple<std::uint64_t, std::uint64_t>& a,
                                     const std::tuple<std::uint64_t, std::uint64_t>& b,
                                     const std::tuple<std::uint64_t, std::uint64_t>& c,
                                     std::uint32_t field) {
    const Integer d = Integer(field) + 1;
    const auto number = [](const std::tuple<std::uint64_t, std::uint64_t>& pair) {
      return Number{Integer(std::get<0>(pair)) + 1, Integer(std::get<1>(pair)) + 1};
    };
    const Number z = number(a), w = number(b), v = number(c);
    // arg(z w) + arg(z v) - arg(w) - arg(v) = 2 arg(z), but for turns: a relation between norms
    // with common factors, all of them unknown.
    const AngleSum left = argument_of_product(z, w, d) + argument_of_product(z, v, d),
                   right = argument(w, d) + argument(v, d) + argument(z, d, 2);
    RC_ASSERT(compare(left, right).order == Order::Equal);
    // And the contrary, which enclosures do not see.
    RC_ASSERT(compare(left, right + pi(scale_by_power_of_two(1, -5000))).order == Order::Less);
    RC_ASSERT(compare(left + pi(scale_by_power_of_two(1, -5000)), right).order == Order::Greater);
  });
}

TEST_CASE("angle_sum: random sums that are congruent, and signs at 2,000 bits") {
  using Term = std::tuple<std::int8_t, std::uint16_t, std::uint16_t, std::int16_t, std::uint8_t>;
  check_property("terms", [](const std::vector<Term>& drawn) {
    AngleSum a, b;
    for (const auto& [factor, length, cross, dot, scale] : drawn) {
      if (cross == 0 && dot == 0) continue;
      const Integer k = Integer(scale) + 1;
      a += angle(cross, dot, int(factor), int(length));
      b += angle(cross * k * k, dot * k, Rational(int(factor)) / Rational(k),
                 Rational(Integer(int(length) * k * k)));
    }
    RC_ASSERT(compare(a, b).order == Order::Equal);
    RC_ASSERT(compare(a, b).tie_proof == TieProof::NormalForm);
    RC_ASSERT(compare(a, AngleSum()).order == order_at_2000_bits(a, AngleSum()));
  });
}

TEST_CASE("angle_sum: the limit of bits") {
  // p/q is close to sqrt(2) by 2^-n, n a little above 280 or 6000.
  const auto above = [](int bits) {
    Integer p = 1, q = 1;
    for (int sign = -1; sign < 0 || bit_length(p) + bit_length(q) < std::size_t(bits);
         sign = -sign) {
      const Integer next = p + 2 * q;
      q = p + q;
      p = next;
    }
    const Rational ratio(p, q);
    return pi(ratio);
  };
  const AngleSum root = angle(0, -1, 1, 2);
  const auto undecided_at = [&](int bits, const CompareLimits& limits) {
    const Ordering comparison = compare(root, above(bits), limits);
    CHECK((comparison.order == Order::Undecided) == (comparison.tie_proof == TieProof::Undecided));
    CHECK((comparison.order == Order::Undecided || comparison.order == Order::Less));
    CHECK(comparison.bits <= limits.bits);
    return comparison.order == Order::Undecided;
  };
  for (const long bits : {1, 2, 127, 128, 129, 255, 256, 257, 276}) {
    CHECK(undecided_at(280, {bits, false}));
  }
  for (const long bits : {300, 511, 512, 513, 4096}) CHECK(!undecided_at(280, {bits, false}));
  CHECK(compare(root, above(280), {4096, false}).bits == 512);
  CHECK(compare(root, above(280), {300, false}).bits == 300);
  CHECK(undecided_at(6000, {4096, false}));
  // The basis shows that they differ, and so there is no need for a limit.
  CHECK(compare(root, above(6000)).order == Order::Less);
  CHECK(compare(root, above(6000)).bits == 8192);
  CHECK(compare(above(6000), root, {1, true}).order == Order::Greater);
  CHECK(error_of([&] {
          return compare(root, root, {0, true});
        }).code() == ErrorCode::InvalidArgument);
}

TEST_CASE("angle_sum: a fraction of pi that is close to an angle is not that angle") {
  // The distance of a convergent p/q of angle / pi is below 1/q^2, far below the distance pi/q of
  // multiples of pi/q: only the primes of the norm tell that there is no relation. The norms are
  // powers of 2 in Q(sqrt(-7)) and Q(sqrt(-15)), and 5, 3, 7, 36 and a long number elsewhere.
  for (const auto& tangent : std::vector<std::pair<Integer, Integer>>{
           {7, 1}, {15, 1}, {1, 2}, {2, 1}, {3, 2}, {28, -2}, {5 * 7, 1}, {1, Integer(1) << 70}}) {
    CAPTURE(tangent.first);
    const AngleSum x = angle(tangent.first, tangent.second);
    Rational rest = (x.enclose(1000) / Enclosure::pi(1000)).low();
    Integer p = 1, q = 0, last_p = 0, last_q = 1;
    while (bit_length(q) < 200) {
      const Integer whole = numerator(rest) / denominator(rest);
      const Integer next_p = whole * p + last_p, next_q = whole * q + last_q;
      last_p = std::exchange(p, next_p);
      last_q = std::exchange(q, next_q);
      rest = 1 / (rest - Rational(whole));
    }
    const Ordering near = compare(x, pi(Rational(p, q)));
    CHECK(near.order == order_at_2000_bits(x, pi(Rational(p, q))));
    CHECK(near.order != Order::Equal);
    CHECK(near.bits == 512);
  }
}

TEST_CASE("angle_sum: undecided if a common divisor has no known square") {
  // tan^2 = a / (p^2 q) with primes p and q beyond 2^16, from a dot product p^2 q. The argument of
  // the square of p sqrt(q) + sqrt(-a) is twice as large.
  const Integer p = 65537, q = 65539, a = 2, b = p * p * q;
  const AngleSum twice = angle(b * a, b, 2), square = angle(4 * b * a, b - a);
  const Ordering comparison = compare(twice, square, {512});
  CHECK(comparison.order == Order::Undecided);
  CHECK(comparison.bits == 512);
  CHECK(compare(twice, square + pi(scale_by_power_of_two(1, -300)), {512}).order == Order::Less);
  // Squares that are known make no trouble.
  for (const Integer& known : {Integer(p * p), Integer(9 * 3 * p), q, Integer(4 * 27 * 49)}) {
    CAPTURE(known);
    check_tie(angle(known * a, known, 2), angle(4 * known * a, known - a), TieProof::AngleBasis);
  }
  // Nor do long divisors of dot products: 2^89 - 1 is a prime.
  const Integer dot = 2 * ((Integer(1) << 89) - 1);
  check_tie(angle(6, dot, 2), angle(24 * dot * dot, dot * dot - 6), TieProof::AngleBasis);
}

TEST_CASE("angle_sum: a comparison can be stopped") {
  const std::atomic<bool> stop = true;
  CHECK(error_of([&] { return compare(angle(8, -1), angle(2, 1, 2), {}, Watch(&stop)); }).code() ==
        ErrorCode::Stopped);
}
