// SPDX-License-Identifier: MIT
#include "convexact/keep.hpp"

#include <fmt/format.h>
#include <mpfr.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "convexact/error.hpp"
#include "convexact/predicates.hpp"
#include "number/arithmetic.hpp"
#include "number/roundoff.hpp"

namespace convexact {
namespace {

[[noreturn]] void refuse(const std::string& why) { throw Error(ErrorCode::InvalidArgument, why); }

IntegerVector3 direction_of(const RationalVector3& v) {
  if (v == RationalVector3::Zero()) refuse("the vector is zero, and has no direction");
  return clear_denominators(v).x;
}

// The square of a cosine with its sign: ordered as the cosines are.
Rational signed_square(const Rational& cosine_times_lengths, const Rational& squared_lengths) {
  const Rational square = cosine_times_lengths * cosine_times_lengths / squared_lengths;
  return cosine_times_lengths < 0 ? Rational(-square) : square;
}

Rational signed_square_of_cosine(const IntegerVector3& a, const IntegerVector3& b) {
  return signed_square(Rational(dot(a, b)), Rational(dot(a, a) * dot(b, b)));
}

// The largest double that is not above the cosine, so that facets at exactly this angle are
// selected. Only 90 degrees has the cosine 0; for any other double the cosine is more than 2^-60 in
// size, so that 256 bits of pi suffice.
Rational cosine_of(double degrees) {
  mpfr_t x;
  mpfr_init2(x, 256);
  mpfr_const_pi(x, MPFR_RNDN);
  mpfr_mul_d(x, x, degrees, MPFR_RNDN);
  mpfr_div_ui(x, x, 180, MPFR_RNDN);
  mpfr_cos(x, x, MPFR_RNDN);
  const double cosine = mpfr_get_d(x, MPFR_RNDD);
  mpfr_clear(x);
  return to_rational(std::abs(cosine) < 0x1p-100 ? 0.0 : cosine);
}

// A plane in doubles: n and d over a power of two that makes all of them less than 1.
class NearPlane {
 public:
  explicit NearPlane(const Halfspace& h) {
    const auto bits = static_cast<long>(
        std::max(bit_length(h.normal()), bit_length({h.offset(), Integer(0), Integer(0)})));
    const auto near = [bits](const Integer& x) {
      return to_double(scale_by_power_of_two(Rational(x), -bits), Rounding::Nearest);
    };
    n_ = {near(h.normal()[0]), near(h.normal()[1]), near(h.normal()[2])};
    d_ = near(h.offset());
  }

  // With u = 2^-53 and S the sum of the terms' sizes, n and d have the relative error u, products u
  // more, and three sums 3 u S: less than 8 u S together. Numbers that underflow are off by 2^-1074
  // each, n_k times x_k; the bound is larger, as subnormal numbers are slow. If something
  // overflows, the answer is no.
  bool is_surely_off(const Point& p) const {
    constexpr double kFactor = 8 * kUnitRoundoff, kUnderflow = 0x1p-1000;
    const double x = p[0], y = p[1], z = p[2];
    const double a = n_[0] * x, b = n_[1] * y, c = n_[2] * z;
    const double size = std::abs(a) + std::abs(b) + std::abs(c) + std::abs(d_);
    return std::abs(a + b + c + d_) >
           kFactor * size + kUnderflow * (1 + std::abs(x) + std::abs(y) + std::abs(z));
  }

 private:
  std::array<double, 3> n_;
  double d_;
};

class Selection {
 public:
  Selection(std::span<const Halfspace> halfspaces, const PointSet& points)
      : halfspaces_(halfspaces), points_(points) {}

  // The ids that one selector selects.
  std::vector<HalfspaceId> of(const KeepSelector& selector) {
    ids_.clear();
    std::visit([this](const auto& facets) { select(facets); }, selector.facets);
    return ids_;
  }

 private:
  template <class Matches>
  void select_if(Matches&& matches) {
    for (std::size_t i = 0; i < halfspaces_.size(); ++i) {
      if (matches(halfspaces_[i])) ids_.emplace_back(i);
    }
  }

