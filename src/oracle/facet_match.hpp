// SPDX-License-Identifier: MIT
// facet_match.hpp - finds the facet of a solid for a plane of a list, and the facets that an order
// names.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "convexact/dual.hpp"
#include "convexact/verify_run.hpp"

namespace convexact {

/// The facet that a plane is nearest to, and the distance.
struct NearestFacet {
  HalfspaceId facet;
  Rational squared_distance;  ///< From the plane to the farthest corner of the facet, squared.
  Rational squared_limit;     ///< The distance that rounding explains, squared.

  bool is_explained() const { return squared_distance <= squared_limit; }
};

/// The facets of a solid that the list of an order names, exactly or up to rounding: the planes of
/// the list have been computed by a program and written in floating point.
class NamedFacets {
 public:
  NamedFacets(const DualHull& dual, const RemovalOrder& order, double unit);

  std::size_t size() const { return ids_.size(); }
  /// The facet of the solid; none if it has no such plane, or if the list ends before the id.
  std::optional<HalfspaceId> find(HalfspaceId listed) const {
    return listed.index() < ids_.size() ? ids_[listed.index()] : std::nullopt;
  }
  const ListedPlanes& listed() const { return listed_; }
  /// How many of these facets are not in the list; 0 if the order has no separate list.
  std::size_t count_unlisted(const std::vector<HalfspaceId>& facets) const;
  /// The name in a removal that is no facet, and what was expected, in words.
  std::string found(const OrderedStep& removal) const;
  std::string expected(const OrderedStep& removal) const;

 private:
  const RemovalOrder& order_;
  std::vector<std::optional<HalfspaceId>> ids_;
  std::map<HalfspaceId, NearestFacet> unknown_;
  ListedPlanes listed_;
};

}  // namespace convexact
