#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""bundle_test.py - the example for Vite: installed from the package's file as users do it, bundled, and opened in headless
Chromium; and a program of TypeScript against the package's types. Skipped where npm cannot bring Vite and TypeScript."""
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
TOOLS = {"vite": "6.4.6", "typescript": "5.9.3"}


def npm(*arguments):
    return subprocess.run(["npm", *arguments, "--no-audit", "--no-fund", "--loglevel=error"], cwd=PLACE, timeout=300).returncode == 0


def install():
    """The tools once, the package anew each time. Whether there are tools."""
    PLACE.mkdir(exist_ok=True)
    if not (PLACE / "node_modules" / "vite").is_dir() or not (PLACE / "node_modules" / "typescript").is_dir():
        (PLACE / "package.json").write_text(json.dumps({"private": True, "type": "module", "devDependencies": TOOLS}))
        if not npm("install"):
            return False
    packed, = WEB.glob("convexact-*.tgz")
    shutil.rmtree(PLACE / "node_modules" / "convexact", ignore_errors=True)
    assert npm("install", "--offline", "--no-save", str(packed)), "npm install FILE"
    return True


def run_tool(name, *arguments):
    ran = subprocess.run(["node", PLACE / "node_modules" / name, *arguments], cwd=PLACE, capture_output=True, text=True, timeout=300)
    assert ran.returncode == 0, ran.stdout + ran.stderr


def check_types():
    shutil.copy(HERE / "types.ts", PLACE)
    run_tool("typescript/bin/tsc", "--noEmit", "--strict", "--target", "es2022", "--module", "nodenext", "--lib", "es2022", "types.ts")


def check_bundle():
    example = PLACE / "node_modules" / "convexact" / "examples" / "vite"
    for path in example.iterdir():
        shutil.copy(path, PLACE)
    shutil.rmtree(PLACE / "dist", ignore_errors=True)
    run_tool("vite/bin/vite.js", "build")
    assert [path for path in (PLACE / "dist").rglob("*.wasm")], "the module is in the bundle"


def check_page():
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(QuietHandler, directory=PLACE / "dist"))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    page = chromium.Page(f"http://127.0.0.1:{server.server_port}/index.html")
    answer = 'document.getElementById("answer").textContent'
    wait_for(page, f'{answer} !== "…"', first="document.body.textContent")
    assert page.evaluate(answer) == "4 facets, volume 0.1666666667; three points: no-interior", page.evaluate(answer)
    page.close()
    server.shutdown()


def main():
    if not (WEB / "package" / "convexact.wasm").is_file():
        print("skipped: no build/web, ./dev web makes it")
        return chromium.SKIPPED
    if not shutil.which("npm") or not install():
        print("skipped: npm cannot bring Vite and TypeScript")
        return chromium.SKIPPED
    check_types()
    check_bundle()
    if not chromium.is_missing():
        check_page()
    print("the package in TypeScript and in a bundle of Vite")
    return 0


if __name__ == "__main__":
    sys.exit(main())
