// SPDX-License-Identifier: MIT
// parts_curve.hpp - how near parts are to a solid, how many there are, and how long that takes: for
// each method of decompose(), at several limits.
#pragma once
#include <optional>
#include <vector>

#include "convexact/decompose.hpp"
#include "lab/report/timing.hpp"

namespace convexact {

/// The parts of one method at one limit.
struct PartsPoint {
  DecomposeMethod method = DecomposeMethod::Cut;
  double limit = 0;  ///< As a share of the diameter: the distance of cut, the concavity of others.
  /// Until the parts are stored and proven to hold what they own; without measures. None if that
  /// took longer than the effort allows; then nothing below is known.
  std::optional<Spread> seconds = {};
  std::size_t parts = 0;
  // As the oracle finds them for the stored parts; none if that took longer than the budget.
  /// The larger one of two: of a point of the surface to the union of the parts, and of a point of
  /// the union to the solid, or to the surface if it is open; over the diameter, rounded up.
  std::optional<double> distance = {};
  /// The union's volume outside of the solid, and the solid's outside of the union, as shares of
  /// the solid's volume; none for an open surface.
  std::optional<double> excess = {}, uncovered = {};
};

/// cut, hacd and acd at 0.3%, 1%, 3% and 10% of the diameter, as the program runs them without
/// further options. A method does not go on to a smaller limit after a run over budget.
/// @throws Error as decompose() does for the mesh; Stopped after an interrupt.
[[nodiscard]] std::vector<PartsPoint> measure_parts_curve(const Mesh& mesh, const Effort& effort);

}  // namespace convexact
