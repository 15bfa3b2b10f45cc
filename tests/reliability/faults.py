#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Injects one fault after another into a copy of the sources and says which test catches it.

  faults.py                     all faults of fault_list.py, in build/faults
  faults.py --only orient3d     those whose kind, place or text holds this
  faults.py --check             only that every fault still finds its place, once, in the tree

A static_assert that a fault breaks catches it; it is taken out then, and the tests are asked too.
Exit 1 if no test catches some fault, or if a fault does not apply."""
import argparse
import json
import pathlib
import sys

from definitions import places
from fault_list import FAULTS
from scratch import ROOT, UNITS, Scratch

LIMIT = 180  # seconds for one test program


def place_of(fault):
    """(file, offset) of the text that a fault replaces; None unless it occurs once in the definitions of its anchor."""
    _, anchor, old, _, _ = fault
    found = set()
    for path, start, end in places(anchor):
        text = path.read_text(encoding='utf-8')
        at = text.find(old, start)
        while at != -1 and at < end:
            found.add((str(path.relative_to(ROOT)), at))
            at = text.find(old, at + 1)
    return found.pop() if len(found) == 1 else None


def caught_by(scratch, fault):
    """What caught a fault: (the compiler's message or '', the test or '', its case)."""
    _, _, old, new, tests = fault
    name, at = place_of(fault)
    compiler, is_asked = '', False
    for test in tests.split():
        scratch.build(test)
    try:
        text = (ROOT / name).read_text()
        scratch.write(name, text[:at] + new + text[at + len(old):])
        for test in tests.split():
            # First what the test compiles of the fault itself, which is quick; then the library's share.
            for with_library in (False, True):
                if not scratch.has_units(test, name, not with_library):
                    continue
                is_asked = True
                program, said = scratch.rebuild(test, name, with_library)
                if not program:
                    compiler = 'static_assert' if 'static assertion failed' in said else 'error'
                    program, said = scratch.rebuild_without_static_asserts(test, name, with_library)
                if not program:
                    return 'error', '', said.strip().split('\n')[0]
                outcome = scratch.run(test, LIMIT, program)
                if outcome.how != 'passed':
                    return compiler, test, outcome.cases[0] if outcome.cases else outcome.how
        return (compiler, '', '') if is_asked else ('error', '', f'no test of {tests} compiles {name}')
    finally:
        scratch.restore()


def misplaced(faults):
    found = [(fault, place_of(fault)) for fault in faults]
    return [fault for fault, place in found
            if place is None or not place[0].endswith('.cpp') and place[0] not in UNITS]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument('--scratch', default=ROOT / 'build' / 'faults', type=pathlib.Path)
    parser.add_argument('--only', default='')
    parser.add_argument('--check', action='store_true')
    parser.add_argument('--json', type=pathlib.Path, help='also write the table here')
    arguments = parser.parse_args()
    faults = [f for f in FAULTS if any(arguments.only in part for part in f)]
    wrong = misplaced(faults)
    for _, anchor, old, *_ in wrong:
        print(f'not found exactly once in {anchor}, or in no file of UNITS: {old}', file=sys.stderr)
    if wrong or arguments.check:
        return 1 if wrong else 0
    scratch = Scratch(arguments.scratch)
    rows = []
    for number, fault in enumerate(faults, 1):
        kind, anchor, _, new, _ = fault
        compiler, test, case = caught_by(scratch, fault)
        rows.append({'kind': kind, 'place': anchor, 'from': fault[2], 'to': new, 'compiler': compiler,
                     'test': test, 'case': case})
        who = ', '.join(filter(None, [compiler, f'{test}: {case}' if test else case])) or 'NO TEST'
        print(f'{number}/{len(faults)} {kind} | {anchor} | '
              f'{" ".join(new.split())[:70] or "- " + " ".join(fault[2].split())[:66]} | {who}', flush=True)
        if arguments.json:
            arguments.json.write_text(json.dumps(rows, indent=1))
    missed = sum(not row['test'] for row in rows)
    print(f'{len(rows)} faults: {len(rows) - missed} caught by a test, '
          f'{sum(bool(row["compiler"]) for row in rows)} by the compiler, '
          f'{sum(not row["test"] and row["compiler"] != "static_assert" for row in rows)} by neither')
    return 1 if any(not row['test'] and row['compiler'] != 'static_assert' for row in rows) else 0


if __name__ == '__main__':
    sys.exit(main())
