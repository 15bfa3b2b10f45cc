// SPDX-License-Identifier: MIT
// allocation_watch.hpp - counts allocations, and records the size of the largest; link
// allocation_watch.cpp in.
#pragma once
#include <cstddef>

/// Bytes of the largest allocation since it was last set to 0.
extern std::size_t largest_allocation;
/// Calls of the allocation functions since the program started.
extern std::size_t allocation_count;
