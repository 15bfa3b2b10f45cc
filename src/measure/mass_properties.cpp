// SPDX-License-Identifier: MIT
#include "convexact/error.hpp"
#include "convexact/measure.hpp"
#include "measure/mass_sum.hpp"
#include "number/arithmetic.hpp"

namespace convexact {
namespace {

// The entries of a symmetric matrix, in the order of MassProperties.
constexpr std::pair<int, int> kEntries[] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};

}  // namespace

void MassSum::add(const RationalPoint& p, const RationalPoint& q, const RationalPoint& r) {
  const RationalVector3 a = p - origin_, b = q - origin_, c = r - origin_;
  const Rational six = a.dot(b.cross(c));
  if (six == 0) return;
  const RationalVector3 sum = a + b + c;
  volumes_.push_back(six);
  for (int k = 0; k < 3; ++k) first_[k].push_back(six * sum[k]);
  for (std::size_t e = 0; e < 6; ++e) {
    const auto [i, k] = kEntries[e];
    second_[e].push_back(six * (a[i] * a[k] + b[i] * b[k] + c[i] * c[k] + sum[i] * sum[k]));
  }
}

std::optional<MassProperties> MassSum::total() {
  MassProperties made;
  made.volume = balanced_sum(std::move(volumes_)) / 6;
  if (made.volume == 0) return {};
  RationalVector3 offset;
  for (int k = 0; k < 3; ++k) {
    offset[k] = balanced_sum(std::move(first_[k])) / (24 * made.volume);
  }
  made.center = origin_ + offset;
  for (std::size_t e = 0; e < 6; ++e) {
    const auto [i, k] = kEntries[e];
    // About the origin, less that of all mass at the center.
    made.moments[e] =
        balanced_sum(std::move(second_[e])) / 120 - made.volume * offset[i] * offset[k];
  }
  return made;
}

std::array<Rational, 6> MassProperties::inertia() const {
  const auto& m = moments;
  return {m[1] + m[2], m[0] + m[2], m[0] + m[1], -m[3], -m[4], -m[5]};
}

MassProperties mass_properties(const Polytope& polytope) {
  MassSum sum(bounding_box(polytope.vertices).middle());
  for (const auto& facet : polytope.facets) {
    const auto corner = [&](std::size_t k) -> const RationalPoint& {
      return polytope.vertices[facet[k]];
    };
    for (std::size_t k = 2; k < facet.size(); ++k) sum.add(corner(0), corner(k - 1), corner(k));
  }
  auto made = sum.total();
  CONVEXACT_ASSERT(made);
  return std::move(*made);
}

std::optional<MassProperties> put_together(std::span<const MassProperties> bodies) {
  MassProperties sum;
  sum.volume = 0;
  RationalVector3 first = RationalVector3::Zero();
  for (const MassProperties& body : bodies) {
    sum.volume += body.volume;
    first += body.volume * body.center;
  }
  if (sum.volume == 0) return {};
  sum.center = first / sum.volume;
  for (std::size_t e = 0; e < 6; ++e) {
    const auto [i, k] = kEntries[e];
    sum.moments[e] = 0;
    for (const MassProperties& body : bodies) {
      const RationalVector3 offset = body.center - sum.center;  // the parallel axis theorem
      sum.moments[e] += body.moments[e] + body.volume * offset[i] * offset[k];
    }
  }
  return sum;
}

}  // namespace convexact
