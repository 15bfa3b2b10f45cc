#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The paper's own program beside ours, on the same doubles: its order, its volumes and its files, judged.

Usage: pchs.py --convexact PROGRAM [--meshes FOLDER] [--only MESH] [--json FILE]

pchs 0.1.0 of the Python index, which is built on Qhull (the paper: on CGAL). Each mesh is replaced by its hull. `verify
--trace` decides for each of its removals whether it was the cheapest, from the exact planes through the input's points
that its facets join. Volumes (by area: areas) are those of the convex hull of what it wrote, exact, over those of the
hull; they count as equal if they differ by less than 1e-12 of it.
"""
import sys

from support.experiment import NOT_COMPARABLE, Experiment, scratch

COUNTS = (18, 12, 8, 6)
COSTS = {'volume': 'ratio', 'area': 'area'}
EQUAL = 1e-12


def order_of(experiment, paper, mesh, cost, folder):
    """The verdict on its removals: (the most by which one cost more than the cheapest, as a share; None if it died, words)."""
    order, without_plane = paper.order(mesh, folder, cost)
    if order is None:
        return None, f'died: {without_plane}'
    verdict = experiment.run('verify', mesh, '--trace', order, '--cost', cost, codes=(0, 1))
    judged = f'{verdict["judged"]:,} of {verdict["removals"]:,}'
    if without_plane:
        judged += f' ({without_plane} facets join points of a line, and were left out)'
    ties = sum(note['steps'] for note in verdict['notes'] if note['code'] == 'tie-order')
    words = f'judged {judged}; {ties} ties in another order than ours'
    if verdict['rating'] == 'greedy':
        return 0, f'cheapest; {words}'
    regret = verdict['worst']['regret']['value'] if verdict['worst'] else float('inf')
    return regret, f'up to {regret:.1g} dearer than the cheapest; {words}'


def ours(experiment, mesh, count, cost, folder):
    """The measure of our result over that of the hull, or the measure itself by area."""
    planes = f'{folder}/ours.json'
    answer = experiment.run('simplify', mesh, '--faces', count, '--cost', cost, '-o', planes)
    if cost == 'volume':
        return answer['volume']['ratio']
    return experiment.run('hull', planes, '--measures', 'area', '--digits', 17)['area']['value']


def main():
    experiment = Experiment(__file__, "the paper's own program", __doc__)
    paper = experiment.paper_program()
    rows, regrets, equal, larger, results, files, missing, farthest = [], [], 0, 0, 0, 0, 0, 0
    for name, mesh in experiment.meshes() if paper else ():
        with scratch() as folder:
            hull, volume, facets = experiment.hull(mesh, folder)
            for cost, key in COSTS.items():
                regret, words = order_of(experiment, paper, hull, cost, folder)
                regrets.append(regret)
                notes = []
                for count, made in sorted(paper.judged(hull, COUNTS, volume, cost).items(), reverse=True):
                    results += 1
                    if 'fault' in made:
                        notes.append(f'{count}: {made["fault"]}')
                        continue
                    files, missing = files + 1, missing + (made['outside'] > 0)
                    farthest = max(farthest, made['farthest'])
                    own = ours(experiment, hull, count, cost, folder)
                    excess = made[key] / own - 1
                    equal += abs(excess) < EQUAL
                    larger += excess >= EQUAL
                    if abs(excess) >= EQUAL:
                        notes.append(f'{count}: {"+" if excess > 0 else ""}{100 * excess:.3g}%')
                rows.append([name, f'{facets:,}', cost, words, ', '.join(notes) or 'equal at all'])
    if rows:
        known = [regret for regret in regrets if regret is not None]
        experiment.claim('each removal adds the least', 'proven for every step', NOT_COMPARABLE,
                         pchs=f'so in {known.count(0)} of {len(regrets)} orders; in the others a removal costs up to '
                              f'{max(known):.1g} (a share) more: rounding decides ties')
        experiment.claim('(no number)', 'the same halfspaces, or others after a tie', NOT_COMPARABLE,
                         pchs=f'equal in {equal} of {results}, larger in {larger}, smaller in {files - equal - larger}')
        experiment.claim('"conservative"', 'every file of ours is proven to hold every point', NOT_COMPARABLE,
                         pchs=f'{missing} of {files} files miss points, by at most {farthest:.2g} of the diameter')
    experiment.table('Its removals down to 6, and its results at ' + ', '.join(map(str, COUNTS)) + ' over ours',
                     ['mesh', 'facets', 'by', 'its order', 'its results'], rows)
    return experiment.finish()


if __name__ == '__main__':
    sys.exit(main())
