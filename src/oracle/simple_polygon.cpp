// SPDX-License-Identifier: MIT
#include <algorithm>
#include <numeric>
#include <vector>

#include "oracle/mesh_surface.hpp"

namespace convexact {
namespace {

using Outline = std::span<const PlanarPoint>;

// Positive if a, b, c turn left.
int turn(const PlanarPoint& a, const PlanarPoint& b, const PlanarPoint& c) {
  return Rational((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).sign();
}

// Whether a, b, c on one line run back at b.
bool runs_back(const PlanarPoint& a, const PlanarPoint& b, const PlanarPoint& c) {
  return Rational((b[0] - a[0]) * (c[0] - b[0]) + (b[1] - a[1]) * (c[1] - b[1])) < 0;
}

// Whether the direction from a to b is in the upper half of all, [0, 180) degrees.
bool is_upward(const PlanarPoint& a, const PlanarPoint& b) {
  return b[1] > a[1] || (b[1] == a[1] && b[0] > a[0]);
}

// A polygon that turns to one side only, and by 360 degrees in all, is convex and simple.
bool is_convex(Outline p) {
  const std::size_t n = p.size();
  int side = 0;
  std::size_t changes = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const PlanarPoint &a = p[k], &b = p[(k + 1) % n], &c = p[(k + 2) % n];
    const int here = turn(a, b, c);
    if (here == 0 ? runs_back(a, b, c) : here == -side) return false;
    if (here != 0) side = here;
    changes += is_upward(a, b) != is_upward(b, c) ? 1 : 0;
  }
  return side != 0 && changes == 2;
}

bool is_between(const Rational& x, const Rational& a, const Rational& b) {
  return std::min(a, b) <= x && x <= std::max(a, b);
}

// Whether p, on the line through a and b, is between them.
bool is_on(const PlanarPoint& p, const PlanarPoint& a, const PlanarPoint& b) {
  return is_between(p[0], a[0], b[0]) && is_between(p[1], a[1], b[1]);
}

bool do_meet(const PlanarPoint& a, const PlanarPoint& b, const PlanarPoint& c,
             const PlanarPoint& d) {
  const int a_side = turn(c, d, a), b_side = turn(c, d, b);
  const int c_side = turn(a, b, c), d_side = turn(a, b, d);
  if (a_side * b_side < 0 && c_side * d_side < 0) return true;
  return (a_side == 0 && is_on(a, c, d)) || (b_side == 0 && is_on(b, c, d)) ||
         (c_side == 0 && is_on(c, a, b)) || (d_side == 0 && is_on(d, a, b));
}

// Whether edges i < j have more in common than the corner between neighbours.
bool do_touch(Outline p, std::size_t i, std::size_t j) {
  const std::size_t n = p.size();
  const auto folds = [&](std::size_t k) {  // at the end of edge k
    const PlanarPoint &a = p[k], &b = p[(k + 1) % n], &c = p[(k + 2) % n];
    return turn(a, b, c) == 0 && runs_back(a, b, c);
  };
  if (j == i + 1) return folds(i);
  if (i == 0 && j == n - 1) return folds(j);
  return do_meet(p[i], p[i + 1], p[j], p[(j + 1) % n]);
}

}  // namespace

std::optional<std::pair<std::size_t, std::size_t>> touching_edges(Outline corners) {
  if (is_convex(corners)) return std::nullopt;
  const std::size_t n = corners.size();
  const auto first_x = [&](std::size_t e) -> const Rational& {
    return std::min(corners[e][0], corners[(e + 1) % n][0]);
  };
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return first_x(a) < first_x(b); });
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t e = order[k];
    const Rational& last_x = std::max(corners[e][0], corners[(e + 1) % n][0]);
    for (std::size_t l = k + 1; l < n && first_x(order[l]) <= last_x; ++l) {
      const auto [i, j] = std::minmax(e, order[l]);
      if (do_touch(corners, i, j)) return std::pair(i, j);
    }
  }
  return std::nullopt;
}

}  // namespace convexact
