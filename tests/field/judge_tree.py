#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""An independent judge of trees of hulls: judge_tree.py TREE...

Decides from the bytes of a file of `convexact bvh` whether it holds one tree over all its parts, in which each hull
holds the stored points of its children; in integers and fractions, with Python's standard library and no line of
convexact. Prints a JSON object for each file. Exit code 1 if one has a fault.
"""
import json
import sys
import time
from collections import Counter
from fractions import Fraction
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from judge_parts import Part  # noqa: E402
from reading import Malformed, NotFinite, Numbers  # noqa: E402
from solid import cross, dot, integers, minus  # noqa: E402


def coordinate(value):
    """What a coordinate means: a number the double nearest to it, a string the fraction in it."""
    if isinstance(value, str):
        return Fraction(value) if "/" in value else Numbers().of_text(value)
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise Malformed(f"expected a coordinate, found {value!r}")
    return Numbers().of_double(float(value))


class Node:
    """A hull of points; of a leaf those of its part, which the file has once."""

    def __init__(self, entry, points, faces):
        self.parent, self.part = entry.get("parent"), entry.get("part")
        self.children = list(entry.get("children", []))
        self.points, self.faces = points, faces


def mesh_of(entry):
    return [tuple(map(coordinate, point)) for point in entry["vertices"]], [list(face) for face in entry["faces"]]


class Tree:
    """A file of `convexact bvh`."""

    def __init__(self, document):
        self.document = document
        self.parts = [(part["name"], *mesh_of(part)) for part in document["parts"]]
        self.nodes = []
        for entry in document["hull_tree"]:
            part = entry.get("part")
            mesh = mesh_of(entry) if "vertices" in entry else ([], [])
            if part is not None and 0 <= part < len(self.parts):
                mesh = self.parts[part][1:]
            self.nodes.append(Node(entry, *mesh))


def read_tree(path):
    def refuse(word):
        raise NotFinite(word)
    try:
        document = json.loads(Path(path).read_bytes(), parse_constant=refuse)
    except ValueError as fault:
        raise Malformed(str(fault)) from None
    if not isinstance(document, dict) or "hull_tree" not in document or "parts" not in document:
        raise Malformed("expected an object with parts and hull_tree")
    return Tree(document)


# ---- Hulls of stored points


def area_vector(corners):
    """Twice the area of a polygon as a vector along its normal."""
    first, total = corners[0], (0, 0, 0)
    for b, c in zip(corners[1:], corners[2:]):
        x, y, z = cross(minus(b, first), minus(c, first))
        total = (total[0] + x, total[1] + y, total[2] + z)
    return total


def planes_of_faces(points, faces):
    """(normal, offset) of each face, if the faces are the surface of the hull of all points; otherwise None.

    The faces have to close up, each in a plane that no point is beyond, and to enclose a volume. Then each lies in a
    facet of the hull, and together they are its whole boundary, at least once. So no facet's plane is missing.
    """
    planes, balance, volume = [], Counter(), 0
    for face in faces:
        corners = [points[corner] for corner in face]
        nx, ny, nz = normal = area_vector(corners)
        offset = dot(normal, corners[0])
        if not any(normal) or any(dot(normal, corner) != offset for corner in corners):
            return None
        if any(nx * x + ny * y + nz * z > offset for x, y, z in points):
            return None
        for tail, head in zip(face, face[1:] + face[:1]):
            balance[min(tail, head), max(tail, head)] += 1 if tail < head else -1
        volume += offset
        planes.append((normal, offset))
    return planes if volume > 0 and not any(balance.values()) else None


class StoredHull:
    """The hull of integer points: `planes` that hold it, exactly. Faces that are not its surface do not count."""

    def __init__(self, points, faces):
        self.points, self.faces = points, faces
        self.planes = planes_of_faces(points, faces)
        self.has_its_faces = self.planes is not None
        if not self.has_its_faces:
            self.planes = Part("", points, faces).planes

    def volume6(self):
        return sum(dot(area_vector([self.points[c] for c in face]), self.points[face[0]]) for face in self.faces)

    def outside(self, points):
        """The first of some points that lies outside, and the plane that it is beyond; None if all are within."""
        own = set(self.points)
        for point in points:
            if point in own:
                continue
            x, y, z = point
            for (nx, ny, nz), offset in self.planes:
                if nx * x + ny * y + nz * z > offset:
                    return point, ((nx, ny, nz), offset)
        return None

    def span(self, origin, direction):
        """Where the line origin + t direction is inside: the least and the largest t; None if nowhere."""
        low = high = None
        for normal, offset in self.planes:
            slope, rest = dot(normal, direction), offset - dot(normal, origin)
            if slope == 0:
                if rest < 0:
                    return None
            elif slope > 0:
                high = Fraction(rest, slope) if high is None else min(high, Fraction(rest, slope))
            else:
                low = Fraction(rest, slope) if low is None else max(low, Fraction(rest, slope))
        return (low, high) if low <= high else None

    def first_hit(self, origin, direction):
        """The least t >= 0 of a ray within the hull; None if it misses."""
        span = self.span(origin, direction)
        return None if span is None or span[1] < 0 else max(span[0], Fraction(0))

    def edges(self):
        """The directions of all edges, one of each pair of opposites."""
        ends = {(min(u, v), max(u, v)) for face in self.faces for u, v in zip(face, face[1:] + face[:1])}
        return [minus(self.points[v], self.points[u]) for u, v in ends]

    def meets_box(self, low, high):
        """Whether a closed box has a common point. If not, a side of either, or an edge of both, separates them."""
        axes = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
        normals = list(axes) + [normal for normal, _ in self.planes]
        normals += [cross(edge, axis) for edge in self.edges() for axis in axes]
        return not any(self._is_apart(normal, low, high) for normal in normals)

    def _is_apart(self, normal, low, high):
        nearest = sum(min(n * a, n * b) for n, a, b in zip(normal, low, high))
        farthest = sum(max(n * a, n * b) for n, a, b in zip(normal, low, high))
        heights = [dot(normal, point) for point in self.points]
        return farthest < min(heights) or max(heights) < nearest


# ---- Faults


def bad_indices(tree):
    for number, node in enumerate(tree.nodes):
        related = node.children + ([] if node.parent is None else [node.parent])
        if any(not isinstance(k, int) or not 0 <= k < len(tree.nodes) for k in related):
            yield f"node {number} names a node that is not there"
        if node.part is not None and not 0 <= node.part < len(tree.parts):
            yield f"node {number} names a part that is not there"


def bad_structure(tree):
    """What keeps the nodes from being one tree whose leaves are the parts. Precondition: no bad index."""
    roots = [number for number, node in enumerate(tree.nodes) if node.parent is None]
    if len(roots) != 1:
        yield f"{len(roots)} nodes have no parent"
    for number, node in enumerate(tree.nodes):
        if len(set(node.children)) < len(node.children):
            yield f"node {number} names a child twice"
        for child in node.children:
            if tree.nodes[child].parent != number:
                yield f"node {number} is not the parent that its child {child} names"
        if node.parent is not None and number not in tree.nodes[node.parent].children:
            yield f"node {number} is not among the children of its parent {node.parent}"
        if bool(node.children) == (node.part is not None):
            yield f"node {number} should have either children or a part"
    reached, below = set(), list(roots)
    while below:
        number = below.pop()
        if number not in reached:
            reached.add(number)
            below += tree.nodes[number].children
    if len(reached) < len(tree.nodes):
        yield f"{len(tree.nodes) - len(reached)} nodes are not below the root"
    leaves = Counter(node.part for node in tree.nodes if node.part is not None)
    for number, (name, _, _) in enumerate(tree.parts):
        if leaves[number] != 1:
            yield f"{name} has {leaves[number]} leaves"


def levels_of(tree):
    """The nodes at each distance from the root. Precondition: no fault so far."""
    levels = [[number for number, node in enumerate(tree.nodes) if node.parent is None]]
    while levels[-1]:
        levels.append([child for number in levels[-1] for child in tree.nodes[number].children])
    return levels[:-1]


class Judged:
    """Faults, the first of them first, and what was counted on the way."""

    def __init__(self, tree):
        self.tree, self.faults, self.figures = tree, [], {"nodes": len(tree.nodes), "parts": len(tree.parts)}
        self.faults += bad_indices(tree)
        if not self.faults:
            self.faults += bad_structure(tree)
        if not self.faults:
            self._judge_hulls()

    def _judge_hulls(self):
        groups, self.scale = integers(*(node.points for node in self.tree.nodes))
        self.hulls = [StoredHull(points, node.faces) for points, node in zip(groups, self.tree.nodes)]
        self.figures["hulls_with_other_faces"] = sum(not hull.has_its_faces for hull in self.hulls)
        tested = 0
        for number, node in enumerate(self.tree.nodes):
            for child in node.children:
                tested += len(self.hulls[child].points)
                found = self.hulls[number].outside(self.hulls[child].points)
                if found:
                    place = ", ".join(str(Fraction(x, self.scale)) for x in found[0])
                    self.faults.append(f"node {number} does not hold the point ({place}) of its child {child}")
        levels = levels_of(self.tree)
        self.figures.update(levels=len(levels), points_tested=tested)
        self._judge_levels(levels)

    def _judge_levels(self, levels):
        """What the file says of its levels: counts, and bounds of volumes that the exact ones have to lie within."""
        said = self.tree.document.get("levels")
        if said is None or self.figures["hulls_with_other_faces"]:
            return
        if len(said) != len(levels):
            self.faults.append(f"the file speaks of {len(said)} levels")
        for level, entry in zip(levels, said):
            volume = Fraction(sum(self.hulls[k].volume6() for k in level), 6 * self.scale ** 3)
            counts = (len(level), sum(not self.tree.nodes[k].children for k in level))
            if (entry["nodes"], entry["leaves"]) != counts:
                self.faults.append(f"level {entry['level']} has {counts[0]} nodes and {counts[1]} leaves")
            if not entry["volume"]["low"] <= volume <= entry["volume"]["high"]:
                self.faults.append(f"level {entry['level']} has the volume {float(volume)!r}")


def judge_tree_file(path):
    """{"faults": [...], ...} of a file that may be unreadable."""
    start = time.monotonic()
    try:
        judged = Judged(read_tree(path))
        faults, figures = judged.faults, judged.figures
    except (Malformed, NotFinite) as fault:
        faults, figures = [f"{type(fault).__name__}: {fault}"], {}
    return {"file": str(path), "faults": faults, **figures, "seconds": round(time.monotonic() - start, 2)}


def main():
    if len(sys.argv) < 2 or sys.argv[1].startswith("-"):
        print(__doc__)
        return 2
    found = [judge_tree_file(path) for path in sys.argv[1:]]
    for verdict in found:
        print(json.dumps(verdict))
    return 1 if any(verdict["faults"] for verdict in found) else 0


if __name__ == "__main__":
    sys.exit(main())
