// SPDX-License-Identifier: MIT
// words.hpp - what the ends of a run are called, in JSON and in tables.
#pragma once
#include "convexact/run.hpp"

namespace convexact::words {

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

}  // namespace convexact::words
