// SPDX-License-Identifier: MIT
// rounding_slack.hpp - whether a violation is no larger than the rounding of coordinates explains.
#pragma once
#include <span>

#include "convexact/point_set.hpp"

namespace convexact {

/// Whether a point is off the plane of a face by no more than this explains: each coordinate of a
/// corner moves by up to `slack`, each of the point by up to `point_slack`.
///
/// Six times the volume between face and point is the sum of the determinants
/// D_k = det(c_k - c_0, c_(k+1) - c_0, p - c_0). If each entry of a matrix moves by up to w, its
/// determinant moves by at most perm(|D| + w) - perm(|D|), with the permanents of the absolute
/// values. The distance is explained if |sum of D_k| is at most the sum of these bounds. Exact;
/// on slivers, whose planes mean little, it allows long distances, on large faces only tiny ones.
/// @param corners  Three or more, in cyclic order.
[[nodiscard]] bool is_explained(std::span<const RationalPoint> corners, const Rational& slack,
                                const RationalPoint& point, const Rational& point_slack);

}  // namespace convexact