  void select(const KeepIds& wanted) {
    for (const HalfspaceId id : wanted.ids) {
      if (id.index() >= halfspaces_.size()) {
        refuse(fmt::format("there is no facet {}: expected ids below {}", id.index(),
                           halfspaces_.size()));
      }
    }
    ids_ = wanted.ids;
  }

  void select(const KeepPlane& wanted) {
    (void)direction_of(wanted.normal);
    const Halfspace plane(wanted.normal, wanted.offset);
    select_if([&](const Halfspace& h) { return h == plane; });
  }

  void select(const KeepNormal& wanted) {
    const IntegerVector3 u = direction_of(wanted.direction);
    if (!wanted.degrees) return select_nearest(u);
    if (!(*wanted.degrees >= 0 && *wanted.degrees <= 180)) {
      refuse(fmt::format("expected 0 to 180 degrees, found {}", *wanted.degrees));
    }
    const Rational least = signed_square(cosine_of(*wanted.degrees), Rational(1));
    select_if([&](const Halfspace& h) { return signed_square_of_cosine(h.normal(), u) >= least; });
  }

  void select_nearest(const IntegerVector3& u) {
    std::vector<Rational> nearness;
    for (const Halfspace& h : halfspaces_)
      nearness.push_back(signed_square_of_cosine(h.normal(), u));
    const Rational most = *std::max_element(nearness.begin(), nearness.end());
    for (std::size_t i = 0; i < nearness.size(); ++i) {
      if (nearness[i] == most) ids_.emplace_back(i);
    }
  }

  void select(const KeepFaces& wanted) {
    for (const auto& polygon : wanted.polygons) {
      for (const std::uint32_t corner : polygon) {
        if (corner >= points_.size()) refuse(fmt::format("there is no point {}", corner));
      }
    }
    // By first corner, since most first corners are off most planes: each is tested once for each
    // plane.
    std::map<PointId, std::vector<const std::vector<std::uint32_t>*>> by_corner;
    for (const auto& polygon : wanted.polygons) {
      if (!polygon.empty()) by_corner[PointId(polygon[0])].push_back(&polygon);
    }
    const std::vector<std::pair<PointId, std::vector<const std::vector<std::uint32_t>*>>> corners(
        by_corner.begin(), by_corner.end());
    select_if([&](const Halfspace& h) {
      const NearPlane near(h);
      const auto holds = [&](const std::vector<std::uint32_t>* polygon) {
        return std::all_of(polygon->begin(), polygon->end(),
                           [&](std::uint32_t corner) { return is_on(h, near, PointId(corner)); });
      };
      return std::any_of(corners.begin(), corners.end(), [&](const auto& corner) {
        return is_on(h, near, corner.first) &&
               std::any_of(corner.second.begin(), corner.second.end(), holds);
      });
    });
  }

  bool is_on(const Halfspace& h, const NearPlane& near, PointId p) const {
    if (!points_.is_binary()) return h(points_[p]) == 0;
    const Point& x = points_.doubles()[p.index()];
    return !near.is_surely_off(x) && side_of(h, x) == Sign::Zero;
  }

  std::span<const Halfspace> halfspaces_;
  const PointSet& points_;
  std::vector<HalfspaceId> ids_;
};

}  // namespace

std::vector<HalfspaceId> select_facets(std::span<const Halfspace> halfspaces,
                                       const PointSet& points,
                                       std::span<const KeepSelector> selectors,
                                       std::optional<std::size_t> most) {
  std::vector<HalfspaceId> all;
  for (const KeepSelector& selector : selectors) {
    std::vector<HalfspaceId> ids;
    try {
      ids = Selection(halfspaces, points).of(selector);
      if (ids.empty()) refuse("it matches no facet of the input's hull");
    } catch (const Error& error) {
      refuse(selector.text + ": " + error.what());
    }
    all.insert(all.end(), ids.begin(), ids.end());
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  if (most && all.size() > *most) {
    refuse(fmt::format(
        "{} facets are to be kept, more than the {} halfspaces of the result: ask for more of "
        "these, or keep fewer",
        all.size(), *most));
  }
  return all;
}

}  // namespace convexact
