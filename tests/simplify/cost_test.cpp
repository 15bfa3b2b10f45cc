// SPDX-License-Identifier: MIT
// Costs of the three measures. Expected numbers are closed forms of a corner cut off a box.
#include "convexact/cost.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <vector>

#include "expect_error.hpp"
#include "simplify/run_names.hpp"
using namespace convexact;

namespace {

// A corner cut off a box, with legs x, y, z, as the cost of removing the cut: the cap is a
// tetrahedron with three right angles.
struct Corner {
  int x, y, z;
};

Cost volume_of(const Corner& c) { return Rational(c.x * c.y * c.z, 6); }

// (xy + yz + zx - sqrt(x^2 y^2 + y^2 z^2 + z^2 x^2)) / 2
Cost area_of(const Corner& c, const Rational& factor = 1) {
  const Rational xy = c.x * c.y, yz = Rational(c.y) * c.z, zx = c.z * c.x;
  RootSum sum(xy + yz + zx);
  sum.add(-1, xy * xy + yz * yz + zx * zx);
  return Cost(sum *= factor / 2);
}

// 4 pi db = (x + y + z) pi/2 less the edges of the cut: length times the angle between a side of
// the box and the cut, whose normal is (1/x, 1/y, 1/z).
Cost width_of(const Corner& c, const Rational& factor = 1) {
  const Integer x = c.x, y = c.y, z = c.z;
  const Integer a = y * z, b = z * x, d = x * y;  // the normal, times x y z
  AngleSum sum = AngleSum::pi(Rational(c.x + c.y + c.z, 2));
  sum -= AngleSum({{1, Rational(Integer(x * x + y * y)), a * a + b * b, d},
                   {1, Rational(Integer(y * y + z * z)), b * b + d * d, a},
                   {1, Rational(Integer(z * z + x * x)), d * d + a * a, b}});
  return Cost(sum *= factor);
}

Order order(const Cost& a, const Cost& b) { return compare(a, b).order; }

}  // namespace

TEST_CASE("cost: the corner of a unit cube at 1/2, of each measure") {
  const Corner unit{1, 1, 1};  // lengths in halves
  CHECK(volume_of(unit).rational() == Rational(1, 6));
  CHECK(area_of(unit, Rational(1, 4)).decimal(18) == "0.158493649053890338");
  CHECK(width_of(unit, Rational(1, 2)).decimal(18) == "0.0262336615512144259");
  CHECK(volume_of({2, 1, 1}).decimal(6) == "0.333333");
}

TEST_CASE("cost: the measure is that of the number") {
  const Corner c{1, 2, 3};
  CHECK(volume_of(c).measure() == CostMeasure::Volume);
  CHECK(area_of(c).measure() == CostMeasure::Area);
  CHECK(width_of(c).measure() == CostMeasure::MeanWidth);
  CHECK(area_of(c).area().terms().size() == 2);  // the radicand 49 is kept as it is
  CHECK(width_of(c).angles().terms().size() == 4);
  for (const auto& action : std::vector<std::function<void()>>{
           [&] { (void)area_of(c).rational(); }, [&] { (void)volume_of(c).area(); },
           [&] { (void)area_of(c).angles(); }, [&] { (void)compare(volume_of(c), area_of(c)); },
           [&] { (void)compare(width_of(c), area_of(c)); },
           [&] { (void)(volume_of(c) < area_of(c)); }, [&] { (void)(area_of(c) == volume_of(c)); },
           [&] { (void)(width_of(c) == width_of(c)); },
           [&] {
             (void)compare(width_of({3, 1, 3}), width_of(c), {0});
           }}) {
    CHECK(error_of(action).code() == ErrorCode::InvalidArgument);
  }
}

TEST_CASE("cost: caps that tie in area and in no other measure") {
  const Corner a{3, 1, 3}, b{1, 1, 7};
  CHECK(order(volume_of(a), volume_of(b)) == Order::Greater);
  CHECK(order(area_of(a), area_of(b)) == Order::Equal);
  CHECK(compare(area_of(a), area_of(b)).tie_proof == TieProof::SquareClasses);
  CHECK(area_of(a) == area_of(b));
  CHECK(!(area_of(a) < area_of(b)));
  CHECK(order(width_of(a), width_of(b)) == Order::Greater);
  CHECK(width_of(a).decimal(9) == "0.0898529702");
  CHECK(width_of(b).decimal(9) == "0.0699856943");
}

TEST_CASE("cost: congruent caps tie in each measure") {
  const Corner a{2, 3, 5}, b{5, 2, 3};
  CHECK(compare(volume_of(a), volume_of(b)).tie_proof == TieProof::EqualRationals);
  CHECK(compare(area_of(a), area_of(b)).tie_proof == TieProof::EqualRationals);  // 19^2
  CHECK(compare(width_of(a), width_of(b)).tie_proof == TieProof::NormalForm);
}

TEST_CASE("cost: order of larger and smaller caps") {
  const Corner small{1, 2, 2}, large{2, 2, 2};
  CHECK(volume_of(small) < volume_of(large));
  CHECK(area_of(small) < area_of(large));
  CHECK(area_of(large) > area_of(small));
  CHECK(compare(area_of(small), area_of(large)).bits == 53);
  CHECK(order(width_of(small), width_of(large)) == Order::Less);
  CHECK(order(width_of(large), width_of(small)) == Order::Greater);
  std::vector<Cost> sorted{area_of(large), area_of({1, 1, 7}), area_of(small), area_of({3, 1, 3})};
  std::sort(sorted.begin(), sorted.end());
  CHECK(sorted[0] == area_of(small));
  CHECK(std::is_sorted(sorted.begin(), sorted.end()));
}

TEST_CASE("cost: enclosures are as narrow as asked for") {
  for (const Cost& cost : {volume_of({1, 1, 5}), area_of({1, 1, 5}), width_of({1, 1, 5}),
                           area_of({1, 1000000, 1000000}), width_of({1, 1000, 1000})}) {
    for (const long precision : {20, 53, 128, 1000}) {
      const Enclosure value = cost.enclose(precision);
      REQUIRE(value.sign() == Sign::Positive);
      CHECK(scale_by_power_of_two(value.width(), precision) <= 2 * value.low());
      CHECK(value.precision() >= precision);
    }
    CHECK(cost.low_double() <= cost.high_double());
  }
  CHECK(Cost(RootSum()).enclose(60).sign() == Sign::Zero);
  CHECK(Cost(RootSum()).decimal(3) == "0");
  CHECK(Cost(AngleSum()).decimal(3) == "0");
}

TEST_CASE("cost: measures and proofs have names") {
  for (const auto& [measure, name] : kCostMeasureNames) {
    CHECK(name_of(measure) == std::string(name));
    CHECK(value_in(kCostMeasureNames, name) == measure);
  }
  CHECK(value_in(kCostMeasureNames, "mean-width") == CostMeasure::MeanWidth);
  CHECK(!value_in(kCostMeasureNames, "width"));
  CHECK(name_of(TieProof::EqualRationals) == std::string("rational"));
  CHECK(name_of(TieProof::Undecided) == std::string("undecided"));
}
