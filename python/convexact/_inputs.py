# SPDX-License-Identifier: MIT
"""What callers have, as the library takes it: arrays of doubles, or exact numbers as texts."""
from __future__ import annotations

import os
from decimal import Decimal
from fractions import Fraction
from typing import Any, Mapping, Sequence

import numpy as np

from . import _core

Rows = Any  # float64 (n, k), or n lists of k texts such as "1/3"
Faces = "list[list[int]]"


def _text(number: Any, place: str) -> str:
    if isinstance(number, (bool, np.bool_)):
        raise _core.InvalidArgument(f"{place}: expected a number, found {number!r}")
    if isinstance(number, (int, np.integer)):
        return str(int(number))
    if isinstance(number, (float, np.floating, Fraction, Decimal)):
        try:
            return str(Fraction(number if not isinstance(number, np.floating) else float(number)))
        except (ValueError, OverflowError) as error:
            raise _core.MalformedInput(f"{place}: expected a finite number, found {number!r}") from error
    raise _core.InvalidArgument(f"{place}: expected a number, found {type(number).__name__}")


def rows(values: Any, width: int, name: str) -> Rows:
    """Rows of so many numbers: float64 where they are doubles; integers beyond 2**53, Fraction,
    Decimal and int objects exactly, as texts."""
    try:
        array = np.asarray(values)
    except ValueError as error:
        raise _core.InvalidArgument(f"{name}: expected an array of shape (n, {width}), found rows of several lengths") from error
    if array.ndim != 2 or array.shape[1] != width:
        raise _core.InvalidArgument(f"{name}: expected an array of shape (n, {width}), found {array.shape}")
    if array.dtype.kind == "f":
        if array.dtype.itemsize > 8:
            return rows(array.astype(object), width, name)
        finite = np.isfinite(array)
        if not finite.all():
            row = int(np.argmin(finite.all(axis=1)))
            raise _core.MalformedInput(f"{name}: expected finite numbers, found {array[row].tolist()} in row {row}")
        return np.ascontiguousarray(array, dtype=np.float64)
    if array.dtype.kind in "iu":
        if array.size == 0 or (abs(int(array.min())) <= 2**53 and int(array.max()) <= 2**53):
            return np.ascontiguousarray(array, dtype=np.float64)
        return [[str(int(x)) for x in row] for row in array]
    if array.dtype.kind == "O":
        return [[_text(x, f"{name}, row {i}") for x in row] for i, row in enumerate(array)]
    raise _core.InvalidArgument(f"{name}: expected numbers, found an array of {array.dtype}")


def faces(values: Any, name: str) -> list[list[int]]:
    """Lists of three or more indices from 0."""
    if values is None:
        return []
    if isinstance(values, np.ndarray) and values.ndim == 2 and values.dtype.kind in "iu":
        if values.size and (values.min() < 0 or values.max() >= 2**32 or values.shape[1] < 3):
            raise _core.InvalidArgument(f"{name}: expected rows of three or more indices from 0")
        return [[int(i) for i in row] for row in values]
    lists: list[list[int]] = []
    for number, face in enumerate(values):
        corners = [int(i) for i in face]
        if len(corners) < 3 or any(i < 0 or i >= 2**32 or i != j for i, j in zip(corners, face)):
            raise _core.InvalidArgument(f"{name}: expected three or more indices from 0 in face {number}, found {list(face)!r}")
        lists.append(corners)
    return lists


def _is_pair(shape: Any) -> bool:
    return isinstance(shape, (tuple, list)) and len(shape) == 2 and np.ndim(shape[0]) == 2


def count(value: Any, name: str) -> int:
    """A whole number of at least 0."""
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, (int, np.integer)) or not 0 <= value < 2**63:
        raise _core.InvalidArgument(f"{name}: expected a whole number of at least 0, found {value!r}")
    return int(value)


def read(path: Any, name: str) -> str:
    """The text of a file."""
    try:
        with open(os.fspath(path), encoding="utf-8") as stream:
            return stream.read()
    except TypeError as error:
        raise _core.InvalidArgument(f"{name}: expected a path, found {type(path).__name__}") from error
    except (OSError, UnicodeDecodeError) as error:
        raise _core.Unreadable(f"{path}: {getattr(error, 'strerror', None) or 'expected text'}") from error


def halfspaces(shape: Any, name: str) -> Rows | None:
    """Rows (n1, n2, n3, d) of a result of this package, exactly, or of an array (m, 4); None of anything else."""
    exact = getattr(shape, "exact_planes", None)
    if exact is not None:
        return rows(np.array(exact, dtype=object).reshape(-1, 4), 4, name)
    if isinstance(shape, (str, os.PathLike)) or _is_pair(shape) or hasattr(shape, "vertices") or hasattr(shape, "points"):
        return None
    try:
        size = np.shape(shape)
    except ValueError:  # rows of several lengths, which rows() refuses
        return None
    return rows(shape, 4, name) if len(size) == 2 and size[1] == 4 else None


