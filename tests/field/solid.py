# SPDX-License-Identifier: MIT
"""Convex hulls by gift wrapping, in integers; distances and volumes as fractions.

A facet is found by turning a plane about an edge until it meets the next point, then taken whole: all
points in its plane. That each facet has all points on one side is checked by the definition for every
facet. Slow and plain on purpose: it is meant for a few hundred vertices.
"""
from fractions import Fraction
from functools import lru_cache
from itertools import combinations
from math import lcm


class Flat(Exception):
    """The points span no volume; the argument is the dimension that they do span."""


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def minus(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def integers(*groups):
    """Each group of points times one common denominator, and that denominator."""
    scale = 1
    for group in groups:
        for point in group:
            for x in point:
                denominator = x.as_integer_ratio()[1]
                if scale % denominator:
                    scale = lcm(scale, denominator)

    def lift(x):
        numerator, denominator = x.as_integer_ratio()
        return numerator * (scale // denominator)
    return [[tuple(map(lift, point)) for point in group] for group in groups], scale


class Facet:
    """normal . x <= offset holds for all points; corners run counter-clockwise seen from outside."""

    def __init__(self, normal, offset, corners):
        self.normal, self.offset, self.corners = normal, offset, corners

    def edges(self):
        return zip(self.corners, self.corners[1:] + self.corners[:1])


def dimension_of(points):
    """Of distinct points: -1 to 3."""
    if len(points) < 2:
        return len(points) - 1
    a = points[0]
    along = minus(points[1], a)
    normal = next((n for n in (cross(along, minus(p, a)) for p in points) if any(n)), None)
    if normal is None:
        return 1
    return 3 if any(dot(normal, minus(p, a)) for p in points) else 2


def flat_polygon(points, ids, normal):
    """The corners of the hull of points in one plane, counter-clockwise about the normal (Andrew's chain)."""
    axis = max(range(3), key=lambda k: abs(normal[k]))
    i, j = (axis + 1) % 3, (axis + 2) % 3
    if normal[axis] < 0:
        i, j = j, i
    ordered = sorted(ids, key=lambda p: (points[p][i], points[p][j]))

    def chain(sequence):
        kept = []
        for p in sequence:
            while len(kept) > 1:
                a, b, c = points[kept[-2]], points[kept[-1]], points[p]
                if (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]) > 0:
                    break
                kept.pop()
            kept.append(p)
        return kept[:-1]
    return chain(ordered) + chain(ordered[::-1])


def facet_through(points, normal, at):
    """The facet in the supporting plane through point `at`; None if the plane meets a point or an edge only."""
    offset = dot(normal, points[at])
    beyond = [dot(normal, p) - offset for p in points]
    if max(beyond) > 0:
        raise AssertionError("a plane that should support the points does not")
    corners = flat_polygon(points, [p for p, value in enumerate(beyond) if value == 0], normal)
    return Facet(normal, offset, corners) if len(corners) > 2 else None


def turned(points, u, v, normal):
    """The normal of the facet beyond the edge uv, given a supporting plane through that edge."""
    a = points[u]
    across = cross(minus(points[v], a), normal)
    zero_x, zero_y = dot(across, a), dot(normal, a)
    best = None
    for p, point in enumerate(points):
        x, y = dot(across, point) - zero_x, zero_y - dot(normal, point)
        if (x or y) and (best is None or x * best[1] - y * best[0] > 0):
            best = (x, y, p)
    return cross(minus(a, points[v]), minus(points[best[2]], points[v]))


def first_facet(points):
    """Wraps the shadow on the plane z = 0 by one vertical plane, and turns that one if it meets an edge only."""
    start = min(range(len(points)), key=lambda p: points[p])
    ax, ay, _ = points[start]
    direction = None
    for x, y, _ in points:
        x, y = x - ax, y - ay
        if (x or y) and (direction is None or direction[0] * y - direction[1] * x < 0):
            direction = (x, y)
    normal = (direction[1], -direction[0], 0)
    facet = facet_through(points, normal, start)
    if facet:
        return facet
    offset = dot(normal, points[start])
    line = sorted((p for p in range(len(points)) if dot(normal, points[p]) == offset), key=lambda p: points[p])
    return facet_through(points, turned(points, line[0], line[-1], normal), line[0])


def inner_planes(points):
    """Planes (normal, offset) of the hull of a few extreme points; none where that would not save work."""
    if len(points) < 100:
        return []
    steps = (-2, -1, 0, 1, 2)
    directions = [(x, y, z) for x in steps for y in steps for z in steps if x or y or z]
    chosen = list(dict.fromkeys(max(points, key=lambda p: (dot(d, p), p)) for d in directions))
    if len(chosen) >= 100 or dimension_of(chosen) < 3:
        return []
    return [(facet.normal, facet.offset) for facet in Hull(chosen).facets]


def without_inner(points, planes):
    """Drops the points that lie strictly inside all planes."""
    return [p for p in points if any(dot(n, p) >= d for n, d in planes)] if planes else points


class Hull:
    """The hull of integer points: facets, whose corners index `points` (distinct, input order)."""

    def __init__(self, points):
        self.points = list(dict.fromkeys(points))
        dimension = dimension_of(self.points)
        if dimension < 3:
            raise Flat(dimension)
        self.inner = inner_planes(self.points)
        self.points = without_inner(self.points, self.inner)
        self.facets = []
        self._wrap()
        self.vertices = sorted({corner for facet in self.facets for corner in facet.corners})

    def _wrap(self):
        owner, waiting = set(), []

        def add(facet):
            self.facets.append(facet)
            for edge in facet.edges():
                owner.add(edge)
                waiting.append((facet, edge))
        add(first_facet(self.points))
        while waiting:
            facet, (u, v) = waiting.pop()
            if (v, u) not in owner:
                add(facet_through(self.points, turned(self.points, u, v, facet.normal), u))

    def volume6(self):
        """Six times the volume, in the cubed unit of the integers."""
        total = 0
        for facet in self.facets:
            a = self.points[facet.corners[0]]
            for b, c in zip(facet.corners[1:], facet.corners[2:]):
                total += dot(a, cross(self.points[b], self.points[c]))
        return total

    def beyond(self, point):
        """The facets that a point lies strictly beyond."""
        return [facet for facet in self.facets if dot(facet.normal, point) > facet.offset]

    def squared_distance(self, point, beyond):
        """To the solid, from a point outside: the nearest spot lies on a facet that the point is beyond."""
        return min(self._to_facet(point, facet) for facet in beyond)

    def _to_facet(self, point, facet):
        edges = [(self.points[u], self.points[v]) for u, v in facet.edges()]
        if all(dot(cross(facet.normal, minus(v, u)), minus(point, u)) >= 0 for u, v in edges):
            return squared_excess(facet.normal, facet.offset, point)
        return min(to_segment(point, u, v) for u, v in edges)


@lru_cache(maxsize=8)
def hull_of(points):
    """The hull of a frozenset of points: most programs write the corners that others have written for the same input."""
    return Hull(sorted(points))


def squared_excess(normal, offset, point):
    return Fraction((dot(normal, point) - offset) ** 2, dot(normal, normal))


def to_segment(point, u, v):
    along, arm = minus(v, u), minus(point, u)
    t, length = dot(along, arm), dot(along, along)
    if t <= 0:
        return Fraction(dot(arm, arm))
    if t >= length:
        away = minus(point, v)
        return Fraction(dot(away, away))
    return dot(arm, arm) - Fraction(t * t, length)


def solve3(rows):
    """The point of three planes n.x + d = 0 as Fractions; None if they do not meet in one."""
    (a, b, c) = (row[:3] for row in rows)
    bc, ca, ab = cross(b, c), cross(c, a), cross(a, b)
    volume = dot(a, bc)
    if volume == 0:
        return None
    d = [row[3] for row in rows]
    return tuple(Fraction(-(d[0] * bc[k] + d[1] * ca[k] + d[2] * ab[k]), volume) for k in range(3))


class Intersection:
    """The intersection of halfspaces, by the definition: every point of three planes that violates none.

    Six more planes, farther away than any point of three planes, make it bounded; it is unbounded if a
    vertex lies on one of these. `state` is 'empty', 'flat', 'unbounded' or 'solid'.
    """

    def __init__(self, rows):
        rows = list(dict.fromkeys(integer_row(row) for row in rows))
        self.rows = [row for row in rows if any(row[:3])]
        self.vertices, self.state = [], "empty"
        if any(row[3] > 0 for row in rows if not any(row[:3])):
            return
        largest = max((abs(x) for row in self.rows for x in row), default=1)
        far = 64 * largest ** 3 + 1
        box = [tuple(sign * (axis == k) for k in range(3)) + (-far,) for axis in range(3) for sign in (1, -1)]
        bounded = list(dict.fromkeys(self.rows + box))
        for triple in combinations(bounded, 3):
            point = solve3(triple)
            if point and all(dot(row, point) + row[3] <= 0 for row in bounded):
                self.vertices.append(point)
        self.vertices = list(dict.fromkeys(self.vertices))
        (points,), _ = integers(self.vertices)
        if self.vertices and dimension_of(points) < 3:
            self.state = "flat"
        elif self.vertices:
            self.state = "unbounded" if any(abs(x) == far for point in self.vertices for x in point) else "solid"


def integer_row(row):
    scale = lcm(*(x.denominator for x in row))
    return tuple(int(x * scale) for x in row)
