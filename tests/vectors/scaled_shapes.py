# SPDX-License-Identifier: MIT
"""Very large, very small and very different coordinates."""
from fractions import Fraction as F

from shapes import Draw, Shape, box, cyclic_images, exact, random_lattice, simplex, stretched


def scaled():
    for seed, power, level in (
        (51, 100, 2),
        (52, -100, 2),
        (53, 300, 3),
        (54, -300, 3),
        (55, 600, 3),
        (56, -600, 3),
        (57, 1000, 3),
        (58, -1000, 3),
    ):
        points = stretched(exact(random_lattice(seed, 13, 20)), [F(2) ** power] * 3)
        yield Shape(
            f"scale-2^{power}".replace("^", "-to-"),
            f"Random integer points times 2^{power}",
            points,
            ["scale"],
            level,
            6,
        )
    for name, a, b, c, level in (
        ("1e150", 1e150, 3e150, 2e150, 3),
        ("1e-150", 1e-150, 5e-150, 2e-150, 3),
        ("1e300", 1e300, 1e300, 7e299, 3),
        ("1e-300", 3e-300, 1e-300, 1e-300, 3),
    ):
        a, b, c = F(a), F(b), F(c)
        yield Shape(
            f"scale-simplex-{name}",
            f"Simplex with legs near {name}, whose volume no double holds",
            simplex(a, b, c),
            ["scale"],
            level,
            4,
            a * b * c / 6,
            4,
            "a b c/6 of the legs as doubles",
        )
    least = F(1, 2**1074)
    for seed, most in ((61, 2), (62, 5), (63, 9), (64, 50), (65, 1000), (66, 2**30)):
        points = stretched(exact(random_lattice(seed, 12, most)), [least] * 3)
        yield Shape(
            f"subnormal-{seed}",
            f"Random multiples up to {most} of the least positive double",
            points,
            ["subnormal", "scale"],
            3,
            6,
        )
    yield Shape(
        "subnormal-simplex",
        "Simplex with legs 1, 2 and 5 times the least positive double",
        stretched(simplex(1, 2, 5), [least] * 3),
        ["subnormal", "scale"],
        3,
        4,
        F(10, 6) * least**3,
        4,
        "a b c/6",
    )
    yield Shape(
        "subnormal-slab",
        "Box 1 x 3 and as thick as the least positive double",
        box(1, 3, least),
        ["subnormal", "slab", "mixed", "parallel-edges"],
        3,
        4,
        3 * least,
        6,
        "a b c",
        costs=[],
        cost_why="no side of a box can go",
    )
    yield Shape(
        "subnormal-edge",
        "Wedge whose roof edge is the least positive double wide",
        [(0, 0, 0), (7, 0, 0), (7, 4, 0), (0, 4, 0), (2, 2, 3), (2 + F(0), 2, 3), (0, 2, least)],
        ["subnormal", "mixed"],
        3,
        4,
    )
    yield Shape(
        "subnormal-to-normal",
        "Octahedron across the border of subnormal numbers",
        stretched(exact(cyclic_images((1, 0, 0)) + [(1, 1, 1)]), [F(1, 2**1022)] * 3),
        ["subnormal", "scale"],
        3,
        6,
    )


def mixed():
    for name, a, b, c in (
        ("500", F(2) ** 500, F(1), F(1, 2**500)),
        ("1000", F(2) ** 1000, F(1), F(1, 2**1000)),
        ("300", F(1e300), F(1e-300), F(1)),
        ("30", F(1e30), F(1e-20), F(1e5)),
    ):
        yield Shape(
            f"mixed-simplex-{name}",
            f"Simplex with legs of very different magnitude ({name})",
            simplex(a, b, c),
            ["mixed", "needle"],
            3,
            4,
            a * b * c / 6,
            4,
            "a b c/6 of the legs as doubles",
        )
        yield Shape(
            f"mixed-octahedron-{name}",
            f"Octahedron with half-axes of very different magnitude ({name})",
            [
                tuple(F(s) * l * e for l, e in zip((a, b, c), axis))
                for axis in ((1, 0, 0), (0, 1, 0), (0, 0, 1))
                for s in (1, -1)
            ],
            ["mixed", "ties"],
            3,
            4,
            F(4, 3) * a * b * c,
            8,
            "4/3 a b c of the half-axes as doubles",
            costs=[a * b * c / 3] * 4,
            cost_why="each removed face gains a tetrahedron of a b c/3",
        )
    for seed, most in ((71, 30), (72, 100), (73, 300), (74, 900)):
        draw, points = Draw(seed), []
        for p in random_lattice(seed, 11, 9):
            points.append(tuple(F(x) * F(2) ** draw.integer(most) for x in p))
        yield Shape(
            f"mixed-random-2-{most}",
            f"Random integers, each times its own power of two up to 2^{most}",
            points,
            ["mixed"],
            3,
            6,
        )
    yield Shape(
        "mixed-corner",
        "A cube with one corner cut at depth 2^-60",
        [p for p in exact(box(1, 1, 1)) if p != (0, 0, 0)]
        + [(F(1, 2**60), 0, 0), (0, F(1, 2**60), 0), (0, 0, F(1, 2**60))],
        ["mixed", "parallel-edges", "unbounded"],
        3,
        4,
        1 - F(1, 6 * 2**180),
        7,
        "1 minus 2^-180/6",
        costs=[F(1, 6 * 2**180)],
        cost_why="the cut gives back 2^-180/6; then no side of a box can go",
    )
