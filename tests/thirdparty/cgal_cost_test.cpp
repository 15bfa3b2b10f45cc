// SPDX-License-Identifier: MIT
// Costs by area and sums of roots against CGAL's exact numbers with square roots, third-party truth
// that decides signs by separation bounds instead of square classes. A cost is the difference of
// two areas, each from the corners of polygons.
#include <CGAL/Exact_predicates_exact_constructions_kernel_with_sqrt.h>
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "convexact/cost.hpp"
#include "convexact/dual.hpp"
#include "number/text.hpp"
#include "simplify/dual_surface.hpp"
using namespace convexact;

namespace {

using KernelWithRoots = CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt;
using Root = KernelWithRoots::FT;

Root to_root(const Integer& x) {
  // Digit by digit, as the two programs share no number type.
  Root value = 0;
  for (const char c : to_string(Integer(abs(x)))) value = value * Root(10) + Root(c - '0');
  return x < 0 ? Root(-value) : value;
}

Root to_root(const Rational& x) {
  return to_root(Integer(numerator(x))) / to_root(Integer(denominator(x)));
}

Root to_root(const RootSum& sum) {
  Root value = 0;
  for (const RootTerm& term : sum.terms()) {
    value = value + to_root(term.factor) * CGAL::sqrt(to_root(term.radicand));
  }
  return value;
}

// Each facet is a fan of triangles around its first corner. Areas of facets along two axes need no
// root: every root doubles the length of the numbers with which CGAL proves that a sum is zero.
Root area_of(const Polytope& polytope) {
  Root sum = 0;
  for (const auto& facet : polytope.facets) {
    const auto point = [&](std::size_t i) {
      const RationalPoint& p = polytope.vertices[facet[i]];
      return KernelWithRoots::Point_3(to_root(p[0]), to_root(p[1]), to_root(p[2]));
    };
    KernelWithRoots::Vector_3 normal(CGAL::NULL_VECTOR);
    for (std::size_t i = 2; i < facet.size(); ++i) {
      normal = normal + CGAL::cross_product(point(i - 1) - point(0), point(i) - point(0));
    }
    const auto zeros = (normal.x() == 0) + (normal.y() == 0) + (normal.z() == 0);
    sum = sum + (zeros == 2 ? CGAL::abs(normal.x() + normal.y() + normal.z())
                            : Root(CGAL::sqrt(normal.squared_length())));
  }
  return sum / Root(2);
}

int sign_of(Order order) {
  REQUIRE(order != Order::Undecided);
  return order == Order::Less ? -1 : order == Order::Greater ? 1 : 0;
}

Halfspace row(int x, int y, int z, int d) { return {IntegerVector3(x, y, z), Integer(d)}; }

Root area_inside(const std::vector<Halfspace>& halfspaces, const RationalPoint& center) {
  const DualHull dual = dual_of(halfspaces, center).dual;
  return area_of(to_polytope(dual.halfspaces, dual.triangles));
}

// A box from 0 to 20 without some of its corners, strictly around (10, 10, 10).
struct CutBox {
  explicit CutBox(std::vector<Halfspace> planes) : cuts(std::move(planes)) {
    for (int k = 0; k < 3; ++k) {
      all.push_back(row(-(k == 0), -(k == 1), -(k == 2), 0));
      all.push_back(row(k == 0, k == 1, k == 2, -20));
    }
    all.insert(all.end(), cuts.begin(), cuts.end());
    dual = dual_of(all, center).dual;
  }

  RootSum our_cost(const Halfspace& cut) const {
    DualSurface surface(dual.halfspaces, dual.triangles, center, 1, CostMeasure::Area);
    for (std::uint32_t i = 0; i < dual.halfspaces.size(); ++i) {
      if (dual.halfspaces[i] == cut) return surface.removal_of(HalfspaceId(i)).cost->area();
    }
    FAIL("the cut is no facet");
    return {};
  }

  Root cost_of_cgal(const Halfspace& cut) const {
    std::vector<Halfspace> left = all;
    left.erase(std::find(left.begin(), left.end(), cut));
    return area_inside(left, center) - area_inside(all, center);
  }

  const RationalPoint center{10, 10, 10};
  std::vector<Halfspace> cuts, all;
  DualHull dual;
};

}  // namespace

TEST_CASE("root_sum: the order of random sums is CGAL's") {
  std::mt19937_64 random(2604);
  const auto draw = [&](int n) { return int(random() % std::uint64_t(n)); };
  int ties = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const auto sum = [&] {
      RootSum s;
      for (int k = 0; k < 3; ++k) {
        const int class_of[] = {1, 2, 3}, square = 1 + draw(2);
        s.add(draw(5) - 2, class_of[draw(3)] * square * square);
      }
      return s;
    };
    const RootSum a = sum();
    RootSum b = sum();
    if (trial % 4 == 0) {  // the same number, written in another way
      b = RootSum();
      for (const auto& [factor, radicand] : a.terms()) b.add(factor / 3, radicand * 9);
    }
    const int theirs = CGAL::sign(to_root(a) - to_root(b));
    CHECK(sign_of(compare(a, b).order) == theirs);
    ties += theirs == 0;
  }
  CHECK(ties >= 250);
}

// Neighbours among sums of three roots of integers up to 60.
TEST_CASE("root_sum: the order of the nearest sums is CGAL's") {
  std::vector<std::pair<double, std::array<int, 3> > > sums;
  for (int i = 1; i <= 60; ++i) {
    for (int j = 1; j <= i; ++j) {
      for (int k = 1; k <= j; ++k) {
        sums.push_back({std::sqrt(i) + std::sqrt(j) + std::sqrt(k), {i, j, k}});
      }
    }
  }
  std::sort(sums.begin(), sums.end());
  const auto exact = [](const std::array<int, 3>& radicands) {
    RootSum s;
    for (const int n : radicands) s.add(1, n);
    return s;
  };
  std::size_t compared = 0;
  for (std::size_t n = 1; n < sums.size(); ++n) {
    if (sums[n].first - sums[n - 1].first > 1e-8) continue;
    ++compared;
    const RootSum a = exact(sums[n - 1].second), b = exact(sums[n].second);
    CHECK(sign_of(compare(a, b).order) == CGAL::sign(to_root(a) - to_root(b)));
  }
  CHECK(compared > 100);
}

TEST_CASE("costs by area: cut corners of a box cost what CGAL says, and tie where it says so") {
  // The first two tie by accident: their caps are not congruent, and both cost (15 - sqrt 99) / 2.
  const CutBox box({row(1, 3, 1, -97), row(-7, -7, -1, 7), row(2, -1, 3, -92), row(-1, 2, 3, -97)});
  std::vector<RootSum> ours;
  std::vector<Root> theirs;
  for (const Halfspace& cut : box.cuts) {
    ours.push_back(box.our_cost(cut));
    theirs.push_back(box.cost_of_cgal(cut));
    CHECK(to_root(ours.back()) == theirs.back());
  }
  CHECK(theirs[0] == (Root(15) - CGAL::sqrt(Root(99))) / Root(2));
  for (std::size_t i = 0; i < ours.size(); ++i) {
    for (std::size_t j = 0; j < ours.size(); ++j) {
      CHECK(sign_of(compare(ours[i], ours[j]).order) == CGAL::sign(theirs[i] - theirs[j]));
    }
  }
  CHECK(compare(ours[0], ours[1]).order == Order::Equal);
}
