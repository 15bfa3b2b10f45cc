// SPDX-License-Identifier: MIT
// halfspace_arrangement.hpp - intersections of a few dozen halfspaces straight from the definition:
// every point where three planes meet is tried. No duality, no incremental structure.
#pragma once
#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "convexact/cost.hpp"
#include "convexact/geometry.hpp"
#include "number/arithmetic.hpp"

namespace definition {

using namespace convexact;
using Subset = std::uint64_t;  // of at most 64 halfspaces, bit i for halfspace i

struct PointOrder {
  bool operator()(const RationalPoint& a, const RationalPoint& b) const {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  }
};

class HalfspaceArrangement {
 public:
  explicit HalfspaceArrangement(std::vector<Halfspace> halfspaces);

  std::size_t size() const { return halfspaces_.size(); }
  Subset all() const { return size() == 64 ? ~Subset{0} : (Subset{1} << size()) - 1; }
  /// Whether the intersection of these halfspaces (not empty) holds no ray.
  bool is_bounded(Subset chosen) const;
  /// Volume of the intersection; none if it is unbounded.
  std::optional<Rational> volume(Subset chosen) const;
  /// Volume, area or mean width of the intersection; none if it is unbounded.
  /// Precondition: none of the halfspaces is redundant, and they span a volume.
  std::optional<Cost> measure(Subset chosen, CostMeasure measure) const;

 private:
  struct Meeting {
    RationalPoint point;
    Subset violated = 0;          // halfspaces that exclude the point
    Subset on = 0;                // planes through it
    std::vector<Subset> triples;  // planes that meet in it and nowhere else
  };
  static bool contains(Subset outer, Subset inner) { return (inner & ~outer) == 0; }
  static bool has(Subset set, std::size_t i) { return set >> i & 1; }
  bool is_vertex(const Meeting& meeting, Subset chosen) const;
  std::vector<const Meeting*> vertices_of(Subset chosen) const;
  std::vector<RationalVector3> corners_of(std::size_t i,
                                          const std::vector<const Meeting*>& vertices) const;
  std::vector<Rational> facet_terms(std::size_t i,
                                    const std::vector<const Meeting*>& vertices) const;
  Cost area(Subset chosen) const;
  Cost mean_width(Subset chosen) const;

  std::vector<Halfspace> halfspaces_;
  std::vector<Meeting> meetings_;
  // For each direction +-(n_a x n_b): the two planes, and the halfspaces that do not hold the ray.
  std::vector<std::pair<Subset, Subset>> rays_;
};

inline HalfspaceArrangement::HalfspaceArrangement(std::vector<Halfspace> halfspaces)
    : halfspaces_(std::move(halfspaces)) {
  std::map<RationalPoint, Meeting, PointOrder> meetings;
  const std::size_t n = size();
  const auto bit = [](std::size_t i) { return Subset{1} << i; };
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const IntegerVector3 ray = halfspaces_[a].normal().cross(halfspaces_[b].normal());
      if (ray == IntegerVector3::Zero()) continue;
      Subset against = 0, against_opposite = 0;
      for (std::size_t i = 0; i < n; ++i) {
        const Integer slope = halfspaces_[i].normal().dot(ray);
        if (slope > 0) against |= bit(i);
        if (slope < 0) against_opposite |= bit(i);
      }
      rays_.push_back({bit(a) | bit(b), against});
      rays_.push_back({bit(a) | bit(b), against_opposite});
      for (std::size_t c = 0; c < b; ++c) {
        if (halfspaces_[c].normal().dot(ray) == 0) continue;
        const RationalPoint x = meet(halfspaces_[a], halfspaces_[b], halfspaces_[c]);
        Meeting& meeting = meetings[x];
        meeting.triples.push_back(bit(a) | bit(b) | bit(c));
      }
    }
  }
  for (auto& [x, meeting] : meetings) {
    meeting.point = x;
    for (std::size_t i = 0; i < n; ++i) {
      const Rational value = halfspaces_[i](x);
      if (value > 0) meeting.violated |= bit(i);
      if (value == 0) meeting.on |= bit(i);
    }
    meetings_.push_back(std::move(meeting));
  }
}

inline bool HalfspaceArrangement::is_vertex(const Meeting& meeting, Subset chosen) const {
  return (meeting.violated & chosen) == 0 &&
         std::any_of(meeting.triples.begin(), meeting.triples.end(),
                     [&](Subset triple) { return contains(chosen, triple); });
}

inline bool HalfspaceArrangement::is_bounded(Subset chosen) const {
  // Without three planes that meet in a point there is a line inside. Otherwise the cone of rays
  // inside is pointed: if it were more than 0, it would have an extreme ray, which lies in two
  // planes.
  const bool pointed = std::any_of(meetings_.begin(), meetings_.end(), [&](const Meeting& m) {
    return std::any_of(m.triples.begin(), m.triples.end(),
                       [&](Subset triple) { return contains(chosen, triple); });
  });
  return pointed && std::none_of(rays_.begin(), rays_.end(), [&](const auto& ray) {
           return contains(chosen, ray.first) && (ray.second & chosen) == 0;
         });
}

