# SPDX-License-Identifier: MIT
"""Encloses 3D shapes in few halfspaces, or few convex parts, and proves that it does.

Every verdict is exact. Points go in as arrays (n, 3), as a path, as (vertices, faces), or as an object of trimesh, Open3D,
scipy, coal or manifold3d; int, Fraction and Decimal are taken exactly. The exact numbers come out beside doubles.

>>> import convexact as cx
>>> cube = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]
>>> cx.hull(cube).volume
Fraction(1, 1)
>>> cx.verify(cube, cube[:7], asks="hull").ok
False
"""
from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Callable, Mapping, Sequence

import numpy as np

from . import _core, _inputs
from ._core import ConvexactError, Interrupted, InvalidArgument, MalformedInput, NotSolid, Unreadable, Unrepresentable
from ._queries import ImplicitPoints, Overlap, RayHit, Tree, TreeHit, bvh, false_positives, implicit, overlap, ray, read_tree
from ._results import Claim, Decomposition, Hull, Inner, Mass, Part, Scene, Simplified, Verdict, Violated, Witness

__all__ = [
    "Claim", "Conformance", "ConvexactError", "Decomposition", "Failure", "Hull", "ImplicitPoints", "Inner", "Interrupted",
    "InvalidArgument", "MalformedInput", "Mass", "NotSolid", "Overlap", "Part", "RayHit", "Scene", "Simplified", "Tree", "TreeHit",
    "Unreadable", "Unrepresentable", "Verdict", "Violated", "Witness", "bvh", "conform", "decompose", "false_positives", "families", "generate",
    "hull", "implicit", "inner", "overlap", "ray", "read_mesh", "read_tree", "shrink", "simplify", "simplify_scene", "verify",
    "verify_parts",
]


def _shape_with_faces(points: Any, planes: Any) -> tuple[Any, Any, list[list[int]]]:
    if (points is None) == (planes is None):
        raise InvalidArgument("expected points, or planes=, and not both")
    if planes is not None:
        return None, _inputs.rows(planes, 4, "planes"), []
    rows, polygons = _inputs.mesh(points, "points")
    return rows, None, polygons


def _shape(points: Any, planes: Any) -> tuple[Any, Any]:
    return _shape_with_faces(points, planes)[:2]


def hull(
    points: Any = None, *, planes: Any = None, measures: Sequence[str] = ("volume", "area", "mean_width"), digits: int = 10,
    progress: Any = None, jobs: int | None = None,
) -> Hull:
    """The exact convex hull of points, or the solid that halfspaces bound.

    Parameters
    ----------
    points : array (n, 3), path, (vertices, faces), or object with vertices
    planes : array (m, 4), optional
        Halfspaces n1 x + n2 y + n3 z + d <= 0, instead of points.
    measures : names out of volume, area, mean_width and inertia (for `mass`)
    digits : certain digits of area and mean width
    jobs : how many threads, by default as many as there are cores; nothing depends on it
    progress : True, or a callable of stage, done and total

    Raises
    ------
    NotSolid
        If the input encloses no volume; the message has the proof.

    >>> import convexact as cx
    >>> cx.hull([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]).volume
    Fraction(1, 6)
    """
    unknown = set(measures) - {"volume", "area", "mean_width", "inertia"}
    if unknown:
        raise InvalidArgument(f"measures: expected volume, area, mean_width and inertia, found {sorted(unknown)}")
    rows, halfspaces = _shape(points, planes)
    threads = None if jobs is None else _inputs.count(jobs, "jobs")
    return Hull(_core.hull(rows, halfspaces, list(measures), digits, threads, _inputs.progress(progress)))


