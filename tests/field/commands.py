#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Attacks on the command line: what is asked, how it is spelled, which bytes names have, how deep JSON nests.

Each entry says which exit codes are right, as docs/usage.md defines them. What is no answer at all (a
signal, 70, JSON that cannot be parsed) is wrong everywhere.
"""
import argparse
import json
import random
import re
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from attacks import CUBE, QUADS, hull_mesh  # noqa: E402
from mutate import obj_text  # noqa: E402
from reading import Mesh  # noqa: E402

USAGE, NO, YES = 2, 1, 0
BAD_COUNTS = ["-1", "+1", "99999999999999999999", "18446744073709551616", "1.5", "1e3", " 8", "8 ", "0x8", "", "eight",
              "-0", "8,", "٨", "1_000", "nan", "inf"]


class Bench:
    """Runs the program in a folder of its own, and remembers what went wrong."""

    def __init__(self, convexact, folder):
        self.convexact, self.folder, self.wrong, self.asked, self.answers = convexact, folder, [], 0, set()

    def run(self, arguments, stdin=b"", seconds=300):
        words = [self.convexact, *arguments]
        try:
            return subprocess.run(words, input=stdin, capture_output=True, cwd=self.folder, timeout=seconds, check=False)
        except subprocess.TimeoutExpired:
            return subprocess.CompletedProcess(words, "time", b"", b"")
        except ValueError:  # a null byte cannot be an argument
            return None

    def expect(self, what, arguments, codes, stdin=b""):
        done = self.run(arguments, stdin)
        self.asked += 1
        if done is None:
            return None
        shown = " ".join(repr(a) if isinstance(a, bytes) else a for a in arguments)
        if done.returncode not in codes:
            self.wrong.append(f"{what}: exit {done.returncode} instead of {codes}: {shown}: {tail(done)}")
        if "--json" in arguments and "--stdio" not in arguments:
            try:
                json.loads(done.stdout.decode())
            except ValueError as fault:
                self.wrong.append(f"{what}: no JSON object: {shown}: {fault}")
        return done

    def file(self, name, data):
        path = self.folder / name if isinstance(name, str) else bytes(self.folder) + b"/" + name
        with open(path, "wb") as out:
            out.write(data)
        return name


def tail(done):
    return (done.stderr or done.stdout)[-200:].decode(errors="replace").strip().replace("\n", " | ")


def counts(bench):
    """7: one rule for every count."""
    for option in ("--max-facets", "--max-vertices", "--max-facet-vertices", "--seed", "--max-memory"):
        for word in BAD_COUNTS:
            if not (option == "--max-memory" and word in ("1.5", "1e3")):
                bench.expect("count", ["verify", "cube.obj", "cube.obj", f"{option}={word}"], [USAGE])
    for word, code in (("010", YES), ("6", YES), ("06", YES), ("5", NO), ("05", NO), ("0", NO)):
        bench.expect("octal", ["verify", "cube.obj", "cube.obj", "--max-facets", word], [code])
    for word in BAD_COUNTS + ["3", "0"]:
        bench.expect("faces", ["simplify", "cube.obj", f"--faces={word}", "-o", "out.obj"], [USAGE])
        bench.expect("faces", ["diff", "cube.obj", f"--faces={word}"], [USAGE])
    bench.expect("faces", ["simplify", "cube.obj", "--faces", "010", "-o", "out.obj"], [YES])


def vacuous(bench):
    """6: a claim that is asked for by name and cannot be decided is no success."""
    rows = bench.file("unbounded.txt", b"1 0 0 -1\n-1 0 0 0\n0 1 0 -1\n")
    for faces, claims in ((QUADS[1:], ("mesh-oriented", "mesh-closed", "mesh-convex")),
                          ([], ("mesh-closed", "mesh-oriented", "mesh-planar", "mesh-convex"))):
        name = bench.file(f"cube-{len(faces)}.obj", obj_text(Mesh(CUBE, faces)))
        for claim in claims:
            bench.expect("vacuous", ["verify", "cube.obj", name, "--claims", claim], [NO])
            bench.expect("vacuous", ["verify", "cube.obj", name, "--claims", f"contains-input,{claim}", "--json"], [NO])
    bench.expect("vacuous", ["verify", "cube.obj", "cube-0.obj"], [YES])
    for claim in ("max-facets", "max-vertices", "max-facet-vertices"):
        bench.expect("asks nothing", ["verify", "cube.obj", "cube.obj", "--claims", claim], [USAGE])
        bench.expect("asks nothing", ["verify", "cube.obj", "cube.obj", "--claims", f"{claim},contains-input"], [USAGE])
        bench.expect("unbounded", ["verify", "cube.obj", rows, "--claims", claim, f"--{claim}", "9"], [NO])
    for claim in ("mesh-closed", "mesh-oriented", "mesh-planar", "mesh-convex"):
        bench.expect("of no mesh", ["verify", "cube.obj", rows, "--claims", claim], [NO, USAGE])
    for word in ("", ",", "contains-input,", "nonsense", "contains-input,,mesh-closed"):
        bench.expect("no claim", ["verify", "cube.obj", "cube.obj", "--claims", word], [USAGE])


def bytes_of_names(bench):
    """14: names that are no UTF-8, in files, options and objects."""
    latin = "größe".encode("latin-1")
    cube = (bench.folder / "cube.obj").read_bytes()
    for name in (latin, b"\xff\xfe", b"a\xc0\x80b", b"\xed\xa0\x80", b"tab\there", b"new\nline", b'quote"\\'):
        path = bench.file(name + b".obj", cube)
        named = bench.file("named.obj", b"o " + name.replace(b"\n", b"") + b"\n" + cube)
        for extra in ([], ["--json"]):
            bench.expect("bytes", ["hull", path, *extra], [YES])
            bench.expect("bytes", ["verify", path, path, *extra], [YES])
            bench.expect("bytes", ["verify", path, b"absent " + name, *extra], [3])
            bench.expect("bytes", ["simplify", path, "--faces", "6", "-o", b"out-" + name + b".obj", *extra], [YES])
            bench.expect("bytes", ["simplify", named, "--parts", "--faces", "6", "-o", "parts.obj", *extra], [YES])
            bench.expect("bytes", ["verify", path, path, "--claims", name, *extra], [USAGE])
            bench.expect("bytes", ["simplify", path, "--engine", name, "--faces", "6", "-o", "o.obj", *extra], [USAGE])
            bench.expect("bytes", [name, *extra], [USAGE])


def deep_json(bench):
    """13, 18: requests that nest deeply, and long integers; later requests are answered all the same."""
    points = [list(p) for p in CUBE]
    good = {"id": "after", "points": points, "candidate": {"vertices": points}}
    for depth in (10, 1000, 100000, 1000000):
        nest = "[" * depth + "]" * depth
        keys = '{"a":' * depth + "1" + "}" * depth
        for bad in (f'{{"id": {nest}, "points": [], "candidate": {{}}}}', f'{{"claims": {nest}}}', f'{{"decimal": {keys}}}',
                    "[" * depth, '{"id":' * depth, nest, f'{{"points": {nest}, "candidate": {{"vertices": []}}}}'):
            done = bench.expect("deep", ["verify", "--stdio"], [YES, NO, 3], (bad + "\n" + json.dumps(good) + "\n").encode())
            last = done.stdout.decode().strip().split("\n")[-1]
            if done.returncode != "time" and '"after"' not in last:
                bench.wrong.append(f"deep: the request after one {depth} deep got no answer: {bad[:20]}")
        for name in ("deep.json", "deep.txt"):
            bench.file(name, f'{{"halfspaces": {nest}}}'.encode())
            bench.expect("deep", ["verify", "cube.obj", name], [NO])
            bench.expect("deep", ["verify", "cube.obj", "--trace", name], [NO, 3])
            bench.expect("deep", ["hull", name], [3])
    large = 2 ** 53 + 1
    for entry in (0, 0.5, "0x1p-1", "1/2", 10 ** 30):
        request = {"id": 2 ** 70 + 1, "points": [[large, 0, 0], [0, 0, 0], [0, 1, 0], [0, 0, 1]],
                   "candidate": {"planes": [[1, 0, 0, -large], [-1, 0, 0, 0], [0, -1, 0, 0], [0, 0, -1, 0], [0, 1, 0, -9],
                                            [0, 0, 1, -9], [0, 0, 1, f"-{10 ** 30}"], [0, 0, 1, str(-10 ** 31)]]}}
        request["candidate"]["planes"].append([0, 0, entry if not isinstance(entry, str) else entry, str(-10 ** 40)])
        answer = bench.expect("long integers", ["verify", "--stdio"], [YES, NO, 3], json.dumps(request).encode() + b"\n")
        if str(2 ** 70 + 1).encode() not in answer.stdout:
            bench.wrong.append(f"long integers: the id changed: {answer.stdout[:80]!r}")
        bench.answers.add(answer.stdout.count(b'"violated"'))
    if len(bench.answers) > 1:
        bench.wrong.append("long integers: 2^53 + 1 means another number beside other entries")


def smallest_tolerance(bench):
    """3: the tolerance that a verdict names makes every claim hold."""
    rng = random.Random(3)
    for k in range(12):
        mesh = None
        while not mesh or all(len(face) == 3 for face in mesh.faces):
            mesh = hull_mesh([tuple(float(rng.randint(-3, 3)) for _ in range(3)) for _ in range(10)])
        turn = [[rng.uniform(-1, 1) for _ in range(3)] for _ in range(3)]
        points = [tuple(sum(r * x for r, x in zip(row, p)) for row in turn) for p in mesh.points]
        name = bench.file(f"turned-{k}.obj", obj_text(Mesh(points, mesh.faces)))
        done = bench.run(["verify", name, name])
        if done.returncode == 0:
            continue
        named = re.search(r"--tolerance[ =](\S+?)[,.;)]?(\s|$)", (done.stdout + done.stderr).decode())
        if not named:
            if b"look inward" not in done.stdout:
                bench.wrong.append(f"smallest tolerance: none is named for {name}")
            continue
        bench.expect("smallest tolerance", ["verify", name, name, "--tolerance", named.group(1)], [YES])
        digits = re.match(r"[0-9.]+", named.group(1)).group()
        less = named.group(1).replace(digits, f"{float(digits) * 0.98:.6g}", 1)
        bench.expect("smallest tolerance", ["verify", name, name, "--tolerance", less], [NO])


def budgets(bench):
    """5: what simplify reached passes its own budget, and a thin hull without simplification does not."""
    rng = random.Random(5)
    for k in range(8):
        flat = 1e-9 if k % 2 else 1.0
        points = [(rng.uniform(-1, 1), rng.uniform(-1, 1), flat * rng.uniform(-1, 1)) for _ in range(20)]
        name, faces = bench.file(f"random-{k}.obj", obj_text(Mesh(points, []))), rng.choice((6, 8, 10))
        for form in ("obj", "stl", "ply", "off", "json"):
            extra = ["--precision", "32"] if form == "stl" else []
            done = bench.run(["simplify", name, "--faces", str(faces), "-o", f"k.{form}", "--json", *extra])
            if done.returncode == 0 and b'"reached"' in done.stdout:
                bench.expect("budget reached", ["verify", name, f"k.{form}", "--max-facets", str(faces)], [YES])
        bench.run(["hull", name, "-o", "hull.obj"])
        bench.expect("budget of a hull", ["verify", name, "hull.obj", "--max-facets", str(faces)], [NO])
        bench.expect("budget of a hull", ["verify", name, "hull.obj", "--claims", "max-facets", "--max-facets", str(faces)], [NO])


def files(bench):
    """15: files that mislead a reader, and outputs that cannot be."""
    cube = (bench.folder / "cube.obj").read_bytes()
    bench.expect("two standard inputs", ["simplify", "-", "-", "--faces", "6", "-o", "x.obj"], [USAGE, 3], cube)
    bench.expect("unknown option", ["conform", "--nonsense", "--", "true", "{input}"], [USAGE])
    done = bench.run(["conform", "--nonsense", "--", "true", "{input}"])
    if b"--nonsense" not in done.stderr + done.stdout:
        bench.wrong.append(f"unknown option: its name is not said: {tail(done)}")
    ply = b"ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty int8 x\nproperty int8 y\nproperty int8 z\nend_header\n"
    signed = bench.file("signed.ply", ply + bytes([0, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0, 255]))
    inside = bench.file("inside.obj", b"v -0.25 -0.25 -0.25\nv -1 0 0\nv 0 -1 0\nv 0 0 -1\n")
    bench.expect("int8", ["verify", inside, signed, "--claims", "contains-input"], [YES])
    # A face of one corner: of an input its points count, an output with it is malformed (docs/formats.md).
    one = bench.file("one.off", b"OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0\n")
    bench.expect("a face of one corner", ["hull", one], [YES])
    bench.expect("a face of one corner", ["verify", "cube.obj", one, "--json"], [NO])
    for name, data in (("empty.stl", b""), ("solid.stl", b"solid"), ("solid2.stl", b"solid" + bytes(79) + b"\x02\0\0\0" + bytes(49)),
                       ("nul.obj", b"v 0 0 0\0\n")):
        bench.file(name, data)
        bench.expect("malformed", ["hull", name], [3, 4])
        bench.expect("malformed", ["verify", "cube.obj", name, "--json"], [NO])
    bench.expect("nowhere to write", ["simplify", "cube.obj", "--faces", "6", "-o", "absent/out.obj", "--json"], [5])


NONSENSE = r"""
import sys
mode, source, target = sys.argv[1:4]
points = [[float(x) for x in line.split()[1:4]] for line in open(source) if line.startswith("v ")]
if len(points) < 4:
    sys.exit(3)
