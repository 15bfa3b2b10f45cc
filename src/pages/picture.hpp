// SPDX-License-Identifier: MIT
// picture.hpp - a page on which shapes can be looked at and turned.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "convexact/geometry.hpp"

namespace convexact {

/// A solid whose facets a reader can pick, and the data that the page then shows. Exact numbers are
/// stored as text.
struct PictureSolid {
  std::string name;                 ///< Plain text.
  std::vector<std::string> planes;  ///< By facet: "(n1, n2, n3, d)", n.x + d <= 0.
};

/// The elements that a picture shows and hides together: surfaces, or points.
struct PictureLayer {
  std::string name;    ///< Plain text; shown beside the layer's switch.
  std::string color;   ///< "#rrggbb".
  double opacity = 1;  ///< Of the faces, in (0, 1]. Below 1, polygons must be closed surfaces,
                       ///< counter-clockwise from outside.
  bool edges = false;  ///< Draws the edges of the polygons.
  bool shown = true;   ///< When the page opens.
  bool right = false;  ///< Shown in the right pane if a reader has two, otherwise in the left one.
  std::vector<Point> points = {};  ///< Drawn as dots if there are no polygons.
  std::vector<std::vector<std::uint32_t>> polygons = {};  ///< Indices into `points`.
  /// Layers whose faces share places, as parts that touch or overlap do: at a place of several, the
  /// faces of the lowest rank are seen, and none flickers.
  std::size_t rank = 0;
  /// Of a closed surface, in cubed units; for a list that readers sort.
  double volume = 0;
  /// Whether the picture is first seen from the side where this layer is.
  bool faces_reader = false;
  /// How far the layer moves, in the scene's units, when a reader draws layers apart.
  Point away = Point::Zero();
  /// By polygon, 0 to 1: its colour, from blue to red. Empty: `color`.
  std::vector<double> heat = {};
  /// Pairs of polygons whose groups become one, step by step; a group is named by its lowest
  /// polygon, the lower name first. A pair of a name with itself is a step that changes no colour.
  /// The page colours groups after as many steps as a reader asks for. Empty: `color`.
  std::vector<std::array<std::uint32_t, 2>> merges = {};
  /// The last so many merges undo splits: a reader chooses a number of splits instead.
  std::optional<std::size_t> splits = {};
  /// After all splits: pairs of groups, as above, that become one again, step by step.
  std::vector<std::array<std::uint32_t, 2>> joined = {};
  /// The polygons are the facets of these solids, one solid after another. Empty: none can be
  /// picked.
  std::vector<PictureSolid> solids = {};

  /// Whether polygons have separate colours; then they are drawn in full, without edges.
  bool has_colors() const { return !heat.empty() || !merges.empty(); }

  /// Adds a surface, or a cloud of points if there are no polygons.
  void add(std::span<const Point> more, const std::vector<std::vector<std::uint32_t>>& faces);
  /// Adds a solid, its corners rounded to nearest.
  void add(const Polytope& solid);
  /// The same, and its facets can be picked. All polygons of the layer must be added like this.
  void add_to_pick(const Polytope& solid, std::string solid_name);
  /// A solid with corners in doubles; planes[k] bounds facets[k].
  void add_to_pick(std::span<const Point> corners,
                   const std::vector<std::vector<std::uint32_t>>& facets,
                   std::span<const Halfspace> planes, std::string solid_name);
  /// Adds a ball, of a few hundred faces.
  void add_ball(const Point& center, double radius);
  /// Adds one facet of it.
  void add_facet(const Polytope& solid, std::size_t facet);
};

/// The nearest doubles; the ends of their range beyond it.
[[nodiscard]] Point drawn_at(const RationalPoint& vertex);

/// The contents of a picture. Layers are drawn one after another: inner ones should come first.
struct Picture {
  std::string title;   ///< A name, plain text.
  std::string answer;  ///< What was found, plain text, one line: it stands first.
  std::vector<PictureLayer> layers;
};

/// A self-contained HTML page that draws the layers by three.js; it opens from disk and needs no
/// network. If the browser has no WebGL 2, and in print, it shows a static drawing instead. Same
/// picture, same bytes. Coordinates are rounded to 1/32767 of half the scene's size, and more
/// coarsely in a layer of more than a million triangles or points: a picture is for looking at, and
/// proves nothing.
[[nodiscard]] std::string picture_html(const Picture& picture);

}  // namespace convexact
