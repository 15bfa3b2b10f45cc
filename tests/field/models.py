#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Has simulators and other readers load the models that `convexact decompose` writes, and compares what they hold with
the files of the parts.

Of each mesh: whether the reader takes the model; in how many parts its points are those of the files, bit by bit; else
how far one moved, in diagonals of the input's box; and what `convexact verify` says of the input and the parts as they
are in the reader's memory. Meshes: tests/data, and those of the folder CONVEXACT_MESHES (OBJ). Exit code 1 if a
reader refuses a model, has other parts than were written, or, of USD, other points. Readers that are missing are skipped.
"""
import argparse
import json
import math
import os
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from programs import BUILD, ROOT, npm_version  # noqa: E402

# MuJoCo looks for the meshes of a URDF beside it, whatever path it names.
NODE_READERS = {"mujoco": ("model.mjcf.xml", "@mujoco/mujoco"), "mujoco-urdf": ("parts/model.urdf", "@mujoco/mujoco"),
                "tinyusdz": ("model.usda", "tinyusdz"), "three-usd": ("model.usda", "three")}


def run(*command):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True)


def corners(path):
    lines = (line.split() for line in path.read_text().splitlines())
    return [tuple(map(float, words[1:4])) for words in lines if words and words[0] == "v"]


def parts_obj(path, parts):
    """All points of the parts, and of each a triangle: what counts is their hull."""
    lines, first = [], 1
    for number, part in enumerate(parts):
        lines += ["v " + " ".join(map(repr, point)) for point in part["points"]]
        lines += [f"o part_{number:03}"] + [f"f {k} {k + 1} {k + 2}" for k in range(first, first + len(part["points"]) - 2)]
        first += len(part["points"])
    path.write_text("\n".join(lines) + "\n")


def compare(reader, folder, mesh, convexact):
    """What the reader made of its model, as a line; and whether that is what was written."""
    name, package = NODE_READERS[reader]
    out = folder / f"{reader}.json"
    ran = run("node", BUILD / "models.mjs", reader.split("-urdf")[0], folder / name, out)
    if ran.returncode != 0:
        return f"refused: {ran.stderr.strip()[:300]}", False
    document = json.loads((folder / "parts" / "parts.json").read_text())["parts"]
    read = json.loads(out.read_text())
    written = [corners(folder / "parts" / part["file"]) for part in document]
    if [len(part["points"]) for part in read] != [len(points) for points in written]:
        return f"has {len(read)} parts of other sizes than the {len(written)} of the files", False
    same = sum(set(map(tuple, part["points"])) == set(points) for part, points in zip(read, written))
    low, high = ([side(axis) for axis in zip(*corners(mesh))] for side in (min, max))
    moved = max(math.dist(a, b) for part, points in zip(read, written) for a, b in zip(part["points"], points))
    text = f"{same} of {len(read)} parts bit by bit, moved {moved / math.dist(low, high):.1e} D"
    if reader == "mujoco":
        text += f", hull corners {sum(part['corners'] for part in read)} of {sum(map(len, written))}"
    parts_obj(folder / f"{reader}.obj", read)
    verdict = json.loads(run(convexact, "verify", mesh, folder / f"{reader}.obj", "--union", "--json",
                             "--claims", "covers-points").stdout)
    claim = next(claim for claim in verdict["claims"] if claim["code"] == "covers-points")
    # MuJoCo moves points by design; readers of USD have no reason to.
    return f"{text}; {claim['sentence']}", reader.startswith("mujoco") or same == len(read)


def check_xml(folder):
    """Two answers about the XML: of Python's parser, and of programs that are installed."""
    for name in ("model.mjcf.xml", "model.urdf"):
        ElementTree.parse(folder / name)
    yield "python xml", "well-formed", True
    for program, command in (("xmllint", ["--noout", folder / "model.mjcf.xml", folder / "model.urdf"]),
                             ("check_urdf", [folder / "model.urdf"])):
        if not shutil.which(program):
            yield program, "skipped: not installed", True
            continue
        ran = run(program, *command)
        yield program, (ran.stdout.splitlines() or ["accepted"])[-1] if ran.returncode == 0 else ran.stderr, ran.returncode == 0


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--convexact", required=True)
    arguments = parser.parse_args()
    folders = [ROOT / "tests" / "data"] + [Path(folder) for folder in [os.environ.get("CONVEXACT_MESHES")] if folder]
    meshes = {path.stem: path for folder in folders for path in sorted(folder.glob("*.obj"))}
    print(", ".join(sorted({npm_version(package) for _, package in NODE_READERS.values()} - {""})))
    is_good = True
    for mesh in meshes.values():
        folder = BUILD / "models" / mesh.stem
        shutil.rmtree(folder, ignore_errors=True)
        (folder / "parts").mkdir(parents=True)  # a model may be written into the folder of parts only if it is there
        ran = run(arguments.convexact, "decompose", mesh, "--precision", "32", "--measures", "none", "-o", f"{folder}/parts/",
                  *(word for name in ("model.mjcf.xml", "model.urdf", "parts/model.urdf", "model.usda")
                    for word in ("-o", folder / name)))
        if ran.returncode != 0:
            sys.exit(ran.stderr)
        answers = list(check_xml(folder))
        for reader, (_, package) in NODE_READERS.items():
            if not (BUILD / "node_modules" / package).exists():
                answers.append((reader, f"skipped: {package} is not installed", True))
            else:
                answers.append((reader, *compare(reader, folder, mesh, arguments.convexact)))
        for reader, answer, is_right in answers:
            print(f"{mesh.stem:16} {reader:12} {answer}", flush=True)
            is_good = is_good and is_right
    return 0 if is_good else 1


if __name__ == "__main__":
    sys.exit(main())
