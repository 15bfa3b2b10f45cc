# SPDX-License-Identifier: MIT
"""reach_worlds_test.py PROGRAM [WORLDS] - two judges on how far parts reach from solids of grid cells.

The program decides by an octree; the judge in Python by the definition: each witness is tested in fractions, and no
point that the judge draws refutes what the program holds for true.
"""
import json
import random
import subprocess
import sys
import unittest
from fractions import Fraction
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from judge_parts import Part, Surroundings, reach_sample  # noqa: E402
from judge_parts_test import boundary  # noqa: E402

PROGRAM, WORLDS = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 2000
LIMITS = ("0.17", "0.37", "0.61", "0.83", "1.13")  # no distance that cells and quarters have


class World:
    """Cells of a grid of 3, and the hulls of a few points on the quarters of it."""

    def __init__(self, chance):
        cells = {tuple(chance.randrange(3) for _ in range(3)) for _ in range(chance.randrange(1, 9))}
        self.mesh = boundary(sorted(cells))
        self.parts = [[[chance.randrange(13) / 4 for _ in range(3)] for _ in range(chance.randrange(1, 7))]
                      for _ in range(chance.randrange(1, 4))]
        self.limit = chance.choice(LIMITS)

    def request(self):
        return json.dumps({"points": [list(p) for p in self.mesh.points], "triangles": self.mesh.faces,
                           "candidate": {"parts": [{"vertices": part} for part in self.parts]},
                           "distance": self.limit, "claims": ["within-solid"]})

    def surroundings(self):
        points = [tuple(map(Fraction, p)) for p in self.mesh.points]
        return Surroundings([tuple(points[corner] for corner in face) for face in self.mesh.faces])

    def judged_parts(self):
        # In quarters: the judge's hulls take integers.
        return [Part(f"part_{k}", [tuple(int(4 * x) for x in p) for p in part], [])
                for k, part in enumerate(self.parts)]


class Worlds(unittest.TestCase):
    def test_the_judges_agree(self):
        chance = random.Random(47)
        worlds = [World(chance) for _ in range(WORLDS)]
        told = subprocess.run([PROGRAM, "verify", "--stdio"], input="\n".join(w.request() for w in worlds) + "\n",
                              capture_output=True, text=True, check=False).stdout.splitlines()
        self.assertEqual(len(told), len(worlds))
        seen = {"holds": 0, "violated": 0, "undecided": 0}
        for k, (world, line) in enumerate(zip(worlds, told)):
            claim = next(c for c in json.loads(line)["claims"] if c["code"] == "within-solid")
            seen[claim["status"]] += 1
            with self.subTest(world=k, limit=world.limit, sentence=claim["sentence"]):
                self.compare(world, claim)
        print(f"{WORLDS} worlds: {seen}", file=sys.stderr)
        self.assertGreater(seen["holds"], WORLDS // 20)
        self.assertGreater(seen["violated"], WORLDS // 4)
        self.assertLess(seen["undecided"], WORLDS // 50)

    def compare(self, world, claim):
        parts, surroundings, squared = world.judged_parts(), world.surroundings(), Fraction(world.limit) ** 2
        if claim["status"] == "violated":
            point = tuple(Fraction(x) for x in claim["witness"]["point"])
            part = parts[claim["witness"]["parts"][0]]
            self.assertTrue(part.contains(tuple(4 * x for x in point)))
            self.assertGreater(surroundings.squared_distance(point), squared)
            self.assertEqual(surroundings.squared_distance(point), Fraction(claim["witness"]["distance"]["squared"]))
        elif claim["status"] == "holds":
            scaled = [type("Drawn", (), {"vertices": [tuple(Fraction(x, 4) for x in v) for v in p.vertices]}) for p in parts]
            sample, _ = reach_sample(surroundings, scaled, squared, 8)
            self.assertIsNone(sample)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
