// SPDX-License-Identifier: MIT
#include "conform/tied_removals.hpp"

#include <algorithm>
#include <set>
#include <vector>

#include "convexact/error.hpp"
#include "fast/dual.hpp"
#include "fast/filtered_loop.hpp"

namespace convexact::oracle {
namespace {

using Removals = std::vector<HalfspaceId>;

class TieSearch {
 public:
  TieSearch(const Solid& solid, std::vector<bool> stays, std::size_t most_states,
            const Watch& watch)
      : center_(interior_point_of(solid)),
        dual_(FastDual::of(solid.dual, center_)),
        options_{.watch = watch},
        watch_(watch),
        stays_(std::move(stays)),
        staying_(static_cast<std::size_t>(std::count(stays_.begin(), stays_.end(), true))),
        most_states_(most_states) {}

  ByTies run() {
    open_ = {{}};
    while (!open_.empty() && states_ <= most_states_) {
      Removals begun = std::move(open_.back());
      open_.pop_back();
      if (follow(std::move(begun))) return ByTies::Lead;
    }
    return states_ > most_states_ ? ByTies::Undecided : ByTies::DoNotLead;
  }

 private:
  // Goes on with the first of the tied removals, and leaves the others open. Returns whether only
  // those that stay are left.
  bool follow(Removals made) {
    FilteredLoop loop(dual_, options_);
    loop.evaluate_all();
    std::vector<bool> is_left(stays_.size(), true);
    const auto remove = [&](HalfspaceId i) {
      if (!loop.is_bounded(i)) throw Error(ErrorCode::Internal, "a removal is no longer bounded");
      loop.remove(i);
      is_left[i.index()] = false;
    };
    for (const HalfspaceId i : made) remove(i);
    for (;;) {
      watch_.ask();
      if (loop.left() == staying_) return true;
      if (!seen_.insert(is_left).second || ++states_ > most_states_ || !loop.choose()) return false;
      Removals next = loop.tie();
      std::erase_if(next, [&](HalfspaceId i) { return stays_[i.index()]; });
      if (next.empty()) return false;
      for (std::size_t k = next.size(); k-- > 1;) {
        open_.push_back(made);
        open_.back().push_back(next[k]);
      }
      made.push_back(next[0]);
      remove(next[0]);
    }
  }

  const RationalPoint center_;
  const FastDual dual_;
  const SimplifyOptions options_;
  const Watch watch_;
  const std::vector<bool> stays_;  // by halfspace
  const std::size_t staying_;
  const std::size_t most_states_;
  std::vector<Removals> open_;
  std::set<std::vector<bool>> seen_;  // which halfspaces are left
  std::size_t states_ = 0;
};

}  // namespace

ByTies do_ties_lead(const Solid& solid, std::span<const Halfspace> to, std::size_t most_states,
                    const Watch& watch) {
  const std::vector<Halfspace>& halfspaces = solid.dual.halfspaces;
  std::vector<bool> stays(halfspaces.size(), false);
  for (const Halfspace& plane : to) {
    const auto found = std::find(halfspaces.begin(), halfspaces.end(), plane);
    if (found == halfspaces.end()) return ByTies::DoNotLead;
    stays[static_cast<std::size_t>(found - halfspaces.begin())] = true;
  }
  return TieSearch(solid, std::move(stays), most_states, watch).run();
}

}  // namespace convexact::oracle
