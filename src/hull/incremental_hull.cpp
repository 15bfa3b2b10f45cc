// SPDX-License-Identifier: MIT
// The incremental hull as a triangulated surface, over any exact points; see docs/design/hull.md.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "convexact/error.hpp"
#include "hull/hull_observer.hpp"
#include "hull/hull_steps.hpp"
#include "number/random.hpp"
#include "task/parallel.hpp"

namespace convexact {
namespace {

// Triangle i of the fan is (rim[i], rim[i+1], apex), counter-clockwise from outside, and the
// center lies strictly below all of them; so around the axis from the center to the apex the
// rim turns once, by less than pi at each step.
template <ExactPoints Points>
class TriangleFan {
 public:
  explicit TriangleFan(const Points& points) : points_(points) {}

  // Starts a new fan; keeps the memory of the old one.
  void assign(PointId apex, std::span<const PointId> rim) {
    apex_ = apex;
    rim_ = rim;
    normals_.clear();
    const auto near = points_.near();
    for (const PointId p : rim) normals_.push_back(cross(near[apex.index()], near[p.index()]));
    split_ = 1;  // the first step turns by less than pi
    std::size_t end = rim.size();
    while (end - split_ > 1) {
      const std::size_t middle = (split_ + end) / 2;
      (side(0, rim[middle]) != Sign::Negative ? split_ : end) = middle;
    }
  }

  // A triangle whose cone from the center holds p, if any does. At most 2 + log2(rim) signs.
  std::size_t locate(PointId p) const {
    // Let f be the angle of p about the axis and t[i] that of rim[i], both in [0, 2 pi) from
    // t[0] = 0. The search is for the last i with t[i] <= f. side(i, p) tells the sign of sin(f -
    // t[i]), which is that of f - t[i] while both lie in the same half [0, pi] or [pi, 2 pi).
    const Sign first = side(0, p);
    if (first == Sign::Zero && side(1, p) != Sign::Positive) return 0;  // f = 0, or on the axis
    // f in (0, pi]: i <= split, the last with t[i] <= pi. f in (pi, 2 pi): i >= split.
    std::size_t low = first == Sign::Negative ? split_ : 0;
    std::size_t end = first == Sign::Negative ? rim_.size() : split_ + 1;
    while (end - low > 1) {
      const std::size_t middle = (low + end) / 2;
      (side(middle, p) != Sign::Negative ? low : end) = middle;
    }
    return low;
  }

 private:
  // The side of the half plane from the axis through rim[i] on which p lies; Positive means ahead.
  Sign side(std::size_t i, PointId p) const {
    return center_side_of(points_, normals_[i], apex_, rim_[i], p);
  }

  const Points& points_;
  PointId apex_;
  std::span<const PointId> rim_;
  std::vector<NearPoint> normals_;  // cross(apex, rim[i])
  std::size_t split_ = 0;           // the last rim vertex with an angle of at most pi
};

// Builds the hull of points about the centroid of `simplex`; see docs/design/hull.md.
//
// Every point that is still outside is listed with the one triangle that the ray from the
// center meets, which then is visible from it (strictly beyond): each point is stored once.
// Invariant between insertions: the triangles are a closed convex surface around the center.
// @par Source  [ClarksonShor1989], [deBerg2008, sec. 11.2], [Barber1996] for furthest-first
template <ExactPoints Points>
class IncrementalHull {
 public:
  // `points` outlive this and are centered at `simplex`; side(simplex 0, 1, 2, 3) is Negative.
  IncrementalHull(const Points& points, const std::array<PointId, 4>& simplex,
                  const HullOptions& options)
      : points_(points),
        near_(points.near()),
        next_(near_.size()),
        conflict_(near_.size(), kNone),
        horizon_at_(near_.size()),
        round_of_(near_.size(), 0),
        fan_(points),
        jobs_(Points::kForThreads ? options.jobs : 1),
        watch_(options.watch) {
    result_.inside.reserve(near_.size());
    // Memory for all of a small hull at once; a large one may have few triangles for its points.
    constexpr std::size_t kSmall = 256;
    result_.triangles.reserve(std::min(2 * near_.size(), kSmall));
    conflicts_.reserve(result_.triangles.capacity());
    start(simplex);
  }

