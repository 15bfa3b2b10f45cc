// SPDX-License-Identifier: MIT
// facet_match.hpp - which facet of a solid a plane of a list is, and which facets an order names.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "convexact/dual.hpp"
#include "convexact/verify_run.hpp"

namespace convexact {

/// The facet that a plane comes nearest to, and how near.
struct NearestFacet {
  HalfspaceId facet;
  Rational squared_distance;  ///< From the plane to the farthest corner of the facet, squared.
  Rational squared_limit;     ///< What rounding explains of it, squared.

  bool is_explained() const { return squared_distance <= squared_limit; }
};

/// Finds facets for planes that a program has computed and written in floating point. A plane names
/// the facet whose normal is nearest to its own; of facets whose normals are as near, up to 2^-45,
/// the one whose corners it misses least. Rounding explains that it misses a corner by
///   16 u c D / h,
/// where u is the unit roundoff of the numbers, c the largest coordinate of the facet's corners, D
/// the length of the longest edge or diagonal from the first corner, and h how far the others are
/// from it: the cross product n of edges e and f is off by some u |e| |f|, its offset by u |n| c.
class FacetMatcher {
 public:
  /// @param unit  2^-53 for binary64. The dual is referred to.
  FacetMatcher(const DualHull& dual, double unit) : dual_(dual), unit_(unit) {}

  /// The facet with exactly this plane; none if there is none.
  std::optional<HalfspaceId> find(const Halfspace& plane) const;
  /// @par Cost  Linear in the number of facets, in doubles.
  NearestFacet nearest(const Halfspace& plane);

 private:
  void prepare();
  NearestFacet measure(const Halfspace& plane, HalfspaceId facet) const;

  const DualHull& dual_;
  const double unit_;
  std::vector<Point> directions_;                         // of the normals, of length 1
  std::vector<std::vector<std::uint32_t>> triangles_of_;  // of each facet: one for each corner
};

/// What the list of an order names, found in the solid: exactly, or up to rounding.
class NamedFacets {
 public:
  NamedFacets(const DualHull& dual, const RemovalOrder& order, double unit);

  std::size_t size() const { return ids_.size(); }
  /// The facet of the solid; none if it has no such plane, or if the list ends before the id.
  std::optional<HalfspaceId> find(HalfspaceId listed) const {
    return listed.index() < ids_.size() ? ids_[listed.index()] : std::nullopt;
  }
  const ListedPlanes& listed() const { return listed_; }
  /// How many of these facets no plane of the list is; 0 if the order has no list of its own.
  std::size_t count_unlisted(const std::vector<HalfspaceId>& facets) const;
  /// What a removal names that is no facet, and what was expected, in words.
  std::string found(const OrderedStep& removal) const;
  std::string expected(const OrderedStep& removal) const;

 private:
  const RemovalOrder& order_;
  std::vector<std::optional<HalfspaceId>> ids_;
  std::map<HalfspaceId, NearestFacet> unknown_;
  ListedPlanes listed_;
};

}  // namespace convexact
