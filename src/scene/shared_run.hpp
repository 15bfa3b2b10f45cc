// SPDX-License-Identifier: MIT
// shared_run.hpp - one queue over the runs of several parts: the cheapest next removal among all
// parts is made first.
#pragma once
#include <compare>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "convexact/cost.hpp"
#include "convexact/run.hpp"

namespace convexact {

/// No solid has fewer faces, so with four every removal is unbounded.
inline constexpr std::size_t kLeastFaces = 4;

/// mantissa * 2^exponent >= 0, with the mantissa in [1/2, 1) where it is finite and not 0: numbers
/// of parts whose duals are scaled differently have an order, however large they are.
struct WideDouble {
  /// For x * 2^exponent; numbers below 0 count as 0.
  static WideDouble of(double x, long exponent);

  long exponent;
  double mantissa;
  friend auto operator<=>(const WideDouble&, const WideDouble&) = default;
};

class ExactPartRun;

/// The run of one part, step by step, for every engine. Costs are in the caller's units.
class PartRun {
 public:
  virtual ~PartRun() = default;
  virtual std::size_t left() const = 0;
  /// Finds the next removal. False if there is none, now and later.
  virtual bool find_next() = 0;

  // Of the next removal:
  struct Bounds {
    WideDouble low, high;
  };
  virtual Bounds cost_bounds() = 0;
  /// The amount that it adds to the measure whose growth is limited.
  virtual Enclosure added() = 0;
  virtual void make() = 0;

  /// The same in exact numbers; null if the engine chooses by estimates, which are then both
  /// bounds.
  virtual ExactPartRun* exact() = 0;
};

/// The additional data of an engine with exact numbers.
class ExactPartRun {
 public:
  virtual ~ExactPartRun() = default;
  /// Of the next removal, likewise.
  virtual const Cost& exact_cost() = 0;
  virtual Cost exactly_added() = 0;
  /// The measure whose growth is limited: of the part as it is now, and before the first removal.
  virtual Cost measure_now() = 0;
  virtual Cost measure_before() = 0;
};

struct SharedOptions {
  std::size_t total_faces;
  CompareLimits compare = {};
  std::optional<Rational> max_growth = {};
  /// With max_growth: the sum of the parts' measures before the first removal.
  std::optional<Enclosure> measure = {};
  bool costs_never_fall = false;  ///< Of one part, as those by volume.
  StopReason when_stuck = StopReason::AllUnbounded;
  std::size_t jobs = 1;  ///< Threads, on which nothing depends, for what one part does alone.
  Watch watch = {};      ///< Told after each removal of those made and of those that lead there.
};

/// How a shared run went.
struct SharedEnd {
  StopReason stop = StopReason::Reached;
  std::vector<std::uint32_t> order;  ///< The part of each removal that the queue chose.
  TieTally ties;                     ///< Between parts.
  long growth_bits = 0;              ///< As in Run.
};

/// Advances the runs, each time the one whose next removal costs least, the first on a tie. The
/// removals that a part makes in any case are made first: it ends with no more than `total_faces`
/// less 4 for each other part.
/// @param parts  At least one; none of them has found its next removal. A budget of 4 for each.
[[nodiscard]] SharedEnd run_shared(std::span<const std::unique_ptr<PartRun>> parts,
                                   const SharedOptions& options);

}  // namespace convexact
