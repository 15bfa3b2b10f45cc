# SPDX-License-Identifier: MIT
"""The judge of trees of hulls against boxes in boxes, of which every fault is known."""
import copy
import json
import math
import random
import sys
import tempfile
import unittest
from fractions import Fraction
from itertools import combinations, product
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from judge_tree import Judged, StoredHull, Tree, judge_tree_file  # noqa: E402
from judge_parts_test import QUADS, box, random_part  # noqa: E402
from solid import dot, solve3  # noqa: E402


def hull_entry(low, high):
    mesh = box(low, high)
    return {"vertices": [list(point) for point in mesh.points], "faces": mesh.faces}


def good_tree():
    """Three boxes: two beside each other below node 1, the third above them."""
    parts = [((0, 0, 0), (1, 1, 1)), ((2, 0, 0), (3, 1, 1)), ((0, 0, 4), (1, 1, 5))]
    return {
        "parts": [{"name": f"part_{k:03d}", **hull_entry(*ends)} for k, ends in enumerate(parts)],
        "hull_tree": [
            {"node": 0, "parent": None, "children": [1, 2], "part": None, **hull_entry((0, 0, 0), (3, 1, 5))},
            {"node": 1, "parent": 0, "children": [3, 4], "part": None, **hull_entry((0, 0, 0), (3, 1, 1))},
            {"node": 2, "parent": 0, "children": [], "part": 2},
            {"node": 3, "parent": 1, "children": [], "part": 0},
            {"node": 4, "parent": 1, "children": [], "part": 1}]}


def judged(document):
    return Judged(Tree(document))


