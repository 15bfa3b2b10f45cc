#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""An independent judge of decompositions: judge_parts.py INPUT PARTS [--numbers binary32] [--tolerance T].

Decides the claims of `convexact verify` about parts by their definitions, in integers and fractions, with Python's
standard library and no line of convexact. PARTS is an OBJ with an object or a group for each part, or a folder with a
mesh for each. Prints one JSON object. A claim is true, false, or null where nothing is decided.
"""
import argparse
import json
import math
import random
import sys
import time
from collections import Counter
from fractions import Fraction
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from judge import Verdict, judge_faces, squared_tolerance  # noqa: E402
from planar import Frame, segment_within, uncovered_line, uncovered_share  # noqa: E402
from reading import Malformed, Mesh, NotFinite, Numbers, obj_index, read, text_lines, words_of  # noqa: E402
from solid import (Flat, Hull, cross, dimension_of, dot, flat_polygon, integers, minus, squared_excess,  # noqa: E402
                   to_segment)
from surface import Surface  # noqa: E402

CLAIMS = ("parts-readable", "parts-finite", "parts-solid", "parts-convex", "covers-points", "covers-surface",
          "covers-solid", "within-solid", "parts-disjoint", "parts-needed")


def obj_parts(data, numbers):
    """(name, Mesh) of each object or group with the points that its faces use, and those under it that no face of the file uses;
    of faces without an object, all points. An object without points is none."""
    points, owners, groups = [], [], [("part_000", [])]
    for line in text_lines(data):
        words = words_of(line)
        if words[:1] == ["v"]:
            points.append(tuple(numbers.of_text(word) for word in words[1:4]))
            owners.append(len(groups) - 1)
        elif words[:1] == ["f"]:
            groups[-1][1].append([obj_index(word, len(points)) for word in words[1:]])
        elif words[:1] in (["o"], ["g"]):
            name = " ".join(words[1:])
            if len(groups) == 1 or groups[-1][0] != name:  # the same name twice in a row is one part
                groups.append((name, []))
    corners = {corner for _, faces in groups for face in faces for corner in face}
    if any(not 0 <= corner < len(points) for corner in corners):
        raise Malformed("the index of a point that is not there")
    loose, parts = {}, []
    for k, owner in enumerate(owners):
        if k not in corners and (owner > 0 or (len(groups) == 1 and corners)):
            loose.setdefault(owner, []).append(k)
    for number, (name, faces) in enumerate(groups):
        own = (*(c for face in faces for c in face), *loose.get(number, ()))
        used = {corner: k for k, corner in enumerate(dict.fromkeys(own))}
        if used:
            parts.append((name, Mesh([points[c] for c in used], [[used[c] for c in face] for face in faces])))
    return parts


def read_parts(path, kind="binary64"):
    path = Path(path)
    if path.is_dir():
        parts = [(file.name, read(file, kind)) for file in sorted(path.iterdir()) if file.suffix in (".obj", ".off", ".stl", ".ply")]
    else:
        parts = obj_parts(path.read_bytes(), Numbers(kind))
    if not parts:
        raise Malformed("no parts")
    return parts


class Part:
    """The hull of a part's points, of any dimension, as planes (normal, offset) that all its points are within."""

    def __init__(self, name, points, faces):
        self.name, self.faces, self.given = name, faces, points
        self.points = list(dict.fromkeys(points))
        self.low, self.high = tuple(map(min, zip(*self.points))), tuple(map(max, zip(*self.points)))
        self.hull, self.dimension = None, dimension_of(self.points)
        if self.dimension == 3:
            self.hull = Hull(self.points)
            self.vertices = [self.hull.points[v] for v in self.hull.vertices]
            self.planes = [(facet.normal, facet.offset) for facet in self.hull.facets]
        else:
            self._flat()

    def _flat(self):
        origin, ends = self.points[0], sorted(self.points)
        along = minus(ends[-1], ends[0])
        if self.dimension == 2:
            normal = next(n for n in (cross(along, minus(p, ends[0])) for p in self.points) if any(n))
            corners = [self.points[p] for p in flat_polygon(self.points, range(len(self.points)), normal)]
            self.vertices, across = corners, [normal]
            sides = [(cross(minus(v, u), normal), u) for u, v in zip(corners, corners[1:] + corners[:1])]
        elif self.dimension == 1:
            first = next(n for n in (cross(along, axis) for axis in ((1, 0, 0), (0, 1, 0))) if any(n))
            self.vertices, across = [ends[0], ends[-1]], [first, cross(along, first)]
            sides = [(along, ends[-1]), (minus((0, 0, 0), along), ends[0])]
        else:
            self.vertices, across, sides = [origin], [(1, 0, 0), (0, 1, 0), (0, 0, 1)], []
        self.planes = [(n, dot(n, p)) for n, p in sides]
        for normal in across:
            opposite = minus((0, 0, 0), normal)
            self.planes += [(normal, dot(normal, origin)), (opposite, dot(opposite, origin))]

    def contains(self, point):
        if any(x < a or x > b for x, a, b in zip(point, self.low, self.high)):
            return False
        for k, (normal, offset) in enumerate(self.planes):
            if dot(normal, point) > offset:
                self.planes.insert(0, self.planes.pop(k))  # the next point is likely to lie beyond it, too
                return False
        return True

    def contains_inside(self, point):
        """Whether a point with a weight, (x, y, z, w), lies in the interior."""
        return self.dimension == 3 and all(dot(n, point[:3]) < d * point[3] for n, d in self.planes)

    def meets_box(self, low, high):
        return all(a <= d and c <= b for a, b, c, d in zip(self.low, self.high, low, high))

    def box_distance(self, point):
        return sum(max(a - x, x - b, 0) ** 2 for x, a, b in zip(point, self.low, self.high))

    def squared_distance(self, point):
        beyond = [(n, d) for n, d in self.planes if dot(n, point) > d]
        if not beyond:
            return Fraction(0)
        if self.dimension == 3:
            return self.hull.squared_distance(point, self.hull.beyond(point))
        corners = self.vertices
        if self.dimension == 2:
            sides = len(self.planes) - len(corners)
            normal, offset = next(plane for plane in self.planes if all(dot(plane[0], c) == plane[1] for c in corners))
            if sides == 2 and all(dot(n, point) <= d for n, d in self.planes if any(dot(n, c) != d for c in corners)):
                return squared_excess(normal, offset, point)
        return min(to_segment(point, u, v) if u != v else Fraction(dot(minus(point, u), minus(point, u)))
                   for u, v in zip(corners, corners[1:] + corners[:1]))

    def convex_as_file(self, scale):
        """Closed, oriented, planar and convex by the definitions of judge.py; None if there are no faces."""
        if not self.faces:
            return None
        surface = Surface(self.given, self.faces)
        verdict = Verdict()
        if not surface.faces:
            return False
        judge_faces(verdict, surface, self.hull, scale, Fraction(0))
        return all(verdict.claims[name] is True for name in ("mesh-closed", "mesh-oriented", "mesh-planar", "mesh-convex"))


