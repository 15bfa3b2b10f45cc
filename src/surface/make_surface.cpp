// SPDX-License-Identifier: MIT
// make_surface(): from a mesh's faces to triangles on distinct points, joined and turned.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "convexact/error.hpp"
#include "number/arithmetic.hpp"
#include "number/groups.hpp"
#include "surface/edges.hpp"
#include "surface/flat_polygon.hpp"
#include "surface/orientation.hpp"

namespace convexact {
namespace {

// ---- Points

struct Welded {
  PointSet points, unused;
  std::vector<PointId> id;  // by point of the mesh; arbitrary for points that no face uses
  std::size_t repeated = 0;
};

template <class P, class At>
Welded weld(std::size_t count, const std::vector<bool>& is_used, const At& at) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return precedes(at(a), at(b)); });
  Welded welded;
  welded.id.resize(count);
  std::vector<P> kept, unused;
  for (std::size_t first = 0; first < count;) {
    std::size_t last = first + 1;
    while (last < count && !precedes(at(order[first]), at(order[last]))) ++last;
    const bool used = std::any_of(order.begin() + long(first), order.begin() + long(last),
                                  [&](std::uint32_t p) { return is_used[p]; });
    for (std::size_t k = first; k < last; ++k) welded.id[order[k]] = PointId(kept.size());
    (used ? kept : unused).push_back(at(order[first]));
    welded.repeated += last - first - 1;
    first = last;
  }
  welded.points = PointSet(std::move(kept));
  welded.unused = PointSet(std::move(unused));
  return welded;
}

Welded weld(const Mesh& mesh) {
  std::vector<bool> is_used(mesh.points.size(), false);
  for (const auto& polygon : mesh.polygons) {
    if (polygon.empty()) throw Error(ErrorCode::InvalidArgument, "a face without corners");
    for (const std::uint32_t corner : polygon) {
      if (corner >= is_used.size()) {
        throw Error(ErrorCode::InvalidArgument, "a face with a corner that is no point");
      }
      is_used[corner] = true;
    }
  }
  if (mesh.points.is_binary()) {
    // A signed zero becomes plain zero.
    const auto at = [&](std::uint32_t p) { return Point(mesh.points.doubles()[p].array() + 0.0); };
    return weld<Point>(mesh.points.size(), is_used, at);
  }
  std::vector<RationalPoint> points;
  for (std::size_t p = 0; p < mesh.points.size(); ++p) points.push_back(mesh.points[PointId(p)]);
  return weld<RationalPoint>(points.size(), is_used,
                             [&](std::uint32_t p) -> const RationalPoint& { return points[p]; });
}

// ---- Triangles

// The same cycle from the place where it comes first in lexicographic order.
void rotate_to_least(std::vector<PointId>& corners) {
  std::vector<PointId> best = corners, turned = corners;
  for (std::size_t k = 1; k < corners.size(); ++k) {
    std::rotate(turned.begin(), turned.begin() + 1, turned.end());
    best = std::min(best, turned);
  }
  corners = best;
}

// Equal corners in a row become one.
std::vector<PointId> cycle_of(const std::vector<std::uint32_t>& polygon, const Welded& welded) {
  std::vector<PointId> corners;
  for (const std::uint32_t p : polygon) {
    if (corners.empty() || corners.back() != welded.id[p]) corners.push_back(welded.id[p]);
  }
  while (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
  rotate_to_least(corners);
  while (corners.size() < 3) corners.push_back(corners.back());
  return corners;
}

void cut_faces(const Mesh& mesh, const Welded& welded, const Watch& watch, Surface& surface) {
  for (std::size_t f = 0; f < mesh.polygons.size(); ++f) {
    watch.ask();
    const std::vector<PointId> corners = cycle_of(mesh.polygons[f], welded);
    std::vector<Triangle> triangles{{corners[0], corners[1], corners[2]}};
    if (corners.size() > 3) {
      auto clipped = clip_ears(surface.points, corners);
      if (auto* ears = std::get_if<std::vector<Triangle>>(&clipped)) {
        triangles = std::move(*ears);
      } else {
        surface.fans.push_back(f);
        surface.bent_faces += std::get<NotCut>(clipped) == NotCut::Bent ? 1 : 0;
        for (std::size_t k = 3; k < corners.size(); ++k) {
          triangles.push_back({corners[0], corners[k - 1], corners[k]});
        }
      }
    }
    for (const Triangle& triangle : triangles) {
      surface.triangles.push_back(triangle);
      surface.face.push_back(static_cast<std::uint32_t>(f));
    }
  }
}

Triangle sorted(Triangle t) {
  std::sort(t.begin(), t.end());
  return t;
}

Triangle reversed(const Triangle& t) { return {t[0], t[2], t[1]}; }

// Rotates each triangle to its lowest corner, and sorts all.
void to_canonical_order(Surface& surface) {
  for (Triangle& t : surface.triangles) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    // Of two equal lowest corners, the one before the third.
    if (t[0] == t[2]) std::rotate(t.begin(), t.begin() + 2, t.end());
  }
  std::vector<std::size_t> order(surface.triangles.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](std::size_t k) {
    return std::tuple(sorted(surface.triangles[k]), surface.triangles[k], surface.face[k]);
  };
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  const Surface before = surface;
  for (std::size_t k = 0; k < order.size(); ++k) {
    surface.triangles[k] = before.triangles[order[k]];
    surface.face[k] = before.face[order[k]];
    if (!before.component.empty()) surface.component[k] = before.component[order[k]];
  }
}

