# SPDX-License-Identifier: MIT
"""Trees that the program has just built, before the independent judge: built_trees_test.py PROGRAM."""
import copy
import json
import math
import random
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction
from itertools import product
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from judge_tree import Judged, read_tree  # noqa: E402
from judge_parts_test import QUADS, boundary, box  # noqa: E402
from reading import to_binary32  # noqa: E402

PROGRAM = sys.argv.pop() if __name__ == "__main__" else "convexact"
DATA = Path(__file__).parents[1] / "data"


def obj_text(*meshes):
    lines, first = [], 1
    for k, mesh in enumerate(meshes):
        lines.append(f"o part_{k}")
        lines += ["v " + " ".join(repr(float(x)) for x in point) for point in mesh.points]
        lines += ["f " + " ".join(str(first + corner) for corner in face) for face in mesh.faces]
        first += len(mesh.points)
    return "\n".join(lines) + "\n"


class BuiltTrees(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def build(self, mesh, *options):
        """The tree of a run and what the judge found of it, after it was found without fault."""
        path = self.folder / "tree.json"
        subprocess.run([PROGRAM, "bvh", mesh, *options, "-o", path], check=True, capture_output=True)
        tree = read_tree(path)
        judged = Judged(tree)
        self.assertEqual(judged.faults, [])
        self.assertEqual(judged.figures["hulls_with_other_faces"], 0)
        self.assertEqual(len(tree.nodes), 2 * len(tree.parts) - 1)
        return tree, judged

    def test_spot_by_hacd(self):
        tree, _ = self.build(DATA / "spot.obj", "--max-parts", "6")
        self.assertEqual(tree.document["joins"], {"by_method": 5, "by_volume": 0})

    def test_spot_by_hacd_simplified(self):
        tree, _ = self.build(DATA / "spot.obj", "--max-parts", "6", "--faces", "12", "--leaf-faces", "20")
        for node, entry in zip(tree.nodes, tree.document["hull_tree"]):
            self.assertLessEqual(entry["facets"], 20 if node.part is not None else 12)

    def test_the_program_and_the_judge_agree_on_trees_with_a_corner_moved_by_an_ulp(self):
        """Without --faces, corners of a branch are those of children, so most moves of a parent's corner are refused."""
        tree, _ = self.build(DATA / "spot.obj", "--max-parts", "4", "--concavity", "20%", "--leaf-faces", "12")
        source, path, refused = random.Random(8), self.folder / "moved.json", 0
        for _ in range(24):
            document = copy.deepcopy(tree.document)
            entry = source.choice(document["parts"] + [node for node in document["hull_tree"] if node["part"] is None])
            point, axis = source.choice(entry["vertices"]), source.randrange(3)
            point[axis] = math.nextafter(point[axis], source.choice((-10, 10)))
            path.write_text(json.dumps(document), encoding="utf-8")
            ran = subprocess.run([PROGRAM, "verify", DATA / "spot.obj", path, "--claims", "tree-nested"], check=False,
                                 capture_output=True)
            faults = Judged(read_tree(path)).faults
            self.assertEqual(ran.returncode, 1 if faults else 0, faults)
            refused += ran.returncode
        self.assertTrue(6 < refused < 24, refused)

    def test_spot_by_acd(self):
        tree, _ = self.build(DATA / "spot.obj", "--method", "acd", "--max-parts", "6")
        self.assertEqual(len(tree.parts), 6)

    def test_spot_by_acd_simplified_in_binary32(self):
        tree, _ = self.build(DATA / "spot.obj", "--method", "acd", "--max-parts", "6", "--faces", "12", "--precision", "32")
        for x in (x for node in tree.nodes for point in node.points for x in point):
            self.assertEqual(x, to_binary32(Fraction(x)))

    def test_teapot_of_several_components_by_both(self):
        for method in ("hacd", "acd"):
            tree, _ = self.build(DATA / "teapot.obj", "--method", method, "--concavity", "10%", "--faces", "16")
            joins = tree.document["joins"]
            self.assertEqual(joins["by_method"] + joins["by_volume"], len(tree.parts) - 1)

    def test_bunny_by_acd(self):
        tree, _ = self.build(DATA / "bunny.obj", "--method", "acd", "--concavity", "20%", "--max-parts", "3", "--faces", "24",
                             "--leaf-faces", "40")
        self.assertEqual(len(tree.parts), 3)

    def test_a_thickened_sheet_in_the_plane_of_the_top_does_not_stick_out(self):
        """The hull of the given points ends at z = 1, and the thickened sheet is partly above."""
        sheet = box((2, 0, 1), (3, 1, 1))
        sheet.points, sheet.faces = sheet.points[::2], [[0, 2, 3, 1]]
        block = box((0, 0, 0), (1, 1, 1))
        parts, mesh = self.folder / "parts.obj", self.folder / "mesh.obj"
        parts.write_text(obj_text(block, sheet), encoding="utf-8")
        mesh.write_text(obj_text(boundary([(0, 0, 0)]), sheet), encoding="utf-8")
        for options in ((), ("--faces", "6"), ("--precision", "32")):
            tree, judged = self.build(mesh, "--from", parts, *options)
            self.assertEqual(tree.document["uncovered_pieces"], 0)
            leaf = next(node for node in tree.nodes if node.part == 1)
            root = next(node for node in tree.nodes if node.parent is None)
            self.assertGreater(max(z for _, _, z in leaf.points), 1)
            self.assertGreaterEqual(max(z for _, _, z in root.points), max(z for _, _, z in leaf.points))
            self.assertEqual(judged.figures["parts"], 2)

    def test_boxes_of_a_file_are_joined_where_that_adds_the_least(self):
        """Of four unit cubes in a row, the first two and the last two are an eighth apart, the pairs 8 and more."""
        ends = [(0, 0, 0), (1.125, 0, 0), (10, 0, 0), (11.125, 0, 0)]
        cubes = [box(low, [x + 1 for x in low]) for low in ends]
        path = self.folder / "cubes.obj"
        path.write_text(obj_text(*cubes), encoding="utf-8")
        tree, judged = self.build(path, "--from", path)
        self.assertEqual(judged.figures["levels"], 3)
        below = {frozenset(tree.nodes[child].part for child in node.children) for node in tree.nodes if node.parent == 0}
        self.assertEqual(below, {frozenset((0, 1)), frozenset((2, 3))})
        volumes = [(entry["volume"]["low"], entry["volume"]["high"]) for entry in tree.document["levels"]]
        for (low, high), exact in zip(volumes, (12.125, 4.25, 4)):
            self.assertTrue(low <= exact <= high)
        self.assertEqual(tree.document["joins"], {"by_method": 0, "by_volume": 3})
        self.assertEqual(sorted(product((0.0, 12.125), (0.0, 1.0), (0.0, 1.0))), sorted(map(tuple, tree.nodes[0].points)))
        self.assertEqual({len(face) for face in tree.nodes[0].faces}, {len(face) for face in QUADS})


if __name__ == "__main__":
    unittest.main()
