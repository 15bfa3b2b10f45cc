# SPDX-License-Identifier: MIT
"""A copy of the sources with a build of its own, to break things in: the tree itself is never touched."""
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Assertions on, as in the ordinary test build; what is broken runs long enough without optimisation.
OPTIONS = ['-Dassertions=true', '-Dbuildtype=plain', '-Db_ndebug=false', '-Doptimization=2',
           '-Dcpp_args=-g1 -fpch-preprocess']


class Outcome:
    """How a test program ended: 'passed', 'failed', 'crashed' or 'timeout', and the cases that failed."""

    def __init__(self, how, cases=(), output=''):
        self.how, self.cases, self.output = how, list(cases), output


class Scratch:
    def __init__(self, folder):
        self.tree = pathlib.Path(folder).resolve() / 'tree'
        self.build_folder = self.tree / 'build'
        self.changed = {}
        self.copy()
        if not (self.build_folder / 'build.ninja').exists():
            subprocess.run(['meson', 'setup', self.build_folder, self.tree, *OPTIONS], check=True,
                           stdout=subprocess.DEVNULL)
        listed = subprocess.run(['meson', 'introspect', '--tests', self.build_folder], check=True,
                                capture_output=True, text=True).stdout
        self.tests = {test['name']: test for test in json.loads(listed)}

    def copy(self):
        """Brings the copy up to date; files that are the same keep their time of change."""
        files = subprocess.run(['git', 'ls-files', '-co', '--exclude-standard'], cwd=ROOT, check=True,
                               capture_output=True, text=True).stdout.split('\n')
        for name in filter(None, files):
            source, target = ROOT / name, self.tree / name
            if not source.is_file():
                continue
            if not target.exists() or target.read_bytes() != source.read_bytes():
                target.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(source, target)
                shutil.copymode(source, target)

    def write(self, name, text):
        path = self.tree / name
        self.changed.setdefault(name, path.read_text())
        path.write_text(text)

    def restore(self):
        for name, text in self.changed.items():
            (self.tree / name).write_text(text)
        self.changed = {}

    def program_of(self, test):
        return self.tests[test]['cmd'][0]

    def build(self, tests):
        """Builds what these tests run: whether that worked, and what the compiler said."""
        targets = set()
        for test in tests:
            for target in [self.program_of(test), *self.tests[test].get('depends', [])]:
                path = pathlib.Path(re.sub(r'@(exe|sha|cus)$', '', target))
                if path.is_absolute():
                    targets.add(str(path.relative_to(self.build_folder)))
        ran = subprocess.run(['ninja', '-C', self.build_folder, *sorted(targets)], text=True,
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        return ran.returncode == 0, ran.stdout

    def build_without_static_asserts(self, tests):
        """Build again and again, with each static_assert that fails taken out of the copy."""
        for _ in range(20):
            built, said = self.build(tests)
            failed = re.findall(r'^(?:\.\./)*(\S+?):(\d+):\d+: error: static assertion failed', said, re.M)
            if built or not failed:
                return built, said
            for name, line in set(failed):
                lines = (self.tree / name).read_text().split('\n')
                first = int(line) - 1
                while not lines[first].lstrip().startswith('static_assert'):
                    first -= 1
                last = first
                while not lines[last].rstrip().endswith(');'):
                    last += 1
                lines[first:last + 1] = ['static_assert(true);'] + [''] * (last - first)
                self.write(name, '\n'.join(lines))
        return False, said

    def run(self, test, limit, arguments=()):
        """Runs one test program of the suite, for at most `limit` seconds."""
        process = subprocess.Popen([*self.tests[test]['cmd'], *arguments], text=True, errors='replace',
                                   env={**os.environ, **self.tests[test]['env']}, cwd=self.build_folder,
                                   stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                   start_new_session=True)
        try:
            output, _ = process.communicate(timeout=limit)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)  # the session that was started above
            process.communicate()
            return Outcome('timeout')
        if process.returncode == 0:
            return Outcome('passed', output=output)
        # Of the blocks that doctest prints, those with an error: others only have messages.
        cases = [re.search(r'^TEST CASE:\s+(.*\S)', block, re.M) for block in re.split(r'^=+$', output, flags=re.M)
                 if 'ERROR:' in block]
        how = 'crashed' if process.returncode < 0 else 'failed'
        return Outcome(how, dict.fromkeys(case.group(1) for case in cases if case), output)
