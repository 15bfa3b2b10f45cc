// SPDX-License-Identifier: MIT
#include "simplify/cap.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "convexact/error.hpp"
#include "number/arithmetic.hpp"

namespace convexact {
namespace {

// A directed edge of the roof with the triangle on its left.
struct RoofEdge {
  HalfspaceId from, to, third;
  std::uint32_t triangle;
};

bool starts_before(const RoofEdge& edge, const std::array<HalfspaceId, 2>& ends) {
  return edge.from != ends[0] ? edge.from < ends[0] : edge.to < ends[1];
}

std::vector<RoofEdge> sorted_edges(std::span<const DualTriangle> triangles) {
  std::vector<RoofEdge> edges;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (int e = 0; e < 3; ++e) {
      edges.push_back({triangles[t][e], triangles[t][(e + 1) % 3], triangles[t][(e + 2) % 3], t});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const RoofEdge& a, const RoofEdge& b) {
    return starts_before(a, {b.from, b.to});
  });
  return edges;
}

// A vertex relative to the apex: x / (d_apex d). The result is divided by the common d_apex in the
// end.
struct Arm {
  IntegerVector3 x;
  Integer d;
};

Arm arm_from(const DualPlane& apex, const DualPlane& vertex) {
  return {vertex.x * apex.d - apex.x * vertex.d, vertex.d};
}

// n / d, not in lowest terms.
struct Fraction {
  Integer n, d;
};

// The sum of fractions, halves first. One long greatest common divisor at the end costs less than
// many short ones on the way.
Rational sum_of(std::span<const Fraction> terms, const Integer& common_denominator) {
  const auto add = [](const auto& self, std::span<const Fraction> part) -> Fraction {
    if (part.size() == 1) return part.front();
    const Fraction a = self(self, part.first(part.size() / 2));
    const Fraction b = self(self, part.subspan(part.size() / 2));
    Fraction sum{a.n * b.d, a.d * b.d};
    add_product(sum.n, b.n, a.d);
    return sum;
  };
  if (terms.empty()) return 0;
  const Fraction sum = add(add, terms);
  return Rational(sum.n, Integer(sum.d * common_denominator));
}

}  // namespace

Cap make_cap(std::span<const HalfspaceId> ring, std::span<const DualPlane> base,
             const RingTriangulation& roof) {
  const std::size_t k = ring.size();
  Cap cap;
  cap.vertices.assign(base.begin(), base.end());
  cap.vertices.insert(cap.vertices.end(), roof.planes.begin(), roof.planes.end());
  const std::vector<RoofEdge> edges = sorted_edges(roof.triangles);
  for (std::size_t t = 0; t < k; ++t) {
    // The roof triangles at ring[t], counter-clockwise: from the edge to its successor in the ring
    // to the edge from its predecessor.
    const std::size_t previous = (t + k - 1) % k;
    std::vector<std::uint32_t> side;
    for (HalfspaceId next = ring[(t + 1) % k]; next != ring[previous];) {
      const auto edge =
          std::lower_bound(edges.begin(), edges.end(), std::array{ring[t], next}, starts_before);
      CONVEXACT_ASSERT(edge != edges.end() && edge->from == ring[t] && edge->to == next);
      side.push_back(static_cast<std::uint32_t>(k + edge->triangle));
      next = edge->third;
    }
    side.push_back(static_cast<std::uint32_t>(previous));
    side.push_back(static_cast<std::uint32_t>(t));
    cap.sides.push_back(std::move(side));
  }
  return cap;
}

Cap make_cap(std::span<const DualPoint> points, HalfspaceId i, std::span<const HalfspaceId> ring,
             const RingTriangulation& roof) {
  std::vector<DualPlane> base;
  for (std::size_t t = 0; t < ring.size(); ++t) {
    const HalfspaceId a = ring[t], b = ring[(t + 1) % ring.size()];
    base.push_back(plane_through(points[i.index()], points[a.index()], points[b.index()]));
  }
  return make_cap(ring, base, roof);
}

std::vector<CapTetrahedron> tetrahedra(const Cap& cap) {
  std::vector<Arm> arms;
  for (const DualPlane& vertex : cap.vertices) {
    arms.push_back(arm_from(cap.vertices[0], vertex));
  }
  // Sides 0 and 1 and the base contain the apex; the others are the bases of pyramids over it.
  std::vector<CapTetrahedron> list;
  for (std::size_t t = 2; t < cap.sides.size(); ++t) {
    const std::vector<std::uint32_t>& side = cap.sides[t];
    const Arm& first = arms[side.back()];
    for (std::size_t c = 1; c + 1 < side.size(); ++c) {
      const Arm &u = arms[side[c - 1]], &v = arms[side[c]];
      Integer determinant = first.x.dot(u.x.cross(v.x));
      CONVEXACT_ASSERT(determinant >= 0);
      if (determinant != 0) {
        list.push_back({{side.back(), side[c - 1], side[c]},
                        std::move(determinant),
                        Integer(first.d * u.d * v.d)});
      }
    }
  }
  return list;
}

