# SPDX-License-Identifier: MIT
"""Hulls and enclosures. Expected values: closed forms, and signs of determinants of Fractions, which share nothing with the
library."""
import json
import os
import pickle
import signal
import subprocess
import sys
import threading
import time
from decimal import Decimal
from fractions import Fraction
from itertools import combinations
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import find, given, settings

import convexact as cx
from convexact.strategies import KINDS, boxes, halfspaces, point_sets

DATA = Path(os.environ["CONVEXACT_TEST_DATA"])
CUBE = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]
QUADS = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]


def volume_six(a: Any, b: Any, c: Any, d: Any) -> Any:
    """Six times the signed volume of a tetrahedron, in Fractions."""
    u, v, w = ([Fraction(x) - Fraction(y) for x, y in zip(p, a)] for p in (b, c, d))
    return (u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) + u[2] * (v[0] * w[1] - v[1] * w[0]))


def is_flat(points: Any) -> Any:
    distinct = sorted({tuple(p) for p in points.tolist()})
    if len(distinct) > 12:
        return None
    return all(volume_six(*four) == 0 for four in combinations(distinct, 4))


def hull_volume(points: Any) -> Any:
    """By definition: the facets are the planes through three points with all others on one side."""
    points = sorted({tuple(map(Fraction, p)) for p in points.tolist()})
    middle = tuple(sum(axis) / len(points) for axis in zip(*points))
    planes = set()
    for a, b, c in combinations(points, 3):
        signs = {(value > 0) - (value < 0) for value in (volume_six(a, b, c, p) for p in points)}
        if signs <= {0, 1} and signs != {0} or signs <= {0, -1} and signs != {0}:
            planes.add(frozenset(p for p in points if volume_six(a, b, c, p) == 0))
    total = Fraction(0)
    for corners in planes:
        total += cone_over_polygon(middle, list(corners))
    return total / 6


def cone_over_polygon(apex: Any, corners: Any) -> Any:
    """Six times the volume of the cone over the hull of coplanar points: the hull's edges seen from one of its points."""
    best = Fraction(0)
    a = min(corners)
    rest = [p for p in corners if p != a]
    for b, c in combinations(rest, 2):
        # Triangles of a fan from the extreme point a: those edges b c beyond which no corner lies.
        value = abs(volume_six(apex, a, b, c))
        if value == 0:
            continue
        beyond = [p for p in rest if p not in (b, c) and volume_six(apex, b, c, p) * volume_six(apex, b, c, a) < 0]
        between = [p for p in rest if p not in (b, c) and volume_six(apex, b, c, p) == 0 and is_between(b, c, p)]
        if not beyond and not between:
            best += value
    return best


def is_between(b: Any, c: Any, p: Any) -> Any:
    return sum((x - y) * (z - y) for x, y, z in zip(b, p, c)) < 0


def test_a_cube() -> None:
    hull = cx.hull(CUBE)
    assert hull.volume == 1 and hull.area == (6.0, 6.0)
    assert hull.mean_width[0] <= 1.5 <= hull.mean_width[1]
    assert len(hull.faces) == 6 and hull.vertices.shape == (8, 3) and hull.planes.shape == (6, 4)
    assert sorted(hull.exact_planes)[0] == (-1, 0, 0, 0)
    assert hull.document["volume"]["decimal"] == "1"


@pytest.mark.parametrize("third", [Fraction(1, 3), Decimal("0.1"), 2**80])
def test_exact_numbers_are_taken_exactly(third: Any) -> None:
    points = np.array([[0, 0, 0], [third, 0, 0], [0, third, 0], [0, 0, third]], dtype=object)
    assert cx.hull(points, measures=["volume"]).volume == Fraction(third) ** 3 / 6


def test_planes_bound_a_solid() -> None:
    assert cx.hull(planes=[[-1, 0, 0, 0], [0, -1, 0, 0], [0, 0, -1, 0], [1, 1, 1, -1]]).volume == Fraction(1, 6)
    with pytest.raises(cx.NotSolid):
        cx.hull(planes=[[-1, 0, 0, 0], [0, -1, 0, 0], [0, 0, -1, 0]])


@settings(max_examples=60, deadline=None)
@given(point_sets(max_size=7))
def test_hulls_are_those_of_the_definition(points: Any) -> None:
    try:
        hull = cx.hull(points, measures=["volume"])
    except cx.NotSolid:
        assert is_flat(points) in (True, None)
        return
    assert hull.volume == hull_volume(points)


