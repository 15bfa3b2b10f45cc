#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks that data flows downward: no file includes from a room below its own (docs/architecture.md).

Sees every include in quotes: of public headers, of private ones ("room/file.hpp") and relative ones.
Prints each offending include as file:line and exits 1 if there is one.
"""
import pathlib
import re
import sys

# From the top down.
ROOMS = ["error", "task", "number", "geometry", "near", "shapes", "io", "lp", "hull", "dual", "implicit", "measure",
         "simplify", "fast", "search", "stored", "solid",
         "surface", "overlay", "reach", "decompose", "cut",
         "scene", "parts", "query", "bvh", "proof", "oracle/solid", "oracle/parts", "oracle/order",
         "conform",
         "wire", "pages", "teach", "lab/diff", "lab/report", "lab/compare", "lab/stress",
         "cli", "lab", "capi", "check"]
# The public headers of each room.
PUBLIC = {header: room for room, headers in {
    "error": "error", "number": "number cost", "geometry": "geometry", "shapes": "shapes", "io": "io",
    "lp": "linear_program", "hull": "hull", "dual": "dual", "implicit": "implicit", "measure": "measure",
    "simplify": "run", "search": "search", "stored": "stored", "solid": "scene",
    "surface": "surface", "overlay": "overlay mass", "reach": "reach", "decompose": "cluster", "cut": "partition",
    "scene": "simplify", "parts": "decompose", "query": "query", "bvh": "hull_tree",
    "oracle/solid": "verify", "oracle/parts": "verify_parts", "oracle/order": "verify_order",
    "conform": "conform shrink", "wire": "json",
    "capi": "convexact"}.items()
          for header in headers.split()}
# What stays apart on purpose, so that a mistake in one cannot hide in the other: (room, room it may
# see little of): the headers that it may see.
APART = {
    # The engines are written twice; they share the record of a run.
    ("fast", "simplify"): {"convexact/run.hpp"},
    # The sceptic's checker shares nothing.
    **{("check", room): set() for room in ROOMS if room != "check"},
}
# The command line takes options and prints: it sees public headers, the rooms that word things, and of the others
# what it needs to read objects, to run stages, to start programs and to write numbers.
WORDING = {"wire", "pages", "teach", "cli"}
CLI_SEES = {"conform/program.hpp", "conform/program_output.hpp", "hull/hull_steps.hpp", "io/file_kind.hpp", "io/json.hpp",
            "io/json_document.hpp", "io/json_text.hpp", "io/mesh_readers.hpp", "io/names.hpp", "io/used_points.hpp",
            "number/precision.hpp", "number/text.hpp", "oracle/parts/scene_verdict.hpp", "proof/decomposition_proof.hpp",
            "proof/proof.hpp", "scene/each_object.hpp", "scene/objects.hpp", "simplify/run_names.hpp", "solid/solid.hpp", "solid/stage_log.hpp"}
# Files that verify steps, and what they must not see: the surface and the cap that they verify.
VERIFICATION = re.compile(r"src/simplify/(step_verification|inner_verification|plain_\w+|whole_dual|modular_volume)\.[hc]pp")
VERIFIED = re.compile(r"simplify/(dual_surface|cap|ring_triangulation|exact_engine)\.hpp")
INCLUDE = re.compile(r'#include "([^"]+)"')
# The one header that includes all of nlohmann/json, which takes long to compile: for sources that read.
READS_JSON = "src/io/json_text.hpp"


def room_of(path, included):
    """The room that an include in quotes leads to, and the name by which it is known; None if it is no file of ours."""
    if included == "convexact.h":
        return "capi"
    if included.startswith("convexact/"):
        return PUBLIC[included.split("/")[1].removesuffix(".hpp")]
    if "/" not in included:
        return own_room(path) if (path.parent / included).exists() else None
    room = included.rpartition("/")[0]
    return room if room in ROOMS else None


def own_room(path):
    """The room of a private file: its folder under src."""
    return str(path.parent.relative_to("src"))


def offences(path, room):
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        if path.suffix == ".hpp" and "<nlohmann/json.hpp>" in line and str(path) != READS_JSON:
            yield f"{path}:{number}: only {READS_JSON} includes nlohmann/json.hpp; write with io/json_document.hpp"
        match = INCLUDE.match(line)
        if not match:
            continue
        included = match.group(1)
        where = f"{path}:{number}: "
        if ".." in included:
            yield where + f'"{included}": write "room/file.hpp"'
            continue
        target = room_of(path, included)
        if target is None:
            yield where + f"{included} is in no room"
            continue
        if path.parts[0] == "include" and not included.startswith("convexact/"):
            yield where + f"a public header includes the private {included}"
        if ROOMS.index(target) > ROOMS.index(room):
            yield where + f"{room} includes from {target}, a room below it"
        allowed = APART.get((room, target))
        if allowed is not None and included not in allowed:
            yield where + f"{room} includes {included}, from which it must stay apart"
        if room == "cli" and target not in WORDING and not included.startswith("convexact") and included not in CLI_SEES:
            yield where + f"cli includes {included}, which is not for the command line"
        if VERIFICATION.match(str(path)) and VERIFIED.match(included):
            yield where + f"the verification of steps includes {included}, which it verifies"


def main():
    found = []
    for path in sorted(pathlib.Path("include/convexact").glob("*.hpp")):
        found += offences(path, PUBLIC[path.stem])
    for path in sorted(pathlib.Path("src").rglob("*.[hc]pp")):
        room = own_room(path)
        if room in ROOMS:
            found += offences(path, room)
    print("\n".join(found) if found else "rooms: every include points upward")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
