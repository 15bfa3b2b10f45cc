// SPDX-License-Identifier: MIT
// fuzz_input.hpp - turns the bytes of a fuzzer into choices, so that it can learn their effect.
#pragma once
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "convexact/geometry.hpp"

/// Consumes the input from the front; at its end every choice is 0.
class FuzzInput {
 public:
  FuzzInput(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

  bool empty() const { return size_ == 0; }

  std::uint8_t byte() {
    if (size_ == 0) return 0;
    --size_;
    return *data_++;
  }

  /// A choice in [0, count), 1 <= count <= 65536; nearly uniform.
  std::size_t below(std::size_t count) {
    const std::size_t low = byte();
    return (count <= 256 ? low : low + 256 * std::size_t(byte())) % count;
  }

  /// One byte in 64: for shapes so large that checking them by definition takes long.
  bool rarely() { return below(64) == 63; }

  /// Any finite double, subnormal and huge ones too.
  double finite_double() {
    std::uint64_t bits = 0;
    for (int k = 0; k < 8; ++k) bits = bits << 8 | byte();
    const double x = std::bit_cast<double>(bits);
    return std::isfinite(x) ? x : 1.0;
  }

  /// At most `largest_count` points with integer coordinates, |x| <= largest_coordinate: repeats
  /// and coplanar points are common. Ends with the input.
  std::vector<convexact::Point> grid_points(std::size_t largest_count, int largest_coordinate) {
    std::vector<convexact::Point> points;
    const std::size_t count = below(largest_count + 1);
    while (points.size() < count && !empty()) {
      convexact::Point point;
      for (double& x : point) {
        x = static_cast<int>(below(static_cast<std::size_t>(2 * largest_coordinate + 1))) -
            largest_coordinate;
      }
      points.push_back(point);
    }
    return points;
  }

  /// The bytes that have not been consumed.
  std::string_view rest() const { return {reinterpret_cast<const char*>(data_), size_}; }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
};
