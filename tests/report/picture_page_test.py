#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""picture_page_test.py PROGRAM DATA [SCREENSHOTS] - opens pictures in headless Chromium, from disk, with its
software renderer: no complaint, no crack, at least 20 frames a second for the bunny and its proxy; and
without WebGL, where the static drawing stands. Writes screenshots into the folder, if one is named."""
import os
import pathlib
import subprocess
import sys
import tempfile

import chromium

FRAMES_A_SECOND = 20

# The canvas as its window of 800x600; turned a little by each frame, which is waited for.
SIZE = """new Promise(done => {
  document.getElementById("view").style.cssText = "flex: none; width: 800px; height: 600px";
  setTimeout(done, 1000);
})"""
PRELUDE = """
const canvas = document.querySelector("canvas"), gl = canvas.getContext("webgl2");
const size = () => [gl.drawingBufferWidth, gl.drawingBufferHeight];
const frame = async (right, down) => {
  canvas.dispatchEvent(new PointerEvent("pointermove", {buttons: 1, movementX: right, movementY: down}));
  await new Promise(requestAnimationFrame);
};
"""
SPEED = "(async () => {" + PRELUDE + """
  const middle = new Uint8Array(3200), seen = new Set();  // a row: reading it waits for the frame
  const finish = () => gl.readPixels(0, 300, 800, 1, gl.RGBA, gl.UNSIGNED_BYTE, middle);
  await frame(5, 0);
  await frame(5, 0);
  finish();
  const start = performance.now();
  let frames = 0;
  while (frames < 60 && performance.now() < start + 10000) {
    await frame(5, 0);
    finish();
    seen.add(String.fromCharCode(...middle));
    ++frames;
  }
  return {size: size(), frames, different: seen.size,
    speed: 1000 * frames / (performance.now() - start)};
})()"""
# Of what is seen after a turn: pixels covered in full, those among them that are darker than the least
# light allows (viewer.js lights every face with 0.41 at least), and background that is enclosed.
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
      if (pixels[4 * k] < 0.4 * 0xcd) ++dark;
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


def opened(path, **how):
    return chromium.Page(pathlib.Path(path).resolve().as_uri(), width=820, height=760, **how)


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
        runs = [measured(page)]
        while runs[-1]["speed"] < FRAMES_A_SECOND and len(runs) < 3:
            runs.append(measured(page))
        assert all(run["size"] == [800, 600] and run["different"] == run["frames"] for run in runs), runs
        best = max(runs, key=lambda run: run["speed"])
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
        said = f"{best['speed']:.1f} frames a second at 800x600, {1000 * best['cost']:.0f} ms of processor each"
        # A busy machine draws fewer; two idle processors then would draw enough.
        assert max(best["speed"], 2 / best["cost"]) >= FRAMES_A_SECOND, said
        return said
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
        look("clusters", slide("apart", 0) + show(0))
        before = int(page.evaluate(f'document.getElementById("{control}").max')) - fewer
        look("clusters_before", slide(control, before))
        assert page.evaluate(f'document.querySelector("#{control} + output").textContent') == str(before)
        look("rays", show(1))
        assert len(set(sights)) == len(sights), sights
        assert page.evaluate('document.getElementById("apart").labels[0].innerText.trim()') == "draw parts apart"
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
        assert "35947 points, 69451 faces" in text and "18 halfspaces" in text, text
        assert not page.complaints, page.complaints
        keep(page, "bunny_static")
    finally:
        page.close()


def main():
    program, data = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    if len(sys.argv) > 3:
        sys.argv[3] = os.path.abspath(sys.argv[3])
    if chromium.find() is None:
        print("skipped: Chromium is not installed (Debian package chromium)")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        subprocess.run([program, "generate", "fibonacci-sphere", "--points", "20000", "--facets", "-o", "sphere.obj"],
                       check=True, stdout=subprocess.DEVNULL)
        for name, faces in (("sphere.obj", "12"), (data / "bunny.obj", "18")):
            subprocess.run([program, "simplify", name, "--faces", faces, "--picture",
                            pathlib.Path(name).stem + ".html"], check=True, stdout=subprocess.DEVNULL)
        for method, limit in (("hacd", "3%"), ("acd", "10%")):
            subprocess.run([program, "decompose", data / "spot.obj", "--method", method, "--concavity", limit,
                            "--no-measures", "--picture", f"{method}.html"], check=True, stdout=subprocess.DEVNULL)
        check_convex("sphere.html")
        check_decomposition("hacd.html", "merges", 40)
        check_decomposition("acd.html", "splits", 5)
        check_static("bunny.html")
        print(f"{check_bunny('bunny.html')}; no cracks")
    return 0


if __name__ == "__main__":
    sys.exit(main())
