# SPDX-License-Identifier: MIT
"""A smaller mesh with the same fault: `convexact shrink` reduces points, and a decomposer wants a surface.

Corners are moved onto others, so that a surface that is closed stays closed: first all within the cells of a grid, the
coarsest that keeps the fault, then one after another, along the shortest edges first; then coordinates lose digits. A mesh
whose triangles touch in other places than their corners and edges is not taken: no program promises anything for it.
"""
import math
import time
from collections import Counter
from fractions import Fraction

from reading import Mesh

FOR_DIGITS = 0.2  # of the time: at the end, coordinates lose digits
GRIDS = (2, 3, 4, 5, 6, 8, 10, 12, 16, 24, 32)  # cells along the longest side
DIGITS = (0, 1, 2, 3, 4, 6, 8)  # binary ones behind the point, of the longest side's unit


def joined(mesh, target):
    """With each corner k at target[k] instead. What became a line goes, and so do two triangles back to back."""
    faces = [[target[corner] for corner in face] for face in mesh.faces]
    faces = [face for face in faces if len(set(face)) == 3]
    count = Counter(turned(face) for face in faces)
    kept = []
    for face in faces:
        back = turned(face[::-1])
        if count[back] and count[turned(face)]:
            count[back] -= 1
            count[turned(face)] -= 1
        elif count[turned(face)]:
            count[turned(face)] -= 1
            kept.append(face)
    used = sorted({corner for face in kept for corner in face})
    place = {corner: k for k, corner in enumerate(used)}
    return Mesh([mesh.points[corner] for corner in used], [[place[corner] for corner in face] for face in kept])


def turned(face):
    """From its lowest corner on."""
    first = face.index(min(face))
    return tuple(face[first:] + face[:first])


def is_surface(mesh):
    """Each edge of as many triangles as are to be expected of a closed surface: one for each direction."""
    edges = Counter((face[k - 1], face[k]) for face in mesh.faces for k in range(3))
    return bool(edges) and all(count == 1 and edges[edge[::-1]] == 1 for edge, count in edges.items())


def difference(p, q):
    return [a - b for a, b in zip(p, q)]


def cross(u, v):
    return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]


def dot(u, v):
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def are_apart(one, other):
    """Whether two triangles, segments or points in integers have no point in common: by a plane along edges or faces of them."""
    edges = [[difference(a, b) for k, a in enumerate(corners) for b in corners[:k]] for corners in (one, other)]
    normals = [cross(own[0], own[1]) for own in edges if len(own) == 3]
    axes = normals + [cross(u, v) for u in edges[0] for v in edges[1]]
    axes += [cross(n, u) for n in normals for own in edges for u in own] + [u for own in edges for u in own]
    if len(one) == len(other) == 1:
        axes = [difference(one[0], other[0])]
    for axis in axes:
        first, second = [dot(axis, p) for p in one], [dot(axis, p) for p in other]
        if max(first) < min(second) or max(second) < min(first):
            return True
    return False


def touches_itself(mesh):
    """Whether two triangles have a point in common that is on no common corner or edge; exactly."""
    exact = [[Fraction(x) for x in point] for point in mesh.points]
    scale = math.lcm(*(x.denominator for point in exact for x in point))
    points = [[int(x * scale) for x in point] for point in exact]
    boxes = []
    for face in mesh.faces:
        axes = list(zip(*(points[corner] for corner in face)))
        boxes.append(([min(axis) for axis in axes], [max(axis) for axis in axes], face))
    boxes.sort(key=lambda box: box[0][0])
    for k, (low, high, face) in enumerate(boxes):
        for other_low, other_high, other in boxes[k + 1:]:
            if other_low[0] > high[0]:
                break
            if any(a > d or c > b for a, b, c, d in zip(low, high, other_low, other_high)):
                continue
            if touch(points, face, other):
                return True
    return False


def touch(points, face, other):
    shared = set(face) & set(other)
    whole, other_whole = [points[k] for k in face], [points[k] for k in other]
    if len(shared) == 2 and is_folded(points, face, other, shared):
        return True
    if not shared:
        return not are_apart(whole, other_whole)
    rest, other_rest = [points[k] for k in face if k not in shared], [points[k] for k in other if k not in shared]
    return not rest or not are_apart(rest, other_whole) or not are_apart(whole, other_rest)


def is_folded(points, face, other, shared):
    """Whether two triangles with an edge in common lie in one plane, on the same side of it."""
    p, q = (points[k] for k in shared)
    apexes = [next(points[k] for k in own if k not in shared) for own in (face, other)]
    one, two = (cross(difference(q, p), difference(apex, p)) for apex in apexes)
    return not any(cross(one, two)) and dot(one, two) > 0


def six_volumes(mesh):
    """Of what the surface bounds, six times; above 0 if its triangles are seen counter-clockwise from outside. Exactly."""
    points = [[Fraction(x) for x in point] for point in mesh.points]
    return sum(dot(points[a], cross(points[b], points[c])) for a, b, c in mesh.faces)


def longest_side(points):
    return max(max(axis) - min(axis) for axis in zip(*points))


def on_grid(mesh, cells):
    """The first point of each cell stands for all of them."""
    low, size = [min(axis) for axis in zip(*mesh.points)], longest_side(mesh.points) / cells
    first = {}
    return joined(mesh, [first.setdefault(tuple(min(int((x - a) / size), cells - 1) for x, a in zip(point, low)), k)
                         for k, point in enumerate(mesh.points)])


def collapses(mesh):
    """Each edge, the shortest first: its ends."""
    edges = {tuple(sorted((face[k - 1], face[k]))) for face in mesh.faces for k in range(3)}
    return sorted(edges, key=lambda edge: math.dist(mesh.points[edge[0]], mesh.points[edge[1]]))


def rounded(mesh, digits):
    step = 2.0 ** (math.frexp(longest_side(mesh.points))[1] - 1 - digits)
    return Mesh([tuple(round(x / step) * step for x in point) for point in mesh.points], mesh.faces)


class Reducer:
    def __init__(self, mesh, fails, seconds):
        self.mesh, self.fails, self.end = mesh, fails, time.monotonic() + (1 - FOR_DIGITS) * seconds
        self.seconds = seconds
        self.was_solid = is_surface(mesh) and six_volumes(mesh) > 0

    def takes(self, mesh):
        """Whether a mesh has the fault, and is of the same kind; then it takes the place of the one before."""
        if time.monotonic() > self.end or not mesh.faces or longest_side(mesh.points) == 0:
            return False
        if self.was_solid and not (is_surface(mesh) and six_volumes(mesh) > 0):
            return False
        if touches_itself(mesh) or not self.fails(mesh):
            return False
        self.mesh = mesh
        return True

    def run(self):
        whole = self.mesh
        any(self.takes(found) for found in (on_grid(whole, cells) for cells in GRIDS) if len(found.points) < len(whole.points))
        while time.monotonic() < self.end and self.collapse_one():
            pass
        self.end = time.monotonic() + FOR_DIGITS * self.seconds
        any(self.takes(rounded(self.mesh, digits)) for digits in DIGITS)
        return self.mesh

    def collapse_one(self):
        for a, b in collapses(self.mesh):
            for gone, kept in ((a, b), (b, a)):
                target = list(range(len(self.mesh.points)))
                target[gone] = kept
                if self.takes(joined(self.mesh, target)):
                    return True
        return False


def smaller_mesh(mesh, fails, seconds):
    """
    @param mesh   Of triangles; it has the fault.
    @param fails  Takes a mesh; whether it has the fault.
    """
    return Reducer(mesh, fails, seconds).run()
