// SPDX-License-Identifier: MIT
#include "fast/congruence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "convexact/number.hpp"
#include "number/arithmetic.hpp"
#include "number/double_double.hpp"

namespace convexact {
namespace {

using Direction = std::array<double, 3>;

bool is_unknown(const Direction& d) { return d[0] == 0 && d[1] == 0 && d[2] == 0; }

// A vector, exactly: each entry as the sum of two doubles: the nearest one, and the rest. Not a
// number where it overflows, and then equal to nothing.
using Translation = std::array<std::pair<double, double>, 3>;

// Row k has its only entry, sign[k], in column axis[k].
struct SignedPermutation {
  std::array<int, 3> axis, sign;

  // Mirror images are run through clockwise.
  bool is_reflection() const {
    const bool even = (axis[1] - axis[0] + 3) % 3 == 1;
    return sign[0] * sign[1] * sign[2] * (even ? 1 : -1) < 0;
  }
  bool is_inverse_of_itself() const {
    for (int k = 0; k < 3; ++k) {
      if (axis[axis[k]] != k || sign[axis[k]] != sign[k]) return false;
    }
    return true;
  }
  Point operator()(const Point& x) const {
    return {sign[0] * x[axis[0]], sign[1] * x[axis[1]], sign[2] * x[axis[2]]};
  }
  // Whether S t = -t. If S is its own inverse, then so is x -> S x + t.
  bool turns_round(const Translation& t) const {
    for (int k = 0; k < 3; ++k) {
      const auto& [high, low] = t[axis[k]];
      if (sign[k] * high != -t[k].first || sign[k] * low != -t[k].second) return false;
    }
    return true;
  }
  // Whether to = S from.
  bool carries(const IntegerVector3& from, const IntegerVector3& to) const {
    for (int k = 0; k < 3; ++k) {
      const Integer& x = from[axis[k]];
      if (x.sign() * sign[k] != to[k].sign()) return false;
      if (mpz_cmpabs(x.backend().data(), to[k].backend().data()) != 0) return false;
    }
    return true;
  }
  // False if it does not carry the normal with direction `from` to that with direction `to`.
  bool may_carry(const Direction& from, const Direction& to) const {
    if (is_unknown(from) || is_unknown(to)) return true;
    for (int k = 0; k < 3; ++k) {
      if (std::abs(sign[k] * from[axis[k]] - to[k]) > FastDual::kEqualSizes) return false;
    }
    return true;
  }
};

std::array<SignedPermutation, 48> all_signed_permutations() {
  std::array<SignedPermutation, 48> all;
  auto next = all.begin();
  std::array<int, 3> axis{0, 1, 2};
  do {
    for (int signs = 0; signs < 8; ++signs) {
      *next++ = {axis, {signs & 1 ? -1 : 1, signs & 2 ? -1 : 1, signs & 4 ? -1 : 1}};
    }
  } while (std::next_permutation(axis.begin(), axis.end()));
  return all;
}

const std::array<SignedPermutation, 48>& all_symmetries() {
  static const std::array<SignedPermutation, 48> kSymmetries = all_signed_permutations();
  return kSymmetries;
}

// The lexicographically least of some points, by its position.
template <class Corner>
std::size_t least_of(std::size_t count, const Corner& corner) {
  std::size_t least = 0;
  for (std::size_t m = 1; m < count; ++m) {
    const Point p = corner(m), q = corner(least);
    if (std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end())) least = m;
  }
  return least;
}

// The t for which x -> S x + t carries the corners of facet i to those of j; none if none is found.
// Then it carries the halfspace of i to that of j: outside is where corners are run through
// counter-clockwise. Not for a facet of many corners, such as the base of a prism: all the sides
// have it as a neighbour, and its plane is formed once.
std::optional<Translation> shift_between_corners(const FastDual& dual,
                                                 const SignedPermutation& symmetry, HalfspaceId i,
                                                 HalfspaceId j) {
  const std::span<const PointId> from = dual.corners(i), to = dual.corners(j);
  const std::size_t k = from.size();
  constexpr std::size_t kMany = 16;
  if (k == 0 || k > kMany || to.size() != k) return {};
  const auto image = [&](std::size_t m) { return symmetry(dual.point(from[m])); };
  const auto corner = [&](std::size_t m) { return dual.point(to[m]); };
  // A translation does not change which corner is the least. Three of the corners, which are not
  // collinear, determine the plane.
  const std::size_t from_least = least_of(k, image), to_least = least_of(k, corner);
  std::optional<Translation> shift;
  for (const std::size_t m : {std::size_t{0}, k / 3, 2 * k / 3}) {
    const Point p = image((from_least + m) % k),
                q = corner((to_least + (symmetry.is_reflection() ? k - m : m)) % k);
    Translation difference;
    for (int axis = 0; axis < 3; ++axis) {
      const DoubleDouble exact = DoubleDouble::difference(q[axis], p[axis]);
      difference[axis] = {exact.hi(), exact.lo()};
    }
    if (shift && *shift != difference) return {};
    shift = difference;
  }
  return shift;
}

// Pairs of planes, one of each cap, whose normals correspond.
using PlanePairs = std::vector<std::pair<const Halfspace*, const Halfspace*>>;

// x -> S x + t carries {n.x + d = 0} to {Sn.x + d - Sn.t = 0}. So t solves Sn.t = d - d' for all
// pairs. The first three planes meet in a vertex, so they determine t, by Cramer's rule as a
// fraction.
bool differ_by_one_translation(const PlanePairs& pairs) {
  std::vector<Integer> shifts;
  for (const auto& [from, to] : pairs) shifts.push_back(from->offset() - to->offset());
  if (std::all_of(shifts.begin(), shifts.end(), [](const Integer& x) { return x == 0; })) {
    return true;  // t = 0
  }
  const auto normal = [&](std::size_t m) -> const IntegerVector3& {
    return pairs[m].second->normal();
  };
  const IntegerVector3 yz = normal(1).cross(normal(2)), zx = normal(2).cross(normal(0)),
                       xy = normal(0).cross(normal(1));
  Integer below = dot(normal(0), yz);
  IntegerVector3 t;
  for (int k = 0; k < 3; ++k) t[k] = yz[k] * shifts[0] + zx[k] * shifts[1] + xy[k] * shifts[2];
  // Mostly a difference of coordinates, so a short fraction.
  const Integer common = gcd(gcd(below, t[0]), gcd(t[1], t[2]));
  below /= common;
  for (int k = 0; k < 3; ++k) t[k] /= common;
  for (std::size_t m = 3; m < pairs.size(); ++m) {
    if (dot(normal(m), t) != below * shifts[m]) return false;
  }
  return true;
}

// Two outlines whose facets may correspond, neighbour m of `a` to neighbour start + m step of `b`.
struct Correspondence {
  const FastDual& dual;
  const FacetOutline &a, &b;
  const SignedPermutation& symmetry;
  std::size_t start, step;