@settings(max_examples=200, deadline=None)
@given(point_sets())
def test_verdicts_accept_exact_hulls_and_refuse_smaller_ones(points: Any) -> None:
    try:
        hull = cx.hull(points, measures=())
    except cx.NotSolid:
        with pytest.raises(cx.NotSolid):
            cx.verify(points, CUBE)
        return
    assert cx.verify(points, hull, asks="hull").ok
    assert cx.verify(points, points, asks="hull").ok
    corner = hull.exact_vertices[0]
    others = [p for p in points.tolist() if tuple(map(Fraction, p)) != corner]
    smaller = cx.verify(points, others)
    assert not smaller.ok
    if smaller.claims["candidate-solid"].holds:
        assert not smaller.claims["contains-input"].holds


@settings(max_examples=100, deadline=None)
@given(halfspaces())
def test_halfspaces_of_any_kind(rows: Any) -> None:
    try:
        hull = cx.hull(planes=rows, measures=["volume"])
    except cx.NotSolid:
        return
    assert hull.volume > 0
    for corner in hull.exact_vertices:
        assert all(sum(Fraction(n) * x for n, x in zip(row, corner)) + Fraction(row[3]) <= 0 for row in rows.tolist())


def box_mesh(low: Any, high: Any) -> Any:
    return [[(low, high)[bit][axis] for axis, bit in enumerate(corner)] for corner in CUBE], QUADS


@settings(max_examples=30, deadline=None)
@given(boxes())
def test_unions_of_boxes_are_held_by_these(world: Any) -> None:
    low, high = world[0]
    mesh = box_mesh(low, high)
    parts = [box_mesh(*box) for box in world]
    assert cx.verify_parts(mesh, parts).claims["covers-surface"].holds
    corners = [c for c in mesh[0] if any(all(a <= x <= b for a, x, b in zip(lo, c, hi)) for lo, hi in world[1:])]
    rest = cx.verify_parts(mesh, parts[1:]) if len(parts) > 1 else None
    if rest is not None:
        assert rest.claims["covers-points"].holds == (len(corners) == 8)


@pytest.mark.parametrize("engine", ["exact", "filtered", "float"])
def test_simplified_solids_hold_every_point(engine: Any) -> None:
    points = cx.generate("random-ball", seed=3)
    small = cx.simplify(points, faces=10, engine=engine)
    assert len(small.exact_planes) == 10 and small.stop == "reached"
    for n1, n2, n3, d in small.exact_planes:
        assert all(n1 * Fraction(x) + n2 * Fraction(y) + n3 * Fraction(z) + d <= 0 for x, y, z in points.tolist())
    assert cx.verify(points, small.planes).ok
    alone = cx.simplify(points, faces=10, engine=engine, jobs=1)
    assert alone.exact_planes == small.exact_planes and cx.hull(points, jobs=1).volume == cx.hull(points, jobs=2).volume
    for wrong in (0, 257, 2**50, True):
        with pytest.raises(cx.InvalidArgument):
            cx.hull(points, jobs=wrong)
    stored = cx.simplify(points.astype(np.float32), faces=10)
    assert (stored.mesh[0] == stored.mesh[0].astype(np.float32)).all()
    assert cx.verify(points.astype(np.float32), stored.mesh).ok


def test_traces_proofs_and_pickles() -> None:
    small = cx.simplify(CUBE + [[2, 2, 2]], faces=4, trace=True, record=True)
    assert json.loads(small.trace()) and small.proof().startswith("convexact")
    again = pickle.loads(pickle.dumps(small))
    assert again.exact_planes == small.exact_planes and again.document == small.document
    assert repr(again) == repr(small) and "iframe" in small._repr_html_() and "iframe" not in again._repr_html_()
    with pytest.raises(cx.InvalidArgument, match="not kept when this result was pickled"):
        again.trace()
    verdict = pickle.loads(pickle.dumps(cx.verify(CUBE, CUBE[:7])))
    assert not verdict.ok and verdict.claims["contains-input"].point == 7
    parts = pickle.loads(pickle.dumps(cx.decompose((CUBE, QUADS))))
    assert len(parts) == 1 and len(parts[0].faces) == 6
    with pytest.raises(cx.InvalidArgument, match="record=True"):
        cx.simplify(CUBE, faces=6).proof()


def test_searches() -> None:
    # Without a corner of the unit cube its hull has seven facets; six hold it best as the cube again, of volume 1.
    cut = [p for p in CUBE if p != [1, 1, 1]] + [[1, 1, 0.5], [1, 0.5, 1], [0.5, 1, 1]]
    best = cx.simplify(cut, faces=6, search="optimal", nodes=1000)
    assert best.volumes[1][0] <= 1 <= best.volumes[1][1] and best.document["search"]["optimum"]["proven"]
    ball = cx.generate("random-ball")
    greedy, local = (cx.simplify(ball, faces=8, **more) for more in ({}, {"search": "local", "moves": 3}))
    assert local.volumes[1][0] <= greedy.volumes[1][1]
    assert all(sum(Fraction(n) * Fraction(x) for n, x in zip(plane, [*p, 1])) <= 0 for plane in local.exact_planes for p in ball.tolist())
    for wrong in ({"moves": 3}, {"nodes": 3}, {"search": "local", "nodes": 3}, {"growth_of": "area"}):
        with pytest.raises(cx.InvalidArgument):
            cx.simplify(CUBE, faces=6, **wrong)