inline std::vector<const HalfspaceArrangement::Meeting*> HalfspaceArrangement::vertices_of(
    Subset chosen) const {
  std::vector<const Meeting*> vertices;
  for (const Meeting& m : meetings_) {
    if (is_vertex(m, chosen)) vertices.push_back(&m);
  }
  return vertices;
}

// The vertices on plane i in order, relative to the first vertex of all. Seen from one corner the
// others of a convex polygon span less than half a turn.
inline std::vector<RationalVector3> HalfspaceArrangement::corners_of(
    std::size_t i, const std::vector<const Meeting*>& vertices) const {
  std::vector<RationalVector3> corners;
  for (const Meeting* m : vertices) {
    if (has(m->on, i)) corners.push_back(m->point - vertices[0]->point);
  }
  if (corners.empty()) return corners;
  const RationalVector3 normal = halfspaces_[i].normal().cast<Rational>();
  std::sort(corners.begin() + 1, corners.end(),
            [&](const RationalVector3& u, const RationalVector3& v) {
              const RationalVector3 a = u - corners[0], b = v - corners[0];
              return normal.dot(a.cross(b)) > 0;
            });
  return corners;
}

// Six times the volume of the pyramid from the first vertex over facet i, in tetrahedra.
inline std::vector<Rational> HalfspaceArrangement::facet_terms(
    std::size_t i, const std::vector<const Meeting*>& vertices) const {
  std::vector<Rational> terms;
  if (has(vertices[0]->on, i)) return terms;
  const std::vector<RationalVector3> corners = corners_of(i, vertices);
  if (corners.size() < 3) return terms;
  for (std::size_t c = 2; c < corners.size(); ++c) {
    terms.push_back(corners[0].dot(corners[c - 1].cross(corners[c])));
  }
  return terms;
}

inline std::optional<Rational> HalfspaceArrangement::volume(Subset chosen) const {
  if (!is_bounded(chosen)) return std::nullopt;
  const std::vector<const Meeting*> vertices = vertices_of(chosen);
  if (vertices.empty()) return Rational(0);
  std::vector<Rational> terms;
  for (std::size_t i = 0; i < size(); ++i) {
    if (!has(chosen, i)) continue;
    for (Rational& term : facet_terms(i, vertices)) terms.push_back(std::move(term));
  }
  return balanced_sum(std::move(terms)) / 6;
}

// Half the length of the cross product of each facet's diagonals, by its component along n.
inline Cost HalfspaceArrangement::area(Subset chosen) const {
  const std::vector<const Meeting*> vertices = vertices_of(chosen);
  RootSum sum;
  for (std::size_t i = 0; i < size(); ++i) {
    if (!has(chosen, i)) continue;
    const std::vector<RationalVector3> corners = corners_of(i, vertices);
    RationalVector3 twice = RationalVector3::Zero();
    for (std::size_t c = 0; c < corners.size(); ++c) {
      twice += corners[c].cross(corners[(c + 1) % corners.size()]);
    }
    sum.add(Rational(1, 2), twice.squaredNorm());
  }
  return Cost(std::move(sum));
}

// 4 pi times the mean width: every two planes with two common vertices have an edge, and as no
// halfspace is redundant, no third plane holds that edge.
inline Cost HalfspaceArrangement::mean_width(Subset chosen) const {
  const std::vector<const Meeting*> vertices = vertices_of(chosen);
  std::vector<AngleTerm> terms;
  for (std::size_t i = 0; i < size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!has(chosen, i) || !has(chosen, j)) continue;
      std::vector<RationalPoint> ends;
      for (const Meeting* m : vertices) {
        if (has(m->on, i) && has(m->on, j)) ends.push_back(m->point);
      }
      if (ends.size() < 2) continue;
      const IntegerVector3 &m = halfspaces_[i].normal(), &n = halfspaces_[j].normal();
      terms.push_back({1, (ends[1] - ends[0]).squaredNorm(), m.cross(n).squaredNorm(), m.dot(n)});
    }
  }
  return Cost(AngleSum(std::move(terms)));
}

inline std::optional<Cost> HalfspaceArrangement::measure(Subset chosen, CostMeasure measure) const {
  if (measure == CostMeasure::Volume) {
    const std::optional<Rational> exact = volume(chosen);
    return exact ? std::optional<Cost>(*exact) : std::nullopt;
  }
  if (!is_bounded(chosen)) return std::nullopt;
  return measure == CostMeasure::Area ? area(chosen) : mean_width(chosen);
}

}  // namespace definition