  HalfspaceId neighbour(std::size_t m) const {
    return b.neighbours[(start + m * step) % b.neighbours.size()];
  }
};

// Whether x -> S x + t carries the plane of one halfspace to that of the other, outside to outside:
// {n.x + d = 0} to {Sn.x + d - Sn.t = 0}.
bool carries_plane(const SignedPermutation& symmetry, const Translation& t, const Halfspace& from,
                   const Halfspace& to) {
  if (!symmetry.carries(from.normal(), to.normal())) return false;
  Rational offset = from.offset();
  for (int k = 0; k < 3; ++k) {
    if (t[k].first == 0) continue;
    offset -= to.normal()[k] * Rational(to_rational(t[k].first) + to_rational(t[k].second));
  }
  return offset == to.offset();
}

// By the corners of the facets, which determine t; by planes for a neighbour whose corners do not
// correspond, as those of a long wall and a short one.
bool holds_by_corners(const Correspondence& of) {
  const std::optional<Translation> t =
      shift_between_corners(of.dual, of.symmetry, of.a.facet, of.b.facet);
  if (!t) return false;
  for (std::size_t m = 0; m < of.a.neighbours.size(); ++m) {
    const HalfspaceId i = of.a.neighbours[m], j = of.neighbour(m);
    if (shift_between_corners(of.dual, of.symmetry, i, j) == t) continue;
    if (!carries_plane(of.symmetry, *t, of.dual.exact(i), of.dual.exact(j))) return false;
  }
  return true;
}

bool holds_by_planes(const Correspondence& of) {
  PlanePairs pairs;
  // Planes are formed one after another, as the first pairs refuse most.
  const auto are_carried = [&](HalfspaceId i, HalfspaceId j) {
    pairs.emplace_back(&of.dual.exact(i), &of.dual.exact(j));
    return of.symmetry.carries(pairs.back().first->normal(), pairs.back().second->normal());
  };
  if (!are_carried(of.a.facet, of.b.facet)) return false;
  for (std::size_t m = 0; m < of.a.neighbours.size(); ++m) {
    if (!are_carried(of.a.neighbours[m], of.neighbour(m))) return false;
  }
  return differ_by_one_translation(pairs);
}

std::vector<Direction> outline_directions(const FastDual& dual, const FacetOutline& outline) {
  std::vector<Direction> directions;
  directions.reserve(1 + outline.neighbours.size());
  directions.push_back(dual.direction(outline.facet));
  for (const HalfspaceId i : outline.neighbours) directions.push_back(dual.direction(i));
  return directions;
}

}  // namespace