def test_inner_solids() -> None:
    points = cx.generate("random-ball", seed=2)
    inside = cx.inner(points, vertices=8)
    assert len(inside.kept) == 8
    assert cx.verify(points, (inside.vertices, inside.faces), asks="inner").ok


def test_decomposition_of_a_bin() -> None:
    mesh = DATA / "cases" / "bin.obj"
    parts = cx.decompose(mesh)
    assert len(parts) == 5 and parts.covers == "solid" and parts.method == "cut" and parts.limit_holds
    verdict = cx.verify_parts(mesh, parts, distance="3%")
    assert verdict.ok and verdict.claims["within-solid"].holds
    assert not cx.verify_parts(mesh, list(parts)[1:]).ok
    assert not cx.verify_parts(mesh, [cx.read_mesh(mesh)], distance="3%", claims=["within-solid"]).ok
    assert "<iframe" in parts._repr_html_() and "5 parts" in repr(parts)
    disjoint = cx.decompose(mesh, disjoint=True, max_parts=5)
    assert cx.verify_parts(mesh, disjoint, claims=["parts-disjoint"]).ok


def test_conform_finds_what_a_function_loses() -> Any:
    assert cx.conform(lambda points: points).ok

    def loses_one(points: Any) -> Any:
        return points[1:]

    found = cx.conform(loses_one, only=["random-sphere", "cube"])
    assert len(found.failures) == 2 and isinstance(found.failures[0].verdict, cx.Verdict)
    raising = cx.conform(lambda points: 1 / 0, only=["cube"])
    assert isinstance(raising.failures[0].error, ZeroDivisionError)


def test_shrink_leads_to_few_points() -> Any:
    points = cx.generate("random-ball", seed=1)

    def fails(some: Any) -> Any:
        return len(some) > 4 and float(some[:, 0].max()) > 1

    small = cx.shrink(points * 8, fails)
    assert len(small) == 5 and fails(small)
    with pytest.raises(cx.InvalidArgument, match="does not fail"):
        cx.shrink(points, lambda some: False)


WRONG = [
    (lambda: cx.hull([[0, 0], [1, 1]]), cx.InvalidArgument, r"shape \(n, 3\)"),
    (lambda: cx.hull([0, 1, 2]), cx.InvalidArgument, "shape"),
    (lambda: cx.hull([[0, 0, 0], [1, 1]]), cx.InvalidArgument, "several lengths"),
    (lambda: cx.hull(np.zeros((2, 2, 3))), cx.InvalidArgument, "shape"),
    (lambda: cx.hull(np.array([["a", "b", "c"]])), cx.InvalidArgument, "numbers"),
    (lambda: cx.hull(np.array([[1j, 0, 0]])), cx.InvalidArgument, "numbers"),
    (lambda: cx.hull(np.array([[True, False, True]])), cx.InvalidArgument, "numbers"),
    (lambda: cx.hull(np.array([[None, 0, 0]], dtype=object)), cx.InvalidArgument, "NoneType"),
    (lambda: cx.hull(np.array([[0, 0, 0], [0, np.nan, 0]])), cx.MalformedInput, "row 1"),
    (lambda: cx.hull(np.array([[np.inf, 0, 0]])), cx.MalformedInput, "row 0"),
    (lambda: cx.hull(np.array([[Decimal("nan"), 0, 0]], dtype=object)), cx.MalformedInput, "finite"),
    (lambda: cx.hull(), cx.InvalidArgument, "points, or planes="),
    (lambda: cx.hull(CUBE, planes=[[1, 0, 0, 0]]), cx.InvalidArgument, "not both"),
    (lambda: cx.hull(CUBE, measures=["weight"]), cx.InvalidArgument, "weight"),
    (lambda: cx.hull(CUBE, digits=0), cx.InvalidArgument, "digits"),
    (lambda: cx.hull([[0, 0, 0]] * 4), cx.NotSolid, "point"),
    (lambda: cx.hull(CUBE[:4]), cx.NotSolid, "plane"),
    (lambda: cx.hull("missing.obj"), cx.Unreadable, "No such file"),
    (lambda: cx.hull(DATA), cx.Unreadable, "directory"),
    (lambda: cx.simplify(CUBE, faces=3), cx.InvalidArgument, "from 4"),
    (lambda: cx.simplify(CUBE), cx.InvalidArgument, "faces"),
    (lambda: cx.simplify(CUBE, faces="many"), cx.InvalidArgument, "whole number"),  # type: ignore[arg-type]
    (lambda: cx.simplify(CUBE, faces=6, engine="fast"), cx.InvalidArgument, "fast"),
    (lambda: cx.simplify(CUBE, faces=6, cost="weight"), cx.InvalidArgument, "weight"),
    (lambda: cx.simplify(CUBE, faces=6, precision=16), cx.InvalidArgument, "32 or 64"),
    (lambda: cx.verify(CUBE, CUBE, asks="beauty"), cx.InvalidArgument, "beauty"),
    (lambda: cx.verify(CUBE, CUBE, tolerance=-1), cx.InvalidArgument, "tolerance"),
    (lambda: cx.verify(CUBE, CUBE, claims=["nice"]), cx.InvalidArgument, "nice"),
    (lambda: cx.verify(CUBE, (CUBE, [[0, 1, 8]])), cx.InvalidArgument, "indices of 8 points, found 8"),
    (lambda: cx.verify(CUBE, (CUBE, [[0, 1]])), cx.InvalidArgument, "three or more"),
    (lambda: cx.decompose((CUBE, [[0, 1, -1]])), cx.InvalidArgument, "from 0"),
    (lambda: cx.decompose((CUBE, QUADS), speed="high"), cx.InvalidArgument, "no option speed"),
    (lambda: cx.decompose(CUBE), cx.ConvexactError, "face"),
    (lambda: cx.decompose((CUBE, QUADS), distance="far"), cx.InvalidArgument, "distance"),
    (lambda: cx.decompose((CUBE, QUADS), measures="some"), cx.InvalidArgument, "some"),
    (lambda: cx.conform(lambda points: None, only=["cube"]), cx.InvalidArgument, "candidate: expected an array"),
    (lambda: cx.conform(lambda points: "a hull", only=["cube"]), cx.Unreadable, "a hull"),
    (lambda: cx.generate("sphinx"), cx.InvalidArgument, "sphinx"),
    (lambda: cx.hull(CUBE, progress=3), cx.InvalidArgument, "callable"),
]


