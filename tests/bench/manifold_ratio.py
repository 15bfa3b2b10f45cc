#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""How long convexact's hull takes, over Manifold's hull of the same points.

    python3 -m venv build/peers && build/peers/bin/pip install manifold3d==3.5.4 numpy
    build/peers/bin/python tests/bench/manifold_ratio.py build/bench/tests/bench/convexact-bench a.obj b.obj

Both are timed in turn, each from points in memory to the hull. Manifold's is in doubles, and proves
nothing; its time includes the copy of the points from Python, which is not small where few points are
on the hull. The meshes need faces, as other benchmarks of the same program read them, too. Prints
medians in milliseconds of the processor.
"""

import argparse
import json
import os
import statistics
import subprocess
import time
from pathlib import Path


def points_of(path):
    rows = [line.split()[1:4] for line in path.read_text(encoding="utf-8").splitlines() if line.startswith("v ")]
    return [[float(x) for x in row] for row in rows]


def ours(bench, path):
    """Milliseconds of the processor, of one run of Google Benchmark."""
    name = path.stem
    text = subprocess.run([bench, f"--benchmark_filter=^{name}/hull$", "--benchmark_min_time=0.1", "--benchmark_format=json"],
                          env=dict(os.environ, CONVEXACT_BENCH_MESHES=str(path)), check=True, capture_output=True, text=True).stdout
    found = [run for run in json.loads(text)["benchmarks"] if run["name"] == f"{name}/hull"]
    return found[0]["cpu_time"] * {"ns": 1e-6, "us": 1e-3, "ms": 1, "s": 1e3}[found[0]["time_unit"]]


def theirs(points):
    import manifold3d  # pylint: disable=import-outside-toplevel
    begin, runs = time.process_time(), 0
    while runs < 3 or time.process_time() - begin < 0.1:
        manifold3d.Manifold.hull_points(points).num_tri()
        runs += 1
    return (time.process_time() - begin) / runs * 1e3


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bench")
    parser.add_argument("meshes", nargs="+", type=Path)
    parser.add_argument("--rounds", type=int, default=5)
    options = parser.parse_args()
    import numpy  # pylint: disable=import-outside-toplevel
    for path in options.meshes:
        points = numpy.array(points_of(path))
        rounds = [(ours(options.bench, path.resolve()), theirs(points)) for _ in range(options.rounds)]
        us, them = (statistics.median(column) for column in zip(*rounds))
        print(f"{path.stem}: {len(points)} points, convexact {us:.2f} ms, Manifold {them:.2f} ms, ratio {us / them:.2f}")


if __name__ == "__main__":
    main()
