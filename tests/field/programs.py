# SPDX-License-Identifier: MIT
"""The programs of ./dev field: how each is called, what it computes with, what it promises, and whether it is here.

`programs.py install [NAME]` brings packages of the Python index, `programs.py kind NAME` says what a program writes (hulls or
decompositions) and where it is from.

To add a program, write an adapter that reads an OBJ and writes one: for npm a function in programs.mjs, for Python one in
python_hulls.py, python_parts.py or python_boxes.py, for Rust one in crates.rs, for C++ a file like bullet.cpp. It writes the
points that a face uses, and no others. Then add a line to the tables below, and the package to package.json, Cargo.toml or
`prepare_debian` in dev.
"""
import json
import re
import shutil
import subprocess
import sys
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import warm
from memory import digest_of

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
    promise: str = ""  # by its documentation: how far a point may be outside, as for --tolerance
    version: str = ""
    origin: str = "here"  # npm, debian, python or crates

    def is_ours(self):
        return self.name.startswith("convexact")

    def words(self, source, target, faces):
        return [word.format(input=source, output=target, faces=faces) for word in self.command]

    def identity(self):
        """What an output depends on beside the input: the version, the words, and the scripts among them with what they import."""
        scripts = [Path(word) for word in self.command if word.endswith((".py", ".mjs"))]
        sources = [path.read_bytes() for script in scripts for path in (script, HERE / "adapter.py") if path.exists()]
        return digest_of(self.version, [word.replace(str(ROOT), "") for word in self.command], *sources)


# Packages of the Python index, in an environment; those of one package beside its name.
PYTHON = {"scipy": "1.17.1", "trimesh": "5.2.0", "open3d": "0.20.0", "manifold3d": "3.5.4", "coal": "3.0.3", "pymeshlab": "2025.7.post1",
          "mujoco": "4.0.0", "pchs": "0.1.0", "libigl": "2.6.3", "drake": "1.51.1", "coacd": "1.0.14", "miniacd": "0.1.5",
          "vhacdx": "0.1.1", "pybullet": "3.2.7"}
# What a package needs for some inputs and does not bring itself.
PYTHON_NEEDS = {"trimesh": {"networkx": "3.6.1"}}
PYTHON_PARTS = ("coacd", "miniacd", "vhacdx", "pybullet")
PYTHON_HULLS = {**{name: name for name in PYTHON if name not in PYTHON_PARTS}, "mujoco-32": "mujoco"}
# The five with the strongest claim to be used most: what programs in Python call for a hull, what tools for meshes, scans and
# solids bring with them, and what a simulator makes of every mesh that it loads.
MOST_USED = ("scipy", "trimesh", "open3d", "mujoco", "manifold3d")
# Their boxes: halfspaces instead of faces.
PYTHON_BOXES = {"trimesh-box": "trimesh", "open3d-box": "open3d", "open3d-least-box": "open3d"}
PYTHON_NUMBERS = {"mujoco": "binary32", "mujoco-32": "binary32"}
ENVIRONMENT = ROOT / "build" / "peers" / "bin" / "python"

NPM = {"three-hull": "binary64", "three-geometry": "binary32", "quickhull3d": "binary64",
       "quickhull3d-polygons": "binary64", "jolt": "binary32", "rapier": "binary32", "manifold": "binary32",
       "physx": "binary32", "physx-shifting": "binary32", "vhacd": "binary64", "ammo": "binary32"}
# Those that are asked for a number of vertices.
NPM_LIMITED = {"physx-limit": "binary32"}
NPM_PARTS = {"vhacd-16": ("binary64", "vhacd-js"), "vhacd-24": ("binary64", "vhacd-js"), "vhacd-parts": ("binary64", "vhacd-js"),
             "rapier-parts": ("binary32", "@dimforge/rapier3d-compat")}
# Crates, in the versions of crates/Cargo.toml.
CRATES = {"parry": ("parry3d", "binary32"), "parry64": ("parry3d-f64", "binary64"), "chull": ("chull", "binary64"),
          "chull-fast": ("chull", "binary64")}
CRATES_PARTS = {"parry-parts": ("parry3d", "binary32"), "parry-voxels": ("parry3d", "binary32")}
BUILT_PARTS = {"hacd": "binary64", "hacd-full": "binary64", "ratcliff": "binary32"}
BUILT = {"bullet-hull": ("bullet", "hull", "binary32"), "bullet-shape": ("bullet", "shape", "binary32"),
         "bullet64-hull": ("bullet64", "hull", "binary64"), "bullet64-shape": ("bullet64", "shape", "binary64"),
         "cgal-doubles": ("cgal", "doubles", "binary64"), "cgal-predicates": ("cgal", "exact-predicates", "binary64"), "cgal-box": ("cgal", "box", "binary64")}
