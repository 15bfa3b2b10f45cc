#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Very few faces: figure 3 of [Jacobson2026], which claims the least volume, area and distance of all methods.

Usage: extreme.py --convexact PROGRAM [--meshes FOLDER] [--json FILE]

12, 8 and 6 faces. The paper's point cloud is not at hand. Methods beyond the paper (search) and greedy runs by other
costs are shown and not ranked.
"""
import sys

from support.experiment import Experiment, compared, fitting

COUNTS = (12, 8, 6)
EQUAL = 1e-12
KEYS = {'volume': 'volume', 'area': 'area', 'Hausdorff distance': 'distance'}
UNRANKED = ('search', 'greedy-area', 'greedy-mean-width')


def against_paper(changes):
    """changes: by case, its volume over that of greedy, less 1."""
    if not changes:
        return None
    others = [change for change in changes if abs(change) >= EQUAL]
    words = f'equal to greedy in {len(changes) - len(others)} of {len(changes)} cases'
    return words + (f', else {100 * min(others):+.2g}% to {100 * max(others):+.2g}%' if others else '')


def main():
    experiment = Experiment(__file__, 'figure 3', __doc__)
    rows, beaten, runs, theirs = [], {what: [] for what in KEYS}, 0, []
    paper = experiment.paper_program()
    for name, mesh in experiment.meshes():
        of_paper = experiment.paper_ratios(paper, mesh, COUNTS)
        for count in COUNTS:
            made = compared(experiment, mesh, count)
            ranked = [method for method in fitting(made) if method not in UNRANKED]
            runs += 1
            if of_paper[count]:
                theirs.append(of_paper[count] / made['greedy']['volume']['value'] - 1)
            for what, key in KEYS.items():
                best = min(ranked, key=lambda method: made[method][key]['value'])
                ours, least = made['greedy'][key]['value'], made[best][key]['value']
                if best != 'greedy':
                    beaten[what].append(f'{name} at {count}: {best}')
                rows.append([name, count, what, f'{ours:.4f}', f'{made["search"][key]["value"]:.4f}',
                             'greedy' if best == 'greedy' else f'{best}, {least:.4f}'])
    for what, where in beaten.items():
        experiment.claim(f'least {what} of all methods', f'in {runs - len(where)} of {runs} cases'
                         + (f'; less: {", ".join(where)}' if where else ''), not where, interval='in all',
                         why='the paper\'s words', pchs=against_paper(theirs) if what == 'volume' else None)
    experiment.table('Over those of the hull; distances over the diameter',
                     ['mesh', 'faces', 'measure', 'greedy', 'with search', 'least of the ranked'], rows)
    return experiment.finish()


if __name__ == '__main__':
    sys.exit(main())
