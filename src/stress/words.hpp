// SPDX-License-Identifier: MIT
// words.hpp - what the ends and forms of a stress run are called, in JSON and in tables.
#pragma once
#include "scene/result_json.hpp"
#include "stress/stress_result.hpp"

namespace convexact::words {

using convexact::name_of;

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
