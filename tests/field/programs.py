# SPDX-License-Identifier: MIT
"""The programs of ./dev field: how each is called, what it computes with, and whether it is here."""
import os
import shlex
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).parent
ROOT = HERE.parent.parent
BUILD = ROOT / "build" / "field"


@dataclass
class Program:
    """`command` has the words {input}, {output} and, of a simplifier, {faces}."""
    name: str
    command: list
    numbers: str = "binary64"
    writes: str = "obj"
    missing: str = ""  # why it cannot run here

    def is_ours(self):
        return self.name.startswith("convexact")

    def words(self, source, target, faces):
        return [word.format(input=source, output=target, faces=faces) for word in self.command]


NPM = {"three-hull": "binary64", "three-geometry": "binary32", "quickhull3d": "binary64",
       "quickhull3d-polygons": "binary64", "jolt": "binary32", "rapier": "binary32", "manifold": "binary32",
       "physx": "binary32", "physx-shifting": "binary32", "vhacd": "binary64"}
BUILT = {"bullet-hull": ("bullet", "hull", "binary32"), "bullet-shape": ("bullet", "shape", "binary32"),
         "bullet64-hull": ("bullet64", "hull", "binary64"), "bullet64-shape": ("bullet64", "shape", "binary64"),
         "cgal-doubles": ("cgal", "doubles", "binary64"), "cgal-predicates": ("cgal", "exact-predicates", "binary64")}
QHULL = {"qhull": "", "qhull-triangles": "Qt", "qhull-no-merging": "=Q0,Pp", "qhull-own-points": "=Qt"}


def all_programs(convexact):
    programs = [Program("convexact-hull", [convexact, "hull", "{input}", "-o", "{output}"]),
                Program("convexact", [convexact, "simplify", "{input}", "--faces", "{faces}", "-o", "{output}"]),
                Program("convexact-single", [convexact, "simplify", "{input}", "--faces", "{faces}", "--precision",
                                             "32", "-o", "{output}"]),
                Program("convexact-planes", [convexact, "simplify", "{input}", "--faces", "{faces}", "-o", "{output}"],
                        writes="json")]
    node = shutil.which("node")
    for name, numbers in NPM.items():
        there = node and (BUILD / "node_modules").exists()
        programs.append(Program(name, ["node", str(BUILD / "programs.mjs"), name, "{input}", "{output}"], numbers,
                                missing="" if there else "npm packages are not installed"))
    for name, (binary, mode, numbers) in BUILT.items():
        path = BUILD / "bin" / binary
        programs.append(Program(name, [str(path), mode, "{input}", "{output}"], numbers,
                                missing="" if path.exists() else f"build/field/bin/{binary} is not built"))
    for name, options in QHULL.items():
        programs.append(Program(name, ["python3", str(HERE / "qhull.py"), options, "{input}", "{output}"],
                                missing="" if shutil.which("qhull") else "qhull-bin is not installed"))
    command = os.environ.get("CONVEXACT_FIELD_JACOBSON", "")
    programs.append(Program("jacobson", shlex.split(command), missing="" if command else
                            "the paper's own program is not in any package registry; set CONVEXACT_FIELD_JACOBSON "
                            "to its command with {input}, {faces} and {output}"))
    return programs


def run_program(program, source, target, faces, seconds):
    """How it ended: 'output', 'refused N', 'no file', 'signal N' or 'time'."""
    target.unlink(missing_ok=True)
    try:
        done = subprocess.run(program.words(source, target, faces), capture_output=True, timeout=seconds, check=False)
    except subprocess.TimeoutExpired:
        return "time"
    except OSError as fault:
        return f"not started: {fault}"
    if done.returncode < 0:
        return f"signal {-done.returncode}"
    if done.returncode:
        return f"refused {done.returncode}"
    return "output" if target.exists() else "no file"
