# SPDX-License-Identifier: MIT
"""The packages of the Python index as programs of ./dev field: python_hulls.py NAME INPUT.obj OUTPUT.obj FACES

Each gets the input's points (those that simplify: its faces, too) by the call that its own documents show first. What it
returns is written with all digits, without the points that no face uses. The seconds of that call, the processor's if these
are less, as on a busy machine, go to OUTPUT.obj.json. Exit code 4: the package raised an exception. A result without faces is
no refusal: then there is no file, and the exit code is 0.
"""
import sys

import numpy as np
from adapter import obj_lines, read_obj, run, timed, used_only


def scipy(points, faces, count):
    """scipy.spatial.ConvexHull: its simplices have no order, its equations look outward."""
    from scipy.spatial import ConvexHull
    hull = ConvexHull(points)
    turned = []
    for corners, normal in zip(hull.simplices, hull.equations[:, :3]):
        a, b, c = points[corners]
        turned.append(corners if np.dot(np.cross(b - a, c - a), normal) > 0 else corners[::-1])
    return points, turned


def trimesh(points, faces, count):
    import trimesh as package
    hull = package.convex.convex_hull(points)
    return hull.vertices, hull.faces


def open3d(points, faces, count):
    import open3d as package
    cloud = package.geometry.PointCloud(package.utility.Vector3dVector(points))
    hull, _ = cloud.compute_convex_hull()
    return np.asarray(hull.vertices), np.asarray(hull.triangles)


def manifold3d(points, faces, count):
    import manifold3d as package
    mesh = package.Manifold.hull_points(points).to_mesh64()
    return mesh.vert_properties[:, :3], mesh.tri_verts


def coal(points, faces, count):
    import coal as package
    model = package.BVHModelOBBRSS()
    model.beginModel(0, len(points))
    model.addVertices(np.asarray(points))
    model.endModel()
    model.buildConvexHull(True, "Qt")
    hull = model.convex
    triangles = [hull.polygons(k) for k in range(hull.num_polygons)]
    return np.array([hull.point(k) for k in range(hull.num_points)]), [[t[0], t[1], t[2]] for t in triangles]


def pymeshlab(points, faces, count):
    import pymeshlab as package
    meshes = package.MeshSet()
    meshes.add_mesh(package.Mesh(points))
    meshes.generate_convex_hull()
    return meshes.current_mesh().vertex_matrix(), meshes.current_mesh().face_matrix()


def mujoco(points, faces, count, limit=-1):
    """The hull that the compiler of models keeps of a mesh, moved back from the frame of its inertia."""
    import mujoco as package
    text = " ".join(repr(float(x)) for x in points.ravel())
    model = package.MjModel.from_xml_string(
        f'<mujoco><asset><mesh name="m" vertex="{text}" maxhullvert="{limit}"/></asset>'
        '<worldbody><geom type="mesh" mesh="m"/></worldbody></mujoco>')
    graph = model.mesh_graph
    corners, triangles = int(graph[0]), int(graph[1])
    names = graph[2 + corners:2 + 2 * corners]
    found = graph[2 + 3 * corners + 3 * triangles:2 + 3 * corners + 6 * triangles].reshape(-1, 3)
    turn = np.zeros(9)
    package.mju_quat2Mat(turn, model.mesh_quat[0])
    places = model.mesh_vert.astype(float) @ turn.reshape(3, 3).T + model.mesh_pos[0]
    index = {int(name): k for k, name in enumerate(names)}
    return places[names], [[index[int(k)] for k in triangle] for triangle in found]


def mujoco_32(points, faces, count):
    return mujoco(points, faces, count, 32)


def libigl(points, faces, count):
    """Its hull is CGAL's."""
    from igl.copyleft import cgal
    return points, cgal.convex_hull(points)


def drake(points, faces, count):
    """Its faces are polygons."""
    from pydrake.geometry import Convex
    hull = Convex(points=points.T, label="input").GetConvexHull()
    polygons = [hull.element(k) for k in range(hull.num_faces())]
    return ([hull.vertex(k) for k in range(hull.num_vertices())],
            [[polygon.vertex(k) for k in range(polygon.num_vertices())] for polygon in polygons])


def pchs(points, faces, count):
    """The program of [Jacobson2026]."""
    import pchs as package
    places, corners, ends = package.simplify_convex_hull(np.asfortranarray(points), np.asfortranarray(faces), count)
    return places, [corners[ends[k]:ends[k + 1]] for k in range(len(ends) - 1)]


def main(name, source, target, count):
    points, faces = read_obj(source)
    call = {"mujoco-32": mujoco_32}.get(name) or globals()[name]

    def twice():
        """The second of two calls counts, since the first one may load the package; but for a long one."""
        first = timed(lambda: call(points, faces, int(count)))
        return first if first[0] > 5 else timed(lambda: call(points, faces, int(count)))
    return run(target, twice, lambda hull: obj_lines(*used_only(*hull)))


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
