#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Rays and boxes against trees of hulls over ever more parts of a cow: is the number of visits logarithmic, as
[Backenhof2011] says of such a hierarchy, and is every answer that of brute force?

Usage: bvh.py --convexact PROGRAM [--cow FILE] [--json FILE] [--plot FILE.svg]
       bvh.py --convexact PROGRAM --mesh FILE [--mesh FILE...] [--json FILE]

The cow of the thesis has 5,804 triangles and may not be shipped: name its file. Without it spot stands in. Trees are
built over the parts of both methods at --concavity 0 --max-parts N, so that hacd merges on and acd splits on until
there are N; parts inside others are left out, so there may be fewer leaves. The parts of hacd are also joined by the
least volume of the common hull, as parts of a file are: the rows "volume". Half the rays start on a sphere around the
shape and run to a random point of its box; the other half start at a random point of the box, in a random direction.

A sample of the answers for each tree is decided again in Python's fractions, part by part. With --brute, more rays are
cast at each part on its own by `convexact query rays`. Exit code 1 if an answer differs, or if rays against 64 parts of
the cow visit more than a third of the nodes on average.

With --mesh, the parts are those of the defaults of both methods, and branches have at most 16 halfspaces.
"""
import argparse
import itertools
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile
import time
from fractions import Fraction

from hacd import COW_TRIANGLES, ROOT, triangles_of

sys.path.insert(0, str(ROOT / 'tests' / 'field'))
from judge_tree import Judged, read_tree  # noqa: E402

METHODS = ('hacd', 'volume', 'acd')
FACES = (None, 16)  # halfspaces of branches
JUDGED_PARTS, JUDGED_SHARE = 64, Fraction(1, 3)


def run(program, *arguments):
    ran = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, check=True)
    return json.loads(ran.stdout)


# ---- Questions


def box_of(mesh):
    words = (line.split() for line in pathlib.Path(mesh).read_text(encoding='utf-8').splitlines())
    points = [tuple(map(float, line[1:4])) for line in words if line[:1] == ['v']]
    return tuple(map(min, zip(*points))), tuple(map(max, zip(*points)))


def random_rays(source, box, count):
    """(origin, direction) by turns from outside, at a point of the box, and from inside the box."""
    low, high = box
    middle = [(a + b) / 2 for a, b in zip(low, high)]
    radius = math.dist(low, high)

    def of_sphere():
        while True:
            point = [source.gauss(0, 1) for _ in range(3)]
            length = math.hypot(*point)
            if length:
                return [x / length for x in point]

    rays = []
    for k in range(count):
        inner = [source.uniform(a, b) for a, b in zip(low, high)]
        if k % 2:
            rays.append((inner, of_sphere()))
        else:
            outer = [m + radius * x for m, x in zip(middle, of_sphere())]
            rays.append((outer, [a - b for a, b in zip(inner, outer)]))
    return rays


def random_boxes(source, box, count):
    """Boxes in the box, with sides from a hundredth to a fifth of its diagonal."""
    low, high = box
    diagonal = math.dist(low, high)
    boxes = []
    for _ in range(count):
        middle = [source.uniform(a, b) for a, b in zip(low, high)]
        half = [diagonal / 2 * math.exp(source.uniform(math.log(0.01), math.log(0.2))) for _ in range(3)]
        boxes.append(([m - h for m, h in zip(middle, half)], [m + h for m, h in zip(middle, half)]))
    return boxes


def write_rays(path, rays):
    path.write_text(''.join(' '.join(map(repr, [*origin, *direction])) + '\n' for origin, direction in rays),
                    encoding='utf-8')
    return path


def write_box(path, box):
    corners = itertools.product(*zip(*box))
    path.write_text(''.join(f'v {x!r} {y!r} {z!r}\n' for x, y, z in corners), encoding='utf-8')
    return path


def write_part(path, points):
    lines = ['v ' + ' '.join(repr(float(x)) for x in point) + '\n' for point in points]
    path.write_text(''.join(lines), encoding='utf-8')
    return path


# ---- Answers of brute force


def first_of(hits):
    """(least t, parts with it) of pairs (part, t or None)."""
    hits = [(t, part) for part, t in hits if t is not None]
    first = min(hits, default=(None, 0))[0]
    return first, sorted(part for t, part in hits if t == first)


def by_fractions(judged, rays, boxes):
    """The answers of brute force over the leaves, in integers and fractions, from the stored numbers."""
    scale = judged.scale
    leaves = [(node.part, hull) for node, hull in zip(judged.tree.nodes, judged.hulls) if node.part is not None]
    assert all(hull.has_its_faces for _, hull in leaves)  # so their planes are those of the hull

    def lift(vector):
        return tuple(Fraction(x) * scale for x in vector)
    rays = [(lift(origin), lift(direction)) for origin, direction in rays]
    cast = [first_of((part, hull.first_hit(*ray)) for part, hull in leaves) for ray in rays]
    met = [sorted(part for part, hull in leaves if hull.meets_box(lift(low), lift(high))) for low, high in boxes]
    return cast, met


def part_by_part(program, tree, file, scratch):
    """The answers of brute force by the program itself, which reads one part at a time, and its seconds."""
    best, seconds = [(None, [])] * len(file.read_text(encoding='utf-8').splitlines()), 0
    for part, (_, points, _) in enumerate(tree.parts):
        answer = run(program, 'query', 'rays', write_part(scratch / 'part.obj', points), file, '--json')
        seconds += seconds_of_rays(answer)
        for k, ray in enumerate(answer['rays']):
            if ray['hit']:
                t = max(Fraction(ray['line']['entry']['exact']), Fraction(0))
                if best[k][0] is None or t < best[k][0]:
                    best[k] = (t, [part])
                elif t == best[k][0]:
                    best[k][1].append(part)
    return best, seconds


def seconds_of_rays(answer):
    """Without reading, checking and writing."""
    return next(stage['seconds'] for stage in answer['stages'] if stage['name'] == 'rays')


def ray_answers(answer):
    return [(Fraction(ray['t']['exact']) if ray['hit'] else None, ray['parts']) for ray in answer['rays']]


# ---- A tree


def mean(numbers):
    return math.fsum(numbers) / len(numbers) if numbers else 0.0


def examine(mesh, method, faces, count, questions, options, scratch):
    """Builds a tree over so many parts, or over those of the defaults, asks it, and compares. The row of the table."""
    program, path = options.convexact, scratch / 'tree.json'
    parts = ['--concavity', '0', '--max-parts', count] if count else []
    source = ['--method', method, *parts]
    if method == 'volume':
        source = ['--from', scratch / 'parts.json']
        run(program, 'decompose', '--method', 'hacd', mesh, *parts, '--measures', 'none', '-o', source[1], '--json')
    began = time.monotonic()
    run(program, 'bvh', mesh, *source, *(['--faces', faces] if faces else []), '-o', path, '--json')
    row = {'shape': pathlib.Path(mesh).stem, 'method': method, 'faces': faces, 'max_parts': count, 'build_seconds': round(time.monotonic() - began, 2)}
    judged = Judged(read_tree(path))
    rays, boxes = questions['rays'], questions['boxes']
    answer = run(program, 'query', 'rays', path, write_rays(scratch / 'rays.txt', rays), '--json')
    overlaps = [run(program, 'query', 'overlap', path, write_box(scratch / 'box.obj', box), '--json') for box in boxes]
    visits = [len(ray['visited']) for ray in answer['rays']]
    row.update(leaves=len(judged.tree.parts), nodes=len(judged.tree.nodes), levels=judged.figures.get('levels'),
               outside=mean(visits[0::2]), inside=mean(visits[1::2]), rays=mean(visits),
               boxes=mean([len(overlap['visited']) for overlap in overlaps]),
               hits=sum(ray['hit'] for ray in answer['rays']), faults=judged.faults)
    if judged.faults:
        return row
    cast, met = by_fractions(judged, rays[:options.sample], boxes)
    given = ray_answers(answer)
    wrong = sum(a != b for a, b in zip(cast, given)) + sum(a != overlap['parts'] for a, overlap in zip(met, overlaps))
    row.update(compared=len(cast) + len(met), differing=wrong)
    if options.brute and count == JUDGED_PARTS:
        file = write_rays(scratch / 'many.txt', questions['many'])
        answer = run(program, 'query', 'rays', path, file, '--json')
        brute, seconds = part_by_part(program, judged.tree, file, scratch)
        row.update(brute_compared=len(brute), tree_seconds=seconds_of_rays(answer), brute_seconds=seconds)
        row['differing'] += sum(a != b for a, b in zip(brute, ray_answers(answer)))
    return row


def show(row):
    def cell(visits):
        return f"{visits:.1f} ({100 * visits / row['nodes']:.0f}%)"
    made = (row['shape'], row['method'], row['faces'] or 'all', row['leaves'], row['nodes'], row['levels'],
            f"{row['build_seconds']:.1f}", cell(row['outside']), cell(row['inside']), cell(row['boxes']),
            f"{row['differing']} of {row['compared']}" if 'compared' in row else 'not judged')
    print('| ' + ' | '.join(map(str, made)) + ' |', flush=True)


HEAD = ('shape', 'joined by', 'faces of branches', 'leaves', 'nodes', 'levels', 'seconds to build',
        'visits of a ray from outside', 'from inside', 'visits of a box', 'answers unlike brute force')


# ---- The plot


SERIES = {('hacd', None): ('#1b6ca8', ''), ('hacd', 16): ('#1b6ca8', '6 4'), ('volume', None): ('#2e8b57', ''),
          ('volume', 16): ('#2e8b57', '6 4'), ('acd', None): ('#c0392b', ''), ('acd', 16): ('#c0392b', '6 4')}
WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 800, 460, 64, 250, 24, 52


def plot(rows):
    """Visits of a ray over the number of leaves, whose axis is logarithmic, as an SVG."""
    most_leaves, least_leaves = max(row['leaves'] for row in rows), min(row['leaves'] for row in rows)
    most = 1.25 * max(row['rays'] for row in rows)
    first, last = math.log2(least_leaves) - 0.1, math.log2(most_leaves) + 0.1

    def at(leaves, visits):
        x = LEFT + (math.log2(leaves) - first) / (last - first) * (WIDTH - LEFT - RIGHT)
        return f'{x:.1f},{HEIGHT - BOTTOM - visits / most * (HEIGHT - TOP - BOTTOM):.1f}'

    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" font-family="sans-serif" '
           'font-size="13">', f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>']

    def text(place, words, more=''):
        x, y = place.split(',')
        out.append(f'<text x="{x}" y="{y}" {more}>{words}</text>')

    def line(points, colour, dashes, width=2):
        out.append(f'<polyline points="{" ".join(points)}" fill="none" stroke="{colour}" stroke-width="{width}" '
                   f'stroke-dasharray="{dashes}"/>')

    step = next(s for s in (1, 2, 5, 10, 20, 50, 100) if most / s < 9)
    for visits in range(0, int(most) + 1, step):
        x, y = at(2 ** first, visits).split(',')
        line([f'{x},{y}', at(2 ** last, visits)], '#ddd', '', 1)
        text(f'{float(x) - 6:.1f},{float(y) + 4:.1f}', visits, 'text-anchor="end"')
    for power in range(math.ceil(first), math.floor(last) + 1):
        x, y = at(2 ** power, 0).split(',')
        line([f'{x},{y}', at(2 ** power, most)], '#ddd', '', 1)
        text(f'{x},{float(y) + 18:.1f}', 2 ** power, 'text-anchor="middle"')
    text(f'{(LEFT + WIDTH - RIGHT) / 2},{HEIGHT - 12}', 'leaves (logarithmic)', 'text-anchor="middle"')
    text(f'18,{HEIGHT / 2}', f"nodes that a ray visits, {rows[0]['shape']}",
         f'text-anchor="middle" transform="rotate(-90 18 {HEIGHT / 2})"')

    top = TOP + 20
    samples = [2 ** (first + (last - first) * k / 200) for k in range(201)]
    guides = [('brute force: leaves', '#555', '2 3', [(n, n) for n in samples if n <= most]),
              ('log2(leaves)', '#999', '1 4', [(n, math.log2(n)) for n in samples])]
    lines = [(f"{method}, {'branches of ' + str(faces) + ' faces' if faces else 'exact hulls'}", *style,
              sorted((row['leaves'], row['rays']) for row in rows if (row['method'], row['faces']) == (method, faces)))
             for (method, faces), style in SERIES.items()]
    for name, colour, dashes, points in lines + guides:
        line([at(*point) for point in points], colour, dashes)
        x = WIDTH - RIGHT + 16
        line([f'{x},{top}', f'{x + 28},{top}'], colour, dashes)
        text(f'{x + 36},{top + 4}', name)
        top += 24
    return '\n'.join(out) + '\n</svg>\n'


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--convexact', required=True)
    parser.add_argument('--cow')
    parser.add_argument('--mesh', action='append', default=[], help='instead of the cow; may be repeated')
    parser.add_argument('--parts', default='4,8,16,32,64,128', help='numbers of parts (default 4,8,16,32,64,128)')
    parser.add_argument('--rays', type=int, default=1000, help='against each tree (default 1000)')
    parser.add_argument('--sample', type=int, default=30, help='of these, decided again by fractions (default 30)')
    parser.add_argument('--boxes', type=int, default=20, help='against each tree, all decided again (default 20)')
    parser.add_argument('--brute', type=int, default=0,
                        help=f'rays against each tree of {JUDGED_PARTS} parts, and against each part (default 0)')
    parser.add_argument('--seed', type=int, default=1)
    parser.add_argument('--json')
    parser.add_argument('--plot')
    options = parser.parse_args()
    rows, counts, all_faces = [], list(map(int, options.parts.split(','))), FACES
    if options.mesh:
        meshes, counts, all_faces = options.mesh, (None,), FACES[-1:]
    elif options.cow:
        found = triangles_of(options.cow)
        if found != COW_TRIANGLES:
            sys.exit(f'{options.cow}: {found} triangles, the cow of the thesis has {COW_TRIANGLES}')
        meshes = [options.cow]
    else:
        print('skipped: the cow, since --cow names no file; spot stands in')
        meshes = [ROOT / 'tests/data/spot.obj']
    print('\n| ' + ' | '.join(HEAD) + ' |\n|' + '---|' * len(HEAD), flush=True)
    with tempfile.TemporaryDirectory() as scratch:
        for mesh in meshes:
            source, box = random.Random(options.seed), box_of(mesh)
            questions = {'rays': random_rays(source, box, options.rays),
                         'boxes': random_boxes(source, box, options.boxes),
                         'many': random_rays(source, box, options.brute)}
            for method, faces, count in itertools.product(METHODS, all_faces, counts):
                rows.append(examine(mesh, method, faces, count, questions, options, pathlib.Path(scratch)))
                show(rows[-1])
    if options.json:
        pathlib.Path(options.json).write_text(json.dumps(rows, indent=1) + '\n', encoding='utf-8')
    if options.plot:
        pathlib.Path(options.plot).write_text(plot(rows), encoding='utf-8')
    return conclude(rows, bool(options.cow))


def conclude(rows, is_cow):
    status = 0
    for row in rows:
        name = f"{row['shape']}, {row['method']}, {row['faces'] or 'all'} faces, {row['leaves']} leaves"
        if 'brute_compared' in row:
            print(f"{name}: {row['brute_compared']} rays take {row['tree_seconds']:.2f} s with the tree, and "
                  f"{row['brute_seconds']:.2f} s against one part after another")
        if row['faults'] or row['differing']:
            print(f"{name}: {row['faults'] or str(row['differing']) + ' answers differ'}", file=sys.stderr)
            status = 1
        if row['max_parts'] == JUDGED_PARTS:
            share = row['rays'] / row['nodes']
            print(f"{name}: a ray visits {100 * share:.1f}% of the nodes")
            if is_cow and share > JUDGED_SHARE:
                print(f'{name}: more than a third', file=sys.stderr)
                status = 1
    return status


if __name__ == '__main__':
    sys.exit(main())
