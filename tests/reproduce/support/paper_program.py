# SPDX-License-Identifier: MIT
"""The paper's own program, as its package of the Python index has it (pchs, built on Qhull), and the oracle's verdict on it."""
import json
import pathlib
import subprocess

from support.experiment import scratch
from support.peer_environment import environment, require

VERSION = '0.1.0'
SCRIPT = pathlib.Path(__file__).with_name('run_pchs.py')


class PaperProgram:
    """@raises Skipped if it cannot be had."""

    def __init__(self, experiment):
        self.experiment = experiment
        self.python = environment()
        require(self.python, 'pchs', VERSION)

    def run(self, mesh, counts, **options):
        """What run_pchs.py tells; {"error": ...} if it dies."""
        asked = {'mesh': str(mesh), 'counts': list(counts), **options}
        ran = subprocess.run([self.python, SCRIPT], input=json.dumps(asked), capture_output=True, text=True, check=False)
        if ran.returncode != 0:
            return {'error': (ran.stderr.strip().splitlines() or [f'exit code {ran.returncode}'])[-1]}
        return json.loads(ran.stdout)

    def judged(self, mesh, counts, volume, cost='volume'):
        """{halfspaces asked for: volume over that of the hull, halfspaces, points outside and the farthest of them}."""
        with scratch() as folder:
            told = self.run(mesh, counts, folder=folder, cost=cost)
            if 'error' in told:
                return {count: {'fault': told['error']} for count in counts}
            return {int(count): {**self.verdict(mesh, made['file'], volume), 'halfspaces': made['halfspaces']}
                    for count, made in told['made'].items()}

    def verdict(self, mesh, file, volume):
        verdict = self.experiment.run('verify', mesh, file, '--claims', 'contains-input', codes=(0, 1))
        claims = {claim['code']: claim for claim in verdict['claims']}
        if claims.get('contains-input', {}).get('status') not in ('holds', 'violated'):
            return {'fault': next(claim['sentence'] for claim in claims.values() if claim['status'] == 'violated')}
        outside = verdict.get('outside', {})
        found = self.experiment.run('hull', file, '--measures', 'volume,area', '--digits', 17)
        return {'ratio': found['volume']['value'] / volume, 'area': found['area']['value'],
                'outside': outside.get('points', 0), 'farthest': float(outside.get('worst_relative', 0))}

    def order(self, mesh, folder, cost='volume'):
        """Its removals down to 6 as rows of planes, for `verify --trace`: a file, and how many have no plane."""
        told = self.run(mesh, [6], order=True, cost=cost)
        if 'error' in told:
            return None, told['error']
        rows = [' '.join(plane) for plane in told['order'] if plane]
        path = pathlib.Path(folder) / 'order.txt'
        path.write_text('\n'.join(rows) + '\n', encoding='utf-8')
        return path, len(told['order']) - len(rows)