bool are_congruent(const FastDual& dual, const FacetOutline& a, const FacetOutline& b) {
  const std::size_t k = a.neighbours.size();
  if (b.neighbours.size() != k) return false;
  const std::vector<Direction> from = outline_directions(dual, a), to = outline_directions(dual, b);
  for (const SignedPermutation& symmetry : all_symmetries()) {
    if (!symmetry.may_carry(from[0], to[0])) continue;
    const std::size_t step = symmetry.is_reflection() ? k - 1 : 1;
    for (std::size_t start = 0; start < k; ++start) {
      std::size_t m = 0;
      while (m < k && symmetry.may_carry(from[1 + m], to[1 + (start + m * step) % k])) ++m;
      if (m < k) continue;
      const Correspondence candidate{dual, a, b, symmetry, start, step};
      if (holds_by_corners(candidate) || holds_by_planes(candidate)) return true;
    }
  }
  return false;
}

bool are_mirror_pairs(const FastDual& dual, const std::array<HalfspaceId, 4>& planes) {
  std::array<Direction, 4> direction;
  for (std::size_t m = 0; m < 4; ++m) direction[m] = dual.direction(planes[m]);
  constexpr std::array<std::array<std::size_t, 4>, 3> kPairs{
      {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2}}};
  for (const SignedPermutation& symmetry : all_symmetries()) {
    if (!symmetry.is_inverse_of_itself() || !symmetry.is_reflection()) continue;
    for (const auto& [a, its_image, b, other_image] : kPairs) {
      if (!symmetry.may_carry(direction[a], direction[its_image])) continue;
      if (!symmetry.may_carry(direction[b], direction[other_image])) continue;
      const std::optional<Translation> shift =
          shift_between_corners(dual, symmetry, planes[a], planes[its_image]);
      if (!shift || !symmetry.turns_round(*shift)) continue;
      if (shift_between_corners(dual, symmetry, planes[b], planes[other_image]) == shift) {
        return true;
      }
    }
  }
  return false;
}

std::optional<bool> precedes_image(const FastDual& dual, HalfspaceId i, HalfspaceId j) {
  const Direction a = dual.direction(i), b = dual.direction(j);
  if (is_unknown(a) || is_unknown(b)) return {};
  for (const SignedPermutation& symmetry : all_symmetries()) {
    if (!symmetry.may_carry(a, b) || !shift_between_corners(dual, symmetry, i, j)) continue;
    for (int k = 0; k < 3; ++k) {
      if (std::abs(a[k] - b[k]) > FastDual::kEqualSizes) return a[k] < b[k];
      const bool are_equal = symmetry.axis[k] == k && symmetry.sign[k] == 1;
      if (!are_equal) break;
    }
  }
  return {};
}

}  // namespace convexact
