// SPDX-License-Identifier: MIT
// Bounding volumes with fixed directions: the box of the axes and the k-DOPs around it.
#include "lab/compare/method.hpp"

namespace convexact {
namespace {

// The directions in {-1, 0, 1}^3 with that many coordinates that are not 0: 6 axes, 12 diagonals of
// the faces of a cube, 8 of its space.
void add_directions(Normals& normals, int nonzero) {
  for (const int x : {-1, 0, 1}) {
    for (const int y : {-1, 0, 1}) {
      for (const int z : {-1, 0, 1}) {
        if (x * x + y * y + z * z != nonzero) continue;
        normals.emplace_back(Rational(x), Rational(y), Rational(z));
      }
    }
  }
}

Normals directions_of(std::initializer_list<int> kinds) {
  Normals normals;
  for (const int nonzero : kinds) add_directions(normals, nonzero);
  return normals;
}

}  // namespace

Normals propose_aabb(const HullToFit&, std::size_t, std::uint64_t) { return directions_of({1}); }
Normals propose_kdop14(const HullToFit&, std::size_t, std::uint64_t) {
  return directions_of({1, 3});
}
Normals propose_kdop18(const HullToFit&, std::size_t, std::uint64_t) {
  return directions_of({1, 2});
}
Normals propose_kdop26(const HullToFit&, std::size_t, std::uint64_t) {
  return directions_of({1, 2, 3});
}

}  // namespace convexact
