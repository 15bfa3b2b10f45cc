# SPDX-License-Identifier: MIT
"""Decomposers of the Python index as programs of ./dev field: python_parts.py NAME INPUT.obj OUTPUT.obj

Each with its defaults, by the call that its own documents show. An object for each part, with all digits; pybullet writes its
file itself. The seconds of that call go to OUTPUT.obj.json. Exit code 4: the package raised an exception, or made no part.
"""
import json
import sys
import tempfile
import time

import numpy as np
from python_hulls import read_obj


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


def text_of(parts):
    lines, base = [], 1
    for number, (corners, triangles) in enumerate(parts):
        lines.append(f"o part_{number:03}")
        lines += ["v " + " ".join(repr(float(x)) for x in corner) for corner in corners]
        lines += ["f " + " ".join(str(int(k) + base) for k in triangle) for triangle in triangles]
        base += len(corners)
    return "\n".join(lines) + "\n"


def timed(call):
    """The seconds of a call, the processor's if these are less, as on a busy machine; and what it returned."""
    start, used = time.perf_counter(), time.process_time()
    result = call()
    return min(time.perf_counter() - start, time.process_time() - used), result


def pybullet(source, target):
    import pybullet as package
    package.connect(package.DIRECT)
    with tempfile.NamedTemporaryFile() as log:
        return timed(lambda: package.vhacd(source, target, log.name))[0]


def main(name, source, target):
    if name == "pybullet":
        seconds = pybullet(source, target)
    else:
        points, faces = read_obj(source)
        try:
            __import__(name)  # loading it is not measured
            seconds, parts = timed(lambda: globals()[name](points, faces))
        except ImportError:
            raise
        except Exception as fault:  # pylint: disable=broad-exception-caught  # its own way to say no
            sys.stderr.write(f"{type(fault).__name__}: {fault}"[:2000])
            return 4
        if len(parts) == 0:
            return 4
        with open(target, "w", encoding="ascii") as out:
            out.write(text_of(parts))
    with open(target + ".json", "w", encoding="ascii") as out:
        json.dump({"seconds": seconds}, out)
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
