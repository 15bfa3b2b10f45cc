// SPDX-License-Identifier: MIT
// check_hull rejects what is not the hull.
#include <doctest/doctest.h>

#include <algorithm>
#include <functional>

#include "checked_hull.hpp"
#include "exact_determinant.hpp"
#include "shapes/makers.hpp"

using namespace convexact;

namespace {

using Facets = std::vector<std::vector<PointId>>;

Facets facets_of(const Hull& hull) {
  Facets facets;
  for (std::size_t f = 0; f < hull.facets.size(); ++f)
    facets.emplace_back(hull.facets[f].begin(), hull.facets[f].end());
  return facets;
}

Hull with_facets(const Hull& hull, const Facets& facets) {
  Hull changed = hull;
  changed.facets = FacetList();
  for (const auto& facet : facets) changed.facets.push_back(facet);
  return changed;
}

Rational det(const Point& a, const Point& b, const Point& c) {
  std::vector<std::vector<Rational>> rows;
  for (const Point* p : {&a, &b, &c})
    rows.push_back({to_rational(p->x()), to_rational(p->y()), to_rational(p->z())});
  return exact_determinant(rows);
}

// The twelve vertices of an icosahedron, nearly, then a small tetrahedron about the origin.
std::vector<Point> icosahedron_points() {
  const double g = 1.618;
  std::vector<Point> points;
  for (const double s : {-1.0, 1.0})
    for (const double t : {-g, g})
      for (int axis = 0; axis < 3; ++axis) {
        Point p = Point::Zero();
        p[(axis + 1) % 3] = s;
        p[(axis + 2) % 3] = t;
        points.push_back(p);
      }
  for (const Point& p : {Point(1, 1, 1), Point(1, -1, -1), Point(-1, 1, -1), Point(-1, -1, 1)})
    points.push_back(p / 16);
  return points;
}

// The surface of the 20 triangles whose corners are pairwise at a (squared) distance within
// [low, high]; the tetrahedron is proven inside by the triangles of `cover`.
Hull surface(const std::vector<Point>& points, double low, double high, const Facets& cover) {
  Hull hull;
  Facets facets;
  const auto linked = [&](std::size_t i, std::size_t j) {
    const double squared = (points[i] - points[j]).squaredNorm();
    return low <= squared && squared <= high;
  };
  for (std::size_t i = 0; i < 12; ++i) {
    hull.vertices.emplace_back(i);
    for (std::size_t j = i + 1; j < 12; ++j)
      for (std::size_t k = j + 1; k < 12; ++k) {
        if (!linked(i, j) || !linked(j, k) || !linked(i, k)) continue;
        const bool turn = det(points[i], points[j], points[k]) > 0;
        facets.push_back({PointId(i), PointId(turn ? j : k), PointId(turn ? k : j)});
      }
  }
  hull.certificate.simplex = {PointId(12), PointId(13), PointId(14), PointId(15)};
  for (std::size_t i = 12; i < 16; ++i) {
    for (const auto& t : cover.empty() ? facets : cover) {
      const Point &a = points[t[0].index()], &b = points[t[1].index()], &c = points[t[2].index()];
      if (det(a, b, points[i]) < 0 || det(b, c, points[i]) < 0 || det(c, a, points[i]) < 0)
        continue;
      hull.certificate.inside.push_back({PointId(i), {t[0], t[1], t[2]}});
      break;
    }
  }
  return with_facets(hull, facets);
}

}  // namespace

TEST_CASE("check_hull: facets that are flipped, missing, doubled, or too many") {
  for (const auto& list : {shapes::cut_cube(3, 0.25), shapes::on_sphere(40, 1), shapes::grid(3)}) {
    const PointSet points(list);
    const Hull hull = checked_hull(points);
    const Facets facets = facets_of(hull);
    for (std::size_t f = 0; f < facets.size(); ++f) {
      Facets changed = facets;
      std::reverse(changed[f].begin(), changed[f].end());
      CHECK_FALSE(check_hull(with_facets(hull, changed), points));
      changed = facets;
      changed.erase(changed.begin() + static_cast<std::ptrdiff_t>(f));
      CHECK_FALSE(check_hull(with_facets(hull, changed), points));
      changed = facets;
      changed.push_back(facets[f]);
      CHECK_FALSE(check_hull(with_facets(hull, changed), points));
    }
    Facets inside_out = facets;
    for (auto& facet : inside_out) std::reverse(facet.begin(), facet.end());
    CHECK_FALSE(check_hull(with_facets(hull, inside_out), points));
    Facets twice = facets;
    twice.insert(twice.end(), facets.begin(), facets.end());
    CHECK_FALSE(check_hull(with_facets(hull, twice), points));
    CHECK_FALSE(check_hull(with_facets(hull, {}), points));
  }
}

