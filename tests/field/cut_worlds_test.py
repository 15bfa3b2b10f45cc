# SPDX-License-Identifier: MIT
"""cut_worlds_test.py PROGRAM DATA [WORLDS] - a second judge, in Python, on the parts of `decompose --method cut`.

That parts hold the surface is decided in fractions. That they hold the solid, and are within the distance of it, is
only refuted, by a sample.
"""
import random
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from judge_parts import judge_part_files  # noqa: E402
from judge_parts_test import boundary  # noqa: E402
from reading import read  # noqa: E402

PROGRAM, DATA, WORLDS = sys.argv[1], Path(sys.argv[2]), int(sys.argv[3]) if len(sys.argv) > 3 else 30
DISTANCES = (("3%", "0.03d"), ("10%", "0.1d"), ("0.37", "0.37"))  # as decompose and as the judge spell them


class Cuts(unittest.TestCase):
    def check(self, path, distance):
        with tempfile.TemporaryDirectory() as folder:
            parts = Path(folder) / "parts.obj"
            subprocess.run([PROGRAM, "decompose", "--method", "cut", "--close", "never", path, "--distance", distance[0], "-o", parts,
                            "--measures", "none"], check=True, stdout=subprocess.DEVNULL)
            verdict = judge_part_files(read(str(path), "binary64"), str(parts), distance=distance[1])
        for claim in ("parts-readable", "parts-solid", "parts-convex", "covers-points", "covers-surface"):
            self.assertIs(verdict.claims[claim], True, claim)
        for claim in ("covers-solid", "within-solid"):
            self.assertIsNot(verdict.claims[claim], False, claim)

    def test_solids_of_cells(self):
        chance = random.Random(48)
        with tempfile.TemporaryDirectory() as folder:
            for world in range(WORLDS):
                cells = {tuple(chance.randrange(3) for _ in range(3)) for _ in range(chance.randrange(1, 9))}
                mesh, path = boundary(sorted(cells)), Path(folder) / "cells.obj"
                path.write_text("".join(f"v {x} {y} {z}\n" for x, y, z in mesh.points) +
                                "".join("f " + " ".join(str(corner + 1) for corner in face) + "\n" for face in mesh.faces), encoding="utf-8")
                with self.subTest(world=world):
                    self.check(path, chance.choice(DISTANCES))

    def test_hollow_things(self):
        for name in ("bin", "cup", "tube", "house"):
            with self.subTest(name=name):
                self.check(DATA / "cases" / f"{name}.obj", DISTANCES[0])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
