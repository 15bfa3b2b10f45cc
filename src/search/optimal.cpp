// SPDX-License-Identifier: MIT
// The least volume of as many halfspaces, by branch and bound over sets of removals.
//
// The volume that a set R of removals adds is the sum of m(S) over the subsets S of R, where m(S)
// is the volume of the region outside exactly the planes of S. Every m(S) is 0 or more, so the cost
// c_i of a removal, and the weight w_ij by which removing i makes j dearer, never fall when more is
// removed: a lower bound of them that is proven in a state holds in all states below it.
#include <algorithm>
#include <limits>
#include <memory>
#include <utility>

#include "convexact/error.hpp"
#include "number/arithmetic.hpp"
#include "number/roundoff.hpp"
#include "search/exchange_surface.hpp"
#include "search/shrunk_surface.hpp"
#include "search/symmetries.hpp"

namespace convexact {
namespace {

constexpr double kUnlimited = std::numeric_limits<double>::infinity();

// A lower bound of the sum of `count` numbers, each 0 or more, that was computed as `sum`. Each
// rounding, of a sum and of the product here, takes at most 2^-53 of it more, except for halves of
// subnormal numbers, which are covered by a separate share.
double at_most(double sum, std::size_t count) {
  return next_below(sum * (1 - static_cast<double>(count + 2) * 2 * kUnitRoundoff));
}

class BranchAndBound {
 public:
  BranchAndBound(std::unique_ptr<ShrunkSurface> surface, std::size_t size,
                 std::vector<Symmetry> symmetries, HalfspaceIds incumbent,
                 const SearchOptions& options);

  // Looks at all sets, unless it is told to settle earlier.
  void run();
  const HalfspaceIds& incumbent() const { return incumbent_; }
  // The amount by which the result of run() is smaller than the first incumbent, in the surface's
  // unit.
  double saved() const { return saved_; }
  Optimality optimality() const;

 private:
  struct Weight {
    HalfspaceId with;
    double lower;
  };
  struct Plane {
    bool is_removed = false;
    bool is_free = true;  // neither removed, nor kept in all sets being looked at
    Interval<double> cost{0, kUnlimited};
    std::optional<Rational> exact_cost = {};  // if it was needed
    std::vector<Weight> weights = {};         // in the input: those that are surely above 0
  };
  struct FormerCost {
    HalfspaceId id;
    Interval<double> cost;
    std::optional<Rational> exact_cost;
  };
  struct Share {
    double lower;
    HalfspaceId id;
  };

  Plane& at(HalfspaceId i) { return planes_[i.index()]; }
  const Rational& exact_cost(HalfspaceId i);
  void set_incumbent(HalfspaceIds kept, const Rational& volume);
  bool is_settled() const;
  void report() const;

  void weigh(HalfspaceId i);
  double share(HalfspaceId i);
  double bound();
  bool is_exact_bound_reached();
  bool keep_dear();
  void keep(HalfspaceId i);
  void keep_orbit(HalfspaceId i);
  HalfspaceId choose() const;
  void explore();
  void branch(HalfspaceId i);
  void undo_to(std::size_t kept, std::size_t costs);
  void judge_leaf();