TEST_CASE("check_hull: coplanar triangles in place of a facet") {
  const PointSet points(shapes::grid(2));
  const Hull hull = checked_hull(points);
  Facets facets = facets_of(hull);
  const auto quad = facets[0];
  facets[0] = {quad[0], quad[1], quad[2]};
  facets.push_back({quad[0], quad[2], quad[3]});
  CHECK_FALSE(check_hull(with_facets(hull, facets), points));
}

TEST_CASE("check_hull: of points that are no doubles") {
  std::vector<RationalPoint> thirds;
  for (int k = 0; k < 8; ++k) {
    thirds.emplace_back(Rational(k & 1, 3), Rational(k >> 1 & 1, 3), Rational(k >> 2, 3));
  }
  const PointSet points(thirds);
  REQUIRE_FALSE(points.is_binary());
  const Hull hull = std::get<Hull>(convex_hull(points));
  CHECK(check_hull(hull, points));
  CHECK_FALSE(check_hull(with_facets(hull, {}), points));
}

TEST_CASE("check_hull: corners that are not extreme, or in the wrong order") {
  const PointSet points(shapes::grid(3));
  const Hull hull = checked_hull(points);
  const Facets facets = facets_of(hull);
  for (std::size_t f = 0; f < facets.size(); ++f) {
    Facets changed = facets;
    std::swap(changed[f][1], changed[f][2]);
    CHECK_FALSE(check_hull(with_facets(hull, changed), points));
  }
  // The middle of an edge as a corner of both facets there.
  const PointId a = facets[0][0], b = facets[0][1];
  const PointId middle((a.index() + b.index()) / 2);
  Facets changed = facets;
  for (auto& facet : changed) {
    for (std::size_t k = 0; k < facet.size(); ++k) {
      const PointId next = facet[(k + 1) % facet.size()];
      if ((facet[k] != a || next != b) && (facet[k] != b || next != a)) continue;
      facet.insert(facet.begin() + static_cast<std::ptrdiff_t>(k) + 1, middle);
      break;
    }
  }
  Hull wrong = with_facets(hull, changed);
  wrong.vertices.insert(std::ranges::lower_bound(wrong.vertices, middle), middle);
  std::erase_if(wrong.certificate.inside, [&](const auto& proof) { return proof.point == middle; });
  CHECK_FALSE(check_hull(wrong, points));
}

TEST_CASE("check_hull: the hull of all points but one vertex is not the hull") {
  const std::vector<Point> list = shapes::on_sphere(30, 2);
  for (std::size_t dropped = 20; dropped < 30; ++dropped) {
    std::vector<Point> fewer = list;
    std::swap(fewer[dropped], fewer.back());
    std::vector<Point> all = fewer;
    fewer.pop_back();
    Hull hull = checked_hull(PointSet(fewer));
    CHECK_FALSE(check_hull(hull, PointSet(all)));  // nothing is said of the last point
    for (std::size_t f = 0; f < hull.facets.size(); ++f) {
      const auto t = hull.facets[f];
      hull.certificate.inside.push_back({PointId(29), {t[0], t[1], t[2]}});
      CHECK_FALSE(check_hull(hull, PointSet(all)));
      hull.certificate.inside.pop_back();
    }
  }
}

TEST_CASE("check_hull: proofs that prove nothing") {
  std::vector<Point> list = shapes::in_ball(60, 1);
  list.push_back(list[0]);
  const PointSet points(list);
  const Hull hull = checked_hull(points);
  const auto reject = [&](const std::function<void(Hull&)>& change) {
    Hull changed = hull;
    change(changed);
    CHECK_FALSE(check_hull(changed, points));
  };
  auto& proofs = hull.certificate.inside;
  REQUIRE(proofs.size() > 2);
  reject([](Hull& h) { h.certificate.inside.pop_back(); });
  reject([](Hull& h) { h.certificate.inside.push_back(h.certificate.inside.front()); });
  reject([](Hull& h) { h.certificate.inside[0].triangle[0] = h.certificate.inside[0].point; });
  reject([](Hull& h) {
    std::swap(h.certificate.inside[0].triangle[0], h.certificate.inside[0].triangle[1]);
  });
  reject([](Hull& h) { h.certificate.inside[0].triangle.fill(h.vertices[0]); });
  reject([](Hull& h) { h.certificate.inside[0].point = h.vertices[0]; });
  reject([](Hull& h) { h.certificate.inside[0].triangle[2] = PointId(61); });
  reject([](Hull& h) { h.certificate.simplex[0] = h.certificate.simplex[1]; });
  reject([](Hull& h) { h.certificate.simplex[0] = PointId(61); });
  reject([](Hull& h) { h.vertices.pop_back(); });
  reject([](Hull& h) { std::swap(h.vertices[0], h.vertices[1]); });
  // Two points that prove one another.
  reject([&](Hull& h) {
    const PointId p = h.certificate.inside[0].point, q = h.certificate.inside[1].point;
    h.certificate.inside[0].triangle = {q, h.vertices[0], h.vertices[1]};
    h.certificate.inside[1].triangle = {p, h.vertices[0], h.vertices[1]};
  });
}

