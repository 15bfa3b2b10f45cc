# SPDX-License-Identifier: MIT
"""Decomposers of the Python index as programs of ./dev field: python_parts.py NAME INPUT.obj OUTPUT.obj

Each with its defaults, by the call that its own documents show. An object for each part, with all digits; pybullet writes its
file itself. The seconds of that call go to OUTPUT.obj.json. Exit code 4: the package raised an exception. If it
made no part there is no file, and the exit code is 0.
"""
import sys
import tempfile

import numpy as np
from adapter import parts_lines, read_obj, run, timed, write_seconds


def coacd(points, faces):
    import coacd as package
    package.set_log_level("off")
    return package.run_coacd(package.Mesh(points, faces))


def miniacd(points, faces):
    import miniacd as package
    mesh = package.Mesh(points, faces.astype(np.uint32))
    return [(part.vertices(), part.faces()) for part in package.run(mesh, print=False)]


def vhacdx(points, faces):
    import vhacdx as package
    flat = np.column_stack((np.full(len(faces), 3), faces)).ravel().astype(np.uint32)
    return [(corners, np.reshape(found, (-1, 4))[:, 1:] if np.ndim(found) == 1 else found)
            for corners, found in package.compute_vhacd(points, flat)]


def pybullet(source, target):
    import pybullet as package
    package.connect(package.DIRECT)
    with tempfile.NamedTemporaryFile() as log:
        return timed(lambda: package.vhacd(source, target, log.name))[0]


def main(name, source, target):
    if name == "pybullet":
        write_seconds(target, pybullet(source, target))
        return 0
    points, faces = read_obj(source)
    __import__(name)  # loading it is not measured
    return run(target, lambda: timed(lambda: globals()[name](points, faces)), parts_lines)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