  TriangulatedHull build(const HullOptions& options) && {
    // Furthest first finds extreme points early, but has no bound on its work: an adversary makes
    // it quadratic. So it has a budget of O(n log n) moves and triangles. The points left after
    // that are inserted in random order, whose expected bound holds after any start.
    const double n = static_cast<double>(near_.size());
    observer_ = options.observer;
    if (observer_ != nullptr) show_start();
    insert_furthest_first(options.furthest_first_effort * n * std::log2(n));
    insert_randomly(options.seed);
    compact();
    return std::move(result_);
  }

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;

  // The data of a triangle, besides its geometry, that an insertion needs.
  struct Conflicts {
    std::uint32_t first = kNone;  // point list, its highest point in front
    double highest = 0;
    std::uint32_t round = 0;  // when visibility was last decided ...
    bool visible = false;     // ... and how
    bool pending = false;     // whether it waits in pending_
    bool alive = false;
  };
  // An edge of the horizon, from the point `from`; `outer` lies beyond it.
  struct HorizonEdge {
    PointId from, to;
    std::uint32_t outer;
  };

  SurfaceTriangle& triangle(std::uint32_t t) { return result_.triangles[t]; }

  std::uint32_t add_triangle(PointId a, PointId b, PointId c) {
    std::uint32_t t;
    if (free_.empty()) {
      t = static_cast<std::uint32_t>(result_.triangles.size());
      result_.triangles.emplace_back();
      conflicts_.emplace_back();
    } else {
      t = free_.back();
      free_.pop_back();
    }
    triangle(t).plane = NearPlane::through(near_[a.index()], near_[b.index()], near_[c.index()]);
    triangle(t).corners = {a, b, c};
    Conflicts& state = conflicts_[t];
    state.first = kNone;
    state.highest = 0;
    state.round = round_;
    state.visible = false;
    state.alive = true;
    return t;
  }

  // The surface of the simplex, and every other point with the triangle that its ray meets.
  void start(const std::array<PointId, 4>& s) {
    round_ = 1;
    const std::array<PointId, 3> rim{s[0], s[1], s[2]};
    for (std::size_t k = 0; k < 3; ++k) {
      added_.push_back(add_triangle(rim[kNextCorner[k]], rim[k], s[3]));
    }
    const std::uint32_t base = add_triangle(s[0], s[1], s[2]);
    for (std::size_t k = 0; k < 3; ++k) {
      // Side k is (rim[k+1], rim[k], s[3]).
      triangle(added_[k]).neighbors = {base, added_[(k + 2) % 3], added_[(k + 1) % 3]};
      triangle(base).neighbors[k] = added_[k];
    }
    // As a fan about s[3] the three sides turn the other way round: rim 0, 2, 1.
    const std::array<PointId, 3> turn{s[0], s[2], s[1]};
    const std::array<std::uint32_t, 3> side{added_[2], added_[1], added_[0]};
    fan_.assign(s[3], turn);
    std::vector<PointId> rest;
    rest.reserve(near_.size() - s.size());
    for (std::size_t i = 0; i < near_.size(); ++i) {
      if (std::find(s.begin(), s.end(), PointId(i)) == s.end()) rest.emplace_back(i);
    }
    file_all(rest, [&](PointId p) {
      // The fan splits space about the axis; the edge of its rim splits each part once more.
      const std::size_t k = fan_.locate(p);
      const bool low = center_side_of(points_, turn[k], turn[(k + 1) % 3], p) == Sign::Negative;
      return low ? base : side[k];
    });
  }

  // The triangle whose cone from the center holds a point, and where it lies there.
  struct Place {
    std::uint32_t triangle;
    double height;
    bool is_beyond;
  };

  Place place(PointId p, std::uint32_t t) const {
    const SurfaceTriangle& s = result_.triangles[t];
    const double height = s.plane.height(near_[p.index()]);
    const auto certain = certain_sign(height, s.plane.bound);
    const Sign sign =
        certain ? *certain : points_.side(s.corners[0], s.corners[1], s.corners[2], p);
    return {t, height, sign == Sign::Positive};
  }

