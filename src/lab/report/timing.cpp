// SPDX-License-Identifier: MIT
#include "lab/report/timing.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace convexact {

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

Spread spread_of(const std::vector<double>& values) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return {*least, median(values), *most, values.size()};
}

std::optional<PowerLaw> fit_power_law(std::span<const std::pair<double, double>> points) {
  std::set<double> different;
  double mean_x = 0, mean_y = 0;
  const double n = static_cast<double>(points.size());
  for (const auto& [x, y] : points) {
    different.insert(x);
    mean_x += std::log(x) / n;
    mean_y += std::log(y) / n;
  }
  if (different.size() < 3) return std::nullopt;
  double xx = 0, xy = 0;
  for (const auto& [x, y] : points) {
    xx += (std::log(x) - mean_x) * (std::log(x) - mean_x);
    xy += (std::log(x) - mean_x) * (std::log(y) - mean_y);
  }
  const double slope = xy / xx;
  double unexplained = 0;
  for (const auto& [x, y] : points) {
    const double residual = (std::log(y) - mean_y) - slope * (std::log(x) - mean_x);
    unexplained += residual * residual;
  }
  return PowerLaw{slope, std::exp(mean_y - slope * mean_x), std::sqrt(unexplained / (n - 2) / xx)};
}

}  // namespace convexact
