// SPDX-License-Identifier: MIT
#include "limb_pool.hpp"

#include <gmp.h>
#include <sanitizer/asan_interface.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <tuple>
#include <utility>
#include <vector>

namespace {

constexpr std::size_t kWord = sizeof(mp_limb_t);

// A thread's free blocks of 0, 1, 2, ... words.
using FreeBlocks = std::array<std::vector<void*>, 64>;

// Null before a thread's first block and after its last object: numbers may outlive any object.
thread_local FreeBlocks* free_blocks = nullptr;

struct EndOfThread {
  ~EndOfThread() {
    for (std::size_t words = 0; words < free_blocks->size(); ++words) {
      for (void* const block : (*free_blocks)[words]) {
        ASAN_UNPOISON_MEMORY_REGION(block, words * kWord);
        std::free(block);
      }
    }
    delete std::exchange(free_blocks, nullptr);
  }
};

bool is_pooled(std::size_t size) {
  if (size % kWord != 0 || size / kWord >= std::tuple_size_v<FreeBlocks>) return false;
  if (free_blocks == nullptr) {
    thread_local bool has_begun = false;
    if (has_begun) return false;
    has_begun = true;
    free_blocks = new FreeBlocks;
    thread_local const EndOfThread end;
  }
  return true;
}

void* allocate(std::size_t size) {
  if (is_pooled(size)) {
    std::vector<void*>& blocks = (*free_blocks)[size / kWord];
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
  if (__asan_address_is_poisoned(block)) {
    std::fprintf(stderr, "a number's memory is freed twice\n");
    std::abort();
  }
  (*free_blocks)[size / kWord].push_back(block);
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
