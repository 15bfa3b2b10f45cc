// SPDX-License-Identifier: MIT
#include "convexact/format/error_json.hpp"

#include <nlohmann/json.hpp>

namespace convexact {
namespace {

const char* name_of(ErrorCode code) {
  switch (code) {
    case ErrorCode::InvalidArgument:
      return "invalid-argument";
    case ErrorCode::Unreadable:
      return "unreadable";
    case ErrorCode::Malformed:
      return "malformed";
    case ErrorCode::NotFinite:
      return "not-finite";
    case ErrorCode::NoInterior:
      return "no-interior";
    case ErrorCode::Unwritable:
      return "unwritable";
    case ErrorCode::Unrepresentable:
      return "unrepresentable";
    case ErrorCode::Stopped:
      return "stopped";
    case ErrorCode::Internal:
      break;
  }
  return "internal";
}

}  // namespace

nlohmann::ordered_json error_json(const Error& error) {
  nlohmann::ordered_json json = {{"code", name_of(error.code())},
                                 {"message", error.what()},
                                 {"exit", exit_code(error.code())}};
  if (error.line()) json["line"] = *error.line();
  return json;
}

}  // namespace convexact