def nearest(point, parts, enough):
    """The squared distance to the nearest part; of one that is at most `enough`, an upper bound of it."""
    best = None
    for part in sorted(parts, key=lambda p: p.box_distance(point)):
        if best is not None and (part.box_distance(point) >= best or best <= enough):
            break
        distance = part.squared_distance(point)
        best = distance if best is None else min(best, distance)
    return best


def in_some(point, parts):
    """The part that holds a point, moved to the front; None if no part does."""
    for k, part in enumerate(parts):
        if part.contains(point):
            if k:
                parts.insert(0, parts.pop(k))
            return part
    return None


def judge_points(verdict, points, parts, scale, allowed):
    outside = [point for point in points if in_some(point, parts) is None]
    worst, at = Fraction(0), None
    for point in outside:
        distance = nearest(point, parts, worst)
        if distance > worst:
            worst, at = distance, point
    verdict.figures.update(points=len(points), points_outside=len(outside), squared_distance=worst / scale ** 2)
    if at:
        verdict.figures["farthest"] = [str(Fraction(x, scale)) for x in at]
    verdict.claims["covers-points"] = worst / scale ** 2 <= allowed


def uncovered_of(triangle, parts):
    """Which share of a triangle no part holds, exactly; of one without area, which share of its longest side."""
    a, b, c = triangle
    normal = cross(minus(b, a), minus(c, a))
    low, high = tuple(map(min, zip(*triangle))), tuple(map(max, zip(*triangle)))
    near = [part for part in parts if part.meets_box(low, high)]
    if any(all(part.contains(corner) for corner in triangle) for part in near):
        return Fraction(0)
    if not any(normal):
        ends = sorted(triangle)
        if ends[0] == ends[2]:
            return Fraction(1)
        found = (segment_within(ends[0], ends[2], part.planes) for part in near)
        return uncovered_line([interval for interval in found if interval])
    frame = Frame(normal, dot(normal, a))
    whole = frame.polygon(triangle)
    pieces = []
    for part in near:
        piece = whole.cut_all(frame.line_of(n, d) for n, d in part.planes)
        if piece is whole:
            return Fraction(0)
        if piece:
            pieces.append(piece)
    return uncovered_share(whole, pieces) if pieces else Fraction(1)


