# SPDX-License-Identifier: MIT
"""Random requests and broken files, thousands of each: no crash, no hang, one answer to each line, and only
documented exit codes. What the answers say is tested elsewhere.

    tests/reliability/random_inputs.py build/test/src/cli/convexact --requests 10000 --files 5000 --seed 1
"""
import argparse
import json
import pathlib
import random
import re
import subprocess
import sys
import tempfile

DOCUMENTED = {0, 1, 2, 3, 4, 5, 6}
NUMBERS = [0, 1, -1, 2, 0.5, -0.25, 1e300, 5e-324, 1e-20, 9007199254740993, '1/3', '-7/2', '0x1.8p-3', 1 << 70]
ODD_NUMBERS = ['nan', 'inf', '1/0', '', 'x', None, True, [], {}, 1e400]
EITHER = {'decimal': ['exact', 'nearest'], 'numbers': ['binary32', 'binary64'], 'orient': ['auto', 'keep'],
          'exact_volumes': [True, False]}
OF_VERDICTS = {**EITHER, 'asks': ['hull', 'inner', 'enclosure', 'simplify'], 'judge_points': ['all', 'used'],
               'tolerance': ['0', '1e-9d', '0.5', '-1', 'x'], 'inner': [True, False], 'tightness': [True, False],
               'exact_facets': [True, False], 'max_facets': [0, 4, 8, -1], 'max_vertices': [4, 8, 1 << 65],
               'max_facet_vertices': [3, 4], 'max_parts': [0, 1, 8]}
OF_PARTS = {**EITHER, 'method': ['hacd', 'acd'], 'concavity': ['3%', '0.5', '200%'], 'measure': ['surface', 'vertices'],
            'flat': ['auto', 'thicken', 'keep', 'merge'], 'loose': ['part', 'refuse'], 'tree': [True, False],
            'connect': ['edge', 'overlap', 'touching'], 'engine': ['exact', 'filtered', 'float'], 'max_parts': [1, 2, 0],
            'faces': [4, 5, 3], 'total_faces': [8, 20], 'seed': [1, 7], 'tree_faces': [4, 8], 'keep_inner': [True, False],
            'no_measures': [True, False], 'precision': [32, 64], 'bridge': ['farther', 'region', 'nearer'],
            'coplanar': ['0.9', '2']}
CLAIMS = ['mesh-closed', 'mesh-convex', 'contains-input', 'is-hull', 'inside-input', 'max-facets', 'covers-points',
          'covers-surface', 'covers-solid', 'parts-disjoint', 'parts-needed', 'tree-nested', 'no-such-claim']


