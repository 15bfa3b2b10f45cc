# SPDX-License-Identifier: MIT
"""The tables of docs/results/field.md: what ./dev field found of hull programs and of decomposers, a row for each.

A row says what it was made of and when, so a run of some programs replaces their rows and leaves the others.
"""
import math
import re
import statistics
import time
from decimal import ROUND_CEILING, Context
from fractions import Fraction

from programs import BUILD, ROOT

PAGE = ROOT / "docs" / "results" / "field.md"


def root(fraction):
    """A square root for the eye, also of fractions beyond doubles."""
    if not fraction:
        return 0.0
    bits = fraction.numerator.bit_length() - fraction.denominator.bit_length()
    shift = bits // 2
    return math.ldexp(math.sqrt(float(fraction / Fraction(2) ** (2 * shift))), shift)


def found_in(answer):
    """What the table needs of the JSON of `convexact verify`; None if it has no verdict."""
    if not answer or "claims" not in answer:
        return None
    claims = {claim["code"]: claim for claim in answer["claims"]}
    holds = {name: claims[name]["status"] == "holds" for name in
             ("candidate-solid", "mesh-closed", "mesh-oriented", "mesh-planar", "mesh-convex", "contains-input")
             if name in claims and claims[name]["status"] != "not-applicable"}
    distance = claims["contains-input"].get("witness", {}).get("distance", {})
    return {"solid": holds.get("candidate-solid", False), "contains": holds.get("contains-input", False),
            "planar": holds.get("mesh-planar"), "facets": answer.get("candidate", {}).get("facets"),
            "outward": all(holds.get(name) for name in ("mesh-closed", "mesh-oriented")),
            "convex": all(holds.get(name) for name in ("mesh-closed", "mesh-oriented", "mesh-convex")),
            "is_hull": claims.get("is-hull", {}).get("status") == "holds",
            "outside": answer.get("outside", {}).get("points"), "relative": distance.get("relative")}


def small(value):
    return "0" if not value else f"{value:.1e}" if value < 0.001 else f"{value:.2g}"


def short_time(seconds):
    if seconds is None:
        return "-"
    return f"{seconds * 1e6:.3g} µs" if seconds < 1e-3 else f"{seconds * 1e3:.3g} ms" if seconds < 1 else f"{seconds:.3g} s"


def markdown(head, rows, left=1):
    rule = ["---"] * left + ["---:"] * (len(head) - left)
    return "\n".join("| " + " | ".join(row) + " |" for row in [head, rule, *rows])


def said(count, total):
    return "all" if count == total else f"{count} of {total}"


def hull_row(program, found, inputs):
    """One program: how many outputs, and in how many of them what holds; meshes are where times are comparable."""
    solid = [f for f in found if f["solid"]]
    missing = [f for f in solid if not f["contains"]]
    worst = max((float(f["relative"]) for f in missing if f["relative"]), default=0.0)
    planar = [f["planar"] for f in found if f["planar"] is not None]
    meshes = [f for f in found if f["mesh"] and f["seconds"] is not None]
    shown_times = ", ".join(short_time(f["seconds"]) for f in sorted(meshes, key=lambda f: f["case"]))
    facets = ", ".join(str(f["facets"]) for f in sorted(meshes, key=lambda f: f["case"]))
    promise = "" if not program.promise else \
        f"{program.promise.removesuffix('d')}{' D' if program.promise.endswith('d') else ''}: " \
        f"{said(sum(bool(f.get('keeps_promise')) for f in solid), len(solid))}"
    hulls = said(sum(bool(f["is_hull"]) for f in found), len(found))
    if program.promise:
        hulls += f"; within its promise {said(sum(bool(f.get('is_promised_hull')) for f in found), len(found))}"
    small_times = [f["seconds"] for f in found if f["seconds"] is not None and not f["mesh"]]
    twice = sum(f["outcome"].startswith("exit") for f in found)  # of the others convexact alone decides, by their size
    return [f"`{program.name}`", program.version or "this one", f"{inputs}; {time.strftime('%Y-%m-%d')}", str(len(found)),
            said(twice, len(found)), said(len(solid), len(found)),
            said(len(solid) - len(missing), len(solid)) if solid else "-", small(worst), promise, hulls,
            said(sum(bool(f["outward"]) for f in found), len(found)) if planar else "-",
            said(sum(bool(f["convex"]) for f in found), len(found)) if planar else "-",
            said(sum(planar), len(planar)) if planar else "-", short_time(statistics.median(small_times) if small_times else None),
            shown_times or "-", facets or "-"]


