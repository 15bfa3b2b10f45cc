// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <mpfr.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "convexact/error.hpp"
#include "convexact/geometry.hpp"
#include "convexact/run.hpp"
#include "near/near_plane.hpp"
#include "number/arithmetic.hpp"

namespace convexact {
namespace {

IntegerVector3 direction_of(const RationalVector3& v) {
  if (v == RationalVector3::Zero()) reject_argument("the vector is zero, and has no direction");
  return clear_denominators(v).n;
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
        reject_argument(fmt::format("there is no facet {}: expected ids below {}", id.index(),
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
      reject_argument(fmt::format("expected 0 to 180 degrees, found {}", *wanted.degrees));
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
    double largest = 1;
    for (const auto& polygon : wanted.polygons) {
      for (const std::uint32_t corner : polygon) {
        if (corner >= points_.size()) reject_argument(fmt::format("there is no point {}", corner));
        largest = std::max(largest, points_.doubles()[corner].cwiseAbs().maxCoeff());
      }
    }
    const double error = absolute_plane_error(largest);
    // By first corner, most of which are off most planes: each is asked once for each plane.
    std::map<PointId, std::vector<const std::vector<std::uint32_t>*>> by_corner;
    for (const auto& polygon : wanted.polygons) {
      if (!polygon.empty()) by_corner[PointId(polygon[0])].push_back(&polygon);
    }
    const std::vector<std::pair<PointId, std::vector<const std::vector<std::uint32_t>*>>> corners(
        by_corner.begin(), by_corner.end());
    select_if([&](const Halfspace& h) {
      const DoubleHalfspace near(h);
      const auto is_on = [&](PointId p) {
        if (!points_.is_binary()) return h(points_[p]) == 0;
        const Point& x = points_.doubles()[p.index()];
        return !near.at(x[0], x[1], x[2], error).surely_not_zero() && side_of(h, x) == Sign::Zero;
      };
      const auto holds = [&](const std::vector<std::uint32_t>* polygon) {
        return std::all_of(polygon->begin(), polygon->end(),
                           [&](std::uint32_t corner) { return is_on(PointId(corner)); });
      };
      return std::any_of(corners.begin(), corners.end(), [&](const auto& corner) {
        return is_on(corner.first) &&
               std::any_of(corner.second.begin(), corner.second.end(), holds);
      });
    });
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
      if (ids.empty()) reject_argument("it matches no facet of the input's hull");
    } catch (const Error& error) {
      reject_argument(selector.text + ": " + error.what());
    }
    all.insert(all.end(), ids.begin(), ids.end());
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  if (most && all.size() > *most) {
    reject_argument(fmt::format(
        "{} facets are to be kept, more than the {} halfspaces of the result: ask for more of "
        "these, or keep fewer",
        all.size(), *most));
  }
  return all;
}

}  // namespace convexact