faces = [[1, 2, 3], [1, 4, 2], [2, 4, 3], [3, 4, 1]]
low, high = [min(axis) for axis in zip(*points)], [max(axis) for axis in zip(*points)]
size = max(b - a for a, b in zip(low, high)) or 1.0
if not all(abs(x) < 1e150 for p in points for x in p) or size < 1e-150:
    sys.exit(3)
if mode == "inner-faces":
    (a, b, c), d = points[0:3], points[3]
    u, v, w = ([q - p for p, q in zip(a, x)] for x in (b, c, d))
    turn = sum(u[k - 2] * (v[k - 1] * w[k] - v[k] * w[k - 1]) for k in range(3))
    if turn > 0:
        faces = [face[::-1] for face in faces]
elif mode == "huge":
    t = 99.0 * size
    points = [[low[0] - t, low[1] - t, low[2] - t], [high[0] + 9 * t, low[1] - t, low[2] - t],
              [low[0] - t, high[1] + 9 * t, low[2] - t], [low[0] - t, low[1] - t, high[2] + 9 * t]]
    faces = [[1, 3, 2], [1, 2, 4], [2, 3, 4], [3, 1, 4]]
elif mode == "empty":
    points, faces = [], []
elif mode == "point":
    points, faces = points[:1], []
with open(target, "w") as out:
    for p in points:
        out.write("v %r %r %r\n" % tuple(p))
    for f in faces:
        out.write("f %d %d %d\n" % tuple(f))
