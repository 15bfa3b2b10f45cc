#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""How the time of a run grows with its points: a table in Markdown with slopes, and a log-log plot.

Usage: growth_plot.py PROGRAM [--most 10000000] [--sphere 1000000] [--svg FILE]

Each row is one run of `convexact simplify POINTS --faces 18`, of points uniform in a ball, of which few are on the hull, or
on a sphere, where all are. Seconds are those of the stages by the clock, and of the processor for the whole process; a slope is that of the
logarithms, from the row above. Memory is the peak of the process.
"""
import argparse
import json
import math
import os
import pathlib
import subprocess
import tempfile

STAGES = {'read': 'read', 'hull': 'hull', 'loop': 'simplify'}
COLOURS = {'read': '#999999', 'hull': '#0072b2', 'loop': '#d55e00', 'all': '#000000'}
SHAPES = {'random-ball': 'points in a ball', 'random-sphere': 'points on a sphere'}


def run_of(program, shape, points, folder):
    """{column: seconds}, the facets of the hull, and the peak of memory in bytes."""
    path = folder / f'{shape}-{points}.obj'
    subprocess.run([program, 'generate', shape, '--points', str(points), '-o', path], check=True, capture_output=True)
    with subprocess.Popen([program, 'simplify', path, '--faces', '18', '--json'], stdout=subprocess.PIPE) as child:
        said = child.stdout.read()
        _, status, used = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
    path.unlink()
    if child.returncode:
        raise SystemExit(f'{shape}, {points} points: exit {child.returncode}')
    answer = json.loads(said)
    seconds = {stage['name']: stage['seconds'] for stage in answer['stages'] if 'seconds' in stage}
    found = {column: max(seconds[stage], 1e-6) for column, stage in STAGES.items()}
    return {**found, 'all': used.ru_utime + used.ru_stime}, answer['input']['halfspaces'], used.ru_maxrss * 1024


def slope(before, now, column):
    """Of the line through two runs in the plot."""
    (n, old), (m, new) = before, now
    return math.log(new[column] / old[column]) / math.log(m / n)


def svg_of(series):
    """Both shapes side by side, decades as a grid."""
    runs = [run for shape in series.values() for run in shape]
    decades = {'x': [math.log10(n) for n, *_ in runs], 'y': [math.log10(t) for _, times, *_ in runs for t in times.values()]}
    low, high = ({k: end(round_to(x) for x in v) for k, v in decades.items()} for end, round_to in ((min, math.floor), (max, math.ceil)))
    width, height, left = 300, 260, 50
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {2 * (width + left) + 70} {height + 70}" font-family="sans-serif" '
             'font-size="12">', '<title>Seconds of simplify, by points</title>']
    for number, (shape, found) in enumerate(series.items()):
        def at(x, y, origin=left + number * (width + left)):
            share = (math.log10(x) - low['x']) / (high['x'] - low['x']), (math.log10(y) - low['y']) / (high['y'] - low['y'])
            return f'{origin + share[0] * width:.1f}', f'{30 + (1 - share[1]) * height:.1f}'
        for kind, format_x in (('x', True), ('y', False)):
            for decade in range(low[kind], high[kind] + 1):
                value, ends = 10.0 ** decade, [10.0 ** low['y' if format_x else 'x'], 10.0 ** high['y' if format_x else 'x']]
                a, b = (at(value, end) if format_x else at(end, value) for end in ends)
                lines.append(f'<line x1="{a[0]}" y1="{a[1]}" x2="{b[0]}" y2="{b[1]}" stroke="#ddd"/>')
                words = f'10<tspan dy="-4" font-size="9">{decade}</tspan>' + ('' if format_x else '<tspan dy="4"> s</tspan>')
                shift = (-8, 16) if format_x else (-38, 4)
                lines.append(f'<text x="{float(a[0]) + shift[0]:.1f}" y="{float(a[1]) + shift[1]:.1f}">{words}</text>')
        lines.append(f'<text x="{left + number * (width + left)}" y="20">{SHAPES[shape]}</text>')
        lowest = math.inf  # where the last name stands; from the bottom up
        for column, colour in sorted(COLOURS.items(), key=lambda item: found[-1][1][item[0]]):
            path = [at(n, times[column]) for n, times, *_ in found]
            lines.append(f'<polyline points="{" ".join(map(",".join, path))}" fill="none" stroke="{colour}" stroke-width="1.5"/>')
            if number == len(series) - 1:
                lowest = min(lowest - 12, float(path[-1][1]) + 4)
                lines.append(f'<text x="{float(path[-1][0]) + 6:.1f}" y="{lowest:.1f}" fill="{colour}">{column}</text>')
    return '\n'.join([*lines, '</svg>']) + '\n'


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('program')
    parser.add_argument('--most', type=int, default=10**7, help='points in the ball (default 10^7)')
    parser.add_argument('--sphere', type=int, default=10**6, help='points on the sphere, each some 700 bytes (default 10^6)')
    parser.add_argument('--svg', type=pathlib.Path)
    options = parser.parse_args()
    if min(options.most, options.sphere) < 10**5:
        parser.error('a slope needs two runs: at least 100000 points')
    series = {}
    print('| points | halfspaces of the hull | read, slope | hull, slope | loop, slope | all, slope | memory, MB |')
    print('|---|---|---|---|---|---|---|')
    with tempfile.TemporaryDirectory() as name:
        for shape, most in (('random-ball', options.most), ('random-sphere', options.sphere)):
            found = series[shape] = []
            points = 10**4
            while points <= most:
                times, halfspaces, memory = run_of(options.program, shape, points, pathlib.Path(name))
                found.append((points, times))
                cells = [f'{seconds:.3g}' + (f', {slope(found[-2], found[-1], column):.2f}' if len(found) > 1 else '')
                         for column, seconds in times.items()]
                print(f'| {points:,} {SHAPES[shape][7:]} | {halfspaces:,} | {" | ".join(cells)} | {memory / 1e6:.0f} |', flush=True)
                points *= 10
    if options.svg:
        options.svg.write_text(svg_of(series))


if __name__ == '__main__':
    main()
