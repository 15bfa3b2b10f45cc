// SPDX-License-Identifier: MIT
#include "parts/merge_by_reach.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <set>
#include <tuple>

#include "hull/near_solid.hpp"
#include "near/frame.hpp"
#include "number/random.hpp"
#include "surface/box_tree.hpp"
#include "task/parallel.hpp"

namespace convexact {
namespace {

using PieceSet = std::vector<std::uint32_t>;  // ascending

PieceSet united(const PieceSet& a, const PieceSet& b) {
  PieceSet both;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both;
}

// The common hull of some pieces.
struct Joined {
  PieceSet pieces;
  std::vector<Point> vertices;
  double volume = 0;
  NearBox box;
  std::optional<bool> is_allowed = {};
  std::vector<NearSolid::Plane> planes = {};  // if parts are kept apart
};

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

// The hulls that were asked for, so that no question is asked twice; those that exchanges asked for
// in vain are forgotten.
class JoinedHulls {
 public:
  JoinedHulls(std::span<const std::vector<Point>> pieces, ReachLimit& limit, bool keeps_apart,
              std::size_t jobs, const Watch& watch)
      : limit_(limit), keeps_apart_(keeps_apart), jobs_(jobs), watch_(watch) {
    std::vector<Wanted> wanted;
    for (std::uint32_t k = 0; k < pieces.size(); ++k) wanted.push_back({{k}, pieces[k]});
    add_all(std::move(wanted));
  }

  Joined& piece(std::uint32_t k) { return *hulls_.at({k}); }
  Joined& join(const Joined& a, const Joined& b) {
    PieceSet both = united(a.pieces, b.pieces);
    const auto known = hulls_.find(both);
    if (known != hulls_.end()) return *known->second;
    return add({std::move(both), points_of(a, b)});
  }
  // Each of several with one, on several threads.
  std::vector<Joined*> join_each(std::span<Joined* const> others, const Joined& one) {
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

  Joined& of(PieceSet pieces) {
    const auto known = hulls_.find(pieces);
    if (known != hulls_.end()) return *known->second;
    std::vector<Point> points;
    for (const std::uint32_t k : pieces) {
      const std::vector<Point>& own = piece(k).vertices;
      points.insert(points.end(), own.begin(), own.end());
    }
    return add({std::move(pieces), std::move(points)});
  }

  // What holds pieces that were refused is refused.
  bool is_refused(const PieceSet& pieces) const {
    return std::any_of(refused_.begin(), refused_.end(), [&](const PieceSet& set) {
      return set.size() <= pieces.size() &&
             std::includes(pieces.begin(), pieces.end(), set.begin(), set.end());
    });
  }

  bool allows(Joined& joined) {
    if (joined.is_allowed) return *joined.is_allowed;
    const bool is_hopeless = is_refused(joined.pieces);
    joined.is_allowed = !is_hopeless && limit_.allows_near(joined.vertices, watch_);
    if (!is_hopeless && !*joined.is_allowed) refused_.push_back(joined.pieces);
    return *joined.is_allowed;
  }

  // Drops the hull of several pieces unless it is allowed. Which pieces were refused is still
  // known. Single pieces stay, since piece() needs them.
  void forget(const PieceSet& pieces) {
    const auto known = hulls_.find(pieces);
    if (pieces.size() < 2 || known == hulls_.end()) return;
    if (known->second->is_allowed != true) hulls_.erase(known);
  }

  // Whether two hulls may be parts together.
  bool allows(const Joined& a, const Joined& b) {
    if (!keeps_apart_) return true;
    const auto [known, is_new] = apart_.try_emplace(std::minmax(&a, &b), true);
    if (is_new) {
      watch_.ask();
      known->second = are_apart(a, b);
    }
    return known->second;
  }

 private:
  struct Wanted {
    PieceSet pieces;
    std::vector<Point> points;
  };

  static std::vector<Point> points_of(const Joined& a, const Joined& b) {
    std::vector<Point> points = a.vertices;
    points.insert(points.end(), b.vertices.begin(), b.vertices.end());
    return points;
  }

  Joined& add(Wanted wanted) { return keep(make(std::move(wanted))); }
  void add_all(std::vector<Wanted> wanted) {
    std::vector<std::unique_ptr<Joined>> made(wanted.size());
    for_each_in_parallel(wanted.size(), jobs_,
                         [&](std::size_t i) { made[i] = make(std::move(wanted[i])); });
    for (std::unique_ptr<Joined>& joined : made) keep(std::move(joined));
  }
  std::unique_ptr<Joined> make(Wanted wanted) const {
    watch_.ask();
    NearSolid solid = near_solid(wanted.points);
    auto made = std::make_unique<Joined>(
        Joined{std::move(wanted.pieces), std::move(solid.vertices), solid.volume, {}, {}});
    for (const Point& y : made->vertices) made->box.include(y);
    if (keeps_apart_) made->planes = std::move(solid.planes);
    return made;
  }
  Joined& keep(std::unique_ptr<Joined> made) {
    std::unique_ptr<Joined>& place = hulls_[made->pieces];
    if (place == nullptr) place = std::move(made);
    return *place;
  }

  ReachLimit& limit_;
  bool keeps_apart_;
  const std::size_t jobs_;
  const Watch& watch_;
  std::map<std::pair<const Joined*, const Joined*>, bool> apart_;
  std::map<PieceSet, std::unique_ptr<Joined>> hulls_;
  std::vector<PieceSet> refused_;
};

class ReachMerger {
 public:
  ReachMerger(std::size_t pieces, JoinedHulls& hulls, double distance,
              const ReachMergeOptions& options)
      : hulls_(hulls), distance_(distance), options_(options) {
    for (std::uint32_t k = 0; k < pieces; ++k) parts_.push_back(&hulls.piece(k));
    volume_ = total_volume();
  }

