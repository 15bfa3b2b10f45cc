// SPDX-License-Identifier: MIT
// words.hpp - what engines, their ends, what parts them and verdicts are called, in JSON and in
// tables.
#pragma once
#include "convexact/oracle/divergence.hpp"
#include "convexact/oracle/judge_trace.hpp"
#include "convexact/oracle/stress_result.hpp"

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

inline const char* name_of(StressEnd end) {
  switch (end) {
    case StressEnd::Reached:
      return "reached";
    case StressEnd::AllUnbounded:
      return "all-unbounded";
    case StressEnd::NoVolume:
      return "no-volume";
    case StressEnd::Crashed:
      return "crashed";
    case StressEnd::TimedOut:
      return "timed-out";
    case StressEnd::OutOfMemory:
      return "out-of-memory";
    case StressEnd::Failed:
      break;
  }
  return "failed";
}

inline const char* name_of(StressStored::Form form) {
  return form == StressStored::Form::Planes ? "planes" : "mesh";
}

inline const char* name_of(StressStored::Outcome outcome) {
  switch (outcome) {
    case StressStored::Outcome::Holds:
      return "holds";
    case StressStored::Outcome::Refused:
      return "refused";
    case StressStored::Outcome::Wrong:
      break;
  }
  return "wrong";
}

}  // namespace convexact::words