"""


def nonsense_programs(bench):
    """12, 21: programs that write nonsense, or nothing, conform nowhere; the first outcome says why."""
    bench.file("nonsense.py", NONSENSE.encode())
    for mode, outcomes in (("inner-faces", None), ("huge", {"too-loose"}), ("empty", {"no-solid"}), ("point", {"no-solid"})):
        done = bench.expect("nonsense", ["conform", "--level", "1", "--json", "--", "python3", "-S", "-E", "nonsense.py", mode, "{input}",
                                         "{output}", "{faces}"], [NO])
        try:
            vectors = json.loads(done.stdout)["vectors"]
        except (ValueError, KeyError):
            continue
        solids = [v for v in vectors if v["outcome"] not in ("wrong-exit", "timed-out") and "refuse" not in v["id"]]
        passed = [v["id"] for v in solids if v["outcome"] == "passed" and not {"malformed", "flat"} & set(v["flags"])]
        if len(passed) > len(vectors) // 10:
            bench.wrong.append(f"nonsense: {mode} passes {len(passed)} vectors: {passed[:4]}")
        others = sorted({v["outcome"] for v in solids if not {"malformed", "flat"} & set(v["flags"])} - (outcomes or set()))
        if outcomes and others:
            bench.wrong.append(f"nonsense: {mode} has outcomes {others} instead of {sorted(outcomes)}")


ROUNDS = (counts, vacuous, bytes_of_names, deep_json, smallest_tolerance, budgets, files, nonsense_programs)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--convexact", required=True)
    parser.add_argument("--only", default="", help="rounds whose name has this in it")
    options = parser.parse_args()
    wrong = asked = 0
    for attack in ROUNDS:
        if options.only not in attack.__name__:
            continue
        with tempfile.TemporaryDirectory() as folder:
            bench = Bench(str(Path(options.convexact).resolve()), Path(folder))
            bench.file("cube.obj", obj_text(Mesh(CUBE, QUADS)))
            attack(bench)
        for sentence in bench.wrong:
            print(f"{attack.__name__}: {sentence[:400]}")
        wrong, asked = wrong + len(bench.wrong), asked + bench.asked
    print(f"{asked} questions, {wrong} answered wrongly")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
