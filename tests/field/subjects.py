# SPDX-License-Identifier: MIT
"""A page for each subject of ./dev field, build/field/subjects/NAME.html: its worst inputs, how to repeat them, a picture of
each, and, if asked for, the smallest input that `convexact shrink` finds for the worst one."""
import html
import shlex
import signal
import subprocess
import time
from dataclasses import dataclass, field

from programs import BUILD, ROOT
from tables import percent, relative_distance, uncovered_share

FOLDER = BUILD / "subjects"
MOST = 5  # inputs of one page
MOST_ALIKE = 2  # that show the same fault
STYLE = ("body{font:16px/1.45 sans-serif;max-width:60rem;margin:2rem auto;padding:0 1rem}pre{background:#f4f4f4;padding:.6rem;"
         "white-space:pre-wrap}iframe{width:100%;height:40rem;border:1px solid #ccc}")


@dataclass
class Finding:
    """What a program did with one input; `rank` orders faults, the worst first."""
    rank: int
    size: float  # of faults of one rank, the larger the worse
    case: str
    sentence: str
    source: object  # the path of the input
    faces: int  # asked for
    run: list  # the words that repeat it
    verify: list = field(default_factory=list)  # those of the verdict; none without an output
    shrink: list = field(default_factory=list)  # options of `convexact shrink` that keep the fault


def hull_finding(program, record, source, target, faces):
    """None of an output without a fault, and of a refusal, which is an answer."""
    words, outcome, found = program.words(source, target, faces), record["outcome"], record["found"]
    numbers = ["--numbers", "binary32"] if program.numbers == "binary32" else []
    verify = ["verify", str(source), str(target), "--asks", "hull", *numbers]
    promise = ["--tolerance", program.promise] if program.promise else []

    def verdict(claim, *more):
        return ["--fails-if", "verdict", "--claims", claim, *more, *numbers]
    if outcome in ("time", "no file") or outcome.startswith("signal"):
        said = {"time": "no answer in time", "no file": "an empty result, and no error"}.get(outcome, f"{outcome} ended the process")
        fails_if = verdict("candidate-readable") if outcome == "no file" else ["--fails-if", "exit"]
        return Finding(0 if outcome.startswith("signal") else 1, 0, record["case"], said, source, faces, words, [], fails_if)
    if found is None:
        return None
    if not found["solid"]:
        return Finding(2, 0, record["case"], "an output without a volume", source, faces, words, verify, verdict("candidate-solid"))
    if not found["contains"]:
        distance = float(found["relative"] or 0)
        within = f", within {program.promise}" if found.get("keeps_promise") else ""
        return Finding(5 if within else 3, distance, record["case"], f"{found['outside']} points outside, the worst by {distance:.2g} of "
                       f"the diameter{within}", source, faces, words, verify, verdict("contains-input", *([] if within else promise)))
    if found["planar"] is not None and not found["convex"]:
        return Finding(4, 0, record["case"], "faces that are not closed, outward and convex, to the last bit", source, faces, words,
                       verify, verdict("mesh-convex"))
    return None


def parts_finding(program, record, source, target):
    """Of a decomposer, without a tolerance; parts that overlap are no fault, since no program promises that they do not."""
    words, outcome = program.words(source, target, 0), record["outcome"]
    numbers = ["--numbers", "binary32"] if program.numbers == "binary32" else []

    def finding(rank, size, sentence, *claims):
        verify = ["verify", str(source), str(target), "--union", "--claims", ",".join(claims), *numbers] if claims else []
        return Finding(rank, size, record["case"], sentence, source, 0, words, verify)
    if outcome != "output":
        rank = next((rank for rank, word in enumerate(("signal", "no file", "time")) if outcome.startswith(word)), None)
        said = {"time": "no answer in time", "no file": "an empty result, and no error"}.get(outcome, f"{outcome} ended the process")
        return None if rank is None else finding(rank, 0, said)
    judge = record.get("judge")
    if not judge:
        return None
    share, distance = uncovered_share(record), relative_distance(judge)
    surface = f"; {percent(share)} of the surface in no part" if share else ""
    if judge["points_outside"]:
        return finding(3, distance, f"{judge['points_outside']} of {judge['points']} points in no part, the worst by {distance:.2g} of the "
                       f"diameter{surface}", "covers-points", "covers-surface")
    if share:
        return finding(4, share, f"all points in a part{surface}", "covers-surface")
    if judge["claims"].get("covers-solid") is False:
        return finding(5, 0, "the surface in the parts, but not all of the solid", "covers-solid")
    if judge["parts_not_solid"]:
        return finding(6, len(judge["parts_not_solid"]), f"{len(judge['parts_not_solid'])} parts without a volume", "parts-solid")
    if judge["parts_not_convex"]:
        return finding(7, len(judge["parts_not_convex"]), f"{len(judge['parts_not_convex'])} parts whose faces are not closed, outward "
                       "and convex, to the last bit", "parts-convex")
    return None


