// SPDX-License-Identifier: MIT
// keyed_queue.hpp - a heap of halfspaces, each with a key that may change.
#pragma once
#include <cstdint>
#include <limits>
#include <vector>

#include "convexact/geometry.hpp"

namespace convexact {

/// A binary heap of (key, id), smallest key first, that knows where each id stands.
template <class Key>
class KeyedQueue {
 public:
  explicit KeyedQueue(std::size_t size) : place_(size, kAbsent) {}

  bool empty() const { return heap_.empty(); }
  HalfspaceId top() const { return heap_.front().id; }
  const Key& key(HalfspaceId id) const { return heap_[place_[id.index()]].key; }
  bool contains(HalfspaceId id) const { return place_[id.index()] != kAbsent; }

  /// Adds without order; call make_heap() before anything else.
  void append(HalfspaceId id, const Key& key) {
    place_[id.index()] = static_cast<std::uint32_t>(heap_.size());
    heap_.push_back({key, id});
  }
  void make_heap() {
    for (std::size_t i = heap_.size() / 2; i-- > 0;) sink(i, heap_[i]);
  }
  /// Sets a key, higher or lower.
  void update(HalfspaceId id, const Key& key) { settle(place_[id.index()], {key, id}); }
  void erase(HalfspaceId id) {
    const std::size_t hole = place_[id.index()];
    place_[id.index()] = kAbsent;
    const Entry last = heap_.back();
    heap_.pop_back();
    if (hole < heap_.size()) settle(hole, last);
  }
  /// All ids with a key of at most `limit`, in no order; if there are more than `most`, any most +
  /// 1 of them.
  /// @par Cost  Their number.
  void collect(const Key& limit, std::vector<HalfspaceId>& ids,
               std::size_t most = std::numeric_limits<std::size_t>::max() - 1) {
    ids.clear();
    pending_.assign(1, 0);
    while (!pending_.empty() && ids.size() <= most) {
      const std::size_t i = pending_.back();
      pending_.pop_back();
      if (i >= heap_.size() || !(heap_[i].key <= limit)) continue;
      ids.push_back(heap_[i].id);
      pending_.push_back(2 * i + 1);
      pending_.push_back(2 * i + 2);
    }
  }

 private:
  struct Entry {
    Key key;
    HalfspaceId id;
  };
  static constexpr std::uint32_t kAbsent = std::numeric_limits<std::uint32_t>::max();

  void put(std::size_t i, const Entry& entry) {
    heap_[i] = entry;
    place_[entry.id.index()] = static_cast<std::uint32_t>(i);
  }
  void settle(std::size_t i, const Entry& entry) {
    while (i > 0 && entry.key < heap_[(i - 1) / 2].key) {
      put(i, heap_[(i - 1) / 2]);
      i = (i - 1) / 2;
    }
    sink(i, entry);
  }
  void sink(std::size_t i, const Entry entry) {
    for (std::size_t child; (child = 2 * i + 1) < heap_.size(); i = child) {
      if (child + 1 < heap_.size() && heap_[child + 1].key < heap_[child].key) ++child;
      if (!(heap_[child].key < entry.key)) break;
      put(i, heap_[child]);
    }
    put(i, entry);
  }

  std::vector<Entry> heap_;
  std::vector<std::uint32_t> place_;
  std::vector<std::size_t> pending_;
};

}  // namespace convexact
