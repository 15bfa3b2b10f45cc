// SPDX-License-Identifier: MIT
#include "oracle/order/facet_match.hpp"

#include <algorithm>
#include <limits>

#include "convexact/measure.hpp"
#include "convexact/number.hpp"
#include "convexact/verify.hpp"
#include "number/text.hpp"

namespace convexact {
namespace {

// With an error of some units of 2^-53. Normals may have thousands of bits, so they are scaled
// first.
Point direction_of(const Halfspace& plane) {
  Integer largest = 0;
  for (const Integer& n : plane.normal()) largest = std::max(largest, Integer(abs(n)));
  Point direction;
  for (int k = 0; k < 3; ++k) {
    direction[k] = to_double(Rational(plane.normal()[k], largest), Rounding::Nearest);
  }
  return direction / direction.norm();
}

// Finds facets for planes that a program has computed and written in floating point. A plane names
// the facet whose normal is nearest to the plane's normal; among facets whose normals are equally
// near, up to 2^-45, the one whose corners it misses least. Rounding explains that it misses a
// corner by
//   16 u c D / h,
// where u is the unit roundoff of the numbers, c the largest coordinate of the facet's corners, D
// the length of the longest edge or diagonal from the first corner, and h how far the others are
// from it: the cross product n of edges e and f has an error of some u |e| |f|, its offset one of u
// |n| c.
class FacetMatcher {
 public:
  // @param unit  2^-53 for binary64. The dual is referred to.
  FacetMatcher(const DualHull& dual, double unit) : dual_(dual), unit_(unit) {}

  // The facet with exactly this plane; none if there is none.
  std::optional<HalfspaceId> find(const Halfspace& plane) const;
  // @par Cost  Linear in the number of facets, in doubles.
  NearestFacet nearest(const Halfspace& plane);

 private:
  void prepare();
  NearestFacet measure(const Halfspace& plane, HalfspaceId facet) const;

  const DualHull& dual_;
  const double unit_;
  std::vector<Point> directions_;                         // of the normals, of length 1
  std::vector<std::vector<std::uint32_t>> triangles_of_;  // of each facet: one for each corner
};

std::optional<HalfspaceId> FacetMatcher::find(const Halfspace& plane) const {
  const std::vector<Halfspace>& all = dual_.halfspaces;
  const auto found = std::lower_bound(all.begin(), all.end(), plane);
  if (found == all.end() || *found != plane) return std::nullopt;
  return HalfspaceId(static_cast<std::size_t>(found - all.begin()));
}

void FacetMatcher::prepare() {
  for (const Halfspace& h : dual_.halfspaces) directions_.push_back(direction_of(h));
  triangles_of_.resize(dual_.halfspaces.size());
  for (std::size_t t = 0; t < dual_.triangles.size(); ++t) {
    for (const HalfspaceId i : dual_.triangles[t]) {
      triangles_of_[i.index()].push_back(static_cast<std::uint32_t>(t));
    }
  }
}

NearestFacet FacetMatcher::nearest(const Halfspace& plane) {
  if (directions_.empty()) prepare();
  const Point direction = direction_of(plane);
  double least = std::numeric_limits<double>::infinity();
  for (const Point& other : directions_) least = std::min(least, (other - direction).norm());
  std::optional<NearestFacet> best;
  for (std::size_t i = 0; i < directions_.size(); ++i) {
    if ((directions_[i] - direction).norm() > least + 0x1p-45) continue;
    NearestFacet found = measure(plane, HalfspaceId(i));
    if (!best || found.squared_distance < best->squared_distance) best = std::move(found);
  }
  return *best;
}

NearestFacet FacetMatcher::measure(const Halfspace& plane, HalfspaceId facet) const {
  std::vector<RationalPoint> corners;
  for (const std::uint32_t t : triangles_of_[facet.index()]) {
    const auto& [a, b, c] = dual_.triangles[t];
    const auto& h = dual_.halfspaces;
    corners.push_back(meet(h[a.index()], h[b.index()], h[c.index()]));
  }
  Rational farthest = 0, diameter = 0, area = 0;  // the last two squared
  RationalPoint far_corner = corners[0];
  for (const RationalPoint& corner : corners) {
    farthest = std::max(farthest, Rational(abs(plane(corner))));
    const Rational distance = (corner - corners[0]).squaredNorm();
    if (distance > diameter) diameter = distance, far_corner = corner;
  }
  const RationalVector3 edge = far_corner - corners[0];
  for (const RationalPoint& corner : corners) {
    const RationalVector3 other = corner - corners[0];
    area = std::max(area, edge.cross(other).squaredNorm());
  }
  const Rational squared_normal(plane.normal().squaredNorm());
  const Rational reach = to_rational(16 * unit_) * bounding_box(corners).largest_coordinate();
  return {facet, farthest * farthest / squared_normal, reach * reach * diameter * diameter / area};
}

}  // namespace

std::string plane_in_words(const Halfspace& plane) {
  std::string text = "the plane";
  for (const Integer& n : plane.normal()) text += " " + in_sentence(Rational(n));
  return text + " " + in_sentence(Rational(plane.offset()));
}

std::string ids_text(std::span<const HalfspaceId> ids, const char* separator) {
  std::string text;
  for (const HalfspaceId id : ids) {
    text += (text.empty() ? "" : separator) + std::to_string(id.index());
  }
  return text;
}

NamedFacets::NamedFacets(const DualHull& dual, const RemovalOrder& order, double unit)
    : order_(order) {
  FacetMatcher matcher(dual, unit);
  for (const std::optional<Halfspace>& plane : order.facets) {
    ids_.push_back(plane ? matcher.find(*plane) : std::nullopt);
    if (!plane || ids_.back()) continue;
    const NearestFacet nearest = matcher.nearest(*plane);
    if (nearest.is_explained()) {
      ids_.back() = nearest.facet;
      ++listed_.rounded;
      listed_.squared_distance = std::max(listed_.squared_distance, nearest.squared_distance);
    } else {
      ++listed_.unknown;
      unknown_.emplace(HalfspaceId(ids_.size() - 1), nearest);
    }
  }
}

std::size_t NamedFacets::count_unlisted(const std::vector<HalfspaceId>& facets) const {
  if (!order_.has_list) return 0;
  const auto is_absent = [&](HalfspaceId facet) {
    return std::find(ids_.begin(), ids_.end(), facet) == ids_.end();
  };
  return static_cast<std::size_t>(std::count_if(facets.begin(), facets.end(), is_absent));
}

std::string NamedFacets::found(const OrderedStep& removal) const {
  const std::optional<Halfspace>& plane = order_.facets[removal.step.removed.index()];
  if (!order_.has_list) return removal.text;
  if (!plane) return removal.text + ", which has normal 0 in the facet list";
  return removal.text + ", in the facet list " + plane_in_words(*plane);
}

std::string NamedFacets::expected(const OrderedStep& removal) const {
  const auto unknown = unknown_.find(removal.step.removed);
  if (unknown == unknown_.end()) return "a facet plane of the input";
  const NearestFacet& nearest = unknown->second;
  return "a facet plane of the input: the nearest, of facet " +
         std::to_string(nearest.facet.index()) + ", has a corner " +
         decimal_of_root(nearest.squared_distance) + " off it, and rounding explains " +
         decimal_of_root(nearest.squared_limit);
}

}  // namespace convexact
