// SPDX-License-Identifier: MIT
// Whether a face crosses or touches itself: small polygons on a lattice, where every kind of
// touching occurs, against the definition (all pairs of edges,
// tests/support/definitional_verdict.hpp), and combs, which are simple or not by construction.
#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <set>

#include "definitional_verdict.hpp"
#include "expect_error.hpp"
#include "number/random.hpp"
#include "oracle/solid/mesh_surface.hpp"
#include "sweep.hpp"

using namespace convexact;

namespace {

// One face through the points in their order, in the plane of x + y + z = 0, so that any of the
// three axes may be the one along which it is seen.
Mesh face_through(const std::vector<std::array<int, 2>>& places) {
  Mesh mesh;
  std::vector<Point> points;
  std::vector<std::uint32_t>& face = mesh.polygons.emplace_back();
  for (const auto& [x, y] : places) {
    face.push_back(static_cast<std::uint32_t>(points.size()));
    points.emplace_back(x, y, -x - y);
  }
  mesh.points = PointSet(points);
  return mesh;
}

bool crosses(const Mesh& mesh) { return MeshSurface(mesh).crossed_face({}).has_value(); }

std::vector<std::array<int, 2>> random_places(Random& random, int size, std::size_t count) {
  std::vector<std::array<int, 2>> all;
  for (int x = 0; x < size; ++x) {
    for (int y = 0; y < size; ++y) all.push_back({x, y});
  }
  for (std::size_t k = 0; k < count; ++k) {
    std::swap(all[k], all[k + uniform_below(random, all.size() - k)]);
  }
  all.resize(count);
  return all;
}

// In the order of their directions from their middle: most of these are simple.
void sort_about_middle(std::vector<std::array<int, 2>>& places) {
  double x = 0, y = 0;
  for (const auto& p : places) {
    x += p[0] / static_cast<double>(places.size());
    y += p[1] / static_cast<double>(places.size());
  }
  std::sort(places.begin(), places.end(), [&](const auto& a, const auto& b) {
    return std::atan2(a[1] - y, a[0] - x) < std::atan2(b[1] - y, b[0] - x);
  });
}

// Teeth up to the given height, whose edges all overlap along the second axis, and a back.
std::vector<std::array<int, 2>> comb(int teeth) {
  std::vector<std::array<int, 2>> places;
  for (int k = 0; k < teeth; ++k) {
    places.push_back({2 * k, 0});
    places.push_back({2 * k + 1, 1000});
  }
  places.push_back({2 * teeth, 2000});
  places.push_back({-1, 2000});
  return places;
}

}  // namespace

TEST_CASE("crossing edges: polygons on a lattice, against all pairs" * sweep) {
  Random random(42);
  std::size_t simple = 0, crossed = 0;
  for (int run = 0; run < 6000; ++run) {
    const int size = 3 + run % 4;
    auto places = random_places(random, size, 4 + uniform_below(random, 5));
    if (run % 2 == 0) sort_about_middle(places);
    const Mesh mesh = face_through(places);
    const bool is_planar = definition::MeshByDefinition(mesh).is_planar();
    CAPTURE(run);
    CHECK(crosses(mesh) == !is_planar);
    ++(is_planar ? simple : crossed);
  }
  CHECK(simple > 1000);
  CHECK(crossed > 1000);
}

TEST_CASE("crossing edges: the two edges of the witness touch") {
  Random random(7);
  for (int run = 0; run < 300; ++run) {
    const Mesh mesh = face_through(random_places(random, 4, 9));
    const auto crossed = MeshSurface(mesh).crossed_face({});
    if (!crossed) continue;
    REQUIRE(crossed->corners.size() == 4);
    const auto& c = crossed->corners;
    if (std::set(c.begin(), c.end()).size() < 4) continue;  // a corner that folds back
    // Edges 0 and 2 of the four corners are those of the witness.
    const Mesh four{mesh.points, {c}, {}};
    CHECK_FALSE(definition::MeshByDefinition(four).is_planar());
  }
}

TEST_CASE(
    "crossing edges: of a corner that hides another one, the edges that meet there are named") {
  // Seen along z the last corner hides the first one: the edges before and behind both meet.
  const std::vector<Point> corners = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0},
                                      {2, 1, 0}, {0, 4, 0}, {0, 0, 1}};
  for (std::uint32_t turn = 0; turn < 6; ++turn) {
    Mesh mesh{PointSet(corners), {{}}, {}};
    for (std::uint32_t k = 0; k < 6; ++k) mesh.polygons[0].push_back((k + turn) % 6);
    const auto crossed = MeshSurface(mesh).crossed_face({});
    REQUIRE(crossed);
    CHECK(std::set(crossed->corners.begin(), crossed->corners.end()) ==
          std::set<std::uint32_t>{0, 1, 4, 5});
  }
}

TEST_CASE("crossing edges: a comb is simple, and one with a bent tooth is not") {
  // All pairs of 12,000 edges would take minutes.
  std::vector<std::array<int, 2>> places = comb(6000);
  CHECK_FALSE(crosses(face_through(places)));
  places[6001] = {6006, 1000};
  const Mesh bent = face_through(places);
  CHECK(crosses(bent));
}

TEST_CASE("crossing edges: the watch ends the search") {
  std::atomic<bool> stop = true;
  const Mesh mesh = face_through(comb(50));
  const MeshSurface surface(mesh);
  CHECK(error_of([&] { return surface.crossed_face(Watch(&stop)); }).code() == ErrorCode::Stopped);
}
