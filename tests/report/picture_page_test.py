#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""picture_page_test.py PROGRAM DATA [SCREENSHOTS] - opens pictures in headless Chromium, from disk, with its
software renderer: no complaint, no crack, few draw calls a frame for the bunny and its proxy; numbers
and planes of facets by mouse, finger and keys; two panes; light, dark and printed; and without WebGL, where
the static drawing stands. Writes screenshots into the folder, if one is named."""
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile

import chromium

MOST_DRAWS = 10  # of three layers, each of them faces, edges and what is picked
CUBE = "".join(f"v {k & 1} {k >> 1 & 1} {k >> 2}\n" for k in range(8)) + (
    "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n")

# The canvas as its window of 800x600; turned a little by each frame, which is waited for.
SIZE = """new Promise(done => {
  document.getElementById("view").style.cssText = "flex: none; width: 800px; height: 600px";
  setTimeout(done, 1000);
})"""
PRELUDE = """
const canvas = document.querySelector("canvas"), gl = canvas.getContext("webgl2");
const size = () => [gl.drawingBufferWidth, gl.drawingBufferHeight];
canvas.setPointerCapture = () => {};  // there is none for a pointer that is made up
const frame = async (right, down) => {
  for (const [type, clientX, clientY] of [["down", 0, 0], ["move", right, down], ["cancel", right, down]]) {
    canvas.dispatchEvent(new PointerEvent("pointer" + type, {pointerId: 99, clientX, clientY}));
  }
  await new Promise(requestAnimationFrame);
};
"""
SPEED = "(async () => {" + PRELUDE + """
  const middle = new Uint8Array(3200), seen = new Set();  // a row: reading it waits for the frame
  const finish = () => gl.readPixels(0, 300, 800, 1, gl.RGBA, gl.UNSIGNED_BYTE, middle);
  await frame(5, 0);
  await frame(5, 0);
  finish();
  let draws = 0;
  for (const name of ["drawArrays", "drawElements", "drawArraysInstanced", "drawElementsInstanced"]) {
    const draw = gl[name].bind(gl);
    gl[name] = (...what) => { ++draws; draw(...what); };
  }
  const start = performance.now();
  let frames = 0;
  while (frames < 60 && performance.now() < start + 10000) {
    await frame(5, 0);
    finish();
    seen.add(String.fromCharCode(...middle));
    ++frames;
  }
  return {size: size(), frames, different: seen.size, draws: draws / frames,
    speed: 1000 * frames / (performance.now() - start)};
})()"""
# Of what is seen after a turn: pixels covered in full, those among them that are darker than the least
# light allows (shapes.js lights every face with 0.54 at least), and background that is enclosed.
CRACKS = "(async () => {" + PRELUDE + """
  await frame(RIGHT, DOWN);
  if (AT_REST && canvas.width === 800) {  // drawn in full at once, or when the picture rests
    await new Promise(done => new MutationObserver(done).observe(canvas, {attributeFilter: ["width"]}));
  }
  const [width, height] = size(), pixels = new Uint8Array(4 * width * height);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  const reached = new Uint8Array(width * height), todo = [0];
  reached[0] = 1;
  while (todo.length) {
    const at = todo.pop(), column = at % width;
    for (const next of [column > 0 ? at - 1 : -1, column < width - 1 ? at + 1 : -1, at - width, at + width]) {
      if (next < 0 || next >= reached.length || reached[next] || pixels[4 * next + 3] === 255) continue;
      reached[next] = 1;
      todo.push(next);
    }
  }
  let covered = 0, dark = 0, enclosed = 0;
  for (let k = 0; k < reached.length; ++k) {
    if (pixels[4 * k + 3] === 255) {
      ++covered;
      if (pixels[4 * k] < 0.4 * 0xe6) ++dark;
    } else if (!reached[k]) {
      ++enclosed;
    }
  }
  return {covered, dark, enclosed};
})()"""
# What is seen, as one number.
SIGHT = "(async () => {" + PRELUDE + """
  await frame(0, 0);
  const [width, height] = size(), pixels = new Uint8Array(4 * width * height);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  return pixels.reduce((sum, x) => (31 * sum + x) % 1000000007, 0);
})()"""
SHOWN = """[...document.querySelectorAll("#layers input")].map(box => box.hidden ? null : box.checked)"""


# Of each half of what is seen, or of all: where it is covered, as [left, right, low, high].
BOXES = "(async () => {" + PRELUDE + """
  await new Promise(done => setTimeout(done, 400));  // at rest
  await frame(0, 0);
  const [width, height] = size(), pixels = new Uint8Array(4 * width * height);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  const across = ACROSS, down = DOWN, boxes = [];
  for (let k = 0; k < across * down; ++k) {
    const x0 = k % across * width / across, y0 = Math.floor(k / across) * height / down, box = [1e9, -1, 1e9, -1];
    for (let y = 0; y < Math.floor(height / down); ++y) {
      for (let x = 0; x < Math.floor(width / across); ++x) {
        if (pixels[4 * (Math.floor(y + y0) * width + Math.floor(x + x0)) + 3] === 0) continue;
        box[0] = Math.min(box[0], x), box[1] = Math.max(box[1], x);
        box[2] = Math.min(box[2], y), box[3] = Math.max(box[3], y);
      }
    }
    boxes.push(box.map(x => x * canvas.clientWidth / width));
  }
  return boxes;
})()"""
# The numbers at facets that are seen, with their places on the page.
NUMBERS = """(async () => {
  await new Promise(requestAnimationFrame);
  await new Promise(requestAnimationFrame);
  return [...document.querySelectorAll("#view b")].filter(label => !label.hidden).map(label => {
    const box = label.getBoundingClientRect();
    return [Number(label.textContent), box.x + box.width / 2, box.y + box.height / 2];
  });
})()"""
TOLD = 'document.getElementById("told").innerText'
TOLD_SOON = """new Promise(done => {
  const told = document.getElementById("told"), end = performance.now() + 2000;
  const look = () => told.innerText || performance.now() > end ? done(told.innerText) : setTimeout(look, 20);
  look();
})"""
# The least ratio of luminances [WCAG 2.2, contrast ratio] of texts to the page behind them.
CONTRAST = """(() => {
  const light = color => {
    const [r, g, b] = color.match(/[\\d.]+/g).map(x => x / 255)
      .map(x => x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4);
    return 0.2126 * r + 0.7152 * g + 0.0722 * b + 0.05;
  };
  const paper = light(getComputedStyle(document.body).backgroundColor);
  return Math.min(...["h1", "#how", "small", "#told", "#view b"].map(name => {
    const ink = light(getComputedStyle(document.querySelector(name)).color);
    return Math.max(ink, paper) / Math.min(ink, paper);
  }));
})()"""


def opened(path, width=820, height=760, **how):
    return chromium.Page(pathlib.Path(path).resolve().as_uri(), width=width, height=height, **how)


def mouse(page, *steps):
    for kind, x, y in steps:
        page.call("Input.dispatchMouseEvent", type="mouse" + kind, x=x, y=y, button="left", clickCount=1,
                  buttons=0 if kind == "Released" else 1)


def click(page, x, y):
    mouse(page, ("Moved", x, y), ("Pressed", x, y), ("Released", x, y))


def drag(page, x, y, right, down):
    mouse(page, ("Pressed", x, y), ("Moved", x + right, y + down), ("Released", x + right, y + down))


def press(page, key):
    text = {"Enter": "\r"}.get(key, key if len(key) == 1 else "")
    page.call("Input.dispatchKeyEvent", type="keyDown", key=key, text=text)
    page.call("Input.dispatchKeyEvent", type="keyUp", key=key)


def middle(page):
    return page.evaluate('(b => [b.x + b.width / 2, b.y + b.height / 2])(document.querySelector("canvas").getBoundingClientRect())')


def boxes(page, across=1, down=1):
    return page.evaluate(BOXES.replace("ACROSS", str(across)).replace("DOWN", str(down)))


def cracks(page, right, down, at_rest):
    """What is seen after a turn, while it moves or when it rests."""
    script = CRACKS.replace("RIGHT", str(right)).replace("DOWN", str(down))
    return page.evaluate(script.replace("AT_REST", "true" if at_rest else "false"))


def keep(page, name):
    if len(sys.argv) > 3:
        page.screenshot(os.path.join(sys.argv[3], name + ".png"))


def measured(page):
    before = page.processor_seconds()
    run = page.evaluate(SPEED)
    return {**run, "cost": (page.processor_seconds() - before) / run["frames"]}


def speed_of(run):
    """Said, not asserted: a busy machine draws fewer."""
    return f"{run['speed']:.1f} frames a second at 800x600, {1000 * run['cost']:.0f} ms of processor each"


def check_convex(path):
    """A convex surface, seen from anywhere, covers each pixel inside of its outline."""
    page = opened(path, graphics=chromium.SOFTWARE_WEBGL)
    try:
        page.evaluate(SIZE)
        page.evaluate('document.querySelectorAll("#layers input")[1].click()')
        for right, down, at_rest in ((0, 0, True), (200, 60, False), (150, -200, True)):
            seen = cracks(page, right, down, at_rest)
            assert seen["covered"] > 50000, seen
            assert seen["dark"] == seen["enclosed"] == 0, seen
        assert not page.complaints, page.complaints
    finally:
        page.close()


def check_bunny(path):
    page = opened(path, graphics=chromium.SOFTWARE_WEBGL)
    try:
        assert page.evaluate("document.title") == "bunny.obj"
        assert page.evaluate(SHOWN) == [True, False, True], page.evaluate(SHOWN)
        page.evaluate(SIZE)
        keep(page, "bunny")
        run = measured(page)
        assert run["size"] == [800, 600] and run["different"] == run["frames"] and run["draws"] <= MOST_DRAWS, run
        boxes = 'document.querySelectorAll("#layers input")'
        page.evaluate(f"{boxes}[2].click()")
        keep(page, "bunny_alone")
        for at_rest in (False, True):
            seen = cracks(page, 0, 0, at_rest)
            assert seen["covered"] > 20000 and seen["dark"] == seen["enclosed"] == 0, seen
        page.evaluate(f"{boxes}[0].click()")
        seen = cracks(page, 0, 0, True)
        assert seen["covered"] == 0, f"hidden, but seen: {seen}"
        assert not page.complaints, page.complaints
        return speed_of(run)
    finally:
        page.close()


def check_decomposition(path, control, fewer):
    """Parts, apart and together; the clusters after fewer steps; rays as colours: each looks different."""
    page = opened(path, graphics=chromium.SOFTWARE_WEBGL)
    try:
        page.evaluate(SIZE)
        sights = []

        def look(name, script):
            page.evaluate(script)
            sights.append(page.evaluate(SIGHT))
            keep(page, name)

        def show(index):
            return f'document.querySelectorAll("#layers input").forEach((x, k) => {{ x.checked = k === {index}; x.onchange(); }})'

        def slide(name, value):
            return f'{{ const s = document.getElementById("{name}"); s.value = {value}; s.oninput(); }}'

        look("parts", "0")
        look("parts_apart", slide("apart", 80))
        look("clusters", slide("apart", 0) + show(1))
        before = int(page.evaluate(f'document.getElementById("{control}").max')) - fewer
        look("clusters_before", slide(control, before))
        assert page.evaluate(f'document.querySelector("#{control} + output").textContent') == str(before)
        look("rays", show(2))
        scale = page.evaluate('(i => [getComputedStyle(i).backgroundImage, i.offsetWidth])(document.querySelector("#layers i.scale"))')
        assert scale[0].startswith("linear-gradient(to right, rgb(43, 122, 181)") and scale[1] > 50, scale
        assert len(set(sights)) == len(sights), sights
        assert page.evaluate('document.getElementById("apart").labels[0].innerText.trim()') == "draw parts apart"
        assert not page.complaints, page.complaints
    finally:
        page.close()


def check_picking(cube):
    """The unit cube, seen from -x, +y and +z: what is where, and what is next to what, by definition."""
    solid = json.loads(pathlib.Path(cube + ".json").read_text())["halfspaces"]
    number = {tuple(map(int, plane)): k for k, plane in enumerate(solid)}
    left, right = number[-1, 0, 0, 0], number[1, 0, 0, -1]
    top, bottom = number[0, 1, 0, -1], number[0, -1, 0, 0]
    front, back = number[0, 0, 1, -1], number[0, 0, -1, 0]
    page = opened(cube + ".html", width=1300, height=900, graphics=chromium.SOFTWARE_WEBGL)
    try:
        x, y = middle(page)
        places = {left: (x - 150, y + 30), top: (x, y - 170), front: (x + 100, y + 50)}
        planes = {left: "(-1, 0, 0, 0)", top: "(0, 1, 0, -1)", front: "(0, 0, 1, -1)"}
        for facet, place in places.items():
            click(page, *place)
            told = page.evaluate(TOLD)
            assert told.startswith(f"Facet {facet} of enclosing solid: 4 corners, next to "), told
            assert told.endswith(f". Plane {planes[facet]}."), told
            beside = sorted(map(int, told.split("next to ")[1].split(".")[0].split(", ")))
            opposite = {left: right, top: bottom, front: back}[facet]
            assert beside == sorted({*range(6)} - {facet, opposite}), told
        keep(page, "cube_picked")
        press(page, "Escape")
        assert page.evaluate(TOLD) == ""
        click(page, *places[top])
        lit = page.evaluate(SIGHT)
        click(page, 20, y + 200)  # beside it
        assert page.evaluate(TOLD) == "" and page.evaluate(SIGHT) != lit
        drag(page, *places[top], 40, 0)  # is no click
        drag(page, *places[top], -40, 0)
        assert page.evaluate(TOLD) == ""
        press(page, "Enter")
        assert page.evaluate(TOLD).startswith("Facet "), "the middle of the view"

        assert page.evaluate(NUMBERS) == []
        page.evaluate('document.getElementById("numbers").click()')
        seen = {k: place for k, *place in page.evaluate(NUMBERS)}
        assert sorted(seen) == sorted(places), seen
        for facet, place in seen.items():
            click(page, *place)
            assert page.evaluate(TOLD).startswith(f"Facet {facet} "), (facet, page.evaluate(TOLD))
        keep(page, "cube_numbers")
        drag(page, x, y, 30, 0)
        moved = {k: place for k, *place in page.evaluate(NUMBERS)}
        # A point of the side that looks at the reader goes where the mouse goes.
        assert sorted(moved) == sorted(seen) and moved[front][0] > seen[front][0] + 5, (seen, moved)
        drag(page, x - 200, y, 471 - 30, 0)  # half a turn: 150 pixels each radian
        assert sorted(k for k, *_ in page.evaluate(NUMBERS)) == sorted((right, top, back))
        page.evaluate('document.querySelector("#layers input:last-of-type").click()')
        page.evaluate('document.querySelectorAll("#layers input")[1].click()')
        assert page.evaluate(NUMBERS) == [], "of a layer that is hidden"
        assert not page.complaints, page.complaints
    finally:
        page.close()


def check_keys(path, planes):
    """By keys alone, every facet once, with the very integers of the summary."""
    page = opened(path, graphics=chromium.SOFTWARE_WEBGL)
    try:
        while page.evaluate("document.activeElement.tagName") != "CANVAS":
            page.call("Input.dispatchKeyEvent", type="keyDown", key="Tab", windowsVirtualKeyCode=9)
        for k, plane in enumerate(planes):
            press(page, "n")
            told = page.evaluate(TOLD)
            assert told.startswith(f"Facet {k} of enclosing solid: ") and told.endswith(f", exactly ({', '.join(plane)})."), told
            # Before them doubles, with a normal of length 1.
            *normal, offset = map(float, told.split(" Plane (")[1].split(")")[0].split(", "))
            length = math.sqrt(sum(int(x) ** 2 for x in plane[:3]))
            for double, exact in zip((*normal, offset), plane):
                assert math.isclose(double, int(exact) / length, rel_tol=1e-5, abs_tol=1e-12), told
            assert page.evaluate('document.getElementById("facet").value') == str(k)
        keep(page, "keys")
        press(page, "p")
        assert page.evaluate(TOLD).startswith(f"Facet {len(planes) - 2} ")
        press(page, "Escape")
        press(page, "p")
        assert page.evaluate(TOLD).startswith(f"Facet {len(planes) - 1} ")
        assert any(abs(int(x)) > 2 ** 53 for plane in planes for x in plane), "doubles would do"
        assert not page.complaints, page.complaints
    finally:
        page.close()


def check_panes(cube, width, across, down):
    """The input, a cube, and its solid, which is the same one: both panes look alike, however they are turned."""
    page = opened(cube + ".html", width=width, height=900, graphics=chromium.SOFTWARE_WEBGL)
    try:
        page.evaluate('document.getElementById("pair").click()')
        x, y = middle(page)
        turns = []
        for right in (0, 60):
            drag(page, x - 100, y - 100, right, right)
            one, other = boxes(page, across, down)
            # Edges are a little thicker than nothing.
            assert max(abs(a - b) for a, b in zip(one, other)) < 6 and one[1] - one[0] > 80, (one, other)
            turns.append(one)
        assert turns[0] != turns[1], turns
        page.evaluate('document.getElementById("numbers").click()')
        half = 0 if down > 1 else 1  # above or below, left or right
        assert all(place[half] > (x, y)[1 - half] for _, *place in
                   [(k, b, a) for k, a, b in page.evaluate(NUMBERS)]), page.evaluate(NUMBERS)
        k, a, b = page.evaluate(NUMBERS)[0]
        click(page, a, b)
        assert page.evaluate(TOLD).startswith(f"Facet {k} "), page.evaluate(TOLD)
        keep(page, f"panes_{width}")
        assert not page.complaints, page.complaints
    finally:
        page.close()


def check_parts(path, parts):
    """The facets of parts, each eleventh of them (each is drawn), and the input beside them, which was hidden at first."""
    page = opened(path, graphics=chromium.SOFTWARE_WEBGL)
    try:
        told = page.evaluate("""[...document.querySelectorAll("#facet option")].slice(1).map((option, k) => {
            if (k % 11) return null;
            option.parentElement.parentElement.value = option.value;
            document.getElementById("facet").onchange();
            return document.getElementById("told").innerText;
        })""")
        expected = [(k, f"part {number}", f"({', '.join(plane)}).") for number, part in enumerate(parts)
                    for k, plane in enumerate(part["halfspaces"])]
        assert len(told) == len(expected) > 100, (len(told), len(expected))
        for line, (k, name, plane) in list(zip(told, expected))[::11]:
            assert line.startswith(f"Facet {k} of {name}: ") and line.endswith(plane), (line, name, plane)
        page.evaluate('document.getElementById("pair").click()')
        assert page.evaluate(SHOWN)[0]
        assert min(box[1] - box[0] for box in boxes(page, 2, 1)) > 80
        keep(page, "parts_beside_input")
        assert not page.complaints, page.complaints
    finally:
        page.close()


def check_touch(cube):
    page = opened(cube + ".html", width=400, height=800, graphics=chromium.SOFTWARE_WEBGL)
    try:
        page.call("Emulation.setTouchEmulationEnabled", enabled=True, maxTouchPoints=2)
        x, y = middle(page)

        def touch(kind, *places):
            page.call("Input.dispatchTouchEvent", type="touch" + kind,
                      touchPoints=[{"x": x + right, "y": y + down, "id": k} for k, (right, down) in enumerate(places)])

        (before,) = boxes(page)
        touch("Start", (-40, 0))
        touch("Start", (-40, 0), (40, 0))
        for apart in (34, 30, 26):
            touch("Move", (-apart, 0), (apart, 0))
        touch("End")
        (after,) = boxes(page)
        share = (after[1] - after[0]) / (before[1] - before[0])
        assert math.isclose(share, 26 / 40, rel_tol=0.03), (share, before, after)
        assert page.evaluate(TOLD) == "", "a pinch picks nothing"
        touch("Start", (0, 0))
        touch("Move", (60, 0))
        touch("End")
        (turned,) = boxes(page)
        assert turned != after
        # The words may come late. The browser cancels a touch that a stalled page does not answer in time: such a tap is repeated.
        page.evaluate("""document.querySelector("canvas").addEventListener("pointercancel", () => window.cancelled = true)""")
        for _ in range(5):
            page.evaluate("window.cancelled = false")
            touch("Start", (0, 0))
            touch("End")
            if page.evaluate(TOLD_SOON) or not page.evaluate("window.cancelled"):
                break
        assert page.evaluate(TOLD).startswith("Facet "), "a tap picks"
        assert not page.complaints, page.complaints
    finally:
        page.close()


def check_looks(path):
    """Light and dark, wide and narrow: texts stand out. Nothing moves by itself. Print has the words."""
    for scheme in ("light", "dark"):
        for width in (1300, 400, 2000):
            page = opened(path, width=width, height=900, graphics=chromium.SOFTWARE_WEBGL,
                          media=(("prefers-color-scheme", scheme), ("prefers-reduced-motion", "reduce")))
            try:
                page.evaluate('document.getElementById("numbers").click()')
                page.evaluate('document.querySelector("canvas").focus()')
                press(page, "n")
                assert page.evaluate(CONTRAST) >= 4.5, page.evaluate(CONTRAST)
                assert page.evaluate("document.documentElement.scrollWidth") <= width
                page.evaluate("new Promise(done => setTimeout(done, 600))")
                before = page.call("Page.captureScreenshot")["data"]
                page.evaluate("new Promise(done => setTimeout(done, 700))")
                assert page.call("Page.captureScreenshot")["data"] == before, "something moves by itself"
                keep(page, f"{scheme}_{width}")
                if width == 1300:
                    told = page.evaluate(TOLD)
                    page.call("Emulation.setEmulatedMedia", media="print",
                              features=[{"name": "prefers-color-scheme", "value": scheme}])
                    assert page.evaluate("getComputedStyle(document.body).color") == "rgb(0, 0, 0)"
                    assert told and page.evaluate(TOLD) == told
                    assert page.evaluate("""["#view svg", "#told", "#view canvas", "#view b", "#facet"].map(
                        name => document.querySelector(name).getClientRects().length > 0)""") == [True, True, False, False, False]
                    keep(page, f"{scheme}_print")
                assert not page.complaints, page.complaints
            finally:
                page.close()


def check_names(path):
    """Names of files and objects are texts, wherever the page puts them."""
    page = opened(path, graphics=chromium.SOFTWARE_WEBGL)
    try:
        page.evaluate('document.querySelector("canvas").focus()')
        press(page, "n")
        assert "</script><img" in page.evaluate(TOLD), page.evaluate(TOLD)
        assert page.evaluate('document.querySelectorAll("#facet optgroup").length') == 2
        assert page.evaluate('document.images.length === 0 && typeof hacked === "undefined"')
        assert not page.complaints, page.complaints
    finally:
        page.close()


def check_static(path):
    """Without WebGL: the drawing and the numbers, no switches, no complaint."""
    page = opened(path, graphics=chromium.NO_WEBGL)
    try:
        assert page.evaluate('document.querySelector("canvas") === null')
        assert page.evaluate(SHOWN) == [None, None, None], page.evaluate(SHOWN)
        box = page.evaluate('(b => [b.width, b.height])(document.querySelector("#view svg").getBoundingClientRect())')
        assert min(box) > 300, box
        text = page.evaluate("document.body.innerText")
        assert "35,947 points, 69,451 faces" in text and "18 halfspaces" in text, text
        page.evaluate("""(list => { list.value = 3; list.dispatchEvent(new Event("change")); })(
            document.getElementById("facet"))""")
        assert page.evaluate(TOLD).startswith("Facet 3 of enclosing solid: "), page.evaluate(TOLD)
        assert not page.complaints, page.complaints
        keep(page, "bunny_static")
    finally:
        page.close()


def main():
    program, data = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    if len(sys.argv) > 3:
        sys.argv[3] = os.path.abspath(sys.argv[3])
    if chromium.is_missing():
        return chromium.SKIPPED
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        subprocess.run([program, "generate", "fibonacci-sphere", "--points", "20000", "--facets", "-o", "sphere.obj"],
                       check=True, stdout=subprocess.DEVNULL)
        for name, faces in (("sphere.obj", "12"), (data / "bunny.obj", "18")):
            subprocess.run([program, "simplify", name, "--faces", faces, "--picture",
                            pathlib.Path(name).stem + ".html"], check=True, stdout=subprocess.DEVNULL)
        pathlib.Path("cube.obj").write_text(CUBE)
        subprocess.run([program, "simplify", "cube.obj", "--faces", "6", "--picture", "cube.html", "-o", "cube.json"],
                       check=True, stdout=subprocess.DEVNULL)
        solid = subprocess.run([program, "simplify", data / "spot.obj", "--faces", "14", "--json", "--picture", "spot.html"],
                               check=True, stdout=subprocess.PIPE).stdout
        hostile = pathlib.Path("\"><img src=x onerror='hacked=1'>.obj")
        name = "</script><img src=x onerror=hacked=1>"
        hostile.write_text(f"o {name}\n{CUBE}o '\"><!--\n" + CUBE.replace("v ", "v 3").replace("f ", "f -"))
        subprocess.run([program, "simplify", hostile, "--faces", "6", "--parts", "--picture", "hostile.html"],
                       check=True, stdout=subprocess.DEVNULL)
        for method, limit in (("hacd", "3%"), ("acd", "10%")):
            subprocess.run([program, "decompose", data / "spot.obj", "--method", method, "--concavity", limit,
                            "--measures", "none", "--picture", f"{method}.html", "-o", f"{method}.json"], check=True, stdout=subprocess.DEVNULL)
        check_convex("sphere.html")
        check_picking("cube")
        check_keys("spot.html", json.loads(solid)["output"]["planes"])
        check_panes("cube", 1300, 2, 1)
        check_panes("cube", 400, 1, 2)
        check_parts("hacd.html", json.loads(pathlib.Path("hacd.json").read_text())["parts"])
        check_touch("cube")
        check_looks("spot.html")
        check_names("hostile.html")
        check_decomposition("hacd.html", "merges", 40)
        check_decomposition("acd.html", "splits", 5)
        check_static("bunny.html")
        print(f"{check_bunny('bunny.html')}; no cracks")
    return 0


if __name__ == "__main__":
    sys.exit(main())
