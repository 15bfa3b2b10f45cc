# SPDX-License-Identifier: MIT
"""Boxes, whole, cut, chamfered and rounded."""
from fractions import Fraction as F

from shapes import Shape, box, rounded_box, signs, zonotope, zonotope_volume


def boxes():
    yield Shape(
        "brick",
        "Box of sides 3, 5, 7 with points on sides and edges and inside",
        box(3, 5, 7) + [(1, 0, 0), (2, 0, 0), (1, 1, 0), (3, 2, 4), (1, 2, 3), (0, 0, 6)],
        ["parallel-edges", "coplanar", "lattice", "unbounded"],
        1,
        4,
        F(105),
        6,
        "3 * 5 * 7",
        costs=[],
        cost_why="no side of a box can go: what is left is unbounded",
    )
    cuts = []
    for name, depths in (
        ("one", [1]),
        ("two", [1, 2]),
        ("four", [1, 2, 3, 4]),
        ("ties", [2, 2, 2, 1]),
        ("eight", [1, 2, 3, 4, 4, 3, 2, 1]),
    ):
        cuts.append((name, depths))
    for name, depths in cuts:
        side = 10
        points = []
        for corner, (x, y, z) in enumerate(box(side, side, side)):
            if corner >= len(depths):
                points.append((x, y, z))
                continue
            d = depths[corner]
            points += [
                (x + (d if x == 0 else -d), y, z),
                (x, y + (d if y == 0 else -d), z),
                (x, y, z + (d if z == 0 else -d)),
            ]
        costs = sorted(F(d**3, 6) for d in depths)
        yield Shape(
            f"cut-cube-{name}",
            f"Cube of side 10 with corners cut at depths {depths}",
            points,
            ["parallel-edges", "unbounded", "ties" if len(set(depths)) < len(depths) else "coplanar"],
            1,
            6,
            1000 - sum(costs),
            6 + len(depths),
            "10^3 minus a corner of volume d^3/6 for each depth d",
            costs=costs,
            cost_why="each cut gives back its d^3/6; the least first",
        )
    yield Shape(
        "cut-brick-uneven",
        "Box with two corners cut by unequal legs",
        [(x, y, z) for x, y, z in box(8, 9, 10) if (x, y, z) not in ((0, 0, 0), (8, 9, 10))]
        + [(3, 0, 0), (0, 2, 0), (0, 0, 5), (8 - 4, 9, 10), (8, 9 - 1, 10), (8, 9, 10 - 2)],
        ["parallel-edges", "unbounded"],
        1,
        4,
        720 - F(30 + 8, 6),
        8,
        "8 * 9 * 10 minus corners of volume 3 * 2 * 5/6 and 4 * 1 * 2/6",
        costs=[F(8, 6), F(30, 6)],
        cost_why="the cuts give back what they took; then no side of a box can go",
    )
    for half, radius, steps, level, k in (
        ((1, 2, 3), 0.5, 1, 1, 12),
        ((1, 1, 1), 0.25, 2, 2, 24),
        ((3, 2, 2), 0.75, 2, 2, 20),
    ):
        yield Shape(
            f"rounded-box-{steps}-{half[0]}{half[1]}{half[2]}",
            f"Rounded box, {steps} steps per octant, in nearest doubles",
            rounded_box(half, radius, steps),
            ["parallel-edges", "near-coplanar" if steps > 1 else "coplanar"],
            level,
            k if steps == 1 else 0,
        )
    yield Shape(
        "chamfered-brick",
        "Box with flat edges and corners",
        sorted({q for p in ((4, 5, 8), (3, 6, 8), (3, 5, 9)) for q in signs(p)}),
        ["parallel-edges", "coplanar"],
        1,
        6,
        facets=26,
        why="6 rectangles, 12 bevels, 8 triangles",
    )
    yield Shape(
        "parallelepiped",
        "Sheared box",
        zonotope([(3, 1, 0), (0, 4, 1), (2, 0, 5)]),
        ["parallel-edges", "unbounded"],
        1,
        4,
        F(zonotope_volume([(3, 1, 0), (0, 4, 1), (2, 0, 5)])),
        6,
        "the determinant of its three edges",
        costs=[],
        cost_why="no side of a parallelepiped can go",
    )
