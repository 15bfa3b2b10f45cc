#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""page_test.py [SCREENSHOTS] - the page that ./dev web made, from disk, in headless Chromium: files are dropped on it,
verdicts read, long work cancelled, broken and large files refused in words; by keys alone, on a phone's width; and no
connection can be opened. The package without a bundler, too. Writes screenshots into the folder, if one is named."""
import base64
import functools
import hashlib
import http.server
import json
import pathlib
import re
import shutil
import sys
import tempfile
import threading
import time

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "report"))
import chromium  # noqa: E402

PAGE = HERE.parent.parent / "build" / "web" / "page" / "index.html"
CUBE = "".join(f"v {k & 1} {k >> 1 & 1} {k >> 2}\n" for k in range(8)) + (
    "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n")
FIRST = 'document.getElementById("first").textContent'
POLICY = 'document.querySelector("meta[http-equiv]").content'
# Drops files with such names and texts on the page, or on an element of it.
DROP = """((files, target = document.body) => {
  const data = new DataTransfer();
  for (const [name, text] of files) data.items.add(new File([text], name));
  target.dispatchEvent(new DragEvent("drop", {dataTransfer: data, bubbles: true, cancelable: true}));
})"""


def wait_for(page, condition, seconds=60, first=FIRST):
    end = time.monotonic() + seconds
    while not page.evaluate(condition):
        assert time.monotonic() < end, f"{condition} within {seconds} s; the page says: {page.evaluate(first)}"
        time.sleep(0.05)


def wait_for_sentence(page, pattern, seconds=60):
    wait_for(page, f"/{pattern}/.test({FIRST})", seconds)
    wait_for(page, 'document.getElementById("work").hidden', seconds)
    return page.evaluate(FIRST)


def drop(page, *files):
    page.evaluate(f"{DROP}({json.dumps(files)})")


def press(page, key, code, text="", shift=False):
    pressed = {"key": key, "code": key, "windowsVirtualKeyCode": code, "modifiers": 8 if shift else 0}
    page.call("Input.dispatchKeyEvent", type="keyDown", text=text, **pressed)
    page.call("Input.dispatchKeyEvent", type="keyUp", **pressed)


def tab_to(page, condition, back=False):
    """Tabs to the element e that meets a condition."""
    for _ in range(30):
        press(page, "Tab", 9, shift=back)
        if page.evaluate(f"(e => {condition})(document.activeElement)"):
            return
    raise AssertionError(f"no element in reach of the key Tab: {condition}")


def rows(page):
    return dict(page.evaluate('[...document.querySelectorAll("#numbers tr")].map(r => [...r.cells].map(c => c.textContent))'))


# `done` gets the next file that the page saves.
CATCH = """const make = URL.createObjectURL;
  URL.createObjectURL = blob => { blob.text().then(done); URL.createObjectURL = make; return "#"; };"""


def saved(page, name):
    """The file of a button under Save, as it would be downloaded."""
    return page.evaluate(f"""new Promise(done => {{
      {CATCH}
      [...document.querySelectorAll("#downloads button")].find(b => b.textContent === {json.dumps(name)}).click();
    }})""")


def check_hull(page):
    drop(page, ["cube.obj", CUBE])
    assert wait_for_sentence(page, "^cube.obj") == "cube.obj: a hull of 6 facets and 8 vertices"
    found = rows(page)
    assert (found["volume"], found["area"], found["mean width"], found["edges"]) == ("1", "6", "1.500000000", "12"), found
    mesh = saved(page, "cube-hull.obj")
    assert mesh.count("\nv ") + mesh.startswith("v ") == 8 and len(re.findall("^f ", mesh, re.M)) == 6, mesh
    # The policy holds in the frame of the picture, too: it names each script there.
    picture = page.evaluate('document.getElementById("picture").srcdoc')
    scripts = re.findall("<script>(.*?)</script>", picture, re.S)
    assert len(scripts) == 4, len(scripts)
    for script in scripts:
        digest = base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()
        assert f"'sha256-{digest}'" in page.evaluate(POLICY), script[:100]


def check_verdict(page, screenshots):
    drop(page, ["seven.xyz", "\n".join(line[2:] for line in CUBE.splitlines()[:7])])
    sentence = wait_for_sentence(page, "^seven.xyz is")
    assert sentence.startswith("seven.xyz is not the hull of cube.obj: "), sentence
    assert page.evaluate('document.getElementById("first").className') == "bad"
    size = page.evaluate('parseFloat(getComputedStyle(document.getElementById("first")).fontSize)')
    assert size >= 1.5 * page.evaluate("parseFloat(getComputedStyle(document.body).fontSize)")
    assert rows(page)["contains-input"].startswith("violated: "), rows(page)
    if screenshots:
        time.sleep(2)
        page.screenshot(screenshots / "verdict.png", whole=False)
    drop(page, ["same.obj", CUBE])
    assert wait_for_sentence(page, "^same.obj is") == "same.obj is the hull of cube.obj: every claim holds"


def check_enclosure(page, screenshots):
    page.evaluate('document.querySelector("[data-example=ball]").click()')
    wait_for_sentence(page, "^ball: a hull")
    page.evaluate("""(slider => { slider.value = 12; for (const type of ["input", "change"]) slider.dispatchEvent(new Event(type)); })(document.getElementById("faces"))""")
    assert re.fullmatch(r"12 halfspaces hold every point; the volume grows by [\d.]+%", wait_for_sentence(page, "^12 half"))
    assert len(json.loads(saved(page, "ball-12.json"))["halfspaces"]) == 12
    assert saved(page, "ball-12.proof").startswith("convexact-proof")
    if screenshots:
        time.sleep(2)
        page.screenshot(screenshots / "enclosure.png", whole=False)
    page.evaluate('document.querySelector("[data-example=wrong]").click()')
    wait_for_sentence(page, "^a hull that misses a point is not the hull of ball")


def check_parts(page, screenshots):
    page.evaluate('document.querySelector("[data-example=stairs]").click()')
    wait_for_sentence(page, "^stairs: a hull")
    page.evaluate('document.querySelector("#decompose button").click()')
    assert wait_for_sentence(page, "convex parts") == "3 convex parts hold stairs"
    if screenshots:
        time.sleep(2)
        page.screenshot(screenshots / "parts.png", whole=False)
    parts = saved(page, "stairs-parts.obj")
    assert len(re.findall("^o ", parts, re.M)) == 3
    # Dropped again they are judged as parts; without the last of them something is left out.
    drop(page, ["parts.obj", parts])
    assert wait_for_sentence(page, "^parts.obj") == "parts.obj is a cover by convex parts of stairs: every claim holds"
    assert page.evaluate('document.getElementById("picture").srcdoc.includes("stairs")')
    page.evaluate("""(asks => { asks.value = "enclosure"; asks.dispatchEvent(new Event("change")); })(document.getElementById("asks"))""")
    drop(page, ["parts.obj", parts])
    # As one mesh they have faces against each other.
    assert wait_for_sentence(page, "^parts.obj is not an enclosure of stairs: ").endswith("where a closed surface has 2")
    page.evaluate('document.querySelector("[data-example=stairs]").click()')
    wait_for_sentence(page, "^stairs: a hull")
    drop(page, ["two.obj", parts[:parts.rindex("o ")]])
    assert wait_for_sentence(page, "^two.obj").startswith("two.obj is not a cover by convex parts of stairs: ")
    assert rows(page)["covers-points"].startswith("violated: "), rows(page)
    drop(page, ["one.obj", parts[:parts.index("o ", 1)]])
    assert wait_for_sentence(page, "^one.obj").startswith("one.obj is not the hull of stairs: ")


def check_files_of_bytes(page):
    """GLB is made when it is asked for."""
    page.evaluate('document.querySelector("[data-example=ball]").click()')
    wait_for_sentence(page, "^ball: a hull")
    assert saved(page, "ball-hull.glb").startswith("glTF")
    wait_for(page, 'document.getElementById("work").hidden')


def check_lesson(page, screenshots):
    """It is in the frame, under an address of its own, and its script runs: that it may, the policy says."""
    page.evaluate('document.querySelector("[data-example=stairs]").click()')
    wait_for_sentence(page, "^stairs: a hull")
    page.evaluate('document.querySelector("#teach button").click()')
    assert wait_for_sentence(page, "^A lesson on").startswith("A lesson on stairs")
    lesson = saved(page, "stairs-lesson.html")
    assert "<title>stairs: polar duality, step by step</title>" in lesson
    script = re.findall("<script>(.*?)</script>", lesson, re.S)
    assert len(script) == 1
    digest = base64.b64encode(hashlib.sha256(script[0].encode()).digest()).decode()
    assert f"'sha256-{digest}'" in page.evaluate(POLICY)
    assert page.evaluate('document.getElementById("picture").src.startsWith("blob:") && !document.getElementById("picture").srcdoc')
    time.sleep(2)
    assert page.complaints == [], page.complaints
    if screenshots:
        page.screenshot(screenshots / "lesson.png", whole=False)


def in_the_lesson(page, expression):
    """The value of an expression in the frame of the picture, which is a process of its own; None while it is loaded."""
    try:
        frame, = [target for target in page.browser.call("Target.getTargets", filter=[{"type": "iframe"}])["targetInfos"]
                  if target["browserContextId"] == page.context]
        session = page.browser.call("Target.attachToTarget", targetId=frame["targetId"], flatten=True)["sessionId"]
        return page.browser.call("Runtime.evaluate", session, expression=expression, returnByValue=True)["result"].get("value")
    except (RuntimeError, ValueError):
        return None


def wait_for_lesson(page, condition, seconds=20):
    end = time.monotonic() + seconds
    while not in_the_lesson(page, condition):
        assert time.monotonic() < end, (condition, in_the_lesson(page, "location.href + document.body.innerText"))
        time.sleep(0.05)


def check_ready_lessons(page, screenshots):
    """Each opens, and its links lead to the others, at the step that they name."""
    for name in ("polygon", "cube", "pyramid", "needle", "bin"):
        page.evaluate(f'document.querySelector("[data-lesson={name}]").click()')
        assert wait_for_sentence(page, f"^A lesson on {name}").startswith(f"A lesson on {name}.obj")
        wait_for_lesson(page, f'document.title.startsWith("{name}.obj") && document.querySelector("h2").textContent !== ""')
    # The chain: the cube, the polygon at its step, the cube again, and the bin.
    for link, name, step in (("cube", "cube", ""), ("polygon.html#polar", "polygon", "#polar"), ("cube.html", "cube", ""), ("bin.html", "bin", "")):
        if link == "cube":
            page.evaluate('document.querySelector("[data-lesson=cube]").click()')
        else:
            if link == "cube.html":
                in_the_lesson(page, """document.querySelector('#contents a[href="#space"]').click()""")
            wait_for_lesson(page, f"""!!document.querySelector('a[href="{link}"]')""")
            in_the_lesson(page, f"""document.querySelector('a[href="{link}"]').click()""")
        wait_for_sentence(page, f"^A lesson on {name}")
        wait_for_lesson(page, f'document.title.startsWith("{name}.obj") && location.hash.startsWith("{step}")')
    assert saved(page, "bin.html").startswith("<!DOCTYPE html>")
    # Only lessons are made on a frame's request.
    page.evaluate('postMessage({lesson: "cube.html"}, "*")')
    in_the_lesson(page, 'parent.postMessage({lesson: "toString.html"}, "*"); parent.postMessage({lesson: {}}, "*")')
    time.sleep(0.5)
    assert page.evaluate(FIRST).startswith("A lesson on bin.obj"), page.evaluate(FIRST)
    assert page.complaints == [], page.complaints
    if screenshots:
        page.screenshot(screenshots / "bin.png", whole=False)


def check_faults(page):
    drop(page, ["broken.obj", "v 0 0 0\nv 1 2 x\n"])
    assert wait_for_sentence(page, "^broken") == "broken.obj:2: expected a number, found 'x'"
    assert page.evaluate('document.getElementById("first").className') == "bad"
    drop(page, ["flat.xyz", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n"], ["any.xyz", "0 0 0\n"])
    wait_for_sentence(page, "(flat|plane|volume)")


def check_cancel(page):
    """Points on a paraboloid, all of them extreme, for the exact hull: seconds of work, which a click ends at once."""
    page.evaluate("""(() => {
      let text = "";
      for (let x = -150; x < 150; ++x) for (let y = -150; y < 150; ++y) text += `${x} ${y} ${x * x + y * y}\\n`;
      (%s)([["large.xyz", text], ["any.xyz", "0 0 0"]]);
    })()""" % DROP)
    wait_for(page, '!document.getElementById("work").hidden')
    time.sleep(1)
    start = time.monotonic()
    page.evaluate('document.getElementById("cancel").click()')
    assert wait_for_sentence(page, "^cancelled") == "cancelled"
    assert time.monotonic() - start < 5
    wait_for(page, 'document.getElementById("work").hidden')


def check_large(page):
    """100 MB of text that is a file of nothing: words. 20 MB of points in a cube and its corners: its hull, or words. The page
    goes on after both."""
    page.evaluate("""(%s)([["large.obj", "x".repeat(100e6)]], document.getElementById("shape"))""" % DROP)
    wait_for_sentence(page, "large.obj", 120)
    page.evaluate("""(() => {
      let at = 1;
      const random = () => ((at = at * 48271 %% 2147483647) / 2147483647).toFixed(9), lines = [];
      for (let k = 0; k < 8; ++k) lines.push(`${k & 1} ${k >> 1 & 1} ${k >> 2}\\n`);
      while (lines.length < 10000) lines.push(`${random()} ${random()} ${random()}\\n`);
      const text = lines.join("");
      (%s)([["cloud.xyz", text.repeat(Math.ceil(20e6 / text.length))]], document.getElementById("shape"));
    })()""" % DROP)
    sentence = wait_for_sentence(page, "(cloud.xyz|out of memory)", 180)
    is_refused = page.evaluate('document.getElementById("first").className') == "bad"
    assert is_refused or sentence == "cloud.xyz: a hull of 6 facets and 8 vertices", sentence
    page.evaluate('document.querySelector("[data-example=ball]").click()')
    wait_for_sentence(page, "^ball: a hull")


def check_keys():
    """By keys alone: an example, the slider, a file to save, and back to a verdict."""
    page = chromium.Page(PAGE.as_uri())
    tab_to(page, 'e.dataset.example === "ball"')
    press(page, "Enter", 13, "\r")
    wait_for_sentence(page, "^ball: a hull")
    tab_to(page, 'e.id === "faces"')
    press(page, "ArrowLeft", 37)
    wait_for_sentence(page, "^17 halfspaces hold every point")
    tab_to(page, 'e.textContent === "ball-17.json"')
    page.evaluate("{ let done = text => { globalThis.caught = text; }; %s }" % CATCH)
    press(page, "Enter", 13, "\r")
    wait_for(page, '"caught" in globalThis')
    assert len(json.loads(page.evaluate("caught"))["halfspaces"]) == 17
    tab_to(page, 'e.dataset.example === "wrong"', back=True)
    press(page, "Enter", 13, "\r")
    wait_for_sentence(page, "^a hull that misses a point is not the hull of ball")
    assert page.complaints == [], page.complaints
    page.close()


def check_phone(screenshots):
    page = chromium.Page(PAGE.as_uri(), width=375, height=700)
    page.evaluate('document.querySelector("[data-example=stairs]").click()')
    wait_for_sentence(page, "^stairs: a hull")
    assert page.evaluate("document.documentElement.scrollWidth") <= 375
    if screenshots:
        page.evaluate('document.getElementById("picture").scrollIntoView()')
        time.sleep(2)
        page.screenshot(screenshots / "phone.png", whole=False)
    page.close()


def check_package():
    """The package in a browser, without a bundler: its example, from a server on this machine."""
    package = PAGE.parent.parent / "package"
    with tempfile.TemporaryDirectory() as folder:
        place = pathlib.Path(folder)
        (place / "node_modules").mkdir()
        (place / "node_modules" / "convexact").symlink_to(package)
        shutil.copy(package / "examples" / "page.html", place)
        server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(QuietHandler, directory=folder))
        threading.Thread(target=server.serve_forever, daemon=True).start()
        page = chromium.Page(f"http://127.0.0.1:{server.server_port}/page.html")
        wait_for(page, 'document.getElementById("answer").textContent !== "…"', first="document.body.textContent")
        assert page.evaluate('document.getElementById("answer").textContent') == "4 facets, volume 0.1666666667"
        page.close()
        server.shutdown()


class QuietHandler(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


def check_no_connection(page):
    policy = page.evaluate(POLICY)
    assert policy.startswith("default-src 'none'") and "//" not in policy and "*" not in policy, policy
    assert page.evaluate('fetch("https://example.org/").then(() => "sent", () => "refused")') == "refused"
    assert any("Content Security Policy" in text for text in page.complaints), page.complaints


def main():
    if not PAGE.is_file():
        print("skipped: no build/web, ./dev web makes it")
        return chromium.SKIPPED
    if chromium.is_missing():
        return chromium.SKIPPED
    screenshots = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else None
    page = chromium.Page(PAGE.as_uri(), graphics=chromium.SOFTWARE_WEBGL if screenshots else chromium.NO_WEBGL)
    check_hull(page)
    check_verdict(page, screenshots)
    check_enclosure(page, screenshots)
    check_parts(page, screenshots)
    check_files_of_bytes(page)
    check_lesson(page, screenshots)
    check_ready_lessons(page, screenshots)
    assert page.complaints == [], page.complaints
    check_faults(page)
    check_cancel(page)
    check_large(page)
    check_keys()
    check_phone(screenshots)
    check_no_connection(page)
    check_package()
    print("the page: hull, verdict, enclosure, parts, GLB, lessons and their links, faults, cancel, files of 100 and 20 MB, keys, a phone; no connection; the package")
    return 0


if __name__ == "__main__":
    sys.exit(main())
