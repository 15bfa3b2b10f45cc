// SPDX-License-Identifier: MIT
#include "convexact/oracle/shrink.hpp"

#include <algorithm>
#include <string>
#include <unordered_set>

#include "convexact/error.hpp"

namespace convexact {
namespace {

using Points = std::vector<RationalPoint>;

std::size_t bits_of(const Points& points) {
  std::size_t bits = 0;
  for (const RationalPoint& p : points) {
    for (int k = 0; k < 3; ++k) bits += coordinate_bits(p[k]);
  }
  return bits;
}

// The nearest multiple of 2^-digits, halves away from zero.
Rational round_to_digits(const Rational& x, long digits) {
  const Rational scaled = abs(scale_by_power_of_two(x, digits + 1));
  const Integer twice = numerator(scaled) / denominator(scaled);
  const Rational rounded = scale_by_power_of_two(Rational(Integer((twice + 1) / 2)), -digits);
  return x < 0 ? Rational(-rounded) : rounded;
}

// Values to try for x, simplest first: fewer bits each than x has.
std::vector<Rational> simpler_values(const Rational& x) {
  std::vector<Rational> values{0, x < 0 ? -1 : 1};
  const auto digits = static_cast<long>(bit_length(denominator(x))) - 1;
  if (digits > 0) {
    values.push_back(round_to_digits(x, 0));
    for (long f = 1; f < digits; f *= 2) values.push_back(round_to_digits(x, f));
    values.push_back(round_to_digits(x, digits - 1));
  } else {
    const Integer& n = numerator(x);
    const auto length = static_cast<long>(bit_length(n));
    for (long kept = 2; kept < length; kept *= 2) {
      values.emplace_back(Integer(n / (Integer(1) << (length - kept))));
    }
    values.emplace_back(Integer(n / 2));
  }
  const std::size_t bits = coordinate_bits(x);
  std::erase_if(values, [bits](const Rational& v) { return coordinate_bits(v) >= bits; });
  return values;
}

class Shrinker {
 public:
  Shrinker(const PointSet& points, const StillFails& fails,
           const std::function<void(const PointSet&)>& progress);
  Shrunk run();

 private:
  bool try_instead(Points points, std::vector<PointId> origin);
  bool try_coordinates(Points points);

  void leave_out_points();
  void round_all();
  void move_to_origin();
  void scale(const std::vector<int>& axes);
  void simplify_each();

