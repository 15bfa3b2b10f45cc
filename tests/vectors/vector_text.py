# SPDX-License-Identifier: MIT
"""Numbers as the vectors spell them, and the normal form by which variants are found."""
from fractions import Fraction as F
from itertools import permutations, product
from math import gcd

from exact_geometry import as_integers


def power_of_two(n):
    """n as odd * 2^e."""
    e = (n & -n).bit_length() - 1
    return n >> e, e


def exact_text(x):
    """p/q, with long powers of two apart: 5/3*2^-3222."""
    x = F(x)
    if x == 0:
        return "0"
    p, up = power_of_two(abs(x.numerator))
    q, down = power_of_two(x.denominator)
    if abs(up - down) <= 64:
        return str(x)
    sign = "-" if x < 0 else ""
    return f"{sign}{p}{'' if q == 1 else f'/{q}'}*2^{up - down}"


def coordinate(x):
    """A double: an integer or a short decimal as a JSON number, anything else as a hexadecimal float."""
    if x.denominator == 1 and abs(x) <= 2**53:
        return int(x)
    if x.denominator <= 2**10 and abs(x.numerator) < 2**20:
        return float(x)
    return float(x).hex()


def coordinates(points):
    return [[coordinate(x) for x in p] for p in points]


def rows_text(rows):
    return [[exact_text(x) for x in row] for row in rows]


def normal_form(points, others=()):
    """Equal for point sets that differ by order, translation, scaling and the symmetries of the axes:
    the least of the 48 images, moved to the origin's corner and without common divisor. `others` (the
    points of a candidate) are moved along."""
    integers, _ = as_integers([*points, *others])
    best = None
    for order in permutations(range(3)):
        for sign in product((1, -1), repeat=3):
            image = [tuple(s * p[k] for s, k in zip(sign, order)) for p in integers]
            low = [min((p[k] for p in image), default=0) for k in range(3)]
            image = [tuple(p[k] - low[k] for k in range(3)) for p in image]
            form = (sorted(image[: len(points)]), sorted(image[len(points) :]))
            if best is None or form < best:
                best = form
    divisor = gcd(*(x for part in best for p in part for x in p)) or 1
    return tuple(tuple(tuple(x // divisor for x in p) for p in part) for part in best)
