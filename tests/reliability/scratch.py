# SPDX-License-Identifier: MIT
"""A copy of the sources with a build of its own, to break things in: the tree itself is never touched.

What is broken is compiled again alone and linked in front of everything else, as a whole build for every
fault would take hours. A broken header stands for the few sources of UNITS that show what it does."""
import atexit
import json
import os
import pathlib
import re
import shlex
import shutil
import signal
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Assertions on, as in the ordinary test build.
OPTIONS = ['-Dassertions=true', '-Dbuildtype=plain', '-Db_ndebug=false', '-Doptimization=2',
           '-Dcpp_args=-g1 -fpch-preprocess']
_AUDIT = ['tests/fast/audit_test.cpp', 'tests/fast/audit_on_thousands_test.cpp']
_CAPS = 'tests/fast/cap_bounds_test.cpp'
_ROUNDED = ['src/fast/' + name for name in ('dual.cpp', 'signs.cpp', 'cap.cpp', 'checks.cpp', 'engines.cpp')]
_HULL = ['tests/hull/near_geometry_test.cpp', 'src/hull/initial_simplex.cpp', 'src/hull/incremental_hull.cpp',
         'src/hull/merge_facets.cpp', 'src/hull/check_hull.cpp']
_ORIENT = ['src/geometry/orient3d.cpp', 'tests/geometry/orient3d_bounds_test.cpp']
_OVERLAY = ['src/overlay/' + name for name in (
    'convex_part.cpp', 'coverage.cpp', 'laid_surface.cpp', 'union_boundary.cpp')]
_EXPANSION = ['tests/number/expansion_test.cpp', *_ORIENT]
UNITS = {
    'src/check/convexact_check.cpp': ['tests/check/checker.cpp'],
    'src/check/run.hpp': ['tests/check/checker.cpp'],
    'src/check/mesh_file.hpp': ['tests/check/checker.cpp'],
    'src/check/reach.hpp': ['tests/check/checker.cpp'],
    'src/check/placed.hpp': ['tests/check/checker.cpp'],
    'src/check/partition.hpp': ['tests/check/checker.cpp'],
    'src/check/text.hpp': ['tests/check/checker.cpp'],
    'src/check/exact.hpp': ['tests/check/checker.cpp'],
    'src/check/root_sum.hpp': ['tests/check/checker.cpp'],
    'src/query/probe_errors.hpp': ['src/query/probed_solid.cpp', 'tests/query/probe_errors_test.cpp'],
    'src/near/near_plane.hpp': ['src/stored/containment.cpp', 'src/stored/stored_planes.cpp',
                                    'src/stored/acceptance.cpp', 'tests/stored/containment_test.cpp'],
    'src/number/roundoff.hpp': [*_EXPANSION, 'tests/number/double_double_test.cpp', *_AUDIT],
    'src/number/expansion.hpp': _EXPANSION,
    'src/geometry/orient3d_stages.hpp': _ORIENT,
    'src/number/double_double.hpp': ['tests/number/double_double_test.cpp', *_ROUNDED, *_AUDIT],
    'src/fast/dual.hpp': ['src/fast/dual.cpp', 'src/fast/metric_cost.cpp', *_AUDIT],
    'src/fast/signs.hpp': ['tests/fast/plane_filter_test.cpp', *_ROUNDED, *_AUDIT],
    'src/fast/cap_volume.hpp': [_CAPS, 'src/fast/cap.cpp'],
    'src/fast/ring_determinants.hpp': [_CAPS, 'src/fast/cap.cpp'],
    'src/fast/angular_excess.hpp': ['src/fast/angular_excess.cpp', 'src/fast/metric_cost.cpp', 'src/fast/long_metric.cpp'],
    'src/fast/metric_cost.hpp': ['src/fast/metric_cost.cpp', *_AUDIT],
    'src/fast/keyed_queue.hpp': ['src/fast/filtered_loop.cpp'],
    'src/fast/filtered_loop.hpp': ['src/fast/filtered_loop.cpp', 'src/fast/engines.cpp', 'src/scene/part_runs.cpp'],
    'src/fast/float_loop_steps.hpp': ['src/fast/float_loop.cpp'],
    'src/fast/near_vertices.hpp': ['src/fast/near_vertices.cpp', 'src/fast/filtered_inner.cpp'],
    'src/near/near_geometry.hpp': _HULL,
    'src/hull/exact_points.hpp': _HULL,
    'src/overlay/arrangement.hpp': _OVERLAY,
    'src/overlay/convex_piece.hpp': _OVERLAY,
}


