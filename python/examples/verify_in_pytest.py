# SPDX-License-Identifier: MIT
"""A test of one's own hull: pytest -p convexact.pytest_plugin verify_in_pytest.py --convexact-keep kept"""
from typing import Any

import numpy as np
from hypothesis import assume, given, settings

import convexact as cx
from convexact.strategies import point_sets
from convexact.testing import assert_is_hull


def my_hull(points: Any) -> Any:
    """The program under test: here, all points, which is right."""
    return np.unique(points, axis=0)


@settings(max_examples=100, deadline=None)
@given(point_sets())
def test_my_hull(points: Any) -> None:
    try:
        cx.hull(points, measures=())
    except cx.NotSolid:
        assume(False)
    assert_is_hull(points, my_hull(points))


def test_a_cube(oracle: Any) -> None:
    cube = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    oracle.assert_is_hull(cube, my_hull(np.array(cube, dtype=float)))
