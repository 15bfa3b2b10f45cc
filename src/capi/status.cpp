// SPDX-License-Identifier: MIT
#include "convexact.h"

const char* convexact_status_text(int status) {
  switch (status) {
    case CONVEXACT_OK:
      return "done";
    case CONVEXACT_INVALID_ARGUMENT:
      return "an argument is invalid: a null pointer, a count of 0, fewer than 4 planes, a face of "
             "fewer than 3 corners, a corner that is not the index of a vertex, a malformed "
             "tolerance, no such measure, bits out of range, or an option out of its range";
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