TEST_CASE("check_hull: the great icosahedron is locally convex, but no hull") {
  // Both surfaces have 12 vertices, 30 edges and 20 triangles that turn the same way about the
  // origin and are strictly convex at every edge; the great one winds seven times about it.
  const std::vector<Point> list = icosahedron_points();
  const PointSet points(list);
  const Hull good = surface(list, 3.5, 4.5, {});
  REQUIRE(good.facets.size() == 20);
  REQUIRE(good.certificate.inside.size() == 4);
  CHECK(check_hull(good, points));
  const Hull great = surface(list, 10, 11, facets_of(good));
  REQUIRE(great.facets.size() == 20);
  REQUIRE(great.certificate.inside.size() == 4);
  CHECK_FALSE(check_hull(great, points));
}

TEST_CASE("check_hull: two facets taken for one, though their ridge is bent") {
  const PointSet points(shapes::on_sphere(16, 5));
  const Hull hull = checked_hull(points);
  const Facets facets = facets_of(hull);
  std::size_t merged = 0;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    for (std::size_t g = 0; g < facets.size(); ++g) {
      if (f == g || facets[f].size() != 3 || facets[g].size() != 3) continue;
      // f = (a, b, c) and g = (b, a, d) in some rotation: together a, d, b, c.
      for (std::size_t k = 0; k < 3; ++k) {
        const PointId a = facets[f][k], b = facets[f][(k + 1) % 3], c = facets[f][(k + 2) % 3];
        for (std::size_t m = 0; m < 3; ++m) {
          if (facets[g][m] != b || facets[g][(m + 1) % 3] != a) continue;
          Facets changed;
          changed.push_back({a, facets[g][(m + 2) % 3], b, c});
          for (std::size_t h = 0; h < facets.size(); ++h) {
            if (h != f && h != g) changed.push_back(facets[h]);
          }
          CHECK_FALSE(check_hull(with_facets(hull, changed), points));
          std::rotate(changed[0].begin(), changed[0].begin() + 1, changed[0].end());
          CHECK_FALSE(check_hull(with_facets(hull, changed), points));
          std::rotate(changed.begin(), changed.begin() + 1, changed.end());
          CHECK_FALSE(check_hull(with_facets(hull, changed), points));
          ++merged;
        }
      }
    }
  }
  CHECK(merged > 20);
}

TEST_CASE(
    "check_hull: a simplex of four points in a plane, whose centroid is inside all the same") {
  const PointSet points(shapes::cube());
  Hull hull = checked_hull(points);
  std::size_t flat = 0;
  for (std::size_t code = 0; code < 4096; ++code) {
    const std::array<PointId, 4> s{PointId(code & 7), PointId(code >> 3 & 7),
                                   PointId(code >> 6 & 7), PointId(code >> 9)};
    if (points[s[0]] + points[s[1]] != points[s[2]] + points[s[3]]) continue;
    hull.certificate.simplex = s;  // a parallelogram, or less
    CHECK_FALSE(check_hull(hull, points));
    ++flat;
  }
  CHECK(flat > 10);
}

TEST_CASE("check_hull: ids far beyond the points") {
  const PointSet points(shapes::in_ball(40, 2));
  const Hull hull = checked_hull(points);
  const PointId far(1u << 30);
  Hull changed = hull;
  changed.vertices.back() = far;
  CHECK_FALSE(check_hull(changed, points));
  Facets facets = facets_of(hull);
  facets[1][2] = far;
  CHECK_FALSE(check_hull(with_facets(hull, facets), points));
  facets = facets_of(hull);
  facets.push_back({});
  CHECK_FALSE(check_hull(with_facets(hull, facets), points));
  facets.back() = {hull.vertices[0], hull.vertices[1]};
  CHECK_FALSE(check_hull(with_facets(hull, facets), points));
  REQUIRE(!hull.certificate.inside.empty());
  for (std::size_t k = 0; k < 4; ++k) {
    changed = hull;
    (k < 3 ? changed.certificate.inside[0].triangle[k] : changed.certificate.inside[0].point) = far;
    CHECK_FALSE(check_hull(changed, points));
    changed = hull;
    changed.certificate.simplex[k] = far;
    CHECK_FALSE(check_hull(changed, points));
  }
}

