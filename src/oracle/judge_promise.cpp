// SPDX-License-Identifier: MIT
// The judgements of an output that verify() does not make: how far rounding explains a violation,
// and the promises of a hull or an inner solid.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "convexact/measure.hpp"
#include "convexact/number.hpp"
#include "convexact/verify.hpp"
#include "oracle/conformance_judge.hpp"
#include "oracle/excess.hpp"
#include "oracle/mesh_surface.hpp"

namespace convexact::oracle {
namespace {

using Magnitudes = std::array<Rational, 3>;

Rational permanent(const Magnitudes& a, const Magnitudes& b, const Magnitudes& c) {
  return a[0] * (b[1] * c[2] + b[2] * c[1]) + a[1] * (b[0] * c[2] + b[2] * c[0]) +
         a[2] * (b[0] * c[1] + b[1] * c[0]);
}

Magnitudes magnitudes(const RationalVector3& v, const Rational& slack) {
  Magnitudes sizes;
  for (int k = 0; k < 3; ++k) sizes[k] = abs(v[k]) + slack;
  return sizes;
}

// How far rounding may have moved each coordinate of a mesh.
Rational slack_of(const Mesh& mesh, const Promise& promise) {
  const Precision precision =
      promise.numbers == Precision::Binary32 ? promise.numbers : precision_of(mesh.points);
  return kRoundingUlps *
         unit_in_last_place(precision, bounding_box(mesh.points).largest_coordinate());
}

// The points of the input near the corners of a hull.
class NearInput {
 public:
  explicit NearInput(const Case& c) : c_(c) {
    reach_ = to_double(c.promise.tolerance.value, Rounding::Up);
    if (c.promise.tolerance.relative) {
      reach_ *= std::sqrt(to_double(c.verdict.squared_diameter, Rounding::Up));
    }
    reach_ *= 1 + 0x1p-40;
  }

  /// Whether a point is within the tolerance, exactly: doubles only rule out those that are not.
  bool holds(const RationalPoint& corner) const {
    const Point about = rounded(corner);
    for (std::uint32_t i = 0; i < points().size(); ++i) {
      const Point p = points().doubles()[i];
      const Point off = (p - about).cwiseAbs(), size = p.cwiseAbs() + about.cwiseAbs();
      const auto is_far = [&](int k) { return off[k] > reach_ + 0x1p-50 * size[k] + 0x1p-1060; };
      if (is_far(0) || is_far(1) || is_far(2)) continue;
      if (c_.tolerates(squared_distance(i, corner))) return true;
    }
    return false;
  }
  /// The squared distance to the point that is nearest in doubles.
  Rational nearest(const RationalPoint& corner) const {
    const Point about = rounded(corner);
    std::uint32_t best = 0;
    for (std::uint32_t i = 1; i < points().size(); ++i) {
      const auto distance = [&](std::uint32_t k) { return (points().doubles()[k] - about).norm(); };
      if (distance(i) < distance(best)) best = i;
    }
    return squared_distance(best, corner);
  }

 private:
  static Point rounded(const RationalPoint& p) {
    return Point(to_double(p[0], Rounding::Nearest), to_double(p[1], Rounding::Nearest),
                 to_double(p[2], Rounding::Nearest));
  }
  const PointSet& points() const { return c_.given.points; }
  Rational squared_distance(std::uint32_t i, const RationalPoint& corner) const {
    return (points()[PointId(i)] - corner).squaredNorm();
  }

  const Case& c_;
  double reach_;
};

}  // namespace

bool is_explained(std::span<const RationalPoint> corners, const Rational& slack,
                  const RationalPoint& point, const Rational& point_slack) {
  const RationalVector3 p = point - corners[0];
  const Rational corner_moves = 2 * slack, point_moves = slack + point_slack;
  Rational volume = 0, explained = 0;
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
    const RationalVector3 u = corners[k] - corners[0], v = corners[k + 1] - corners[0];
    volume += u.cross(v).dot(p);
    explained += permanent(magnitudes(u, corner_moves), magnitudes(v, corner_moves),
                           magnitudes(p, point_moves)) -
                 permanent(magnitudes(u, 0), magnitudes(v, 0), magnitudes(p, 0));
  }
  return abs(volume) <= explained;
}