  const StillFails& fails_;
  const std::function<void(const PointSet&)>& progress_;
  bool is_binary_;
  Points points_;
  std::vector<PointId> origin_;
  std::unordered_set<std::string> passed_;  // point sets that are known not to fail
  std::size_t tries_ = 0;
};

Shrinker::Shrinker(const PointSet& points, const StillFails& fails,
                   const std::function<void(const PointSet&)>& progress)
    : fails_(fails), progress_(progress), is_binary_(points.is_binary()) {
  for (std::size_t k = 0; k < points.size(); ++k) {
    points_.push_back(points[PointId(k)]);
    origin_.emplace_back(k);
  }
  ++tries_;
  if (!fails_(points, origin_)) {
    throw Error(ErrorCode::InvalidArgument, "there is nothing to shrink: the points do not fail");
  }
}

Shrunk Shrinker::run() {
  for (std::size_t points = 0, bits = 0; points_.size() != points || bits_of(points_) != bits;) {
    points = points_.size();
    bits = bits_of(points_);
    leave_out_points();
    move_to_origin();
    round_all();
    scale({0, 1, 2});
    for (int axis = 0; axis < 3; ++axis) scale({axis});
    simplify_each();
  }
  return {PointSet(points_), origin_, tries_};
}

// Takes the points if they still fail.
bool Shrinker::try_instead(Points points, std::vector<PointId> origin) {
  const PointSet set(points);
  if (is_binary_ && !set.is_binary()) return false;
  std::string key;  // large sets do not come again
  if (points.size() < 200) {
    for (const RationalPoint& p : points) {
      for (int k = 0; k < 3; ++k) key += to_string(p[k]) + " ";
    }
    if (passed_.contains(key)) return false;
  }
  ++tries_;
  if (!fails_(set, origin)) {
    if (!key.empty()) passed_.insert(std::move(key));
    return false;
  }
  points_ = std::move(points);
  origin_ = std::move(origin);
  if (progress_) progress_(set);
  return true;
}

bool Shrinker::try_coordinates(Points points) {
  return bits_of(points) < bits_of(points_) && try_instead(std::move(points), origin_);
}

// Chunks of half of the points first, then of a quarter and so on; single ones until none can go.
void Shrinker::leave_out_points() {
  for (std::size_t chunk = std::max<std::size_t>(points_.size() / 2, 1);;) {
    bool any = false;
    for (std::size_t start = 0; start < points_.size();) {
      const auto first = static_cast<std::ptrdiff_t>(start);
      const auto last = static_cast<std::ptrdiff_t>(std::min(start + chunk, points_.size()));
      Points fewer = points_;
      std::vector<PointId> origin = origin_;
      fewer.erase(fewer.begin() + first, fewer.begin() + last);
      origin.erase(origin.begin() + first, origin.begin() + last);
      if (try_instead(std::move(fewer), std::move(origin))) {
        any = true;  // the next chunk has moved up to `start`
      } else {
        start += chunk;
      }
    }
    if (chunk == 1 && !any) return;
    chunk = std::max<std::size_t>(chunk / 2, 1);
  }
}

// To the coarsest grid that serves, 2^e times the integers.
void Shrinker::round_all() {
  long top = 0, bottom = 0;  // 2^bottom divides every dyadic coordinate, none reaches 2^top
  bool any = false;
  for (const RationalPoint& p : points_) {
    for (int k = 0; k < 3; ++k) {
      if (p[k] == 0) continue;
      const auto above = static_cast<long>(bit_length(numerator(p[k])));
      const auto below = static_cast<long>(bit_length(denominator(p[k])));
      top = any ? std::max(top, above - below + 2) : above - below + 2;
      bottom = any ? std::min(bottom, 1 - below) : 1 - below;
      any = true;
    }
  }
  for (long e = top; any && e > bottom; --e) {
    Points rounded = points_;
    for (RationalPoint& p : rounded) {
      for (int k = 0; k < 3; ++k) p[k] = round_to_digits(p[k], -e);
    }
    if (try_coordinates(std::move(rounded))) return;
  }
}

void Shrinker::move_to_origin() {
  for (int axis = 0; axis < 3 && !points_.empty(); ++axis) {
    Rational least = points_[0][axis];
    for (const RationalPoint& p : points_) least = std::min(least, p[axis]);
    for (const Rational& offset : {least, points_[0][axis]}) {
      Points moved = points_;
      for (RationalPoint& p : moved) p[axis] -= offset;
      if (try_coordinates(std::move(moved))) break;
    }
  }
}

// By the power of two that makes doubles integers that are not all even.
void Shrinker::scale(const std::vector<int>& axes) {
  long power = 0;
  bool any = false;
  for (const RationalPoint& p : points_) {
    for (const int k : axes) {
      if (p[k] == 0) continue;
      const long low =
          static_cast<long>(lsb(abs(numerator(p[k])))) - static_cast<long>(lsb(denominator(p[k])));
      power = any ? std::min(power, low) : low;
      any = true;
    }
  }
  Points scaled = points_;
  for (RationalPoint& p : scaled) {
    for (const int k : axes) p[k] = scale_by_power_of_two(p[k], -power);
  }
  (void)try_coordinates(std::move(scaled));
}

void Shrinker::simplify_each() {
  for (std::size_t i = 0; i < points_.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      for (bool simpler = true; simpler;) {
        simpler = false;
        for (const Rational& value : simpler_values(points_[i][k])) {
          Points changed = points_;
          changed[i][k] = value;
          if ((simpler = try_coordinates(std::move(changed)))) break;
        }
      }
    }
  }
}

}  // namespace

std::size_t coordinate_bits(const Rational& x) {
  return x == 0 ? 0 : bit_length(numerator(x)) + bit_length(denominator(x)) - 1;
}

std::size_t coordinate_bits(const PointSet& points) {
  std::size_t bits = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const RationalPoint p = points[PointId(i)];
    for (int k = 0; k < 3; ++k) bits += coordinate_bits(p[k]);
  }
  return bits;
}

Shrunk shrink(const PointSet& points, const StillFails& fails,
              const std::function<void(const PointSet&)>& progress) {
  return Shrinker(points, fails, progress).run();
}

}  // namespace convexact
