// SPDX-License-Identifier: MIT
// error.hpp - what can go wrong, with its place in the input; and how a long loop is watched and
// stopped.
#pragma once
#include <atomic>
#include <cstddef>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace convexact {

// ---- What can go wrong, with where in the input.

enum class ErrorCode {
  InvalidArgument,  ///< A precondition of a function or an option of the caller is broken.
  Unreadable,       ///< A file cannot be opened or read.
  Malformed,        ///< A file or a number in it does not spell what was expected.
  NotFinite,        ///< NaN, infinity, or a decimal beyond the largest double.
  NoInterior,       ///< INPUT is empty, flat or unbounded where a solid was asked for.
  Unwritable,       ///< A file cannot be created or written.
  Unrepresentable,  ///< The output format cannot hold the result.
  Stopped,          ///< Out of memory, interrupted, closed pipe.
  Internal,         ///< An invariant or a verification of convexact failed: a bug.
};

/// Broken precondition, unreadable input or unwritable output; never a mathematical answer.
/// what() is one sentence and starts with "file:line: " as far as these are known.
class Error : public std::runtime_error {
 public:
  Error(ErrorCode code, const std::string& message, std::optional<std::size_t> line = {});

  ErrorCode code() const noexcept { return code_; }
  /// Offending line or row of a text, 1-based.
  std::optional<std::size_t> line() const noexcept { return line_; }
  /// The same error, with the name of the file put in front of the message.
  Error in_file(const std::string& file) const;

 private:
  Error(ErrorCode code, const std::string& file, const std::string& message,
        std::optional<std::size_t> line);
  ErrorCode code_;
  std::string message_;  // without file and line
  std::optional<std::size_t> line_;
};

/// The process exit code that stands for an error: 2, 3, 4, 5, 6 or 70 (docs/usage.md).
int exit_code(ErrorCode code) noexcept;

namespace detail {
[[noreturn]] void assertion_failed(const char* condition, const char* file, int line);
}

/// @throws Error InvalidArgument: what is wrong with a request, and what would be right.
[[noreturn]] void reject_argument(const std::string& why);

// ---- How a caller watches a long loop, and ends it.

/// A check at each step of a loop that may take seconds; without arguments it does nothing.
class Watch {
 public:
  using Progress = std::function<void(std::size_t done, std::size_t total)>;

  /// @param stop  When it becomes true, the loop ends. A signal handler may set it.
  Watch(const std::atomic<bool>* stop = nullptr, Progress progress = {})
      : stop_(stop), progress_(std::move(progress)) {}

  /// @throws Error Stopped when the flag has become true.
  void ask() const {
    if (stop_ != nullptr && stop_->load(std::memory_order_relaxed)) {
      throw Error(ErrorCode::Stopped, "interrupted");
    }
  }
  /// Reports the number of steps done and of all steps, for steps that take microseconds and more.
  void report(std::size_t done, std::size_t total) const {
    if (progress_) progress_(done, total);
  }
  /// The same flag without reports, for threads that work at the same time.
  Watch without_reports() const { return Watch(stop_); }
  /// Calls ask(), and report() from time to time.
  void at(std::size_t done, std::size_t total) const {
    ask();
    if (done % 256 == 0) report(done, total);
  }

 private:
  const std::atomic<bool>* stop_;
  Progress progress_;
};

/// How a caller watches a request while its stages run, and ends it.
struct StageWatch {
  /// Called as a stage begins.
  std::function<void(const std::string& stage)> begins = {};
  /// Called from time to time with the number of steps done and the number of all steps of a long
  /// stage: one call at a time, of a stage that works on several threads on any of them.
  std::function<void(const std::string& stage, std::size_t done, std::size_t total)> progress = {};
  /// When it becomes true, the request ends with Error Stopped. A signal handler may set it.
  const std::atomic<bool>* stop = nullptr;
  /// When it becomes true, a search for the least volume ends with the best so far.
  const std::atomic<bool>* settle = nullptr;

  /// The same flags without reports, for work on several things at the same time.
  StageWatch without_reports() const { return {.stop = stop, .settle = settle}; }
  /// For the loops of one stage; it must not outlive this.
  Watch of(const std::string& stage) const {
    if (!progress) return stop;
    return Watch(
        stop, [this, stage](std::size_t done, std::size_t total) { progress(stage, done, total); });
  }
};

}  // namespace convexact

/// An invariant of ours. Throws Error(Internal) when broken; compiled in for tests and fuzzing.
#ifdef CONVEXACT_ASSERTIONS
#define CONVEXACT_ASSERT(condition) \
  ((condition) ? void(0) : ::convexact::detail::assertion_failed(#condition, __FILE__, __LINE__))
#else
#define CONVEXACT_ASSERT(condition) (void(sizeof(bool(condition))))
#endif
