// SPDX-License-Identifier: MIT
// exchange_surface.hpp - a solid of few halfspaces, and the effect of exchanging one of them.
#pragma once
#include <algorithm>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "convexact/cost.hpp"
#include "convexact/dual.hpp"
#include "convexact/search.hpp"
#include "fast/dual.hpp"
#include "number/roundoff.hpp"

namespace convexact {

/// Ascending.
using HalfspaceIds = std::vector<HalfspaceId>;

/// The ids of `a` that are not in `b`.
[[nodiscard]] inline HalfspaceIds without(const HalfspaceIds& a, const HalfspaceIds& b) {
  HalfspaceIds only_a;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(only_a));
  return only_a;
}

/// The measure after an exchange minus the one before.
struct Change {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();  ///< Around it, in a unit of the surface.
  std::optional<Cost> exact = {};
};

/// No change is this much.
inline constexpr double kNoLimit = std::numeric_limits<double>::infinity();

/// The kept halfspaces, all of them facets of the input, so that none is ever redundant. Exchanging
/// i for j inserts j first: where few halfspaces are kept, the solid without i is mostly unbounded.
/// The exchange adds the cap of i to the solid with both, and takes away that of j. Preconditions:
/// i is kept, j is not.
class ExchangeSurface {
 public:
  virtual ~ExchangeSurface() = default;

  /// None if the solid would be unbounded, and possibly where the change is proven to be `below` or
  /// more: then it need not be known. An engine that has bounds leaves `exact` empty.
  virtual std::optional<Change> change(HalfspaceId i, HalfspaceId j, double below) = 0;
  /// The same exactly, of an exchange that leaves the solid bounded.
  virtual Cost exact_change(HalfspaceId i, HalfspaceId j) = 0;
  /// Such a number, nearly, in the unit of Change::lower; where there are no bounds, in another
  /// one, always the same, in which doubles hold it.
  virtual double in_unit(const Cost& change) = 0;
  /// Makes it. Precondition: it leaves the solid bounded.
  virtual void exchange(HalfspaceId i, HalfspaceId j) = 0;

  /// Bounds of the present measure, always in the same unit, for comparisons with former ones:
  /// infinite where only exact numbers are known.
  virtual Interval<double> measure_bounds() {
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  }
  /// The dual hull of what is kept.
  virtual std::vector<DualTriangle> triangles() = 0;
  /// The measure of the solid with that dual hull.
  virtual Cost measure(std::span<const DualTriangle> triangles) const = 0;
};

/// Every sign and every cost in integers and rationals.
/// @param dual      Of the input; must outlive the surface.
/// @param triangles The dual hull of what is kept.
[[nodiscard]] std::unique_ptr<ExchangeSurface> make_exact_surface(
    const DualHull& dual, std::span<const DualTriangle> triangles, const RationalPoint& center,
    CostMeasure measure);

/// Doubles with bounds, and exact numbers where these leave a sign or an order open.
/// @param dual  Of the input, with its ids; must outlive the surface.
[[nodiscard]] std::unique_ptr<ExchangeSurface> make_filtered_surface(
    const FastDual& dual, std::span<const DualTriangle> triangles, CostMeasure measure);

/// As search_exchanges().
/// @param fast   Of `dual`, for the filtered engine; null if there is none yet.
/// @param start  The dual hull of what is kept at the start.
[[nodiscard]] SearchRun search_from(const DualHull& dual, const FastDual* fast,
                                    const Polytope& input, const RationalPoint& center,
                                    std::span<const DualTriangle> start,
                                    const SearchOptions& options);
/// The same by the filtered engine alone, without an exact dual of the whole input.
/// @param dual  Of `hull`, whose facets are in canonical order.
[[nodiscard]] SearchRun search_from(const FastDual& dual, const Hull& hull,
                                    std::span<const DualTriangle> start,
                                    const SearchOptions& options);
/// As search_optimal().
[[nodiscard]] SearchRun search_optimal_from(const DualHull& dual, const FastDual* fast,
                                            const Polytope& input, const RationalPoint& center,
                                            std::span<const DualTriangle> start,
                                            const SearchOptions& options);

/// The dual hull of some halfspaces of an input.
[[nodiscard]] std::vector<DualTriangle> dual_triangles_of(const DualHull& dual,
                                                          std::span<const HalfspaceId> ids,
                                                          const RationalPoint& center);
/// The ids in it, ascending.
[[nodiscard]] std::vector<HalfspaceId> ids_in(std::span<const DualTriangle> triangles);

}  // namespace convexact
