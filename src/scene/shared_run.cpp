// SPDX-License-Identifier: MIT
#include "scene/shared_run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <set>
#include <utility>

#include "convexact/error.hpp"
#include "number/precision.hpp"
#include "task/parallel.hpp"

namespace convexact {

WideDouble WideDouble::of(double x, long exponent) {
  using Limits = std::numeric_limits<long>;
  if (!(x > 0)) return {Limits::min(), 0};
  if (std::isinf(x)) return {Limits::max(), 1};
  int shift = 0;
  const double mantissa = std::frexp(x, &shift);
  return {exponent + shift, mantissa};
}

namespace {

// Decides whether the sum of the parts' measures stays within (1 + max_growth) times what it was.
// Enclosures decide it, and exact measures where these overlap; there are none for estimates.
class SharedGrowth {
 public:
  SharedGrowth(std::span<const std::unique_ptr<PartRun>> parts, const SharedOptions& options)
      : parts_(parts), options_(options), spent_(kMeasureBits), allowance_(kMeasureBits) {
    if (!options.max_growth) return;
    allowance_ = Enclosure(*options.max_growth, kMeasureBits) * options.measure.value();
  }

  // Whether the next removal of a part may be made; if so, it counts from now on.
  bool allows(PartRun& part) {
    if (!options_.max_growth) return true;
    const Enclosure spent = spent_ + part.added();
    const std::optional<Sign> slack = (allowance_ - spent).sign();
    if (slack == Sign::Negative) return false;
    if (!slack && part.exact() != nullptr && !allows_exactly(*part.exact())) return false;
    spent_ = spent;
    return true;
  }
  long undecided_bits() const { return undecided_bits_; }

 private:
  bool allows_exactly(ExactPartRun& part) {
    std::vector<Cost> now, before;
    for (const auto& each : parts_) now.push_back(each->exact()->measure_now());
    now.push_back(part.exactly_added());
    if (!limit_) {
      for (const auto& each : parts_) before.push_back(each->exact()->measure_before());
      limit_ = sum_of(before);
      *limit_ *= Rational(1 + *options_.max_growth);
    }
    const Ordering ordering = compare(sum_of(now), *limit_, options_.compare, options_.watch);
    undecided_bits_ = ordering.order == Order::Undecided ? ordering.bits : 0;
    return ordering.order == Order::Less || ordering.order == Order::Equal;
  }

  std::span<const std::unique_ptr<PartRun>> parts_;
  const SharedOptions& options_;
  Enclosure spent_, allowance_;
  std::optional<Cost> limit_;
  long undecided_bits_ = 0;
};

class SharedQueue {
 public:
  SharedQueue(std::span<const std::unique_ptr<PartRun>> parts, const SharedOptions& options)
      : parts_(parts), options_(options), place_(parts.size()), class_(parts.size()) {}

  bool empty() const { return queue_.empty(); }
  void find_next(std::size_t part) {
    if (parts_[part]->find_next()) add(part);
  }
  // The next removal of a part, which has been found.
  void add(std::size_t part);
  std::size_t cheapest();
  // After cheapest(): why the next removals of several parts count as equally cheap.
  const TieEvidence& evidence() const { return evidence_; }
  // The next removal of a part has been made: the part has none until find_next().
  void forget(std::size_t part) { queue_.erase(place_[part]); }

 private:
  // The next removal of a part.
  struct Entry {
    WideDouble low;
    std::size_t part;
    WideDouble high;
    friend bool operator<(const Entry& a, const Entry& b) {
      return std::pair(a.low, a.part) < std::pair(b.low, b.part);
    }
  };
  // Next removals that are proven to cost the same. Identical parts would be compared again at
  // every step without them.
  struct CostClass {
    std::size_t number = 0;
    TieEvidence evidence = {};
  };

  std::vector<std::size_t> candidates() const;
  Ordering compared(std::size_t part, std::size_t least);

