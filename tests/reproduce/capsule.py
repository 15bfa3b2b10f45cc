#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""An oriented capsule as an implicit shape, in 18 halfspaces: figure 8 of [Jacobson2026].

Usage: capsule.py --convexact PROGRAM [--depths 4,5,6,7] [--faces 18] [--json FILE]

The paper prints no numbers. The counts and ratios to compare with were computed once, in doubles, by
other code. The volume ratios are those of the hull, and of the result, over the capsule in closed form.
"""
import argparse
import json
import math
import pathlib
import subprocess
import sys

SHAPE = pathlib.Path(__file__).parents[1] / 'data' / 'capsule.json'
# The axis is (1.5, 0.5, 1) and the radius 1/2.
VOLUME = math.pi * 0.25 * math.sqrt(3.5) + math.pi / 6
# Depth: leaves, facets of the hull, volume ratio of the hull.
EXPECTED = {4: (240, 42, 3.02891), 5: (992, 74, 1.92835), 6: (3880, 248, 1.44790), 7: (15632, 526, 1.21753)}
EXPECTED_END = {(7, 18): 1.3169}
# Most steps have ties, which doubles break by their rounding: relative difference of the ends.
TIES = 2e-3


def run(program, depth, faces):
    ran = subprocess.run([program, 'simplify', '--implicit', SHAPE, '--box=-2,-2,-2,4', '--depth', str(depth),
                          '--faces', str(faces), '--json'], capture_output=True, text=True, check=True)
    answer = json.loads(ran.stdout)
    cells = answer['implicit']
    return {'depth': depth, 'tested': sum(level['tested'] for level in cells['levels']),
            'kept': cells['levels'][-1]['kept'], 'facets': answer['input']['halfspaces'],
            'hull': answer['volume']['input']['value'] / VOLUME, 'bound': cells['ratio_bound'],
            'distance': cells['distance'], 'end': answer['volume']['output']['value'] / VOLUME,
            'halfspaces': answer['output']['halfspaces']}


def agrees(row, faces):
    """Whether counts are equal, hulls agree in the digits printed, and ends but for ties."""
    kept, facets, ratio = EXPECTED.get(row['depth'], (row['kept'], row['facets'], row['hull']))
    end = EXPECTED_END.get((row['depth'], faces), row['end'])
    return (row['kept'] == kept and row['facets'] == facets and abs(row['hull'] - ratio) < 0.6e-5
            and abs(row['end'] / end - 1) < TIES and row['hull'] <= row['bound'])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--convexact', required=True)
    parser.add_argument('--depths', default='4,5,6,7')
    parser.add_argument('--faces', type=int, default=18)
    parser.add_argument('--json', type=pathlib.Path)
    options = parser.parse_args()
    rows = [run(options.convexact, int(depth), options.faces) for depth in options.depths.split(',')]
    print('| depth | cells tested | kept, expected | kept | facets, expected | facets | V/V0 of the hull, expected '
          f'| V/V0 of the hull | bound | delta | V/V0 at {options.faces}, expected | V/V0 at {options.faces} |')
    print('|' + '---|' * 12)
    for row in rows:
        kept, facets, ratio = EXPECTED.get(row['depth'], ('-', '-', '-'))
        end = EXPECTED_END.get((row['depth'], options.faces), '-')
        print(f"| {row['depth']} | {row['tested']:,} | {kept} | {row['kept']} | {facets} | {row['facets']} | {ratio} "
              f"| {row['hull']:.5f} | {row['bound']:.5f} | {row['distance']:.5f} | {end} | {row['end']:.4f} |")
    if options.json:
        options.json.write_text(json.dumps({'faces': options.faces, 'rows': rows}, indent=2) + '\n')
    return 0 if all(agrees(row, options.faces) for row in rows) else 1


if __name__ == '__main__':
    sys.exit(main())
