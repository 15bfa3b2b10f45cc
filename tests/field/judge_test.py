# SPDX-License-Identifier: MIT
"""The judge against closed forms: what it says of solids whose every figure is known."""
import struct
import sys
import tempfile
import unittest
from fractions import Fraction
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from judge import Input, judge, judge_files  # noqa: E402
from reading import Malformed, Mesh, NotFinite, Numbers, Rows, read, to_binary32  # noqa: E402
from solid import Flat, Hull, Intersection, cross, dot, minus  # noqa: E402

CUBE = [(x, y, z) for x in (0.0, 1.0) for y in (0.0, 1.0) for z in (0.0, 1.0)]
QUADS = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
CORNER = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)]
CORNER_FACES = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]


def verdict_on(points, faces, given=CUBE, tolerance="0"):
    return judge(Input(given), Mesh(points, faces), tolerance)


class Solids(unittest.TestCase):
    def test_cube_has_six_facets_eight_corners_volume_one(self):
        hull = Hull([(int(x), int(y), int(z)) for x, y, z in CUBE] + [(0, 0, 0)])
        self.assertEqual((len(hull.facets), len(hull.vertices), hull.volume6()), (6, 8, 6))

    def test_points_inside_facets_and_edges_are_no_vertices(self):
        grid = [(x, y, z) for x in range(5) for y in range(5) for z in range(5)]
        hull = Hull(grid)
        self.assertEqual((len(hull.facets), len(hull.vertices), hull.volume6()), (6, 8, 6 * 64))

    def test_sphere_grid_satisfies_euler(self):
        points = [(x, y, z) for x in range(-9, 10) for y in range(-9, 10) for z in range(-9, 10)
                  if x * x + y * y + z * z == 81]
        hull = Hull(points)
        edges = sum(len(facet.corners) for facet in hull.facets) // 2
        self.assertEqual(len(hull.vertices) - edges + len(hull.facets), 2)
        self.assertEqual(len(hull.vertices), len(points))

    def test_flat_sets_have_their_dimension(self):
        for points, dimension in (([], -1), ([(1, 2, 3)] * 3, 0), ([(0, 0, 0), (1, 1, 1), (2, 2, 2)], 1),
                                  ([(x, y, 0) for x in range(3) for y in range(3)], 2)):
            with self.assertRaises(Flat) as caught:
                Hull(points)
            self.assertEqual(caught.exception.args[0], dimension)

    def test_halfspaces_empty_flat_unbounded_solid(self):
        box = [(s * (k == 0), s * (k == 1), s * (k == 2), -1) for k in range(3) for s in (1, -1)]
        rows = [tuple(map(Fraction, row)) for row in box]
        self.assertEqual(Intersection(rows).state, "solid")
        self.assertEqual(Intersection(rows[1:]).state, "unbounded")
        self.assertEqual(Intersection([]).state, "unbounded")
        self.assertEqual(Intersection(rows + [(Fraction(1), Fraction(0), Fraction(0), Fraction(1))]).state, "flat")
        self.assertEqual(Intersection(rows + [(Fraction(1), Fraction(0), Fraction(0), Fraction(2))]).state, "empty")
        self.assertEqual(Intersection(rows + [(Fraction(0), Fraction(0), Fraction(0), Fraction(1))]).state, "empty")

    def test_a_wedge_is_as_far_as_its_edge_and_not_as_its_planes(self):
        # 0 <= x <= 1, |y| <= 10^-6 x, 0 <= z <= 1: the edge x = 0 is half a unit away.
        e = Fraction(1, 10 ** 6)
        rows = Rows([(Fraction(1), Fraction(0), Fraction(0), Fraction(-1)),
                     (-e, Fraction(1), Fraction(0), Fraction(0)), (-e, Fraction(-1), Fraction(0), Fraction(0)),
                     (Fraction(0), Fraction(0), Fraction(1), Fraction(-1)),
                     (Fraction(0), Fraction(0), Fraction(-1), Fraction(0))])
        verdict = judge(Input([(-0.5, 0.0, 0.0)]), rows, "1e-6")
        self.assertEqual(verdict.figures["squared_distance"], Fraction(1, 4))
        self.assertLess(verdict.figures["squared_excess"], Fraction(1, 10 ** 12))
        self.assertFalse(verdict.claims["contains-input"])

    def test_distance_to_facet_edge_and_corner(self):
        for point, squared in (((0.5, 0.5, 3.0), 4), ((0.5, 2.0, 2.0), 2), ((-1.0, -2.0, 3.0), 9), ((1.0, 1.0, 1.0), 0)):
            verdict = verdict_on(CUBE, QUADS, [point])
            self.assertEqual(verdict.figures["squared_distance"], squared)
            self.assertEqual(verdict.claims["contains-input"], squared == 0)

    def test_tolerance_counts_the_diameter_squared(self):
        given = CUBE + [(0.5, 0.5, 3.0)]  # diameter sqrt(11), distance 2
        self.assertFalse(verdict_on(CUBE, QUADS, given, "0.6d").claims["contains-input"])
        self.assertTrue(verdict_on(CUBE, QUADS, given, "0.61d").claims["contains-input"])
        self.assertTrue(verdict_on(CUBE, QUADS, given, "2").claims["contains-input"])


