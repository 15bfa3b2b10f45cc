// SPDX-License-Identifier: MIT
// parallel.hpp - the same work for many numbers, on several threads.
#pragma once
#include <algorithm>
#include <cstddef>
#include <exception>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

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

/// What `jobs` of a request may be at most.
inline constexpr std::size_t kMostThreads = 256;

/// @throws Error InvalidArgument for no thread at all, and for more than kMostThreads.
void require_threads(std::optional<std::size_t> jobs);

/// What a function returned, or threw: found on one thread, told on another.
template <class Value>
class Attempt {
 public:
  template <class Make>
  void set(const Make& make) noexcept {
    try {
      value_.emplace(make());
    } catch (...) {
      error_ = std::current_exception();
    }
  }
  /// Precondition, as of the next: set.
  bool has_value() const { return value_.has_value(); }
  /// @throws What the function threw.
  Value& get() {
    if (error_) std::rethrow_exception(error_);
    return *value_;
  }

 private:
  std::optional<Value> value_;
  std::exception_ptr error_;
};

/// Calls take(i, make(i, quiet)) for each i below count, ascending and on the caller's thread,
/// until it returns false; make() runs on up to `jobs` threads, for a few i in advance. What
/// make(i) returns must depend on i alone: then take() gets the same for any number of threads.
/// @param watch  Asked before each, and told how many are taken. make() gets it without reports.
/// @param turn   How many a thread makes before it asks for more: several, if they are quick.
/// @throws       What make(i) threw, if no take() before it ended the loop; what take() throws;
///               Error InvalidArgument without a thread.
template <class Make, class Take>
void take_in_order(std::size_t count, std::size_t jobs, const Watch& watch, const Make& make,
                   const Take& take, std::size_t turn = 16) {
  require_threads(jobs);
  constexpr std::size_t kInAdvance = 64;  // at most, for each thread; what they return waits
  const Watch quiet = watch.without_reports();
  using Made = decltype(make(std::size_t{}, quiet));
  std::vector<Attempt<Made>> made;
  // Few at first, as the first that is taken may end it.
  std::size_t together = jobs == 1 ? 1 : jobs * turn;
  for (std::size_t first = 0; first < count; first += made.size()) {
    if (first > 0 && jobs > 1) together = std::min(2 * together, kInAdvance * jobs);
    made.clear();
    made.resize(std::min(together, count - first));
    const auto tell = [&](std::size_t turns) {
      const std::size_t done = first + std::min(turns * turn, made.size());
      if (jobs > 1 || done % 256 == 0) watch.report(done, count);
    };
    for_each_in_parallel((made.size() + turn - 1) / turn, jobs,
                         [&](std::size_t number) {
                           const std::size_t end = std::min(made.size(), (number + 1) * turn);
                           for (std::size_t k = number * turn; k < end; ++k) {
                             quiet.ask();
                             made[k].set([&] { return make(first + k, quiet); });
                           }
                         },
                         tell);
    for (std::size_t k = 0; k < made.size(); ++k) {
      watch.ask();
      if (!take(first + k, std::move(made[k].get()))) return;
    }
  }
}

/// As many threads as this machine runs at the same time, from 1 to kMostThreads.
[[nodiscard]] std::size_t all_cores();

/// Of a request with `jobs`, which mean all cores where they are not given.
template <class Request>
[[nodiscard]] std::size_t jobs_of(const Request& request) {
  return request.jobs.value_or(all_cores());
}

}  // namespace convexact