class Attacker:
    def __init__(self, seed):
        self.random = random.Random(seed)

    def is_odd(self, share=0.01):
        return self.random.random() < share

    def number(self):
        if self.is_odd(0.001):
            return self.random.choice(ODD_NUMBERS)
        return self.random.choice(NUMBERS) if self.is_odd(0.3) else self.random.randint(-4, 4)

    def points(self, most=12):
        if self.is_odd():
            return self.random.choice([[], [], None, [[]], [[0, 0]], 'points'])
        if self.is_odd(0.4):  # often something with a volume
            size = self.random.choice([1, 2, 0.5])
            return [[size * (k & 1), size * (k >> 1 & 1), size * (k >> 2 & 1)] for k in range(8)]
        return [[self.number() for _ in range(3)] for _ in range(self.random.randint(1, most))]

    def faces(self, count):
        if self.is_odd():
            return self.random.choice([[], None, [[0]], [[0, 1, 99]], [[0, 1, -1]]])
        return [[self.random.randrange(max(count, 1)) for _ in range(self.random.randint(3, 6))]
                for _ in range(self.random.randint(1, 10))]

    def mesh(self):
        vertices = self.points()
        mesh = {'vertices': vertices}
        if self.is_odd(0.6):
            mesh['faces'] = self.faces(len(vertices) if isinstance(vertices, list) else 3)
        return mesh

    def candidate(self):
        if self.is_odd():
            return self.random.choice([None, {}, [], 5, {'planes': 3}, {'parts': {}}])
        kind = self.random.randrange(4)
        if kind == 0:
            return {'planes': [[self.number() for _ in range(4)] for _ in range(self.random.randint(0, 9))]}
        if kind == 1:
            return {'parts': [self.mesh() for _ in range(self.random.randint(0, 4))]}
        return self.mesh()

    def request(self, is_verdict):
        request = {'id': self.random.choice([7, 'x', None, 1.5, True]), 'points': self.points(), 'time_limit': 2}
        if is_verdict:
            request['candidate'] = self.candidate()
        if not is_verdict or self.is_odd(0.3):
            request['triangles'] = self.faces(len(request['points'] or []) if isinstance(request['points'], list) else 3)
        for key, values in (OF_VERDICTS if is_verdict else OF_PARTS).items():
            if self.is_odd(0.06):
                request[key] = self.random.choice(values)
        if is_verdict and self.is_odd(0.15):
            request['claims'] = self.random.sample(CLAIMS, self.random.randint(1, 3))
        return request

    def line(self, is_verdict):
        text = json.dumps(self.request(is_verdict))
        return text if self.is_odd(0.8) else self.broken(text.encode()).decode('latin-1')

    def renumbered(self, data):
        """One of the numbers replaced by another one."""
        places = list(re.finditer(rb'[-+.\d][-+.eE\d]*', data))
        if not places:
            return data
        place = self.random.choice(places)
        return data[:place.start()] + str(self.number()).encode() + data[place.end():]

    def broken(self, data):
        """A few bytes changed, left out, repeated, or the rest cut off; never a line end more."""
        data = bytearray(data)
        for _ in range(self.random.randint(1, 4)):
            if not data:
                break
            at = self.random.randrange(len(data))
            kind = self.random.randrange(6)
            if kind == 0:
                data[at] = self.random.choice(b'0123456789-.eE/{}[]",: fv#xn')
            elif kind == 1:
                del data[at:at + self.random.randint(1, 5)]
            elif kind == 2:
                data[at:at] = data[at:at + self.random.randint(1, 40)]
            elif kind == 3:
                data[at] ^= 1 << self.random.randrange(7)
            elif kind == 4:
                data[at:at] = self.random.choice([b'1e999', b'nan', b'-', b'1/0', b'9' * 60, b'\\', b'#', b'0x1p-1074'])
            elif self.is_odd(0.3):
                del data[at:]
        return bytes(data).replace(b'\n', b' ')


def ask(program, command, lines):
    """The faults of the answers to lines in one process."""
    run = subprocess.run([program, command, '--stdio'], input='\n'.join(lines) + '\n', capture_output=True, timeout=3600,
                         encoding='utf-8', errors='replace')
    if run.returncode != 0:
        yield f'{command} --stdio ended with {run.returncode}: {run.stderr[:300]}'
    answers = run.stdout.split('\n')[:-1]
    asked = [line for line in lines if line.strip()]
    if len(answers) != len(asked):
        yield f'{command} --stdio: {len(answers)} answers to {len(asked)} lines'
    for line, answer in zip(asked, answers):
        document = json.loads(answer)
        error = document.get('error')
        if error is not None and (error['exit'] not in DOCUMENTED - {0, 1} or error['code'] == 'internal'):
            yield f'{command} --stdio: {line}\n  {answer}'
        if error is None and not {'verdict', 'parts'} & document.keys():
            yield f'{command} --stdio: {line}\n  {answer}'


OBJ = b'''o a
v 0 0 0
v 2 0 0
v 0 2 0
v 0 0 2
v 0.25 0.25 0.25
f 1 3 2
f 1 2 4
f 1 4 3
f 2 3 4
o b
v 5 5 5
v 6 5 5
v 5 6 5
v 5 5 6
f -4 -2 -3
f -4/1/1 -3 -1
f -4 -1 -2
f -3//2 -2 -1
'''
OFF = b'OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n'
PLY = (b'ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 4\n'
       b'property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n')
