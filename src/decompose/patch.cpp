// SPDX-License-Identifier: MIT
#include "decompose/patch.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "convexact/cluster.hpp"
#include "convexact/measure.hpp"
#include "number/arithmetic.hpp"
#include "number/groups.hpp"
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

// Points in the frame are off by 2^-54 in each coordinate, so a difference by 2^-52 when it is
// rounded, too, and its length by less than 2^-51; squares, their sum and the root add less than
// 2^-49.8. Together that is less than 2^-49: 2^-9 units.
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

// By triangle at a point: the lowest one of those that are reached from it over edges at the point.
std::vector<std::uint32_t> Patch::fans_at(std::uint32_t point) const {
  const auto triangles = triangles_at(point);
  const std::vector<Spoke> edges = spokes(point);
  const auto place = [&](std::uint32_t triangle) {
    return static_cast<std::uint32_t>(
        std::lower_bound(triangles.begin(), triangles.end(), triangle) - triangles.begin());
  };
  Groups fans(triangles.size());
  for (const Spoke& edge : edges) {
    for (const std::uint32_t triangle : edge.triangles) {
      fans.join(place(edge.triangles[0]), place(triangle));
    }
  }
  std::vector<std::uint32_t> lowest = fans.roots();
  for (std::uint32_t& fan : lowest) fan = triangles[fan];
  return lowest;
}

// Each step has at most one successor, so the loops are the cycles of a map.
void Patch::find_loops(std::vector<BorderStep> steps) {
  constexpr std::size_t kNoStep = ~std::size_t(0);
  std::map<std::uint32_t, std::vector<std::uint32_t>> fans;  // of the points at borders
  const auto fan = [&](std::uint32_t point, std::uint32_t triangle) {
    const auto [found, is_new] = fans.try_emplace(point);
    if (is_new) found->second = fans_at(point);
    const auto at = triangles_at(point);
    return found->second[static_cast<std::size_t>(std::lower_bound(at.begin(), at.end(), triangle) -
                                                  at.begin())];
  };
  std::sort(steps.begin(), steps.end(), [](const BorderStep& a, const BorderStep& b) {
    return std::tie(a.from, a.to) < std::tie(b.from, b.to);
  });
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> out_of;  // by point and fan
  for (std::size_t k = 0; k < steps.size(); ++k) {
    out_of.try_emplace({steps[k].from, fan(steps[k].from, steps[k].triangle)}, k);
  }
  const auto successor = [&](const BorderStep& step) {
    const auto next = out_of.find({step.to, fan(step.to, step.triangle)});
    return next != out_of.end() ? next->second : kNoStep;
  };
  std::vector<std::size_t> walk(steps.size(), kNoStep);  // by step: the first step of its walk
  for (std::size_t first = 0; first < steps.size(); ++first) {
    std::vector<std::size_t> path;
    std::size_t step = first;
    for (; step != kNoStep && walk[step] == kNoStep; step = successor(steps[step])) {
      walk[step] = first;
      path.push_back(step);
    }
    if (step == kNoStep || walk[step] != first) continue;
    std::vector<std::uint32_t>& loop = loops_.emplace_back();
    for (auto k = std::find(path.begin(), path.end(), step); k != path.end(); ++k) {
      loop.push_back(steps[*k].from);
    }
  }
}

}  // namespace convexact
