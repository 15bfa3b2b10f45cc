# SPDX-License-Identifier: MIT
"""ball_test.py PROGRAM DATA - does a ball fall into a cup and into a bin?

MuJoCo drops a ball onto the parts of `decompose`. On those of `--method cut` it comes to rest on the floor, on those of
the published hacd on the lid that fills the cavity: this is why cut exists. Skipped without the package mujoco, which
`python3 -m venv build/peers && build/peers/bin/pip install mujoco` installs.
"""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PEERS = ROOT / "build" / "peers" / "bin" / "python"

# Runs in Python with MuJoCo: MODEL LOW HIGH. Prints how high the ball ends, as a share of the height, and its speed.
DROP = """
import sys
import mujoco
model, low, high = sys.argv[1], *(list(map(float, word.split(','))) for word in sys.argv[2:])
size = [b - a for a, b in zip(low, high)]
radius = 0.12 * min(size)
start = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, high[2] + 2 * radius]
text = open(model).read().replace('<worldbody>', f'''<option gravity="0 0 {-9.81 * max(size)}" timestep="0.001"/>
<worldbody><body pos="{start[0]} {start[1]} {start[2]}"><freejoint/><geom type="sphere" size="{radius}" mass="1"/></body>''', 1)
scene = model.replace('.mjcf.xml', '.scene.xml')
open(scene, 'w').write(text)
simulated = mujoco.MjModel.from_xml_path(scene)
data = mujoco.MjData(simulated)
for _ in range(4000):
    mujoco.mj_step(simulated, data)
print((data.qpos[2] - radius - low[2]) / size[2], abs(data.qvel[2]) / size[2])
"""


def python_with_mujoco():
    for python in (PEERS, Path(sys.executable)):
        if python.exists() and subprocess.run([python, "-c", "import mujoco"], capture_output=True, check=False).returncode == 0:
            return python
    return None


class Balls(unittest.TestCase):
    def rest(self, name, method):
        mesh = DATA / "cases" / f"{name}.obj"
        points = [list(map(float, line.split()[1:4])) for line in mesh.read_text(encoding="utf-8").splitlines() if line.startswith("v ")]
        ends = [",".join(str(end(axis)) for axis in zip(*points)) for end in (min, max)]
        with tempfile.TemporaryDirectory() as folder:
            model = Path(folder) / f"{name}.mjcf.xml"
            subprocess.run([PROGRAM, "decompose", mesh, "--method", method, "--precision", "32", "--measures", "none", "-o",
                            f"{folder}/parts/", "-o", model], check=True, stdout=subprocess.DEVNULL)
            ran = subprocess.run([PYTHON, "-c", DROP, model, *ends], capture_output=True, text=True, check=True)
        height, speed = map(float, ran.stdout.split())
        self.assertLess(speed, 1e-3, "the ball is still moving")
        return height

    def test_parts_of_cut_leave_the_cavity_open(self):
        for name in ("cup", "bin"):  # their floors are a tenth of the height
            with self.subTest(name=name):
                self.assertAlmostEqual(self.rest(name, "cut"), 0.1, delta=0.01)

    def test_parts_of_hacd_fill_it(self):
        for name in ("cup", "bin"):
            with self.subTest(name=name):
                self.assertAlmostEqual(self.rest(name, "hacd"), 1, delta=0.01)


if __name__ == "__main__":
    PROGRAM, DATA, PYTHON = sys.argv[1], Path(sys.argv[2]), python_with_mujoco()
    if PYTHON is None:
        print("skipped: the Python package mujoco is not installed; build/peers/bin/pip install mujoco")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