HULL_HEAD = ["program", "package", "inputs; date", "outputs", "judged twice", "solid", "hold the input", "farthest outside, D",
             "within its promise", "are the hull", "outward", "convex", "planar", "median time", "time: bunny, spot, teapot", "facets"]


def outputs_by_name(records):
    """What was found of each output, by program: of the records that have the seconds, which are those without a tolerance."""
    by_name = {}
    for record in records:
        if record["found"] and "seconds" in record["found"]:
            by_name.setdefault(record["program"], []).append({"case": record["case"], "outcome": record["outcome"], **record["found"]})
    return by_name


def hull_table(records, programs, inputs, real=False):
    """Real meshes are no peers of bunny, spot and teapot, whose columns are left out."""
    by_name = outputs_by_name(records)
    columns = len(HULL_HEAD) - (2 if real else 0)
    rows = [hull_row(program, by_name[program.name], inputs)[:columns] for program in programs if program.name in by_name]
    return markdown(HULL_HEAD[:columns], rows, left=2)


# In diameters: how far the worst point of an output is outside. Each output is counted once, in the first that it is below.
DISTANCES = (1e-15, 1e-12, 1e-9, 1e-6, 1e-3)
DISTANCE_HEAD = ["program", "outputs", "0", *(f"< {bound:.0e}".replace("e-0", "e-") for bound in DISTANCES), "farther", "no volume"]


def distance_row(program, found):
    solid = [f for f in found if f["solid"]]
    counts = [sum(bool(f["contains"]) for f in solid), *[0] * (len(DISTANCES) + 1)]
    for distance in (float(f["relative"]) for f in solid if not f["contains"]):
        counts[1 + sum(distance >= bound for bound in DISTANCES)] += 1
    return [f"`{program.name}`", *map(str, (len(found), *counts, len(found) - len(solid)))]


def distance_table(records, programs):
    """How often, and not only how far at worst, outputs miss points of their input."""
    by_name = outputs_by_name(records)
    return markdown(DISTANCE_HEAD, [distance_row(program, by_name[program.name]) for program in programs if program.name in by_name])


ENDS = ("exception or error", "empty result, no error", "ends the process", "no answer in time")


def end_of(outcome):
    """In the words of ENDS, of a run without an output; None of one that wrote one, judged or not."""
    if outcome.startswith(("signal", "refused 101")):  # Rust's exit code of a panic
        return ENDS[2]
    kinds = {"refused": ENDS[0], "no file": ENDS[1], "time": ENDS[3]}
    return next((words for start, words in kinds.items() if outcome.startswith(start)), None)


def ends_table(records, programs):
    """How often each program wrote nothing, and how it ended then; also for inputs without a volume."""
    rows = []
    for program in programs:
        found = [end_of(record["outcome"]) for record in records if record["program"] == program.name and record["tolerance"] is None]
        if found:
            rows.append([f"`{program.name}`", str(len(found)), *(str(found.count(end)) for end in (*ENDS, None))])
    return markdown(["program", "inputs", *ENDS, "output"], rows)


def with_old_rows(text, old, names):
    """The table `text`, with the rows of `old` for programs that it has not; in the order of `names`."""
    head, before = text.split("\n")[:2], old.strip().split("\n")
    rows, kept = ({line.split("`")[1]: line for line in lines[2:]} for lines in (text.split("\n"), before))
    if len(before) > 1 and before[:2] != head and any(name in kept and name not in rows for name in names):
        raise ValueError("docs/results/field.md has other columns: run all programs")
    found = {**kept, **rows}
    return "\n".join(head + [found[name] for name in names if name in found])


def edit_page(name, change):
    """Puts change(table) in the place of the table between the two marks of that name in the page, and returns it."""
    page = PAGE.read_text()
    marks = re.search(rf"(<!-- {name}: .*?-->\n)(.*?)(<!-- end of {name} -->)", page, re.DOTALL)
    if not marks:
        raise ValueError(f"docs/results/field.md has no marks for {name}")
    table = change(marks[2])
    PAGE.write_text(page[:marks.start()] + marks[1] + "\n" + table + "\n\n" + marks[3] + page[marks.end():])
    return table