def judge_surface(verdict, triangles, parts):
    """Areas of single triangles are roots, so their sum is rounded; which ones are covered is not."""
    uncovered = total = 0.0
    count = 0
    for triangle in triangles:
        a, b, c = triangle
        normal = cross(minus(b, a), minus(c, a))
        area = math.sqrt(dot(normal, normal)) if dot(normal, normal) < 2 ** 1000 else float(math.isqrt(dot(normal, normal)))
        share = uncovered_of(triangle, parts)
        count += share > 0
        total += area
        uncovered += area * share
    verdict.figures.update(triangles=len(triangles), triangles_uncovered=count,
                           uncovered_area_share=uncovered / total if total else 0.0)
    verdict.claims["covers-surface"] = count == 0


def is_closed(triangles):
    """Whether every directed edge is cancelled by one in the opposite direction."""
    balance = Counter()
    for triangle in triangles:
        for tail, head in zip(triangle, triangle[1:] + triangle[:1]):
            balance[min(tail, head), max(tail, head)] += 1 if tail < head else -1
    return not any(balance.values())


def column(triangles, x, y):
    """(z, sign) where the surface meets the vertical line at x, y; None if that meets an edge or a corner."""
    found = []
    for low, high, triangle in triangles:
        if low[0] > x or high[0] < x or low[1] > y or high[1] < y:
            continue
        turns = [(b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]) for a, b in zip(triangle, triangle[1:] + triangle[:1])]
        if min(turns) > 0 or max(turns) < 0:
            a, b, c = triangle
            normal = cross(minus(b, a), minus(c, a))
            found.append((a[2] - (normal[0] * (x - a[0]) + normal[1] * (y - a[1])) / Fraction(normal[2]), 1 if normal[2] > 0 else -1))
        elif min(turns) >= 0 or max(turns) <= 0:
            return None
    return found


def solid_sample(triangles, parts, count):
    """A rational point of the solid that no part holds, on a grid of `count` lines each way; None if none is there."""
    points = [corner for triangle in triangles for corner in triangle]
    low, high = tuple(map(min, zip(*points))), tuple(map(max, zip(*points)))
    boxed = [(tuple(map(min, zip(*t))), tuple(map(max, zip(*t))), t) for t in triangles]

    def at(axis, k):
        return low[axis] + (high[axis] - low[axis]) * (Fraction(2 * k + 1, 2 * count) + Fraction(1, 997 + axis))
    for i in range(count):
        for j in range(count):
            x, y = at(0, i), at(1, j)
            crossings = column(boxed, x, y)
            for k in range(count if crossings else 0):
                z = at(2, k)
                if sum(sign for height, sign in crossings if height > z) and not any(part.contains((x, y, z)) for part in parts):
                    return x, y, z
    return None


