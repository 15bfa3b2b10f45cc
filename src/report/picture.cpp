// SPDX-License-Identifier: MIT
#include "report/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "convexact/number.hpp"
#include "report/picture_page.hpp"

namespace convexact {
namespace {

constexpr std::size_t kMostPointsDrawn = 200000;
constexpr double kGrid = 10000;  // coordinates become integers in [-kGrid, kGrid]

// Maps the scene's bounding box into the cube [-1, 1]^3, without overflow at huge coordinates.
struct Frame {
  Point center = Point::Zero();
  double half_size = 1;

  explicit Frame(const std::vector<Point>& corners) {
    Point low = Point::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const Point& p : corners) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    if (corners.empty()) return;
    center = 0.5 * low + 0.5 * high;
    const double size = (0.5 * high - 0.5 * low).maxCoeff();
    if (size > 0) half_size = size;
  }
  Point operator()(const Point& p) const { return (0.5 * p - 0.5 * center) / (0.5 * half_size); }
};

std::string coordinates(const Point& p) {
  return fmt::format("{:.0f},{:.0f},{:.0f}", kGrid * p[0], kGrid * p[1], kGrid * p[2]);
}

// Sum of the normals of the polygons around each point (Newell), for shading only.
std::vector<Point> shading_normals(const Picture& picture, const Frame& frame) {
  std::vector<Point> normals(picture.points.size(), Point::Zero());
  for (const auto& polygon : picture.polygons) {
    Point normal = Point::Zero();
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Point p = frame(picture.points[polygon[k]]);
      const Point q = frame(picture.points[polygon[(k + 1) % polygon.size()]]);
      normal += p.cross(q);
    }
    for (const std::uint32_t corner : polygon) normals[corner] += normal;
  }
  return normals;
}

std::string points_data(const Picture& picture, const Frame& frame) {
  const std::vector<Point> normals = shading_normals(picture, frame);
  const std::size_t stride = 1 + picture.points.size() / (kMostPointsDrawn + 1);
  std::string data;
  for (std::size_t i = 0; i < picture.points.size(); i += stride) {
    const double length = normals[i].norm();
    const Point normal = length > 0 ? Point(normals[i] / length) : Point::Zero();
    data += coordinates(frame(picture.points[i])) +
            fmt::format(",{:.0f},{:.0f},{:.0f},", 99 * normal[0], 99 * normal[1], 99 * normal[2]);
  }
  return data;
}

std::string facets_data(const std::vector<Polytope>& proxies) {
  std::string data;
  std::size_t first_corner = 0;
  for (const Polytope& proxy : proxies) {
    for (std::vector<std::uint32_t> facet : proxy.facets) {
      for (std::uint32_t& corner : facet) corner += static_cast<std::uint32_t>(first_corner);
      data += fmt::format("[{}],", fmt::join(facet, ","));
    }
    first_corner += proxy.vertices.size();
  }
  return data;
}

std::vector<Point> corners_of(const std::vector<Polytope>& proxies) {
  std::vector<Point> corners;
  for (const Polytope& proxy : proxies) {
    for (const RationalPoint& vertex : proxy.vertices) {
      Point& corner = corners.emplace_back();
      for (int k = 0; k < 3; ++k) corner[k] = to_double(vertex[k], Rounding::Nearest);
    }
  }
  return corners;
}

std::string escaped(const std::string& text) {
  std::string html;
  for (const char c : text) {
    html += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  }
  return html;
}

void replace(std::string& page, const std::string& mark, const std::string& text) {
  page.replace(page.find(mark), mark.size(), text);
}

}  // namespace

std::string picture_html(const Picture& picture) {
  const std::vector<Point> corners = corners_of(picture.proxies);
  const Frame frame(corners);
  std::string corner_data;
  for (const Point& corner : corners) corner_data += coordinates(frame(corner)) + ",";

  std::string page = kPicturePage;
  replace(page, "@TITLE@", escaped(picture.title));
  replace(page, "@HEADING@", escaped(picture.title));
  replace(page, "@CAPTION@", escaped(picture.caption));
  replace(page, "@POINTS@", points_data(picture, frame));
  replace(page, "@CORNERS@", corner_data);
  replace(page, "@FACETS@", facets_data(picture.proxies));
  return page;
}

}  // namespace convexact
