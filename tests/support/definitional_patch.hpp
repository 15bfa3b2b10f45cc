// SPDX-License-Identifier: MIT
// definitional_patch.hpp - some triangles of a surface as a graph, from the definitions: lengths of
// edges, shortest paths between all pairs, borders, and holes. For a few dozen points.
#pragma once
#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "convexact/cluster.hpp"

namespace definition {

using namespace convexact;

/// The least integer whose square is at least x >= 0, by halving an interval.
inline Integer least_root(const Rational& x) {
  Integer low = -1, high = 0;
  while (Rational(high * high) < x) high = 2 * high + 1;
  while (high - low > 1) {
    const Integer middle = (low + high) / 2;
    (Rational(middle * middle) < x ? low : high) = middle;
  }
  return high;
}

/// The sign of a / sqrt(n) + b / sqrt(m). The numbers have so few digits that 2000 bits show
/// whether it is 0.
inline Sign sign_of_sum(const Rational& a, const Rational& n, const Rational& b,
                        const Rational& m) {
  constexpr long kBits = 2000;
  const auto term = [&](const Rational& x, const Rational& y) {
    return Enclosure(x, kBits) / sqrt(Enclosure(y, kBits));
  };
  return (term(a, n) + term(b, m)).sign().value_or(Sign::Zero);
}

class Patch {
 public:
  using Ends = std::pair<PointId, PointId>;  // ascending

  /// @param exponent  Lengths are in units of 2^(exponent - 40).
  Patch(const Surface& surface, std::vector<TriangleId> of, long exponent)
      : triangles(std::move(of)), surface_(surface), exponent_(exponent) {
    std::set<PointId> found;
    for (const TriangleId t : triangles) {
      const auto& corners = surface.triangles[t.index()];
      found.insert(corners.begin(), corners.end());
      for (int k = 0; k < 3 && has_edges(t); ++k) {
        edges[std::minmax(corners[k], corners[(k + 1) % 3])].push_back(t);
      }
    }
    points.assign(found.begin(), found.end());
    find_distances();
    find_border();
  }

  std::vector<TriangleId> triangles;
  std::vector<PointId> points;                     ///< Ascending.
  std::map<Ends, std::vector<TriangleId>> edges;   ///< Of triangles with three corners.
  std::vector<std::vector<PointId>> border_loops;  ///< Each from its lowest step.

  bool is_edge(PointId a, PointId b) const { return edges.count(std::minmax(a, b)) > 0; }
  std::vector<PointId> beside(PointId p) const {
    std::vector<PointId> found;
    for (const PointId q : points) {
      if (is_edge(p, q)) found.push_back(q);
    }
    return found;
  }
  /// The triangles with edges at a point, ascending.
  std::vector<TriangleId> triangles_at(PointId p) const {
    std::vector<TriangleId> found;
    for (const TriangleId t : triangles) {
      const auto& corners = surface_.triangles[t.index()];
      if (has_edges(t) && std::count(corners.begin(), corners.end(), p) > 0) found.push_back(t);
    }
    return found;
  }

  Integer length(PointId a, PointId b) const {
    const Rational squared = (surface_.points[a] - surface_.points[b]).squaredNorm();
    return least_root(scale_by_power_of_two(squared, 2 * (40 - exponent_)));
  }
  bool is_reached(PointId a, PointId b) const { return distances_.count({a, b}) > 0; }
  const Integer& distance(PointId a, PointId b) const { return distances_.at({a, b}); }
  /// The number of edges from a to b. Precondition: b is reached.
  std::size_t steps(PointId a, PointId b) const { return steps_.at({a, b}); }

  /// Follows a shortest path back from its end over the lowest points; none if there is no path.
  std::vector<PointId> path(PointId from, PointId to) const {
    std::vector<PointId> made{to};
    if (!is_reached(from, to)) return {};
    while (made.front() != from) {
      for (const PointId q : beside(made.front())) {
        if (distance(from, q) + length(q, made.front()) != distance(from, made.front())) continue;
        made.insert(made.begin(), q);
        break;
      }
    }
    return made;
  }

