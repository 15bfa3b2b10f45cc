# SPDX-License-Identifier: MIT
"""Inputs to be refused, and inputs given as halfspaces."""
import math
import struct
from fractions import Fraction as F

from shapes import Draw, stretched


OBJ_POINTS = "v 0 0 0\nv 3 0 0\nv 0 4 0\nv 0 0 5\n"
OBJ_FACES = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"


# The points of files in which nothing but the faces is malformed: a program that reads points only
# may accept these.
SOUND_POINTS = [(0, 0, 0), (3, 0, 0), (0, 4, 0), (0, 0, 5)]
MALFORMED_FACES = [
    "obj-index-zero",
    "obj-index-beyond",
    "obj-index-negative",
    "off-index",
    "off-cut-off",
    "ply-index",
    "ply-fewer-faces",
    "ply-more-faces",
]


def malformed_inputs():
    """Yields name, title, bytes, format, error."""
    obj = OBJ_POINTS + OBJ_FACES
    off = (
        lambda counts, tail="3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n", last="0 0 5": f"OFF\n{counts}\n0 0 0\n3 0 0\n0 4 0\n{last}\n{tail}"
    )
    ply = lambda vertices, faces, tail="3 0 2 1\n3 0 1 3\n", last="0 0 5": (
        f"ply\nformat ascii 1.0\nelement vertex {vertices}\nproperty double x\nproperty double y\nproperty double z\nelement face {faces}\n"
        f"property list uchar int vertex_indices\nend_header\n0 0 0\n3 0 0\n0 4 0\n{last}\n{tail}"
    )
    stl = (
        lambda last: f"solid part\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 3 0 0\n   vertex {last}\n  endloop\n endfacet\nendsolid part\n"
    )
    yield "obj-nan", "NaN in an OBJ", obj + "v NaN 0 0\n", "obj", "not-finite"
    yield "obj-infinity", "Infinity in an OBJ", obj + "v 0 -Infinity 0\n", "obj", "not-finite"
    yield "obj-overflow", "A coordinate of 2e308 in an OBJ", obj + "v 0 0 2e308\n", "obj", "not-finite"
    yield "obj-index-zero", "Index 0 in an OBJ, which counts from 1", OBJ_POINTS + "f 0 1 2\n", "obj", "malformed"
    yield "obj-index-beyond", "An OBJ face that names a fifth of four points", OBJ_POINTS + "f 2 3 5\n", "obj", "malformed"
    yield "obj-index-negative", "A relative OBJ index before the first point", OBJ_POINTS + "f -1 -2 -9\n", "obj", "malformed"
    yield "obj-two-coordinates", "An OBJ point of two coordinates", OBJ_POINTS + "v 1 2\n" + OBJ_FACES, "obj", "malformed"
    yield "obj-cut-off", "An OBJ that ends within a number", OBJ_POINTS + "v 1 2 -", "obj", "malformed"
    yield "obj-comma", "Decimal commas in an OBJ", obj + "v 0,5 0,5 0,5\n", "obj", "malformed"
    yield "obj-comma-inside", "A thousands separator in an OBJ", obj + "v 1_000 0 0\n", "obj", "malformed"
    yield "obj-word", "A word for a number in an OBJ", obj + "v one 0 0\n", "obj", "malformed"
    yield "obj-two-signs", "A number with two signs in an OBJ", obj + "v --1 0 0\n", "obj", "malformed"
    yield "off-no-header", "An OFF file without its header", off("4 4 6")[4:], "off", "malformed"
    yield "off-more-points", "An OFF file that announces 6 points and holds 4", off("6 4 6"), "off", "malformed"
    yield "off-fewer-points", "An OFF file that announces 2 points and holds 4", off("2 4 6"), "off", "malformed"
    yield "off-many", "An OFF file that announces four thousand million points", off(
        "4000000000 4 6"
    ), "off", "malformed"
    yield "off-nan", "NaN in an OFF file", off("4 4 6", last="0 0 nan"), "off", "not-finite"
    yield "off-index", "An OFF polygon that names point 4 of 4", off("4 1 3", "3 1 2 4\n"), "off", "malformed"
    yield "off-cut-off", "An OFF file that ends within a polygon", off("4 4 6")[:-3], "off", "malformed"
    yield "off-empty", "An empty OFF file", "", "off", "malformed"
    yield "ply-no-magic", "A PLY file without its first line", ply(4, 2)[4:], "ply", "malformed"
    yield "ply-fewer-faces", "A PLY file that announces 1 face and holds 2", ply(4, 1), "ply", "malformed"
    yield "ply-more-faces", "A PLY file that announces 3 faces and holds 2", ply(4, 3), "ply", "malformed"
    yield "ply-infinity", "Infinity in a PLY file", ply(4, 2, last="0 0 inf"), "ply", "not-finite"
    yield "ply-index", "A PLY face that names point 7 of 4", ply(4, 2, "3 0 2 1\n3 0 1 7\n"), "ply", "malformed"
    yield "ply-header-only", "A PLY header without an end", ply(4, 2)[:70], "ply", "malformed"
    head = b"ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\nend_header\n"
    numbers = [0.0, 0, 0, 3, 0, 0, 0, 4, 0, 0, 0, 5]
    yield "ply-binary-cut-off", "A binary PLY file that lacks its last byte", (head + struct.pack("<12d", *numbers))[
        :-1
    ], "ply", "malformed"
    yield "ply-binary-nan", "NaN in a binary PLY file", head + struct.pack(
        "<12d", *numbers[:-1], math.nan
    ), "ply", "not-finite"
    yield "stl-cut-off", "A text STL that ends within a triangle", stl("0 4 0")[:70], "stl", "malformed"
    yield "stl-nan", "NaN in a text STL", stl("0 nan 0"), "stl", "not-finite"
    yield "stl-overflow", "A coordinate beyond the doubles in a text STL", stl("0 1e999 0"), "stl", "not-finite"
    triangle = struct.pack("<12fH", 0, 0, 1, 0, 0, 0, 3, 0, 0, 0, 4, 0, 0)
    yield "stl-binary-count", "A binary STL that announces 3 triangles and holds 1", b" " * 80 + struct.pack(
        "<I", 3
    ) + triangle, "stl", "malformed"
    yield "stl-binary-infinity", "Infinity in a binary STL", b" " * 80 + struct.pack("<I", 1) + struct.pack(
        "<12fH", 0, 0, 1, 0, 0, 0, 3, 0, 0, 0, math.inf, 0, 0
    ), "stl", "not-finite"
    yield "json-three", "A halfspace of three numbers in JSON", '{"halfspaces": [[1, 0, 0]]}', "json", "malformed"
    yield "json-cut-off", "JSON that ends within a row", '{"halfspaces": [[1, 0, 0, -1], [0, 1', "json", "malformed"
    yield "ine-count", "An .ine file that announces 5 rows and holds 4", "H-representation\nbegin\n5 4 integer\n1 -1 -1 -1\n0 1 0 0\n0 0 1 0\n0 0 0 1\nend\n", "ine", "malformed"
    yield "ine-vertices", "Vertices where halfspaces are expected in an .ine file", "V-representation\nbegin\n4 4 integer\n1 0 0 0\n1 1 0 0\n1 0 1 0\n1 0 0 1\nend\n", "ine", "malformed"


