// SPDX-License-Identifier: MIT
// Property of surface: for any soup of polygons the triangles of a face have its area, points are
// distinct and sorted, directed edges cancel iff the surface is closed, and the order of points and
// faces changes nothing; winding numbers are those of a ray in another direction, and those beside
// a triangle differ by the triangles that lie on it.
#include <map>

#include "convexact/overlay.hpp"
#include "convexact/surface.hpp"
#include "fuzz_check.hpp"
#include "fuzz_target.hpp"

using namespace convexact;

namespace {

constexpr std::size_t kMostPoints = 12, kMostFaces = 10, kMostCorners = 6;

Mesh soup_of(FuzzInput& in) {
  Mesh mesh;
  const std::vector<Point> points = in.grid_points(kMostPoints, 2);
  mesh.points = PointSet(points);
  if (points.empty()) return mesh;
  for (std::size_t count = 1 + in.below(kMostFaces); count > 0; --count) {
    auto& polygon =
        mesh.polygons.emplace_back(in.below(3) == 0 ? 3 + in.below(kMostCorners - 2) : 3);
    for (std::uint32_t& corner : polygon) {
      corner = static_cast<std::uint32_t>(in.below(points.size()));
    }
    // The same face in the opposite direction closes the surface.
    if (in.below(2) == 0) {
      const auto copy = polygon;
      mesh.polygons.emplace_back(copy.rbegin(), copy.rend());
    }
  }
  return mesh;
}

RationalVector3 cross(const Surface& s, std::size_t t) {
  const auto& [a, b, c] = s.triangles[t];
  return RationalVector3(s.points[b] - s.points[a])
      .cross(RationalVector3(s.points[c] - s.points[a]));
}

void check_areas(const Mesh& mesh, const Surface& surface) {
  std::vector<RationalVector3> areas(mesh.polygons.size(), RationalVector3::Zero());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    areas[surface.face[t]] += cross(surface, t);
  }
  for (std::size_t f = 0; f < areas.size(); ++f) {
    const auto& polygon = mesh.polygons[f];
    RationalVector3 area = RationalVector3::Zero();
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const RationalPoint a = mesh.points[PointId(polygon[k])],
                          b = mesh.points[PointId(polygon[(k + 1) % polygon.size()])];
      area += a.cross(b);
    }
    FUZZ_CHECK(areas[f] == area);
  }
}

void check_points_and_edges(const Surface& surface) {
  for (std::size_t p = 1; p < surface.points.size(); ++p) {
    const RationalPoint a = surface.points[PointId(p - 1)], b = surface.points[PointId(p)];
    FUZZ_CHECK(std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3));
  }
  std::map<std::pair<PointId, PointId>, long> directed;
  for (const auto& t : surface.triangles) {
    for (int k = 0; k < 3; ++k) {
      const PointId tail = t[k], head = t[(k + 1) % 3];
      if (tail < head) ++directed[{tail, head}];
      if (head < tail) --directed[{head, tail}];
    }
  }
  const bool cancels = std::all_of(directed.begin(), directed.end(),
                                   [](const auto& edge) { return edge.second == 0; });
  FUZZ_CHECK(surface.is_closed == cancels);
}

Mesh permuted(const Mesh& mesh, FuzzInput& in) {
  std::vector<std::uint32_t> place(mesh.points.size());
  for (std::uint32_t p = 0; p < place.size(); ++p) place[p] = p;
  for (std::size_t p = place.size(); p > 1; --p) std::swap(place[p - 1], place[in.below(p)]);
  std::vector<Point> points(place.size());
  for (std::size_t p = 0; p < place.size(); ++p) points[place[p]] = mesh.points.doubles()[p];
  Mesh other{PointSet(points), mesh.polygons, {}};
  for (auto& polygon : other.polygons) {
    for (std::uint32_t& corner : polygon) corner = place[corner];
    std::rotate(polygon.begin(), polygon.begin() + long(in.below(polygon.size())), polygon.end());
  }
  for (std::size_t f = other.polygons.size(); f > 1; --f) {
    std::swap(other.polygons[f - 1], other.polygons[in.below(f)]);
  }
  return other;
}

