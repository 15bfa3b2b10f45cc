// SPDX-License-Identifier: MIT
#include "decompose/patch.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "convexact/cluster.hpp"
#include "convexact/measure.hpp"
#include "number/arithmetic.hpp"
#include "surface/edges.hpp"

namespace convexact {
namespace {

constexpr int kLengthBits = 40;

// The least integer whose square is at least x >= 0.
std::uint64_t root_up(const Rational& x) {
  Integer whole, root, rest;
  mpz_cdiv_q(raw(whole), mpq_numref(x.backend().data()), mpq_denref(x.backend().data()));
  mpz_sqrtrem(raw(root), raw(rest), raw(whole));
  return static_cast<std::uint64_t>(root) + (rest > 0 ? 1 : 0);
}

}  // namespace

NearSurface::NearSurface(const Surface& surface)
    : frame(frame_around(std::array{bounding_box(surface.points)})) {
  for (std::size_t p = 0; p < surface.points.size(); ++p) {
    points.push_back(frame(surface.points[PointId(p)]));
  }
}

// Points in the frame are off by 2^-54 in each coordinate, so the length of a difference by 2^-52,
// and a root and a few products add less than 2^-50: 2^-10 units.
double EdgeLengths::unrounded(const Point& a, const Point& b) {
  return std::ldexp((a - b).norm(), kLengthBits);
}

std::uint64_t EdgeLengths::operator()(PointId a, PointId b) const {
  constexpr double kError = 0x1p-9;
  const double length = unrounded(near_.points[a.index()], near_.points[b.index()]);
  const double up = std::ceil(length);
  if (length > 1 && up - length > kError && length - (up - 1) > kError) {
    return static_cast<std::uint64_t>(up);
  }
  const RationalVector3 along = points_[a] - points_[b];
  return root_up(
      scale_by_power_of_two(along.squaredNorm(), 2 * (kLengthBits - near_.frame.exponent)));
}

Patch::Patch(const Surface& surface, std::span<const TriangleId> triangles,
             const EdgeLengths& lengths)
    : triangles_(triangles.begin(), triangles.end()), points_(points_of(surface, triangles)) {
  std::vector<Triangle> local;  // in numbers of points
  for (const TriangleId t : triangles_) {
    const auto& [a, b, c] = surface.triangles[t.index()];
    corners_.push_back({number_of(a), number_of(b), number_of(c)});
    const auto& [x, y, z] = corners_.back();
    local.push_back({PointId(x), PointId(y), PointId(z)});
  }
  std::vector<std::vector<Way>> ways(points_.size());
  std::vector<std::vector<std::uint32_t>> fans(points_.size());
  std::vector<BorderStep> border;
  EdgeTable(local).for_each([&](std::span<const EdgeUse> uses) {
    const std::uint32_t low = uses[0].low.value, high = uses[0].high.value;
    const std::uint64_t length = lengths(points_[low], points_[high]);
    ways[low].push_back({high, length});
    ways[high].push_back({low, length});
    for (const EdgeUse& use : uses) {
      fans[low].push_back(use.triangle);
      fans[high].push_back(use.triangle);
    }
    if (uses.size() > 1) return;
    border.push_back(uses[0].is_forward ? BorderStep{low, high, uses[0].triangle}
                                        : BorderStep{high, low, uses[0].triangle});
  });
  for (std::size_t p = 0; p < points_.size(); ++p) {
    std::sort(ways[p].begin(), ways[p].end(),
              [](const Way& a, const Way& b) { return a.to < b.to; });
    std::sort(fans[p].begin(), fans[p].end());
    fans[p].erase(std::unique(fans[p].begin(), fans[p].end()), fans[p].end());
    first_way_.push_back(ways_.size());
    ways_.insert(ways_.end(), ways[p].begin(), ways[p].end());
    first_fan_.push_back(fans_.size());
    fans_.insert(fans_.end(), fans[p].begin(), fans[p].end());
  }
  first_way_.push_back(ways_.size());
  first_fan_.push_back(fans_.size());
  find_loops(std::move(border));
}

std::uint32_t Patch::number_of(PointId point) const {
  return static_cast<std::uint32_t>(std::lower_bound(points_.begin(), points_.end(), point) -
                                    points_.begin());
}

bool Patch::is_edge(std::uint32_t a, std::uint32_t b) const {
  const auto found = ways(a);
  return std::binary_search(found.begin(), found.end(), Way{b, 0},
                            [](const Way& x, const Way& y) { return x.to < y.to; });
}

std::vector<Patch::Spoke> Patch::spokes(std::uint32_t point) const {
  std::vector<Spoke> found;
  for (const Way& way : ways(point)) found.push_back({way.to, {}});
  for (const std::uint32_t t : triangles_at(point)) {
    for (const std::uint32_t p : corners_[t]) {
      if (p == point) continue;
      const auto spoke =
          std::lower_bound(found.begin(), found.end(), p,
                           [](const Spoke& s, std::uint32_t to) { return s.to < to; });
      spoke->triangles.push_back(t);
    }
  }
  return found;
}

// ---- Borders

// The triangles at a point that are reached from one of them over edges at the point.
std::vector<std::uint32_t> Patch::fan_at(std::uint32_t point, std::uint32_t triangle) const {
  std::vector<std::uint32_t> fan{triangle};
  for (std::size_t k = 0; k < fan.size(); ++k) {
    for (const std::uint32_t other : triangles_at(point)) {
      if (std::find(fan.begin(), fan.end(), other) != fan.end()) continue;
      const auto& mine = corners_[fan[k]];
      const bool shares = std::any_of(mine.begin(), mine.end(), [&](std::uint32_t p) {
        return p != point && std::count(corners_[other].begin(), corners_[other].end(), p) > 0;
      });
      if (shares) fan.push_back(other);
    }
  }
  return fan;
}

// Each step has one successor or none, so the loops are the cycles of a map.
void Patch::find_loops(std::vector<BorderStep> steps) {
  constexpr std::size_t kNone = ~std::size_t(0);
  std::sort(steps.begin(), steps.end(), [](const BorderStep& a, const BorderStep& b) {
    return std::tie(a.from, a.to) < std::tie(b.from, b.to);
  });
  const auto successor = [&](const BorderStep& step) {
    const auto fan = fan_at(step.to, step.triangle);
    const auto first =
        std::lower_bound(steps.begin(), steps.end(), step.to,
                         [](const BorderStep& s, std::uint32_t from) { return s.from < from; });
    for (auto next = first; next != steps.end() && next->from == step.to; ++next) {
      if (std::find(fan.begin(), fan.end(), next->triangle) != fan.end()) {
        return static_cast<std::size_t>(next - steps.begin());
      }
    }
    return kNone;
  };
  std::vector<std::size_t> walk(steps.size(), kNone);  // by step: the first step of its walk
  for (std::size_t first = 0; first < steps.size(); ++first) {
    std::vector<std::size_t> path;
    std::size_t step = first;
    for (; step != kNone && walk[step] == kNone; step = successor(steps[step])) {
      walk[step] = first;
      path.push_back(step);
    }
    if (step == kNone || walk[step] != first) continue;
    std::vector<std::uint32_t>& loop = loops_.emplace_back();
    for (auto k = std::find(path.begin(), path.end(), step); k != path.end(); ++k) {
      loop.push_back(steps[*k].from);
    }
  }
}

}  // namespace convexact
