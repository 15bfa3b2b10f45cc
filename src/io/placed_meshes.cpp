// SPDX-License-Identifier: MIT
#include "io/placed_meshes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "convexact/error.hpp"
#include "number/text.hpp"

namespace convexact {
namespace {

// A short file may place a long mesh many times.
constexpr std::size_t kMostCorners = 100'000'000;

}  // namespace

std::uint32_t PlacedMeshes::add_point(const PointSet& points, std::uint32_t index,
                                      const Placement& placement, bool is_placed) {
  if (!is_placed && points.is_binary()) return points_.add(points.doubles()[index]);
  const RationalPoint local = points[PointId(index)];
  const RationalPoint exact = is_placed ? placement(local) : local;
  const std::uint32_t number = points_.add(exact);
  if (decimal_ == Decimal::Exact) return number;
  const Point& rounded = points_.double_at(number);
  for (int k = 0; k < 3; ++k) {
    const Rational move = abs(exact[k] - to_rational(rounded[k]));
    if (move != 0) largest_move_ = std::max(largest_move_, to_double(move, Rounding::Up));
  }
  return number;
}

void PlacedMeshes::add(const std::string& name, const LocalMesh& mesh, const Placement& placement) {
  const Sign orientation = placement.orientation();
  if (orientation == Sign::Zero) {
    throw Error(
        ErrorCode::Malformed,
        "expected transforms of nodes that keep three dimensions, found one that flattens " +
            in_quotes(name));
  }
  corners_ += mesh.loose.size();
  for (const auto& polygon : mesh.polygons) corners_ += polygon.size();
  if (corners_ > kMostCorners) {
    throw Error(ErrorCode::Malformed, "expected at most " + with_separators(kMostCorners) +
                                          " corners in all instances of meshes");
  }
  const bool is_placed = placement != Placement{};
  const double before = std::exchange(largest_move_, 0);
  constexpr std::uint32_t kNew = ~std::uint32_t{0};
  std::vector<std::uint32_t> numbers(mesh.points.size(), kNew);
  const auto number_of = [&](std::uint32_t index) {
    if (numbers[index] == kNew) {
      numbers[index] = add_point(mesh.points, index, placement, is_placed);
    }
    return numbers[index];
  };
  const std::size_t first = mesh_.polygons.size();
  for (const auto& polygon : mesh.polygons) {
    auto& placed = mesh_.polygons.emplace_back();
    for (const std::uint32_t corner : polygon) placed.push_back(number_of(corner));
    if (orientation == Sign::Negative) std::reverse(placed.begin() + 1, placed.end());
  }
  MeshPart part{name, first, mesh_.polygons.size()};
  for (const std::uint32_t point : mesh.loose) part.loose.push_back(number_of(point));
  std::sort(part.loose.begin(), part.loose.end());
  part.loose.erase(std::unique(part.loose.begin(), part.loose.end()), part.loose.end());
  mesh_.parts.push_back(std::move(part));
  if (largest_move_ > 0) ++moved_;
  largest_move_ = std::max(largest_move_, before);
}

Mesh PlacedMeshes::finish() {
  if (moved_ > 0) {
    mesh_.notes.push_back(fmt::format(
        "the transforms of nodes were computed exactly and rounded once: coordinates of {} moved "
        "by up to {:.2g}; --decimal exact keeps them",
        counted(moved_, "object", "objects"), largest_move_));
  }
  // Merging may have made a point a corner of some polygon.
  const PointSet points = points_.finish();
  const std::vector<bool> is_used = used_points(points.size(), mesh_.polygons);
  for (MeshPart& part : mesh_.parts) {
    std::erase_if(part.loose, [&](std::uint32_t point) { return is_used[point]; });
  }
  std::erase_if(mesh_.parts, [](const MeshPart& part) {
    return part.first_polygon == part.last_polygon && part.loose.empty();
  });
  if (mesh_.parts.empty()) mesh_.parts.push_back({"", 0, 0});
  mesh_.points = points;
  return std::move(mesh_);
}

}  // namespace convexact
