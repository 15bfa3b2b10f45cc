#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Removals to 18 faces against the hull, and how their time grows: figure 6 of [Jacobson2026].

Usage: timing.py --convexact PROGRAM [--meshes FOLDER] [--points N] [--repeats 5] [--json FILE]

The paper's 133 scans are not at hand; our meshes and points on a sphere stand in. Times are those of the stages of one
run, the least of the repeats.
"""
import math
import statistics
import sys

from support.experiment import NOT_COMPARABLE, Experiment, scratch


def seconds_of(experiment, mesh):
    """Halfspaces of the hull, seconds of hull and dual, seconds of the removals."""
    best = None
    for _ in range(experiment.options.repeats):
        answer = experiment.run('simplify', mesh, '--faces', 18, '--verify', 'none')
        took = {stage['name']: stage.get('seconds', 0) for stage in answer['stages']}
        pair = (took['hull'], took['simplify'])
        best = pair if best is None else tuple(map(min, best, pair))
    return answer['input']['halfspaces'], *best


def exponent(sizes, times):
    """The slope of a straight line through the logarithms, by least squares."""
    x, y = [math.log(size) for size in sizes], [math.log(time) for time in times]
    middle, height = statistics.fmean(x), statistics.fmean(y)
    return sum((a - middle) * (b - height) for a, b in zip(x, y)) / sum((a - middle) ** 2 for a in x)


def main():
    def add_options(parser):
        parser.add_argument('--points', type=int, default=64000, help='of the largest sphere')
        parser.add_argument('--repeats', type=int, default=5)

    experiment = Experiment(__file__, 'figure 6', __doc__, add_options)
    rows, shares, slowest = [], [], 0
    for name, mesh in experiment.meshes():
        size, hull, removals = seconds_of(experiment, mesh)
        rows.append([name, size, f'{1000 * hull:.1f}', f'{1000 * removals:.1f}', f'{100 * removals / hull:.0f}%'])
        shares.append(removals / hull)
        slowest = max(slowest, removals)
    sizes, times = [], []
    with scratch() as folder:
        count = 1000
        while count <= experiment.options.points:
            sphere = f'{folder}/sphere.xyz'
            experiment.run('generate', 'random-sphere', '--points', count, '-o', sphere)
            size, hull, removals = seconds_of(experiment, sphere)
            rows.append([f'{count:,} points on a sphere', size, f'{1000 * hull:.1f}', f'{1000 * removals:.1f}',
                         f'{100 * removals / hull:.0f}%'])
            sizes.append(size)
            times.append(removals)
            count *= 2
    experiment.claim('removals take 32% of the time of the hull (median of 133 scans)',
                     f'{100 * statistics.median(shares):.0f}% of the time of our hull (median of {len(shares)} meshes)',
                     NOT_COMPARABLE)
    experiment.claim('every scan in less than a second', f'the slowest mesh takes {1000 * slowest:.0f} ms', slowest < 1)
    if len(sizes) > 1:
        slope = exponent(sizes, times)
        experiment.claim('time grows as n log n', f'as n to the {slope:.2f} on spheres of {sizes[0]:,} to {sizes[-1]:,} '
                         'halfspaces', slope < 1.25)
    experiment.table('Milliseconds', ['input', 'halfspaces', 'hull', 'removals to 18', 'removals over hull'], rows)
    return experiment.finish()


if __name__ == '__main__':
    sys.exit(main())
