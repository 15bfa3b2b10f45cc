// SPDX-License-Identifier: MIT
// triple.hpp - three numbers of any kind: the few vector operations of the fast engines.
#pragma once

namespace convexact {

template <class Scalar>
struct Triple {
  Scalar x, y, z;
};

template <class Scalar>
inline Triple<Scalar> operator-(const Triple<Scalar>& a, const Triple<Scalar>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <class Scalar>
inline Triple<Scalar> cross(const Triple<Scalar>& a, const Triple<Scalar>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class Scalar>
inline Scalar dot(const Triple<Scalar>& a, const Triple<Scalar>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

}  // namespace convexact
