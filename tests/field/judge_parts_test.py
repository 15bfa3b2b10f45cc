# SPDX-License-Identifier: MIT
"""The judge of decompositions against closed forms: boxes, of which every figure is known."""
import math
import random
import sys
import tempfile
import unittest
from fractions import Fraction
from itertools import combinations, product
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from judge_parts import Part, Surroundings, interiors_meet, judge_part_files, judge_parts, uncovered_of  # noqa: E402
from planar import Frame  # noqa: E402
from reading import Mesh  # noqa: E402
from solid import cross, dot, minus  # noqa: E402

QUADS = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]


def box(low, high):
    return Mesh(list(product(*zip(map(float, low), map(float, high)))), QUADS)


def unit(cell):
    return box(cell, [x + 1 for x in cell])


def boundary(cells):
    """The surface of a union of unit cells: each square with a cell on one side only, as two triangles."""
    points, faces = [], []
    for cell in cells:
        corners = unit(cell).points
        for quad in QUADS:
            centre = [sum(corners[c][k] for c in quad) / 4 for k in range(3)]
            beyond = tuple(int(math.floor(2 * m - x - 0.5)) for m, x in zip(centre, cell))
            if beyond not in cells:
                at = len(points)
                points += [corners[c] for c in quad]
                faces += [[at, at + 1, at + 2], [at, at + 2, at + 3]]
    return Mesh(points, faces)


def named(*meshes):
    return [(f"part_{k:03d}", mesh) for k, mesh in enumerate(meshes)]


L = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]
CROSS = [(1, 1, 1), (0, 1, 1), (2, 1, 1), (1, 0, 1), (1, 2, 1), (1, 1, 0), (1, 1, 2)]


def moved_point(mesh, corner, axis, towards):
    points = list(mesh.points)
    point = list(points[corner])
    point[axis] = math.nextafter(point[axis], towards)
    points[corner] = tuple(point)
    return Mesh(points, mesh.faces)


