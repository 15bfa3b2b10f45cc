#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""All faults of fault_list.py in one build, each behind a switch, and the tests that catch each.

  campaign.py                   all faults that a switch can hold, in build/campaign
  campaign.py --only surface    those whose kind, place or text holds this
  campaign.py --drawn 8         and 8 mutants of each room that has fewer than ten faults in the list, by lot
  campaign.py --rooms check,near --drawn 80    80 mutants of each of these rooms, and no fault of the list
  campaign.py --markdown FILE   a table by room, too

The tests run once to find which test cases get to the place of which fault; then, for each fault, those cases
alone, the quickest first. What cannot stand behind a switch, such as constants of the compiler, is named at the
end: faults.py compiles these one at a time. Exit 1 if a fault is caught by no test."""
import argparse
import collections
import json
import os
import pathlib
import random
import re
import signal
import subprocess
import sys

import mutants
from definitions import sources
from fault_list import FAULTS
from faults import place_of
from scratch import ROOT, copy_tree
from switch import HEADER, LISTENER, switched

Fault = collections.namedtuple('Fault', 'kind place file at old new tests')  # tests: names, in order

OPTIONS = ['-Dassertions=true', '-Dbuildtype=plain', '-Db_ndebug=false', '-Doptimization=1', '-Dunity=on', '-Dunity_size=6',
           '-Dthird_party=false', '-Dcpp_args=-w']
LIMIT = 240  # seconds for the cases of one fault
ROUNDS = 6   # of builds, until every switch that is left compiles
NO_SWITCH = 'it does not compile behind a switch'
FEW = 10     # faults in the list; rooms with fewer get some by lot
# The tests that are asked about a fault drawn by lot, by its room; not in the table: the room's own.
TESTS = {
    'check': ['check', 'check_mutated'], 'cli': ['cli', 'cli of decompositions'], 
    'dual': ['dual', 'simplify'], 'io': ['io', 'cli', 'io_broken_files'], 'lab': ['report', 'stress', 'compare', 'oracle', 'cli', 'cli shipped'],
    'conform': ['oracle', 'oracle_programs', 'cli'], 'parts': ['decompose_scene', 'wire'], 'proof': ['check', 'check_mutated'],
    'solid': ['simplify', 'scene'], 'wire': ['wire', 'oracle', 'cli', 'cli of decompositions'],
    'measure': ['measure', 'simplify'], 'number': ['number', 'geometry', 'measure', 'fast'], 'pages': ['report', 'teach', 'cli of decompositions'],
    'near': ['hull', 'stored_planes', 'stored_mesh', 'containment', 'growth', 'reach', 'overlay', 'cut', 'query', 'decompose'],
    'query': ['query', 'hull_trees', 'cli'], 'shapes': ['shapes', 'hull', 'cli'],
    'capi': ['capi'], 'search': ['search', 'search_property', 'hull_trees'],
}


def listed():
    """The faults of fault_list.py."""
    for kind, place, old, new, tests in FAULTS:
        file, at = place_of((kind, place, old, new, tests))
        yield Fault(kind, place, file, at, old, new, tests.split())


def drawn(count, seed, rooms_asked):
    """Mutants by lot, `count` in each room that is asked for, or has few faults in the list."""
    have = collections.Counter(fault[1].split('/')[0] for fault in FAULTS)
    rooms = collections.defaultdict(list)
    for path in sources(('src',)):
        rooms[path.parent.relative_to(ROOT / 'src').as_posix()].append(path)
    for room, paths in sorted(rooms.items()):
        if room not in rooms_asked if rooms_asked else have[room] >= FEW or room in ('.', 'pch'):
            continue
        found = []
        for path in paths:
            text = path.read_text()
            starts = [0]
            for line in text.split('\n'):
                starts.append(starts[-1] + len(line) + 1)
            for line, column, old, new in mutants.mutants_of(text):
                at = starts[line - 1] + column
                if text.startswith(old, at) and switched(text, at, old, new, 0) is not None:
                    found.append(Fault('drawn', f'{room}/{path.name}:{line}', str(path.relative_to(ROOT)), at, old, new,
                                       TESTS.get(room, [room])))
        yield from random.Random(f'{room} {seed}').sample(found, min(count, len(found)))


def places_in(text):
    """The numbers of faults in what write_seen() of the header wrote."""
    return {int(number) for number in re.findall(r'\b(\d+):\d', text)}


class Campaign:
    def __init__(self, folder, faults):
        self.folder, self.tree = folder, folder / 'tree'
        self.build_folder = self.tree / 'build'
        self.faults, self.numbers, self.alone = faults, list(range(len(faults))), {}
        self.tree.mkdir(parents=True, exist_ok=True)
        # What did not compile in an earlier run need not be tried again.
        self.refused = self.folder / 'refused.json'
        known = json.loads(self.refused.read_text()) if self.refused.exists() else []
        for number, fault in enumerate(faults):
            if [fault.file, fault.at, fault.old, fault.new] in known:
                self.alone[number] = NO_SWITCH
        self.numbers = [number for number in self.numbers if number not in self.alone]

    def write_sources(self):
        """The tree with the switches of all faults that are left."""
        texts, places = {}, collections.defaultdict(list)
        for number in self.numbers:
            places[self.faults[number].file].append((self.faults[number].at, number))
        for name, found in places.items():
            text = (ROOT / name).read_text()
            unchanged = len(text)  # up to here
            for at, number in sorted(found, reverse=True):
                fault = self.faults[number]
                changed = switched(text, at, fault.old, fault.new, number)
                if changed is None:
                    self.alone[number] = 'it is no condition, value or statement'
                elif at + len(fault.old) > unchanged:
                    self.alone[number] = 'another fault is in this statement'
                else:
                    unchanged = len(os.path.commonprefix([text, changed]))
                    text = changed
            texts[name] = f'#include "{self.tree}/fault_switch.hpp"\n' + text
        main = 'tests/support/test_main.cpp'
        texts[main] = (ROOT / main).read_text() + f'\n#include "{self.tree}/fault_switch.hpp"\n' + LISTENER
        self.numbers = [number for number in self.numbers if number not in self.alone]
        copy_tree(self.tree, texts)
        header = self.tree / 'fault_switch.hpp'
        if not header.exists() or header.read_text() != HEADER:
            header.write_text(HEADER)

    def build(self):
        """Builds the tests; a switch that does not compile is taken out."""
        self.write_sources()
        if not (self.build_folder / 'build.ninja').exists():
            subprocess.run(['meson', 'setup', self.build_folder, self.tree, *OPTIONS], check=True, stdout=subprocess.DEVNULL)
        for _ in range(ROUNDS):
            ran = subprocess.run(['ninja', '-k', '0', '-C', self.build_folder, 'tests-of-a-change'], capture_output=True, text=True)
            if ran.returncode == 0:
                return
            blamed = self.blamed(ran.stdout + ran.stderr)
            if not blamed:
                sys.exit(f'the campaign does not build:\n{ran.stdout[-3000:]}')
            print(f'{len(blamed)} switches do not compile', file=sys.stderr)
            self.alone.update(dict.fromkeys(blamed, NO_SWITCH))
            self.refused.write_text(json.dumps([[fault.file, fault.at, fault.old, fault.new] for number, fault
                                                in enumerate(self.faults) if self.alone.get(number) == NO_SWITCH]))
            self.numbers = [number for number in self.numbers if number not in self.alone]
            self.write_sources()
        sys.exit('switches that do not compile are left')

    def blamed(self, said):
        """The faults whose switches are in the lines that the compiler complains about, or next to them."""
        found = set()
        for path, line in re.findall(r'^(\S+?):(\d+):\d+:\s+(?:(?:fatal )?error:|required from)', said, re.M):
            file = (self.build_folder / path).resolve()
            if not file.is_file() or self.tree not in file.parents:
                continue
            lines, at = file.read_text().split('\n'), int(line) - 1
            for reach in range(40):
                near = '\n'.join(lines[max(0, at - reach):at + 1])
                numbers = re.findall(r'campaign::(?:is|condition|value<[^>]*>)\((\d+)', near)
                if numbers:
                    found.update(map(int, numbers))
                    break
        return found & set(self.numbers)

    def tests(self):
        """By name: the words that start it, and its environment."""
        said = subprocess.run(['meson', 'introspect', '--tests', self.build_folder], check=True, capture_output=True, text=True).stdout
        return {test['name']: (test['cmd'], test['env']) for test in json.loads(said)}

    def run(self, words, environment, limit):
        """(exit code, output); None instead of a code beyond the time limit."""
        process = subprocess.Popen(words, text=True, errors='replace', start_new_session=True, cwd=self.build_folder,
                                   env={**os.environ, **environment}, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        try:
            output, _ = process.communicate(timeout=limit)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)  # the session that was started above
            process.communicate()
            return None, ''
        return process.returncode, output

    def cases_of(self, name, test):
        """[(seconds, case, places)] of a test, the quickest first; None if it fails without a fault."""
        words, environment = test
        log, started = self.folder / 'cases.txt', self.folder / 'started.txt'
        log.unlink(missing_ok=True)
        started.unlink(missing_ok=True)
        code, output = self.run(words, {**environment, 'CONVEXACT_FAULT_CASES': str(log),
                                        'CONVEXACT_FAULT_SEEN': str(started)}, 10 * LIMIT)
        if code != 0:
            print(f'{name} fails without a fault:\n{output[-2000:]}', file=sys.stderr)
            return None
        cases = []
        # What a library has seen that has a memory of its own is known at the end only: any case may have got there.
        late = places_in(started.read_text()) if started.exists() else set()
        for line in log.read_text().split('\n') if log.exists() else []:
            if line.count('\t') >= 2:
                case, seconds, places = line.rsplit('\t', 2)
                cases.append((float(seconds), case, places_in(places) | late))
        return sorted(cases, key=lambda found: found[0])

    def judge(self, number, name, test, cases):
        """(how, case): 'caught', 'differed', 'equal', 'unreached' by one test."""
        reached = [case for _, case, places in cases if number in places]
        if not reached:
            return 'unreached', ''
        words, environment = test
        seen = self.folder / 'seen.txt'
        seen.unlink(missing_ok=True)
        wanted = ','.join(case.replace('\\', '\\\\').replace(',', '\\,') for case in reached)
        code, output = self.run([*words, '--abort-after=1', f'--test-case={wanted}'],
                                {**environment, 'CONVEXACT_FAULT': str(number), 'CONVEXACT_FAULT_SEEN': str(seen)}, LIMIT)
        if code != 0:
            case = re.findall(r'^TEST CASE:\s+(.*\S)', output, re.M)
            return 'caught', 'no end in time' if code is None else f'{name}: {case[-1] if case else "a crash"}'
        differed = seen.exists() and re.search(rf'\b{number}:3\b', seen.read_text())
        return ('differed' if differed else 'equal'), f'{len(reached)} cases'


def table(rows):
    """By room: injected, caught, reached and different yet passed, reached only, never reached."""
    rooms = collections.defaultdict(collections.Counter)
    for row in rows:
        rooms[row['place'].split('/')[0]][row['how']] += 1
    lines = ['| room | injected | caught | other values, yet passed | reached, not told apart | never reached |',
             '|---|---:|---:|---:|---:|---:|']
    for room, found in sorted(rooms.items()):
        lines.append(f'| {room} | {sum(found.values())} | {found["caught"]} | {found["differed"]} | {found["equal"]} | {found["unreached"]} |')
    return '\n'.join(lines) + '\n'


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument('--folder', default=ROOT / 'build' / 'campaign', type=pathlib.Path)
    parser.add_argument('--only', default='')
    parser.add_argument('--json', type=pathlib.Path, help='also write a row for each fault here')
    parser.add_argument('--markdown', type=pathlib.Path, help='also write the table by room here')
    parser.add_argument('--drawn', type=int, default=0, metavar='N')
    parser.add_argument('--seed', type=int, default=1, help='of those drawn')
    parser.add_argument('--rooms', default=(), type=lambda names: names.split(','), help='draw from these only')
    arguments = parser.parse_args()
    # All are built, so that another choice needs no build.
    faults = [] if arguments.rooms else [*listed()]
    campaign = Campaign(arguments.folder.resolve(), faults + [*drawn(arguments.drawn, arguments.seed, arguments.rooms)])
    chosen = [k for k, fault in enumerate(campaign.faults)
              if any(arguments.only in part for part in (fault.kind, fault.place, fault.old, fault.new))]
    campaign.build()
    tests, known, rows = campaign.tests(), {}, []
    order = ['unreached', 'equal', 'differed', 'caught']
    for number in chosen:
        if number in campaign.alone:
            continue
        fault = campaign.faults[number]
        how, said = 'unreached', ''
        for name in fault.tests:
            if name not in known:
                known[name] = campaign.cases_of(name, tests[name])
            if known[name] is None:
                continue
            found = campaign.judge(number, name, tests[name], known[name])
            if order.index(found[0]) > order.index(how):
                how, said = found
            if how == 'caught':
                break
        rows.append({'number': number, **fault._asdict(), 'how': how, 'said': said})
        print(f'{len(rows)}/{len(chosen)} {fault.place} | {" ".join(fault.old.split())[:40]} -> '
              f'{" ".join(fault.new.split())[:40]} | {how} {said}', flush=True)
        if arguments.json:
            arguments.json.write_text(json.dumps(rows, indent=1))
    print(table(rows), end='')
    if arguments.markdown:
        arguments.markdown.write_text(table(rows))
    for number in sorted(set(campaign.alone) & set(chosen)):
        print(f'not behind a switch, see faults.py: {campaign.faults[number].place}, as {campaign.alone[number]}')
    missed = sum(row['how'] != 'caught' for row in rows)
    print(f'{len(rows)} faults behind a switch: {len(rows) - missed} caught, {missed} not; '
          f'{len(set(campaign.alone) & set(chosen))} need a build of their own')
    return 1 if missed else 0


if __name__ == '__main__':
    sys.exit(main())
