// SPDX-License-Identifier: MIT
// picture.hpp - a page on which the input and the halfspaces around it can be looked at and turned.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "convexact/point_set.hpp"
#include "convexact/polytope.hpp"

namespace convexact {

/// What a picture shows. Coordinates are rounded to about four digits of the size of the scene: a
/// picture is for looking at, and proves nothing.
struct Picture {
  std::string title;          ///< Plain text.
  std::string caption;        ///< Plain text, one line.
  std::vector<Point> points;  ///< The input; a sample of 200,000 if it has more.
  std::vector<std::vector<std::uint32_t>>
      polygons;                   ///< Of the input, for its shading; may be empty.
  std::vector<Polytope> proxies;  ///< What encloses it: one for each object.
};

/// A self-contained HTML page (no network, no library) that draws the points, shaded, inside the
/// translucent proxies; dragging turns it, the wheel scales it.
[[nodiscard]] std::string picture_html(const Picture& picture);

}  // namespace convexact
