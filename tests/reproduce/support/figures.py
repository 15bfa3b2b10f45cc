#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Figures of docs/results/reproduction.md, each beside a file of its numbers, by matplotlib.

Usage: figures.py RECORDS TARGET     (folders; run by the Python of the environment)

Draws what there are records of: corpus.json (violins at 18 halfspaces, and curves over the number of halfspaces) and
timing.json (growth of the removals).
"""
import csv
import json
import math
import pathlib
import statistics
import sys

import matplotlib

matplotlib.use('svg')
matplotlib.rcParams.update({'svg.hashsalt': 'convexact', 'svg.fonttype': 'none', 'font.size': 10, 'axes.spines.top': False,
                            'axes.spines.right': False})
import matplotlib.pyplot as plt  # pylint: disable=wrong-import-position

SHOWN = {'local': 'greedy, then local search', 'greedy': 'greedy (ours)', 'pchs': "paper's program", 'obb': 'oriented box (6)',
         'kdop14': '14-DOP', 'kdop18': '18-DOP', 'kdop26': '26-DOP'}
COLORS = {'local': '#0072b2', 'greedy': '#e69f00', 'pchs': '#000000', 'obb': '#999999', 'kdop14': '#56b4e9', 'kdop18': '#009e73',
          'kdop26': '#cc79a7'}
# Files that miss points by more are no enclosures.
SOUND = 1e-9
LEAST = 1e-4  # added volumes below are drawn there


def ratio_of(record, method, count):
    found = record['made'].get(method, {}).get(count)
    return found['ratio'] if found and 'ratio' in found and found.get('farthest', 0) < SOUND else None


def save(figure, path):
    figure.savefig(path, metadata={'Date': None, 'Creator': None}, bbox_inches='tight')
    plt.close(figure)


def write_csv(path, head, rows):
    with open(path, 'w', newline='', encoding='utf-8') as out:
        csv.writer(out, lineterminator='\n').writerows([head, *rows])


def draw_corpus(meshes, target):
    keys = sorted({(method, count) for mesh in meshes for method, made in mesh['made'].items() for count in made},
                  key=lambda key: (key[0], int(key[1])))
    write_csv(target / 'corpus.csv', ['facets', *(f'{method}-{count}' for method, count in keys)],
              [[mesh['facets'], *('' if (r := ratio_of(mesh, *key)) is None else f'{r:.6f}' for key in keys)] for mesh in meshes])

    at_18 = {method: [r for mesh in meshes for count in [{'obb': '6', 'kdop14': '14', 'kdop26': '26'}.get(method, '18')]
                      if (r := ratio_of(mesh, method, count)) is not None] for method in SHOWN}
    at_18 = {method: ratios for method, ratios in at_18.items() if ratios}
    figure, axes = plt.subplots(figsize=(7.5, 3.4))
    for place, (method, ratios) in enumerate(at_18.items()):
        body = axes.violinplot([[math.log10(max(r - 1, LEAST)) for r in ratios]], positions=[place], widths=0.85,
                               showmedians=True, showextrema=False)
        body['bodies'][0].set_facecolor(COLORS[method])
        body['bodies'][0].set_alpha(0.55)
        body['cmedians'].set_color('black')
        middle = statistics.median(ratios) - 1
        axes.annotate(f'{100 * middle:.1f}%', (place, math.log10(middle)), xytext=(0, 4), textcoords='offset points',
                      ha='center', fontsize=9)
    axes.set_xticks(range(len(at_18)), [SHOWN[method].replace(' ', '\n', 1).replace('then local ', 'then\nlocal ') for method in at_18],
                    fontsize=8.5)
    axes.set_yticks([-4, -3, -2, -1, 0, 1], ['0.01%', '0.1%', '1%', '10%', '100%', '1000%'])
    axes.set_ylabel('added volume')
    axes.set_title(f'18 halfspaces, {len(meshes)} real meshes; boxes and k-DOPs at their own numbers', fontsize=10)
    save(figure, target / 'violin.svg')

    figure, axes = plt.subplots(figsize=(7.5, 3.6))
    counts = [6, 8, 12, 18, 24, 32]
    for method in ('greedy', 'local', 'pchs'):
        values = [[r - 1 for mesh in meshes if (r := ratio_of(mesh, method, str(count)))] for count in counts]
        if not all(values):
            continue
        quartiles = [statistics.quantiles(of, n=4) for of in values]
        axes.plot(counts, [q[1] for q in quartiles], marker='o', color=COLORS[method], label=SHOWN[method],
                  linestyle='--' if method == 'pchs' else '-')
        if method == 'greedy':
            axes.fill_between(counts, [q[0] for q in quartiles], [q[2] for q in quartiles], color=COLORS[method], alpha=0.15,
                              label='half of the meshes (greedy)')
    for method, planes in (('obb', 6), ('kdop14', 14), ('kdop18', 18), ('kdop26', 26)):
        ratios = [r for mesh in meshes if (r := ratio_of(mesh, method, str(planes)))]
        if ratios:
            axes.plot([planes], [statistics.median(ratios) - 1], marker='s', linestyle='', color=COLORS[method], label=SHOWN[method])
    axes.set_xscale('log')
    axes.set_yscale('log')
    axes.set_xticks(counts, map(str, counts))
    axes.minorticks_off()
    axes.set_yticks([0.003, 0.01, 0.03, 0.1, 0.3, 1], ['0.3%', '1%', '3%', '10%', '30%', '100%'])
    axes.set_xlabel('halfspaces')
    axes.set_ylabel('added volume, median')
    axes.legend(frameon=False, fontsize=8.5)
    save(figure, target / 'tightness.svg')


def draw_timing(inputs, target):
    write_csv(target / 'timing.csv', ['input', 'halfspaces', 'program', 'hull and dual, s', 'removals, s'],
              [[i['name'], i['halfspaces'], way, *(f'{statistics.median(values):.6f}' for values in i['seconds'][way])]
               for i in inputs for way in i['seconds']])
    spheres = [i for i in inputs if 'sphere' in i['name']]
    if len(spheres) < 3:
        return
    figure, axes = plt.subplots(figsize=(7.5, 3.6))
    styles = {'ours': ('#e69f00', '-'), 'ours, steps verified': ('#d55e00', '-'), 'ours by area': ('#0072b2', '-'),
              'pchs': ('#000000', '--'), 'pchs by area': ('#666666', '--')}
    for way, (color, line) in styles.items():
        points = [(i['halfspaces'], statistics.median(i['seconds'][way][1])) for i in spheres if way in i['seconds']]
        if points:
            axes.plot(*zip(*points), marker='o', markersize=4, color=color, linestyle=line, label=way.replace('pchs', "the paper's program"))
    size, seconds = spheres[0]['halfspaces'], statistics.median(spheres[0]['seconds']['ours'][1])
    axes.plot([i['halfspaces'] for i in spheres],
              [seconds * i['halfspaces'] * math.log(i['halfspaces']) / (size * math.log(size)) for i in spheres], color='#bbbbbb',
              linewidth=1, label='n log n')
    axes.set_xscale('log')
    axes.set_yscale('log')
    axes.set_xlabel('halfspaces of the hull, points on a sphere')
    axes.set_ylabel('seconds of the removals to 18')
    axes.legend(frameon=False, fontsize=8.5)
    save(figure, target / 'growth.svg')


def main():
    records, target = map(pathlib.Path, sys.argv[1:])
    target.mkdir(parents=True, exist_ok=True)
    for name, draw in (('corpus', draw_corpus), ('timing', draw_timing)):
        file = records / f'{name}.json'
        data = json.loads(file.read_text(encoding='utf-8')).get('data', {}).get(name) if file.is_file() else None
        if data:
            draw(data, target)
    return 0


if __name__ == '__main__':
    sys.exit(main())
