// SPDX-License-Identifier: MIT
#include "convexact/search.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

#include "convexact/error.hpp"
#include "fast/mesh.hpp"
#include "number/random.hpp"
#include "search/exchange_surface.hpp"

namespace convexact {
namespace {

// For each facet those that share an edge with it, ascending. Corners are numbers below `corners`.
std::vector<HalfspaceIds> neighbours_of(const std::vector<std::vector<std::uint32_t>>& facets,
                                        std::size_t corners) {
  std::vector<std::uint32_t> tail, head, facet;  // of each half-edge
  for (std::uint32_t f = 0; f < facets.size(); ++f) {
    const auto& around = facets[f];
    for (std::size_t c = 0; c < around.size(); ++c) {
      tail.push_back(around[c]);
      head.push_back(around[c + 1 < around.size() ? c + 1 : 0]);
      facet.push_back(f);
    }
  }
  const std::vector<std::uint32_t> twins = match_twins(tail, head, corners);
  std::vector<HalfspaceIds> lists(facets.size());
  for (std::size_t h = 0; h < twins.size(); ++h) lists[facet[h]].emplace_back(facet[twins[h]]);
  for (HalfspaceIds& list : lists) std::sort(list.begin(), list.end());
  return lists;
}

Cost zero_of(CostMeasure measure) {
  switch (measure) {
    case CostMeasure::Volume:
      return Rational(0);
    case CostMeasure::Area:
      return Cost(RootSum());
    case CostMeasure::MeanWidth:
      break;
  }
  return Cost(AngleSum());
}

// The facets at a distance from a given one, counted in edges to be crossed.
class Surroundings {
 public:
  explicit Surroundings(std::vector<HalfspaceIds> neighbours)
      : neighbours_(std::move(neighbours)), visit_(neighbours_.size(), 0) {}
  /// Those that share an edge with it, ascending.
  const HalfspaceIds& of(HalfspaceId i) const { return neighbours_[i.index()]; }
  /// Those that are reached in exactly this many steps and not in fewer, ascending.
  HalfspaceIds away_from(HalfspaceId from, std::uint64_t steps);

 private:
  std::vector<HalfspaceIds> neighbours_;
  // The call of away_from() that came to a facet last: so no call clears anything.
  std::vector<std::uint64_t> visit_;
  std::uint64_t visits_ = 0;
};

HalfspaceIds Surroundings::away_from(HalfspaceId from, std::uint64_t steps) {
  ++visits_;
  visit_[from.index()] = visits_;
  HalfspaceIds now = {from}, next;
  for (; steps > 0; --steps) {
    next.clear();
    for (const HalfspaceId i : now) {
      for (const HalfspaceId j : of(i)) {
        if (std::exchange(visit_[j.index()], visits_) != visits_) next.push_back(j);
      }
    }
    now.swap(next);
  }
  std::sort(now.begin(), now.end());
  return now;
}

class ExchangeSearch {
 public:
  // neighbours: of each facet of the input
  ExchangeSearch(std::unique_ptr<ExchangeSurface> surface, std::vector<HalfspaceIds> neighbours,
                 HalfspaceIds start, const SearchOptions& options);
  SearchRun run();

 private:
  struct Exchange {
    HalfspaceId out, in;
    Change change;
  };

  bool is_kept(HalfspaceId i) const { return std::binary_search(kept_.begin(), kept_.end(), i); }
  HalfspaceIds exchangeable() const { return without(kept_, options_.keep); }
  bool is_less(const Cost& a, const Cost& b) const;
  bool is_less(Exchange& a, std::optional<Exchange>& b);
  const Cost& exactly(Exchange& exchange);
  double approximately(const Change& change);
  std::optional<Exchange> best_exchange(HalfspaceId out);
  void make(Exchange exchange);
  bool walk(bool is_kick);
  void kick();
  bool has_shrunk();
  void accept();
  void undo();

