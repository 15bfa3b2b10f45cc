// SPDX-License-Identifier: MIT
// each_object.hpp - the same work on each object of a scene, on several of them at the same time.
#pragma once
#include <algorithm>
#include <cstddef>
#include <mutex>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "convexact/simplify.hpp"
#include "task/parallel.hpp"

namespace convexact {

/// The results of work(k, watch, jobs) for each object k; or the first one without volume.
/// @param work   Returns a variant of a Result and NotSolid. It may use `jobs` threads: all of them
///               for a single object, and otherwise one, with a watch that reports nothing.
/// @param threads  All cores if it is not given. Nothing depends on it.
/// @param watch  Of the stages of a single object; of several, told how many are done.
/// @throws       What `work` threw for the first object, if none before it is without volume.
template <class Result, class Work>
std::variant<std::vector<Result>, NotSolidPart> on_each(std::size_t count,
                                                        std::optional<std::size_t> threads,
                                                        const StageWatch& watch, const Work& work) {
  constexpr const char* kStage = "objects";
  const std::size_t jobs = threads.value_or(all_cores());
  const bool alone = jobs == 1 || count <= 1;
  if (!alone && watch.begins) watch.begins(kStage);
  const StageWatch quiet = watch.without_reports();
  const Watch together = alone ? Watch(watch.stop) : watch.of(kStage);
  std::vector<Attempt<std::variant<Result, NotSolid>>> attempts(count);
  std::mutex mutex;
  std::size_t end = count;  // the first that ends it: all before it are looked at
  for_each_in_parallel(count, alone ? 1 : jobs, together, [&](std::size_t k, const Watch&) {
    {
      const std::lock_guard lock(mutex);
      if (k > end) return;
    }
    attempts[k].set([&] { return work(k, alone ? watch : quiet, alone ? jobs : 1); });
    if (attempts[k].has_value() && std::holds_alternative<Result>(attempts[k].get())) return;
    const std::lock_guard lock(mutex);
    end = std::min(end, k);
  });
  std::vector<Result> results;
  results.reserve(count);
  for (auto& attempt : attempts) {
    auto& outcome = attempt.get();
    if (auto* reason = std::get_if<NotSolid>(&outcome)) {
      return NotSolidPart{results.size(), std::move(*reason)};
    }
    results.push_back(std::get<Result>(std::move(outcome)));
  }
  return results;
}

}  // namespace convexact