def keep(selectors: Any, polygons: list[list[int]]) -> dict[str, Any]:
    """Facets that stay: ids, planes, normals with degrees, and faces of the input by their numbers."""
    if selectors is None:
        return {}
    if not isinstance(selectors, Mapping) or not set(selectors) <= {"ids", "planes", "normals", "degrees", "faces"}:
        raise _core.InvalidArgument(f"keep: expected a dict of ids, planes, normals, degrees and faces, found {selectors!r}")
    given = dict(selectors)
    if "degrees" in given and "normals" not in given:
        raise _core.InvalidArgument("keep: degrees need normals")
    for name, width in (("planes", 4), ("normals", 3)):
        if name in given:
            given[name] = rows(given[name], width, f"keep[{name!r}]")
    if "faces" in given:
        wrong = [k for k in given["faces"] if not count(k, "keep['faces']") < len(polygons)]
        if wrong:
            raise _core.InvalidArgument(f"keep['faces']: expected numbers of the {len(polygons)} faces of the input, found {wrong[0]}")
        given["faces"] = [polygons[k] for k in given["faces"]]
    if "ids" in given:
        given["ids"] = [count(k, "keep['ids']") for k in given["ids"]]
    if "degrees" in given:
        try:
            given["degrees"] = float(given["degrees"])
        except (TypeError, ValueError) as error:
            raise _core.InvalidArgument(f"keep['degrees']: expected a number, found {given['degrees']!r}") from error
    return given


def mesh(shape: Any, name: str, exact: bool = False) -> tuple[Rows, list[list[int]]]:
    """Points and faces: of a path, (vertices, faces), an object of trimesh, Open3D, scipy, coal or manifold3d, or points."""
    if isinstance(shape, (str, os.PathLike)):
        points, polygons, _ = _core.read_mesh(os.fspath(shape), exact)
        return points, polygons
    if _is_pair(shape):
        return rows(shape[0], 3, f"{name}[0]"), faces(shape[1], f"{name}[1]")
    if hasattr(shape, "to_mesh"):  # of manifold3d
        shape = shape.to_mesh()
    if hasattr(shape, "vert_properties"):
        return rows(np.asarray(shape.vert_properties)[:, :3], 3, name), faces(np.asarray(shape.tri_verts), name)
    for points_of, face_of, count in (("points", "polygons", "num_polygons"), ("vertices", "tri_indices", "num_tris")):  # of coal
        if hasattr(shape, face_of) and hasattr(shape, count):
            found = [getattr(shape, face_of)(k) for k in range(getattr(shape, count))]
            triangles = [[face[0], face[1], face[2]] for face in found]
            return rows(np.asarray(getattr(shape, points_of)()), 3, name), faces(triangles, name)
    for points_of, faces_of in (("vertices", "faces"), ("vertices", "triangles"), ("points", "simplices")):
        if hasattr(shape, points_of) and hasattr(shape, faces_of):
            found = getattr(shape, faces_of)
            corners = found if isinstance(found, (list, np.ndarray)) else np.asarray(found)
            if points_of == "points":  # of scipy: its simplices are not turned outward, and only its corners count
                used = np.unique(np.asarray(corners))
                return rows(np.asarray(getattr(shape, points_of))[used], 3, name), []
            return rows(np.asarray(getattr(shape, points_of)), 3, name), faces(corners, name)
    if hasattr(shape, "points") and not isinstance(shape, np.ndarray):
        return rows(np.asarray(shape.points), 3, name), []
    return rows(shape, 3, name), []


def text(value: Any) -> str:
    """An option as the command line spells it."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (float, np.floating)):
        return repr(float(value))
    return str(value)


def options(given: dict[str, Any]) -> list[tuple[str, str]]:
    """Those that are not None."""
    return [(name, text(value)) for name, value in given.items() if value is not None]


def progress(wanted: Any) -> Any:
    """None, a callable, or for True a bar of tqdm where that is installed."""
    if wanted is None or wanted is False:
        return None
    if wanted is not True:
        if not callable(wanted):
            raise _core.InvalidArgument("progress: expected True, or a callable of stage, done and total")
        return wanted
    try:
        from tqdm.auto import tqdm  # type: ignore[import-not-found, import-untyped, unused-ignore]  # pylint: disable=import-outside-toplevel
    except ImportError:
        return None
    bars: dict[str, Any] = {}

    def show(stage: str, done: int, total: int) -> None:
        if stage not in bars:
            bars[stage] = tqdm(total=total, desc=stage, leave=False)
        bars[stage].n = done
        bars[stage].refresh()

    return show


def names(claims: Sequence[str] | None) -> list[str]:
    if claims is None:
        return []
    return [claims] if isinstance(claims, str) else list(claims)
