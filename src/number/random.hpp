// SPDX-License-Identifier: MIT
// random.hpp - seeded choices that are the same on every platform.
#pragma once
#include <concepts>
#include <cstdint>
#include <random>
#include <span>
#include <utility>

namespace convexact {

/// The standard fixes this generator's output; it does not fix std::shuffle or any distribution.
using Random = std::mt19937_64;

/// Uniform in [0, n), n >= 1, without bias (rejection). The type of n makes no difference.
template <std::integral Number>
[[nodiscard]] Number uniform_below(Random& random, Number n) {
  const auto count = static_cast<std::uint64_t>(n);
  const std::uint64_t limit = Random::max() - Random::max() % count;  // a multiple of n
  std::uint64_t draw = random();
  while (draw >= limit) draw = random();
  return static_cast<Number>(draw % count);
}

/// Uniform among the multiples of 2^-53 in [0, 1).
[[nodiscard]] inline double uniform_unit(Random& random) {
  return static_cast<double>(random() >> 11) * 0x1p-53;
}

/// Fisher-Yates; every order equally likely.
template <class T>
void shuffle(std::span<T> items, Random& random) {
  for (std::size_t i = items.size(); i > 1; --i) {
    std::swap(items[i - 1], items[uniform_below(random, i)]);
  }
}

}  // namespace convexact