def flat_inputs():
    """Yields name, title, points, flags, level: they span no volume."""
    yield "nothing", "No points at all", [], [], 1
    yield "one-point", "One point", [(1, 2, 3)], [], 1
    yield "same-points", "Five copies of one point", [(0.5, -0.25, 8)] * 5, ["duplicates"], 1
    yield "two-points", "Two points", [(0, 0, 0), (1, 3, 2)], [], 1
    yield "line", "Points of a line along (1, 2, 3)", [(t, 2 * t, 3 * t) for t in (0, 1, 5, -7, 100, 1)], ["lattice"], 1
    yield "line-large", "Points of a line, up to 2^900", [
        (F(2) ** t, F(2) ** (t + 1), 3 * F(2) ** t) for t in (0, 1, 300, 900)
    ], ["scale", "mixed"], 2
    yield "triangle", "Three points", [(0, 0, 0), (1, 0, 0), (0, 1, 1)], [], 1
    yield "square-twice", "A square in space, twice", [(0, 0, 0), (2, 0, 1), (0, 2, 1), (2, 2, 2)] * 2, [
        "duplicates",
        "coplanar",
    ], 1
    yield "oblique-plane", "Forty integer points of the plane x + 2 y + 3 z = 5", [
        (5 - 2 * a - 3 * b, a, b) for a in range(-4, 4) for b in range(-2, 3)
    ], ["coplanar", "lattice"], 1
    draw = Draw(401)
    far = []
    for _ in range(15):
        a, b = draw.integer(1000), draw.integer(1000)
        far.append((2**40 + a, 2**40 + b, 2**40 + a - b))
    yield "plane-far", "Points of an oblique plane 2^40 from the origin", far, ["coplanar", "offset"], 2
    plane = [(F(draw.integer(2**20), 2**10), F(draw.integer(2**20), 2**10)) for _ in range(12)]
    yield "plane-fine", "Points of the plane x + y + z = 1/4 whose sums cancel", [
        (a, b, F(1, 4) - a - b) for a, b in plane
    ], ["coplanar", "near-coplanar"], 2
    yield "plane-subnormal", "Points of a plane, all coordinates subnormal", stretched(
        [(a, b, a + 2 * b) for a, b in ((0, 0), (1, 0), (0, 1), (5, 7), (9, 2))], [F(1, 2**1074)] * 3
    ), ["subnormal", "coplanar"], 3
    yield "plane-mixed", "Points of the plane x = z, 2^1000 to 2^-1000", [
        (F(2) ** e, F(2) ** -e, F(2) ** e) for e in (0, 1000, -1000, 500, 13)
    ], ["mixed", "coplanar"], 3
    yield "plane-needle", "A flat sliver: 2^80 long, 1 wide, no height", [
        (0, 0, 0),
        (2**80, 0, 0),
        (2**80, 1, 0),
        (0, 1, 0),
        (2**79, 0, 0),
    ], ["needle", "coplanar"], 2
    yield "circle", "Integer points of a circle in a plane", [
        (x, y, 7) for x in range(-5, 6) for y in range(-5, 6) if x * x + y * y == 25
    ], ["cospherical", "coplanar"], 1


