#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""plane_lesson_test.py PROGRAM [SCREENSHOTS] - the lessons in the plane, dragged by mouse and keys in headless
Chromium. Every number they show is compared with the definition, in fractions: halfplanes are the lines through two
points that have all points on one side, a polygon is where lines meet without breaking a condition, the cost of a
removal is the difference of two areas; pieces are as large as what a line leaves of the polygon on its sides, and what
is proven of a part holds for every point of a grid in it."""
import json
import math
import pathlib
import random
import re
import subprocess
import sys
import tempfile
from fractions import Fraction
from itertools import combinations

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "report"))
import chromium  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
CHAPTERS = ["points", "polar", "swap", "cap", "choice", "run", "space"]
SHOWN = """(() => ({
  chapter: location.hash.slice(1), say: document.getElementById("say").innerText, text: document.querySelector("main").innerText,
  numbers: [...document.querySelectorAll("[data-what]")].map(e => [e.dataset.what, e.dataset.exact, e.textContent]),
  points: state.points.map(p => p.map(String)), center: state.center.map(String), picked: state.picked, stretch: String(state.stretch), at: state.at,
  question: document.getElementById("question").innerText, bad: document.querySelector("#panes").innerHTML.match(/NaN|Infinity|undefined/g),
  wide: document.documentElement.scrollWidth - innerWidth}))()"""


# ---- The construction by definition

def primitive(n, d):
    row = [Fraction(x) for x in (*n, d)]
    factor = math.lcm(*(x.denominator for x in row))
    whole = [int(x * factor) for x in row]
    return tuple(x // math.gcd(*whole) for x in whole)


def value(plane, x):
    return plane[0] * x[0] + plane[1] * x[1] + plane[2]


def halfplanes(points):
    found = set()
    for a, b in combinations(set(points), 2):
        for n in ((b[1] - a[1], a[0] - b[0]), (a[1] - b[1], b[0] - a[0])):
            plane = primitive(n, -(n[0] * a[0] + n[1] * a[1]))
            if all(value(plane, p) <= 0 for p in points):
                found.add(plane)
    return sorted(found)


def corners(planes):
    found = set()
    for p, q in combinations(planes, 2):
        w = p[0] * q[1] - p[1] * q[0]
        if w:
            x = (Fraction(p[1] * q[2] - q[1] * p[2], 1) / w, Fraction(q[0] * p[2] - p[0] * q[2], 1) / w)
            if all(value(plane, x) <= 0 for plane in planes):
                found.add(x)
    return found


def is_bounded(planes):
    """No direction satisfies all n.u <= 0; if there is one, one is at right angles to some normal."""
    return not any(all(n[0] * u[0] + n[1] * u[1] <= 0 for n in planes)
                   for p in planes for u in ((-p[1], p[0]), (p[1], -p[0])))


def area(planes):
    """Of the triangles from the mean of the corners, sorted by the angle there."""
    found = list(corners(planes))
    mean = [sum(x[k] for x in found) / len(found) for k in (0, 1)]
    arms = sorted(((x - mean[0], y - mean[1]) for x, y in found), key=lambda v: math.atan2(v[1], v[0]))
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(arms, arms[1:] + arms[:1])) / 2


def cost(planes, k):
    rest = planes[:k] + planes[k + 1:]
    return area(rest) - area(planes) if is_bounded(rest) else None


def greedy(planes):
    """(id, cost, area after) of each removal."""
    ids, left, steps = list(range(len(planes))), list(planes), []
    while True:
        costs = [(cost(left, k), ids[k], k) for k in range(len(left))]
        bounded = [entry for entry in costs if entry[0] is not None]
        if not bounded:
            return steps
        least, removed, k = min(bounded)
        del ids[k], left[k]
        steps.append((removed, least, area(left)))


# ---- The page against it

def check(page):
    shown = page.evaluate(SHOWN)
    where = f"#{shown['chapter']}: "
    assert shown["bad"] is None and not page.complaints, (where, shown["bad"], page.complaints)
    assert not re.search(r"undefined|NaN|\[object|null", shown["text"]), where + shown["text"]
    assert shown["wide"] <= 0, (where, "wider than the window", shown["wide"])
    points = [tuple(Fraction(x) for x in p) for p in shown["points"]]
    center = [Fraction(x) for x in shown["center"]]
    planes = halfplanes(points)
    assert all(value(plane, center) < 0 for plane in planes), where
    moved = list(planes)
    if shown["chapter"] == "polar" and shown["picked"] is not None:
        n = planes[shown["picked"]]
        s = -value(n, center) * Fraction(shown["stretch"])
        moved[shown["picked"]] = (n[0], n[1], -s - n[0] * center[0] - n[1] * center[1])

    def dual(k, of=moved):
        return [Fraction(x) / -value(of[k], center) for x in of[k][:2]]
    steps = greedy(planes)
    for what, exact, text in shown["numbers"]:
        exact, (key, *rest) = Fraction(exact), what.split("/")
        if key in ("s", "dual", "area", "D") and rest:
            k = int(rest[0])
        if key == "s":
            expected = -value(moved[k], center)
        elif key == "dual":
            expected = dual(k)[int(rest[1])]
        elif key == "center":
            expected = center[int(rest[0])]
        elif key == "stretch":
            expected = Fraction(shown["stretch"])
        elif key == "area":
            expected = cost(planes, k if rest else shown["picked"])
        elif key == "D":
            # The cross product of the dual points of the neighbours: those with corners on the side.
            own = planes[k if rest else shown["picked"]]
            beside = [j for j, p in enumerate(planes) if p != own and
                      any(value(p, x) == 0 and value(own, x) == 0 for x in corners(planes))]
            a, b = sorted(beside, key=lambda j: own[0] * planes[j][1] - own[1] * planes[j][0])
            (u, v), (x, y) = dual(a, planes), dual(b, planes)
            expected = u * y - v * x
        elif key == "tip":
            assert shown["chapter"] == "cap"
            rest_planes = planes[:shown["picked"]] + planes[shown["picked"] + 1:]
            (tip,) = corners(rest_planes) - corners(planes)
            expected = tip[int(rest[0])]
        elif key == "least":
            expected = steps[0][1]
        elif key == "step":
            expected = steps[shown["at"]][1]
        elif key == "growth":
            grown = steps[shown["at"] - 1][2] if shown["at"] else area(planes)
            expected = (grown - area(planes)) / area(planes) * 100
        elif key == "best":
            expected = min(area(chosen) for chosen in combinations(planes, len(planes) - shown["at"])
                           if is_bounded(chosen))
        elif key == "now":
            expected = steps[shown["at"] - 1][2]
        elif key == "run":
            expected = steps[int(rest[0])][1 if rest[1] == "area" else 2]
        elif key == "incidence":
            expected = 1
        elif key == "corner":
            first = [tuple(x[j] - center[j] for j in (0, 1)) for x in corners(planes)]
            assert exact in [x[int(rest[0])] for x in first], where
            continue
        else:
            raise AssertionError(where + "what is " + what)
        assert exact == expected, (where, what, exact, expected)
        written = text.replace("\u2212", "-")
        assert "\u2026" in written or Fraction(written) == exact, (where, what, text)
    return shown


def middle_of(page, selector):
    return page.evaluate(f"(() => {{ const box = document.querySelector({selector!r}).getBoundingClientRect();"
                         "return [(box.left + box.right) / 2, (box.top + box.bottom) / 2]; })()")


def mouse(page, kind, at):
    page.call("Input.dispatchMouseEvent", type=kind, x=at[0], y=at[1], button="left", buttons=1, clickCount=1)


def drag(page, selector, by):
    at = middle_of(page, selector)
    mouse(page, "mousePressed", at)
    for part in (0.5, 1):
        mouse(page, "mouseMoved", [x + part * d for x, d in zip(at, by)])
    mouse(page, "mouseReleased", [x + d for x, d in zip(at, by)])


def press(page, key):
    for kind in ("rawKeyDown", "keyUp"):
        page.call("Input.dispatchKeyEvent", type=kind, key=key, code=key)


def walk_and_drag(page, choose):
    page.evaluate("go(0)")
    places = set()
    for k, chapter in enumerate(CHAPTERS):
        if k:
            press(page, "ArrowRight")
        shown = check(page)
        assert shown["chapter"] == chapter, (shown["chapter"], chapter)
        assert shown["say"].startswith("Wanted:") or chapter in ("run", "space"), shown["say"]
        assert "Now you have:" in shown["text"], chapter
        for _ in range(3):
            by = [choose.randint(-60, 60), choose.randint(-60, 60)]
            if chapter == "points":
                drag(page, f"[data-point='{choose.randrange(len(shown['points']))}']", by)
            elif chapter in ("polar", "cap", "choice", "swap"):
                drag(page, "[data-center]", [x / 3 for x in by])
            shown = check(page)
            places.add(str((shown["points"], shown["center"])))
        if chapter in ("polar", "cap"):
            for side in range(page.evaluate("model.planes.length")):
                page.evaluate(f"set({{picked: {side}, stretch: one}})")
                check(page)
                if chapter == "polar":
                    drag(page, f"#solid .grip[data-side='{side}']", [choose.randint(-70, 70), choose.randint(-70, 70)])
                    check(page)
        if chapter == "swap":
            for corner in page.evaluate("[...document.querySelectorAll('#dual [data-corner]')].map(e => e.dataset.corner)"):
                page.evaluate(f"pick(document.querySelector('#dual [data-corner=\"{corner}\"]'))")
                check(page)
        if chapter == "run":
            for at in range(page.evaluate("model.run.steps.length") + 1):
                page.evaluate(f"set({{at: {at}}})")
                check(page)
    return places


def ask_and_answer(page):
    """Of each question: it blocks nothing, a right answer is told so, a wrong one too, each with a reason."""
    page.evaluate("byId('reset').click()")
    asked = []
    for chapter, (right, wrong) in {
            "points": ("Number(document.querySelectorAll('[data-point]').length - 1)", "0"),
            "polar": ("toDual(scaled(model.side.dual, new Rational(1n, 2n)))", "[0, 0]"),
            "swap": ("(() => { const s = model.polygon.sides, k = Math.floor(s.length / 2); return `${s[k].id}-${s[(k + 1) % s.length].id}`; })()", "'9-9'"),
            "cap": ("'no'", "'yes'"), "choice": ("model.next.side.id", "-1"), "ring": ("model.next.after.id", "-1"), "run": ("'no'", "'yes'")}.items():
        for answer, verdict in ((right, "Right."), (wrong, "Not so.")):
            place = "choice" if chapter == "ring" else chapter
            page.evaluate(f"go({CHAPTERS.index(place)})")
            page.evaluate("state.answered = " + ("{choice: 'told'}" if chapter == "ring" else "{}"))
            page.evaluate("set({picked: state.chapter === 1 ? 0 : null, at: 3})")
            before = page.evaluate(SHOWN)["question"]
            assert "?" in before and "Right." not in before and "tell me" in before, (chapter, before)
            if answer == "'no'" or answer == "'yes'":
                page.evaluate(f'document.querySelector("#question [data-answer={answer}]").click()')
            else:
                page.evaluate(f"answer({chapter!r}, {answer}); set({{}})")
            after = check(page)["question"]
            assert verdict in after and len(after) > len(before), (chapter, answer, after)
        asked.append(chapter)
    return asked


# ---- The lesson on parts

PARTS = ["hull", "ball", "squares", "cut", "merge", "guarantee"]
PIECES = """(() => ({outline: outline.map(p => p.map(String)), pieces: model.pieces.map(piece => piece.map(p => p.map(String))),
  groups: model.groups, parts: model.parts.map(part => part.map(p => p.map(String))), verdicts: model.verdicts, distance: String(model.distance),
  hull: model.hull.map(p => p.map(String)), squares: model.squares?.map(s => [s.middle.map(String), String(s.half), s.state]),
  line: state.line.map(p => p.map(String)), cuts: state.cuts.length, far: model.far.at.map(String), probe: (state.probe ?? model.far.at).map(String),
  common: model.common?.map(p => p.map(String))}))()"""


def exact(points):
    return [tuple(Fraction(x) for x in p) for p in points]


def shoelace(polygon):
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(polygon, polygon[1:] + polygon[:1])) / 2


def hull_area(points):
    return area(halfplanes(points))


def left_of(polygon, line):
    """The area of the polygon on the left of a line: what Sutherland's and Hodgman's clipping leaves, whose area is right
    even where its sides run back on themselves."""
    (ax, ay), (bx, by) = line

    def height(p):
        return (bx - ax) * (p[1] - ay) - (by - ay) * (p[0] - ax)
    kept = []
    for a, b in zip(polygon, polygon[1:] + polygon[:1]):
        u, v = height(a), height(b)
        if u >= 0:
            kept.append(a)
        if u * v < 0:
            kept.append(tuple(x + (y - x) * u / (u - v) for x, y in zip(a, b)))
    return shoelace(kept) if kept else Fraction(0)


def is_in(polygon, p):
    inside = False
    for a, b in zip(polygon, polygon[1:] + polygon[:1]):
        if (a[1] > p[1]) != (b[1] > p[1]) and p[0] < a[0] + (p[1] - a[1]) * (b[0] - a[0]) / (b[1] - a[1]):
            inside = not inside
    return inside


def squared_distance(polygon, p):
    if is_in(polygon, p):
        return Fraction(0)
    best = None
    for a, b in zip(polygon, polygon[1:] + polygon[:1]):
        d = (b[0] - a[0], b[1] - a[1])
        t = min(Fraction(1), max(Fraction(0), ((p[0] - a[0]) * d[0] + (p[1] - a[1]) * d[1]) / (d[0] ** 2 + d[1] ** 2)))
        away = (p[0] - a[0] - t * d[0]) ** 2 + (p[1] - a[1] - t * d[1]) ** 2
        best = away if best is None else min(best, away)
    return best


def grid_in(part, steps=9):
    """Points of a convex part, on a grid over its box."""
    planes = halfplanes(part)
    low, high = ([f(p[k] for p in part) for k in (0, 1)] for f in (min, max))
    for i in range(steps + 1):
        for j in range(steps + 1):
            p = (low[0] + (high[0] - low[0]) * i / steps, low[1] + (high[1] - low[1]) * j / steps)
            if all(value(plane, p) <= 0 for plane in planes):
                yield p


def check_part(part, outline, verdict, distance, where):
    over = [p for p in [*part, *grid_in(part)] if squared_distance(outline, p) > distance ** 2]
    assert not (verdict == "within" and over), (where, "proven to be near, but", over[:1])
    if verdict == "beyond":
        assert max(squared_distance(outline, p) for p in [*part, *grid_in(part, 40)]) > distance ** 2 * Fraction(9, 10), where


def check_parts(page):
    shown, found = page.evaluate(SHOWN.replace("points: state.points.map(p => p.map(String)), center: state.center.map(String), picked: state.picked, "
                                               "stretch: String(state.stretch), at: state.at,", "")), page.evaluate(PIECES)
    where = f"#{shown['chapter']}: "
    assert shown["bad"] is None and not page.complaints, (where, shown["bad"], page.complaints)
    assert not re.search(r"undefined|NaN|\[object|null", shown["text"]), where + shown["text"]
    assert shown["wide"] <= 0, (where, "wider than the window", shown["wide"])
    outline, distance = exact(found["outline"]), Fraction(found["distance"])
    pieces, parts = [exact(p) for p in found["pieces"]], [exact(p) for p in found["parts"]]
    areas = [shoelace(p) for p in pieces]
    assert sum(areas) == shoelace(outline) and min(areas) > 0, where
    if shown["chapter"] == "cut" and found["cuts"] == 0:
        # Each piece lies on one side of the line, and together they are what it leaves there.
        (ax, ay), (bx, by) = line = exact(found["line"])
        sides = [[(bx - ax) * (p[1] - ay) - (by - ay) * (p[0] - ax) for p in piece] for piece in pieces]
        assert all(min(s) >= 0 or max(s) <= 0 for s in sides), where
        assert sum(a for a, s in zip(areas, sides) if max(s) > 0) == left_of(outline, line), where
    for k, part in enumerate(parts):
        held = [p for i in found["groups"][k] for p in pieces[i]]
        assert shoelace(part) == hull_area(held), (where, k)
        assert all(value(plane, p) <= 0 for plane in halfplanes(part) for p in held), (where, k)
        if found["verdicts"]:
            check_part(part, outline, found["verdicts"][k], distance, where)
    for middle, half, how in found.get("squares") or []:
        (x, y), r = exact([middle])[0], Fraction(half)
        if how == "within":
            assert all(squared_distance(outline, (x + i * r, y + j * r)) <= distance ** 2 for i in (-1, 1) for j in (-1, 1)), where
        if how == "beyond":
            assert squared_distance(outline, (x, y)) > distance ** 2, where
    if found.get("squares") and all(how == "within" for _, _, how in found.get("squares")):
        check_part(exact(found["hull"]), outline, "within", distance, where)
        boxes = [(exact([m])[0], Fraction(r)) for m, r, _ in found.get("squares")]
        assert all(any(abs(p[0] - m[0]) <= r and abs(p[1] - m[1]) <= r for m, r in boxes) for p in grid_in(exact(found["hull"]), 20)), where + "not covered"
    for what, text, written in shown["numbers"]:
        key, *rest = what.split("/")
        expected = {"distance": lambda: distance, "far": lambda: squared_distance(outline, exact([found["far"]])[0]),
                    "area": lambda: shoelace(outline) if rest == ["polygon"] else hull_area(outline), "excess": lambda: hull_area(outline) - shoelace(outline),
                    "probe": lambda: exact([found["probe"]])[0][int(rest[0])], "squared": lambda: squared_distance(outline, exact([found["probe"]])[0]),
                    "held": lambda: sum(areas[i] for i in found["groups"][int(rest[0])]), "part": lambda: shoelace(parts[int(rest[0])]),
                    "total": lambda: sum(map(shoelace, parts)), "common": lambda: shoelace(exact(found.get("common"))), "pieces": lambda: sum(areas)}[key]()
        assert Fraction(text) == expected, (where, what, text, expected)
        written = written.replace("\u2212", "-")
        assert "\u2026" in written or Fraction(written) == expected, (where, what, written)
    return found


def walk_parts(page, choose):
    page.evaluate("byId('reset').click()")
    seen = set()
    for k, chapter in enumerate(PARTS):
        page.evaluate(f"go({k})")
        check_parts(page)
        for _ in range(4):
            by = [choose.randint(-90, 90), choose.randint(-90, 90)]
            if chapter == "ball":
                drag(page, "[data-probe]", by)
            elif chapter == "cut":
                drag(page, f"[data-end='{choose.randint(0, 1)}']", by)
            elif chapter == "squares":
                page.evaluate(f"set({{wide: {choose.randint(1, 28)}, depth: {choose.randint(0, 5)}}})")
            else:
                page.evaluate(f"set({{quarter: {choose.randint(1, 28)}}})")
            found = check_parts(page)
            seen.add(str((found["line"], found["probe"], found["distance"])))
    # Kept cuts; and all merges that are allowed, one after another.
    page.evaluate("go(3); document.querySelector('[data-keep]').click()")
    drag(page, "[data-end='0']", [40, -60])
    check_parts(page)
    page.evaluate("document.querySelector('[data-forget]').click(); go(4); set({quarter: 13})")
    while page.evaluate("""(() => { for (let a = 0; a < model.parts.length; ++a) for (let b = a + 1; b < model.parts.length; ++b) {
        set({picked: [a, b]}); const join = document.querySelector('[data-join]'); if (!join.disabled) { join.click(); return true; } } return false; })()"""):
        check_parts(page)
    assert page.evaluate("model.parts.length") == 2  # the floor and the low wall; with the high one the hull reaches farther
    page.evaluate("go(5)")
    check_parts(page)
    return seen


def ask_about_parts(page):
    asked = 0
    for chapter, (right, wrong) in {"hull": ("1", "0.5"), "ball": ("'no'", "'yes'"), "squares": ("'no'", "'yes'"), "cut": ("4", "0"),
                                    "merge": ("'1 and 2'", "'0 and 1'"), "guarantee": ("'no'", "'yes'")}.items():
        for given, verdict in ((right, "Right."), (wrong, "Not so.")):
            page.evaluate(f"byId('reset').click(); go({PARTS.index(chapter)}); set({{quarter: 13}})")
            before = page.evaluate("byId('question').innerText")
            assert "?" in before and "Right." not in before, (chapter, before)
            page.evaluate(f"answer({chapter!r}, {given}); set({{}})")
            check_parts(page)
            after = page.evaluate("byId('question').innerText")
            assert verdict in after and len(after) > len(before), (chapter, given, after)
        asked += 1
    return asked


def refusals(program, folder):
    """(arguments, exit code, a word of the complaint)"""
    line, tilted, solid = (folder / name for name in ("line.obj", "tilted.obj", "solid.obj"))
    line.write_text("v 0 0 0\nv 1 1 0\nv 2 2 0\n")
    tilted.write_text("v 0 0 0\nv 1 0 0\nv 0 1 1\n")
    solid.write_text((ROOT / "docs/lessons/cube.obj").read_text())
    many = folder / "many.xyz"
    many.write_text("".join(f"{k} {k * k} 0\n" for k in range(61)))
    two, crossed = folder / "two.obj", folder / "crossed.obj"
    two.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n")
    crossed.write_text("v 0 0 0\nv 4 0 0\nv 0 4 0\nv 4 5 0\nf 1 2 3 4\n")
    planes = folder / "planes.json"
    subprocess.run([program, "hull", solid, "-o", planes], check=True, stdout=subprocess.DEVNULL)
    page = folder / "page.html"
    polygon = ROOT / "docs/lessons/polygon.obj"
    cases = [([line, "-o", page], 4, "not in line"), ([tilted, "-o", page], 2, "one z"), ([solid, "-o", page], 2, "one z"),
             ([many, "-o", page], 2, "at most 60"), ([planes, "-o", page], 2, "halfspaces"), ([two, "-o", page], 2, "one face"), ([crossed, "-o", page], 2, "meets others"),
             ([polygon, "-o", folder / "x.json"], 2, ".html"),
             ([polygon, "--json"], 2, "-o"), ([polygon, "-o", page, "--faces", "4"], 2, "--faces")]
    for arguments, code, word in cases:
        done = subprocess.run([program, "teach", "--plane", *map(str, arguments)], capture_output=True, text=True)
        said = done.stderr + done.stdout
        assert done.returncode == code and word in said, (arguments, done.returncode, said)
        assert not page.exists() and not (folder / "x.json").exists(), arguments
    return len(cases)


def main():
    program, shots = sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else None
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        count = refusals(program, folder)
        if chromium.is_missing():
            print(f"{count} refusals; the page was not opened: no Chromium")
            return 77
        path = folder / "polygon.html"
        subprocess.run([program, "teach", "--plane", ROOT / "docs/lessons/polygon.obj", "-o", path], check=True, stdout=subprocess.DEVNULL)
        media = [("prefers-color-scheme", "light"), ("prefers-reduced-motion", "reduce")]
        page = chromium.Page(path.resolve().as_uri(), width=1200, height=950, media=media)
        places = set()
        for seed in range(4):
            page.evaluate("byId('reset').click()")
            places |= walk_and_drag(page, random.Random(seed))
        assert len(places) > 20, len(places)
        asked = ask_and_answer(page)
        if shots:
            for k, chapter in enumerate(CHAPTERS):
                page.evaluate(f"go({k}); byId('reset').click()")
                page.screenshot(str(pathlib.Path(shots) / f"plane-{chapter}.png"))
        bin_page = folder / "bin.html"
        subprocess.run([program, "teach", "--plane", ROOT / "docs/lessons/bin.obj", "-o", bin_page], check=True, stdout=subprocess.DEVNULL)
        parts = chromium.Page(bin_page.resolve().as_uri(), width=1200, height=950, media=media)
        seen = set().union(*(walk_parts(parts, random.Random(seed)) for seed in range(3)))
        assert len(seen) > 40, len(seen)
        about_parts = ask_about_parts(parts)
        if shots:
            for k, chapter in enumerate(PARTS):
                parts.evaluate(f"go({k}); byId('reset').click()")
                parts.screenshot(str(pathlib.Path(shots) / f"parts-{chapter}.png"))
        narrow = chromium.Page(path.resolve().as_uri() + "#choice", width=380, height=800, media=media)
        check(narrow)
        print(f"{len(CHAPTERS) + len(PARTS)} chapters, dragged to {len(seen) + len(places)} places, {len(asked) + about_parts} questions, {count} refusals")
    return 0


if __name__ == "__main__":
    sys.exit(main())
