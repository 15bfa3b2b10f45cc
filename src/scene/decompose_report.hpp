// SPDX-License-Identifier: MIT
// decompose_report.hpp - a decomposition as JSON (docs/schema/decompose.schema.json), as a trace
// (docs/schema/decompose-trace.schema.json), and as text for people.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "convexact/decompose.hpp"
#include "io/names.hpp"

namespace convexact {

inline constexpr auto kDecomposeMethodNames =
    name_table<DecomposeMethod>({{DecomposeMethod::Hacd, "hacd"}, {DecomposeMethod::Acd, "acd"}});

inline constexpr auto kBridgeChoiceNames =
    name_table<BridgeChoice>({{BridgeChoice::Farther, "farther"},
                              {BridgeChoice::Region, "region"},
                              {BridgeChoice::Nearer, "nearer"}});

inline constexpr auto kConcavityMeasureNames = name_table<ConcavityMeasure>(
    {{ConcavityMeasure::Surface, "surface"}, {ConcavityMeasure::Vertices, "vertices"}});

inline constexpr auto kConnectNames = name_table<Connect>(
    {{Connect::Edge, "edge"}, {Connect::Overlap, "overlap"}, {Connect::Touching, "touching"}});

inline constexpr auto kOrientationNames =
    name_table<Orient>({{Orient::Auto, "auto"}, {Orient::Keep, "keep"}});

inline constexpr auto kFlatPartsNames = name_table<FlatParts>({{FlatParts::Auto, "auto"},
                                                               {FlatParts::Thicken, "thicken"},
                                                               {FlatParts::Keep, "keep"},
                                                               {FlatParts::Merge, "merge"}});

inline constexpr auto kPartFormNames = name_table<PartForm>({{PartForm::Hull, "hull"},
                                                             {PartForm::Rounded, "rounded"},
                                                             {PartForm::Simplified, "simplified"},
                                                             {PartForm::Thickened, "thickened"},
                                                             {PartForm::Flat, "flat"}});

/// How much of a decomposition its document holds.
enum class DecompositionDetail {
  Numbers,  ///< Counts, certificates and measures: its length is that of the list of parts.
  All,      ///< Also owners, solids, and the forest of merges or the tree of splits.
};

/// A decomposition and how it came about, without stages.
/// @param names  Of the parts.
[[nodiscard]] nlohmann::ordered_json decomposition_json(const Decomposition& decomposition,
                                                        const DecomposeRequest& request,
                                                        std::span<const std::string> names,
                                                        DecompositionDetail detail);

/// A document with each entry of a top-level list, and every other value, on a separate line.
[[nodiscard]] std::string write_lines(const nlohmann::ordered_json& document);

/// The concavity allowed, and one that was found.
[[nodiscard]] nlohmann::ordered_json limit_json(const ConcavityLimit& limit,
                                                const Decomposition& decomposition);
[[nodiscard]] nlohmann::ordered_json concavity_json(const Concavity& concavity,
                                                    const Rational& squared_diameter);
/// Doubles; for an input with fractions, the fractions that they equal, which mean the same to a
/// reader that takes decimals as spelled.
[[nodiscard]] nlohmann::ordered_json vertices_json(const PointSet& points, bool as_fractions);
/// The numbers of triangles, as a list.
[[nodiscard]] nlohmann::ordered_json indices_json(std::span<const TriangleId> triangles);
/// The reason why the run ended.
[[nodiscard]] const char* stop_name(const Decomposition& decomposition);

/// The root of an exact square, and a length as a percentage of the diameter; 0 for a single point.
[[nodiscard]] Enclosure enclosed_root_of(const Rational& square);
[[nodiscard]] Enclosure percent_of(const Enclosure& length, const Rational& squared_diameter);

/// The ties of the merges, and the merges that led beyond the limit.
[[nodiscard]] TieTally ties_of(const Clustering& clustering);
[[nodiscard]] std::size_t merges_beyond(const Clustering& clustering);

/// The start of every trace: the question, and the surface.
[[nodiscard]] nlohmann::ordered_json trace_head(const Decomposition& decomposition,
                                                const DecomposeRequest& request);

/// Every merge, or split, on the surface that it refers to, so that a program can replay it.
[[nodiscard]] std::string write_decompose_trace(const Decomposition& decomposition,
                                                const DecomposeRequest& request);

/// A few lines: the parts, whether the limit holds, what is covered, and which volume of the solid
/// is not.
[[nodiscard]] std::string summary(const Decomposition& decomposition,
                                  const DecomposeRequest& request,
                                  std::span<const std::string> names);

}  // namespace convexact
