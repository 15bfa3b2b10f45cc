#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Hulls inside of the hull: figure 14 of [Jacobson2026], vertices dropped one after another beside edge collapses.

Usage: inner.py --convexact PROGRAM [--meshes FOLDER] [--json FILE]

`drop` removes the vertex that loses the least volume, `qem-ends` collapses edges onto one of their ends by quadrics.
The paper prints no number.
"""
import statistics
import sys

from support.experiment import Experiment

COUNTS = (100, 50, 32, 18, 12, 8, 4)
METHODS = ('drop', 'qem-ends')


def claim(experiment, pairs):
    """pairs: (run, volume kept by drop, by qem-ends), without runs that keep every vertex."""
    behind = sorted((drop - ends, run) for run, drop, ends in pairs if drop < ends)
    equal = [run for run, drop, ends in pairs if drop == ends]
    here = f'in {len(pairs) - len(behind) - len(equal)} of {len(pairs)} runs'
    if equal:
        here += f'; the same volume for {", ".join(equal)}'
    if behind:
        runs = ', '.join(run for _, run in behind)
        here += f'; collapses keep more for {runs}, at most {-100 * behind[0][0]:.2f}% of the hull'
    experiment.claim('tighter than QEM edge collapse onto endpoints', here, not behind and not equal, interval='in all',
                     why='the paper\'s words; its program has no inner hulls')


def main():
    experiment = Experiment(__file__, 'figure 14', __doc__)
    rows, pairs, gains = [], [], {count: [] for count in COUNTS}
    for name, mesh in experiment.meshes():
        for count in COUNTS:
            answer = experiment.run('compare', mesh, '--inner', '--vertices', count, '--methods', 'drop,qem-ends')
            of_input = answer['inputs'][0]
            if of_input['vertices'] <= count:
                continue  # nothing to remove
            made = {of['method']: of for of in of_input['methods']}
            # Vertices in one plane keep no volume.
            drop, ends = (0 if 'flat' in made[method] else made[method]['volume']['value'] for method in METHODS)
            pairs.append((f'{name} at {count}', drop, ends))
            gains[count].append((drop, ends))
            rows.append([name, count, f'{drop:.5f}', f'{ends:.5f}', f'{100 * (drop - ends):.2f}%'])
    claim(experiment, pairs)
    experiment.table('Median over the meshes with more vertices', ['vertices', 'meshes', *METHODS, 'drop ahead'],
                     [[count, len(of), *(f'{statistics.median(volumes):.5f}' for volumes in zip(*of)),
                       sum(drop > ends for drop, ends in of)] for count, of in gains.items() if of])
    experiment.table('Volume inside over that of the hull', ['mesh', 'vertices', *METHODS, 'drop keeps more'], rows)
    return experiment.finish()


if __name__ == '__main__':
    sys.exit(main())
