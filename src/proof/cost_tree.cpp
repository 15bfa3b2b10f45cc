// SPDX-License-Identifier: MIT
#include "proof/cost_tree.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "convexact/error.hpp"

namespace convexact {
namespace {

// The data on the removal of a free halfspace.
struct FreeRemoval {
  HalfspaceId id;
  Rational cost = 0;                    // a lower bound
  std::optional<Removal> removal = {};  // in the state at hand; then the cost is exact
};

class CostTree {
 public:
  CostTree(DualSurface& surface, const Rational& least, CostTreeObserver& observer,
           const Watch& watch)
      : surface_(surface), least_(least), observer_(observer), watch_(watch) {}

  void walk(std::vector<FreeRemoval> free, std::size_t to_go, const Rational& added);

 private:
  bool is_reached(const std::vector<FreeRemoval>& free, std::size_t to_go,
                  const Rational& added) const;
  void evaluate(std::vector<FreeRemoval>& free);
  std::vector<FreeRemoval>::iterator dearest_below(std::vector<FreeRemoval>& free,
                                                   std::size_t to_go, const Rational& added) const;

  DualSurface& surface_;
  const Rational& least_;
  CostTreeObserver& observer_;
  const Watch& watch_;
};

void CostTree::walk(std::vector<FreeRemoval> free, std::size_t to_go, const Rational& added) {
  watch_.ask();
  while (!is_reached(free, to_go, added)) {
    if (to_go == 0) throw Error(ErrorCode::Internal, "other halfspaces bound less volume");
    evaluate(free);
    if (is_reached(free, to_go, added)) break;
    const auto next = dearest_below(free, to_go, added);
    const Removal removal = next->removal.value();
    free.erase(next);
    // The costs of its ring are lower bounds after it.
    std::vector<FreeRemoval> after = free;
    for (FreeRemoval& other : after) {
      const auto& ring = removal.ring;
      if (std::find(ring.begin(), ring.end(), other.id) != ring.end()) other.removal.reset();
    }
    observer_.branches(removal);
    surface_.apply(removal);
    walk(std::move(after), to_go - 1, Rational(added + removal.cost->rational()));
    surface_.undo(removal);
  }
  observer_.closes();
}

bool CostTree::is_reached(const std::vector<FreeRemoval>& free, std::size_t to_go,
                          const Rational& added) const {
  if (free.size() < to_go) return true;
  std::vector<Rational> costs;
  for (const FreeRemoval& each : free) costs.push_back(each.cost);
  std::sort(costs.begin(), costs.end());
  Rational bound = added;
  for (std::size_t k = 0; k < to_go; ++k) bound += costs[k];
  return bound >= least_;
}

// The dearest of the removals with which the bound is not reached. The others need no branch: where
// one of them is among the cheapest that are left, the bound is reached. Precondition: the bound is
// not reached now, so the cheapest removals are of the first kind; all costs are exact.
std::vector<FreeRemoval>::iterator CostTree::dearest_below(std::vector<FreeRemoval>& free,
                                                           std::size_t to_go,
                                                           const Rational& added) const {
  std::sort(free.begin(), free.end(), [](const FreeRemoval& a, const FreeRemoval& b) {
    return a.cost != b.cost ? a.cost < b.cost : a.id < b.id;
  });
  Rational others = added;
  for (std::size_t k = 0; k + 1 < to_go; ++k) others += free[k].cost;
  auto last = free.begin() + static_cast<std::ptrdiff_t>(to_go) - 1;
  while (last + 1 != free.end() && others + (last + 1)->cost < least_) ++last;
  return last;
}

// An unbounded removal stays unbounded in all states below, and its halfspace is no longer free.
void CostTree::evaluate(std::vector<FreeRemoval>& free) {
  for (FreeRemoval& each : free) {
    if (each.removal) continue;
    each.removal = surface_.removal_of(each.id);
    observer_.evaluated(*each.removal);
    if (each.removal->cost) each.cost = each.removal->cost->rational();
  }
  std::erase_if(free, [](const FreeRemoval& each) { return !each.removal->cost; });
}

}  // namespace

void walk_cost_tree(DualSurface& surface, std::span<const HalfspaceId> free, std::size_t to_go,
                    const Rational& least, CostTreeObserver& observer, const Watch& watch) {
  std::vector<FreeRemoval> removals;
  for (const HalfspaceId i : free) removals.push_back({i});
  CostTree(surface, least, observer, watch).walk(std::move(removals), to_go, 0);
}

}  // namespace convexact
