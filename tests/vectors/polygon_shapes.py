# SPDX-License-Identifier: MIT
"""Prisms, antiprisms, pyramids and frusta over polygons."""
from fractions import Fraction as F

from circle import circle_point
from shapes import Shape, parabola, parabola_area, prism_over


def over_polygons():
    for n in (1, 2, 3, 4, 6, 9):
        polygon, area, k = parabola(n), parabola_area(n), 2 * n + 1
        height = n + 1
        yield Shape(
            f"prism-parabola-{k}",
            f"Prism over {k} points of a parabola",
            prism_over(polygon, height),
            ["parallel-edges", "coplanar"] + (["unbounded"] if n == 1 else []),
            1,
            max(5, n),
            area * height,
            k + 2,
            f"the polygon's area (4 n^3 - n)/3 = {area} with n = {n}, times the height {height}",
        )
        apex = (0, n * n - F(1, 2) if n == 1 else n * n - 1, 3 * n + 1)
        yield Shape(
            f"pyramid-parabola-{k}",
            f"Pyramid over {k} points of a parabola",
            [(x, y, 0) for x, y in polygon] + [apex],
            ["valence", "coplanar"],
            1 if n < 6 else 2,
            max(4, n),
            area * (3 * n + 1) / 3,
            k + 1,
            f"the polygon's area {area} times a third of the height {3 * n + 1}",
        )
        if n > 1:
            inner = (1, n * n // 2 + 1)
            yield Shape(
                f"bipyramid-parabola-{k}",
                f"Bipyramid over {k} points of a parabola",
                [(x, y, 0) for x, y in polygon] + [(*inner, 2 * n), (*inner, -n)],
                ["valence"],
                2,
                2 * n,
                area * n,
                2 * k,
                f"the polygon's area {area} times a third of the heights {2 * n} + {n}",
            )
    for k in (5, 8, 12):
        polygon = [circle_point(i, k) for i in range(k)]
        yield Shape(
            f"prism-circle-{k}",
            f"Prism over a regular {k}-gon in nearest doubles",
            prism_over(polygon, 1),
            ["parallel-edges", "ties" if k != 5 else "coplanar"],
            1,
            k // 2 + 2,
            facets=k + 2,
            why="two polygons and a rectangle per side",
        )
        yield Shape(
            f"antiprism-circle-{k}",
            f"Antiprism over a regular {k}-gon in nearest doubles",
            [(c, s, -1) for c, s in polygon] + [(*circle_point(2 * i + 1, 2 * k), 1) for i in range(k)],
            ["ties", "coplanar"],
            2,
            k + 1,
            facets=2 * k + 2,
            why="two polygons and two triangles per side",
        )
    yield Shape(
        "pyramid-circle-24",
        "Pyramid over a regular 24-gon in nearest doubles: costs tie in mirror images, almost",
        [(*circle_point(i, 24), 0) for i in range(24)] + [(0, 0, 2)],
        ["valence", "ties"],
        2,
        8,
        facets=25,
        why="a base and a triangle per side",
    )
    yield Shape(
        "cone-32",
        "Pyramid over a 32-gon with points on its edges",
        [(*(F(r) * x for x in circle_point(i, 32)), 2 - 2 * r) for i in range(32) for r in (1, 0.5)] + [(0, 0, 2)],
        ["valence", "coplanar"],
        2,
        12,
        facets=33,
        why="a base and a triangle per side; the inner rings lie on edges",
    )
    yield Shape(
        "pyramid-parabola-201",
        "Pyramid of 201 sides: more than half of what one byte counts",
        [(x, y, 0) for x, y in parabola(100)] + [(0, 5000, 700)],
        ["valence", "coplanar"],
        3,
        0,
        parabola_area(100) * 700 / 3,
        202,
        vertices=202,
        why="the polygon's area (4 n^3 - n)/3 with n = 100 times a third of the height 700",
    )
    yield Shape(
        "prism-parabola-301",
        "Prism with two facets of 301 corners: more than one byte counts",
        prism_over(parabola(150), 20000),
        ["parallel-edges", "valence", "coplanar"],
        3,
        0,
        parabola_area(150) * 20000,
        303,
        vertices=602,
        why="the polygon's area (4 n^3 - n)/3 with n = 150 times the height 20000",
    )
    hexagon = [(2, 0), (1, 2), (-1, 2), (-2, 0), (-1, -2), (1, -2)]
    yield Shape(
        "hexagonal-prism",
        "Prism over a hexagon",
        prism_over(hexagon, 7),
        ["parallel-edges", "ties"],
        1,
        6,
        F(84),
        8,
        "the hexagon's area 12 times the height 7",
    )
    yield Shape(
        "hexagonal-frustum",
        "Frustum over a hexagon",
        [(3 * x, 3 * y, 0) for x, y in hexagon] + [(x, y, 4) for x, y in hexagon],
        ["coplanar", "ties"],
        1,
        6,
        F(12 * 4 * (9 + 3 + 1), 3),
        8,
        "height/3 (A + sqrt(A B) + B) with A = 9 * 12 and B = 12",
    )
    yield Shape(
        "sheared-prism",
        "Oblique prism over a hexagon",
        [(x, y, 0) for x, y in hexagon] + [(x + 5, y - 3, 4) for x, y in hexagon],
        ["parallel-edges", "coplanar"],
        1,
        6,
        F(48),
        8,
        "shears keep the volume: area 12 times height 4",
    )
    yield Shape(
        "wedge",
        "Wedge: a roof of which one edge is parallel to the base",
        [(0, 0, 0), (6, 0, 0), (6, 4, 0), (0, 4, 0), (2, 2, 3), (3, 2, 3)],
        ["parallel-edges"],
        1,
        4,
        F(26),
        5,
        "height * width (2 * base edge + roof edge)/6 = 3 * 4 * 13/6",
    )
    yield Shape(
        "integer-antiprism",
        "Antiprism over a square",
        [(2, 0, 0), (0, 2, 0), (-2, 0, 0), (0, -2, 0), (1, 1, 3), (-1, 1, 3), (-1, -1, 3), (1, -1, 3)],
        ["ties", "coplanar"],
        1,
        6,
        facets=10,
        why="two squares and eight triangles",
    )
