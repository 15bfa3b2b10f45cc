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


def license_texts(out):
    """Texts of licenses by the name of what is under them, as far as this machine has them: the LGPL's always."""
    texts = {"GPL-3.0": out / "gmp" / "COPYINGv3", "LGPL-3.0": out / "gmp" / "COPYING.LESSERv3"}
    for package in ("libboost-dev", "libeigen3-dev", "libfmt-dev", "libgmp-dev", "libmpfr-dev", "libpugixml-dev", "nlohmann-json3-dev"):
        texts[package] = pathlib.Path("/usr/share/doc") / package / "copyright"
    emcc = shutil.which("emcc")
    emscripten = out / "debian" / "usr" / "share" / "emscripten" if (out / "debian").is_dir() or not emcc else pathlib.Path(emcc).resolve().parent
    texts["musl"] = emscripten / "system" / "lib" / "libc" / "musl" / "COPYRIGHT"
    texts["libcxx-credits"] = emscripten / "system" / "lib" / "libcxx" / "CREDITS.TXT"
    return {name: path.read_text() for name, path in texts.items() if path.is_file() or name.endswith("GPL-3.0")}


def make_package(out):
    package = out / "package"
    shutil.rmtree(package, ignore_errors=True)
    shutil.copytree(WEB / "package", package)
    shutil.copy(out / "module" / "web" / "convexact.wasm", package)
    shutil.copy(ROOT / "LICENSE", package)
    (package / "vectors.json").write_text(json.dumps(vectors(), separators=(",", ":")))
    notice = (package / "NOTICE.md").read_text()
    (package / "NOTICE.md").write_text(notice.replace("@SOURCES@", "\n".join(f"- `{name}`" for name in versions(out))))
    (package / "licenses").mkdir()
    for name, text in license_texts(out).items():
        (package / "licenses" / f"{name}.txt").write_text(text)
    subprocess.run(["npm", "pack", "--silent", "--pack-destination", str(out)], cwd=package, check=True, stdout=sys.stderr)


def without_modules(text):
    """A module as part of one script: its imports are defined before it."""
    text = re.sub(r"^import .*?;\n", "", text, flags=re.M)
    text = re.sub(r"^export \{.*?;\n", "", text, flags=re.M)
    return re.sub(r"^export (default )?", "", text, flags=re.M)


def hash_of(script):
    return "'sha256-" + base64.b64encode(hashlib.sha256(script.encode()).digest()).decode() + "'"


def scripts_in_the_frame(package):
    """The scripts on the pages that the module makes, which are shown in a frame of the page: pictures and lessons. They
    are the same for all shapes, so those of a few tell."""
    pages = json.loads(subprocess.run(["node", WEB / "pages_of_the_module.mjs", package], check=True, capture_output=True).stdout)
    return sorted({script for page in pages for script in re.findall(r"<script>(.*?)</script>", page, re.S)})


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
        "HASHES": " ".join(map(hash_of, [script, *scripts_in_the_frame(out / "package")])),
        # JSON spells a '<' of a text that way, too.
        "LESSONS": json.dumps({path.stem: path.read_text() for path in sorted((ROOT / "docs" / "lessons").glob("*.obj"))}).replace("<", "\\u003c"),
    }
    page = re.sub(r"@([A-Z]+)@", lambda mark: texts[mark[1]], (source / "index.html").read_text())
    (out / "page").mkdir(exist_ok=True)
    (out / "page" / "index.html").write_text(page)
    shutil.copy(package / "NOTICE.md", out / "page")


if __name__ == "__main__":
    make_package(pathlib.Path(sys.argv[1]))
    make_page(pathlib.Path(sys.argv[1]))
