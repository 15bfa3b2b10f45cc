#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""record.py - checksums of what the program answers: a guard for moving code, no source of truth.

While code moves between files, nothing that a user's program reads may change. This script runs
every subcommand on generated, shipped and malformed inputs and keeps, for each run, the exit code
and a checksum of its JSON (times and sentences left out) and of each file that it wrote. Text for
people is not recorded. Whether an answer is right is for the other tests to say.

    record.py PROGRAM --check    compare with checksums.json; names each run that differs
    record.py PROGRAM --write    replace checksums.json; docs/changelog.md says why an answer changed
    record.py PROGRAM --only simplify --check    only runs whose names contain a word
"""
import argparse
import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
CHECKSUMS = HERE / 'checksums.json'
SEEDS = (1, 2, 3)
ENGINES = ('exact', 'filtered', 'float')
MESHES = ('spot', 'teapot', 'bunny')
# Sizes at which the exact engine takes seconds: recorded with the filtered engine only.
LARGE = {'cone', 'cylinder', 'prism', 'grid'}
# Times, memory, versions, and sentences for people.
LEFT_OUT = {'seconds', 'sentence', 'sentences', 'message', 'title', 'notes', 'skipped', 'version', 'build',
            'peak_memory', 'program', 'why', 'detail'}


def masked(value):
    """JSON without what may differ between two runs, or between two versions that answer alike."""
    if isinstance(value, dict):
        return {key: masked(each) for key, each in value.items() if key not in LEFT_OUT}
    if isinstance(value, list):
        return [masked(each) for each in value]
    return value


def checksum(data):
    return hashlib.sha256(data).hexdigest()[:16]


def json_checksum(text, folder):
    """Of each line that is JSON (verify --stdio answers in lines) or of the whole document."""
    text = text.replace(str(folder) + '/', '').replace(str(folder.parent) + '/', '').replace(str(ROOT) + '/', '')
    try:
        documents = [json.loads(text)]
    except ValueError:
        documents = [json.loads(line) for line in text.splitlines()]
    return checksum(json.dumps(masked(documents), sort_keys=True).encode())


class Case:
    """One command. Words that begin with '@' are files that the run is expected to write."""

    def __init__(self, name, words, standard_input=None, text=False, before=None, checker=False):
        self.name, self.words, self.standard_input, self.text = name, words, standard_input, text
        self.before, self.checker = before, checker

    def run(self, program, folder):
        if self.before:
            subprocess.run([program] + self.before, cwd=folder, capture_output=True, check=False)
        if self.checker:
            program = checker_of(program)
        outputs = [word[1:] for word in self.words if word.startswith('@')]
        words = [word[1:] if word.startswith('@') else word for word in self.words]
        done = subprocess.run([program] + words, input=self.standard_input, cwd=folder, text=True,
                              capture_output=True, check=False)
        answer = {'exit': done.returncode}
        if self.text or self.checker:
            answer['stdout'] = checksum(done.stdout.replace(str(folder.parent) + '/', '').replace(str(ROOT) + '/', '').encode())
        elif done.stdout:
            answer['json'] = json_checksum(done.stdout, folder)
        for name in outputs:
            path = folder / name
            if not path.exists():
                answer[name] = 'not written'
            elif name.endswith('trace.json'):
                answer[name] = json_checksum(path.read_text(), folder)
            else:
                answer[name] = checksum(path.read_bytes())
        return answer


def checker_of(program):
    """convexact-check of the build or the installation that a program is of."""
    folder = pathlib.Path(program).parent
    for path in (folder / 'convexact-check', folder.parent / 'check' / 'convexact-check'):
        if path.exists():
            return str(path)
    sys.exit(f'no convexact-check beside {program}')


def families(program):
    """Names of the generated families: of points, and of malformed files with their formats."""
    text = subprocess.run([program, 'generate', '--help'], capture_output=True, text=True, check=True).stdout
    points, malformed = text.split('Files that no reader may accept:')
    names = re.findall(r'^  ([a-z][a-z-]*[a-z])(?:  |$)', points.split('Families of points:')[1], re.M)
    return names, re.findall(r'^  (malformed-[a-z0-9-]+)', malformed, re.M)


def shape_cases(label, path, faces, engines):
    """Everything that is asked about one input."""
    yield Case(f'hull {label}', ['hull', path, '--json', '--exact-values', '-o', '@hull.off', '-o', '@hull.ine'])
    for engine in engines:
        yield Case(f'simplify {label} {engine}',
                   ['simplify', path, '--faces', faces, '--engine', engine, '--json', '--exact-values',
                    '-o', '@solid.obj', '-o', '@planes.json', '--proof', '@run.proof']
                   + (['--trace', '@trace.json'] if engine != 'float' else []))
    for precision in ('64', '32'):
        yield Case(f'simplify {label} --precision {precision}',
                   ['simplify', path, '--faces', faces, '--precision', precision, '--json',
                    '-o', '@solid.stl' if precision == '32' else '@solid.off', '-o', '@solid.ply', '-o', '@planes.txt'])
    yield Case(f'simplify {label} --max-growth', ['simplify', path, '--max-growth', '5%', '--json'])
    yield Case(f'diff {label}', ['diff', path, '--faces', faces, '--engines', ','.join(engines), '--json'])
    if engines == ENGINES:
        yield Case(f'verify {label} --trace', ['verify', path, '--trace', 'kept.trace.json', '--json'],
                   before=['simplify', path, '--faces', faces, '--trace', 'kept.trace.json'])
    yield Case(f'verify {label} rounded', ['verify', path, 'rounded.stl', '--json', '--max-facets', faces, '--exact-facets'],
               before=['simplify', path, '--faces', faces, '--precision', '32', '-o', 'rounded.stl'])
    yield Case(f'check {label}', ['run.proof', path], checker=True,
               before=['simplify', path, '--faces', faces, '--proof', 'run.proof'])
    yield Case(f'verify {label} against itself', ['verify', path, path, '--json', '--max-facets', faces])


def generated_cases(names, folder):
    for name in names:
        for seed in SEEDS:
            label = f'{name}-{seed}'
            yield Case(f'generate {label}', ['generate', name, '--seed', str(seed), '-o', '@shape.obj'])
            path = str(folder / f'{label}.obj')
            engines = ENGINES[1:] if name in LARGE else ENGINES
            if seed == 1:
                yield from shape_cases(label, path, '8', engines)
            else:
                yield Case(f'simplify {label} filtered', ['simplify', path, '--faces', '8', '--json', '--trace', '@trace.json'])


def vector_requests():
    """Every vector that asks for a verdict, as a request of verify --stdio."""
    for path in sorted((ROOT / 'tests' / 'vectors').glob('*.json')):
        for vector in json.loads(path.read_text())['vectors']:
            question = vector['question']
            if question['ask'] != 'verify' or 'points' not in vector['input']:
                continue
            request = {'id': vector['id'], 'input': vector['input']}
            request.update({key: value for key, value in question.items() if key != 'ask'})
            yield json.dumps(request)


def cases(program, folder):
    names, malformed = families(program)
    yield from generated_cases(names, folder)
    for name in MESHES:
        yield from shape_cases(name, str(ROOT / 'tests' / 'data' / f'{name}.obj'), '18', ENGINES)
    for name in malformed:
        extension = name.split('-')[1]
        path = str(folder / f'{name}.{extension}')
        yield Case(f'generate {name}', ['generate', name, '-o', f'@file.{extension}'])
        yield Case(f'refuse {name}', ['hull', path, '--json'])
        yield Case(f'verify against {name}', ['verify', str(folder / 'cube-1.obj'), path, '--json'])
    yield Case('simplify --parts', ['simplify', str(folder / 'parts.obj'), '--parts', '--faces', '6', '--json', '-o', '@parts.obj'])
    yield Case('verify --stdio', ['verify', '--stdio'], '\n'.join(vector_requests()) + '\n')
    for engine in ENGINES:
        yield Case(f'conform {engine}', ['conform', '--json', '--vectors', str(ROOT / 'tests' / 'vectors'), '--level', '2',
                                         '--', program, 'simplify', '{input}',
                                         '--faces', '{faces}', '-o', '{output}', '--engine', engine])
    for wrong in (['simplify', 'spot.obj'], ['hull'], ['hull', 'missing.obj', '--json'], ['simplify', 'missing.obj', '--faces', '3']):
        yield Case('wrong usage: ' + ' '.join(wrong), wrong, text=True)


def header_checksum():
    """Of convexact.h without its comments: names, layouts and values."""
    text = (ROOT / 'include' / 'convexact.h').read_text()
    text = re.sub(r'/\*.*?\*/|//[^\n]*', '', text, flags=re.S)
    return checksum(' '.join(text.split()).encode())


def prepare(program, folder):
    """Writes the inputs that the cases read."""
    names, malformed = families(program)
    for name in names:
        for seed in SEEDS:
            subprocess.run([program, 'generate', name, '--seed', str(seed), '-o', folder / f'{name}-{seed}.obj'], check=True)
    for name in malformed:
        subprocess.run([program, 'generate', name, '-o', folder / f'{name}.{name.split("-")[1]}'], check=True)
    parts, points = '', 0
    for index, name in enumerate(('cube', 'icosahedron', 'prism')):
        subprocess.run([program, 'hull', folder / f'{name}-1.obj', '-o', folder / 'part.obj'],
                       check=True, capture_output=True)
        parts += f'o part{index}\n'
        lines = [line.split() for line in (folder / 'part.obj').read_text().splitlines() if line[:2] in ('v ', 'f ')]
        for word, *values in lines:
            if word == 'f':
                values = [str(int(value.split('/')[0]) + points) for value in values]
            parts += ' '.join([word] + values) + '\n'
        points += sum(line[0] == 'v' for line in lines)
    (folder / 'parts.obj').write_text(parts)


def record(program, only, jobs):
    with tempfile.TemporaryDirectory() as root:
        inputs = pathlib.Path(root, 'inputs')
        inputs.mkdir()
        prepare(program, inputs)

        def run(case):
            with tempfile.TemporaryDirectory(dir=root) as folder:
                return case.run(program, pathlib.Path(folder))

        chosen = [case for case in cases(program, inputs) if only in case.name]
        with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            answers = dict(zip((case.name for case in chosen), pool.map(run, chosen)))
    if only in 'convexact.h':
        answers['convexact.h'] = header_checksum()
    return answers


def differences(before, now):
    for name in sorted(before.keys() | now.keys()):
        if name not in now:
            yield f'{name}: not run any more'
        elif name not in before:
            yield f'{name}: new'
        elif before[name] != now[name]:
            yield f'{name}: {before[name]} is now {now[name]}'


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('program', help='the convexact to be asked')
    mode = parser.add_mutually_exclusive_group(required=True)
    mode.add_argument('--check', action='store_true')
    mode.add_argument('--write', action='store_true')
    parser.add_argument('--only', default='', metavar='WORD')
    parser.add_argument('--jobs', type=int, default=os.cpu_count())
    arguments = parser.parse_args()
    now = record(os.path.abspath(arguments.program), arguments.only, arguments.jobs)
    if arguments.write:
        CHECKSUMS.write_text(json.dumps(now, indent=0, sort_keys=True) + '\n')
        print(f'{len(now)} runs recorded')
        return 0
    before = json.loads(CHECKSUMS.read_text())
    before = {name: answer for name, answer in before.items() if arguments.only in name}
    changed = list(differences(before, now))
    print('\n'.join(changed))
    print(f'{len(now)} runs, {len(changed)} differ')
    return 1 if changed else 0


if __name__ == '__main__':
    sys.exit(main())
