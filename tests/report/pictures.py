#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""pictures.py PROGRAM - makes the pictures of README and guides, docs/pictures/*.png, by the pages of --picture in headless
Chromium. `./dev docs pictures` runs it."""
import pathlib
import subprocess
import sys
import tempfile

import chromium

ROOT = pathlib.Path(__file__).resolve().parents[2]
DATA = ROOT / "tests/data"
# The view alone, 900 x 600; then what is to be seen of it.
VIEW = """new Promise(done => {
  const view = document.getElementById("view");
  for (const other of [...document.body.children]) if (other !== view) other.style.display = "none";
  view.style.cssText = "flex: none; width: 900px; height: 600px";
  document.body.style.background = "#ffffff";
  const slide = (id, value) => { const s = document.getElementById(id); s.value = value; s.oninput(); };
  ACT
  setTimeout(done, 1500);
})"""


def make(program, name, arguments, act="", code=0):
    with tempfile.TemporaryDirectory() as folder:
        page = pathlib.Path(folder, "page.html")
        ran = subprocess.run([program, *map(str, arguments), "--picture", page], cwd=folder, stdout=subprocess.DEVNULL, check=False)
        assert ran.returncode == code, (arguments, ran.returncode)
        shown = chromium.Page(page.as_uri(), width=900, height=600, graphics=chromium.SOFTWARE_WEBGL)
        try:
            shown.evaluate(VIEW.replace("ACT", act))
            shown.screenshot(str(ROOT / "docs/pictures" / f"{name}.png"), whole=False)
            assert not shown.complaints, shown.complaints
        finally:
            shown.close()
    print(f"docs/pictures/{name}.png")


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    if chromium.is_missing():
        return chromium.SKIPPED
    (ROOT / "docs/pictures").mkdir(exist_ok=True)
    spot = DATA / "spot.obj"
    make(program, "parts", ["decompose", spot, "-o", "parts.obj"])
    make(program, "simplify", ["simplify", spot, "--faces", "14"])
    make(program, "cup", ["decompose", DATA / "cases/cup.obj", "-o", "cup.obj"], 'slide("apart", 25); slide("cut", 30);')
    with tempfile.TemporaryDirectory() as folder:
        hull = pathlib.Path(folder, "hull.obj")
        subprocess.run([program, "hull", spot, "-o", hull], stdout=subprocess.DEVNULL, check=True)
        corners = [line for line in hull.read_text(encoding="utf-8").splitlines(True) if line.startswith("v ")]
        hull.write_text("".join(corners[:4] + corners[5:]), encoding="utf-8")
        make(program, "verdict", ["verify", spot, hull, "--asks", "hull"], code=1)
    return 0


if __name__ == "__main__":
    sys.exit(main())
