// SPDX-License-Identifier: MIT
// keyed_queue.hpp - a heap of halfspaces, each with a key that may change.
#pragma once
#include <cstdint>
#include <limits>
#include <vector>

#include "convexact/geometry.hpp"
#include "number/double_double.hpp"

namespace convexact {

/// Where a queue keeps its keys: in the heap.
template <class Key>
class QueueKeys {
 public:
  using InHeap = Key;
  explicit QueueKeys(std::size_t /*size*/) {}
  const Key& keep(HalfspaceId, const Key& key) { return key; }
  const Key& key(const Key& in_heap, HalfspaceId) const { return in_heap; }
  bool is_less(const Key& a, HalfspaceId, const Key& b, HalfspaceId) const { return a < b; }
};

/// The low halves decide seldom, so they stay out of the heap, which then is as small as one of
/// doubles.
template <>
class QueueKeys<DoubleDouble> {
 public:
  using InHeap = double;
  explicit QueueKeys(std::size_t size) : low_(size) {}
  double keep(HalfspaceId id, const DoubleDouble& key) {
    low_[id.index()] = key.lo();
    return key.hi();
  }
  DoubleDouble key(double high, HalfspaceId id) const { return {high, low_[id.index()]}; }
  bool is_less(double a, HalfspaceId i, double b, HalfspaceId j) const {
    return a < b || (a == b && low_[i.index()] < low_[j.index()]);
  }

 private:
  std::vector<double> low_;
};

/// A binary heap of (key, id), smallest key first, that knows where each id stands.
template <class Key>
class KeyedQueue {
 public:
  explicit KeyedQueue(std::size_t size) : keys_(size), place_(size, kAbsent) {}

  bool empty() const { return heap_.empty(); }
  HalfspaceId top() const { return heap_.front().id; }
  decltype(auto) key(HalfspaceId id) const { return keys_.key(heap_[place_[id.index()]].key, id); }
  bool contains(HalfspaceId id) const { return place_[id.index()] != kAbsent; }

  /// Adds without order; call make_heap() before anything else.
  void append(HalfspaceId id, const Key& key) {
    place_[id.index()] = static_cast<std::uint32_t>(heap_.size());
    heap_.push_back({keys_.keep(id, key), id});
  }
  void make_heap() {
    for (std::size_t i = heap_.size() / 2; i-- > 0;) sink(i, heap_[i]);
  }
  /// Sets a key, higher or lower.
  void update(HalfspaceId id, const Key& key) {
    settle(place_[id.index()], {keys_.keep(id, key), id});
  }
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
      if (i >= heap_.size() || limit < keys_.key(heap_[i].key, heap_[i].id)) continue;
      ids.push_back(heap_[i].id);
      pending_.push_back(2 * i + 1);
      pending_.push_back(2 * i + 2);
    }
  }

 private:
  struct Entry {
    typename QueueKeys<Key>::InHeap key;
    HalfspaceId id;
  };
  bool is_less(const Entry& a, const Entry& b) const {
    return keys_.is_less(a.key, a.id, b.key, b.id);
  }
  static constexpr std::uint32_t kAbsent = std::numeric_limits<std::uint32_t>::max();

  void put(std::size_t i, const Entry& entry) {
    heap_[i] = entry;
    place_[entry.id.index()] = static_cast<std::uint32_t>(i);
  }
  void settle(std::size_t i, const Entry& entry) {
    while (i > 0 && is_less(entry, heap_[(i - 1) / 2])) {
      put(i, heap_[(i - 1) / 2]);
      i = (i - 1) / 2;
    }
    sink(i, entry);
  }
  void sink(std::size_t i, const Entry entry) {
    for (std::size_t child; (child = 2 * i + 1) < heap_.size(); i = child) {
      if (child + 1 < heap_.size() && is_less(heap_[child + 1], heap_[child])) ++child;
      if (!is_less(heap_[child], entry)) break;
      put(i, heap_[child]);
    }
    put(i, entry);
  }

  QueueKeys<Key> keys_;
  std::vector<Entry> heap_;
  std::vector<std::uint32_t> place_;
  std::vector<std::size_t> pending_;
};

}  // namespace convexact
