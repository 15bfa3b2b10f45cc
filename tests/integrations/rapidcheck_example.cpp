// SPDX-License-Identifier: MIT
// rapidcheck searches for points that enclose(), the program under test, does not enclose.
#include <convexact.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <vector>

using Numbers = std::vector<double>;

// The program under test: the six planes of the box around n points.
Numbers enclose(const Numbers& points) {
  std::array<double, 3> low, high;
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < points.size(); ++i) {
    low[i % 3] = std::min(low[i % 3], points[i]);
    high[i % 3] = std::max(high[i % 3], points[i]);
  }
  return {1, 0,  0, -high[0], -1, 0, 0, low[0],   0, 1, 0,  -high[1],
          0, -1, 0, low[1],   0,  0, 1, -high[2], 0, 0, -1, low[2]};
}

int main() {
  const bool holds = rc::check("every point is inside", [] {
    const auto count = *rc::gen::inRange<std::size_t>(1, 30);
    const auto grid = *rc::gen::container<std::vector<int>>(3 * count, rc::gen::inRange(-999, 999));
    Numbers points;
    for (const int x : grid) points.push_back(x / 7.0);
    const Numbers planes = enclose(points);

    convexact_containment* verdict = nullptr;
    RC_ASSERT(convexact_verify_planes(points.data(), count, planes.data(), planes.size() / 4,
                                      &verdict) == CONVEXACT_OK);
    const std::unique_ptr<convexact_containment, decltype(&convexact_containment_free)> owner(
        verdict, convexact_containment_free);
    RC_LOG() << convexact_containment_squared_distance(verdict) << " beyond plane "
             << convexact_containment_plane(verdict);
    RC_ASSERT(convexact_containment_holds(verdict));
  });
  return holds ? 0 : 1;
}
