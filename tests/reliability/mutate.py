#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A mutation run: changes one token of a source at a time, and says which test notices.

  mutate.py checker --sample 200 --seed 1    200 mutants of convexact-check, in build/faults
  mutate.py predicates                       all mutants of the exact predicates
  mutate.py --self-test                      whether the tool tells a killed mutant from a surviving one

A mutant that no test notices is asked a second question: does `predicate_answers` print other answers
(then a test is missing), or only other stages of arithmetic (then a filter became slower), or the same?
Results go to FOLDER/GROUP.json, one entry per mutant; a second run goes on where the first one stopped."""
import argparse
import json
import pathlib
import random
import subprocess
import sys
import tempfile
import time

import mutants
from scratch import ROOT, Scratch

LIMIT = 60  # seconds for one test program; the slowest of these takes a few
_GEO, _NUMBER, _FAST, _HULL = 'src/geometry/', 'src/number/', 'src/fast/', 'src/hull/'
_SIGNS = ['fast_plane_filter', 'fast', 'fast_audit', 'fast_agreement_sample', 'fast_audit_sample']
# Sources of a group, and the tests that are asked about each, cheapest first.
GROUPS = {
    'checker': {'src/check/' + name: ['check', 'check_mutated']
                for name in ('convexact_check.cpp', 'decomposition.hpp', 'exact.hpp', 'mesh_file.hpp', 'partition.hpp', 'reach.hpp',
                          'root_sum.hpp', 'run.hpp', 'surface.hpp', 'text.hpp')},
    'predicates': {
        _GEO + 'orient3d.cpp': ['geometry', 'hull'],
        _GEO + 'orient3d_stages.hpp': ['geometry', 'hull'],
        _GEO + 'plane_side.cpp': ['geometry', 'containment'],
        _GEO + 'plane_determinants.cpp': ['geometry'],
        'src/dual/polar.cpp': ['geometry', 'dual', 'simplify'],
        'src/simplify/plain_vertex.cpp': ['geometry', 'simplify'],
        _NUMBER + 'rounding.cpp': ['number', 'stored_planes'],
        _FAST + 'signs.cpp': _SIGNS[1:],
        _NUMBER + 'roundoff.hpp': ['number', 'geometry', *_SIGNS],
        _NUMBER + 'expansion.hpp': ['number', 'geometry'],
        _FAST + 'signs.hpp': _SIGNS,
        'src/near/near_geometry.hpp': ['hull'],
        _HULL + 'exact_points.hpp': ['hull'],
        _NUMBER + 'double_double.hpp': ['number', *_SIGNS],
    },
}
ANSWERS = 'predicate_answers'  # a program that prints 'answers HASH' and 'stages HASH'


def answers_of(scratch, name=None):
    """What the second question compares, by its first word; None if the program did not end well."""
    program = None
    if name:
        program, _ = scratch.rebuild(ANSWERS, name, True)
        if not program:
            return None
    outcome = scratch.run(ANSWERS, 2 * LIMIT, program)
    return dict(line.split() for line in outcome.output.splitlines()) if outcome.how == 'passed' else None


def judge(scratch, name, mutant, tests, original):
    """One mutant's entry."""
    entry = {'file': name, 'line': mutant[0], 'column': mutant[1], 'old': mutant[2], 'new': mutant[3],
             'fate': 'survived', 'by': ''}
    try:
        scratch.write(name, mutants.apply((ROOT / name).read_text(), mutant))
        for test in tests:
            for with_library in (False, True):
                if not scratch.has_units(test, name, not with_library):
                    continue
                program, said = scratch.rebuild(test, name, with_library)
                if not program:
                    entry['fate'] = 'static_assert' if 'static assertion failed' in said else 'no program'
                    return entry
                outcome = scratch.run(test, LIMIT, program)
                if outcome.how != 'passed':
                    entry['fate'] = 'timeout' if outcome.how == 'timeout' else 'killed'
                    entry['by'] = f'{test}: {outcome.cases[0] if outcome.cases else outcome.how}'
                    return entry
        if original:
            now = answers_of(scratch, name)
            if now is None or now['answers'] != original['answers']:
                entry['fate'] = 'survived, other answers'
            elif now['stages'] != original['stages']:
                entry['fate'] = 'survived, other stages only'
        return entry
    finally:
        scratch.restore()


