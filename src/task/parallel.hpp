// SPDX-License-Identifier: MIT
// parallel.hpp - the same work for many numbers, on several threads.
#pragma once
#include <cstddef>
#include <functional>
#include <mutex>

#include "convexact/error.hpp"

namespace convexact {

/// Calls work(i) for each i below count, on up to `jobs` threads, one of them the caller's. What
/// work(i) leaves must depend on i alone: then it is the same for any number of threads.
/// @param jobs      At least 1; of 1 the order is ascending.
/// @param finished  Called with the number of those done after each, one call at a time, on the
///                  thread that did it; may be empty.
/// @throws          What work(i), or `finished` after it, threw, for the lowest i that did. No more
///                  work begins after it.
void for_each_in_parallel(std::size_t count, std::size_t jobs,
                          const std::function<void(std::size_t)>& work,
                          const std::function<void(std::size_t)>& finished = {});

/// The same with a watch, which is asked before each, and told of each. work() gets it without
/// reports.
void for_each_in_parallel(std::size_t count, std::size_t jobs, const Watch& watch,
                          const std::function<void(std::size_t, const Watch&)>& work);

/// As many threads as this machine runs at the same time, at least 1.
[[nodiscard]] std::size_t all_cores();

}  // namespace convexact
