// SPDX-License-Identifier: MIT
#include <algorithm>
#include <tuple>

#include "convexact/error.hpp"
#include "convexact/geometry.hpp"

namespace convexact {
namespace {

// A side of a facet, by its lower and its higher vertex.
struct Side {
  std::uint32_t low, high;
  bool falling;  // the facet runs from high to low
  std::uint32_t facet;
};

std::vector<Side> sides(const Polytope& polytope) {
  std::vector<Side> list;
  for (std::uint32_t f = 0; f < polytope.facets.size(); ++f) {
    const std::vector<std::uint32_t>& corners = polytope.facets[f];
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::uint32_t a = corners[i], b = corners[(i + 1) % corners.size()];
      list.push_back({std::min(a, b), std::max(a, b), a > b, f});
    }
  }
  return list;
}

}  // namespace

std::vector<Edge> edges(const Polytope& polytope) {
  std::vector<Side> list = sides(polytope);
  std::sort(list.begin(), list.end(), [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.falling) < std::tie(b.low, b.high, b.falling);
  });
  // On a closed surface the sides come in pairs: rising (edge on its left), then falling.
  std::vector<Edge> result;
  for (std::size_t i = 0; i < list.size(); i += 2) {
    const Side& rising = list[i];
    const bool paired = i + 1 < list.size() && list[i + 1].low == rising.low &&
                        list[i + 1].high == rising.high && !rising.falling && list[i + 1].falling;
    if (!paired || rising.low == rising.high) {
      throw Error(ErrorCode::InvalidArgument,
                  "the facets of a polytope do not form a closed surface");
    }
    result.push_back({rising.low, rising.high, rising.facet, list[i + 1].facet});
  }
  return result;
}

}  // namespace convexact
