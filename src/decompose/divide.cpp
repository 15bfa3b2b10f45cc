// SPDX-License-Identifier: MIT
#include "decompose/divide.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "near/near_plane.hpp"
#include "number/arithmetic.hpp"
#include "surface/flat_polygon.hpp"

namespace convexact {

// ---- Units

Units::Units(const Surface& surface, const ClusterStart& start)
    : name_(start.lowest), triangles_(name_.size()), shown_(name_.size()), beside_(name_.size()) {
  for (std::uint32_t t = 0; t < name_.size(); ++t) {
    auto& unit = triangles_[name_[t]];
    if (unit.empty() || !has_no_area(surface.points, surface.triangles[t])) {
      shown_[name_[t]] = TriangleId(t);
    }
    unit.push_back(TriangleId(t));
  }
  for (const auto& [a, b] : start.pairs) {
    beside_[a].push_back(b);
    beside_[b].push_back(a);
  }
  for (auto& units : beside_) std::sort(units.begin(), units.end());
}

// ---- Planes

namespace {

constexpr unsigned kNormalBits = 20;

// 2^kNormalBits times the unit vector, rounded to nearest.
IntegerVector3 rounded_unit(const IntegerVector3& n) {
  const Integer squared = dot(n, n);
  IntegerVector3 unit;
  for (int k = 0; k < 3; ++k) {
    // With 2x the root of twice the component, squared: floor(x + 1/2) = (floor(2x) + 1) / 2.
    const Integer twice = sqrt(Integer((n[k] * n[k] << (2 * kNormalBits + 2)) / squared));
    unit[k] = (twice + 1) / 2;
    if (n[k] < 0) unit[k] = -unit[k];
  }
  return unit;
}

// The cosine of the angle between two vectors, squared, with its sign: it has the same order as the
// cosine.
Rational signed_squared_cosine(const IntegerVector3& a, const IntegerVector3& b) {
  const Integer along = dot(a, b);
  return Rational(along * abs(along), dot(a, a) * dot(b, b));
}

IntegerVector3 normal_of(const Surface& surface, TriangleId t) {
  const RationalVector3 area = area_vector(surface.points, surface.triangles[t.index()]);
  return area.isZero() ? IntegerVector3(IntegerVector3::Zero())
                       : primitive_direction(clear_denominators(area).n);
}

// Along the plane, besides the edge.
IntegerVector3 across(const IntegerVector3& n1, const IntegerVector3& n2, const Rational& cosine) {
  const IntegerVector3 u1 = rounded_unit(n1), u2 = rounded_unit(n2);
  if (abs(cosine) >= Rational(1, 25)) return u1 + u2;
  const Integer d = abs(dot(u1, u2));
  return d * u1 + ((Integer(1) << (2 * kNormalBits)) - d) * u2;
}

// Whether the corner of b that is not on the edge is beyond the plane of a.
bool is_concave(const Surface& surface, TriangleId a, const IntegerVector3& normal_of_a,
                TriangleId b) {
  const auto& of_a = surface.triangles[a.index()];
  const RationalPoint from = surface.points[of_a[0]];
  for (const PointId p : surface.triangles[b.index()]) {
    if (std::find(of_a.begin(), of_a.end(), p) != of_a.end()) continue;
    return normal_of_a.cast<Rational>().dot(surface.points[p] - from) > 0;
  }
  return false;
}

std::optional<SplitPlane> plane_through(const Surface& surface, PointId notch, PointId to,
                                        std::vector<TriangleId> triangles,
                                        const IntegerVector3& across) {
  const RationalPoint at = surface.points[notch];
  const RationalVector3 normal = (surface.points[to] - at).cross(across.cast<Rational>());
  if (normal.isZero()) return {};
  return SplitPlane{to, std::move(triangles), Halfspace(normal, -normal.dot(at)), true, 1};
}

}  // namespace

std::vector<SplitPlane> split_planes(const Surface& surface, const Patch& patch, PointId notch) {
  std::vector<SplitPlane> planes;
  std::optional<SplitPlane> at_border;
  std::map<TriangleId, IntegerVector3> normals;
  for (const std::uint32_t t : patch.triangles_at(patch.number_of(notch))) {
    const TriangleId id = patch.triangles()[t];
    normals[id] = normal_of(surface, id);
  }
  for (const Patch::Spoke& spoke : patch.spokes(patch.number_of(notch))) {
    const PointId to = patch.points()[spoke.to];
    std::vector<TriangleId> ids;
    for (const std::uint32_t t : spoke.triangles) {
      const TriangleId id = patch.triangles()[t];
      if (!normals[id].isZero()) ids.push_back(id);
    }
    if (ids.size() == 1 && !at_border) {
      at_border = plane_through(surface, notch, to, ids, normals[ids[0]]);
    }
    for (std::size_t i = 0; i < ids.size(); ++i) {
      for (std::size_t j = i + 1; j < ids.size(); ++j) {
        const IntegerVector3 &n1 = normals[ids[i]], &n2 = normals[ids[j]];
        Rational cosine = signed_squared_cosine(n1, n2);
        auto plane = plane_through(surface, notch, to, {ids[i], ids[j]}, across(n1, n2, cosine));
        if (!plane) continue;
        plane->is_convex = !is_concave(surface, ids[i], n1, ids[j]);
        plane->cosine = std::move(cosine);
        planes.push_back(std::move(*plane));
      }
    }
  }
  std::stable_sort(planes.begin(), planes.end(), [](const SplitPlane& a, const SplitPlane& b) {
    return std::tie(a.is_convex, a.cosine) < std::tie(b.is_convex, b.cosine);
  });
  if (planes.empty() && at_border) planes.push_back(std::move(*at_border));
  return planes;
}

// ---- Division

namespace {

// On which side of a plane the centroids of triangles lie. In the frame, coordinates are off by
// 2^-54, so the sum of three corners less three times a point of the plane by less than 12 u,
// u = 2^-53, and it is below 6. The product with a normal whose components are at most 1, rounded
// as well, is off by less than 101 u, which is less than 2^-46.
class CentroidSide {
 public:
  CentroidSide(const Surface& surface, const Halfspace& plane, PointId on_plane,
               const NearSurface& near)
      : surface_(surface),
        plane_(plane),
        near_(near),
        on_plane_(near.points[on_plane.index()]),
        normal_(near_direction(plane.normal())) {}

