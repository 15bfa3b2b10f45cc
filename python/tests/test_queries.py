# SPDX-License-Identifier: MIT
"""Overlaps, rays, trees, implicit shapes, facets that stay, and scenes. Expected values: intervals of boxes in Fractions, and
closed forms."""
import json
import math
import pickle
import random
from fractions import Fraction
from itertools import product
from typing import Any

import numpy as np
import pytest

import convexact as cx

CUBE = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]
QUADS = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]


def corners(low: Any, high: Any) -> Any:
    return [list(p) for p in product(*zip(low, high))]


def some_box(draw: Any) -> Any:
    low = [draw.randrange(-4, 4) for _ in range(3)]
    return low, [x + draw.randrange(1, 4) for x in low]


def dot(plane: Any, point: Any) -> Any:
    return sum(Fraction(n) * x for n, x in zip(plane, point)) + plane[3]


def test_boxes_overlap_where_their_intervals_do() -> None:
    draw, seen = random.Random(4), set()
    for _ in range(200):
        a, b = some_box(draw), some_box(draw)
        expected = all(a[0][k] <= b[1][k] and b[0][k] <= a[1][k] for k in range(3))
        found = cx.overlap(corners(*a), corners(*b))
        seen.add(bool(found))
        assert bool(found) == expected
        if found.point is not None:
            assert all(max(a[0][k], b[0][k]) <= found.point[k] <= min(a[1][k], b[1][k]) for k in range(3))
        else:
            assert found.plane is not None
            assert all(dot(found.plane, p) < 0 for p in corners(*a)) and all(dot(found.plane, p) > 0 for p in corners(*b))
    assert seen == {True, False}


def slabs(box: Any, origin: Any, direction: Any) -> Any:
    """Entry and exit of a line in a box, by intervals of its parameter."""
    low, high = box
    entry: Any = -math.inf
    leave: Any = math.inf
    for k in range(3):
        if direction[k] == 0:
            if not low[k] <= origin[k] <= high[k]:
                return None
            continue
        ends = sorted(Fraction(x - origin[k], direction[k]) for x in (low[k], high[k]))
        entry, leave = max(entry, ends[0]), min(leave, ends[1])
    return None if entry > leave else (entry, leave)


def some_ray(draw: Any) -> Any:
    while True:
        direction = [draw.randrange(-2, 3) for _ in range(3)]
        if any(direction):
            return [draw.randrange(-5, 6) for _ in range(3)], direction


def test_rays_meet_boxes_where_slabs_say() -> None:
    draw, hits = random.Random(5), 0
    for _ in range(600):
        box, (origin, direction) = some_box(draw), some_ray(draw)
        line = slabs(box, origin, direction)
        found = cx.ray(corners(*box), origin, direction)
        is_hit = line is not None and line[1] >= 0
        assert bool(found) == is_hit
        if is_hit:
            hits += 1
            assert (found.entry, found.exit) == line and found.first == max(0, line[0])
        else:
            assert 1 <= len(found.missed) <= 2
    assert 20 < hits < 580


def test_trees_answer_as_their_parts_do(tmp_path: Any) -> None:
    draw = random.Random(6)
    boxes = [some_box(draw) for _ in range(12)]
    tree = cx.bvh([corners(*box) for box in boxes])
    assert sorted(part for part in tree.parts if part is not None) == list(range(12))
    assert [len(children) for children in tree.children] == [0 if part is not None else 2 for part in tree.parts]
    path = tmp_path / "tree.json"
    path.write_text(tree.text)
    for each in (tree, pickle.loads(pickle.dumps(tree)), cx.read_tree(path)):
        for _ in range(60):
            origin, direction = some_ray(draw)
            lines = {k: slabs(box, origin, direction) for k, box in enumerate(boxes)}
            firsts = {k: max(0, line[0]) for k, line in lines.items() if line and line[1] >= 0}
            found = each.ray(origin, direction)
            assert found.first == min(firsts.values(), default=None)
            assert found.parts == [k for k, t in firsts.items() if t == found.first]
            low, high = some_box(draw)
            assert each.overlap(corners(low, high)) == [
                k for k, box in enumerate(boxes) if all(box[0][i] <= high[i] and low[i] <= box[1][i] for i in range(3))
            ]


def test_a_tree_whose_hull_misses_a_child_is_refused() -> None:
    document = json.loads(cx.bvh([corners((0, 0, 0), (1, 1, 1)), corners((3, 0, 0), (4, 1, 1))]).text)
    root = next(node for node in document["hull_tree"] if "vertices" in node)
    root["vertices"] = [[min(x, 3.5), y, z] for x, y, z in root["vertices"]]
    with pytest.raises(cx.MalformedInput, match="outside"):
        cx.read_tree(json.dumps(document))
    with pytest.raises(cx.MalformedInput, match="hull_tree"):
        cx.read_tree(json.dumps({"parts": document["parts"]}))


