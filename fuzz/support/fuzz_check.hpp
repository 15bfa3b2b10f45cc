// SPDX-License-Identifier: MIT
// fuzz_check.hpp - a property that must hold for every input; on failure the process ends by abort,
// which the fuzzer reports with the input that caused it.
#pragma once
#include <cstdio>
#include <cstdlib>

#define FUZZ_CHECK(condition)                                                                    \
  ((condition) ? void(0)                                                                         \
               : (std::fprintf(stderr, "%s:%d: violated: %s\n", __FILE__, __LINE__, #condition), \
                  std::abort()))
