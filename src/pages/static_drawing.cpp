// SPDX-License-Identifier: MIT
#include "pages/static_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "number/text.hpp"

namespace convexact {
namespace {

constexpr std::size_t kMostStaticDots = 3000;  // of a layer

// The points of a layer in the first view of viewer.js, without perspective: x to the right, y
// down.
std::vector<std::array<int, 2>> projected(const PictureLayer& layer, const PictureFrame& frame) {
  // Turned by 0.6 and tilted by 0.35. Digits, as cos() may differ in its last bit among platforms.
  constexpr double kCosTurn = 0.8253356149, kSinTurn = 0.5646424734;
  constexpr double kCosTilt = 0.9393727128, kSinTilt = 0.3428978075;
  std::vector<std::array<int, 2>> places;
  for (const Point& point : layer.points) {
    const Point p = 1000 * frame(point);
    const double depth = kCosTurn * p[2] - kSinTurn * p[0];
    places.push_back({static_cast<int>(std::lround(kCosTurn * p[0] + kSinTurn * p[2])),
                      static_cast<int>(std::lround(kSinTilt * depth - kCosTilt * p[1]))});
  }
  return places;
}

// Two paths: edges of faces that look away, dashed; and the faces in front. On a convex solid these
// are the hidden edges and the visible ones.
std::array<std::string, 2> edge_paths(const PictureLayer& layer,
                                      const std::vector<std::array<int, 2>>& places) {
  std::array<std::string, 2> paths;
  for (const auto& polygon : layer.polygons) {
    std::int64_t area = 0;  // y points down: negative if counter-clockwise for the viewer
    std::string path;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const auto [x, y] = places[polygon[k]];
      const auto [u, v] = places[polygon[(k + 1) % polygon.size()]];
      area += std::int64_t{x} * v - std::int64_t{u} * y;
      path += fmt::format("{}{} {}", k == 0 ? 'M' : 'L', x, y);
    }
    paths[area < 0 ? 1 : 0] += path + "z";
  }
  return paths;
}

std::string dot_path(const std::vector<std::array<int, 2>>& places) {
  const std::size_t stride = (places.size() + kMostStaticDots - 1) / kMostStaticDots;
  std::string path;
  for (std::size_t k = 0; k < places.size(); k += stride) {
    path += fmt::format("M{} {}h0", places[k][0], places[k][1]);
  }
  return path;
}

}  // namespace

// Surfaces with edges as their edges, everything else as dots. Hidden edges lie below all dots.
std::string static_drawing(const Picture& picture, const PictureFrame& frame) {
  std::string below, above;
  std::array<int, 2> low = {0, 0}, high = {0, 0};
  for (const PictureLayer& layer : picture.layers) {
    if (!layer.shown) continue;
    const auto places = projected(layer, frame);
    for (const auto& place : places) {
      for (int k : {0, 1}) {
        low[k] = std::min(low[k], place[k]);
        high[k] = std::max(high[k], place[k]);
      }
    }
    const std::string color = escaped_markup(layer.color);
    if (layer.edges && !layer.polygons.empty()) {
      const auto [hidden, front] = edge_paths(layer, places);
      below += fmt::format(R"(<path fill="none" stroke="{}" stroke-width="4" )"
                           R"(stroke-dasharray="16 14" d="{}"/>)"
                           "\n",
                           color, hidden);
      above += fmt::format(R"(<path fill="{0}" fill-opacity="{1}" stroke="{0}" stroke-width="8" )"
                           R"(stroke-linejoin="round" d="{2}"/>)"
                           "\n",
                           color, std::min(layer.opacity, 0.5), front);
    } else {
      above += fmt::format(R"(<path stroke="{}" stroke-width="12" stroke-linecap="round" d="{}"/>)"
                           "\n",
                           color, dot_path(places));
    }
  }
  return fmt::format(R"(<svg viewBox="{} {} {} {}" role="img" aria-label="A static drawing">)"
                     "\n",
                     low[0] - 30, low[1] - 30, high[0] - low[0] + 60, high[1] - low[1] + 60) +
         below + above + "</svg>\n";
}

}  // namespace convexact
