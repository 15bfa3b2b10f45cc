// SPDX-License-Identifier: MIT
// Groups that join, against sets that are merged one by one.
#include "number/groups.hpp"

#include <doctest/doctest.h>

#include "number/random.hpp"

using namespace convexact;

TEST_CASE("Groups: none, and one each") {
  CHECK(Groups(0).roots().empty());
  CHECK(Groups(3).roots() == std::vector<std::uint32_t>{0, 1, 2});
}

TEST_CASE("Groups: the root is the lowest number, in whatever order groups join") {
  constexpr std::uint32_t kCount = 12;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    Groups groups(kCount);
    std::vector<std::uint32_t> lowest = Groups(kCount).roots();
    for (int step = 0; step < 10; ++step) {
      const auto a = static_cast<std::uint32_t>(uniform_below(random, kCount)),
                 b = static_cast<std::uint32_t>(uniform_below(random, kCount));
      const std::uint32_t x = lowest[a], y = lowest[b];
      CHECK(groups.join(a, b) == (x != y));
      for (std::uint32_t& name : lowest) {
        if (name == std::max(x, y)) name = std::min(x, y);
      }
      for (std::uint32_t i = 0; i < kCount; ++i) CHECK(Groups(groups).root(i) == lowest[i]);
    }
    CHECK(groups.roots() == lowest);
  }
}