  /// Whether a border leads from a, left of the path to b, into b, and leaves b to the right.
  bool spans_hole(PointId a, PointId b, const RationalVector3& n, const RationalVector3& m) const {
    const auto side = [&](PointId x) {
      const RationalPoint from = surface_.points[a];
      const RationalVector3 left = (surface_.points[b] - from).cross(surface_.points[x] - from);
      return sign_of_sum(left.dot(n), n.squaredNorm(), left.dot(m), m.squaredNorm());
    };
    for (const auto& loop : border_loops) {
      for (std::size_t start = 0; start < loop.size(); ++start) {
        std::vector<PointId> walk(loop);
        std::rotate(walk.begin(), walk.begin() + static_cast<std::ptrdiff_t>(start), walk.end());
        if (walk[0] != a) continue;
        walk.push_back(a);
        const auto end = std::find(walk.begin() + 1, walk.end(), b);
        if (end >= std::find(walk.begin() + 1, walk.end(), a)) continue;
        if (side(end[-1]) == Sign::Positive && side(end[1]) == Sign::Negative) return true;
      }
    }
    return false;
  }

 private:
  bool has_edges(TriangleId t) const {
    const auto& [a, b, c] = surface_.triangles[t.index()];
    return a != b && b != c && c != a;
  }

  // [Floyd 1962]
  void find_distances() {
    for (const PointId p : points) {
      distances_[{p, p}] = 0;
      steps_[{p, p}] = 0;
      for (const PointId q : beside(p)) {
        distances_[{p, q}] = length(p, q);
        steps_[{p, q}] = 1;
      }
    }
    const auto shorten = [&](auto& of, PointId a, PointId over, PointId b) {
      const auto first = of.find({a, over}), second = of.find({over, b});
      if (first == of.end() || second == of.end()) return;
      const auto sum = first->second + second->second;
      const auto [found, is_new] = of.try_emplace({a, b}, sum);
      if (sum < found->second) found->second = sum;
    };
    for (const PointId over : points) {
      for (const PointId a : points) {
        for (const PointId b : points) {
          shorten(distances_, a, over, b);
          shorten(steps_, a, over, b);
        }
      }
    }
  }

  // The step after another one along a border: in the same fan, to the lowest point.
  using Step = Ends;  // tail and head, along the only triangle of an edge
  const Step* next(const std::map<Step, TriangleId>& border, const Step& step) const {
    std::set<TriangleId> fan{border.at(step)};
    for (std::size_t before = 0; before != fan.size();) {
      before = fan.size();
      for (const auto& [ends, uses] : edges) {
        if (ends.first != step.second && ends.second != step.second) continue;
        const bool is_met =
            std::any_of(uses.begin(), uses.end(), [&](TriangleId t) { return fan.count(t) > 0; });
        if (is_met) fan.insert(uses.begin(), uses.end());
      }
    }
    for (const auto& [other, triangle] : border) {
      if (other.first == step.second && fan.count(triangle) > 0) return &other;
    }
    return nullptr;
  }

  void find_border() {
    std::map<Step, TriangleId> border;
    for (const auto& [ends, uses] : edges) {
      if (uses.size() > 1) continue;
      const auto& corners = surface_.triangles[uses[0].index()];
      for (int k = 0; k < 3; ++k) {
        const Step step(corners[k], corners[(k + 1) % 3]);
        if (step == ends || step == Step(ends.second, ends.first)) border[step] = uses[0];
      }
    }
    for (const auto& [first, triangle] : border) {
      std::vector<PointId> loop;
      const Step* step = &first;
      bool is_lowest = true;
      while (step != nullptr && loop.size() <= border.size() && is_lowest) {
        loop.push_back(step->first);
        step = next(border, *step);
        if (step == nullptr || *step == first) break;
        is_lowest = first < *step;
      }
      if (is_lowest && step != nullptr && *step == first) border_loops.push_back(loop);
    }
  }

  const Surface& surface_;
  long exponent_;
  std::map<Ends, Integer> distances_;  // by both ends, in any order
  std::map<Ends, std::size_t> steps_;
};

}  // namespace definition
