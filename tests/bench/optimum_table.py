#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Proves the least volume of every number of halfspaces of small solids, as a table in Markdown.

Usage: optimum_table.py PROGRAM [--most 30]
For families of `convexact generate` with at most so many facets: the states of all searches, their user time, and the
longest one, each of the whole program. A search that ends without a proof is named with its gap.
"""
import argparse
import json
import pathlib
import resource
import subprocess
import sys
import tempfile

SOLIDS = ('dodecahedron', 'icosahedron', 'prism --k 10', 'prism --k 18', 'prism --k 22', 'antiprism --k 10', 'antiprism --k 11',
          'pyramid --k 20', 'bipyramid --k 10', 'bipyramid --k 12', 'cut-cube', 'chamfered-box', 'cube-symmetric',
          'centrally-symmetric --points 7', 'lattice --points 30', 'cospherical --points 12',
          'random-ball --points 30', 'random-sphere --points 10', 'random-sphere --points 12', 'random-sphere --points 14',
          'random-sphere --points 17', 'fibonacci-sphere --points 14', 'nearly-coplanar --points 12')


def answer(program, *arguments):
    finished = subprocess.run([program, *map(str, arguments), '--json'], capture_output=True, text=True)
    if finished.returncode != 0:
        sys.exit(f'convexact {" ".join(map(str, arguments))}: exit {finished.returncode}\n{finished.stdout}{finished.stderr}')
    return json.loads(finished.stdout)


def row(cells):
    print('| ' + ' | '.join(map(str, cells)) + ' |', flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('program')
    parser.add_argument('--most', type=int, default=30, help='facets of a solid (default: 30)')
    options = parser.parse_args()
    open_ends = []
    row(['solid', 'facets', 'states, every K', 'seconds', 'longest'])
    row(['---'] * 5)
    with tempfile.TemporaryDirectory() as folder:
        for solid in SOLIDS:
            file = pathlib.Path(folder) / 'solid.obj'
            answer(options.program, 'generate', *solid.split(), '-o', file)
            facets = len(answer(options.program, 'hull', file)['planes'])
            if facets > options.most:
                continue
            states, times = 0, [0.0]
            for faces in range(4, facets):
                before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
                found = answer(options.program, 'simplify', file, '--faces', faces, '--search', 'optimal')
                times.append(resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before)
                optimum = found['search']['optimum']
                states += optimum['nodes']
                if not optimum['proven']:
                    open_ends.append(f'{solid}, K = {faces}: gap {optimum["gap"]:.2g}')
            row([solid, facets, f'{states:,}', f'{sum(times):.2f}', f'{max(times):.2f}'])
    print('\n'.join(['', *(open_ends or ['every optimum is proven'])]))


if __name__ == '__main__':
    main()
