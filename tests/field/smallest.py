# SPDX-License-Identifier: MIT
"""The smallest input that `convexact shrink` finds for each kind of fault of each hull program of ./dev field, from the report of
an earlier run: build/field/smallest/PROGRAM-KIND.obj, and a table of them."""
import argparse
import json
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from programs import BUILD, ROOT, all_programs  # noqa: E402
from run import all_cases  # noqa: E402
from subjects import hull_finding, smallest  # noqa: E402
from tables import write_page  # noqa: E402

# By rank of a finding. The others are what a program does within its promise, or may, as its faces are no exact planes.
KINDS = {0: "signal", 1: "nothing", 2: "no-volume", 3: "outside"}
COLUMNS = ("ends the process", "no answer, or nothing", "no volume", "points outside")
MOST_TRIED = 3  # inputs of one kind, the worst first, if those before could not be reduced
MOST_SHOWN = 8  # points in the table


def findings_of(program, records, faces):
    """By kind, the worst first."""
    kinds = {kind: [] for kind in KINDS}
    for record in records:
        if record["program"] != program.name or record["tolerance"] is not None:
            continue
        found = hull_finding(program, record, BUILD / "out" / record["case"] / "input.obj", BUILD / record["file"],
                             faces[record["case"]])
        if found and found.rank in kinds and found.source.exists():
            kinds[found.rank].append(found)
    for found in kinds.values():
        found.sort(key=lambda finding: (-finding.size, finding.case))
    return kinds


def points_of(text):
    return [line[2:] for line in text.splitlines() if line.startswith("v ")]


def reduced(program, found, options):
    """The first of the worst findings that can be reduced, with the text of its input; or None and why not."""
    fault = ""
    for finding in found[:MOST_TRIED]:
        _, text = smallest(options.convexact, program, finding, options.seconds)
        if points_of(text):
            return finding, text
        fault = fault or text
    return None, fault


def cell(found, finding, text):
    """How many inputs have the fault, how far at the worst, and the smallest input."""
    count = f"{len(found)}, at most {found[0].size:.1g} D" if found[0].size else f"{len(found)}"
    if finding is None:
        return f"{count}; not reduced: {text.replace('|', '/')}"
    points = points_of(text)
    listed = ": " + "; ".join(points) if len(points) <= MOST_SHOWN else ""
    return f"{count}; {counted(len(points))}{listed}"


def counted(points):
    return "1 point" if points == 1 else f"{points} points"


def row(program, kinds, folder, options):
    cells = []
    for rank, found in kinds.items():
        finding, text = reduced(program, found, options) if found else (None, "")
        if finding:
            (folder / f"{program.name}-{KINDS[rank]}.obj").write_text(text)
        cells.append(cell(found, finding, text) if found else "")
    return f"| `{program.name}` | " + " | ".join(cells) + " |"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("seconds", type=float, help="for each kind of fault of a program, and input that is tried")
    parser.add_argument("--only", action="append", help="only this program; may be repeated")
    parser.add_argument("--page", action="store_true", help="write the table into docs/results/field.md, too")
    parser.add_argument("--convexact", default=str(ROOT / "build" / "run" / "src" / "cli" / "convexact"))
    options = parser.parse_args()
    report = BUILD / "report.json"
    if not report.exists():
        sys.exit(f"{report} is missing: run ./dev field first")
    records, faces = json.loads(report.read_text())["records"], {case[0]: case[2] for case in all_cases("")}
    folder = BUILD / "smallest"
    folder.mkdir(exist_ok=True)
    rows = ["| program | " + " | ".join(COLUMNS) + " |", "| --- |" + " --- |" * len(COLUMNS)]
    programs = all_programs(options.convexact)
    for program in programs:
        if program.is_ours() or program.missing or (options.only and program.name not in options.only):
            continue
        kinds = findings_of(program, records, faces)
        if any(kinds.values()):
            rows.append(row(program, kinds, folder, options))
            print(rows[-1], flush=True)
    write_page("smallest", "\n".join(rows), options.page, [program.name for program in programs])


if __name__ == "__main__":
    main()
