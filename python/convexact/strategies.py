# SPDX-License-Identifier: MIT
"""Strategies for Hypothesis: point sets that are hard for hull code. They shrink towards few points with small integers.

>>> from hypothesis import given
>>> from convexact.strategies import point_sets
"""
from __future__ import annotations

from typing import Any

import numpy as np
from hypothesis import strategies as st

KINDS = ("general", "lattice", "coplanar", "cospherical", "duplicated", "needles", "mixed", "subnormal")


def _array(rows: Any) -> Any:
    return np.array(rows, dtype=np.float64).reshape(-1, 3)


def _lattice(least: int, most: int, size: int) -> Any:
    return st.lists(st.tuples(*[st.integers(-size, size)] * 3), min_size=least, max_size=most).map(_array)


def _moved_by_ulps(points: Any, steps: Any) -> Any:
    moved = points.copy()
    for row, axis, ulps in steps:
        value = moved[row % len(moved), axis]
        moved[row % len(moved), axis] = value + ulps * np.spacing(value)
    return moved


def point_sets(kind: str | None = None, *, min_size: int = 4, max_size: int = 40) -> Any:
    """Arrays (n, 3) of doubles, of one kind or of any.

    general: integers up to a million; lattice: integers up to 3, so that many points are coplanar; coplanar: on z = 0 but
    for some units in the last place; cospherical: exactly on a sphere, by rational points of it, in doubles; duplicated:
    with repeats; needles: 2^40 times longer than wide; mixed: coordinates of many magnitudes; subnormal: below 2^-1022.
    """
    if kind is None:
        return st.one_of([point_sets(name, min_size=min_size, max_size=max_size) for name in KINDS])
    few = _lattice(min_size, max_size, 3)
    if kind == "general":
        return _lattice(min_size, max_size, 10**6)
    if kind == "lattice":
        return few
    if kind == "coplanar":
        steps = st.lists(st.tuples(st.integers(0, max_size), st.integers(0, 2), st.integers(-2, 2)), max_size=8)
        flat = few.map(lambda points: points * [0.1, 0.1, 0] + [0, 0, 1])
        return st.tuples(flat, steps).map(lambda both: _moved_by_ulps(*both))
    if kind == "cospherical":
        # From the plane to the sphere: (2u, 2v, u^2 + v^2 - 1) / (u^2 + v^2 + 1), scaled.
        def lift(pairs: Any) -> Any:
            return _array([[2 * u, 2 * v, u * u + v * v - 1] for u, v in pairs]) / _array([[u * u + v * v + 1] * 3 for u, v in pairs])

        return st.lists(st.tuples(*[st.integers(-9, 9)] * 2), min_size=min_size, max_size=max_size).map(lift)
    if kind == "duplicated":
        repeats = st.lists(st.integers(0, max_size), min_size=1, max_size=max_size)
        return st.tuples(few, repeats).map(lambda both: np.concatenate([both[0], both[0][[k % len(both[0]) for k in both[1]]]]))
    if kind == "needles":
        return few.map(lambda points: points * [1, 1, 2.0**40])
    if kind == "mixed":
        number = st.tuples(st.integers(-9, 9), st.integers(-60, 60)).map(lambda both: both[0] * 2.0 ** both[1])
        return st.lists(st.tuples(number, number, number), min_size=min_size, max_size=max_size).map(_array)
    if kind == "subnormal":
        return few.map(lambda points: points * 5e-324)
    raise ValueError(f"kind: expected one of {', '.join(KINDS)}, found {kind!r}")


def boxes(most: int = 6, size: int = 6) -> Any:
    """Lists of boxes ((low, high), ...) with integer corners: worlds of parts whose union is known."""
    side = st.tuples(st.integers(0, size), st.integers(1, size))
    box = st.tuples(side, side, side).map(
        lambda sides: (tuple(low for low, _ in sides), tuple(low + length for low, length in sides))
    )
    return st.lists(box, min_size=1, max_size=most)


def halfspaces(min_size: int = 4, max_size: int = 20) -> Any:
    """Arrays (m, 4) of small integers: n.x + d <= 0, any of them empty, unbounded or redundant."""
    row = st.tuples(*[st.integers(-4, 4)] * 4)
    return st.lists(row, min_size=min_size, max_size=max_size).map(lambda rows: np.array(rows, dtype=np.float64).reshape(-1, 4))
