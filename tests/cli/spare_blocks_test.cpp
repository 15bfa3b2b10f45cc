// SPDX-License-Identifier: MIT
// Blocks that were given back: each serves its own sizes only, each once.
#include "cli/spare_blocks.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <set>

using convexact::cli::SpareBlocks;

namespace {

void* block_for(std::size_t size) { return std::malloc(SpareBlocks::rounded(size)); }

}  // namespace

TEST_CASE("a block is large enough for every size that it may serve") {
  for (std::size_t size = 1; size <= SpareBlocks::kLargest; ++size) {
    CHECK(SpareBlocks::rounded(size) >= size);
    CHECK(SpareBlocks::rounded(size) >= sizeof(void*));
    for (std::size_t other = 1; other <= SpareBlocks::kLargest + 1; ++other) {
      const bool are_alike = SpareBlocks::are_alike(size, other);
      CHECK(are_alike == SpareBlocks::are_alike(other, size));
      if (are_alike) CHECK(SpareBlocks::rounded(size) == SpareBlocks::rounded(other));
    }
  }
}

TEST_CASE("a spare block is taken once, and for alike sizes only") {
  SpareBlocks blocks;
  CHECK(blocks.take(1) == nullptr);
  void* block = block_for(24);
  REQUIRE(blocks.keep(block, 24));
  CHECK(blocks.take(16) == nullptr);
  CHECK(blocks.take(33) == nullptr);
  CHECK(blocks.take(32) == block);
  CHECK(blocks.take(24) == nullptr);
  std::free(block);
}

TEST_CASE("there are never many spare blocks, and they come back each once") {
  SpareBlocks blocks;
  std::set<void*> kept;
  for (;;) {
    void* block = block_for(8);
    if (!blocks.keep(block, 8)) {
      std::free(block);
      break;
    }
    kept.insert(block);
    REQUIRE(kept.size() < 10000);
  }
  std::set<void*> taken;
  while (void* block = blocks.take(8)) {
    CHECK(taken.insert(block).second);
    std::free(block);
  }
  CHECK(taken == kept);
}

TEST_CASE("closed, spare blocks are freed and no more are kept") {
  SpareBlocks blocks;
  REQUIRE(blocks.keep(block_for(8), 8));
  REQUIRE(blocks.keep(block_for(128), 128));
  blocks.close();  // a leak checker sees the two if they were not freed
  CHECK(blocks.take(8) == nullptr);
  CHECK(blocks.take(128) == nullptr);
  void* block = block_for(8);
  CHECK_FALSE(blocks.keep(block, 8));
  std::free(block);
}
