// SPDX-License-Identifier: MIT
// The entry point of libFuzzer and AFL++; the environment variable FUZZ_TARGET names the target.
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "fuzz_target.hpp"
#include "limb_pool.hpp"

namespace {

const FuzzTarget* chosen = nullptr;

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  const char* const name = std::getenv("FUZZ_TARGET");
  if (name != nullptr) chosen = FuzzTarget::find(name);
  if (chosen != nullptr) {
    pool_limbs();
    return 0;
  }
  std::fprintf(stderr, "set FUZZ_TARGET to one of:\n");
  for (const FuzzTarget* target : FuzzTarget::all()) std::fprintf(stderr, "%s\n", target->name);
  std::exit(2);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzInput in(data, size);
  chosen->hold(in);
  return 0;
}
