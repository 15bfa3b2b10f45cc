// SPDX-License-Identifier: MIT
// compare.hpp - the methods on one input, each refitted, timed and measured; as tables and as data.
#pragma once
#include <string>
#include <variant>
#include <vector>

#include "convexact/scene.hpp"
#include "io/json_document.hpp"
#include "lab/compare/refit.hpp"

namespace convexact {

struct CompareRequest {
  std::size_t size = 18;  ///< Planes of each solid, or vertices of each one inside; at least 4.
  bool inner = false;     ///< Solids inside the inputs; all methods are of that kind.
  std::vector<const Method*> methods;
  std::uint64_t seed = 1;  ///< Of the methods that choose at random.
  StageWatch watch = {};
};

/// The result of a method on one input.
struct MethodResult {
  const Method* method;
  double seconds;        ///< Of the proposal, from the exact hull on.
  double refit_seconds;  ///< Of the refit with its proofs and measures.
  RefitOutcome outcome;

  const Refit* solid() const { return std::get_if<Refit>(&outcome); }
  /// Planes, or vertices of a solid inside. There must be a solid.
  std::size_t size() const {
    const Polytope& made = solid()->solid;
    return method->is_inner() ? made.vertices.size() : made.planes.size();
  }
  /// Whether it made a solid of at most this size.
  bool fits(std::size_t most) const { return solid() != nullptr && size() <= most; }
  /// Whether its solid is nearer to the hull than the other one's: by volume, exactly.
  bool is_tighter(const MethodResult& other) const {
    const Rational &mine = solid()->volume_ratio, &its = other.solid()->volume_ratio;
    return method->is_inner() ? mine > its : mine < its;
  }
};

/// All methods on one input.
struct MethodComparison {
  std::string name;
  std::size_t points = 0;  ///< 0 where the input is halfspaces.
  std::size_t vertices = 0, facets = 0;
  std::size_t size = 0;  ///< As requested.
  bool inner = false;
  std::vector<MethodResult> results;

  /// The tightest of the solids that fit, the first on a tie; null if none does.
  const MethodResult* tightest() const;
  /// Whether a solid that fits is tighter than that of our own greedy removals.
  bool beats_own(const MethodResult& result) const;
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

/// The medians of the methods with such an input, the tightest first.
[[nodiscard]] std::vector<MethodMedian> medians(const std::vector<MethodComparison>& comparisons);

/// A table for each input, and one of medians if there are several.
[[nodiscard]] std::string compare_text(const std::vector<MethodComparison>& comparisons);
/// docs/schema/compare.schema.json.
[[nodiscard]] Json compare_json(const std::vector<MethodComparison>& comparisons,
                                const CompareRequest& request);
/// A row for each input and method, with a heading. RFC 4180.
[[nodiscard]] std::string compare_csv(const std::vector<MethodComparison>& comparisons);

/// Every method, with a description and its source.
[[nodiscard]] std::string methods_text();
[[nodiscard]] Json methods_json();

}  // namespace convexact