  // Lists each point with the triangle that `find` says, or discards it. Many points find their
  // places on several threads first: that is most of the work, and none depends on another.
  template <class Find>
  void file_all(std::span<const PointId> points, const Find& find) {
    constexpr std::size_t kTurn = 4096, kFewest = 4 * kTurn;
    if (jobs_ == 1 || points.size() < kFewest) {
      for (const PointId p : points) file(p, place(p, find(p)));
      return;
    }
    places_.resize(4 * kTurn * std::min(jobs_, points.size() / kTurn));
    for (std::size_t first = 0; first < points.size(); first += places_.size()) {
      watch_.ask();
      const auto some = points.subspan(first, std::min(places_.size(), points.size() - first));
      for_each_in_parallel((some.size() + kTurn - 1) / kTurn, jobs_, [&](std::size_t turn) {
        const std::size_t end = std::min(some.size(), (turn + 1) * kTurn);
        for (std::size_t k = turn * kTurn; k < end; ++k) places_[k] = place(some[k], find(some[k]));
      });
      for (std::size_t k = 0; k < some.size(); ++k) file(some[k], places_[k]);
    }
  }

  void file(PointId p, const Place& at) {
    const std::uint32_t t = at.triangle;
    if (!at.is_beyond) return give_up(p, t);
    conflict_[p.index()] = t;
    Conflicts& list = conflicts_[t];
    if (list.first == kNone) {
      next_[p.index()] = kNone;
      list.first = p.value;
      list.highest = at.height;
      if (!list.pending) pending_.push_back(t);
      list.pending = true;
    } else if (at.height > list.highest) {
      next_[p.index()] = list.first;
      list.first = p.value;
      list.highest = at.height;
    } else {
      next_[p.index()] = next_[list.first];
      next_[list.first] = p.value;
    }
  }

  // p lies in the cone of triangle t and not beyond it; t is its proof.
  void give_up(PointId p, std::uint32_t t) {
    conflict_[p.index()] = kNone;
    std::array<PointId, 3> proof = triangle(t).corners;
    for (const PointId corner : triangle(t).corners) {
      if (points_.equal(p, corner)) {
        result_.repeats.emplace_back(p, corner);
        proof = {corner, corner, corner};
        break;
      }
    }
    result_.inside.push_back({p, proof});
  }

  void insert_furthest_first(double budget) {
    while (pending_.size() > taken_ && work_ < budget) {
      const std::uint32_t t = take_pending();
      conflicts_[t].pending = false;
      if (conflicts_[t].alive && conflicts_[t].first != kNone) {
        insert(PointId(conflicts_[t].first), t);
      }
    }
  }

  // The triangle that has waited longest, at first: so a coarse hull is soon all around, most
  // points are inside it for good, and few triangles are made in vain. Then the last one, whose
  // surroundings are still in the cache.
  std::uint32_t take_pending() {
    constexpr std::size_t kCoarse = 256;
    if (taken_ < kCoarse) return pending_[taken_++];
    const std::uint32_t t = pending_.back();
    pending_.pop_back();
    return t;
  }

  void insert_randomly(std::uint64_t seed) {
    std::vector<PointId> order;
    for (std::size_t i = 0; i < near_.size(); ++i) {
      if (conflict_[i] != kNone) order.emplace_back(i);
    }
    if (order.empty()) return;  // a generator takes long to start for a small hull
    Random random(seed);
    shuffle(std::span(order), random);
    for (const PointId p : order) {
      if (conflict_[p.index()] != kNone) insert(p, conflict_[p.index()]);
    }
  }

