// SPDX-License-Identifier: MIT
#include "limb_pool.hpp"

#include <gmp.h>
#include <sanitizer/asan_interface.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <vector>

namespace {

constexpr std::size_t kWord = sizeof(mp_limb_t);

// Free blocks of 0, 1, 2, ... words. Never destroyed, as GMP's numbers may outlive any object.
std::array<std::vector<void*>, 64>& free_blocks() {
  static auto* const blocks = new std::array<std::vector<void*>, 64>;
  return *blocks;
}

bool is_pooled(std::size_t size) { return size % kWord == 0 && size / kWord < 64; }

void* allocate(std::size_t size) {
  if (is_pooled(size)) {
    std::vector<void*>& blocks = free_blocks()[size / kWord];
    if (!blocks.empty()) {
      void* const block = blocks.back();
      blocks.pop_back();
      ASAN_UNPOISON_MEMORY_REGION(block, size);
      return block;
    }
  }
  void* const block = std::malloc(size);
  if (block == nullptr) std::abort();
  return block;
}

void release(void* block, std::size_t size) {
  if (!is_pooled(size)) return std::free(block);
  free_blocks()[size / kWord].push_back(block);
  ASAN_POISON_MEMORY_REGION(block, size);
}

void* reallocate(void* block, std::size_t old_size, std::size_t new_size) {
  if (old_size == new_size) return block;
  void* const moved = allocate(new_size);
  std::memcpy(moved, block, old_size < new_size ? old_size : new_size);
  release(block, old_size);
  return moved;
}

}  // namespace

void pool_limbs() { mp_set_memory_functions(allocate, reallocate, release); }