class Unions(unittest.TestCase):
    def claims(self, mesh, *parts, **options):
        verdict = judge_parts(mesh, named(*parts), **options)
        return verdict.claims, verdict.figures

    def test_the_boundary_of_the_cells_is_right(self):
        self.assertEqual(len(boundary(L).faces), 2 * 14)
        self.assertEqual(len(boundary(CROSS).faces), 2 * 30)

    def test_an_l_is_two_boxes(self):
        claims, figures = self.claims(boundary(L), box((0, 0, 0), (2, 1, 1)), unit((0, 1, 0)))
        self.assertEqual({name for name, holds in claims.items() if not holds},
                         {"covers-solid", "within-solid"})
        self.assertIsNone(claims["covers-solid"])
        self.assertIsNone(claims["within-solid"])
        self.assertEqual(figures["facets"], [6, 6])
        self.assertEqual(figures["uncovered_area_share"], 0)

    def test_the_box_of_an_l_reaches_out_of_it(self):
        # Its far edge is 1 from both arms. A void is outside, too: its middle is 1/2 from the cells around it.
        claims, figures = self.claims(boundary(L), box((0, 0, 0), (2, 2, 1)), distance="0.5")
        self.assertIs(claims["within-solid"], False)
        self.assertEqual(figures["squared_reach"], 1)
        self.assertEqual(figures["reach_sample"][:2], ["2", "2"])
        claims, _ = self.claims(boundary(L), box((0, 0, 0), (2, 2, 1)), distance="1")
        self.assertIsNone(claims["within-solid"])
        ring = [(x, y, z) for x, y, z in product(range(3), repeat=3) if (x, y, z) != (1, 1, 1)]
        claims, _ = self.claims(boundary(ring), box((0, 0, 0), (3, 3, 3)), distance="0.4")
        self.assertIs(claims["within-solid"], False)

    def test_an_l_without_its_arm_lacks_four_faces(self):
        claims, figures = self.claims(boundary(L), box((0, 0, 0), (2, 1, 1)))
        self.assertEqual((claims["covers-points"], claims["covers-surface"], claims["covers-solid"]), (False,) * 3)
        # The corners at y = 2 are a unit away. The five squares of the arm are left.
        self.assertEqual((figures["points_outside"], figures["squared_distance"]), (4, 1))
        self.assertEqual(figures["triangles_uncovered"], 10)
        self.assertAlmostEqual(figures["uncovered_area_share"], 5 / 14)

    def test_a_cross_without_its_middle_has_its_surface_and_lacks_a_seventh(self):
        arms = [unit(cell) for cell in CROSS[1:]]
        claims, figures = self.claims(boundary(CROSS), *arms)
        self.assertEqual((claims["covers-points"], claims["covers-surface"], claims["covers-solid"]), (True, True, False))
        self.assertTrue(all(1 < Fraction(x) < 2 for x in figures["solid_sample"]))
        claims, _ = self.claims(boundary(CROSS), *arms, unit(CROSS[0]))
        self.assertEqual((claims["covers-solid"], claims["parts-disjoint"], claims["parts-needed"]), (None, True, True))

    def test_a_plus_is_two_overlapping_bars(self):
        plus = [(1, 0, 0), (0, 1, 0), (1, 1, 0), (2, 1, 0), (1, 2, 0)]
        bars = [box((1, 0, 0), (2, 3, 1)), box((0, 1, 0), (3, 2, 1))]
        claims, figures = self.claims(boundary(plus), *bars)
        self.assertEqual((claims["covers-surface"], claims["parts-disjoint"], claims["parts-needed"]), (True, False, True))
        self.assertEqual(figures["overlapping_pairs"], 1)

    def test_boxes_that_share_an_edge_or_a_corner_are_disjoint(self):
        for other in ((1, 1, 0), (1, 1, 1), (1, 0, 0)):
            cells = [(0, 0, 0), other]
            claims, _ = self.claims(boundary(cells), *map(unit, cells))
            self.assertTrue(claims["covers-surface"] and claims["parts-disjoint"] and claims["parts-needed"])

    def test_a_part_in_another_or_equal_to_it_is_not_needed(self):
        for inner in (box((0, 0, 0), (1, 1, 0.5)), unit((0, 0, 0)), box((0.25, 0.25, 0.25), (0.5, 0.5, 0.5))):
            claims, figures = self.claims(boundary([(0, 0, 0)]), unit((0, 0, 0)), inner)
            self.assertEqual((claims["parts-needed"], claims["parts-disjoint"]), (False, False))
            self.assertIn("part_001", figures["parts_inner"])

    def test_a_part_shrunk_by_an_ulp_is_found_where_it_matters(self):
        ell = boundary(L)
        long, arm = box((0, 0, 0), (2, 1, 1)), unit((0, 1, 0))
        # The corner (2, 1, 1) is only the long box's. With u = 2^-52 it is beyond by u from the plane
        # x + u y + u z = 2 + u through three other corners, whose normal has the squared length 1 + 2 u^2.
        claims, figures = self.claims(ell, moved_point(long, 7, 0, -1), arm)
        self.assertEqual((claims["covers-points"], claims["covers-surface"]), (False, False))
        self.assertEqual((figures["points_outside"], figures["squared_distance"]), (1, Fraction(1, 2 ** 104 + 2)))
        # The arm may sink into the long box as far as it likes.
        arm = box((0, 0.5, 0), (1, 2, 1))
        claims, _ = self.claims(ell, long, moved_point(arm, 0, 1, 2))
        self.assertEqual((claims["covers-points"], claims["covers-surface"]), (True, True))

    def test_a_gap_of_an_ulp_between_parts_uncovers_the_surface_but_no_point(self):
        bar = Mesh(box((0, 0, 0), (2, 1, 1)).points, [f for q in QUADS for f in (q[:3], [q[0], *q[2:]])])
        below = box((0, 0, 0), (math.nextafter(1, 0), 1, 1))
        claims, figures = self.claims(bar, below, box((1, 0, 0), (2, 1, 1)))
        self.assertEqual((claims["covers-points"], claims["covers-surface"]), (True, False))
        self.assertEqual(figures["triangles_uncovered"], 8)
        claims, _ = self.claims(bar, box((0, 0, 0), (1, 1, 1)), box((1, 0, 0), (2, 1, 1)))
        self.assertTrue(claims["covers-surface"])

    def test_a_tolerance_forgives_distances_of_points(self):
        parts = [box((0, 0, 0), (2, 1, 1))]
        self.assertTrue(self.claims(boundary(L), *parts, tolerance="1")[0]["covers-points"])
        self.assertFalse(self.claims(boundary(L), *parts, tolerance="0.3d")[0]["covers-points"])
        self.assertTrue(self.claims(boundary(L), *parts, tolerance="0.34d")[0]["covers-points"])