def write_page(name, text, into_page, names):
    """To build/field, and into the page."""
    BUILD.mkdir(parents=True, exist_ok=True)
    (BUILD / f"{name}.md").write_text(text + "\n")
    if into_page:
        edit_page(name, lambda old: with_old_rows(text, old, names))


def with_times(old, cells):
    """The table of decomposers with other times, by the names of the rows."""
    column, lines = PARTS_HEAD.index("its time"), []
    for line in old.strip().split("\n"):
        words = line.split(" | ")
        name = line.split("`")[1] if "`" in line else ""
        if name in cells:
            words[column] = cells[name]
        lines.append(" | ".join(words))
    return "\n".join(lines)


def middle(bounds):
    """Of an interval in an answer, as a number."""
    return (bounds["low"] + bounds["high"]) / 2


def percent(value):
    return "0" if not value else f"{100 * value:.1e}%" if value < 1e-4 else f"{100 * value:.2g}%" if value < 0.1 else f"{100 * value:.0f}%"


def relative_distance(judge):
    return root(Fraction(judge["squared_distance"]) / Fraction(judge["squared_diameter"]))


def faults(judges):
    """What is wrong with the parts themselves, of all meshes together, in words."""
    kinds = {"flat": lambda judge: len(judge["parts_not_solid"]), "not convex": lambda judge: len(judge["parts_not_convex"]),
             "pairs overlap": lambda judge: judge["overlapping_pairs"], "within another": lambda judge: len(judge["parts_inner"])}
    counts = {words: sum(count(judge) for judge in judges) for words, count in kinds.items()}
    return ", ".join(f"{count} {words}" for words, count in counts.items() if count) or "-"


def volume_share(measures, name):
    if "solid_volume" not in measures:
        return "-"
    return percent(max(middle(measures[name]), 0.0) / middle(measures["solid_volume"]))


def uncovered_share(record):
    """Of the surface, in no part, by convexact, or by the judge alone; None if neither says."""
    measures = (record.get("answer") or {}).get("measures", {})
    return middle(measures["uncovered_area_share"]) if "uncovered_area_share" in measures else record["judge"].get("uncovered_area_share")


def beyond(record):
    """How far the parts reach beyond the input's solid at most, in diameters, rounded up; REACH if that is proven to be enough."""
    answer, judge = record.get("answer") or {}, record["judge"]
    bounds = answer.get("measures", {}).get("union_to_input")
    if not bounds:
        return "-"
    relative = bounds["high"] / root(Fraction(judge["squared_diameter"]))
    held = any(claim["code"] == "within-solid" and claim["status"] == "holds" for claim in answer["claims"])
    bound = min(relative, REACH) if held else relative
    return small(float(Context(prec=2, rounding=ROUND_CEILING).create_decimal_from_float(bound)))


def judged_cells(record):
    """Of one mesh, in the order of PARTS_HEAD from "parts" on; a word in the first one if there is nothing to judge."""
    if record["outcome"] != "output" or "judge" not in record:
        words = {"time": "over time", "output": "not judged"}.get(record["outcome"], record["outcome"])
        return [words] + ["-"] * 9
    judge, measures = record["judge"], (record.get("answer") or {}).get("measures", {})
    share = uncovered_share(record)
    return [str(judge["parts"]), str(max(judge["facets"], default=0)), short_time(record["seconds"]),
            percent(judge["points_outside"] / judge["points"]), small(relative_distance(judge)), "-" if share is None else percent(share),
            volume_share(measures, "uncovered_volume"), volume_share(measures, "excess_volume"), beyond(record),
            short_time(record.get("verdict_seconds"))]


# How far parts may reach beyond the solid, in diameters, for the matrix.
REACH = 0.03
# The meshes of the table; each cell has their values in this order.
PARTS_MESHES = ("l", "plus", "cross", "torus", "spot", "cow")
PARTS_HEAD = ["decomposer", "package", "date", "parts", "most facets", "its time", "points outside", "farthest, D", "surface outside",
              "volume outside", "excess volume", "beyond, D", "verdict's time", "judged twice", "parts with faults"]


