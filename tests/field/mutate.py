# SPDX-License-Identifier: MIT
"""Wrong meshes, and odd ones that are right, made from a mesh: both judges are to tell them apart."""
import math
import struct
from fractions import Fraction

from reading import Mesh


def obj_text(mesh):
    lines = ["v " + " ".join(repr(float(x)) for x in point) for point in mesh.points]
    lines += ["f " + " ".join(str(corner + 1) for corner in face) for face in mesh.faces]
    return ("\n".join(lines) + "\n").encode()


def ply_bytes(mesh):
    header = (f"ply\nformat binary_little_endian 1.0\nelement vertex {len(mesh.points)}\nproperty double x\n"
              f"property double y\nproperty double z\nelement face {len(mesh.faces)}\n"
              "property list uint uint vertex_indices\nend_header\n").encode()
    return header + b"".join(struct.pack("<3d", *p) for p in mesh.points) + b"".join(
        struct.pack(f"<{len(f) + 1}I", len(f), *f) for f in mesh.faces)


def off_text(mesh):
    lines = ["OFF", f"{len(mesh.points)} {len(mesh.faces)} 0"]
    lines += [" ".join(repr(float(x)) for x in point) for point in mesh.points]
    lines += [" ".join(map(str, [len(face), *face])) for face in mesh.faces]
    return ("\n".join(lines) + "\n").encode()


def middle(a, b):
    """Of two points, if doubles hold it."""
    exact = [(Fraction(x) + Fraction(y)) / 2 for x, y in zip(a, b)]
    rounded = tuple(float(x) for x in exact)
    return rounded if all(Fraction(x) == y for x, y in zip(rounded, exact)) else None


def edge_with_middle(mesh, random):
    """A directed edge of a face whose middle is a double: face, place, the middle; None if there is none."""
    places = [(f, k) for f, face in enumerate(mesh.faces) for k in range(len(face))]
    random.shuffle(places)
    for f, k in places[:50]:
        face = mesh.faces[f]
        spot = middle(mesh.points[face[k - 1]], mesh.points[face[k]])
        if spot and spot not in (mesh.points[face[k - 1]], mesh.points[face[k]]):
            return f, k, spot
    return None


class Mutations:
    """Each method with a name `m_...` changes points and faces in place; False if it does not apply."""

    def __init__(self, mesh, random):
        self.points, self.faces, self.random = list(mesh.points), [list(face) for face in mesh.faces], random

    def face(self, size=3):
        large = [face for face in self.faces if len(face) >= size]
        return self.random.choice(large) if large else None

    def twin(self, corner):
        self.points.append(self.points[corner])
        return len(self.points) - 1

    def m_as_it_is(self):
        return True

    def m_vertex_dropped(self):
        gone = self.random.choice(self.face())
        self.faces = [face for face in self.faces if gone not in face]
        self.points[gone] = self.points[gone - 1]

    def m_face_dropped(self):
        self.faces.remove(self.face())

    def m_bow_tie(self):
        face = self.face(4)
        if not face:
            return False
        k = self.random.randrange(len(face))
        face[k - 1], face[k] = face[k], face[k - 1]

    def m_zero_length_edge(self):
        face = self.face()
        k = self.random.randrange(len(face))
        face.insert(k, self.twin(face[k]))

    def m_twin_in_one_face(self):
        face = self.face()
        k = self.random.randrange(len(face))
        face[k] = self.twin(face[k])

    def m_points_for_each_face(self):
        self.faces = [[self.twin(corner) for corner in face] for face in self.faces]

    def m_triangles_without_area(self):
        for _ in range(3):
            a, b = self.face()[:2]
            self.faces.append([a, self.twin(a), b])
            self.faces.append([self.twin(b), b, self.twin(b)])

    def m_repeated_corner(self):
        face = self.face()
        k = self.random.randrange(len(face))
        face.insert(k, face[k])

    def m_corner_again_later(self):
        face = self.face(4)
        if not face:
            return False
        face.insert(2, face[0])

    def m_spike(self):
        face = self.face()
        k = self.random.randrange(len(face))
        others = [c for c in range(len(self.points)) if c not in face]
        if not others:
            return False
        face[k + 1:k + 1] = [self.random.choice(others), face[k]]

    def m_face_turned(self):
        self.face().reverse()

    def m_all_turned(self):
        for face in self.faces:
            face.reverse()

    def nudge(self, outward):
        corner = self.random.choice(self.face())
        point = list(self.points[corner])
        axis = self.random.randrange(3)
        center = math.fsum(p[axis] for p in self.points) / len(self.points)
        up = (point[axis] > center) == outward
        point[axis] = math.nextafter(point[axis], math.inf if up else -math.inf)
        self.points[corner] = tuple(point)

    def m_nudged_inward(self):
        self.nudge(False)

    def m_nudged_outward(self):
        self.nudge(True)

    def m_pushed_inward(self):
        corner = self.random.choice(self.face())
        center = [math.fsum(p[k] for p in self.points) / len(self.points) for k in range(3)]
        self.points[corner] = tuple(x + (c - x) / 8 for x, c in zip(self.points[corner], center))

    def m_t_junction(self):
        found = edge_with_middle(self, self.random)
        if not found:
            return False
        f, k, spot = found
        self.points.append(spot)
        self.faces[f].insert(k, len(self.points) - 1)

    def m_straight_corner(self):
        found = edge_with_middle(self, self.random)
        if not found:
            return False
        f, k, spot = found
        edge = {self.faces[f][k - 1], self.faces[f][k]}
        self.points.append(spot)
        for face in self.faces:
            for at in range(len(face)):
                if {face[at - 1], face[at]} == edge:
                    face.insert(at, len(self.points) - 1)
                    break

    def m_sliver_in_t_junction(self):
        found = edge_with_middle(self, self.random)
        if not found:
            return False
        f, k, spot = found
        a, b = self.faces[f][k - 1], self.faces[f][k]
        self.points.append(spot)
        self.faces[f].insert(k, len(self.points) - 1)
        self.faces.append([a, b, len(self.points) - 1])

    def m_double_cover(self):
        self.faces += [list(face) for face in self.faces]

    def m_double_cover_turned(self):
        self.faces += [face[::-1] for face in self.faces]

    def m_inner_tetrahedron(self):
        a, b, c = self.face()[:3]
        d = next((d for d in range(len(self.points)) if d not in (a, b, c)), None)
        if d is None:
            return False
        self.faces = [[a, b, c], [a, d, b], [b, d, c], [c, d, a]]

    def m_point_far_away(self):
        self.points.append(tuple(2 * x + 1 for x in self.points[0]))

    def m_point_inside(self):
        self.points.append(tuple(math.fsum(p[k] for p in self.points) / len(self.points) for k in range(3)))

    def m_fans(self):
        self.faces = [[face[0], b, c] for face in self.faces for b, c in zip(face[1:], face[2:])]

    def m_no_faces(self):
        self.faces = []


def mutations(mesh, random):
    """(name, Mesh) for each mutation that applies."""
    for name in sorted(dir(Mutations)):
        if name.startswith("m_"):
            mutant = Mutations(mesh, random)
            if getattr(mutant, name)() is not False:
                yield name[2:].replace("_", "-"), Mesh(mutant.points, mutant.faces)
