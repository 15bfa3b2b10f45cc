// SPDX-License-Identifier: MIT
// definitional_tree.hpp - the tree of split() by replaying it from the definitions.
#pragma once
#include "definitional_split.hpp"

namespace definition {

struct Plane {
  PointId to;
  std::vector<TriangleId> triangles;
  Halfspace plane;
};

/// The planes at a notch in the order in which they are tried.
class SplitPlanes {
 public:
  SplitPlanes(const Surface& surface, const Patch& patch, PointId notch)
      : surface_(surface), notch_(notch) {
    std::optional<Plane> at_border;
    for (const PointId to : patch.beside(notch)) {
      std::vector<TriangleId> at;
      for (const TriangleId t : patch.edges.at(std::minmax(notch, to))) {
        if (!area(t).isZero()) at.push_back(t);
      }
      if (at.size() == 1 && !at_border) at_border = plane(to, at, area(at[0]));
      for (std::size_t i = 0; i < at.size(); ++i) {
        for (std::size_t j = i + 1; j < at.size(); ++j) add(to, at[i], at[j]);
      }
    }
    for (const auto& [rank, ranked] : ranked_) planes.push_back(ranked);
    if (planes.empty() && at_border) planes.push_back(*at_border);
  }

  std::vector<Plane> planes;

 private:
  RationalVector3 area(TriangleId t) const {
    const auto& [a, b, c] = surface_.triangles[t.index()];
    const RationalPoint at = surface_.points[a];
    return (surface_.points[b] - at).cross(surface_.points[c] - at);
  }
  // Multiples of 2^-20, as integers. No component is in the middle of two.
  static RationalVector3 rounded_unit(const RationalVector3& n) {
    RationalVector3 unit;
    for (int k = 0; k < 3; ++k) {
      const Rational twice_squared = scale_by_power_of_two(n[k] * n[k] / n.squaredNorm(), 42);
      unit[k] = Rational(least_root(twice_squared) / 2) * (n[k] < 0 ? -1 : 1);
    }
    return unit;
  }
  std::optional<Plane> plane(PointId to, const std::vector<TriangleId>& at,
                             const RationalVector3& across) const {
    const RationalPoint from = surface_.points[notch_];
    const RationalVector3 normal = (surface_.points[to] - from).cross(across);
    if (normal.isZero()) return {};
    return Plane{to, at, Halfspace(normal, -normal.dot(from))};
  }
  void add(PointId to, TriangleId first, TriangleId second) {
    const RationalVector3 n = area(first), m = area(second);
    const Rational along = n.dot(m);
    const Rational squared = along * along / (n.squaredNorm() * m.squaredNorm());
    const RationalVector3 u = rounded_unit(n), v = rounded_unit(m);
    const Rational unit = Rational(1 << 20);
    RationalVector3 across = u + v;
    if (squared < Rational(1, 25)) {
      const Rational d = abs(Rational(u.dot(v))) / (unit * unit);
      across = d * u + (1 - d) * v;
    }
    const auto made = plane(to, {first, second}, across);
    if (!made) return;
    const auto& corners = surface_.triangles[second.index()];
    const bool is_concave = std::any_of(corners.begin(), corners.end(), [&](PointId p) {
      return p != notch_ && p != to && n.dot(surface_.points[p] - surface_.points[notch_]) > 0;
    });
    const Rational cosine = along < 0 ? Rational(-squared) : squared;
    ranked_.emplace(Rank{!is_concave, cosine, to, first, second}, *made);
  }

  using Rank = std::tuple<bool, Rational, PointId, TriangleId, TriangleId>;
  const Surface& surface_;
  PointId notch_;
  std::map<Rank, Plane> ranked_;
};

/// Triangles that move as one: those without area with the one that they are attached to.
class SplitUnits {
 public:
  SplitUnits(const Surface& surface, Connect connect,
             const std::vector<std::pair<TriangleId, TriangleId>>& united)
      : surface_(surface) {
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) unit_[TriangleId(t)] = TriangleId(t);
    for (const auto& [a, b] : united) {
      const auto [low, high] = std::minmax(unit_[a], unit_[b]);
      const TriangleId name = low, gone = high;
      for (auto& [t, unit] : unit_) {
        if (unit == gone) unit = name;
      }
    }
    for (const auto& [a, b] : neighbours(surface, connect)) {
      beside_[unit_[a]].insert(unit_[b]);
      beside_[unit_[b]].insert(unit_[a]);
    }
  }

