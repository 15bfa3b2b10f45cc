// SPDX-License-Identifier: MIT
// decompose_report.hpp - a decomposition for machines (docs/schema/decompose.schema.json), as a
// trace (docs/schema/decompose-trace.schema.json, decompose-acd-trace.schema.json), and for people.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "convexact/decompose.hpp"
#include "io/json_document.hpp"
#include "io/names.hpp"

namespace convexact {

inline constexpr auto kLeafStatusNames =
    name_table<LeafStatus>({{LeafStatus::WithinLimit, "within-eps"},
                            {LeafStatus::MaxParts, "max-parts"},
                            {LeafStatus::Unsplittable, "unsplittable"}});

/// How much of a decomposition its document holds.
enum class DecompositionDetail {
  Numbers,  ///< Counts, certificates and measures: its length is that of the list of parts.
  All,      ///< Also owners, solids, and the forest of merges or the tree of splits.
};

/// A decomposition and how it came about, without stages.
/// @param names  Of the parts.
[[nodiscard]] Json decomposition_json(const Decomposition& decomposition,
                                      const DecomposeRequest& request,
                                      std::span<const std::string> names,
                                      DecompositionDetail detail);

/// A decomposition of one object of a scene, and the names of its parts.
struct DecomposedObject {
  std::string name;
  Decomposition result;
  std::vector<std::string> part_names;
  DecomposeRequest request = {};  ///< With the method that was used.
};

/// Of one object the same; of several their documents under "objects", and all parts together under
/// "parts", each with the number of its object.
[[nodiscard]] Json decomposition_json(std::span<const DecomposedObject> objects,
                                      DecompositionDetail detail);

/// The concavity allowed.
[[nodiscard]] Json limit_json(const ConcavityLimit& limit, const Decomposition& decomposition);
/// Doubles; of an input with fractions the fractions that they are, which mean the same to a reader
/// that takes decimals as they are spelled.
[[nodiscard]] Json vertices_json(const PointSet& points, bool as_fractions);
/// The method and its options.
[[nodiscard]] Json method_json(const DecomposeRequest& request);
/// What the parts are proven to hold: "surface", or "solid", which includes it.
[[nodiscard]] const char* covered_name(const Decomposition& decomposition);
/// What is proven of the parts, in one sentence without a full stop: "9 parts hold the solid; no
/// point of them is farther than 3% of the diameter (0.0776) from it".
[[nodiscard]] std::string proven_of_parts(const Decomposition& decomposition);
/// What ended the run.
[[nodiscard]] const char* stop_name(const Decomposition& decomposition);

/// The root of an exact square, and a length as a percentage of the diameter; 0 for a single point.
[[nodiscard]] Enclosure enclosed_root_of(const Rational& square);
[[nodiscard]] Enclosure percent_of(const Enclosure& length, const Rational& squared_diameter);

/// The ties of the merges, and the merges that led beyond the limit.
[[nodiscard]] TieTally ties_of(const Clustering& clustering);
[[nodiscard]] std::size_t merges_beyond(const Clustering& clustering);

/// The leaves of that status, and the triangles that went with a split as islands.
[[nodiscard]] std::size_t count_leaves(const SplitTree& tree, LeafStatus status);
[[nodiscard]] std::size_t island_count(const SplitTree& tree);

/// Every merge, or split, on the surface that it refers to, so that a program can replay it.
[[nodiscard]] std::string write_decompose_trace(const Decomposition& decomposition,
                                                const DecomposeRequest& request);

/// A few lines: the parts, whether the limit holds, what is covered, and which volume of the solid
/// is not.
[[nodiscard]] std::string summary(const Decomposition& decomposition,
                                  const DecomposeRequest& request,
                                  std::span<const std::string> names);

}  // namespace convexact
