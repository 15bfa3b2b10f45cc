# SPDX-License-Identifier: MIT
"""Integer points: lattices, spheres, the moment curve."""
from fractions import Fraction as F
from itertools import product

from shapes import Shape, random_lattice, sphere_points


def lattices():
    for square in (5, 6, 8, 11):
        r = 4
        yield Shape(
            f"lattice-ball-{square}",
            f"All integer points with x^2 + y^2 + z^2 <= {square}",
            [p for p in product(range(-r, r + 1), repeat=3) if sum(x * x for x in p) <= square],
            ["lattice", "coplanar", "ties"],
            2,
            8,
        )
    for seed, count, most in ((1, 12, 2), (2, 20, 2), (3, 30, 3), (4, 14, 5), (5, 16, 9), (6, 24, 4), (7, 40, 3)):
        yield Shape(
            f"lattice-random-{seed}",
            f"{count} random integer points of [-{most}, {most}]^3",
            random_lattice(seed, count, most),
            ["lattice", "coplanar"],
            2,
            6,
        )
    for n in (2, 3):
        points = [p for p in product(range(n + 1), repeat=3) if sum(p) <= n + 1]
        yield Shape(
            f"lattice-corner-{n}",
            f"Integer points of the cube [0, {n}]^3 with x + y + z <= {n + 1}",
            points,
            ["lattice", "coplanar"],
            2,
            4,
        )
    yield Shape(
        "lattice-simplex-6",
        "All integer points of the simplex x, y, z >= 0, x + 2 y + 3 z <= 6",
        [p for p in product(range(7), repeat=3) if p[0] + 2 * p[1] + 3 * p[2] <= 6],
        ["lattice", "coplanar", "unbounded"],
        2,
        4,
        F(6),
        4,
        "legs 6, 3, 2: 36/6",
        costs=[],
        cost_why="a simplex has four sides",
    )


def spheres():
    for square in (9, 14, 17, 21, 26, 29, 41):
        points = sphere_points(square)
        yield Shape(
            f"sphere-{square}",
            f"All {len(points)} integer points with x^2 + y^2 + z^2 = {square}",
            points,
            ["cospherical", "lattice", "ties", "coplanar"],
            2,
            8 if square in (9, 14, 17, 21) else 0,
        )
    for square, modulus in ((26, 3), (29, 4), (54, 5), (89, 7), (101, 11)):
        points = sphere_points(square, lambda index, m=modulus: index % m == 1)
        yield Shape(
            f"sphere-{square}-part",
            f"{len(points)} integer points with x^2 + y^2 + z^2 = {square}, no symmetry left",
            points,
            ["cospherical", "lattice"],
            2,
            10,
        )
    for count in (6, 9, 12, 16, 20):
        points = [(t, t * t, t**3) for t in range(-(count // 2), count - count // 2)]
        yield Shape(
            f"moment-curve-{count}",
            f"{count} points (t, t^2, t^3): a cyclic polytope",
            points,
            ["valence", "lattice"],
            2,
            4 + count // 3,
            facets=2 * count - 4,
            why="2n - 4 triangles, by Gale's evenness",
        )
