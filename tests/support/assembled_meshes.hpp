// SPDX-License-Identifier: MIT
// assembled_meshes.hpp - meshes of several pieces, to be decomposed.
#pragma once
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>
#include <variant>
#include <vector>

#include "convexact/hull.hpp"
#include "convexact/io.hpp"

namespace support {

using convexact::Mesh;
using convexact::Point;
using convexact::PointId;
using convexact::PointSet;
using convexact::RationalPoint;

inline std::vector<RationalPoint> points_in(const PointSet& set) {
  std::vector<RationalPoint> points;
  for (std::size_t i = 0; i < set.size(); ++i) points.push_back(set[PointId(i)]);
  return points;
}

inline Mesh mesh_of(std::vector<Point> points, std::vector<std::vector<std::uint32_t>> polygons) {
  const std::size_t count = polygons.size();
  return {PointSet(std::move(points)), std::move(polygons), {{"", 0, count}}};
}

/// All faces of some meshes.
inline Mesh joined(const std::vector<Mesh>& meshes) {
  std::vector<RationalPoint> points;
  Mesh all;
  for (const Mesh& mesh : meshes) {
    const auto first = std::uint32_t(points.size());
    for (const RationalPoint& p : points_in(mesh.points)) points.push_back(p);
    for (auto polygon : mesh.polygons) {
      for (auto& corner : polygon) corner += first;
      all.polygons.push_back(std::move(polygon));
    }
  }
  all.points = PointSet(std::move(points));
  all.parts = {{"", 0, all.polygons.size()}};
  return all;
}

/// The hull of points near a sphere.
inline Mesh ball(const Point& center, int count) {
  std::mt19937_64 random(7);
  const auto coordinate = [&] { return std::ldexp(double(random() >> 11), -52) - 1; };
  std::vector<Point> points;
  while (points.size() < std::size_t(count)) {
    const Point p(coordinate(), coordinate(), coordinate());
    if (p.norm() > 0.1) points.push_back(center + p / p.norm());
  }
  const PointSet set(points);
  const auto hull = std::get<convexact::Hull>(convexact::convex_hull(set));
  Mesh mesh{set, {}, {}};
  for (std::size_t f = 0; f < hull.facets.size(); ++f) {
    auto& polygon = mesh.polygons.emplace_back();
    for (const PointId corner : hull.facets[f]) polygon.push_back(corner.value);
  }
  mesh.parts = {{"", 0, mesh.polygons.size()}};
  return mesh;
}

}  // namespace support
