// SPDX-License-Identifier: MIT
// measure.hpp - volume, surface area, mean width, inertia, distance and box of solids.
//
// Rational measures are exact: boxes, volumes, squared distances. Areas and mean widths are sums of
// roots and angles and come as enclosures of any precision. docs/measures.md derives the formulas.
#pragma once
#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "convexact/cost.hpp"
#include "convexact/error.hpp"
#include "convexact/geometry.hpp"
#include "convexact/hull.hpp"
#include "convexact/number.hpp"

namespace convexact {

/// Exact volume, in cubed length units: the sum over the facets of height times area over 3, where
/// the roots in both cancel. The summation is balanced, because the vertices of a simplified
/// polytope hardly share denominators.
/// @par Cost    O(corners) short products; the last additions are as long as the result.
/// @par Source  docs/measures.md
[[nodiscard]] Rational volume(const Polytope& polytope);

/// The same to a relative width of about 2^-precision, without long numbers: no term is negative,
/// because heights are measured from a vertex.
[[nodiscard]] Enclosure enclose_volume(const Polytope& polytope, long precision);

/// Exact volume of a hull, in cubed length units. Points that are doubles are integers times a
/// common power of two, so the sum over the facets needs no fraction until the end.
/// @par Cost  O(corners) products of integers as long as the spread of the coordinates.
[[nodiscard]] Rational volume(const Hull& hull, const PointSet& points);

/// Volume, area or mean width of a hull, relative width about 2^-precision, from the same integers:
/// no plane is formed.
[[nodiscard]] Enclosure enclose_measure(const Hull& hull, const PointSet& points,
                                        CostMeasure measure, long precision);

/// Exact area of each facet, in squared length units; radicand = n.n of the facet's primitive
/// normal direction.
[[nodiscard]] std::vector<RootTerm> facet_areas(const Polytope& polytope, const Watch& watch = {});

/// The sum of root terms. Relative width about 2^-precision if no factor is negative.
[[nodiscard]] Enclosure enclose_sum(const std::vector<RootTerm>& terms, long precision);

/// Surface area in squared length units, relative width about 2^-precision.
/// @par Cost    O(corners) exact products, then one root per facet.
[[nodiscard]] Enclosure surface_area(const Polytope& polytope, long precision,
                                     const Watch& watch = {});

/// The width of the polytope between two parallel planes, averaged over all directions, in length
/// units: the sum over the edges of length times exterior dihedral angle, over 4 pi. A ball
/// of diameter D has D, a cube of side a has 3a/2. Relative width about 2^-precision.
/// @throws Error Stopped when the watch ends the call.
/// @par Cost    Two roots and one arctangent per edge.
/// @par Source  [Schneider2014, sec. 4.2]; docs/measures.md derives it.
[[nodiscard]] Enclosure mean_width(const Polytope& polytope, long precision,
                                   const Watch& watch = {});

/// Volume, area or mean width, relative width about 2^-precision.
/// @throws Error Stopped when the watch ends the call.
[[nodiscard]] Enclosure enclose_measure(const Polytope& polytope, CostMeasure measure,
                                        long precision, const Watch& watch = {});

/// The same measure as an exact number, of the kind that costs are.
/// @throws Error Stopped when the watch ends the call.
[[nodiscard]] Cost exact_measure(const Polytope& polytope, CostMeasure measure,
                                 const Watch& watch = {});

/// Of a solid of density 1.
struct MassProperties {
  Rational volume;       ///< In cubed length units; > 0.
  RationalPoint center;  ///< Of mass.
  /// The integral of (x - center) (x - center)^T: its entries xx, yy, zz, xy, xz, yz.
  std::array<Rational, 6> moments;

  /// The tensor of inertia about the center: xx, yy, zz, xy, xz, yz, such as the integral of
  /// y^2 + z^2, and the negative one of x y.
  std::array<Rational, 6> inertia() const;
};

/// Exactly.
/// @par Cost  O(corners) products; the last additions are as long as the result.
[[nodiscard]] MassProperties mass_properties(const Polytope& polytope);

/// Of bodies of density 1 as one body; what lies in two of them counts twice. Nothing without a
/// volume.
[[nodiscard]] std::optional<MassProperties> put_together(std::span<const MassProperties> bodies);

/// Finds the nearest point of one polytope. Space outside is divided into the regions of points
/// that are nearest to one facet, edge or vertex; each is bounded by planes, so that only signs of
/// integers are needed to find the right one, and the result proves itself. Any threads may ask at
/// the same time.
/// @par Source  [LinCanny1991]; [Rockafellar1970, thm. 27.4] for the proof.
class NearestPoint {
 public:
  /// Keeps a reference. @par Cost  O(E log E), without an exact plane: those of a feature are
  ///                             computed when it is first asked about.
  explicit NearestPoint(const Polytope& polytope);
  ~NearestPoint();

  /// The unique point of the polytope nearest to x; x itself if inside or on the boundary.
  /// @par Cost  For x outside: a product in doubles per facet, then a few signs for each feature of
  ///            the visible facets, starting next to the facet that x is farthest beyond. For x
  ///            inside: the products, and a sign where these leave it open.
  RationalPoint operator()(const RationalPoint& x) const;

 private:
  class Search;
  std::unique_ptr<const Search> search_;
};

/// The Hausdorff distance between a polytope and one inside it, with the pair that attains it.
struct HausdorffDistance {
  Rational squared;       ///< Exact, in squared length units.
  std::uint32_t vertex;   ///< Of the outer polytope, the lowest index on a tie.
  RationalPoint nearest;  ///< Its nearest point of the inner polytope.
};

/// The distance to a convex set is a convex function, so on the outer polytope it is largest at one
/// of its vertices; and every point of the inner one lies in the outer one. Precondition: `outer`
/// contains `inner`.
/// @throws Error Stopped when the watch ends it.
/// @par Cost  NearestPoint for each outer vertex that is no inner one.
[[nodiscard]] HausdorffDistance hausdorff_distance(const Polytope& outer, const Polytope& inner,
                                                   const Watch& watch = {});

}  // namespace convexact
