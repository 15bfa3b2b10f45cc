// SPDX-License-Identifier: MIT
#include "lab/diff/cluster_diff.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "decompose/cluster_engines.hpp"
#include "decompose/merge_cost.hpp"
#include "io/json.hpp"
#include "number/precision.hpp"
#include "simplify/run_names.hpp"
#include "solid/stage_log.hpp"

namespace convexact {
namespace {

void require_engines(std::vector<Engine> engines) {
  std::sort(engines.begin(), engines.end());
  if (engines.size() < 2 || std::unique(engines.begin(), engines.end()) != engines.end()) {
    throw Error(ErrorCode::InvalidArgument, "name two or three different engines");
  }
}

// The cost of a choice, in the state after the merges that both runs have in common.
struct JudgedMerge {
  MergeCost cost;
  Enclosure bounds;
};

class ClusterJudge {
 public:
  ClusterJudge(const Surface& surface, const ClusterOptions& options)
      : surface_(surface),
        concavity_(surface, options.measure),
        start_(start_clusters(surface, options)),
        order_(start_.squared_weight) {}

  ClusterDivergence judge(const Clustering& reference, const Clustering& other,
                          std::size_t step) const {
    ClusterDivergence found;
    found.step = step;
    std::vector<std::uint32_t> names = start_.lowest;
    for (std::size_t k = 0; k < step; ++k) {
      const Merge& merge = reference.merges[k];
      std::replace(names.begin(), names.end(), merge.gone.value, merge.kept.value);
    }
    if (step < reference.merges.size()) found.reference = reference.merges[step];
    if (step < other.merges.size()) found.other = other.merges[step];
    const auto a = judged(found.reference, names), b = judged(found.other, names);
    if (a) found.reference_cost = a->bounds;
    if (b) found.other_cost = b->bounds;
    found.kind = kind_of(found, a, b);
    return found;
  }

 private:
  std::optional<JudgedMerge> judged(const std::optional<Merge>& merge,
                                    const std::vector<std::uint32_t>& names) const {
    if (!merge) return std::nullopt;
    std::vector<TriangleId> triangles;
    for (std::uint32_t t = 0; t < names.size(); ++t) {
      if (names[t] == merge->kept.value || names[t] == merge->gone.value) {
        triangles.push_back(TriangleId(t));
      }
    }
    MergeCost cost = merge_cost(surface_, triangles, concavity_);
    Enclosure bounds = merge->beyond_limit ? sqrt(Enclosure(cost.squared_concavity, kMeasureBits))
                                           : order_.enclose(cost, kMeasureBits);
    return JudgedMerge{std::move(cost), std::move(bounds)};
  }

  static bool are_close(const Enclosure& a, const Enclosure& b) {
    const Rational most = std::max<Rational>(a.high(), b.high());
    return abs(a.high() - b.high()) <= to_rational(kExplained) * most;
  }

  bool is_near_limit(const std::optional<JudgedMerge>& merge) const {
    return merge && are_close(sqrt(Enclosure(merge->cost.squared_concavity, kMeasureBits)),
                              sqrt(Enclosure(start_.squared_limit, kMeasureBits)));
  }

  MergeDifference kind_of(const ClusterDivergence& found, const std::optional<JudgedMerge>& a,
                          const std::optional<JudgedMerge>& b) const {
    if (a && b && found.reference->kept == found.other->kept &&
        found.reference->gone == found.other->gone) {
      return MergeDifference::WrongRecord;
    }
    if (a && b && found.reference->beyond_limit == found.other->beyond_limit) {
      const bool by_concavity = found.reference->beyond_limit;
      const bool is_tie = by_concavity ? a->cost.squared_concavity == b->cost.squared_concavity
                                       : order_.compare(a->cost, b->cost).order == Order::Equal;
      if (is_tie) return MergeDifference::Tie;
      if (are_close(a->bounds, b->bounds)) return MergeDifference::CostRounding;
    }
    if (is_near_limit(a) || is_near_limit(b)) return MergeDifference::LimitRounding;
    return MergeDifference::WrongMerge;
  }

