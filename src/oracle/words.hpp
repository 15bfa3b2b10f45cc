// SPDX-License-Identifier: MIT
// words.hpp - what divergences and ratings are called, in JSON and in tables.
#pragma once
#include "convexact/verify_run.hpp"
#include "oracle/divergence.hpp"
#include "scene/words.hpp"

namespace convexact::words {

inline const char* name_of(DivergenceKind kind) {
  switch (kind) {
    case DivergenceKind::Tie:
      return "tie";
    case DivergenceKind::BelowRounding:
      return "gap-below-rounding";
    case DivergenceKind::WrongTopology:
      return "wrong-topology";
    case DivergenceKind::WrongBoundedness:
      return "wrong-boundedness";
    case DivergenceKind::WrongRecord:
      break;
  }
  return "wrong-record";
}

inline const char* name_of(TraceRating rating) {
  switch (rating) {
    case TraceRating::Greedy:
      return "greedy";
    case TraceRating::UpToRegret:
      return "up-to-regret";
    case TraceRating::NotGreedy:
      return "not-greedy";
    case TraceRating::Unbounded:
      return "unbounded";
    case TraceRating::Meaningless:
      break;
  }
  return "meaningless";
}

}  // namespace convexact::words