def to_triangle(point, triangle):
    """The squared distance: of the plane above the triangle, elsewhere of the nearest side."""
    a, b, c = triangle
    normal, sides = cross(minus(b, a), minus(c, a)), ((a, b), (b, c), (c, a))
    if any(normal) and all(dot(cross(minus(v, u), minus(point, u)), normal) >= 0 for u, v in sides):
        return squared_excess(normal, dot(normal, a), point)
    return min(to_segment(point, u, v) if u != v else Fraction(dot(minus(point, u), minus(point, u))) for u, v in sides)


class Surroundings:
    """How far points are from a surface and, if it is closed, from what it winds about."""

    def __init__(self, triangles):
        self.boxed = [(tuple(map(min, zip(*t))), tuple(map(max, zip(*t))), t) for t in triangles]
        self.closed = is_closed(triangles)

    def squared_distance(self, point):
        """Exactly; of a point inside, 0."""
        best = None
        for low, high, triangle in self.boxed:
            beside = sum(max(a - x, x - b, 0) ** 2 for x, a, b in zip(point, low, high))
            if best is None or beside < best:
                distance = to_triangle(point, triangle)
                best = distance if best is None else min(best, distance)
        return Fraction(0) if best == 0 or self._winds_about(point, best) else best

    def _winds_about(self, point, squared):
        """A point on the line of an edge moves by less than its distance, which leads through no triangle."""
        if not self.closed:
            return False
        shift = Fraction(math.isqrt(squared.numerator * squared.denominator), 16 * squared.denominator)
        for part in range(50):
            x, y = point[0] + shift * Fraction(part, 97), point[1] + shift * Fraction(part * part, 4801)
            crossings = column(self.boxed, x, y)
            if crossings is not None:
                return sum(sign for height, sign in crossings if height > point[2]) != 0
        raise RuntimeError("a point on the lines of many edges")


def reach_sample(surroundings, parts, squared, count):
    """The farthest of the parts' vertices and of some other points of them, and its squared distance, if that is above `squared`."""
    chance, worst, at = random.Random(2604), squared, None
    for part in parts:
        corners = range(len(part.vertices))
        weights = [[1] * len(corners), *([int(k == own) for k in corners] for own in corners)]
        weights += [[chance.randrange(1, 100) ** 2 for _ in part.vertices] for _ in range(count)]
        for row in weights:
            point = tuple(Fraction(sum(w * v[k] for w, v in zip(row, part.vertices)), sum(row)) for k in range(3))
            distance = surroundings.squared_distance(point)
            if distance > worst:
                worst, at = distance, point
    return at, worst


def interiors_meet(first, second):
    """Of two solid parts: a facet of one with an area inside the other, or one within the other."""
    if not first.meets_box(second.low, second.high):
        return False
    for solid, other in ((first, second), (second, first)):
        total = tuple(map(sum, zip(*solid.vertices)))
        if other.contains_inside((*total, len(solid.vertices))):
            return True
        for facet in solid.hull.facets:
            frame = Frame(facet.normal, facet.offset)
            lines = [frame.line_of(n, d) for n, d in other.planes]
            if any(not a and not b and c >= 0 for a, b, c in lines):
                continue
            corners = [solid.hull.points[c] for c in facet.corners]
            if frame.polygon(corners).cut_all(lines):
                return True
    return False


def judge_among(verdict, parts):
    solids = [part for part in parts if part.dimension == 3]
    pairs = [(a.name, b.name) for k, a in enumerate(solids) for b in solids[k + 1:] if interiors_meet(a, b)]
    inner = [part.name for part in parts if any(other is not part and all(map(other.contains, part.vertices)) for other in parts)]
    verdict.figures.update(overlapping_pairs=len(pairs), parts_inner=inner)
    verdict.claims["parts-disjoint"] = not pairs
    verdict.claims["parts-needed"] = not inner


def judge_each(verdict, parts, scale):
    flat = [part.name for part in parts if part.dimension < 3]
    not_convex = [part for part in parts if part.convex_as_file(scale) is False]
    verdict.figures.update(
        parts=len(parts), parts_not_solid=flat, parts_not_convex=[part.name for part in not_convex],
        facets=[len(part.hull.facets) if part.hull else 2 * (part.dimension == 2) for part in parts],  # a polygon has two sides
        vertices=[len(part.vertices) for part in parts])
    verdict.claims["parts-solid"] = not flat
    # The faces of a flat part enclose nothing, so the claim is not about them.
    verdict.claims["parts-convex"] = all(part.dimension < 3 for part in not_convex)