def test_a_decomposition_has_its_own_tree() -> None:
    lower, upper = corners((0, 0, 0), (3, 1, 1)), corners((0, 0, 1), (1, 1, 2))
    points = np.array(lower + upper)
    faces = QUADS + [[8 + k for k in face] for face in QUADS]
    parts = cx.decompose((points, faces), method="hacd", concavity=0)
    tree = cx.bvh(parts)
    assert len(tree.parts) == 2 * len(parts) - 1
    hit = tree.ray((Fraction(1, 2), Fraction(1, 3), 9), (0, 0, -1))
    assert hit.first == 7 and hit


def test_points_around_a_sphere_hold_it() -> None:
    found = cx.implicit({"sphere": {"center": [0, 0, 0], "radius": 1}}, (-2, -2, -2, 4), 5)
    lengths = np.linalg.norm(found.points, axis=1)
    assert found.distance and lengths.max() <= 1 + found.distance and found.kept[-1] > 100
    # Held: in no direction is the hull's support below 1.
    directions = np.random.default_rng(1).normal(size=(200, 3))
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    assert (directions @ found.points.T).max(axis=1).min() >= 1
    assert len(cx.simplify(found, faces=12).exact_planes) == 12
    with pytest.raises(cx.NotSolid, match="box"):
        cx.implicit({"sphere": {"center": [0, 0, 0], "radius": 3}}, (-2, -2, -2, 4), 3)


def test_facets_that_are_kept_stay() -> None:
    points = cx.generate("random-ball")
    # A small foot, which few halfspaces do without.
    body = np.vstack([points, np.array(corners((-0.0625, -0.0625, -1.25), (0.0625, 0.0625, 0)))])
    floor = (0, 0, -4, -5)
    assert floor not in cx.simplify(body, faces=6).exact_planes
    for keep in ({"normals": [[0, 0, -1]]}, {"planes": [[0, 0, -8, -10]]}, {"normals": [[0, 0, -1]], "degrees": 1}):
        made = cx.simplify(body, faces=6, keep=keep)
        assert floor in made.exact_planes
        (facet, place), = made.kept
        assert made.exact_planes[place] == floor
        assert floor in cx.simplify(body, faces=6, keep={"ids": [facet]}).exact_planes
    # The fifth of the cube's faces is z = 0.
    roof = (np.array([*CUBE, [0.5, 0.5, 1.5], [0.4, 0.5, 1.45]]), QUADS)
    assert (0, 0, -1, 0) in cx.simplify(roof, faces=6, keep={"faces": [4]}).exact_planes


@pytest.mark.parametrize("keep, sentence", [
    ({"normal": [[0, 0, 1]]}, "expected a dict of ids"), ([3], "expected a dict of ids"), ({"degrees": 3}, "need normals"),
    ({"faces": [6]}, "numbers of the 6 faces"), ({"normals": [[0, 0, 0]]}, "no direction"), ({"ids": [99]}, "99"),
    ({"ids": [-1]}, "at least 0"), ({"ids": [1.5]}, "whole number"), ({"faces": [0.5]}, "whole number"),
    ({"normals": [[0, 0, 1]], "degrees": "few"}, "expected a number"), ({"planes": [[1, 1, 1, 1]]}, "keep"), ({"normals": [[0, 0]]}, "shape"),
])
def test_wrong_selectors_get_a_sentence(keep: Any, sentence: Any) -> None:
    with pytest.raises(cx.InvalidArgument, match=sentence):
        cx.simplify((CUBE, QUADS), faces=6, keep=keep)


