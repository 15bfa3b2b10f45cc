#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""times.py PROGRAM [PAIRS] - times and memory of the module in Node beside the program's, on the same requests: the table
of docs/javascript.md. Processor time of whole processes, the least of three pairs (or PAIRS) that run in turn; and the most memory."""
import json
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
WEB = HERE.parent.parent / "build" / "web"


def shape(name):
    """Points and triangles of an OBJ whose faces have plain indices."""
    rows = [line.split() for line in (HERE.parent / "data" / name).read_text().splitlines()]
    return {"points": [[float(x) for x in row[1:4]] for row in rows if row[:1] == ["v"]],
            "triangles": [[int(corner.split("/")[0]) - 1 for corner in row[1:]] for row in rows if row[:1] == ["f"]]}


def requests():
    bunny, spot = shape("bunny.obj"), shape("spot.obj")
    points = {"points": bunny["points"]}
    yield "start: the hull of a tetrahedron", "hull", {"points": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]}
    yield "hull of the bunny", "hull", points
    yield "simplify the bunny to 18", "simplify", {**points, "faces": 18}
    yield "the same, inside, to 32 vertices", "simplify", {**points, "inner": True, "vertices": 32}
    yield "verify the bunny as its own hull", "verify", {**points, "candidate": {"vertices": bunny["points"]}, "asks": "hull"}
    yield "decompose spot, 3%, one thread", "decompose", {**spot, "distance": "3%", "jobs": 1}
    yield "simplify the bunny to 18, exact", "simplify", {**points, "faces": 18, "engine": "exact"}


# A process begins with the memory of the one that starts it, so a small one does.
START = """import resource, subprocess, sys
subprocess.run(sys.argv[1:], check=True)
used = resource.getrusage(resource.RUSAGE_CHILDREN)
print(used.ru_utime + used.ru_stime, used.ru_maxrss / 1024, file=sys.stderr)"""


def cost(command, line):
    """Seconds of the processor, megabytes, and the answer."""
    ran = subprocess.run([sys.executable, "-S", "-c", START, *map(str, command)], input=line, capture_output=True, check=True)
    seconds, megabytes = map(float, ran.stderr.split()[-2:])
    return seconds, megabytes, ran.stdout


def main():
    program, pairs = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 3
    print("| | program, s | module, s | program, MB | module, MB |\n|---|---|---|---|---|")
    for name, kind, request in requests():
        line = (json.dumps(request) + "\n").encode()
        native, module = [], []
        for _ in range(pairs):
            native.append(cost([program, kind, "--stdio"], line))
            module.append(cost(["node", HERE / "stdio.mjs", program, WEB, kind], line))
        assert {run[2] for run in native} == {run[2] for run in module}, f"{name}: other answers"
        least = [min(run[0] for run in runs) for runs in (native, module)]
        most = [max(run[1] for run in runs) for runs in (native, module)]
        print(f"| {name} | {least[0]:.2f} | {least[1]:.2f} | {most[0]:.0f} | {most[1]:.0f} |", flush=True)


if __name__ == "__main__":
    main()
