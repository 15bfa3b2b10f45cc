#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Nasty candidates of every kind that once fooled a judge, settled by `convexact verify` and by judge.py.

Each generator yields (name, points of the input, candidate, tolerance, numbers): right ones that look wrong
and wrong ones that look right, seeded, so that a failure can be run again by its name.
"""
import argparse
import math
import random
import struct
import sys
import tempfile
from fractions import Fraction
from itertools import permutations
from multiprocessing import Pool
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from compare import compare  # noqa: E402
from judge import Input  # noqa: E402
from mutate import mutations, obj_text, off_text, ply_bytes  # noqa: E402
from reading import Mesh, read, to_binary32  # noqa: E402
from solid import Flat, Hull, integers  # noqa: E402

CUBE = [(x, y, z) for x in (0.0, 1.0) for y in (0.0, 1.0) for z in (0.0, 1.0)]
QUADS = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]


def hull_mesh(points):
    """The points with the facets of their hull as polygons; None if they are flat."""
    points = list(dict.fromkeys(points))
    (lifted,), _ = integers(points)
    try:
        hull = Hull(lifted)
    except Flat:
        return None
    index = {point: k for k, point in enumerate(lifted)}
    return Mesh(points, [[index[hull.points[c]] for c in facet.corners] for facet in hull.facets])


def some_solids(rng, count):
    """Small solids with polygons and with triangles, on a grid and off it, thin, far away, huge and tiny."""
    for _ in range(count):
        size, kind = rng.randrange(4, 14), rng.randrange(6)
        span = rng.choice((1, 2, 4))
        points = [tuple(float(rng.randint(-span, span)) for _ in range(3)) for _ in range(size + 4)]
        if kind == 1:
            points = [tuple(rng.uniform(-1, 1) for _ in range(3)) for _ in range(size)]
        elif kind == 2:
            points = [(x, y, z * 2.0 ** -40) for x, y, z in points]
        elif kind == 3:
            points = [(x + 2.0 ** 30, y, z) for x, y, z in points]
        elif kind == 4:
            points = [tuple(x * 2.0 ** rng.choice((-900, 300)) for x in p) for p in points]
        elif kind == 5:
            points = [tuple(to_binary32(Fraction(rng.uniform(-1, 1))) for _ in range(3)) for _ in range(size)]
        mesh = hull_mesh(points)
        if mesh:
            yield mesh


def damaged(rng, count):
    """1, 4: every mutation of mutate.py, one upon another."""
    for mesh in some_solids(rng, count):
        for name, mutant in mutations(mesh, rng):
            yield name, mesh.points, mutant, rng.choice((None, "1e-9d")), "binary64"
            if name not in ("no-faces", "as-it-is") and rng.random() < 0.3:
                again = list(mutations(mutant, rng))
                second, twice = rng.choice(again) if again else ("", None)
                if twice:
                    yield f"{name}+{second}", mesh.points, twice, None, "binary64"


def nothing_faces(rng, count):
    """1: zero-length edges in number, minus zero for zero, faces that vanish altogether; holes that only seem filled."""
    for mesh in some_solids(rng, count):
        points, faces = list(mesh.points), [list(face) for face in mesh.faces]
        for face in faces:
            for _ in range(rng.randrange(3)):
                k = rng.randrange(len(face))
                points.append(tuple(-x if x == 0 else x for x in points[face[k]]))
                face.insert(k, len(points) - 1)
        faces += [[c, c, c] for c in rng.sample(range(len(points)), 2)]
        yield "zero-length-edges", mesh.points, Mesh(points, faces), None, "binary64"
        gone = rng.randrange(len(faces) - 2)
        a, b = faces[gone][:2]
        yield "hole-with-nothing-in-it", mesh.points, Mesh(points, faces[:gone] + faces[gone + 1:] + [[a, b, a]]), None, "binary64"
        yield "nothing-but-nothing", mesh.points, Mesh(points, [[a, b, a], [a, a, a]]), None, "binary64"
        k = faces[0][0]
        near = tuple(math.nextafter(x, math.inf) for x in points[k])
        ajar = [[len(points) if c == k else c for c in faces[0]]] + faces[1:]
        yield "twin-one-ulp-off", mesh.points, Mesh(points + [near], ajar), rng.choice((None, "1e-6d")), "binary64"


def outlines(rng, count):
    """4: faces that are no simple polygons, and odd ones that are."""
    cube, rest = CUBE, [face for face in QUADS if face != [1, 5, 7, 3]]
    a, b, c, d = 1, 5, 7, 3  # the top, counter-clockwise
    ties = [[a, b, d, c], [a, c, b, d], [a, d, b, c], [b, a, c, d]]
    for tie in ties:
        yield "bow-tie-top", cube, Mesh(cube, rest + [tie]), None, "binary64"
        for other in ties:
            for cover in ([a, b, c, d], [a, b, c], [d, c, b, a]):
                yield "bow-ties-over-a-cover", cube, Mesh(cube, rest + [tie, other, cover]), None, "binary64"
                yield "bow-ties-over-covers", cube, Mesh(cube, rest + [tie, other, [a, b, c], [a, c, d]]), None, "binary64"
    for mesh in some_solids(rng, count):
        face = max(mesh.faces, key=len)
        others = [other for other in mesh.faces if other is not face]
        if len(face) > 4:
            star = face[::2] + face[1::2]
            yield "star", mesh.points, Mesh(mesh.points, others + [star]), None, "binary64"
        shuffled = rng.sample(face, len(face))
        yield "shuffled-outline", mesh.points, Mesh(mesh.points, others + [shuffled]), rng.choice((None, "1e-3d")), "binary64"
        yield "outline-twice", mesh.points, Mesh(mesh.points, others + [face + face]), None, "binary64"
        yield "turned-to-another-start", mesh.points, Mesh(mesh.points, others + [face[1:] + face[:1]]), None, "binary64"
    grid = CUBE + [(x, y, 1.0) for x, y in ((0.5, 0.0), (0.5, 0.5), (1.0, 0.5), (0.25, 0.75), (0.5, 0.75))]
    s, m, e = 8, 9, 10  # middle of the edge ab, of the top, of the edge bc
    front, right = [0, 4, 5, s, 1], [4, 6, 7, e, 5]
    sides = [face for face in rest if face not in ([0, 4, 5, 1], [4, 6, 7, 5])] + [front, right]
    notched, corner = [a, s, m, e, c, d], [s, b, e, m]
    yield "notched-faces", cube, Mesh(grid, sides + [notched, corner]), None, "binary64"
    yield "notch-empty", cube, Mesh(grid, sides + [notched]), None, "binary64"
    yield "notch-covered-twice", cube, Mesh(grid, sides + [notched, [a, s, b, e, c, d]]), None, "binary64"
    keyhole = [a, s, b, e, c, d, 11, 12, m, 11, d]
    yield "keyhole", cube, Mesh(grid, sides + [keyhole, [11, m, 12]]), None, "binary64"
    yield "touching-itself", cube, Mesh(grid, sides + [[a, s, m, b, e, m, c, d]]), None, "binary64"
    yield "out-and-back", cube, Mesh(grid, sides + [notched, corner + [12, m]]), None, "binary64"
    for tilt in (2.0 ** -52, 2.0 ** -40, 2.0 ** -10):
        bent = [(x, y, z + tilt if (x, y, z) == (1.0, 1.0, 1.0) else z) for x, y, z in grid]
        yield "bent-bow-tie", cube, Mesh(bent, rest + [[a, c, b, d]]), rng.choice((None, "1e-3")), "binary64"
        yield "bent-notch", cube, Mesh(bent, sides + [notched, corner]), rng.choice((None, "1e-3")), "binary64"


def loop_covers(rim, inner, largest):
    """All sets of at most `largest` loops over the points whose directed edges are the rim, and inner ones in pairs."""
    points = rim + inner
    loops = [(points[0], *rest) for size in range(2, 6) for rest in permutations(points[1:], size)]
    for start in range(1, len(points) - 2):
        loops += [(points[start], *rest) for size in range(2, 6) for rest in permutations(points[start + 1:], size)]
    sides = [[(loop[k - 1], loop[k]) for k in range(len(loop))] for loop in loops]
    found = []

    def extend(chosen, used):
        missing = [edge for edge in wanted if edge not in used]
        missing += [(v, u) for u, v in used if (u, v) not in wanted and (v, u) not in used]
        if not missing:
            found.append([list(loops[k]) for k in chosen])
        elif len(chosen) < largest:
            for k, side in enumerate(sides):
                if missing[0] in side and not used & set(side) and not backward & set(side):
                    extend(chosen + [k], used | set(side))
    wanted = {(rim[k - 1], rim[k]) for k in range(len(rim))}
    backward = {(v, u) for u, v in wanted}
    extend([], frozenset())
    return found


def overlapping(rng, count):
    """4: every way to close the top of a frustum by loops, which is closed and oriented and covers it once by area."""
    rim, inner = [4, 5, 6, 7], [8]
    base = [(-3.0, -3.0, 0.0), (4.0, -3.0, 0.0), (4.0, 3.0, 0.0), (-3.0, 3.0, 0.0)]
    covers = loop_covers(rim, inner, 3)
    for _ in range(20 * count):
        x, y = rng.choice(((0.25, 0.0), (0.5, 0.25), (-0.5, 0.5), (0.0, -0.75)))
        top = [(-1.0, -1.5, 2.0), (2.0, -1.0, 2.0), (1.0, 1.0, 2.0), (-1.5, 1.0, 2.0), (x, y, 2.0)]
        mesh = hull_mesh(base + top[:4])
        points = base + top
        index = {point: k for k, point in enumerate(points)}
        sides = [[index[mesh.points[c]] for c in face] for face in mesh.faces]
        sides = [face for face in sides if set(face) != set(rim)]
        yield "loops", mesh.points, Mesh(points, sides + rng.choice(covers)), None, "binary64"


def nested(rng, count):
    """4, 12: surfaces that are closed and oriented, and cover the hull twice, not at all, or somewhere else."""
    for mesh in some_solids(rng, count):
        n = len(mesh.points)
        centre = [math.fsum(p[k] for p in mesh.points) / n for k in range(3)]
        for shrink in (0.5, 2.0 ** -20, 2.0 ** -45):
            inner = [tuple(x + (c - x) * shrink for x, c in zip(p, centre)) for p in mesh.points]
            copy = [[corner + n for corner in face] for face in mesh.faces]
            tolerance = rng.choice((None, "1e-9d", "1e-3d"))
            yield "nested", mesh.points, Mesh(mesh.points + inner, mesh.faces + copy), tolerance, "binary64"
            yield "shell", mesh.points, Mesh(mesh.points + inner, mesh.faces + [f[::-1] for f in copy]), tolerance, "binary64"
            yield "only-inner", mesh.points, Mesh(mesh.points + inner, copy), tolerance, "binary64"


def wedges(rng, count):
    """10: points before a sharp edge or corner, with tolerances just above and just below their distance."""
    for _ in range(count):
        slope, z = 2.0 ** -rng.randrange(1, 30), rng.choice((0.0, 0.5, -0.25))
        wedge = hull_mesh([(0.0, 0.0, 0.0), (0.0, 0.0, 1.0), (1.0, slope, 0.0), (1.0, -slope, 0.0),
                           (1.0, slope, 1.0), (1.0, -slope, 1.0)])
        away = rng.choice((0.5, 2.0 ** -10, 3.0 * 2.0 ** -35))
        given = wedge.points + [(-away, 0.0, z)]
        exact = math.hypot(away, min(z, 0.0))
        rows = "".join(f"{row}\n" for row in (f"{-slope!r} 1 0 0", f"{-slope!r} -1 0 0", "1 0 0 -1", "0 0 1 -1", "0 0 -1 0"))
        for tolerance in (None, "1e-6", repr(exact * (1 + 1e-12)), repr(exact * (1 - 1e-12))):
            yield "wedge", given, wedge, tolerance, "binary64"
            yield "wedge-rows", given, rows.encode(), tolerance, "binary64"
    for _ in range(count):
        spike = hull_mesh([(0.0, 0.0, 0.0)] + [(1.0, rng.uniform(-1e-6, 1e-6), rng.uniform(-1e-6, 1e-6)) for _ in range(5)])
        if spike:
            point = (-rng.random(), rng.uniform(-1e-3, 1e-3), rng.uniform(-1e-3, 1e-3))
            yield "spike-solid", spike.points + [point], spike, rng.choice((None, "1e-6", "0.5")), "binary64"


def near_misses(rng, count):
    """Points by one unit in the last place outside, on, and inside of facets, edges and corners."""
    for mesh in some_solids(rng, count):
        given = list(mesh.points)
        for p in rng.sample(mesh.points, min(3, len(mesh.points))):
            given.append(tuple(math.nextafter(x, rng.choice((-math.inf, math.inf, x))) for x in p))
        for _ in range(3):
            p, q = rng.sample(mesh.points, 2)
            given.append(tuple((x + y) / 2 for x, y in zip(p, q)))
        yield "near-misses", given, mesh, rng.choice((None, "1e-15d", "1e-9d")), "binary64"


def halfspace_sets(rng, count):
    """6, 10, 18: rows that bound a solid, nothing, or all but one direction; long integers, fractions, decimals."""
    for _ in range(count):
        given = [tuple(rng.uniform(-1, 1) for _ in range(3)) for _ in range(6)]
        rows = []
        for _ in range(rng.randrange(3, 14)):
            n = [rng.randint(-5, 5) for _ in range(3)]
            shift = max(sum(x * c for x, c in zip(n, p)) for p in given)
            offset = -shift - rng.choice((0, 0, 1e-16, -1e-16, 1, -0.5))
            rows.append(" ".join(map(str, n)) + " " + rng.choice((repr(offset), str(Fraction(offset)), str(math.floor(offset)))))
        rows += rng.choice(([], ["0 0 0 -1"], ["0 0 0 0"], ["1 0 0 9007199254740993"]))
        if rng.random() < 0.7:
            rows += [f"{x} {y} {z} -{rng.choice((1, 2, '1.0000000000000002'))}" for x, y, z in
                     ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1))]
        yield "rows", given, "".join(row + "\n" for row in rows).encode(), rng.choice((None, "1e-9d", "0.1")), "binary64"


def single_numbers(rng, count):
    """24: decimals that mean another float32 than by way of a double, nine digits, ties, subnormals."""
    def word():
        x = to_binary32(Fraction(rng.choice((1.0, 1e-3, 1e-40, 1e30)) * rng.uniform(-1, 1)))
        up = struct.unpack("f", struct.pack("i", struct.unpack("i", struct.pack("f", x))[0] + 1))[0]
        tie = (Fraction(x) + Fraction(up)) / 2
        digits = decimal_text(tie)
        return rng.choice((f"{x:.9g}", repr(x), digits, digits + "0000000000000000000001", f"{x:.7g}"))
    for _ in range(count):
        lines = [[word() for _ in range(3)] for _ in range(8)]
        text = "".join("v " + " ".join(line) + "\n" for line in lines).encode()
        given = [tuple(float(f"{float(w):.9g}") for w in line) for line in lines]
        yield "single", given, text, rng.choice((None, "1e-9d")), rng.choice(("binary32", "binary32", "binary64", "exact"))


def decimal_text(value):
    """All digits of a dyadic fraction."""
    shift = value.denominator.bit_length() - 1
    digits = str(abs(value.numerator) * 5 ** shift).rjust(shift + 1, "0")
    whole, rest = (digits[:-shift], digits[-shift:]) if shift else (digits, "0")
    return ("-" if value < 0 else "") + whole + "." + rest


GENERATORS = (damaged, nothing_faces, outlines, overlapping, nested, wedges, near_misses, halfspace_sets, single_numbers)


def attack(work):
    """Sets one candidate before both judges: (name, differences)."""
    name, points, candidate, tolerance, numbers, convexact, keep, rng = work
    if isinstance(candidate, bytes):
        suffix, data = ("obj" if candidate.startswith(b"v") else "txt"), candidate
    else:
        suffix, writer = rng.choice((("obj", obj_text), ("off", off_text), ("ply", ply_bytes)))
        data = writer(candidate)
    with tempfile.TemporaryDirectory() as folder:
        source, target = Path(folder) / "input.obj", Path(folder) / f"candidate.{suffix}"
        source.write_bytes(obj_text(Mesh(points, [])))
        target.write_bytes(data)
        given = Input(read(source, numbers).points)
        differences, status, _ = compare(convexact, given, source, target, numbers, tolerance)
        if differences.found:
            place = keep / name
            place.mkdir(parents=True, exist_ok=True)
            source.rename(place / "input.obj")
            target.rename(place / target.name)
    return name, tolerance, numbers, status, differences.found


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--convexact", required=True)
    parser.add_argument("--count", type=int, default=20, help="solids for each generator (default 20)")
    parser.add_argument("--seed", type=int, default=13)
    parser.add_argument("--only", default="", help="generators whose name has this in it")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--keep", type=Path, default=Path("build/field/attacks"), help="where failing pairs are kept")
    options = parser.parse_args()
    work = []
    for generator in GENERATORS:
        if options.only in generator.__name__:
            rng = random.Random(f"{options.seed} {generator.__name__}")
            for k, entry in enumerate(generator(rng, options.count)):
                work.append((f"{generator.__name__}-{k}-{entry[0]}", *entry[1:], options.convexact, options.keep,
                             random.Random(k)))
    failed = 0
    with Pool(options.jobs) as pool:
        for name, tolerance, numbers, status, found in pool.imap(attack, work, 8):
            failed += bool(found)
            for kind, claim, sentence in found:
                print(f"{kind}: {name} {tolerance or ''} {numbers} exit {status}: {claim}: {sentence[:200]}")
    print(f"{len(work)} attacks, {failed} on which the judges differ")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
