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
