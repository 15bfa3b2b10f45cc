// SPDX-License-Identifier: MIT
// Square classes, judged by the definition: two integers are in one class if their product is a
// square.
#include "number/square_classes.hpp"

#include <doctest/doctest.h>

#include <vector>

#include "property.hpp"
using namespace convexact;

namespace {

bool is_square(const Integer& n) {
  const Integer root = sqrt(n);
  return root * root == n;
}

// What must hold whatever the numbers are.
bool is_right(const std::vector<Integer>& numbers, const SquareClasses& classes) {
  if (classes.members.size() != numbers.size() || classes.representatives[0] != 1) return false;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto& [index, multiple] = classes.members[i];
    if (numbers[i] != multiple * multiple * classes.representatives[index]) return false;
    for (std::size_t k = 0; k < i; ++k) {
      const bool is_one_class = is_square(numbers[i] * numbers[k]);
      if (is_one_class != (index == classes.members[k].index)) return false;
    }
  }
  return true;
}

}  // namespace

TEST_CASE("square_classes: all pairs of small integers") {
  std::vector<Integer> numbers;
  for (int n = 1; n <= 600; ++n) numbers.emplace_back(n);
  CHECK(is_right(numbers, square_classes(numbers)));
}

TEST_CASE("square_classes: none for no numbers but that of the squares") {
  const SquareClasses classes = square_classes({});
  CHECK(classes.representatives == std::vector<Integer>{1});
  CHECK(classes.members.empty());
}

TEST_CASE("square_classes: a prime that divides a number tells nothing about its class") {
  // 7 divides 3 * 49 and not 3; 139 is beyond all primes whose residues are taken.
  const std::vector<Integer> numbers{3 * 49, 3, 3 * 139 * 139, 7, 139};
  const SquareClasses classes = square_classes(numbers);
  CHECK(classes.members[0].index == classes.members[1].index);
  CHECK(classes.members[0].index == classes.members[2].index);
  CHECK(classes.representatives[classes.members[0].index] == 3);
  CHECK(classes.members[0].multiple == 7);
  CHECK(is_right(numbers, classes));
}

TEST_CASE("square_classes: long numbers that no one factors") {
  check_property("classes", [](std::uint64_t p, std::uint64_t q, std::uint64_t r) {
    const Integer a = Integer(p) + 1, b = Integer(q) + 1, c = Integer(r) + 1;
    const std::vector<Integer> numbers{a * b * b, a * c * c,    a, b * c, b * c * a * a,
                                       b * c * a, a * a * b * b};
    RC_ASSERT(is_right(numbers, square_classes(numbers)));
  });
}
