#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks that nothing includes from a room below its own (docs/architecture.md).

Prints each offending include as file:line and exits 1 if there is one.
"""
import pathlib
import re
import sys

ROOMS = ["number", "geometry", "shapes", "io", "lp", "hull", "dual", "measure", "simplify", "fast",
         "stored", "pipeline", "oracle", "report", "format", "stress", "cli"]
INCLUDE = re.compile(r'#include "convexact/(\w+)/')
# The engines are written twice on purpose: neither may see the other's work. The trace, the one
# record both write, is shared.
APART = {("fast", "simplify"): {"simplify/trace.hpp", "simplify/options.hpp"}}


def offences(path, room):
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        match = INCLUDE.search(line)
        if not match:
            continue
        included = match.group(1)
        if ROOMS.index(included) > ROOMS.index(room):
            yield f"{path}:{number}: {room} includes from {included}, a room below it"
        allowed = APART.get((room, included))
        if allowed is not None and not any(header in line for header in allowed):
            yield f"{path}:{number}: {room} includes {included} code, from which it must stay apart"


def main():
    found = []
    for top in ("include/convexact", "src"):
        for path in sorted(pathlib.Path(top).rglob("*.[hc]pp")):
            parts = path.relative_to(top).parts
            if len(parts) > 1 and parts[0] in ROOMS:
                found += offences(path, parts[0])
    print("\n".join(found) if found else "rooms: every include points upward")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