def worst(findings):
    """The first of all, but not more than MOST_ALIKE of a rank; the same for the same findings in any order."""
    chosen, alike = [], {}
    for finding in sorted(findings, key=lambda f: (f.rank, -f.size, f.case)):
        alike[finding.rank] = alike.get(finding.rank, 0) + 1
        if alike[finding.rank] <= MOST_ALIKE:
            chosen.append(finding)
    return chosen[:MOST]


def command(words):
    """As a person types it in the repository."""
    return shlex.join(word.replace(f"{ROOT}/", "") for word in map(str, words))


def picture(convexact, name, finding, seconds):
    """The file that `verify --picture` writes; none if there is no output to show."""
    path = FOLDER / name / f"{finding.case}.html"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.unlink(missing_ok=True)
    try:
        subprocess.run([convexact, *finding.verify, "--picture", str(path)], capture_output=True, timeout=seconds, check=False)
    except subprocess.TimeoutExpired:
        return None
    return path if path.exists() else None


def smallest(convexact, program, finding, seconds):
    """The command, and the smallest input that it found in that time as text, or why there is none."""
    path = FOLDER / program.name / f"{finding.case}-smallest.obj"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.unlink(missing_ok=True)
    words = ["shrink", finding.source, "-o", path, "--faces", finding.faces, "--output-format", program.writes, *finding.shrink,
             "--", *program.command]
    with subprocess.Popen([convexact, *map(str, words)], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as done:
        try:
            said = done.communicate(timeout=seconds)[1]
        except subprocess.TimeoutExpired:
            done.send_signal(signal.SIGINT)  # it leaves what it has
            said = done.communicate()[1]
    fault = (said.strip().splitlines() or ["no message"])[-1]
    return command(["convexact", *words]), path.read_text() if path.exists() else fault


def section(convexact, program, finding, options):
    """One finding in HTML; the picture is a page of its own, shown in a frame."""
    lines = [f"<h2>{html.escape(finding.case)}</h2><p>{html.escape(finding.sentence)}.</p>",
             f"<pre>{html.escape(command(finding.run))}"]
    if finding.verify:
        lines.append(html.escape(command(["convexact", *finding.verify])))
    lines.append("</pre>")
    path = picture(convexact, program.name, finding, options.verify_limit) if finding.verify else None
    if path:
        lines.append(f'<iframe loading="lazy" src="{html.escape(program.name)}/{html.escape(path.name)}"></iframe>')
    return "\n".join(lines)


def write_subject(options, program, findings, inputs):
    """The page of one program, others of real meshes; with options.shrink the worst finding that can be reduced is."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    shown, name, convexact = worst(findings), program.name + options.suffix, options.convexact
    parts = [f'<!doctype html><meta charset="utf-8"><title>{name}</title><style>{STYLE}</style>', f"<h1>{name}</h1>",
             f"<p>{html.escape(program.version or 'this repository')}, {time.strftime('%Y-%m-%d')}: {inputs} inputs; "
             f"findings: {len(findings)}, the worst {len(shown)} below. The tolerance that it promises, or that is allowed to it: "
             f"{html.escape(program.promise or 'none, so that its findings are measurements')}.</p>"]
    parts += [section(convexact, program, finding, options) for finding in shown]
    reducible = [finding for finding in shown if finding.shrink]
    if options.shrink and reducible:
        said, text = smallest(convexact, program, reducible[0], options.shrink)
        parts.append(f"<h2>The smallest input like {html.escape(reducible[0].case)}</h2><pre>{html.escape(said)}</pre>"
                     f"<pre>{html.escape(text)}</pre>")
    (FOLDER / f"{name}.html").write_text("\n".join(parts) + "\n")
