// SPDX-License-Identifier: MIT
// check_bounded.hpp - whether the result of a fast engine is a bounded solid.
#pragma once
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "exact_determinant.hpp"
#include "fast/filtered_engine.hpp"

/// By the definition: the dual is closed and every triangle of it has the right orientation as seen
/// from the center, so the center is inside the dual hull. D is independent of the center.
inline void check_bounded(const convexact::FastDual& dual, const convexact::FastResult& result) {
  using namespace convexact;
  REQUIRE(result.survivors.size() + result.steps.size() == dual.size());
  REQUIRE(result.triangles.size() == 2 * result.survivors.size() - 4);
  std::vector<std::array<std::uint32_t, 2>> edges;
  for (const DualTriangle& t : result.triangles) {
    std::vector<std::vector<Rational>> rows;
    for (int c = 0; c < 3; ++c) {
      const Halfspace& h = dual.exact(t[c]);
      rows.push_back({Rational(h.normal()[0]), Rational(h.normal()[1]), Rational(h.normal()[2])});
      CHECK(std::binary_search(result.survivors.begin(), result.survivors.end(), t[c]));
      edges.push_back({t[c].value, t[(c + 1) % 3].value});
    }
    CHECK(exact_determinant(rows) > 0);
  }
  std::sort(edges.begin(), edges.end());
  CHECK(std::adjacent_find(edges.begin(), edges.end()) == edges.end());
  for (const auto& [a, b] : edges) {
    CHECK(std::binary_search(edges.begin(), edges.end(), std::array<std::uint32_t, 2>{b, a}));
  }
}
