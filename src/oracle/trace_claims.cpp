// SPDX-License-Identifier: MIT
#include "oracle/trace_claims.hpp"

namespace convexact {

TraceClaims::TraceClaims() {
  claims_ = {{"trace-readable"},
             {"trace-plane-unknown"},
             {"trace-id-out-of-range"},
             {"trace-removed-twice"},
             {"trace-bounded"},
             {"trace-greedy"},
             {"trace-cost", Status::NotAsked},
             {"trace-ties", Status::NotAsked},
             {"trace-left", Status::NotAsked},
             {"trace-stop", Status::NotAsked}};
}

void TraceClaims::violate(TraceCode code, TraceWitness witness) {
  TraceClaim& claim = at(code);
  if (claim.status == Status::Violated) return;
  claim.status = Status::Violated;
  claim.witness = std::move(witness);
}

void TraceClaims::ask(TraceCode code) {
  TraceClaim& claim = at(code);
  if (claim.status == Status::NotAsked) claim.status = Status::Holds;
}

void TraceClaims::give_up() {
  for (TraceClaim& claim : claims_) {
    if (claim.status == Status::Holds) claim.status = Status::NotAsked;
  }
}

}  // namespace convexact
