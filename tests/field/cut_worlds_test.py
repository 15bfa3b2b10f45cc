# SPDX-License-Identifier: MIT
"""cut_worlds_test.py PROGRAM DATA [WORLDS] - a second judge, in Python, on the parts of `decompose --method cut`.

That parts hold the surface is decided in fractions. That they hold the solid, and are within the distance of it, is
only refuted, by a sample. The solids are of grid cells, straight, tilted, thin and as needles, some with corners on edges
(T-junctions), and crossing prisms over polygons.
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
from reading import Mesh, read  # noqa: E402
from solid import dimension_of, flat_polygon  # noqa: E402

PROGRAM, DATA, WORLDS = sys.argv[1], Path(sys.argv[2]), int(sys.argv[3]) if len(sys.argv) > 3 else 24
DISTANCES = (("3%", "0.03d"), ("10%", "0.1d"), ("0.37", "0.37"))  # as decompose and as the judge spell them


MATRICES = {"straight": ((1, 0, 0), (0, 1, 0), (0, 0, 1)), "tilted": ((2, 1, 0), (-1, 2, 1), (0, -1, 2)),
            "thin": ((1, 0, 0), (0, 1, 0), (0, 0, 2 ** -9)), "needle": ((1, 0, 0), (0, 2 ** -6, 0), (0, 0, 2 ** -6))}


def some_cells(chance):
    cells = {tuple(chance.randrange(3) for _ in range(3)) for _ in range(chance.randrange(1, 9))}
    return boundary(sorted(cells))


def crossing(chance):
    """Two or three prisms over convex polygons of integers, each closed; what they share lies in both."""
    points, faces = [], []
    for _ in range(chance.randrange(2, 4)):
        flat = []
        while dimension_of(flat) < 2:
            spots = list({(chance.randrange(6), chance.randrange(6)) for _ in range(7)})
            flat = [(x, y, 0) for x, y in spots]
        outline = [spots[k] for k in flat_polygon(flat, range(len(flat)), (0, 0, 1))]
        low, high = sorted(chance.sample(range(6), 2))
        turn = chance.randrange(3)  # the axis of the prism
        first, count = len(points), len(outline)
        for z in (low, high):
            points += [tuple(((x, y, z) * 2)[turn:turn + 3]) for x, y in outline]
        faces += [[first + k for k in reversed(range(count))], [first + count + k for k in range(count)]]
        faces += [[first + k, first + (k + 1) % count, first + count + (k + 1) % count, first + count + k] for k in range(count)]
    return Mesh(points, faces)


def with_junctions(chance, mesh):
    """Some edges with a corner in the middle that only one of their two faces has."""
    points, faces = list(mesh.points), []
    for face in mesh.faces:
        if chance.randrange(2):
            faces.append(face)
            continue
        a, b, c, *others = face
        middle = len(points)
        points.append(tuple((x + y) / 2 for x, y in zip(points[a], points[b])))
        faces += [[middle, b, c], [a, middle, c, *others]]
    return Mesh(points, faces)


def some_solid(chance, world):
    """Of all 24 kinds in turn."""
    mesh = crossing(chance) if world % 3 == 0 else some_cells(chance)
    if world // 3 % 2 == 0:
        mesh = with_junctions(chance, mesh)
    matrix = MATRICES[sorted(MATRICES)[world // 6 % len(MATRICES)]]
    return Mesh([tuple(sum(m * x for m, x in zip(row, point)) for row in matrix) for point in mesh.points], mesh.faces)


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

    def test_solids(self):
        chance = random.Random(48)
        with tempfile.TemporaryDirectory() as folder:
            for world in range(WORLDS):
                mesh, path, distance = some_solid(chance, world), Path(folder) / "solid.obj", chance.choice(DISTANCES)
                path.write_text("".join(f"v {x} {y} {z}\n" for x, y, z in mesh.points) +
                                "".join("f " + " ".join(str(corner + 1) for corner in face) + "\n" for face in mesh.faces), encoding="utf-8")
                with self.subTest(world=world):
                    self.check(path, distance)

    def test_hollow_things(self):
        for name in ("bin", "cup", "tube", "house"):
            with self.subTest(name=name):
                self.check(DATA / "cases" / f"{name}.obj", DISTANCES[0])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
