// SPDX-License-Identifier: MIT
// decompose_options.hpp - the options of a decomposition, and of a tree over its parts, as users
// spell them: on the command line, in requests and in the C interface.
#pragma once
#include <string>

#include "convexact/decompose.hpp"
#include "convexact/hull_tree.hpp"
#include "convexact/number.hpp"
#include "io/names.hpp"
#include "wire/field.hpp"

namespace convexact {

inline constexpr auto kDecomposeMethodNames =
    name_table<DecomposeMethod>({{DecomposeMethod::Hacd, "hacd"},
                                 {DecomposeMethod::Acd, "acd"},
                                 {DecomposeMethod::Cut, "cut"},
                                 {DecomposeMethod::Auto, "auto"}});

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

inline constexpr auto kReachUseNames =
    name_table<ReachUse>({{ReachUse::None, "none"}, {ReachUse::Reach, "reach"}});

inline constexpr auto kEffortNames = name_table<CutEffort>(
    {{CutEffort::Low, "low"}, {CutEffort::Normal, "normal"}, {CutEffort::High, "high"}});

inline constexpr auto kCloseNames =
    name_table<Close>({{Close::Auto, "auto"}, {Close::Never, "never"}});

inline constexpr auto kLoosePointsNames =
    name_table<LoosePoints>({{LoosePoints::Part, "part"}, {LoosePoints::Refuse, "refuse"}});

/// What requests start from: the method is chosen for the surface.
[[nodiscard]] inline DecomposeRequest default_decompose_request() {
  DecomposeRequest request;
  request.method = DecomposeMethod::Auto;
  return request;
}

/// All that the command line and lines of JSON have in common.
[[nodiscard]] const Fields<DecomposeRequest>& decompose_fields();

/// The same, and what the command line says for all of its commands, or by its outputs: tree,
/// exact_volumes, no_measures and seed. For lines of JSON and the C interface.
[[nodiscard]] const Fields<DecomposeRequest>& decompose_call_fields();

/// faces, leaf_faces and precision.
[[nodiscard]] const Fields<TreeRequest>& tree_fields();

/// "3%" and "0.03d" are shares of the diameter, "0.05" is a length; all exact.
/// @param option  Its name, for the message.
/// @throws Error InvalidArgument for anything else, for a share that is not from 0 to 1, and for a
///               negative length.
[[nodiscard]] ConcavityLimit parse_concavity(const std::string& option, const std::string& text);

/// "20%" is a share; exact.
/// @throws Error InvalidArgument for anything else, and for a negative share.
[[nodiscard]] Rational parse_excess(const std::string& option, const std::string& text);

/// The cosine of an angle, above 0 and at most 1: "0.99", exact.
/// @throws Error InvalidArgument for anything else.
[[nodiscard]] Rational parse_cosine(const std::string& option, const std::string& text);

}  // namespace convexact
