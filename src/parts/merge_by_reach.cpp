// SPDX-License-Identifier: MIT
#include "parts/merge_by_reach.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>
#include <tuple>

#include "near/frame.hpp"
#include "number/random.hpp"
#include "parts/joined_hulls.hpp"

namespace convexact {
namespace {

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
