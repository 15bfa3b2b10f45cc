// SPDX-License-Identifier: MIT
// Counts and limits memory: for C++ by the operators below, for GMP by its hooks.
#include <gmp.h>
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <limits>
#include <new>
#include <utility>

#include "cli/command.hpp"
#include "cli/spare_blocks.hpp"

namespace convexact::cli {
namespace {

// 0: no limit, and nothing is counted.
std::atomic<std::uint64_t> most_bytes = 0;
// Signed, since memory allocated before the count began is freed later.
std::atomic<std::int64_t> bytes_in_use = 0;
std::function<void()>& last_words() {
  static std::function<void()> words;
  return words;
}

enum class Asker { Cpp, Gmp };

bool is_within(Asker asker, std::size_t size) {
  const std::uint64_t most = most_bytes.load(std::memory_order_relaxed);
  if (most == 0) return true;
  const auto limit = static_cast<std::int64_t>(asker == Asker::Cpp ? most - most / 8 : most);
  const std::int64_t used = bytes_in_use.load(std::memory_order_relaxed);
  return used <= limit && size <= static_cast<std::uint64_t>(limit - used);
}

void count(void* block, int sign) {
  if (most_bytes.load(std::memory_order_relaxed) == 0 || block == nullptr) return;
  bytes_in_use.fetch_add(sign * static_cast<std::int64_t>(malloc_usable_size(block)),
                         std::memory_order_relaxed);
}

[[noreturn]] void end_process() {
  lift_memory_limit();
  if (last_words()) {
    last_words()();
  } else {
    constexpr char kMessage[] = "convexact: out of memory\n";
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, kMessage, std::strlen(kMessage));
  }
  std::_Exit(exit_code(ErrorCode::Stopped));
}

// A sanitizer is to see every block.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSparesBlocks = false;
#elif defined(__has_feature)
constexpr bool kSparesBlocks =
    !__has_feature(address_sanitizer) && !__has_feature(thread_sanitizer);
#else
constexpr bool kSparesBlocks = true;
#endif

// Of each thread, for GMP. Spare blocks count as memory in use.
thread_local SpareBlocks spare_blocks;
struct AtThreadEnd {
  bool is_awaited = false;
  ~AtThreadEnd() { spare_blocks.close(); }
};
thread_local AtThreadEnd at_thread_end;

bool is_small(std::size_t size) {
  return kSparesBlocks && size > 0 && size <= SpareBlocks::kLargest;
}

// Whether a block of that size can serve its list. Those of numbers that were made before the
// functions below were installed may be shorter.
bool is_whole(void* block, std::size_t size) {
  return is_small(size) && malloc_usable_size(block) >= SpareBlocks::rounded(size);
}

void* allocate(std::size_t size) {
  if (is_small(size)) {
    if (void* block = spare_blocks.take(size)) return block;
    size = SpareBlocks::rounded(size);
  }
  void* block = is_within(Asker::Gmp, size) ? std::malloc(size) : nullptr;
  if (block == nullptr) end_process();
  count(block, 1);
  return block;
}

void release(void* block, std::size_t size) {
  if (is_whole(block, size)) {
    at_thread_end.is_awaited = true;  // an object of a thread begins, and so ends, by its first use
    if (spare_blocks.keep(block, size)) return;
  }
  count(block, -1);
  std::free(block);
}

void* reallocate_large(void* old, std::size_t size) {
  if (!is_within(Asker::Gmp, size)) end_process();
  count(old, -1);
  void* block = std::realloc(old, size);
  if (block == nullptr) end_process();
  count(block, 1);
  return block;
}

void* reallocate(void* old, std::size_t old_size, std::size_t size) {
  if (!is_small(old_size) && !is_small(size)) return reallocate_large(old, size);
  if (is_whole(old, old_size) && SpareBlocks::are_alike(old_size, size)) return old;
  void* block = allocate(size);
  std::memcpy(block, old, std::min(old_size, size));
  release(old, old_size);
  return block;
}

}  // namespace

void install_memory_functions() {
  mp_set_memory_functions(allocate, reallocate, release);
#ifdef M_MMAP_THRESHOLD
  // Keeps what is freed, since each page that the system gives anew costs a fault. glibc goes to
  // these thresholds by itself, but only after it freed a block of that size.
  if (mallopt(M_MMAP_THRESHOLD, 32 << 20) == 1) mallopt(M_TRIM_THRESHOLD, 64 << 20);
#endif
}

void limit_memory(std::uint64_t bytes, std::function<void()> words) {
  // Destructors of JSON values allocate, and must not throw: a failure in them ends the run as one
  // in GMP does.
  std::set_terminate([] {
    try {
      if (std::current_exception()) std::rethrow_exception(std::current_exception());
    } catch (const std::bad_alloc&) {
      end_process();
    } catch (...) {
    }
    std::abort();
  });
  last_words() = std::move(words);
  bytes_in_use = 0;
  // The largest signed count, which is more than any machine has.
  most_bytes = std::min<std::uint64_t>(bytes, std::numeric_limits<std::int64_t>::max());
}

void lift_memory_limit() noexcept { most_bytes = 0; }

namespace {

void* allocate_for_cpp(std::size_t size, std::size_t alignment) {
  if (!is_within(Asker::Cpp, size)) throw std::bad_alloc();
  const std::size_t asked = size == 0 ? 1 : size;
  void* block = alignment == 0 ? std::malloc(asked)
                               : std::aligned_alloc(
                                     alignment, (asked + alignment - 1) / alignment * alignment);
  if (block == nullptr) throw std::bad_alloc();
  count(block, 1);
  return block;
}

void release_for_cpp(void* block) noexcept {
  count(block, -1);
  std::free(block);
}

}  // namespace
}  // namespace convexact::cli

// The operators for arrays call these. The ones that do not throw would call them, too, but a
// sanitizer replaces those by its versions while it uses ours for the rest.
void* operator new(std::size_t size) { return convexact::cli::allocate_for_cpp(size, 0); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return convexact::cli::allocate_for_cpp(size, static_cast<std::size_t>(alignment));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  try {
    return convexact::cli::allocate_for_cpp(size, 0);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}
void operator delete(void* block) noexcept { convexact::cli::release_for_cpp(block); }
void operator delete(void* block, std::size_t) noexcept { convexact::cli::release_for_cpp(block); }
void operator delete(void* block, const std::nothrow_t&) noexcept {
  convexact::cli::release_for_cpp(block);
}
void operator delete(void* block, std::align_val_t) noexcept {
  convexact::cli::release_for_cpp(block);
}
void operator delete(void* block, std::size_t, std::align_val_t) noexcept {
  convexact::cli::release_for_cpp(block);
}
