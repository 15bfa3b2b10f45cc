// SPDX-License-Identifier: MIT
#include "wire/model_body.hpp"

#include <algorithm>
#include <cmath>

namespace convexact {
namespace {

// Of the symmetric matrix xx, yy, zz, xy, xz, yz: whether no eigenvalue is negative, by all
// principal minors.
bool is_semidefinite(const std::array<Rational, 6>& m) {
  const auto& [xx, yy, zz, xy, xz, yz] = m;
  const Rational determinant =
      xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
  return xx >= 0 && yy >= 0 && zz >= 0 && xx * yy >= xy * xy && xx * zz >= xz * xz &&
         yy * zz >= yz * yz && determinant >= 0;
}

}  // namespace

bool is_tensor_of_body(const std::array<double, 6>& inertia) {
  std::array<Rational, 6> second;
  Rational half_trace = 0;
  for (std::size_t k = 0; k < 3; ++k) half_trace += to_rational(inertia[k]) / 2;
  for (std::size_t k = 0; k < 6; ++k) {
    second[k] = (k < 3 ? half_trace : Rational(0)) - to_rational(inertia[k]);
  }
  // A tensor of zeros is no body's; with second moments of which one is positive, at most one
  // principal moment, that of a rod about itself, could be 0.
  return is_semidefinite(second) &&
         std::all_of(inertia.begin(), inertia.begin() + 3, [](double x) { return x > 0; });
}

std::optional<BodyMass> body_mass(const MassProperties& of, const Rational& density,
                                  const Rational& scale) {
  const auto nearest = [](const Rational& x) { return to_double(x, Rounding::Nearest); };
  const Rational kilograms = density * scale * scale * scale;
  BodyMass body;
  body.mass = nearest(of.volume * kilograms);
  for (int k = 0; k < 3; ++k) body.center[k] = nearest(of.center[k] * scale);
  const std::array<Rational, 6> exact = of.inertia();
  const Rational unit = kilograms * scale * scale;
  const auto is_usable = [&] {
    return body.mass > 0 && std::isfinite(body.mass) && body.center.allFinite() &&
           std::all_of(body.inertia.begin(), body.inertia.end(),
                       [](double x) { return std::isfinite(x); });
  };
  for (std::size_t k = 0; k < 6; ++k) body.inertia[k] = nearest(exact[k] * unit);
  constexpr int kMostDoublings = 8;
  Rational growth(1, std::int64_t(1) << 53);
  for (int turn = 0; is_usable() && turn < kMostDoublings; ++turn) {
    if (is_tensor_of_body(body.inertia)) return body;
    // Adding the same to all three principal moments adds half of it to each second moment.
    const Rational more = growth * (exact[0] + exact[1] + exact[2]) * unit;
    for (std::size_t k = 0; k < 3; ++k) body.inertia[k] = nearest(exact[k] * unit + more);
    growth *= 2;
  }
  return {};
}

}  // namespace convexact