def parts_row(program, records):
    cells = zip(*(judged_cells(record) for record in records))
    judges = [record["judge"] for record in records if "judge" in record]
    twice = sum(judge["claims"]["covers-surface"] is not None for judge in judges)  # of the others the judge tests the points only
    return [f"`{program.name}`", program.version or "this one", time.strftime("%Y-%m-%d"), *(", ".join(column) for column in cells),
            said(twice, len(judges)), faults(judges)]


def parts_table(records, programs):
    """A row for each program that ran on all of PARTS_MESHES."""
    rows = []
    for program in programs:
        found = {record["case"]: record for record in records if record["program"] == program.name}
        if all(mesh in found for mesh in PARTS_MESHES):
            rows.append(parts_row(program, [found[mesh] for mesh in PARTS_MESHES]))
    return markdown(PARTS_HEAD, rows, left=2)


REAL_PARTS_HEAD = ["decomposer", "package", "date", "outputs", "judged twice", "hold all points", "farthest, D", "all of the surface",
                   "most surface outside", "the solid", "within 3% D of it", "parts", "median time", "parts with faults", "no output"]


def real_parts_row(program, records):
    """One decomposer on many meshes. The solid and the distance from it count where they are known: real surfaces may be open."""
    found = [record for record in records if record["outcome"] == "output" and "judge" in record]
    judges = [record["judge"] for record in found]
    shares = [share for share in map(uncovered_share, found) if share is not None]
    cells = [dict(zip(PARTS_HEAD[PARTS_HEAD.index("parts"):], judged_cells(record))) for record in found]
    volumes, reaches = ([of[column] for of in cells if of[column] != "-"] for column in ("volume outside", "beyond, D"))
    ends = [judged_cells(record)[0] for record in records if record not in found]
    seconds = [record["seconds"] for record in found if record["seconds"] is not None]
    return [f"`{program.name}`", program.version or "this one", time.strftime("%Y-%m-%d"), said(len(found), len(records)),
            said(sum(judge["claims"]["covers-surface"] is not None for judge in judges), len(judges)),
            said(sum(not judge["points_outside"] for judge in judges), len(judges)),
            small(max(map(relative_distance, judges), default=0.0)),
            said(sum(not share for share in shares), len(shares)), percent(max(shares, default=0.0)),
            said(sum(share == "0" for share in volumes), len(volumes)),
            said(sum(float(reach) <= REACH for reach in reaches), len(reaches)), str(sum(judge["parts"] for judge in judges)),
            short_time(statistics.median(seconds) if seconds else None), faults(judges),
            ", ".join(f"{ends.count(end)} {end}" for end in sorted(set(ends))) or "-"]


def real_parts_table(records, programs):
    rows = []
    for program in programs:
        mine = [record for record in records if record["program"] == program.name]
        if mine:
            rows.append(real_parts_row(program, mine))
    return markdown(REAL_PARTS_HEAD, rows, left=2)


FAULTS = ("flat", "not convex", "pairs overlap", "within another")


def matrix_row(cells):
    """By question: on how many meshes nothing is outside; how many parts and faults there are in all."""
    def held(name):
        values = cells[name].split(", ")
        return said(sum(value == "0" for value in values), len(values))

    def count(words):
        found = re.search(rf"(\d+) {words}", cells["parts with faults"])
        return found[1] if found else "0"
    parts = [int(word) for word in cells["parts"].split(", ") if word.isdigit()]
    reaches = cells["beyond, D"].split(", ")
    near = said(sum(reach != "-" and float(reach) <= REACH for reach in reaches), len(reaches))
    return [cells["decomposer"], held("points outside"), held("surface outside"), held("volume outside"), near, *map(count, FAULTS),
            str(sum(parts))]


def parts_matrix(table):
    """The table of decomposers in short, a column for each question."""
    rows = [[word.strip() for word in line.strip("| ").split(" | ")] for line in table.strip().split("\n")[2:]]
    head = ["decomposer", "holds all points", "all of the surface", "the solid", "within 3% D of it", *FAULTS, "parts"]
    return markdown(head, [matrix_row(dict(zip(PARTS_HEAD, row))) for row in rows])
