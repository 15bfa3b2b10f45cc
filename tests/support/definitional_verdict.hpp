// SPDX-License-Identifier: MIT
// definitional_verdict.hpp - what the oracle should say about a small candidate, straight from the
// definition of each claim: all triples of points, all corners of all faces, all pairs of a point
// and a plane, in rationals. Shares nothing with the oracle but the number types.
#pragma once
#include <array>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "affine_dimension.hpp"
#include "convexact/geometry/halfspace_list.hpp"
#include "convexact/io/mesh.hpp"
#include "halfspace_arrangement.hpp"
#include "supporting_planes.hpp"

namespace definition {

using Place = std::array<Rational, 3>;

inline Place place_of(const RationalPoint& p) { return {p[0], p[1], p[2]}; }

inline std::vector<RationalPoint> rationals(const PointSet& points) {
  std::vector<RationalPoint> list;
  for (std::size_t i = 0; i < points.size(); ++i) list.push_back(points[PointId(i)]);
  return list;
}

/// The largest squared distance of a point strictly beyond a plane, and how many points are beyond
/// at least one.
struct Beyond {
  std::size_t points = 0;
  Rational worst = 0;
};

inline Beyond beyond(std::span<const Halfspace> planes, const std::vector<RationalPoint>& points) {
  Beyond result;
  for (const RationalPoint& p : points) {
    bool is_outside = false;
    for (const Halfspace& h : planes) {
      const RationalVector3 n = h.normal().cast<Rational>();
      const Rational value = n.dot(p) + Rational(h.offset());
      if (value <= 0) continue;
      is_outside = true;
      result.worst = std::max(result.worst, Rational(value * value / n.dot(n)));
    }
    result.points += is_outside ? 1 : 0;
  }
  return result;
}

class MeshByDefinition {
 public:
  explicit MeshByDefinition(const Mesh& mesh) : points_(rationals(mesh.points)) {
    for (const auto& polygon : mesh.polygons) {
      std::vector<RationalPoint> corners;
      for (const std::uint32_t c : polygon) corners.push_back(points_[c]);
      for (std::size_t k = 0; k < corners.size(); ++k) {
        edges_.emplace_back(place_of(corners[k]), place_of(corners[(k + 1) % corners.size()]));
      }
      faces_.push_back(std::move(corners));
    }
    if (is_solid()) planes_ = supporting_planes(points_);
  }

  bool is_solid() const { return affine_dimension(points_) == 3; }
  const std::vector<Halfspace>& planes() const { return planes_; }

  bool is_closed() const {
    std::map<std::set<Place>, int> faces_at;
    for (const auto& [from, to] : edges_) {
      if (from == to) return false;
      ++faces_at[{from, to}];
    }
    return std::all_of(faces_at.begin(), faces_at.end(),
                       [](const auto& e) { return e.second == 2; });
  }
  bool is_twisted() const {
    std::map<std::pair<Place, Place>, int> times;
    for (const auto& edge : edges_) {
      if (++times[edge] > 1 && edge.first != edge.second) return true;
    }
    return false;
  }
  /// Six times the signed volume of the cones from the origin over the fans of all faces.
  Rational enclosed() const {
    Rational sum = 0;
    for (const auto& c : faces_) {
      for (std::size_t k = 1; k + 1 < c.size(); ++k) sum += c[0].dot(c[k].cross(c[k + 1]));
    }
    return sum;
  }
  bool is_planar() const {
    return std::all_of(faces_.begin(), faces_.end(), [](const std::vector<RationalPoint>& c) {
      return normal_of(c) != RationalVector3::Zero() && affine_dimension(c) == 2;
    });
  }
  /// Whether no point of the mesh is beyond the plane of a face (through its first corner).
  bool no_point_beyond_a_face() const {
    for (const auto& c : faces_) {
      const RationalVector3 n = normal_of(c);
      for (const RationalPoint& p : points_) {
        if (n.dot(RationalVector3(p - c[0])) > 0) return false;
      }
    }
    return true;
  }
  /// Six times the volume of the hull, as the intersection of its halfspaces. At most 64 facets.
  Rational hull_volume() const {
    const HalfspaceArrangement arrangement(planes_);
    return 6 * arrangement.volume(arrangement.all()).value();
  }

 private:
  static RationalVector3 normal_of(const std::vector<RationalPoint>& c) {
    RationalVector3 sum = RationalVector3::Zero();
    for (std::size_t k = 1; k + 1 < c.size(); ++k) {
      const RationalVector3 u = c[k] - c[0], v = c[k + 1] - c[0];
      sum += u.cross(v);
    }
    return sum;
  }

  std::vector<RationalPoint> points_;
  std::vector<std::vector<RationalPoint>> faces_;
  std::vector<std::pair<Place, Place>> edges_;
  std::vector<Halfspace> planes_;
};

}  // namespace definition
