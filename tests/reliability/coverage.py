#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Line and branch coverage of the central rooms, by their tests.

  coverage.py              a table, from a build in build/faults
  coverage.py --missing    and every line that no test runs, every branch that none takes

The sources of these rooms are compiled again for gcov, without optimisation, and linked in front of the
library. Branches that only exceptions take are left out, and those of assertions, which are never to fail;
templates count once, however many types they are used with."""
import argparse
import collections
import functools
import json
import pathlib
import re
import subprocess
import sys

from scratch import ROOT, Scratch

# A room by what its files are called: the first that fits.
ROOMS = {
    'predicates': r'src/(geometry/|number/(arithmetic|roundoff|expansion|double_double|rounding)|fast/signs|hull/(near_geometry|exact_points))',
    'lp': r'src/lp/',
    'dual': r'src/dual/',
    'greedy, exact': r'src/simplify/',
    'greedy, fast': r'src/fast/',
    'oracle': r'src/(oracle|conform)/',
    'checker': r'src/check/.*',
}
UNITS = (r'^src/(geometry/|lp/|dual/|simplify/|fast/|oracle/|conform/|near/|solid/|number/(arithmetic|rounding)|hull/exact_points)|^tests/(check/checker|hull/near_geometry_test|'
         r'number/(expansion|double_double)_test|fast/(cap_bounds|plane_filter|audit|float_scalar)_test)')
TESTS = ['number', 'geometry', 'lp', 'hull', 'dual', 'measure', 'simplify', 'definition', 'fast', 'fast_plane_filter',
         'fast_cap_bounds', 'fast_audit', 'fast_float_scalar', 'fast_agreement_sample', 'fast_float_sample',
         'fast_audit_sample', 'growth', 'scene', 'oracle', 'oracle_programs', 'oracle_corrupted_sample',
         'oracle_metamorphic', 'report', 'check', 'check_mutated']


class Coverage(Scratch):
    def compile_for_gcov(self):
        self.counted = self.tree.parent / 'coverage'
        self.counted.mkdir(exist_ok=True)
        self.newest_header = max(header.stat().st_mtime for header in self.tree.glob('*/**/*.hpp'))
        linked = {word for words in self.links.values() for word in words}
        for output, (_, source) in self.commands.items():
            if re.search(UNITS, str(source.relative_to(self.tree))) and (
                    output in linked or output.startswith('src/libconvexact.a.p/')):
                self.compile_one(output, source)

    def compile_one(self, output, source):
        target = self.counted / output.replace('/', '_')
        if not target.exists() or target.stat().st_mtime < max(source.stat().st_mtime, self.newest_header):
            said = self._compile(output, target, ['--coverage'])
            if said:
                sys.exit(said)
        self.compiled[output] = str(target)

    def run_counted(self, test):
        words = self.links[test]
        start = words.index('-o')
        program = self.counted / ('program_' + test)
        mine = [o for o in self.compiled if o.startswith('src/libconvexact.a.p/') or o in words]
        rest = [word for word in words[start + 2:] if word not in mine]
        subprocess.run([*words[:start], '-o', str(program), *(self.compiled[o] for o in mine), *rest, '--coverage'],
                       cwd=self.build_folder, check=True)
        outcome = self.run(test, 600, program)
        print(f'{test}: {outcome.how}', file=sys.stderr)
        program.unlink()
        return outcome.how == 'passed'

    @staticmethod
    @functools.cache
    def assertions(path):
        """The numbers of the lines of a file where an assertion starts."""
        return {number for number, text in enumerate(path.read_text().split('\n'), 1) if 'CONVEXACT_ASSERT(' in text}

    def counts(self):
        """(file, line) -> how often, and the list of how often each of its branches was taken."""
        lines, branches = collections.Counter(), collections.defaultdict(collections.Counter)
        for data in sorted(self.counted.glob('*.gcda')):
            said = subprocess.run(['gcov', '--json-format', '--branch-probabilities', '--stdout', str(data)],
                                  cwd=self.build_folder, check=True, capture_output=True, text=True).stdout
            for document in said.splitlines():
                for file in json.loads(document)['files']:
                    path = (self.build_folder / file['file']).resolve()
                    if not path.is_relative_to(self.tree):
                        continue
                    name = str(path.relative_to(self.tree))
                    asserted = self.assertions(path)
                    for line in file['lines']:
                        key = name, line['line_number']
                        lines[key] += line['count']
                        taken = [b['count'] for b in line['branches'] if not b['throw'] and key[1] not in asserted]
                        for index, count in enumerate(taken):
                            branches[key][index] += count
        return lines, branches


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument('--scratch', default=ROOT / 'build' / 'faults', type=pathlib.Path)
    parser.add_argument('--missing', action='store_true')
    arguments = parser.parse_args()
    coverage = Coverage(arguments.scratch)
    for test in TESTS:
        coverage.build(test)
    coverage.compile_for_gcov()
    for old in coverage.counted.glob('*.gcda'):
        old.unlink()
    if not all([coverage.run_counted(test) for test in TESTS]):
        print('a test does not pass', file=sys.stderr)
    lines, branches = coverage.counts()
    room_of = {name: next((room for room, pattern in ROOMS.items() if re.match(pattern, name)), None)
               for name, _ in lines}
    print(f'{"room":15} {"lines":>18} {"branches":>18}')
    for room in ROOMS:
        mine = [key for key in lines if room_of[key[0]] == room]
        taken = [count for key in mine for count in branches[key].values()]
        ran = sum(lines[key] > 0 for key in mine)
        print(f'{room:15} {ran:5} / {len(mine):5} {100 * ran / max(1, len(mine)):5.1f} '
              f'{sum(c > 0 for c in taken):5} / {len(taken):5} {100 * sum(c > 0 for c in taken) / max(1, len(taken)):5.1f}')
    if arguments.missing:
        for key in sorted(key for key in lines if room_of[key[0]]):
            missed = sum(count == 0 for count in branches[key].values())
            if lines[key] == 0 or missed:
                text = (ROOT / key[0]).read_text().split('\n')[key[1] - 1].strip()
                what = 'line' if lines[key] == 0 else f'{missed} of {len(branches[key])}'
                print(f'{key[0]}:{key[1]}: {what}: {text}')


if __name__ == '__main__':
    main()
