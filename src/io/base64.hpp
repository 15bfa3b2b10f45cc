// SPDX-License-Identifier: MIT
// base64.hpp - bytes as text, in base64 [RFC 4648, sec. 4].
#pragma once
#include <string>
#include <string_view>

namespace convexact {

/// The bytes up to the first '='. @throws Error Malformed for a character that is no digit.
[[nodiscard]] std::string from_base64(std::string_view text);

/// Its inverse, padded with '=' to a multiple of four digits.
[[nodiscard]] std::string to_base64(std::string_view bytes);

}  // namespace convexact