def bad_halfspaces():
    """Yields name, title, rows, reason, flags, level, why."""
    walls = [[1, 0, 0, -1], [-1, 0, 0, -1], [0, 1, 0, -1], [0, -1, 0, -1], [0, 0, 1, -1], [0, 0, -1, -1]]
    yield "one-plane", "One halfspace", [[1, 2, 3, -4]], "unbounded", ["unbounded"], 1, "(-1, -2, -3) leads to infinity"
    yield "four-walls", "A square tube", walls[:4], "unbounded", [
        "unbounded",
        "parallel-edges",
    ], 1, "(0, 0, 1) leads to infinity"
    yield "five-walls", "A square tube with a floor", walls[:5], "unbounded", [
        "unbounded",
        "parallel-edges",
    ], 1, "(0, 0, -1) leads to infinity"
    yield "cone", "A cone of six planes", [
        [3, 0, -1, 0],
        [-3, 0, -1, 0],
        [0, 3, -1, 0],
        [0, -3, -1, 0],
        [2, 2, -1, 0],
        [-2, -2, -1, 0],
    ], "unbounded", ["unbounded", "valence"], 1, "(0, 0, 1) leads to infinity"
    yield "narrow-cone", "A tube that opens by 2^-60", [
        [2**60, 0, -1, -1],
        [-(2**60), 0, -1, -1],
        [0, 2**60, -1, -1],
        [0, -(2**60), -1, -1],
        [0, 0, -1, 0],
    ], "unbounded", ["unbounded", "needle"], 3, "(0, 0, 1) leads to infinity"
    yield "prism-no-lid", "A hexagonal tube with a floor", [
        [2, 1, 0, -4],
        [-2, 1, 0, -4],
        [0, -1, 0, -2],
        [2, -1, 0, -4],
        [-2, -1, 0, -4],
        [0, 1, 0, -2],
        [0, 0, -1, 0],
    ], "unbounded", ["unbounded", "parallel-edges"], 1, "(0, 0, 1) leads to infinity"
    yield "slab-planes", "Two parallel planes", [[1, 1, 1, -1], [-1, -1, -1, -1]], "unbounded", [
        "unbounded",
        "slab",
    ], 1, "(1, -1, 0) leads to infinity"
    yield "no-planes-far", "Three planes through a point, far away", [
        [1, 0, 0, -(10**15)],
        [0, 1, 0, -(10**15)],
        [0, 0, 1, -(10**15)],
    ], "unbounded", ["unbounded", "offset"], 2, "(-1, -1, -1) leads to infinity"
    yield "opposite", "x <= -1 and x >= 1", [[1, 0, 0, 1], [-1, 0, 0, 1], *walls[2:]], "empty", [
        "flat"
    ], 1, "the two rows add up to 2 <= 0"
    yield "opposite-narrowly", "x <= 0 and x >= 2^-80", [[1, 0, 0, 0], [-(2**80), 0, 0, 1], *walls[2:]], "empty", [
        "flat",
        "near-coplanar",
    ], 3, "2^80 times the first row and the second add up to 1 <= 0"
    yield "four-around-nothing", "Four planes of a simplex that look inward", [
        [-1, 0, 0, 1],
        [0, -1, 0, 1],
        [0, 0, -1, 1],
        [1, 1, 1, 0],
    ], "empty", ["flat"], 1, "the four rows add up to 3 <= 0"
    yield "impossible-row", "0 <= -1 among the walls of a cube", [*walls, [0, 0, 0, 1]], "empty", [
        "flat"
    ], 1, "the last row holds nowhere"
    yield "sheet", "A square without thickness", [[1, 0, 0, -1], [-1, 0, 0, 1], *walls[2:]], "flat", [
        "flat",
        "slab",
    ], 1, "the first two rows add up to 0 <= 0"
    yield "single-point", "Four planes that meet in one point from all sides", [
        [-1, 0, 0, 0],
        [0, -1, 0, 0],
        [0, 0, -1, 0],
        [1, 1, 1, 0],
    ], "flat", ["flat", "coplanar"], 1, "the four rows add up to 0 <= 0"
    yield "segment", "A square tube of no width", [
        [1, 0, 0, -3],
        [-1, 0, 0, 3],
        [0, 1, 0, -2],
        [0, -1, 0, 2],
        *walls[4:],
    ], "flat", ["flat"], 1, "the first two rows add up to 0 <= 0"