SPHERE = {"sphere": {"center": [0, 0, 0], "radius": 1}}
WRONG: list[Any] = [
    (lambda: cx.implicit(SPHERE, (0, 0, 0), 3), cx.InvalidArgument, "box: expected an array"),
    (lambda: cx.implicit(SPHERE, None, 3), cx.InvalidArgument, "box"),
    (lambda: cx.implicit(SPHERE, (-2, -2, -2, 4), -1), cx.InvalidArgument, "depth: expected a whole number"),
    (lambda: cx.implicit("missing.json", (-2, -2, -2, 4), 3), cx.Unreadable, "missing.json: No such file"),
    (lambda: cx.implicit(3, (-2, -2, -2, 4), 3), cx.InvalidArgument, "shape: expected a path"),
    (lambda: cx.read_tree("missing.json"), cx.Unreadable, "No such file"),
    (lambda: cx.bvh([CUBE], faces=-4), cx.InvalidArgument, "faces: expected a whole number"),
    (lambda: cx.bvh([]), cx.InvalidArgument, "part"),
    (lambda: cx.simplify_scene([CUBE], faces=2.5), cx.InvalidArgument, "faces: expected a whole number"),  # type: ignore[arg-type]
    (lambda: cx.false_positives(CUBE, CUBE, samples=-1), cx.InvalidArgument, "samples"),
    (lambda: cx.ray(CUBE, (0, 0), (1, 0, 0)), cx.InvalidArgument, "origin"),
    (lambda: cx.ray(CUBE, (0, 0, 0), (0, 0, 0)), cx.InvalidArgument, "direction"),
    (lambda: cx.overlap(CUBE, CUBE[:4]), cx.NotSolid, "plane"),
]


@pytest.mark.parametrize("number", range(len(WRONG)))
def test_wrong_questions_get_a_sentence(number: Any) -> None:
    call, kind, words = WRONG[number]
    with pytest.raises(kind, match=words) as raised:
        call()
    assert "\n" not in str(raised.value)


def test_scenes_share_one_number_of_halfspaces() -> None:
    first, second = cx.generate("random-ball", 1), cx.generate("random-ball", 2) * 8
    scene = cx.simplify_scene([first, second], faces=24)
    counts = [len(each.exact_planes) for each in scene]
    # The larger one has the costly removals: it keeps more.
    assert sum(counts) == 24 and counts[1] > counts[0] >= 4
    for points, each in zip((first, second), scene):
        assert cx.verify(points, each).ok
        # Removals of objects are those of their own runs.
        alone = cx.simplify(points, faces=len(each.exact_planes))
        assert alone.exact_planes == each.exact_planes
    again = pickle.loads(pickle.dumps(scene))
    assert [each.exact_planes for each in again] == [each.exact_planes for each in scene] and repr(again) == repr(scene)
    with pytest.raises(cx.NotSolid, match=r"objects\[1\]"):
        cx.simplify_scene([first, CUBE[:4]], faces=24)
    with pytest.raises(cx.InvalidArgument):
        cx.simplify_scene([first, second], faces=7)


def test_mass_of_a_box_is_a_closed_form() -> None:
    sides = (Fraction(2), Fraction(3), Fraction(1, 3))
    mass = cx.hull(np.array(corners((0, 0, 0), sides), dtype=object), measures=["volume", "inertia"]).mass
    assert mass.center == tuple(side / 2 for side in sides)
    total = sides[0] * sides[1] * sides[2]
    for k, row in enumerate(mass.inertia):
        i, j = (sides[m] for m in range(3) if m != k)
        assert row == [total * (i * i + j * j) / 12 if m == k else 0 for m in range(3)]
    with pytest.raises(cx.InvalidArgument, match="inertia"):
        _ = cx.hull(CUBE).mass


def test_volumes_of_parts_are_closed_forms() -> None:
    # An L of two boxes, in one part: its hull has half a unit more than its 3 - and only the document of "all" says so.
    shape = np.array(corners((0, 0, 0), (2, 1, 1)) + corners((0, 0, 1), (1, 1, 2)))
    faces = QUADS + [[8 + k for k in face] for face in QUADS]
    one = cx.decompose((shape, faces), concavity="100%", method="hacd", max_parts=1, measures="all")
    assert len(one) == 1
    for (low, high), exact in ((one.solid_volume, 3), (one.excess, 0.5), (one.uncovered, 0)):
        assert low <= exact <= high and high - low < 1e-9
    with pytest.raises(cx.InvalidArgument, match="measures='all'"):
        _ = cx.decompose((shape, faces)).excess
    for part in one:
        assert (np.array(part.vertices) @ part.planes[:, :3].T + part.planes[:, 3]).max() <= 0
    assert "<iframe" in one._repr_html_() and "<iframe" in cx.hull(CUBE)._repr_html_()


def test_false_positives_of_a_double_cube() -> None:
    found = cx.false_positives(CUBE, [[2 * x for x in p] for p in CUBE], samples=400)
    tally = found["points"] if "points" in found else found["false_positives"]["points"]
    # Of the points in the larger cube 7 of 8 miss the smaller one: 6 standard deviations of 400 draws of which few hit.
    hits = tally["hits_b"]
    assert hits > 20 and abs(tally["only_b"] / hits - 7 / 8) < 6 * math.sqrt(7 / 64 / hits)
