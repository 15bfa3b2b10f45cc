// SPDX-License-Identifier: MIT
#include <cmath>
#include <optional>

#include "hull/hull_steps.hpp"

namespace convexact {
namespace {

// The point with the largest |measure|; if it does not pass the exact test, the first that does.
// nullopt if none passes.
template <class Measure, class Test>
std::optional<PointId> best_point(std::size_t size, Measure measure, Test passes) {
  if (size == 0) return std::nullopt;
  PointId best;
  double largest = -1;
  for (std::size_t i = 0; i < size; ++i) {
    const double value = std::abs(measure(i));
    if (value <= largest) continue;
    largest = value;
    best = PointId(i);
  }
  if (passes(best)) return best;
  for (std::size_t i = 0; i < size; ++i) {
    if (passes(PointId(i))) return PointId(i);
  }
  return std::nullopt;
}

}  // namespace

template <ExactPoints Points>
std::vector<PointId> find_simplex(const Points& points) {
  const auto near = points.near();
  const std::size_t size = points.size();
  const auto difference = [&](std::size_t i, PointId p) {
    const NearPoint &a = near[i], &b = near[p.index()];
    return NearPoint{a.x - b.x, a.y - b.y, a.z - b.z};
  };
  std::vector<PointId> s;
  // A corner far out: except in odd cases, the largest coordinate sum finds a corner of the box.
  const auto first = best_point(
      size, [&](std::size_t i) { return near[i].x + near[i].y + near[i].z; },
      [](PointId) { return true; });
  if (!first) return s;
  s.push_back(*first);
  const auto second = best_point(
      size,
      [&](std::size_t i) {
        const NearPoint d = difference(i, s[0]);
        return dot(d, d);
      },
      [&](PointId p) { return !points.equal(p, s[0]); });
  if (!second) return s;
  s.push_back(*second);
  const NearPoint axis = difference(s[1].index(), s[0]);
  const auto third = best_point(
      size,
      [&](std::size_t i) {
        const NearPoint area = cross(axis, difference(i, s[0]));
        return dot(area, area);
      },
      [&](PointId p) { return !are_collinear(points, s[0], s[1], p); });
  if (!third) return s;
  s.push_back(*third);
  const NearPoint normal = cross(axis, difference(s[2].index(), s[0]));
  const auto fourth = best_point(
      size, [&](std::size_t i) { return dot(normal, difference(i, s[0])); },
      [&](PointId p) { return points.side(s[0], s[1], s[2], p) != Sign::Zero; });
  if (!fourth) return s;
  s.push_back(*fourth);
  if (points.side(s[0], s[1], s[2], s[3]) == Sign::Positive) std::swap(s[0], s[1]);
  return s;
}

template std::vector<PointId> find_simplex(const DoublePoints&);
template std::vector<PointId> find_simplex(const HomogeneousPoints&);

}  // namespace convexact
