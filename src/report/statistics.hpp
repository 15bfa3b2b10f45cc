// SPDX-License-Identifier: MIT
// statistics.hpp - statistics of repeated measurements: their spread, and the power law behind a
// series.
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace convexact {

/// Of the middle, or half way between the two middle ones. Precondition: at least one value.
[[nodiscard]] double median(std::vector<double> values);

/// Repeated measurements of one quantity.
struct Spread {
  double least = 0, median = 0, most = 0;
  std::size_t repetitions = 0;
};

/// Precondition: at least one value.
[[nodiscard]] Spread spread_of(const std::vector<double>& values);

/// y = factor x^exponent.
struct PowerLaw {
  double exponent, factor;
  double standard_error;  ///< Of the exponent, from the residuals; n - 2 degrees
                          ///< of freedom.
};

/// The straight line of least squares through (log x, log y). None for fewer than three different
/// x.
/// @param points  (x, y), all positive.
/// @par Source    [DraperSmith1998, sec. 1.2 to 1.4]
[[nodiscard]] std::optional<PowerLaw> fit_power_law(
    std::span<const std::pair<double, double>> points);

}  // namespace convexact