  TriangleId of(TriangleId t) const { return unit_.at(t); }
  std::set<TriangleId> all() const { return of(everything()); }
  std::set<TriangleId> of(const std::vector<TriangleId>& triangles) const {
    std::set<TriangleId> units;
    for (const TriangleId t : triangles) units.insert(of(t));
    return units;
  }
  std::vector<TriangleId> triangles(const std::set<TriangleId>& units) const {
    std::vector<TriangleId> found;
    for (const auto& [t, unit] : unit_) {
      if (units.count(unit) > 0) found.push_back(t);
    }
    return found;
  }
  /// Those among some units that are reached from one of them.
  std::set<TriangleId> reached(TriangleId first, const std::set<TriangleId>& among) const {
    std::set<TriangleId> found{first};
    for (std::size_t before = 0; before != found.size();) {
      before = found.size();
      for (const TriangleId unit : std::set<TriangleId>(found)) {
        const auto beside = beside_.find(unit);
        if (beside == beside_.end()) continue;
        for (const TriangleId other : beside->second) {
          if (among.count(other) > 0) found.insert(other);
        }
      }
    }
    return found;
  }
  /// Decided by the centroid of its triangle with an area.
  bool is_beyond(const Halfspace& plane, TriangleId unit) const {
    const std::vector<TriangleId> of_unit = triangles({unit});
    const auto shown = std::find_if(of_unit.begin(), of_unit.end(), [&](TriangleId t) {
      const auto& [a, b, c] = surface_.triangles[t.index()];
      const RationalVector3 u = surface_.points[b] - surface_.points[a];
      return !u.cross(surface_.points[c] - surface_.points[a]).isZero();
    });
    const auto& [a, b, c] =
        surface_.triangles[(shown == of_unit.end() ? of_unit.front() : *shown).index()];
    const RationalPoint sum = surface_.points[a] + surface_.points[b] + surface_.points[c];
    return plane(sum / Rational(3)) > 0;
  }

 private:
  std::vector<TriangleId> everything() const {
    std::vector<TriangleId> all;
    for (const auto& [t, unit] : unit_) all.push_back(t);
    return all;
  }
  const Surface& surface_;
  std::map<TriangleId, TriangleId> unit_;  // its lowest triangle
  std::map<TriangleId, std::set<TriangleId>> beside_;
};

struct Halves {
  std::vector<TriangleId> kept, moved, islands;
};

inline std::optional<Halves> halves_of(const SplitUnits& units, const Patch& patch, PointId notch,
                                       const Plane& plane) {
  const std::set<TriangleId> all = units.of(patch.triangles);
  std::vector<TriangleId> at_notch;  // those at the edge first
  for (const TriangleId t : plane.triangles) at_notch.push_back(units.of(t));
  const std::set<TriangleId> others = units.of(patch.triangles_at(notch));
  at_notch.insert(at_notch.end(), others.begin(), others.end());
  const auto first_of = [&](const std::set<TriangleId>& among) {
    const auto found = std::find_if(at_notch.begin(), at_notch.end(),
                                    [&](TriangleId unit) { return among.count(unit) > 0; });
    return found == at_notch.end() ? std::optional<TriangleId>() : *found;
  };
  const auto without = [](std::set<TriangleId> a, const std::set<TriangleId>& b) {
    for (const TriangleId t : b) a.erase(t);
    return a;
  };
  std::set<TriangleId> beyond;
  for (const TriangleId unit : all) {
    if (units.is_beyond(plane.plane, unit)) beyond.insert(unit);
  }
  const auto goes = first_of(beyond);
  if (!goes) return {};
  const std::set<TriangleId> moved = units.reached(*goes, beyond);
  const std::set<TriangleId> rest = without(all, moved);
  const auto stays = first_of(rest);
  if (!stays) return {};
  const std::set<TriangleId> kept = units.reached(*stays, rest);
  return Halves{units.triangles(kept), units.triangles(moved),
                units.triangles(without(rest, kept))};
}

