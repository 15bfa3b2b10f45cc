// SPDX-License-Identifier: MIT
// small_surfaces.hpp - small seeded surfaces with many ties: terrains, boundaries of cells, and
// soups.
#pragma once
#include <random>
#include <set>

#include "cells.hpp"
#include "convexact/surface.hpp"

namespace support {

/// The triangles of a grid of columns x rows squares, at random whole heights from 0 to `steep`;
/// `missing` of them are left out at random.
inline convexact::Mesh terrain(std::uint32_t columns, std::uint32_t rows, unsigned steep,
                               std::size_t missing, std::mt19937& random) {
  std::vector<Point> points;
  for (std::uint32_t y = 0; y <= rows; ++y) {
    for (std::uint32_t x = 0; x <= columns; ++x) points.emplace_back(x, y, random() % (steep + 1));
  }
  std::vector<std::vector<std::uint32_t>> triangles;
  for (std::uint32_t y = 0; y < rows; ++y) {
    for (std::uint32_t x = 0; x < columns; ++x) {
      const std::uint32_t a = y * (columns + 1) + x, b = a + 1, c = a + columns + 1, d = c + 1;
      triangles.push_back({a, b, d});
      triangles.push_back({a, d, c});
    }
  }
  std::shuffle(triangles.begin(), triangles.end(), random);
  triangles.resize(triangles.size() - std::min(missing, triangles.size() - 1));
  return {convexact::PointSet(std::move(points)), std::move(triangles), {}};
}

/// Random cells that are connected by their faces.
inline std::set<Cell> random_cells(std::size_t count, std::mt19937& random) {
  std::vector<Cell> cells{{0, 0, 0}};
  std::set<Cell> taken{cells[0]};
  while (cells.size() < count) {
    Cell next = cells[random() % cells.size()];
    next[random() % 3] += random() % 2 == 0 ? 1 : -1;
    if (taken.insert(next).second) cells.push_back(next);
  }
  return taken;
}

/// Triangles on points of a grid of (size + 1)^3: most share an edge with an earlier one, and some
/// have no area or are repeated.
inline convexact::Mesh soup(std::size_t points, std::size_t triangles, unsigned size,
                            std::mt19937& random) {
  std::vector<Point> corners;
  const auto coordinate = [&] { return double(random() % (size + 1)); };
  while (corners.size() < points) {
    const double x = coordinate(), y = coordinate();
    corners.emplace_back(x, y, coordinate());
  }
  std::vector<std::vector<std::uint32_t>> faces;
  while (faces.size() < triangles) {
    std::vector<std::uint32_t> face(3);
    for (auto& corner : face) corner = std::uint32_t(random() % points);
    if (!faces.empty() && random() % 8 != 0) {
      const auto& before = faces[random() % faces.size()];
      const std::size_t k = random() % 3;
      face[0] = before[(k + 1) % 3];
      face[1] = before[k];
    }
    faces.push_back(std::move(face));
  }
  return {convexact::PointSet(std::move(corners)), std::move(faces), {}};
}

/// The first triangles of a surface in canonical order, as a surface.
inline convexact::Surface first_triangles(const convexact::Surface& surface, std::size_t count) {
  convexact::Mesh mesh;
  mesh.points = surface.points;
  for (std::size_t t = 0; t < std::min(count, surface.triangles.size()); ++t) {
    const auto& [a, b, c] = surface.triangles[t];
    mesh.polygons.push_back({a.value, b.value, c.value});
  }
  return convexact::make_surface(mesh, {convexact::Orient::Keep});
}

}  // namespace support
