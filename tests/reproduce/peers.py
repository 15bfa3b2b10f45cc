#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""`convexact decompose` beside the programs that people install: how many parts at the same distance.

Usage: peers.py --convexact PROGRAM [--meshes DIR] [--only SHAPE] [--peer NAME] [--json FILE] [--environment DIR]

Each peer (coacd, miniacd, vhacdx: pinned wheels of the Python index, in an environment under build/peers that is
made at the first run) runs with its default settings. `convexact verify` judges its parts: how far they and the
solid are from each other, in both directions, and how much of the surface is in no part. Then `convexact decompose
--method cut` runs at that distance, rounded up to four digits, and is judged likewise. "at 0.49x" is the ratio of
the numbers of parts. Distances and excess are in percent, of the diameter and of the solid's volume.
A peer that cannot be had or that fails, and a shape whose mesh is not there, are skipped with the reason.
Exit code 1 if something of ours is not held, or not within the distance; or if it takes more parts than coacd.
"""
import argparse
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import time

from support.peer_environment import FOLDER, ROOT, Skipped, environment, require

DATA = ROOT / 'tests' / 'data'
SHAPES = ['bin', 'cup', 'tube', 'spot', 'fandisk', 'homer', 'rocker-arm']
PEERS = {'coacd': '1.0.14', 'miniacd': '0.1.5', 'vhacdx': '0.1.1'}
TIME_LIMIT = 600  # seconds for a run of a peer

# Runs in the environment of the peers: NAME INPUT OUTPUT, as OBJ of triangles and of objects.
RUN = '''
import sys
import numpy as np
name, source, target = sys.argv[1:]
points, faces = [], []
for line in open(source):
    words = line.split()
    if words[:1] == ['v']:
        points.append([float(x) for x in words[1:4]])
    elif words[:1] == ['f']:
        corners = [int(word.split('/')[0]) - 1 for word in words[1:]]
        faces += [[corners[0], corners[k - 1], corners[k]] for k in range(2, len(corners))]
points, faces = np.array(points, dtype=np.float64), np.array(faces, dtype=np.int32)
if name == 'coacd':
    import coacd
    coacd.set_log_level('off')
    parts = [(p, f) for p, f in coacd.run_coacd(coacd.Mesh(points, faces))]
elif name == 'vhacdx':
    import vhacdx
    flat = np.column_stack((np.full(len(faces), 3), faces)).ravel().astype(np.uint32)
    parts = [(p, np.asarray(f).reshape(-1, 4)[:, 1:] if np.asarray(f).ndim == 1 else f)
             for p, f in vhacdx.compute_vhacd(points, flat)]
else:
    import miniacd
    parts = [(part.vertices(), part.faces()) for part in miniacd.run(miniacd.Mesh(points, faces.astype(np.uint32)), print=False)]
with open(target, 'w') as out:
    base = 1
    for k, (corners, triangles) in enumerate(parts):
        out.write(f'o part_{k}\\n')
        for x in corners:
            out.write('v ' + ' '.join(repr(float(c)) for c in x) + '\\n')
        for face in triangles:
            out.write('f ' + ' '.join(str(int(c) + base) for c in face) + '\\n')
        base += len(corners)
'''


def judge(options, mesh, parts, distance):
    ran = subprocess.run([options.convexact, 'verify', mesh, parts, '--union', '--json', '--close', 'never', '--claims',
                          'covers-surface,covers-solid,within-solid', '--distance', distance], capture_output=True, text=True, check=False)
    if ran.returncode not in (0, 1):
        raise Skipped('not judged: ' + ran.stderr.strip()[:100])
    verdict = json.loads(ran.stdout)
    held = {claim['code']: claim['status'] for claim in verdict['claims']}
    measures = verdict['measures']
    diameter = diameter_of(mesh)
    two_sided = max(measures['surface_to_union']['high'], measures['union_to_input']['high'])
    return {'parts': len(verdict['parts']), 'distance': two_sided / diameter,
            'uncovered': measures['uncovered_area']['high'] / measures['surface_area']['low'],
            'excess': measures['excess_volume']['high'] / measures['solid_volume']['low'],
            'holds': all(held[code] == 'holds' for code in ('covers-surface', 'covers-solid', 'within-solid'))}


def diameter_of(mesh):
    """Of the box of its points."""
    lines = mesh.read_text(encoding='utf-8').splitlines()
    points = [[float(x) for x in line.split()[1:4]] for line in lines if line.startswith('v ')]
    return math.dist([min(axis) for axis in zip(*points)], [max(axis) for axis in zip(*points)])


def run_peer(python, name, mesh, target):
    start = time.monotonic()
    try:
        ran = subprocess.run([python, '-c', RUN, name, mesh, target], capture_output=True, text=True, check=False, timeout=TIME_LIMIT)
    except subprocess.TimeoutExpired:
        raise Skipped(f'not done within {TIME_LIMIT} s') from None
    if ran.returncode != 0:
        raise Skipped('failed: ' + (ran.stderr.strip().splitlines() or [f'exit code {ran.returncode}'])[-1][:100])
    return time.monotonic() - start


def run_ours(options, mesh, distance, target):
    start = time.monotonic()
    subprocess.run([options.convexact, 'decompose', '--method', 'cut', '--close', 'never', mesh, '--distance', distance, '-o', target,
                    '--measures', 'none'], capture_output=True, check=True)
    return time.monotonic() - start


def text_of(row):
    return (f'{row["parts"]}; {100 * row["distance"]:.2f}; {100 * row["uncovered"]:.3g}; {100 * row["excess"]:.1f}; '
            f'{row["seconds"]:.1f}')


def compare(options, python, shape, name, mesh, folder):
    target = folder / 'parts.obj'
    seconds = run_peer(python, name, mesh, target)
    theirs = {**judge(options, mesh, target, '3%'), 'seconds': seconds}
    distance = f'{math.ceil(1e6 * theirs["distance"]) / 1e4:.4f}%'
    seconds = run_ours(options, mesh, distance, target)
    ours = {**judge(options, mesh, target, distance), 'seconds': seconds}
    ratio = ours['parts'] / theirs['parts']
    print(f'| {shape} | {name} | {text_of(theirs)} | {text_of(ours)} | {ratio:.2f}x | {"holds" if ours["holds"] else "NOT HELD"} |',
          flush=True)
    return {'shape': shape, 'peer': name, 'theirs': theirs, 'ours': ours, 'ratio': ratio}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--convexact', required=True)
    parser.add_argument('--meshes', help='a folder with fandisk.obj, homer.obj and rocker-arm.obj')
    parser.add_argument('--only', action='append', choices=SHAPES)
    parser.add_argument('--peer', action='append', choices=list(PEERS))
    parser.add_argument('--environment', type=pathlib.Path, default=FOLDER)
    parser.add_argument('--json')
    options = parser.parse_args()
    rows, reasons = [], {}
    try:
        python = environment(options.environment)
        for name in options.peer or PEERS:
            try:
                require(python, name, PEERS[name])
            except Skipped as reason:
                reasons[name] = str(reason)
    except Skipped as reason:
        reasons = dict.fromkeys(options.peer or PEERS, str(reason))
    print('Each: parts; distance; surface uncovered; excess (percent); seconds.\n')
    print('| shape | peer | peer | cut at its distance | parts | judged |\n|---|---|---|---|---|---|')
    with tempfile.TemporaryDirectory() as scratch:
        for shape in options.only or SHAPES:
            places = [DATA / 'cases' / f'{shape}.obj', DATA / f'{shape}.obj']
            places += [pathlib.Path(options.meshes) / f'{shape}.obj'] if options.meshes else []
            mesh = next((path for path in places if path.exists()), None)
            for name in options.peer or PEERS:
                try:
                    if mesh is None:
                        raise Skipped(f'{shape}.obj is not there; --meshes names its folder')
                    if name in reasons:
                        raise Skipped(reasons[name])
                    rows.append(compare(options, python, shape, name, mesh, pathlib.Path(scratch)))
                except Skipped as reason:
                    print(f'| {shape} | {name} | skipped: {reason} |', flush=True)
    for name in options.peer or PEERS:
        own = [row['ratio'] for row in rows if row['peer'] == name]
        if own:
            mean = math.exp(sum(map(math.log, own)) / len(own))
            print(f'\n{name} {PEERS[name]}: cut takes {mean:.2f} times its parts on {len(own)} shapes (geometric mean), at most {max(own):.2f}')
    if options.json:
        pathlib.Path(options.json).write_text(json.dumps({'rows': rows}, indent=1) + '\n', encoding='utf-8')
    return int(any(not row['ours']['holds'] or (row['peer'] == 'coacd' and row['ratio'] > 1) for row in rows))


if __name__ == '__main__':
    sys.exit(main())
