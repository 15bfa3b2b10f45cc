// SPDX-License-Identifier: MIT
// Regret: the share by which one cost exceeds another.
#include <algorithm>

#include "convexact/error.hpp"
#include "convexact/verify_run.hpp"
#include "number/precision.hpp"

namespace convexact {

const Rational& Regret::rational() const {
  if (exact() == nullptr) throw Error(ErrorCode::InvalidArgument, "a regret within an interval");
  return *exact();
}

Enclosure Regret::bounds() const {
  if (exact() != nullptr) return {*exact(), kMeasureBits};
  return std::get<Enclosure>(value_);
}

double Regret::near_double() const {
  return to_double(exact() != nullptr ? *exact() : bounds().low(), Rounding::Nearest);
}

double Regret::high_double() const {
  return exact() != nullptr ? to_double(*exact(), Rounding::Up) : bounds().high_double();
}

bool Regret::is_above(const Regret& other) const {
  if (exact() != nullptr && other.exact() != nullptr) return *exact() > *other.exact();
  return bounds().low() > other.bounds().high();
}

std::optional<Regret> relative_regret(const Cost& cost, const Cost& minimum,
                                      const CompareLimits& limits, const Watch& watch) {
  if (cost.measure() == CostMeasure::Volume && minimum.measure() == CostMeasure::Volume) {
    const Rational &paid = cost.rational(), &least = minimum.rational();
    if (paid == least) return Rational(0);
    if (least == 0) return std::nullopt;
    return Rational((paid - least) / least);
  }
  const Order order = compare(cost, minimum, limits, watch).order;
  if (order == Order::Equal) return Rational(0);
  const bool is_open = order == Order::Undecided;
  const long bits = is_open ? std::max(limits.bits, kMeasureBits) : kMeasureBits;
  const Enclosure least = minimum.enclose(bits, watch);
  if (least.sign() != Sign::Positive) return std::nullopt;
  if (is_open) return Regret((cost.enclose(bits, watch) - least) / least);
  return Regret(difference(cost, minimum).enclose(bits, watch) / least);
}

}  // namespace convexact
