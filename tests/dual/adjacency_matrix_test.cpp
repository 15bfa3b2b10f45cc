// SPDX-License-Identifier: MIT
// The adjacency matrix. Expected values by hand.
#include <doctest/doctest.h>

#include "convexact/dual.hpp"
#include "convexact/error.hpp"
#include "matrix_table.hpp"

using namespace convexact;

namespace {

DualTriangle triangle(std::size_t a, std::size_t b, std::size_t c) {
  return {HalfspaceId(a), HalfspaceId(b), HalfspaceId(c)};
}

// The octahedron: 0 and 5 are poles, 1 2 3 4 go round counter-clockwise seen from 5.
AdjacencyMatrix octahedron() {
  AdjacencyMatrix matrix(6);
  for (std::size_t t = 0; t < 4; ++t) {
    matrix.add(triangle(5, 1 + t, 1 + (t + 1) % 4));
    matrix.add(triangle(0, 1 + (t + 1) % 4, 1 + t));
  }
  return matrix;
}

std::vector<std::uint32_t> values(const std::vector<HalfspaceId>& ids) {
  std::vector<std::uint32_t> v;
  for (const HalfspaceId id : ids) v.push_back(id.value);
  return v;
}

}  // namespace

TEST_CASE("AdjacencyMatrix: an empty matrix") {
  const AdjacencyMatrix matrix(2);
  CHECK_FALSE(matrix.at(HalfspaceId(0), HalfspaceId(1)).has_value());
  CHECK(matrix.one_ring(HalfspaceId(0)).empty());
  CHECK(matrix.triangles().empty());
  CHECK(matrix.is_closed_manifold());
  CHECK(table_of(matrix) == ". .\n. .\n");
}

TEST_CASE("AdjacencyMatrix: the tetrahedron is the smallest closed surface") {
  AdjacencyMatrix matrix(4);
  matrix.add(triangle(0, 1, 2));
  CHECK_FALSE(matrix.is_closed_manifold());
  matrix.add(triangle(0, 2, 3));
  matrix.add(triangle(0, 3, 1));
  matrix.add(triangle(1, 3, 2));
  CHECK(matrix.is_closed_manifold());
  CHECK(table_of(matrix) ==
        ". 2 3 1\n"
        "3 . 0 2\n"
        "1 3 . 0\n"
        "2 0 1 .\n");
}

TEST_CASE("AdjacencyMatrix: rings turn counter-clockwise from the lowest id") {
  const AdjacencyMatrix matrix = octahedron();
  CHECK(matrix.is_closed_manifold());
  CHECK(values(matrix.one_ring(HalfspaceId(5))) == std::vector<std::uint32_t>{1, 2, 3, 4});
  CHECK(values(matrix.one_ring(HalfspaceId(0))) == std::vector<std::uint32_t>{1, 4, 3, 2});
  CHECK(values(matrix.one_ring(HalfspaceId(1))) == std::vector<std::uint32_t>{0, 2, 5, 4});
  CHECK(matrix.triangles().size() == 8);
}

TEST_CASE("AdjacencyMatrix: remove undoes add") {
  AdjacencyMatrix matrix = octahedron();
  for (std::size_t t = 0; t < 4; ++t) matrix.remove(triangle(1 + t, 1 + (t + 1) % 4, 5));
  CHECK(matrix.one_ring(HalfspaceId(5)).empty());
  CHECK_FALSE(matrix.is_closed_manifold());
  matrix.add(triangle(1, 2, 3));
  matrix.add(triangle(1, 3, 4));
  CHECK(matrix.is_closed_manifold());
  CHECK(matrix.at(HalfspaceId(3), HalfspaceId(1)) == HalfspaceId(2));
}

#ifdef CONVEXACT_ASSERTIONS
TEST_CASE("AdjacencyMatrix: an edge is set once") {
  AdjacencyMatrix matrix(4);
  matrix.add(triangle(0, 1, 2));
  CHECK_THROWS_AS(matrix.add(triangle(0, 1, 3)), Error);
  CHECK_THROWS_AS(matrix.remove(triangle(0, 2, 1)), Error);
}
#endif

TEST_CASE("AdjacencyMatrix: two surfaces that share one vertex are no manifold") {
  AdjacencyMatrix matrix(7);
  for (const std::size_t s : {1u, 4u}) {  // tetrahedra (0, s, s+1, s+2)
    matrix.add(triangle(0, s, s + 1));
    matrix.add(triangle(0, s + 1, s + 2));
    matrix.add(triangle(0, s + 2, s));
    matrix.add(triangle(s, s + 2, s + 1));
  }
  CHECK_FALSE(matrix.is_closed_manifold());
}
