# SPDX-License-Identifier: MIT
"""Questions about solids, answered exactly; trees of hulls over parts; points of implicit shapes.

Solids are closed sets: touching counts.
"""
from __future__ import annotations

import json
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any, Mapping

import numpy as np
import numpy.typing as npt

from . import _core, _inputs
from ._results import Decomposition

Point = "tuple[Fraction, ...]"


def _solid(shape: Any, name: str) -> Any:
    planes = _inputs.halfspaces(shape, name)
    return _core.solid(None, planes) if planes is not None else _core.solid(_inputs.mesh(shape, name)[0], None)


def _point(values: Any, name: str) -> Any:
    return _inputs.rows([values], 3, name)


def _fraction(text: str | None) -> Fraction | None:
    return None if text is None else Fraction(text)


@dataclass(frozen=True)
class Overlap:
    """Whether two solids have a common point: true in a condition if they do."""

    point: tuple[Fraction, ...] | None  # of both
    plane: tuple[int, ...] | None  # n1, n2, n3, d: the first solid has n.x + d < 0, the second n.x + d > 0

    def __bool__(self) -> bool:
        return self.point is not None


@dataclass(frozen=True)
class RayHit:
    """Where the ray origin + t direction, t >= 0, meets a solid: true in a condition if it does."""

    first: Fraction | None  # the least t >= 0 in the solid
    entry: Fraction | None  # of the whole line: negative if the ray begins inside
    exit: Fraction | None
    entry_facets: list[int]
    exit_facets: list[int]
    missed: list[int]  # of a miss: facets that no point of the ray satisfies together

    def __bool__(self) -> bool:
        return self.first is not None


@dataclass(frozen=True)
class TreeHit:
    """Where a ray first meets the parts of a tree."""

    first: Fraction | None
    parts: list[int]  # that it meets there
    visited: int  # hulls that were looked at

    def __bool__(self) -> bool:
        return self.first is not None


def overlap(a: Any, b: Any) -> Overlap:
    """Have two convex solids a common point? With the point, or a plane between them.

    Parameters
    ----------
    a, b : points whose hull is meant, array (m, 4) of halfspaces, Hull, Simplified, or a Part

    >>> import convexact as cx
    >>> cube = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    >>> bool(cx.overlap(cube, [[x + 1, y, z] for x, y, z in cube]))
    True
    >>> cx.overlap(cube, [[x + 3, y, z] for x, y, z in cube]).plane
    (1, 0, 0, -2)
    """
    point, plane = _solid(a, "a").overlap(_solid(b, "b"))
    return Overlap(
        None if point is None else tuple(Fraction(x) for x in point), None if plane is None else tuple(int(x) for x in plane)
    )


def ray(solid: Any, origin: Any, direction: Any) -> RayHit:
    """Where a ray meets a convex solid. Touching a corner, an edge or a facet is a hit.

    Parameters
    ----------
    solid : as overlap()
    origin, direction : three numbers each; parameters of points are in units of the direction's length
    """
    first, entry, leave, entered, left, missed = _solid(solid, "solid").ray(_point(origin, "origin"), _point(direction, "direction"))
    return RayHit(_fraction(first), _fraction(entry), _fraction(leave), entered, left, missed)


def false_positives(a: Any, b: Any, samples: int = 1000, *, seed: int = 1, progress: Any = None) -> dict[str, Any]:
    """How many random lines, planes and points hit solid b and not solid a, each decided exactly.

    Parameters
    ----------
    a, b : as overlap(); b is an enclosure of a
    samples : of each kind
    """
    document: dict[str, Any] = json.loads(
        _core.false_positives(_solid(a, "a"), _solid(b, "b"), _inputs.count(samples, "samples"), _inputs.count(seed, "seed"),
                              _inputs.progress(progress))
    )
    return document


