# SPDX-License-Identifier: MIT
"""The fixture `oracle`, and --convexact-keep DIR, which writes the inputs that fail, with the command that judges them."""
from __future__ import annotations

import re
from pathlib import Path
from typing import Any, Iterator

import numpy as np
import pytest

from . import _inputs, testing
from ._results import Violated


class Oracle:
    """convexact.testing, which keeps what fails."""

    def __init__(self, name: str, folder: Path | None) -> None:
        self._name, self._folder, self._count = re.sub(r"[^\w.-]+", "_", name), folder, 0

    def assert_encloses(self, points: Any, candidate: Any, **options: Any) -> Any:
        return self._keeping(testing.assert_encloses, points, candidate, options)

    def assert_is_hull(self, points: Any, candidate: Any, **options: Any) -> Any:
        return self._keeping(testing.assert_is_hull, points, candidate, options)

    def assert_covers(self, mesh: Any, parts: Any, **options: Any) -> Any:
        return self._keeping(testing.assert_covers, mesh, parts, options)

    def _keeping(self, require: Any, shape: Any, candidate: Any, options: dict[str, Any]) -> Any:
        try:
            return require(shape, candidate, **options)
        except Violated as error:
            if self._folder is None:
                raise
            raise Violated(f"{error}\nkept: {self._keep(shape, candidate, require.__name__)}") from None

    def _keep(self, shape: Any, candidate: Any, asked: str) -> str:
        assert self._folder is not None
        self._folder.mkdir(parents=True, exist_ok=True)
        self._count += 1
        stem = self._folder / f"{self._name}-{self._count}"
        _write_obj(stem.with_suffix(".obj"), [_inputs.mesh(shape, "points")])
        if asked == "assert_covers":
            _write_obj(Path(f"{stem}-parts.obj"), [_inputs.mesh(part, "parts") for part in candidate])
            return f"convexact verify {stem}.obj {stem}-parts.obj --union"
        asks = " --asks hull" if asked == "assert_is_hull" else ""
        if np.ndim(candidate) == 2 and np.shape(candidate)[1] == 4:
            rows = "\n".join(" ".join(map(repr, row)) for row in np.asarray(candidate, dtype=float).tolist())
            Path(f"{stem}-candidate.txt").write_text(rows + "\n", encoding="utf-8")
            return f"convexact verify {stem}.obj {stem}-candidate.txt{asks}"
        _write_obj(Path(f"{stem}-candidate.obj"), [_inputs.mesh(candidate, "candidate")])
        return f"convexact verify {stem}.obj {stem}-candidate.obj{asks}"


def _write_obj(path: Path, meshes: list[Any]) -> None:
    lines, first = [], 1
    for number, (points, faces) in enumerate(meshes):
        if len(meshes) > 1:
            lines.append(f"o part_{number}")
        lines += ["v " + " ".join(x if isinstance(x, str) else repr(float(x)) for x in row) for row in points]
        lines += ["f " + " ".join(str(first + corner) for corner in face) for face in faces]
        first += len(points)
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def pytest_addoption(parser: Any) -> None:
    parser.addoption("--convexact-keep", metavar="DIR", default=None, help="write inputs on which the fixture oracle fails")


@pytest.fixture
def oracle(request: Any) -> Iterator[Oracle]:
    """Assertions about hulls, enclosures and parts, decided exactly."""
    folder = request.config.getoption("--convexact-keep")
    yield Oracle(request.node.name, Path(folder) if folder else None)
