// SPDX-License-Identifier: MIT
#include "task/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

namespace convexact {

void for_each_in_parallel(std::size_t count, std::size_t jobs,
                          const std::function<void(std::size_t)>& work,
                          const std::function<void(std::size_t)>& finished) {
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> has_failed = false;
  std::vector<std::exception_ptr> errors(count);
  std::mutex mutex;  // of `finished` and `done`
  std::size_t done = 0;
  const auto run = [&] {
    // What was taken is done, so that of several that fail the lowest is found on any schedule.
    while (!has_failed) {
      const std::size_t i = next++;
      if (i >= count) break;
      try {
        work(i);
        if (!finished) continue;
        const std::lock_guard lock(mutex);
        finished(++done);
      } catch (...) {
        errors[i] = std::current_exception();
        has_failed = true;
      }
    }
  };
  std::vector<std::thread> threads;
  try {
    for (std::size_t k = 1; k < std::min(jobs, count); ++k) threads.emplace_back(run);
  } catch (const std::system_error&) {
    // A system without threads, or one that gives no more of them: those that there are do it all.
  }
  run();
  for (std::thread& thread : threads) thread.join();
  for (const std::exception_ptr& error : errors) {
    if (error) std::rethrow_exception(error);
  }
}

void for_each_in_parallel(std::size_t count, std::size_t jobs, const Watch& watch,
                          const std::function<void(std::size_t, const Watch&)>& work) {
  const Watch quiet = watch.without_reports();
  for_each_in_parallel(
      count, jobs,
      [&](std::size_t i) {
        quiet.ask();
        work(i, quiet);
      },
      [&](std::size_t done) { watch.report(done, count); });
}

void require_threads(std::optional<std::size_t> jobs) {
  if (!jobs || (*jobs >= 1 && *jobs <= kMostThreads)) return;
  throw Error(ErrorCode::InvalidArgument, "jobs: expected 1 to " + std::to_string(kMostThreads) +
                                              ", found " + std::to_string(*jobs));
}

std::size_t all_cores() {
  return std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, kMostThreads);
}

}  // namespace convexact
