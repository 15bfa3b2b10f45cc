#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""stdio_bench.py PROGRAM - how many containment verdicts `PROGRAM verify --stdio` gives per second.

Each request has 100 points and 18 planes. `tight` planes touch the points but for rounding, so that
nearly every verdict is a violation with its witness; `loose` ones hold. Prints the best of five, by
the clock and by the processor time of the program."""
import json
import math
import random
import resource
import subprocess
import sys
import time

REQUESTS, POINTS, PLANES, REPEATS = 2000, 100, 18, 5


def unit_vector(random_):
    v = [random_.gauss(0, 1) for _ in range(3)]
    length = math.hypot(*v)
    return [x / length for x in v]


def request(random_, shape, slack):
    points = [[shape(random_) for _ in range(3)] for _ in range(POINTS)]
    planes = []
    for _ in range(PLANES):
        normal = unit_vector(random_)
        reach = max(math.fsum(n * x for n, x in zip(normal, p)) for p in points)
        planes.append([*normal, -reach - slack])
    return json.dumps({"points": points, "candidate": {"planes": planes}, "claims": ["contains-input"]})


def processor_seconds():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def main(program):
    shapes = {"ball": lambda r: r.gauss(0, 1), "box": lambda r: r.uniform(-1, 1)}
    for shape in shapes:
        for name, slack in (("tight", 0), ("loose", 1e-9)):
            random_ = random.Random(2604)
            lines = "\n".join(request(random_, shapes[shape], slack) for _ in range(REQUESTS)) + "\n"
            elapsed = processor = math.inf
            for _ in range(REPEATS):
                start, spent = time.perf_counter(), processor_seconds()
                answers = subprocess.run([program, "verify", "--stdio"], input=lines, text=True,
                                         check=True, stdout=subprocess.PIPE).stdout.splitlines()
                elapsed = min(elapsed, time.perf_counter() - start)
                processor = min(processor, processor_seconds() - spent)
            violated = sum('"verdict":"violated"' in answer for answer in answers)
            print(f"{shape:5} {name:6} {len(answers) / elapsed:6.0f} verdicts/s, "
                  f"{len(answers) / processor:6.0f} per processor second, "
                  f"{violated} of {len(answers)} violated")


if __name__ == "__main__":
    main(sys.argv[1])
