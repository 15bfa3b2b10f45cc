// SPDX-License-Identifier: MIT
// The least box over many orientations, in doubles; its directions are then exact.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "lab/compare/method.hpp"

namespace convexact {
namespace {

// A rotation, up to its length, which does not matter: (w, x, y, z).
using Quaternion = std::array<double, 4>;

// The rows are the rotated axes, orthogonal in exact numbers, each as long as the quaternion's
// squared length.
template <class Scalar>
std::array<Vector3<Scalar>, 3> axes_of(const std::array<Scalar, 4>& q) {
  const auto& [w, x, y, z] = q;
  const Scalar two(2);
  return {
      Vector3<Scalar>(w * w + x * x - y * y - z * z, two * (x * y - w * z), two * (x * z + w * y)),
      Vector3<Scalar>(two * (x * y + w * z), w * w - x * x + y * y - z * z, two * (y * z - w * x)),
      Vector3<Scalar>(two * (x * z - w * y), two * (y * z + w * x), w * w - x * x - y * y + z * z)};
}

Quaternion normalized(const Quaternion& q) {
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  return {q[0] / length, q[1] / length, q[2] / length, q[3] / length};
}

double box_volume(const HullToFit& hull, const Quaternion& rotation) {
  double volume = 1;
  for (const Point& axis : axes_of(rotation)) {
    const double a = axis.x(), b = axis.y(), c = axis.z();
    double low = INFINITY, high = -INFINITY;
    for (const Point& p : hull.vertices) {
      const double height = a * p.x() + b * p.y() + c * p.z();
      low = std::min(low, height);
      high = std::max(high, height);
    }
    volume *= high - low;
  }
  return volume;
}

// The k-th of n rotations that cover all of them evenly [Alexa2022].
Quaternion super_fibonacci(std::size_t k, std::size_t n) {
  constexpr double kPhi = std::numbers::sqrt2;
  constexpr double kPsi = 1.533751168755204288118041;  // psi^4 = psi + 4
  const double s = static_cast<double>(k) + 0.5, t = s / static_cast<double>(n);
  const double outer = std::sqrt(t), inner = std::sqrt(1 - t);
  const double alpha = 2 * std::numbers::pi * s / kPhi, beta = 2 * std::numbers::pi * s / kPsi;
  return {outer * std::sin(alpha), outer * std::cos(alpha), inner * std::sin(beta),
          inner * std::cos(beta)};
}

struct Oriented {
  Quaternion rotation;
  double volume;
};

// Turns about the axes by ever smaller angles, as long as the box shrinks. The rounds are limited:
// for needles, where rounding changes volumes more than small turns do, it might go on for hours.
Oriented descend(const HullToFit& hull, Oriented best) {
  constexpr double kFirstAngle = 0.05, kLastAngle = 1e-9;
  constexpr int kRounds = 500;
  double angle = kFirstAngle;
  for (int round = 0; round < kRounds && angle > kLastAngle; ++round) {
    hull.watch.ask();
    bool is_smaller = false;
    for (const std::size_t axis : {1u, 2u, 3u}) {
      for (const double turn : {angle / 2, -angle / 2}) {
        const auto& [w, x, y, z] = best.rotation;
        Quaternion turned = best.rotation;  // (1 + turn * unit of axis) * rotation
        if (axis == 1) turned = {w - turn * x, x + turn * w, y - turn * z, z + turn * y};
        if (axis == 2) turned = {w - turn * y, x + turn * z, y + turn * w, z - turn * x};
        if (axis == 3) turned = {w - turn * z, x - turn * y, y + turn * x, z + turn * w};
        turned = normalized(turned);
        const double volume = box_volume(hull, turned);
        if (volume >= best.volume) continue;
        best = {turned, volume};
        is_smaller = true;
      }
    }
    if (!is_smaller) angle /= 2;
  }
  return best;
}

}  // namespace

Normals propose_obb(const HullToFit& hull, std::size_t, std::uint64_t) {
  constexpr std::size_t kRotations = 100'000, kDescents = 8;
  // (1) The box of the axes, so that the result is never larger than that, and all samples.
  std::vector<Oriented> boxes{{{1, 0, 0, 0}, 0}};
  for (std::size_t k = 0; k < kRotations; ++k) boxes.push_back({super_fibonacci(k, kRotations), 0});
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    hull.watch.at(k, boxes.size());
    boxes[k].volume = box_volume(hull, boxes[k].rotation);
  }
  // (2) From the best of them downhill. A stable order keeps ties as they were sampled.
  std::stable_sort(boxes.begin(), boxes.end(),
                   [](const Oriented& a, const Oriented& b) { return a.volume < b.volume; });
  boxes.resize(kDescents);
  for (Oriented& box : boxes) box = descend(hull, box);
  const auto best =
      std::min_element(boxes.begin(), boxes.end(),
                       [](const Oriented& a, const Oriented& b) { return a.volume < b.volume; });
  // (3) Exactly orthogonal directions near the rotated axes.
  std::array<Rational, 4> exact;
  std::transform(best->rotation.begin(), best->rotation.end(), exact.begin(),
                 [](double x) { return to_rational(x); });
  Normals normals;
  for (const RationalVector3& axis : axes_of(exact)) {
    normals.push_back(axis);
    normals.push_back(-axis);
  }
  return normals;
}

}  // namespace convexact
