#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Solids cut into few parts: how many parts at 3% and at 1% of the diameter, and what is proven of them.

Links of robots, which are many overlapping bodies each, are cut at 1.8%.

Usage: cut.py --convexact PROGRAM [--meshes DIR] [--distances 3%,1%] [--effort low|normal|high] [--disjoint]
              [--check CONVEXACT-CHECK] [--only NAME] [--json FILE]

Each row is one run of `convexact decompose`: parts, excess as a share of the solid's volume, the measured distance of
the parts from the solid as a share of the diameter, seconds. Every result is judged by `convexact verify --union
--distance`, and its proof by convexact-check where that is beside the program. "given" is the number of parts that
the specification of the method names, with doubles. Shapes of unit cells have closed forms: so many boxes that do not overlap
and no excess. Parts may overlap, so fewer of them may do (a plus is two bars).
Exit code 1 if something is not held, not within the distance or not proven, or if there are more parts, or an excess.
"""
import argparse
import json
import math
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
DATA = ROOT / 'tests' / 'data'
CELLS = {
    'L': ([(0, 0, 0), (1, 0, 0), (0, 1, 0)], 2),
    'U': ([(0, 0, 0), (1, 0, 0), (2, 0, 0), (0, 1, 0), (2, 1, 0)], 3),
    'plus': ([(1, 0, 0), (0, 1, 0), (1, 1, 0), (2, 1, 0), (1, 2, 0)], 3),
    'square ring': ([(x, y, 0) for x in range(3) for y in range(3) if (x, y) != (1, 1)], 4),
    'stairs of 4': ([(x, 0, z) for x in range(4) for z in range(x + 1)], 4),
    'cavity': ([(x, y, z) for x in range(3) for y in range(3) for z in range(3) if (x, y, z) != (1, 1, 1)], 6),
    'cross': ([(1, 1, 1), (0, 1, 1), (2, 1, 1), (1, 0, 1), (1, 2, 1), (1, 1, 0), (1, 1, 2)], 5),
}
# At 3% and 1%.
MESHES = {'bin': (5, 5), 'house': (9, 10), 'tube': (9, 14), 'cup': (11, 17), 'spot': (11, 20), 'fandisk': (9, 20),
          'homer': (11, 24), 'rocker-arm': (16, 38), 'cow': (13, 36),
          'torus': (8, 15)}
# At 1.8%. Of example-robot-data 6.0.0 (the second of its hip-pitch.stl: cassie's) and gymnasium-robotics 1.4.2 (forearm).
LINKS = {'forearm_simple': 3, 'hip-pitch': 19, 'wrist_roll_follower_so101_v1': 25, 'neck_mesh': 1}


def cells_obj(cells):
    """The boundary of a union of unit cells, as squares that look outward."""
    inside, ids, faces = set(cells), {}, []
    for cell in cells:
        for axis in range(3):
            for high in (0, 1):
                beside = list(cell)
                beside[axis] += 2 * high - 1
                if tuple(beside) in inside:
                    continue
                square = []
                for u, v in ((0, 0), (1, 0), (1, 1), (0, 1)):
                    corner = list(cell)
                    corner[axis] += high
                    corner[(axis + 1) % 3] += u
                    corner[(axis + 2) % 3] += v
                    square.append(ids.setdefault(tuple(corner), len(ids) + 1))
                faces.append(square if high else square[::-1])
    return ''.join(f'v {x} {y} {z}\n' for x, y, z in ids) + ''.join(f'f {" ".join(map(str, face))}\n' for face in faces)


def torus_obj(around, across, radius=2.0, tube=1.0):
    """A torus of triangles. (The specification says how many, not which radii.)"""
    def corner(i, j):
        u, v = 2 * math.pi * i / around, 2 * math.pi * j / across
        return (radius + tube * math.cos(v)) * math.cos(u), (radius + tube * math.cos(v)) * math.sin(u), tube * math.sin(v)

    def at(i, j):
        return i % around * across + j % across + 1
    corners = [corner(i, j) for i in range(around) for j in range(across)]
    faces = [face for i in range(around) for j in range(across) for face in
             ((at(i, j), at(i + 1, j), at(i + 1, j + 1)), (at(i, j), at(i + 1, j + 1), at(i, j + 1)))]
    return ''.join(f'v {x!r} {y!r} {z!r}\n' for x, y, z in corners) + ''.join(f'f {a} {b} {c}\n' for a, b, c in faces)


def mesh_of(name, folder, meshes):
    """The file of a row; None if it is not there."""
    if name == 'torus':
        path = folder / 'torus.obj'
        path.write_text(torus_obj(32, 16), encoding='utf-8')
        return path
    if name in CELLS:
        path = folder / (name.replace(' ', '_') + '.obj')
        path.write_text(cells_obj(CELLS[name][0]), encoding='utf-8')
        return path
    places = [DATA / 'cases' / f'{name}.obj', DATA / f'{name}.obj']
    places += [pathlib.Path(meshes) / (name + ending) for ending in ('.obj', '.stl', '.STL')] if meshes else []
    return next((path for path in places if path.exists()), None)


def wanted(name, distances):
    """Pairs of a distance and the number of parts that is given for it, if one is."""
    given = {'1.8%': LINKS[name]} if name in LINKS else dict(zip(('3%', '1%'), CELLS[name][1:] * 2 if name in CELLS else MESHES[name]))
    if not distances:
        return list(given.items())
    return [(distance, CELLS[name][1] if name in CELLS else given.get(distance)) for distance in distances.split(',')]


def row_of(options, mesh, distance, folder, is_exact):
    parts, proof = folder / 'parts.obj', folder / 'parts.proof'
    ran = subprocess.run([options.convexact, 'decompose', '--method', 'cut', '--close', 'never', mesh, '--distance', distance,
                          '--effort', options.effort, *(['--disjoint'] if options.disjoint else []), '-o', parts, '--proof', proof, '--json', '--stages',
                          *(['--exact-volumes'] if is_exact else [])],
                         capture_output=True, text=True, check=True)
    made = json.loads(ran.stdout)
    seconds = sum(stage.get('seconds', 0) for stage in made['stages'] if stage['name'] in ('surface', 'cuts', 'store leaves',
                                                                                            'merge by reach', 'store parts', 'reach'))
    judged = subprocess.run([options.convexact, 'verify', mesh, parts, '--distance', distance, '--json'], capture_output=True,
                            text=True, check=False)
    verdict = json.loads(judged.stdout)
    wrong = [claim['code'] for claim in verdict['claims']
             if claim['code'] in ('covers-surface', 'covers-solid', 'within-solid') and claim['status'] != 'holds']
    checked = 'not checked'
    if options.check:
        check = subprocess.run([options.check, proof, mesh], capture_output=True, text=True, check=False)
        checked = 'proven' if check.returncode == 0 and 'no point of a part is farther' in check.stdout else 'NOT PROVEN'
    excess = made['excess']['high'] / made['solid']['low']
    return {'parts': len(made['parts']), 'excess': excess, 'no_excess': made['excess'].get('exact') == '0', 'seconds': seconds,
            'wrong': wrong, 'checked': checked, 'leaves': made['cuts']['leaves']}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--convexact', required=True)
    parser.add_argument('--meshes', help='a folder with fandisk.obj, homer.obj, rocker-arm.obj, cow.obj, and links of robots')
    parser.add_argument('--distances', help='of all shapes; default: those for which a number of parts is given')
    parser.add_argument('--effort', default='normal')
    parser.add_argument('--disjoint', action='store_true')
    parser.add_argument('--check', help='convexact-check; by default the one that was built with the program')
    parser.add_argument('--only', action='append')
    parser.add_argument('--json')
    options = parser.parse_args()
    built = pathlib.Path(options.convexact).resolve().parents[1] / 'check' / 'convexact-check'
    options.check = options.check or (str(built) if built.exists() else None)
    rows, failed = [], False
    print(f'| {"shape":12} | distance | parts | given | leaves | excess | seconds | judged | checked |')
    print('|---|---|---|---|---|---|---|---|---|')
    with tempfile.TemporaryDirectory() as scratch:
        for name in [*CELLS, *MESHES, *LINKS]:
            if options.only and name not in options.only:
                continue
            mesh = mesh_of(name, pathlib.Path(scratch), options.meshes)
            for distance, given in wanted(name, options.distances):
                if mesh is None:
                    print(f'| {name:12} | {distance} | skipped: it is not there; --meshes names its folder |')
                    continue
                row = row_of(options, mesh, distance, pathlib.Path(scratch), name in CELLS)
                missed = name in CELLS and (row['parts'] > given or not row['no_excess'])
                failed = failed or missed or bool(row['wrong']) or row['checked'] == 'NOT PROVEN'
                print(f'| {name:12} | {distance} | {row["parts"]} | {given or ""} | {row["leaves"]} | {100 * row["excess"]:.2f}% | '
                      f'{row["seconds"]:.2f} | {", ".join(row["wrong"]) or "holds"}{" MISSED" if missed else ""} | {row["checked"]} |',
                      flush=True)
                rows.append({'shape': name, 'distance': distance, **row})
    if options.json:
        pathlib.Path(options.json).write_text(json.dumps({'rows': rows}, indent=1) + '\n', encoding='utf-8')
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main())