def run(group, arguments):
    sources = {name: tests for name, tests in GROUPS[group].items() if arguments.only in name}
    chosen = [(name, mutant) for name in sources for mutant in mutants.mutants_of((ROOT / name).read_text())]
    total = len(chosen)
    if arguments.sample and arguments.sample < total:
        chosen = random.Random(arguments.seed).sample(chosen, arguments.sample)
    chosen.sort(key=lambda pair: list(sources).index(pair[0]))  # each source is then rebuilt once only
    record = arguments.scratch / f'{group}.json'
    results = json.loads(record.read_text()) if record.exists() else []
    done = {(r['file'], r['line'], r['column'], r['new']) for r in results}
    scratch = Scratch(arguments.scratch)
    asks = group == 'predicates' and not arguments.no_answers
    answers = scratch.build_folder / 'tests' / 'reliability' / ANSWERS
    scratch.programs[ANSWERS] = (answers, [], {'CONVEXACT_STRIDE': '2'})
    tests = {test for name in sources for test in sources[name]}
    for test in [*tests, *([ANSWERS] if asks else [])]:
        scratch.build(test)
    original = answers_of(scratch) if asks else None
    for test in tests:
        if scratch.run(test, LIMIT).how != 'passed':
            sys.exit(f'the test {test} does not pass on the original sources')
    for number, (name, mutant) in enumerate(chosen, 1):
        if (name, mutant[0], mutant[1], mutant[3]) in done:
            continue
        started = time.monotonic()
        entry = judge(scratch, name, mutant, sources[name], original)
        results.append(entry)
        record.write_text(json.dumps(results, indent=1))
        print(f'{number}/{len(chosen)} {name}:{mutant[0]}: {mutant[2]!r} -> {mutant[3]!r}: {entry["fate"]} '
              f'{entry["by"]} ({time.monotonic() - started:.0f} s)', flush=True)
    print(f'{total} mutants, {len(chosen)} taken with seed {arguments.seed}:')
    for fate in sorted({r['fate'] for r in results}):
        print(f'  {sum(r["fate"] == fate for r in results)} {fate}')


def self_test():
    """The mutants of a function of one line, and which of them its test notices."""
    text = 'int highest(int a, int b) { return a < b ? b : a; }\n'
    test = 'int main() { return highest(1, 2) == 2 && highest(2, 1) == 2 && highest(3, 3) == 3 ? 0 : 1; }\n'

    def passes(source, folder):
        path = pathlib.Path(folder) / 'mutant.cpp'
        path.write_text(source + test)
        subprocess.run(['c++', '-o', path.with_suffix(''), path], check=True)
        return subprocess.run([path.with_suffix('')]).returncode == 0

    found = mutants.mutants_of(text)
    assert [mutant[2:] for mutant in found] == [('<', '<='), ('<', '>=')], found
    with tempfile.TemporaryDirectory() as folder:
        assert passes(text, folder)
        # Of equal numbers either is the highest, so the first one is no mistake.
        assert [passes(mutants.apply(text, mutant), folder) for mutant in found] == [True, False]
    line = '  if (x[1] == 0 && !seen) return low + 2 * high;'
    assert {mutant[2:] for mutant in mutants.mutants_of(line)} == {
        ('1', '(1 + 1)'), ('1', '(1 - 1)'), ('==', '!='), ('0', '1'), ('&&', '||'), ('!', ''), ('+', '-'),
        ('2', '(2 + 1)'), ('2', '(2 - 1)'), ('*', '+'), ('x[1] == 0 && !seen', '!(x[1] == 0 && !seen)'),
        ('low + 2 * high', '!(low + 2 * high)'), (line.strip(), ';')}
    assert not mutants.mutants_of('  // a < b + 1\n  static_assert(2 + 2 ==\n                4);\n#if 1\n')


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument('group', nargs='?', choices=GROUPS)
    parser.add_argument('--scratch', default=ROOT / 'build' / 'faults', type=pathlib.Path)
    parser.add_argument('--sample', type=int, default=0)
    parser.add_argument('--seed', type=int, default=1)
    parser.add_argument('--only', default='', help='sources whose path holds this')
    parser.add_argument('--no-answers', action='store_true', help='without the second question')
    parser.add_argument('--self-test', action='store_true')
    arguments = parser.parse_args()
    if arguments.self_test:
        return self_test()
    if not arguments.group:
        parser.error('which group?')
    return run(arguments.group, arguments)


if __name__ == '__main__':
    sys.exit(main())