// Along a direction that no plane of the grid holds with x: the sum of signed crossings. Nothing if
// x lies on a triangle.
std::optional<long> winding_by_ray(const Surface& s, const RationalPoint& x) {
  const RationalVector3 direction(Rational(1), Rational(1, 101), Rational(1, 10007));
  long sum = 0;
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    const RationalVector3 normal = cross(s, t);
    if (normal.isZero(0)) continue;
    const auto& [a, b, c] = s.triangles[t];
    const Rational slope = normal.dot(direction);
    const Rational height = normal.dot(RationalVector3(s.points[a] - x));
    FUZZ_CHECK(slope != 0);
    const Rational at = height / slope;
    if (at < 0) continue;
    const RationalPoint y = x + direction * at;
    const auto side = [&](PointId p, PointId q) {
      return sign_of(Rational(normal.dot(
          RationalVector3(s.points[q] - s.points[p]).cross(RationalVector3(y - s.points[p])))));
    };
    const Sign sides[] = {side(a, b), side(b, c), side(c, a)};
    const bool is_in = std::none_of(std::begin(sides), std::end(sides),
                                    [](Sign sign) { return sign == Sign::Negative; });
    if (!is_in) continue;
    if (at == 0) return std::nullopt;
    // The ray must not meet an edge: then another direction would be needed.
    FUZZ_CHECK(std::none_of(std::begin(sides), std::end(sides),
                            [](Sign sign) { return sign == Sign::Zero; }));
    sum += slope > 0 ? 1 : -1;
  }
  return sum;
}

void check_windings(const Surface& surface, FuzzInput& in) {
  const Winding winding(surface);
  for (int k = 0; k < 4; ++k) {
    // Quarters, off the grid by a third so that no ray meets an edge.
    RationalPoint x;
    for (Rational& c : x) c = Rational(static_cast<int>(in.below(25)) - 12, 5) + Rational(1, 77);
    x[1] += Rational(1, 1009);
    FUZZ_CHECK(winding(x) == winding_by_ray(surface, x));
  }
  const std::size_t t = in.below(surface.triangles.size());
  const RationalVector3 normal = cross(surface, t);
  const auto& [a, b, c] = surface.triangles[t];
  FUZZ_CHECK(!winding(surface.points[a]));
  if (normal.isZero(0)) return;
  const RationalPoint middle = surface.points[a] * Rational(1, 3) +
                               surface.points[b] * Rational(1, 5) +
                               surface.points[c] * Rational(7, 15);
  const auto [before, behind] = winding.beside(TriangleId(t), middle);
  long covered = 0;
  bool crosses = false;
  for (std::size_t s = 0; s < surface.triangles.size(); ++s) {
    const RationalVector3 other = cross(surface, s);
    if (other.isZero(0)) continue;
    const auto& u = surface.triangles[s];
    if (other.dot(RationalVector3(middle - surface.points[u[0]])) != 0) continue;
    bool is_in = true;
    for (int k = 0; k < 3; ++k) {
      const RationalPoint p = surface.points[u[k]], q = surface.points[u[(k + 1) % 3]];
      is_in = is_in && other.dot(RationalVector3(q - p).cross(RationalVector3(middle - p))) >= 0;
    }
    if (!is_in) continue;
    if (other.cross(normal).isZero(0)) {
      covered += other.dot(normal) > 0 ? 1 : -1;
    } else {
      crosses = true;
    }
  }
  if (!crosses) FUZZ_CHECK(behind - before == covered);
}

void hold_surface(FuzzInput& in) {
  const Mesh mesh = soup_of(in);
  if (mesh.polygons.empty()) return;
  const bool keeps = in.below(2) == 0;
  const SurfaceOptions options{keeps ? Orient::Keep : Orient::Auto};
  const Surface surface = make_surface(mesh, options);
  if (keeps) check_areas(mesh, surface);
  check_points_and_edges(surface);
  const Surface other = make_surface(permuted(mesh, in), options);
  FUZZ_CHECK(other.triangles == surface.triangles);
  FUZZ_CHECK(other.points.size() == surface.points.size());
  FUZZ_CHECK(other.is_closed == surface.is_closed);
  FUZZ_CHECK(other.contradictions == surface.contradictions);
  if (!surface.is_closed) return;
  check_windings(surface, in);
  const Measured volume = solid_volume(surface, 64, true);
  FUZZ_CHECK(*volume.exact >= 0);
  FUZZ_CHECK(volume.bounds.contains(*volume.exact));
}

const FuzzTarget kSurface("surface", hold_surface);

}  // namespace