class Surfaces(unittest.TestCase):
    def claims(self, points, faces, *names):
        verdict = verdict_on(points, faces, CORNER)
        claims = {**verdict.claims, "mesh-simple": verdict.figures["not_simple"] == 0}
        return [claims["mesh-" + name] for name in names]

    def test_cube_holds_every_claim(self):
        verdict = verdict_on(CUBE, QUADS)
        self.assertEqual(set(verdict.claims.values()), {True})
        self.assertEqual(verdict.figures["volume"], 1)

    def test_a_zero_length_edge_and_a_triangle_without_area_are_nothing(self):
        points = CORNER + [(0.0, 0.0, 0.0)]
        faces = [[0, 2, 1], [0, 1, 3, 4], [4, 3, 2, 0], [1, 2, 3], [0, 4, 1], [4, 0, 0]]
        self.assertEqual(self.claims(points, faces, "closed", "oriented", "simple", "planar", "convex"), [True] * 5)

    def test_a_bow_tie_is_not_simple(self):
        top = [(0.0, 0.0, 1.0), (1.0, 0.0, 1.0), (1.0, 1.0, 1.0), (0.0, 1.0, 1.0)]
        self.assertEqual(self.claims(top + CORNER[:3], [[0, 2, 1, 3]], "simple"), [False])
        self.assertEqual(self.claims(top + CORNER[:3], [[0, 1, 2, 3]], "simple"), [True])

    def test_a_spike_is_neither_simple_nor_closed(self):
        faces = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3, 4, 3]]
        self.assertEqual(self.claims(CORNER + [(0.0, 0.0, 2.0)], faces, "simple", "closed"), [False, False])

    def test_a_straight_corner_is_simple(self):
        points = CORNER + [(0.5, 0.0, 0.0)]
        faces = [[0, 2, 1, 4], [0, 4, 1, 3], [0, 3, 2], [1, 2, 3]]
        self.assertEqual(self.claims(points, faces, "closed", "simple", "planar", "convex"), [True] * 4)

    def test_a_sliver_closes_a_t_junction_and_a_winding_one_does_not(self):
        points = CORNER + [(0.25, 0.0, 0.0), (0.5, 0.0, 0.0)]
        faces = [[0, 2, 1], [0, 4, 5, 1, 3], [0, 3, 2], [1, 2, 3]]
        claims = ("closed", "oriented", "simple", "planar", "convex")
        self.assertEqual(self.claims(points, faces + [[0, 1, 5, 4]], *claims), [True] * 5)
        self.assertEqual(self.claims(points, faces + [[0, 5, 4, 1]], "simple", "planar"), [False, False])

    def test_a_hole_and_a_double_cover_are_not_closed(self):
        self.assertEqual(self.claims(CORNER, CORNER_FACES[1:], "closed", "oriented"), [False, None])
        self.assertEqual(self.claims(CORNER, CORNER_FACES * 2, "closed", "oriented"), [False, False])

    def test_a_hull_is_as_far_as_the_worse_of_both_distances(self):
        given = Input(CUBE)
        high = Mesh([(x, y, 2 * z) for x, y, z in CUBE], QUADS)
        low = Mesh([(x, y, z / 4) for x, y, z in CUBE], QUADS)
        for mesh, squared in ((Mesh(CUBE, QUADS), 0), (high, 1), (low, Fraction(9, 16))):
            verdict = judge(given, mesh, asks_hull=True)
            self.assertEqual(verdict.figures["squared_hausdorff"], squared)
            self.assertEqual(verdict.claims["is-hull"], squared == 0)
        self.assertTrue(judge(given, high, "1", asks_hull=True).claims["is-hull"])
        self.assertNotIn("is-hull", judge(given, high).claims)

    def test_a_turned_face_and_an_inward_surface_are_not_oriented(self):
        turned = [CORNER_FACES[0][::-1]] + CORNER_FACES[1:]
        self.assertEqual(self.claims(CORNER, turned, "closed", "oriented"), [True, False])
        inward = [face[::-1] for face in CORNER_FACES]
        self.assertEqual(self.claims(CORNER, inward, "closed", "oriented", "convex"), [True, False, True])

    def test_a_dent_is_not_convex(self):
        points = CORNER + [(0.25, 0.25, 0.25)]
        faces = CORNER_FACES[:3] + [[1, 2, 4], [2, 3, 4], [3, 1, 4]]
        self.assertEqual(self.claims(points, faces, "closed", "oriented", "convex"), [True, True, False])

    def test_a_bent_quad_is_off_by_its_bend(self):
        points = CUBE[:7] + [(1.0, 1.0, 1.5)]
        verdict = verdict_on(points, QUADS)
        self.assertFalse(verdict.claims["mesh-planar"])
        self.assertGreater(verdict.figures["squared_bend"], 0)

    def test_faces_that_enclose_no_volume_are_not_turned(self):
        # Two pyramids over one triangle, to the same side and equally high.
        points = [(0, 0, 0), (2, 0, 0), (0, 2, 0), (0, 0, 2), (1, 1, 2)]
        faces = [(0, 1, 3), (1, 2, 3), (2, 0, 3), (1, 0, 4), (2, 1, 4), (0, 2, 4)]
        verdict = judge(Input(points), Mesh(points, faces))
        self.assertIs(verdict.claims["mesh-closed"], True)
        self.assertIs(verdict.claims["mesh-oriented"], False)
        worst = 0
        for a, b, c in ([points[corner] for corner in face] for face in faces):
            normal = cross(minus(b, a), minus(c, a))
            beyond = [dot(normal, minus(p, a)) for p in points]
            worst = max([worst] + [Fraction(x * x, dot(normal, normal)) for x in beyond if x > 0])
        self.assertEqual(verdict.figures["squared_concavity"], worst)


