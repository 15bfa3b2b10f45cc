// SPDX-License-Identifier: MIT
// facet_match.hpp - which facet of a solid a plane of a list is, which facets an order names, and
// planes and facets in words.
#pragma once
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "convexact/dual.hpp"
#include "convexact/verify_order.hpp"

namespace convexact {

/// "the plane 1 0 0 -2": a row of a list, for messages.
[[nodiscard]] std::string plane_in_words(const Halfspace& plane);

/// "7, 12, 30", for the separator ", ".
[[nodiscard]] std::string ids_text(std::span<const HalfspaceId> ids, const char* separator);

/// The facet that a plane comes nearest to, and how near.
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
