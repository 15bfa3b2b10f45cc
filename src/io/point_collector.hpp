// SPDX-License-Identifier: MIT
// point_collector.hpp - gathers the points of a file as doubles or as spelled.
#pragma once
#include <array>
#include <cmath>
#include <vector>

#include "convexact/geometry.hpp"
#include "io/text_cursor.hpp"

namespace convexact {

class PointCollector {
 public:
  explicit PointCollector(Decimal decimal) : decimal_(decimal) {}

  /// @throws Error Malformed or NotFinite at the line of `cursor`.
  void add(const std::array<std::string_view, 3>& coordinates, const TextCursor& cursor) {
    Point point;
    for (int k = 0; k < 3; ++k) point[k] = cursor.to_number(coordinates[k], decimal_);
    doubles_.push_back(point);
    if (decimal_ == Decimal::Exact) rationals_.push_back(spelled(coordinates, cursor));
  }

  /// A point of a binary file, finite.
  void add(const Point& point) {
    doubles_.push_back(point);
    if (decimal_ == Decimal::Exact) rationals_.push_back(to_rational(point));
  }

  /// A point that was computed: itself, or its nearest double or binary32 number, as asked.
  /// @throws Error NotFinite beyond the largest one.
  void add(const RationalPoint& point) {
    const Precision precision =
        decimal_ == Decimal::Nearest32 ? Precision::Binary32 : Precision::Binary64;
    Point nearest;
    for (int k = 0; k < 3; ++k) {
      nearest[k] = round_to(precision, point[k], Rounding::Nearest);
      if (!std::isfinite(nearest[k])) {
        throw Error(ErrorCode::NotFinite, "a coordinate is beyond the largest number");
      }
    }
    doubles_.push_back(nearest);
    if (decimal_ == Decimal::Exact) rationals_.push_back(point);
  }

  std::size_t size() const { return doubles_.size(); }
  const Point& double_at(std::size_t index) const { return doubles_[index]; }
  bool equal(std::size_t a, std::size_t b) const {
    return decimal_ == Decimal::Exact ? rationals_[a] == rationals_[b] : doubles_[a] == doubles_[b];
  }
  void drop_last() {
    doubles_.pop_back();
    if (decimal_ == Decimal::Exact) rationals_.pop_back();
  }
  PointSet finish() {
    return decimal_ == Decimal::Exact ? PointSet(std::move(rationals_))
                                      : PointSet(std::move(doubles_));
  }

 private:
  // Called after all three were found to be decimals with finite values. A very low exponent, whose
  // digits would fill the memory, may still be refused.
  static RationalPoint spelled(const std::array<std::string_view, 3>& coordinates,
                               const TextCursor& cursor) {
    try {
      return {parse_rational(coordinates[0]), parse_rational(coordinates[1]),
              parse_rational(coordinates[2])};
    } catch (const Error& error) {
      cursor.fail(error.what(), error.code());
    }
  }

  Decimal decimal_;
  std::vector<Point> doubles_;
  std::vector<RationalPoint> rationals_;
};

}  // namespace convexact
