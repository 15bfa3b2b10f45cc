# SPDX-License-Identifier: MIT
"""The smallest input for each kind of fault of each program of ./dev field, from the reports of an earlier run: of hull programs by
`convexact shrink`, of decomposers by smaller_mesh.py. build/field/smallest/PROGRAM-KIND.obj, and two tables of them."""
import argparse
import json
import sys
import tempfile
from fractions import Fraction
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from decompositions import ask_union  # noqa: E402
from mutate import obj_text  # noqa: E402
from programs import BUILD, ROOT, all_programs, decomposers, run_program  # noqa: E402
from reading import read  # noqa: E402
from run import all_cases  # noqa: E402
from smaller_mesh import is_surface, smaller_mesh, touches_itself  # noqa: E402
from subjects import hull_finding, smallest  # noqa: E402
from tables import middle, relative_distance, root, uncovered_share, write_page  # noqa: E402

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


# ---- Decomposers

PARTS_COLUMNS = ("ends the process", "nothing, and no error", "points outside by more than 1e-6 D", "over 1% of the surface outside")
LEAST_DISTANCE, LEAST_SHARE = 1e-6, 0.01  # beyond what roundings do, also those of binary32
PART_SECONDS = 60  # for a decomposer on an input that is reduced; one that needs longer is no fault, as machines differ


def kinds_of(outcome, distance, share):
    """Which of the columns a run belongs to."""
    if outcome != "output":
        return {0} if outcome.startswith("signal") else {1} if outcome == "no file" else set()
    return {k for k, is_there in ((2, distance > LEAST_DISTANCE), (3, share > LEAST_SHARE)) if is_there}


def asked_of(convexact, program, source, target):
    """The kinds of faults of a run, with how far points are outside and how much of the surface is, if it wrote parts."""
    outcome = run_program(program, source, target, 0, PART_SECONDS)
    if outcome != "output":
        return kinds_of(outcome, 0, 0), 0, 0
    _, answer, _ = ask_union(convexact, source, target, program.numbers, PART_SECONDS, ["--claims", "covers-points,covers-surface"])
    if not answer or "claims" not in answer:
        return set(), 0, 0
    said = {claim["code"]: claim for claim in answer["claims"]}
    distance, share = said["covers-points"].get("witness", {}).get("distance"), answer.get("measures", {}).get("uncovered_area_share")
    sides = [Fraction(max(axis)) - Fraction(min(axis)) for axis in zip(*read(source).points)]
    far = root(Fraction(distance["squared"]) / sum(side * side for side in sides)) if distance else 0
    lost = middle(share) if share else 0
    return kinds_of(outcome, far, lost), far, lost


def inputs_of(program, records):
    """By kind: the meshes with such a fault, that of the fewest triangles first."""
    found = {k: [] for k in range(len(PARTS_COLUMNS))}
    for record in sorted((r for r in records if r["program"] == program.name), key=lambda r: (r["triangles"], r["case"])):
        judge = record.get("judge")
        distance, share = (relative_distance(judge), uncovered_share(record) or 0) if judge else (0, 0)
        for kind in kinds_of(record["outcome"], distance, share):
            source = BUILD / "parts" / record["case"] / "input.obj"
            if source.exists():
                found[kind].append(source)
    return found


def reduced_mesh(program, kind, sources, options):
    """The mesh, how far points are outside and how much of the surface; None if no input has the fault again, or is a surface."""
    with tempfile.TemporaryDirectory() as folder:
        source, target = Path(folder) / "input.obj", Path(folder) / "output.obj"
        seen = []

        def fails(mesh):
            source.write_bytes(obj_text(mesh))
            kinds, *sizes = asked_of(options.convexact, program, source, target)
            if kind in kinds:
                seen[:] = sizes  # of the last one that is kept
            return kind in kinds
        for path in sources[:MOST_TRIED]:
            mesh = read(path)
            if is_surface(mesh) and not touches_itself(mesh) and fails(mesh):
                return smaller_mesh(mesh, fails, options.seconds), *seen
    return None


def parts_cell(program, kind, sources, folder, options):
    if not sources:
        return ""
    found = reduced_mesh(program, kind, sources, options)
    if found is None:
        return f"{len(sources)}; not reduced: none of the {min(MOST_TRIED, len(sources))} smallest is a surface with the fault again"
    mesh, distance, share = found
    (folder / f"{program.name}-{('signal', 'nothing', 'outside', 'surface')[kind]}.obj").write_bytes(obj_text(mesh))
    size = {2: f", by {distance:.1g} D", 3: f", {100 * share:.0f}%"}.get(kind, "")
    listed = ": " + "; ".join(" ".join(f"{x:g}" if float(f"{x:g}") == x else repr(x) for x in point) for point in mesh.points)
    return f"{len(sources)}; {counted(len(mesh.points))}, {len(mesh.faces)} triangles{size}{listed if len(mesh.points) <= MOST_SHOWN else ''}"


def parts_rows(options, folder):
    records = [record for name in ("decompositions.json", "decompositions-real.json") if (BUILD / name).exists()
               for record in json.loads((BUILD / name).read_text())["records"]]
    rows = ["| program | " + " | ".join(PARTS_COLUMNS) + " |", "| --- |" + " --- |" * len(PARTS_COLUMNS)]
    for program in decomposers(options.convexact):
        if program.is_ours() or program.missing or (options.only and program.name not in options.only):
            continue
        sources = inputs_of(program, records)
        if any(sources.values()):
            cells = [parts_cell(program, kind, own, folder, options) for kind, own in sources.items()]
            rows.append(f"| `{program.name}` | " + " | ".join(cells) + " |")
            print(rows[-1], flush=True)
    return rows


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
    rows = parts_rows(options, folder)
    write_page("smallest-parts", "\n".join(rows), options.page, [program.name for program in decomposers(options.convexact)])


if __name__ == "__main__":
    main()
