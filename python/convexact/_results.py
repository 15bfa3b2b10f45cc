# SPDX-License-Identifier: MIT
"""What calls return. Arrays are float64; what is exact is a Fraction or an int; enclosures are pairs (low, high)."""
from __future__ import annotations

import html
import json
import math
from contextlib import suppress
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any, Callable, Iterator, Sequence

import numpy as np
import numpy.typing as npt

from . import _core

Array = npt.NDArray[np.float64]
Pair = "tuple[float, float]"


class Violated(AssertionError):
    """A claim does not hold; the message is its sentence."""


def _fractions(rows: Sequence[Sequence[str]]) -> list[tuple[Fraction, ...]]:
    return [tuple(Fraction(x) for x in row) for row in rows]


def _place(texts: Sequence[str] | None) -> tuple[Fraction, ...] | None:
    return None if texts is None else tuple(Fraction(x) for x in texts)


def _nearest(rows: Sequence[Sequence[Any]]) -> Array:
    return np.array([[float(x) for x in row] for row in rows], dtype=np.float64).reshape(-1, 3)


def _frame(picture: Callable[[], str], otherwise: str) -> str:
    """A page in a frame of a notebook."""
    try:
        page = picture()
    except _core.InvalidArgument:  # of a pickle
        return html.escape(otherwise)
    return f'<iframe srcdoc="{html.escape(page, quote=True)}" width="100%" height="480" style="border:0"></iframe>'


def _asked(found: Any, call: str) -> Any:
    if found is None:
        raise _core.InvalidArgument(f"was not asked for: {call}")
    return found


class _Unpickled:
    """In the place of what the library found: pickles hold the values that were asked for."""

    def __getattr__(self, name: str) -> Any:
        raise _core.InvalidArgument(f"{name} was not kept when this result was pickled")


class _Result:
    """Holds what the library found and converts it when it is first asked for. Pickles as plain values."""

    _fields: tuple[str, ...] = ()

    def __init__(self, found: Any) -> None:
        self._found = found

    def __getstate__(self) -> dict[str, Any]:
        state = {}
        for name in (*self._fields, "document"):
            with suppress(_core.InvalidArgument):  # was not asked for
                state[name] = getattr(self, name)
        return state

    def __setstate__(self, state: dict[str, Any]) -> None:
        self._found = _Unpickled()
        self.__dict__.update(state)

    @cached_property
    def document(self) -> dict[str, Any]:
        """What the program prints with --json."""
        document: dict[str, Any] = json.loads(self._found.json())
        return document


class _Solid(_Result):
    @cached_property
    def exact_vertices(self) -> list[tuple[Fraction, ...]]:
        """The corners of the solid that the exact planes bound."""
        return _fractions(self._found.vertices())

    @cached_property
    def vertices(self) -> Array:
        """(k, 3): the nearest doubles of the exact ones. Of an enclosure they may miss points: use planes."""
        return _nearest(self.exact_vertices)

    @cached_property
    def faces(self) -> list[list[int]]:
        """Corners of each facet, counter-clockwise from outside."""
        faces: list[list[int]] = self._found.faces()
        return faces

    @cached_property
    def exact_planes(self) -> list[tuple[int, ...]]:
        """(n1, n2, n3, d) of each halfspace n.x + d <= 0, as coprime integers."""
        return [tuple(int(x) for x in row) for row in self._found.exact_planes()]

    @cached_property
    def planes(self) -> Array:
        """(m, 4): the same in doubles, rounded outward and proven to hold every point."""
        planes: Array = self._found.planes()
        return planes

    def _repr_html_(self) -> str:
        return _frame(lambda: str(self._found.picture()), repr(self))

    def to_trimesh(self) -> Any:
        """A trimesh.Trimesh of fans over the facets."""
        import trimesh  # type: ignore[import-not-found, import-untyped, unused-ignore]  # pylint: disable=import-outside-toplevel

        triangles = [(face[0], face[k - 1], face[k]) for face in self.faces for k in range(2, len(face))]
        return trimesh.Trimesh(self.vertices, triangles, process=False)


@dataclass(frozen=True)
class Mass:
    """Of a solid of density 1, exactly."""

    center: tuple[Fraction, ...]
    inertia: list[list[Fraction]]  # (3, 3), about the center


