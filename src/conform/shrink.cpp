// SPDX-License-Identifier: MIT
#include "convexact/shrink.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <unordered_set>

#include "convexact/error.hpp"

namespace convexact {
namespace {

// A point's coordinates, or a halfspace's numbers.
using Row = std::vector<Rational>;
using Rows = std::vector<Row>;

std::size_t bits_of(const Rows& rows) {
  std::size_t bits = 0;
  for (const Row& row : rows) {
    for (const Rational& x : row) bits += coordinate_bits(x);
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

// Whether no coordinate lies beyond the largest double. A difference may, and so may a coordinate
// that was rounded up.
bool are_finite(const Rows& rows) {
  return std::ranges::all_of(rows, [](const Row& row) {
    return std::ranges::all_of(
        row, [](const Rational& x) { return std::isfinite(to_double(x, Rounding::Nearest)); });
  });
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

Rows rows_of(std::span<const Halfspace> halfspaces) {
  Rows rows;
  for (const Halfspace& h : halfspaces) {
    rows.push_back({h.normal()[0], h.normal()[1], h.normal()[2], h.offset()});
  }
  return rows;
}

Rows rows_of(const PointSet& points) {
  Rows rows;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const RationalPoint p = points[PointId(i)];
    rows.push_back({p[0], p[1], p[2]});
  }
  return rows;
}

PointSet points_of(const Rows& rows) {
  std::vector<RationalPoint> list;
  for (const Row& row : rows) list.emplace_back(row[0], row[1], row[2]);
  return PointSet(list);
}

// Nothing if a normal is zero.
std::optional<std::vector<Halfspace>> halfspaces_of(const Rows& rows) {
  std::vector<Halfspace> halfspaces;
  for (const Row& row : rows) {
    const RationalVector3 normal(row[0], row[1], row[2]);
    if (normal.isZero(0)) return std::nullopt;
    halfspaces.emplace_back(normal, row[3]);
  }
  return halfspaces;
}

class Shrinker {
 public:
  using Fails = std::function<bool(const Rows& rows, std::span<const PointId> origin)>;
  using Progress = std::function<void(const Rows& rows)>;

  /// @param are_points  Whether rows are points, which may be moved, and scaled along each axis.
  Shrinker(Rows rows, bool are_points, Fails fails, Progress progress);
  void run();
  const Rows& rows() const { return rows_; }
  const std::vector<PointId>& origin() const { return origin_; }

 private:
  bool try_instead(Rows rows, std::vector<PointId> origin);
  bool try_numbers(Rows rows);

  void leave_out_rows();
  void round_all();
  void move_to_origin();
  void scale(const std::vector<std::size_t>& axes);
  void shorten_each();
  void simplify_each();

  Rows rows_;
  bool are_points_;
  Fails fails_;
  Progress progress_;
  std::vector<PointId> origin_;
  std::unordered_set<std::string> passed_;  // rows that are known not to fail
};

Shrinker::Shrinker(Rows rows, bool are_points, Fails fails, Progress progress)
    : rows_(std::move(rows)),
      are_points_(are_points),
      fails_(std::move(fails)),
      progress_(std::move(progress)) {
  for (std::size_t k = 0; k < rows_.size(); ++k) origin_.emplace_back(k);
  if (!fails_(rows_, origin_)) {
    throw Error(ErrorCode::InvalidArgument, "there is nothing to shrink: the input does not fail");
  }
}

void Shrinker::run() {
  for (std::size_t rows = 0, bits = 0; rows_.size() != rows || bits_of(rows_) != bits;) {
    rows = rows_.size();
    bits = bits_of(rows_);
    leave_out_rows();
    if (are_points_) {
      move_to_origin();
      round_all();
      scale({0, 1, 2});
      for (std::size_t axis = 0; axis < 3; ++axis) scale({axis});
    } else {
      shorten_each();
    }
    simplify_each();
    // The same halfspaces by numbers without a common factor.
    if (!are_points_) rows_ = rows_of(*halfspaces_of(rows_));
  }
}

// Takes the rows if they still fail.
bool Shrinker::try_instead(Rows rows, std::vector<PointId> origin) {
  std::string key;  // large sets do not occur again
  if (rows.size() < 200) {
    for (const Row& row : rows) {
      for (const Rational& x : row) key += to_string(x) + " ";
    }
    if (passed_.contains(key)) return false;
  }
  if (!fails_(rows, origin)) {
    if (!key.empty()) passed_.insert(std::move(key));
    return false;
  }
  rows_ = std::move(rows);
  origin_ = std::move(origin);
  progress_(rows_);
  return true;
}

bool Shrinker::try_numbers(Rows rows) {
  return bits_of(rows) < bits_of(rows_) && try_instead(std::move(rows), origin_);
}

// Chunks of half of the rows first, then of a quarter and so on; single ones until none can go.
void Shrinker::leave_out_rows() {
  for (std::size_t chunk = std::max<std::size_t>(rows_.size() / 2, 1);;) {
    bool any = false;
    for (std::size_t start = 0; start < rows_.size();) {
      const auto first = static_cast<std::ptrdiff_t>(start);
      const auto last = static_cast<std::ptrdiff_t>(std::min(start + chunk, rows_.size()));
      Rows fewer = rows_;
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

// Rounds to the coarsest grid with which the rows still fail, 2^e times the integers.
void Shrinker::round_all() {
  long top = 0, bottom = 0;  // 2^bottom divides every dyadic coordinate, none reaches 2^top
  bool any = false;
  for (const Row& p : rows_) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (p[k] == 0) continue;
      const auto above = static_cast<long>(bit_length(numerator(p[k])));
      const auto below = static_cast<long>(bit_length(denominator(p[k])));
      top = any ? std::max(top, above - below + 2) : above - below + 2;
      bottom = any ? std::min(bottom, 1 - below) : 1 - below;
      any = true;
    }
  }
  for (long e = top; any && e > bottom; --e) {
    Rows rounded = rows_;
    for (Row& p : rounded) {
      for (std::size_t k = 0; k < 3; ++k) p[k] = round_to_digits(p[k], -e);
    }
    if (try_numbers(std::move(rounded))) return;
  }
}

void Shrinker::move_to_origin() {
  for (std::size_t axis = 0; axis < 3 && !rows_.empty(); ++axis) {
    Rational least = rows_[0][axis];
    for (const Row& p : rows_) least = std::min(least, p[axis]);
    for (const Rational& offset : {least, rows_[0][axis]}) {
      Rows moved = rows_;
      for (Row& p : moved) p[axis] -= offset;
      if (try_numbers(std::move(moved))) break;
    }
  }
}

// Scales by the power of two that makes the doubles integers that are not all even.
void Shrinker::scale(const std::vector<std::size_t>& axes) {
  long power = 0;
  bool any = false;
  for (const Row& p : rows_) {
    for (const std::size_t k : axes) {
      if (p[k] == 0) continue;
      const long low =
          static_cast<long>(lsb(abs(numerator(p[k])))) - static_cast<long>(lsb(denominator(p[k])));
      power = any ? std::min(power, low) : low;
      any = true;
    }
  }
  Rows scaled = rows_;
  for (Row& p : scaled) {
    for (const std::size_t k : axes) p[k] = scale_by_power_of_two(p[k], -power);
  }
  (void)try_numbers(std::move(scaled));
}

// A halfspace stays nearly the same if each of its numbers loses the same number of bits.
void Shrinker::shorten_each() {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    std::size_t longest = 0;
    for (const Rational& x : rows_[i]) longest = std::max(longest, bit_length(numerator(x)));
    for (std::size_t kept = 1; kept < longest; kept *= 2) {
      Rows changed = rows_;
      for (Rational& x : changed[i]) x = round_to_digits(x, -static_cast<long>(longest - kept));
      for (Rational& x : changed[i])
        x = scale_by_power_of_two(x, -static_cast<long>(longest - kept));
      if (try_numbers(std::move(changed))) break;
    }
  }
}

void Shrinker::simplify_each() {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    for (std::size_t k = 0; k < rows_[i].size(); ++k) {
      for (bool simpler = true; simpler;) {
        simpler = false;
        for (const Rational& value : simpler_values(rows_[i][k])) {
          Rows changed = rows_;
          changed[i][k] = value;
          if ((simpler = try_numbers(std::move(changed)))) break;
        }
      }
    }
  }
}

}  // namespace

std::size_t coordinate_bits(const Rational& x) {
  return x == 0 ? 0 : bit_length(numerator(x)) + bit_length(denominator(x)) - 1;
}

std::size_t coordinate_bits(const PointSet& points) { return bits_of(rows_of(points)); }

std::size_t coordinate_bits(std::span<const Halfspace> halfspaces) {
  return bits_of(rows_of(halfspaces));
}

Shrunk shrink(const PointSet& points, const StillFails& fails,
              const std::function<void(const PointSet&)>& progress) {
  std::size_t tries = 0;
  const auto rows_fail = [&](const Rows& candidate, std::span<const PointId> origin) {
    if (!are_finite(candidate)) return false;
    const PointSet set = points_of(candidate);
    if (points.is_binary() && !set.is_binary()) return false;
    ++tries;
    return fails(set, origin);
  };
  Shrinker shrinker(rows_of(points), true, rows_fail, [&](const Rows& smaller) {
    if (progress) progress(points_of(smaller));
  });
  shrinker.run();
  return {points_of(shrinker.rows()), shrinker.origin(), tries};
}

std::vector<Halfspace> shrink(std::span<const Halfspace> halfspaces,
                              const HalfspacesStillFail& fail,
                              const std::function<void(std::span<const Halfspace>)>& progress) {
  const auto fails = [&](const Rows& rows, std::span<const PointId>) {
    const auto candidate = halfspaces_of(rows);
    return candidate && fail(*candidate);
  };
  Shrinker shrinker(rows_of(halfspaces), false, fails, [&](const Rows& smaller) {
    if (progress) progress(*halfspaces_of(smaller));
  });
  shrinker.run();
  return *halfspaces_of(shrinker.rows());
}

}  // namespace convexact
