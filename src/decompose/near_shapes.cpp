// SPDX-License-Identifier: MIT
#include "decompose/near_shapes.hpp"

#include <algorithm>

#include "number/precision.hpp"
#include "surface/edges.hpp"
#include "surface/flat_polygon.hpp"

namespace convexact {
namespace {

std::vector<std::uint32_t> not_in_both(const std::vector<std::uint32_t>& a,
                                       const std::vector<std::uint32_t>& b) {
  std::vector<std::uint32_t> result;
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

// Bounds of weight / 20 pi in units of 2^exponent.
LengthBounds weight_bounds(const Rational& squared_weight, long exponent) {
  Enclosure weight =
      sqrt(Enclosure(Rational(scale_by_power_of_two(squared_weight, -2 * exponent)), 64));
  weight /= Enclosure(Rational(20), 64) * Enclosure::pi(64);
  return {weight.low_double(), weight.high_double()};
}

}  // namespace

NearShapes::NearShapes(const Surface& surface, const NearConcavity& near,
                       const Rational& squared_weight, bool is_float)
    : surface_(surface),
      points_(near.points()),
      off_(near.off()),
      is_float_(is_float),
      weight_(weight_bounds(squared_weight, near.exponent())),
      edges_of_(surface.triangles.size()),
      areas_(surface.triangles.size()) {
  EdgeTable(surface.triangles).for_each([&](std::span<const EdgeUse> uses) {
    const auto& [low, high] = std::pair(uses[0].low, uses[0].high);
    const double length = (points_[high.index()] - points_[low.index()]).norm();
    for (const EdgeUse& use : uses) {
      edges_of_[use.triangle].push_back(static_cast<std::uint32_t>(edges_.size()));
    }
    edges_.push_back({low, high, {length, error(8 * kUnitRoundoff * length + 4 * off_)}});
  });
  lengths_.resize(edges_.size());
}

// Numbers that are too small for doubles are lost.
double NearShapes::error(double rounding) const { return is_float_ ? 0 : rounding + 0x1p-960; }

NearSum NearShapes::doubled_area(TriangleId t) const {
  const auto& [a, b, c] = surface_.triangles[t.index()];
  const Point e = points_[b.index()] - points_[a.index()];
  const Point f = points_[c.index()] - points_[a.index()];
  const double size_e = e.cwiseAbs().maxCoeff(), size_f = f.cwiseAbs().maxCoeff();
  return {e.cross(f).norm(), error(40 * kUnitRoundoff * size_e * size_f +
                                   off_ * (10 * (size_e + size_f) + 20 * off_))};
}

NearSum NearShapes::perimeter(std::span<const std::uint32_t> boundary) const {
  NearSum sum;
  for (const std::uint32_t e : boundary) sum += edges_[e].length;
  return sum;
}

NearShape NearShapes::shape(std::span<const TriangleId> triangles) const {
  NearShape result;
  for (const TriangleId t : triangles) {
    result.doubled_area += doubled_area(t);
    result.boundary = not_in_both(result.boundary, edges_of_[t.index()]);
  }
  result.perimeter = perimeter(result.boundary);
  return result;
}

NearShape NearShapes::unite(const NearShape& a, const NearShape& b) const {
  NearShape both{not_in_both(a.boundary, b.boundary), {}, a.doubled_area};
  both.perimeter = perimeter(both.boundary);
  both.doubled_area += b.doubled_area;
  return both;
}

LengthBounds NearShapes::term(const NearShape& a, const NearShape& b) const {
  NearSum shared, perimeter = a.perimeter, area = a.doubled_area;
  auto x = a.boundary.begin(), y = b.boundary.begin();
  while (x != a.boundary.end() && y != b.boundary.end()) {
    if (*x == *y) shared += edges_[*x].length;
    const bool first = *x <= *y, second = *y <= *x;
    x += first;
    y += second;
  }
  perimeter += b.perimeter;
  perimeter += shared * -2;
  area += b.doubled_area;
  if (is_float_) {
    const double shape = area.value > 0 ? perimeter.value * perimeter.value / area.value : 0;
    return {weight_.low * shape, weight_.low * shape};
  }
  constexpr double up = 1 + 8 * kUnitRoundoff, down = 1 - 8 * kUnitRoundoff;
  return {weight_.low * perimeter.low() * perimeter.low() / area.high() * down,
          area.low() > 0 ? weight_.high * perimeter.high() * perimeter.high() / area.low() * up
                         : kNoBound};
}

void NearShapes::set_exact(MergeCost& cost, const NearShape& a, const NearShape& b,
                           std::span<const TriangleId> triangles) {
  std::vector<RootTerm> areas, lengths;
  for (const TriangleId t : triangles) {
    std::optional<RootTerm>& area = areas_[t.index()];
    if (!area) {
      area = root_of(area_vector(surface_.points, surface_.triangles[t.index()]).squaredNorm());
    }
    if (area->radicand != 0) areas.push_back(*area);
  }
  for (const std::uint32_t e : not_in_both(a.boundary, b.boundary)) {
    std::optional<RootTerm>& length = lengths_[e];
    if (!length) {
      const PointSet& points = surface_.points;
      length = root_of((points[edges_[e].high] - points[edges_[e].low]).squaredNorm());
    }
    lengths.push_back(*length);
  }
  cost.doubled_area = RootSum(std::move(areas));
  cost.perimeter = RootSum(std::move(lengths));
}

}  // namespace convexact
