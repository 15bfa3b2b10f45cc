# SPDX-License-Identifier: MIT
"""package.py FOLDER - puts the package and the page together: FOLDER/package and its .tgz, FOLDER/page/index.html."""
import base64
import gzip
import hashlib
import json
import pathlib
import re
import shutil
import subprocess
import sys

WEB = pathlib.Path(__file__).resolve().parent
ROOT = WEB.parent


def vectors():
    """The inputs of all conformance vectors that ask for a hull of points in doubles, which every caller can hold."""
    found = []
    for path in sorted((ROOT / "tests" / "vectors").glob("*.json")):
        for vector in json.loads(path.read_text())["vectors"]:
            if vector["question"].get("ask") != "hull" or "points" not in vector["input"]:
                continue
            points = [as_double(x) for row in vector["input"]["points"] for x in row]
            if None not in points:
                found.append({"id": vector["id"], "title": vector["title"], "level": vector["level"], "points": points})
    return found


def as_double(spelled):
    """A coordinate as vectors spell it; None for a number that is no double."""
    if isinstance(spelled, (int, float)):
        return spelled
    return float.fromhex(spelled) if "x" in spelled else float(spelled) if "/" not in spelled else None


def versions(out):
    """What is linked into the module, by the names of its sources."""
    return [path.stem for path in sorted((out / "sources").glob("*.dsc"))]


def make_package(out):
    package = out / "package"
    shutil.rmtree(package, ignore_errors=True)
    shutil.copytree(WEB / "package", package)
    shutil.copy(out / "module" / "web" / "convexact.wasm", package)
    shutil.copy(ROOT / "LICENSE", package)
    (package / "vectors.json").write_text(json.dumps(vectors(), separators=(",", ":")))
    notice = (package / "NOTICE.md").read_text()
    (package / "NOTICE.md").write_text(notice.replace("@SOURCES@", "\n".join(f"- `{name}`" for name in versions(out))))
    subprocess.run(["npm", "pack", "--silent", "--pack-destination", str(out)], cwd=package, check=True, stdout=sys.stderr)


def without_modules(text):
    """A module as part of one script: its imports are defined before it."""
    text = re.sub(r"^import .*?;\n", "", text, flags=re.M)
    text = re.sub(r"^export \{.*?;\n", "", text, flags=re.M)
    return re.sub(r"^export (default )?", "", text, flags=re.M)


def hash_of(script):
    return "'sha256-" + base64.b64encode(hashlib.sha256(script.encode()).digest()).decode() + "'"


def scripts_of_pictures():
    """The scripts on the pages that the module makes, which are shown in a frame of the page: src/pages/page/viewer.html."""
    pages = ROOT / "src" / "pages"
    names = {"FACETS": "page/facets.js", "LIBRARY": "vendor/three.min.js", "SHAPES": "page/shapes.js", "SCRIPT": "page/viewer.js"}
    for script in re.findall(r"<script>(.*?)</script>", (pages / "page" / "viewer.html").read_text(), re.S):
        yield re.sub(r"@(\w+)@", lambda mark: (pages / names[mark[1]]).read_text(), script)


def make_page(out):
    """One file that opens from disk: a page there may load neither modules nor workers, so it holds them."""
    source, package = WEB / "page", WEB / "package"
    worker = "".join(without_modules((package / name).read_text()) for name in ("module.js", "requests.js", "serve.js", "worker.js"))
    script = "".join(without_modules((package / name).read_text()) for name in ("requests.js", "conform.js", "client.js"))
    script += (source / "page.js").read_text()
    style = (source / "page.css").read_text()
    wasm = (out / "module" / "web" / "convexact.wasm").read_bytes()
    texts = {
        "STYLE": style,
        "WASM": base64.b64encode(gzip.compress(wasm, 9, mtime=0)).decode(),
        "WORKER": worker.replace("</", "<\\/"),
        "SCRIPT": script,
        "HASHES": " ".join(map(hash_of, [script, *scripts_of_pictures()])),
    }
    page = re.sub(r"@([A-Z]+)@", lambda mark: texts[mark[1]], (source / "index.html").read_text())
    (out / "page").mkdir(exist_ok=True)
    (out / "page" / "index.html").write_text(page)
    shutil.copy(package / "NOTICE.md", out / "page")


if __name__ == "__main__":
    make_package(pathlib.Path(sys.argv[1]))
    make_page(pathlib.Path(sys.argv[1]))
