// SPDX-License-Identifier: MIT
// words.hpp - what engines, their ends and what parts them are called, in JSON and in tables.
#pragma once
#include "convexact/oracle/divergence.hpp"

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

}  // namespace convexact::words
