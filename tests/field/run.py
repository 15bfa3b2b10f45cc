#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the field's programs over the conformance vectors and the meshes, and has two judges settle each output.

`convexact verify` and judge.py, which shares nothing with it, decide about every output, and about
deliberate damage to some. Exit code 1 if they differ anywhere. What is found of each program goes to
build/field/hulls.md, a table, and with --page to docs/results/field.md, in place of the rows of these programs.
A run says before how long it will take; it resumes where an earlier one stopped.
"""
import argparse
import json
import os
import random
import sys
import time
from collections import Counter
from multiprocessing import Pool
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from compare import Differences, ask_convexact, compare  # noqa: E402
from judge import Input, judge_files  # noqa: E402
from memory import Memory, bytes_of, digest_of, expectation, judges_digest, write_whole  # noqa: E402
from mutate import mutations, obj_text, off_text, ply_bytes  # noqa: E402
from programs import BUILD, MOST_USED, NOT_HERE, ROOT, all_programs, own_seconds, run_program, says_nothing  # noqa: E402
from real_meshes import real_meshes  # noqa: E402
from reading import Malformed, Mesh, NotFinite, read, vector_number  # noqa: E402
from subjects import hull_finding, write_subject  # noqa: E402
from tables import distance_table, ends_table, found_in, hull_table, write_page  # noqa: E402

TOLERANCES = ("1e-15d", "1e-9d", "1e-6d", "1e-2d")
MESHES = sorted(path.stem for path in (ROOT / "tests" / "data").glob("*.obj"))
WRITERS = {"obj": obj_text, "ply": ply_bytes, "off": off_text}


def vector_points(entry):
    """The points of a vector's input; None if it has halfspaces or a text."""
    if "points" in entry:
        return [tuple(vector_number(x) for x in point) for point in entry["points"]]
    if isinstance(entry.get("file"), str):
        mesh = read(ROOT / "tests" / "data" / entry["file"])
        return [tuple(x * entry["scale"] for x in point) for point in mesh.points]
    return None


def all_cases(wanted):
    """(name, points, faces asked for), each input once, small ones first."""
    cases = {}
    for path in sorted((ROOT / "tests" / "vectors").glob("*.json")):
        for vector in json.loads(path.read_text())["vectors"]:
            points, key = vector_points(vector["input"]), json.dumps(vector["input"], sort_keys=True)
            if points and (key not in cases or "faces" in vector["question"]):
                cases[key] = (vector["id"], points, vector["question"].get("faces", 8))
    for path in sorted((ROOT / "tests" / "data").glob("*.obj")):
        cases[path.stem] = (path.stem, read(path).points, 18)
    return sorted((case for case in cases.values() if wanted in case[0]), key=lambda case: len(case[1]))


def real_cases(wanted, count):
    """As all_cases(), of real meshes, and why others are missing. Files of STL repeat their points for each triangle."""
    meshes, reasons = real_meshes(count)
    cases = [(name, list(dict.fromkeys(mesh.points)), 18) for name, mesh in meshes if wanted in name]
    return sorted(cases, key=lambda case: len(case[1])), reasons


def input_text(given):
    """Points and, of a solid, the facets of its hull: some programs want a closed mesh."""
    faces = []
    if given.hull:
        index = {point: k for k, point in reversed(list(enumerate(given.integers)))}
        faces = [[index[given.hull.points[corner]] for corner in facet.corners] for facet in given.hull.facets]
    return obj_text(Mesh(given.points, faces))


def number_options(numbers):
    return {"binary64": [], "binary32": ["--numbers", "binary32"]}[numbers]