class Triangles(unittest.TestCase):
    TRIANGLE = ((0, 0, 0), (4, 0, 0), (0, 4, 0))

    def share(self, *boxes, triangle=TRIANGLE):
        return uncovered_of(triangle, [Part("", [tuple(map(int, p)) for p in box(*ends).points], []) for ends in boxes])

    def test_shares_by_hand(self):
        self.assertEqual(self.share(((0, 0, -1), (2, 4, 1))), Fraction(1, 4))
        self.assertEqual(self.share(((0, 0, -1), (2, 2, 1))), Fraction(1, 2))
        self.assertEqual(self.share(((0, 0, -1), (2, 4, 1)), ((0, 0, -1), (4, 2, 1))), 0)
        self.assertEqual(self.share(((0, 0, -1), (1, 4, 1)), ((0, 0, -1), (4, 1, 1))), Fraction(1, 4))
        self.assertEqual(self.share(((5, 5, 5), (6, 6, 6))), 1)

    def test_parts_that_touch_from_below_or_lie_in_the_plane_hold_it(self):
        self.assertEqual(self.share(((0, 0, -1), (4, 4, 0))), 0)
        self.assertEqual(self.share(((0, 0, 0), (4, 4, 0))), 0)
        self.assertEqual(self.share(((0, 0, 1), (4, 4, 1))), 1)

    def test_tilted_triangles_are_the_same_seen_along_any_axis(self):
        for turn in range(3):
            tilted = tuple(tuple((p[(k + turn) % 3] for k in range(3))) for p in ((0, 0, 0), (4, 0, 4), (0, 4, 4)))
            ends = tuple(tuple((p[(k + turn) % 3] for k in range(3))) for p in ((0, 0, 0), (2, 4, 9)))
            self.assertEqual(self.share(ends, triangle=tilted), Fraction(1, 4))
            self.assertEqual(self.share(ends, triangle=tilted[::-1]), Fraction(1, 4))

    def test_triangles_without_area_are_their_longest_sides(self):
        sliver = ((0, 0, 0), (4, 0, 0), (1, 0, 0))
        self.assertEqual(self.share(((0, -1, -1), (1, 1, 1)), triangle=sliver), Fraction(3, 4))
        self.assertEqual(self.share(((0, -1, -1), (1, 1, 1)), ((1, 0, 0), (4, 1, 1)), triangle=sliver), 0)
        self.assertEqual(self.share(((1, 0, 0), (2, 1, 1)), triangle=((0, 0, 0),) * 3), 1)


def random_part(source, most):
    """The hull of some points of a small grid, so that many are coplanar with others."""
    while True:
        points = [tuple(source.randint(0, most) for _ in range(3)) for _ in range(source.randint(4, 7))]
        part = Part("", points, [])
        if part.dimension == 3:
            return part


def area(polygon):
    corners = [(Fraction(x, w), Fraction(y, w)) for x, y, w in polygon.corners] if polygon else []
    return sum((p[0] * q[1] - p[1] * q[0] for p, q in zip(corners, corners[1:] + corners[:1])), Fraction(0)) / 2


class Laws(unittest.TestCase):
    def test_uncovered_shares_are_those_of_inclusion_and_exclusion(self):
        source = random.Random(17)
        for _ in range(150):
            a, b, c = triangle = [tuple(source.randint(0, 4) for _ in range(3)) for _ in range(3)]
            normal = cross(minus(b, a), minus(c, a))
            if not any(normal):
                continue
            parts = [random_part(source, 5) for _ in range(source.randint(1, 4))]
            frame = Frame(normal, dot(normal, a))
            whole = frame.polygon(triangle)
            covered = Fraction(0)
            for size in range(1, len(parts) + 1):
                for some in combinations(parts, size):
                    lines = [frame.line_of(n, d) for part in some for n, d in part.planes]
                    covered -= (-1) ** size * area(whole.cut_all(lines))
            self.assertEqual(uncovered_of(triangle, parts), 1 - covered / area(whole))

    def test_interiors_meet_where_points_of_a_finer_grid_lie_in_both(self):
        source = random.Random(4)
        grid = list(product(range(1, 24, 2), repeat=3))
        met = 0
        for _ in range(60):
            first, second = random_part(source, 3), random_part(source, 3)
            in_both = any(first.contains_inside((*p, 8)) and second.contains_inside((*p, 8)) for p in grid)
            meets = interiors_meet(first, second)
            met += meets
            self.assertEqual(meets, interiors_meet(second, first))
            self.assertFalse(in_both and not meets)
            if meets:  # the separating direction is one of facets or of two edges: none of the facets'
                for solid, other in ((first, second), (second, first)):
                    self.assertTrue(all(any(dot(n, v) < d for v in other.vertices) for n, d in solid.planes))
        self.assertTrue(0 < met < 60)


