// SPDX-License-Identifier: MIT
// output_buffer.hpp - builds the bytes of a file: text with shortest decimals, or little-endian.
#pragma once
#include <bit>
#include <charconv>
#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>

namespace convexact {

class OutputBuffer {
 public:
  OutputBuffer& text(std::string_view piece) {
    bytes_ += piece;
    return *this;
  }
  OutputBuffer& number(std::integral auto value) { return digits(value); }
  /// The shortest decimal whose nearest double is `value`.
  OutputBuffer& number(double value) { return digits(value); }

  template <std::unsigned_integral T>
  OutputBuffer& little_endian(T value) {
    for (std::size_t k = 0; k < sizeof(T); ++k) {
      bytes_ += static_cast<char>(static_cast<unsigned char>(value >> (8 * k)));
    }
    return *this;
  }
  OutputBuffer& little_endian(float value) {
    return little_endian(std::bit_cast<std::uint32_t>(value));
  }
  OutputBuffer& little_endian(double value) {
    return little_endian(std::bit_cast<std::uint64_t>(value));
  }

  std::string finish() { return std::move(bytes_); }

 private:
  OutputBuffer& digits(auto value) {
    char buffer[32];  // the longest: -1.7976931348623157e+308
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
    bytes_.append(buffer, end);
    return *this;
  }

  std::string bytes_;
};

}  // namespace convexact
