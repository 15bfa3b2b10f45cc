# SPDX-License-Identifier: MIT
"""bench.py PROGRAM - the three ratios of docs/results/performance.md, each side by side in this process: what a call
costs above the library, a hull against scipy's, and conform on a function against starting it, and the program, for
each input."""
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any, Callable

import numpy as np

import convexact as cx
from convexact import _core

CUBE = np.array([[x, y, z] for x in (0.0, 1.0) for y in (0.0, 1.0) for z in (0.0, 1.0)])
IDENTITY = """import sys
import numpy as np
points = np.array([line.split()[1:] for line in open(sys.argv[1])], dtype=float)
points = np.unique(points, axis=0)
open(sys.argv[2], "w").write("".join(f"v {x!r} {y!r} {z!r}\\n" for x, y, z in points.tolist()))
"""


def least(rounds: int, *functions: Callable[[], Any]) -> list[float]:
    """The least of some seconds of each, in turns."""
    found = [float("inf")] * len(functions)
    for _ in range(rounds):
        for k, function in enumerate(functions):
            start = time.perf_counter()
            function()
            found[k] = min(found[k], time.perf_counter() - start)
    return found


def overhead() -> None:
    count = 500
    call, core = least(
        7, lambda: [cx.verify(CUBE, CUBE) for _ in range(count)],
        lambda: [_core.verify_mesh(CUBE, [], CUBE, [], [], [], None) for _ in range(count)],
    )
    print(f"verify of 8 points: {call / count * 1e6:.0f} us, of which the extension {core / count * 1e6:.0f} us")


def hulls() -> None:
    try:
        from scipy.spatial import ConvexHull  # type: ignore[import-not-found, import-untyped, unused-ignore]  # pylint: disable=import-outside-toplevel
    except ImportError:
        print("hulls: skipped, scipy is not installed")
        return
    draw = np.random.default_rng(1)
    ball = draw.normal(size=(100000, 3))
    for name, points in (("10^6 normal", draw.normal(size=(1000000, 3))), ("10^6 in a cube", draw.random(size=(1000000, 3))),
                         ("10^5 on a sphere", ball / np.linalg.norm(ball, axis=1)[:, None])):
        ours, theirs = least(3, lambda: cx.hull(points, measures=()), lambda: ConvexHull(points))  # pylint: disable=cell-var-from-loop
        print(f"hull of {name}: {ours:.2f} s, scipy {theirs:.2f} s, ratio {ours / theirs:.2f}")


def unique(points: Any) -> Any:
    return np.unique(points, axis=0)


def protocol(program: str) -> None:
    families = ["random-ball", "cube", "icosahedron", "lattice"]
    inputs = [cx.generate(name) for name in families]
    with tempfile.TemporaryDirectory() as folder:
        script, given, made = Path(folder, "hull.py"), Path(folder, "in.obj"), Path(folder, "out.obj")
        script.write_text(IDENTITY, encoding="utf-8")

        def by_processes() -> None:
            for points in inputs:
                given.write_text("".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in points.tolist()), encoding="utf-8")
                subprocess.run([sys.executable, script, given, made], check=True)
                subprocess.run([program, "verify", given, made, "--asks", "hull"], check=True, stdout=subprocess.DEVNULL)

        inside, outside = least(3, lambda: cx.conform(unique, only=families), by_processes)
    print(f"conform on a function: {inside / len(inputs) * 1e3:.1f} ms an input, by processes {outside / len(inputs) * 1e3:.1f} ms, "
          f"{outside / inside:.0f} times")


if __name__ == "__main__":
    overhead()
    protocol(sys.argv[1])
    hulls()
