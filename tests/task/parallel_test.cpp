// SPDX-License-Identifier: MIT
// Loops on several threads: each number once, the lowest failure, calls of `finished` one by one.
#include "task/parallel.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

using namespace convexact;

namespace {

void delay(std::size_t i) {
  std::mt19937_64 random(i);
  std::this_thread::sleep_for(std::chrono::microseconds(random() % 200));
}

}  // namespace

TEST_CASE("for_each_in_parallel: each number once, for any number of threads") {
  for (const std::size_t jobs : {1u, 2u, 3u, 8u, 100u}) {
    for (const std::size_t count : {0u, 1u, 2u, 50u}) {
      CAPTURE(jobs);
      std::vector<int> calls(count, 0);
      std::vector<std::size_t> done;
      for_each_in_parallel(
          count, jobs,
          [&](std::size_t i) {
            delay(i);
            ++calls[i];
          },
          [&](std::size_t n) { done.push_back(n); });
      CHECK(calls == std::vector<int>(count, 1));
      std::vector<std::size_t> ascending(count);
      std::iota(ascending.begin(), ascending.end(), 1);
      CHECK(done == ascending);
    }
  }
}

TEST_CASE("for_each_in_parallel: one thread goes in order") {
  std::vector<std::size_t> order;
  for_each_in_parallel(5, 1, [&](std::size_t i) { order.push_back(i); });
  CHECK(order == std::vector<std::size_t>{0, 1, 2, 3, 4});
}

TEST_CASE("for_each_in_parallel: the failure of the lowest number is thrown, and ends the loop") {
  for (const std::size_t jobs : {1u, 2u, 8u}) {
    CAPTURE(jobs);
    std::atomic<std::size_t> begun = 0;
    std::string caught;
    try {
      // The first one waits until the second has failed, if there is a thread for it.
      std::atomic<bool> second_failed = jobs == 1;
      for_each_in_parallel(1000, jobs, [&](std::size_t i) {
        ++begun;
        while (i == 0 && !second_failed) std::this_thread::yield();
        if (i == 1) second_failed = true;
        if (i < 2) throw std::runtime_error(std::to_string(i));
        delay(i);
      });
    } catch (const std::runtime_error& error) {
      caught = error.what();
    }
    CHECK(caught == "0");
    CHECK(begun < 1000);
  }
}

TEST_CASE("for_each_in_parallel: of several failures it is the lowest, on any schedule") {
  for (const std::size_t jobs : {1u, 2u, 8u}) {
    for (std::size_t slow = 5; slow < 9; ++slow) {
      CAPTURE(jobs);
      CAPTURE(slow);
      const auto fail_from_fifth = [&](std::size_t i) {
        if (i == slow) std::this_thread::sleep_for(std::chrono::milliseconds(2));
        if (i >= 5) throw std::runtime_error(std::to_string(i));
      };
      CHECK_THROWS_WITH(for_each_in_parallel(1000, jobs, fail_from_fifth), "5");
    }
  }
}

TEST_CASE("for_each_in_parallel: what a callback throws gets to the caller, on any thread") {
  for (const std::size_t jobs : {1u, 2u, 8u}) {
    CAPTURE(jobs);
    const auto cancel = [](std::size_t done) {
      if (done == 10) throw std::runtime_error("cancelled");
    };
    CHECK_THROWS_AS(for_each_in_parallel(1000, jobs, delay, cancel), std::runtime_error);
  }
}