  // With other preferences for each random number; none: as they are.
  void run(Random* random) {
    random_ = random;
    tries_ = options_.exchanges * parts_.size();
    merge();
    while (options_.eliminate && eliminate_one()) {
    }
  }

  // The two whose hull adds least, again and again, whatever the limit says.
  bool merge_down_to(std::size_t most) {
    bool is_beyond = false;
    while (parts_.size() > most) {
      std::optional<std::tuple<double, std::size_t, std::size_t>> best;
      for (std::size_t b = 0; b < parts_.size(); ++b) {
        for (std::size_t a = 0; a < b; ++a) {
          const double added =
              hulls_.join(*parts_[a], *parts_[b]).volume - parts_[a]->volume - parts_[b]->volume;
          if (!best || added < std::get<0>(*best)) best = {added, a, b};
        }
      }
      const auto [added, a, b] = *best;
      parts_[a] = &hulls_.join(*parts_[a], *parts_[b]);
      is_beyond = is_beyond || !hulls_.allows(*parts_[a]);
      parts_.erase(parts_.begin() + static_cast<long>(b));
    }
    return is_beyond;
  }

  std::size_t size() const { return parts_.size(); }
  double total_volume() const {
    return std::accumulate(parts_.begin(), parts_.end(), 0.0,
                           [](double sum, const Joined* part) { return sum + part->volume; });
  }
  std::vector<PieceSet> parts() const {
    std::vector<PieceSet> list;
    for (const Joined* part : parts_) list.push_back(part->pieces);
    std::sort(list.begin(), list.end());
    return list;
  }

 private:
  double key(double added) {
    constexpr std::uint64_t kMost = 2048, kMiddle = kMost / 2;
    if (random_ == nullptr) return added;
    return added * static_cast<double>(1 + uniform_below(*random_, kMost)) / kMiddle;
  }

  // Where all together are too large already, they may at least not grow.
  bool is_small(double volume) const { return volume <= std::max(options_.most_volume, volume_); }

  bool are_near(const Joined& a, const Joined& b) const {
    for (int k = 0; k < 3; ++k) {
      if (a.box.high[k] + distance_ < b.box.low[k] || b.box.high[k] + distance_ < a.box.low[k]) {
        return false;
      }
    }
    return true;
  }

  // Parts have numbers; a merged one has a new number.
  void merge() {
    std::vector<Joined*> numbered = parts_;
    std::set<std::uint32_t> alive;
    std::set<std::tuple<double, std::uint32_t, std::uint32_t>> queue;
    const auto add = [&](std::uint32_t b) {
      std::vector<std::uint32_t> near;
      std::vector<Joined*> others;
      for (const std::uint32_t a : alive) {
        if (!are_near(*numbered[a], *numbered[b])) continue;
        near.push_back(a);
        others.push_back(numbered[a]);
      }
      const std::vector<Joined*> joined = hulls_.join_each(others, *numbered[b]);
      for (std::size_t k = 0; k < near.size(); ++k) {
        const double added = joined[k]->volume - others[k]->volume - numbered[b]->volume;
        queue.emplace(key(added), std::min(near[k], b), std::max(near[k], b));
      }
      alive.insert(b);
    };
    for (std::uint32_t k = 0; k < numbered.size(); ++k) add(k);
    while (!queue.empty()) {
      const auto [cost, a, b] = *queue.begin();
      queue.erase(queue.begin());
      if (!alive.contains(a) || !alive.contains(b)) continue;
      Joined& both = hulls_.join(*numbered[a], *numbered[b]);
      const double volume = volume_ + both.volume - numbered[a]->volume - numbered[b]->volume;
      if (!is_small(volume) || !hulls_.allows(both)) continue;
      const bool is_apart =
          std::all_of(alive.begin(), alive.end(), [&, a = a, b = b](std::uint32_t c) {
            return c == a || c == b || hulls_.allows(both, *numbered[c]);
          });
      if (!is_apart) continue;
      volume_ = volume;
      alive.erase(a);
      alive.erase(b);
      numbered.push_back(&both);
      add(static_cast<std::uint32_t>(numbered.size() - 1));
    }
    parts_.clear();
    for (const std::uint32_t k : alive) parts_.push_back(numbered[k]);
  }

