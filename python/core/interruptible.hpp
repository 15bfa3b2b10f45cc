// SPDX-License-Identifier: MIT
// interruptible.hpp - long work under Python: without its lock, with progress, ended by Ctrl-C.
#pragma once
#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

#include "convexact/error.hpp"

namespace convexact::python {

namespace py = pybind11;

/// Calls of less than this many points end sooner than a thread begins.
inline constexpr std::size_t kSmall = 64;

/// work(watch), in a thread of its own unless it is small: this one waits and asks Python every 50
/// milliseconds whether a signal came.
/// @param progress  None, or called with stage, steps done and all steps; what it throws ends the
///                  work.
/// @throws What the work, a signal's handler or `progress` throws.
template <class Work>
auto interruptible(std::size_t size, const py::object& progress, Work&& work) {
  using Result = decltype(work(StageWatch{}));
  std::atomic<bool> stop{false};
  std::exception_ptr thrown;
  std::optional<py::error_already_set> said;  // by `progress`
  StageWatch watch;
  watch.stop = &stop;
  if (!progress.is_none()) {
    watch.progress = [&](const std::string& stage, std::size_t done, std::size_t total) {
      const py::gil_scoped_acquire lock;
      if (said) return;
      try {
        progress(stage, done, total);
      } catch (py::error_already_set& error) {
        said.emplace(error);
        stop = true;
      }
    };
  } else if (size < kSmall) {
    const py::gil_scoped_release unlocked;
    return work(watch);
  }
  std::optional<Result> result;
  {
    const py::gil_scoped_release unlocked;
    std::mutex mutex;
    std::condition_variable ended;
    bool is_done = false;
    std::thread worker([&] {
      try {
        result.emplace(work(watch));
      } catch (...) {
        thrown = std::current_exception();
      }
      const std::lock_guard guard(mutex);
      is_done = true;
      ended.notify_one();
    });
    std::unique_lock guard(mutex);
    while (!ended.wait_for(guard, std::chrono::milliseconds(50), [&] { return is_done; })) {
      guard.unlock();
      {
        const py::gil_scoped_acquire lock;
        if (!said && PyErr_CheckSignals() != 0) {
          said.emplace();
          stop = true;
        }
      }
      guard.lock();
    }
    guard.unlock();
    worker.join();
  }
  if (said) throw py::error_already_set(*said);
  if (thrown) std::rethrow_exception(thrown);
  return std::move(*result);
}

}  // namespace convexact::python
