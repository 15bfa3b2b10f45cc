# SPDX-License-Identifier: MIT
"""Assertions for tests of hull and decomposition code: on failure the message is the sentence of the claim, its witness, and
the input as a literal."""
from __future__ import annotations

from typing import Any

import numpy as np

from . import verify, verify_parts
from ._results import Verdict, Violated

_LONGEST = 60  # points that a message spells


def _literal(points: Any) -> str:
    try:
        rows = np.asarray(points, dtype=np.float64)
    except (TypeError, ValueError):
        return ""
    if rows.ndim != 2 or len(rows) > _LONGEST:
        return ""
    return "\npoints = " + repr(rows.tolist())


def _require(verdict: Verdict, points: Any) -> Verdict:
    if not verdict.ok:
        raise Violated("\n".join(f"{claim.name}: {claim.sentence}" for claim in verdict.violated) + _literal(points))
    return verdict


def assert_encloses(points: Any, candidate: Any, *, tolerance: Any = None) -> Verdict:
    """The candidate is a convex solid that holds every point."""
    return _require(verify(points, candidate, tolerance=tolerance), points)


def assert_is_hull(points: Any, candidate: Any, *, tolerance: Any = None) -> Verdict:
    """The candidate is the convex hull of the points."""
    return _require(verify(points, candidate, asks="hull", tolerance=tolerance), points)


def assert_covers(mesh: Any, parts: Any, *, distance: Any = None, tolerance: Any = None) -> Verdict:
    """The convex parts hold the mesh and, with a distance, reach no farther from it."""
    return _require(verify_parts(mesh, parts, distance=distance, tolerance=tolerance), mesh[0] if isinstance(mesh, tuple) else mesh)