STL = b'solid s\n' + b''.join(b'facet normal 0 0 0\nouter loop\n' + b''.join(b'vertex %d %d %d\n' % p for p in t) + b'endloop\nendfacet\n'
                             for t in [((0, 0, 0), (0, 1, 0), (1, 0, 0)), ((0, 0, 0), (1, 0, 0), (0, 0, 1)),
                                       ((0, 0, 0), (0, 0, 1), (0, 1, 0)), ((1, 0, 0), (0, 1, 0), (0, 0, 1))]) + b'endsolid s\n'
XYZ = b'0 0 0\n1 0 0\n0 1 0\n0 0 1\n0.5,0.5,0.5\n'
PLANES = b'[["-1","0","0","0"],[0,-1,0,0],[0,0,-1,0],[1,1,1,-2.5]]'
INE = b'H-representation\nbegin\n4 4 rational\n0 1 0 0\n0 0 1 0\n0 0 0 1\n3/2 -1 -1 -1\nend\n'
ROWS = b'-1 0 0 0\n0 -1 0 0\n0 0 -1 0\n1 1 1 -1\n'
SEEDS = {'a.obj': OBJ, 'a.off': OFF, 'a.ply': PLY, 'a.stl': STL, 'a.xyz': XYZ, 'a.json': PLANES, 'a.ine': INE, 'a.txt': ROWS}
COMMANDS = [['verify', '{broken}', '{broken}'], ['verify', '{sound}', '{broken}', '--asks', 'hull'],
            ['verify', '{sound}', '{broken}', '--union'], ['verify', '{broken}', '{sound}', '--points', 'used'],
            ['hull', '{broken}', '--measures', 'volume'], ['simplify', '{broken}', '--faces', '5', '-o', '{output}.obj'],
            ['simplify', '{broken}', '--parts', '--faces', '5'], ['simplify', '{broken}', '--inner', '--vertices', '4'],
            ['decompose', '{broken}', '-o', '{output}.obj'], ['bvh', '{broken}'], ['verify', '{sound}', '--trace', '{broken}']]


def try_file(program, attacker, folder):
    """The fault of one run on a broken file, if there is one."""
    name = attacker.random.choice(list(SEEDS))
    broken = folder / ('broken' + pathlib.Path(name).suffix)
    lines = SEEDS[name].split(b'\n')
    for _ in range(attacker.random.randint(1, 3)):
        at = attacker.random.randrange(len(lines))
        kind = attacker.random.randrange(8)
        lines[at] = b'' if kind == 0 else attacker.broken(lines[at]) if kind <= 2 else attacker.renumbered(lines[at])
    broken.write_bytes(b'\n'.join(lines))
    sound = folder / 'sound.obj'
    sound.write_bytes(OBJ)
    places = {'broken': broken, 'sound': sound, 'output': folder / 'output'}
    command = [word.format(**places) for word in attacker.random.choice(COMMANDS)]
    run = subprocess.run([program, *command, '--json'], stdin=subprocess.DEVNULL, capture_output=True, timeout=120)
    if run.returncode in DOCUMENTED and b'"internal"' not in run.stdout:
        return None
    return f'exit {run.returncode} of {" ".join(command)}\n{broken.read_bytes()!r}\n{run.stderr[-300:]!r}'


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('program')
    parser.add_argument('--requests', type=int, default=10000)
    parser.add_argument('--files', type=int, default=5000)
    parser.add_argument('--seed', type=int, default=1)
    options = parser.parse_args()
    attacker = Attacker(options.seed)
    faults = []
    for command, share in (('verify', options.requests * 3 // 4), ('decompose', options.requests - options.requests * 3 // 4)):
        faults += ask(options.program, command, [attacker.line(command == 'verify') for _ in range(share)])
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(options.files):
            fault = try_file(options.program, attacker, pathlib.Path(folder))
            if fault is not None:
                faults.append(fault)
    for fault in faults:
        print(fault)
    print(f'{options.requests} requests, {options.files} files, seed {options.seed}: {len(faults)} faults')
    return 1 if faults else 0


if __name__ == '__main__':
    sys.exit(main())
