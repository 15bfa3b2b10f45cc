# SPDX-License-Identifier: MIT
"""Points of the unit circle in nearest doubles, the same on every machine: Decimal arithmetic with
60 digits and the series of sine and cosine, nothing from the C library."""
from decimal import Decimal, localcontext
from fractions import Fraction

PI = Decimal("3.14159265358979323846264338327950288419716939937510582097494459230781640628620899")


def series(angle, first, power):
    term = total = first
    for k in range(power + 1, 200, 2):
        term = -term * angle * angle / (k * (k + 1))
        total += term
    return total


def circle_point(k, n):
    """Cosine and sine of 2 pi k / n, each rounded to a nearest double, as fractions."""
    with localcontext() as context:
        context.prec = 70
        turn = Fraction(8 * (k % n), n)  # in eighths of the circle
        octant, rest = divmod(turn, 1)
        if octant % 2:
            rest = 1 - rest
        angle = PI / 4 * rest.numerator / rest.denominator
        cosine, sine = series(angle, Decimal(1), 0), series(angle, angle, 1)
    c, s = Fraction(float(cosine)), Fraction(float(sine))
    if octant in (1, 2, 5, 6):
        c, s = s, c
    return (-c if 2 <= octant < 6 else c, -s if octant >= 4 else s)
