// SPDX-License-Identifier: MIT
// The judgement of an output that verify() does not make: how far rounding explains a violation.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "conform/conformance_judge.hpp"
#include "convexact/error.hpp"
#include "convexact/measure.hpp"
#include "convexact/number.hpp"
#include "convexact/verify.hpp"
#include "geometry/area_vector.hpp"
#include "oracle/solid/excess.hpp"
#include "oracle/solid/mesh_surface.hpp"

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

bool is_moved_corner(const Case& c, const Rational& squared_distance) {
  const auto* mesh = std::get_if<Mesh>(&c.output);
  if (mesh == nullptr) return false;
  const Rational slack = slack_of(*mesh, c.promise);
  return squared_distance <= 3 * slack * slack;
}

bool leak_is_rounding(const Case& c) {
  if (const auto* list = std::get_if<HalfspaceList>(&c.output)) {
    const Rational unit =
        scale_by_power_of_two(kRoundingUlps, 1 - significand_bits(c.promise.numbers));
    for (const Halfspace& plane : list->halfspaces) {
      Watch(c.watch.stop).ask();
      const auto worst = find_excess(std::span(&plane, 1), c.given.points);
      if (!worst) continue;
      const RationalPoint p = c.given.points[worst->point];
      Rational explained = abs(Rational(plane.offset()));
      for (int k = 0; k < 3; ++k) explained += abs(Rational(plane.normal()[k]) * p[k]);
      if (plane(p) > unit * explained) return false;
    }
    return true;
  }
  return is_moved_corner(c, c.verdict[ClaimCode::ContainsInput].witness.squared_distance.value());
}

bool faces_are_rounded(const Case& c) {
  const auto& mesh = std::get<Mesh>(c.output);
  const Rational slack = slack_of(mesh, c.promise);
  const PointSet corners(c.solid->vertices);
  for (const auto& polygon : mesh.polygons) {
    Watch(c.watch.stop).ask();
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

}  // namespace convexact::oracle
