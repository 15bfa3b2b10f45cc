// SPDX-License-Identifier: MIT
// definitional_verdict.hpp - the right verdict of the oracle on a small candidate, straight from
// the definition of each claim: all triples of points, all corners of all faces, all pairs of a
// point and a plane, in rationals. Shares only the number types with the oracle.
#pragma once
#include <array>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "affine_dimension.hpp"
#include "convexact/geometry.hpp"
#include "convexact/io.hpp"
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

/// The squared distance of a point to the intersection of halfspaces: 0 if none excludes it.
/// Otherwise the nearest point is the projection to the intersection of one, two or three of the
/// planes for which the projection lies in all halfspaces, and the vector to it is opposite to a
/// nonnegative combination of these normals (the conditions of Karush, Kuhn and Tucker). Nothing if
/// there is no such projection: the intersection is empty.
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
      for (const std::uint32_t c : polygon) {
        if (corners.empty() || corners.back() != points_[c]) corners.push_back(points_[c]);
      }
      while (corners.size() > 1 && corners.back() == corners.front()) corners.pop_back();
      std::set<Place> places;
      for (const RationalPoint& c : corners) places.insert(place_of(c));
      if (places.size() < 3) continue;
      for (std::size_t k = 0; k < corners.size(); ++k) {
        edges_.emplace_back(place_of(corners[k]), place_of(corners[(k + 1) % corners.size()]));
        face_of_.push_back(faces_.size());
      }
      faces_.push_back(std::move(corners));
    }
    if (is_solid()) planes_ = supporting_planes(points_);
  }

  bool is_solid() const { return affine_dimension(points_) == 3; }
  const std::vector<Halfspace>& planes() const { return planes_; }

  /// Whether there is a face with three corners at different places.
  bool has_faces() const { return !faces_.empty(); }
  bool is_closed() const {
    std::map<std::set<Place>, std::vector<std::size_t>> faces_at;
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      faces_at[{edges_[e].first, edges_[e].second}].push_back(face_of_[e]);
    }
    return std::all_of(faces_at.begin(), faces_at.end(), [](const auto& e) {
      return e.second.size() == 2 && e.second[0] != e.second[1];
    });
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
      const int dimension = affine_dimension(c);
      return dimension == 1 ? covers_a_segment_twice(c) : dimension == 2 && is_simple(c);
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
  static bool has_repeats(const std::vector<RationalPoint>& c) {
    std::set<Place> places;
    for (const RationalPoint& p : c) places.insert(place_of(p));
    return places.size() < c.size();
  }
  // For corners on a line: whether exactly two edges run between any two neighbours among them.
  static bool covers_a_segment_twice(const std::vector<RationalPoint>& c) {
    const RationalVector3 along = c[1] - c[0];
    std::vector<Rational> at;
    for (const RationalPoint& p : c) at.push_back(along.dot(RationalVector3(p - c[0])));
    std::vector<Rational> sorted = at;
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t i = 0; i + 1 < sorted.size(); ++i) {
      std::size_t edges = 0;
      for (std::size_t k = 0; k < at.size(); ++k) {
        const Rational &x = at[k], &y = at[(k + 1) % at.size()];
        edges += std::min(x, y) <= sorted[i] && sorted[i + 1] <= std::max(x, y) ? 1 : 0;
      }
      if (edges != 2) return false;
    }
    return !has_repeats(c);
  }
  // For segments in one plane: p + s u and q + t v with s and t in [0, 1].
  static bool do_meet(const RationalPoint& p, const RationalVector3& u, const RationalPoint& q,
                      const RationalVector3& v) {
    const RationalVector3 n = u.cross(v), w = q - p;
    if (n != RationalVector3::Zero()) {
      const Rational s = w.cross(v).dot(n) / n.dot(n), t = w.cross(u).dot(n) / n.dot(n);
      return s >= 0 && s <= 1 && t >= 0 && t <= 1;
    }
    if (w.cross(u) != RationalVector3::Zero()) return false;
    const Rational a = w.dot(u), b = a + v.dot(u);
    return std::max(a, b) >= 0 && std::min(a, b) <= u.dot(u);
  }
  // For corners in a plane: whether all differ, and edges meet only where they follow each other.
  static bool is_simple(const std::vector<RationalPoint>& c) {
    const std::size_t n = c.size();
    if (has_repeats(c)) return false;
    for (std::size_t i = 0; i < n; ++i) {
      const RationalVector3 u = c[(i + 1) % n] - c[i];
      for (std::size_t j = i + 1; j < n; ++j) {
        const RationalVector3 v = c[(j + 1) % n] - c[j];
        const bool follow = j == i + 1 || (i == 0 && j == n - 1);
        if (follow && u.cross(v) == RationalVector3::Zero() && u.dot(v) < 0) return false;
        if (!follow && do_meet(c[i], u, c[j], v)) return false;
      }
    }
    return true;
  }
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
  std::vector<std::size_t> face_of_;  // of each edge
  std::vector<Halfspace> planes_;
};

}  // namespace definition