def simplify(
    points: Any = None, faces: int | None = None, *, planes: Any = None, max_growth: Any = None, cost: str | None = None,
    engine: str | None = None, search: str | None = None, verify: str | None = None, seed: int | None = None,  # pylint: disable=redefined-outer-name
    growth_of: str | None = None, keep: Mapping[str, Any] | None = None, precision: int | None = None, trace: bool = False,
    record: bool = False, progress: Any = None, moves: int | None = None, nodes: int | None = None, jobs: int | None = None,
) -> Simplified:
    """Few halfspaces that hold every point: the facets of the hull, less the ones whose removal adds least.

    Parameters
    ----------
    points : as hull()
    faces : how many halfspaces to keep, at least 4
    max_growth : a share, such as 0.05, that the measure may grow by; instead of `faces`, or besides
    cost : 'volume', 'area' or 'mean-width', which is kept small
    growth_of : the measure that max_growth limits, if it is another one
    keep : facets that stay, a dict of `ids`, `planes` (m, 4), `normals` (k, 3) with `degrees` (or the nearest facets), and
        `faces`, numbers of faces of a mesh; such as {"normals": [[0, 0, -1]]} for the side that a body stands on
    engine : 'exact', 'filtered' (the default) or 'float'
    search : 'walk' or 'local', which improve the result, or 'optimal', which proves the least volume, or how far it may be
    moves, nodes : how many random exchanges 'local' tries (20), and how many states 'optimal' examines at most
    precision : 64 or 32, in which `mesh` is stored; for float32 input 32
    trace, record : keep what trace() and proof() need
    jobs : how many threads, by default as many as there are cores; nothing depends on it

    Raises
    ------
    NotSolid, InvalidArgument, Unrepresentable

    >>> import convexact as cx
    >>> small = cx.simplify(cx.generate("random-ball"), faces=12)
    >>> len(small.exact_planes)
    12
    """
    if precision is None and getattr(points, "dtype", None) == np.float32:
        precision = 32
    if precision not in (None, 32, 64):
        raise InvalidArgument(f"precision: expected 32 or 64, found {precision!r}")
    rows, halfspaces, polygons = _shape_with_faces(points, planes)
    given = {"faces": faces, "max_growth": max_growth, "growth_of": growth_of, "cost": cost, "engine": engine, "search": search,
             "moves": moves, "nodes": nodes, "verify": verify, "seed": seed, "precision": precision, "trace": trace or None,
             "record": record or None, "jobs": jobs}
    return Simplified(_core.simplify(rows, halfspaces, _inputs.options(given), _inputs.keep(keep, polygons),
                                     _inputs.progress(progress)))


def simplify_scene(
    objects: Sequence[Any], faces: int, *, keep: Sequence[Mapping[str, Any] | None] | None = None, max_growth: Any = None,
    cost: str | None = None, engine: str | None = None, progress: Any = None, jobs: int | None = None,
) -> Scene:
    """Encloses several objects, each in halfspaces of its own, with one number of halfspaces for all of them.

    Parameters
    ----------
    objects : each as the points of hull()
    faces : how many halfspaces to keep in all objects together, at least 4 for each
    keep : by object, as in simplify()
    max_growth : as in simplify(), of the sum over all objects
    jobs : as in simplify()

    >>> import convexact as cx
    >>> scene = cx.simplify_scene([cx.generate("random-ball", seed) for seed in (1, 2)], faces=20)
    >>> sum(len(each.exact_planes) for each in scene)
    20
    """
    given = _inputs.options({"max_growth": max_growth, "cost": cost, "engine": engine, "jobs": jobs})
    shapes = [_inputs.mesh(each, f"objects[{k}]") for k, each in enumerate(objects)]
    if keep is not None and len(keep) != len(shapes):
        raise InvalidArgument(f"keep: expected an entry for each of {len(shapes)} objects, found {len(keep)}")
    kept = [] if keep is None else [_inputs.keep(each, shapes[k][1]) for k, each in enumerate(keep)]
    return Scene(_core.simplify_scene([(rows, None) for rows, _ in shapes], _inputs.count(faces, "faces"), given, kept, _inputs.progress(progress)))


