#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the field's decomposers over meshes, and has two judges settle each set of parts.

`convexact verify --union` and judge_parts.py, which shares nothing with it, decide about all claims. Exit code 1 if
they differ anywhere. What is found goes to build/field/decompositions.md, a table, and with --page to docs/results/field.md,
in place of the rows of these decomposers. A run says before how long it will take; it resumes where an earlier one stopped.
CONVEXACT_MESHES names a folder with more meshes (OBJ).
"""
import argparse
import json
import math
import os
import resource
import subprocess
import sys
import time
from fractions import Fraction
from multiprocessing import Pool
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from compare import shown  # noqa: E402
from judge_parts import judge_part_files  # noqa: E402
from memory import Memory, bytes_of, digest_of, expectation, judges_digest  # noqa: E402
from mutate import obj_text  # noqa: E402
from programs import BUILD, NOT_HERE, ROOT, decomposers, own_seconds, run_program, says_nothing  # noqa: E402
from reading import Mesh, read  # noqa: E402
from real_meshes import real_meshes  # noqa: E402
from run import number_options  # noqa: E402
from subjects import parts_finding, write_subject  # noqa: E402
from tables import PARTS_MESHES, REACH, edit_page, parts_matrix, parts_table, real_parts_table, with_times, write_page  # noqa: E402
from times import cell, timed_runs  # noqa: E402

ASKED = "covers-points,covers-surface,parts-disjoint,parts-needed,parts-solid,parts-convex"
COMPARED = ("parts-readable", "parts-finite", "parts-solid", "parts-convex", "covers-points", "covers-surface",
            "covers-solid", "within-solid", "parts-disjoint", "parts-needed")
DISTANCE = f"{REACH}d"


def polycube(cells):
    """The surface of a union of unit cells: a triangle pair for each square with a cell on one side only."""
    index, faces = {}, []
    for cell in cells:
        for axis in range(3):
            for side in (0, 1):
                beyond = tuple(x + (2 * side - 1) * (k == axis) for k, x in enumerate(cell))
                if beyond in cells:
                    continue
                u, v = (axis + 1) % 3, (axis + 2) % 3
                loop = []
                for a, b in ((0, 0), (1, 0), (1, 1), (0, 1)):
                    corner = [float(x) for x in cell]
                    corner[axis] += side
                    corner[u] += a
                    corner[v] += b
                    loop.append(index.setdefault(tuple(corner), len(index)))
                if side == 0:
                    loop.reverse()
                faces += [[loop[0], loop[1], loop[2]], [loop[0], loop[2], loop[3]]]
    return Mesh(list(index), faces)


def torus(around, across, radius=2.0, tube=1.0):
    def corner(i, j):
        u, v = 2 * math.pi * i / around, 2 * math.pi * j / across
        return ((radius + tube * math.cos(v)) * math.cos(u), (radius + tube * math.cos(v)) * math.sin(u), tube * math.sin(v))

    def at(i, j):
        return i % around * across + j % across
    faces = [face for i in range(around) for j in range(across) for face in
             ([at(i, j), at(i + 1, j), at(i + 1, j + 1)], [at(i, j), at(i + 1, j + 1), at(i, j + 1)])]
    return Mesh([corner(i, j) for i in range(around) for j in range(across)], faces)


def in_triangles(mesh):
    return Mesh(mesh.points, [[face[0], b, c] for face in mesh.faces for b, c in zip(face[1:], face[2:])])


def real_solids(count):
    """Real meshes as users have them, open surfaces among them, and why others are missing. STL repeats points: once each."""
    meshes, reasons = real_meshes(count)
    found = {}
    for name, mesh in meshes:
        index = {point: k for k, point in enumerate(dict.fromkeys(mesh.points))}
        found[name] = in_triangles(Mesh(list(index), [[index[mesh.points[corner]] for corner in face] for face in mesh.faces]))
    return found, reasons


def all_meshes():
    """Closed forms, the meshes of tests/data, the cow of an npm package, and those of CONVEXACT_MESHES."""
    middle = (1, 1, 1)
    arms = [tuple(x + d * (k == axis) for k, x in enumerate(middle)) for axis in range(3) for d in (-1, 1)]
    meshes = {"l": polycube([(0, 0, 0), (1, 0, 0), (0, 1, 0)]),
              "plus": polycube([(1, 1, 0), (0, 1, 0), (2, 1, 0), (1, 0, 0), (1, 2, 0)]),
              "cross": polycube([middle, *arms]), "torus": torus(32, 16)}
    folders = [ROOT / "tests" / "data"]
    if os.environ.get("CONVEXACT_MESHES"):
        folders.append(Path(os.environ["CONVEXACT_MESHES"]))
    files = {path.stem: path for folder in folders for path in sorted(folder.glob("*.obj"))}
    cow = BUILD / "node_modules" / "vhacd-js" / "app" / "meshes" / "cow-nonormals.obj"
    if cow.exists():
        files.setdefault("cow", cow)
    for name, path in files.items():
        meshes[name] = in_triangles(read(path))
    return meshes


def ask_union(convexact, source, target, numbers, seconds, claims):
    """The exit code (None: over time), the JSON object if there is one, and the seconds of the whole process.

    They are those of the processor if these are less than the clock's, as on a busy machine.
    """
    command = [convexact, "verify", str(source), str(target), "--union", "--json", *number_options(numbers), *claims]
    start, used = time.monotonic(), resource.getrusage(resource.RUSAGE_CHILDREN)
    try:
        done = subprocess.run(command, capture_output=True, timeout=seconds, check=False)
    except subprocess.TimeoutExpired:
        return None, None, time.monotonic() - start
    now = resource.getrusage(resource.RUSAGE_CHILDREN)
    passed = min(time.monotonic() - start, now.ru_utime + now.ru_stime - used.ru_utime - used.ru_stime)
    try:
        return done.returncode, json.loads(done.stdout), passed
    except ValueError:
        return done.returncode, None, passed


def differences_of(verdict, status, answer):
    """Where the two judges disagree: (kind, claim, sentence)."""
    if status not in (0, 1) or not answer or "claims" not in answer:
        return [("other exit", "", f"exit {status} {(answer or {}).get('error', {}).get('message', '')}")]
    found, said = [], {claim["code"]: claim for claim in answer["claims"]}
    for name in COMPARED:
        expected, claim = verdict["claims"][name], said.get(name, {})
        if expected is False and claim.get("status") == "holds":
            found.append(("missed violation", name, claim.get("sentence", "")))
        if expected is True and claim.get("status") in ("violated", "undecided", "not-applicable"):
            found.append(("false accusation", name, claim.get("sentence", "")))
    for name, theirs, ours in (("parts", len(answer.get("parts", [])), verdict.get("parts")),
                               ("outside", answer.get("outside", {}).get("points"), verdict.get("points_outside")),
                               ("tested", answer.get("outside", {}).get("tested"), verdict.get("points"))):
        if theirs is not None and ours is not None and theirs != ours:
            found.append(("count", name, f"{theirs}, by the judge {ours}"))
    for key in ("facets", "vertices"):
        theirs = [part.get(key, 0) for part in answer.get("parts", [])]
        if verdict.get(key) and theirs != verdict[key]:
            found.append(("count", key, f"{theirs}, by the judge {verdict[key]}"))
    distance = said.get("covers-points", {}).get("witness", {}).get("distance")
    if distance and Fraction(distance["squared"]) != Fraction(verdict["squared_distance"]):
        found.append(("distance", "covers-points", f"{shown(Fraction(distance['squared']))} squared, by the judge "
                      f"{shown(Fraction(verdict['squared_distance']))}"))
    share = answer.get("measures", {}).get("uncovered_area_share")
    if share and "uncovered_area_share" in verdict:
        low, high, ours = share["low"], share["high"], verdict["uncovered_area_share"]
        if not low - 1e-9 <= ours <= high + 1e-9:  # the judge adds roots in doubles
            found.append(("area", "uncovered_area_share", f"{low} to {high}, by the judge {ours}"))
    return found


class Run:
    """One decomposer on one mesh: its parts, what verify says of them, and in another process what the judge says."""

    def __init__(self, case, mesh, program, options):
        self.case, self.program, self.options = case, program, options
        self.folder = BUILD / "parts" / case
        self.folder.mkdir(parents=True, exist_ok=True)
        self.source, self.target = self.folder / "input.obj", self.folder / f"{program.name}.obj"
        self.outcome_file = self.folder / f"{program.name}.outcome"
        text = obj_text(mesh)
        if not self.source.exists() or self.source.read_bytes() != text:
            self.source.write_bytes(text)
            for file in self.folder.glob("*.outcome"):
                file.unlink()
        self.record = {"case": case, "program": program.name, "numbers": program.numbers, "version": program.version,
                       "triangles": len(mesh.faces)}

        self.memory = Memory(self.folder / "verdicts.json", options.fresh)

    def digest(self):
        return digest_of(self.options.digest, self.program.identity(), bytes_of(self.source), bytes_of(self.target))

    def known(self):
        return self.memory.recall(self.program.name, self.digest())

    def settle(self):
        """All but the second judge's verdict; from an earlier run, if nothing has changed."""
        found = self.known()
        if found is not None:
            self.record = found
            return
        start = time.monotonic()
        self.decompose()
        if self.options.asks and self.record["outcome"] == "output":
            self.verify()
        if not says_nothing(self.record["outcome"]):
            self.memory.keep(self.program.name, self.digest(), self.record, time.monotonic() - start)

    def decompose(self):
        outcome, identity = "time", self.program.identity()
        if self.outcome_file.exists() and not self.options.fresh and not self.program.is_ours():
            outcome, *before = self.outcome_file.read_text().split("\n")
            outcome = outcome if before == [identity] else "time"
        if says_nothing(outcome):
            start = time.monotonic()
            outcome = run_program(self.program, self.source, self.target, 0, self.options.time_limit)
            self.outcome_file.write_text(f"{outcome}\n{identity}")
            if self.program.is_ours():  # with its start, because it does not say how long it took
                self.record["seconds"] = time.monotonic() - start
        self.record["outcome"] = outcome
        self.record.setdefault("seconds", own_seconds(self.target))

    def verify(self):
        """The defaults, timed, as a user asks; then all claims by name, covers-solid only where there is a solid."""
        ask = self.options.convexact, self.source, self.target, self.program.numbers, self.options.verify_limit
        _, _, self.record["verify_seconds"] = ask_union(*ask, [])
        _, _, self.record["verdict_seconds"] = ask_union(*ask, ["--no-tightness"])
        status, answer, _ = ask_union(*ask, ["--claims", f"{ASKED},covers-solid", "--distance", DISTANCE])
        self.record.update(status=status, answer=answer)


