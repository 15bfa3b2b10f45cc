// SPDX-License-Identifier: MIT
// Entry point of every doctest executable.
#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#ifdef CONVEXACT_LIMB_POOL
#include "limb_pool.hpp"
#endif

int main(int argc, char** argv) {
#ifdef CONVEXACT_LIMB_POOL
  pool_limbs();
#endif
  doctest::Context context;
#ifdef CONVEXACT_SANITIZED
  context.addFilter("test-suite-exclude", "sweep");
#endif
  context.applyCommandLine(argc, argv);
  return context.run();
}
