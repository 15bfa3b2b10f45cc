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

/// The largest squared distance of a point strictly beyond a plane to that plane, and how many
/// points are beyond at least one.
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

/// The squared distance of a point to the intersection of halfspaces: 0 if none excludes it. Else
/// the nearest point is where the projection to the meet of one, two or three of the planes lies in
/// all of them, and the way there is against a nonnegative combination of these normals (the
/// conditions of Karush, Kuhn and Tucker). Nothing if there is none such: the intersection is
/// empty.
inline std::optional<Rational> squared_distance(std::span<const Halfspace> planes,
                                                const RationalPoint& x) {
  std::vector<RationalVector3> n;
  std::vector<Rational> beyond;
  for (const Halfspace& h : planes) {
    n.push_back(h.normal().cast<Rational>());
    beyond.push_back(n.back().dot(x) + Rational(h.offset()));
  }
  const std::size_t count = planes.size();
  // Whether x - sum of y_k n_k lies in all halfspaces, for y >= 0 that solves the planes `chosen`.
  const auto reach = [&](std::vector<std::size_t> chosen) -> std::optional<Rational> {
    const auto k = static_cast<Eigen::Index>(chosen.size());
    Eigen::Matrix<Rational, 3, 3> gram = Eigen::Matrix<Rational, 3, 3>::Identity();
    Eigen::Matrix<Rational, 3, 1> value = Eigen::Matrix<Rational, 3, 1>::Zero();
    for (Eigen::Index i = 0; i < k; ++i) {
      for (Eigen::Index j = 0; j < k; ++j) gram(i, j) = n[chosen[i]].dot(n[chosen[j]]);
      value[i] = beyond[chosen[i]];
    }
    const auto column = [&](Eigen::Index c) -> RationalVector3 { return gram.col(c); };
    const auto det = [](const RationalVector3& a, const RationalVector3& b,
                        const RationalVector3& c) { return Rational(a.cross(b).dot(c)); };
    const Rational whole = det(column(0), column(1), column(2));
    if (whole == 0) return {};
    const Rational y[3] = {det(value, column(1), column(2)) / whole,
                           det(column(0), value, column(2)) / whole,
                           det(column(0), column(1), value) / whole};
    RationalVector3 way = RationalVector3::Zero();
    for (Eigen::Index i = 0; i < k; ++i) {
      if (y[i] < 0) return {};
      way += y[i] * n[chosen[i]];
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (beyond[i] - n[i].dot(way) > 0) return {};
    }
    return way.dot(way);
  };
  if (std::none_of(beyond.begin(), beyond.end(), [](const Rational& b) { return b > 0; })) return 0;
  for (std::size_t a = 0; a < count; ++a) {
    if (const auto found = reach({a})) return found;
  }
  for (std::size_t a = 0; a < count; ++a) {
    for (std::size_t b = a + 1; b < count; ++b) {
      if (const auto found = reach({a, b})) return found;
    }
  }
  for (std::size_t a = 0; a < count; ++a) {
    for (std::size_t b = a + 1; b < count; ++b) {
      for (std::size_t c = b + 1; c < count; ++c) {
        if (const auto found = reach({a, b, c})) return found;
      }
    }
  }
  return {};
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