  std::span<const std::unique_ptr<PartRun>> parts_;
  const SharedOptions& options_;
  std::set<Entry> queue_;
  std::vector<std::set<Entry>::iterator> place_;  // of parts that have a next removal
  std::vector<CostClass> class_;
  std::size_t classes_ = 0;
  TieEvidence evidence_;
};

void SharedQueue::add(std::size_t part) {
  const PartRun::Bounds bounds = parts_[part]->cost_bounds();
  place_[part] = queue_.insert({bounds.low, part, bounds.high}).first;
  class_[part] = {++classes_};
}

// All parts whose next removal cannot be distinguished from the cheapest by bounds, ascending.
std::vector<std::size_t> SharedQueue::candidates() const {
  WideDouble least = queue_.begin()->high;
  std::vector<std::size_t> found;
  auto entry = queue_.begin();
  for (; entry != queue_.end() && entry->low <= least; ++entry) {
    least = std::min(least, entry->high);
  }
  for (auto each = queue_.begin(); each != entry; ++each) {
    if (each->low <= least) found.push_back(each->part);
  }
  std::sort(found.begin(), found.end());
  return found;
}

Ordering SharedQueue::compared(std::size_t part, std::size_t least) {
  if (class_[part].number == class_[least].number) {
    TieEvidence both = class_[part].evidence;
    both.add(class_[least].evidence);
    return {Order::Equal, both.proof, both.bits};
  }
  const Ordering ordering =
      compare(parts_[part]->exact()->exact_cost(), parts_[least]->exact()->exact_cost(),
              options_.compare, options_.watch);
  if (ordering.order == Order::Equal) {
    class_[part] = {class_[least].number, {ordering.tie_proof, ordering.bits}};
  }
  return ordering;
}

// As in one run, a cost that is not proven to differ from the least one counts as a tie.
std::size_t SharedQueue::cheapest() {
  evidence_ = {};
  const std::vector<std::size_t> found = candidates();
  std::size_t least = found.front();
  // Estimates that overlap are equal.
  if (found.size() == 1 || parts_[least]->exact() == nullptr) return least;
  for (const std::size_t part : found) {
    if (part != least && compared(part, least).order == Order::Less) least = part;
  }
  std::optional<std::size_t> first;
  for (const std::size_t part : found) {
    if (part != least) {
      const Ordering ordering = compared(part, least);
      if (ordering.order == Order::Greater) continue;
      evidence_.add({ordering.tie_proof, ordering.bits});
    }
    if (!first) first = part;
  }
  return *first;
}

}  // namespace

SharedEnd run_shared(std::span<const std::unique_ptr<PartRun>> parts,
                     const SharedOptions& options) {
  SharedEnd end;
  SharedGrowth growth(parts, options);
  SharedQueue queue(parts, options);
  std::size_t left = 0;
  for (const auto& part : parts) left += part->left();
  const std::size_t at_start = left;
  std::mutex mutex;  // of `left`, and of what is told
  const auto make = [&](PartRun& part) {
    part.make();
    const std::lock_guard lock(mutex);
    --left;
    options.watch.report(at_start - left, at_start - options.total_faces);
  };
  // (1) The others keep 4 each, so no part ends with more than the rest. Each part is reduced to
  // that number first, since it must make these removals in any case and its data are in the cache.
  // (Not so with a growth limit, which may end the run before; nor where costs may fall, since the
  // queue may spend the budget on another part before this part gets that far.) The total stays at
  // or above the budget.
  const bool can_run_ahead = options.costs_never_fall && !options.max_growth;
  const std::size_t most = options.total_faces - kLeastFaces * (parts.size() - 1);
  for_each_in_parallel(can_run_ahead ? parts.size() : 0, options.jobs, [&](std::size_t k) {
    while (parts[k]->left() > most && parts[k]->find_next()) make(*parts[k]);
  });
  // (2) The cheapest removal of all.
  std::vector<char> has_next(parts.size(), 0);  // threads write their own
  for_each_in_parallel(left > options.total_faces ? parts.size() : 0, options.jobs,
                       [&](std::size_t k) { has_next[k] = parts[k]->find_next() ? 1 : 0; });
  for (std::size_t part = 0; part < parts.size(); ++part) {
    if (has_next[part] != 0) queue.add(part);
  }
  while (left > options.total_faces) {
    options.watch.ask();
    if (queue.empty()) {
      end.stop = options.when_stuck;
      break;
    }
    const std::size_t part = queue.cheapest();
    if (!growth.allows(*parts[part])) {
      end.stop = StopReason::GrowthLimit;
      end.growth_bits = growth.undecided_bits();
      break;
    }
    queue.forget(part);
    make(*parts[part]);
    end.order.push_back(static_cast<std::uint32_t>(part));
    end.ties.add(queue.evidence());
    if (left > options.total_faces) queue.find_next(part);
  }
  return end;
}

}  // namespace convexact
