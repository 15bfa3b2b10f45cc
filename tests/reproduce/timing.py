#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Removals to 18 faces against the hull, how their time grows, and the paper's own program: figure 6 of [Jacobson2026].

Usage: timing.py --convexact PROGRAM [--meshes FOLDER] [--points N] [--rounds 9] [--json FILE]

The paper's 133 scans are not at hand; our meshes and points on a sphere stand in. Seconds are those of the stages
within one process, reading not counted; without the verification of steps for ours, as the other program has none,
and with it in a row of its own. Programs take turns within each round. A number is the median of the rounds, after it
half the distance of its quartiles, in percent. An exponent is the slope of a line through the logarithms; the residual
is the most by which a time is off that line. n log n itself has the exponent 1 + 1/ln n, about 1.1 here.
"""
import math
import statistics
import sys

from support.experiment import AS_CLAIMED, DIFFERS, NOT_COMPARABLE, SAME_ORDER, Experiment, scratch

SMALLEST = 1000
RANGE = 64
FACES = 18
WAYS = {'ours': (), 'ours, steps verified': ('--verify', 'local'), 'ours by area': ('--cost', 'area')}


def seconds_of_ours(experiment, mesh, options):
    verify = () if '--verify' in options else ('--verify', 'none')
    answer = experiment.run('simplify', mesh, '--faces', FACES, *verify, *options)
    took = {stage['name']: stage.get('seconds', 0) for stage in answer['stages']}
    before = took['hull'] + took.get('dual', 0)
    return answer['input']['halfspaces'], before, took['simplify']


def seconds_of_paper(paper, mesh, cost):
    told = paper.run(mesh, [FACES], cost=cost)
    if 'error' in told:
        return None
    stages = {name: values[0] for name, values in told['stages'].items()}
    # The paper counts the queue with the removals: it holds the first evaluation of each.
    return stages['t_primal_hull'] + stages['t_dual_hull'], stages['t_queue_init'] + stages['t_last_simplify']


def rounds_of(experiment, paper, mesh):
    """Halfspaces, and for each way the seconds before the removals and those of the removals, round after round."""
    times, size = {}, 0
    for _ in range(experiment.options.rounds):
        for way, options in WAYS.items():
            size, *pair = seconds_of_ours(experiment, mesh, options)
            times.setdefault(way, []).append(pair)
        for cost in ('volume', 'area') if paper else ():
            pair = seconds_of_paper(paper, mesh, cost)
            if pair:
                times.setdefault('pchs' if cost == 'volume' else 'pchs by area', []).append(pair)
    return size, {way: list(zip(*pairs)) for way, pairs in times.items()}


def spread(values):
    if len(values) < 2:
        return 0
    low, _, high = statistics.quantiles(values, n=4)
    return (high - low) / 2 / statistics.median(values)


def shown(values):
    return f'{1000 * statistics.median(values):.1f} ± {100 * spread(values):.0f}%'


def fit(sizes, times):
    """The slope of the line through the logarithms by least squares, and the largest residual as a share."""
    x, y = [math.log(size) for size in sizes], [math.log(time) for time in times]
    middle, height = statistics.fmean(x), statistics.fmean(y)
    slope = sum((a - middle) * (b - height) for a, b in zip(x, y)) / sum((a - middle) ** 2 for a in x)
    return slope, math.exp(max(abs(b - height - slope * (a - middle)) for a, b in zip(x, y))) - 1


def add_growth(experiment, sizes, times):
    """times: {way: medians of the removals}, by size."""
    ideal, _ = fit(sizes, [n * math.log(n) for n in sizes])
    slopes = {way: fit(sizes, values) for way, values in times.items()}
    low, high = ideal - 0.05, ideal + 0.05
    slope, residual = slopes['ours']
    verdict = AS_CLAIMED if low <= slope <= high and residual < 0.15 else SAME_ORDER if slope < 1.5 else DIFFERS
    others = f'n to the {slopes["pchs"][0]:.2f}, off by up to {100 * slopes["pchs"][1]:.0f}%' if 'pchs' in slopes else None
    experiment.claim('time grows as n log n', f'as n to the {slope:.2f} on spheres of {sizes[0]:,} to {sizes[-1]:,} halfspaces, '
                     f'off by up to {100 * residual:.0f}%', verdict, pchs=others, interval=f'{low:.2f} to {high:.2f}, off by < 15%',
                     why=f'n log n has {ideal:.2f} on these sizes; 0.05 is what caches and spread of the rounds leave')
    experiment.table(f'Growth over 1:{round(sizes[-1] / sizes[0])}', ['program', 'exponent', 'off the line by at most', 'last doubling'],
                     [[way, f'{s:.2f}', f'{100 * r:.0f}%', f'{times[way][-1] / times[way][-2]:.2f}'] for way, (s, r) in slopes.items()])


def main():
    def add_options(parser):
        parser.add_argument('--points', type=int, default=RANGE * SMALLEST, help='of the largest sphere')
        parser.add_argument('--rounds', type=int, default=9)

    experiment = Experiment(__file__, 'figure 6', __doc__, add_options)
    paper = experiment.paper_program()
    rows, shares, slowest, ratios = [], {'ours': [], 'pchs': []}, 0, {}
    data = []

    def measure(name, mesh):
        size, times = rounds_of(experiment, paper, mesh)
        for way, (before, removals) in times.items():
            rows.append([name, f'{size:,}', way, shown(before), shown(removals),
                         f'{100 * statistics.median(removals) / statistics.median(before):.0f}%'])
        data.append({'name': name, 'halfspaces': size, 'seconds': times})
        return size, {way: statistics.median(removals) for way, (_, removals) in times.items()}, times

    for name, mesh in experiment.meshes():
        with scratch() as folder:
            _, middle, times = measure(name, experiment.hull(mesh, folder)[0])
        slowest = max(slowest, middle['ours'])
        for way, values in shares.items():
            if way in times:
                values.append(middle[way] / statistics.median(times[way][0]))
        for ours, theirs in (('ours', 'pchs'), ('ours by area', 'pchs by area')):
            if theirs in times:
                total = {way: statistics.median(map(sum, zip(*times[way]))) for way in (ours, theirs)}
                ratios.setdefault(ours, []).append(total[theirs] / total[ours])
    sizes, grown = [], {}
    count = SMALLEST
    while count <= experiment.options.points:
        with scratch() as folder:
            experiment.run('generate', 'random-sphere', '--points', count, '-o', f'{folder}/sphere.xyz')
            size, middle, _ = measure(f'{count:,} points on a sphere', experiment.hull(f'{folder}/sphere.xyz', folder)[0])
        sizes.append(size)
        for way, seconds in middle.items():
            grown.setdefault(way, []).append(seconds)
        count *= 2
    if shares['ours']:
        experiment.claim('removals take 32% of the time of the hull (median of 133 scans)',
                         f'{100 * statistics.median(shares["ours"]):.0f}% of ours and its dual (median of {len(shares["ours"])} meshes)',
                         NOT_COMPARABLE,
                         pchs=f'{100 * statistics.median(shares["pchs"]):.0f}% of its hulls' if shares['pchs'] else None,
                         why='the paper divides by CGAL\'s hull')
        experiment.claim('every scan in less than a second', f'the slowest mesh takes {1000 * slowest:.0f} ms', slowest < 1,
                         interval='< 1 s', why='as the paper says it; other meshes and another machine')
    for ours, values in ratios.items():
        experiment.claim('(no number) hull, dual and removals' + (' by area' if 'area' in ours else ''),
                         f'{min(values):.1f} to {max(values):.1f} times faster, median {statistics.median(values):.1f}', NOT_COMPARABLE,
                         pchs='1')
    if len(sizes) > 2:
        add_growth(experiment, sizes, grown)
    experiment.table('Milliseconds: hull and dual, removals to 18', ['input', 'halfspaces', 'program', 'hull and dual', 'removals',
                                                                      'removals over hull'], rows)
    experiment.data('timing', data)
    return experiment.finish()


if __name__ == '__main__':
    sys.exit(main())
