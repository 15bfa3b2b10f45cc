// SPDX-License-Identifier: MIT
// guarded.hpp - the boundary that no exception crosses.
#pragma once
#include <memory>
#include <new>

#include "convexact.h"
#include "convexact/error.hpp"

namespace convexact::capi {

inline convexact_status status_of(ErrorCode code) {
  switch (code) {
    case ErrorCode::InvalidArgument:
      return CONVEXACT_INVALID_ARGUMENT;
    case ErrorCode::NotFinite:
      return CONVEXACT_NOT_FINITE;
    case ErrorCode::NoInterior:
      return CONVEXACT_NO_INTERIOR;
    case ErrorCode::Unrepresentable:
      return CONVEXACT_UNREPRESENTABLE;
    case ErrorCode::Stopped:
      return CONVEXACT_OUT_OF_MEMORY;
    case ErrorCode::Unreadable:
    case ErrorCode::Malformed:
    case ErrorCode::Unwritable:
    case ErrorCode::Internal:
      break;
  }
  return CONVEXACT_INTERNAL;
}

/// Keeps the sentence on a failure for this thread: convexact_message().
void keep_message(const char* text) noexcept;

/// CONVEXACT_OK, or the status of the exception that ends `work`, whose sentence is kept.
template <class Work>
convexact_status status_of_call(const Work& work) noexcept {
  try {
    work();
    return CONVEXACT_OK;
  } catch (const Error& error) {
    keep_message(error.what());
    return status_of(error.code());
  } catch (const std::bad_alloc&) {
    keep_message(convexact_status_text(CONVEXACT_OUT_OF_MEMORY));
    return CONVEXACT_OUT_OF_MEMORY;
  } catch (...) {
    keep_message(convexact_status_text(CONVEXACT_INTERNAL));
    return CONVEXACT_INTERNAL;
  }
}

/// Sets *result to the new object that `make` returns, or to null.
template <class Result, class Make>
convexact_status guarded(Result** result, const Make& make) noexcept {
  if (result != nullptr) *result = nullptr;
  return status_of_call([&] {
    if (result == nullptr) reject_argument("the place for the result is missing");
    *result = std::make_unique<Result>(make()).release();
  });
}

}  // namespace convexact::capi
