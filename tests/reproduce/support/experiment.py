# SPDX-License-Identifier: MIT
"""What the experiments on the figures of [Jacobson2026] share: options, meshes, runs, and the record of what was found.

A record is one object: {"id", "figure", "command", "claims": [{"paper", "here", "pchs", "interval", "why", "verdict"}],
"tables": [{"title", "head", "rows"}], "skipped": [...], "data": {...}}. It is printed as Markdown, written by --json, and
docs/results/reproduction.md is made of it.
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
SHIPPED = ('spot', 'teapot', 'bunny')
# May not be shipped: named and skipped where they are absent. The bunny there is the one that is shipped.
OTHERS = ('suzanne', 'cow', 'homer', 'fandisk', 'rocker-arm')
AS_CLAIMED, SAME_ORDER, DIFFERS, NOT_COMPARABLE = 'as claimed', 'same order', 'differs', 'not comparable'


class Experiment:
    """Options of the command line, and the record that grows."""

    def __init__(self, script, figure, description, add_options=lambda parser: None):
        parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
        parser.add_argument('--convexact', required=True, help='the program')
        parser.add_argument('--meshes', type=pathlib.Path, help='a folder with ' + ', '.join(OTHERS) + ' as .obj')
        parser.add_argument('--only', action='append', help='only this mesh; may be repeated')
        parser.add_argument('--json', type=pathlib.Path, help='where to write the record')
        parser.add_argument('--plot', type=pathlib.Path, help='where to write a plot (.svg), if there is one')
        parser.add_argument('--must-hold', action='store_true', help='fail if a claim differs')
        parser.add_argument('--alone', action='store_true', help="without the paper's program, which is of the Python index")
        add_options(parser)
        self.options = parser.parse_args()
        words = [word for word in sys.argv[1:] if word not in ('--convexact', '--must-hold', '--alone', self.options.convexact)]
        name = pathlib.Path(script).stem
        self.record = {'id': name, 'figure': figure, 'command': ' '.join(['./dev reproduce', name, *self.shown(words)]),
                       'claims': [], 'tables': [], 'skipped': []}

    def shown(self, words):
        """The options as anybody would give them: without the files that are written, and with names of folders only."""
        kept, skip = [], False
        for word in words:
            if skip or word in ('--json', '--plot'):
                skip = not skip
                continue
            kept.append(pathlib.Path(word).name if '/' in word else word)
        return kept

    def meshes(self, names=SHIPPED + OTHERS):
        """(name, path) of those that are there; the record says which are not."""
        for name in names:
            if self.options.only and name not in self.options.only:
                continue
            path = ROOT / 'tests' / 'data' / f'{name}.obj'
            if name not in SHIPPED:
                path = self.options.meshes / f'{name}.obj' if self.options.meshes else None
            if path is None or not path.is_file():
                self.record['skipped'].append(f'{name}: may not be shipped, and --meshes names no folder that has it')
                continue
            yield name, path

    def run(self, *arguments, codes=(0,)):
        """What a command of the program prints with --json."""
        ran = subprocess.run([self.options.convexact, *map(str, arguments), '--json'], capture_output=True, text=True)
        if ran.returncode not in codes:
            sys.exit(f'{" ".join(map(str, arguments))}: exit code {ran.returncode}\n{ran.stdout[-2000:]}{ran.stderr[-2000:]}')
        return json.loads(ran.stdout)

    def paper_program(self):
        """The paper's own program; None if it cannot be had, which the record then says."""
        from support.paper_program import PaperProgram  # pylint: disable=import-outside-toplevel,cyclic-import
        from support.peer_environment import Skipped  # pylint: disable=import-outside-toplevel
        if self.options.alone:
            return None
        try:
            return PaperProgram(self)
        except Skipped as reason:
            self.record['skipped'].append(f'pchs: {reason}')
            return None

    def paper_ratios(self, paper, mesh, counts):
        """Its volumes over that of the hull, as text; of no program, or where it fails, None."""
        if paper is None:
            return {count: None for count in counts}
        with scratch() as folder:
            hull, volume, _ = self.hull(mesh, folder)
            return {count: made.get('ratio') for count, made in paper.judged(hull, counts, volume).items()}

    def hull(self, mesh, folder):
        """The hull of a mesh as an OBJ, so that every program gets the same doubles: the file, its volume, its facets."""
        target = f'{folder}/hull.obj'
        answer = self.run('hull', mesh, '-o', target, '--measures', 'volume', '--digits', 17)
        return target, answer['volume']['value'], answer['input']['halfspaces']

    def claim(self, paper, here, verdict, pchs=None, interval=None, why=None):
        """verdict: a boolean, or one of the words above; pchs: the number of the paper's own program on the same input;
        interval: for which numbers the verdict is "as claimed", and why for these."""
        if isinstance(verdict, bool):
            verdict = AS_CLAIMED if verdict else DIFFERS
        self.record['claims'].append({'paper': paper, 'here': here, 'pchs': pchs or '-', 'interval': interval or '-',
                                      'why': why or '-', 'verdict': verdict})

    @staticmethod
    def within(value, low, high, order=None):
        """As claimed in the interval; of the same order within `order` = (low, high), if that is given; else it differs."""
        if low <= value <= high:
            return AS_CLAIMED
        return SAME_ORDER if order and order[0] <= value <= order[1] else DIFFERS

    @staticmethod
    def all_of(count, total):
        """For a claim about every one."""
        return AS_CLAIMED if count == total else DIFFERS

    def data(self, name, values):
        """Numbers of a figure."""
        self.record.setdefault('data', {})[name] = values

    def table(self, title, head, rows):
        self.record['tables'].append({'title': title, 'head': list(map(str, head)),
                                      'rows': [list(map(str, row)) for row in rows]})

    def finish(self):
        """Prints the record and writes it. That something differs is a result, and no failure unless it must hold."""
        print(markdown(self.record), end='')
        if self.options.json:
            self.options.json.parent.mkdir(parents=True, exist_ok=True)
            self.options.json.write_text(json.dumps(self.record, indent=1, ensure_ascii=False) + '\n', encoding='utf-8')
        differs = any(claim['verdict'] == DIFFERS for claim in self.record['claims'])
        return 1 if differs and self.options.must_hold else 0