class Hull(_Solid):
    """An exact convex hull."""

    _fields = ("exact_vertices", "vertices", "faces", "exact_planes", "planes", "volume", "area", "mean_width", "mass")

    @cached_property
    def mass(self) -> Mass:
        """Center of mass and tensor of inertia; of hull(..., measures=["inertia"])."""
        found = _asked(self._found.mass(), "hull(..., measures=['inertia'])")
        xx, yy, zz, xy, xz, yz = (Fraction(x) for x in found[1])
        return Mass(tuple(Fraction(x) for x in found[0]), [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])

    @cached_property
    def volume(self) -> Fraction:
        """Exactly, in cubed length units."""
        return Fraction(_asked(self._found.volume(), "hull(..., measures=['volume'])"))

    @cached_property
    def area(self) -> tuple[float, float]:
        """Doubles below and above the surface area."""
        pair: tuple[float, float] = _asked(self._found.area(), "hull(..., measures=['area'])")
        return pair

    @cached_property
    def mean_width(self) -> tuple[float, float]:
        """The same, of the mean width."""
        pair: tuple[float, float] = _asked(self._found.mean_width(), "hull(..., measures=['mean_width'])")
        return pair

    def __repr__(self) -> str:
        volume = ""
        with suppress(_core.InvalidArgument):
            volume = f", volume {float(self.volume):.6g}"
        return f"<convexact.Hull: {len(self.exact_vertices)} vertices, {len(self.exact_planes)} facets{volume}>"


