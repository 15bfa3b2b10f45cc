#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""An independent judge of enclosures: judge.py INPUT CANDIDATE [--numbers binary32|exact] [--tolerance T] [--asks hull].

Decides the claims of `convexact verify` by their definitions in integers and fractions, with Python's
standard library and no line of convexact. Prints one JSON object. A claim is true, false, or null where
the definition decides nothing.
"""
import argparse
import json
import sys
from fractions import Fraction
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from reading import Malformed, Mesh, NotFinite, read  # noqa: E402
from solid import Flat, Intersection, dot, hull_of, integers, squared_excess, without_inner  # noqa: E402
from surface import Surface  # noqa: E402

CLAIMS = ("candidate-readable", "candidate-finite", "candidate-solid", "candidate-bounded", "mesh-closed",
          "mesh-oriented", "mesh-planar", "mesh-convex", "contains-input")


def squared_tolerance(text, diameter):
    """`1e-6`, or `1e-9d` of the diameter, squared; `diameter` is squared as well."""
    if text.endswith("d"):
        return Fraction(text[:-1]) ** 2 * diameter
    return Fraction(text) ** 2


class Verdict:
    """What is decided; lengths are squared and in the unit of the files."""

    def __init__(self):
        self.claims = dict.fromkeys(CLAIMS)
        self.figures = {}

    def as_json(self):
        figures = {key: str(value) if isinstance(value, Fraction) else value for key, value in self.figures.items()}
        return {"claims": self.claims, **figures}


class Input:
    """The points that a candidate is to hold, repeats included, with their hull."""

    def __init__(self, points):
        self.points = list(points)
        (self.integers,), self.scale = integers(self.points)
        try:
            self.hull = hull_of(frozenset(self.integers))
        except Flat:
            self.hull = None

    def volume(self):
        """Of the hull; 0 if it is flat."""
        return Fraction(self.hull.volume6(), 6 * self.scale ** 3) if self.hull else Fraction(0)

    def squared_diameter(self):
        """Of the diagonal of the box."""
        spans = [max(axis) - min(axis) for axis in zip(*self.integers)]
        return Fraction(dot(spans, spans), self.scale ** 2)


def count_outside(verdict, points, planes, inner, scale):
    """By the definition: every point against every plane n.x <= d, in the unit 1/scale.

    `inner` are planes of a smaller solid, which spares the points deep inside.
    """
    outside, worst = [], Fraction(0)
    for point in without_inner(points, inner):
        beyond = [(n, d) for n, d in planes if dot(n, point) > d]
        if beyond:
            outside.append(point)
            worst = max([worst] + [squared_excess(n, d, point) for n, d in beyond])
    verdict.figures["outside"] = len(outside)
    verdict.figures["squared_excess"] = worst / scale ** 2
    return list(dict.fromkeys(outside))


def measure_distance(verdict, outside, hull, scale):
    distance = max((hull.squared_distance(p, hull.beyond(p)) for p in outside), default=Fraction(0))
    verdict.figures["squared_distance"] = Fraction(distance, 1) / scale ** 2


def judge_is_hull(verdict, given, corners, scale, tolerance):
    """Whether the solid with these corners, in the unit 1/scale, is the input's hull: both directed distances."""
    factor = scale // given.scale
    beyond = Fraction(0)
    for corner in corners:
        point = tuple(Fraction(x, factor) for x in corner)
        facets = given.hull.beyond(point)
        if facets:
            beyond = max(beyond, given.hull.squared_distance(point, facets))
    figures = verdict.figures
    figures["squared_hausdorff"] = max(beyond / given.scale ** 2, figures["squared_distance"])
    verdict.claims["is-hull"] = figures["squared_hausdorff"] <= tolerance


def judge_hull(verdict, hull, scale):
    verdict.figures.update(facets=len(hull.facets), vertices=len(hull.vertices),
                           most_facet_vertices=max(len(facet.corners) for facet in hull.facets),
                           volume=Fraction(hull.volume6(), 6 * scale ** 3))


def measure_cover(verdict, surface, hull, scale):
    """How far the volume that the faces enclose is from the hull's."""
    verdict.figures["volume_gap"] = Fraction(abs(surface.volume6() - hull.volume6()), 6 * scale ** 3)


def decide_convex(claims, figures, tolerance):
    """Simple faces in the planes of the hull's facets that cover it once; up to the tolerance, given as a square.

    Covering is asked of closed, oriented surfaces only; of others that lie in the hull's surface nothing is decided.
    """
    if figures["not_simple"] or figures["squared_concavity"] > tolerance or (figures["faces_off"] and not tolerance):
        return False
    if not claims["mesh-closed"] or not figures["consistent"]:
        return None
    if not figures["faces_off"]:
        return figures["volume_gap"] == 0
    # A closed surface near the hull's encloses nearly a multiple of its volume: nearly one.
    return 2 * figures["volume_gap"] < figures["volume"]


