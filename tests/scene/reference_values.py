#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs by area and by mean width on one well-known mesh, against numbers from the definition.

Usage: reference_values.py --convexact PROGRAM MESH

Expected are volume, area and mean width of the result over those of the hull, at 18, 12 and 6
halfspaces. They are from runs in another language, with costs of 50 digits that are differences of two
solids, rounded to five decimals. MESH is a name. The file is looked for in tests/data, then in the
folders of $CONVEXACT_MESHES (separated by colons), because not every mesh may be copied into this
repository. Without it the test is skipped, with status 77.
"""
import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile

# Mesh -> by area at 18, 12, 6, then by mean width at 18, 12, 6.
EXPECTED = {
    'suzanne': [(1.03725, 1.05455, 1.03769), (1.07577, 1.10893, 1.08222), (1.57396, 1.59353, 1.35791),
                (1.04659, 1.06448, 1.03247), (1.09305, 1.11954, 1.06914), (1.58240, 1.60584, 1.36434)],
    'cow': [(1.03334, 1.02927, 1.01835), (1.09607, 1.08946, 1.05173), (1.58243, 1.63641, 1.38782),
            (1.06543, 1.04476, 1.01672), (1.16690, 1.12213, 1.04384), (1.64677, 1.71625, 1.42475)],
    'spot': [(1.02790, 1.05370, 1.03514), (1.06271, 1.10593, 1.06487), (1.52433, 1.67626, 1.46815),
             (1.04007, 1.06232, 1.03271), (1.07126, 1.10893, 1.06086), (1.56923, 1.67307, 1.43274)],
    'teapot': [(1.07973, 1.09103, 1.05870), (1.16921, 1.19133, 1.11449), (1.64480, 1.65257, 1.31867),
               (1.11556, 1.12040, 1.05709), (1.17457, 1.18197, 1.08958), (1.71389, 1.76595, 1.39038)],
    'homer': [(1.03916, 1.04913, 1.02972), (1.09742, 1.11788, 1.05507), (1.85279, 1.74502, 1.36392),
              (1.04549, 1.05367, 1.02848), (1.09799, 1.11797, 1.05811), (1.79984, 1.71725, 1.35356)],
    'fandisk': [(1.00216, 1.00240, 1.00112), (1.01529, 1.01591, 1.00575), (1.44582, 1.35820, 1.18129),
                (1.00326, 1.00371, 1.00105), (1.01531, 1.01591, 1.00575), (1.44600, 1.35831, 1.18133)],
    'rocker-arm': [(1.06168, 1.07541, 1.05048), (1.13706, 1.16642, 1.10226), (1.64069, 1.73832, 1.37999),
                   (1.11299, 1.08730, 1.04121), (1.20179, 1.18832, 1.09029), (1.66948, 1.73811, 1.37023)],
    'bunny': [(1.05016, 1.06599, 1.05035), (1.09026, 1.11193, 1.07519), (1.55293, 1.57929, 1.32425),
              (1.09169, 1.08458, 1.03751), (1.13457, 1.14005, 1.08001), (1.72207, 1.66092, 1.33401)],
}
# The source took too large a volume (by 0.031%) and area (by 0.021%) for this hull: Qhull says 33.981979
# and 62.943258, as does this program. So these two are compared from row to row.
RELATIVE = {'fandisk'}
MEASURES = ('volume', 'area', 'mean_width')
RUNS = [(cost, faces) for cost in ('area', 'mean-width') for faces in (18, 12, 6)]
# Half a unit of the fifth decimal, and the last of the nine digits of a measure.
TOLERANCE = 0.5e-5 + 1e-8


def find_mesh(name):
    shipped = pathlib.Path(__file__).resolve().parents[1] / 'data'
    others = [pathlib.Path(p) for p in os.environ.get('CONVEXACT_MESHES', '').split(':') if p]
    for folder in [shipped, *others]:
        if (folder / f'{name}.obj').is_file():
            return folder / f'{name}.obj'
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--convexact', required=True)
    parser.add_argument('mesh', choices=EXPECTED)
    options = parser.parse_args()
    mesh = find_mesh(options.mesh)
    if mesh is None:
        print(f'skipped: {options.mesh}.obj is in no folder of $CONVEXACT_MESHES')
        return 77

    def answer(*arguments):
        ran = subprocess.run([options.convexact, *arguments, '--json'],
                             capture_output=True, text=True, check=True)
        return json.loads(ran.stdout)

    tolerance = TOLERANCE * (3 if options.mesh in RELATIVE else 1)  # a quotient of two, up to 1.5

    def compared(ratios, first):
        if options.mesh not in RELATIVE:
            return ratios
        return ratios[0] / first[0], ratios[1] / first[1], ratios[2]

    def measures(path):
        solid = answer('hull', path)
        return [solid[m]['value'] for m in MEASURES]

    wrong, first, rows = 0, None, EXPECTED[options.mesh]
    with tempfile.TemporaryDirectory() as scratch:
        result = pathlib.Path(scratch) / 'result.obj'
        before = measures(mesh)
        for (cost, faces), expected in zip(RUNS, rows):
            answer('simplify', mesh, '--faces', str(faces), '--cost', cost, '--verify', 'none',
                   '-o', result)
            ratios = [y / x for x, y in zip(before, measures(result))]
            first = first or ratios
            pairs = zip(compared(ratios, first), compared(expected, rows[0]))
            is_right = all(abs(r - e) < tolerance for r, e in pairs)
            wrong += not is_right
            print(f'by {cost:10} to {faces:2}: ' + ' '.join(f'{r:.5f}' for r in ratios) +
                  ('' if is_right else f'  expected {expected}'))
    return bool(wrong)


if __name__ == '__main__':
    sys.exit(main())
