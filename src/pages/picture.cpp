// SPDX-License-Identifier: MIT
#include "pages/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <unordered_map>

#include "convexact/error.hpp"
#include "io/json_document.hpp"
#include "number/text.hpp"
#include "pages/page_parts.hpp"
#include "pages/picture_frame.hpp"
#include "pages/static_drawing.hpp"

namespace convexact {
namespace {

constexpr int kGrid = 32767;                 // drawn coordinates are integers in [-kGrid, kGrid]
constexpr std::size_t kMostDrawn = 1000000;  // triangles or dots of a layer
constexpr std::size_t kMostTurning = 30000;  // while a page without fast graphics turns
constexpr std::size_t kMostPicked = 5000;    // facets of a layer that can be picked
constexpr std::size_t kMostNumbered = 200;   // facets of a page with a number at each
constexpr std::size_t kMostUnsorted = 12;    // layers that need no order but their own

// --- what viewer.js draws -----------------------------------------------------------------------

bool can_be_picked(const PictureLayer& layer) {
  return !layer.solids.empty() && layer.polygons.size() <= kMostPicked;
}

using GridPoint = std::array<std::int16_t, 3>;
using Triangle = std::array<std::uint32_t, 3>;
using Edge = std::array<std::uint32_t, 2>;

struct DrawnLayer {
  std::vector<GridPoint> points;
  std::vector<Triangle> triangles;
  std::vector<Edge> edges;  // the lower index first
};

// Points that share a cell of a grid become one, their mean, in the order of their first use.
class Clusters {
 public:
  Clusters(const PictureLayer& layer, const PictureFrame& frame, int step)
      : points_(layer.points), frame_(frame), step_(step), clusters_(points_.size(), kNone) {}

  std::uint32_t cluster_of(std::uint32_t point) {
    if (clusters_[point] != kNone) return clusters_[point];
    const Point place = frame_(points_[point]) * kGrid;
    std::uint64_t key = 0;
    for (int k = 0; k < 3; ++k) {
      key = key << 16 | static_cast<std::uint16_t>(std::lround(place[k] / step_));
    }
    const auto next = static_cast<std::uint32_t>(sums_.size());
    const auto [found, is_new] = of_cell_.try_emplace(key, next);
    if (is_new) sums_.push_back({Point::Zero(), 0});
    sums_[found->second].place += place;
    ++sums_[found->second].count;
    return clusters_[point] = found->second;
  }
  std::vector<GridPoint> means() const {
    std::vector<GridPoint> means;
    for (const auto& [place, count] : sums_) {
      GridPoint& mean = means.emplace_back();
      for (int k = 0; k < 3; ++k) {
        const long coordinate = std::lround(place[k] / count);
        mean[k] = static_cast<std::int16_t>(std::clamp(coordinate, -long{kGrid}, long{kGrid}));
      }
    }
    return means;
  }

 private:
  struct Sum {
    Point place;
    int count;
  };
  static constexpr std::uint32_t kNone = ~0u;

  const std::vector<Point>& points_;
  const PictureFrame& frame_;
  int step_;
  std::vector<std::uint32_t> clusters_;  // of each point
  std::unordered_map<std::uint64_t, std::uint32_t> of_cell_;
  std::vector<Sum> sums_;
};

template <class T>
void sort_unique(std::vector<T>& items) {
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

// The layer with one point for each cell of a grid; polygons that collapse there are left out.
DrawnLayer on_grid(const PictureLayer& layer, const PictureFrame& frame, int step) {
  DrawnLayer drawn;
  Clusters clusters(layer, frame, step);
  std::vector<std::uint32_t> polygon;
  for (const auto& indices : layer.polygons) {
    polygon.clear();
    for (const std::uint32_t index : indices) {
      polygon.push_back(clusters.cluster_of(index));
    }
    for (std::size_t k = 2; k < polygon.size(); ++k) {
      Triangle triangle = {polygon[0], polygon[k - 1], polygon[k]};
      std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()),
                  triangle.end());
      if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0]) {
        drawn.triangles.push_back(triangle);
      }
    }
    for (std::size_t k = 0; layer.edges && k < polygon.size(); ++k) {
      const auto [low, high] = std::minmax(polygon[k], polygon[(k + 1) % polygon.size()]);
      if (low != high) drawn.edges.push_back({low, high});
    }
  }
  if (layer.polygons.empty()) {
    for (std::uint32_t k = 0; k < layer.points.size(); ++k) clusters.cluster_of(k);
  }
  sort_unique(drawn.triangles);
  sort_unique(drawn.edges);
  drawn.points = clusters.means();
  return drawn;
}

// The layer on the finest grid that leaves at most so many triangles, and dots.
DrawnLayer drawn_layer(const PictureLayer& layer, const PictureFrame& frame, std::size_t most) {
  // The loop ends: few triangles have their corners in few grid points.
  for (int step = 1;; step = std::max(16, 3 * step / 2)) {
    DrawnLayer drawn = on_grid(layer, frame, step);
    if (std::max(drawn.triangles.size(), drawn.points.size()) <= most) return drawn;
  }
}

