#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""How often random lines, planes and points hit a proxy and not the hull: figure 12 of [Jacobson2026].

Usage: lines.py --convexact PROGRAM [--meshes FOLDER] [--lines 1000] [--json FILE]

Twelve faces, by each cost and by each baseline of `convexact compare` that is bounded. Every probe is decided exactly.
The closed form of the rate is 1 - M(hull)/M(proxy), with M the area for lines, the mean width for planes and the volume
for points; a rate farther than four standard deviations from it is a fault. The paper shows a drawing without numbers
and claims the least rate.
"""
import sys

from support.experiment import Experiment, proxies, scratch

FACES = 12
PROBES = ('lines', 'planes', 'points')
SIGMAS = 4


def main():
    def add_options(parser):
        parser.add_argument('--lines', type=int, default=1000, help='and as many planes and points')
        parser.add_argument('--seed', type=int, default=1)

    experiment = Experiment(__file__, 'figure 12', __doc__, add_options)
    options = experiment.options
    counts = [word for probe in PROBES for word in ('--' + probe, options.lines)]
    rows, beaten, far, judged = [], [], 0, 0
    paper = experiment.paper_program()
    with scratch() as folder:
        for name, mesh in experiment.meshes():
            rates = {}
            for method, planes in proxies(experiment, mesh, FACES, folder, paper):
                answer = experiment.run('query', 'false-positives', mesh, planes, *counts, '--seed', options.seed)
                row = [name, method]
                for probe in PROBES:
                    found, predicted = answer[probe], answer[probe]['predicted']
                    if predicted is None:  # the file misses points of the hull, so the closed form says nothing
                        row.append(f'{100 * found["rate"]:.1f}%')
                        continue
                    middle = (predicted['low'] + predicted['high']) / 2
                    judged += 1
                    far += abs(found['rate'] - middle) > SIGMAS * found['sigma']
                    row.append(f'{100 * found["rate"]:.1f}% ({100 * middle:.1f}%)')
                rows.append(row)
                if method not in ('search', 'pchs'):  # beyond the paper; and the paper's own, beside ours
                    rates[method] = answer['lines']['predicted']['high']
            best = min(rates, key=rates.get)
            if not best.startswith('greedy'):
                beaten.append(f'{name}: {best}')
    experiment.claim('fewest false hits of lines among all methods', 'fewer: ' + ', '.join(beaten) if beaten else
                     'on every mesh one of the three greedy runs has the fewest, by the closed form (search is not ranked)',
                     not beaten, interval='on every mesh', why='the claim says all')
    experiment.claim('(no number)', f'{far} of {judged} rates are farther than {SIGMAS} standard deviations from the '
                     'closed form', far == 0, interval='0',
                     why=f'one in 16,000 is farther by chance; {judged} are judged')
    experiment.table(f'False hits of {options.lines:,} lines, planes and points at {FACES} faces, and the closed form',
                     ['mesh', 'method', *PROBES], rows)
    return experiment.finish()


if __name__ == '__main__':
    sys.exit(main())
