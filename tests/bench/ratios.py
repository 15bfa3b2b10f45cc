#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints the ratios of one benchmark run as a table in Markdown, and those that have an aim beside it.

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


SCANS = ("bunny", "horse", "igea", "nefertiti", "beast")
SMALL_SCANS = ("homer", "rocker-arm", "fandisk")
DECOMPOSED = ("cow", "spot", "homer", "fandisk", "suzanne", "teapot")

# What a ratio is to be at most: {(above, below): {input: aim}}. By area and mean width it is that of the loops alone.
AIMS = {
    ("filtered", "cgal"): {**dict.fromkeys(SCANS, 0.7), **dict.fromkeys(SMALL_SCANS, 0.8), "spot": 1.5, "teapot": 1.5,
                           "rounded_box": 2, "sphere50000": 1},
    ("float", "cgal"): {**dict.fromkeys(SCANS, 0.5), **dict.fromkeys(SMALL_SCANS, 0.6), "spot": 1, "teapot": 1,
                        "rounded_box": 1.5, "sphere50000": 0.7},
    ("by-area", "by-volume"): dict.fromkeys(("bunny", "homer", "rocker-arm"), 2),
    ("by-mean-width", "by-volume"): dict.fromkeys(("bunny", "homer", "rocker-arm"), 4),
    ("acd", "filtered"): dict.fromkeys((f"clusters-of-{name}" for name in DECOMPOSED), 1),
    ("acd-paths", "acd"): dict.fromkeys((f"clusters-of-{name}" for name in DECOMPOSED), 0.5),
}


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


def print_aims(inputs):
    """The ratios of this run that have an aim."""
    rows = [(name, above, below, times[above] / times[below], aim) for (above, below), aims in AIMS.items()
            for name, aim in aims.items() if above in (times := inputs.get(name, {})) and below in times]
    if not rows:
        return
    print("\n| input | ratio | measured | aim | met |\n|---|---|---:|---:|---|")
    for name, above, below, ratio, aim in rows:
        print(f"| {name} | {above} / {below} | {ratio:.2f} | {aim} | {'yes' if ratio <= aim else 'no'} |")


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
    inputs = medians(sys.argv[1])
    for name, times in inputs.items():
        shown = [f"{times[what]:.2f}" if what in times else "-" for what in ("cgal", "hull", "filtered", "float")]
        memory = [f"{times['bytes']:.0f}" if "bytes" in times else "-"]
        print(f"| {name} | " + " | ".join(shown + [cell(times, a, b) for a, b in COLUMNS] + memory) + " |")
    print_aims(inputs)
    if found := growth(sys.argv[1]):
        print_growth(found)


if __name__ == "__main__":
    main()