bool leak_is_rounding(const Case& c) {
  if (const auto* list = std::get_if<HalfspaceList>(&c.output)) {
    const Rational unit =
        scale_by_power_of_two(kRoundingUlps, 1 - significand_bits(c.promise.numbers));
    for (const Halfspace& plane : list->halfspaces) {
      const auto worst = find_excess(std::span(&plane, 1), c.given.points);
      if (!worst) continue;
      const RationalPoint p = c.given.points[worst->point];
      Rational explained = abs(Rational(plane.offset()));
      for (int k = 0; k < 3; ++k) explained += abs(Rational(plane.normal()[k]) * p[k]);
      if (plane(p) > unit * explained) return false;
    }
    return true;
  }
  const Rational slack = slack_of(std::get<Mesh>(c.output), c.promise);
  for (std::size_t f = 0; f < c.solid->planes.size(); ++f) {
    const auto worst = find_excess(std::span(&c.solid->planes[f], 1), c.given.points);
    if (!worst) continue;
    std::vector<RationalPoint> corners;
    for (const std::uint32_t corner : c.solid->facets[f]) {
      corners.push_back(c.solid->vertices[corner]);
    }
    if (!is_explained(corners, slack, c.given.points[worst->point], 0)) return false;
  }
  return true;
}

bool faces_are_rounded(const Case& c) {
  const auto& mesh = std::get<Mesh>(c.output);
  const Rational slack = slack_of(mesh, c.promise);
  const PointSet corners(c.solid->vertices);
  for (const auto& polygon : mesh.polygons) {
    std::vector<RationalPoint> face;
    for (const std::uint32_t corner : polygon) face.push_back(mesh.points[PointId(corner)]);
    const RationalVector3 area = area_vector(mesh.points, polygon);
    if (area.isZero(0)) continue;  // since any sliver can be such a face after rounding
    const Halfspace plane(area, Rational(-area.dot(face[0])));
    if (const auto worst = find_excess(std::span(&plane, 1), corners);
        worst && !is_explained(face, slack, corners[worst->point], slack)) {
      return false;
    }
    for (const RationalPoint& corner : face) {
      if (!is_explained(face, slack, corner, slack)) return false;
    }
  }
  // Closed and oriented faces near the hull's surface enclose it a whole number of times.
  const Rational twice = MeshSurface(mesh).enclosed() / 3;
  return abs(Rational(twice - 2 * volume(*c.solid))) < volume(*c.solid);
}

// The hull of points has no other corners than these points. A convex solid that contains them, and
// has corners among them only, is their hull; with a tolerance it may lack some.
void judge_corners(Case& c) {
  const NearInput input(c);
  std::size_t strange = 0;
  Rational worst = 0;
  for (const RationalPoint& corner : c.solid->vertices) {
    if (input.holds(corner)) continue;
    ++strange;
    worst = std::max(worst, input.nearest(corner));
  }
  if (strange == 0) return;
  c.fail(Outcome::NotTheHull,
         fmt::format("{} of {} corners are no points of the input; the worst is {} of the diameter "
                     "from all of them",
                     strange, c.solid->vertices.size(), decimal_of_root(c.relative(worst))),
         c.relative(worst));
}

void judge_inside(Case& c) {
  const Rational squared = hausdorff_distance(*c.solid, c.given.hull).squared;
  if (c.tolerates(squared)) return;
  c.fail(Outcome::NotInside,
         fmt::format("it is outside of the input's hull by {} of the diameter",
                     decimal_of_root(c.relative(squared))),
         c.relative(squared));
}

}  // namespace convexact::oracle
