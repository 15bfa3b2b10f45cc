// SPDX-License-Identifier: MIT
// union_distance.cpp - exact distances of points to the union of parts.
#include <algorithm>
#include <utility>
#include <vector>

#include "convexact/error.hpp"
#include "convexact/measure.hpp"
#include "convexact/overlay.hpp"
#include "overlay/union_distance_flat.hpp"
#include "overlay/union_distance_near.hpp"
#include "task/lazy.hpp"

namespace convexact {

// ---- Flat parts

FlatFeatures::FlatFeatures(const ConvexPart& polygon) {
  if (polygon.dimension != 2) return;
  for (const Halfspace& h : polygon.halfspaces) {
    std::vector<std::uint32_t> tight;
    for (std::uint32_t v = 0; v < polygon.vertices.size(); ++v) {
      if (h(polygon.vertices[v]) == 0) tight.push_back(v);
    }
    if (tight.size() == 2) {
      sides.emplace_back(tight[0], tight[1]);
    } else if (tight.size() == polygon.vertices.size()) {
      plane = &h;
    }
  }
}

namespace {

RationalPoint nearest_on_exact_segment(const RationalPoint& a, const RationalPoint& b,
                                       const RationalPoint& x) {
  const RationalVector3 along = b - a, from = x - a;
  const Rational t = from.dot(along), length = along.squaredNorm();
  if (t <= 0) return a;  // also where both ends are one point
  if (t >= length) return b;
  const Rational factor = t / length;
  return a + factor * along;
}

// Outside of the sides, the nearest point of a polygon is on one of them.
RationalPoint nearest_in_polygon(const ConvexPart& part, const FlatFeatures& features,
                                 const RationalPoint& x) {
  const RationalVector3 normal = features.plane->normal().cast<Rational>();
  const Rational factor = (*features.plane)(x) / normal.squaredNorm();
  RationalPoint foot = x - factor * normal;
  const bool is_inside = std::all_of(part.halfspaces.begin(), part.halfspaces.end(),
                                     [&](const Halfspace& h) { return h(foot) <= 0; });
  if (is_inside) return foot;
  std::optional<std::pair<Rational, RationalPoint>> best;
  for (const auto& [a, b] : features.sides) {
    RationalPoint q = nearest_on_exact_segment(part.vertices[a], part.vertices[b], x);
    const RationalVector3 gap = x - q;
    Rational squared = gap.squaredNorm();
    if (!best || squared < best->first) best.emplace(std::move(squared), std::move(q));
  }
  return best->second;
}

}  // namespace

RationalPoint nearest_in_flat(const ConvexPart& part, const FlatFeatures& features,
                              const RationalPoint& x) {
  switch (part.dimension) {
    case 2:
      return nearest_in_polygon(part, features, x);
    case 1:
      return nearest_on_exact_segment(part.vertices[0], part.vertices[1], x);
    default:
      return part.vertices[0];
  }
}

// Above the triangle the foot of the perpendicular is nearest, elsewhere a point of a side.
RationalPoint nearest_in_triangle(const std::array<RationalPoint, 3>& corners,
                                  const RationalPoint& x) {
  const RationalVector3 b = corners[1] - corners[0], c = corners[2] - corners[0];
  const RationalVector3 normal = b.cross(c);
  const Rational squared = normal.squaredNorm();
  if (squared != 0) {
    const RationalVector3 from = x - corners[0];
    const Rational v = normal.dot(from.cross(c)), w = normal.dot(b.cross(from));
    if (v >= 0 && w >= 0 && v + w <= squared) {
      const Rational at_b = v / squared, at_c = w / squared;
      return corners[0] + at_b * b + at_c * c;
    }
  }
  std::optional<std::pair<Rational, RationalPoint>> best;
  for (std::size_t k = 0; k < 3; ++k) {
    RationalPoint q = nearest_on_exact_segment(corners[k], corners[(k + 1) % 3], x);
    const RationalVector3 gap = x - q;
    Rational distance = gap.squaredNorm();
    if (!best || distance < best->first) best.emplace(std::move(distance), std::move(q));
  }
  return best->second;
}

// ---- The union

namespace {

NearFrame frame_of_parts(std::span<const ConvexPart> parts) {
  if (parts.empty()) throw Error(ErrorCode::InvalidArgument, "a union of no parts");
  std::vector<BoundingBox> boxes;
  for (const ConvexPart& part : parts) boxes.push_back(part.box);
  return frame_around(boxes);
}

}  // namespace

class UnionDistance::Search {
 public:
  explicit Search(std::span<const ConvexPart> parts)
      : parts_(parts), near_(parts, frame_of_parts(parts)), exact_(parts.size()) {}

  std::span<const ConvexPart> parts() const { return parts_; }

  RationalPoint nearest_in(std::size_t part, const RationalPoint& x) const {
    const ConvexPart& of = parts_[part];
    if (of.solid) {
      const auto& solid =
          exact_[part].solid.get([&] { return std::make_unique<const NearestPoint>(*of.solid); });
      return (*solid)(x);
    }
    const auto& flat = exact_[part].flat.get([&] { return FlatFeatures(of); });
    return nearest_in_flat(of, flat, x);
  }

  // Ascending, so that the lowest part wins a tie.
  NearestPart operator()(const RationalPoint& x) const {
    std::optional<NearestPart> best;
    for (const std::uint32_t p : near_.candidates(near_.frame()(x))) {
      RationalPoint q = nearest_in(p, x);
      const RationalVector3 gap = x - q;
      Rational squared = gap.squaredNorm();
      if (!best || squared < best->squared) best = NearestPart{p, std::move(q), std::move(squared)};
      if (best->squared == 0) break;
    }
    return *best;
  }

 private:
  // The data for a part's exact distances.
  struct Exact {
    Lazy<std::unique_ptr<const NearestPoint>> solid;
    Lazy<FlatFeatures> flat;
  };

  std::span<const ConvexPart> parts_;
  NearParts near_;
  std::vector<Exact> exact_;
};

UnionDistance::UnionDistance(std::span<const ConvexPart> parts)
    : search_(std::make_unique<const Search>(parts)) {}
UnionDistance::~UnionDistance() = default;

std::span<const ConvexPart> UnionDistance::parts() const { return search_->parts(); }
NearestPart UnionDistance::operator()(const RationalPoint& x) const { return (*search_)(x); }
RationalPoint UnionDistance::nearest_in(std::size_t part, const RationalPoint& x) const {
  return search_->nearest_in(part, x);
}

}  // namespace convexact
