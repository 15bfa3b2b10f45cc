# SPDX-License-Identifier: MIT
"""The faces of a mesh as a surface: closed, oriented, simple, planar, convex; all in integers."""
from collections import defaultdict
from fractions import Fraction

from solid import cross, dot, minus, squared_excess


def side(normal, a, b, c):
    """Left (+1), right (-1) or on (0) the line ab is c, seen against the normal."""
    value = dot(normal, cross(minus(b, a), minus(c, a)))
    return (value > 0) - (value < 0)


def within(a, b, p):
    """Whether p, which is seen on the line ab, lies in the segment ab."""
    along = minus(b, a)
    return 0 <= dot(along, minus(p, a)) <= dot(along, along)


def touch(normal, a, b, c, d):
    """Whether the segments ab and cd share a point, seen along the normal."""
    first, second = side(normal, a, b, c), side(normal, a, b, d)
    third, fourth = side(normal, c, d, a), side(normal, c, d, b)
    if first * second < 0 and third * fourth < 0:
        return True
    return ((first == 0 and within(a, b, c)) or (second == 0 and within(a, b, d)) or
            (third == 0 and within(c, d, a)) or (fourth == 0 and within(c, d, b)))


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

    def is_closed(self):
        """Each edge belongs to exactly two faces, and those are not one."""
        return all(len(uses) == 2 and uses[0][0] != uses[1][0] for uses in self.edges.values())

    def is_consistent(self):
        """Along no edge two faces run in the same direction."""
        return all(len({tail for _, tail in uses}) == len(uses) for uses in self.edges.values())

    def volume6(self):
        return sum(dot(area, face[0]) for area, face in zip(self.areas, self.faces))

    def without_area(self):
        return [k for k, area in enumerate(self.areas) if not any(area)]

    def not_simple(self):
        """Faces whose outline, seen along the area vector, meets itself; those without area are in that list."""
        return [k for k, (area, face) in enumerate(zip(self.areas, self.faces))
                if not any(area) or not self._is_simple(area, face)]

    @staticmethod
    def _is_simple(normal, face):
        if len(face) == 3:
            return True
        edges = [(face[k - 1], face[k]) for k in range(len(face))]
        count = len(edges)
        for i, (a, b) in enumerate(edges):
            c, d = edges[(i + 1) % count]
            # Neighbours share b; they may go on straight but not back.
            if side(normal, a, b, d) == 0 and dot(minus(b, a), minus(d, c)) <= 0:
                return False
            for j in range(i + 2, count):
                if (j + 1) % count != i and touch(normal, a, b, *edges[j]):
                    return False
        return True

    def bend(self):
        """The largest squared distance of a corner to the plane through its face's first corner."""
        worst = Fraction(0)
        for area, face in zip(self.areas, self.faces):
            if any(area):
                offset = dot(area, face[0])
                worst = max([worst] + [squared_excess(area, offset, c) for c in face if dot(area, c) != offset])
        return worst

    def off_hull(self, hull):
        """How many faces with an area lie in no facet of the hull outward, and how far a vertex is beyond one."""
        planes = {direction(facet.normal, facet.offset) for facet in hull.facets}
        vertices = [hull.points[v] for v in hull.vertices]
        count, worst = 0, Fraction(0)
        for area, face in zip(self.areas, self.faces):
            if not any(area):
                continue
            offset = dot(area, face[0])
            if direction(area, offset) in planes:
                continue
            count += 1
            farthest = max(vertices, key=lambda p: dot(area, p))
            if dot(area, farthest) > offset:
                worst = max(worst, squared_excess(area, offset, farthest))
        return count, worst


def direction(normal, offset):
    """Equal for planes that are equal with the same outside."""
    size = max(abs(x) for x in normal)
    return tuple(Fraction(x, size) for x in (*normal, offset))
