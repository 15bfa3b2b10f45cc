# SPDX-License-Identifier: MIT
"""The faces of a mesh as a surface: closed, oriented, simple, planar, convex; all in integers."""
from collections import defaultdict
from fractions import Fraction

from solid import cross, dot, minus, squared_excess


def side(a, b, c):
    """Left (+1), right (-1) or on (0) the line ab is c, in the plane."""
    value = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    return (value > 0) - (value < 0)


def within(a, b, p):
    """Whether p, which is on the line ab, lies in the segment ab."""
    return min(a, b) <= p <= max(a, b)


def touch(a, b, c, d):
    """Whether the segments ab and cd share a point."""
    first, second = side(a, b, c), side(a, b, d)
    third, fourth = side(c, d, a), side(c, d, b)
    if first * second < 0 and third * fourth < 0:
        return True
    return ((first == 0 and within(a, b, c)) or (second == 0 and within(a, b, d)) or
            (third == 0 and within(c, d, a)) or (fourth == 0 and within(c, d, b)))


def is_simple(area, face):
    """Whether the outline meets itself nowhere, seen along the axis on which its area is largest.

    Corners on one line are in order if they go along it once to and fro: such slivers close T-junctions.
    """
    if len(set(face)) < len(face):
        return False
    if not any(area):
        return is_sliver(face)
    axis = max(range(3), key=lambda k: abs(area[k]))
    flat = [tuple(x for k, x in enumerate(corner) if k != axis) for corner in face]
    edges = [(flat[k - 1], flat[k]) for k in range(len(flat))]
    count = len(edges)
    for i, (a, b) in enumerate(edges):
        c, d = edges[(i + 1) % count]
        # Neighbours share b; they may go on straight but not back.
        if side(a, b, d) == 0 and (b[0] - a[0]) * (d[0] - c[0]) + (b[1] - a[1]) * (d[1] - c[1]) <= 0:
            return False
        for j in range(i + 2, count):
            if (j + 1) % count != i and touch(a, b, *edges[j]):
                return False
    return True


def is_sliver(face):
    """Whether different corners lie on one line and go along it once to and fro."""
    along = minus(face[1], face[0])
    if any(any(cross(along, minus(corner, face[0]))) for corner in face):
        return False
    places = [dot(along, corner) for corner in face]
    turns = [(places[k] - places[k - 1] > 0) != (places[k - 1] - places[k - 2] > 0) for k in range(len(places))]
    return sum(turns) == 2


class Surface:
    """Faces after welding equal points and dropping repeated neighbours and what is left with under three corners."""

    def __init__(self, points, faces):
        self.points, self.faces, self.dropped = points, [], 0
        for face in faces:
            corners = [points[corner] for corner in face]
            corners = [c for k, c in enumerate(corners) if c != corners[k - 1]]
            if len(corners) > 2:
                self.faces.append(corners)
            else:
                self.dropped += 1
        self.areas = [self._area(face) for face in self.faces]
        self.edges = defaultdict(list)
        for number, face in enumerate(self.faces):
            for k, corner in enumerate(face):
                self.edges[frozenset((face[k - 1], corner))].append((number, face[k - 1]))

    @staticmethod
    def _area(face):
        """Twice the area vector."""
        total = (0, 0, 0)
        for b, c in zip(face[1:], face[2:]):
            part = cross(minus(b, face[0]), minus(c, face[0]))
            total = tuple(x + y for x, y in zip(total, part))
        return total

    def turned_over(self):
        """The same faces, each the other way round."""
        turned = Surface([], [])
        turned.faces = [face[::-1] for face in self.faces]
        turned.areas = [tuple(-x for x in area) for area in self.areas]
        turned.edges = self.edges
        return turned

    def is_closed(self):
        """Each edge belongs to exactly two faces, and those are not one."""
        return all(len(uses) == 2 and uses[0][0] != uses[1][0] for uses in self.edges.values())

    def is_consistent(self):
        """Along no edge two faces run in the same direction."""
        return all(len({tail for _, tail in uses}) == len(uses) for uses in self.edges.values())

    def volume6(self):
        return sum(dot(area, face[0]) for area, face in zip(self.areas, self.faces))

    def without_area(self):
        return sum(not any(area) for area in self.areas)

    def not_simple(self):
        """How many faces are no simple polygons."""
        return sum(not is_simple(area, face) for area, face in zip(self.areas, self.faces))

    def bend(self):
        """The largest squared distance of a corner to the plane through its face's first corner."""
        return max((bend_of(area, face) for area, face in zip(self.areas, self.faces)), default=Fraction(0))

    def off_hull(self, hull):
        """How many faces with an area lie in no facet of the hull outward, and how far a vertex is beyond one.

        If none is beyond any of them, how much they are bent.
        """
        planes = {direction(facet.normal, facet.offset) for facet in hull.facets}
        vertices = [hull.points[v] for v in hull.vertices]
        count, worst, bend = 0, Fraction(0), Fraction(0)
        for area, face in zip(self.areas, self.faces):
            if not any(area):
                continue
            offset = dot(area, face[0])
            if direction(area, offset) in planes:
                continue
            count, bend = count + 1, max(bend, bend_of(area, face))
            farthest = max(vertices, key=lambda p: dot(area, p))
            if dot(area, farthest) > offset:
                worst = max(worst, squared_excess(area, offset, farthest))
        return count, worst or bend


def bend_of(area, face):
    """The largest squared distance of a corner to the plane through the first one; 0 without an area."""
    offset = dot(area, face[0])
    return max((squared_excess(area, offset, c) for c in face if dot(area, c) != offset), default=Fraction(0))


def direction(normal, offset):
    """Equal for planes that are equal with the same outside."""
    size = max(abs(x) for x in normal)
    return tuple(Fraction(x, size) for x in (*normal, offset))