@pytest.mark.parametrize("number", range(len(WRONG)))
def test_wrong_calls_get_a_sentence(number: Any) -> None:
    call, kind, words = WRONG[number]
    with pytest.raises(kind, match=words) as raised:
        call()
    assert "\n" not in str(raised.value)
    assert isinstance(raised.value, cx.ConvexactError)


def test_progress_is_called_and_may_end_the_run() -> None:
    seen = []
    points = cx.generate("random-sphere", seed=1)
    points = np.concatenate([points * scale for scale in np.linspace(1, 1.001, 40)])
    cx.simplify(points, faces=4, progress=lambda stage, done, total: seen.append((stage, done <= total)))
    assert seen and all(ok for _, ok in seen)

    def stop(stage: Any, done: Any, total: Any) -> None:
        raise LookupError("enough")

    with pytest.raises(LookupError, match="enough"):
        cx.simplify(points, faces=4, progress=stop)


def test_two_threads_and_a_fork_give_the_same() -> None:
    points = cx.generate("random-ball", seed=5)
    expected = cx.simplify(points, faces=8).exact_planes
    found = []
    threads = [threading.Thread(target=lambda: found.append(cx.simplify(points, faces=8).exact_planes)) for _ in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == [expected, expected]
    child = os.fork()
    if child == 0:
        os._exit(0 if cx.simplify(points, faces=8).exact_planes == expected else 1)
    assert os.waitpid(child, 0)[1] == 0


def test_ctrl_c_ends_a_run() -> None:
    script = (
        "import convexact as cx, numpy as np, signal\n"
        "signal.signal(signal.SIGINT, signal.default_int_handler)\n"  # a shell's background job ignores it
        "points = np.random.default_rng(1).normal(size=(20000, 3)); points /= np.linalg.norm(points, axis=1)[:, None]\n"
        "print('begun', flush=True)\n"
        "try:\n    cx.simplify(points, faces=4, engine='exact')\n"
        "except KeyboardInterrupt:\n    print('ended', flush=True)\n"
    )
    run = subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True)
    assert run.stdout is not None and run.stdout.readline() == "begun\n"
    time.sleep(0.5)
    run.send_signal(signal.SIGINT)
    assert run.communicate(timeout=600)[0] == "ended\n"


def test_kinds_of_strategies_are_known() -> None:
    for kind in KINDS:
        found = find(point_sets(kind), lambda points: points.shape[1] == 3)  # and shrinks to the least one
        assert len(found) >= 4 and len(np.unique(found, axis=0)) <= 4
    with pytest.raises(ValueError, match="expected one of"):
        point_sets("odd")
