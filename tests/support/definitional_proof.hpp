// SPDX-License-Identifier: MIT
// definitional_proof.hpp - the claims of a proof, and whether they are true by the definition.
// Witnesses (the interior point, the tetrahedra that show points inside, rays) are no claims; only
// the checker judges them.
#pragma once
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "affine_dimension.hpp"
#include "cheapest_removals.hpp"
#include "number/text.hpp"
#include "stored_cases.hpp"
#include "supporting_planes.hpp"

namespace definition {

/// The claims of a proof of docs/proof-format.md that has been accepted, so is well-formed.
struct ProofClaims {
  explicit ProofClaims(const std::string& text);

  struct Removal {
    std::size_t id;
    std::optional<Cost> cost;  // none if the proof shows no costs
    std::vector<HalfspaceId> tie;
    friend bool operator==(const Removal&, const Removal&) = default;
  };

  bool is_greedy = false;
  CostMeasure measure = CostMeasure::Volume;  // of the costs, if there are any
  std::vector<Halfspace> rows, planes;
  std::vector<RationalPoint> points;
  std::vector<Removal> removals;
  std::vector<std::size_t> survivors;
  std::vector<std::array<Rational, 4>> stored;

  friend bool operator==(const ProofClaims&, const ProofClaims&) = default;
  /// Whether all claims are true. For a dozen points and two dozen planes.
  bool are_true() const;

 private:
  bool hull_is_true() const;
  bool removals_are_true() const;
  bool stored_is_true() const;
};

// The words of a proof, each taken once.
class ProofWords {
 public:
  explicit ProofWords(const std::string& text) : in_(text) { take(); }
  const std::string& next() const { return next_; }
  std::string take() {
    std::string taken = std::move(next_);
    if (!(in_ >> next_)) next_.clear();
    return taken;
  }
  bool at_number() const { return !next_.empty() && next_[0] <= '9'; }
  std::size_t id() { return std::stoul(take()); }
  std::vector<std::size_t> ids() {
    std::vector<std::size_t> list;
    while (at_number()) list.push_back(id());
    return list;
  }
  Rational number() {
    const std::string word = take();
    return is_hex_float(word) ? parse_hex_float(word) : parse_rational(word);
  }
  RationalPoint point() {
    RationalPoint p;
    for (Rational& x : p) x = number();
    return p;
  }
  Halfspace halfspace() {
    const RationalVector3 normal = point();
    return {normal, number()};
  }

 private:
  std::istringstream in_;
  std::string next_;
};

inline ProofClaims::ProofClaims(const std::string& text) {
  ProofWords words(text);
  std::vector<std::optional<Cost>> costs;
  while (!words.next().empty()) {
    const std::string word = words.take();
    if (word == "greedy" || word == "greedy-area") is_greedy = true;
    if (word == "greedy-area") measure = CostMeasure::Area;
    if (word == "row") rows.push_back(words.halfspace());
    if (word == "point") points.push_back(words.point());
    if (word == "plane") planes.push_back(words.halfspace());
    costs.resize(planes.size());
    if (word == "evaluate") {
      const std::size_t id = words.id();
      const std::string kind = words.take();
      if (kind == "cost") costs[id] = words.number();
      if (kind == "area") {
        RootSum area;
        while (words.at_number()) {
          const Rational factor = words.number();
          area.add(factor, words.number());
        }
        costs[id] = Cost(area);
      }
    }
    if (word == "remove") {
      const std::size_t id = words.id();
      Removal& removal = removals.emplace_back(Removal{id, costs[id], {}});
      if (words.next() == "tie") words.take();
      for (const std::size_t i : words.ids()) removal.tie.emplace_back(i);
    }
    if (word == "survive") survivors = words.ids();
    if (word == "halfspace") {
      auto& plane = stored.emplace_back();
      for (Rational& x : plane) x = words.number();
    }
  }
}

inline bool ProofClaims::are_true() const {
  return hull_is_true() && removals_are_true() && stored_is_true();
}

inline bool ProofClaims::hull_is_true() const {
  if (affine_dimension(points) < 3 || supporting_planes(points) != planes) return false;
  for (const Halfspace& row : rows) {
    for (const RationalPoint& p : points) {
      if (row(p) > 0) return false;
    }
  }
  const std::set<Halfspace> given(rows.begin(), rows.end());
  return rows.empty() || std::all_of(planes.begin(), planes.end(),
                                     [&](const Halfspace& plane) { return given.contains(plane); });
}

inline bool ProofClaims::removals_are_true() const {
  const HalfspaceArrangement arrangement(planes);
  Subset left = arrangement.all();
  for (const Removal& removal : removals) {
    const Subset bit = Subset{1} << removal.id;
    if ((left & bit) == 0) return false;
    const std::optional<Cost> after = arrangement.measure(left & ~bit, measure);
    if (!after) return false;
    if (removal.cost) {
      const std::array<Cost, 2> parts{arrangement.measure(left, measure).value(), *removal.cost};
      if (sum_of(parts) != *after) return false;
    }
    if (is_greedy) {
      const Cheapest best = cheapest_removals(arrangement, left, measure);
      if (best.tie != removal.tie || removal.tie.front().index() != removal.id) return false;
    }
    left &= ~bit;
  }
  Subset surviving = 0;
  for (const std::size_t i : survivors) surviving |= Subset{1} << i;
  return surviving == left;
}

inline bool ProofClaims::stored_is_true() const {
  if (stored.empty()) return true;
  std::vector<stored_checker::Plane> exact;
  for (const std::array<Rational, 4>& plane : stored) {
    const auto [integers, common] =
        stored_checker::clear({stored_cases::to_mpq(plane[0]), stored_cases::to_mpq(plane[1]),
                               stored_cases::to_mpq(plane[2]), stored_cases::to_mpq(plane[3])});
    exact.push_back({integers[0], integers[1], integers[2], integers[3]});
  }
  return stored.size() == survivors.size() && stored_checker::is_bounded(exact) &&
         stored_checker::count_outside(exact, stored_cases::to_homogeneous(PointSet(points))) == 0;
}

}  // namespace definition
