// SPDX-License-Identifier: MIT
#include "fast/growth_watch.hpp"

#include <algorithm>
#include <limits>

#include "convexact/error.hpp"
#include "convexact/number.hpp"
#include "fast/cap.hpp"
#include "fast/cap_volume.hpp"
#include "fast/mesh.hpp"
#include "fast/signs.hpp"

namespace convexact {
namespace {

// Six times the volume of the initial solid, enclosed.
CapRange<double> volume_range(const FastDual& dual) {
  const HalfEdgeMesh mesh(dual.size(), dual.triangles());
  RangeSource<double>::Sum sum;
  OneRing ring;
  RingGeometry<double> geometry;
  std::size_t terms = 0;
  bool certain = true;
  for (std::size_t i = 0; i < dual.size(); ++i) {
    mesh.one_ring(HalfspaceId(i), ring);
    geometry.load(HalfspaceId(i), ring.vertices, [&](HalfspaceId v) { return dual.near(v); });
    RangeSource<double> source(geometry, Roundoff<double>::kUnit);
    add_cone(static_cast<std::uint32_t>(ring.vertices.size()), source, sum);
    terms += ring.vertices.size();
    certain = certain && source.is_certain();
  }
  using Kind = CapRange<double>::Kind;
  if (!certain) return CapRange<double>::doubtful();
  // As for a cap, with all cones in one sum.
  const double slop = 2 * (16 + 2 * static_cast<double>(terms)) * Roundoff<double>::kUnit;
  const double tiny = ExponentRange<double>::kVolumeUnderflow;
  return {Kind::Bounded, std::max(sum.total.lower * (1 - slop) - tiny, 0.0),
          sum.total.upper * (1 + slop) + tiny};
}

}  // namespace

Rational exact_volume(const FastDual& dual, std::span<const DualTriangle> triangles) {
  const HalfEdgeMesh mesh(dual.size(), triangles);
  ExactCapSource::Sum sum;
  OneRing ring;
  for (const HalfspaceId i : mesh.vertices()) {
    mesh.one_ring(i, ring);
    ExactCapSource source(dual, i, ring.vertices);
    ExactCapSource::Sum cone;
    add_cone(static_cast<std::uint32_t>(ring.vertices.size()), source, cone);
    // The row of i is once more below than above, and the apex lies at slack w_i instead of 1.
    sum.add(Rational(cone.total() * -dual.exact(i)(dual.center())));
  }
  return Rational(sum.total() / 6);
}

GrowthWatch::GrowthWatch(const FastDual& dual, const std::optional<Rational>& max_growth)
    : dual_(dual), max_growth_(max_growth) {
  if (!max_growth_) return;
  if (*max_growth_ < 0) throw Error(ErrorCode::InvalidArgument, "a growth limit is not negative");
  const CapRange<double> six_times = volume_range(dual);
  limit_lower_ = std::max(
      0.0, next_below(next_below(six_times.lower / 6) * to_double(*max_growth_, Rounding::Down)));
  limit_upper_ =
      next_above(next_above(six_times.upper / 6) * to_double(*max_growth_, Rounding::Up));
}

bool GrowthWatch::allows(double lower, double upper,
                         const std::function<Rational()>& volume_after) {
  if (!max_growth_) return true;
  const double grown_lower = next_below(grown_lower_ + lower);
  const double grown_upper = next_above(grown_upper_ + upper);
  if (grown_lower > limit_upper_) return false;
  if (!(grown_upper <= limit_lower_)) {
    if (!exact_limit_) {
      exact_limit_ = (1 + *max_growth_) * exact_volume(dual_, dual_.triangles());
    }
    if (volume_after() > *exact_limit_) return false;
  }
  grown_lower_ = grown_lower;
  grown_upper_ = grown_upper;
  return true;
}

}  // namespace convexact
