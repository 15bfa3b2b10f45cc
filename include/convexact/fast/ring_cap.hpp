// SPDX-License-Identifier: MIT
// ring_cap.hpp - the cap of one dual point, in one floating-point arithmetic.
#pragma once
#include <vector>

#include "convexact/fast/cap_estimate.hpp"
#include "convexact/fast/half_edge_mesh.hpp"
#include "convexact/fast/ring_geometry.hpp"
#include "convexact/fast/triangulate_ring.hpp"

namespace convexact {

/// Ring, triangulation T and volume. Signs of H are taken as they come out.
/// @tparam Arithmetic  As for FloatLoop.
template <class Arithmetic>
class RingCap {
 public:
  using Scalar = typename Arithmetic::Scalar;

  explicit RingCap(const Arithmetic& arithmetic) : arithmetic_(arithmetic) {}

  /// Reads the coordinates of i and its ring, and triangulates it.
  void load(HalfspaceId i, const OneRing& ring, std::uint64_t seed,
            std::vector<RingTriangle>& triangles) {
    geometry_.load(i, ring.vertices, [&](HalfspaceId v) { return arithmetic_.point(v); });
    Beyond beyond{geometry_};
    triangulator_.run(static_cast<std::uint32_t>(ring.vertices.size()), beyond, seed, triangles);
  }
  /// Of the cap read last, with T as it was made.
  CapEstimate<Scalar> estimate(const std::vector<RingTriangle>& triangles) {
    return estimator_.run(geometry_, triangles, arithmetic_.unit());
  }
  const RingGeometry<Scalar>& geometry() const { return geometry_; }

 private:
  struct Beyond {
    const RingGeometry<Scalar>& ring;
    Triple<Scalar> normal{};
    std::uint32_t low = 0;

    void set_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      low = a;
      normal = cross(ring.point[b] - ring.point[a], ring.point[c] - ring.point[a]);
    }
    bool is_beyond(std::uint32_t m) const {
      return is_positive(dot(normal, ring.point[m] - ring.point[low]));
    }
  };

  const Arithmetic& arithmetic_;
  RingGeometry<Scalar> geometry_;
  RingTriangulator triangulator_;
  CapEstimator<Scalar> estimator_;
};

}  // namespace convexact