  const Surface& surface_;
  ExactConcavity concavity_;
  ClusterStart start_;
  CostOrder order_;
};

Json merge_json(const std::optional<Merge>& merge, const std::optional<Enclosure>& cost) {
  if (!merge) return nullptr;
  Json json = {{"kept", merge->kept.value},
               {"gone", merge->gone.value},
               {"ties", merge->ties},
               {"beyond_limit", merge->beyond_limit}};
  if (cost) json["cost"] = measured_json({*cost, {}}, 17);
  return json;
}

std::string merge_text(const std::optional<Merge>& merge, const std::optional<Enclosure>& cost) {
  if (!merge) return "ends";
  return fmt::format("merges {} and {}{}", merge->kept.value, merge->gone.value,
                     cost ? fmt::format(" at {:.17g}", cost->high_double()) : "");
}

}  // namespace

bool ClusterDiff::holds() const {
  return std::all_of(comparisons.begin(), comparisons.end(),
                     [](const ClusterComparison& each) { return each.explained; });
}

ClusterComparison compare_runs(const Surface& surface, const ClusterOptions& options,
                               const ClusterRun& reference, const ClusterRun& other) {
  ClusterComparison result;
  result.reference = reference.engine;
  result.other = other.engine;
  const bool is_float = result.reference == Engine::Float || result.other == Engine::Float;
  const auto same = [&](const Merge& a, const Merge& b) {
    // The float engine does not count ties.
    return a.kept == b.kept && a.gone == b.gone && a.beyond_limit == b.beyond_limit &&
           (is_float || a.ties == b.ties);
  };
  const std::vector<Merge>&x = reference.made.merges, &y = other.made.merges;
  const auto [a, b] = std::mismatch(x.begin(), x.end(), y.begin(), y.end(), same);
  if (a == x.end() && b == y.end()) return result;
  result.divergence =
      ClusterJudge(surface, options).judge(reference.made, other.made, std::size_t(a - x.begin()));
  const MergeDifference kind = result.divergence->kind;
  result.explained =
      is_float && kind != MergeDifference::WrongMerge && kind != MergeDifference::WrongRecord;
  return result;
}

ClusterDiff diff_clusters(const Surface& surface, const ClusterOptions& options,
                          const std::vector<Engine>& engines, const StageWatch& watch) {
  require_engines(engines);
  ClusterDiff diff;
  diff.triangles = surface.triangles.size();
  diff.engines = engines;
  StageLog log(watch);
  for (const Engine engine : engines) {
    const std::string stage = std::string("clusters, ") + name_of(engine);
    ClusterOptions wanted = options;
    wanted.engine = engine;
    wanted.watch = log.watch(stage);
    diff.runs.push_back(log.run(stage, [&] { return cluster(surface, wanted); }));
  }
  for (std::size_t k = 1; k < engines.size(); ++k) {
    diff.comparisons.push_back(log.run("judge differences", [&] {
      return compare_runs(surface, options, {engines[0], diff.runs[0]}, {engines[k], diff.runs[k]});
    }));
  }
  diff.stages = log.stages();
  return diff;
}

Json cluster_diff_json(const ClusterDiff& diff) {
  Json runs = Json::array(), comparisons = runs;
  for (std::size_t k = 0; k < diff.runs.size(); ++k) {
    runs.push_back({{"engine", name_of(diff.engines[k])},
                    {"parts", diff.runs[k].clusters.size()},
                    {"merges", diff.runs[k].merges.size()},
                    {"evaluations", diff.runs[k].evaluations},
                    {"exact_evaluations", diff.runs[k].exact_evaluations}});
  }
  for (const ClusterComparison& each : diff.comparisons) {
    Json entry = {{"reference", name_of(each.reference)},
                  {"other", name_of(each.other)},
                  {"explained", each.explained},
                  {"divergence", nullptr}};
    if (const auto& found = each.divergence) {
      entry["divergence"] = {{"step", found->step},
                             {"kind", name_in(kMergeDifferenceNames, found->kind)},
                             {"reference", merge_json(found->reference, found->reference_cost)},
                             {"other", merge_json(found->other, found->other_cost)}};
    }
    comparisons.push_back(std::move(entry));
  }
  return {{"triangles", diff.triangles}, {"runs", runs}, {"comparisons", comparisons}};
}

std::string cluster_diff_text(const ClusterDiff& diff) {
  std::string text;
  for (std::size_t k = 0; k < diff.runs.size(); ++k) {
    text += fmt::format("  {:<12}{} parts by {} merges, {} evaluations, {} of them exact\n",
                        name_of(diff.engines[k]), diff.runs[k].clusters.size(),
                        diff.runs[k].merges.size(), diff.runs[k].evaluations,
                        diff.runs[k].exact_evaluations);
  }
  for (const ClusterComparison& each : diff.comparisons) {
    text += fmt::format("  {} / {}: ", name_of(each.other), name_of(each.reference));
    const auto& found = each.divergence;
    if (!found) {
      text += "the same merges\n";
      continue;
    }
    text += fmt::format(
        "{} at merge {}: {} {}, {} {}{}\n", name_in(kMergeDifferenceNames, found->kind),
        found->step, name_of(each.reference), merge_text(found->reference, found->reference_cost),
        name_of(each.other), merge_text(found->other, found->other_cost),
        each.explained ? "; rounding explains it" : "");
  }
  return text;
}

}  // namespace convexact