/// The whole run.
class SplitReplay {
 public:
  /// @param exponent  Of the lengths. @param united  As SplitTree.
  SplitReplay(const Surface& surface, const SplitOptions& options, long exponent,
              const std::vector<std::pair<TriangleId, TriangleId>>& united)
      : surface_(surface),
        options_(options),
        exponent_(exponent),
        units_(surface, options.connect, united) {
    made_.united = united;
    made_.squared_diameter = bounding_box(surface.points).squared_diameter();
    made_.squared_limit = options.limit.value * options.limit.value;
    if (options.limit.is_share) made_.squared_limit *= made_.squared_diameter;
  }

  SplitTree run() {
    std::set<TriangleId> left = units_.all();
    while (!left.empty()) {
      const std::set<TriangleId> group = units_.reached(*left.begin(), units_.all());
      for (const TriangleId unit : group) left.erase(unit);
      add(units_.triangles(group), {});
    }
    made_.roots = made_.nodes.size();
    while (const auto deepest = worst_leaf()) {
      if (options_.max_parts && made_.roots + made_.splits.size() >= *options_.max_parts) {
        made_.stopped_by_count = true;
        break;
      }
      split(*deepest);
    }
    for (std::uint32_t n = 0; n < made_.nodes.size(); ++n) {
      if (made_.nodes[n].is_split) continue;
      const LeafStatus status = unsplittable_.count(n) > 0 ? LeafStatus::Unsplittable
                                : is_beyond(n)             ? LeafStatus::MaxParts
                                                           : LeafStatus::WithinLimit;
      made_.leaves.push_back({n, status, parts_[n].patch.triangles, parts_[n].least_squared});
    }
    std::sort(made_.leaves.begin(), made_.leaves.end(),
              [](const auto& a, const auto& b) { return a.triangles[0] < b.triangles[0]; });
    return made_;
  }

 private:
  bool is_beyond(std::uint32_t n) const {
    return parts_[n].concavity.squared > made_.squared_limit;
  }
  std::optional<std::uint32_t> worst_leaf() const {
    std::optional<std::uint32_t> worst;
    for (std::uint32_t n = 0; n < made_.nodes.size(); ++n) {
      if (made_.nodes[n].is_split || !is_beyond(n) || unsplittable_.count(n) > 0) continue;
      const auto rank = [&](std::uint32_t m) {
        return std::pair(-made_.nodes[m].concavity.squared, made_.nodes[m].lowest);
      };
      if (!worst || rank(n) < rank(*worst)) worst = n;
    }
    return worst;
  }
  void add(std::vector<TriangleId> triangles, std::optional<std::uint32_t> parent) {
    parts_.emplace_back(surface_, std::move(triangles), exponent_, options_);
    const SplitPart& part = parts_.back();
    SplitNode& node = made_.nodes.emplace_back();
    node.parent = parent;
    node.lowest = part.patch.triangles.front();
    node.triangle_count = part.patch.triangles.size();
    node.concavity = part.concavity;
    node.notch = part.notch.value_or(PointId(0));
    node.association = part.association;
  }
  void split(std::uint32_t n) {
    const PointId notch = *parts_[n].notch;
    std::size_t refused = 0;
    for (const Plane& plane : SplitPlanes(surface_, parts_[n].patch, notch).planes) {
      const auto halves = halves_of(units_, parts_[n].patch, notch, plane);
      if (!halves) {
        ++refused;
        continue;
      }
      made_.splits.push_back(
          {n, {notch, plane.to}, plane.plane, refused, halves->moved, halves->islands});
      std::vector<TriangleId> gone = halves->moved;
      gone.insert(gone.end(), halves->islands.begin(), halves->islands.end());
      std::sort(gone.begin(), gone.end());
      const auto first = static_cast<std::uint32_t>(made_.nodes.size());
      made_.nodes[n].is_split = true;
      made_.nodes[n].children = {first, first + 1};
      add(halves->kept, n);
      add(gone, n);
      return;
    }
    unsplittable_.insert(n);
  }

  const Surface& surface_;
  const SplitOptions& options_;
  long exponent_;
  SplitUnits units_;
  SplitTree made_;
  std::vector<SplitPart> parts_;  // by node
  std::set<std::uint32_t> unsplittable_;
};

}  // namespace definition
