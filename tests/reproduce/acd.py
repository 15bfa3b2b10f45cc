#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Splits of a cow at its notches: the table of hulls, figure 11 and the equal budgets of [Backenhof2011].

Usage: acd.py --convexact PROGRAM [--cow FILE] [--json FILE]

The cow of the thesis has 5,804 triangles and may not be shipped: name its file. Without it the rows say so, and spot
stands in at 20 and 10%, of which nothing was published. A row is as published if one of the three ways to choose a
bridge is within a factor of 2 of the thesis; 0% is shown and not judged. Seconds are the processor's, of the whole
command without volumes.
"""
import argparse
import json
import math
import pathlib
import resource
import subprocess
import sys
import tempfile
from fractions import Fraction

from hacd import COW_TRIANGLES, ROOT, triangles_of

BRIDGES = ('farther', 'region', 'nearer')
COW = {'20%': (4, 0.31), '15%': (8, 0.41), '10%': (19, 0.54), '5%': (81, 0.80), '0': (1506, 1.36)}  # hulls, seconds
BUDGET = 23  # parts of the cow in [MamouGhorbel2009], and then in the thesis


def decompose(program, mesh, *arguments):
    ran = subprocess.run([program, 'decompose', mesh, '--keep-inner', '--json', *arguments],
                         capture_output=True, text=True, check=True)
    return json.loads(ran.stdout)


def processor_seconds():
    """Of all programs that were run so far."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def print_table(head, rows):
    print('\n| ' + ' | '.join(head) + ' |\n|' + '---|' * len(head))
    for row in rows:
        print('| ' + ' | '.join(str(cell) for cell in row) + ' |', flush=True)


def hulls(program, shape, mesh, shares, published):
    """The table of the thesis: one row for each share of the diameter."""
    rows = []
    for share in shares:
        row = {'shape': shape, 'concavity': share, 'published': published.get(share)}
        for bridge in BRIDGES:
            before = processor_seconds()
            result = decompose(program, mesh, '--method', 'acd', '--concavity', share, '--bridge', bridge,
                               '--measures', 'none')
            row[bridge] = {'parts': len(result['parts']), 'seconds': round(processor_seconds() - before, 2),
                           'unsplittable': sum(part['status'] == 'unsplittable' for part in result['parts'])}
        rows.append(row)
    return rows


def verdict(row):
    if row['published'] is None or row['concavity'] == '0':
        return 'not judged'
    count = row['published'][0]
    near = [bridge for bridge in BRIDGES if count <= 2 * row[bridge]['parts'] and row[bridge]['parts'] <= 2 * count]
    return 'as published: ' + ', '.join(near) if near else 'differs'


def show_hulls(rows):
    def cell(made):
        stuck = f", {made['unsplittable']} unsplittable" if made['unsplittable'] else ''
        return f"{made['parts']} / {made['seconds']:.2f}{stuck}"

    print_table(('shape', 'concavity', 'thesis, hulls / seconds', *BRIDGES, 'verdict'),
                [(row['shape'], row['concavity'], '{} / {:.2f}'.format(*row['published']) if row['published'] else '-',
                  *(cell(row[bridge]) for bridge in BRIDGES), verdict(row)) for row in rows])


def total_concavities(trace):
    """Of all leaves, as a share of the diameter, after each number of splits."""
    squared_diameter = Fraction(trace['squared_diameter'])
    depth = [math.sqrt(Fraction(node['squared_concavity']) / squared_diameter) for node in trace['nodes']]
    leaves = {node['node'] for node in trace['nodes'] if node['parent'] is None}
    totals = [math.fsum(depth[node] for node in leaves)]
    for split in trace['splits']:
        leaves.remove(split['node'])
        leaves.update(split['children'])
        totals.append(math.fsum(depth[node] for node in leaves))
    return totals


def curve(program, mesh, share, scratch):
    totals = {}
    for bridge in BRIDGES:
        trace = pathlib.Path(scratch) / 'splits.json'
        decompose(program, mesh, '--method', 'acd', '--concavity', share, '--bridge', bridge, '--measures', 'none',
                  '--trace', str(trace))
        totals[bridge] = total_concavities(json.loads(trace.read_text(encoding='utf-8')))
    return totals


def show_curve(shape, totals):
    most = max(len(each) for each in totals.values()) - 1
    shown = [k for k in (0, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000) if k <= most]
    print(f'\nTotal concavity of all leaves of {shape}, in diameters, after so many splits:')
    print_table(('splits', *BRIDGES), [
        (k, *(f'{totals[bridge][k]:.3f}' if k < len(totals[bridge]) else '-' for bridge in BRIDGES)) for k in shown])


def budgets(program, shape, mesh):
    """As many parts by either method, and what they add to the solid and leave of it, in percent of its volume."""
    runs = [('hacd, vertices', ('--method', 'hacd', '--measure', 'vertices', '--max-parts', str(BUDGET))),
            ('hacd, surface', ('--method', 'hacd', '--max-parts', str(BUDGET)))]
    runs += [('acd, ' + bridge, ('--method', 'acd', '--bridge', bridge, '--concavity', '0', '--max-parts', str(BUDGET)))
             for bridge in BRIDGES]
    rows = []
    for name, arguments in runs:
        result = decompose(program, mesh, *arguments)
        solid = result['solid']['low']
        rows.append({'shape': shape, 'method': name, 'parts': len(result['parts']),
                     'excess_percent': 100 * result['excess']['low'] / solid,
                     'uncovered_percent': 100 * result['uncovered']['low'] / solid})
    return rows


def show_budgets(rows):
    print_table(('shape', 'method', 'parts', 'excess', 'uncovered'),
                [(row['shape'], row['method'], row['parts'], f"{row['excess_percent']:.1f}%",
                  f"{row['uncovered_percent']:.1f}%") for row in rows])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--convexact', required=True)
    parser.add_argument('--cow')
    parser.add_argument('--json')
    options = parser.parse_args()
    if options.cow:
        found = triangles_of(options.cow)
        if found != COW_TRIANGLES:
            sys.exit(f'{options.cow}: {found} triangles, the cow of the thesis has {COW_TRIANGLES}')
        shape, mesh, shares, published = 'cow', options.cow, tuple(COW), COW
    else:
        print('skipped: the cow, since --cow names no file; spot stands in')
        shape, mesh, shares, published = 'spot', ROOT / 'tests/data/spot.obj', ('20%', '10%'), {}
    made = {'hulls': hulls(options.convexact, shape, mesh, shares, published)}
    show_hulls(made['hulls'])
    with tempfile.TemporaryDirectory() as scratch:
        made['total_concavity'] = curve(options.convexact, mesh, shares[-1], scratch)
    show_curve(shape, made['total_concavity'])
    made['equal_budgets'] = budgets(options.convexact, shape, mesh)
    show_budgets(made['equal_budgets'])
    if options.json:
        pathlib.Path(options.json).write_text(json.dumps(made, indent=1) + '\n', encoding='utf-8')
    differs = [row for row in made['hulls'] if verdict(row) == 'differs']
    for row in differs:
        print(f"{row['shape']} at {row['concavity']}: published {row['published'][0]} hulls", file=sys.stderr)
    return 1 if differs else 0


if __name__ == '__main__':
    sys.exit(main())
