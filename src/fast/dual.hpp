// SPDX-License-Identifier: MIT
// dual.hpp - the dual hull for the fast engines: dual points in doubles with a proven
// error, exact planes only on demand.
#pragma once
#include <array>
#include <memory>
#include <span>
#include <vector>

#include "convexact/cost.hpp"
#include "convexact/dual.hpp"
#include "convexact/hull.hpp"
#include "number/double_double.hpp"

namespace convexact {

/// Three numbers of any kind, with the few vector operations of the fast engines.
template <class Scalar>
struct Triple {
  Scalar x, y, z;

  Scalar& operator[](int k) { return k == 0 ? x : k == 1 ? y : z; }
  const Scalar& operator[](int k) const { return k == 0 ? x : k == 1 ? y : z; }
};

template <class Scalar>
inline Triple<Scalar> operator-(const Triple<Scalar>& a, const Triple<Scalar>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <class Scalar>
inline Triple<Scalar> cross(const Triple<Scalar>& a, const Triple<Scalar>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class Scalar>
inline Scalar dot(const Triple<Scalar>& a, const Triple<Scalar>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// The dual hull of a primal hull, triangulated. Ids are positions in the list of facets.
struct DualFaces {
  std::vector<DualTriangle> triangles;
  /// Of half-edge 3 t + c, which leaves corner c of triangle t, the opposite one.
  std::vector<std::uint32_t> twins;
};

/// A dual face, the convex polygon of the facets around a vertex, is cut in a zigzag: no dual point
/// gets more than two diagonals of it. So rings stay short where hundreds of facets meet; with a
/// fan they would not.
/// @param facets  Closed and manifold; corners below point_count.
/// @par Cost      Linear.
[[nodiscard]] DualFaces triangulate_dual_faces(const FacetList& facets, std::size_t point_count);

/// A bounded solid as dual points. With c the center and w_i = -(n_i.c + d_i) > 0, dual point i is
/// P_i = n_i / w_i, each axis scaled by a power of two so that the largest coordinate is in
/// [1/2, 1]. Scaling an axis multiplies every determinant by one positive constant, so no sign and
/// no comparison of volumes depends on it.
///
/// Two roundings are kept: near(i), a double per coordinate, and near(i) + rest(i), twice as long.
/// Each coordinate q of P_i, wherever it does not underflow (see PlaneFilter), satisfies
///   |near - q| <= kNearError |near|   and   |near + rest - q| <= kLongError |near|.
class FastDual {
 public:
  static constexpr double kNearError = 0x1p-52;
  static constexpr double kLongError = 0x1p-85;

  /// Reads the dual off a hull without forming its exact planes: ids are positions
  /// in hull.facets, *not* canonical. Both arguments must outlive the object.
  /// @par Cost  Linear; about 0.3 microseconds per facet. Where cancellation would break the bound
  ///            (a facet normal close to, but not in, a coordinate plane), exact numbers are used.
  static FastDual of(const Hull& hull, const PointSet& points);
  static FastDual of(Hull&&, const PointSet&) = delete;
  /// From exact planes; ids are theirs. `dual` must outlive the object.
  /// @param center  Strictly inside. @throws Error InvalidArgument if it is not.
  static FastDual of(const DualHull& dual, const RationalPoint& center);
  static FastDual of(DualHull&&, const RationalPoint&) = delete;

  FastDual(FastDual&&) noexcept;
  ~FastDual();

  std::size_t size() const { return near_.size(); }
  /// A closed triangulated sphere, 2 size() - 4 triangles.
  std::span<const DualTriangle> triangles() const { return triangles_; }
  /// Of half-edge 3 t + c, which leaves corner c of triangle t, the opposite one.
  std::span<const std::uint32_t> twins() const { return twins_; }
  const Triple<double>& near(HalfspaceId i) const { return near_[i.index()]; }
  const Triple<double>& rest(HalfspaceId i) const { return rest_[i.index()]; }
  Triple<DoubleDouble> long_point(HalfspaceId i) const {
    const Triple<double>&a = near(i), &b = rest(i);
    return {{a.x, b.x}, {a.y, b.y}, {a.z, b.z}};
  }
  /// The vertices of the solid that lie on plane i, as ascending numbers: planes with a common
  /// number have a common point.
  std::span<const std::uint32_t> incidences(HalfspaceId i) const {
    return {incident_.data() + incident_start_[i.index()],
            incident_.data() + incident_start_[i.index() + 1]};
  }
  /// near(i) in the caller's frame: each axis scaled back, and all of them by one common power of
  /// two. For lengths and angles, which scaling of single axes changes.
  Triple<double> in_callers_frame(HalfspaceId i) const {
    const Triple<double>& p = near(i);
    return {p.x * axis_weight_[0], p.y * axis_weight_[1], p.z * axis_weight_[2]};
  }
  /// The same for long_point(i).
  Triple<DoubleDouble> long_point_in_callers_frame(HalfspaceId i) const {
    const Triple<double> a = in_callers_frame(i), &b = rest(i);
    return {
        {a.x, b.x * axis_weight_[0]}, {a.y, b.y * axis_weight_[1]}, {a.z, b.z * axis_weight_[2]}};
  }
  /// Volumes in these coordinates times 2^this are volumes in the caller's cubed length unit.
  long volume_exponent() const { return long{frame_[0]} + frame_[1] + frame_[2]; }
  /// Costs computed from determinants of these coordinates and, for area and mean width, from
  /// points in_callers_frame(), times 2^this are costs in the caller's units.
  long cost_exponent(CostMeasure measure) const;

  /// The halfspace itself; formed when it is first asked for.
  const Halfspace& exact(HalfspaceId i) const;
  /// Of a dual of a hull of doubles: the corners of facet i, counter-clockwise from outside.
  /// Otherwise none.
  std::span<const PointId> corners(HalfspaceId i) const;
  /// One of these corners.
  const Point& point(PointId corner) const;
  /// How many halfspaces have been formed so far.
  std::size_t formed() const;
  /// Whether i stands before j in canonical order.
  bool precedes(HalfspaceId i, HalfspaceId j) const;
  /// The outward normal up to rounding, its largest entry +-1; zeros where doubles are too short
  /// for it, as for a plane whose axis has far larger numbers than the others.
  std::array<double, 3> direction(HalfspaceId i) const;
  /// The sizes of the entries of the normal, up to rounding, over the largest of them, ascending:
  /// the same for facets that a symmetry of the axes carries to each other. Zeros where doubles
  /// are too short for the normal: they tell nothing.
  std::array<double, 3> normal_sizes(HalfspaceId i) const;
  /// What two such sizes may differ by where the true ones are equal, and more than that.
  static constexpr double kEqualSizes = 0x1p-40;
  /// Whether a symmetry of the axes seems to carry one normal to the other.
  bool seem_congruent(HalfspaceId i, HalfspaceId j) const;
  /// As precedes(), without exact numbers where the two seem_congruent(): their primitive normals
  /// are then equally long, so the directions, in doubles, are in the same order. For choices that
  /// need no proof.
  bool seems_to_precede(HalfspaceId i, HalfspaceId j) const;
  /// Strictly inside: the point that the dual refers to.
  const RationalPoint& center() const { return center_; }

 private:
  friend class FastDualBuilder;
  FastDual();
  struct Planes;

  std::vector<Triple<double>> near_, rest_;
  std::vector<DualTriangle> triangles_;
  std::vector<std::uint32_t> twins_;
  std::vector<std::uint32_t> incident_, incident_start_;
  std::array<int, 3> frame_{0, 0, 0};           // caller's length = length here * 2^frame
  std::array<double, 3> axis_weight_{1, 1, 1};  // 2^-frame over the largest of the three
  RationalPoint center_;
  std::unique_ptr<Planes> planes_;
};

}  // namespace convexact
