// SPDX-License-Identifier: MIT
// hard_numbers.hpp - coordinates whose products cancel: few bits, few ulps apart, far apart in
// size.
#pragma once
#include <cmath>
#include <limits>

#include "convexact/geometry.hpp"
#include "fuzz_input.hpp"

/// One kind of number for a whole input, chosen by its first byte.
class HardNumbers {
 public:
  explicit HardNumbers(FuzzInput& in) : in_(in), kind_(in.below(6)) {
    if (kind_ == 2 || kind_ == 3) exponent_ = static_cast<int>(in.below(2100)) - 1075;
  }

  double next() {
    constexpr double kUlp = std::numeric_limits<double>::epsilon();
    switch (kind_) {
      case 0:  // small integers: exact zeros
        return integer(4);
      case 1:  // 1 and its nearest neighbors
        return 1 + integer(4) * kUlp;
      case 2:  // small integers at any scale, down to subnormals
        return finite(std::ldexp(integer(4), exponent_));
      case 3:  // small integers times one number of many bits, an ulp off or not
        return finite(std::ldexp(integer(4) / 3 * (1 + integer(1) * kUlp), exponent_));
      case 4:  // a small integer with a tail far below
        return integer(4) + std::ldexp(integer(1), -static_cast<int>(in_.below(80)));
      default:
        return in_.finite_double();
    }
  }
  convexact::Point point() {
    convexact::Point p;
    for (double& x : p) x = next();
    return p;
  }

 private:
  double integer(int largest) {
    return static_cast<int>(in_.below(static_cast<std::size_t>(2 * largest + 1))) - largest;
  }
  static double finite(double x) { return std::isfinite(x) ? x : 1.0; }

  FuzzInput& in_;
  std::size_t kind_;
  int exponent_ = 0;
};
