// SPDX-License-Identifier: MIT
// time_left.hpp - how long work will still take, from the share of it that is done.
#pragma once
#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <string>

namespace convexact::cli {

/// What remains takes as long as what is done, until the last change of the share. From then on it
/// becomes less, so that it never grows while the share stands still.
class TimeLeft {
 public:
  /// "about 12 s left", in minutes from two minutes on; empty as long as it is unknown, and once
  /// the work takes longer than it should.
  /// @param seconds  Since the work began.
  std::string text(double seconds, std::size_t done, std::size_t total) {
    constexpr double kTooSoon = 0.5, kMinute = 60;
    if (done != done_) {
      done_ = done;
      seconds_ = seconds;
    }
    if (done_ == 0 || seconds_ < kTooSoon) return {};
    const double estimate =
        seconds_ * static_cast<double>(total - done_) / static_cast<double>(done_);
    const double left = estimate - (seconds - seconds_);
    if (left <= 0) return {};  // longer than expected
    if (left < 2 * kMinute) return fmt::format("about {:.0f} s left", std::ceil(left));
    return fmt::format("about {:.0f} min left", std::ceil(left / kMinute));
  }

 private:
  std::size_t done_ = 0;
  double seconds_ = 0;  // at the last change of done_
};

}  // namespace convexact::cli
