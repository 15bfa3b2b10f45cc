# SPDX-License-Identifier: MIT
"""Regular and everyday solids, and sums of segments."""
from fractions import Fraction as F
from math import sqrt

from shapes import Shape, all_images, box, cyclic_images, random_ball, simplex, zonotope, zonotope_volume


def regular_solids():
    yield Shape(
        "tetrahedron",
        "Regular tetrahedron",
        [(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)],
        [],
        1,
        4,
        F(8, 3),
        4,
        "a cube of side 2 minus four corners of volume 4/3 each",
    )
    yield Shape(
        "cube",
        "Cube",
        box(2, 2, 2),
        ["parallel-edges", "unbounded"],
        1,
        4,
        F(8),
        6,
        "2^3",
        costs=[],
        cost_why="no side of a box can go: what is left is unbounded",
    )
    yield Shape(
        "octahedron",
        "Regular octahedron",
        cyclic_images((1, 0, 0)),
        ["ties", "valence"],
        1,
        4,
        F(4, 3),
        8,
        "two pyramids over a square of area 2, each of height 1",
        costs=[F(1, 3)] * 4,
        cost_why="each removed face gains a tetrahedron of 1/3, until a " "tetrahedron of volume 8/3 is left",
    )
    golden = (1 + sqrt(5)) / 2
    yield Shape(
        "icosahedron",
        "Regular icosahedron in nearest doubles",
        cyclic_images((0, 1, golden)),
        ["ties"],
        1,
        8,
        facets=20,
        why="20 triangles, by Euler's formula",
    )
    yield Shape(
        "rounded-dodecahedron",
        "Regular dodecahedron in nearest doubles: pentagons not quite plane",
        all_images((1, 1, 1)) + cyclic_images((0, 1 / golden, golden)),
        ["near-coplanar", "ties"],
        2,
        12,
    )
    yield Shape(
        "pyritohedron",
        "Dodecahedron with exactly plane pentagons",
        all_images((4, 4, 4)) + cyclic_images((0, 6, 3)),
        ["ties", "coplanar"],
        1,
        6,
        facets=12,
        why="a pentagon through each of the 12 roof edges of a cube",
    )
    yield Shape(
        "cuboctahedron",
        "Cuboctahedron",
        all_images((1, 1, 0)),
        ["ties", "coplanar"],
        1,
        6,
        F(20, 3),
        14,
        "a cube of side 2 minus eight corners of volume 1/6 each",
        costs=[F(1, 6)] * 8,
        cost_why="each removed triangle gives back a corner of the cube, of volume 1/6",
    )
    yield Shape(
        "truncated-octahedron",
        "Truncated octahedron",
        all_images((0, 1, 2)),
        ["ties", "coplanar", "parallel-edges"],
        1,
        8,
        F(32),
        14,
        "an octahedron of half-diagonal 3 (volume 36) minus six pyramids of volume 2/3 each",
        costs=[F(2, 3)] * 6,
        cost_why="each removed square gives back a pyramid of volume 2/3",
    )
    yield Shape(
        "truncated-tetrahedron",
        "Truncated tetrahedron",
        sorted({q for q in all_images((3, 1, 1)) if q[0] * q[1] * q[2] > 0}),
        ["ties", "coplanar"],
        1,
        4,
        F(184, 3),
        8,
        "a tetrahedron in a cube of side 6 (volume 72) minus four of a third of its edge",
        costs=[F(8, 3)] * 4,
        cost_why="each removed triangle gives back a tetrahedron of 72/27",
    )
    yield Shape(
        "truncated-cube",
        "Cube with its corners cut at depth 2 of 6",
        all_images((1, 3, 3)),
        ["ties", "coplanar"],
        1,
        6,
        F(216) - 8 * F(8, 6),
        14,
        "6^3 minus eight corners of volume 2^3/6",
        costs=[F(4, 3)] * 8,
        cost_why="each removed triangle gives back a corner of volume 2^3/6",
    )
    yield Shape(
        "rhombic-dodecahedron",
        "Rhombic dodecahedron",
        all_images((1, 1, 1)) + all_images((2, 0, 0)),
        ["ties", "valence", "parallel-edges"],
        1,
        6,
        F(16),
        12,
        "a cube of volume 8 and six pyramids over its sides, 4/3 each",
    )
    yield Shape(
        "tetrakis-cube",
        "Cube with a low pyramid on each side",
        all_images((4, 4, 4)) + all_images((5, 0, 0)),
        ["ties", "valence"],
        1,
        12,
        F(512) + 6 * F(64, 3),
        24,
        "8^3 and six pyramids of height 1 over 8 x 8",
    )
    yield Shape(
        "triakis-tetrahedron",
        "Tetrahedron with a low pyramid on each side",
        [(5, 5, 5), (5, -5, -5), (-5, 5, -5), (-5, -5, 5), (-3, -3, -3), (-3, 3, 3), (3, -3, 3), (3, 3, -3)],
        ["ties"],
        1,
        4,
        facets=12,
        why="three triangles on each of four sides",
    )
    yield Shape(
        "triakis-octahedron",
        "Octahedron with a low pyramid on each side",
        all_images((5, 0, 0)) + all_images((2, 2, 2)),
        ["ties", "valence"],
        1,
        8,
        facets=24,
        why="three triangles on each of eight sides",
    )
    yield Shape(
        "rhombicuboctahedron-like",
        "Cube, octahedron and dodecahedron cut each other",
        all_images((1, 1, 3)),
        ["ties", "coplanar", "parallel-edges"],
        1,
        6,
        facets=26,
        why="6 squares, 12 rectangles, 8 triangles",
    )
    yield Shape(
        "truncated-cuboctahedron-like",
        "48 corners, all images of (1, 3, 6)",
        all_images((1, 3, 6)),
        ["ties", "coplanar", "parallel-edges"],
        2,
        6,
        facets=26,
        why="6 octagons, 12 rectangles, 8 hexagons",
    )
    yield Shape(
        "deltoid-like",
        "Cube, octahedron and cuboctahedron of 26 corners, no two facets alike by chance",
        all_images((6, 0, 0)) + all_images((4, 4, 0)) + all_images((3, 3, 3)),
        ["ties", "valence"],
        2,
        8,
    )
    for a, b in ((1, 2), (3, 5), (8, 13)):
        yield Shape(
            f"pseudo-icosahedron-{a}-{b}",
            f"Icosahedron of the points (0, {a}, {b})",
            cyclic_images((0, a, b)),
            ["ties"],
            1,
            6,
            facets=20,
            why="20 triangles, by Euler's formula",
        )
    yield Shape(
        "stella-octangula",
        "Two tetrahedra and the eight points between, on the edges of a cube",
        all_images((2, 2, 2)) + all_images((2, 2, 0)) + all_images((2, 0, 0)) + [(0, 0, 0)],
        ["coplanar", "lattice", "duplicates"],
        2,
        4,
        F(64),
        6,
        "4^3: the other points lie on edges and sides",
        costs=[],
        cost_why="no side of a box can go: what is left is unbounded",
    )


