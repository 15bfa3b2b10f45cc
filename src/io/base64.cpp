// SPDX-License-Identifier: MIT
#include "io/base64.hpp"

#include <cstdint>

#include "convexact/error.hpp"
#include "number/text.hpp"

namespace convexact {
namespace {

constexpr std::string_view kBase64Digits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

}  // namespace

std::string to_base64(std::string_view bytes) {
  std::string text;
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    std::uint32_t bits = 0;
    for (std::size_t j = k; j < k + 3; ++j) {
      bits = bits << 8 | (j < bytes.size() ? static_cast<unsigned char>(bytes[j]) : 0);
    }
    for (int shift = 18; shift >= 0; shift -= 6) text += kBase64Digits[bits >> shift & 63];
  }
  // The digits that hold no bit of the bytes.
  for (std::size_t left = (3 - bytes.size() % 3) % 3; left > 0; --left) {
    text[text.size() - left] = '=';
  }
  return text;
}

std::string from_base64(std::string_view text) {
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    if (c == '=') break;
    const std::size_t digit = kBase64Digits.find(c);
    if (digit == std::string_view::npos) {
      throw Error(ErrorCode::Malformed, "expected base64, found " + in_quotes(text));
    }
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    count += 6;
    if (count >= 8) bytes += static_cast<char>(bits >> (count -= 8) & 0xFF);
  }
  return bytes;
}

}  // namespace convexact
