#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes each condition of the program's checks true, one at a time, and says which test notices.

  conditions.py --list          finds the conditions by parsing: file, line, text, and their number
  conditions.py                 builds once, in build/conditions, and runs the tests for each
  conditions.py --only hull     those whose file or text holds this
  conditions.py --again         those only that no test noticed in the last run

A condition is an operand of && in a claim that must hold (`require(a && b, ...)`, `return a && b;`),
or an operand of || in a test that refuses (`if (a || b) return false;`). It is made true after it was
evaluated: the check goes on as if it had passed. All are in one build. Each operand is written as
`((operand) || condition_passes(N))`, and the variable CONVEXACT_CONDITION of the environment selects N.

A condition that no test notices must stand in implied_conditions.py with the reason why no input
fails it alone. Exit 1 if one does not."""
import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import time

from implied_conditions import IMPLIED
from scratch import ROOT, Scratch

# As few and as large compilations as possible: the tests are short.
OPTIONS = ['-Dassertions=true', '-Dbuildtype=plain', '-Db_ndebug=false', '-Doptimization=1', '-Db_pch=false',
           '-Dunity=on', '-Dunity_size=6', '-Dthird_party=false', '-Dbench=false']
# Which places of a file hold conditions, and the tests (with the sources of each that are asked first).
CLAIMS, REFUSALS, ANSWERS, SKIPS = 'claims', 'refusals', 'answers', 'skips'
_CHECK = [('check', 'wrong_proof_test,metric_proof_test,same_points_test,stored_reach_test'), ('check_mutated', ''), ('check', '')]
_DECOMPOSITION = [('check', 'wrong_decomposition_test,decomposition_proof_test'), ('check_mutated', ''), ('check', '')]
_PARTITION = [('check', 'partition_proof_test'), ('check', '')]
_REACH = [('check', 'wrong_reach_test,clear_proof_test,placed_test'), ('check', '')]
_SIMPLIFY = [('simplify', 'step_verification_test,whole_dual_test'), ('simplify', '')]
_LP = [('lp', 'certificates_test,chebyshev_center_test,feasibility_test'), ('lp', '')]
FILES = {
    'src/check/run.hpp': ((CLAIMS, REFUSALS, SKIPS), _CHECK),
    'src/check/text.hpp': ((CLAIMS,), _CHECK),
    'src/check/mesh_file.hpp': ((CLAIMS, REFUSALS), _CHECK),
    'src/check/decomposition.hpp': ((CLAIMS, REFUSALS, SKIPS), _DECOMPOSITION),
    'src/check/surface.hpp': ((CLAIMS, REFUSALS, SKIPS), _DECOMPOSITION),
    'src/check/partition.hpp': ((CLAIMS, REFUSALS), _PARTITION),
    'src/check/reach.hpp': ((CLAIMS, REFUSALS, ANSWERS), _REACH),
    'src/fast/checks.cpp': ((CLAIMS, REFUSALS, ANSWERS), [('fast', 'step_check_test,check_surface_test'), ('fast', '')]),
    'src/simplify/step_verification.cpp': ((CLAIMS,), _SIMPLIFY),
    'src/simplify/plain_surface.cpp': ((REFUSALS,), _SIMPLIFY),
    'src/simplify/whole_dual.cpp': ((REFUSALS, ANSWERS), _SIMPLIFY),
    'src/simplify/modular_volume.cpp': ((REFUSALS,), _SIMPLIFY),
    'src/hull/check_hull.cpp': ((REFUSALS, ANSWERS), [('hull', 'check_hull_test'), ('hull', '')]),
    'src/hull/check_flat.cpp': ((REFUSALS, ANSWERS), [('hull', 'hull_degenerate_test'), ('hull', '')]),
    'tests/support/lp_certificates.hpp': ((REFUSALS, ANSWERS), _LP),
    'src/lp/halfspace_certificates.cpp': ((REFUSALS, ANSWERS), _LP),
    'src/stored/acceptance.cpp': ((REFUSALS,), [('stored_planes', ''), ('stored_mesh', ''), ('growth', '')]),
    'src/stored/stored_planes.cpp': ((REFUSALS,), [('stored_planes', ''), ('growth', '')]),
    'src/stored/stored_mesh.cpp': ((REFUSALS,), [('stored_mesh', ''), ('growth', '')]),
    'src/stored/containment.cpp': ((SKIPS, ANSWERS), [('containment', '')]),
}
# Functions whose answer `true` refuses (in another file the same name may let pass), and expressions that are no
# conditions of a check.
REFUSING = {('src/fast/checks.cpp', 'is_beyond'), ('src/stored/containment.cpp', 'is_outside'),
            ('src/hull/check_hull.cpp', 'is_in_cone')}
NO_CONDITIONS = {
    'src/check/run.hpp': ['edge.first == i || edge.second == i'],
    'src/fast/checks.cpp': ['std::pair(a.from, a.to) < std::pair(b.from, b.to)',
                            'a.from == b.from', 'a.to == b.to'],
    'src/simplify/step_verification.cpp': ['holds'],
    'src/hull/check_hull.cpp': ['a >= b'],
    'src/hull/check_flat.cpp': ['row[column] != 0'],
    'src/check/reach.hpp': ['found == beyond_.end()'],
    'src/stored/containment.cpp': ['points_[a.index()][longest] < points_[b.index()][longest]'],
}
GUARD = '''#ifndef CONVEXACT_CONDITIONS
#define CONVEXACT_CONDITIONS
#include <cstdlib>
inline bool condition_passes(int number) {
  static const int chosen = [] {
    const char* const text = std::getenv("CONVEXACT_CONDITION");
    return text == nullptr ? 0 : std::atoi(text);
  }();
  return chosen == number;
}
#endif
'''


def without_comments(text):
    """The same text without comments and what literals say; all positions stay."""
    pattern = r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\''
    blank = lambda m: re.sub(r'[^\n]', ' ' if m.group()[0] == '/' else '_', m.group())
    return re.sub(pattern, blank, text, flags=re.S)


def closing(code, start):
    """The position of the bracket that closes the one at start."""
    depth = 0
    for at in range(start, len(code)):
        depth += (code[at] in '([{') - (code[at] in ')]}')
        if depth == 0:
            return at
    raise ValueError('a bracket is not closed')


def split(code, start, end, separator):
    """The parts of code[start:end] between separators outside of brackets."""
    parts, depth, first, at = [], 0, start, start
    while at < end:
        depth += (code[at] in '([{') - (code[at] in ')]}')
        if depth == 0 and code.startswith(separator, at):
            parts.append((first, at))
            at += len(separator)
            first = at
        else:
            at += 1
    return parts + [(first, end)]


def trimmed(code, start, end):
    while start < end and code[start].isspace():
        start += 1
    while end > start and code[end - 1].isspace():
        end -= 1
    return start, end


def conditions_in(code, start, end, holds):
    """Operands of an expression, as (start, end, whether it must hold). A claim that is a chain of || has one
    for the chain, as any operand that is true makes it true, and those of each operand that is a chain of &&."""
    start, end = trimmed(code, start, end)
    if code[start] == '(' and closing(code, start) == end - 1:
        return conditions_in(code, start + 1, end - 1, holds)
    if code[start] == '!' and code[start + 1] == '(' and closing(code, start + 1) == end - 1:
        return conditions_in(code, start + 2, end - 1, not holds)
    outer = split(code, start, end, '||')
    both = split(code, start, end, '&&')
    if holds and len(outer) == 1 and len(both) > 1:
        return [c for part in both for c in conditions_in(code, *part, holds)]
    if not holds and len(outer) > 1:
        return [c for part in outer for c in conditions_in(code, *part, holds)]
    found = [(start, end, holds)]
    for part in (outer if holds else both) if len(outer if holds else both) > 1 else []:
        nested = conditions_in(code, *part, holds)
        found += nested if len(nested) > 1 else []
    return found


def function_at(code, position):
    """The name of the function that position is in."""
    names = re.findall(r'^[ \w:<>,&*~]*?\b(\w+)\([^;{}]*\)[ \w:]*\{', code[:position], re.M)
    return names[-1] if names else ''


def conditions_of(name):
    """The conditions of a file, as (start, end, holds), in the order of the file."""
    text = (ROOT / name).read_text()
    code = without_comments(text)
    kinds, found = FILES[name][0], []
    if CLAIMS in kinds:
        for m in re.finditer(r'(?<!void )\b(?:require|expect)\s*\(', code):
            start, end = m.end(), closing(code, m.end() - 1)
            found += conditions_in(code, *split(code, start, end, ',')[0], True)
    for m in re.finditer(r'\bif\s*\(', code):
        end = closing(code, m.end() - 1)
        what = code[end + 1:].lstrip(' \n{')
        if function_at(code, m.start()) in ('require', 'expect'):
            continue
        # A text that is returned says, like `false`, that something does not hold.
        is_refused = re.match(r'return (?:false|_+|what\b.*|\{\});|throw\b|(?:stored::)?refuse\(', what) is not None
        if REFUSALS in kinds and (is_refused or re.match(r'return (?:true|proven\b.*|rounded);', what)):
            is_refused = is_refused != ((name, function_at(code, m.start())) in REFUSING)
            found += conditions_in(code, m.end(), end, not is_refused)
        if SKIPS in kinds and what.startswith('continue;'):
            found += conditions_in(code, m.end(), end, True)
    if ANSWERS in kinds:
        for m in re.finditer(r'\breturn\b', code):
            end = split(code, m.end(), len(code), ';')[0][1]
            answer = re.sub(r'\{.*\}', '', code[m.end():end], flags=re.S).strip()
            is_claim = re.search(r'&&|\|\||[=!<>]=|^!|\s[<>]\s|^is_|^has_|\ball_of\(|\.(empty|equal|isZero|passes|surely_negative)\(', answer)
            if not is_claim or answer in ('true', 'false') or re.match(r'std::\w+<', answer):
                continue
            holds = (name, function_at(code, m.start())) not in REFUSING
            found += conditions_in(code, m.end(), end, holds)
    ignored = NO_CONDITIONS.get(name, [])
    return [c for c in sorted(set(found)) if text[c[0]:c[1]] not in ignored]


def instrumented(text, numbered):
    """The text with each condition (number, start, end, holds) made to obey the environment."""
    edits = []  # position, closing first, then inner before outer if closing, outer first if opening
    for number, start, end, holds in numbered:
        size = end - start
        behind = f') || condition_passes({number}))' if holds else f') && !condition_passes({number}))'
        edits += [(start, 1, -size, '(('), (end, 0, size, behind)]
    for position, _, _, insert in sorted(edits, reverse=True):
        text = text[:position] + insert + text[position:]
    return GUARD + text


class Condition:
    def __init__(self, number, name, span):
        text = (ROOT / name).read_text()
        self.number, self.name, self.span = number, name, span
        self.line = text.count('\n', 0, span[0]) + 1
        self.text = ' '.join(text[span[0]:span[1]].split())

    @property
    def reason(self):
        return IMPLIED.get((self.name, self.text), '')


def all_conditions():
    # Numbers of a file stay as they are when another file changes.
    return [Condition(1000 * place + number, name, span) for place, name in enumerate(FILES, 1)
            for number, span in enumerate(conditions_of(name), 1)]


class Runner:
    def __init__(self, folder, conditions):
        self.scratch = Scratch(folder, OPTIONS)
        for name in {c.name for c in conditions}:
            numbered = [(c.number, *c.span) for c in conditions if c.name == name]
            self.scratch.write(name, instrumented((ROOT / name).read_text(), numbered))
        self.limits = {}
        programs = sorted({str(self.scratch.programs[test][0].relative_to(self.scratch.build_folder))
                           for _, tests in FILES.values() for test, _ in tests})
        subprocess.run(['ninja', '-C', self.scratch.build_folder, *programs], check=True)

    def run(self, test, sources, number):
        """Whether a test passes with this condition made true, how it ended otherwise, and its first case."""
        path, arguments, environment = self.scratch.programs[test]
        if sources:
            arguments = ['--source-file=' + ','.join(f'*/{source}.cpp' for source in sources.split(','))]
        environment = {**os.environ, **environment, 'CONVEXACT_CONDITION': str(number)}
        process = subprocess.Popen([path, *arguments, '--abort-after=1'], text=True, errors='replace',
                                   start_new_session=True, env=environment, cwd=self.scratch.build_folder,
                                   stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        try:
            output, _ = process.communicate(timeout=self.limits.get((test, sources), 600))
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)  # the session that was started above
            process.communicate()
            return False, 'timeout', ''
        if process.returncode == 0:
            return True, '', ''
        cases = [re.search(r'^TEST CASE:\s+(.*\S)', block, re.M)
                 for block in re.split(r'^=+$', output, flags=re.M) if 'ERROR:' in block]
        case = next((c.group(1) for c in cases if c), '')
        return False, 'crashed' if process.returncode < 0 else 'failed', case

    def check_baseline(self):
        """Every test passes with no condition changed; ten times as long is the limit then."""
        for test, sources in sorted({test for _, tests in FILES.values() for test in tests}):
            start = time.time()
            passed, how, case = self.run(test, sources, 0)
            if not passed:
                sys.exit(f'{test} {how} without any change: {case}')
            self.limits[test, sources] = 20 + 10 * (time.time() - start)

    def judge(self, condition):
        for test, sources in FILES[condition.name][1]:
            passed, how, case = self.run(test, sources, condition.number)
            if not passed:
                return {'caught': test, 'how': how, 'case': case}
        return {'caught': ''}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument('--scratch', default=ROOT / 'build' / 'conditions', type=pathlib.Path)
    parser.add_argument('--only', default='')
    parser.add_argument('--list', action='store_true')
    parser.add_argument('--again', action='store_true')
    parser.add_argument('--jobs', type=int, default=2)
    parser.add_argument('--json', type=pathlib.Path, help='also write the results here')
    arguments = parser.parse_args()
    conditions = all_conditions()
    unknown = set(IMPLIED) - {(c.name, c.text) for c in conditions}
    for name, text in sorted(unknown):
        print(f'implied_conditions.py names no condition: {name}: {text}')
    if arguments.list:
        for c in conditions:
            print(f'{c.name}:{c.line}: {c.text}')
        print(f'{len(conditions)} conditions in {len({c.name for c in conditions})} files')
        sys.exit(bool(unknown))
    wanted = [c for c in conditions if arguments.only in f'{c.name}: {c.text}']
    record = arguments.scratch / 'not_caught.json'
    if arguments.again and record.exists():
        last = {tuple(pair) for pair in json.loads(record.read_text())}
        wanted = [c for c in wanted if (c.name, c.text) in last]
    start = time.time()
    runner = Runner(arguments.scratch, conditions)
    print(f'built in {time.time() - start:.0f} s')
    runner.check_baseline()
    start, results = time.time(), []
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        for c, answer in zip(wanted, pool.map(runner.judge, wanted)):
            verdict = 'caught' if answer['caught'] else 'implied' if c.reason else 'NOT CAUGHT'
            by = f"{answer['caught']}: {answer.get('case') or answer.get('how')}" if answer['caught'] else c.reason
            print(f'{verdict:10} {c.name}:{c.line}: {c.text}\n           {by}', flush=True)
            results.append({'file': c.name, 'line': c.line, 'condition': c.text, 'verdict': verdict, 'by': by})
    verdicts = ('caught', 'implied', 'NOT CAUGHT')
    print('\n' + f"{'':40}" + ''.join(f'{v.lower():>12}' for v in verdicts))
    for name in [*FILES, '']:
        of_file = [r['verdict'] for r in results if not name or r['file'] == name]
        if of_file:
            print(f"{name or 'all ' + str(len(results)):40}" + ''.join(f'{of_file.count(v):12}' for v in verdicts))
    print(f'in {time.time() - start:.0f} s')
    lost = [[r['file'], r['condition']] for r in results if r['verdict'] == 'NOT CAUGHT']
    record.write_text(json.dumps(lost, indent=1))
    if arguments.json:
        arguments.json.write_text(json.dumps(results, indent=1))
    sys.exit(bool(lost or unknown))


if __name__ == '__main__':
    main()
