# SPDX-License-Identifier: MIT
"""Hulls, volumes and greedy runs by their definitions, in integers and fractions.

Nothing here is clever, and nothing is shared with convexact: a facet is a plane through three points
that has all others on one side; a vertex is a point where three planes meet and that violates none;
the cost of a removal is the volume that it adds. All numbers are exact.
"""
from fractions import Fraction
from itertools import combinations
from math import gcd, lcm


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def minus(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def determinant(a, b, c):
    return dot(a, cross(b, c))


def primitive(row):
    g = gcd(*row)
    return tuple(x // g for x in row) if g else tuple(row)


def primitive_plane(row):
    """The plane n.x + d <= 0 as integers without common divisor, from fractions."""
    row = [Fraction(x) for x in row]
    scale = lcm(*(x.denominator for x in row))
    return primitive(tuple(int(x * scale) for x in row))


def canonical_key(plane):
    """Primitive normals first, lexicographically, then the offset."""
    g = gcd(*plane[:3])
    return (tuple(x // g for x in plane[:3]), Fraction(plane[3], g))


def as_integers(points):
    """The points times one common denominator, and that denominator."""
    scale = lcm(*(x.denominator for p in points for x in p)) if points else 1
    return [tuple(int(x * scale) for x in p) for p in points], scale


def dimension(points):
    """Affine dimension, -1 for no points: a largest set of independent differences, greedily."""
    if not points:
        return -1
    integers, _ = as_integers(points)
    chosen = []
    for p in integers:
        v = minus(p, integers[0])
        if not chosen and any(v):
            chosen = [v]
        elif len(chosen) == 1 and any(cross(chosen[0], v)):
            chosen.append(v)
        elif len(chosen) == 2 and determinant(*chosen, v):
            return 3
    return len(chosen)


def hull_planes(points):
    """The facets' planes in canonical order, each with the set of (indices of) points on it.

    Every plane through three points counts that has no point on its outer side.
    """
    integers, scale = as_integers(points)
    distinct = sorted(set(integers))
    facets = {}
    known = set()  # triples' pairs that lie in a facet found before, to skip coplanar triples fast
    for a, b, c in combinations(distinct, 3):
        if (a, b, c) in known:
            continue
        n = cross(minus(b, a), minus(c, a))
        if not any(n):
            continue
        level = dot(n, a)
        below = above = False
        for p in distinct:
            value = dot(n, p)
            if value < level:
                below = True
            elif value > level:
                above = True
            if below and above:
                break
        if below and above:
            continue
        if above:
            n, level = (-n[0], -n[1], -n[2]), -level
        on = [p for p in distinct if dot(n, p) == level]
        if len(on) > 3:
            known.update(combinations(on, 3))
        facets[primitive((n[0] * scale, n[1] * scale, n[2] * scale, -level))] = set(on)
    where = {}
    for index, p in enumerate(integers):
        where.setdefault(p, index)
    return {plane: sorted(where[p] for p in facets[plane]) for plane in sorted(facets, key=canonical_key)}


class Surface:
    """Points (homogeneous, integers) on planes, and volumes from which points lie on which planes."""

    def __init__(self, planes, points):
        self.planes, self.points = list(planes), list(points)
        self.tight, self.violated = [], []
        for p in self.points:
            values = [plane[0] * p[0] + plane[1] * p[1] + plane[2] * p[2] + plane[3] * p[3] for plane in self.planes]
            self.tight.append(sum(1 << j for j, value in enumerate(values) if value == 0))
            self.violated.append(sum(1 << j for j, value in enumerate(values) if value > 0))

    def volume(self, vertices, faces):
        """Of the polytope with these vertices and with faces on these planes (bits): tetrahedra
        from the first vertex over a fan of each face that does not hold it."""
        first = vertices[0]
        total = Fraction(0)
        for j in range(len(self.planes)):
            if not faces >> j & 1 or self.tight[first] >> j & 1:
                continue
            ring = self.ring([v for v in vertices if self.tight[v] >> j & 1], faces & ~(1 << j))
            for k in range(1, len(ring) - 1):
                total += self.tetrahedron(first, ring[0], ring[k], ring[k + 1])
        return total

    def ring(self, corners, others):
        """Corners of a convex polygon in cyclic order: neighbours share a second plane."""
        if len(corners) < 3:
            return []
        order, last = [corners[0]], None
        while True:
            here = order[-1]
            near = [v for v in corners if v != here and v != last and self.tight[v] & self.tight[here] & others]
            near = [v for v in near if v == corners[0] or v not in order]
            following = [v for v in near if v != corners[0]] or near
            if not following or following[0] == corners[0]:
                assert len(order) == len(corners), "corners of a face do not form one ring"
                return order
            last = here
            order.append(following[0])

    def tetrahedron(self, a, b, c, d):
        rows = [self.points[v] for v in (a, b, c, d)]
        total = 0
        for k in range(4):
            rest = [row[:3] for i, row in enumerate(rows) if i != k]
            total += (-1) ** (k + 1) * rows[k][3] * determinant(*rest)
        return Fraction(abs(total), 6 * rows[0][3] * rows[1][3] * rows[2][3] * rows[3][3])

    def all_alive(self):
        return (1 << len(self.planes)) - 1


class Arrangement(Surface):
    """All points where three of the planes meet, and all directions where two meet."""

    def __init__(self, planes):
        planes = list(planes)
        m = len(planes)
        normals = [p[:3] for p in planes]
        found = {}
        self.rays = {}
        for a, b in combinations(range(m), 2):
            direction = cross(normals[a], normals[b])
            if not any(direction):
                continue
            for sign in (1, -1):
                ray = primitive(tuple(sign * x for x in direction))
                if ray not in self.rays:
                    self.rays[ray] = sum(1 << j for j in range(m) if dot(normals[j], ray) > 0)
            for c in range(b + 1, m):
                w = dot(direction, normals[c])
                if w == 0:
                    continue
                bc, ca = cross(normals[b], normals[c]), cross(normals[c], normals[a])
                da, db, dc = planes[a][3], planes[b][3], planes[c][3]
                point = tuple(-(da * bc[k] + db * ca[k] + dc * direction[k]) for k in range(3)) + (w,)
                if w < 0:
                    point = tuple(-x for x in point)
                found.setdefault(primitive(point), []).append(1 << a | 1 << b | 1 << c)
        super().__init__(planes, found)
        self.triples = list(found.values())

    def is_bounded(self, alive):
        """No direction stays inside all planes that are alive, and these span all directions."""
        normals = [p[:3] for j, p in enumerate(self.planes) if alive >> j & 1]
        if not any(determinant(*three) for three in combinations(normals, 3)):
            return False
        return all(violated & alive for violated in self.rays.values())

    def is_vertex(self, point, alive):
        return any(triple & ~alive == 0 for triple in self.triples[point])

    def levels(self, alive):
        """Points that violate no plane, and for each plane those that violate only this one."""
        inside, beyond = [], {}
        for p, violated in enumerate(self.violated):
            violated &= alive
            if violated & (violated - 1):
                continue
            if not self.is_vertex(p, alive):
                continue
            if violated == 0:
                inside.append(p)
            else:
                beyond.setdefault(violated.bit_length() - 1, []).append(p)
        return inside, beyond

    def volume_of(self, alive):
        return self.volume(self.levels(alive)[0], alive)


def greedy(planes, wanted):
    """Removes the plane whose removal adds the least volume, of equals the first in canonical
    order, until `wanted` are left or every further removal is unbounded."""
    arrangement = Arrangement(sorted(planes, key=canonical_key))
    alive = arrangement.all_alive()
    before = arrangement.volume_of(alive)
    costs, ties, known = [], [], {}
    while bin(alive).count("1") > wanted:
        inside, beyond = arrangement.levels(alive)
        best, tie = None, []
        for i in range(len(arrangement.planes)):
            without = alive & ~(1 << i)
            if not alive >> i & 1 or not arrangement.is_bounded(without):
                continue
            base = [p for p in inside if arrangement.tight[p] >> i & 1]
            cap = beyond[i] + base
            key = (i, frozenset(cap))
            if key not in known:
                known[key] = arrangement.volume(cap, alive)
            if best is None or known[key] < best:
                best, tie = known[key], []
            if known[key] == best:
                tie.append(i)
        if best is None:
            break
        costs.append(best)
        ties.append([arrangement.planes[i] for i in tie])
        alive &= ~(1 << tie[0])
    after = arrangement.volume_of(alive)
    assert after == before + sum(costs), "the caps do not add up to the final volume"
    left = bin(alive).count("1")
    return {"facets": left, "volume": after, "costs": costs, "ties": ties, "reached": left <= wanted, "start": before}


def hull_measures(points):
    """Counts and volume of the hull of points that span a volume. A point is a vertex if the
    normals of the facets that it lies on span all directions."""
    planes = list(hull_planes(points))
    homogeneous = []
    for p in sorted({tuple(Fraction(x) for x in p) for p in points}):
        (row,), w = as_integers([p])
        homogeneous.append((*row, w))
    surface = Surface(planes, homogeneous)
    vertices = []
    for v in range(len(homogeneous)):
        normals = [plane[:3] for j, plane in enumerate(planes) if surface.tight[v] >> j & 1]
        if any(determinant(*three) for three in combinations(normals, 3)):
            vertices.append(v)
    return {"facets": len(planes), "vertices": len(vertices), "volume": surface.volume(vertices, surface.all_alive())}


def squared_distance(planes, p):
    """From a point to the intersection of halfspaces, by the conditions of Karush, Kuhn and Tucker: the
    nearest point is p less a nonnegative combination of the normals of one, two or three planes, lies on
    these and in all halfspaces."""
    beyond = [dot(plane[:3], p) + plane[3] for plane in planes]
    if all(value <= 0 for value in beyond):
        return Fraction(0)
    for count in (1, 2, 3):
        for chosen in combinations(range(len(planes)), count):
            if all(beyond[i] <= 0 for i in chosen):
                continue  # 0 < |p - q|^2 = sum of y_i times beyond[i]
            normals = [planes[i][:3] for i in chosen]
            weights = solve([[dot(n, m) for m in normals] for n in normals], [beyond[i] for i in chosen])
            if weights is None or any(y < 0 for y in weights):
                continue
            way = tuple(sum(y * n[k] for y, n in zip(weights, normals)) for k in range(3))
            if all(value <= dot(plane[:3], way) for value, plane in zip(beyond, planes)):
                return Fraction(dot(way, way))
    raise ValueError("the halfspaces have nothing in common")


def solve(matrix, right):
    """The solution of a regular square system, or None."""
    rows = [[Fraction(x) for x in row] + [Fraction(b)] for row, b in zip(matrix, right)]
    for k in range(len(rows)):
        pivot = next((r for r in range(k, len(rows)) if rows[r][k]), None)
        if pivot is None:
            return None
        rows[k], rows[pivot] = rows[pivot], rows[k]
        rows[k] = [x / rows[k][k] for x in rows[k]]
        for r in range(len(rows)):
            if r != k:
                rows[r] = [x - rows[r][k] * y for x, y in zip(rows[r], rows[k])]
    return [row[-1] for row in rows]


def farthest_outside(planes, points):
    """How many points lie beyond some plane, and the largest squared distance to the solid of all planes."""
    distances = [squared_distance(planes, p) for p in points]
    return sum(distance > 0 for distance in distances), max(distances)