def inner(
    points: Any, vertices: int | None = None, *, max_loss: Any = None, engine: str | None = None,
    verify: str | None = None, progress: Any = None, jobs: int | None = None,  # pylint: disable=redefined-outer-name
) -> Inner:
    """A solid inside the hull: few of its vertices, removed one by one where the least volume is lost.

    Parameters
    ----------
    points : as hull()
    vertices : how many to keep, at least 4
    max_loss : the share of the volume that may be lost; instead of `vertices`, or besides
    jobs : as in simplify()
    """
    rows, _ = _inputs.mesh(points, "points")
    given = {"vertices": vertices, "max_loss": max_loss, "engine": engine, "verify": verify, "jobs": jobs}
    return Inner(_core.inner(rows, _inputs.options(given), _inputs.progress(progress)))


def verify(
    points: Any, candidate: Any, *, asks: str | None = None, tolerance: Any = None, claims: Sequence[str] | None = None,
    max_facets: int | None = None, max_vertices: int | None = None, progress: Any = None,
) -> Verdict:
    """Is a candidate a convex solid that holds every point? Decided exactly.

    Parameters
    ----------
    points : as hull(); float32 is taken as the numbers that it is
    candidate : array (m, 4) of halfspaces, array (n, 3) of points that stand for their hull, (vertices, faces), an object
        with these, a path, or a result of this package (by its exact planes)
    asks : 'enclosure' (the default), 'hull' or 'inner'
    tolerance : a length, or a share of the diameter such as '1e-9d'
    claims : names, if only these are to be decided

    Returns
    -------
    Verdict
        With `ok`, the claims by name, their sentences and witnesses. A fault of the candidate is a violated claim.

    Raises
    ------
    NotSolid
        If the points themselves lie in one plane.
    """
    rows, faces = _inputs.mesh(points, "points")
    given = _inputs.options({"asks": asks, "tolerance": tolerance, "max_facets": max_facets, "max_vertices": max_vertices})
    bar = _inputs.progress(progress)
    planes = _inputs.halfspaces(candidate, "candidate")
    if planes is not None:
        return Verdict(_core.verify_planes(rows, faces, planes, given, _inputs.names(claims), bar))
    vertices, corners = _inputs.mesh(candidate, "candidate")
    return Verdict(_core.verify_mesh(rows, faces, vertices, corners, given, _inputs.names(claims), bar))


def decompose(
    mesh: Any, distance: Any = None, *, concavity: Any = None, method: str | None = None, max_parts: int | None = None,
    faces: int | None = None, measures: str = "none", progress: Any = None, **options: Any,
) -> Decomposition:
    """Convex parts that hold a mesh.

    A solid is cut by planes: the parts hold it, and no point of them is farther from it than `distance`. Open surfaces, and
    calls that name a concavity, are taken apart by clustering triangles.

    Parameters
    ----------
    mesh : (vertices, faces), a path, or an object of trimesh or Open3D
    distance, concavity : a length, or a share of the diameter such as '3%'
    method : 'cut', 'hacd' or 'acd'
    max_parts, faces : budgets of the parts, and of the faces of each
    measures : 'none', 'uncovered' or 'all', for `document`
    options : any other option of `convexact decompose`, such as disjoint=True or effort='high'

    >>> import convexact as cx
    >>> cube = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    >>> quads = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    >>> cx.decompose((cube, quads))
    <convexact.Decomposition: 1 part by cut holds the solid>
    """
    if measures not in ("none", "uncovered", "all"):
        raise InvalidArgument(f"measures: expected none, uncovered or all, found {measures!r}")
    points, polygons = _inputs.mesh(mesh, "mesh")
    given = _inputs.options({"distance": distance, "concavity": concavity, "method": method, "max_parts": max_parts,
                             "faces": faces, **options})
    return Decomposition(_core.decompose(points, polygons, given, measures, _inputs.progress(progress)))


def verify_parts(
    mesh: Any, parts: Any, *, distance: Any = None, tolerance: Any = None, claims: Sequence[str] | None = None,
    max_parts: int | None = None, progress: Any = None, **options: Any,
) -> Verdict:
    """Do convex parts of any program hold a mesh? Decided exactly.

    Parameters
    ----------
    mesh : as decompose()
    parts : a Decomposition, or a list of (vertices, faces), of arrays of vertices, or of objects with these
    distance : how far a point of a part may be from the solid; asks for that as well
    """
    points, polygons = _inputs.mesh(mesh, "mesh")
    given = _inputs.options({"distance": distance, "tolerance": tolerance, "max_parts": max_parts, **options})
    listed = [_inputs.mesh(part, f"parts[{k}]") for k, part in enumerate(parts)]
    return Verdict(_core.verify_parts(points, polygons, listed, given, _inputs.names(claims), _inputs.progress(progress)))


