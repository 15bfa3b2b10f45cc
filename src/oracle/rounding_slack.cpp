// SPDX-License-Identifier: MIT
#include <array>

#include "oracle/conformance_judge.hpp"

namespace convexact::oracle {
namespace {

using Magnitudes = std::array<Rational, 3>;

Rational permanent(const Magnitudes& a, const Magnitudes& b, const Magnitudes& c) {
  return a[0] * (b[1] * c[2] + b[2] * c[1]) + a[1] * (b[0] * c[2] + b[2] * c[0]) +
         a[2] * (b[0] * c[1] + b[1] * c[0]);
}

Magnitudes magnitudes(const RationalVector3& v, const Rational& slack) {
  Magnitudes sizes;
  for (int k = 0; k < 3; ++k) sizes[k] = abs(v[k]) + slack;
  return sizes;
}

}  // namespace

bool is_explained(std::span<const RationalPoint> corners, const Rational& slack,
                  const RationalPoint& point, const Rational& point_slack) {
  const RationalVector3 p = point - corners[0];
  const Rational corner_moves = 2 * slack, point_moves = slack + point_slack;
  Rational volume = 0, explained = 0;
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
    const RationalVector3 u = corners[k] - corners[0], v = corners[k + 1] - corners[0];
    volume += u.cross(v).dot(p);
    explained += permanent(magnitudes(u, corner_moves), magnitudes(v, corner_moves),
                           magnitudes(p, point_moves)) -
                 permanent(magnitudes(u, 0), magnitudes(v, 0), magnitudes(p, 0));
  }
  return abs(volume) <= explained;
}

}  // namespace convexact::oracle
