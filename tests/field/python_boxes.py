# SPDX-License-Identifier: MIT
"""Oriented boxes of Python packages as programs of ./dev field: python_boxes.py NAME INPUT.obj OUTPUT.txt

A box is the six halfspaces that its axes, its middle and its lengths say, a row n x + d <= 0 each, computed in doubles; that
adds some 1e-16 of the coordinates. Seconds and exit codes are those of python_hulls.py.
"""
import sys

import numpy as np
from adapter import read_obj, run, timed


def trimesh_box(points):
    import trimesh as package
    to_origin, extents = package.bounds.oriented_bounds(points)
    return to_origin[:3, :3], to_origin[:3, 3], extents


def open3d_box(points, minimal=False):
    import open3d as package
    cloud = package.geometry.PointCloud(package.utility.Vector3dVector(points))
    box = cloud.get_minimal_oriented_bounding_box() if minimal else cloud.get_oriented_bounding_box()
    axes = np.asarray(box.R).T
    return axes, -axes @ box.center, box.extent


def open3d_least_box(points):
    return open3d_box(points, minimal=True)


def row_lines(box):
    """Of the box |axes x + shift| <= extents / 2."""
    for axis, shift, extent in zip(*box):
        for side in (1, -1):
            yield " ".join(repr(float(x)) for x in (*(side * axis), side * shift - extent / 2)) + "\n"


def main(name, source, target):
    points, _ = read_obj(source)
    call = globals()[name.replace("-", "_")]

    def twice():
        """The second of two calls counts, since the first one may load the package."""
        call(points)
        return timed(lambda: call(points))
    return run(target, twice, row_lines)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
