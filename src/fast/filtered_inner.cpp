// SPDX-License-Identifier: MIT
#include "fast/filtered_inner.hpp"

#include <algorithm>
#include <limits>

#include "convexact/error.hpp"

namespace convexact {

// For RingTriangulator: whether ring point m is strictly beyond a triangle of ring points.
struct FilteredLoss::Beyond {
  FilteredLoss& of;
  double bound;
  std::array<std::uint32_t, 3> corner{};
  Triple<double> normal{};

  void set_triangle(std::uint32_t low, std::uint32_t middle, std::uint32_t high) {
    corner = {low, middle, high};
    normal = cross(of.point_[middle] - of.point_[low], of.point_[high] - of.point_[low]);
  }
  bool is_beyond(std::uint32_t m) {
    const FilterSign sure = filter_sign(dot(normal, of.point_[m] - of.point_[corner[0]]), bound);
    if (sure != FilterSign::Unknown) {
      ++of.counts_.signs;
      return sure == FilterSign::Positive;
    }
    ++of.counts_.exact_signs;
    const auto& v = of.ring_.vertices;
    return of.near_.exact().side(v[corner[0]].index(), v[corner[1]].index(), v[corner[2]].index(),
                                 v[m].index()) == Sign::Positive;
  }
};

void FilteredLoss::prepare(VertexId v) {
  vertex_ = v;
  mesh_.one_ring(v, ring_);
  const auto k = static_cast<std::uint32_t>(ring_.vertices.size());
  point_.resize(k);
  arm_.resize(k);
  extent_ = {};
  for (std::uint32_t m = 0; m < k; ++m) {
    point_[m] = near_[ring_.vertices[m]];
    arm_[m] = point_[m] - near_[v];
    extent_.include(arm_[m]);
  }
  // Differences between ring points are at most twice the arms, up to a rounding.
  Beyond beyond{*this, near_.bound(extent_.doubled())};
  triangulator_.run(k, beyond, seed_, triangles_);
}

// A sum of n terms, none of them negative, that were rounded once each, is off by less than a
// relative (n + 1) u; 2^-40 is more, up to rings of 4000, and 2^-20 beyond.
double FilteredLoss::lower_bound(const std::vector<Term>& terms) {
  double sum = 0;
  for (const Term& term : terms) sum += term.lower;
  return sum * (1 - (terms.size() < 4000 ? 0x1p-40 : 0x1p-20));
}

Interval<double> FilteredLoss::bounds(std::vector<Term>& terms) {
  ++counts_.evaluations;
  const double bound = near_.bound(extent_.size);
  const auto& v = ring_.vertices;
  terms.clear();
  double upper = 0;
  for (const RingTriangle& t : triangles_) {
    // Seen from v the corners run counter-clockwise, so the determinant of the arms is negative.
    const double value = -dot(cross(arm_[t.low], arm_[t.middle]), arm_[t.high]);
    terms.push_back({v[t.low], v[t.middle], v[t.high], std::max(0.0, value - bound)});
    upper += value + bound;
  }
  return {lower_bound(terms), upper * (1 + (terms.size() < 4000 ? 0x1p-40 : 0x1p-20))};
}

Integer FilteredLoss::exactly() const {
  const auto& v = ring_.vertices;
  Integer sum = 0;
  for (const RingTriangle& t : triangles_) {
    sum += near_.exact().height(v[t.low].index(), v[t.middle].index(), v[t.high].index(),
                                vertex_.index());
  }
  return sum;
}

InnerLoop::InnerLoop(const VertexHull& hull, const InnerOptions& options, InnerCounts& counts)
    : hull_(hull),
      options_(options),
      counts_(counts),
      near_(hull.points),
      mesh_(hull.points.size(), hull.triangles),
      loss_(near_, mesh_, options.seed, counts),
      queue_(hull.points.size()),
      upper_(hull.points.size()),
      stale_(hull.points.size(), false),
      terms_(hull.points.size()),
      exact_(hull.points.size()),
      left_(hull.points.size()) {
  if (options.vertices < 4) {
    throw Error(ErrorCode::InvalidArgument, "a solid has at least 4 vertices");
  }
  if (options.max_loss && *options.max_loss < 0) {
    throw Error(ErrorCode::InvalidArgument, "a limit of the loss is not negative");
  }
}

void InnerLoop::evaluate(VertexId v) {
  loss_.prepare(v);
  const Interval<double> bounds = loss_.bounds(terms_[v.index()]);
  stale_[v.index()] = false;
  exact_[v.index()].reset();
  upper_[v.index()] = bounds.upper;
  queue_.update(v, bounds.lower);
}

// The exact cost of a fresh entry, whose bounds become as narrow as doubles can be.
const Integer& InnerLoop::exact_cost(VertexId v) {
  std::optional<Integer>& exact = exact_[v.index()];
  if (exact) return *exact;
  ++counts_.exact_costs;
  loss_.prepare(v);
  exact = loss_.exactly();
  const Interval<double> bounds = near_.scaled(*exact);
  upper_[v.index()] = bounds.upper;
  queue_.update(v, bounds.lower);
  return *exact;
}

// Whether the top is fresh and its bounds are close; otherwise one step is made towards that. An
// upper bound far away would make too many entries candidates.
bool InnerLoop::is_top_tight() {
  constexpr double kClose = 1 + 0x1p-10;
  const VertexId top = queue_.top();
  if (stale_[top.index()]) {
    evaluate(top);
    return false;
  }
  if (upper_[top.index()] <= kClose * queue_.key(top) || exact_[top.index()]) return true;
  (void)exact_cost(top);
  return false;
}

bool InnerLoop::are_candidates_fresh() {
  bool all_fresh = true;
  for (const VertexId v : candidates_) {
    if (!stale_[v.index()]) continue;
    evaluate(v);
    all_fresh = false;
  }
  return all_fresh;
}

// Reduces fresh candidates to those of the least cost, in canonical order.
void InnerLoop::keep_cheapest() {
  double best = std::numeric_limits<double>::infinity();
  for (const VertexId v : candidates_) best = std::min(best, upper_[v.index()]);
  std::erase_if(candidates_, [&](VertexId v) { return queue_.key(v) > best; });
  if (candidates_.size() == 1) return;
  const Integer* least = nullptr;
  for (const VertexId v : candidates_) {
    const Integer& cost = exact_cost(v);
    if (least == nullptr || cost < *least) least = &cost;
  }
  std::erase_if(candidates_, [&](VertexId v) { return *exact_[v.index()] != *least; });
  std::sort(candidates_.begin(), candidates_.end());
}

// The tie: all of the least cost, ascending.
const std::vector<VertexId>& InnerLoop::choose() {
  for (;;) {
    if (!is_top_tight()) continue;
    queue_.collect(upper_[queue_.top().index()], candidates_);
    if (!are_candidates_fresh()) continue;
    if (candidates_.size() > 1) keep_cheapest();
    return candidates_;
  }
}

Step InnerLoop::record(const std::vector<VertexId>& tie) {
  const auto& v = loss_.ring().vertices;
  Step step{.removed = tie.front(), .tie = tie, .ring = v, .left = left_ - 1};
  step.triangles.reserve(loss_.triangles().size());
  for (const RingTriangle& t : loss_.triangles()) {
    step.triangles.push_back({v[t.low], v[t.middle], v[t.high]});
  }
  return step;
}

// The prepared one.
void InnerLoop::remove(VertexId v) {
  mesh_.remove(v, loss_.ring(), loss_.triangles());
  --left_;
  queue_.erase(v);
  for (const VertexId r : loss_.ring().vertices) {
    std::vector<FilteredLoss::Term>& terms = terms_[r.index()];
    std::erase_if(terms,
                  [&](const FilteredLoss::Term& t) { return t.a == v || t.b == v || t.c == v; });
    stale_[r.index()] = true;
    queue_.update(r, FilteredLoss::lower_bound(terms));
  }
}

InnerRun InnerLoop::run() {
  const VertexDeterminants& exact = near_.exact();
  std::optional<Rational> limit;  // of six times the volume lost
  if (options_.max_loss) {
    limit = *options_.max_loss * Rational(exact.six_volumes(hull_.triangles));
  }
  Integer lost = 0;
  InnerRun run;
  if (left_ > options_.vertices) {
    for (std::size_t v = 0; v < near_.size(); ++v) queue_.append(VertexId(v), 0);
    for (std::size_t v = 0; v < near_.size(); ++v) evaluate(VertexId(v));
  }
  while (left_ > options_.vertices) {
    options_.watch.ask();
    const std::vector<VertexId>& tie = choose();
    const VertexId v = tie.front();
    if (limit) {
      lost += exact_cost(v);
      if (Rational(lost) > *limit) {
        run.stop = InnerStop::LossLimit;
        break;
      }
    }
    loss_.prepare(v);
    run.steps.push_back(record(tie));
    remove(v);
    options_.watch.report(near_.size() - left_, near_.size() - options_.vertices);
  }
  run.triangles = mesh_.triangles();
  return run;
}

InnerRun simplify_inner_filtered(const VertexHull& hull, const InnerOptions& options,
                                 InnerCounts* counts) {
  InnerCounts own;
  return InnerLoop(hull, options, counts != nullptr ? *counts : own).run();
}

}  // namespace convexact
