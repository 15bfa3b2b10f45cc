// SPDX-License-Identifier: MIT
// Inserting and removing vertices of a half-edge mesh, against the triangles that it must have.
#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "convexact/measure.hpp"
#include "fast/cap.hpp"
#include "searched.hpp"
#include "shapes/makers.hpp"

using namespace convexact;

namespace {

// What any closed sphere around these vertices satisfies: every ring is read off both ways.
void check_closed(const HalfEdgeMesh& mesh, std::size_t size) {
  AdjacencyMatrix matrix(size);
  for (const DualTriangle& t : mesh.triangles()) matrix.add(t);
  CHECK(matrix.is_closed_manifold());
  const std::vector<HalfspaceId> vertices = mesh.vertices();
  CHECK(mesh.triangles().size() == 2 * vertices.size() - 4);
  OneRing ring;
  for (const HalfspaceId v : vertices) {
    mesh.one_ring(v, ring);
    const auto least = std::min_element(ring.vertices.begin(), ring.vertices.end());
    std::rotate(ring.vertices.begin(), least, ring.vertices.end());
    CHECK(ring.vertices == matrix.one_ring(v));
  }
}

std::set<DualTriangle> rotated(const std::vector<DualTriangle>& triangles) {
  std::set<DualTriangle> list;
  for (DualTriangle t : triangles) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    list.insert(t);
  }
  return list;
}

}  // namespace

TEST_CASE("HalfEdgeMesh: inserted vertices are joined to the rim of what they see") {
  for (const std::vector<Point>& points :
       {shapes::cut_cube(8, 0.25), shapes::icosahedron(), shapes::in_ball(40, 1)}) {
    const Greedy greedy(points, 4, CostMeasure::Volume);
    const FastDual dual = FastDual::of(greedy.dual, greedy.center);
    const DualSigns signs(dual);
    HalfEdgeMesh mesh(dual.size(), dual.triangles(), dual.twins());
    FilteredCap cap(dual, mesh, CostMeasure::Volume, 1);
    Random random(4);
    std::vector<HalfspaceId> gone;
    const auto remove_some = [&] {
      std::vector<HalfspaceId> all = mesh.vertices();
      shuffle(std::span(all), random);
      for (const HalfspaceId v : all) {
        cap.prepare(v);
        if (cap.in_doubles().kind == Boundedness::Unbounded) continue;
        mesh.remove(v, cap.ring(), cap.triangles());
        cap.invalidate();
        gone.push_back(v);
      }
    };
    for (int round = 0; round < 4; ++round) {
      remove_some();
      check_closed(mesh, dual.size());
      shuffle(std::span(gone), random);
      for (std::size_t left = round == 3 ? 0 : gone.size() / 2; gone.size() > left;) {
        const HalfspaceId v = gone.back();
        gone.pop_back();
        mesh.insert(v, [&](const DualTriangle& t) {
          return signs.height(t[0], t[1], t[2], v) != Sign::Negative;
        });
        cap.invalidate();
        check_closed(mesh, dual.size());
      }
    }
    // Everything is back: the same solid, if with other triangles on level points.
    const Polytope again = to_polytope(greedy.dual.halfspaces, mesh.triangles());
    CHECK(again.planes == greedy.input.planes);
    CHECK(volume(again) == volume(greedy.input));
  }
}

TEST_CASE("HalfEdgeMesh: a removal is taken back to the same triangles") {
  const Greedy greedy(shapes::in_ball(40, 1), 4, CostMeasure::Volume);
  const FastDual dual = FastDual::of(greedy.dual, greedy.center);
  HalfEdgeMesh mesh(dual.size(), dual.triangles(), dual.twins());
  FilteredCap cap(dual, mesh, CostMeasure::Volume, 1);
  const std::set<DualTriangle> before = rotated(mesh.triangles());
  for (const HalfspaceId v : mesh.vertices()) {
    cap.prepare(v);
    const OneRing ring = cap.ring();
    mesh.remove(v, ring, cap.triangles());
    cap.invalidate();
    CHECK(!mesh.has(v));
    check_closed(mesh, dual.size());
    mesh.put_back(v, ring);
    CHECK(mesh.has(v));
    check_closed(mesh, dual.size());
    CHECK(rotated(mesh.triangles()) == before);
  }
}

TEST_CASE("HalfEdgeMesh: a rim does not depend on where the first seen triangle is looked for") {
  const Greedy greedy(shapes::in_ball(40, 1), 4, CostMeasure::Volume);
  const FastDual dual = FastDual::of(greedy.dual, greedy.center);
  const DualSigns signs(dual);
  HalfEdgeMesh mesh(dual.size(), dual.triangles(), dual.twins());
  FilteredCap cap(dual, mesh, CostMeasure::Volume, 1);
  const auto normalised = [](OneRing ring) {
    const auto least = std::min_element(ring.vertices.begin(), ring.vertices.end());
    std::rotate(ring.vertices.begin(), least, ring.vertices.end());
    return ring.vertices;
  };
  OneRing near, found;
  for (const HalfspaceId v : mesh.vertices()) {
    cap.prepare(v);
    const OneRing ring = cap.ring();
    mesh.remove(v, ring, cap.triangles());
    cap.invalidate();
    const auto sees = [&](const DualTriangle& t) {
      return signs.height(t[0], t[1], t[2], v) != Sign::Negative;
    };
    mesh.rim(sees, {}, found);
    const std::vector<HalfspaceId> anywhere = normalised(found);
    for (const HalfspaceId other : mesh.vertices()) {
      mesh.one_ring(other, near);
      mesh.rim(sees, near.outer, found);
      CHECK(normalised(found) == anywhere);
    }
    mesh.put_back(v, ring);
  }
}
