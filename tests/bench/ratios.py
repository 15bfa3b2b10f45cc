#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints the ratios of one benchmark run as a table in Markdown.

Usage: ratios.py build/bench.json
Each time is the median of its repetitions, in milliseconds; a dash where a benchmark did not run.
"""
import json
import math
import sys

COLUMNS = [("hull", "cgal"), ("hull", "qhull"), ("filtered", "cgal"), ("float", "cgal"), ("exact", "filtered"),
           ("by-area", "by-volume"), ("by-mean-width", "by-volume"),
           ("by-area-exact", "by-area"), ("by-mean-width-exact", "by-mean-width"), ("inner", "outer"), ("inner-costs", "outer"), ("shared", "own"), ("union", "nef-union"),
           ("filtered", "hacd"), ("filtered", "float"), ("owners", "filtered"),
           ("acd", "filtered"), ("acd-paths", "acd"),
           ("obb", "cgal-obb")]


def runs_of(path):
    """The medians, or all runs if there were no repetitions."""
    with open(path, encoding="utf-8") as file:
        runs = json.load(file)["benchmarks"]
    return [run for run in runs if run.get("aggregate_name") == "median"] or runs


def medians(path):
    """{input: {what: milliseconds}} of the runs named INPUT/WHAT, and {"bytes": peak per facet} of the filtered one."""
    times = {}
    for run in runs_of(path):
        parts = run["run_name"].removeprefix("overlay/").split("/")
        if len(parts) == 2 and not parts[1].isdigit():
            times.setdefault(parts[0], {})[parts[1]] = run["real_time"]
            if "bytes_per_facet" in run and parts[1] == "filtered":
                times[parts[0]]["bytes"] = run["bytes_per_facet"]
    return times


def cell(times, above, below):
    if above not in times or below not in times:
        return "-"
    return f"{times[above] / times[below]:.2f}"


def growth(path):
    """{what: {size: milliseconds}} of the runs named growth/WHAT/SIZE."""
    found = {}
    for run in runs_of(path):
        parts = run["run_name"].split("/")
        if parts[0] == "growth":
            found.setdefault(parts[1], {})[int(parts[2])] = run["real_time"]
    return found


def print_growth(found):
    print("\n| growth | size | ms | size | ms | exponent |\n|---|---:|---:|---:|---:|---:|")
    for what, times in found.items():
        (n, fast), (m, slow) = sorted(times.items())[0], sorted(times.items())[-1]
        exponent = math.log(slow / fast) / math.log(m / n) if m > n else float("nan")
        print(f"| {what} | {n} | {fast:.1f} | {m} | {slow:.1f} | {exponent:.2f} |")


def main():
    print("| input | CGAL ms | hull ms | filtered ms | float ms | " +
          " | ".join(f"{a} / {b}" for a, b in COLUMNS) + " | bytes / facet |")
    print("|---|" + "---|" * (5 + len(COLUMNS)))
    for name, times in medians(sys.argv[1]).items():
        shown = [f"{times[what]:.2f}" if what in times else "-" for what in ("cgal", "hull", "filtered", "float")]
        memory = [f"{times['bytes']:.0f}" if "bytes" in times else "-"]
        print(f"| {name} | " + " | ".join(shown + [cell(times, a, b) for a, b in COLUMNS] + memory) + " |")
    if found := growth(sys.argv[1]):
        print_growth(found)


if __name__ == "__main__":
    main()