// ---- Components

void find_components(const EdgeTable& edges, Surface& surface) {
  Groups groups(surface.triangles.size());
  edges.for_each([&](std::span<const EdgeUse> uses) {
    for (const EdgeUse& use : uses) groups.join(uses[0].triangle, use.triangle);
  });
  const std::vector<std::uint32_t> root = groups.roots();
  constexpr std::uint32_t kNone = ~std::uint32_t{0};
  std::vector<std::uint32_t> number(root.size(), kNone);
  surface.component.resize(root.size());
  for (std::uint32_t t = 0; t < root.size(); ++t) {
    std::uint32_t& component = number[root[t]];
    if (component == kNone) {
      component = static_cast<std::uint32_t>(surface.components.size());
      surface.components.push_back({.is_flat = true});
    }
    surface.component[t] = component;
    ++surface.components[component].triangles;
  }
}

void turn(const Orientation& orientation, Surface& surface) {
  for (std::uint32_t t = 0; t < orientation.turns.size(); ++t) {
    if (!orientation.turns[t]) continue;
    surface.triangles[t] = reversed(surface.triangles[t]);
    ++surface.components[surface.component[t]].turned;
  }
  surface.ambiguous_edges = orientation.ambiguous_edges;
}

void count_edges(Surface& surface) {
  for (SurfaceComponent& component : surface.components) component.is_closed = true;
  EdgeTable(surface.triangles).for_each([&](std::span<const EdgeUse> uses) {
    SurfaceComponent& component = surface.components[surface.component[uses[0].triangle]];
    const auto forward =
        std::count_if(uses.begin(), uses.end(), [](const EdgeUse& use) { return use.is_forward; });
    const bool cancels = 2 * static_cast<std::size_t>(forward) == uses.size();
    component.border_edges += uses.size() == 1 ? 1 : 0;
    component.branching_edges += uses.size() > 2 ? 1 : 0;
    component.is_closed = component.is_closed && cancels;
    surface.contradictions += uses.size() == 2 && !cancels ? 1 : 0;
  });
  surface.is_closed = std::all_of(surface.components.begin(), surface.components.end(),
                                  [](const SurfaceComponent& c) { return c.is_closed; });
}

void find_flat(Surface& surface) {
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const bool is_flat = has_no_area(surface.points, surface.triangles[t]);
    surface.flat_triangles += is_flat ? 1 : 0;
    if (!is_flat) surface.components[surface.component[t]].is_flat = false;
  }
}

void count_repeated(Surface& surface) {
  for (std::size_t t = 1; t < surface.triangles.size(); ++t) {
    surface.repeated_triangles +=
        sorted(surface.triangles[t]) == sorted(surface.triangles[t - 1]) ? 1 : 0;
  }
}

// Components keep the order of their lowest triangles.
void number_components(Surface& surface) {
  constexpr std::uint32_t kNone = ~std::uint32_t{0};
  std::vector<std::uint32_t> number(surface.components.size(), kNone);
  std::vector<SurfaceComponent> components;
  for (std::uint32_t& component : surface.component) {
    if (number[component] == kNone) {
      number[component] = static_cast<std::uint32_t>(components.size());
      components.push_back(surface.components[component]);
    }
    component = number[component];
  }
  surface.components = std::move(components);
}

}  // namespace

Surface make_surface(const Mesh& mesh, const SurfaceOptions& options, const Watch& watch) {
  if (mesh.polygons.empty()) {
    throw Error(ErrorCode::InvalidArgument, "a surface needs faces, and the mesh has none");
  }
  Welded welded = weld(mesh);
  Surface surface;
  surface.points = std::move(welded.points);
  surface.repeated_points = welded.repeated;
  surface.unused = std::move(welded.unused);
  cut_faces(mesh, welded, watch, surface);
  to_canonical_order(surface);
  find_components(EdgeTable(surface.triangles), surface);
  find_flat(surface);
  const Orientation orientation = find_orientation(surface, watch);
  for (std::size_t k = 0; k < surface.components.size(); ++k) {
    surface.components[k].is_orientable = !orientation.has_one_side[k];
  }
  if (options.orient == Orient::Auto) turn(orientation, surface);
  count_edges(surface);
  for (SurfaceComponent& component : surface.components) {
    component.is_reversed = component.is_closed && component.turned == component.triangles;
  }
  to_canonical_order(surface);
  count_repeated(surface);
  number_components(surface);
  return surface;
}

std::size_t count_near_corners(const Surface& surface) {
  const auto open = std::count_if(surface.components.begin(), surface.components.end(),
                                  [](const SurfaceComponent& c) { return !c.is_closed; });
  if (open < 2 || 2 * static_cast<std::size_t>(open) <= surface.components.size()) return 0;
  constexpr double kNear = 1e-6;  // of the diameter; a hint needs no more than doubles
  const auto points = surface.points.doubles();
  const Rational squared = bounding_box(surface.points).squared_diameter();
  const double reach = kNear * std::sqrt(to_double(squared, Rounding::Nearest));
  std::vector<bool> is_near(points.size(), false);
  // Points are in the order of their first coordinates.
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t k = i + 1; k < points.size() && points[k][0] - points[i][0] <= reach; ++k) {
      if ((points[k] - points[i]).norm() <= reach) is_near[i] = is_near[k] = true;
    }
  }
  return static_cast<std::size_t>(std::count(is_near.begin(), is_near.end(), true));
}

}  // namespace convexact
