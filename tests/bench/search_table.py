#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measures what a search gains beyond greedy removals, as tables in Markdown.

Usage: search_table.py PROGRAM MESH...        e.g. search_table.py build/src/cli/convexact tests/data/*.obj
For 24, 18, 12, 8 and 6 halfspaces: the volume added to the hull in percent of what greedy removals add, and the time
of the search as a multiple of that of the removals in the same run. First each mesh, then the medians of all.
--kicks N sets the kicks of the local search, --cost what is added.
"""
import argparse
import json
import pathlib
import statistics
import subprocess
from fractions import Fraction

FACES = (24, 18, 12, 8, 6)
KEYS = {"volume": "volume", "area": "area", "mean-width": "mean_width"}


def measured(options, mesh, faces, kind):
    """(percent of what greedy adds, search time over removal time), or None if nothing is removed."""
    command = [options.program, "simplify", mesh, "--faces", str(faces), "--search", kind, "--cost", options.cost, "--json"]
    if kind == "local":
        command += ["--moves", str(options.kicks)]
    result = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
    start = Fraction(result[KEYS[options.cost]]["input"]["decimal"])
    greedy, now = (Fraction(result["search"][key]["decimal"]) for key in ("greedy", "now"))
    if greedy == start:
        return None
    seconds = {stage["name"]: stage.get("seconds", 0) for stage in result["stages"]}
    return float(100 * (now - start) / (greedy - start)), seconds["search"] / seconds["simplify"]


def row(cells):
    print("| " + " | ".join(cells) + " |")


def spread(values):
    return f"{statistics.median(values):.1f} ({min(values):.0f}..{max(values):.0f})" if values else "-"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("mesh", nargs="+")
    parser.add_argument("--kicks", type=int, default=200)
    parser.add_argument("--cost", choices=KEYS, default="volume")
    options = parser.parse_args()
    found = {}
    for kind in ("walk", "local"):
        print(f"\n{kind}: percent of what greedy adds, and time of the search over that of the removals\n")
        row(["mesh", *(f"k = {faces}" for faces in FACES)])
        row(["---"] * (1 + len(FACES)))
        for mesh in options.mesh:
            cells = []
            for faces in FACES:
                pair = measured(options, mesh, faces, kind)
                if pair:
                    found.setdefault((kind, faces), []).append(pair)
                cells.append(f"{pair[0]:.1f}, {pair[1]:.1f}" if pair else "-")
            row([pathlib.Path(mesh).stem, *cells])
    print(f"\nmedian (best..worst) of {len(options.mesh)} meshes\n")
    row(["", *(f"k = {faces}" for faces in FACES)])
    row(["---"] * (1 + len(FACES)))
    for kind in ("walk", "local"):
        for what, position in (("percent", 0), ("time", 1)):
            row([f"{kind}, {what}", *(spread([pair[position] for pair in found.get((kind, faces), [])]) for faces in FACES)])


if __name__ == "__main__":
    main()