TEST_CASE("for_each_in_parallel: a watch is told of each, and ends the loop") {
  for (const std::size_t jobs : {1u, 3u}) {
    CAPTURE(jobs);
    std::vector<std::size_t> told;
    std::vector<int> calls(50, 0);
    const Watch watch(nullptr, [&](std::size_t done, std::size_t all) {
      CHECK(all == 50);
      told.push_back(done);
    });
    for_each_in_parallel(50, jobs, watch, [&](std::size_t i, const Watch& quiet) {
      ++calls[i];
      quiet.report(1, 2);  // goes nowhere
    });
    CHECK(calls == std::vector<int>(50, 1));
    std::vector<std::size_t> ascending(50);
    std::iota(ascending.begin(), ascending.end(), 1);
    CHECK(told == ascending);

    std::atomic<bool> stop = false;
    std::atomic<std::size_t> begun = 0;
    const auto stop_at_tenth = [&](std::size_t, const Watch&) {
      if (++begun == 10) stop = true;
    };
    CHECK_THROWS_AS(for_each_in_parallel(50, jobs, Watch(&stop), stop_at_tenth), Error);
    CHECK(begun < 10 + jobs);
  }
}

TEST_CASE("take_in_order: each in its order, on the caller's thread, for any number of threads") {
  for (const std::size_t jobs : {1u, 2u, 3u, 8u}) {
    for (const std::size_t turn : {1u, 16u}) {
      for (const std::size_t count : {0u, 1u, 17u, 700u}) {
        CAPTURE(jobs);
        std::vector<std::size_t> taken;
        const auto caller = std::this_thread::get_id();
        take_in_order(
            count, jobs, {},
            [&](std::size_t i, const Watch&) {
              if (i % 50 == 0) delay(i);
              return i * i;
            },
            [&](std::size_t i, std::size_t made) {
              CHECK(made == i * i);
              CHECK(std::this_thread::get_id() == caller);
              taken.push_back(i);
              return true;
            },
            turn);
        std::vector<std::size_t> ascending(count);
        std::iota(ascending.begin(), ascending.end(), 0);
        CHECK(taken == ascending);
      }
    }
  }
}

TEST_CASE("take_in_order: what is behind the end is not told of, not even its failure") {
  for (const std::size_t jobs : {1u, 2u, 8u}) {
    CAPTURE(jobs);
    std::size_t taken = 0;
    const auto fail_from = [&](std::size_t first, std::size_t end) {
      taken = 0;
      take_in_order(
          1000, jobs, {},
          [&](std::size_t i, const Watch&) {
            if (i >= first) throw std::runtime_error(std::to_string(i));
            return i;
          },
          [&](std::size_t i, std::size_t) {
            ++taken;
            return i != end;
          });
    };
    CHECK_NOTHROW(fail_from(6, 5));
    CHECK(taken == 6);
    CHECK_THROWS_WITH(fail_from(5, 5), "5");
    CHECK(taken == 5);
    CHECK_THROWS_WITH(fail_from(0, 5), "0");
  }
}

TEST_CASE("take_in_order: no thread is refused, and so are too many") {
  const auto make = [](std::size_t i, const Watch&) { return i; };
  const auto take = [](std::size_t, std::size_t) { return true; };
  CHECK_THROWS_AS(take_in_order(5, 0, {}, make, take), Error);
  CHECK_THROWS_WITH(take_in_order(5, 257, {}, make, take), "jobs: expected 1 to 256, found 257");
  CHECK_NOTHROW(take_in_order(5, 256, {}, make, take));
}

TEST_CASE("take_in_order: a watch ends it, and is told") {
  for (const std::size_t jobs : {1u, 3u}) {
    std::atomic<bool> stop = false;
    std::size_t told = 0;
    const Watch watch(&stop, [&](std::size_t, std::size_t all) {
      CHECK(all == 5000);
      ++told;
    });
    const auto make = [&](std::size_t i, const Watch& quiet) {
      quiet.report(1, 2);  // goes nowhere
      return i;
    };
    const auto stop_at = [&](std::size_t i, std::size_t) {
      if (i == 1000) stop = true;
      return true;
    };
    CHECK_THROWS_AS(take_in_order(5000, jobs, watch, make, stop_at), Error);
    CHECK(told >= 3);  // alone, once in 256
  }
}
