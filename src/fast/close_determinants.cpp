// SPDX-License-Identifier: MIT
#include "fast/close_determinants.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "fast/signs.hpp"

namespace convexact {
namespace {

using Long = Triple<DoubleDouble>;
constexpr double kUnit = Roundoff<DoubleDouble>::kUnit, kRounding = DoubleDouble::kUnit;

double size_of(const Long& v) {
  return std::abs(v.x.hi()) + std::abs(v.y.hi()) + std::abs(v.z.hi());
}
double distance(const Long& a, const Long& b) {
  return std::abs(a.x.hi() - b.x.hi()) + std::abs(a.y.hi() - b.y.hi()) +
         std::abs(a.z.hi() - b.z.hi());
}

// Every row is a dual point, off by 2 kUnit in each coordinate, or the difference of two, off by
// 4 kUnit and by its rounding, a relative kRounding of at most 2.
constexpr double kOfRow = 2 + 2, kRowError = 5;
static_assert(kOfRow + 2 * kRounding / kUnit < kRowError);

// The rows f, g, h with sums of sizes A, B, C. A product of one entry of each is off, with r the
// error of a row, by r of two sizes, by r^2 of one, and by r^3. There are six products, of
// different columns, so together they are off by r (AB + BC + CA) + 2 r^2 (A + B + C) + 6 r^3.
// Rounding: 2 kRounding in a component of f x g from products and subtraction, 1 from the product
// with h and 2 from two additions, of at most ABC. The sizes and this bound are rounded as doubles;
// twice the rest allows for it.
constexpr double kOfRounding = 2 + 1 + 2, kRoundings = 6;
static_assert(kOfRounding < kRoundings);

Approximate determinant_of_rows(const Long& f, const Long& g, const Long& h) {
  constexpr double r = kRowError * kUnit, kSlack = 1 + 0x1p-20;
  const double a = size_of(f), b = size_of(g), c = size_of(h);
  const double error = r * (a * b + b * c + c * a) + 2 * r * r * (a + b + c) + 6 * r * r * r +
                       kRoundings * kRounding * a * b * c;
  return {dot(cross(f, g), h), kSlack * error + ExponentRange<DoubleDouble>::kUnderflow};
}

}  // namespace

Approximate close_height(const Long& a, const Long& b, const Long& c, const Long& p) {
  const std::array<const Long*, 4> point{&a, &b, &c, &p};
  // The tree of the shortest differences, from a: `order` has the points in the order in
  // which they join it, each by the difference to its parent.
  std::array<int, 4> order{0, 1, 2, 3}, parent{0, 0, 0, 0};
  std::array<double, 4> length{0, distance(a, b), distance(a, c), distance(a, p)};
  std::array<Long, 3> row;
  bool is_odd = false;
  for (int k = 1; k < 4; ++k) {
    int next = k;
    for (int m = k + 1; m < 4; ++m) {
      if (length[order[m]] < length[order[next]]) next = m;
    }
    if (next != k) {
      std::swap(order[k], order[next]);
      is_odd = !is_odd;
    }
    const int joined = order[k];
    row[k - 1] = *point[joined] - *point[parent[joined]];
    for (int m = k + 1; m < 4; ++m) {
      const double from_joined = distance(*point[joined], *point[order[m]]);
      if (from_joined < length[order[m]]) {
        length[order[m]] = from_joined;
        parent[order[m]] = joined;
      }
    }
  }
  const auto [value, error] = determinant_of_rows(row[0], row[1], row[2]);
  return {is_odd ? -value : value, error};
}

Approximate close_determinant(const Long& a, const Long& b, const Long& c) {
  return determinant_of_rows(b - a, c - a, a);
}

}  // namespace convexact
