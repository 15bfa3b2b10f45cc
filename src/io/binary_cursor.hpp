// SPDX-License-Identifier: MIT
// binary_cursor.hpp - reads numbers of either byte order from bytes, on machines of either byte
// order.
#pragma once
#include <bit>
#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>

#include "convexact/error.hpp"

namespace convexact {

enum class ByteOrder { Little, Big };

class BinaryCursor {
 public:
  BinaryCursor(std::string_view bytes, std::size_t offset, ByteOrder order)
      : bytes_(bytes), offset_(offset), order_(order) {}

  std::size_t offset() const { return offset_; }
  std::size_t remaining() const { return bytes_.size() - offset_; }

  /// @pre count <= remaining()
  void skip(std::size_t count) { offset_ += count; }

  /// The next sizeof(T) bytes. @pre sizeof(T) <= remaining()
  template <std::unsigned_integral T>
  T take() {
    T value = 0;
    for (std::size_t k = 0; k < sizeof(T); ++k) {
      const std::size_t place = order_ == ByteOrder::Little ? k : sizeof(T) - 1 - k;
      value |= static_cast<T>(T(static_cast<unsigned char>(bytes_[offset_ + k])) << (8 * place));
    }
    offset_ += sizeof(T);
    return value;
  }
  float take_float() { return std::bit_cast<float>(take<std::uint32_t>()); }
  double take_double() { return std::bit_cast<double>(take<std::uint64_t>()); }

  /// @throws Error always; `message` says what was expected, the byte offset is put in front.
  [[noreturn]] void fail(const std::string& message, ErrorCode code = ErrorCode::Malformed) const {
    throw Error(code, "at byte " + std::to_string(offset_) + ": " + message);
  }

 private:
  std::string_view bytes_;
  std::size_t offset_;
  ByteOrder order_;
};

}  // namespace convexact