def judge_run(work):
    """The judge's verdict, or the one that it gave before on the same parts."""
    source, target, numbers, most = work
    given = read(source, numbers)
    whole = len(given.faces) <= most  # its surface, or only its points
    memory, digest = Path(target + ".judge"), judges_digest(bytes_of(Path(source)), bytes_of(Path(target)), numbers, whole)
    verdict = json.loads(memory.read_text()) if memory.exists() else {}
    if verdict.get("digest") != digest:
        start = time.monotonic()
        verdict = judge_part_files(given, target, numbers, most=most, distance=DISTANCE).as_json()
        verdict.update(seconds=round(time.monotonic() - start, 3), digest=digest)
        memory.write_text(json.dumps(verdict))
    return verdict


def parse_options(arguments):
    parser = argparse.ArgumentParser(prog="./dev field --decompositions", description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--convexact", required=True, help="the program to be judged (./dev field names it)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="judges at a time (default: the processors); "
                        "decomposers and verify run one at a time, since they are timed")
    parser.add_argument("--case", action="append", help="only this mesh; may be repeated")
    parser.add_argument("--program", action="append", help="only this decomposer; may be repeated")
    parser.add_argument("--only", metavar="NAME", help="one decomposer in minutes: --program NAME on the meshes of the table")
    parser.add_argument("--table", action="store_true", help="only the meshes of the table in docs/results/field.md")
    parser.add_argument("--real", metavar="COUNT", type=int, nargs="?", const=30, default=0,
                        help="real meshes of packages of robots instead: the first thirty of the list, or COUNT of it")
    parser.add_argument("--time-limit", type=float, default=300, help="seconds for one run of a decomposer (default 300)")
    parser.add_argument("--verify-limit", type=float, default=300, help="seconds for one verdict (default 300)")
    parser.add_argument("--most", type=int, default=7000,
                        help="triangles of the largest surface that the independent judge tests (default 7000); points always")
    parser.add_argument("--times", action="store_true",
                        help="only time them on the meshes of the table, by the processor, each run followed by one of convexact-cut")
    parser.add_argument("--no-judge", action="store_true", help="ask convexact only")
    parser.add_argument("--fresh", action="store_true", help="run all decomposers again")
    parser.add_argument("--page", action="store_true", help="write the tables into docs/results/field.md, too")
    parser.add_argument("-o", dest="report", help="the report as JSON (default: in build/field, decompositions.json, or -real.json)")
    options = parser.parse_args(arguments)
    if options.real and (options.table or options.times):
        parser.error("--table and --times are for the meshes of the table, so not with --real")
    if options.only:
        options.program, options.table = [options.only], not options.real
    if options.table or options.times:
        options.case = list(PARTS_MESHES)
    options.suffix, options.shrink = "-real" if options.real else "", 0  # for the pages of decomposers
    options.report = options.report or str(BUILD / f"decompositions{options.suffix}.json")
    return options