  // One insertion, as in [deBerg2008, sec. 11.2]; `seed` is visible from apex.
  void insert(PointId apex, std::uint32_t seed) {
    watch_.ask();
    ++round_;
    // (1) Visible means strictly beyond. The visible triangles are a disk: spread from the seed.
    collect_visible(apex, seed);
    // (2) Its rim is one simple cycle.
    order_horizon();
    if (observer_ != nullptr) note_visible();
    // (3) Collect the points that lose their triangle, and the vertices that the new cone covers.
    collect_orphans(apex);
    // (4) Join apex to the horizon. Degenerate: were apex collinear with a ridge, it would be
    //     coplanar with both triangles there and see neither; so no new triangle is flat.
    join_to_horizon(apex);
    // (5) Seen from the center the old disk and the new cone cover the same directions, so the ray
    //     of each orphan meets one of the new triangles.
    redistribute(apex);
    if (observer_ != nullptr) show_insertion(apex);
  }

  void show_start() {
    std::vector<HullTriangle> simplex;
    for (const SurfaceTriangle& t : result_.triangles) simplex.push_back(t.corners);
    std::vector<FiledPoint> filed;
    for (std::size_t i = 0; i < conflict_.size(); ++i) note_filed(PointId(i), filed);
    observer_->start({simplex, filed, result_.inside});
  }

  void note_filed(PointId p, std::vector<FiledPoint>& filed) {
    if (const std::uint32_t t = conflict_[p.index()]; t != kNone) {
      filed.push_back({p, triangle(t).corners});
    }
  }

  // To be called before the slots of the visible triangles are used again.
  void note_visible() {
    inside_before_ = result_.inside.size();
    shown_visible_.clear();
    for (const std::uint32_t t : visible_) shown_visible_.push_back(triangle(t).corners);
  }

  void show_insertion(PointId apex) {
    std::vector<HullTriangle> added;
    for (const std::uint32_t t : added_) added.push_back(triangle(t).corners);
    std::vector<FiledPoint> filed;
    for (const PointId p : orphans_) note_filed(p, filed);
    observer_->inserted({apex, shown_visible_, rim_, added, filed,
                         std::span(result_.inside).subspan(inside_before_)});
  }

  bool is_visible(PointId apex, std::uint32_t t) {
    Conflicts& state = conflicts_[t];
    if (state.round != round_) {
      state.round = round_;
      state.visible =
          side_of(points_, triangle(t).plane, triangle(t).corners, apex) == Sign::Positive;
    }
    return state.visible;
  }

  void collect_visible(PointId apex, std::uint32_t seed) {
    visible_.assign(1, seed);
    edges_.clear();
    conflicts_[seed].round = round_;
    conflicts_[seed].visible = true;
    for (std::size_t i = 0; i < visible_.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t t = visible_[i], beyond = triangle(t).neighbors[k];
        const bool known = conflicts_[beyond].round == round_;
        if (is_visible(apex, beyond)) {
          if (!known) visible_.push_back(beyond);
        } else {
          const auto& corners = triangle(t).corners;
          edges_.push_back({corners[k], corners[kNextCorner[k]], beyond});
        }
      }
    }
  }

  void order_horizon() {
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      CONVEXACT_ASSERT(round_of_[edges_[i].from.index()] != round_);
      horizon_at_[edges_[i].from.index()] = static_cast<std::uint32_t>(i);
      round_of_[edges_[i].from.index()] = round_;
    }
    rim_.clear();
    outer_.clear();
    std::uint32_t i = 0;
    do {
      rim_.push_back(edges_[i].from);
      outer_.push_back(edges_[i].outer);
      i = horizon_at_[edges_[i].to.index()];
    } while (i != 0);
    CONVEXACT_ASSERT(rim_.size() == edges_.size());
  }

  void collect_orphans(PointId apex) {
    orphans_.clear();
    swallowed_.clear();
    for (const std::uint32_t t : visible_) {
      for (std::uint32_t p = conflicts_[t].first; p != kNone; p = next_[p]) {
        if (p != apex.value) orphans_.emplace_back(p);
      }
      conflicts_[t].alive = false;
    }
    // A disk of T triangles with r vertices on its rim has (T - r + 2) / 2 inside.
    if (visible_.size() + 2 > edges_.size()) {
      for (const std::uint32_t t : visible_) {
        for (const PointId p : triangle(t).corners) {
          if (round_of_[p.index()] == round_) continue;
          round_of_[p.index()] = round_;
          swallowed_.push_back(p);
        }
      }
    }
    conflict_[apex.index()] = kNone;
  }

