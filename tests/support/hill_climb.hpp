// SPDX-License-Identifier: MIT
// hill_climb.hpp - looks for the doubles at which an error bound is closest to being broken.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "convexact/number.hpp"
#include "number/random.hpp"

namespace hill_climb {

using convexact::Random;
using convexact::Rational;

inline double random_sign(Random& random) {
  return convexact::uniform_below(random, 2) == 0 ? -1 : 1;
}

/// Numbers in [-1, 1] to start from: near corners of the cube, where rounding errors are largest,
/// or in a cluster of a random size.
inline std::vector<double> start(std::size_t count, Random& random) {
  std::vector<double> x(count);
  const double size = std::ldexp(1.0, -static_cast<int>(convexact::uniform_below(random, 30)));
  const bool is_cluster = convexact::uniform_below(random, 2) == 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double off = convexact::uniform_unit(random) / 8;
    x[k] = is_cluster ? 1 - size * (random_sign(random) + 1) / 2 - size * off
                      : random_sign(random) * (1 - off);
  }
  return x;
}

/// Changes one number a little, or flips its sign. The result stays in [-1, 1].
inline void mutate(std::vector<double>& x, Random& random) {
  double& one = x[convexact::uniform_below(random, x.size())];
  const auto scale = static_cast<int>(convexact::uniform_below(random, 54));
  one += std::ldexp(convexact::uniform_unit(random) - 0.5, -scale);
  if (convexact::uniform_below(random, 16) == 0) one = -one;
  one = std::clamp(one, -1.0, 1.0);
}

/// The largest value of `ratio` found by some climbs with `tries` tries each.
template <class Ratio>
double highest(std::size_t count, int climbs, int tries, std::uint64_t seed, const Ratio& ratio) {
  Random random(seed);
  double highest = 0;
  for (int c = 0; c < climbs; ++c) {
    std::vector<double> best = start(count, random);
    double value = ratio(best);
    for (int t = 0; t < tries; ++t) {
      std::vector<double> next = best;
      mutate(next, random);
      const double changed = ratio(next);
      if (!(changed >= value)) continue;
      value = changed;
      best = std::move(next);
    }
    highest = std::max(highest, value);
  }
  return highest;
}

/// For a function that is affine in each of its arguments: the largest |computed - f(q)| over all q
/// with |q_k - x_k| <= error |x_k|, to first order in the error; it is attained exactly at some
/// such q.
/// @param f  From a vector of Rational.
template <class Function>
Rational worst_distance(const Rational& computed, const std::vector<Rational>& x,
                        const Rational& error, const Function& f) {
  const Rational at_x = f(x);
  std::vector<int> slope;  // the sign of x_k df/dx_k
  for (std::size_t k = 0; k < x.size(); ++k) {
    std::vector<Rational> without = x;
    without[k] = 0;
    slope.push_back(Rational(at_x - f(without)).sign());
  }
  Rational worst = 0;
  for (const int direction : {-1, 1}) {
    std::vector<Rational> q = x;
    for (std::size_t k = 0; k < x.size(); ++k) q[k] *= 1 + direction * slope[k] * error;
    worst = std::max(worst, Rational(abs(Rational(computed - f(q)))));
  }
  return worst;
}

}  // namespace hill_climb
