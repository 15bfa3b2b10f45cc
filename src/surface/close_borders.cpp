// SPDX-License-Identifier: MIT
// Surfaces with holes, closed: a fan over each border, from the rounded middle of its corners.
#include <algorithm>
#include <map>

#include "convexact/surface.hpp"
#include "number/arithmetic.hpp"
#include "surface/edges.hpp"

namespace convexact {
namespace {

using Loop = std::vector<PointId>;

// Cycles of directed edges that cancel those that the triangles leave over. At a point of several
// borders the way goes on to the lowest point, and a cycle ends where it meets itself, so none
// passes a point twice.
std::vector<Loop> missing_loops(const Surface& surface) {
  std::map<PointId, std::vector<PointId>> ways;  // from the head of an edge back to its tail
  EdgeTable(surface.triangles).for_each([&](std::span<const EdgeUse> uses) {
    long left = 0;
    for (const EdgeUse& use : uses) left += use.is_forward ? 1 : -1;
    for (; left > 0; --left) ways[uses[0].high].push_back(uses[0].low);
    for (; left < 0; ++left) ways[uses[0].low].push_back(uses[0].high);
  });
  for (auto& [from, to] : ways) std::sort(to.begin(), to.end(), std::greater<>());
  std::vector<Loop> loops;
  while (!ways.empty()) {
    Loop path{ways.begin()->first};
    // As many edges end at each point as begin there, so the way never ends but in a cycle.
    for (;;) {
      const auto at = ways.find(path.back());
      if (at == ways.end()) break;
      const PointId next = at->second.back();
      at->second.pop_back();
      if (at->second.empty()) ways.erase(at);
      const auto seen = std::find(path.begin(), path.end(), next);
      if (seen == path.end()) {
        path.push_back(next);
        continue;
      }
      loops.emplace_back(seen, path.end());
      path.erase(seen + 1, path.end());
    }
  }
  return loops;
}

Rational squared_size(const Surface& surface, const Loop& loop) {
  return bounding_box(subset(surface.points, loop)).squared_diameter();
}

// Some point of the mesh at the place of each point of the loops.
std::map<PointId, std::uint32_t> in_mesh(const Mesh& mesh, const Surface& surface,
                                         const std::vector<Loop>& loops) {
  const auto before = [](const RationalPoint& a, const RationalPoint& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  };
  std::map<RationalPoint, PointId, decltype(before)> wanted(before);
  for (const Loop& loop : loops) {
    for (const PointId p : loop) wanted.emplace(surface.points[p], p);
  }
  std::map<PointId, std::uint32_t> found;
  for (std::uint32_t p = 0; p < mesh.points.size(); ++p) {
    const auto at = wanted.find(mesh.points[PointId(p)]);
    if (at != wanted.end()) found.emplace(at->second, p);
  }
  return found;
}

// The mean of the corners, as a double each.
RationalPoint middle_of(const Surface& surface, const Loop& loop) {
  RationalPoint sum = RationalPoint::Zero();
  for (const PointId p : loop) sum += surface.points[p];
  RationalPoint middle;
  for (int k = 0; k < 3; ++k) {
    const Rational mean = sum[k] / Rational(loop.size());
    middle[k] = to_rational(to_double(mean, Rounding::Nearest));
  }
  return middle;
}

Mesh with_caps(const Mesh& mesh, const Surface& surface, const std::vector<Loop>& loops) {
  const std::map<PointId, std::uint32_t> number = in_mesh(mesh, surface, loops);
  Mesh closed{{}, mesh.polygons, {}, {}};
  std::vector<RationalPoint> middles;
  auto next = static_cast<std::uint32_t>(mesh.points.size());
  for (const Loop& loop : loops) {
    middles.push_back(middle_of(surface, loop));
    for (std::size_t k = 0; k < loop.size(); ++k) {
      closed.polygons.push_back({number.at(loop[k]), number.at(loop[(k + 1) % loop.size()]), next});
    }
    ++next;
  }
  if (mesh.points.is_binary()) {
    std::vector<Point> doubles(mesh.points.doubles().begin(), mesh.points.doubles().end());
    for (const RationalPoint& middle : middles) {
      Point& p = doubles.emplace_back();
      for (int k = 0; k < 3; ++k) p[k] = to_double(middle[k], Rounding::Nearest);
    }
    closed.points = PointSet(std::move(doubles));
  } else {
    closed.points = concatenated(mesh.points, PointSet(middles));
  }
  return closed;
}

}  // namespace

ClosedSurface make_closed_surface(const Mesh& mesh, const SurfaceOptions& options,
                                  const Watch& watch) {
  ClosedSurface made{make_surface(mesh, options, watch), {}, 0};
  if (made.surface.is_closed) return made;
  const std::vector<Loop> loops = missing_loops(made.surface);
  const Rational most = bounding_box(made.surface.points).squared_diameter() / kBorderShare;
  Rational largest = 0;
  for (const Loop& loop : loops) {
    largest = std::max<Rational>(largest, squared_size(made.surface, loop));
  }
  if (loops.empty() || largest > most) return made;
  Surface closed = make_surface(with_caps(mesh, made.surface, loops), options, watch);
  if (!closed.is_closed) return made;
  return {std::move(closed), loops.size(), std::move(largest)};
}

}  // namespace convexact
