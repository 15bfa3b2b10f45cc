// SPDX-License-Identifier: MIT
#include "surface/patches.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "convexact/geometry.hpp"
#include "number/groups.hpp"
#include "surface/box_tree.hpp"
#include "surface/common_point.hpp"
#include "surface/edges.hpp"

namespace convexact {
namespace {

// Whether a triangle has the corners of the one before: repeated triangles stand side by side.
bool repeats_last(const Surface& surface, std::uint32_t t) {
  if (t == 0) return false;
  Triangle own = surface.triangles[t], last = surface.triangles[t - 1];
  std::sort(own.begin(), own.end());
  std::sort(last.begin(), last.end());
  return own == last;
}

// Whether a box is not strictly on one side of a triangle's plane.
bool may_meet_plane(const PointSet& points, const Triangle& t, const NearBox& box) {
  if (!points.is_binary()) return true;
  const auto p = points.doubles();
  std::optional<Sign> side;
  for (unsigned corner = 0; corner < 8; ++corner) {
    Point x;
    for (unsigned k = 0; k < 3; ++k) x[k] = (corner >> k & 1u) != 0 ? box.high[k] : box.low[k];
    const Sign here = orient3d(p[t[0].index()], p[t[1].index()], p[t[2].index()], x);
    if (here == Sign::Zero || (side && *side != here)) return true;
    side = here;
  }
  return false;
}

// Triangles by the size of their boxes, up to a factor of two: each looks for those of its own size
// and for smaller ones near its plane, so that few large ones are not found by many small ones.
class Sizes {
 public:
  Sizes(const Surface& surface, const std::vector<std::uint32_t>& triangles) : surface_(surface) {
    std::map<int, std::vector<std::uint32_t>> by_size;
    for (const std::uint32_t t : triangles) {
      const NearBox box = box_of(surface.points, surface.triangles[t]);
      by_size[std::ilogb((box.high - box.low).maxCoeff())].push_back(t);
    }
    for (auto& [size, members] : by_size) {
      std::vector<NearBox> boxes;
      for (const std::uint32_t t : members) {
        boxes.push_back(box_of(surface.points, surface.triangles[t]));
      }
      levels_.push_back({std::move(members), BoxTree(std::move(boxes))});
    }
  }

  /// Calls look(t, s) for each two triangles whose boxes meet near the plane of one of them.
  template <class Look>
  void for_each_pair(const Watch& watch, const Look& look) const {
    std::vector<std::uint32_t> found;
    for (std::size_t own = 0; own < levels_.size(); ++own) {
      const auto& members = levels_[own].triangles;
      for (std::size_t i = 0; i < members.size(); ++i) {
        watch.ask();
        const Triangle& triangle = surface_.triangles[members[i]];
        const auto may_hold = [&](const NearBox& box) {
          return may_meet_plane(surface_.points, triangle, box);
        };
        for (std::size_t level = 0; level <= own; ++level) {
          levels_[level].tree.find_if(levels_[own].tree.box(i), may_hold, found);
          for (const std::uint32_t k : found) {
            if (level < own || k > i) look(members[i], levels_[level].triangles[k]);
          }
        }
      }
    }
  }

 private:
  struct Level {
    std::vector<std::uint32_t> triangles;
    BoxTree tree;
  };
  const Surface& surface_;
  std::vector<Level> levels_;  // the smallest first
};

std::vector<bool> find_crossed(const Surface& surface, const std::vector<bool>& has_area,
                               const std::vector<bool>& repeats, const Watch& watch) {
  const auto count = static_cast<std::uint32_t>(surface.triangles.size());
  std::vector<std::uint32_t> firsts;  // with an area; of equal ones the first
  for (std::uint32_t t = 0; t < count; ++t) {
    if (has_area[t] && !repeats[t]) firsts.push_back(t);
  }
  std::vector<bool> is_crossed(count, false);
  Sizes(surface, firsts).for_each_pair(watch, [&](std::uint32_t t, std::uint32_t s) {
    if (is_crossed[s] && is_crossed[t]) return;
    if (cross(surface.points, surface.triangles[t], surface.triangles[s])) {
      is_crossed[s] = is_crossed[t] = true;
    }
  });
  for (std::uint32_t t = 1; t < count; ++t) {
    if (repeats[t] && has_area[t]) is_crossed[t - 1] = is_crossed[t] = true;
  }
  return is_crossed;
}

}  // namespace

// Neighbours along an edge with two triangles that run through it in opposite directions.
Patches find_patches(const Surface& surface, const Watch& watch) {
  std::vector<bool> has_area;
  for (const Triangle& t : surface.triangles) has_area.push_back(!has_no_area(surface.points, t));
  Patches found;
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    found.repeats_last.push_back(repeats_last(surface, t));
  }
  found.is_crossed = find_crossed(surface, has_area, found.repeats_last, watch);
  const auto is_plain = [&](std::uint32_t t) { return has_area[t] && !found.is_crossed[t]; };
  Groups patches(surface.triangles.size());
  EdgeTable(surface.triangles).for_each([&](std::span<const EdgeUse> uses) {
    if (uses.size() != 2 || uses[0].is_forward == uses[1].is_forward) return;
    const std::uint32_t s = uses[0].triangle, t = uses[1].triangle;
    if (is_plain(s) && is_plain(t)) patches.join(s, t);
  });
  found.patch = patches.roots();
  return found;
}

std::vector<std::uint32_t> without_inner_triangles(const Surface& surface, const Winding& winding,
                                                   const Watch& watch) {
  const Patches patches = find_patches(surface, watch);
  std::vector<std::optional<bool>> is_inner(surface.triangles.size());  // by patch
  std::vector<std::uint32_t> ids;
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    const Triangle& triangle = surface.triangles[t];
    if (!patches.is_crossed[t] && !has_no_area(surface.points, triangle)) {
      std::optional<bool>& is_known = is_inner[patches.patch[t]];
      if (!is_known) {
        RationalPoint middle = RationalPoint::Zero();
        for (const PointId p : triangle) middle += surface.points[p] / Rational(3);
        const auto [before, behind] = winding.beside(TriangleId(t), middle);
        is_known = before != 0 && behind != 0;
      }
      if (*is_known) continue;
    }
    ids.push_back(t);
  }
  return ids;
}

}  // namespace convexact
