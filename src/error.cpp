// SPDX-License-Identifier: MIT
#include "convexact/error.hpp"

namespace convexact {
namespace {
std::string located(const std::string& file, const std::string& message,
                    std::optional<std::size_t> line) {
  std::string place = file;
  if (line) place += (file.empty() ? "line " : ":") + std::to_string(*line);
  return place.empty() ? message : place + ": " + message;
}
}  // namespace

Error::Error(ErrorCode code, const std::string& message, std::optional<std::size_t> line)
    : Error(code, "", message, line) {}

Error::Error(ErrorCode code, const std::string& file, const std::string& message,
             std::optional<std::size_t> line)
    : std::runtime_error(located(file, message, line)),
      code_(code),
      message_(message),
      line_(line) {}

Error Error::in_file(const std::string& file) const { return {code_, file, message_, line_}; }

int exit_code(ErrorCode code) noexcept {
  switch (code) {
    case ErrorCode::InvalidArgument:
      return 2;
    case ErrorCode::Unreadable:
    case ErrorCode::Malformed:
    case ErrorCode::NotFinite:
      return 3;
    case ErrorCode::NoInterior:
      return 4;
    case ErrorCode::Unwritable:
    case ErrorCode::Unrepresentable:
      return 5;
    case ErrorCode::Stopped:
      return 6;
    case ErrorCode::Internal:
      break;
  }
  return 70;
}

void reject_argument(const std::string& why) { throw Error(ErrorCode::InvalidArgument, why); }

namespace detail {
void assertion_failed(const char* condition, const char* file, int line) {
  throw Error(ErrorCode::Internal, std::string("invariant broken: ") + condition + " (" + file +
                                       ":" + std::to_string(line) + ")");
}
}  // namespace detail

}  // namespace convexact
