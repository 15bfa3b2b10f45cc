// SPDX-License-Identifier: MIT
// compare.hpp - the methods on one input, each refitted, timed and measured; as tables and as data.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "compare/refit.hpp"
#include "convexact/scene.hpp"

namespace convexact {

struct CompareRequest {
  std::size_t faces = 18;  ///< Planes of each solid, at least 4.
  std::vector<const Method*> methods;
  std::uint64_t seed = 1;  ///< Of the methods that choose at random.
  StageWatch watch = {};
};

/// What a method made of one input.
struct MethodResult {
  const Method* method;
  double seconds;        ///< Of the proposal, from the exact hull on.
  double refit_seconds;  ///< Of the refit with its proofs and measures.
  RefitOutcome outcome;

  const Refit* solid() const { return std::get_if<Refit>(&outcome); }
  /// Whether it made a solid of at most so many planes.
  bool fits(std::size_t faces) const {
    return solid() != nullptr && solid()->solid.planes.size() <= faces;
  }
};

/// All methods on one input.
struct MethodComparison {
  std::string name;
  std::size_t points = 0;  ///< 0 where the input is halfspaces.
  std::size_t vertices = 0, facets = 0;
  std::size_t faces = 0;  ///< As requested.
  std::vector<MethodResult> results;

  /// The least volume among the solids that fit, the first on a tie; null if none does.
  const MethodResult* least() const;
  /// Whether a solid that fits has less volume than that of the method greedy, exactly.
  bool beats_greedy(const MethodResult& result) const;
};

/// @throws Error Internal if a proof fails; Stopped.
[[nodiscard]] std::variant<MethodComparison, NotSolid> compare_methods(
    const std::string& name, const Shape& shape, const CompareRequest& request);

/// The median of a method's measures over the inputs on which it made a solid that fits.
struct MethodMedian {
  const Method* method;
  std::size_t inputs = 0;  ///< How many these are.
  double volume = 0, area = 0, mean_width = 0, distance = 0, seconds = 0;
};

/// Of the methods with such an input, by their volumes.
[[nodiscard]] std::vector<MethodMedian> medians(const std::vector<MethodComparison>& comparisons);

/// A table for each input, and one of medians if there are several.
[[nodiscard]] std::string compare_text(const std::vector<MethodComparison>& comparisons);
/// docs/schema/compare.schema.json.
[[nodiscard]] nlohmann::ordered_json compare_json(const std::vector<MethodComparison>& comparisons,
                                                  const CompareRequest& request);
/// A row for each input and method, with a heading. RFC 4180.
[[nodiscard]] std::string compare_csv(const std::vector<MethodComparison>& comparisons);

/// Every method with what it does and its source.
[[nodiscard]] std::string methods_text();
[[nodiscard]] nlohmann::ordered_json methods_json();

}  // namespace convexact
