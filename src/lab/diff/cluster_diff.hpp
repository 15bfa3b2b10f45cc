// SPDX-License-Identifier: MIT
// cluster_diff.hpp - where two engines merge clusters differently, and whether rounding explains
// it.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "convexact/cluster.hpp"
#include "convexact/scene.hpp"
#include "io/json_document.hpp"
#include "io/names.hpp"

namespace convexact {

/// How the first merge that differs is explained, by exact costs of both pairs from the definition.
enum class MergeDifference {
  Tie,            ///< The costs are equal; the canonical order should have decided.
  CostRounding,   ///< They differ by at most kExplained of the larger one.
  LimitRounding,  ///< A concavity is that close to the limit.
  WrongMerge,     ///< Neither: the engine is wrong.
  WrongRecord,    ///< The same merge, but other ties, or another reason for it.
};

inline constexpr auto kMergeDifferenceNames =
    name_table<MergeDifference>({{MergeDifference::Tie, "tie"},
                                 {MergeDifference::CostRounding, "cost-below-rounding"},
                                 {MergeDifference::LimitRounding, "limit-below-rounding"},
                                 {MergeDifference::WrongMerge, "wrong-merge"},
                                 {MergeDifference::WrongRecord, "wrong-record"}});

/// The largest error of the float engine's estimates, as a share: they are bounds made tight to
/// about 2^-26, from planes whose corners may be close together.
inline constexpr double kExplained = 0x1p-24;

/// The first difference. From there on the engines work on different clusters.
struct ClusterDivergence {
  std::size_t step = 0;  ///< Merges in common.
  MergeDifference kind = MergeDifference::WrongMerge;
  std::optional<Merge> reference, other;                ///< None: the run ended.
  std::optional<Enclosure> reference_cost, other_cost;  ///< Of merges within the limit.
};

struct ClusterComparison {
  Engine reference = Engine::Exact, other = Engine::Exact;
  std::optional<ClusterDivergence> divergence;  ///< None: the same merges.
  /// Whether the engines agree, or one of them is the float engine and rounding explains it.
  bool explained = true;
};

struct ClusterDiff {
  std::size_t triangles = 0;
  std::vector<Engine> engines;
  std::vector<Clustering> runs;                ///< Of each engine.
  std::vector<ClusterComparison> comparisons;  ///< Of each with the first.
  std::vector<Stage> stages;

  bool holds() const;
};

/// What an engine made of a surface.
struct ClusterRun {
  Engine engine = Engine::Exact;
  const Clustering& made;
};

/// Where two runs first differ, and why. @param options  Of both runs.
[[nodiscard]] ClusterComparison compare_runs(const Surface& surface, const ClusterOptions& options,
                                             const ClusterRun& reference, const ClusterRun& other);

/// Runs the engines, at least two and all different, and compares them with the first.
/// @param options  Of every run; its engine and watch are not used.
/// @throws Error InvalidArgument for what cluster() refuses, and for an invalid list of engines;
///               Stopped when the watch ends the call.
[[nodiscard]] ClusterDiff diff_clusters(const Surface& surface, const ClusterOptions& options,
                                        const std::vector<Engine>& engines,
                                        const StageWatch& watch = {});

[[nodiscard]] Json cluster_diff_json(const ClusterDiff& diff);
/// A line for each engine and each comparison.
[[nodiscard]] std::string cluster_diff_text(const ClusterDiff& diff);

}  // namespace convexact
