# SPDX-License-Identifier: MIT
"""Hypothesis searches for points that `enclose`, the program under test, does not enclose."""
import math

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from oracle import Oracle

coordinates = st.floats(-1e6, 1e6)  # finite, signed zeros and subnormals included
point_sets = st.lists(st.tuples(coordinates, coordinates, coordinates), min_size=4, max_size=30)
DIRECTIONS = [(x, y, z) for x in (-1, 0, 1) for y in (-1, 0, 1) for z in (-1, 0, 1) if x or y or z]


def enclose(points):
    """The program under test: 26 planes (n1, n2, n3, d) around the points, rounded outward."""
    reach = [max(math.fsum(n * x for n, x in zip(normal, p)) for p in points)
             for normal in DIRECTIONS]
    return [(*normal, math.nextafter(-r, -math.inf)) for normal, r in zip(DIRECTIONS, reach)]


@pytest.fixture(scope="module")
def oracle():
    oracle = Oracle()
    yield oracle
    assert oracle.close() == 0


@given(points=point_sets)
@settings(max_examples=200, deadline=None)
def test_every_point_is_inside(oracle, points):
    try:
        verdict = oracle.verify(points, {"planes": enclose(points)}, claims=["contains-input"])
    except ValueError:  # the points lie in one plane: nothing to enclose
        assume(False)
    assert verdict["verdict"] == "holds", verdict["claims"][0]["sentence"]


def test_a_plane_that_cuts_is_found(oracle):
    points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
    planes = [(-1, 0, 0, 0), (0, -1, 0, 0), (0, 0, -1, 0), (1, 1, 1, -0.5)]
    verdict = oracle.verify(points, {"planes": planes}, claims=["contains-input"])
    assert verdict["verdict"] == "violated"
    assert verdict["outside"]["points"] == 3
    assert verdict["claims"][0]["witness"]["nearest"] == ["1/2", "0", "0"]
    assert verdict["claims"][0]["witness"]["distance"]["squared"] == "1/4"
