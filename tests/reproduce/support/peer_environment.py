# SPDX-License-Identifier: MIT
"""An environment with pinned packages of the Python index, made once, for programs to compare with."""
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
FOLDER = ROOT / 'build' / 'peers'


class Skipped(Exception):
    """With the reason."""


def environment(folder=FOLDER):
    """Its Python. @raises Skipped."""
    python = pathlib.Path(folder) / 'bin' / 'python'
    if not python.exists():
        made = subprocess.run([sys.executable, '-m', 'venv', folder], capture_output=True, text=True, check=False)
        if made.returncode != 0:
            raise Skipped('no environment: ' + (made.stderr.strip().splitlines() or ['python3 -m venv failed'])[-1])
    return python


def require(python, name, version):
    """Installs a version of a package, and numpy, if they are not there. @raises Skipped."""
    has = f'import importlib.metadata as m, numpy; assert m.version({name!r}) == {version!r}'
    if subprocess.run([python, '-c', has], capture_output=True, check=False).returncode == 0:
        return
    pip = [python, '-m', 'pip', 'install', '--quiet', '--disable-pip-version-check', '--prefer-binary', '--retries', '1']
    made = subprocess.run([*pip, f'{name}=={version}', 'numpy'], capture_output=True, text=True, check=False)
    if made.returncode != 0:
        raise Skipped(f'{name} {version} cannot be had: ' + (made.stderr.strip().splitlines() or ['pip failed'])[-1])
