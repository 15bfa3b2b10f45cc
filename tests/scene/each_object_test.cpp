// SPDX-License-Identifier: MIT
// Objects of a scene on several threads: all results in their order, or the first end in that
// order.
#include "scene/each_object.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <random>
#include <string>
#include <thread>

using namespace convexact;

namespace {

using Outcome = std::variant<int, NotSolid>;

NotSolid flat() { return FlatInput{2, {}, {}}; }

// Different times, so that later objects end before earlier ones.
void delay(std::size_t k) {
  std::mt19937_64 random(k);
  std::this_thread::sleep_for(std::chrono::microseconds(random() % 300));
}

}  // namespace

TEST_CASE("on_each: all results in their order, a single object with all threads") {
  for (const std::size_t jobs : {1u, 2u, 3u, 8u}) {
    for (const std::size_t count : {1u, 2u, 40u}) {
      CAPTURE(jobs);
      std::vector<std::pair<std::size_t, std::size_t>> told;
      StageWatch watch;
      watch.progress = [&](const std::string& stage, std::size_t done, std::size_t all) {
        CHECK(stage == "objects");
        told.emplace_back(done, all);
      };
      const auto made =
          on_each<int>(count, jobs, watch,
                       [&](std::size_t k, const StageWatch& given, std::size_t threads) -> Outcome {
                         delay(k);
                         CHECK(threads == (count == 1 ? jobs : 1));
                         CHECK((given.progress != nullptr) == (count == 1 || jobs == 1));
                         return int(k);
                       });
      const auto& results = std::get<std::vector<int>>(made);
      REQUIRE(results.size() == count);
      for (std::size_t k = 0; k < count; ++k) CHECK(results[k] == int(k));
      CHECK(told.size() == (count == 1 || jobs == 1 ? 0 : count));
    }
  }
}

TEST_CASE("on_each: the first that is flat or fails ends it, whichever is found first") {
  for (const std::size_t jobs : {1u, 2u, 3u, 8u}) {
    for (std::size_t slow = 0; slow < 8; ++slow) {
      CAPTURE(jobs);
      CAPTURE(slow);
      const auto run = [&](std::size_t is_flat, std::size_t fails) {
        return on_each<int>(200, jobs, {},
                            [&](std::size_t k, const StageWatch&, std::size_t) -> Outcome {
                              if (k == slow)
                                std::this_thread::sleep_for(std::chrono::milliseconds(2));
                              if (k == fails) throw Error(ErrorCode::Malformed, std::to_string(k));
                              if (k >= is_flat) return flat();
                              return int(k);
                            });
      };
      CHECK(std::get<NotSolidPart>(run(4, 6)).part == 4);
      CHECK(std::get<NotSolidPart>(run(0, 1)).part == 0);
      CHECK_THROWS_WITH_AS((void)run(6, 4), "4", Error);
    }
  }
}

TEST_CASE("on_each: an interrupt ends it") {
  for (const std::size_t jobs : {1u, 3u}) {
    std::atomic<bool> stop = false;
    std::atomic<std::size_t> begun = 0;
    StageWatch watch;
    watch.stop = &stop;
    const auto stop_at_tenth = [&](std::size_t, const StageWatch&, std::size_t) -> Outcome {
      if (++begun == 10) stop = true;
      return 0;
    };
    CHECK_THROWS_AS((void)on_each<int>(100, jobs, watch, stop_at_tenth), Error);
    CHECK(begun < 10 + jobs);
  }
}