class Case:
    """One input: every program's output, two verdicts on each."""

    def __init__(self, name, points, faces, options):
        self.name, self.points, self.faces, self.options = name, points, faces, options
        self.folder = BUILD / "out" / name
        self.folder.mkdir(parents=True, exist_ok=True)
        self.source, self.outcomes_file = self.folder / "input.obj", self.folder / "outcomes.json"
        self.given, self.own, self.outcomes = {}, {}, None
        self.memory = Memory(self.folder / "verdicts.json", options.fresh)
        self.digest, self.digest_of_input = digest_of(options.digest, name, points, faces), judges_digest(points)

    def prepare(self):
        """Writes the input, once: its hull by the judge is slow."""
        kept = self.outcomes_file.exists() and not self.options.fresh
        self.outcomes = json.loads(self.outcomes_file.read_text()) if kept else {}
        if self.source.exists() and self.memory.recall("input", self.digest_of_input) is not None:
            return
        start = time.monotonic()
        text = input_text(self.input_for("binary64"))
        if bytes_of(self.source) != text:
            self.source.write_bytes(text)
            self.outcomes = {}
        self.memory.keep("input", self.digest_of_input, "written", time.monotonic() - start)

    def random(self, *names):
        return random.Random(int(digest_of(self.name, *names), 16))

    def target_of(self, program):
        return self.folder / f"{program.name}.{program.writes}"

    def digest_with(self, program):
        numbers = () if program.numbers == "binary64" else (program.numbers,)
        return digest_of(self.digest, program.identity(), program.promise, bytes_of(self.target_of(program)), *numbers)

    def expected(self, programs):
        """Seconds of what is still to do: those measured before, and guesses for the rest."""
        todo = [program.name for program in programs if self.memory.recall(program.name, self.digest_with(program)) is None]
        known = [self.memory.seconds(name) for name in todo]
        guessed = [1 + 0.005 * min(len(self.points), 1000) for seconds in known if seconds is None]
        if todo and self.memory.recall("input", self.digest_of_input) is None:
            guessed.append(5e-5 * len(self.points) ** 1.5)
        return [seconds for seconds in known if seconds is not None], guessed

    def settled(self, program):
        """The records of one program: those of an earlier run, if nothing has changed."""
        found = self.memory.recall(program.name, self.digest_with(program))
        if found is None:
            if self.outcomes is None:
                self.prepare()
            start = time.monotonic()
            found = self.run(program)
            if not says_nothing(found[0]["outcome"]):
                self.memory.keep(program.name, self.digest_with(program), found, time.monotonic() - start)
            write_whole(self.outcomes_file, json.dumps(self.outcomes))
        return found

    def input_for(self, numbers):
        if numbers not in self.given:
            points = self.points if numbers == "binary64" else read(self.source, numbers).points
            self.given[numbers] = Input(points)
        return self.given[numbers]

    def too_large(self, target, numbers):
        try:
            return len(getattr(read(target, numbers), "points", ())) > self.options.most
        except (Malformed, NotFinite):
            return False

    def settle(self, program, target, numbers, tolerances):
        """One record for each tolerance; None asks for the exact verdicts."""
        if self.too_large(target, numbers):
            _, answer = ask_convexact(self.options.convexact, self.source, target, ["--asks", "hull", *number_options(numbers)],
                                      self.options.verify_limit)
            return [self.record(program, target, "too large for the judge", [], found=found_in(answer))]
        try:
            given, start = self.input_for(numbers), time.monotonic()
        except NotFinite:
            return [self.record(program, target, f"an input beyond {numbers}", [])]
        verdict, records = judge_files(given, target, numbers, asks_hull=True) if given.hull else None, []
        for tolerance in tolerances:
            differences, status, answer = compare(self.options.convexact, given, self.source, target, numbers, tolerance,
                                                  seconds=self.options.verify_limit, verdict=verdict)
            records.append(self.record(program, target, f"exit {status}", differences.found, tolerance, numbers,
                                       time.monotonic() - start, None if tolerance else found_in(answer)))
        return records

    def record(self, program, target, outcome, differences, tolerance=None, numbers="", seconds=0.0, found=None):
        return {"case": self.name, "program": program, "file": str(target.relative_to(BUILD)), "outcome": outcome,
                "differences": differences, "tolerance": tolerance, "numbers": numbers, "seconds": round(seconds, 3), "found": found}

    def run(self, program):
        target = self.target_of(program)
        outcome, identity = self.outcomes.get(program.name, ("time", ""))
        if says_nothing(outcome) or identity != program.identity() or program.is_ours():
            start = time.monotonic()
            outcome = run_program(program, self.source, target, self.faces, self.options.time_limit)
            self.outcomes[program.name] = outcome, program.identity()
            if program.is_ours():  # with its start, because it does not say how long it took
                self.own[program.name] = time.monotonic() - start
        if outcome != "output":
            return [self.record(program.name, target, outcome, [])]
        numbers = program.numbers
        records = self.settle(program.name, target, numbers, (None, self.random(program.name).choice(TOLERANCES)))
        self.add_own(program, target, numbers, records[0])
        return records

    def add_own(self, program, target, numbers, record):
        """The seconds of the program's own call, and whether it keeps what it promises."""
        found = record["found"]
        if not found:
            return
        found["seconds"] = self.own.get(program.name) or own_seconds(target)
        found["mesh"] = self.name in MESHES
        if program.promise:
            _, answer = ask_convexact(self.options.convexact, self.source, target,
                                      ["--asks", "hull", "--tolerance", program.promise, *number_options(numbers)], self.options.verify_limit)
            again = found_in(answer)
            found["keeps_promise"] = bool(again and again["contains"])
            found["is_promised_hull"] = bool(again and again["is_hull"])

    def run_mutants(self, targets):
        """Damages an output with faces in every way, and writes it in one of three formats."""
        meshes, chance = [], self.random("mutants")
        for target in targets:
            try:
                mesh = read(target)
            except (Malformed, NotFinite):
                continue
            if isinstance(mesh, Mesh) and mesh.faces and len(mesh.points) <= self.options.most // 4:
                meshes.append(mesh)
        records = []
        for mesh in chance.sample(meshes, min(len(meshes), self.options.mutants)):
            for name, mutant in mutations(mesh, chance):
                form = chance.choice(sorted(WRITERS))
                target = self.folder / f"mutant-{name}.{form}"
                target.write_bytes(WRITERS[form](mutant))
                found = self.settle("mutant " + name, target, "binary64", [chance.choice((None, None, *TOLERANCES))])
                if not any(record["differences"] for record in found):
                    target.unlink()
                records += found
        return records


