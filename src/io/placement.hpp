// SPDX-License-Identifier: MIT
// placement.hpp - where a scene puts a mesh: an affine map in rationals. glTF and COLLADA share it.
#pragma once
#include <Eigen/Core>
#include <array>
#include <span>

#include "convexact/geometry.hpp"

namespace convexact {

/// x -> linear x + shift.
struct Placement {
  Eigen::Matrix<Rational, 3, 3> linear = Eigen::Matrix<Rational, 3, 3>::Identity();
  RationalVector3 shift = RationalVector3::Zero();

  RationalPoint operator()(const RationalPoint& x) const { return linear * x + shift; }
  /// The inner map first.
  friend Placement operator*(const Placement& outer, const Placement& inner) {
    return {outer.linear * inner.linear, outer(inner.shift)};
  }
  friend bool operator==(const Placement&, const Placement&) = default;

  /// Of the determinant: negative for a mirror image, zero for a map that flattens.
  Sign orientation() const;
};

[[nodiscard]] Placement translation(const RationalVector3& by);
[[nodiscard]] Placement scaling(const RationalVector3& by);

/// The rotation of the quaternion x, y, z, w, which need not have length 1: each entry of the
/// matrix is a quadratic form over q.q, so rational.
/// @pre Not all four are 0.
[[nodiscard]] Placement rotation(const std::array<Rational, 4>& q);

/// The rotation about an axis by an angle in degrees: exact by multiples of 90 degrees about an
/// axis whose length is rational, otherwise the rotation of a quaternion with double entries,
/// within 1e-15 radians of it.
/// @pre The axis is not 0.
[[nodiscard]] Placement rotation_about(const RationalVector3& axis, const Rational& degrees);

/// A matrix of four rows, row by row. @throws Error Malformed unless its last row is 0 0 0 1.
[[nodiscard]] Placement affine(std::span<const Rational, 16> rows);

}  // namespace convexact