class _Run(_Result):
    @cached_property
    def steps(self) -> int:
        """How many halfspaces were removed; of a scene from all objects, as all of these."""
        return int(self._found.steps())

    @cached_property
    def stop(self) -> str:
        """Why the run ended: 'reached' and so on."""
        return str(self._found.stop())

    @cached_property
    def volumes(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """Doubles below and above the volume of the input's hull, and that of the result."""
        pairs: tuple[tuple[float, float], tuple[float, float]] = self._found.volumes()
        return pairs

    @property
    def growth(self) -> float:
        """The volume of the result over that of the hull, less 1; to about 1e-15."""
        return self.volumes[1][1] / self.volumes[0][0] - 1


class Simplified(_Run, _Solid):
    """A solid of few halfspaces that holds every point."""

    _fields = ("exact_vertices", "vertices", "faces", "exact_planes", "planes", "mesh", "steps", "stop", "volumes", "kept")

    @cached_property
    def kept(self) -> list[tuple[int, int]]:
        """With keep=: facets of the hull that were kept, each with its place in `planes`."""
        return list(self._found.kept())

    @cached_property
    def mesh(self) -> tuple[Array, list[list[int]]]:
        """Vertices and faces in doubles or binary32, whose hull is proven to hold every point; of precision=64 or 32."""
        mesh: tuple[Array, list[list[int]]] = _asked(self._found.stored_mesh(), "simplify(..., precision=64)")
        return mesh

    def trace(self) -> str:
        """Every step as JSON; of simplify(..., trace=True)."""
        return str(self._found.trace())

    def proof(self) -> str:
        """A text for convexact-check; of simplify(..., record=True)."""
        return str(self._found.proof())

    def __repr__(self) -> str:
        return f"<convexact.Simplified: {len(self.exact_planes)} halfspaces after {self.steps} removals, volume +{self.growth:.3%}>"


class Scene(_Run, Sequence[Simplified]):
    """Several objects, each enclosed by itself, as a sequence."""

    _fields = ("objects", "steps", "stop", "volumes")

    @cached_property
    def objects(self) -> list[Simplified]:
        return [Simplified(found) for found in self._found.objects()]

    def __len__(self) -> int:
        return len(self.objects)

    def __getitem__(self, index: Any) -> Any:
        return self.objects[index]

    def __repr__(self) -> str:
        planes = sum(len(each.exact_planes) for each in self)
        return f"<convexact.Scene: {len(self)} objects in {planes} halfspaces>"


class Inner(_Result):
    """A solid inside the hull whose corners are points of the input."""

    _fields = ("kept", "vertices", "faces")

    @cached_property
    def kept(self) -> list[int]:
        """Which points of the input its corners are."""
        return list(self._found.kept())

    @cached_property
    def vertices(self) -> Array:
        vertices: Array = self._found.vertices()
        return vertices

    @cached_property
    def faces(self) -> list[list[int]]:
        faces: list[list[int]] = self._found.faces()
        return faces

    def __repr__(self) -> str:
        return f"<convexact.Inner: {len(self.kept)} vertices of the input>"


@dataclass(frozen=True)
class Witness:
    """Where a claim is violated, as far as that is a place."""

    place: tuple[Fraction, ...] | None  # of a point or corner
    nearest: tuple[Fraction, ...] | None  # of the candidate, to `place`
    plane: tuple[int, ...] | None  # n1, n2, n3, d, that `place` is beyond
    parts: list[int]  # of a decomposition


@dataclass(frozen=True)
class Claim:
    """One claim and what was found."""

    name: str
    status: str  # 'holds', 'violated', 'undecided' or 'not-applicable'
    sentence: str
    squared_distance: Fraction | None  # of the witness
    point: int | None  # of the input, that is the witness
    witness: Witness

    @property
    def holds(self) -> bool:
        return self.status == "holds"

    @property
    def distance(self) -> float | None:
        return None if self.squared_distance is None else math.sqrt(self.squared_distance)


class Verdict(_Result):
    """What the oracle decided, exactly."""

    _fields = ("ok", "claims")

    @cached_property
    def ok(self) -> bool:
        return bool(self._found.holds())

    @cached_property
    def claims(self) -> dict[str, Claim]:
        """By name, those that were asked."""
        claims = {}
        for name, status, sentence, squared, point, place, nearest, plane, parts in self._found.claims():
            witness = Witness(_place(place), _place(nearest), None if plane is None else tuple(int(x) for x in plane), parts)
            claims[name] = Claim(name, status, sentence, None if squared is None else Fraction(squared), point, witness)
        return claims

    @property
    def violated(self) -> list[Claim]:
        return [claim for claim in self.claims.values() if claim.status in ("violated", "undecided")]

    def raise_if_violated(self) -> None:
        """Raises Violated with the sentences of the claims that do not hold."""
        if not self.ok:
            raise Violated("; ".join(f"{claim.name}: {claim.sentence}" for claim in self.violated) or str(self))

    def __str__(self) -> str:
        lines = [f"{claim.name:<20}{claim.status:<16}{claim.sentence}" for claim in self.claims.values()]
        return "\n".join([*lines, "verdict             " + ("every claim holds" if self.ok else "violated")])

    def __repr__(self) -> str:
        if self.ok:
            return f"<convexact.Verdict: {len(self.claims)} claims hold>"
        return "<convexact.Verdict: violated: " + ", ".join(claim.name for claim in self.violated) + ">"


@dataclass(frozen=True, repr=False)
class Part:
    """A convex part of a decomposition: the hull of its vertices, exactly as the numbers are."""

    vertices: Array
    faces: list[list[int]]
    exact_planes: list[tuple[int, ...]]
    owns: list[int]  # triangles of the input

    @cached_property
    def planes(self) -> Array:
        """(m, 4) in doubles, rounded outward: proven to hold every vertex."""
        planes: Array = _core.hull(self.vertices, None, [], 1, None, None).planes()
        return planes

    def __repr__(self) -> str:
        return f"<convexact.Part: {len(self.vertices)} vertices, {len(self.faces)} faces>"


class Decomposition(_Result, Sequence[Part]):
    """Convex parts that hold a mesh, as a sequence."""

    _fields = ("parts", "limit_holds", "method", "covers", "summary", "_volumes")

    @cached_property
    def parts(self) -> list[Part]:
        return [
            Part(vertices, faces, [tuple(int(x) for x in row) for row in planes], owns)
            for vertices, faces, planes, owns in self._found.parts()
        ]

    @cached_property
    def limit_holds(self) -> bool:
        """Whether every part is within the distance, or the concavity, that was asked for."""
        return bool(self._found.limit_holds())

    @cached_property
    def method(self) -> str:
        return str(self._found.method())

    @cached_property
    def covers(self) -> str:
        """What is proven to lie in the parts: 'solid' or 'surface'."""
        return str(self._found.covers())

    @cached_property
    def _volumes(self) -> tuple[Any, Any, Any]:
        volumes: tuple[Any, Any, Any] = self._found.measures()
        return volumes

    def _volume(self, number: int) -> tuple[float, float]:
        pair: tuple[float, float] = _asked(self._volumes[number], "decompose(..., measures='all')")
        return pair

    @property
    def solid_volume(self) -> tuple[float, float]:
        """Doubles below and above; of measures='uncovered' or 'all', as `uncovered`."""
        return self._volume(0)

    @property
    def uncovered(self) -> tuple[float, float]:
        """The volume of the solid that lies in no part."""
        return self._volume(1)

    @property
    def excess(self) -> tuple[float, float]:
        """The volume of the parts outside of the solid; of measures='all'."""
        return self._volume(2)

    @cached_property
    def summary(self) -> str:
        """What the program says."""
        return str(self._found.summary())

    def trace(self) -> str:
        return str(self._found.trace())

    def proof(self) -> str:
        """A text for convexact-check, together with the mesh."""
        return str(self._found.proof())

    def __len__(self) -> int:
        return len(self.parts)

    def __getitem__(self, index: Any) -> Any:
        return self.parts[index]

    def __iter__(self) -> Iterator[Part]:
        return iter(self.parts)

    def __repr__(self) -> str:
        many = "1 part by {} holds" if len(self) == 1 else f"{len(self)} parts by {{}} hold"
        return f"<convexact.Decomposition: {many.format(self.method)} the {self.covers}>"

    def _repr_html_(self) -> str:
        return _frame(lambda: str(self._found.picture("decomposition")), repr(self))