class Distances(unittest.TestCase):
    def test_above_an_edge_however_near(self):
        # The vertical line through the middle meets the diagonals of the upper and the lower square.
        cube = boundary([(0, 0, 0)])
        around = Surroundings([tuple(tuple(map(int, cube.points[c])) for c in face) for face in cube.faces])
        self.assertTrue(around.closed)
        for height in (Fraction(1), Fraction(1, 2 ** 30), Fraction(1, 2 ** 50), Fraction(1, 2 ** 200)):
            above, below = ((Fraction(1, 2), Fraction(1, 2), z) for z in (1 + height, 1 - height / 4))
            self.assertEqual(around.squared_distance(above), height ** 2)
            self.assertEqual(around.squared_distance(below), 0)


class Parts(unittest.TestCase):
    def test_distances_to_flat_parts(self):
        square = Part("", [(0, 0, 0), (4, 0, 0), (4, 4, 0), (0, 4, 0), (2, 2, 0)], [])
        edge = Part("", [(0, 0, 0), (4, 0, 0), (1, 0, 0)], [])
        point = Part("", [(0, 0, 0)] * 2, [])
        self.assertEqual([square.dimension, edge.dimension, point.dimension], [2, 1, 0])
        for part, place, squared in ((square, (2, 1, 3), 9), (square, (6, 2, 0), 4), (square, (6, 7, 1), 14),
                                     (edge, (2, 3, 0), 9), (edge, (6, 0, 1), 5), (point, (1, 2, 2), 9), (edge, (3, 0, 0), 0)):
            self.assertEqual(part.squared_distance(place), squared)
            self.assertEqual(part.contains(place), squared == 0)

    def test_a_flat_part_and_a_turned_face_are_told(self):
        flat = Mesh([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)], [[0, 1, 2]])
        turned = Mesh(unit((0, 0, 0)).points, [QUADS[0][::-1], *QUADS[1:]])
        verdict = judge_parts(boundary([(0, 0, 0)]), named(unit((0, 0, 0)), flat, turned))
        self.assertEqual(verdict.figures["parts_not_solid"], ["part_001"])
        self.assertIn("part_002", verdict.figures["parts_not_convex"])
        self.assertNotIn("part_000", verdict.figures["parts_not_convex"])
        self.assertFalse(verdict.claims["parts-solid"] or verdict.claims["parts-convex"])

    def test_the_faces_of_flat_parts_are_not_judged(self):
        flat = Mesh([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)], [[0, 1, 2]])
        verdict = judge_parts(boundary([(0, 0, 0)]), named(unit((0, 0, 0)), flat))
        self.assertTrue(verdict.claims["parts-convex"])
        self.assertFalse(verdict.claims["parts-solid"])

    def test_files_with_objects_are_read_and_others_are_malformed(self):
        cube = "".join(f"v {x} {y} {z}\n" for x, y, z in unit((0, 0, 0)).points)
        faces = "".join("f " + " ".join(str(c + 1) for c in quad) + "\n" for quad in QUADS)
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "parts.obj"
            path.write_text(f"{cube}o part_000\n{faces}o empty\no part_001\n{faces}")
            verdict = judge_part_files(unit((0, 0, 0)), path)
            self.assertEqual((verdict.figures["parts"], verdict.claims["parts-needed"]), (2, False))
            path.write_text(cube)
            self.assertFalse(judge_part_files(unit((0, 0, 0)), path).claims["parts-readable"])
            # Points under an object that no face uses are its own; the same name twice in a row is one part.
            path.write_text(f"{cube}o a\nv 0.5 0.5 3\n{faces}o b\n{cube}o b\nv 0.5 0.5 9\n")
            self.assertEqual(judge_part_files(unit((0, 0, 0)), path).figures["vertices"], [9, 9])
            # Of faces without an object all points count.
            path.write_text(f"{cube}v 0.5 0.5 3\n{faces}")
            self.assertEqual(judge_part_files(unit((0, 0, 0)), path).figures["vertices"], [9])
            path.write_text(cube.replace("v 0.0", "v nan", 1) + faces)
            self.assertFalse(judge_part_files(unit((0, 0, 0)), path).claims["parts-finite"])


if __name__ == "__main__":
    unittest.main()
