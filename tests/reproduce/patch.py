#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A sphere with a dense patch: figures 4 and 5 of [Jacobson2026].

Usage: patch.py --convexact PROGRAM [--json FILE]

60 points spread over a sphere, alone and with 2,000 more within 20 degrees of its pole. k-means of facet normals spends
its planes on the patch; greedy removals do not. No number in the paper.
"""
import math
import sys

from support.experiment import Experiment, compared, scratch

FACES, EVEN, DENSE, DEGREES = 18, 60, 2000, 20
METHODS = ('greedy', 'stl')
GOLDEN = math.pi * (3 - math.sqrt(5))


def spread(count, lowest):
    """Points of equal area shares between the height `lowest` and the pole, along a Fibonacci spiral."""
    points = []
    for i in range(count):
        z = 1 - (1 - lowest) * (i + 0.5) / count
        r = math.sqrt(1 - z * z)
        points.append((r * math.cos(GOLDEN * i), r * math.sin(GOLDEN * i), z))
    return points


def in_patch(planes):
    """How many have their normal within the patch."""
    def slope(plane):
        x, y, z = (int(number) for number in plane[:3])
        largest = max(abs(x), abs(y), abs(z))
        x, y, z = x / largest, y / largest, z / largest
        return z / math.sqrt(x * x + y * y + z * z)

    return sum(slope(plane) > math.cos(math.radians(DEGREES)) for plane in planes)


def main():
    experiment = Experiment(__file__, 'figures 4 and 5', __doc__)
    even = spread(EVEN, -1)
    shapes = {'even': even, 'with the patch': even + spread(DENSE, math.cos(math.radians(DEGREES)))}
    rows, volume, inside = [], {}, {}
    with scratch() as folder:
        for shape, points in shapes.items():
            file = f'{folder}/points.xyz'
            with open(file, 'w', encoding='utf-8') as out:
                out.writelines(' '.join(map(repr, p)) + '\n' for p in points)
            made = compared(experiment, file, FACES, METHODS)
            for method in METHODS:
                volume[method, shape] = made[method]['volume']['value']
                inside[method, shape] = in_patch(made[method]['halfspaces'])
                rows.append([shape, method, f'{volume[method, shape]:.4f}', inside[method, shape]])
    dense, plain = 'with the patch', 'even'
    experiment.claim('k-means of normals gets worse by the patch',
                     f'{volume["stl", plain]:.4f} becomes {volume["stl", dense]:.4f}, '
                     f'{inside["stl", dense]} of {FACES} planes face the patch',
                     volume['stl', dense] > volume['stl', plain], interval='larger', why='the paper\'s words')
    experiment.claim('greedy removals get better',
                     f'{volume["greedy", plain]:.4f} becomes {volume["greedy", dense]:.4f}, '
                     f'{inside["greedy", dense]} of {FACES} planes face the patch',
                     volume['greedy', dense] < volume['greedy', plain], interval='smaller', why='the paper\'s words')
    experiment.table(f'{FACES} faces: volume over that of the hull, and planes that face the patch',
                     ['points', 'method', 'volume', 'in the patch'], rows)
    return experiment.finish()


if __name__ == '__main__':
    sys.exit(main())
