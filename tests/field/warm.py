# SPDX-License-Identifier: MIT
"""Calls the adapters of Python packages in copies of a process that has imported the package: an import takes seconds, most
calls take milliseconds. Each call has a process of its own, so that a crash ends this call only.

As a program, `warm.py PACKAGE` is the process that is copied: it reads a call from each line, [adapter, arguments...] in JSON,
and answers with the copy's process id and then its wait status, a line each.
"""
import contextlib
import importlib
import json
import os
import select
import signal
import subprocess
import sys
import time
from pathlib import Path

# What is imported before: numpy, which every adapter needs, and what a package loads when it is called.
MODULES = {"scipy": ["scipy.spatial"], "trimesh": ["trimesh", "scipy.spatial", "scipy.optimize"], "open3d": ["open3d"],
           "manifold3d": ["numpy", "manifold3d"], "coal": ["numpy", "coal"], "pymeshlab": ["numpy", "pymeshlab"],
           "mujoco": ["mujoco"], "pchs": ["numpy", "pchs"], "libigl": ["numpy", "igl.copyleft.cgal"],
           "drake": ["numpy", "pydrake.geometry"]}
WARM = {}  # by package, of this process


class Dead(Exception):
    """The process that is copied has ended; for example, the package cannot be imported."""


def line_of(process, until):
    """The next line of answer; None if there is none in time. @raises Dead."""
    if not select.select([process.stdout], [], [], max(until - time.monotonic(), 0))[0]:
        return None
    line = process.stdout.readline()
    if not line:
        raise Dead
    return int(line)


def call(python, package, words, seconds):
    """The exit code of an adapter called with these words, as subprocess has it; None if it took too long. @raises Dead."""
    process = WARM.get(package)
    if process is None or process.poll() is not None:
        process = WARM[package] = subprocess.Popen([str(python), __file__, package], bufsize=0, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                                   stderr=subprocess.DEVNULL)
        line_of(process, time.monotonic() + 120)  # it has imported the package
    try:
        process.stdin.write(json.dumps([str(word) for word in words]).encode() + b"\n")
    except BrokenPipeError as fault:
        raise Dead from fault
    copy = line_of(process, time.monotonic() + 120)
    status = line_of(process, time.monotonic() + seconds)
    if status is None:
        with contextlib.suppress(ProcessLookupError):  # it may have ended just now
            os.kill(copy, signal.SIGKILL)
        line_of(process, time.monotonic() + 120)
        return None
    return os.waitstatus_to_exitcode(status)


def in_copy(words):
    """Never returns."""
    code = 1
    try:
        sys.path.insert(0, str(Path(words[0]).parent))
        adapter = importlib.import_module(Path(words[0]).stem)
        code = adapter.main(*words[1:])
    finally:
        os._exit(code)


def serve(package):
    answers = os.fdopen(os.dup(1), "w", buffering=1)
    silence = os.open(os.devnull, os.O_WRONLY)
    os.dup2(silence, 1)
    for name in MODULES.get(package, [package]):
        importlib.import_module(name)
    print(os.getpid(), file=answers)
    for line in sys.stdin:
        copy = os.fork()
        if copy == 0:
            in_copy(json.loads(line))
        print(copy, file=answers)
        print(os.waitpid(copy, 0)[1], file=answers)


if __name__ == "__main__":
    serve(sys.argv[1])
