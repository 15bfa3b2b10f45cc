# SPDX-License-Identifier: MIT
"""glb_peers_test.py PROGRAM DATA - do a reader and a writer of others agree about GLB and mass?

trimesh reads the GLB that `decompose` writes and holds the same binary32 numbers, bit by bit; it writes scenes with
turned and mirrored instances, whose boxes agree with its own doubles; and it finds the same mass. Skipped without the
package trimesh, which `python3 -m venv build/peers && build/peers/bin/pip install trimesh` installs.
"""
import json
import struct
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PEERS = ROOT / "build" / "peers" / "bin" / "python"

# Runs in Python with trimesh: the parts of a GLB, as lists of the bits of their points.
READ = """
import sys, json, numpy, trimesh
scene = trimesh.load(sys.argv[1], process=False)
print(json.dumps({name: sorted(set(map(tuple, numpy.asarray(mesh.vertices, dtype=numpy.float32).view(numpy.uint32).tolist())))
                  for name, mesh in scene.geometry.items()}))
"""
# Writes a scene of boxes, turned and mirrored at random, and prints the box around each instance.
WRITE = """
import sys, json, numpy, trimesh
random = numpy.random.default_rng(49)
scene, box = trimesh.Scene(), trimesh.creation.box((1, 2, 3))
for k in range(8):
    place = trimesh.transformations.random_rotation_matrix(random.random(3))
    place[:3, 3] = random.random(3) * 10
    place[:3, :3] *= [1, 1, -1] if k % 2 else [1, 1, 1]
    scene.add_geometry(box, node_name=f'box_{k}', geom_name='box', transform=place)
scene.export(sys.argv[1])
print(json.dumps({name: trimesh.transform_points(box.vertices, scene.graph[name][0]).tolist() for name in scene.graph.nodes_geometry}))
"""
MASS = """
import sys, json, trimesh
mesh = trimesh.load(sys.argv[1], process=False, force='mesh')
mesh.merge_vertices(merge_tex=True, merge_norm=True)
print(json.dumps([mesh.volume, *mesh.center_mass, *mesh.moment_inertia.flatten()[[0, 4, 8, 1, 2, 5]]]))
"""


def python_with_trimesh():
    for python in (PEERS, Path(sys.executable)):
        if python.exists() and subprocess.run([python, "-c", "import trimesh"], capture_output=True, check=False).returncode == 0:
            return python
    return None


def said_by_peer(script, path):
    return json.loads(subprocess.run([PYTHON, "-c", script, path], capture_output=True, text=True, check=True).stdout)


def said_by_program(*arguments):
    return json.loads(subprocess.run([PROGRAM, *arguments, "--json"], capture_output=True, text=True, check=True).stdout)


class Peers(unittest.TestCase):
    def test_parts_are_read_bit_by_bit(self):
        with tempfile.TemporaryDirectory() as folder:
            file = f"{folder}/spot.glb"
            subprocess.run([PROGRAM, "decompose", DATA / "spot.obj", "--measures", "none", "-o", file, "-o", f"{folder}/parts/"],
                           check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            read = said_by_peer(READ, file)
            files = sorted(Path(f"{folder}/parts").glob("*.obj"))
            self.assertEqual(sorted(read), [path.stem for path in files])
            for path in files:
                lines = [line.split()[1:] for line in path.read_text(encoding="utf-8").splitlines() if line.startswith("v ")]
                expected = sorted({tuple(int.from_bytes(struct.pack("<f", float(x)), "little") for x in point) for point in lines})
                self.assertEqual([tuple(point) for point in read[path.stem]], expected)

    def test_instances_lie_where_the_writer_puts_them(self):
        with tempfile.TemporaryDirectory() as folder:
            file = f"{folder}/scene.glb"
            corners = said_by_peer(WRITE, file)
            objects = said_by_program("hull", file, "--parts", "--measures", "volume")["objects"]
            self.assertEqual(len(objects), 8)
            for entry in objects:
                expected = corners[entry["name"].rpartition(": ")[2]]
                for axis in range(3):
                    for end, bound in (("low", min), ("high", max)):
                        found = float(Fraction(entry["box"][end][axis]))
                        self.assertAlmostEqual(found, bound(point[axis] for point in expected), delta=1e-6)
                self.assertAlmostEqual(float(entry["volume"]["decimal"]), 6, delta=1e-5)

    def test_mass_is_the_same(self):
        with tempfile.TemporaryDirectory() as folder:
            mass = said_by_program("decompose", DATA / "spot.obj", "--measures", "none", "-o", f"{folder}/spot.usda")["mass"]
        exact = [mass["volume"], *mass["center"], *mass["inertia"]]
        for found, other in zip(exact, said_by_peer(MASS, DATA / "spot.obj")):
            self.assertAlmostEqual(float(Fraction(found)), other, delta=1e-11)


if __name__ == "__main__":
    PROGRAM, DATA = sys.argv[1], Path(sys.argv[2])
    PYTHON = python_with_trimesh()
    if PYTHON is None:
        print("skipped: the Python package trimesh is not installed; build/peers/bin/pip install trimesh")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
