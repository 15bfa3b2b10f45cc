// SPDX-License-Identifier: MIT
// trace_claims.hpp - the claims about a removal order while it is followed.
#pragma once
#include <vector>

#include "convexact/verify_run.hpp"

namespace convexact {

enum class TraceCode : unsigned char {
  Readable,
  PlaneUnknown,
  IdOutOfRange,
  RemovedTwice,
  Bounded,
  Greedy,
  Cost,
  Ties,
  Left,
  Stop,
};

/// One claim per code; of each the first violation is kept.
class TraceClaims {
 public:
  TraceClaims();

  void violate(TraceCode code, TraceWitness witness);
  /// A claim that only some files make: it holds unless it is violated.
  void ask(TraceCode code);
  /// The steps cannot be judged.
  void give_up();
  std::vector<TraceClaim> list() && { return std::move(claims_); }

 private:
  TraceClaim& at(TraceCode code) { return claims_[static_cast<std::size_t>(code)]; }
  std::vector<TraceClaim> claims_;
};

}  // namespace convexact
