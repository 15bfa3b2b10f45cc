// SPDX-License-Identifier: MIT
#include "decompose/merge_cost.hpp"

#include <algorithm>

#include "surface/edges.hpp"
#include "surface/flat_polygon.hpp"

namespace convexact {
namespace {

bool same_terms(const RootSum& a, const RootSum& b) {
  return std::equal(a.terms().begin(), a.terms().end(), b.terms().begin(), b.terms().end(),
                    [](const RootTerm& x, const RootTerm& y) {
                      return x.factor == y.factor && x.radicand == y.radicand;
                    });
}

bool are_equal(const RootSum& a, const RootSum& b, const Watch& watch) {
  return same_terms(a, b) || (a - b).normalized(watch).terms().empty();
}

RootSum product(const RootSum& a, const RootSum& b) {
  std::vector<RootTerm> terms;
  for (const RootTerm& x : a.terms()) {
    for (const RootTerm& y : b.terms()) {
      terms.push_back({x.factor * y.factor, x.radicand * y.radicand});
    }
  }
  return RootSum(std::move(terms));
}

// Whether perimeter^2 / area are the same: of similar shapes, for instance. The products are
// multiplied out, which is feasible for small clusters only.
bool have_equal_shapes(const MergeCost& a, const MergeCost& b, const Watch& watch) {
  constexpr std::size_t kMostTerms = 8;  // at most 512 products of three roots on each side
  for (const RootSum* sum : {&a.perimeter, &b.perimeter, &a.doubled_area, &b.doubled_area}) {
    if (sum->terms().size() > kMostTerms) return false;
  }
  return are_equal(product(product(a.perimeter, a.perimeter), b.doubled_area),
                   product(product(b.perimeter, b.perimeter), a.doubled_area), watch);
}

}  // namespace

RootTerm root_of(const Rational& square) {
  const Integer below = denominator(square);
  return {Rational(1) / Rational(below), numerator(square) * below};
}

MergeCost merge_cost(const Surface& surface, std::span<const TriangleId> triangles,
                     const ExactConcavity& concavity, const Watch& watch) {
  MergeCost cost;
  std::vector<std::array<PointId, 3>> corners;
  std::vector<RootTerm> areas, lengths;
  const auto add = [](std::vector<RootTerm>& terms, const Rational& square) {
    if (square != 0) terms.push_back(root_of(square));
  };
  for (const TriangleId t : triangles) {
    corners.push_back(surface.triangles[t.index()]);
    add(areas, area_vector(surface.points, corners.back()).squaredNorm());
  }
  EdgeTable(corners).for_each([&](std::span<const EdgeUse> uses) {
    if (uses.size() % 2 == 0) return;
    const RationalVector3 along = surface.points[uses[0].high] - surface.points[uses[0].low];
    add(lengths, along.squaredNorm());
  });
  cost.doubled_area = RootSum(std::move(areas));
  cost.perimeter = RootSum(std::move(lengths));
  const ConvexPart hull = convex_part(subset(surface.points, points_of(surface, triangles)));
  cost.squared_concavity = concavity(triangles, hull, watch).squared;
  return cost;
}

Enclosure CostOrder::enclose(const MergeCost& cost, long precision, const Watch& watch) const {
  Enclosure sum = sqrt(Enclosure(cost.squared_concavity, precision));
  if (cost.doubled_area.terms().empty()) return sum;
  const Enclosure perimeter = cost.perimeter.enclose(precision, watch);
  Enclosure shape = perimeter * perimeter;
  shape /= Enclosure(Rational(20), precision) * Enclosure::pi(precision) *
           cost.doubled_area.enclose(precision, watch);
  return sum += sqrt(Enclosure(squared_weight_, precision)) * shape;
}

bool CostOrder::have_same_terms(const MergeCost& a, const MergeCost& b) {
  return a.squared_concavity == b.squared_concavity && same_terms(a.perimeter, b.perimeter) &&
         same_terms(a.doubled_area, b.doubled_area);
}

Ordering CostOrder::compare(const MergeCost& a, const MergeCost& b, const Watch& watch) const {
  if (have_same_terms(a, b)) return {Order::Equal, TieProof::SquareClasses, 0};
  for (long bits = 128; bits <= kMostBits; bits *= 2) {
    const Enclosure difference = enclose(a, bits, watch) - enclose(b, bits, watch);
    if (const auto sign = difference.sign(); sign && *sign != Sign::Zero) {
      return {*sign == Sign::Negative ? Order::Less : Order::Greater, std::nullopt, bits};
    }
    if (bits == 128 && a.squared_concavity == b.squared_concavity &&
        ((are_equal(a.perimeter, b.perimeter, watch) &&
          are_equal(a.doubled_area, b.doubled_area, watch)) ||
         have_equal_shapes(a, b, watch))) {
      return {Order::Equal, TieProof::SquareClasses, bits};
    }
  }
  return {Order::Undecided, TieProof::Undecided, kMostBits};
}

}  // namespace convexact
