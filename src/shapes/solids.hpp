// SPDX-License-Identifier: MIT
// solids.hpp - the five regular solids.
#pragma once
#include <vector>

#include "convexact/point_set.hpp"

namespace convexact::shapes {

/// Edges sqrt(8); exactly regular. 4 vertices, 4 facets.
[[nodiscard]] std::vector<Point> tetrahedron();
/// [-1, 1]^3; exactly regular. 8 vertices, 6 facets.
[[nodiscard]] std::vector<Point> cube();
/// Edges sqrt(2); exactly regular. 6 vertices, 8 facets.
[[nodiscard]] std::vector<Point> octahedron();
/// In doubles, so regular up to 2^-25, but its pentagons are exactly plane and it has exactly the
/// symmetries of a pyritohedron (sign changes and cyclic shifts). 20 vertices, 12 facets.
[[nodiscard]] std::vector<Point> dodecahedron();
/// The nearest doubles to a regular dodecahedron: 20 vertices whose pentagons are not quite plane,
/// so they break into triangles that one ulp decides.
[[nodiscard]] std::vector<Point> rounded_dodecahedron();
/// The nearest doubles to a regular icosahedron with edges 2, exactly symmetric under sign changes
/// and cyclic shifts. 12 vertices, 20 facets.
[[nodiscard]] std::vector<Point> icosahedron();

}  // namespace convexact::shapes