def judge_parts(mesh, parts, tolerance="0", most=10 ** 9, samples=8, distance=None):
    """The verdict on a list of (name, Mesh) for a Mesh.

    With faces, the points that they use are to be held, otherwise all. Above `most` triangles the surface is not judged.
    A tolerance is applied to points only. That a solid is covered, or that parts are within a distance of it (`1e-6`, or
    `1e-9d` of the diameter), is never proven here, only refuted by a sample.
    """
    verdict = Verdict()
    verdict.claims = dict.fromkeys(CLAIMS)
    verdict.claims.update({"parts-readable": True, "parts-finite": True})
    (given, *groups), scale = integers(mesh.points, *(part.points for _, part in parts))
    judged = [Part(name, points, part.faces) for (name, part), points in zip(parts, groups)]
    used = [given[corner] for face in mesh.faces for corner in face] or given
    spans = [max(axis) - min(axis) for axis in zip(*used)]
    verdict.figures["squared_diameter"] = Fraction(dot(spans, spans), scale ** 2)
    judge_each(verdict, judged, scale)
    judge_among(verdict, judged)
    allowed = squared_tolerance(tolerance, verdict.figures["squared_diameter"])
    judge_points(verdict, list(dict.fromkeys(used)), list(judged), scale, allowed)
    triangles = [(given[face[0]], given[b], given[c]) for face in mesh.faces for b, c in zip(face[1:], face[2:])]
    if triangles and not allowed and len(triangles) <= most:
        judge_surface(verdict, triangles, judged)
    if triangles and len(triangles) <= most and is_closed(triangles):
        sample = solid_sample(triangles, judged, samples)
        if sample:
            verdict.claims["covers-solid"] = False
            verdict.figures["solid_sample"] = [str(x / scale) for x in sample]
    if triangles and distance is not None and len(triangles) <= most:
        limit = squared_tolerance(distance, verdict.figures["squared_diameter"])
        sample, squared = reach_sample(Surroundings(triangles), judged, limit * scale ** 2, samples)
        if sample:
            verdict.claims["within-solid"] = False
            verdict.figures["reach_sample"] = [str(x / scale) for x in sample]
            verdict.figures["squared_reach"] = squared / scale ** 2
    return verdict


def judge_part_files(mesh, path, numbers="binary64", **options):
    """As judge_parts(), of a file that may be unreadable."""
    try:
        parts = read_parts(path, numbers)
    except (Malformed, NotFinite) as fault:
        verdict = Verdict()
        verdict.claims = dict.fromkeys(CLAIMS)
        verdict.claims["parts-readable" if isinstance(fault, Malformed) else "parts-finite"] = False
        verdict.figures["reason"] = str(fault)
        return verdict
    return judge_parts(mesh, parts, **options)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("input")
    parser.add_argument("parts")
    parser.add_argument("--numbers", choices=("binary64", "binary32", "exact"), default="binary64")
    parser.add_argument("--tolerance", default="0", help="of points: 1e-6, or 1e-9d of the diameter")
    parser.add_argument("--distance", help="of parts from the solid: 0.05, or 0.03d of the diameter")
    parser.add_argument("--most", type=int, default=10 ** 9, help="triangles of the largest surface to be judged")
    parser.add_argument("--samples", type=int, default=8, help="lines each way of the grid in the solid (default 8)")
    options = parser.parse_args()
    start = time.monotonic()
    mesh = read(options.input, options.numbers)
    verdict = judge_part_files(mesh, options.parts, options.numbers, tolerance=options.tolerance, most=options.most,
                               samples=options.samples, distance=options.distance)
    verdict.figures["seconds"] = round(time.monotonic() - start, 3)
    json.dump(verdict.as_json(), sys.stdout, indent=1)
    print()
    return 1 if False in verdict.claims.values() else 0


if __name__ == "__main__":
    sys.exit(main())