def everyday():
    """Random solids of ordinary proportions."""
    for seed, count in ((101, 8), (102, 10), (103, 12), (104, 14), (105, 16), (106, 18)):
        yield Shape(
            f"random-ball-{count}", f"{count} random points of the unit ball", random_ball(seed, count), [], 1, 6
        )
    for a, b, c in ((1, 2, 3), (2, 3, 7)):
        yield Shape(
            f"cross-polytope-{a}{b}{c}",
            f"Octahedron with half-axes {a}, {b}, {c}",
            [
                tuple(s * l * e for l, e in zip((a, b, c), axis))
                for axis in ((1, 0, 0), (0, 1, 0), (0, 0, 1))
                for s in (1, -1)
            ],
            ["ties"],
            1,
            4,
            F(4 * a * b * c, 3),
            8,
            "4/3 a b c",
            costs=[F(a * b * c, 3)] * 4,
            cost_why="each removed face gains a tetrahedron of a b c/3",
        )
    yield Shape(
        "cross-polytope-uneven",
        "Cross-polytope whose six arms have lengths 1 to 6",
        [(1, 0, 0), (-2, 0, 0), (0, 3, 0), (0, -4, 0), (0, 0, 5), (0, 0, -6)],
        [],
        1,
        4,
        F(3 * 7 * 11, 6),
        8,
        "(1 + 2)(3 + 4)(5 + 6)/6",
    )
    yield Shape(
        "simplex-235",
        "Simplex with legs 2, 3, 5",
        simplex(2, 3, 5),
        [],
        1,
        4,
        F(5),
        4,
        "2 * 3 * 5/6",
        costs=[],
        cost_why="a simplex has four sides",
    )
    yield Shape(
        "gem",
        "A cut gem: table, crown and pavilion",
        [(3 * c, 3 * s, 0) for c, s in ((1, 0), (0, 1), (-1, 0), (0, -1))]
        + [(1, 1, 1), (-1, 1, 1), (-1, -1, 1), (1, -1, 1), (0, 0, -4)],
        ["ties"],
        1,
        6,
    )
    yield Shape(
        "house",
        "A box with a roof",
        box(4, 6, 3) + [(2, 1, 5), (2, 5, 5)],
        ["coplanar"],
        1,
        5,
        facets=9,
        why="five sides of the box and four of the hipped roof",
    )


def zonotopes():
    sets = {
        "four": [(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1)],
        "five": [(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 2, 0), (0, 1, 3)],
        "six-of-a-cube": [(1, 1, 0), (1, -1, 0), (1, 0, 1), (1, 0, -1), (0, 1, 1), (0, 1, -1)],
        "generic-four": [(5, 1, 2), (-1, 7, 3), (2, -2, 9), (4, 4, -3)],
        "generic-five": [(5, 0, 2), (-1, 6, 3), (1, -2, 8), (4, 3, -3), (-2, 3, 5)],
    }
    for name, generators in sets.items():
        yield Shape(
            f"zonotope-{name}",
            f"Sum of {len(generators)} segments",
            zonotope(generators),
            ["parallel-edges", "lattice", "ties"],
            1 if len(generators) < 5 else 2,
            6,
            F(zonotope_volume(generators)),
            why="the sum of |det| over all triples of segments",
        )