def solid_halfspaces():
    """Yields name, title, rows, faces, flags, level: bounded solids for simplify, redundant rows too."""
    walls = lambda a, b, c: [
        [1, 0, 0, -a],
        [-1, 0, 0, -a],
        [0, 1, 0, -b],
        [0, -1, 0, -b],
        [0, 0, 1, -c],
        [0, 0, -1, -c],
    ]
    yield "cut-corner", "A box with one corner cut", walls(3, 4, 5) + [[1, 1, 1, -10]], 4, [
        "unbounded",
        "parallel-edges",
    ], 1
    yield "two-cuts", "A box with two opposite corners cut differently", walls(2, 3, 4) + [
        [1, 1, 1, -8],
        [-1, -1, -1, -7],
    ], 4, ["unbounded", "parallel-edges"], 1
    yield "edge-cuts", "A box with four edges cut", walls(5, 5, 9) + [
        [1, 1, 0, -8],
        [1, -1, 0, -8],
        [-1, 1, 0, -8],
        [-1, -1, 0, -8],
    ], 6, ["unbounded", "parallel-edges", "ties"], 1
    yield "redundant", "A box, a plane that touches an edge and one far outside", walls(1, 2, 3) + [
        [1, 1, 0, -3],
        [1, 2, 3, -100],
        [1, 0, 1, -3],
    ], 4, ["unbounded", "parallel-edges"], 2
    yield "thirds", "A simplex cut in fractions", [
        [-1, 0, 0, 0],
        [0, -1, 0, 0],
        [0, 0, -1, 0],
        [1, 2, 3, -1],
        [F(1, 3), 0, 0, F(-2, 9)],
        [0, 0, 7, F(-5, 3)],
    ], 4, [], 2
    yield "same-plane-twice", "A prism with each row twice, once tripled", [
        row
        for row in [[2, 1, 0, -4], [-2, 1, 0, -4], [0, -1, 0, -1], [0, 0, 1, -2], [0, 0, -1, 0], [1, 1, 1, -5]]
        for row in (row, [3 * x for x in row])
    ], 4, ["duplicates", "parallel-edges"], 2
    yield "octagon-tube", "An octagonal prism", [
        [2, 1, 0, -9],
        [2, -1, 0, -9],
        [-2, 1, 0, -9],
        [-2, -1, 0, -9],
        [1, 2, 0, -9],
        [1, -2, 0, -9],
        [-1, 2, 0, -9],
        [-1, -2, 0, -9],
        [0, 0, 1, -2],
        [0, 0, -1, -2],
    ], 5, ["unbounded", "parallel-edges", "ties"], 2
    yield "tilted", "Planes tilted by 2^-50", [
        [2**50, 1, 0, -(2**50)],
        [-(2**50), 0, 1, -(2**50)],
        [1, 2**50, 0, -(2**50)],
        [0, -(2**50), 1, -(2**50)],
        [0, 1, 2**50, -(2**50)],
        [1, 0, -(2**50), -(2**50)],
        [1, 1, 1, F(-5, 2)],
    ], 4, ["near-coplanar", "unbounded"], 3