class Trees(unittest.TestCase):
    def assert_refused(self, change, *expected):
        """The faults after a change are exactly those that contain the words expected, one each."""
        document = copy.deepcopy(good_tree())
        change(document, document["hull_tree"])
        faults = judged(document).faults
        self.assertEqual(len(faults), len(expected), faults)
        for words in expected:
            self.assertTrue(any(words in fault for fault in faults), faults)

    def test_a_good_tree_is_accepted(self):
        verdict = judged(good_tree())
        self.assertEqual(verdict.faults, [])
        self.assertEqual(verdict.figures, {"nodes": 5, "parts": 3, "levels": 3, "points_tested": 32,
                                           "hulls_with_other_faces": 0})

    def test_a_single_part_is_its_own_root(self):
        document = good_tree()
        document["parts"] = document["parts"][:1]
        document["hull_tree"] = [{"node": 0, "parent": None, "children": [], "part": 0}]
        self.assertEqual(judged(document).faults, [])

    def test_a_corner_of_a_parent_moved_inward_by_an_ulp_is_refused(self):
        def move(_, nodes):  # the edge at x = 3, y = 1 now leans away from the child's corner (3, 1, 1)
            nodes[0]["vertices"][7][0] = math.nextafter(3, 0)
        self.assert_refused(move, "node 0 does not hold the point (3, 1, 1) of its child 1")

    def test_a_corner_of_a_child_moved_outward_by_an_ulp_is_refused(self):
        def move(document, _):
            document["parts"][1]["vertices"][7][1] = math.nextafter(1, 2)
        ulp = Fraction(math.nextafter(1, 2))
        self.assert_refused(move, f"node 1 does not hold the point (3, {ulp}, 1) of its child 4")

    def test_a_corner_of_a_child_may_move_inward_and_one_of_a_parent_outward(self):
        document = good_tree()
        document["parts"][1]["vertices"][7][1] = math.nextafter(1, 0)
        document["hull_tree"][0]["vertices"][7][0] = math.nextafter(3, 4)
        verdict = judged(document)
        self.assertEqual(verdict.faults, [])
        self.assertEqual(verdict.figures["hulls_with_other_faces"], 2)  # their squares are bent now

    def test_fractions_are_exact(self):
        document = good_tree()
        document["parts"][2]["vertices"] = [["-1/3" if x == 0 and k == 0 else x for k, x in enumerate(point)]
                                            for point in document["parts"][2]["vertices"]]
        faults = judged(document).faults
        self.assertEqual(faults, ["node 0 does not hold the point (-1/3, 0, 4) of its child 2"])
        for point in document["hull_tree"][0]["vertices"]:
            point[0] = "-1/3" if point[0] == 0 else point[0]
        self.assertEqual(judged(document).faults, [])

    def test_a_cycle_is_refused(self):
        def tie(_, nodes):
            nodes[0]["children"] = [2]
            nodes[1]["parent"] = 3
            nodes[3].update(children=[1], part=None, **hull_entry((0, 0, 0), (3, 1, 1)))
        self.assert_refused(tie, "3 nodes are not below the root", "part_000 has 0 leaves")

    def test_a_tree_without_a_root_is_refused(self):
        def tie(_, nodes):
            nodes[0]["parent"] = 1
            nodes[1]["children"].append(0)
        self.assert_refused(tie, "0 nodes have no parent", "5 nodes are not below the root")

    def test_two_roots_are_refused(self):
        def cut(_, nodes):
            nodes[0]["children"] = [1]
            nodes[2]["parent"] = None
        self.assert_refused(cut, "2 nodes have no parent")

    def test_a_missing_part_and_a_part_twice_are_refused(self):
        def leave_out(_, nodes):
            nodes[4]["part"] = 0
        self.assert_refused(leave_out, "part_001 has 0 leaves", "part_000 has 2 leaves")

        def add(document, _):
            document["parts"].append(document["parts"][0])
        self.assert_refused(add, "part_000 has 0 leaves")

    def test_a_wrong_parent_is_refused(self):
        def move(_, nodes):
            nodes[4]["parent"] = 0
        self.assert_refused(move, "node 1 is not the parent that its child 4 names",
                            "node 4 is not among the children of its parent 0")

    def test_leaves_and_branches_are_told_apart(self):
        def name_part(_, nodes):
            nodes[1]["part"] = 0
        self.assert_refused(name_part, "node 1 should have either", "part_000 has 2 leaves")

        def repeat(_, nodes):
            nodes[1]["children"] = [3, 4, 4]
        self.assert_refused(repeat, "node 1 names a child twice")

    def test_indices_that_are_not_there_are_refused(self):
        def name_child(_, nodes):
            nodes[1]["children"] = [3, 5]
        self.assert_refused(name_child, "node 1 names a node")

        def name_part(_, nodes):
            nodes[2]["part"] = 3
        self.assert_refused(name_part, "node 2 names a part")

    def test_what_the_file_says_of_its_levels_is_checked(self):
        document = good_tree()
        document["levels"] = [{"level": k, "nodes": n, "leaves": m, "volume": {"low": v, "high": v}}
                              for k, (n, m, v) in enumerate([(1, 0, 15.0), (2, 1, 4.0), (2, 2, 2.0)])]
        self.assertEqual(judged(document).faults, [])
        document["levels"][1].update(leaves=2)
        document["levels"][2]["volume"]["low"] = math.nextafter(2, 3)
        self.assertEqual(judged(document).faults, ["level 1 has 2 nodes and 1 leaves", "level 2 has the volume 2.0"])

    def test_files_are_read_and_others_are_told(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "tree.json"
            for text, words in ((json.dumps(good_tree()), None), ("{", "Malformed"), ('{"parts": []}', "Malformed"),
                                (json.dumps(good_tree()).replace("5.0", "NaN", 1), "NotFinite"),
                                (json.dumps(good_tree()).replace("5.0", "1e999", 1), "NotFinite")):
                path.write_text(text, encoding="utf-8")
                faults = judge_tree_file(path)["faults"]
                self.assertEqual(faults == [], words is None, faults)
                self.assertTrue(words is None or words in faults[0])


class Hulls(unittest.TestCase):
    CUBE = StoredHull(list(product((0, 2), repeat=3)), QUADS)

    def test_the_planes_are_those_of_the_faces_if_these_are_the_surface(self):
        self.assertTrue(self.CUBE.has_its_faces)
        self.assertEqual(self.CUBE.volume6(), 6 * 8)
        for faces in (QUADS[1:], [face[::-1] for face in QUADS], QUADS[:5] + [QUADS[5][::-1]], [],
                      [[0, 1, 3, 2], [0, 2, 3, 1]]):
            hull = StoredHull(self.CUBE.points, faces)
            self.assertFalse(hull.has_its_faces)
            self.assertEqual({n.index(max(n, key=abs)) for n, _ in hull.planes}, {0, 1, 2})
            self.assertEqual(hull.outside([(1, 1, 1), (3, 1, 1)])[0], (3, 1, 1))
        beyond = StoredHull(self.CUBE.points + [(1, 1, 3)], QUADS)
        self.assertFalse(beyond.has_its_faces)
        self.assertIsNone(beyond.outside([(1, 1, 3)]))

    def test_rays_by_hand(self):
        for ray, first in ((((-1, 1, 1), (1, 0, 0)), 1), (((1, 1, 1), (0, 0, 5)), 0), (((-1, 1, 1), (-1, 0, 0)), None),
                           (((-1, -1, 1), (3, 3, 0)), Fraction(1, 3)), (((-1, 2, 2), (2, 0, 0)), Fraction(1, 2)),
                           (((-1, 3, 1), (1, 0, 0)), None), (((4, 0, 1), (-1, 1, 0)), 2), (((4, 1, 1), (-1, 1, 0)), None)):
            self.assertEqual(self.CUBE.first_hit(*ray), first, ray)

    def test_boxes_meet_hulls_where_three_planes_of_both_meet_within_all(self):
        source = random.Random(5)
        met = 0
        for _ in range(60):
            part = random_part(source, 4)
            corners = sorted({tuple(p) for p in part.vertices})
            faces = [[corners.index(part.hull.points[c]) for c in facet.corners] for facet in part.hull.facets]
            hull = StoredHull(corners, faces)
            self.assertTrue(hull.has_its_faces)
            low = tuple(source.randint(-1, 4) for _ in range(3))
            high = tuple(x + source.randint(1, 2) for x in low)
            planes = [(*n, -d) for n, d in hull.planes]
            planes += [(*(s * (k == j) for k in range(3)), -s * bound[j]) for j in range(3) for s, bound in ((-1, low), (1, high))]
            places = filter(None, (solve3(rows) for rows in combinations(planes, 3)))
            truth = any(all(dot(row[:3], place) + row[3] <= 0 for row in planes) for place in places)
            self.assertEqual(hull.meets_box(low, high), truth)
            met += truth
        self.assertTrue(10 < met < 50, met)


if __name__ == "__main__":
    unittest.main()
