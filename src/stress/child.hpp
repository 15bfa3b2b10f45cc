// SPDX-License-Identifier: MIT
// child.hpp - work in a process of its own, so that a crash or a hang is a finding and not the end.
#pragma once
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "stress/stress.hpp"

namespace convexact {

/// How a child ended.
struct ChildEnd {
  std::optional<std::string> result;   ///< What the work returned.
  StressEnd end = StressEnd::Reached;  ///< If there is no result: Failed, Crashed, TimedOut, ...
  std::string why;                     ///< Likewise, with the end of what it wrote to its errors.
  std::uint64_t memory = 0;            ///< Peak, bytes.
};

/// A fork of this process that does one piece of work and hands its result back in a file without
/// a name. It dies with its parent, and with this object; what it prints goes nowhere.
class Child {
 public:
  /// @throws Error Stopped if the system cannot make a process.
  Child(const std::function<std::string()>& work, const StressLimits& limits);
  ~Child();
  Child(Child&& other) noexcept;
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Its end, once it has ended or has taken too long, and then no more.
  [[nodiscard]] std::optional<ChildEnd> poll();

 private:
  using Clock = std::chrono::steady_clock;
  ChildEnd describe(int status, std::uint64_t memory) const;

  int id_ = -1, result_ = -1, errors_ = -1;
  StressLimits limits_;
  Clock::time_point start_ = Clock::now();
};

}  // namespace convexact
