// SPDX-License-Identifier: MIT
// Replaces the global allocation functions of the executable that it is linked into.
#include "allocation_watch.hpp"

#include <algorithm>
#include <cstdlib>
#include <new>

std::size_t largest_allocation = 0, allocation_count = 0;

void* operator new(std::size_t size) {
  largest_allocation = std::max(largest_allocation, size);
  ++allocation_count;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