def chosen_programs(options):
    return [program for program in all_programs(options.convexact)
            if not program.missing and (not options.program or program.name in options.program)]


def run_case(work):
    case, options = Case(*work), work[-1]
    records, targets = [], []
    for program in chosen_programs(options):
        found = case.settled(program)
        records += found
        if found[0]["outcome"].startswith("exit") and program.writes == "obj":
            targets.append(BUILD / found[0]["file"])
    if options.mutants and targets and case.input_for("binary64").hull:
        records += case.run_mutants(targets)
    return records


def write_subjects(records, programs, work, options):
    """A page for each program, of the verdicts without a tolerance."""
    faces = {case[0]: case[2] for case in work}
    for program in programs:
        mine = [record for record in records if record["program"] == program.name and record["tolerance"] is None]
        found = [hull_finding(program, record, BUILD / "out" / record["case"] / "input.obj", BUILD / record["file"], faces[record["case"]])
                 for record in mine]
        write_subject(options, program, [finding for finding in found if finding], len(mine))


def table(records):
    rows, head = {}, ["program", "outputs", "none", "agree", *Differences.KINDS]
    for record in records:
        row = rows.setdefault(record["program"], Counter())
        judged = record["outcome"].startswith("exit")
        row["outputs" if judged else "none"] += 1
        found = {kind for kind, _, _ in record["differences"]}
        row["agree"] += judged and not found
        row.update(found)
    lines = [[name, *(str(row[column]) for column in head[1:])] for name, row in rows.items()]
    widths = [max(len(line[k]) for line in [head, *lines]) for k in range(len(head))]
    return "\n".join("  ".join(cell.ljust(width) if k == 0 else cell.rjust(width)
                               for k, (cell, width) in enumerate(zip(line, widths))) for line in [head, *lines])


