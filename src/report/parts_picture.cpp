// SPDX-License-Identifier: MIT
#include "report/parts_picture.hpp"

#include <fmt/format.h>

#include <array>
#include <numeric>

#include "io/json.hpp"
#include "number/text.hpp"

namespace convexact {
namespace {

// Neighbours in the list differ in hue; red is for what is uncovered.
constexpr std::array kColors = {"#4e79a7", "#f2b134", "#59a14f", "#b07aa1", "#76b7b2", "#9c755f",
                                "#8cd17d", "#86bcb6", "#499894", "#d4a6c8", "#79706e", "#a0cbe8"};
constexpr std::size_t kMostSwitches = 32;  // parts with a switch of their own

PictureLayer uncovered_layer(const SurfaceCoverage& coverage) {
  PictureLayer layer{.name = "uncovered", .color = "#e5202b"};
  for (const UncoveredPiece& piece : coverage.uncovered) {
    if (piece.corners.size() < 3) continue;
    std::vector<Point> corners;
    for (const RationalPoint& c : piece.corners) {
      corners.emplace_back(to_double(c[0], Rounding::Nearest), to_double(c[1], Rounding::Nearest),
                           to_double(c[2], Rounding::Nearest));
    }
    std::vector<std::uint32_t> polygon(corners.size());
    std::iota(polygon.begin(), polygon.end(), 0);
    layer.add(corners, {polygon});
  }
  return layer;
}

}  // namespace

Picture parts_picture(const Mesh& input, const PartsVerdict& verdict, const std::string& title) {
  Picture picture;
  picture.title = as_utf8(title);
  PictureLayer surface{.name = "input", .color = "#b8b8b8", .shown = false};
  surface.add(input.points.doubles(), input.polygons);
  picture.layers.push_back(std::move(surface));
  std::size_t pieces = 0;
  if (verdict.coverage && !verdict.coverage->uncovered.empty()) {
    pieces = verdict.coverage->uncovered.size();
    picture.layers.push_back(uncovered_layer(*verdict.coverage));
  }
  const std::size_t switches = std::min(verdict.hulls.size(), kMostSwitches);
  std::vector<PictureLayer> layers;
  for (std::size_t k = 0; k < switches; ++k) {
    layers.push_back({.name = as_utf8(verdict.parts[k].name),
                      .color = kColors[k % kColors.size()],
                      .opacity = 0.55,
                      .edges = true});
  }
  for (std::size_t k = 0; k < verdict.hulls.size(); ++k) {
    PictureLayer& layer = layers[k % kMostSwitches];
    if (k == kMostSwitches + k % kMostSwitches) layer.name += " and others";
    if (const auto& solid = verdict.hulls[k].solid) layer.add(*solid);
  }
  for (PictureLayer& layer : layers) {
    if (!layer.polygons.empty()) picture.layers.push_back(std::move(layer));
  }
  picture.caption = fmt::format(
      "{} parts; {}", with_separators(verdict.hulls.size()),
      pieces > 0 ? with_separators(pieces) + " pieces of the surface lie in none of them"
                 : "no piece of the surface was found outside of them");
  return picture;
}

}  // namespace convexact
