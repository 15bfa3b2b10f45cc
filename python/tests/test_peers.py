# SPDX-License-Identifier: MIT
"""Other people's packages, where their wheels are installed: their objects go in, and their outputs are judged. What is said
of these holds for any version: an output is refused only with a witness that Fractions confirm."""
import os
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import convexact as cx

DATA = Path(os.environ["CONVEXACT_TEST_DATA"])


@pytest.fixture(name="spot", scope="module")
def read_spot() -> Any:
    return cx.read_mesh(DATA / "spot.obj", triangles=True)


def as_trimesh(vertices: Any, faces: Any) -> Any:
    return pytest.importorskip("trimesh").Trimesh(vertices, faces, process=False)


def as_open3d(vertices: Any, faces: Any) -> Any:
    geometry, utility = (getattr(pytest.importorskip("open3d"), name) for name in ("geometry", "utility"))
    return geometry.TriangleMesh(utility.Vector3dVector(vertices), utility.Vector3iVector(faces))


def as_cloud(vertices: Any, faces: Any) -> Any:
    del faces
    open3d = pytest.importorskip("open3d")
    return open3d.geometry.PointCloud(open3d.utility.Vector3dVector(vertices))


def as_scipy(vertices: Any, faces: Any) -> Any:
    del faces
    return pytest.importorskip("scipy.spatial").ConvexHull(vertices)


def as_coal(vertices: Any, faces: Any) -> Any:
    model = pytest.importorskip("coal").BVHModelOBBRSS()
    model.beginModel(len(faces), len(vertices))
    for face in faces:
        model.addTriangle(*(vertices[k] for k in face))
    model.endModel()
    return model


@pytest.mark.parametrize("make", [as_trimesh, as_open3d, as_cloud, as_scipy, as_coal])
def test_objects_go_in_by_their_attributes(make: Any, spot: Any) -> None:
    vertices, faces = spot
    used = cx.hull(vertices[np.unique(faces)])
    assert cx.hull(make(vertices, faces)).exact_planes == used.exact_planes


def hull_of_scipy(points: Any) -> Any:
    hull = pytest.importorskip("scipy.spatial").ConvexHull(points)
    return points[hull.vertices]


def hull_of_trimesh(points: Any) -> Any:
    return pytest.importorskip("trimesh").convex.convex_hull(points)


def hull_of_manifold(points: Any) -> Any:
    return pytest.importorskip("manifold3d").Manifold.hull_points(points)


def hull_of_coal(points: Any) -> Any:
    model = pytest.importorskip("coal").BVHModelOBBRSS()
    model.beginModel(0, len(points))
    model.addVertices(points)
    model.endModel()
    model.buildConvexHull(True, "Qt")
    return model.convex


@pytest.mark.parametrize("function", [hull_of_scipy, hull_of_trimesh, hull_of_manifold, hull_of_coal])
def test_hulls_hold_their_points_or_there_is_a_witness(function: Any, spot: Any) -> None:
    points = spot[0]
    verdict = cx.verify(points, function(points))
    claim = verdict.claims["contains-input"]
    assert claim.status in ("holds", "violated")
    if claim.holds:
        return
    assert claim.point is not None and claim.squared_distance and claim.distance is not None
    assert claim.distance < 1e-5 * np.ptp(points, axis=0).max()  # binary32, at worst
    # Outside, whatever rounding says: the exact hull of what they gave does not grow by a point that lies in it.
    given = cx.hull(function(points)).volume
    both = np.vstack([cx._inputs.mesh(function(points), "candidate")[0], points[claim.point]])  # pylint: disable=protected-access
    assert cx.hull(both).volume > given


def test_what_the_paper_s_program_writes_is_judged(spot: Any) -> None:
    pchs = pytest.importorskip("pchs")
    vertices, faces = spot
    corners, _, _ = pchs.simplify_convex_hull(np.asfortranarray(vertices), np.asfortranarray(faces.astype(np.int32)), 20)
    verdict = cx.verify(vertices, corners)
    ours = cx.simplify(vertices, faces=20)
    assert cx.verify(vertices, ours).ok
    claim = verdict.claims["contains-input"]
    # Its doubles miss points by roundings, if at all.
    assert claim.holds or claim.distance is not None and claim.distance < 1e-12
    assert Fraction(float(cx.hull(corners).volume)) < cx.hull(vertices).volume * 2


def parts_of_coacd(vertices: Any, faces: Any) -> Any:
    coacd = pytest.importorskip("coacd")
    coacd.set_log_level("error")
    return coacd.run_coacd(coacd.Mesh(vertices, faces), threshold=0.1)


def parts_of_vhacd(vertices: Any, faces: Any) -> Any:
    found = pytest.importorskip("vhacdx").compute_vhacd(vertices, np.hstack([np.full((len(faces), 1), 3), faces]).ravel())
    return [(points, np.asarray(corners).reshape(-1, 4)[:, 1:] if np.ndim(corners) == 1 else corners) for points, corners in found]


@pytest.mark.parametrize("decompose", [parts_of_coacd, parts_of_vhacd])
def test_parts_are_judged_and_ours_hold_the_solid(decompose: Any) -> None:
    mesh = cx.read_mesh(DATA / "cases" / "bin.obj", triangles=True)
    theirs = cx.verify_parts(mesh, decompose(*mesh))
    assert theirs.claims["covers-points"].status in ("holds", "violated")
    ours = cx.verify_parts(mesh, cx.decompose(mesh, distance="3%"), distance="3%")
    assert ours.ok
