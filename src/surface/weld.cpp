// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "convexact/error.hpp"
#include "convexact/surface.hpp"
#include "surface/box_tree.hpp"

namespace convexact {
namespace {

// Points that faces use, in lexicographic order; equal ones by their numbers.
std::vector<std::uint32_t> used_in_order(const Mesh& mesh) {
  const std::vector<bool> is_used = used_points(mesh.points.size(), mesh.polygons);
  std::vector<std::uint32_t> order;
  for (std::uint32_t p = 0; p < is_used.size(); ++p) {
    if (is_used[p]) order.push_back(p);
  }
  const auto comes_before = [&](std::uint32_t a, std::uint32_t b) {
    if (mesh.points.is_binary()) {
      const Point &x = mesh.points.doubles()[a], &y = mesh.points.doubles()[b];
      return std::lexicographical_compare(x.begin(), x.end(), y.begin(), y.end());
    }
    const RationalPoint x = mesh.points[PointId(a)], y = mesh.points[PointId(b)];
    return std::lexicographical_compare(x.begin(), x.end(), y.begin(), y.end());
  };
  std::stable_sort(order.begin(), order.end(), comes_before);
  return order;
}

// Holds a point whose coordinates were rounded to nearest, and all within a distance of it.
NearBox box_around(const Point& p, double reach) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  NearBox box;
  for (int k = 0; k < 3; ++k) {
    box.low[k] = std::nextafter(std::nextafter(p[k], -kInfinity) - reach, -kInfinity);
    box.high[k] = std::nextafter(std::nextafter(p[k], kInfinity) + reach, kInfinity);
  }
  return box;
}

}  // namespace

WeldedMesh weld(const Mesh& mesh, const Rational& squared_reach, const Watch& watch) {
  if (squared_reach < 0) throw Error(ErrorCode::InvalidArgument, "a distance is not negative");
  const std::vector<std::uint32_t> order = used_in_order(mesh);
  const double reach = std::nextafter(std::sqrt(to_double(squared_reach, Rounding::Up)),
                                      std::numeric_limits<double>::infinity());
  std::vector<NearBox> boxes;
  for (const std::uint32_t p : order) boxes.push_back(box_around(mesh.points.doubles()[p], 0));
  const BoxTree tree(std::move(boxes));
  WeldedMesh welded{mesh, 0, 0};
  std::vector<std::uint32_t> taken_by(mesh.points.size());
  std::iota(taken_by.begin(), taken_by.end(), 0);
  std::vector<bool> is_taken(order.size(), false);
  std::vector<std::uint32_t> found;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (is_taken[i]) continue;
    watch.ask();
    const RationalPoint at = mesh.points[PointId(order[i])];
    tree.find(box_around(mesh.points.doubles()[order[i]], reach), found);
    for (const std::uint32_t k : found) {
      if (k <= i || is_taken[k]) continue;
      const Rational squared = RationalVector3(mesh.points[PointId(order[k])] - at).squaredNorm();
      if (squared > squared_reach) continue;
      is_taken[k] = true;
      taken_by[order[k]] = order[i];
      welded.moved += squared > 0 ? 1 : 0;
      if (squared > welded.squared_move) welded.squared_move = squared;
    }
  }
  for (auto& polygon : welded.mesh.polygons) {
    for (std::uint32_t& corner : polygon) corner = taken_by[corner];
  }
  return welded;
}

}  // namespace convexact
