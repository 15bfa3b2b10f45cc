# SPDX-License-Identifier: MIT
"""The judge against the conformance vectors, whose answers come from formulas, from lrs and from brute force."""
import json
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from judge import Input, judge, judge_files  # noqa: E402
from reading import Mesh, Rows, file_bytes, scaled_exact, vector_number  # noqa: E402
from solid import Intersection  # noqa: E402

FOLDER = Path(__file__).parent.parent / "vectors"


def vectors(ask):
    for path in sorted(FOLDER.glob("*.json")):
        for vector in json.loads(path.read_text())["vectors"]:
            if vector["question"]["ask"] == ask and "points" in vector["input"]:
                yield vector, Input([tuple(map(vector_number, point)) for point in vector["input"]["points"]])


def verdict_on(given, candidate):
    if "points" in candidate:
        return judge(given, Mesh([tuple(map(vector_number, p)) for p in candidate["points"]], candidate["faces"]))
    if "halfspaces" in candidate:
        return judge(given, Rows([tuple(map(scaled_exact, row)) for row in candidate["halfspaces"]]))
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"candidate.{candidate['format']}"
        path.write_bytes(file_bytes(candidate))
        return judge_files(given, path)


def inner_verdict_on(vector):
    """Whether a candidate lies inside: its corners take the place of the input, and the input is what shall hold them."""
    candidate = vector["question"]["candidate"]
    if "points" in candidate:
        corners = [tuple(map(vector_number, point)) for point in candidate["points"]]
    else:
        corners = Intersection([tuple(map(scaled_exact, row)) for row in candidate["halfspaces"]]).vertices
    verdict = verdict_on(Input(corners), {"points": vector["input"]["points"], "faces": []})
    verdict.claims = {"inside-input": verdict.claims["contains-input"]}
    return verdict


class Vectors(unittest.TestCase):
    def test_hulls_have_the_known_counts_and_volumes(self):
        for vector, given in vectors("hull"):
            with self.subTest(vector["id"]):
                expected = vector["expected"]
                self.assertEqual((len(given.hull.facets), len(given.hull.vertices)),
                                 (expected["facets"], expected["vertices"]))
                self.assertEqual(given.volume(), scaled_exact(expected["volume"]))

    def test_candidates_get_the_known_verdicts(self):
        for vector, given in vectors("verify"):
            with self.subTest(vector["id"]):
                question, expected = vector["question"], vector["expected"]
                is_inner = question.get("inner", False)
                verdict = inner_verdict_on(vector) if is_inner else verdict_on(given, question["candidate"])
                for claim, status in expected["claims"].items():
                    if claim in verdict.claims:
                        self.assertEqual(verdict.claims[claim], status == "holds", claim)
                if "outside" in expected:
                    self.assertEqual(verdict.figures["outside"], expected["outside"]["points"])
                    self.assertIn(scaled_exact(expected["outside"]["squared_distance"]),
                                  (verdict.figures.get("squared_distance"), verdict.figures["squared_excess"]))


if __name__ == "__main__":
    unittest.main()
