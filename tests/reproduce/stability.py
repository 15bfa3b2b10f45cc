#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The same shape in other points: figure 13 of [Jacobson2026].

Usage: stability.py --convexact PROGRAM [--meshes FOLDER] [--seed 1] [--json FILE]

Subsets of the points, blue noise on the surface, points merged in the cells of a grid, rounding to binary32, noise of a
share of the diameter; and two changes that leave the hull as it is, midpoints of all edges and triangles merged to
quads. The paper shows that the result hardly changes, without a number. Selection jumps, so there is no bound to test:
the measure is the volume of a result over that of its own hull. Meshes that lose edges are left out, as a script has no
way to make them.
"""
import math
import random
import struct
import sys
from fractions import Fraction

from support.experiment import DIFFERS, SAME_ORDER, Experiment, faces_of, points_of, ratio, scratch

COUNTS = (18, 12)
JUDGED = 18
MOST_CHANGE = 0.01  # of the volume over that of the own hull


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def diameter_of(points):
    return math.dist(*([pick(p[k] for p in points) for k in range(3)] for pick in (min, max)))


def triangles_of(faces):
    return [(face[0], face[k], face[k + 1]) for face in faces for k in range(1, len(face) - 1)]


def blue_noise(points, triangles, count, source):
    """Up to so many points on the surface, none nearer to another than a radius: darts that hit too near are dropped."""
    areas = [math.sqrt(dot(n, n)) / 2 for n in
             (cross(minus(points[b], points[a]), minus(points[c], points[a])) for a, b, c in triangles)]
    radius = 0.75 * math.sqrt(sum(areas) / count)  # with 0.83 no further dart would fit
    kept, cells = [], {}
    for a, b, c in source.choices(triangles, areas, k=20 * count):
        u, v = source.random(), source.random()
        if u + v > 1:
            u, v = 1 - u, 1 - v
        p = tuple(x + u * (y - x) + v * (z - x) for x, y, z in zip(points[a], points[b], points[c]))
        cell = tuple(math.floor(x / radius) for x in p)
        near = (cells.get((cell[0] + i, cell[1] + j, cell[2] + k), ())
                for i in (-1, 0, 1) for j in (-1, 0, 1) for k in (-1, 0, 1))
        if all(math.dist(p, q) >= radius for block in near for q in block):
            kept.append(p)
            cells.setdefault(cell, []).append(p)
        if len(kept) == count:
            break
    return kept


def merged(points, edge):
    """The mean of the points in each cell of a grid."""
    cells = {}
    for p in points:
        cells.setdefault(tuple(math.floor(x / edge) for x in p), []).append(p)
    return [tuple(math.fsum(p[k] for p in block) / len(block) for k in range(3)) for block in cells.values()]


def with_midpoints(points, triangles):
    """All numbers spelled exactly: a midpoint need not be a double."""
    edges = {tuple(sorted((t[k], t[(k + 1) % 3]))) for t in triangles for k in range(3)}
    middles = [tuple((Fraction(x) + Fraction(y)) / 2 for x, y in zip(points[a], points[b])) for a, b in sorted(edges)]
    return [tuple(map(spelled, p)) for p in points + middles]


def spelled(number):
    """A fraction over a power of two as a decimal, exactly."""
    number = Fraction(number)
    digits = number.denominator.bit_length() - 1
    return f'{number.numerator * 5 ** digits}e-{digits}'


def to_binary32(p):
    return tuple(struct.unpack('f', struct.pack('f', x))[0] for x in p)


def variants(points, triangles, seed):
    """(name, points, whether they are spelled exactly)."""
    def source(what):
        return random.Random(f'{seed} {what}')

    size = diameter_of(points)
    for share in (50, 25, 10, 2):
        what = f'{share}% of the points'
        yield what, source(what).sample(points, max(4, len(points) * share // 100)), False
    yield 'blue noise', blue_noise(points, triangles, max(100, len(points) // 10), source('blue noise')), False
    for power in (7, 6, 5):
        yield f'merged on a grid of 2^-{power}', merged(points, size / 2 ** power), False
    yield 'binary32', [to_binary32(p) for p in points], False
    for share in ('1e-9', '1e-6', '1e-4', '1e-2'):
        most, what = float(share) * size, f'noise of {share}'
        drawn = source(what)
        yield what, [tuple(x + drawn.uniform(-most, most) for x in p) for p in points], False
    yield 'with midpoints', with_midpoints(points, triangles), True


def missed(points, planes):
    """How many points lie beyond a plane: doubles first, and exact numbers where these are close."""
    rows = [tuple(map(int, plane)) for plane in planes]
    near = []
    for row in rows:
        n = tuple(float(Fraction(x, max(map(abs, row)))) for x in row)
        near.append((n, row))
    count = 0
    for p in points:
        for n, row in near:
            value = n[0] * p[0] + n[1] * p[1] + n[2] * p[2] + n[3]
            if value < -1e-9 * (abs(p[0]) + abs(p[1]) + abs(p[2]) + 1):
                continue
            if sum(Fraction(x) * y for x, y in zip(p, row)) + row[3] > 0:
                count += 1
                break
    return count


def nearest_in(planes, p):
    """The point of a solid that is nearest to p, by Dykstra's projections, in doubles."""
    x, moves = p, [(0.0, 0.0, 0.0)] * len(planes)
    for _ in range(200):
        before = x
        for i, (n, d) in enumerate(planes):
            y = tuple(a + b for a, b in zip(x, moves[i]))
            beyond = max(0.0, dot(n, y) + d)
            x = tuple(a - beyond * b for a, b in zip(y, n))
            moves[i] = minus(y, x)
        if math.dist(before, x) < 1e-12:
            break
    return x