def table_lines(head, rows):
    return [f'| {" | ".join(head)} |', '|' + '---|' * len(head), *(f'| {" | ".join(row)} |' for row in rows)]


CLAIM_HEAD = {'paper': 'the paper', 'here': 'here', 'pchs': 'its program here', 'interval': 'as claimed if', 'why': 'since',
              'verdict': 'verdict'}


def claim_lines(claims):
    return table_lines(list(CLAIM_HEAD.values()), [[claim[key] for key in CLAIM_HEAD] for claim in claims])


def markdown(record, heading='##'):
    """A record as a section of a page."""
    lines = [f'{heading} {record["id"]}: {record["figure"]}', '', f'`{record["command"]}`', '']
    if record['claims']:
        lines += claim_lines(record['claims']) + ['']
    for table in record['tables']:
        lines += [table['title'] + ':', '', *table_lines(table['head'], table['rows']), '']
    if record['skipped']:
        lines += ['Skipped: ' + '; '.join(record['skipped']) + '.', '']
    return '\n'.join(lines)


def ratio(answer, key='volume'):
    """A measure of the result of `simplify --json` over that of the hull."""
    return answer[key]['ratio']


def compared(experiment, mesh, faces, methods=None):
    """What `convexact compare` finds of each method: volume, area and mean width over those of the hull, the Hausdorff
    distance over the diameter, and the planes."""
    chosen = ('--methods', ','.join(methods)) if methods else ()
    answer = experiment.run('compare', mesh, '--faces', faces, *chosen)
    return {made['method']: made for made in answer['inputs'][0]['methods']}


def fitting(made):
    """Those that are bounded and have no more planes than asked for, by volume."""
    return sorted((name for name in made if made[name].get('fits')), key=lambda name: made[name]['volume']['value'])


def proxies(experiment, mesh, faces, folder, paper=None):
    """(method, file of its planes) of each that fits, the least volume first; and the file of the paper's program."""
    made = compared(experiment, mesh, faces)
    for name in fitting(made):
        file = pathlib.Path(folder) / 'proxy.json'
        file.write_text(json.dumps({'halfspaces': made[name]['halfspaces']}), encoding='utf-8')
        yield name, file
    if paper:
        hull, *_ = experiment.hull(mesh, folder)
        told = paper.run(hull, [faces], folder=str(folder))
        if 'made' in told:
            yield 'pchs', told['made'][str(faces)]['file']


def measures_of(experiment, solid):
    """Volume, area and mean width of a file, as doubles."""
    answer = experiment.run('hull', solid)
    return {key: answer[key]['value'] for key in ('volume', 'area', 'mean_width')}


def points_of(mesh):
    """The vertices of an OBJ."""
    with open(mesh, encoding='utf-8') as lines:
        return [tuple(map(float, line.split()[1:4])) for line in lines if line.startswith('v ')]


def faces_of(mesh):
    """The faces of an OBJ, as indices of vertices from 0."""
    with open(mesh, encoding='utf-8') as lines:
        return [[int(word.split('/')[0]) - 1 for word in line.split()[1:]] for line in lines if line.startswith('f ')]


def scratch():
    """A folder that goes with the program."""
    return tempfile.TemporaryDirectory()
