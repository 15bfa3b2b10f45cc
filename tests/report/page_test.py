#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""page_test.py PROGRAM - opens the page of a report in headless Chromium, from disk: no complaint of
the browser, nothing asked of the network, every plot drawn, and every number on the page equal to
the one in report.json."""
import hashlib
import json
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import chromium

HERE = pathlib.Path(__file__).resolve().parent
VENDOR = HERE.parent.parent / "src" / "pages" / "vendor"

# Of each canvas: the number of different colours among its pixels, and the points of its datasets.
PLOTS = """[...document.querySelectorAll("canvas")].map(canvas => {
  const pixels = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
  const colours = new Set(new Uint32Array(pixels.buffer));
  const sets = Chart.getChart(canvas).data.datasets;
  return {id: canvas.id, label: canvas.getAttribute("aria-label"), colours: colours.size,
    points: sets.flatMap(set => set.data).filter(p => p && p.pointer).map(p => ({
      pointer: p.pointer, values: [p.x, p.y]}))};
})"""
CELLS = """[...document.querySelectorAll("td[data-pointer]")].map(
  cell => [cell.dataset.pointer, cell.textContent])"""


def resolve(document, pointer):
    for key in pointer.split("/")[1:]:
        document = None if document is None else document[int(key) if isinstance(document, list) else key]
    return document


def numbers_below(document, pointer=""):
    """The pointers of all numbers in the measured parts of a report."""
    if isinstance(document, dict):
        for key, value in document.items():
            yield from numbers_below(value, f"{pointer}/{key}")
    elif isinstance(document, list):
        for i, value in enumerate(document):
            yield from numbers_below(value, f"{pointer}/{i}")
    elif isinstance(document, (int, float)) and not isinstance(document, bool):
        yield pointer


def same(shown, value):
    """Whether a cell says the number, to its four digits."""
    if value is None:
        return shown == "–"
    return math.isclose(float(shown), value, rel_tol=6e-4, abs_tol=0)


# What is a name or a heading on the page, or drawn only.
NOT_IN_CELLS = re.compile(r"/(points|hull_vertices|halfspaces|faces|size|value|ways/\d+/bits)$")


def check_numbers(page, report):
    cells = page.evaluate(CELLS)
    assert cells, "the page has no tables"
    for pointer, shown in cells:
        assert same(shown, resolve(report, pointer)), f"{pointer}: {shown} for {resolve(report, pointer)}"
    shown_pointers = {pointer for pointer, _ in cells}
    measured = {key: report[key] for key in ("inputs", "spheres", "stability") if key in report}
    for pointer in numbers_below(measured):
        error = re.search(r"/(planes|cost_worst|cost_median|volume|outside)/(value|bits)$", pointer)
        if pointer in shown_pointers or (NOT_IN_CELLS.search(pointer) and not error):
            continue
        raise AssertionError(f"{pointer} is nowhere on the page")
    return len(cells)


def check_plots(page, report):
    plots = page.evaluate(PLOTS)
    figures = page.evaluate('document.querySelectorAll("figure").length')
    assert len(plots) == figures > 0, f"{len(plots)} plots in {figures} figures"
    for plot in plots:
        assert plot["colours"] > 5, f"{plot['id']} ({plot['label']}) is blank"
        assert plot["points"], f"{plot['id']} ({plot['label']}) shows no data"
        for point in plot["points"]:
            value = resolve(report, point["pointer"])
            near = [v for v in point["values"] if math.isclose(v, max(value, 1e-6), rel_tol=1e-12)
                    or math.isclose(v, max(value, 1), rel_tol=1e-12)]
            assert near, f"{plot['id']}: {point['pointer']} is {value}, drawn at {point['values']}"
    links = page.evaluate('[...document.querySelectorAll("nav a")].every(a => document.querySelector(a.hash))')
    assert links, "an entry of the contents leads nowhere"
    return len(plots)


# Of each plot: the names beside its marks with their boxes, the middles of the marks, the kind, and the ticks of x.
DRAWN = """[...document.querySelectorAll("canvas")].map(canvas => {
  const chart = Chart.getChart(canvas), box = chart.chartArea;
  return {id: canvas.id, names: chart.named, marks: chart.marks, kind: chart.config.type, area: [box.left, box.top, box.right, box.bottom],
    wanted: chart.data.datasets.filter(set => set.named).reduce((sum, set) => sum + set.data.length, 0),
    ticks: chart.scales.x.type === "linear" ? chart.scales.x.ticks.map(tick => String(tick.label)) : []};
})"""


def check_looks(page, is_wide):
    """Names lie on no mark and on no other name, and nearly none is left out; ticks are round; no bars on a scale
    without a zero; the page begins with what was found."""
    named = wanted = 0
    for plot in page.evaluate(DRAWN):
        assert plot["kind"] != "bar", plot["id"]
        boxes = [name["box"] for name in plot["names"]]
        for k, (left, top, right, bottom) in enumerate(boxes):
            assert plot["area"][0] <= left < right <= plot["area"][2] and plot["area"][1] <= top < bottom <= plot["area"][3], plot["id"]
            for other in boxes[:k]:
                assert not (left < other[2] and other[0] < right and top < other[3] and other[1] < bottom), (plot["id"], plot["names"])
            for x, y in plot["marks"]:
                assert not (left < x + 4 and x - 4 < right and top < y + 4 and y - 4 < bottom), (plot["id"], plot["names"][k])
        named, wanted = named + len(boxes), wanted + plot["wanted"]
        for label in plot["ticks"]:
            number = re.match(r"[\d.]+", label)
            assert number is None or len(number[0].replace(".", "").strip("0")) <= 2, (plot["id"], plot["ticks"])
    assert not is_wide or named >= 0.9 * wanted > 0, (named, wanted)
    first = page.evaluate('document.getElementById("conclusions").innerText')
    assert 1 <= len(re.findall(r"[.] |[.]$", first)) <= 3, first
    text = page.evaluate("document.body.innerText")
    assert "0% larger" not in text.replace("00% larger", "").replace("10% larger", ""), "equal is said as equal"
    exponents = re.findall(r"size\^\S+ \((\S+) to (\S+)\)", text)
    assert all(float(high) - float(low) <= 0.61 for low, high in exponents), exponents


def check_page(url, report, **how):
    page = chromium.Page(url, **how)
    try:
        check_looks(page, "width" not in how)
        plots, cells = check_plots(page, report), check_numbers(page, report)
        wide = page.evaluate("document.documentElement.scrollWidth > innerWidth + 1")
        assert not wide, "the page is wider than the window"
        assert not page.complaints, page.complaints
        return plots, cells
    finally:
        page.close()


def check_libraries():
    """The libraries inside of pages are those that their README names."""
    readme = (VENDOR / "README.md").read_text(encoding="utf-8")
    for library in VENDOR.glob("*.js"):
        total = hashlib.sha256(library.read_bytes()).hexdigest()
        assert library.name in readme and total in readme, f"the checksum of {library.name}"


# A prism over an L.
CORNERS = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]
L_PRISM = "".join(f"v {x} {y} {z}\n" for z in (0, 1) for x, y in CORNERS) + "f 6 5 4 3 2 1\nf 7 8 9 10 11 12\n" + "".join(
    f"f {k + 1} {(k + 1) % 6 + 1} {(k + 1) % 6 + 7} {k + 7}\n" for k in range(6))


def main():
    program = sys.argv[1]
    check_libraries()
    if chromium.is_missing():
        return chromium.SKIPPED
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        subprocess.run([program, "generate", "random-ball", "--points", "200", "-o", "a <b>.obj"], check=True)
        subprocess.run([program, "report", "a <b>.obj", "-o", "out", "--repetitions", "2", "--budget", "2",
                        "--family", "needle", "--family", "scaled-ball"], check=True, stdout=subprocess.DEVNULL)
        pathlib.Path("l.obj").write_text(L_PRISM, encoding="utf-8")
        subprocess.run([program, "report", "l.obj", "-o", "parts", "--repetitions", "2", "--sections", "parts"], check=True,
                       stdout=subprocess.DEVNULL)
        parts = json.loads(pathlib.Path("parts/report.json").read_text(encoding="utf-8"))
        assert len(parts["inputs"][0]["parts"]["points"]) == 12
        check_page(pathlib.Path("parts/report.html").resolve().as_uri(), parts)
        report = json.loads(pathlib.Path("out/report.json").read_text(encoding="utf-8"))
        url = pathlib.Path("out/report.html").resolve().as_uri()
        for how in ({}, {"media": [("prefers-color-scheme", "dark")]}, {"width": 400}):
            plots, cells = check_page(url, report, **how)
        print(f"{plots} plots, {cells} numbers in tables, in light, dark and narrow windows")
    return 0


if __name__ == "__main__":
    sys.exit(main())