// The integers as bytes, the low one first, in base64 [RFC 4648, sec. 4].
template <class Integer, class Group>
std::string base64(const std::vector<Group>& groups) {
  static constexpr char kDigits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  std::uint32_t bits = 0;
  int count = 0;  // of bits not yet written, below 6 between bytes
  for (const Group& group : groups) {
    for (const auto number : group) {
      for (std::size_t byte = 0; byte < sizeof(Integer); ++byte) {
        bits = bits << 8 | (static_cast<std::uint32_t>(number) >> 8 * byte & 255);
        for (count += 8; count >= 6; count -= 6) text += kDigits[bits >> (count - 6) & 63];
      }
    }
  }
  if (count > 0) text += kDigits[bits << (6 - count) & 63];
  while (text.size() % 4 != 0) text += '=';
  return text;
}

// 16-bit coordinates, and indices of 16 bits or, if "wide", 32. Points alone have no triangles.
Json geometry_json(const PictureLayer& layer, const DrawnLayer& drawn) {
  const bool wide = drawn.points.size() > 65536;
  const auto indices = [wide](const auto& groups) {
    return wide ? base64<std::uint32_t>(groups) : base64<std::uint16_t>(groups);
  };
  Json json = {{"wide", wide}, {"points", base64<std::int16_t>(drawn.points)}};
  if (!layer.polygons.empty()) json["triangles"] = indices(drawn.triangles);
  if (layer.edges) json["edges"] = indices(drawn.edges);
  return json;
}

// Every point, even where several share a place.
std::vector<GridPoint> grid_points(const PictureLayer& layer, const PictureFrame& frame) {
  std::vector<GridPoint> points;
  for (const Point& p : layer.points) {
    const Point place = frame(p) * kGrid;
    GridPoint& grid = points.emplace_back();
    for (int k = 0; k < 3; ++k) grid[k] = static_cast<std::int16_t>(std::lround(place[k]));
  }
  return points;
}

// The data that facets.js reads. Corners are not merged on the grid, so facets that share two are
// neighbours.
Json facets_json(const PictureLayer& layer, const PictureFrame& frame) {
  Json solids = Json::array();
  auto polygon = layer.polygons.begin();
  for (const PictureSolid& solid : layer.solids) {
    const auto end = polygon + static_cast<std::ptrdiff_t>(solid.planes.size());
    solids.push_back({{"name", solid.name},
                      {"planes", solid.planes},
                      {"polygons", std::vector<std::vector<std::uint32_t>>(polygon, end)}});
    polygon = end;
  }
  CONVEXACT_ASSERT(polygon == layer.polygons.end());
  return {{"corners", base64<std::int16_t>(grid_points(layer, frame))}, {"solids", solids}};
}

// Every polygon as a fan, with the polygon of each triangle.
Json colored_json(const PictureLayer& layer, const PictureFrame& frame) {
  DrawnLayer drawn;
  drawn.points = grid_points(layer, frame);
  std::vector<std::array<std::uint32_t, 1>> polygon_of;
  for (std::uint32_t f = 0; f < layer.polygons.size(); ++f) {
    const auto& polygon = layer.polygons[f];
    for (std::size_t k = 2; k < polygon.size(); ++k) {
      drawn.triangles.push_back({polygon[0], polygon[k - 1], polygon[k]});
      polygon_of.push_back({f});
    }
  }
  Json json = geometry_json(layer, drawn);
  json["polygonOf"] = base64<std::uint32_t>(polygon_of);
  if (!layer.heat.empty()) {
    std::vector<std::array<std::uint8_t, 1>> heat;
    for (const double x : layer.heat) {
      heat.push_back({static_cast<std::uint8_t>(std::lround(255 * std::clamp(x, 0.0, 1.0)))});
    }
    json["heat"] = base64<std::uint8_t>(heat);
  }
  if (!layer.merges.empty()) json["merges"] = base64<std::uint32_t>(layer.merges);
  if (layer.splits) json["splits"] = *layer.splits;
  if (!layer.joined.empty()) json["joined"] = base64<std::uint32_t>(layer.joined);
  return json;
}

// A layer as viewer.js reads it. "turning", if it is there, is a coarser geometry.
Json layer_json(const PictureLayer& layer, const PictureFrame& frame) {
  Json json = {{"color", layer.color}, {"opacity", layer.opacity}};
  if (layer.right) json["right"] = true;
  if (layer.rank > 0) json["rank"] = layer.rank;
  if (layer.faces_reader) json["facesReader"] = true;
  if (can_be_picked(layer)) json.update(facets_json(layer, frame));
  if (layer.has_colors() && layer.polygons.size() <= kMostDrawn) {
    json.update(colored_json(layer, frame));
    return json;
  }
  const DrawnLayer drawn = drawn_layer(layer, frame, kMostDrawn);
  json.update(geometry_json(layer, drawn));
  if (!layer.away.isZero()) {
    const Point away = frame.length(layer.away) * kGrid;
    json["away"] = {std::lround(away[0]), std::lround(away[1]), std::lround(away[2])};
  }
  if (!layer.edges && std::max(drawn.triangles.size(), drawn.points.size()) > kMostTurning) {
    json["turning"] = geometry_json(layer, drawn_layer(layer, frame, kMostTurning));
  }
  return json;
}

