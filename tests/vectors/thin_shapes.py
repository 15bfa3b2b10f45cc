# SPDX-License-Identifier: MIT
"""Needles, slabs, and shapes far from the origin."""
from fractions import Fraction as F

from shapes import (
    Shape,
    cyclic_images,
    exact,
    prism_over,
    random_ball,
    random_lattice,
    rounded,
    shifted,
    simplex,
    stretched,
)


def thin():
    """Needles and slabs: lengths that differ by 1e3 to 1e300."""
    for name, a, level in (
        ("1e3", 1000, 2),
        ("1e8", 10**8, 2),
        ("2-52", 2**52, 3),
        ("1e16", 10**16, 3),
        ("1e100", F(float(10**100)), 3),
    ):
        a = F(a)
        yield Shape(
            f"needle-simplex-{name}",
            f"Simplex of legs {name}, 2, 3",
            simplex(a, 2, 3),
            ["needle"],
            level,
            4,
            a,
            4,
            "a * 2 * 3/6",
        )
        yield Shape(
            f"slab-simplex-{name}",
            f"Simplex of legs 5, {name}, {name}",
            simplex(5, a, a),
            ["slab"],
            level,
            4,
            5 * a * a / 6,
            4,
            "5 * a * a/6",
        )
    for name, a, level in (("1e5", 10**5, 2), ("2-40", 2**40, 2), ("2-200", 2**200, 3), ("2-900", 2**900, 3)):
        hexagon = [(2, 0), (1, 3), (-1, 3), (-2, 0), (-1, -3), (1, -3)]
        yield Shape(
            f"needle-prism-{name}",
            f"Prism of height {name} over a hexagon",
            prism_over(hexagon, a),
            ["needle", "parallel-edges"],
            level,
            6,
            F(18) * a,
            8,
            "the hexagon's area 18 times the height",
        )
        octagon = [(3, 1), (1, 3), (-1, 3), (-3, 1), (-3, -1), (-1, -3), (1, -3), (3, -1)]
        yield Shape(
            f"slab-octagon-{name}",
            f"Octagonal frustum of height 1 and width {name}",
            [(a * x, a * y, 0) for x, y in octagon] + [(a * x / F(2), a * y / F(2), 1) for x, y in octagon],
            ["slab", "coplanar"],
            level,
            6,
            F(28) * a * a * F(7, 12),
            10,
            "height/3 (A + A/2 + A/4) with A = 28 a^2",
        )
    for seed, power, level in ((11, 20, 2), (12, 60, 3), (13, 300, 3), (14, 900, 3)):
        points = random_lattice(seed, 12, 50)
        yield Shape(
            f"needle-random-2-{power}",
            f"Random integer points stretched by 2^{power} along x",
            stretched(points, (2**power, 1, 1)),
            ["needle"],
            level,
            8,
        )
        points = random_lattice(seed + 10, 12, 50)
        yield Shape(
            f"slab-random-2-{power}",
            f"Random integer points flattened by 2^-{power} along z",
            stretched(points, (1, 1, F(1, 2**power))),
            ["slab"],
            level,
            8,
        )
    yield Shape(
        "needle-oblique",
        "Needle along (1, 2, 3) of length 1e10 and width 1",
        exact(
            [
                (0, 0, 0),
                (1, 0, 0),
                (0, 1, 0),
                (10**10, 2 * 10**10, 3 * 10**10),
                (10**10 + 1, 2 * 10**10, 3 * 10**10),
                (10**10, 2 * 10**10 + 1, 3 * 10**10),
            ]
        ),
        ["needle", "parallel-edges"],
        3,
        4,
    )
    yield Shape(
        "slab-oblique",
        "Slab across (1, 1, 1), 1 thick and 1e9 wide",
        exact(
            [
                (10**9, -(10**9), 0),
                (0, 10**9, -(10**9)),
                (-(10**9), 0, 10**9),
                (10**9 + 1, -(10**9), 0),
                (0, 10**9 + 1, -(10**9)),
                (-(10**9), 1, 10**9),
            ]
        ),
        ["slab"],
        3,
        4,
    )


def far():
    for seed, power, level in ((31, 20, 2), (32, 30, 2), (33, 40, 2), (34, 50, 3), (35, 52, 3)):
        away = (2**power, -(2**power), 2**power - 1)
        yield Shape(
            f"offset-lattice-2-{power}",
            f"Random integer points, 2^{power} from the origin",
            shifted(exact(random_lattice(seed, 14, 7)), away),
            ["offset"],
            level,
            6,
        )
    for seed, distance, level in ((41, 10**6, 2), (42, 10**8, 2), (43, 10**12, 3), (44, 10**15, 3)):
        points = rounded(shifted(random_ball(seed, 14), (distance, 3 * distance, -2 * distance)))
        yield Shape(
            f"offset-ball-{len(str(distance)) - 1}",
            f"Random points of the unit ball, rounded at a distance of 10^{len(str(distance)) - 1}",
            points,
            ["offset", "lattice" if distance == 10**15 else "near-coplanar"],
            level,
            6,
        )
    yield Shape(
        "offset-one-axis",
        "Octahedron with one long way to the origin",
        [(2**40 + x, 3 * y, 5 * z) for x, y, z in cyclic_images((1, 0, 0))],
        ["offset", "ties"],
        2,
        4,
        F(4, 3) * 15,
        8,
        "4/3 a b c with half-axes 1, 3, 5",
    )
