# SPDX-License-Identifier: MIT
"""Meshes are reduced to closed surfaces that keep a fault; what touches itself is found, against cases that a person can see."""
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from decompositions import polycube, torus  # noqa: E402
from reading import Mesh  # noqa: E402
from smaller_mesh import is_surface, joined, six_volumes, smaller_mesh, touches_itself  # noqa: E402

TETRAHEDRON = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
FACES = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]


def pair(offset):
    """Two tetrahedra, the second one moved."""
    moved = [tuple(float(x + d) for x, d in zip(point, offset)) for point in TETRAHEDRON]
    return Mesh([*TETRAHEDRON, *moved], FACES + [[corner + 4 for corner in face] for face in FACES])


class Surfaces(unittest.TestCase):
    def test_what_touches_itself(self):
        for mesh in (Mesh(TETRAHEDRON, FACES), polycube([(0, 0, 0), (1, 0, 0), (0, 1, 0)]), torus(8, 6), pair((2, 0, 0)),
                     pair((1.0000001, 0, 0))):
            self.assertTrue(is_surface(mesh))
            self.assertFalse(touches_itself(mesh))
        # At a corner, at an edge, at a face, through each other, one in the other but for a corner.
        for offset in ((1, 0, 0), (-0.5, -0.5, 1), (0.5, 0, -1), (0.25, 0.25, 0), (0.1, 0.1, 0.1), (0, 0, 0)):
            self.assertTrue(touches_itself(pair(offset)), offset)

    def test_a_face_that_is_folded_onto_its_neighbour(self):
        points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0.2, 0.2, 0), (0, 0, 1)]
        self.assertTrue(touches_itself(Mesh(points, [[0, 1, 2], [1, 0, 3]])))  # over it
        self.assertFalse(touches_itself(Mesh(points, [[0, 1, 2], [1, 0, 4]])))
        # Neither apex in the other triangle; then a square of two layers.
        self.assertTrue(touches_itself(Mesh([(0, 0, 0), (1, 0, 0), (-0.5, 1, 0), (1.5, 1, 0)], [[0, 1, 2], [1, 0, 3]])))
        self.assertTrue(touches_itself(Mesh([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], FACES)))

    def test_triangles_back_to_back_go(self):
        octahedron = Mesh([(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)],
                          [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]])
        self.assertTrue(is_surface(octahedron))
        smaller = joined(octahedron, [0, 0, 2, 3, 4, 5])  # a square, twice, back to back
        self.assertEqual(smaller.faces, [])
        self.assertEqual(len(joined(octahedron, [0, 1, 0, 3, 4, 5]).faces), 6)  # of five points


class Reduced(unittest.TestCase):
    def test_to_a_tetrahedron(self):
        least = smaller_mesh(torus(12, 8), lambda mesh: True, 10)
        self.assertEqual((len(least.points), len(least.faces)), (4, 4))
        self.assertTrue(all(x == int(x) for point in least.points for x in point))
        self.assertGreater(six_volumes(least), 0)

    def test_nothing_is_turned_inside_out(self):
        points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0.3, 0.3, 1), (0.3, 0.3, 0.5)]
        dented = Mesh(points, [[0, 1, 3], [1, 2, 3], [2, 0, 3], [1, 0, 4], [2, 1, 4], [0, 2, 4]])
        self.assertEqual(six_volumes(dented) * 2, 1)
        self.assertLess(six_volumes(joined(dented, [0, 1, 2, 0, 4])), 0)
        self.assertGreater(six_volumes(smaller_mesh(dented, lambda mesh: True, 5)), 0)

    def test_a_hole_stays(self):
        def has_hole(mesh):
            return len(mesh.points) - len(mesh.faces) // 2 == 0
        least = smaller_mesh(torus(12, 8), has_hole, 20)
        self.assertTrue(has_hole(least) and is_surface(least) and not touches_itself(least))
        self.assertLessEqual(len(least.points), 12)  # no torus has fewer than 7

    def test_without_the_fault_it_stays_whole(self):
        whole = torus(6, 4)
        self.assertIs(smaller_mesh(whole, lambda mesh: False, 5), whole)


if __name__ == "__main__":
    unittest.main()
