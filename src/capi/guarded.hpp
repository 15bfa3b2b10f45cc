// SPDX-License-Identifier: MIT
// guarded.hpp - the boundary that no exception crosses.
#pragma once
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

/// CONVEXACT_OK, or the status of the exception that ends `work`.
template <class Work>
convexact_status status_of_call(const Work& work) noexcept {
  try {
    work();
    return CONVEXACT_OK;
  } catch (const Error& error) {
    return status_of(error.code());
  } catch (const std::bad_alloc&) {
    return CONVEXACT_OUT_OF_MEMORY;
  } catch (...) {
    return CONVEXACT_INTERNAL;
  }
}

/// Sets *result to the new object that `make` returns, or to null.
template <class Result, class Make>
convexact_status guarded(Result** result, const Make& make) noexcept {
  if (result == nullptr) return CONVEXACT_INVALID_ARGUMENT;
  *result = nullptr;
  return status_of_call([&] { *result = new Result(make()); });
}

}  // namespace convexact::capi