def judge_faces(verdict, surface, hull, scale, tolerance):
    """The claims about a surface; a tolerance forgives distances to planes, never a hole.

    Faces that all look inward are one fault, of mesh-oriented; for the others they are turned. (Those that enclose no volume
    look neither inward nor outward, and stay.)
    """
    claims = verdict.claims
    verdict.figures.update(without_area=surface.without_area(), not_simple=surface.not_simple(),
                           consistent=surface.is_consistent())
    claims["mesh-closed"] = surface.is_closed()
    if not verdict.figures["consistent"]:
        claims["mesh-oriented"] = False
    elif claims["mesh-closed"]:
        claims["mesh-oriented"] = surface.volume6() > 0
    bend = surface.bend()
    verdict.figures["squared_bend"] = bend / scale ** 2
    claims["mesh-planar"] = not verdict.figures["not_simple"] and bend / scale ** 2 <= tolerance
    if hull is None:
        return
    if claims["mesh-closed"] and verdict.figures["consistent"] and surface.volume6() < 0:
        surface = surface.turned_over()
    off, worst = surface.off_hull(hull)
    verdict.figures.update(faces_off=off, squared_concavity=worst / scale ** 2)
    measure_cover(verdict, surface, hull, scale)
    claims["mesh-convex"] = decide_convex(claims, verdict.figures, tolerance)


def judge_mesh(verdict, given, mesh, tolerance, asks_hull):
    claims = verdict.claims
    (points, tested), scale = integers(mesh.points, given.points)
    try:
        hull = hull_of(frozenset(points))
    except Flat as flat:
        claims["candidate-solid"], hull = False, None
        verdict.figures["dimension"] = flat.args[0]
    if hull:
        claims.update({"candidate-solid": True, "candidate-bounded": True})
        judge_hull(verdict, hull, scale)
        outside = count_outside(verdict, tested, [(f.normal, f.offset) for f in hull.facets], hull.inner, scale)
        measure_distance(verdict, outside, hull, scale)
        claims["contains-input"] = verdict.figures["squared_distance"] <= tolerance
        if asks_hull:
            judge_is_hull(verdict, given, [hull.points[v] for v in hull.vertices], scale, tolerance)
    else:
        # Without a solid there is no distance that a tolerance could forgive.
        claims["contains-input"] = False
        if asks_hull:
            claims["is-hull"] = False
    if mesh.faces:
        surface = Surface(points, mesh.faces)
        verdict.figures["dropped_faces"] = surface.dropped
        claims["mesh-closed"] = False  # of faces that are a point or an edge each
        if surface.faces:
            judge_faces(verdict, surface, hull, scale, tolerance)


def judge_rows(verdict, given, rows, tolerance, asks_hull):
    claims = verdict.claims
    solid = Intersection(rows.rows)
    claims["candidate-solid"] = solid.state in ("solid", "unbounded")
    claims["candidate-bounded"] = None if solid.state in ("empty", "flat") else solid.state != "unbounded"
    (tested, vertices), scale = integers(given.points, solid.vertices)
    planes = [(row[:3], -row[3] * scale) for row in solid.rows]
    outside = count_outside(verdict, tested, planes, [], scale)
    if solid.state == "solid":
        hull = hull_of(frozenset(vertices))
        judge_hull(verdict, hull, scale)
        measure_distance(verdict, outside, hull, scale)
        claims["contains-input"] = verdict.figures["squared_distance"] <= tolerance
        if asks_hull:
            judge_is_hull(verdict, given, vertices, scale, tolerance)
    else:
        if asks_hull:
            claims["is-hull"] = False
        claims["contains-input"] = not outside and solid.state != "empty"


def judge(given, candidate, tolerance="0", asks_hull=False):
    """The verdict on a Mesh or Rows as candidate for the points of an Input; `asks_hull` as `verify --asks hull`."""
    verdict = Verdict()
    verdict.claims.update({"candidate-readable": True, "candidate-finite": True})
    allowed = squared_tolerance(tolerance, given.squared_diameter())
    (judge_mesh if isinstance(candidate, Mesh) else judge_rows)(verdict, given, candidate, allowed, asks_hull)
    return verdict


def judge_files(given, path, numbers="binary64", tolerance="0", asks_hull=False):
    """As judge(), of a file that may be unreadable."""
    verdict = Verdict()
    try:
        candidate = read(path, numbers)
    except Malformed as fault:
        verdict.claims["candidate-readable"] = False
        verdict.figures["reason"] = str(fault)
        return verdict
    except NotFinite as fault:
        verdict.claims["candidate-finite"] = False
        verdict.figures["reason"] = str(fault)
        return verdict
    return judge(given, candidate, tolerance, asks_hull)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("input")
    parser.add_argument("candidate")
    parser.add_argument("--numbers", choices=("binary64", "binary32", "exact"), default="binary64")
    parser.add_argument("--tolerance", default="0")
    parser.add_argument("--asks", choices=("enclosure", "hull"), default="enclosure")
    options = parser.parse_args()
    given = Input(read(options.input, options.numbers).points)
    verdict = judge_files(given, options.candidate, options.numbers, options.tolerance, options.asks == "hull")
    json.dump(verdict.as_json(), sys.stdout, indent=1)
    print()
    return 1 if False in verdict.claims.values() else 0


if __name__ == "__main__":
    sys.exit(main())
