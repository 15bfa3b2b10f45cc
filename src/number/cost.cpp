// SPDX-License-Identifier: MIT
#include "convexact/cost.hpp"

#include <array>
#include <functional>
#include <vector>

#include "convexact/error.hpp"
#include "number/arithmetic.hpp"
#include "number/ordering.hpp"
#include "number/precision.hpp"

namespace convexact {
namespace {

[[noreturn]] void reject_measure() {
  throw Error(ErrorCode::InvalidArgument, "a cost of another measure");
}

// 4 pi times a mean width, as that mean width.
Enclosure per_four_pi(const Enclosure& angles) {
  return angles / (Enclosure(Integer(4), angles.precision()) * Enclosure::pi(angles.precision()));
}

// compute(bits) with enough bits that the width is below 2^-precision times the number.
template <class Compute>
Enclosure enclose_narrowly(const Compute& compute, long precision) {
  constexpr long kSpareBits = 32, kMostBits = 1L << 16;
  for (long bits = precision + kSpareBits;; bits *= 2) {
    Enclosure value = compute(bits);
    const Rational low = value.low(), least = low > 0 ? low : -value.high();
    if (scale_by_power_of_two(value.width(), precision) <= least || bits > kMostBits) return value;
  }
}

// By bounds alone; nothing if they overlap.
template <class Bounded>
std::optional<Ordering> compare_bounds(const Bounded& a, const Bounded& b) {
  if (a.high < b.low) return Ordering{Order::Less, {}, kDoubleBits};
  if (a.low > b.high) return Ordering{Order::Greater, {}, kDoubleBits};
  return std::nullopt;
}

}  // namespace

template <class Sum>
Cost::Bounded<Sum>::Bounded(Sum x)
    : sum(std::move(x)),
      bounds(sum.enclose(kMeasureBits)),
      low(bounds.low_double()),
      high(bounds.high_double()) {}

Cost::Cost(RootSum area) : value_(std::make_shared<const Bounded<RootSum>>(std::move(area))) {}

Cost::Cost(AngleSum angles)
    : value_(std::make_shared<const Bounded<AngleSum>>(std::move(angles))) {}

const Rational& Cost::rational() const {
  if (measure() != CostMeasure::Volume) reject_measure();
  return std::get<0>(value_);
}

const RootSum& Cost::area() const {
  if (measure() != CostMeasure::Area) reject_measure();
  return std::get<1>(value_)->sum;
}

const AngleSum& Cost::angles() const {
  if (measure() != CostMeasure::MeanWidth) reject_measure();
  return std::get<2>(value_)->sum;
}

Cost& Cost::operator*=(const Rational& factor) {
  switch (measure()) {
    case CostMeasure::Volume:
      return *this = Cost(Rational(rational() * factor));
    case CostMeasure::Area:
      return *this = Cost(RootSum(area()) *= factor);
    case CostMeasure::MeanWidth:
      break;
  }
  return *this = Cost(AngleSum(angles()) *= factor);
}

Enclosure Cost::enclose(long precision, const Watch& watch) const {
  switch (measure()) {
    case CostMeasure::Volume:
      break;
    case CostMeasure::Area:
      return enclose_narrowly([&](long bits) { return area().enclose(bits, watch); }, precision);
    case CostMeasure::MeanWidth:
      return enclose_narrowly([&](long bits) { return per_four_pi(angles().enclose(bits, watch)); },
                              precision);
  }
  return {rational(), precision};
}

Enclosure Cost::bounds() const {
  switch (measure()) {
    case CostMeasure::Volume:
      break;
    case CostMeasure::Area:
      return std::get<1>(value_)->bounds;
    case CostMeasure::MeanWidth:
      return std::get<2>(value_)->bounds;
  }
  return {rational(), kMeasureBits};
}

double Cost::low_double() const {
  switch (measure()) {
    case CostMeasure::Volume:
      break;
    case CostMeasure::Area:
      return std::get<1>(value_)->low;
    case CostMeasure::MeanWidth:
      return std::get<2>(value_)->low;
  }
  return to_double(rational(), Rounding::Down);
}

double Cost::high_double() const {
  switch (measure()) {
    case CostMeasure::Volume:
      break;
    case CostMeasure::Area:
      return std::get<1>(value_)->high;
    case CostMeasure::MeanWidth:
      return std::get<2>(value_)->high;
  }
  return to_double(rational(), Rounding::Up);
}

std::string Cost::decimal(int digits) const {
  if (measure() == CostMeasure::Volume) return to_decimal(rational(), digits);
  if (measure() == CostMeasure::Area) return to_decimal(area(), digits);
  const auto text = refine([&](long bits) { return per_four_pi(angles().enclose(bits)); },
                           [&](const Enclosure& value) { return to_decimal(value, digits); },
                           {kMeasureBits, 4096});
  if (text) return *text;
  if (compare(angles(), AngleSum()).order == Order::Equal) return "0";
  throw Error(ErrorCode::Unrepresentable, "a mean width has no certain digits");
}

std::strong_ordering Cost::order_of_areas(const Cost& a, const Cost& b) {
  if (a.measure() != CostMeasure::Area) reject_measure();
  switch (compare(a, b).order) {
    case Order::Less:
      return std::strong_ordering::less;
    case Order::Greater:
      return std::strong_ordering::greater;
    default:
      return std::strong_ordering::equal;
  }
}

Ordering compare(const Cost& a, const Cost& b, const CompareLimits& limits, const Watch& watch) {
  if (a.measure() != b.measure()) reject_measure();
  if (a.measure() == CostMeasure::Volume) {
    const std::strong_ordering order = a <=> b;
    if (order == 0) return {Order::Equal, TieProof::EqualRationals, 0};
    return {order < 0 ? Order::Less : Order::Greater, {}, 0};
  }
  if (a.measure() == CostMeasure::Area) {
    const auto &x = *std::get<1>(a.value_), &y = *std::get<1>(b.value_);
    const auto order = compare_bounds(x, y);
    return order ? *order : compare(x.sum, y.sum, watch);
  }
  if (limits.bits < 1) throw Error(ErrorCode::InvalidArgument, "a limit is at least one bit");
  const auto &x = *std::get<2>(a.value_), &y = *std::get<2>(b.value_);
  const auto order = compare_bounds(x, y);
  return order ? *order : compare(x.sum, y.sum, limits, watch);
}

namespace {

template <class Sum, class Of>
Sum sum_of_terms(std::span<const Cost> costs, const Of& of) {
  auto terms = of(costs[0]).terms();
  for (const Cost& cost : costs.subspan(1)) {
    terms.insert(terms.end(), of(cost).terms().begin(), of(cost).terms().end());
  }
  return Sum(std::move(terms));
}

}  // namespace

Cost sum_of(std::span<const Cost> costs) {
  if (costs.empty()) throw Error(ErrorCode::InvalidArgument, "a sum of costs has at least one");
  if (costs[0].measure() == CostMeasure::Area) {
    return Cost(sum_of_terms<RootSum>(costs, std::mem_fn(&Cost::area)));
  }
  if (costs[0].measure() == CostMeasure::MeanWidth) {
    return Cost(sum_of_terms<AngleSum>(costs, std::mem_fn(&Cost::angles)));
  }
  std::vector<Rational> volumes;
  for (const Cost& cost : costs) volumes.push_back(cost.rational());
  return balanced_sum(std::move(volumes));
}

Cost difference(const Cost& a, const Cost& b) {
  Cost negative = b;
  negative *= Rational(-1);
  return sum_of(std::array{a, std::move(negative)});
}

}  // namespace convexact
