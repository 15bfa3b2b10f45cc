// SPDX-License-Identifier: MIT
// hard_halfspaces.hpp - small sets of halfspaces in special position, numbered.
#pragma once
#include <cstdint>
#include <vector>

#include "convexact/geometry.hpp"
#include "number/random.hpp"

namespace hard {

/// The origin strictly inside all of them; not always bounded, often redundant, sometimes repeated.
class Halfspaces {
 public:
  explicit Halfspaces(std::uint32_t i) : random_(i) {
    using namespace convexact;
    const std::uint64_t count = 8 + uniform_below(random_, 17);
    const std::uint64_t range = 1 + uniform_below(random_, 4);
    while (made_.size() < count) {
      IntegerVector3 normal;
      for (int k = 0; k < 3; ++k) normal[k] = small(range);
      if (normal == IntegerVector3::Zero()) continue;
      switch (i % 4) {
        case 0:  // small integers: parallel planes, planes through common points, repeats
          made_.emplace_back(normal, Integer(-1 - static_cast<int>(uniform_below(random_, 5))));
          break;
        case 1:  // through the lattice points of a cube: vertices of many planes
          made_.emplace_back(normal, -highest(normal));
          break;
        case 2:  // all touch one sphere, to 60 bits
          made_.emplace_back(IntegerVector3(normal * (Integer(1) << 60)), -tangent(normal));
          break;
        default:  // directions and distances that differ by 2^-60
          for (int k = 0; k < 3; ++k) normal[k] = (normal[k] << 60) + small(2);
          made_.emplace_back(normal, (Integer(-1) << 60) + small(2));
      }
    }
  }
  const std::vector<convexact::Halfspace>& all() const { return made_; }

 private:
  convexact::Integer small(std::uint64_t range) {
    return convexact::Integer(convexact::uniform_below(random_, 2 * range + 1)) -
           convexact::Integer(range);
  }
  // The largest n.x over the corners of [-1, 1]^3, or over the middles of its edges.
  convexact::Integer highest(const convexact::IntegerVector3& n) {
    convexact::Integer sum = 0, least = abs(n[0]);
    for (int k = 0; k < 3; ++k) {
      sum += abs(n[k]);
      least = std::min(least, convexact::Integer(abs(n[k])));
    }
    const bool at_edge = convexact::uniform_below(random_, 2) == 0;
    return at_edge ? sum - least : sum;
  }
  static convexact::Integer tangent(const convexact::IntegerVector3& n) {
    const convexact::Integer square = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
    return sqrt(convexact::Integer(square << 120));
  }

  convexact::Random random_;
  std::vector<convexact::Halfspace> made_;
};

}  // namespace hard
