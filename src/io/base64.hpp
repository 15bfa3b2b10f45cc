// SPDX-License-Identifier: MIT
// base64.hpp - bytes from base64 [RFC 4648, sec. 4].
#pragma once
#include <string>
#include <string_view>

namespace convexact {

/// The bytes up to the first '='. @throws Error Malformed for a character that is no digit.
[[nodiscard]] std::string from_base64(std::string_view text);

}  // namespace convexact
