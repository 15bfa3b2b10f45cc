#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What the experiments compute themselves, against closed forms: slopes, intervals, planes, and the order of a corpus."""
import hashlib
import math
import pathlib
import sys
import tempfile
from fractions import Fraction

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from support import corpus  # noqa: E402
from support.experiment import AS_CLAIMED, DIFFERS, SAME_ORDER, Experiment  # noqa: E402
from support.run_pchs import plane_through, read_obj  # noqa: E402
from timing import fit  # noqa: E402


def check_fit():
    sizes = [1000 * 2 ** k for k in range(7)]
    slope, residual = fit(sizes, [3e-7 * n ** 1.5 for n in sizes])
    assert math.isclose(slope, 1.5) and residual < 1e-9
    slope, residual = fit(sizes, [n * (1.1 if k == 3 else 1) for k, n in enumerate(sizes)])
    # The middle one does not turn the line, and lifts it by a seventh of its logarithm.
    assert math.isclose(slope, 1) and math.isclose(residual, 1.1 ** (6 / 7) - 1)


def check_verdicts():
    within = Experiment.within
    assert [within(x, 1.015, 1.025, order=(1.01, 1.04)) for x in (1.0149, 1.015, 1.025, 1.03, 1.05)] == [
        SAME_ORDER, AS_CLAIMED, AS_CLAIMED, SAME_ORDER, DIFFERS]
    assert within(1.03, 1.015, 1.025) == DIFFERS
    assert Experiment.all_of(8, 8) == AS_CLAIMED and Experiment.all_of(7, 8) == DIFFERS


def check_planes():
    """x + y + z <= 3/4 through three corners; the first three are on a line."""
    corners = [tuple(map(Fraction, p)) for p in ((0.75, 0, 0), (0.5, 0.25, 0), (0.25, 0.5, 0), (0, 0, 0.75))]
    row = [int(x) for x in plane_through(corners)]
    assert row[0] == row[1] == row[2] > 0 and Fraction(row[3], row[0]) == Fraction(-3, 4), row
    assert plane_through(corners[:3]) is None


def check_files():
    with tempfile.TemporaryDirectory() as folder:
        mesh = pathlib.Path(folder) / 'a.obj'
        mesh.write_text('v 9 9 9\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 2/1 3/1 4/1 5/1\n')
        points, faces = read_obj(mesh)
        assert points == [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]] and faces == [[0, 1, 2], [0, 2, 3]]
        for name in corpus.PACKAGES:
            (pathlib.Path(folder) / name).mkdir()
            (pathlib.Path(folder) / name / 'done').touch()
        place = pathlib.Path(folder) / 'pybullet'
        for name in ('one.stl', 'two.obj', 'same.STL', 'other.txt'):
            (place / name).write_text(name if name != 'same.STL' else 'one.stl')
        skipped = []
        found = corpus.meshes(skipped, pathlib.Path(folder))
        assert not skipped and len(found) == 2, found
        digests = [hashlib.sha256(path.read_bytes()).hexdigest() for _, path in found]
        assert digests == sorted(digests)


if __name__ == '__main__':
    check_fit()
    check_verdicts()
    check_planes()
    check_files()
