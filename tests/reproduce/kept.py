#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Faces that must stay: figure 15 of [Jacobson2026], whose hammer keeps its base and its striking face.

Usage: kept.py --convexact PROGRAM [--meshes FOLDER] [--json FILE]

The hammer is not at hand. Each mesh keeps the facets whose normals are nearest to straight down and to straight ahead,
and what that costs in volume is shown. The paper prints no number.
"""
import sys

from support.experiment import NOT_COMPARABLE, Experiment, ratio

DOWN, AHEAD = 'normal:0,-1,0', 'normal:0,0,1'
COUNTS = (18, 12)


def main():
    experiment = Experiment(__file__, 'figure 15', __doc__)
    rows, survive, most = [], True, 0
    for name, mesh in experiment.meshes():
        for count in COUNTS:
            free = experiment.run('simplify', mesh, '--faces', count)
            keeping = experiment.run('simplify', mesh, '--faces', count, '--keep', DOWN, '--keep', AHEAD)
            kept = keeping['kept']
            survive = survive and keeping['output']['halfspaces'] == count and len(kept) >= 1
            cost = ratio(keeping) / ratio(free) - 1
            most = max(most, cost)
            rows.append([name, count, len(kept), f'{ratio(free):.5f}', f'{ratio(keeping):.5f}', f'{100 * cost:.2f}%'])
    experiment.claim('faces can be kept by giving their removal an infinite cost',
                     f'every run ends with all of them, at a volume at most {100 * most:.1f}% larger' if survive
                     else 'a run lost some', survive, interval='all kept', why='the paper\'s words')
    experiment.claim('a hammer keeps its base and striking face', 'the hammer is not at hand', NOT_COMPARABLE)
    experiment.table('Volume over that of the hull, with and without two kept directions',
                     ['mesh', 'faces', 'kept facets', 'free', 'keeping', 'more'], rows)
    return experiment.finish()


if __name__ == '__main__':
    sys.exit(main())
