// SPDX-License-Identifier: MIT
// words.hpp - what engines are called, in JSON and in tables.
#pragma once
#include "convexact/simplify.hpp"
#include "simplify/words.hpp"

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

}  // namespace convexact::words
