# SPDX-License-Identifier: MIT
"""What the shapes of the vectors are made of: exact fractions, each shape with its flags, its level and,
where there is one, the closed form of its volume.

Written anew here and not taken from convexact's own families, so that a mistake there cannot hide.
"""
from dataclasses import dataclass, field
from fractions import Fraction as F
from itertools import permutations, product
from math import sqrt

from circle import circle_point
from exact_geometry import determinant


@dataclass
class Shape:
    name: str
    title: str
    points: list
    flags: list
    level: int = 1
    faces: int = 0  # of the simplification that is asked for; 0: none is
    volume: F = None  # by the closed form
    facets: int = None
    why: str = ""  # the closed form in a sentence
    vertices: int = None  # set where the points are too many for the definition
    costs: list = field(default=None)  # of the removals, by a closed form
    cost_why: str = ""


class Draw:
    """A generator that is the same everywhere (Knuth's MMIX constants)."""

    def __init__(self, seed):
        self.state = seed * 2862933555777941757 + 3037000493 & 2**64 - 1

    def below(self, n):
        self.state = self.state * 6364136223846793005 + 1442695040888963407 & 2**64 - 1
        return (self.state >> 33) % n

    def integer(self, most):
        return self.below(2 * most + 1) - most


def exact(points):
    """Numbers (integers, floats or fractions) as fractions that are doubles."""
    result = [tuple(F(x) for x in p) for p in points]
    for p in result:
        assert all(F(float(x)) == x for x in p), f"{p} is no point of doubles"
    return result


def rounded(points):
    """Fractions to their nearest doubles."""
    return [tuple(F(float(F(x))) for x in p) for p in points]


def signs(p):
    """All distinct sign changes."""
    return sorted(set(product(*({x, -x} for x in p))))


def cyclic(p):
    return [p, (p[1], p[2], p[0]), (p[2], p[0], p[1])]


def all_images(p):
    """All permutations and sign changes, distinct."""
    return sorted({q for r in permutations(p) for q in signs(r)})


def cyclic_images(p):
    return sorted({q for r in cyclic(p) for q in signs(r)})


def shifted(points, by):
    return [tuple(x + F(b) for x, b in zip(p, by)) for p in points]


def stretched(points, by):
    return [tuple(x * F(b) for x, b in zip(p, by)) for p in points]


def box(a, b, c):
    return list(product((0, a), (0, b), (0, c)))


def parabola(n):
    """2n + 1 points (t, t^2), the corners of a convex polygon of area (4 n^3 - n) / 3."""
    return [(t, t * t) for t in range(-n, n + 1)]


def parabola_area(n):
    return F(4 * n**3 - n, 3)


def prism_over(polygon, height):
    return [(x, y, z) for x, y in polygon for z in (0, height)]


def sphere_points(square, keep=lambda index: True):
    r = int(sqrt(square)) + 1
    found = [p for p in product(range(-r, r + 1), repeat=3) if sum(x * x for x in p) == square]
    return [p for index, p in enumerate(found) if keep(index)]


def random_lattice(seed, count, most):
    draw = Draw(seed)
    return [tuple(draw.integer(most) for _ in range(3)) for _ in range(count)]


def random_ball(seed, count, bits=52):
    """Multiples of 2^-bits in the unit ball."""
    draw, found = Draw(seed), []
    while len(found) < count:
        p = tuple(F(draw.below(2**31) * 2**31 + draw.below(2**31) - 2**61, 2**61) for _ in range(3))
        p = tuple(F(round(x * 2**bits), 2**bits) for x in p)
        if sum(x * x for x in p) <= 1:
            found.append(p)
    return found


def zonotope(generators):
    """All sums of subsets."""
    points = {(0, 0, 0)}
    for g in generators:
        points |= {tuple(a + b for a, b in zip(p, g)) for p in points}
    return sorted(points)


def zonotope_volume(generators):
    n = len(generators)
    return sum(
        abs(determinant(generators[i], generators[j], generators[k]))
        for i in range(n)
        for j in range(i)
        for k in range(j)
    )


def rounded_box(half, radius, steps):
    """The nearest doubles to a box plus an octant grid of a sphere at each corner."""
    octant = []
    for i in range(steps + 1):
        latitude = circle_point(i, 4 * steps)
        for j in range(steps + 1 if i < steps else 1):
            longitude = circle_point(j, 4 * steps)
            octant.append((latitude[0] * longitude[0], latitude[0] * longitude[1], latitude[1]))
    points = set()
    for p in octant:
        for sign in product((1, -1), repeat=3):
            points.add(tuple(F(s * float(h + radius * F(x))) for s, h, x in zip(sign, half, p)))
    return sorted(points)


def nudged(points, which, axis, ulps):
    """One coordinate moved by so many units in its last place."""
    import math

    result = [list(p) for p in points]
    x = float(result[which][axis])
    for _ in range(abs(ulps)):
        x = math.nextafter(x, math.inf if ulps > 0 else -math.inf)
    result[which][axis] = F(x)
    return [tuple(p) for p in result]


def simplex(a, b, c):
    return [(0, 0, 0), (a, 0, 0), (a, b, 0), (a, b, c)]
