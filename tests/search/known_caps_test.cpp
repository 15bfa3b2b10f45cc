// SPDX-License-Identifier: MIT
// Known caps: which are found again, and which rule a candidate out. Expected values by hand.
#include "search/known_caps.hpp"

#include <doctest/doctest.h>

#include <set>

using namespace convexact;

namespace {

std::vector<HalfspaceId> ring(std::initializer_list<std::uint32_t> ids) {
  std::vector<HalfspaceId> list;
  for (const std::uint32_t id : ids) list.emplace_back(id);
  return list;
}

CostBounds<double> bounded(double upper) { return {Boundedness::Bounded, 0, upper}; }

}  // namespace

TEST_CASE(
    "KnownCaps: a ring is found from any start, in its direction and for its halfspace only") {
  KnownCaps caps(20);
  const HalfspaceId i(7);
  CHECK(caps.find(i, ring({1, 2, 3, 4})) == nullptr);
  caps.add(i, ring({1, 2, 3, 4}), bounded(5));
  for (const auto& turned : {ring({1, 2, 3, 4}), ring({3, 4, 1, 2}), ring({4, 1, 2, 3})}) {
    REQUIRE(caps.find(i, turned) != nullptr);
    CHECK(caps.find(i, turned)->upper == 5);
  }
  CHECK(caps.find(i, ring({4, 3, 2, 1})) == nullptr);
  CHECK(caps.find(i, ring({1, 2, 3})) == nullptr);
  CHECK(caps.find(i, ring({1, 2, 3, 5})) == nullptr);
  CHECK(caps.find(HalfspaceId(8), ring({1, 2, 3, 4})) == nullptr);
}

TEST_CASE("KnownCaps: of many rings the last ones are kept, and none that is long") {
  KnownCaps caps(40);
  const HalfspaceId i(0);
  for (std::uint32_t k = 1; k <= 9; ++k) caps.add(i, ring({k, k + 10, k + 20}), bounded(k));
  CHECK(caps.find(i, ring({1, 11, 21})) == nullptr);
  for (std::uint32_t k = 2; k <= 9; ++k) {
    REQUIRE(caps.find(i, ring({k, k + 10, k + 20})) != nullptr);
    CHECK(caps.find(i, ring({k, k + 10, k + 20}))->upper == k);
  }
  std::vector<HalfspaceId> longest;
  for (std::uint32_t k = 20; k < 33; ++k) longest.emplace_back(k);
  caps.add(i, longest, bounded(1));
  CHECK(caps.find(i, longest) == nullptr);
  longest.pop_back();
  caps.add(i, longest, bounded(1));
  CHECK(caps.find(i, longest) != nullptr);
}

TEST_CASE("KnownCaps: a cap bounds others where the solid has all of its ring") {
  KnownCaps caps(20);
  const HalfspaceId i(0);
  caps.add(i, ring({1, 2, 3}), bounded(5));
  caps.add(i, ring({4, 5, 6}), {Boundedness::Unbounded, 0, 0});
  caps.add(i, ring({4, 5, 7}), {Boundedness::Doubtful, 0, 0});
  const auto is_at_most = [&](double most, const std::set<std::uint32_t>& solid) {
    return caps.is_at_most(i, most, [&](HalfspaceId h) { return solid.contains(h.value); });
  };
  CHECK(is_at_most(5, {1, 2, 3, 9}));
  CHECK_FALSE(is_at_most(4.5, {1, 2, 3, 9}));
  for (int round = 0; round < 2; ++round) {  // whichever of the ring is missing
    for (const std::uint32_t missing : {1u, 2u, 3u}) {
      std::set<std::uint32_t> solid{1, 2, 3};
      solid.erase(missing);
      CHECK_FALSE(is_at_most(5, solid));
    }
    CHECK(is_at_most(5, {1, 2, 3}));
  }
  CHECK_FALSE(is_at_most(1e9, {4, 5, 6, 7}));  // doubtful and endless ones rule nothing out
}
