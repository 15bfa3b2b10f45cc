// SPDX-License-Identifier: MIT
// words.hpp - what engines, their ends, what parts them and verdicts are called, in JSON and in
// tables.
#pragma once
#include "convexact/oracle/divergence.hpp"
#include "convexact/oracle/judge_trace.hpp"

namespace convexact::words {

inline const char* name_of(Engine engine) {
  switch (engine) {
    case Engine::Exact:
      return "exact";
    case Engine::Filtered:
      return "filtered";
    case Engine::Float:
      break;
  }
  return "float";
}

inline const char* name_of(StopReason reason) {
  switch (reason) {
    case StopReason::Reached:
      return "reached";
    case StopReason::GrowthLimit:
      return "growth-limit";
    case StopReason::AllUnbounded:
      break;
  }
  return "all-unbounded";
}

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
