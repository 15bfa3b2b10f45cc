// SPDX-License-Identifier: MIT
// auditor.hpp - repeats every decision that the filtered engine makes without exact numbers: signs
// by a determinant of rationals, caps by the exact engine's explicit polytopes.
#pragma once
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <span>
#include <variant>
#include <vector>

#include "convexact/dual.hpp"
#include "convexact/hull.hpp"
#include "exact_determinant.hpp"
#include "fast/filtered_loop.hpp"
#include "simplify/cap.hpp"

namespace audit {

using namespace convexact;

/// The decisions reported to an auditor, and those that it repeated.
struct Tally {
  std::size_t signs = 0, unknown_signs = 0, signs_checked = 0;
  std::size_t caps = 0, unenclosed_caps = 0, caps_checked = 0;
};

/// Repeats the decision on every `stride`-th sign and cap that is reported.
class Auditor : public CostObserver, public Tally {
 public:
  Auditor(const FastDual& dual, std::size_t stride, CostMeasure measure = CostMeasure::Volume)
      : dual_(dual), stride_(stride), measure_(measure) {}

  void height(HalfspaceId a, HalfspaceId b, HalfspaceId c, HalfspaceId p,
              FilterSign sign) override {
    if (sign == FilterSign::Unknown) {
      ++unknown_signs;
      return;
    }
    if (++signs % stride_ != 0) return;
    std::vector<std::vector<Rational>> rows;
    for (const HalfspaceId i : {a, b, c, p}) {
      const Halfspace& h = dual_.exact(i);
      rows.push_back({Rational(h.normal()[0]), Rational(h.normal()[1]), Rational(h.normal()[2]),
                      Rational(h.offset())});
    }
    CHECK(static_cast<int>(sign_of(exact_determinant(rows))) == static_cast<int>(sign));
    ++signs_checked;
  }

  void in_doubles(HalfspaceId i, const OneRing& ring, const std::vector<RingTriangle>& triangles,
                  const CostBounds<double>& bounds) override {
    decide_again(i, ring, triangles, bounds);
  }
  void in_double_doubles(HalfspaceId i, const OneRing& ring,
                         const std::vector<RingTriangle>& triangles,
                         const CostBounds<DoubleDouble>& bounds) override {
    decide_again(i, ring, triangles, bounds);
  }

 private:
  template <class Scalar>
  void decide_again(HalfspaceId i, const OneRing& ring, const std::vector<RingTriangle>& triangles,
                    const CostBounds<Scalar>& bounds) {
    unenclosed_caps += bounds.kind == Boundedness::Doubtful;
    if (bounds.kind == Boundedness::Doubtful || ++caps % stride_ != 0) return;
    const auto point = [&](HalfspaceId v) { return polar(dual_.exact(v), dual_.center()); };
    const std::size_t k = ring.vertices.size();
    std::vector<DualPlane> base;
    for (std::size_t m = 0; m < k; ++m) {
      base.push_back(
          plane_through(point(i), point(ring.vertices[m]), point(ring.vertices[(m + 1) % k])));
    }
    RingTriangulation roof;
    for (const RingTriangle& t : triangles) {
      const DualTriangle corners{ring.vertices[t.low], ring.vertices[t.middle],
                                 ring.vertices[t.high]};
      roof.triangles.push_back(corners);
      roof.planes.push_back(plane_through(point(corners[0]), point(corners[1]), point(corners[2])));
    }
    REQUIRE(roof.is_bounded() == (bounds.kind == Boundedness::Bounded));
    ++caps_checked;
    if (bounds.kind != Boundedness::Bounded) return;
    const auto [low, high] = multiple(make_cap(ring.vertices, base, roof), i, ring.vertices);
    CHECK(exactly(bounds.lower) <= low);
    const bool is_beyond_doubles = std::isinf(leading(bounds.upper));
    CHECK((is_beyond_doubles || high <= exactly(bounds.upper)));
  }

  // The number that is bounded, exactly or within 200 bits.
  std::array<Rational, 2> multiple(const Cap& cap, HalfspaceId i,
                                   std::span<const HalfspaceId> ring) {
    const long exponent = -dual_.cost_exponent(measure_);
    if (measure_ == CostMeasure::Volume) {
      const Rational six_times = scale_by_power_of_two(volume(cap) * 6, exponent);
      return {six_times, six_times};
    }
    constexpr long kBits = 200;
    if (directions_.empty()) {
      std::vector<DualPoint> points;
      for (std::size_t k = 0; k < dual_.size(); ++k) {
        points.push_back(polar(dual_.exact(HalfspaceId(k)), dual_.center()));
      }
      directions_ = primitive_directions(points);
    }
    Enclosure value = cost_of(cap, directions_, i, ring, measure_).enclose(kBits);
    value *= measure_ == CostMeasure::Area ? Enclosure(Integer(2), kBits)
                                           : Enclosure(Integer(4), kBits) * Enclosure::pi(kBits);
    return {scale_by_power_of_two(value.low(), exponent),
            scale_by_power_of_two(value.high(), exponent)};
  }

  static Rational exactly(double x) { return to_rational(x); }
  static Rational exactly(const DoubleDouble& x) {
    return to_rational(x.hi()) + to_rational(x.lo());
  }

  const FastDual& dual_;
  std::size_t stride_;
  CostMeasure measure_;
  std::vector<IntegerVector3> directions_;
};

struct Audited {
  Tally tally;
  FastCounts counts;
};

/// Runs the loop to `faces` halfspaces under an audit.
inline Audited run(const FastDual& dual, std::size_t stride, const SimplifyOptions& options = {}) {
  Auditor auditor(dual, stride, options.cost);
  const FastResult result = FilteredLoop(dual, options, &auditor).run();
  return {auditor, result.counts};
}

/// The same for points that span a volume.
inline Audited run(const std::vector<Point>& points, std::size_t stride, std::size_t faces = 4) {
  const PointSet set(points);
  const Hull hull = std::get<Hull>(convex_hull(set));
  return run(FastDual::of(hull, set), stride, {.faces = faces});
}

}  // namespace audit
