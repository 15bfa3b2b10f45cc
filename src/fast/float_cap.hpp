// SPDX-License-Identifier: MIT
// float_cap.hpp - what one removal costs in the float engine: arithmetics, and a cap in one of
// them.
#pragma once
#include <cmath>
#include <concepts>
#include <vector>

#include "fast/cap_volume.hpp"
#include "fast/dual.hpp"
#include "fast/mesh.hpp"
#include "fast/ring.hpp"
#include "fast/signs.hpp"

namespace convexact {

/// The float engine computes in an arithmetic, which provides
///   Scalar                              + - * / < > <= and, by leading(), the nearest double
///   Triple<Scalar> point(HalfspaceId)   the dual point, off by at most 2 unit() per coordinate
///   double unit()                       the relative error of one operation, at most 2^-24
/// and, if there is a longer arithmetic for the caps that this one does not find bounded,
///   Longer                              such a type, without a Longer of its own
///   const Longer& longer()
/// and, if the run is to bound its error (FastResult::bound),
///   const DualSigns& signs()            decides where a sign of T is uncertain in this arithmetic
/// These two are the engine's own.
struct DoubleDoubles {
  using Scalar = DoubleDouble;
  const FastDual& dual;
  DualSigns exact{dual};

  Triple<DoubleDouble> point(HalfspaceId i) const { return dual.long_point(i); }
  static constexpr double unit() { return Roundoff<DoubleDouble>::kUnit; }
  const DualSigns& signs() const { return exact; }
};

struct Doubles {
  using Scalar = double;
  using Longer = DoubleDoubles;
  const FastDual& dual;
  DoubleDoubles long_ones;

  const Triple<double>& point(HalfspaceId i) const { return dual.near(i); }
  static constexpr double unit() { return Roundoff<double>::kUnit; }
  const DualSigns& signs() const { return long_ones.exact; }
  const DoubleDoubles& longer() const { return long_ones; }
};

template <class Arithmetic>
concept HasLonger = requires {
  typename Arithmetic::Longer;
};
template <class Arithmetic>
concept HasSigns = requires(const Arithmetic& arithmetic) {
  { arithmetic.signs() } -> std::convertible_to<const DualSigns&>;
};

/// The cap of one dual point: ring, triangulation T and volume. Signs of H are taken as computed.
template <class Arithmetic>
class FloatCap {
 public:
  using Scalar = typename Arithmetic::Scalar;

  explicit FloatCap(const Arithmetic& arithmetic) : arithmetic_(arithmetic) {}

  /// Reads the coordinates of i and its ring, and triangulates it.
  void load(HalfspaceId i, const OneRing& ring, std::uint64_t seed,
            std::vector<RingTriangle>& triangles) {
    geometry_.load(i, ring.vertices, [&](HalfspaceId v) { return arithmetic_.point(v); });
    Beyond beyond{geometry_, ring.vertices, arithmetic_,
                  geometry_.filter(arithmetic_.unit()).height};
    triangulator_.run(static_cast<std::uint32_t>(ring.vertices.size()), beyond, seed, triangles);
    is_right_ = !beyond.is_wrong;
  }
  /// Whether T, as it was made last, has only right signs; true if the arithmetic has no signs().
  bool is_right() const { return is_right_; }
  /// The estimate for the cap read last, with T as it was made.
  CostEstimate<Scalar> estimate(const std::vector<RingTriangle>& triangles) {
    return cost_.estimate(geometry_, triangles, arithmetic_.unit());
  }
  const RingGeometry<Scalar>& geometry() const { return geometry_; }
  double unit() const { return arithmetic_.unit(); }

 private:
  struct Beyond {
    const RingGeometry<Scalar>& ring;
    const std::vector<HalfspaceId>& ids;
    const Arithmetic& arithmetic;
    double doubt;  // how far H may be off
    bool is_wrong = false;
    Triple<Scalar> normal{};
    std::uint32_t low = 0, middle = 0, high = 0;

    void set_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      low = a;
      middle = b;
      high = c;
      normal = cross(ring.point[b] - ring.point[a], ring.point[c] - ring.point[a]);
    }
    bool is_beyond(std::uint32_t m) {
      const Scalar height = dot(normal, ring.point[m] - ring.point[low]);
      const bool answer = is_positive(height);
      if constexpr (HasSigns<Arithmetic>) {
        if (!(std::abs(leading(height)) > doubt)) check(m, answer);
      }
      return answer;
    }
    // Where H is zero, either answer leads to a right T.
    void check(std::uint32_t m, bool answer) {
      const Sign sign = arithmetic.signs().height(ids[low], ids[middle], ids[high], ids[m]);
      is_wrong |= sign == (answer ? Sign::Negative : Sign::Positive);
    }
  };

  const Arithmetic& arithmetic_;
  RingGeometry<Scalar> geometry_;
  RingTriangulator triangulator_;
  CapCost<Scalar> cost_;
  bool is_right_ = true;
};

}  // namespace convexact
