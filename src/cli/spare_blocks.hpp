// SPDX-License-Identifier: MIT
// spare_blocks.hpp - small blocks of memory that were given back and are soon asked for again.
#pragma once
#include <array>
#include <cstddef>
#include <cstdlib>
#include <new>
#include <utility>

namespace convexact::cli {

/// Lists of blocks from malloc, by size. Exact arithmetic makes and drops short numbers all the
/// time, far more of a size than the seven that glibc keeps at hand, and beyond these its search
/// takes a sixth of a run. One object serves one thread.
///
/// Nothing runs when an object ends, so that numbers which end later may still use it: close() is
/// to be called while the thread lives.
class SpareBlocks {
 public:
  static constexpr std::size_t kLargest = 128;  ///< Bytes.

  /// What to ask malloc for, so that the block can serve every size of its list.
  static constexpr std::size_t rounded(std::size_t size) { return (list_of(size) + 1) * kStep; }
  /// Whether a block for one size, as rounded, serves the other.
  static constexpr bool are_alike(std::size_t size, std::size_t other) {
    return size <= kLargest && other <= kLargest && list_of(size) == list_of(other);
  }

  /// A block of at least that size, 1 to kLargest; null if there is none to spare.
  void* take(std::size_t size) {
    List& list = lists_[list_of(size)];
    if (list.first == nullptr) return nullptr;
    --list.length;
    return std::exchange(list.first, list.first->next);
  }
  /// Keeps a block that was asked for with that size, 1 to kLargest. False if there are enough of
  /// them, or the lists are closed: then it is the caller's to free.
  [[nodiscard]] bool keep(void* block, std::size_t size) {
    List& list = lists_[list_of(size)];
    if (is_closed_ || list.length == kMost) return false;
    ++list.length;
    list.first = new (block) Block{list.first};
    return true;
  }
  /// Frees all that are kept, and keeps no more.
  void close() {
    is_closed_ = true;
    for (List& list : lists_) {
      while (list.first != nullptr) std::free(std::exchange(list.first, list.first->next));
    }
  }

 private:
  static constexpr std::size_t kStep = 16;
  // The lists of a thread stay within 150 kB, and within its cache.
  static constexpr std::size_t kMost = 256;

  struct Block {
    Block* next;
  };
  struct List {
    Block* first;
    std::size_t length;
  };
  static constexpr std::size_t list_of(std::size_t size) { return (size - 1) / kStep; }

  std::array<List, kLargest / kStep> lists_{};
  bool is_closed_ = false;
};

}  // namespace convexact::cli
