// SPDX-License-Identifier: MIT
#include "parts/joined_hulls.hpp"

#include <algorithm>
#include <iterator>

#include "task/parallel.hpp"

namespace convexact {
namespace {

bool overlap(const NearBox& a, const NearBox& b) {
  return (a.low.array() < b.high.array() - kApart).all() &&
         (b.low.array() < a.high.array() - kApart).all();
}

// Whether there is a plane between two hulls: that of a facet of one of them, or of one of all
// differences of vertices.
bool are_apart(const Joined& a, const Joined& b) {
  if (!overlap(a.box, b.box)) return true;
  for (const auto& [one, other] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    for (const NearSolid::Plane& plane : one->planes) {
      const auto is_beyond = [&](const Point& y) {
        return plane.normal.dot(y) + plane.offset >= -kApart;
      };
      if (std::all_of(other->vertices.begin(), other->vertices.end(), is_beyond)) return true;
    }
  }
  std::vector<Point> differences;
  for (const Point& x : a.vertices) {
    for (const Point& y : b.vertices) differences.push_back(x - y);
  }
  const NearSolid hull = near_solid(differences);
  return hull.planes.empty() ||
         std::any_of(hull.planes.begin(), hull.planes.end(),
                     [](const NearSolid::Plane& plane) { return plane.offset >= -kApart; });
}

}  // namespace

PieceSet united(const PieceSet& a, const PieceSet& b) {
  PieceSet both;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both;
}

JoinedHulls::JoinedHulls(std::span<const std::vector<Point>> pieces, ReachLimit& limit,
                         bool keeps_apart, std::size_t jobs, const Watch& watch)
    : limit_(limit), keeps_apart_(keeps_apart), jobs_(jobs), watch_(watch) {
  std::vector<Wanted> wanted;
  for (std::uint32_t k = 0; k < pieces.size(); ++k) wanted.push_back({{k}, pieces[k]});
  add_all(std::move(wanted));
}

Joined& JoinedHulls::join(const Joined& a, const Joined& b) {
  PieceSet both = united(a.pieces, b.pieces);
  const auto known = hulls_.find(both);
  if (known != hulls_.end()) return *known->second;
  return add({std::move(both), points_of(a, b)});
}

std::vector<Joined*> JoinedHulls::join_each(std::span<Joined* const> others, const Joined& one) {
  std::vector<Wanted> wanted;
  for (const Joined* other : others) {
    PieceSet both = united(one.pieces, other->pieces);
    if (!hulls_.contains(both)) wanted.push_back({std::move(both), points_of(*other, one)});
  }
  add_all(std::move(wanted));
  std::vector<Joined*> joined;
  for (const Joined* other : others) joined.push_back(&join(*other, one));
  return joined;
}

Joined& JoinedHulls::of(PieceSet pieces) {
  const auto known = hulls_.find(pieces);
  if (known != hulls_.end()) return *known->second;
  std::vector<Point> points;
  for (const std::uint32_t k : pieces) {
    const std::vector<Point>& own = piece(k).vertices;
    points.insert(points.end(), own.begin(), own.end());
  }
  return add({std::move(pieces), std::move(points)});
}

bool JoinedHulls::is_refused(const PieceSet& pieces) const {
  return std::any_of(refused_.begin(), refused_.end(), [&](const PieceSet& set) {
    return set.size() <= pieces.size() &&
           std::includes(pieces.begin(), pieces.end(), set.begin(), set.end());
  });
}

bool JoinedHulls::allows(Joined& joined) {
  if (joined.is_allowed) return *joined.is_allowed;
  const bool is_hopeless = is_refused(joined.pieces);
  joined.is_allowed = !is_hopeless && limit_.allows_near(joined.vertices, watch_);
  if (!is_hopeless && !*joined.is_allowed) refused_.push_back(joined.pieces);
  return *joined.is_allowed;
}

bool JoinedHulls::allows(const Joined& a, const Joined& b) {
  if (!keeps_apart_) return true;
  const auto [known, is_new] = apart_.try_emplace(std::minmax(&a, &b), true);
  if (is_new) {
    watch_.ask();
    known->second = are_apart(a, b);
  }
  return known->second;
}

void JoinedHulls::forget(const PieceSet& pieces) {
  const auto known = hulls_.find(pieces);
  if (pieces.size() < 2 || known == hulls_.end()) return;
  if (known->second->is_allowed != true) hulls_.erase(known);
}

std::vector<Point> JoinedHulls::points_of(const Joined& a, const Joined& b) {
  std::vector<Point> points = a.vertices;
  points.insert(points.end(), b.vertices.begin(), b.vertices.end());
  return points;
}

void JoinedHulls::add_all(std::vector<Wanted> wanted) {
  std::vector<std::unique_ptr<Joined>> made(wanted.size());
  for_each_in_parallel(wanted.size(), jobs_,
                       [&](std::size_t i) { made[i] = make(std::move(wanted[i])); });
  for (std::unique_ptr<Joined>& joined : made) keep(std::move(joined));
}

std::unique_ptr<Joined> JoinedHulls::make(Wanted wanted) const {
  watch_.ask();
  NearSolid solid = near_solid(wanted.points);
  auto made = std::make_unique<Joined>(
      Joined{std::move(wanted.pieces), std::move(solid.vertices), solid.volume, {}});
  for (const Point& y : made->vertices) made->box.include(y);
  if (keeps_apart_) made->planes = std::move(solid.planes);
  return made;
}

Joined& JoinedHulls::keep(std::unique_ptr<Joined> made) {
  std::unique_ptr<Joined>& place = hulls_[made->pieces];
  if (place == nullptr) place = std::move(made);
  return *place;
}

}  // namespace convexact
