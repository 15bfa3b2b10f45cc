// SPDX-License-Identifier: MIT
// Doubles, incidence, DoubleDouble, mirror pairs, integers: each stage is used only if the one
// before is uncertain.
#include "fast/signs.hpp"

#include <algorithm>

#include "fast/close_determinants.hpp"
#include "fast/congruence.hpp"
#include "geometry/plane_determinants.hpp"

namespace convexact {
namespace {

// H and D of four or three points in floating arithmetic. With all w = 1,
// H = ((b - a) x (c - a)).(p - a) and D = ((b - a) x (c - a)).a.
template <class Scalar>
FilterSign height_in(const Triple<Scalar>& a, const Triple<Scalar>& b, const Triple<Scalar>& c,
                     const Triple<Scalar>& p) {
  const Triple<Scalar> f = b - a, g = c - a, h = p - a;
  Extent extent;
  extent.include(f);
  extent.include(g);
  extent.include(h);
  return filter_sign(leading(dot(cross(f, g), h)),
                     PlaneFilter::within(extent.size, Roundoff<Scalar>::kUnit).height);
}

FilterSign determinant_in(const Triple<double>& a, const Triple<double>& b,
                          const Triple<double>& c) {
  const Triple<double> f = b - a, g = c - a;
  Extent extent;
  extent.include(f);
  extent.include(g);
  return filter_sign(dot(cross(f, g), a),
                     PlaneFilter::within(extent.size, Roundoff<double>::kUnit).determinant);
}

FilterSign sign_by(const Approximate& x) { return filter_sign(x.value.hi(), x.error); }

Sign to_sign(FilterSign v) { return Sign(static_cast<signed char>(v)); }

// `list` is ascending.
bool contains(std::span<const std::uint32_t> list, std::uint32_t x) {
  constexpr std::size_t kFewEnoughToScan = 8;
  if (list.size() > kFewEnoughToScan) return std::binary_search(list.begin(), list.end(), x);
  for (const std::uint32_t y : list) {
    if (y == x) return true;
  }
  return false;
}

// Whether four planes are known to pass through one vertex; then they are dependent.
bool share_vertex(const FastDual& dual, HalfspaceId a, HalfspaceId b, HalfspaceId c,
                  HalfspaceId d) {
  std::span<const std::uint32_t> few = dual.incidences(a), second = dual.incidences(b),
                                 third = dual.incidences(c), fourth = dual.incidences(d);
  for (std::span<const std::uint32_t>* other : {&second, &third, &fourth}) {
    if (other->size() < few.size()) std::swap(*other, few);
  }
  return std::any_of(few.begin(), few.end(), [&](std::uint32_t vertex) {
    return contains(second, vertex) && contains(third, vertex) && contains(fourth, vertex);
  });
}

// If a vertex of the input lies on three of these planes and not on the fourth: the place of the
// fourth.
std::optional<std::size_t> plane_off_shared_vertex(const FastDual& dual,
                                                   const std::array<HalfspaceId, 4>& planes) {
  std::array<std::span<const std::uint32_t>, 4> vertices;
  std::array<std::size_t, 4> order{0, 1, 2, 3};
  for (std::size_t k = 0; k < 4; ++k) vertices[k] = dual.incidences(planes[k]);
  std::sort(order.begin(), order.end(),
            [&](std::size_t k, std::size_t m) { return vertices[k].size() < vertices[m].size(); });
  // Among three of the planes there is one of any two; these two have the fewest vertices.
  for (const std::size_t k : {order[0], order[1]}) {
    for (const std::uint32_t vertex : vertices[k]) {
      std::size_t count = 0, off = 0;
      for (std::size_t m = 0; m < 4; ++m) {
        const bool is_on = m == k || contains(vertices[m], vertex);
        count += is_on;
        if (!is_on) off = m;
      }
      if (count == 3) return off;
    }
  }
  return {};
}

// Whether all these normals are known to lie in one coordinate plane, as along a prism; then three
// of them are dependent, and so are four rows (n, d). A coordinate that underflowed to zero is
// distinguished from a true zero.
template <class... Ids>
bool share_axis(const FastDual& dual, Ids... ids) {
  for (int k = 0; k < 3; ++k) {
    const auto is_zero = [&](HalfspaceId i) {
      return dual.near(i)[k] == 0 && dual.exact(i).normal()[k].is_zero();
    };
    if ((is_zero(ids) && ...)) return true;
  }
  return false;
}

}  // namespace

Sign DualSigns::height(HalfspaceId a, HalfspaceId b, HalfspaceId c, HalfspaceId p) const {
  const FilterSign sure = height_in(dual_->near(a), dual_->near(b), dual_->near(c), dual_->near(p));
  if (sure == FilterSign::Unknown) return height_beyond_doubles(a, b, c, p);
  ++counts_.filtered;
  return to_sign(sure);
}

bool DualSigns::is_known_zero(HalfspaceId a, HalfspaceId b, HalfspaceId c, HalfspaceId p) const {
  return share_vertex(*dual_, a, b, c, p) || share_axis(*dual_, a, b, c, p);
}

// Let the origin be a vertex v of the input on planes a, b and c: then their offsets are zero, and
// H is D(a, b, c) times the value of p at v. That value is negative, as v lies on or inside all
// planes. Of another three planes, the fourth row changes places with those behind it.
std::optional<Sign> DualSigns::height_by_vertex(const std::array<HalfspaceId, 4>& planes) const {
  const std::optional<std::size_t> off = plane_off_shared_vertex(*dual_, planes);
  if (!off) return {};
  std::array<HalfspaceId, 3> on;
  std::copy_if(planes.begin(), planes.end(), on.begin(),
               [&](HalfspaceId i) { return i != planes[*off]; });
  const Sign sign = determinant(on[0], on[1], on[2]);
  const bool is_swapped = *off % 2 == 0;  // an odd number of rows behind it
  return is_swapped ? sign : -sign;
}

Sign DualSigns::height_beyond_doubles(HalfspaceId a, HalfspaceId b, HalfspaceId c,
                                      HalfspaceId p) const {
  if (is_known_zero(a, b, c, p)) {
    ++counts_.incident;
    return Sign::Zero;
  }
  if (const std::optional<Sign> sign = height_by_vertex({a, b, c, p})) return *sign;
  const Triple<DoubleDouble> at_a = dual_->long_point(a), at_b = dual_->long_point(b),
                             at_c = dual_->long_point(c), at_p = dual_->long_point(p);
  FilterSign sure = height_in(at_a, at_b, at_c, at_p);
  if (sure == FilterSign::Unknown) sure = sign_by(close_height(at_a, at_b, at_c, at_p));
  if (sure != FilterSign::Unknown) {
    ++counts_.extended;
    return to_sign(sure);
  }
  if (are_mirror_pairs(*dual_, {a, b, c, p})) {
    ++counts_.incident;
    return Sign::Zero;
  }
  ++counts_.exact;
  return sign_of(
      plane_determinant(dual_->exact(a), dual_->exact(b), dual_->exact(c), dual_->exact(p)));
}

Sign DualSigns::determinant(HalfspaceId a, HalfspaceId b, HalfspaceId c) const {
  const FilterSign sure = determinant_in(dual_->near(a), dual_->near(b), dual_->near(c));
  if (sure == FilterSign::Unknown) return determinant_beyond_doubles(a, b, c);
  ++counts_.filtered;
  return to_sign(sure);
}

Sign DualSigns::determinant_beyond_doubles(HalfspaceId a, HalfspaceId b, HalfspaceId c) const {
  if (share_axis(*dual_, a, b, c)) {
    ++counts_.incident;
    return Sign::Zero;
  }
  const FilterSign sure =
      sign_by(close_determinant(dual_->long_point(a), dual_->long_point(b), dual_->long_point(c)));
  if (sure != FilterSign::Unknown) {
    ++counts_.extended;
    return to_sign(sure);
  }
  ++counts_.exact;
  return sign_of(normal_determinant(dual_->exact(a), dual_->exact(b), dual_->exact(c)));
}

}  // namespace convexact
