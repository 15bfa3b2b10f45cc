// SPDX-License-Identifier: MIT
// angular_excess.hpp - by how much the angle at an edge of a cap counts for the mean width, with
// proven bounds.
#pragma once
#include "fast/dual.hpp"
#include "number/double_double.hpp"

namespace convexact {

/// (E2) The distance of two directions of dual points, as computed, is off by so many units of
/// roundoff.
inline constexpr double kChordError = 24;

/// sin theta times f of MetricCost, for normals i, x, y: of the differences between them. Where two
/// normals are nearly opposite, the interval is [0, infinity].
/// @param to_x, to_y  The differences from normal i; `across` that from x to y. All as computed
///                    from directions of DualNormals.
[[nodiscard]] Interval<double> angular_excess(const Triple<double>& to_x,
                                              const Triple<double>& to_y,
                                              const Triple<double>& across);
/// The same in longer arithmetic, for directions whose error is of its unit. Where a difference is
/// longer than 1/2, the interval is [0, infinity].
[[nodiscard]] Interval<DoubleDouble> angular_excess(const Triple<DoubleDouble>& to_x,
                                                    const Triple<DoubleDouble>& to_y,
                                                    const Triple<DoubleDouble>& across);
/// The same as it is computed, for angles of any size; NaN next to opposite normals.
[[nodiscard]] double rounded_angular_excess(const Triple<double>& to_x, const Triple<double>& to_y,
                                            const Triple<double>& across);

}  // namespace convexact
