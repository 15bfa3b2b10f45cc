#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs of every subcommand, byte by byte as they were recorded: nothing may change while sources move.

  recorded_runs_test.py PROGRAM            compares; exit 1 and the first differences
  recorded_runs_test.py PROGRAM --record   writes the record anew

A record says that nothing changed, not that it is right: other tests do that. It goes when the moves are done.
Changes that are meant are listed in recorded/intended.txt, with the reason."""
import argparse
import difflib
import hashlib
import itertools
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
RECORD = HERE / 'recorded' / 'runs.txt'
FILES = {
    'cube.obj': ''.join(f'v {x} {y} {z}\n' for x in (0, 2) for y in (0, 2) for z in (0, 2)) +
                'f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n',
    'points.xyz': '0 0 0\n4 0 0\n0 3 0\n0 0 5\n1 1 1\n4 3 5\n4 3 0\n2 3 5\n',
    'notch.obj': 'o l\n' + ''.join(f'v {x} {y} {z}\n' for z in (0, 1) for x, y in
                                   ((0, 0), (4, 0), (4, 1), (1, 1), (1, 4), (0, 4))) +
                 'f 6 5 4 3 2 1\nf 7 8 9 10 11 12\nf 1 2 8 7\nf 2 3 9 8\nf 3 4 10 9\nf 4 5 11 10\nf 5 6 12 11\nf 6 1 7 12\n',
    'two.obj': 'o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n'
               'o b\nv 5 0 0\nv 6 0 0\nv 5 1 0\nv 5 0 1\nv 6 1 1\nf 5 7 6\nf 5 6 8\nf 6 9 8\nf 6 7 9\nf 7 5 8\nf 7 8 9\n',
    'planes.ine': 'H-representation\nbegin\n6 4 rational\n1 1 0 0\n1 -1 0 0\n1 0 1 0\n1 0 -1 0\n1 0 0 1\n3/2 -1/3 -1/3 -1\nend\n',
    'flat.obj': 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 4 3\n',
    'thirds.obj': 'v 0.1 0 0\nv 1.3 0 0.7\nv 0 1.1 0\nv 0.2 0.3 1.7\nv 1 1 1\nf 1 3 2\nf 1 2 4\nf 2 5 4\nf 2 3 5\nf 3 1 4\nf 3 4 5\n',
    'open.obj': 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\n',
    'inside_out.obj': 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n',
    'nan.obj': 'v 0 0 0\nv 1 nan 0\n', 'bad.obj': 'v 0 0\n', 'empty.obj': '', 'index.obj': 'v 0 0 0\nf 1 2 3\n',
    'rays.txt': '-1 0.5 0.5 1 0 0\n0.5 0.5 9 0 0 -1\n9 9 9 1 1 1\n',
    'capsule.json': '{"shape": "capsule", "from": [-0.5, 0, 0], "to": [0.5, 0, 0], "radius": 0.5}\n',
    'requests.jsonl': '{"input": {"points": [[0,0,0],[1,0,0],[0,1,0],[0,0,1]]}, '
                      '"candidate": {"halfspaces": [[1,1,1,-1],[-1,0,0,0],[0,-1,0,0],[0,0,-1,0]]}}\n{"input": 3}\nnot json\n',
    'meshes.jsonl': '{"points":[[0,0,0],[1,0,0],[0,1,0],[0,0,1]],"triangles":[[0,2,1],[0,1,3],[1,2,3],[2,0,3]],"id":7}\n{}\n',
}
SOLIDS = ['cube.obj', 'points.xyz', 'notch.obj', 'two.obj', 'planes.ine', 'thirds.obj']
WRONG = ['flat.obj', 'nan.obj', 'bad.obj', 'empty.obj', 'index.obj', 'none.obj']


def runs():
    """The command lines, in order; later ones take files that earlier ones wrote."""
    each = lambda *parts: (' '.join(filter(None, words)) for words in itertools.product(*parts))
    yield from ['', '--help', '--version', 'simplfy cube.obj', 'simplify --fasces 3 cube.obj']
    for command in ('hull', 'simplify', 'decompose', 'bvh', 'verify', 'conform', 'generate', 'shrink', 'query', 'teach'):
        yield f'{command} --help'
    yield from each(['hull'], SOLIDS + WRONG, ['', '--json'])
    yield from each(['hull cube.obj'], ['--measures volume', '--measures none --json', '--points used', '--exact-values --json',
                                        '--decimal exact', '--stages'])
    yield from each(['simplify'], SOLIDS + WRONG, ['--faces 5', '--faces 5 --json'])
    yield from each(['simplify notch.obj --faces 5'], [
        '--cost area', '--cost mean-width', '--engine exact', '--engine float', '--search walk', '--search local --moves 20',
        '--search optimal', '--verify full', '--verify none', '--precision 32', '--precision 64 --json', '--center 1,1,0.5',
        '--seed 7', '--keep normal:1,0,0', '--keep id:0', '--keep nothing', '--points used', '--decimal exact', '--stages',
        '-o s.obj', '-o s.json --json', '-o s.ine', '-o s.off -o s.ply', '-o s.stl', '-o s.txt', '-o s.xyz', '-o s.what',
        '--trace t.json', '--proof p.proof', '-o no/where.obj'])
    yield from ['simplify notch.obj', 'simplify notch.obj --faces 3', 'simplify notch.obj --max-growth 5%',
                'simplify notch.obj --max-growth 500% --json', 'simplify notch.obj --max-growth 20% --growth-of area',
                'simplify two.obj --parts --faces 4', 'simplify two.obj --parts --faces 4 --json',
                'simplify two.obj --parts --total-faces 9', 'simplify two.obj --parts --total-faces 9 --json -o both.obj',
                'simplify two.obj --faces 5 -o hull_of_both.obj', 'simplify cube.obj notch.obj --faces 5',
                'simplify notch.obj --inner --vertices 6', 'simplify notch.obj --inner --vertices 6 --json -o inner.obj',
                'simplify notch.obj --inner --max-loss 20%', 'simplify notch.obj --inner --faces 6',
                'simplify --implicit capsule.json --box -2,-2,-2,4 --depth 3 --faces 8',
                'simplify --implicit capsule.json --box -2,-2,-2,4 --depth 3 --faces 8 --json']
    yield from each(['decompose --method hacd'], SOLIDS + WRONG + ['open.obj', 'inside_out.obj'], ['', '--json'])
    yield from each(['decompose --method hacd notch.obj'], [
        '--concavity 0', '--concavity 30%', '--concavity 0.5', '--concavity -1', '--concavity 0 --max-parts 2', '--measure vertices', '--engine exact',
        '--engine float', '--connect touching', '--orient keep', '--flat keep', '--flat merge', '--keep-inner', '--precision 32',
        '--concavity 0 --faces 5', '--concavity 0 --total-faces 12', '--measures all', '--measures none', '--exact-volumes --json',
        '--concavity 0 -o parts.obj', '--concavity 0 -o parts.json', '--concavity 0 -o parts/', '--concavity 0 --precision 32 -o m.mjcf.xml',
        '--concavity 0 --trace d.json', '--concavity 0 --proof d.proof', '--concavity 0 --tree tree.json',
        '--names part', '--concavity 0 --names p%d -o named.obj', '--stages', '--points used', '--decimal exact'])
    yield from each(['decompose --method acd notch.obj'], ['', '--concavity 0 --json', '--concavity 0 --bridge nearer'])
    yield from each(['decompose'], SOLIDS + ['flat.obj', 'open.obj', 'inside_out.obj'], ['', '--json'])
    yield from each(['decompose notch.obj'], [
        '--distance 1%', '--distance 0', '--effort high', '--effort most', '--max-excess 10%', '--max-excess 10', '--max-parts 1',
        '--faces 8', '--engine exact', '--engine float', '--concavity 5%', '--guard reach', '--measures all', '-o c.obj', '-o c.json',
        '--trace c.trace.json', '--proof c.proof', '--tree c.tree.json', '--stages'])
    yield from ['decompose --method hacd two.obj --parts --json', 'decompose two.obj --parts --json', 'decompose --stdio <meshes.jsonl', 'decompose']
    yield from each(['bvh'], ['notch.obj --concavity 0', 'notch.obj --concavity 0 --json', 'notch.obj --concavity 0 -o t.json',
                              'notch.obj --concavity 0 --tree-faces 6', '--from parts.obj', '--from parts.obj -o t2.json --json', 'flat.obj'])
    candidates = ['cube.obj', 's.obj', 's.ine', 's.json', 'open.obj', 'inside_out.obj', 'flat.obj', 'nan.obj', 'none.obj']
    yield from each(['verify notch.obj'], candidates, ['', '--json'])
    yield from each(['verify notch.obj s.obj'], [
        '--asks hull', '--asks hull --json', '--asks simplify', '--asks simplify --max-facets 5', '--asks inner', '--tolerance 1e-9d',
        '--max-facets 4', '--max-vertices 3', '--max-facet-vertices 3', '--profile physx', '--profile nobody', '--claims contains-input',
        '--claims contains-input,nothing', '--no-tightness', '--numbers binary32', '--points used', '--stages', '--union', '--exact-facets'])
    yield from each(['verify notch.obj'], ['parts.obj --union', 'parts.obj --union --json', 'parts.obj --union --measures all',
                                           'parts.obj --union --claims covers-solid,parts-disjoint', 'parts.json', 'parts/', 't.json',
                                           'parts.obj --union --max-parts 1', 'cube.obj --union --json', 'parts.obj --union --no-tightness',
                                           't.json --claims tree-nested', 'parts.obj --union --exact-volumes --json', 'inner.obj --inner',
                                           's.obj --trace t.json', 'parts.obj --parts'])
    yield from ['verify two.obj both.obj --parts', 'verify two.obj both.obj --parts --json', 'verify --stdio <requests.jsonl', 'verify',
                'verify cube.obj --inner', 'verify notch.obj t.json --trace']
    yield from each(['query'], ['overlap cube.obj notch.obj', 'overlap cube.obj notch.obj --json', 'overlap cube.obj two.obj',
                                'rays cube.obj rays.txt', 'rays cube.obj rays.txt --json', 'rays t.json rays.txt', 'rays t.json rays.txt --json',
                                'overlap t.json cube.obj', 'rays cube.obj none.txt', 'rays cube.obj cube.obj', 'overlap flat.obj cube.obj',
                                'false-positives notch.obj s.json --probes 200', 'false-positives notch.obj s.json --probes 200 --json'])
    yield from each(['generate'], ['--list', 'cube', 'prism --help', 'lattice --seed 3', 'cube --facets', 'cube -o g.ply', 'cube --json -o g.off',
                                   'cbe', '--any --seed 4', '--vector nobody', 'cube -o g.what'])
    yield from each(['teach'], ['thirds.obj -o lesson.json', 'thirds.obj --faces 5 -o lesson.json --json', 'flat.obj -o l.json', 'thirds.obj'])
    yield from each(['shrink notch.obj -o small.obj'], [
        '-- false {input}', '-- true {input}', '--json -- false {input}', '-- false', "--interesting 'grep -q 4 {input}'", '--asks hull -- cp {input} {output}', ''])
    yield from each(['conform'], ['-- false', '--flag nobody -- false {input} {output}', '--asks nothing -- false {input} {output}',
                                  '--level 1 --flag malformed -- false {input} {output}',
                                  '--level 1 --flag malformed --json -- false {input} {output}',
                                  '--level 1 --flag malformed --asks hull -- cp {input} {output}'])
    yield from each(['diff', 'diff --json', 'diff --cost area', 'compare --faces 8', 'compare --faces 8 --json'], ['thirds.obj', 'flat.obj'])
    yield from ['conform', 'conform --list-profiles', 'shrink', 'stdio']


MASKS = [
    (r'/\S*/convexact-\w{6}/', 'SCRATCH/'),
    (r'(?m)^  time  .*$', '  time'),
    (r'\d+\.\d+ s\b', 'T s'),
    (r'(?m)^(  \S+ +\d+(?: +\d+\.\d+){4}) +[0-9.e+-]+', r'\1 T'),  # rows of compare
    (r'"(\w*seconds|time)": [0-9.e+-]+', r'"\1": T'),
    (r'"(peak_bytes|bytes|peak_memory)": \d+', r'"\1": N'),
    (r'convexact \d+\.\d+\.\d+\S*( \(.*\))?', 'convexact V'),
    (r'"version": "[^"]*"', '"version": V'),
    (r'"build": "[^"]*"', '"build": B'),
]


def masked(text, folder):
    text = text.replace(str(folder), 'FOLDER').replace(str(HERE.parents[1]), 'ROOT')
    for pattern, instead in MASKS:
        text = re.sub(pattern, instead, text)
    return text


def outcome(program, line, folder):
    """What a run printed, its exit code, and the files that it wrote or changed."""
    contents = lambda: {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob('*')) if path.is_file()}
    before = contents()
    ran = subprocess.run(f'"{program}" {line}', shell=True, cwd=folder, capture_output=True, text=True, errors='replace', timeout=600,
                         stdin=subprocess.DEVNULL if '<' not in line else None, env={**os.environ, 'COLUMNS': '100'})
    text = f'$ convexact {line}\nexit {ran.returncode}\n'
    for name, said in (('out', ran.stdout), ('err', ran.stderr)):
        text += ''.join(f'{name}: {row}\n' for row in masked(said, folder).rstrip('\n').split('\n') if said)
    for name, data in contents().items():
        if before.get(name) != data:
            data = masked(data.decode('utf-8', 'replace'), folder).encode()
            text += f'file: {name}, {len(data)} bytes, {hashlib.sha256(data).hexdigest()[:16]}\n'
    return text


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument('program', type=pathlib.Path)
    parser.add_argument('--record', action='store_true')
    arguments = parser.parse_args()
    folder = pathlib.Path(tempfile.mkdtemp(prefix='recorded')).resolve()
    try:
        for name, text in FILES.items():
            (folder / name).write_text(text)
        found = [outcome(arguments.program.resolve(), line, folder) for line in runs()]
    finally:
        shutil.rmtree(folder)
    if arguments.record:
        RECORD.write_text('\n'.join(found))
        print(f'{len(found)} runs recorded')
        return 0
    known = [text.rstrip('\n') + '\n' for text in RECORD.read_text().split('\n$ ')]
    known = [text if text.startswith('$ ') else '$ ' + text for text in known]
    differ = [(a, b) for a, b in itertools.zip_longest(known, found, fillvalue='') if a != b]
    for a, b in differ[:5]:
        print('\n'.join(difflib.unified_diff(a.split('\n'), b.split('\n'), 'recorded', 'now', lineterm='')))
    print(f'{len(found)} runs, {len(differ)} differ from the record')
    return 1 if differ else 0


if __name__ == '__main__':
    sys.exit(main())