  // Whether a part could be given up, smallest first.
  bool eliminate_one() {
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t k = 0; k < parts_.size(); ++k) order.emplace_back(key(parts_[k]->volume), k);
    std::sort(order.begin(), order.end());
    return std::any_of(order.begin(), order.end(),
                       [&](const auto& entry) { return give_up(entry.second); });
  }

  bool give_up(std::size_t gone) {
    Arrangement others{parts_, volume_ - parts_[gone]->volume};
    others.parts.erase(others.parts.begin() + static_cast<long>(gone));
    for (const std::uint32_t piece : parts_[gone]->pieces) {
      std::vector<bool> entered(others.parts.size());
      if (!place(piece, others, entered)) return false;
    }
    parts_ = std::move(others.parts);
    volume_ = others.volume;
    return true;
  }

  struct Arrangement {
    std::vector<Joined*> parts;
    double volume;
  };

  bool replace(std::size_t k, Joined& by, Arrangement& in) {
    const double volume = in.volume + by.volume - in.parts[k]->volume;
    if (!is_small(volume) || !hulls_.allows(by)) return false;
    for (std::size_t other = 0; other < in.parts.size(); ++other) {
      if (other != k && !hulls_.allows(by, *in.parts[other])) return false;
    }
    in.parts[k] = &by;
    in.volume = volume;
    return true;
  }

  // Takes a piece into the part that grows least, or else into one that gives away another piece,
  // which finds a place likewise: as a matching grows by an augmenting path. Each part gives away
  // once at most.
  bool place(std::uint32_t piece, Arrangement& in, std::vector<bool>& entered) {
    std::vector<std::size_t> near;
    std::vector<Joined*> others;
    for (std::size_t k = 0; k < in.parts.size(); ++k) {
      if (!are_near(*in.parts[k], hulls_.piece(piece))) continue;
      near.push_back(k);
      others.push_back(in.parts[k]);
    }
    const std::vector<Joined*> joined = hulls_.join_each(others, hulls_.piece(piece));
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < near.size(); ++i) {
      order.emplace_back(joined[i]->volume - others[i]->volume, near[i]);
    }
    std::sort(order.begin(), order.end());
    for (const auto& [added, k] : order) {
      if (replace(k, hulls_.join(*in.parts[k], hulls_.piece(piece)), in)) return true;
    }
    for (const auto& [added, k] : order) {
      if (entered[k]) continue;
      entered[k] = true;
      const PieceSet own = in.parts[k]->pieces;
      for (const std::uint32_t away : own) {
        if (tries_ == 0) return false;
        --tries_;
        PieceSet others = own;
        std::erase(others, away);
        const PieceSet wanted = united(others, {piece});
        if (hulls_.is_refused(wanted)) continue;
        Arrangement next = in;
        if (!replace(k, hulls_.of(wanted), next)) {
          hulls_.forget(wanted);
          continue;
        }
        if (!place(away, next, entered)) continue;
        in = std::move(next);
        return true;
      }
    }
    return false;
  }

  JoinedHulls& hulls_;
  double distance_;
  const ReachMergeOptions& options_;
  std::vector<Joined*> parts_;
  double volume_ = 0;
  std::size_t tries_ = 0;  // exchanges that are left
  Random* random_ = nullptr;
};

}  // namespace

ReachMerged merge_by_reach(std::span<const std::vector<Point>> pieces, ReachLimit& limit,
                           const ReachMergeOptions& options, const Watch& watch) {
  JoinedHulls hulls(pieces, limit, options.keeps_apart, options.jobs, watch);
  const double distance = limit.frame().root_up(limit.squared_limit());
  Random random(options.seed);
  std::optional<ReachMerger> best;
  for (int round = 0; round < options.rounds; ++round) {
    ReachMerger merger(pieces.size(), hulls, distance, options);
    merger.run(round == 0 ? nullptr : &random);
    if (!best || std::pair(merger.size(), merger.total_volume()) <
                     std::pair(best->size(), best->total_volume())) {
      best.emplace(merger);
    }
  }
  ReachMerged made;
  if (options.most_parts > 0) made.is_beyond = best->merge_down_to(options.most_parts);
  made.parts = best->parts();
  return made;
}

}  // namespace convexact