def read_mesh(path: Any, *, exact: bool = False, triangles: bool = False) -> tuple[Any, Any]:
    """Points and faces of a file (OBJ, OFF, PLY, STL, glTF, COLLADA, point clouds).

    Faces are lists of corners; with triangles=True an int32 array (m, 3), as other packages want it, in which a face of more
    corners is a fan around its first one. With exact=True decimals are the fractions that they spell: an array of Fraction
    where these are no doubles.
    """
    points, polygons = _inputs.mesh(path, "path", exact)
    if isinstance(points, list):
        from fractions import Fraction  # pylint: disable=import-outside-toplevel

        points = np.array([[Fraction(x) for x in row] for row in points], dtype=object)
    if triangles:
        fans = [(face[0], face[k - 1], face[k]) for face in polygons for k in range(2, len(face))]
        return points, np.array(fans, dtype=np.int32).reshape(-1, 3)
    return points, polygons


def families() -> list[str]:
    """Names of the families of points that generate() makes."""
    return list(_core.families())


def generate(family: str, seed: int = 1) -> Any:
    """Points of a family of hard inputs, float64 (n, 3): the same for the same seed, on every machine."""
    return _core.generate(family, seed)


@dataclass(frozen=True)
class Failure:
    """An input on which a function fails."""

    family: str
    seed: int
    points: Any
    verdict: Verdict | None  # None if the function raised
    error: BaseException | None = None

    def __str__(self) -> str:
        said = repr(self.error) if self.verdict is None else repr(self.verdict)
        return f"generate({self.family!r}, seed={self.seed}), {len(self.points)} points: {said}"


@dataclass(frozen=True)
class Conformance:
    """How a function did over the families."""

    passed: int
    failures: list[Failure] = field(default_factory=list)

    @property
    def ok(self) -> bool:
        return not self.failures

    def __repr__(self) -> str:
        return f"<convexact.Conformance: {self.passed} passed, {len(self.failures)} failed>"


def conform(
    function: Callable[[Any], Any], *, asks: str = "hull", tolerance: Any = None, seeds: int = 1, only: Sequence[str] | None = None,
) -> Conformance:
    """Runs a function of points over families of hard inputs and judges what it returns, as verify() does.

    Parameters
    ----------
    function : takes an array (n, 3); returns a candidate of verify()
    asks, tolerance : as verify()
    seeds : how many inputs of each family
    only : names of families; without, all whose points span a volume
    """
    passed, failures = 0, []
    for family in only or families():
        for seed in range(1, seeds + 1):
            points = generate(family, seed)
            try:
                hull(points, measures=())
            except NotSolid:
                continue
            try:
                candidate = function(points)
            except Exception as error:  # pylint: disable=broad-exception-caught
                failures.append(Failure(family, seed, points, None, error))
                continue
            verdict = verify(points, candidate, asks=asks, tolerance=tolerance)
            if verdict.ok:
                passed += 1
            else:
                failures.append(Failure(family, seed, points, verdict))
    return Conformance(passed, failures)


def shrink(points: Any, fails: Callable[[Any], bool]) -> Any:
    """Fewer points, with shorter numbers, on which a predicate still holds: a minimal counterexample.

    Parameters
    ----------
    points : array (n, 3) of doubles
    fails : takes such an array; True if the program under test still fails on it
    """
    rows, _ = _inputs.mesh(points, "points")
    if isinstance(rows, list):
        raise InvalidArgument("points: expected doubles")
    if not fails(rows):
        raise InvalidArgument("fails: the program does not fail on the points themselves")
    return _core.shrink(rows, fails)