Rational volume(const Cap& cap) {
  std::vector<Fraction> six_volumes;
  for (CapTetrahedron& t : tetrahedra(cap)) {
    six_volumes.push_back({std::move(t.n), std::move(t.d)});
  }
  const Integer& d = cap.vertices[0].d;
  return sum_of(six_volumes, 6 * d * d * d);
}

namespace {

// An axis along which a vector that is not 0 extends. For parallel vectors one coordinate suffices.
int axis_of(const IntegerVector3& v) { return v[0] != 0 ? 0 : v[1] != 0 ? 1 : 2; }

// The area of a polygon in a plane with that normal, as a multiple of the root of n.n: by triangles
// from its first corner, all with the same orientation.
RootTerm area_of(std::span<const DualPlane> vertices, std::span<const std::uint32_t> corners,
                 const IntegerVector3& normal) {
  const DualPlane& apex = vertices[corners[0]];
  const int k = axis_of(normal), p = (k + 1) % 3, q = (k + 2) % 3;
  std::vector<Fraction> along;  // twice each triangle's area vector, its coordinate k
  for (std::size_t c = 1; c + 1 < corners.size(); ++c) {
    const Arm u = arm_from(apex, vertices[corners[c]]),
              v = arm_from(apex, vertices[corners[c + 1]]);
    const Integer area = u.x[p] * v.x[q] - u.x[q] * v.x[p];
    along.push_back({abs(area), Integer(u.d * v.d)});
  }
  return {sum_of(along, Integer(2 * apex.d * apex.d * abs(normal[k]))), dot(normal, normal)};
}

// The edge is parallel to m x n, so its length is a multiple of that vector's. Reducing a fraction
// to lowest terms before squaring it takes a fourth of the time.
AngleTerm edge_of(const DualPlane& from, const DualPlane& to, const IntegerVector3& m,
                  const IntegerVector3& n, int factor) {
  const IntegerVector3 cross = m.cross(n);
  const int k = axis_of(cross);
  const Rational multiple(Integer(to.x[k] * from.d - from.x[k] * to.d),
                          Integer(cross[k] * from.d * to.d));
  const Integer squared = dot(cross, cross);
  return {factor, Rational(multiple * multiple * squared), squared, dot(m, n)};
}

// Normals of a cap's planes: primitive directions.
struct CapNormals {
  const IntegerVector3& base;
  std::vector<const IntegerVector3*> sides;
};

RootSum area(const Cap& cap, const CapNormals& normals) {
  std::vector<RootTerm> terms;
  std::vector<std::uint32_t> base;
  for (std::uint32_t t = 0; t < cap.sides.size(); ++t) {
    terms.push_back(area_of(cap.vertices, cap.sides[t], *normals.sides[t]));
    base.push_back(t);
  }
  terms.push_back(area_of(cap.vertices, base, normals.base));
  terms.back().factor = -terms.back().factor;
  return RootSum(std::move(terms));
}

// Each directed edge of a side is met in the opposite direction on another side, or is on the base.
AngleSum edges_times_angles(const Cap& cap, const CapNormals& normals) {
  std::map<std::array<std::uint32_t, 2>, std::size_t> side_of;
  for (std::size_t t = 0; t < cap.sides.size(); ++t) {
    const std::vector<std::uint32_t>& side = cap.sides[t];
    for (std::size_t c = 0; c < side.size(); ++c) {
      side_of[{side[c], side[(c + 1) % side.size()]}] = t;
    }
  }
  std::vector<AngleTerm> terms;
  for (const auto& [ends, t] : side_of) {
    const DualPlane &from = cap.vertices[ends[0]], &to = cap.vertices[ends[1]];
    const auto across = side_of.find({ends[1], ends[0]});
    if (across == side_of.end()) {
      terms.push_back(edge_of(from, to, *normals.sides[t], normals.base, -1));
    } else if (ends[0] < ends[1]) {
      terms.push_back(edge_of(from, to, *normals.sides[t], *normals.sides[across->second], 1));
    }
  }
  return AngleSum(std::move(terms));
}

}  // namespace

Cost cost_of(const Cap& cap, std::span<const IntegerVector3> directions, HalfspaceId i,
             std::span<const HalfspaceId> ring, CostMeasure measure) {
  if (measure == CostMeasure::Volume) return volume(cap);
  CapNormals normals{directions[i.index()], {}};
  for (const HalfspaceId r : ring) normals.sides.push_back(&directions[r.index()]);
  return measure == CostMeasure::Area ? Cost(area(cap, normals))
                                      : Cost(edges_times_angles(cap, normals));
}

std::vector<IntegerVector3> primitive_directions(std::span<const DualPoint> points) {
  std::vector<IntegerVector3> directions;
  directions.reserve(points.size());
  for (const DualPoint& p : points) directions.push_back(primitive_direction(p.n));
  return directions;
}

}  // namespace convexact