class Files(unittest.TestCase):
    def read(self, name, data, numbers="binary64"):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / name
            path.write_bytes(data)
            return read(path, numbers)

    def test_binary32_is_rounded_from_the_decimal_and_not_by_way_of_a_double(self):
        # Just above a tie between two floats; as a double it is the tie itself, which goes to the even one.
        word = "1.00000005960464477539062500001"
        self.assertEqual(Numbers("binary32").of_text(word), 1 + 2.0 ** -23)
        self.assertEqual(to_binary32(Fraction(float(word))), 1.0)

    def test_binary32_agrees_with_the_machine(self):
        for value in (0.1, -1e-45, 7e-46, 1e-39, 3.4028235e38, 16777217.0, -0.3, 1e-50):
            self.assertEqual(to_binary32(Fraction(value)), struct.unpack("f", struct.pack("f", value))[0])
        with self.assertRaises(NotFinite):
            to_binary32(Fraction(3.5e38))

    def test_all_formats_say_the_same(self):
        obj = b"v 0 0 0\nv 1 0 0 1\r\nv 0 1 0 .5 .5 .5 # c\nv 0 0 1\nf 1 3 2\nf 1/1 2/2 4/3\nf -4 \\\n-1 -2\nf 2//1 3//1 4 \\"
        off = b"OFF 4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3 255 0 0\n"
        ply = (b"ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
               b"property double z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n" +
               b"".join(struct.pack("<3d", *p) for p in CORNER) +
               b"".join(struct.pack("<B3i", 3, *f) for f in CORNER_FACES))
        stl = bytes(80) + struct.pack("<I", 4) + b"".join(
            struct.pack("<12fH", 0, 0, 0, *(x for k in f for x in CORNER[k]), 0) for f in CORNER_FACES)
        for name, data in (("a.obj", obj), ("a.off", off), ("a.ply", ply), ("a.stl", stl)):
            mesh = self.read(name, data)
            self.assertEqual(sorted(mesh.points), sorted(CORNER), name)
            self.assertEqual(set(judge(Input(CORNER), mesh).claims.values()), {True}, name)

    def test_what_is_malformed_is_said_to_be(self):
        for name, data in (("a.obj", b"v 0 0\n"), ("a.obj", b"v 0 0 0\nf 1 1 2\n"), ("a.obj", b"hello\n"),
                           ("a.txt", b"\n"), ("a.json", b"{}"), ("a.json", b"[]"),
                           ("a.off", b"OFF 1 0 0\n")):
            with self.assertRaises(Malformed):
                self.read(name, data)
        with self.assertRaises(NotFinite):
            self.read("a.obj", b"v 0 0 1e999\n")

    def test_rows_are_exact_and_decimals_are_doubles(self):
        rows = self.read("a.json", b'{"halfspaces": [["1/3", 0, 10000000000000000000001, 0.1]]}').rows
        self.assertEqual(rows, [(Fraction(1, 3), 0, 10 ** 22 + 1, Fraction(0.1))])

    def test_an_unreadable_file_is_a_verdict(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "a.obj"
            path.write_text("v 0 0 nan\n")
            self.assertFalse(judge_files(Input(CUBE), path).claims["candidate-finite"])


if __name__ == "__main__":
    unittest.main()