def unit_planes(planes):
    result = []
    for plane in planes:
        row = tuple(map(int, plane))
        n = [float(Fraction(x, max(map(abs, row)))) for x in row]
        length = math.sqrt(dot(n[:3], n[:3]))
        result.append((tuple(x / length for x in n[:3]), n[3] / length))
    return result


def distance(a, b):
    """Hausdorff distance of two results: of a vertex of either from the other."""
    return max(math.dist(p, nearest_in(unit_planes(other['output']['planes']), p))
               for one, other in ((a, b), (b, a)) for p in one['vertices'])


def simplified(experiment, file, count, folder, exact=False):
    mesh = f'{folder}/result.obj'
    answer = experiment.run('simplify', file, '--faces', count, '-o', mesh,
                            *(('--decimal', 'exact') if exact else ()))
    answer['vertices'] = points_of(mesh)
    return answer


def quads_of(triangles):
    """Pairs of triangles with a common edge, each in one pair at most; the others stay."""
    partner, faces = {}, []
    waiting = {}
    for t in triangles:
        for k in range(3):
            other = waiting.get((t[(k + 1) % 3], t[k]))
            if other is not None and other not in partner and t not in partner:
                partner[t], partner[other] = other, t
                apex = next(v for v in other if v not in t)
                faces.append((t[k], apex, t[(k + 1) % 3], t[(k + 2) % 3]))
        for k in range(3):
            waiting[t[k], t[(k + 1) % 3]] = t
    return faces + [t for t in triangles if t not in partner]


def main():
    def add_options(parser):
        parser.add_argument('--seed', type=int, default=1)

    experiment = Experiment(__file__, 'figure 13', __doc__, add_options)
    rows, identical, most = [], True, (0, '')
    with scratch() as folder:
        file = f'{folder}/points.xyz'
        for name, mesh in experiment.meshes():
            points, triangles = points_of(mesh), triangles_of(faces_of(mesh))
            size = diameter_of(points)
            before = {count: simplified(experiment, mesh, count, folder) for count in COUNTS}
            quads = f'{folder}/quads.obj'
            with open(quads, 'w', encoding='utf-8') as out:
                out.writelines('v ' + ' '.join(map(repr, p)) + '\n' for p in points)
                out.writelines('f ' + ' '.join(str(v + 1) for v in face) + '\n' for face in quads_of(triangles))
            for count in COUNTS:
                same = simplified(experiment, quads, count, folder)['output']['planes'] == \
                    before[count]['output']['planes']
                identical = identical and same
                rows.append([name, count, 'quads', *['the same' if same else 'OTHER'] * 6])
            for what, changed, exact in variants(points, triangles, experiment.options.seed):
                with open(file, 'w', encoding='utf-8') as out:
                    out.writelines(' '.join(map(str, p)) + '\n' for p in changed)
                for count in COUNTS:
                    old, new = before[count], simplified(experiment, file, count, folder, exact)
                    if exact:
                        same = new['output']['planes'] == old['output']['planes']
                        identical = identical and same
                        rows.append([name, count, what, *['the same' if same else 'OTHER'] * 6])
                        continue
                    change = abs(ratio(new) - ratio(old))
                    if count == JUDGED:
                        most = max(most, (change, f'{name}, {what}'))
                    volume = {key: new['volume'][key]['value'] / old['volume'][key]['value']
                              for key in ('input', 'output')}
                    rows.append([name, count, what, new['input']['halfspaces'], f'{volume["input"]:.4f}',
                                 f'{volume["output"]:.4f}', f'{ratio(new):.4f} ({ratio(old):.4f})',
                                 f'{distance(old, new) / size:.4f}', missed(points, new['output']['planes'])])
    experiment.claim('stable: the result is that of the hull', 'the same planes wherever the hull is the same'
                     if identical else 'another result from the same hull', identical, interval='the same',
                     why='the result is a function of the hull')
    experiment.claim('stable: other points of the same shape', f'at {JUDGED} faces the volume over that of its own '
                     f'hull changes by at most {most[0]:.4f} ({most[1]})', SAME_ORDER if most[0] <= MOST_CHANGE else DIFFERS,
                     interval='no number in the paper', why='same order: at most 0.01, a quarter of what 18 faces add')
    experiment.record['skipped'] += ['decimated meshes: a script has no way to make them',
                                     'distances of the hulls: they take too long in a script']
    experiment.table('Volumes over those of the unchanged mesh; distances of the results in diameters, '
                     'about; points of the unchanged mesh that the result misses, which it does not promise to hold',
                     ['mesh', 'faces', 'change', 'facets', 'hull', 'result', 'over its own hull (before)', 'distance',
                      'missed'], rows)
    return experiment.finish()


if __name__ == '__main__':
    sys.exit(main())
