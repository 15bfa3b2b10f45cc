// SPDX-License-Identifier: MIT
// keep.hpp - the facets of a solid that a run must not remove: by id, plane, normal or face.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "convexact/halfspace.hpp"
#include "convexact/number.hpp"
#include "convexact/point_set.hpp"

namespace convexact {

/// Facets by their positions in canonical order.
struct KeepIds {
  std::vector<HalfspaceId> ids;
};

/// The facet in the plane n.x + d = 0, n outward, up to a positive factor.
struct KeepPlane {
  RationalVector3 normal;
  Rational offset;
};

/// The facets whose outward normal is at most so many degrees away from a direction; without an
/// angle those nearest to it, all of them if several are equally near.
///
/// 0 degrees is the direction itself, exactly. The cosine of any other angle is rounded down to a
/// double, and every facet is decided exactly with that number: a facet at exactly this angle is
/// selected.
struct KeepNormal {
  RationalVector3 direction;      ///< Not zero, of any length.
  std::optional<double> degrees;  ///< 0 to 180.
};

/// The facets whose planes hold all corners of one of these faces of the input.
struct KeepFaces {
  std::vector<std::vector<std::uint32_t>> polygons;  ///< Of point input: positions of points.
};

struct KeepSelector {
  std::variant<KeepIds, KeepPlane, KeepNormal, KeepFaces> facets;
  std::string text;  ///< Its name in messages.
};

/// The facets that the selectors select together.
/// @param halfspaces  Of the facets, in canonical order.
/// @param points      The points that the faces refer to; empty if the input is halfspaces.
/// @param most        How many may be selected; unset: any number.
/// @return            Ascending, each once.
/// @throws Error      InvalidArgument, with its text, for a selector that selects nothing or refers
///                    to a facet or point that does not exist, for a direction or normal of length
///                    0 and for an angle outside of 0 to 180 degrees; if more are selected than
///                    may be.
/// @par Cost          A sign per facet and direction; for faces one per facet and corner.
[[nodiscard]] std::vector<HalfspaceId> select_facets(std::span<const Halfspace> halfspaces,
                                                     const PointSet& points,
                                                     std::span<const KeepSelector> selectors,
                                                     std::optional<std::size_t> most = {});

}  // namespace convexact
