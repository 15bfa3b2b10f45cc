# SPDX-License-Identifier: MIT
"""Times of decomposers on a busy machine: seconds of the processor, each run followed by one of ours, `convexact-cut`.

What was timed stays in build/field/times.json, so a run that was stopped resumes; nothing is judged.
"""
import json
import resource

from programs import BUILD, own_seconds, run_program
from tables import PARTS_MESHES, short_time

FILE = BUILD / "times.json"


def children_seconds():
    """Of the processor, of all programs that have ended."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def seconds_of_one(run, limit):
    """Of the library's own call; of ours, of the whole process; or how else it ended."""
    target = run.folder / f"timed-{run.program.name}.obj"
    before = children_seconds()
    outcome = run_program(run.program, run.source, target, 0, limit)
    if outcome != "output":
        return outcome
    return children_seconds() - before if run.program.is_ours() else own_seconds(target)


def timed_runs(runs, limit):
    """Seconds by decomposer and mesh. Ours is run after each of the others; its time is the least of all."""
    found = json.loads(FILE.read_text()) if FILE.exists() else {}  # runs over time are made again
    ours = {run.case: run for run in runs if run.program.name == "convexact-cut"}
    for run in runs:
        name = f"{run.program.name} {run.program.identity()}"
        if found.get(name, {}).get(run.case, "time") != "time":
            continue
        found.setdefault(name, {})[run.case] = seconds_of_one(run, limit)
        if run.case in ours and run.program.name != "convexact-cut":
            peer = ours[run.case].program
            mine, took = found.setdefault(f"{peer.name} {peer.identity()}", {}), seconds_of_one(ours[run.case], limit)
            if not isinstance(took, str):
                mine[run.case] = min(mine.get(run.case, took), took)
        FILE.write_text(json.dumps(found, indent=1) + "\n")
    return {name.split()[0]: times for name, times in found.items()}


def cell(times):
    """Of one decomposer, on the meshes of the table."""
    shown = [times.get(mesh) for mesh in PARTS_MESHES]
    return ", ".join("over time" if x == "time" else x if isinstance(x, str) else short_time(x) for x in shown)