# The engine in share/convexact/profiles.json whose tolerance a program promises. btShapeHull and V-HACD promise none.
PROFILES = {"jolt": "jolt", "physx": "physx", "physx-shifting": "physx", "physx-limit": "physx", "bullet-hull": "bullet", "bullet64-hull": "bullet",
            "ammo": "bullet", "manifold": "manifold", "qhull": "qhull", "qhull-triangles": "qhull",
            "quickhull3d": "quickhull3d", "quickhull3d-polygons": "quickhull3d", "rapier": "rapier",
            "three-hull": "threejs", "three-geometry": "threejs", "scipy": "qhull", "trimesh": "qhull", "open3d": "qhull",
            "coal": "qhull", "pymeshlab": "qhull", "drake": "qhull", "parry": "rapier"}
PACKAGES = {"three-hull": "three", "three-geometry": "three", "quickhull3d-polygons": "quickhull3d", "jolt": "jolt-physics",
            "rapier": "@dimforge/rapier3d-compat", "manifold": "manifold-3d", "physx": "physx-js-webidl",
            "physx-shifting": "physx-js-webidl", "physx-limit": "physx-js-webidl", "vhacd": "vhacd-js", "ammo": "ammojs-typed"}
# What people use and what cannot be judged here, with the reason.
NOT_HERE = {"python-fcl": "0.7.0.11 takes a hull (fcl.Convex) and computes none",
            "pybullet's hull": "3.2.7 returns its corners and no faces; the library under it is bullet-hull",
            "ovphysx": "0.3.7 cooks hulls of a USD stage, and no call returns them; the engine under it is physx",
            "Jolt's limit of vertices": "it is a constant, 256 (cMaxPointsInHull), and no setting",
            "geogram": "0.0.7 of the Python index binds its Voronoi diagrams only, and Debian 12 has no package",
            "cuacd": "0.1.0 needs the driver of a GPU (libcuda.so.1)",
            "CGAL's convex_decomposition_3": "the export of version 5.5 is wrong"}
QHULL = {"qhull": "", "qhull-triangles": "Qt", "qhull-no-merging": "=Q0,Pp", "qhull-own-points": "=Qt"}


def npm_version(package):
    """The name and the version of an npm package, as installed."""
    path = BUILD / "node_modules" / package / "package.json"
    return f"{package} {json.loads(path.read_text())['version']}" if path.exists() else ""


@lru_cache
def python_versions():
    """Of the packages in the environment, as far as they are there."""
    script = ("import importlib.metadata as m, json, sys\n"
              "print(json.dumps({d.name: d.version for d in m.distributions() if d.name in sys.argv[1:]}))")
    try:
        done = subprocess.run([ENVIRONMENT, "-c", script, *PYTHON], capture_output=True, text=True, check=False)
    except OSError:
        return {}
    return json.loads(done.stdout) if done.returncode == 0 else {}


@lru_cache
def debian_version(package):
    try:
        done = subprocess.run(["dpkg-query", "-W", "-f=${Version}", package], capture_output=True, text=True, check=False)
    except OSError:
        return ""
    return f"{package} {done.stdout.strip()}" if done.returncode == 0 else ""


def all_programs(convexact):
    programs = own_programs(convexact) + hull_programs()
    profiles = json.loads((ROOT / "share" / "convexact" / "profiles.json").read_text())["profiles"]
    for program in programs:
        program.promise = profiles[PROFILES[program.name]]["tolerance"] if program.name in PROFILES else ""
    return programs


def own_programs(convexact):
    return [Program("convexact-hull", [convexact, "hull", "{input}", "-o", "{output}"]),
                Program("convexact", [convexact, "simplify", "{input}", "--faces", "{faces}", "-o", "{output}"]),
                Program("convexact-single", [convexact, "simplify", "{input}", "--faces", "{faces}", "--precision",
                                             "32", "-o", "{output}"]),
                Program("convexact-planes", [convexact, "simplify", "{input}", "--faces", "{faces}", "-o", "{output}"],
                        writes="json")]


def hull_programs():
    programs = [npm_program(name, numbers, PACKAGES.get(name, name)) for name, numbers in NPM.items()]
    programs += [npm_program(name, numbers, PACKAGES[name], "{faces}") for name, numbers in NPM_LIMITED.items()]
    for name, (binary, mode, numbers) in BUILT.items():
        package = {"bullet": "libbullet-dev", "cgal": "libcgal-dev"}[binary.removesuffix("64")]
        programs.append(built_program(name, binary, mode, numbers, package))
    for name, options in QHULL.items():
        programs.append(Program(name, ["python3", str(HERE / "qhull.py"), options, "{input}", "{output}"], origin="debian",
                                missing="" if shutil.which("qhull") else "qhull-bin is not installed",
                                version=debian_version("qhull-bin")))
    programs += [python_program(name, package, PYTHON_NUMBERS.get(name, "binary64"), "python_hulls.py", "{faces}")
                 for name, package in PYTHON_HULLS.items()]
    programs += [python_program(name, package, "binary64", "python_boxes.py", writes="txt") for name, package in PYTHON_BOXES.items()]
    return programs + [crate_program(name, *found) for name, found in CRATES.items()]


