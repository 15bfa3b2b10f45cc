// SPDX-License-Identifier: MIT
#include "cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <system_error>

#include "cli/command.hpp"

namespace convexact::cli {
namespace {

constexpr std::chrono::seconds kPatience{1};
constexpr std::chrono::milliseconds kPause{200};

// Not through stdio: a process that is forked meanwhile must not find a lock taken.
void write_to_terminal(const std::string& text) {
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text.data(), text.size());
}

}  // namespace

Progress::Progress() : is_shown_(isatty(STDERR_FILENO) != 0) {
  if (!is_shown_) return;
  try {
    painter_ = std::thread([this] { paint(); });
  } catch (const std::system_error&) {
    is_shown_ = false;  // a system without threads, or one that gives no more of them
  }
}

void Progress::clear() {
  if (!is_shown_) return;
  is_shown_ = false;
  {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
  }
  changed_.notify_one();
  painter_.join();
}

void Progress::operator()(const std::string& what, std::size_t done, std::size_t total) {
  if (!is_shown_) return;
  if (what_ != what) begin(what);
  total_ = total;
  done_ = done;
}

StageWatch Progress::watch() {
  return {.begins =
              [this](const std::string& name) {
                let_interrupt_settle(name == stage::kOptimum);
                begin(name);
              },
          .progress = [this](const std::string& stage, std::size_t done,
                             std::size_t total) { (*this)(stage, done, total); },
          .stop = &interrupted(),
          .settle = &settled()};
}

Watch Progress::watch(const std::string& what) {
  return {&interrupted(),
          [this, what](std::size_t done, std::size_t total) { (*this)(what, done, total); }};
}

void Progress::begin(const std::string& what) {
  const std::lock_guard lock(mutex_);
  what_ = what;
  began_ = Clock::now();
  time_left_ = {};
  done_ = 0;
  total_ = 0;
}

void Progress::paint() {
  std::unique_lock lock(mutex_);
  bool is_painted = false;
  auto pause = std::chrono::duration_cast<std::chrono::milliseconds>(kPatience);
  while (!changed_.wait_for(lock, pause, [this] { return is_over_; })) {
    pause = kPause;
    write_to_terminal("\r\033[K" + line());
    is_painted = true;
  }
  if (is_painted) write_to_terminal("\r\033[K");
}

// Precondition: the lock is held.
std::string Progress::line() {
  const double seconds = std::chrono::duration<double>(Clock::now() - began_).count();
  const std::size_t total = total_, done = std::min<std::size_t>(done_, total);
  if (total == 0) return fmt::format("{}: {:.0f} s", what_, seconds);
  const std::string left = time_left_.text(seconds, done, total);
  return fmt::format("{}: {} of {} ({:.0f}%){}{}", what_, done, total,
                     100 * static_cast<double>(done) / static_cast<double>(total),
                     left.empty() ? "" : ", ", left);
}

}  // namespace convexact::cli