TEST_CASE("check_hull: the prism over a pentagram, seen from a top whose fan turns back") {
  // Closed and convex at every edge, and the ray through the top meets one triangle that turns
  // left: only that another one turns right tells that the top winds around twice.
  std::vector<Point> list;
  for (const double z : {-10.0, 10.0}) {
    for (const auto& [x, y] : {std::pair{0, 10}, {-9, 3}, {-6, -8}, {6, -8}, {30, 3}})
      list.emplace_back(x, y, z);
  }
  const PointSet points(list);
  for (std::size_t start = 0; start < 5; ++start) {
    Facets facets(2);
    for (std::size_t k = 0; k < 5; ++k) {
      const std::size_t i = (start + 2 * k) % 5, j = (i + 2) % 5;
      facets[0].emplace_back(i + 5);
      facets[1].insert(facets[1].begin(), PointId(i));
      facets.push_back({PointId(i), PointId(j), PointId(j + 5), PointId(i + 5)});
    }
    Hull hull;
    for (std::size_t i = 0; i < 10; ++i) hull.vertices.emplace_back(i);
    hull = with_facets(hull, facets);
    for (std::size_t code = 0; code < 10000; ++code) {
      const std::size_t s[] = {code % 10, code / 10 % 10, code / 100 % 10, code / 1000};
      if (s[0] >= s[1] || s[1] >= s[2] || s[2] >= s[3]) continue;
      hull.certificate.simplex = {PointId(s[0]), PointId(s[1]), PointId(s[2]), PointId(s[3])};
      CHECK_FALSE(check_hull(hull, points));
    }
  }
}

TEST_CASE("check_hull: a vertex that is a repeat of a corner, and no corner itself") {
  std::vector<Point> list = shapes::cube();
  list.push_back(list[0]);
  const PointSet points(list);
  const Hull hull = checked_hull(points);
  const PointId corner = hull.vertices[0] == PointId(0) ? PointId(0) : PointId(8);
  const PointId repeat(8 - corner.index());
  Hull wrong = hull;
  std::erase(wrong.vertices, corner);
  wrong.vertices.insert(std::ranges::lower_bound(wrong.vertices, repeat), repeat);
  wrong.certificate.inside = {{corner, {repeat, repeat, repeat}}};
  CHECK_FALSE(check_hull(wrong, points));
  wrong.vertices = hull.vertices;  // one corner too few
  std::erase(wrong.vertices, corner);
  CHECK_FALSE(check_hull(wrong, points));
}

TEST_CASE("check_hull: a proof twice in place of another") {
  const PointSet points(shapes::in_ball(60, 3));
  const Hull hull = checked_hull(points);
  const std::size_t count = hull.certificate.inside.size();
  REQUIRE(count > 3);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < count; ++j) {
      if (i == j) continue;
      Hull wrong = hull;
      wrong.certificate.inside[i] = wrong.certificate.inside[j];
      CHECK_FALSE(check_hull(wrong, points));
    }
  }
}

TEST_CASE("check_hull: a point outside, by a triangle in a plane with the center") {
  std::vector<Point> list = shapes::cube();
  const Hull cube = checked_hull(PointSet(list));
  list.push_back(list[0] + 4 * (list[7] - list[0]));
  const PointSet points(list);
  std::size_t flat = 0;
  for (std::size_t code = 0; code < 512; ++code) {
    Hull wrong = cube;
    wrong.certificate.inside.push_back(
        {PointId(8), {PointId(code & 7), PointId(code >> 3 & 7), PointId(code >> 6)}});
    CHECK_FALSE(check_hull(wrong, points));
    ++flat;
  }
  CHECK(flat == 512);
}

TEST_CASE("check_hull: points that are no doubles are checked, too") {
  std::vector<RationalPoint> thirds;
  for (const Point& p : shapes::cube()) thirds.push_back(to_rational(p) / Rational(3));
  const PointSet points(thirds);
  const Hull hull = checked_hull(points);
  Facets facets = facets_of(hull);
  facets.pop_back();
  CHECK_FALSE(check_hull(with_facets(hull, facets), points));
}
