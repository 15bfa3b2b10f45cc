#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Eight parts under one budget of planes, and no gaps: figures 1 and 10 of [Jacobson2026].

Usage: parts.py --convexact PROGRAM [--meshes FOLDER] [--json FILE]

The paper's decomposed scenes are not at hand. Here the triangles of a mesh are halved three times, at the median of
their centroids along the longest side; the points of a part are the corners of its triangles. 144 planes are shared
out as 18 for each part, and by one queue over all parts. Dropping vertices to as many triangles stands for the
proxies that leave gaps: a triangle has one if a corner of it lies outside of the proxy of its part.
"""
import sys
from fractions import Fraction

from support.experiment import DIFFERS, SAME_ORDER, Experiment, faces_of, points_of, scratch

PARTS, PLANES = 8, 18
VERTICES = 2 + PLANES // 2  # of a closed triangle mesh with as many triangles


def halves(triangles, centroid):
    """Two lists, by the median along the longest side of the centroids' box."""
    axis = max(range(3), key=lambda k: max(centroid[t][k] for t in triangles) - min(centroid[t][k] for t in triangles))
    ordered = sorted(triangles, key=lambda t: (centroid[t][axis], t))
    return ordered[:len(ordered) // 2], ordered[len(ordered) // 2:]


def write_parts(mesh, file):
    """One object for each part. Returns the triangles of each, as points."""
    points = points_of(mesh)
    triangles = [(f[0], f[k], f[k + 1]) for f in faces_of(mesh) for k in range(1, len(f) - 1)]
    centroid = [tuple(sum(points[v][k] for v in t) for k in range(3)) for t in triangles]
    lists = [list(range(len(triangles)))]
    while len(lists) < PARTS:
        lists = [half for triangle_list in lists for half in halves(triangle_list, centroid)]
    with open(file, 'w', encoding='utf-8') as out:
        out.writelines('v ' + ' '.join(map(repr, p)) + '\n' for p in points)
        for k, members in enumerate(lists):
            out.write(f'o part{k}\n')
            out.writelines('f ' + ' '.join(str(v + 1) for v in triangles[t]) + '\n' for t in members)
    return [[[points[v] for v in triangles[t]] for t in members] for members in lists]


def gaps(triangles, planes):
    """How many triangles have a corner beyond a plane (n, d): exactly."""
    rows = [[int(number) for number in plane] for plane in planes]
    outside = {}

    def is_outside(p):
        if p not in outside:
            exact = [Fraction(x) for x in p]
            outside[p] = any(sum(n * x for n, x in zip(row, exact)) + row[3] > 0 for row in rows)
        return outside[p]

    return sum(any(is_outside(p) for p in triangle) for triangle in triangles)


def main():
    experiment = Experiment(__file__, 'figures 1 and 10', __doc__)
    rows, outer_gaps, inner_gaps, worst = [], 0, 0, 0
    with scratch() as folder:
        for name, mesh in experiment.meshes():
            file = f'{folder}/{name}.obj'
            parts = write_parts(mesh, file)
            uniform = experiment.run('simplify', file, '--parts', '--faces', PLANES)
            shared = experiment.run('simplify', file, '--parts', '--total-faces', PARTS * PLANES)
            dropped = experiment.run('simplify', file, '--parts', '--inner', '--vertices', VERTICES)
            hull, *volumes = (sum(part['volume'][end]['value'] for part in run['objects'])
                              for run, end in ((uniform, 'input'), (uniform, 'output'), (shared, 'output'),
                                               (dropped, 'output')))
            count = [sum(gaps(triangles, part['output']['planes']) for triangles, part in zip(parts, run['objects']))
                     for run in (uniform, shared, dropped)]
            outer_gaps += count[0] + count[1]
            inner_gaps += count[2]
            worst = max(worst, volumes[0] / hull)
            all_triangles = sum(map(len, parts))
            rows.append([name, *(f'{volume / hull:.5f}' for volume in volumes), f'{count[0]}, {count[1]}',
                         f'{count[2]:,} of {all_triangles:,}'])
    experiment.claim('the simplified parts leave no gaps', f'{outer_gaps} triangles stick out of their part',
                     outer_gaps == 0, interval='0', why='decided exactly')
    experiment.claim('dropping vertices does', f'{inner_gaps:,} do', inner_gaps > 0, interval='> 0', why='decided exactly')
    experiment.claim('the volume hardly grows', f'by at most {100 * (worst - 1):.1f}% with {PLANES} planes for a part',
                     SAME_ORDER if worst < 1.05 else DIFFERS, interval='no number in the paper',
                     why='same order: < 5%, which the paper calls little at 18 faces')
    experiment.table(f'Volume of {PARTS} parts over that of their hulls, and triangles that stick out',
                     ['mesh', f'{PLANES} each', f'{PARTS * PLANES} shared', f'dropped to {VERTICES} vertices',
                      'stick out, each and shared', 'stick out, dropped'], rows)
    return experiment.finish()


if __name__ == '__main__':
    sys.exit(main())
