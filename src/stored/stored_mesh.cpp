// SPDX-License-Identifier: MIT
#include <cmath>
#include <optional>

#include "convexact/geometry.hpp"
#include "convexact/hull.hpp"
#include "convexact/stored.hpp"
#include "stored/acceptance.hpp"

namespace convexact {
namespace {

std::vector<Point> round_vertices(std::span<const RationalPoint> vertices, Precision precision) {
  std::vector<Point> rounded;
  rounded.reserve(vertices.size());
  for (const RationalPoint& v : vertices) {
    Point p;
    for (int k = 0; k < 3; ++k) p[k] = round_to(precision, v[k], Rounding::Nearest);
    if (!p.allFinite()) stored::refuse(precision, "a vertex is beyond its largest number");
    rounded.push_back(p);
  }
  return rounded;
}

// center + (1 + factor)(v - center), exactly.
std::vector<RationalPoint> scaled_vertices(const Polytope& exact, const RationalPoint& center,
                                           double factor) {
  const Rational scale = 1 + to_rational(factor);
  std::vector<RationalPoint> scaled;
  scaled.reserve(exact.vertices.size());
  for (const RationalPoint& v : exact.vertices) scaled.push_back(center + (v - center) * scale);
  return scaled;
}

// A rung that holds the witnesses.
struct Rung {
  PointSet points;
  Hull hull;
  std::vector<Halfspace> halfspaces;
};

std::optional<Rung> try_rung(std::vector<Point> vertices, const PointSet& witnesses) {
  PointSet points(std::move(vertices));
  HullOutcome outcome = convex_hull(points);
  if (!std::holds_alternative<Hull>(outcome)) return {};  // flat
  Hull& hull = std::get<Hull>(outcome);
  std::vector<Halfspace> halfspaces = facet_halfspaces(hull, points);
  if (count_outside(halfspaces, witnesses) > 0) return {};
  return Rung{std::move(points), std::move(hull), std::move(halfspaces)};
}

Rung climb(const Polytope& exact, const PointSet& input, std::span<const PointId> ids,
           Precision precision) {
  const PointSet witnesses = subset(input, ids);
  if (auto rung = try_rung(round_vertices(exact.vertices, precision), witnesses)) {
    return std::move(*rung);
  }
  const RationalPoint center = stored::interior_point(input, ids, exact.planes);
  const double unit = std::ldexp(1.0, 1 - significand_bits(precision));
  for (double factor = unit; factor <= 1; factor *= 2) {
    auto rung =
        try_rung(round_vertices(scaled_vertices(exact, center, factor), precision), witnesses);
    if (rung) return std::move(*rung);
  }
  stored::refuse(precision, "no scaling of the vertices up to twofold holds the input");
}

// Whether rounding has changed no vertex: then the rung is the hull of the exact ones.
bool is_unchanged(const Rung& rung, const Polytope& exact) {
  for (std::size_t i = 0; i < exact.vertices.size(); ++i) {
    if (to_rational(rung.points.doubles()[i]) != exact.vertices[i]) return false;
  }
  return true;
}

// Only the extreme points, numbered in their order.
Mesh to_mesh(const Rung& rung) {
  Mesh mesh;
  mesh.points = subset(rung.points, rung.hull.vertices);
  std::vector<std::uint32_t> number(rung.points.size());
  for (std::size_t i = 0; i < rung.hull.vertices.size(); ++i) {
    number[rung.hull.vertices[i].index()] = static_cast<std::uint32_t>(i);
  }
  for (std::size_t f = 0; f < rung.hull.facets.size(); ++f) {
    std::vector<std::uint32_t> polygon;
    for (const PointId corner : rung.hull.facets[f]) polygon.push_back(number[corner.index()]);
    mesh.polygons.push_back(std::move(polygon));
  }
  mesh.parts.push_back({"", 0, mesh.polygons.size()});
  return mesh;
}

}  // namespace

StoredMesh store_mesh(const Polytope& exact, const PointSet& input,
                      std::span<const PointId> witnesses, Precision precision) {
  StoredMesh stored;
  stored.precision = precision;
  const Rung rung = climb(exact, input, witnesses, precision);
  stored.mesh = to_mesh(rung);
  // A rung was tested against all witnesses, which may be all points.
  const bool is_tested = witnesses.size() == input.size();
  stored.violations = is_tested ? 0 : stored::final_pass(rung.halfspaces, input);
  if (!is_unchanged(rung, exact)) {
    const Polytope polytope = to_polytope(rung.hull, rung.points);
    stored.growth = stored::checked_growth(exact, polytope, input, witnesses, precision);
  }
  return stored;
}

std::size_t count_outside_hull(const PointSet& mesh_points, const PointSet& input) {
  const HullOutcome outcome = convex_hull(mesh_points);
  const auto* hull = std::get_if<Hull>(&outcome);
  if (hull == nullptr) return input.size();
  return count_outside(facet_halfspaces(*hull, mesh_points), input);
}

}  // namespace convexact