class Tree:
    """Convex parts under a binary tree of hulls, each of which holds its children as they are stored: proven."""

    def __init__(self, found: Any) -> None:
        self._found = found

    @cached_property
    def text(self) -> str:
        """The file that `convexact bvh` writes; see read_tree()."""
        return str(self._found.json())

    @cached_property
    def document(self) -> dict[str, Any]:
        document: dict[str, Any] = json.loads(self.text)
        return document

    @cached_property
    def children(self) -> list[list[int]]:
        """By node, the root first: its two children, or none."""
        return list(self._found.children())

    @cached_property
    def parts(self) -> list[int | None]:
        """By node: the part that a leaf is."""
        return list(self._found.parts())

    def ray(self, origin: Any, direction: Any) -> TreeHit:
        """Where a ray first meets the union of the parts, exactly."""
        first, parts, visited = self._found.ray(_point(origin, "origin"), _point(direction, "direction"))
        return TreeHit(_fraction(first), parts, visited)

    def overlap(self, solid: Any) -> list[int]:
        """The parts that have a common point with a solid."""
        parts: list[int] = self._found.overlap(_solid(solid, "solid"))[0]
        return parts

    def __reduce__(self) -> Any:
        return read_tree, (self.text,)

    def __repr__(self) -> str:
        leaves = sum(part is not None for part in self.parts)
        return f"<convexact.Tree: {leaves} parts under {len(self.parts) - leaves} hulls>"


def bvh(parts: Any, *, faces: int | None = None, progress: Any = None) -> Tree:
    """A tree of hulls over convex parts.

    Parameters
    ----------
    parts : a Decomposition, whose own splits or merges are followed, or a list of parts as in verify_parts(), which are
        joined where the common hull has the least volume
    faces : how many halfspaces to keep of each branch, at least 4

    >>> import convexact as cx
    >>> corner = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    >>> tree = cx.bvh([corner, [[x + 4, y, z] for x, y, z in corner]])
    >>> tree
    <convexact.Tree: 2 parts under 1 hulls>
    >>> tree.ray((9, 0, 0), (-1, 0, 0))
    TreeHit(first=Fraction(4, 1), parts=[1], visited=3)
    """
    bar = _inputs.progress(progress)
    faces = None if faces is None else _inputs.count(faces, "faces")
    found = getattr(parts, "_found", None) if isinstance(parts, Decomposition) else None
    if found is not None:
        return Tree(_core.tree_of(found, faces, bar))
    return Tree(_core.tree_of_parts([_inputs.mesh(part, f"parts[{k}]") for k, part in enumerate(parts)], faces, bar))


def read_tree(source: Any) -> Tree:
    """A tree from its file, or from the text of one; refused if a hull does not hold its children."""
    if isinstance(source, str) and source.lstrip().startswith("{"):
        return Tree(_core.read_tree(source))
    return Tree(_core.read_tree(_inputs.read(source, "source")))


@dataclass(frozen=True)
class ImplicitPoints:
    """Corners of the cells that may hold the surface of an implicit shape. Their hull holds the shape: proven."""

    points: npt.NDArray[np.float64]
    distance: float | None  # each point is within this distance of the shape, where that is known
    kept: list[int]  # cells, level by level


def implicit(shape: Any, box: Any, depth: int, *, progress: Any = None) -> ImplicitPoints:
    """Points around an implicit shape, for hull(), simplify() or verify().

    Parameters
    ----------
    shape : a dict as in docs/formats.md, such as {"sphere": {"center": [0, 0, 0], "radius": 1}}, or the path of such a file
    box : x0, y0, z0 and the edge of a cube that holds the shape
    depth : how often the cube is halved
    """
    text = json.dumps(shape) if isinstance(shape, Mapping) else _inputs.read(shape, "shape")
    corners = _inputs.rows([box], 4, "box")
    if isinstance(corners, list):
        raise _core.InvalidArgument("box: expected doubles")
    found = _core.implicit(text, corners[0].tolist(), _inputs.count(depth, "depth"), _inputs.progress(progress))
    return ImplicitPoints(*found)
