#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Where greedy removal ends on rotated icosahedra: figure 16 of [Jacobson2026].

Usage: icosahedron.py --convexact PROGRAM [--trials 1000] [--seed 1] [--cost volume|area|mean-width] [--json FILE]

Twelve vertices are rotated at random, each coordinate is moved by up to 10^-12 at random, and the run
ends at 4 halfspaces or where every further removal adds too much. All faces of an icosahedron cost the
same, and so do many removals later. The noise breaks these ties. Rounding to doubles would not do: it
keeps the point symmetry, so opposite faces tie exactly, and the canonical order decides each time.
"""
import argparse
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile

R5, R3 = math.sqrt(5), math.sqrt(3)
# With the inradius 1 the icosahedron has this volume, and the ends have these.
START = R3 * (70 - 30 * R5)
# Name, halfspaces, volume over that of the icosahedron, share in the paper.
ENDS = [
    ('irregular tetrahedron', 4, R3 * (8 + 16 / R5) / START, '95.4%'),
    ('other tetrahedron', 4, R3 * (9 + 4 * R5) / START, 'not told'),
    ('rhombohedron, least', 6, 12 * math.sqrt(3 / 5) / START, '1.2%'),
    ('regular tetrahedron', 4, 8 * R3 / START, '0.6%'),
    ('rhombohedron, other', 6, 6 * R3 / START, 'not told'),
]
TOLERANCE = 1e-9  # relative, of a volume ratio
NOISE = 1e-12
# Opposite faces of a rhombohedron are parallel but for that noise, so one of them can be removed at
# 10^10 times the volume. That is no end of an icosahedron: all of these are below 7 times.
MOST_GROWTH = '20'


def vertices():
    """Edge length 2: (0, +-1, +-phi) and its cyclic permutations."""
    phi = (1 + R5) / 2
    corners = [(0.0, a, b * phi) for a in (-1, 1) for b in (-1, 1)]
    return [tuple(corner[(k + turn) % 3] for k in range(3)) for corner in corners for turn in range(3)]


def rotation(source):
    """A uniformly random rotation: of a uniformly random unit quaternion."""
    w, x, y, z = (source.gauss(0, 1) for _ in range(4))
    n = w * w + x * x + y * y + z * z
    s = 2 / n
    return ((1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w)),
            (s * (x * y + z * w), 1 - s * (x * x + z * z), s * (y * z - x * w)),
            (s * (x * z - y * w), s * (y * z + x * w), 1 - s * (x * x + y * y)))


def end_of(program, points, cost, scratch):
    """Halfspaces that are left, and the volume over that at the start."""
    file = pathlib.Path(scratch) / 'icosahedron.xyz'
    file.write_text(''.join(' '.join(map(repr, p)) + '\n' for p in points))
    ran = subprocess.run([program, 'simplify', file, '--faces', '4', '--max-growth', MOST_GROWTH,
                          '--cost', cost, '--json'],
                         capture_output=True, text=True, check=True)
    answer = json.loads(ran.stdout)
    return answer['output']['halfspaces'], answer['volume']['ratio']


def name_of(halfspaces, ratio):
    for name, count, expected, _ in ENDS:
        if count == halfspaces and abs(ratio / expected - 1) < TOLERANCE:
            return name
    return f'none of these: {halfspaces} halfspaces, {ratio!r} times the volume'


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--convexact', required=True)
    parser.add_argument('--trials', type=int, default=1000)
    parser.add_argument('--seed', type=int, default=1)
    parser.add_argument('--cost', default='volume', choices=['volume', 'area', 'mean-width'])
    parser.add_argument('--json', type=pathlib.Path)
    options = parser.parse_args()
    source = random.Random(options.seed)
    counts = {name: 0 for name, *_ in ENDS}
    with tempfile.TemporaryDirectory() as scratch:
        for trial in range(options.trials):
            turn = rotation(source)
            points = [tuple(sum(row[k] * p[k] for k in range(3)) + source.uniform(-NOISE, NOISE) for row in turn)
                      for p in vertices()]
            name = name_of(*end_of(options.convexact, points, options.cost, scratch))
            counts[name] = counts.get(name, 0) + 1
            if sys.stderr.isatty():
                print(f'\r{trial + 1} of {options.trials}', end='', file=sys.stderr)
    known = {name: (ratio, paper) for name, _, ratio, paper in ENDS}
    print(f'{options.trials} random rotations, by {options.cost}, seed {options.seed}')
    print('| end | V/V0 | here | paper, by volume |')
    print('|---|---|---|---|')
    for name, count in counts.items():
        ratio, paper = known.get(name, (math.nan, '-'))
        print(f'| {name} | {ratio:.6f} | {100 * count / options.trials:.1f}% | {paper} |')
    if options.json:
        options.json.write_text(json.dumps({'cost': options.cost, 'trials': options.trials,
                                            'seed': options.seed, 'ends': counts}, indent=2) + '\n')
    return 0 if counts.keys() == known.keys() else 1


if __name__ == '__main__':
    sys.exit(main())