  void join_to_horizon(PointId apex) {
    // The outer triangles look for their neighbors before the slots of these are used again.
    outer_edge_.clear();
    for (std::size_t i = 0; i < rim_.size(); ++i) {
      const auto& corners = triangle(outer_[i]).corners;
      const PointId to = rim_[i + 1 < rim_.size() ? i + 1 : 0];
      outer_edge_.push_back(corners[0] == to ? 0 : corners[1] == to ? 1 : 2);
    }
    free_.insert(free_.end(), visible_.begin(), visible_.end());
    added_.clear();
    for (std::size_t i = 0; i < rim_.size(); ++i) {
      const PointId to = rim_[i + 1 < rim_.size() ? i + 1 : 0];
      added_.push_back(add_triangle(rim_[i], to, apex));
    }
    for (std::size_t i = 0; i < rim_.size(); ++i) {
      const std::uint32_t ahead = added_[i + 1 < rim_.size() ? i + 1 : 0];
      const std::uint32_t behind = added_[i > 0 ? i - 1 : rim_.size() - 1];
      triangle(added_[i]).neighbors = {outer_[i], ahead, behind};
      triangle(outer_[i]).neighbors[outer_edge_[i]] = added_[i];
    }
    work_ += static_cast<double>(rim_.size() + orphans_.size());
  }

  void redistribute(PointId apex) {
    if (orphans_.empty() && swallowed_.empty()) return;
    fan_.assign(apex, rim_);
    file_all(orphans_, [&](PointId p) { return added_[fan_.locate(p)]; });
    for (const PointId p : swallowed_) give_up(p, added_[fan_.locate(p)]);
  }

  // Drops the free slots.
  void compact() {
    std::vector<std::uint32_t> moved(conflicts_.size());
    std::uint32_t count = 0;
    for (std::uint32_t t = 0; t < conflicts_.size(); ++t) {
      if (!conflicts_[t].alive) continue;
      moved[t] = count;
      triangle(count++) = triangle(t);
    }
    result_.triangles.resize(count);
    for (SurfaceTriangle& t : result_.triangles) {
      for (std::uint32_t& neighbor : t.neighbors) neighbor = moved[neighbor];
    }
  }

  const Points& points_;
  std::span<const NearPoint> near_;
  TriangulatedHull result_;
  std::vector<Conflicts> conflicts_;    // by triangle
  std::vector<std::uint32_t> free_;     // slots of dead triangles
  std::vector<std::uint32_t> pending_;  // triangles that may have points, behind those ...
  std::size_t taken_ = 0;               // ... taken from the front
  // By point: next in its list; its triangle or kNone; its horizon edge, valid in round_of_.
  std::vector<std::uint32_t> next_, conflict_, horizon_at_, round_of_;
  TriangleFan<Points> fan_;
  std::uint32_t round_ = 0;
  double work_ = 0;
  std::size_t jobs_;
  Watch watch_;
  HullObserver* observer_ = nullptr;
  // Of the current insertion; members to keep their memory.
  std::vector<std::uint32_t> visible_, outer_, added_;
  std::vector<std::uint8_t> outer_edge_;
  std::vector<HorizonEdge> edges_;
  std::vector<PointId> rim_, orphans_, swallowed_;
  std::vector<Place> places_;
  // For an observer: what it is shown, and how many points had been given up before.
  std::vector<HullTriangle> shown_visible_;
  std::size_t inside_before_ = 0;
};

}  // namespace

template <ExactPoints Points>
TriangulatedHull triangulate(const Points& points, const std::array<PointId, 4>& simplex,
                             const HullOptions& options) {
  return IncrementalHull(points, simplex, options).build(options);
}

template TriangulatedHull triangulate(const DoublePoints&, const std::array<PointId, 4>&,
                                      const HullOptions&);
template TriangulatedHull triangulate(const HomogeneousPoints&, const std::array<PointId, 4>&,
                                      const HullOptions&);

}  // namespace convexact