// As heatColor() of shapes.js.
constexpr const char* kHeatScale = "linear-gradient(to right, #2b7ab5, #ffffbf, #d61a1c)";

std::string list_entry(const PictureLayer& layer) {
  std::string counts = with_separators(layer.points.size()) + " points";
  if (!layer.polygons.empty()) {
    const std::string faces = with_separators(layer.polygons.size()) + " faces";
    counts = layer.volume > 0 ? fmt::format("{}, volume {:.3g}", faces, layer.volume)
                              : counts + ", " + faces;
  }
  return fmt::format(
      R"(<li data-points="{}" data-faces="{}" data-volume="{}">)"
      R"(<label><input type="checkbox"{} hidden> <i{} style="background: {}"></i> )"
      R"({} <small>{}</small></label> <button type="button" hidden>only</button></li>)"
      "\n",
      layer.points.size(), layer.polygons.size(), layer.volume, layer.shown ? " checked" : "",
      layer.heat.empty() ? "" : R"( class="scale")",
      layer.heat.empty() ? escaped_markup(layer.color) : kHeatScale, escaped_markup(layer.name),
      counts);
}

// The controls besides the view; viewer.js shows them.
std::string control_list(const std::vector<PictureLayer>& layers) {
  constexpr std::string_view kSlider =
      R"(<label hidden>{} <input type="range" id="{}" min="0" max="{}" value="{}"> )"
      R"(<output>{}</output></label>)"
      "\n";
  constexpr std::string_view kSwitch = R"(<label hidden><input type="checkbox" id="{}"> {}</label>)"
                                       "\n";
  bool moves = false;
  std::size_t merges = 0, splits = 0, joined = 0, facets = 0, right = 0;
  for (const PictureLayer& layer : layers) {
    if (layer.right) ++right;
    if (can_be_picked(layer)) facets += layer.polygons.size();
    moves = moves || !layer.away.isZero();
    if (layer.splits) {
      splits = std::max(splits, *layer.splits);
      joined = std::max(joined, layer.joined.size());
    } else {
      merges = std::max(merges, layer.merges.size());
    }
  }
  std::string list;
  if (facets > 0 && facets <= kMostNumbered) {
    list += fmt::format(kSwitch, "numbers", "numbers of facets");
  }
  if (layers.size() > kMostUnsorted) {
    list += R"(<label hidden>sort by <select id="sort"><option value="">number</option>)"
            R"(<option value="volume">volume</option><option value="faces">faces</option>)"
            R"(<option value="points">points</option></select></label>)"
            "\n";
  }
  if (right > 0 && right < layers.size() && moves)
    list += fmt::format(kSwitch, "glass", "see the input through the parts");
  list += fmt::format(kSwitch, "z-up", "z is up");
  list += fmt::format(kSlider, "cut open", "cut", 100, 0, "");
  if (right > 0 && right < layers.size()) list += fmt::format(kSwitch, "pair", "side by side");
  if (moves) list += fmt::format(kSlider, "draw parts apart", "apart", 100, 0, "");
  if (merges > 0) list += fmt::format(kSlider, "merges", "merges", merges, merges, merges);
  const std::size_t steps = splits + joined;
  if (steps > 0) {
    const bool merge_again = joined > 0;
    list += fmt::format(
        kSlider, merge_again ? "splits, then merges" : "splits", "splits", steps, steps,
        merge_again ? fmt::format("{} and {}", splits, joined) : std::to_string(splits));
  }
  return list;
}

}  // namespace

std::string picture_html(const Picture& picture) {
  const PictureFrame frame(picture.layers);
  Json layers = Json::array();
  std::string list;
  for (const PictureLayer& layer : picture.layers) {
    layers.push_back(layer_json(layer, frame));
    list += list_entry(layer);
  }
  return fill_page(kViewerPage, {{"TITLE", escaped_markup(picture.title)},
                                 {"ANSWER", escaped_markup(picture.answer)},
                                 {"LAYERS", list},
                                 {"CONTROLS", control_list(picture.layers)},
                                 {"DRAWING", static_drawing(picture, frame)},
                                 {"DATA", for_script_element(write_json(layers))},
                                 {"STYLE", kViewerStyle},
                                 {"LIBRARY", kThreeLibrary},
                                 {"FACETS", kFacetsScript},
                                 {"SHAPES", kShapesScript},
                                 {"SCRIPT", kViewerScript}});
}

}  // namespace convexact
