// SPDX-License-Identifier: MIT
#include "simplify/whole_dual.hpp"

#include <algorithm>

#include "number/arithmetic.hpp"

namespace convexact {
namespace {

std::array<ModularVolume, 2> two_primes(std::span<const Halfspace> halfspaces, std::uint64_t seed) {
  Random random(seed);
  ModularVolume first(halfspaces, random), second(halfspaces, random);
  return {std::move(first), std::move(second)};
}

Integer determinant_of(const IntegerVector3& a, const IntegerVector3& b, const IntegerVector3& c) {
  return a.dot(b.cross(c));
}

}  // namespace

WholeDual::WholeDual(std::span<const Halfspace> halfspaces, std::span<const PlainVertex> vertices,
                     const PlainSurface& surface, std::uint64_t seed)
    : halfspaces_(halfspaces),
      vertices_(vertices),
      modular_(two_primes(halfspaces, seed)),
      residues_{modular_[0].six_volume(surface), modular_[1].six_volume(surface)},
      first_six_volume_(six_volume(surface)) {}

PlainVertex WholeDual::vertex_of(const DualTriangle& t) const {
  return plain_vertex(halfspaces_[t[0].index()], halfspaces_[t[1].index()],
                      halfspaces_[t[2].index()]);
}

bool WholeDual::is_certified(const PlainSurface& surface, const std::vector<bool>& present) const {
  return has_all(surface, present) && is_locally_convex(surface) && is_met_once_by_a_ray(surface);
}

// The surface has the survivors and no other halfspace.
bool WholeDual::has_all(const PlainSurface& surface, const std::vector<bool>& present) const {
  for (std::size_t i = 0; i < present.size(); ++i) {
    if (present[i] == surface.ring(HalfspaceId(i)).empty()) return false;
  }
  return true;
}

// Each edge has a triangle on both sides, so the surface is closed.
bool WholeDual::is_locally_convex(const PlainSurface& surface) const {
  for (const DualTriangle& t : surface.triangles()) {
    const PlainVertex vertex = vertex_of(t);
    if (vertex.d <= 0) return false;  // the origin must lie strictly below
    for (int e = 0; e < 3; ++e) {
      const auto apex = surface.third(t[(e + 1) % 3], t[e]);
      if (!apex || value_at(vertex, halfspaces_[apex->index()]) > 0) return false;
    }
  }
  return true;
}

// Local convexity alone also holds for a surface that winds around twice. The ray through the
// inside of one triangle must miss (the closed cones of) all others. The surface is closed and
// turns one way everywhere, so every direction is then covered once: it is a sphere, with one fan
// around each vertex.
bool WholeDual::is_met_once_by_a_ray(const PlainSurface& surface) const {
  const std::vector<DualTriangle> triangles = surface.triangles();
  const auto normal = [&](HalfspaceId i) -> const IntegerVector3& {
    return halfspaces_[i.index()].normal();
  };
  const auto& [a, b, c] = triangles.front();
  const IntegerVector3 ray = normal(a) + normal(b) + normal(c);
  return 1 == std::count_if(triangles.begin(), triangles.end(), [&](const DualTriangle& t) {
           for (int e = 0; e < 3; ++e) {
             if (determinant_of(normal(t[e]), normal(t[(e + 1) % 3]), ray) < 0) return false;
           }
           return true;
         });
}

bool WholeDual::holds_vertices(const std::vector<bool>& present) const {
  for (std::size_t i = 0; i < present.size(); ++i) {
    if (!present[i]) continue;
    for (const PlainVertex& v : vertices_) {
      if (value_at(v, halfspaces_[i]) > 0) return false;
    }
  }
  return true;
}

bool WholeDual::volume_grew_by(const Rational& cost, const PlainSurface& surface) {
  costs_.push_back(cost);
  std::array<std::uint64_t, 2> expected;
  for (int p = 0; p < 2; ++p) {
    const std::uint64_t six_cost = modular_[p].product(6, modular_[p].residue(cost));
    expected[p] = modular_[p].sum(residues_[p], six_cost);
    residues_[p] = modular_[p].six_volume(surface);
  }
  return residues_ == expected;
}

bool WholeDual::volume_is_sum_of_costs(const PlainSurface& surface) const {
  return six_volume(surface) == first_six_volume_ + 6 * balanced_sum(costs_);
}

Rational WholeDual::six_volume(const PlainSurface& surface) const {
  std::vector<Rational> terms;
  for (std::size_t i = 0; i < surface.size(); ++i) {
    const std::vector<HalfspaceId> ring = surface.ring(HalfspaceId(i));
    std::vector<PlainVertex> corners;
    for (std::size_t t = 0; t < ring.size(); ++t) {
      corners.push_back(vertex_of({HalfspaceId(i), ring[t], ring[(t + 1) % ring.size()]}));
    }
    for (std::size_t t = 2; t < corners.size(); ++t) {
      const PlainVertex &u = corners[0], &v = corners[t - 1], &w = corners[t];
      terms.emplace_back(determinant_of(u.x, v.x, w.x), Integer(u.d * v.d * w.d));
    }
  }
  return balanced_sum(std::move(terms));
}

}  // namespace convexact
