# SPDX-License-Identifier: MIT
"""Qhull as a program of ./dev field: qhull.py OPTIONS INPUT.obj OUTPUT.obj

Runs `qhull OPTIONS s o` (OPTIONS with commas between them, such as Q0,Pp) and keeps its 16 digits; with a leading `=` the
faces keep the input's own coordinates, by Qhull's indices. It prints all points of its input; those that no face uses are left
out, because judges take all points of a file for the solid. Qhull lists corners clockwise; they are turned. Its own summary
says how many seconds of the processor the hull took, which go to OUTPUT.obj.json.
"""
import json
import re
import subprocess
import sys


def main(options, source, target):
    points = [line.split()[1:4] for line in open(source, encoding="latin-1") if line.startswith("v ")]
    text = f"3\n{len(points)}\n" + "".join(" ".join(point) + "\n" for point in points)
    command = ["qhull", *filter(None, options.lstrip("=").split(",")), "s", "o"]
    done = subprocess.run(command, input=text, capture_output=True, text=True, check=False)
    if done.returncode:
        sys.stderr.write(done.stderr[:2000])
        return 4
    lines = done.stdout.split("\n")
    count, faces, _ = map(int, lines[1].split())
    printed = points if options.startswith("=") else [line.split() for line in lines[2:2 + count]]
    polygons = [[int(corner) for corner in line.split()[:0:-1]] for line in lines[2 + count:2 + count + faces]]
    index = {corner: k for k, corner in enumerate(dict.fromkeys(corner for polygon in polygons for corner in polygon), 1)}
    with open(target, "w", encoding="ascii") as out:
        out.writelines("v " + " ".join(printed[corner]) + "\n" for corner in index)
        out.writelines("f " + " ".join(str(index[corner]) for corner in polygon) + "\n" for polygon in polygons)
    seconds = re.search(r"CPU seconds to compute hull.*?: *([0-9.e+-]+)", done.stderr)
    with open(target + ".json", "w", encoding="ascii") as out:
        json.dump({"seconds": float(seconds[1]) if seconds else None}, out)
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
