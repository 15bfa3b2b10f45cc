// SPDX-License-Identifier: MIT
#include "io/point_merger.hpp"

#include <doctest/doctest.h>

#include <set>

using namespace convexact;

TEST_CASE("PointMerger: points of a grid have different hashes, in 32 bits too") {
  std::set<std::uint32_t> hashes;
  for (int x = 0; x < 16; ++x) {
    for (int y = 0; y < 16; ++y) {
      for (int z = 0; z < 16; ++z) {
        hashes.insert(static_cast<std::uint32_t>(hash_of(Point(x, y, z))));
      }
    }
  }
  // 4096 random numbers of 32 bits collide in 2 pairs on average.
  CHECK(hashes.size() > 4080);
  CHECK(hash_of(Point(0, 1, 2)) == hash_of(Point(-0.0, 1, 2)));
}
