# SPDX-License-Identifier: MIT
"""What the adapters of Python packages share: reading an OBJ, timing a call, writing what it returned with all digits."""
import json
import sys
import time

import numpy as np


def read_obj(path):
    """Points and triangles."""
    points, faces = [], []
    with open(path, encoding="utf-8") as lines:
        for line in lines:
            words = line.split()
            if words[:1] == ["v"]:
                points.append([float(x) for x in words[1:4]])
            elif words[:1] == ["f"]:
                corners = [int(word.split("/")[0]) - 1 for word in words[1:]]
                faces += [[corners[0], corners[k - 1], corners[k]] for k in range(2, len(corners))]
    return np.array(points), np.array(faces, dtype=np.int32).reshape(-1, 3)


def used_only(points, polygons):
    """Without the points that no polygon uses. Judges take all points of a file for the solid, so that a program which
    returns indices into its input would hold every point by the input's own."""
    index, kept = {}, []
    for polygon in polygons:
        for corner in polygon:
            if index.setdefault(int(corner), len(kept)) == len(kept):
                kept.append(points[int(corner)])
    return kept, [[index[int(corner)] for corner in polygon] for polygon in polygons]


def obj_lines(points, polygons, before=0):
    yield from ("v " + " ".join(repr(float(x)) for x in point) + "\n" for point in points)
    yield from ("f " + " ".join(str(int(k) + 1 + before) for k in polygon) + "\n" for polygon in polygons)


def parts_lines(parts):
    """An object for each part."""
    before = 0
    for number, (points, polygons) in enumerate(parts):
        yield f"o part_{number:03}\n"
        yield from obj_lines(points, polygons, before)
        before += len(points)


def timed(call):
    """The seconds of a call, the processor's if these are less, as on a busy machine; and what it returned."""
    start, used = time.perf_counter(), time.process_time()
    result = call()
    return min(time.perf_counter() - start, time.process_time() - used), result


def write_seconds(target, seconds):
    with open(target + ".json", "w", encoding="ascii") as out:
        json.dump({"seconds": seconds}, out)


def run(target, call, lines_of):
    """Writes the lines of what call() returns with its seconds, and its seconds beside. Returns the exit code: 4 if it raises.

    Nothing is written of an empty result.
    """
    try:
        seconds, result = call()
        lines = list(lines_of(result))
    except ImportError:
        raise
    except Exception as fault:  # pylint: disable=broad-exception-caught  # its own way to say no
        sys.stderr.write(f"{type(fault).__name__}: {fault}"[:2000])
        return 4
    if lines:
        with open(target, "w", encoding="ascii") as out:
            out.writelines(lines)
        write_seconds(target, seconds)
    return 0
