#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""lesson_page_test.py PROGRAM DATA [SCREENSHOTS] - walks through lessons in headless Chromium, from disk, by keys
alone: no complaint, nothing asked of the network, every recorded number on the page is the record's, what the page
works out agrees with it, deep links land, and a record that is wrong is shown to be wrong. Leaves a screenshot of
each chapter in the folder, if one is named."""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
from fractions import Fraction

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "report"))
import chromium  # noqa: E402

CUBE = """v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 0.5 1\nv 1 1 0.5\nv 0.5 1 1\n"""
CHAPTERS = ["film", "hull", "center", "polar", "topology", "removal", "verification", "storing"]

# What a step shows: numbers with where they come from, verdicts, what is drawn, and how far the page reaches.
STEP = """(() => {
  const text = document.querySelector("main").innerText;
  return {hash: location.hash.slice(1), title: document.querySelector("main h2").textContent,
    say: document.getElementById("say").innerText, text,
    numbers: [...document.querySelectorAll("[data-at]")].map(e => [e.dataset.at, e.dataset.exact, e.localName === "mrow" ? null : e.textContent]),
    computed: [...document.querySelectorAll("[data-computed]")].map(e => e.dataset.computed),
    no: document.querySelectorAll(".no").length, yes: document.querySelectorAll(".yes").length,
    drawn: [...document.querySelectorAll("#panes svg")].map(svg => svg.querySelectorAll("path, circle, ellipse").length),
    bad: document.querySelector("#panes").innerHTML.match(/NaN|Infinity|undefined/g),
    here: document.querySelectorAll("#contents a[aria-current]").length,
    labels: [...document.querySelectorAll("#panes svg")].map(svg => [...svg.querySelectorAll("text")].map(text => {
      const box = text.getBoundingClientRect(), style = getComputedStyle(text);
      return {text: text.textContent, box: [box.left, box.top, box.right, box.bottom], hidden: /back|far/.test(text.getAttribute("class")),
        seen: Number(style.fillOpacity) * Number(style.opacity)};
    })),
    captions: [...document.querySelectorAll("#panes figure:not([hidden]) figcaption")].map(caption => caption.getBoundingClientRect())
      .map(box => [box.top, box.bottom].map(Math.round).join()),
    last: document.getElementById("next").disabled,
    wide: document.documentElement.scrollWidth - innerWidth};
})()"""


def at(document, pointer):
    for key in pointer.split("/")[1:]:
        document = document[int(key) if isinstance(document, list) else key]
    return document


def press(page, key):
    for kind in ("rawKeyDown", "keyUp"):
        page.call("Input.dispatchKeyEvent", type=kind, key=key, code=key)


def opened(path, hash_="", width=1300, height=900, dark=False, still=True, asks=False):
    media = [("prefers-color-scheme", "dark" if dark else "light")]
    if still:
        media.append(("prefers-reduced-motion", "reduce"))
    page = chromium.Page(pathlib.Path(path).resolve().as_uri() + hash_, width=width, height=height, media=media)
    if not asks:
        page.evaluate("state.isTold = true; show()")
    return page


def says(shown, exact):
    """Whether a number as it is shown is the exact one: in full, or cut off after some digits."""
    shown = shown.replace("\u2212", "-")
    if "\u2026" not in shown:
        return Fraction(shown) == Fraction(exact)
    digits, power = shown.split("\u2026")
    unit = Fraction(1, 10 ** len(digits.partition(".")[2])) * Fraction(10) ** int(power[1:] or 0)
    value = Fraction(digits) * Fraction(10) ** int(power[1:] or 0)
    return value != Fraction(exact) and abs(value) <= abs(Fraction(exact)) < abs(value) + unit


def check_labels(panes, where):
    """No label covers another one, those in front are drawn in full and those behind fainter."""
    for labels in panes:
        for k, label in enumerate(labels):
            assert label["seen"] == 1 if not label["hidden"] else 0.3 < label["seen"] < 0.7, (where, label)
            left, top, right, bottom = label["box"]
            for other in labels[:k]:
                # A glyph's box is higher than the glyph.
                across = min(right, other["box"][2]) - max(left, other["box"][0])
                down = min(bottom, other["box"][3]) - max(top, other["box"][1])
                assert across <= 2 or down <= 0.3 * (bottom - top), (where, label, other)


def check_step(step, lesson, name):
    where = f"{name} #{step['hash']}"
    assert step["bad"] is None, (where, step["bad"])
    assert not re.search(r"undefined|NaN|\[object|null", step["text"]), (where, step["text"])
    assert len(step["say"]) > 40 and step["say"].rstrip()[-1] in ".?:\u2026", (where, step["say"])
    assert "\u2026." not in step["text"], (where, step["text"])
    assert step["no"] == 0, f"{where}: the page does not agree with the record"
    assert step["here"] == 1, where
    assert step["wide"] <= 0, f"{where}: wider than the window by {step['wide']}"
    check_labels(step["labels"], where)
    assert len(set(step["captions"])) == 1, (where, "captions of two heights", step["captions"])
    for pointer, exact, shown in step["numbers"]:
        assert at(lesson, pointer) == exact, (where, pointer)
        if shown is not None and not pointer.endswith("/decimal"):
            assert says(shown, exact), (where, pointer, shown, exact)


def walk(page, lesson, name):
    """Steps by id, from the first to the last, by the right arrow alone."""
    press(page, "Home")
    steps = {}
    while True:
        step = page.evaluate(STEP)
        check_step(step, lesson, name)
        assert step["hash"] not in steps, f"{name}: #{step['hash']} twice"
        steps[step["hash"]] = step
        if step["last"]:
            break
        press(page, "ArrowRight")
    # Details that a walk leaves out are reached by their address.
    for name in page.evaluate("steps.filter(step => step.isDetail).map(step => step.id)"):
        assert name not in steps and int(name.split("-")[1]) > lesson["topology"]["step"] + 3, name
        page.evaluate(f"location.hash = '#{name}'; new Promise(requestAnimationFrame)")
        step = page.evaluate(STEP)
        assert step["hash"] == name, (step["hash"], name)
        check_step(step, lesson, name)
        steps[name] = step
    assert list(sorted(steps)) == sorted(page.evaluate("steps.map(step => step.id)"))
    assert not page.complaints, page.complaints
    page.evaluate("go(steps.length - 1)")
    return steps


def lesson_of(program, arguments):
    done = subprocess.run([program, "teach", *arguments, "--json"], check=True, stdout=subprocess.PIPE)
    return json.loads(done.stdout)


def check_lesson(program, name, arguments, folder, expected):
    """A lesson from its first step to its last."""
    path = os.path.join(folder, name + ".html")
    subprocess.run([program, "teach", *arguments, "-o", path], check=True, stdout=subprocess.DEVNULL)
    lesson = lesson_of(program, arguments)
    page = opened(path)
    try:
        steps = walk(page, lesson, name)
        assert [c for c in CHAPTERS if any(s.split("-")[0] == c for s in steps)] == expected, steps.keys()
        for chapter in CHAPTERS:  # a chapter that is left out says why
            if chapter not in expected:
                assert any(entry["chapter"] == chapter for entry in lesson["left_out"]), (name, chapter)
        for step in steps.values():
            assert max(step["drawn"]) > 3, (name, step["hash"])
        press(page, "PageUp")
        assert page.evaluate("location.hash.slice(1)") in steps
        keep(path, name, expected)
        return path, lesson, steps
    finally:
        page.close()


def keep(path, name, chapters):
    if len(sys.argv) <= 3:
        return
    for width, dark in ((1300, False), (1300, True), (400, False), (400, True)):
        page = opened(path, width=width, dark=dark)
        for chapter in chapters:
            page.evaluate(f"location.hash = '#{chapter}'; new Promise(requestAnimationFrame)")
            page.screenshot(os.path.join(sys.argv[3], f"{name}-{chapter}-{width}-{'dark' if dark else 'light'}.png"))
        page.close()


def check_cube(program, folder):
    """The numbers of docs/construction.md, where the page says them."""
    cube = os.path.join(folder, "cube.obj")
    pathlib.Path(cube).write_text(CUBE, encoding="ascii")
    path, lesson, steps = check_lesson(program, "cube", [cube, "--center", "0.5,0.5,0.5"], folder,
                                       [c for c in CHAPTERS if c != "center"])
    assert "which adds 1/48" in steps["removal-1"]["say"], steps["removal-1"]["say"]
    assert "from 47/48 to 1." in steps["removal-1-cap"]["say"], steps["removal-1-cap"]["say"]
    assert steps["removal-1"]["text"].count("25/48") == 3 and steps["removal-1"]["text"].count("unbounded\n") + steps["removal-1"]["text"].count("unbounded\t") == 3
    check_lesson(program, "cube-chebyshev", [cube, "--measures", "area,mean-width"], folder, CHAPTERS)
    return path, lesson


def check_polar(path):
    """Picking by the table and by a click, and a center that moves: signs and costs stay."""
    page = opened(path, "#polar")
    try:
        page.evaluate('document.querySelector("[data-picker]").value = "h5"; document.querySelector("[data-picker]").dispatchEvent(new Event("input", {bubbles: true}))')
        said = page.evaluate('document.getElementById("say").innerText')
        assert "Halfspace 5 is a facet" in said and "5 neighbours" in said, said  # row 5 of the matrix: 2 4 1 6 3
        lit = page.evaluate('document.querySelectorAll("#solid .face.chosen, #dual .dot.chosen").length')
        assert lit == 2, lit
        # A triangle of the dual, clicked.
        place = page.evaluate("""(() => {
          const face = document.querySelector('#dual .face.front[data-pick="t3,5,4"], #dual .face.front'), box = face.getBoundingClientRect();
          for (let x = box.left + 1; x < box.right; x += 2) for (let y = box.top + 1; y < box.bottom; y += 2)
            if (document.elementFromPoint(x, y) === face) return [x, y, face.dataset.pick];
        })()""")
        for kind in ("mousePressed", "mouseReleased"):
            page.call("Input.dispatchMouseEvent", type=kind, x=place[0], y=place[1], button="left", clickCount=1)
        said = page.evaluate('document.getElementById("say").innerText')
        assert f"The planes {place[2][1:].replace(',', ', ')} meet in a vertex" in said, (said, place)
        numbers = 'document.getElementById("more").innerText'
        before = page.evaluate(numbers)
        page.evaluate("""(() => { const s = document.querySelector("[data-center='0']"); s.value = 5; s.dispatchEvent(new Event("input", {bubbles: true})); })()""")
        after, said = page.evaluate(numbers), page.evaluate('document.getElementById("say").innerText')
        assert before != after and "no sign and no cost has changed" in said, said
        # The center in the picture, dragged: the dual follows, in exact numbers; nothing turns.
        shown = lambda: page.evaluate("({c: movedCenter().map(String), turn: camera.turn, dual: document.getElementById('dual').innerHTML, more: document.getElementById('more').innerText})")  # noqa: E731
        was, (x, y) = shown(), page.evaluate("(() => { const box = document.querySelector('#solid [data-drag]').getBoundingClientRect(); return [box.left + 4, box.top + 4]; })()")
        for kind, by in (("mousePressed", 0), ("mouseMoved", 6), ("mouseMoved", 25), ("mouseReleased", 25)):
            page.call("Input.dispatchMouseEvent", type=kind, x=x - by, y=y - by, button="left", buttons=1, clickCount=1)
        now = shown()
        assert now["c"] != was["c"] and now["turn"] == was["turn"] and now["dual"] != was["dual"], (was["c"], now["c"])
        assert all(text in now["more"] for text in now["c"]), (now["c"], now["more"])
        press(page, "Escape")
        said = page.evaluate('document.getElementById("say").innerText')
        assert "Halfspace 6 is a facet" in said, said  # what the step is about if nothing is picked
        assert not page.complaints, page.complaints
    finally:
        page.close()


def check_candidates(path):
    """What would be if another halfspace went: its cost, or the triangle that has no corner."""
    page = opened(path, "#removal-1")
    try:
        for i, says_ in (("3", "that would add 25/48"), ("0", "the solid would be unbounded")):
            page.evaluate(f"document.querySelector('#more button[data-pick=\"h{i}\"]').click()")
            said = page.evaluate('document.getElementById("say").innerText')
            assert f"If {i} went instead, {says_}" in said, said
        assert page.evaluate("document.getElementById('more').innerText").count("none") >= 1
    finally:
        page.close()


def check_doubles(program, folder):
    """A needle far from the origin: doubles beside exact numbers are off, and have wrong signs."""
    needle = os.path.join(folder, "far-needle.obj")
    points = [(k << 17, 10**15 + k * k * 3 % 11, 10**15 - k * k * k % 7) for k in range(-4, 5)]
    pathlib.Path(needle).write_text("".join("v %d %d %d\n" % p for p in points), encoding="ascii")
    path = os.path.join(folder, "far-needle.html")
    subprocess.run([program, "teach", needle, "--precision", "64", "-o", path], check=True, stdout=subprocess.DEVNULL)
    page = opened(path, "#verification")
    try:
        assert page.evaluate("document.getElementById('doubles').checked")  # where they are far off, from the start
        signs, off = 0, []
        for name in page.evaluate("steps.filter(step => step.chapter.id === 'verification').map(step => step.id)"):
            page.evaluate(f"go(steps.findIndex(step => step.id === {json.dumps(name)}))")
            signs += page.evaluate("document.getElementById('more').innerText").count("the wrong sign")
        page.evaluate("location.hash = '#removal-1'; new Promise(requestAnimationFrame)")
        off = re.findall(r"([0-9.e+]+)%", page.evaluate("document.getElementById('more').innerText"))
        assert signs > 0 and max(map(float, off)) > 1, (signs, off)
        assert not page.complaints, page.complaints
    finally:
        page.close()


def check_links(path):
    for link, title in (("hull", "The hull"), ("removal", "Removal 1: the cheapest"), ("removal-1", "Removal 1: the cheapest"),
                        ("removal-1-cap", "Removal 1: the cap"), ("verification", "Step 1, checked"), ("storing", "Storing"), ("nothing-there", "")):
        page = opened(path, "#" + link)
        seen = page.evaluate(STEP)
        assert title in seen["title"] and seen["drawn"][0] > 3, (link, seen["title"])
        assert page.evaluate("scrollY") == 0, link
        if title:
            assert page.evaluate(f"document.getElementById('{link}') !== null"), link
        page.close()


def check_wrong_record(path, folder):
    """A cost, a check or a triangle that an engine got wrong: the page says so."""
    text = pathlib.Path(path).read_text(encoding="utf-8")
    for step, change in (("removal-1-cap", ('"cap_volume":"1/48"', '"cap_volume":"1/47"')),
                         ("removal-1-cap", ('"height":"1"', '"height":"-1"')),
                         ("verification", ('"value":"1"', '"value":"-1"'))):
        wrong = os.path.join(folder, "wrong.html")
        assert change[0] in text, change
        pathlib.Path(wrong).write_text(text.replace(*change), encoding="utf-8")
        page = opened(wrong, "#" + step)
        assert page.evaluate(STEP)["no"] > 0, (step, change)
        page.close()


def check_names(program, folder):
    """A name that would end a script or an element, or is no UTF-8."""
    for name in (b"</script><script>alert(1)</script>.obj", b"a\"'<b>&amp;\xff.obj"):
        folder_of_name = os.path.join(folder, "names")
        source = os.path.join(os.fsencode(folder), b"".join([b"x", name.replace(b"/", b"\\")]))
        pathlib.Path(os.fsdecode(source)).write_text(CUBE, encoding="ascii")
        path = os.path.join(folder, "named.html")
        subprocess.run([program, "teach", source, "-o", path], check=True, stdout=subprocess.DEVNULL)
        page = opened(path)
        seen = page.evaluate("[document.scripts.length, document.querySelector('h1').innerText, document.querySelectorAll('h1 b').length]")
        assert seen[0] == 2 and seen[1].startswith("x") and seen[2] == 0 and not page.complaints, (seen, page.complaints)
        page.close()


def check_sizes(path, chapters):
    """Nothing is wider than the window, not on a phone and not in the dark."""
    for width, dark in ((400, False), (400, True), (1300, True)):
        page = opened(path, width=width, height=800, dark=dark)
        for chapter in chapters:
            page.evaluate(f"location.hash = '#{chapter}'; new Promise(requestAnimationFrame)")
            seen = page.evaluate(STEP)
            assert seen["wide"] <= 0, (chapter, width, seen["wide"])
        assert not page.complaints, page.complaints
        page.close()


# The page's clock and frames, in the test's hands: a busy machine may not show a frame in time, and need not.
OWN_CLOCK = """(() => {
  window.waiting = []; window.clock = 0;
  window.requestAnimationFrame = frame => waiting.push(frame);
  performance.now = () => clock;
  window.shownAt = time => {
    clock = time;
    for (const frame of waiting.splice(0)) frame(time);
    return [...document.querySelectorAll("#solid path")].map(e => e.getAttribute("d")).join();
  };
})()"""


def check_motion(path):
    """The cap grows by itself, unless the reader prefers that nothing moves."""
    for still in (False, True):
        page = opened(path, "#removal-1", still=still)
        page.evaluate(OWN_CLOCK)
        page.evaluate("new Promise(done => { addEventListener('hashchange', done); location.hash = '#removal-1-cap'; })")
        sights = [page.evaluate(f"shownAt({time})") for time in (0, 300, 600, 900, 1200)]
        assert page.evaluate("waiting.length") == 0, "moves on"
        assert [sight == sights[-1] for sight in sights] == [still, still, still, True, True], still
        page.close()


# What a reader sees of sizes: the box of the solid, the length of a pixel by the scale bar, the caption, and whether the first
# solid is there as a ghost.
SIZES = """(() => {
  const svg = document.querySelector("#solid svg"), all = [...svg.querySelectorAll(".face:not(.cap)")].map(face => face.getBBox());
  const bar = svg.querySelector("path.bar").getBBox();
  return {box: [Math.min(...all.map(b => b.x)), Math.min(...all.map(b => b.y)), Math.max(...all.map(b => b.x + b.width)),
    Math.max(...all.map(b => b.y + b.height))], pixel: Number(svg.querySelector("text.bar").textContent) / bar.width,
    caption: document.querySelector("#solid figcaption span").textContent, ghost: svg.querySelectorAll(".ghost").length};
})()"""


FILM = """(() => ({at: film.at, say: document.getElementById("say").innerText, count: document.querySelector("[data-film] + output").textContent,
  link: document.querySelector("#more a").hash, faces: document.querySelectorAll("#solid .face").length,
  dot: ["cx", "cy"].map(name => Number(document.querySelector("#film-curve circle").getAttribute(name))),
  box: (box => [box.left, box.top, box.width, box.height])(document.getElementById("film-curve").getBoundingClientRect())}))()"""


def check_film(path, lesson):
    """The run as a film: each place of the slider shows that solid; the dot is as high as its cost; playing ends at the end; a
    pointer drags the dot; and from everywhere a link explains the step."""
    page, last = opened(path, "#film"), len(lesson["removals"])
    try:
        costs, start = [float(removal["cost"]["decimal"]) for removal in lesson["removals"]], len(lesson["topology"]["present"])
        heights = []
        for k in range(last + 1):
            page.evaluate(f"(() => {{ const s = document.querySelector('[data-film]'); s.value = {k}; s.dispatchEvent(new Event('input', {{bubbles: true}})); }})()")
            seen = page.evaluate(FILM)
            assert seen["at"] == k and seen["count"] == f"{k} of {last}" and f" {start - k} of {start} are left" in seen["say"], seen
            assert seen["faces"] == start - k, seen
            assert seen["link"] == (f"#removal-{lesson['removals'][k]['step']}" if k < last else "#removal-end"), seen
            heights.append(-seen["dot"][1])
        for a in range(last):
            for b in range(a):
                if abs(costs[a] - costs[b]) > 1e-3 * costs[a]:
                    assert (costs[a] > costs[b]) == (heights[a] > heights[b]), (a, b, costs, heights)
        page.evaluate("document.querySelector('[data-speed]').value = '60', film.speed = 60, document.querySelector('[data-play]').click()")
        page.evaluate("new Promise(done => setTimeout(done, 1500))")
        assert page.evaluate("[film.at, film.playing]") == [last, False]
        left, top, width, height = page.evaluate(FILM)["box"]
        for kind, share in (("mousePressed", 0.9), ("mouseMoved", 0.5), ("mouseReleased", 0.5)):
            page.call("Input.dispatchMouseEvent", type=kind, x=left + share * width, y=top + height / 2, button="left", buttons=1, clickCount=1)
        assert 0 < page.evaluate("film.at") < last
        assert not page.complaints, page.complaints
    finally:
        page.close()


def check_contents(program, folder):
    """A lesson of many removals: its contents fit on a screen, and the line of the step at hand is seen."""
    shape, path = os.path.join(folder, "ball.obj"), os.path.join(folder, "ball.html")
    subprocess.run([program, "generate", "fibonacci-sphere", "--points", "45", "-o", shape], check=True, stdout=subprocess.DEVNULL)
    subprocess.run([program, "teach", shape, "-o", path], check=True, stdout=subprocess.DEVNULL)
    page = opened(path, "#removal-33-cap")
    try:
        for move, here in ((None, "#removal-33"), ("ArrowRight", "#removal-34"), ("End", None)):
            if move:
                press(page, move)
            seen = page.evaluate("""[...document.querySelectorAll("#contents a, #contents ol summary")].filter(e => e.checkVisibility())
                .map(e => [e.hash ?? "", e.hasAttribute("aria-current"), e.getBoundingClientRect().bottom])""")
            assert len(seen) <= 45, (move, len(seen))
            current = [(hash_, bottom) for hash_, is_here, bottom in seen if is_here]
            assert len(current) == 1 and current[0][1] < 900 and (here is None or current[0][0] == here), (move, current)
        assert not page.complaints, page.complaints
    finally:
        page.close()


def check_question(path, lesson):
    """Before the first removal the reader is asked which it will be, and told why; nothing is blocked."""
    page, removal = opened(path, "#removal-1", asks=True), lesson["removals"][0]
    try:
        text = lambda: page.evaluate("document.querySelector('main').innerText")  # noqa: E731
        assert "Which one?" in text() and "Tell me" in text() and "goes\n" not in text(), text()
        wrong = next(i for i in lesson["topology"]["present"] if i not in removal["tie"])
        for guess, said in ((wrong, "Not so."), (removal["removed"], "Right.")):
            page.evaluate(f"pick('h{guess}')")
            assert said in text() and f"You picked {guess}." in text(), text()
        page.evaluate("document.querySelector('[data-told]').click()")
        assert "The cheapest is" in text() and "Which one?" not in text(), text()
        page.evaluate("state.isTold = false; show()")
        press(page, "ArrowRight")
        press(page, "ArrowLeft")
        assert "The cheapest is" in text(), text()
        # What each chapter is for stands at its first step, what it gave at its last one.
        for chapter in page.evaluate("chapters.map(chapter => chapter.id)"):
            if chapter == "film":
                continue
            page.evaluate(f"go(steps.findIndex(step => step.chapter.id === '{chapter}'))")
            assert "Wanted:" in text(), chapter
            page.evaluate(f"go(steps.findLastIndex(step => step.chapter.id === '{chapter}'))")
            assert "Now you have:" in text(), chapter
        assert not page.complaints, page.complaints
    finally:
        page.close()


def check_near_ties(path):
    """Costs that look the same are told apart: what is no tie says by how much it is dearer."""
    page, told = opened(path), 0
    try:
        for name in page.evaluate("steps.filter(step => /^removal-[0-9]+$/.test(step.id)).map(step => step.id)"):
            page.evaluate(f"go(steps.findIndex(step => step.id === {json.dumps(name)}))")
            rows = page.evaluate("""[...document.querySelector("#more table").querySelectorAll("tbody tr")].map(row =>
                [...row.children].map(cell => cell.innerText.trim())).map(cells => [cells[2], cells.at(-1)])""")
            shown = next(cost for cost, note in rows if note == "goes")
            for cost, note in rows:
                if cost == shown and note not in ("goes", "tie"):
                    assert re.fullmatch(r"dearer by [0-9.e-]+", note), (name, cost, note)
                    told += 1
    finally:
        page.close()
    assert told > 0, "nothing looked the same: the test would see nothing"


def check_frame(path):
    """A solid that grows is drawn no smaller than before, unless the caption says how many times smaller; the scale bar agrees."""
    page, before, factors = opened(path), None, []
    try:
        names = page.evaluate("steps.filter(step => /^removal-[0-9]+$/.test(step.id)).map(step => step.id)")
        for place, name in enumerate(names):
            page.evaluate(f"go(steps.findIndex(step => step.id === {json.dumps(name)}))")
            seen = page.evaluate(SIZES)
            said = re.search(r"Drawn ([0-9]+) times smaller", seen["caption"])
            seen["factor"] = int(said[1]) if said else 1
            assert (seen["ghost"] > 0) == (place > 0), (name, seen)
            if before and before["factor"] == seen["factor"]:
                assert all(old >= new - 0.5 for old, new in zip(before["box"][:2], seen["box"][:2])), (name, before, seen)
                assert all(old <= new + 0.5 for old, new in zip(before["box"][2:], seen["box"][2:])), (name, before, seen)
            if before:
                grown = seen["pixel"] / before["pixel"] * before["factor"] / seen["factor"]
                assert abs(grown - 1) < 0.02, (name, before, seen)
            factors.append(seen["factor"])
            before = seen
        assert not page.complaints, page.complaints
    finally:
        page.close()
    assert factors[0] == 1 and factors == sorted(factors) and factors[-1] > 1, factors


def main():
    program, data = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    if len(sys.argv) > 3:
        sys.argv[3] = os.path.abspath(sys.argv[3])
    if chromium.is_missing():
        return chromium.SKIPPED
    with tempfile.TemporaryDirectory() as folder:
        path, lesson = check_cube(program, folder)
        check_polar(path)
        check_candidates(path)
        check_doubles(program, folder)
        check_links(path)
        check_wrong_record(path, folder)
        check_names(program, folder)
        check_sizes(path, CHAPTERS)
        check_motion(path)
        check_contents(program, folder)
        for name, family in (("icosahedron", ["icosahedron"]), ("needle", ["needle", "--points", "12", "--aspect", "1e9"]),
                             ("huge", ["huge", "--points", "8"])):
            shape = os.path.join(folder, name + ".obj")
            subprocess.run([program, "generate", *family, "-o", shape], check=True, stdout=subprocess.DEVNULL)
            page, known, _ = check_lesson(program, name, [shape, "--precision", "64"], folder, CHAPTERS)
            if name == "icosahedron":
                check_frame(page)
                check_near_ties(page)
                check_question(page, known)
                check_film(page, known)
        planes = os.path.join(folder, "planes.json")
        subprocess.run([program, "hull", os.path.join(folder, "cube.obj"), "-o", planes], check=True, stdout=subprocess.DEVNULL)
        check_lesson(program, "planes", [planes], folder, CHAPTERS)
    print(f"lessons: walked through, {len(lesson['halfspaces'])} halfspaces and more")
    return 0


if __name__ == "__main__":
    sys.exit(main())
