// SPDX-License-Identifier: MIT
// Stands for the tests of a package that is not installed.
#include <cstdio>

int main() {
  std::puts("skipped: " CONVEXACT_MISSING);
  return 77;
}