LIBRARY = re.compile(r'(src/libconvexact_(kernel|solids|rim|lab)|tests/check/libchecker)\.a\.p/')


class Outcome:
    """How a test program ended: 'passed', 'failed', 'crashed' or 'timeout', and the cases that failed."""

    def __init__(self, how, cases=(), output=''):
        self.how, self.cases, self.output = how, list(cases), output


def copy_tree(target, instead=()):
    """Brings a copy of the sources up to date, some files with another text; files that are the same keep their time
    of change."""
    listed = subprocess.run(['git', 'ls-files', '-co', '--exclude-standard'], cwd=ROOT, check=True, capture_output=True, text=True)
    for name in listed.stdout.split('\n'):
        source, copy = ROOT / name, target / name
        if not source.is_file():
            continue
        data = instead[name].encode() if name in instead else source.read_bytes()
        if copy.exists() and copy.read_bytes() == data:
            continue
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_bytes(data)
        shutil.copymode(source, copy)


class Scratch:
    def __init__(self, folder, options=OPTIONS):
        self.tree = pathlib.Path(folder).resolve() / 'tree'
        self.build_folder = self.tree / 'build'
        self.tree.mkdir(parents=True, exist_ok=True)
        self.lean = pathlib.Path(tempfile.mkdtemp(prefix='lean', dir=self.tree.parent))
        atexit.register(shutil.rmtree, self.lean)
        self.changed, self.compiled, self.links = {}, {}, {}
        copy_tree(self.tree)
        if not (self.build_folder / 'build.ninja').exists():
            subprocess.run(['meson', 'setup', self.build_folder, self.tree, *options], check=True,
                           stdout=subprocess.DEVNULL)
        else:  # the tests may be others than those of an earlier copy
            subprocess.run(['ninja', '-C', self.build_folder, 'build.ninja'], check=True, stdout=subprocess.DEVNULL)
        self.programs = {}  # by name of a test: its path, its arguments and the environment it wants
        for test in json.loads(self._said('meson', 'introspect', '--tests', str(self.build_folder))):
            self.programs[test['name']] = (pathlib.Path(test['cmd'][0]), test['cmd'][1:], test['env'])
        commands = json.loads((self.build_folder / 'compile_commands.json').read_text())
        self.commands = {entry['output']: (entry['command'], (self.build_folder / entry['file']).resolve())
                         for entry in commands}

    def _said(self, *command, folder=ROOT):
        return subprocess.run(command, cwd=folder, check=True, capture_output=True, text=True).stdout

    def build(self, test):
        """Builds a test as it is, if that has not been done."""
        if test in self.links:
            return
        target = str(self.programs[test][0].relative_to(self.build_folder))
        subprocess.run(['ninja', '-C', self.build_folder, target], check=True, stdout=subprocess.DEVNULL)
        self.links[test] = shlex.split(
            self._said('ninja', '-t', 'commands', target, folder=self.build_folder).strip().split('\n')[-1])

    def _compile(self, output, target, more=()):
        """Compiles what makes `output` into `target`, without optimisation: what the compiler said if it failed.
        For the library the header that all sources include is compiled first, in the same way; tests include theirs as it is."""
        command, _ = self.commands[output]
        drop = {'ccache', '-fpch-preprocess', '-Winvalid-pch', '-MD', '-g1'}
        words = [word for word in shlex.split(command) if word not in drop and not re.match(r'-I(src/libconvexact|tests/).*\.p$', word)]
        for option in ('-MF', '-MQ'):
            del words[words.index(option):words.index(option) + 2]
        words += ['-O0', '-w', '-fdiagnostics-color=never', *more]
        words[words.index('-o') + 1] = str(target)
        if 'tests.hpp' in words:
            words.insert(1, f'-I{self.tree}/tests/support/pch')
        elif '-include' in words:
            precompiled = self.lean / 'pch' / 'library.hpp.gch'
            if not precompiled.exists():
                precompiled.parent.mkdir()
                shutil.copyfile(self.tree / 'src' / 'pch' / 'library.hpp', precompiled.with_suffix(''))
                header = list(words)
                del header[header.index('-include'):header.index('-include') + 2]
                header[header.index('-c'):header.index('-c') + 2] = ['-x', 'c++-header', str(precompiled.with_suffix(''))]
                header[header.index('-o') + 1] = str(precompiled)
                subprocess.run(header, cwd=self.build_folder, check=True)
            words.insert(1, f'-I{precompiled.parent}')
        ran = subprocess.run(words, cwd=self.build_folder, capture_output=True, text=True)
        return None if ran.returncode == 0 else ran.stderr

    def write(self, name, text):
        """Changes a file until restore()."""
        path = self.tree / name
        if name not in self.changed:
            self.changed[name] = (path.read_text(), path.stat().st_mtime_ns)
        path.write_text(text)
        self.compiled = {}

    def restore(self):
        for name, (text, time) in self.changed.items():
            (self.tree / name).write_text(text)
            os.utime(self.tree / name, ns=(time, time))  # nothing to build again
        self.changed, self.compiled = {}, {}

    def _objects(self, test, name, of_test):
        """The objects, of the test or of the library, that are compiled again when `name` has changed."""
        self.build(test)
        linked = set(self.links[test])
        for unit in UNITS.get(name, [name]):
            for output, (_, source) in self.commands.items():
                in_library = LIBRARY.match(output)
                if source == self.tree / unit and (in_library and not of_test or output in linked and of_test):
                    yield output

    def has_units(self, test, name, of_test):
        return any(True for _ in self._objects(test, name, of_test))

    def rebuild(self, test, name, with_library):
        """Links a test anew after a change of file `name`: its program, or None and what the compiler said."""
        replaced = list(self._objects(test, name, True))
        if with_library:
            replaced += self._objects(test, name, False)
        for output in replaced:
            if output not in self.compiled:
                said = self._compile(output, self.lean / output.replace('/', '_'))
                if said is not None:
                    return None, said
                self.compiled[output] = str(self.lean / output.replace('/', '_'))
        program = self.lean / 'program'
        words = self.links[test]
        start = words.index('-o')
        rest = [word for word in words[start + 2:] if word not in replaced]
        link = [*words[:start], '-o', str(program), *(self.compiled[r] for r in replaced), *rest]
        ran = subprocess.run(link, cwd=self.build_folder, capture_output=True, text=True)
        return (program, '') if ran.returncode == 0 else (None, ran.stderr)

    def rebuild_without_static_asserts(self, test, name, with_library):
        """Rebuilds again and again, with each static_assert that fails taken out of the copy."""
        for _ in range(20):
            program, said = self.rebuild(test, name, with_library)
            failed = re.findall(r'^(?:\.\./)*(\S+?):(\d+):\d+: error: static assertion failed', said, re.M)
            if program or not failed:
                break
            for header, line in set(failed):
                lines = (self.tree / header).read_text().split('\n')
                first = last = int(line) - 1
                while not lines[first].lstrip().startswith('static_assert'):
                    first -= 1
                while not lines[last].rstrip().endswith(');'):
                    last += 1
                lines[first:last + 1] = ['static_assert(true);'] + [''] * (last - first)
                self.write(header, '\n'.join(lines))
        return program, said

    def run(self, test, limit, program=None):
        """Runs a test, or another program in its place, for at most `limit` seconds."""
        self.build(test)
        path, arguments, environment = self.programs[test]
        process = subprocess.Popen([program or path, *arguments, '--abort-after=1'], text=True, errors='replace', start_new_session=True,
                                   env={**os.environ, **environment}, cwd=self.build_folder,
                                   stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        try:
            output, _ = process.communicate(timeout=limit)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)  # the session that was started above
            process.communicate()
            return Outcome('timeout')
        if process.returncode == 0:
            return Outcome('passed', output=output)
        # Of the blocks that doctest prints, those with an error: others only have messages.
        cases = [re.search(r'^TEST CASE:\s+(.*\S)', block, re.M)
                 for block in re.split(r'^=+$', output, flags=re.M) if 'ERROR:' in block]
        how = 'crashed' if process.returncode < 0 else 'failed'
        return Outcome(how, dict.fromkeys(case.group(1) for case in cases if case), output)
