// SPDX-License-Identifier: MIT
// exact.hpp - the basic types of the checker: GMP's numbers, planes, points, and failures.
//
// A plane (n, d) is the halfspace {x : n.x + d <= 0}. A point is (x, y, z, w), w > 0, in
// homogeneous integers. dot() of the two is negative inside, zero on the plane, positive outside.
#pragma once
#include <gmpxx.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <string>

namespace check {

using Integer = mpz_class;
using Rational = mpq_class;
using Numbers = std::array<Rational, 4>;
using Row = std::array<Integer, 4>;

struct Failure {
  int exit_code;
  std::string what;
  std::string where = {};  // a line of the proof, or a place in the mesh file
};
inline void require(bool holds, const std::string& otherwise) {
  if (!holds) throw Failure{1, "not proven: " + otherwise};
}
inline void expect(bool holds, const std::string& what) {
  if (!holds) throw Failure{3, "malformed: expected " + what};
}

// GMP ends the process by abort() if memory is short, and no exception may pass through it.
[[noreturn]] inline void end_out_of_memory() {
  std::fputs("convexact-check: out of memory: nothing is decided\n", stderr);
  std::_Exit(6);
}
inline void* or_end(void* block) {
  if (block == nullptr) end_out_of_memory();
  return block;
}
inline void end_if_memory_is_short() {
  std::set_new_handler(end_out_of_memory);
  mp_set_memory_functions(
      [](std::size_t size) { return or_end(std::malloc(size)); },
      [](void* block, std::size_t, std::size_t size) { return or_end(std::realloc(block, size)); },
      nullptr);
}

// The dot product of two normals.
inline Integer dot3(const Row& a, const Row& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Integer dot(const Row& a, const Row& b) { return dot3(a, b) + a[3] * b[3]; }
// The determinant of three columns of three rows: by default of three normals.
inline Integer det(const Row& a, const Row& b, const Row& c, int i = 0, int j = 1, int k = 2) {
  return a[i] * (b[j] * c[k] - b[k] * c[j]) - a[j] * (b[i] * c[k] - b[k] * c[i]) +
         a[k] * (b[i] * c[j] - b[j] * c[i]);
}
// The point on three planes, w the determinant of their normals; or the plane through three points.
inline Row meet(const Row& a, const Row& b, const Row& c) {
  return {-det(a, b, c, 1, 2, 3), det(a, b, c, 0, 2, 3), -det(a, b, c, 0, 1, 3), det(a, b, c)};
}

inline Rational quotient(const Integer& above, const Integer& below) {
  Rational value(above, below);
  value.canonicalize();
  return value;
}
inline Rational power_of_two(long e) {
  const auto size = static_cast<unsigned long>(std::labs(e));
  return e < 0 ? Rational(Rational(1) >> size) : Rational(Rational(1) << size);
}
// Numbers times their common denominator: a point has only one such form.
inline Row scaled(const Numbers& x) {
  const Integer w = lcm(lcm(x[0].get_den(), x[1].get_den()), lcm(x[2].get_den(), x[3].get_den()));
  return {Integer(x[0] * w), Integer(x[1] * w), Integer(x[2] * w), Integer(x[3] * w)};
}
// A plane without a common factor: its only such form.
inline Row primitive(Row plane) {
  const Integer common = gcd(gcd(plane[0], plane[1]), gcd(plane[2], plane[3]));
  for (Integer& x : plane) x /= common;
  return plane;
}

inline Rational squared_distance(const Row& p, const Row& q) {
  Rational sum = 0;
  for (int k = 0; k < 3; ++k) {
    const Rational x = quotient(p[k] * q[3] - q[k] * p[3], p[3] * q[3]);
    sum += x * x;
  }
  return sum;
}
// The square root of a positive number, rounded up to two digits: "1.5e-3".
inline std::string root_from_above(const Rational& square) {
  const auto digits = [](const Integer& x) { return long(mpz_sizeinbase(x.get_mpz_t(), 10)); };
  long e = (digits(square.get_num()) - digits(square.get_den())) / 2 - 3;
  for (;; ++e) {  // the first e for which the root is at most 99 units of 10^(e - 1)
    Integer power;
    mpz_ui_pow_ui(power.get_mpz_t(), 100, static_cast<unsigned long>(std::labs(e - 1)));
    const Rational square_in_units = e > 1 ? Rational(square / power) : Rational(square * power);
    Integer units = sqrt(Integer(square_in_units.get_num() / square_in_units.get_den()));
    if (units * units < square_in_units) ++units;
    if (units >= 100) continue;
    const std::string text = units.get_str();
    return text.substr(0, 1) + "." + text.substr(1) + "e" + std::to_string(e);
  }
}

}  // namespace check
