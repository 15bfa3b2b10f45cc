# SPDX-License-Identifier: MIT
"""The tables of docs/field.md: what ./dev field found of hull programs and of decomposers."""
import math
import re
import statistics
import subprocess
import time
from fractions import Fraction

from programs import BUILD, ROOT

PAGE = ROOT / "docs" / "field.md"


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
            "convex": all(holds.get(name) for name in ("mesh-closed", "mesh-oriented", "mesh-convex")),
            "is_hull": claims.get("is-hull", {}).get("status") == "holds",
            "outside": answer.get("outside", {}).get("points"), "relative": distance.get("relative")}


def small(value):
    return "0" if not value else f"{value:.1e}" if value < 0.001 else f"{value:.2g}"


def short_time(seconds):
    if seconds is None:
        return "-"
    return f"{seconds * 1e6:.0f} µs" if seconds < 1e-3 else f"{seconds * 1e3:.3g} ms" if seconds < 1 else f"{seconds:.3g} s"


def markdown(head, rows, left=1):
    rule = ["---"] * left + ["---:"] * (len(head) - left)
    return "\n".join("| " + " | ".join(row) + " |" for row in [head, rule, *rows])


def said(count, total):
    return "all" if count == total else f"{count} of {total}"


def hull_row(program, found):
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
    return [f"`{program.name}`", str(len(found)), said(len(solid), len(found)),
            said(len(solid) - len(missing), len(solid)) if solid else "-", small(worst), promise, hulls,
            said(sum(bool(f["convex"]) for f in found), len(found)) if planar else "-",
            said(sum(planar), len(planar)) if planar else "-", short_time(statistics.median(small_times) if small_times else None),
            shown_times or "-", facets or "-"]


def hull_table(records, programs, inputs):
    by_name = {}
    for record in records:
        if record["found"] and "seconds" in record["found"]:
            by_name.setdefault(record["program"], []).append({"case": record["case"], **record["found"]})
    head = ["program", "outputs", "solid", "hold the input", "farthest outside, D", "within its promise", "are the hull", "convex", "planar",
            "median time", "time: bunny, spot, teapot", "facets"]
    rows = [hull_row(program, by_name[program.name]) for program in programs if program.name in by_name]
    versions = sorted({program.version for program in programs if program.version})
    skipped = [f"`{program.name}`: {program.missing}" for program in programs if program.missing]
    return "\n".join([f"{inputs} inputs, {time.strftime('%Y-%m-%d')}, {revision()}; {'; '.join(versions)}.", "",
                      markdown(head, rows), "", *([f"Skipped: {'; '.join(skipped)}.", ""] if skipped else [])])


def revision():
    done = subprocess.run(["git", "-C", str(ROOT), "describe", "--always", "--dirty"], capture_output=True, text=True, check=False)
    return f"convexact {done.stdout.strip()}"


def write_page(name, text, into_page):
    """To build/field, and between the two marks of that name in the page."""
    BUILD.mkdir(parents=True, exist_ok=True)
    (BUILD / f"{name}.md").write_text(text)
    if into_page:
        page = PAGE.read_text()
        pattern = re.compile(rf"(<!-- {name}: .*?-->\n).*?(<!-- end of {name} -->)", re.DOTALL)
        if not pattern.search(page):
            raise ValueError(f"docs/field.md has no marks for {name}")
        PAGE.write_text(pattern.sub(lambda marks: marks[1] + "\n" + text + "\n" + marks[2], page))


def middle(bounds):
    """Of an interval in an answer, as a number."""
    return (bounds["low"] + bounds["high"]) / 2


def percent(value):
    return "0" if not value else f"{100 * value:.1e}%" if value < 1e-4 else f"{100 * value:.2g}%" if value < 0.1 else f"{100 * value:.0f}%"


def relative_distance(judge):
    return root(Fraction(judge["squared_distance"]) / Fraction(judge["squared_diameter"]))


def faults(judge):
    """What is wrong with the parts themselves, in words."""
    found = [(len(judge["parts_not_solid"]), "flat"), (len(judge["parts_not_convex"]), "not convex"),
             (judge["overlapping_pairs"], "pairs overlap"), (len(judge["parts_inner"]), "within another")]
    return ", ".join(f"{count} {words}" for count, words in found if count) or "-"


def volume_share(measures, name):
    if "solid_volume" not in measures:
        return "no solid"
    return percent(max(middle(measures[name]), 0.0) / middle(measures["solid_volume"]))


def judged_row(record):
    judge, measures = record["judge"], (record.get("answer") or {}).get("measures", {})
    share = middle(measures["uncovered_area_share"]) if "uncovered_area_share" in measures else judge.get("uncovered_area_share")
    facets = sorted(judge["facets"])
    return [str(judge["parts"]), f"{facets[len(facets) // 2]} to {facets[-1]}", short_time(record["seconds"]),
            f"{judge['points_outside']} of {judge['points']} ({percent(judge['points_outside'] / judge['points'])})",
            small(relative_distance(judge)), "-" if share is None else percent(share),
            volume_share(measures, "uncovered_volume") if measures else "-",
            volume_share(measures, "excess_volume") if measures else "-", faults(judge)]


def parts_row(record):
    head = [record["case"], f"`{record['program']}`"]
    if record["outcome"] != "output" or "judge" not in record:
        words = {"time": "over time", "output": "not judged"}.get(record["outcome"], record["outcome"])
        return head + [words] + [""] * 8
    return head + judged_row(record)


def speed_rows(records):
    rows = []
    for record in records:
        if record["outcome"] == "output" and record.get("verify_seconds") and record["seconds"] and record["triangles"] > 2000:
            verdict, whole = record["verdict_seconds"], record["verify_seconds"]
            rows.append([record["case"], f"`{record['program']}`", short_time(record["seconds"]), short_time(verdict),
                         f"{verdict / record['seconds']:.2g}", short_time(whole), f"{whole / record['seconds']:.2g}"])
    return rows


def parts_table(records, programs):
    head = ["mesh", "decomposer", "parts", "facets, median to most", "its time", "points outside", "farthest, D",
            "surface outside", "volume outside", "excess volume", "parts with faults"]
    versions = sorted({program.version for program in programs if program.version and not program.missing})
    skipped = [f"`{program.name}`: {program.missing}" for program in programs if program.missing]
    lines = [f"{time.strftime('%Y-%m-%d')}, {revision()}; {'; '.join(versions)}.", "",
             markdown(head, [parts_row(record) for record in records], left=2), ""]
    rows = speed_rows(records)
    if rows:
        lines += ["How long the verdict takes beside the decomposer that made the parts:", "",
                  markdown(["mesh", "decomposer", "its time", "verdict", "ratio", "with measures", "ratio"], rows, left=2), ""]
    return "\n".join(lines + ([f"Skipped: {'; '.join(skipped)}.", ""] if skipped else []))
