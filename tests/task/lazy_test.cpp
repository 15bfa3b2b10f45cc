// SPDX-License-Identifier: MIT
// Values made when they are first asked for: once, also if several threads ask at the same time.
#include "task/lazy.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

#include "task/parallel.hpp"

using namespace convexact;

TEST_CASE("Lazy: made once, and the same for all threads") {
  std::vector<Lazy<std::string>> values(20);
  std::vector<std::atomic<int>> made(values.size());
  std::vector<const std::string*> seen(400);
  for_each_in_parallel(seen.size(), 8, [&](std::size_t i) {
    const std::size_t k = i % values.size();
    seen[i] = &values[k].get([&] {
      ++made[k];
      return std::to_string(k);
    });
  });
  for (std::size_t i = 0; i < seen.size(); ++i) {
    CHECK(*seen[i] == std::to_string(i % values.size()));
    CHECK(seen[i] == seen[i % values.size()]);
  }
  for (const std::atomic<int>& count : made) CHECK(count == 1);
}

TEST_CASE("Lazy: what could not be made is made when it is asked for again") {
  const Lazy<int> value;
  CHECK_THROWS_AS((void)value.get([]() -> int { throw std::runtime_error("not yet"); }),
                  std::runtime_error);
  CHECK(value.get([] { return 7; }) == 7);
  CHECK(value.get([] { return 8; }) == 7);
}