  bool is_beyond(TriangleId triangle) const {
    constexpr double kError = 0x1p-46;
    const auto& [a, b, c] = surface_.triangles[triangle.index()];
    const Point sum = (near_.points[a.index()] - on_plane_) +
                      (near_.points[b.index()] - on_plane_) + (near_.points[c.index()] - on_plane_);
    const double near = normal_.dot(sum);
    if (std::abs(near) > kError) return near > 0;
    return plane_(surface_.points[a]) + plane_(surface_.points[b]) + plane_(surface_.points[c]) > 0;
  }

 private:
  const Surface& surface_;
  const Halfspace& plane_;
  const NearSurface& near_;
  Point on_plane_, normal_;
};

class Divider {
 public:
  Divider(const Surface& surface, const Units& units, const Patch& patch, PointId notch,
          const SplitPlane& plane, const NearSurface& near)
      : units_(units), side_(surface, plane.plane, notch, near) {
    for (const TriangleId t : patch.triangles()) state_[units.of(t)] = Remains;
    for (const TriangleId t : plane.triangles) at_notch_.push_back(units.of(t));
    std::vector<std::uint32_t> others;
    for (const std::uint32_t t : patch.triangles_at(patch.number_of(notch))) {
      others.push_back(units.of(patch.triangles()[t]));
    }
    std::sort(others.begin(), others.end());
    at_notch_.insert(at_notch_.end(), others.begin(), others.end());
  }

  std::optional<Division> run() {
    const auto is_up = [&](std::uint32_t unit) { return side_.is_beyond(units_.shown(unit)); };
    if (!take(Moves, is_up)) return {};
    if (!take(Stays, [](std::uint32_t) { return true; })) return {};
    Division made;
    for (const auto& [unit, state] : state_) {
      auto& half = state == Moves ? made.moved : state == Stays ? made.kept : made.islands;
      half.insert(half.end(), units_.triangles(unit).begin(), units_.triangles(unit).end());
    }
    for (auto* half : {&made.moved, &made.kept, &made.islands}) {
      std::sort(half->begin(), half->end());
    }
    return made;
  }

 private:
  enum State { Remains, Moves, Stays };

  // Takes those of the remaining units that are reached from the first fit one at the notch over
  // others that are fit; false if there is none.
  template <class Fit>
  bool take(State state, const Fit& is_fit) {
    const auto first = std::find_if(at_notch_.begin(), at_notch_.end(), [&](std::uint32_t unit) {
      return state_.at(unit) == Remains && is_fit(unit);
    });
    if (first == at_notch_.end()) return false;
    std::vector<std::uint32_t> front{*first};
    state_[*first] = state;
    while (!front.empty()) {
      const std::uint32_t unit = front.back();
      front.pop_back();
      for (const std::uint32_t other : units_.beside(unit)) {
        const auto found = state_.find(other);
        if (found == state_.end() || found->second != Remains || !is_fit(other)) continue;
        found->second = state;
        front.push_back(other);
      }
    }
    return true;
  }

  const Units& units_;
  CentroidSide side_;
  std::map<std::uint32_t, State> state_;  // by unit of the patch
  std::vector<std::uint32_t> at_notch_;   // first those at the edge
};

}  // namespace

std::optional<Division> divide(const Surface& surface, const Units& units, const Patch& patch,
                               PointId notch, const SplitPlane& plane, const NearSurface& near) {
  return Divider(surface, units, patch, notch, plane, near).run();
}

}  // namespace convexact
