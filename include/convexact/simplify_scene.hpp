// SPDX-License-Identifier: MIT
// simplify_scene.hpp - several parts, each enclosed separately, with one budget of halfspaces; and
// the gaps that solids leave between the parts.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "convexact/keep.hpp"
#include "convexact/simplify.hpp"

namespace convexact {

/// A request for all parts together.
struct SceneRequest {
  /// As for one part. `faces` and `center` stay unset, since no single number or point suits every
  /// part; `keep` stays unset, too. `max_growth` limits the sum over all parts.
  SimplifyRequest each;
  /// Halfspaces to keep in all parts together: at least 4 for each part.
  std::size_t total_faces = 0;
  /// By part: its facets that stay. Empty if no part has any; else as long as there are parts.
  std::vector<std::vector<KeepSelector>> keep = {};
};

/// The results for all parts together. Measures are sums over the parts.
struct SceneTotals {
  std::size_t steps = 0;  ///< Halfspaces removed.
  /// The last removals, in their order, each by its part, counted from 0. The other parts keep at
  /// least 4 halfspaces each, so that a part cannot end with more than `total_faces` less these;
  /// by volume and unless growth is limited, each part is first simplified down to that number by
  /// itself. Otherwise these are all removals.
  std::vector<std::uint32_t> order;
  StopReason stop = StopReason::Reached;
  std::size_t input_halfspaces = 0, output_halfspaces = 0;
  Measured input_volume{Enclosure(1), {}}, output_volume{Enclosure(1), {}};
  /// As in SimplifyResult.
  CostMeasure cost = CostMeasure::Volume;
  std::optional<std::array<Enclosure, 2>> measure;
  std::optional<CostMeasure> growth_of;
  std::optional<std::array<Enclosure, 2>> limited;
  long growth_bits = 0;
  /// Of the exact and the filtered engine: the steps of `order` in which the cheapest removals of
  /// several parts cost the same, so that the first of these parts went on.
  TieTally ties;
  Engine engine = Engine::Filtered;
  /// Of the float engine: whether exact numbers, too, would have ended every part's run there.
  bool is_end_proven = true;
  std::vector<Stage> stages;  ///< Of all parts at once; others are in the results of the parts.
};

struct SceneResult : SceneTotals {
  std::vector<SimplifyResult> parts;  ///< As the parts were given; `stop` is that of the scene.
};

/// The first part that has no volume.
struct NotSolidPart {
  std::size_t part;
  NotSolid reason;
};

using SceneOutcome = std::variant<SceneResult, NotSolidPart>;

/// Removes one halfspace after another, each time the one of all parts whose removal adds the least
/// to the measure of the request, until `total_faces` are left. On a tie the first part is chosen,
/// and within a part the first halfspace in canonical order. A part whose removals are all
/// unbounded, as with 4 halfspaces, drops out; if all parts have dropped out, the run ends above
/// `total_faces`.
///
/// Parts do not interact, so the removals in each part are the first ones of the part's separate
/// run. Costs by volume never fall during a run, so no other choice of prefixes of these runs keeps
/// as few halfspaces and has a smaller sum of volumes. Costs by area and mean width may fall, so
/// there this is a greedy choice without that property.
///
/// The exact and the filtered engine compare the parts' costs exactly where their bounds overlap;
/// mean widths that cannot be told apart count as equal. The float engine compares its estimates.
/// @throws Error InvalidArgument for no part, a budget below 4 halfspaces for each part, or what
///               simplify() refuses; otherwise as simplify().
/// @par Cost     As the parts' separate runs, and for each removal the logarithm of the number of
///               parts.
[[nodiscard]] SceneOutcome simplify_scene(std::span<const Shape> parts,
                                          const SceneRequest& request);

/// A face of one part of an input, both counted from 0.
struct PartFace {
  std::size_t part;
  std::size_t face;
  friend bool operator==(const PartFace&, const PartFace&) = default;
};

/// Which faces of the parts of an input the solids of the parts leave bare.
struct Gaps {
  std::size_t faces = 0;             ///< Of all parts.
  std::vector<PartFace> out_of_own;  ///< Not inside the solid of their own part, ascending.
  std::vector<PartFace> in_no_part;  ///< Of these: not inside the solid of any other part.
};

/// Whether each face of the input is inside the solid of its own part, exactly: a face is inside a
/// convex set if and only if its corners are, and touching counts as inside. A face that several
/// solids cover only together counts as in no part.
/// @param parts   Of halfspaces, or of points without faces: nothing to test.
/// @param solids  For each part the halfspaces whose intersection it is; without any, the empty
///                set.
/// @throws Error  InvalidArgument unless there is a solid for each part; Stopped when `stop`
///                becomes true.
/// @par Cost      A sign for each point and halfspace of its part; for each face that is not inside
///                its own part one for each corner and halfspace of the scene.
[[nodiscard]] Gaps find_gaps(std::span<const SceneObject> parts,
                             std::span<const std::vector<Halfspace>> solids,
                             const std::atomic<bool>* stop = nullptr);

}  // namespace convexact