def parse_options(arguments):
    parser = argparse.ArgumentParser(prog="./dev field", description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--convexact", required=True, help="the program to be judged (./dev field names it)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="cases at a time (default: the processors)")
    parser.add_argument("--case", default="", help="only inputs whose name has this in it")
    parser.add_argument("--program", action="append", help="only this program; may be repeated")
    parser.add_argument("--only", metavar="NAME", help="one program, as in the table: --program NAME --mutants 0")
    parser.add_argument("--time-limit", type=float, default=20, help="seconds for one run of a program (default 20)")
    parser.add_argument("--verify-limit", type=float, default=120, help="seconds for one verdict (default 120)")
    parser.add_argument("--most", type=int, default=700, help="points of the largest output to judge (default 700)")
    parser.add_argument("--mutants", type=int, default=1, help="outputs of each input to be damaged (default 1)")
    parser.add_argument("--every", type=int, default=1, help="only every Nth input (default 1)")
    parser.add_argument("--meshes", action="store_true", help="with --every: the meshes of tests/data in any case")
    parser.add_argument("--real", metavar="COUNT", type=int, nargs="?", const=30, default=0,
                        help="real meshes of packages of robots instead of vectors and tests/data: the first thirty of the list, or as "
                        "many as COUNT, which is for the most used programs (" + ", ".join(MOST_USED) + ") if no other is named")
    parser.add_argument("--fresh", action="store_true", help="run all programs again, also where their output is there")
    parser.add_argument("--page", action="store_true", help="write the table into docs/results/field.md, too")
    parser.add_argument("--shrink", type=float, default=0, metavar="SECONDS",
                        help="reduce the worst input of each program, in so much time, for its page in build/field/subjects")
    parser.add_argument("-o", dest="report", help="the report as JSON (default: in build/field, report.json, report-real.json, ...)")
    options = parser.parse_args(arguments)
    if options.only:
        options.program, options.mutants = [options.only], 0
    options.suffix = "" if not options.real else "-real" if options.real <= 30 else f"-real-{options.real}"
    options.report = options.report or str(BUILD / f"report{options.suffix}.json")
    if options.real > 30 and not options.program:
        options.program, options.mutants = list(MOST_USED), 0
    if options.page and options.case:
        parser.error("--page shows programs over all inputs, so not with --case")
    return options


def main(arguments=None):
    options = parse_options(arguments)
    options.convexact = str(Path(options.convexact).resolve())
    options.digest = judges_digest(bytes_of(Path(options.convexact)), options.most, options.verify_limit)
    cases, skipped = real_cases(options.case, options.real) if options.real else (all_cases(options.case), {})
    work = [(*case, options) for number, case in enumerate(cases)
            if number % options.every == 0 or (options.meshes and case[0] in MESHES)]
    skipped.update({program.name: program.missing for program in all_programs(options.convexact)
                    if program.missing and (not options.program or program.name in options.program)})
    programs, records = chosen_programs(options), []
    costs = [Case(*case).expected(programs) for case in work]
    print(f"{len(work)} inputs, {len(programs)} programs; "
          + expectation([x for known, _ in costs for x in known], [x for _, guessed in costs for x in guessed], options.jobs)
          + (" without the damaged outputs" if options.mutants else ""), flush=True)
    with Pool(options.jobs) as pool:
        for done, found in enumerate(pool.imap_unordered(run_case, work), 1):
            records += found
            if sys.stderr.isatty():
                print(f"\r{done} of {len(work)} inputs", end="", file=sys.stderr, flush=True)
    records.sort(key=lambda record: (record["program"], record["case"], record["tolerance"] or ""))
    differing = [record for record in records if record["differences"]]
    Path(options.report).write_text(json.dumps({"skipped": skipped, "records": records}, indent=1) + "\n")
    everything = all_programs(options.convexact)
    names = [program.name for program in everything]
    write_page(options.suffix[1:] or "hulls", hull_table(records, everything, len(work), options.real), options.page, names)
    if options.real:
        write_page(options.suffix[1:] + "-distances", distance_table(records, everything), options.page, names)
    else:
        write_page("ends", ends_table(records, everything), options.page, names)
    write_subjects(records, programs, work, options)
    print(table(records))
    for record in differing[:60]:
        for kind, claim, sentence in record["differences"]:
            print(f"{kind}: {record['file']} {record['tolerance'] or ''}: {claim}: {sentence}")
    for name, reason in {**skipped, **({} if options.program else NOT_HERE)}.items():
        print(f"skipped: {name}: {reason}")
    verdicts = sum(record["outcome"].startswith("exit") for record in records)
    print(f"{verdicts} verdicts of both judges on {len(work)} inputs, {len(differing)} differ; {options.report}")
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main())
