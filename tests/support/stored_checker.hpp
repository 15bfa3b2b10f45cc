// SPDX-License-Identifier: MIT
// stored_checker.hpp - whether a stored solid holds the input, from the definition: GMP integers,
// no filter, no hull, nothing of the library.
#pragma once
#include <gmpxx.h>

#include <array>
#include <set>
#include <utility>
#include <vector>

#include "stored_file.hpp"

namespace stored_checker {

/// (x, y, z, w) in integers, w > 0, for the point (x/w, y/w, z/w).
using Homogeneous = std::array<mpz_class, 4>;
/// (n, d) in integers: n.x + d <= 0.
using Plane = std::array<mpz_class, 4>;
using Vector = std::array<mpz_class, 3>;

/// `numbers` times their common denominator, and that denominator.
inline std::pair<std::vector<mpz_class>, mpz_class> clear(const std::vector<mpq_class>& numbers) {
  mpz_class common = 1;
  for (const mpq_class& q : numbers) common = lcm(common, q.get_den());
  std::vector<mpz_class> cleared;
  for (const mpq_class& q : numbers) cleared.push_back(q.get_num() * (common / q.get_den()));
  return {cleared, common};
}

inline Homogeneous point(const mpq_class& x, const mpq_class& y, const mpq_class& z) {
  const auto [n, w] = clear({x, y, z});
  return {n[0], n[1], n[2], w};
}
inline Homogeneous point(double x, double y, double z) {
  return point(mpq_class(x), mpq_class(y), mpq_class(z));
}
inline Plane plane(const std::array<double, 4>& p) {
  const auto [n, w] = clear({mpq_class(p[0]), mpq_class(p[1]), mpq_class(p[2]), mpq_class(p[3])});
  return {n[0], n[1], n[2], n[3]};
}

/// The sign of n.x + d at a point.
inline int side(const Plane& p, const Homogeneous& x) {
  return sgn(mpz_class(p[0] * x[0] + p[1] * x[1] + p[2] * x[2] + p[3] * x[3]));
}

inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline bool is_zero(const Vector& v) { return v[0] == 0 && v[1] == 0 && v[2] == 0; }

/// (b - a) times w_a w_b.
inline Vector difference(const Homogeneous& b, const Homogeneous& a) {
  return {b[0] * a[3] - a[0] * b[3], b[1] * a[3] - a[1] * b[3], b[2] * a[3] - a[2] * b[3]};
}

/// The plane through a, b, c with n = (b - a) x (c - a), up to a positive factor; n may be zero.
inline Plane plane_through(const Homogeneous& a, const Homogeneous& b, const Homogeneous& c) {
  const Vector n = cross(difference(b, a), difference(c, a));
  return {n[0] * a[3], n[1] * a[3], n[2] * a[3], -(n[0] * a[0] + n[1] * a[1] + n[2] * a[2])};
}

/// How many of the points are strictly outside some plane.
inline std::size_t count_outside(const std::vector<Plane>& planes,
                                 const std::vector<Homogeneous>& points) {
  std::size_t outside = 0;
  for (const Homogeneous& x : points) {
    for (const Plane& p : planes) {
      if (side(p, x) > 0) {
        ++outside;
        break;
      }
    }
  }
  return outside;
}

/// No ray u != 0 with n.u <= 0 for all planes. If the normals have rank 3, then the cone of such
/// rays is pointed, and if it is not zero it has an extreme ray, where two of the planes meet.
inline bool is_bounded(const std::vector<Plane>& planes) {
  bool rank_3 = false;
  for (const Plane& p : planes) {
    for (const Plane& q : planes) {
      const Vector u = cross({p[0], p[1], p[2]}, {q[0], q[1], q[2]});  // -u comes with (q, p)
      if (is_zero(u)) continue;
      bool escapes = true;
      for (const Plane& r : planes) {
        const int sign = sgn(mpz_class(r[0] * u[0] + r[1] * u[1] + r[2] * u[2]));
        rank_3 = rank_3 || sign != 0;
        escapes = escapes && sign <= 0;
      }
      if (escapes) return false;
    }
  }
  return rank_3;
}

/// The planes of a mesh's polygons, if these are shown to be the facets of the hull of its
/// vertices: every polygon lies in a plane that has no vertex beyond it, and the surface is closed
/// (each directed edge once, its reverse once), so it covers the boundary of the hull.
/// Empty if any of that fails.
inline std::vector<Plane> hull_planes(const stored_file::Solid& solid) {
  std::vector<Homogeneous> vertices;
  for (const auto& p : solid.vertices) vertices.push_back(point(p[0], p[1], p[2]));
  std::set<std::pair<std::size_t, std::size_t>> edges;
  std::vector<Plane> planes;
  for (const auto& polygon : solid.polygons) {
    Plane p{};
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const std::size_t a = polygon[k], b = polygon[(k + 1) % polygon.size()],
                        c = polygon[(k + 2) % polygon.size()];
      if (a >= vertices.size() || !edges.insert({a, b}).second) return {};
      p = plane_through(vertices[a], vertices[b], vertices[c]);
      if (is_zero({p[0], p[1], p[2]})) return {};  // three corners of a facet are never collinear
    }
    for (const std::size_t corner : polygon) {
      if (side(p, vertices[corner]) != 0) return {};
    }
    bool has_inside = false;
    for (const Homogeneous& v : vertices) {
      const int s = side(p, v);
      if (s > 0) return {};
      has_inside = has_inside || s < 0;
    }
    if (!has_inside) return {};
    planes.push_back(p);
  }
  for (const auto& [a, b] : edges) {
    if (!edges.contains({b, a})) return {};
  }
  return planes;
}

}  // namespace stored_checker
