// SPDX-License-Identifier: MIT
// allocation_watch.hpp - how large the largest single allocation was; link allocation_watch.cpp in.
#pragma once
#include <cstddef>

/// Bytes of the largest allocation since it was last set to 0.
extern std::size_t largest_allocation;