  const SearchOptions& options_;
  const Watch watch_;
  const std::unique_ptr<ShrunkSurface> surface_;
  const Rational input_volume_;
  std::vector<Symmetry> symmetries_;  // those that keep what is to be kept in all sets
  std::vector<Plane> planes_;
  HalfspaceIds incumbent_;
  Rational incumbent_volume_;
  Interval<double> incumbent_added_;  // to the input
  double saved_ = 0;
  // The state at hand.
  std::size_t to_go_;             // removals
  Interval<double> added_{0, 0};  // by those made
  HalfspaceIds free_;             // ascending
  HalfspaceIds removed_;
  std::vector<Share> shares_;    // of those, ascending, as bound() found them
  std::vector<double> weights_;  // scratch of share()
  // The path to this state: the data to restore on the way back, and for each state on it a bound
  // of the choices left to be looked at below.
  HalfspaceIds kept_;
  std::vector<FormerCost> costs_;
  std::vector<double> open_;
  double given_up_ = kUnlimited;  // a bound of the states that were not looked at
  std::size_t nodes_ = 0;
};

// On the way to the incumbent, which is bounded, every removal leaves a bounded solid.
BranchAndBound::BranchAndBound(std::unique_ptr<ShrunkSurface> surface, std::size_t size,
                               std::vector<Symmetry> symmetries, HalfspaceIds incumbent,
                               const SearchOptions& options)
    : options_(options),
      watch_(options.watch),
      surface_(std::move(surface)),
      input_volume_(surface_->volume()),
      symmetries_(std::move(symmetries)),
      planes_(size),
      to_go_(size - incumbent.size()) {
  for (std::size_t i = 0; i < size; ++i) free_.emplace_back(i);
  const HalfspaceIds removed = without(free_, incumbent);
  for (const HalfspaceId i : removed) surface_->remove(i);
  set_incumbent(std::move(incumbent), surface_->volume());
  for (const HalfspaceId i : removed) surface_->insert(i);
}

void BranchAndBound::set_incumbent(HalfspaceIds kept, const Rational& volume) {
  incumbent_ = std::move(kept);
  incumbent_volume_ = volume;
  incumbent_added_ = surface_->in_unit(volume - input_volume_);
}

const Rational& BranchAndBound::exact_cost(HalfspaceId i) {
  std::optional<Rational>& cost = at(i).exact_cost;
  if (!cost) cost = surface_->exact_cost(i);
  return *cost;
}

void BranchAndBound::run() {
  for (const HalfspaceId i : options_.keep) keep(i);
  symmetries_.erase(std::remove_if(symmetries_.begin(), symmetries_.end(),
                                   [this](const Symmetry& symmetry) {
                                     return std::any_of(options_.keep.begin(), options_.keep.end(),
                                                        [&](HalfspaceId i) {
                                                          return at(symmetry[i.index()]).is_free;
                                                        });
                                   }),
                    symmetries_.end());
  if (to_go_ == 0) return;
  for (const HalfspaceId i : HalfspaceIds(free_)) {
    at(i).cost = surface_->cost(i);
    if (at(i).cost.lower == kUnlimited) keep(i);
  }
  if (to_go_ > 1) {
    for (const HalfspaceId i : free_) weigh(i);
  }
  explore();
}

// Bounds of all weights of i.
void BranchAndBound::weigh(HalfspaceId i) {
  watch_.ask();
  const HalfspaceIds ring = surface_->ring(i);
  surface_->remove(i);
  for (const HalfspaceId j : ring) {
    if (!at(j).is_free) continue;
    const double lower = next_below(surface_->cost(j).lower - at(j).cost.upper);
    if (lower > 0) at(i).weights.push_back({j, lower});
  }
  surface_->insert(i);
}

bool BranchAndBound::is_settled() const {
  return nodes_ >= options_.request.nodes || options_.is_told_to_settle();
}

void BranchAndBound::report() const {
  constexpr std::size_t kNodesBetween = 1024;
  if (!options_.bounded || nodes_ % kNodesBetween != 0) return;
  const double least = std::min(given_up_, *std::min_element(open_.begin(), open_.end()));
  const double gap = std::max(0.0, incumbent_added_.upper - least);
  options_.bounded(nodes_, gap / surface_->in_unit(incumbent_volume_).lower);
}

// All choices of the removals to go among the free planes. Invariant: the costs of these are those
// of the state at hand. In each round the choices that include i are looked at, and i is kept in
// all further ones: so each set is met once, whatever the order of its removals.
void BranchAndBound::explore() {
  watch_.ask();
  ++nodes_;
  if (to_go_ == 0) return judge_leaf();
  const std::size_t kept = kept_.size(), costs = costs_.size();
  open_.push_back(added_.lower);
  report();
  for (;;) {
    double lower = bound();
    while (lower < incumbent_added_.upper && keep_dear()) lower = bound();
    open_.back() = std::max(open_.back(), lower);
    if (lower >= incumbent_added_.upper || is_exact_bound_reached()) break;
    if (is_settled()) {
      given_up_ = std::min(given_up_, open_.back());
      break;
    }
    const HalfspaceId i = choose();
    branch(i);
    keep_orbit(i);
  }
  open_.pop_back();
  undo_to(kept, costs);
}

// All choices that include i.
void BranchAndBound::branch(HalfspaceId i) {
  const std::size_t kept = kept_.size(), costs = costs_.size();
  const Interval<double> before = added_;
  added_ = {next_below(added_.lower + at(i).cost.lower),
            next_above(added_.upper + at(i).cost.upper)};
  const HalfspaceIds ring = surface_->ring(i);
  surface_->remove(i);
  --to_go_;
  at(i).is_removed = true;
  removed_.push_back(i);
  keep(i);
  for (const HalfspaceId j : ring) {
    Plane& plane = at(j);
    if (to_go_ == 0 || !plane.is_free) continue;
    costs_.push_back({j, plane.cost, std::move(plane.exact_cost)});
    plane.exact_cost.reset();
    plane.cost = surface_->cost(j);
    if (plane.cost.lower == kUnlimited) keep(j);
  }
  explore();
  surface_->insert(i);
  ++to_go_;
  at(i).is_removed = false;
  removed_.pop_back();
  undo_to(kept, costs);
  added_ = before;
}

void BranchAndBound::keep(HalfspaceId i) {
  at(i).is_free = false;
  free_.erase(std::lower_bound(free_.begin(), free_.end(), i));
  kept_.push_back(i);
}

// Keeps i and its images under the symmetries that only exchange the removed planes. A symmetry
// turns each choice that includes one of these images into one of the same volume that includes i.
// Unless a plane of the latter is kept already, it has just been looked at; otherwise it was
// settled before.
void BranchAndBound::keep_orbit(HalfspaceId i) {
  keep(i);
  for (const Symmetry& symmetry : symmetries_) {
    const HalfspaceId other = symmetry[i.index()];
    if (at(other).is_free && std::all_of(removed_.begin(), removed_.end(), [&](HalfspaceId r) {
          return at(symmetry[r.index()]).is_removed;
        })) {
      keep(other);
    }
  }
}

void BranchAndBound::undo_to(std::size_t kept, std::size_t costs) {
  for (; kept_.size() > kept; kept_.pop_back()) {
    const HalfspaceId i = kept_.back();
    at(i).is_free = true;
    free_.insert(std::lower_bound(free_.begin(), free_.end(), i), i);
  }
  for (; costs_.size() > costs; costs_.pop_back()) {
    FormerCost& former = costs_.back();
    at(former.id).cost = former.cost;
    at(former.id).exact_cost = std::move(former.exact_cost);
  }
}

// A lower bound of the volume that every choice of the removals to go adds, with those made. Fills
// shares_.
double BranchAndBound::bound() {
  if (free_.size() < to_go_) return kUnlimited;
  shares_.clear();
  for (const HalfspaceId i : free_) shares_.push_back({share(i), i});
  std::sort(shares_.begin(), shares_.end(),
            [](const Share& a, const Share& b) { return a.lower < b.lower; });
  double sum = added_.lower;
  for (std::size_t k = 0; k < to_go_; ++k) sum += shares_[k].lower;
  return at_most(sum, to_go_ + 1);
}

// A lower bound of the volume that i adds as one of the removals to go: its cost, and half of the
// least weights that it can have with the others. The other half is in the shares of the others.
// [Lawler1963]
double BranchAndBound::share(HalfspaceId i) {
  const Plane& plane = at(i);
  weights_.clear();
  for (const Weight& weight : plane.weights) {
    if (at(weight.with).is_free) weights_.push_back(weight.lower);
  }
  const std::size_t others = to_go_ - 1, weightless = free_.size() - 1 - weights_.size();
  if (others <= weightless) return plane.cost.lower;
  const std::size_t count = others - weightless;
  std::sort(weights_.begin(), weights_.end());
  double sum = 0;
  for (std::size_t k = 0; k < count; ++k) sum += weights_[k];
  return at_most(plane.cost.lower + sum / 2, count + 1);
}

// Where the bound in doubles does not differ from the incumbent, as in solids with many equal caps:
// whether the least exact costs of the removals to go end at no smaller volume.
bool BranchAndBound::is_exact_bound_reached() {
  constexpr double kNearly = 1 - 0x1p-30;
  if (open_.back() < kNearly * incumbent_added_.upper) return false;
  std::vector<Rational> costs;
  for (const HalfspaceId i : free_) costs.push_back(exact_cost(i));
  std::sort(costs.begin(), costs.end());
  costs.resize(to_go_);
  costs.push_back(surface_->volume());
  return balanced_sum(std::move(costs)) >= incumbent_volume_;
}

// Keeps the planes whose removal, with the cheapest others, ends at no smaller volume than the
// incumbent. Precondition: shares_ are those of the state at hand.
bool BranchAndBound::keep_dear() {
  double sum = added_.lower;
  for (std::size_t k = 0; k + 1 < to_go_; ++k) sum += shares_[k].lower;
  const std::size_t before = kept_.size();
  for (std::size_t k = to_go_; k < shares_.size(); ++k) {
    if (at_most(sum + shares_[k].lower, to_go_ + 1) >= incumbent_added_.upper) keep(shares_[k].id);
  }
  return kept_.size() > before;
}

// The dearest removal: with it the bound rises most, and without it fewer are left to be kept. The
// first of those that are equal up to rounding, which is the same in both engines.
HalfspaceId BranchAndBound::choose() const {
  constexpr double kSurely = 1 + 0x1p-20;
  HalfspaceId dearest = free_.front();
  for (const HalfspaceId i : free_) {
    const Interval<double>&cost = planes_[i.index()].cost, &most = planes_[dearest.index()].cost;
    if (cost.lower > kSurely * most.upper) dearest = i;
  }
  return dearest;
}

void BranchAndBound::judge_leaf() {
  if (added_.lower >= incumbent_added_.upper) return;
  const Rational volume = surface_->volume();
  if (volume >= incumbent_volume_) return;
  saved_ += surface_->in_unit(incumbent_volume_ - volume).upper;
  HalfspaceIds kept;
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    if (!planes_[i].is_removed) kept.emplace_back(i);
  }
  set_incumbent(std::move(kept), volume);
}

Optimality BranchAndBound::optimality() const {
  if (given_up_ >= incumbent_added_.upper) return {true, incumbent_volume_, nodes_};
  const Rational open = input_volume_ + surface_->from_unit(given_up_);
  return {false, std::min(open, incumbent_volume_), nodes_};
}

SearchRun search_beyond(SearchRun run, std::unique_ptr<ShrunkSurface> surface, std::size_t size,
                        std::vector<Symmetry> symmetries, HalfspaceIds start,
                        const SearchOptions& options) {
  const HalfspaceIds found = after_moves(std::move(start), run.moves);
  BranchAndBound search(std::move(surface), size, std::move(symmetries), found, options);
  search.run();
  run.optimality = search.optimality();
  if (search.incumbent() != found) {
    run.moves.push_back({without(found, search.incumbent()), without(search.incumbent(), found)});
    run.changes.push_back(-search.saved());
  }
  return run;
}

SearchOptions options_of_local(const SearchOptions& options) {
  if (options.engine == Engine::Float) {
    throw Error(ErrorCode::InvalidArgument,
                "a search compares exactly: it needs the exact or the filtered engine");
  }
  if (options.cost != CostMeasure::Volume) {
    throw Error(ErrorCode::InvalidArgument,
                "only a volume can be proven the least: removing a halfspace may add less area or "
                "mean width later, so no bound holds for what is left to be tried");
  }
  SearchOptions local = options;
  local.request.kind = SearchKind::Local;
  return local;
}

}  // namespace

SearchRun search_optimal(const DualHull& dual, const Polytope& input, const RationalPoint& center,
                         std::vector<HalfspaceId> start, const SearchOptions& options) {
  return search_optimal_from(dual, nullptr, input, center, dual_triangles_of(dual, start, center),
                             options);
}

SearchRun search_optimal_from(const DualHull& dual, const FastDual* fast, const Polytope& input,
                              const RationalPoint& center, std::span<const DualTriangle> start,
                              const SearchOptions& options) {
  const SearchOptions local = options_of_local(options);
  if (options.engine == Engine::Filtered && fast == nullptr) {
    const FastDual made = FastDual::of(dual, center);
    return search_optimal_from(dual, &made, input, center, start, options);
  }
  return search_beyond(search_from(dual, fast, input, center, start, local),
                       options.engine == Engine::Exact ? make_exact_shrunk_surface(dual, center)
                                                       : make_filtered_shrunk_surface(*fast),
                       dual.halfspaces.size(), symmetries_of(dual.halfspaces, input), ids_in(start),
                       options);
}

}  // namespace convexact
