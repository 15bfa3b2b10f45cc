# SPDX-License-Identifier: MIT
"""Repeated points, and points an ulp off a plane."""
from fractions import Fraction as F

from circle import circle_point
from shapes import (
    Draw,
    Shape,
    all_images,
    box,
    cyclic_images,
    exact,
    nudged,
    parabola,
    parabola_area,
    prism_over,
    random_ball,
    random_lattice,
    rounded,
    simplex,
)


def repeated():
    cuboid = box(2, 3, 4)
    yield Shape(
        "duplicates-brick",
        "Every corner of a box three times",
        [p for p in cuboid for _ in range(3)],
        ["duplicates", "parallel-edges"],
        1,
        4,
        F(24),
        6,
        "2 * 3 * 4",
        costs=[],
        cost_why="no side of a box can go",
    )
    yield Shape(
        "duplicates-simplex",
        "A simplex of which one corner comes forty times",
        simplex(3, 5, 7) + [(3, 5, 7)] * 39,
        ["duplicates"],
        1,
        4,
        F(105, 6),
        4,
        "3 * 5 * 7/6",
        costs=[],
        cost_why="a simplex has four sides",
    )
    yield Shape(
        "duplicates-interior",
        "An octahedron with its centre thirty times",
        exact(cyclic_images((3, 0, 0)) + [(0, 0, 0)] * 30),
        ["duplicates", "ties"],
        1,
        4,
        F(36),
        8,
        "4/3 * 3^3",
        costs=[F(9)] * 4,
        cost_why="each removed face gains a tetrahedron of 3^3/3",
    )
    for seed, count, most in ((81, 10, 4), (82, 12, 6), (83, 8, 30), (84, 14, 3)):
        points = random_lattice(seed, count, most)
        yield Shape(
            f"duplicates-random-{seed}",
            f"{count} random integer points, each twice, in two orders",
            points + points[::-1],
            ["duplicates", "lattice"],
            2,
            5,
        )
    ball = random_ball(85, 9)
    yield Shape(
        "duplicates-ball",
        "Random points of a ball, the first of them seven times",
        ball + [ball[0]] * 6,
        ["duplicates"],
        2,
        6,
    )
    yield Shape(
        "duplicates-edge",
        "A tetrahedron with doubled points in the middle of every edge",
        [(8, 8, 8), (8, -8, -8), (-8, 8, -8), (-8, -8, 8)] + 2 * all_images((8, 0, 0)),
        ["duplicates", "coplanar"],
        1,
        4,
        F(8**3 * 8, 3),
        4,
        "a cube of side 16 minus four corners: a third of it",
        costs=[],
        cost_why="a simplex has four sides",
    )
    prism = prism_over(parabola(2), 5)
    yield Shape(
        "duplicates-prism",
        "A prism twice, and once more shifted inside itself",
        prism + prism + [(0, 1, 1), (0, 1, 1), (0, 2, 2), (0, 2, 2)],
        ["duplicates", "parallel-edges"],
        1,
        6,
        parabola_area(2) * 5,
        7,
        "the polygon's area 10 times the height 5",
    )


def nearly():
    cube = exact(box(1, 1, 1))
    top = [i for i, p in enumerate(cube) if p == (1, 1, 1)][0]
    for ulps in (1, -1, 3, -1000):
        yield Shape(
            f"near-cube-{'up' if ulps > 0 else 'down'}-{abs(ulps)}",
            f"A cube of which one corner is {abs(ulps)} ulp{'s' if abs(ulps) > 1 else ''} {'above' if ulps > 0 else 'below'} its side",
            nudged(cube, top, 2, ulps),
            ["near-coplanar"],
            2,
            6,
        )
    for seed, ulps in ((91, 1), (92, 2), (93, 5)):
        draw = Draw(seed)
        lid = [
            (F(draw.below(1000), 1024), F(draw.below(1000), 1024), 1 + F(draw.below(ulps + 1), 2**52))
            for _ in range(10)
        ]
        yield Shape(
            f"near-lid-{ulps}",
            f"A pyramid under ten points that are within {ulps} ulp{'s' if ulps > 1 else ''} of a plane",
            lid + [(F(1, 2), F(1, 2), F(0))],
            ["near-coplanar", "valence"],
            3,
            5,
        )
    for k, ulps in ((6, 1), (9, 1), (12, 2)):
        polygon = [circle_point(i, k) for i in range(k)]
        points = exact([(c, s, 1) for c, s in polygon] + [(2 * c, 2 * s, 0) for c, s in polygon])
        for i in range(0, k, 2):
            points = nudged(points, i, 2, ulps)
        yield Shape(
            f"near-frustum-{k}",
            f"Frustum over a {k}-gon, every second upper corner {ulps} ulp{'s' if ulps > 1 else ''} too high",
            points,
            ["near-coplanar", "ties"],
            3,
            k,
        )
    yield Shape(
        "near-collinear-edge",
        "A simplex with a point one ulp off the middle of an edge",
        nudged(exact(simplex(4, 4, 4) + [(2, 0, 0)]), 4, 1, -1),
        ["near-coplanar", "mixed"],
        3,
        4,
    )
    yield Shape(
        "near-facet-centre",
        "An octahedron with a point one ulp above the middle of a face",
        exact(cyclic_images((3, 0, 0))) + nudged(exact([(1, 1, 1)]), 0, 0, 1),
        ["near-coplanar"],
        3,
        6,
    )
    yield Shape(
        "near-thirds",
        "A plane of slope 1/3 in nearest doubles",
        rounded([(x, y, F(x + y, 3)) for x in range(4) for y in range(4)]) + [(F(1), F(1), F(-5))],
        ["near-coplanar", "lattice"],
        3,
        5,
    )
    yield Shape(
        "near-tie",
        "A cube of side 1 with two corners cut, one deeper by one ulp of 1/4",
        [p for p in cube if p not in ((0, 0, 0), (1, 1, 1))]
        + exact([(0.25, 0, 0), (0, 0.25, 0), (0, 0, 0.25)])
        + [
            (1 - F(1, 4) - F(1, 2**53), 1, 1),
            (1, 1 - F(1, 4) - F(1, 2**53), 1),
            (1, 1, 1 - F(1, 4) - F(1, 2**53)),
        ],
        ["near-coplanar", "parallel-edges", "unbounded"],
        3,
        4,
        1 - F(1, 384) - (F(1, 4) + F(1, 2**53)) ** 3 / 6,
        8,
        "1 minus d^3/6 for both depths",
        costs=[F(1, 384), (F(1, 4) + F(1, 2**53)) ** 3 / 6],
        cost_why="the cuts give back d^3/6; they differ by about 1e-17 of themselves",
    )
