// SPDX-License-Identifier: MIT
// What an observer of insertions sees rebuilds the hull: judged by the definition of a convex
// surface.
#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "convexact/geometry.hpp"
#include "hull/hull_observer.hpp"
#include "shapes/makers.hpp"

using namespace convexact;

namespace {

// The same triangle, lowest corner first.
HullTriangle turned(HullTriangle t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

using Edge = std::pair<PointId, PointId>;

// Replays what it is told, and checks each insertion on the way.
class Replay : public HullObserver {
 public:
  std::set<HullTriangle> surface;
  std::size_t starts = 0, insertions = 0;

  void start(const HullStart& simplex) override {
    ++starts;
    CHECK(simplex.triangles.size() == 4);
    for (const HullTriangle& t : simplex.triangles) CHECK(surface.insert(turned(t)).second);
  }

  void inserted(const HullInsertion& insertion) override {
    ++insertions;
    // The rim of the visible triangles: their edges without a visible triangle on the other side.
    std::set<Edge> rim;
    for (const HullTriangle& t : insertion.visible) {
      CHECK(surface.erase(turned(t)) == 1);
      for (std::size_t k = 0; k < 3; ++k) {
        const Edge edge{t[k], t[(k + 1) % 3]};
        if (rim.erase({edge.second, edge.first}) == 0) rim.insert(edge);
      }
    }
    const auto& horizon = insertion.horizon;
    REQUIRE(insertion.added.size() == horizon.size());
    CHECK(rim.size() == horizon.size());
    for (std::size_t k = 0; k < horizon.size(); ++k) {
      const PointId from = horizon[k], to = horizon[(k + 1) % horizon.size()];
      CHECK(rim.count({from, to}) == 1);
      CHECK(insertion.added[k] == HullTriangle{from, to, insertion.point});
      CHECK(surface.insert(turned(insertion.added[k])).second);
    }
  }
};

// Every edge once in each direction, and no point beyond a triangle.
template <class Beyond>
void check_surface(const std::set<HullTriangle>& surface, std::size_t count, const Hull& hull,
                   const Beyond& is_beyond_plane) {
  std::set<Edge> edges;
  std::set<PointId> corners;
  for (const HullTriangle& t : surface) {
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(edges.insert({t[k], t[(k + 1) % 3]}).second);
      corners.insert(t[k]);
    }
    for (std::size_t p = 0; p < count; ++p) CHECK_FALSE(is_beyond_plane(t, PointId(p)));
  }
  for (const auto& [from, to] : edges) CHECK(edges.count({to, from}) == 1);
  CHECK(corners.size() + surface.size() == edges.size() / 2 + 2);
  CHECK(corners.size() >= hull.vertices.size());
}

void check_replay(const std::vector<Point>& points, double effort) {
  const PointSet set(points);
  Replay replay;
  const HullOutcome outcome =
      convex_hull(set, {.seed = 3, .furthest_first_effort = effort, .observer = &replay});
  const Hull& hull = std::get<Hull>(outcome);
  CHECK(replay.starts == 1);
  CHECK(replay.insertions + 4 >= hull.vertices.size());
  check_surface(replay.surface, points.size(), hull, [&](const HullTriangle& t, PointId p) {
    return is_beyond(points[t[0].index()], points[t[1].index()], points[t[2].index()],
                     points[p.index()]);
  });
  // To look changes nothing.
  const Hull alone = std::get<Hull>(convex_hull(set, {.seed = 3, .furthest_first_effort = effort}));
  CHECK(alone.vertices == hull.vertices);
  REQUIRE(alone.facets.size() == hull.facets.size());
  for (std::size_t f = 0; f < alone.facets.size(); ++f) {
    CHECK(std::ranges::equal(alone.facets[f], hull.facets[f]));
  }
}

}  // namespace

TEST_CASE("observer: a simplex is not inserted into, and flat points show nothing") {
  Replay replay;
  (void)convex_hull(PointSet(shapes::tetrahedron()), {.observer = &replay});
  CHECK(replay.starts == 1);
  CHECK(replay.insertions == 0);
  Replay flat;
  (void)convex_hull(PointSet(shapes::coplanar(20, 1)), {.observer = &flat});
  CHECK(flat.starts == 0);
}

TEST_CASE("observer: the insertions that it sees rebuild the hull") {
  for (const double effort : {0.0, 8.0}) {
    CAPTURE(effort);
    check_replay(shapes::in_ball(60, 1), effort);
    check_replay(shapes::on_sphere(40, 2), effort);
    check_replay(shapes::grid(4), effort);  // many points in facets and edges
    check_replay(shapes::lattice(60, 2, 5), effort);
    check_replay(shapes::repeated_sphere(10, 3, 1), effort);
  }
}

TEST_CASE("observer: homogeneous points are seen alike") {
  const std::vector<Point> points = shapes::lattice(30, 3, 7);
  std::vector<HomogeneousPoint> homogeneous;
  for (const Point& p : points) {
    homogeneous.push_back({{Integer(p[0]), Integer(p[1]), Integer(p[2])}, 1});
  }
  Replay replay;
  const HullOutcome outcome = convex_hull(homogeneous, {.observer = &replay});
  check_surface(replay.surface, points.size(), std::get<Hull>(outcome),
                [&](const HullTriangle& t, PointId p) {
                  return is_beyond(points[t[0].index()], points[t[1].index()], points[t[2].index()],
                                   points[p.index()]);
                });
}
