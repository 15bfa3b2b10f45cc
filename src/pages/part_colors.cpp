// SPDX-License-Identifier: MIT
#include "pages/part_colors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <string_view>

#include "convexact/overlay.hpp"
#include "convexact/query.hpp"

namespace convexact {
namespace {

using Neighbours = std::vector<std::vector<std::size_t>>;

// Rounding to doubles is monotone, so the boxes meet if the parts do.
struct CornerBox {
  explicit CornerBox(const PointSet& points) : low(points.doubles()[0]), high(low) {
    for (const Point& p : points.doubles()) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
  bool meets(const CornerBox& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
  Point low, high;
};

Neighbours contacts(std::span<const PointSet* const> parts) {
  Neighbours neighbours(parts.size());
  std::vector<CornerBox> boxes;
  for (const PointSet* part : parts) boxes.emplace_back(*part);
  std::vector<std::optional<ConvexPart>> hulls(parts.size());
  const auto hull = [&](std::size_t k) -> const std::optional<Polytope>& {
    if (!hulls[k]) hulls[k] = convex_part(*parts[k]);
    return hulls[k]->solid;
  };
  for (std::size_t b = 1; b < parts.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      if (!boxes[a].meets(boxes[b])) continue;
      if (hull(a) && hull(b) &&
          !std::holds_alternative<CommonPoint>(find_overlap(*hull(a), *hull(b)))) {
        continue;
      }
      neighbours[a].push_back(b);
      neighbours[b].push_back(a);
    }
  }
  return neighbours;
}

}  // namespace

std::vector<std::size_t> colors_by_contact(std::span<const PointSet* const> parts) {
  constexpr std::size_t kNone = ~std::size_t{0};
  const Neighbours neighbours = contacts(parts);
  std::vector<std::size_t> order(parts.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return neighbours[a].size() > neighbours[b].size();
  });
  std::vector<std::size_t> colors(parts.size(), kNone), uses(kPartColors.size(), 0);
  for (const std::size_t part : order) {
    std::vector<bool> is_taken(uses.size(), false);
    for (const std::size_t other : neighbours[part]) {
      if (colors[other] != kNone) is_taken[colors[other]] = true;
    }
    // The least used one of the palette; else the first one beyond it.
    std::optional<std::size_t> best;
    for (std::size_t c = 0; c < uses.size(); ++c) {
      if (is_taken[c]) continue;
      if (!best || (c < kPartColors.size() && uses[c] < uses[*best])) best = c;
    }
    if (!best) {
      best = uses.size();
      uses.push_back(0);
    }
    ++uses[*best];
    colors[part] = *best;
  }
  return colors;
}

std::string part_color(std::size_t number) {
  const std::string_view color = kPartColors[number % kPartColors.size()];
  const std::size_t round = number / kPartColors.size();
  std::string text = "#";
  for (std::size_t k = 1; k < color.size(); k += 2) {
    const int channel = std::stoi(std::string(color.substr(k, 2)), nullptr, 16);
    text +=
        fmt::format("{:02x}", static_cast<int>(channel / (1 + 0.6 * static_cast<double>(round))));
  }
  return text;
}

}  // namespace convexact
