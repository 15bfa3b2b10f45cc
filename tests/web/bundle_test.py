#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""bundle_test.py - the package's file as a project takes it up: installed by npm, judged by publint and by Are The Types
Wrong, compiled against by TypeScript, bundled by Vite, webpack and esbuild as its example says, and opened in headless
Chromium under a policy that allows this origin alone; and without a bundler, from another origin. Skipped where npm
cannot bring the tools."""
import functools
import http.server
import json
import pathlib
import shutil
import subprocess
import sys
import threading

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "report")]
import chromium  # noqa: E402
from page_test import QuietHandler, wait_for  # noqa: E402

WEB = HERE.parent.parent / "build" / "web"
PLACE = WEB / "bundle"
TOOLS = {"vite": "6.4.6", "webpack": "5.113.0", "webpack-cli": "7.3.1", "esbuild": "0.28.2", "typescript": "5.9.3", "publint": "0.3.25",
         "@arethetypeswrong/cli": "0.18.5"}
# What a page with the package has to allow, and no more.
POLICY = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; connect-src 'self'"


def npm(*arguments):
    return subprocess.run(["npm", *arguments, "--no-audit", "--no-fund", "--loglevel=error"], cwd=PLACE, timeout=300).returncode == 0


def install(packed):
    """The tools once, the package anew each time. Whether there are tools."""
    wanted = json.dumps({"private": True, "type": "module", "devDependencies": TOOLS})
    if not (PLACE / "complete").is_file() or (PLACE / "complete").read_text() != wanted:
        PLACE.mkdir(exist_ok=True)
        (PLACE / "package.json").write_text(wanted)
        if not npm("install"):
            return False
        (PLACE / "complete").write_text(wanted)
    shutil.rmtree(PLACE / "node_modules" / "convexact", ignore_errors=True)
    assert npm("install", "--offline", "--no-save", str(packed)), "npm install FILE"
    return True


def run(*command):
    ran = subprocess.run(command, cwd=PLACE, capture_output=True, text=True, timeout=300)
    assert ran.returncode == 0, f"{command}: {ran.stdout}{ran.stderr}"


def check_package(packed):
    run("npx", "publint", str(packed), "--strict")
    # It is an ES module, which require() takes in Node 20.19 and newer, and import() everywhere.
    run("npx", "attw", str(packed), "--ignore-rules", "cjs-resolves-to-esm", "--exclude-entrypoints", "convexact.wasm")
    (PLACE / "required.cjs").write_text("""
      const {default: convexact, toNumber} = require("convexact");
      convexact().then(cx => cx.hull([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], {exact_values: true}))
        .then(hull => { if (toNumber(hull.volume.exact) !== 1 / 6) process.exit(1); });""")
    run("node", "required.cjs")


def check_types():
    shutil.copy(HERE / "types.ts", PLACE)
    for module in (["nodenext"], ["esnext", "--moduleResolution", "bundler"]):
        run("npx", "tsc", "--noEmit", "--strict", "--target", "es2022", "--lib", "es2022", "--module", *module, "types.ts")


def bundles():
    """Bundles the example by the commands on its top; the folders."""
    example = PLACE / "node_modules" / "convexact" / "examples" / "bundle"
    for path in example.iterdir():
        shutil.copy(path, PLACE)
    comment = (example / "main.js").read_text().replace(" \\\n//", "")
    for name in ("Vite", "webpack", "esbuild"):
        command = next(line for line in comment.splitlines() if line.startswith(f"//   {name}")).split(None, 2)[2]
        shutil.rmtree(PLACE / "dist", ignore_errors=True)
        run("sh", "-c", command)
        assert len(list((PLACE / "dist").rglob("*.wasm"))) == 1, f"{name}: the module is in the bundle, once"
        shutil.rmtree(PLACE / f"dist-{name}", ignore_errors=True)
        (PLACE / "dist").rename(PLACE / f"dist-{name}")
        yield name, PLACE / f"dist-{name}"


class StrictHandler(QuietHandler):
    def end_headers(self):
        self.send_header("Content-Security-Policy", POLICY)
        super().end_headers()


class OpenHandler(QuietHandler):
    """As hosts of packages do: any page may load what it has."""

    def end_headers(self):
        self.send_header("Access-Control-Allow-Origin", "*")
        super().end_headers()


def server_of(folder, handler):
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(handler, directory=folder))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    return server


def check_page(folder, wanted, handler=StrictHandler):
    server = server_of(folder, handler)
    page = chromium.Page(f"http://127.0.0.1:{server.server_port}/index.html")
    answer = 'document.getElementById("answer").textContent'
    wait_for(page, f'{answer} !== "…"', first="document.body.textContent + performance.getEntriesByType('resource').map(e => e.name)")
    assert page.evaluate(answer) == wanted, page.evaluate(answer)
    assert page.evaluate("crossOriginIsolated") is False  # so it needs no memory that threads share
    wrong = [text for text in page.complaints if not text.startswith("asks the network for http://127.0.0.1:")]
    assert wrong == [], wrong
    page.close()
    server.shutdown()


def check_other_origin():
    package = server_of(PLACE / "node_modules" / "convexact", OpenHandler)
    folder = PLACE / "other-origin"
    folder.mkdir(exist_ok=True)
    (folder / "favicon.ico").touch()  # which a browser asks for
    text = (PLACE / "node_modules" / "convexact" / "examples" / "page.html").read_text()
    (folder / "index.html").write_text(text.replace("./node_modules/convexact/", f"http://127.0.0.1:{package.server_port}/"))
    check_page(folder, "4 facets, volume 0.1666666667", QuietHandler)
    package.shutdown()


def main():
    if not (WEB / "package" / "convexact.wasm").is_file():
        print("skipped: no build/web, ./dev web makes it")
        return chromium.SKIPPED
    packed, = WEB.glob("convexact-*.tgz")
    if not shutil.which("npm") or not install(packed):
        print(f"skipped: npm cannot bring {', '.join(TOOLS)}")
        return chromium.SKIPPED
    check_package(packed)
    check_types()
    for name, folder in bundles():
        if not chromium.is_missing():
            check_page(folder, "4 facets, volume 0.1666666667; three points: no-interior; tetrahedra right: true")
        print(f"a bundle of {name}")
    if not chromium.is_missing():
        check_other_origin()
    print("the package: publint, Are The Types Wrong, TypeScript, require(), from another origin")
    return 0


if __name__ == "__main__":
    sys.exit(main())