def decomposers(convexact):
    programs = [Program(f"convexact-{method}", [convexact, "decompose", "{input}", "--method", method, "-o", "{output}"])
                for method in ("cut", "hacd", "acd")]
    programs += [npm_program(name, *found) for name, found in NPM_PARTS.items()]
    programs += [built_program(name, "decomposers", name, numbers, "libbullet-extras-dev") for name, numbers in BUILT_PARTS.items()]
    programs += [python_program(name, name, "binary64", "python_parts.py") for name in PYTHON_PARTS]
    return programs + [crate_program(name, *found) for name, found in CRATES_PARTS.items()]


def npm_program(name, numbers, package, *more):
    there = shutil.which("node") and (BUILD / "node_modules").exists()
    return Program(name, ["node", str(BUILD / "programs.mjs"), name, "{input}", "{output}", *more], numbers, origin="npm",
                   missing="" if there else "npm packages are not installed", version=npm_version(package))


def built_program(name, binary, mode, numbers, package):
    path = BUILD / "bin" / binary
    return Program(name, [str(path), mode, "{input}", "{output}"], numbers, origin="debian",
                   missing="" if path.exists() else f"build/field/bin/{binary} is not built", version=debian_version(package))


def python_program(name, package, numbers, adapter, *more, writes="obj"):
    wanted, found = PYTHON[package], python_versions().get(package)
    return Program(name, [str(ENVIRONMENT), str(HERE / adapter), name, "{input}", "{output}", *more], numbers, writes, origin="python",
                   missing="" if found == wanted else f"{package} {wanted} is not in the environment build/peers",
                   version=f"{package} {found}" if found else "")


def crate_program(name, package, numbers):
    path = BUILD / "bin" / "crates"
    version = re.search(rf'^{package} = "=(.*)"', (HERE / "crates" / "Cargo.toml").read_text(), re.MULTILINE)[1]
    return Program(name, [str(path), name, "{input}", "{output}"], numbers, origin="crates", version=f"{package} {version}",
                   missing="" if path.exists() else "build/field/bin/crates is not built: no cargo, or too old a one")


def kind(name):
    """What a program writes, and where it is from. @raises SystemExit with the names, if there is none of that name."""
    kinds = {"hulls": own_programs("convexact") + hull_programs(), "decompositions": decomposers("convexact")}
    for writes, programs in kinds.items():
        for program in programs:
            if program.name == name:
                return f"{writes} {program.origin}"
    reason = f"{name} {NOT_HERE[name]}" if name in NOT_HERE else f"no program {name}"
    names = {writes: " ".join(program.name for program in programs) for writes, programs in kinds.items()}
    raise SystemExit(f"{reason}; hulls: {names['hulls']}; decompositions: {names['decompositions']}")


def install_python(only):
    """Brings the packages of the Python index, each for itself, or that of one program; says which cannot be had."""
    sys.path.insert(0, str(ROOT / "tests" / "reproduce"))
    from support import peer_environment  # pylint: disable=import-outside-toplevel
    for name, version in PYTHON.items():
        if only and {**PYTHON_HULLS, **PYTHON_BOXES}.get(only, only) != name:
            continue
        try:
            for package, pinned in {name: version, **PYTHON_NEEDS.get(name, {})}.items():
                peer_environment.require(peer_environment.environment(), package, pinned)
        except peer_environment.Skipped as reason:
            print(f"{reason}: its programs will be skipped", file=sys.stderr)


def run_program(program, source, target, faces, seconds):
    """How it ended: 'output', 'refused N', 'no file', 'signal N', 'time', or 'not started' and why."""
    target.unlink(missing_ok=True)
    seconds_of(target).unlink(missing_ok=True)
    code = exit_code(program, program.words(source, target, faces), seconds)
    if not isinstance(code, int):
        return code
    if code < 0:
        return f"signal {-code}"
    if code == 1 and program.origin == "python":
        return "not started: an import failed"  # adapters end with another code if the package raises
    if code:
        return f"refused {code}"
    return "output" if target.exists() else "no file"


def says_nothing(outcome):
    """Of a run that may end otherwise next time, so that it is not remembered: on a busy machine, or without a package."""
    return outcome.startswith(("time", "not started"))


def exit_code(program, words, seconds):
    """Of one run, in a copy of a process that has imported the program's package, if there is one; or how else it ended."""
    package = program.version.split(" ", maxsplit=1)[0]
    if program.origin == "python" and package in warm.MODULES:
        try:
            code = warm.call(words[0], package, words[1:], seconds)
            return "time" if code is None else code
        except warm.Dead as fault:
            return f"not started: {package} cannot be imported: {fault}"
    try:
        return subprocess.run(words, capture_output=True, timeout=seconds, check=False).returncode
    except subprocess.TimeoutExpired:
        return "time"
    except OSError as fault:
        return f"not started: {fault}"


def seconds_of(target):
    """The file in which an adapter leaves the seconds of the library's own call."""
    return target.with_name(target.name + ".json")


def own_seconds(target):
    path = seconds_of(target)
    return json.loads(path.read_text())["seconds"] if path.exists() else None


def main(task, name=""):
    if task == "kind":
        print(kind(name))
    else:
        install_python(name)


if __name__ == "__main__":
    main(*sys.argv[1:])
