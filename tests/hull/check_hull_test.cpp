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
