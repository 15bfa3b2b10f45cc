// SPDX-License-Identifier: MIT
// Colours of parts. What readers see is computed here from the published matrices [Machado2009];
// which boxes touch, by their intervals.
#include "pages/part_colors.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

using namespace convexact;

namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

// Of linear RGB: as everybody else sees it, and without long, middle or short cones.
const Matrix kVisions[] = {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
                           {{{0.152286, 1.052583, -0.204868},
                             {0.114503, 0.786281, 0.099216},
                             {-0.003882, -0.048116, 1.051998}}},
                           {{{0.367322, 0.860646, -0.227968},
                             {0.280085, 0.672501, 0.047413},
                             {-0.011820, 0.042940, 0.968881}}},
                           {{{1.255528, -0.076749, -0.178779},
                             {-0.078411, 0.930809, 0.147602},
                             {0.004733, 0.691367, 0.303900}}}};
// To the primaries of CIE XYZ over the white of sRGB [IEC 61966-2-1].
const Matrix kXyz = {
    {{0.4339, 0.3762, 0.1899}, {0.2126, 0.7152, 0.0722}, {0.0177, 0.1094, 0.8729}}};

Point times(const Matrix& m, const Point& x) {
  Point y = Point::Zero();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) y[i] += m[std::size_t(i)][std::size_t(j)] * x[j];
  }
  return y;
}

Point linear(const std::string& color) {
  Point rgb;
  for (int k = 0; k < 3; ++k) {
    const double x = std::stoi(color.substr(std::size_t(1 + 2 * k), 2), nullptr, 16) / 255.0;
    rgb[k] = x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
  }
  return rgb;
}

Point cielab(const Matrix& vision, const std::string& color) {
  const Point seen = times(vision, linear(color)).cwiseMax(0).cwiseMin(1);
  const Point f = times(kXyz, seen).unaryExpr([](double x) {
    return x > 216.0 / 24389 ? std::cbrt(x) : (24389.0 / 27 * x + 16) / 116;
  });
  return {116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
}

std::vector<std::size_t> colors_of(const std::vector<std::vector<Point>>& boxes) {
  std::vector<PointSet> sets;
  for (const auto& box : boxes) sets.emplace_back(box);
  std::vector<const PointSet*> parts;
  for (const PointSet& set : sets) parts.push_back(&set);
  return colors_by_contact(parts);
}

std::vector<Point> box(const Point& low, const Point& high) {
  std::vector<Point> corners;
  for (int k = 0; k < 8; ++k) {
    corners.emplace_back(k & 1 ? high[0] : low[0], k & 2 ? high[1] : low[1],
                         k & 4 ? high[2] : low[2]);
  }
  return corners;
}

}  // namespace

TEST_CASE("part colors: every two differ for every reader") {
  std::vector<std::string> colors(kPartColors.begin(), kPartColors.end());
  colors.emplace_back(kOutsideColor);
  for (const Matrix& vision : kVisions) {
    for (std::size_t b = 1; b < colors.size(); ++b) {
      for (std::size_t a = 0; a < b; ++a) {
        CAPTURE(colors[a]);
        CAPTURE(colors[b]);
        CHECK((cielab(vision, colors[a]) - cielab(vision, colors[b])).norm() > 20);
      }
    }
  }
  CHECK(part_color(0) == "#287cf4");
  CHECK(part_color(12) == "#194d98");  // 40/1.6, 124/1.6, 244/1.6
}

TEST_CASE("part colors: cells of a grid that touch differ, and all colours are in use") {
  std::vector<std::vector<Point>> cells;
  std::vector<std::array<int, 3>> places;
  for (int i = 0; i < 64; ++i) {
    places.push_back({i % 4, i / 4 % 4, i / 16});
    const Point low(places.back()[0], places.back()[1], places.back()[2]);
    cells.push_back(box(low, low + Point::Ones()));
  }
  const std::vector<std::size_t> colors = colors_of(cells);
  std::array<std::size_t, 12> uses{};
  for (std::size_t b = 0; b < cells.size(); ++b) {
    REQUIRE(colors[b] < 12);  // 8 would do
    ++uses[colors[b]];
    for (std::size_t a = 0; a < b; ++a) {
      bool touch = true;
      for (std::size_t k = 0; k < 3; ++k)
        touch = touch && std::abs(places[a][k] - places[b][k]) <= 1;
      if (touch) CHECK(colors[a] != colors[b]);
    }
  }
  for (const std::size_t count : uses) CHECK(count > 0);
}

TEST_CASE("part colors: more neighbours than colours get shades of their own") {
  std::vector<std::vector<Point>> boxes;
  for (int k = 0; k < 15; ++k) boxes.push_back(box({0, 0, 0}, {1, 1, 1.0 + k}));
  std::vector<std::size_t> colors = colors_of(boxes);
  std::sort(colors.begin(), colors.end());
  for (std::size_t k = 0; k < colors.size(); ++k) CHECK(colors[k] == k);
}

TEST_CASE(
    "part colors: boxes that meet are no contact where the solids are apart; flat parts count") {
  // Two corners of a cube, cut off: a plane is between them. With both the same colour would do.
  const std::vector<Point> low = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  std::vector<Point> high;
  for (const Point& p : low) high.push_back(Point(0.9, 0.9, 0.9) - 0.6 * p);
  std::vector<std::vector<Point>> parts(13, low);
  for (std::size_t k = 0; k < 12; ++k)
    parts[k + 1] = box({5.0 + double(k), 0, 0}, {5.5 + double(k), 1, 1});
  parts.push_back(high);
  const std::vector<std::size_t> colors = colors_of(parts);
  // 14 parts without a contact: all of the palette, and nothing else.
  for (const std::size_t color : colors) CHECK(color < 12);
  const std::vector<std::size_t> flat =
      colors_of({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, box({0, 0, 0}, {1, 1, 1})});
  CHECK(flat[0] != flat[1]);
}
