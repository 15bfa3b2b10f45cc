// SPDX-License-Identifier: MIT
// What parts are to each other: whether they overlap, lie in one another, and how a tree of hulls
// holds them.
#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "convexact/hull_tree.hpp"
#include "number/text.hpp"
#include "oracle/parts/judge.hpp"

namespace convexact::oracle {
namespace {

using enum ClaimCode;

// Calls look(i, k) for all pairs i < k of parts whose boxes meet.
template <class Look>
void for_pairs(const std::vector<ConvexPart>& parts, const Watch& watch, const Look& look) {
  std::vector<std::size_t> by_low(parts.size());
  std::iota(by_low.begin(), by_low.end(), 0);
  std::sort(by_low.begin(), by_low.end(), [&](std::size_t a, std::size_t b) {
    return parts[a].box.low[0] < parts[b].box.low[0];
  });
  const auto meet = [&](const BoundingBox& a, const BoundingBox& b, int axis) {
    return a.low[axis] <= b.high[axis] && b.low[axis] <= a.high[axis];
  };
  for (std::size_t first = 0; first < by_low.size(); ++first) {
    watch.at(first, by_low.size());
    const BoundingBox& box = parts[by_low[first]].box;
    for (std::size_t next = first + 1; next < by_low.size(); ++next) {
      const BoundingBox& other = parts[by_low[next]].box;
      if (!meet(box, other, 0)) break;
      if (!meet(box, other, 1) || !meet(box, other, 2)) continue;
      const auto [i, k] = std::minmax(by_low[first], by_low[next]);
      look(i, k);
    }
  }
}

using Pair = std::pair<std::size_t, std::size_t>;

// Whether there is a plane between two parts beyond which neither reaches farther than is
// tolerated.
bool may_reach(const PartsTrial& trial, const ConvexPart& a, const ConvexPart& b) {
  if (trial.tolerance.value == 0) return false;
  const Rational squared = trial.tolerance.squared(trial.squared_diameter);
  return plane_between(a, b, squared, trial.watch("disjoint parts")).squared <= squared;
}

void judge_disjoint(PartsTrial& trial) {
  std::vector<Pair> overlapping;
  std::optional<RationalPoint> point;
  for_pairs(trial.verdict.hulls, trial.watch("disjoint parts"), [&](std::size_t i, std::size_t k) {
    const ConvexPart &a = trial.verdict.hulls[i], &b = trial.verdict.hulls[k];
    auto common = common_interior(a, b);
    if (!common || may_reach(trial, a, b)) return;
    if (overlapping.empty() || Pair(i, k) < overlapping.front()) {
      point = std::move(common);
      overlapping.insert(overlapping.begin(), {i, k});
    } else {
      overlapping.emplace_back(i, k);
    }
  });
  if (overlapping.empty()) {
    return trial.holds(PartsDisjoint, trial.tolerance.value == 0
                                          ? "no two parts have a common interior point"
                                          : "a plane is between each two parts, beyond which "
                                            "neither reaches farther than is tolerated");
  }
  Witness witness;
  witness.parts = {overlapping.front().first, overlapping.front().second};
  witness.point = point;
  std::string sentence =
      fmt::format("{} of parts overlap; {} and {} do", counted(overlapping.size(), "pair", "pairs"),
                  trial.part_text(witness.parts[0]), trial.part_text(witness.parts[1]));
  trial.violated(PartsDisjoint, std::move(sentence), std::move(witness));
}

void judge_needed(PartsTrial& trial) {
  std::vector<Pair> inside;  // the part, and the one that it lies in
  const auto look = [&](std::size_t part, std::size_t other) {
    if (lies_in(trial.verdict.hulls[part], trial.verdict.hulls[other]))
      inside.emplace_back(part, other);
  };
  for_pairs(trial.verdict.hulls, trial.watch("needed parts"), [&](std::size_t i, std::size_t k) {
    look(k, i);
    look(i, k);
  });
  std::sort(inside.begin(), inside.end());
  if (inside.empty()) return trial.holds(PartsNeeded, "no part lies in another one");
  Witness witness;
  witness.parts = {inside.front().first, inside.front().second};
  // Of two equal parts each lies in the other, but only one is superfluous.
  std::vector<std::size_t> superfluous;
  for (const auto& [part, other] : inside) {
    const bool is_equal = std::binary_search(inside.begin(), inside.end(), Pair(other, part));
    if (!is_equal || part > other) superfluous.push_back(part);
  }
  superfluous.erase(std::unique(superfluous.begin(), superfluous.end()), superfluous.end());
  std::string sentence = fmt::format(
      "{} in another one; {} lies in {}", counted(superfluous.size(), "part lies", "parts lie"),
      trial.part_text(witness.parts[0]), trial.part_text(witness.parts[1]));
  trial.violated(PartsNeeded, std::move(sentence), std::move(witness));
}

}  // namespace

void judge_pairs(PartsTrial& trial) {
  const auto judge = [&](ClaimCode code, const char* stage, const auto& decide) {
    if (!trial.asks(code)) return trial.log.skip(stage, "not requested");
    if (trial.verdict.hulls.empty()) return trial.not_applicable(code, "there is no part");
    trial.log.run(stage, [&] { decide(trial); });
  };
  judge(PartsDisjoint, "disjoint parts", judge_disjoint);
  judge(PartsNeeded, "needed parts", judge_needed);
}

void judge_tree(const HullTree* tree, PartsTrial& trial) {
  constexpr const char* kStage = "tree";
  if (trial.claims.back().code != TreeNested) return;
  if (!trial.asks(TreeNested)) return trial.log.skip(kStage, "not requested");
  if (tree == nullptr) return trial.not_applicable(TreeNested, "the parts are under no tree");
  const std::optional<TreeFault> fault =
      trial.log.run(kStage, [&] { return find_tree_fault(*tree, trial.watch(kStage)); });
  if (!fault) {
    return trial.holds(TreeNested, fmt::format("{}, and each hull holds its children",
                                               counted(tree->nodes.size(), "node", "nodes")));
  }
  Witness witness;
  witness.nodes = fault->nodes;
  if (fault->part) witness.parts = {*fault->part};
  if (fault->point) {
    const PointSet& points = tree->mesh_of(fault->nodes[1]).points;
    witness.vertices = {*fault->point};
    witness.point = points[PointId(*fault->point)];
    witness.plane = fault->plane;
    const Rational height = (*fault->plane)(*witness.point);
    witness.squared_distance = height * height / Rational(fault->plane->normal().squaredNorm());
  }
  trial.violated(TreeNested, fault->sentence, std::move(witness));
}

}  // namespace convexact::oracle
