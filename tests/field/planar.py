# SPDX-License-Identifier: MIT
"""Convex polygons in a plane as cycles of integer lines, and what their union leaves of a polygon, by slabs.

A line (a, b, c) has the polygon in a x + b y + c <= 0. Corners are met by two lines each and never by points
that were met before, so numbers do not grow with the number of cuts.
"""
from fractions import Fraction
from math import gcd

from solid import cross, dot, minus


def reduced(line):
    common = gcd(*line)
    return tuple(x // common for x in line) if common > 1 else line


def meet(first, second):
    """The homogeneous point of two lines, its weight >= 0; the weight is 0 if they are parallel."""
    x, y, w = cross(first, second)
    return (x, y, w) if w >= 0 else (-x, -y, -w)


class Frame:
    """A plane in space with two of the three coordinates as its own."""

    def __init__(self, normal, offset):
        self.normal, self.offset = normal, offset
        self.axis = max(range(3), key=lambda k: abs(normal[k]))
        self.i, self.j = (self.axis + 1) % 3, (self.axis + 2) % 3
        self.sign = 1 if normal[self.axis] > 0 else -1

    def flat(self, point):
        return point[self.i], point[self.j]

    def line_of(self, normal, offset):
        """Where normal . x <= offset in this plane; the first two numbers are 0 if it is parallel."""
        k, i, j, s = self.axis, self.i, self.j, self.sign
        own = self.normal
        return reduced((s * (normal[i] * own[k] - normal[k] * own[i]), s * (normal[j] * own[k] - normal[k] * own[j]),
                        s * (normal[k] * self.offset - offset * own[k])))

    def polygon(self, corners):
        """Of corners in convex position in this plane, counter-clockwise about its normal."""
        flat = [self.flat(corner) for corner in corners]
        if self.sign < 0:
            flat.reverse()
        return Polygon([reduced((q[1] - p[1], p[0] - q[0], q[0] * p[1] - p[0] * q[1]))
                        for p, q in zip(flat, flat[1:] + flat[:1])])


class Polygon:
    """A convex polygon with an area; edge k runs from corner k - 1 to corner k."""

    def __init__(self, lines):
        self.lines = lines
        self.corners = [meet(line, after) for line, after in zip(lines, lines[1:] + lines[:1])]

    def cut(self, line):
        """What lies in a x + b y + c <= 0: this polygon, a smaller one, or None if that has no area."""
        if not line[0] and not line[1]:
            return self if line[2] <= 0 else None
        values = [dot(line, corner) for corner in self.corners]
        if max(values) <= 0:
            return self
        if min(values) >= 0:
            return None
        lines = []
        for k, own in enumerate(self.lines):
            if values[k - 1] < 0 or values[k] < 0:
                lines.append(own)
            if values[k - 1] < 0 <= values[k]:
                lines.append(line)
        return Polygon(lines)

    def cut_all(self, lines):
        polygon = self
        for line in lines:
            polygon = polygon.cut(line)
            if polygon is None:
                return None
        return polygon

    def spans(self):
        """Of each edge: its line and the range of x that it has."""
        xs = [Fraction(x, w) for x, _, w in self.corners]
        return [(line, min(xs[k - 1], xs[k]), max(xs[k - 1], xs[k])) for k, line in enumerate(self.lines)]

    def at(self, x):
        """The range of y at an x strictly between its ends."""
        low, high = [], []
        for a, b, c in self.lines:
            if b:
                (high if b > 0 else low).append((-c - a * x) / b)
        return max(low), min(high)


def uncovered_share(whole, pieces):
    """Which share of the polygon `whole` the union of `pieces`, all within it, leaves; a Fraction.

    Between two neighbouring x of corners and crossings no two edges cross, so the length that is covered at an x
    is affine there, and its value halfway times the width is the area.
    """
    edges = [(number, *edge) for number, piece in enumerate(pieces) for edge in piece.spans()]
    ends = {low for _, _, low, _ in edges} | {high for _, _, _, high in edges}
    ends |= {Fraction(x, w) for x, _, w in whole.corners}
    for at, (number, line, low, high) in enumerate(edges):
        for other, second, least, most in edges[at + 1:]:
            if other == number or least >= high or most <= low:
                continue
            x, _, w = meet(line, second)
            if w and max(low, least) < Fraction(x, w) < min(high, most):
                ends.add(Fraction(x, w))
    ranges = [(min(low for n, _, low, _ in edges if n == k), max(high for n, _, _, high in edges if n == k))
              for k in range(len(pieces))]
    ends = sorted(ends)
    total = covered = Fraction(0)
    for left, right in zip(ends, ends[1:]):
        middle, width = (left + right) / 2, right - left
        bottom, top = whole.at(middle)
        total += width * (top - bottom)
        reached = bottom
        for low, high in sorted(piece.at(middle) for piece, (least, most) in zip(pieces, ranges) if least < middle < most):
            if high > reached:
                covered += width * (high - max(low, reached))
                reached = high
    return 1 - covered / total


def uncovered_line(intervals):
    """Which share of [0, 1] the union of closed intervals leaves."""
    reached = left = Fraction(0)
    for low, high in sorted(intervals):
        if low > reached:
            left += low - reached
        reached = max(reached, high)
    return left + max(1 - reached, 0)


def segment_within(a, b, planes):
    """The t in [0, 1] with a + t (b - a) in all planes (normal, offset), as a pair; None if there is none."""
    low, high, along = Fraction(0), Fraction(1), minus(b, a)
    for normal, offset in planes:
        rise, room = dot(normal, along), offset - dot(normal, a)
        if rise > 0:
            high = min(high, Fraction(room, rise))
        elif rise < 0:
            low = max(low, Fraction(room, rise))
        elif room < 0:
            return None
    return (low, high) if low <= high else None
