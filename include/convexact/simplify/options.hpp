// SPDX-License-Identifier: MIT
// options.hpp - what every engine is asked: where to stop, what to verify, how to be interrupted.
#pragma once
#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>

#include "convexact/number/rational.hpp"

namespace convexact {

/// How much of each step is proven again; see docs/verification.md.
enum class VerifyLevel {
  None,   ///< Nothing; for experiments only.
  Local,  ///< The step itself: its disk, its signs, its cap, its witnesses.
  Full,   ///< In addition the whole dual, every hull vertex, and the volume.
};

struct SimplifyOptions {
  /// Stop at this many halfspaces; at least 4. At or above the input's number: nothing happens.
  std::size_t faces = 4;
  /// Stop before the volume exceeds (1 + max_growth) times the input's; >= 0.
  std::optional<Rational> max_growth = {};
  /// Of the random choices; the removals and their costs do not depend on it.
  std::uint64_t seed = 1;
  VerifyLevel verify = VerifyLevel::Local;
  /// Keep the evaluations of every removal; docs/proof-format.md has their use.
  bool keep_evaluations = false;
  /// Called after every step with the number of halfspaces left.
  std::function<void(std::size_t left)> progress = {};
  /// When it becomes true, the run ends with Error(Stopped). May be set by a signal handler.
  const std::atomic<bool>* stop = nullptr;
};

}  // namespace convexact
