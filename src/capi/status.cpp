// SPDX-License-Identifier: MIT
#include <string>

#include "capi/guarded.hpp"

namespace convexact::capi {
namespace {

thread_local std::string last_message;

}  // namespace

void keep_message(const char* text) noexcept {
  try {
    last_message = text;
  } catch (...) {  // No memory for it: a stale sentence would mislead.
    last_message.clear();
  }
}

}  // namespace convexact::capi

const char* convexact_message(void) { return convexact::capi::last_message.c_str(); }

const char* convexact_status_text(int status) {
  switch (status) {
    case CONVEXACT_OK:
      return "done";
    case CONVEXACT_INVALID_ARGUMENT:
      return "an argument is invalid: a null pointer, a count of 0, a face of fewer than 3 "
             "corners, a corner that is not the index of a vertex, or an option that does not "
             "exist or has no such value";
    case CONVEXACT_NOT_FINITE:
      return "a number is NaN or infinite";
    case CONVEXACT_NO_INTERIOR:
      return "the points lie in one plane";
    case CONVEXACT_UNREPRESENTABLE:
      return "doubles cannot hold the result";
    case CONVEXACT_OUT_OF_MEMORY:
      return "out of memory";
    case CONVEXACT_INTERNAL:
      return "a verification of convexact failed: this is a bug, please report it";
  }
  return "no such status";
}

const char* convexact_version(void) { return CONVEXACT_VERSION; }