def knows_unions(convexact):
    done = subprocess.run([convexact, "verify", "--help"], capture_output=True, text=True, check=False)
    return "--union" in done.stdout


def expected(runs, jobs):
    """Decomposers differ by a factor of a thousand, so what was never run is guessed from the triangles; so is the slow judge."""
    known = [seconds for run in runs if run.known() is None and (seconds := run.memory.seconds(run.program.name)) is not None]
    unknown = [run for run in runs if run.known() is None and run.memory.seconds(run.program.name) is None]
    fresh = [run for run in runs if not Path(str(run.target) + ".judge").exists()]
    return expectation(known, [5 + 0.01 * run.record["triangles"] for run in unknown]
                       + [0.01 * run.record["triangles"] / jobs for run in fresh], 1)


def main(arguments=None):
    options = parse_options(arguments)
    options.convexact = str(Path(options.convexact).resolve())
    options.asks = knows_unions(options.convexact)
    options.digest = judges_digest(bytes_of(Path(options.convexact)), options.verify_limit)
    everything = decomposers(options.convexact)
    meshes, skipped = real_solids(options.real) if options.real else (all_meshes(), {})
    programs = [program for program in everything if not options.program or program.name in options.program]
    runs = [Run(case, mesh, program, options) for case, mesh in meshes.items() for program in programs
            if not program.missing and (not options.case or case in options.case)]
    if options.times:
        cells = {name: cell(times) for name, times in timed_runs(runs, options.time_limit).items()}
        if options.page:
            edit_page("decompositions", lambda old: with_times(old, cells))
        print("\n".join(f"{name}: {text}" for name, text in cells.items()))
        return 0
    print(f"{len(runs)} decompositions; {expected(runs, options.jobs)}", flush=True)
    for done, run in enumerate(runs, 1):
        run.settle()
        if sys.stderr.isatty():
            print(f"\r{done} of {len(runs)} decompositions", end="", file=sys.stderr, flush=True)
    judged = [run for run in runs if run.record["outcome"] == "output" and not options.no_judge]
    with Pool(options.jobs) as pool:
        work = [(str(run.source), str(run.target), run.program.numbers, options.most) for run in judged]
        for run, verdict in zip(judged, pool.imap(judge_run, work)):
            run.record["judge"] = verdict
            run.record["differences"] = differences_of(verdict, run.record["status"], run.record["answer"]) if options.asks else []
    records = [run.record for run in runs]
    Path(options.report).write_text(json.dumps({"records": records}, indent=1) + "\n")
    table = (real_parts_table if options.real else parts_table)(records, programs)
    write_page("real-parts" if options.real else "decompositions", table, options.page, [program.name for program in everything])
    if options.page and not options.real:
        matrix = parts_matrix(edit_page("decompositions", str.strip))
        edit_page("matrix", lambda old: matrix)
    for program in (program for program in programs if not program.missing):
        mine = [run for run in runs if run.program is program]
        found = [parts_finding(program, run.record, run.source, run.target) for run in mine]
        write_subject(options, program, [finding for finding in found if finding], len(mine))
    print(table)
    skipped.update({program.name: program.missing for program in programs if program.missing})
    return report(records, skipped, options)


def report(records, skipped, options):
    differing = 0
    for record in records:
        for kind, claim, sentence in record.get("differences", []):
            differing += 1
            print(f"{kind}: {record['case']} {record['program']}: {claim}: {sentence}")
    for name, reason in {**skipped, **({} if options.program else NOT_HERE)}.items():
        print(f"skipped: {name}: {reason}")
    judged = sum("judge" in record for record in records)
    print(f"{judged} decompositions judged{'' if options.asks else ' by the independent judge only'}, {differing} differences; "
          f"{options.report}")
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main())
