// SPDX-License-Identifier: MIT
// Entry point of every doctest executable.
#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

int main(int argc, char** argv) {
  doctest::Context context;
#ifdef CONVEXACT_SANITIZED
  context.addFilter("test-suite-exclude", "sweep");
#endif
  context.applyCommandLine(argc, argv);
  return context.run();
}