  const SearchOptions& options_;
  const Watch watch_;
  Surroundings surroundings_;
  const std::unique_ptr<ExchangeSurface> surface_;
  const Cost zero_;
  Random random_;
  HalfspaceIds kept_;              // ascending
  HalfspaceIds settled_;           // kept halfspaces that no exchange would improve now, ascending
  std::set<HalfspaceIds> walked_;  // the kept sets at the start of all passes so far
  // The best that is known so far, and the exchanges made since.
  HalfspaceIds best_;
  std::vector<DualTriangle> best_triangles_;
  Interval<double> best_bounds_;
  std::optional<Cost> best_measure_;  // if it was needed
  std::vector<Exchange> since_;
  SearchRun run_;
};

ExchangeSearch::ExchangeSearch(std::unique_ptr<ExchangeSurface> surface,
                               std::vector<HalfspaceIds> neighbours, HalfspaceIds start,
                               const SearchOptions& options)
    : options_(options),
      watch_(options.watch),
      surroundings_(std::move(neighbours)),
      surface_(std::move(surface)),
      zero_(zero_of(options.cost)),
      random_(options.seed),
      kept_(std::move(start)),
      best_(kept_),
      best_triangles_(surface_->triangles()),
      best_bounds_(surface_->measure_bounds()) {}

// An undecided cost counts as not smaller.
bool ExchangeSearch::is_less(const Cost& a, const Cost& b) const {
  return compare(a, b, options_.compare, watch_).order == Order::Less;
}

// Bounds give the same answers as exact numbers. Without b: whether a makes the measure smaller.
bool ExchangeSearch::is_less(Exchange& a, std::optional<Exchange>& b) {
  const double lower = b ? b->change.lower : 0, upper = b ? b->change.upper : 0;
  if (a.change.lower >= upper) return false;
  if (a.change.upper < lower) return true;
  return is_less(exactly(a), b ? exactly(*b) : zero_);
}

// Precondition: it is not made.
const Cost& ExchangeSearch::exactly(Exchange& exchange) {
  std::optional<Cost>& exact = exchange.change.exact;
  if (!exact) exact = surface_->exact_change(exchange.out, exchange.in);
  return *exact;
}

// In the unit of the surface.
double ExchangeSearch::approximately(const Change& change) {
  const auto& [lower, upper, exact] = change;
  const double value = exact ? surface_->in_unit(*exact) : lower + (upper - lower) / 2;
  return std::isfinite(value) ? value : 0;
}

// The incumbent stays until a candidate is proven smaller, which then stays until the next one is.
std::optional<ExchangeSearch::Exchange> ExchangeSearch::best_exchange(HalfspaceId out) {
  std::optional<Exchange> leader;
  for (const HalfspaceId in : surroundings_.of(out)) {
    if (is_kept(in)) continue;
    watch_.ask();
    ++run_.tried;
    const double below = leader ? leader->change.upper : 0;  // as in is_less()
    const std::optional<Change> change = surface_->change(out, in, below);
    if (!change) continue;
    Exchange candidate{out, in, *change};
    if (is_less(candidate, leader)) leader = std::move(candidate);
  }
  return leader;
}

void ExchangeSearch::make(Exchange exchange) {
  surface_->exchange(exchange.out, exchange.in);
  kept_.erase(std::lower_bound(kept_.begin(), kept_.end(), exchange.out));
  kept_.insert(std::lower_bound(kept_.begin(), kept_.end(), exchange.in), exchange.in);
  settled_.clear();
  since_.push_back(std::move(exchange));
}

// Ends, because the measure falls each time and there are finitely many sets. Returns false where
// the end is known to be no smaller than the best: a pass has begun here before, and what follows
// is the same.
bool ExchangeSearch::walk(bool is_kick) {
  for (bool helped = true; helped;) {
    if (!walked_.insert(kept_).second) return false;
    helped = false;
    for (const HalfspaceId out : exchangeable()) {
      const auto place = std::lower_bound(settled_.begin(), settled_.end(), out);
      if (place != settled_.end() && *place == out) continue;
      std::optional<Exchange> best = best_exchange(out);
      if (!best) {
        settled_.insert(place, out);
        continue;
      }
      helped = true;
      make(std::move(*best));
      if (!is_kick) accept();
    }
  }
  return true;
}

void ExchangeSearch::kick() {
  constexpr std::uint64_t kMostExchanges = 3, kFewestSteps = 2, kMostSteps = 11;
  // (1) Random exchanges.
  for (std::uint64_t left = 1 + uniform_below(random_, kMostExchanges); left > 0; --left) {
    const HalfspaceIds candidates = exchangeable();
    const HalfspaceId out = candidates[uniform_below(random_, candidates.size())];
    const std::uint64_t steps =
        kFewestSteps + uniform_below(random_, kMostSteps - kFewestSteps + 1);
    const HalfspaceIds there = surroundings_.away_from(out, steps);
    if (there.empty()) continue;
    const HalfspaceId in = there[uniform_below(random_, there.size())];
    if (is_kept(in)) continue;
    ++run_.tried;
    const std::optional<Change> change = surface_->change(out, in, kNoLimit);
    if (change) make({out, in, *change});
  }
  if (since_.empty()) return;
  // (2) From there to the nearest solid that no exchange makes smaller.
  const bool is_new = walk(true);
  // (3) Back, unless that one is smaller than the best so far.
  if (is_new && has_shrunk()) {
    accept();
  } else {
    undo();
  }
}

// Whether the measure is proven smaller than the best so far.
bool ExchangeSearch::has_shrunk() {
  if (kept_ == best_) return false;
  double lower = 0, upper = 0;
  for (const Exchange& exchange : since_) {
    lower = next_below(lower + exchange.change.lower);
    upper = next_above(upper + exchange.change.upper);
  }
  if (lower >= 0) return false;
  if (upper < 0) return true;
  // A kick may lead through a solid so large that the changes cancel.
  const Interval<double> now = surface_->measure_bounds();
  if (now.lower >= best_bounds_.upper) return false;
  if (now.upper < best_bounds_.lower) return true;
  if (!best_measure_) best_measure_ = surface_->measure(best_triangles_);
  return is_less(surface_->measure(surface_->triangles()), *best_measure_);
}

void ExchangeSearch::accept() {
  double change = 0;
  for (const Exchange& exchange : since_) change += approximately(exchange.change);
  run_.changes.push_back(change);
  since_.clear();
  best_triangles_ = surface_->triangles();
  best_bounds_ = surface_->measure_bounds();
  best_measure_.reset();
  run_.moves.push_back({without(best_, kept_), without(kept_, best_)});
  best_ = kept_;
}

// Reverses the exchanges, the last one first: each leads to a solid that occurred before.
void ExchangeSearch::undo() {
  for (auto exchange = since_.rbegin(); exchange != since_.rend(); ++exchange) {
    surface_->exchange(exchange->in, exchange->out);
  }
  since_.clear();
  settled_.clear();
  kept_ = best_;
}

SearchRun ExchangeSearch::run() {
  if (options_.request.kind == SearchKind::None || exchangeable().empty()) return {};
  walk(false);
  if (options_.request.kind == SearchKind::Local) {
    for (std::size_t made = 1; made <= options_.request.kicks; ++made) {
      if (options_.is_told_to_settle()) break;
      watch_.ask();
      kick();
      watch_.report(made, options_.request.kicks);
    }
  }
  return std::move(run_);
}

}  // namespace

std::vector<DualTriangle> dual_triangles_of(const DualHull& dual, std::span<const HalfspaceId> ids,
                                            const RationalPoint& center) {
  std::vector<Halfspace> halfspaces;
  for (const HalfspaceId i : ids) halfspaces.push_back(dual.halfspaces.at(i.index()));
  const HalfspaceDual of_ids = dual_of(halfspaces, center);
  const auto id = [&](HalfspaceId k) { return ids[of_ids.rows[k.index()]]; };
  std::vector<DualTriangle> triangles;
  for (const DualTriangle& t : of_ids.dual.triangles) {
    triangles.push_back({id(t[0]), id(t[1]), id(t[2])});
  }
  return triangles;
}

std::vector<HalfspaceId> ids_in(std::span<const DualTriangle> triangles) {
  std::set<HalfspaceId> ids;
  for (const DualTriangle& t : triangles) ids.insert(t.begin(), t.end());
  return {ids.begin(), ids.end()};
}

SearchRun search_exchanges(const DualHull& dual, const Polytope& input, const RationalPoint& center,
                           std::vector<HalfspaceId> start, const SearchOptions& options) {
  return search_from(dual, nullptr, input, center, dual_triangles_of(dual, start, center), options);
}

SearchRun search_from(const DualHull& dual, const FastDual* fast, const Polytope& input,
                      const RationalPoint& center, std::span<const DualTriangle> start,
                      const SearchOptions& options) {
  switch (options.engine) {
    case Engine::Exact:
      return ExchangeSearch(make_exact_surface(dual, start, center, options.cost),
                            neighbours_of(input.facets, input.vertices.size()), ids_in(start),
                            options)
          .run();
    case Engine::Filtered: {
      if (fast == nullptr) {
        const FastDual made = FastDual::of(dual, center);
        return search_from(dual, &made, input, center, start, options);
      }
      return ExchangeSearch(make_filtered_surface(*fast, start, options.cost),
                            neighbours_of(input.facets, input.vertices.size()), ids_in(start),
                            options)
          .run();
    }
    case Engine::Float:
      break;
  }
  throw Error(ErrorCode::InvalidArgument,
              "a search compares exactly: it needs the exact or the filtered engine");
}

SearchRun search_from(const FastDual& dual, const Hull& hull, std::span<const DualTriangle> start,
                      const SearchOptions& options) {
  const std::size_t corners = hull.vertices.back().index() + 1;
  return ExchangeSearch(make_filtered_surface(dual, start, options.cost),
                        neighbours_of(polygons_of(hull.facets), corners), ids_in(start), options)
      .run();
}

}  // namespace convexact
