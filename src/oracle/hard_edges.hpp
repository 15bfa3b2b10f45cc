// SPDX-License-Identifier: MIT
// hard_edges.hpp - edges at which two facets meet at an angle that no rounding explains.
#pragma once
#include <cmath>
#include <span>
#include <vector>

#include "convexact/number.hpp"
#include "convexact/point_set.hpp"
#include "convexact/polytope.hpp"
#include "number/arithmetic.hpp"

namespace convexact::oracle {

using Corner = std::uint32_t;
using Corners = std::span<const Corner>;

/// Decides in doubles which pairs of neighbouring facets can never be in one patch.
class HardEdges {
 public:
  HardEdges(const Polytope& polytope, std::span<const RationalVector3> slack) {
    Rational largest = 0;
    for (const RationalPoint& v : polytope.vertices) {
      for (const Rational& x : v) largest = std::max<Rational>(largest, abs(x));
    }
    // By a power of two into [-1, 1], where products do not overflow.
    const int exponent = exponent_of(to_double(largest, Rounding::Down));
    const auto scaled = [&](const Rational& x) {
      return to_double(scale_by_power_of_two(x, -exponent), Rounding::Nearest);
    };
    for (std::size_t v = 0; v < slack.size(); ++v) {
      Point& p = points_.emplace_back();
      Point& u = errors_.emplace_back();
      for (int k = 0; k < 3; ++k) {
        p[k] = scaled(polytope.vertices[v][k]);
        u[k] = scaled(slack[v][k]) + kUnit * std::abs(p[k]) + kTiny;
      }
    }
  }

  /// Whether the four points are not coplanar wherever they are within their errors.
  bool separates(Corner a, Corner b, Corner c, Corner d) const {
    const Corner others[] = {b, c, d};
    double m[3][3], e[3][3];
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) {
        m[i][k] = points_[others[i]][k] - points_[a][k];
        e[i][k] = errors_[others[i]][k] + errors_[a][k];
      }
    }
    double determinant = 0, size = 0, change = 0;
    constexpr int kOrders[6][4] = {{0, 1, 2, 1},  {1, 2, 0, 1},  {2, 0, 1, 1},
                                   {0, 2, 1, -1}, {2, 1, 0, -1}, {1, 0, 2, -1}};
    for (const auto& [i, j, k, sign] : kOrders) {
      const double x = m[0][i], y = m[1][j], z = m[2][k];
      determinant += sign * (x * y * z);
      size += std::abs(x * y * z);
      change += e[0][i] * (std::abs(y) + e[1][j]) * (std::abs(z) + e[2][k]) +
                std::abs(x) * e[1][j] * (std::abs(z) + e[2][k]) + std::abs(x * y) * e[2][k];
    }
    // What rounding adds here is below 2^-49 of the sum of the sizes.
    return std::abs(determinant) > change + 16 * kUnit * size + kTiny;
  }

  /// Four times the square of the area, in units of its own.
  double squared_area(Corners corners) const {
    Vector3<double> sum(0, 0, 0);
    for (std::size_t k = 2; k < corners.size(); ++k) {
      const Vector3<double> u = points_[corners[k - 1]] - points_[corners[0]];
      const Vector3<double> v = points_[corners[k]] - points_[corners[0]];
      sum += u.cross(v);
    }
    return sum.dot(sum);
  }

 private:
  static constexpr double kUnit = 0x1p-52, kTiny = 0x1p-1000;
  std::vector<Point> points_, errors_;
};

}  // namespace convexact::oracle
