#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A mutation run: changes one token of a source at a time, and says which test notices.

  mutate.py checker --sample 200 --seed 1    200 mutants of convexact-check, in build/mutation
  mutate.py predicates                       all mutants of the exact predicates
  mutate.py --self-test                      whether the tool tells a killed mutant from a surviving one

A mutant that no test notices is asked a second question: does `predicate_answers` print other answers
(then a test is missing), or only other stages of arithmetic (then a filter became slower), or the same?
Results go to FOLDER/GROUP.json, one entry per mutant; a second run goes on where the first one stopped."""
import argparse
import json
import os
import pathlib
import random
import sys
import time

import mutants
from scratch import ROOT, Scratch

LIMIT = 60  # seconds for one test program; the slowest of these takes a few
_GEO, _NUMBER, _FAST, _HULL = ('src/geometry/', 'include/convexact/number/', 'include/convexact/fast/',
                               'include/convexact/hull/')
_SIGNS = ['fast_plane_filter', 'fast', 'fast_audit', 'fast_agreement_sample', 'fast_audit_sample']
# Sources of a group, and the tests that are asked about each, cheapest first.
GROUPS = {
    'checker': {'src/check/convexact_check.cpp': ['check', 'check program']},
    'predicates': {
        _GEO + 'orient3d.cpp': ['geometry', 'hull'],
        _GEO + 'plane_side.cpp': ['geometry', 'containment'],
        _GEO + 'plane_determinants.cpp': ['geometry', 'dual'],
        'src/number/rounding.cpp': ['number', 'stored_planes'],
        'src/fast/dual_signs.cpp': _SIGNS[1:],
        _NUMBER + 'expansion.hpp': ['number', 'geometry'],
        _FAST + 'plane_filter.hpp': _SIGNS,
        _FAST + 'dual_signs.hpp': _SIGNS[1:],
        _HULL + 'near_geometry.hpp': ['hull'],
        _HULL + 'exact_points.hpp': ['hull'],
        _NUMBER + 'double_double.hpp': ['number', *_SIGNS],
    },
}
ANSWERS = 'predicate_answers'  # a program that prints 'answers HASH' and 'stages HASH'


def answers_of(scratch):
    """What the second question compares, by its first word; None if the program did not end well."""
    if not scratch.build([ANSWERS])[0]:
        return None
    outcome = scratch.run(ANSWERS, 2 * LIMIT)
    return dict(line.split() for line in outcome.output.splitlines()) if outcome.how == 'passed' else None


def judge(scratch, name, mutant, tests, original):
    """One mutant's entry."""
    entry = {'file': name, 'line': mutant[0], 'column': mutant[1], 'old': mutant[2], 'new': mutant[3],
             'fate': 'survived', 'by': ''}
    try:
        scratch.write(name, mutants.apply((ROOT / name).read_text(), mutant))
        for test in tests:
            built, said = scratch.build([test])
            if not built:
                entry['fate'] = 'static_assert' if 'static assertion failed' in said else 'no program'
                return entry
            outcome = scratch.run(test, LIMIT)
            if outcome.how != 'passed':
                entry['fate'] = 'timeout' if outcome.how == 'timeout' else 'killed'
                entry['by'] = f'{test}: {outcome.cases[0] if outcome.cases else outcome.how}'
                return entry
        if original:
            now = answers_of(scratch)
            if now is None or now['answers'] != original['answers']:
                entry['fate'] = 'survived, other answers'
            elif now['stages'] != original['stages']:
                entry['fate'] = 'survived, other stages only'
        return entry
    finally:
        scratch.restore()


def run(group, arguments):
    sources = GROUPS[group]
    chosen = [(name, mutant) for name in sources for mutant in mutants.mutants_of((ROOT / name).read_text())]
    total = len(chosen)
    if arguments.sample and arguments.sample < total:
        chosen = random.Random(arguments.seed).sample(chosen, arguments.sample)
    chosen.sort(key=lambda pair: list(sources).index(pair[0]))  # each source is then rebuilt once only
    record = arguments.scratch / f'{group}.json'
    results = json.loads(record.read_text()) if record.exists() else []
    done = {(r['file'], r['line'], r['column'], r['new']) for r in results}
    scratch = Scratch(arguments.scratch)
    scratch.tests[ANSWERS] = {'cmd': [str(scratch.build_folder / 'tests' / 'mutation' / ANSWERS)],
                              'env': {'CONVEXACT_STRIDE': '2'}}
    os.environ['CCACHE_READONLY'] = '1'  # mutants are compiled once
    original = answers_of(scratch) if group == 'predicates' else None
    for name in sources:
        for test in sources[name]:
            if not scratch.build([test])[0] or scratch.run(test, LIMIT).how != 'passed':
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
    """On a function of ten lines: all of its mutants are found and all but the planted one are noticed."""
    def holds(text):
        scope = {}
        exec(text, scope)  # written so that it is C++ to the eye of the tool and Python to run
        f = scope['f']
        return f(1, 2) == 3 and f(5, 5) == 10 and f(7, 0) == 7 and f(-3, 1) == -2

    text = 'def f(a, b):\n  if (a < b):\n    return a + b\n  return b + a\n'
    assert holds(text)
    found = mutants.mutants_of(text)
    alive = [m for m in found if m[3] != '!' and not holds(mutants.apply(text, m).replace('!(', 'not ('))]
    survivors = [m for m in found if m not in alive]
    # a < b chooses between equal sums: its three mutants change no answer. The others do.
    assert [m[2] for m in survivors] == ['<', '<'], survivors
    assert [m[2] for m in alive] == ['+', '+'], alive


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument('group', nargs='?', choices=GROUPS)
    parser.add_argument('--scratch', default=ROOT / 'build' / 'mutation', type=pathlib.Path)
    parser.add_argument('--sample', type=int, default=0)
    parser.add_argument('--seed', type=int, default=1)
    parser.add_argument('--self-test', action='store_true')
    arguments = parser.parse_args()
    if arguments.self_test:
        return self_test()
    if not arguments.group:
        parser.error('which group?')
    return run(arguments.group, arguments)


if __name__ == '__main__':
    sys.exit(main())
