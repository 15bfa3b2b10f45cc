# SPDX-License-Identifier: MIT
"""The shapes of the vectors, as exact fractions, each with its flags, its level and, where there is
one, the closed form of its volume.

Written anew here and not taken from convexact's own families, so that a mistake there cannot hide.
"""
from dataclasses import dataclass, field
from fractions import Fraction as F
from itertools import permutations, product
from math import sqrt

from circle import circle_point
from exact_geometry import determinant


@dataclass
class Shape:
    name: str
    title: str
    points: list
    flags: list
    level: int = 1
    faces: int = 0  # of the simplification that is asked for; 0: none is
    volume: F = None  # by the closed form
    facets: int = None
    why: str = ""  # the closed form in a sentence
    vertices: int = None  # set where the points are too many for the definition
    costs: list = field(default=None)  # of the removals, by a closed form
    cost_why: str = ""


class Draw:
    """A generator that is the same everywhere (Knuth's MMIX constants)."""

    def __init__(self, seed):
        self.state = seed * 2862933555777941757 + 3037000493 & 2**64 - 1

    def below(self, n):
        self.state = self.state * 6364136223846793005 + 1442695040888963407 & 2**64 - 1
        return (self.state >> 33) % n

    def integer(self, most):
        return self.below(2 * most + 1) - most


def exact(points):
    """Numbers (integers, floats or fractions) as fractions that are doubles."""
    result = [tuple(F(x) for x in p) for p in points]
    for p in result:
        assert all(F(float(x)) == x for x in p), f"{p} is no point of doubles"
    return result


def rounded(points):
    """Fractions to their nearest doubles."""
    return [tuple(F(float(F(x))) for x in p) for p in points]


def signs(p):
    """All distinct sign changes."""
    return sorted(set(product(*({x, -x} for x in p))))


def cyclic(p):
    return [p, (p[1], p[2], p[0]), (p[2], p[0], p[1])]


def all_images(p):
    """All permutations and sign changes, distinct."""
    return sorted({q for r in permutations(p) for q in signs(r)})


def cyclic_images(p):
    return sorted({q for r in cyclic(p) for q in signs(r)})


def shifted(points, by):
    return [tuple(x + F(b) for x, b in zip(p, by)) for p in points]


def stretched(points, by):
    return [tuple(x * F(b) for x, b in zip(p, by)) for p in points]


def box(a, b, c):
    return list(product((0, a), (0, b), (0, c)))


def parabola(n):
    """2n + 1 points (t, t^2), the corners of a convex polygon of area (4 n^3 - n) / 3."""
    return [(t, t * t) for t in range(-n, n + 1)]


def parabola_area(n):
    return F(4 * n**3 - n, 3)


def prism_over(polygon, height):
    return [(x, y, z) for x, y in polygon for z in (0, height)]


def sphere_points(square, keep=lambda index: True):
    r = int(sqrt(square)) + 1
    found = [p for p in product(range(-r, r + 1), repeat=3) if sum(x * x for x in p) == square]
    return [p for index, p in enumerate(found) if keep(index)]


def random_lattice(seed, count, most):
    draw = Draw(seed)
    return [tuple(draw.integer(most) for _ in range(3)) for _ in range(count)]


def random_ball(seed, count, bits=52):
    """Multiples of 2^-bits in the unit ball."""
    draw, found = Draw(seed), []
    while len(found) < count:
        p = tuple(F(draw.below(2**31) * 2**31 + draw.below(2**31) - 2**61, 2**61) for _ in range(3))
        p = tuple(F(round(x * 2**bits), 2**bits) for x in p)
        if sum(x * x for x in p) <= 1:
            found.append(p)
    return found


def zonotope(generators):
    """All sums of subsets."""
    points = {(0, 0, 0)}
    for g in generators:
        points |= {tuple(a + b for a, b in zip(p, g)) for p in points}
    return sorted(points)


def zonotope_volume(generators):
    n = len(generators)
    return sum(abs(determinant(generators[i], generators[j], generators[k]))
               for i in range(n) for j in range(i) for k in range(j))


def rounded_box(half, radius, steps):
    """The nearest doubles to a box plus an octant grid of a sphere at each corner."""
    octant = []
    for i in range(steps + 1):
        latitude = circle_point(i, 4 * steps)
        for j in range(steps + 1 if i < steps else 1):
            longitude = circle_point(j, 4 * steps)
            octant.append((latitude[0] * longitude[0], latitude[0] * longitude[1], latitude[1]))
    points = set()
    for p in octant:
        for sign in product((1, -1), repeat=3):
            points.add(tuple(F(s * float(h + radius * F(x))) for s, h, x in zip(sign, half, p)))
    return sorted(points)


def nudged(points, which, axis, ulps):
    """One coordinate moved by so many units in its last place."""
    import math
    result = [list(p) for p in points]
    x = float(result[which][axis])
    for _ in range(abs(ulps)):
        x = math.nextafter(x, math.inf if ulps > 0 else -math.inf)
    result[which][axis] = F(x)
    return [tuple(p) for p in result]


def regular_solids():
    yield Shape("tetrahedron", "Regular tetrahedron", [(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)],
                [], 1, 4, F(8, 3), 4, "a cube of side 2 minus four corners of volume 4/3 each")
    yield Shape("cube", "Cube", box(2, 2, 2), ["parallel-edges", "unbounded"], 1, 4, F(8), 6, "2^3",
                costs=[], cost_why="no side of a box can go: what is left is unbounded")
    yield Shape("octahedron", "Regular octahedron", cyclic_images((1, 0, 0)), ["ties", "valence"], 1, 4,
                F(4, 3), 8, "two pyramids over a square of area 2, each of height 1",
                costs=[F(1, 3)] * 4, cost_why="each removed face gains a tetrahedron of 1/3, until a "
                "tetrahedron of volume 8/3 is left")
    golden = (1 + sqrt(5)) / 2
    yield Shape("icosahedron", "Regular icosahedron in nearest doubles", cyclic_images((0, 1, golden)),
                ["ties"], 1, 8, facets=20, why="20 triangles, by Euler's formula")
    yield Shape("rounded-dodecahedron", "Regular dodecahedron in nearest doubles: pentagons not quite plane",
                all_images((1, 1, 1)) + cyclic_images((0, 1 / golden, golden)), ["near-coplanar", "ties"], 2, 12)
    yield Shape("pyritohedron", "Dodecahedron with exactly plane pentagons",
                all_images((4, 4, 4)) + cyclic_images((0, 6, 3)), ["ties", "coplanar"], 1, 6, facets=12,
                why="a pentagon through each of the 12 roof edges of a cube")
    yield Shape("cuboctahedron", "Cuboctahedron", all_images((1, 1, 0)), ["ties", "coplanar"], 1, 6, F(20, 3),
                14, "a cube of side 2 minus eight corners of volume 1/6 each",
                costs=[F(1, 6)] * 8, cost_why="each removed triangle gives back a corner of the cube, of volume 1/6")
    yield Shape("truncated-octahedron", "Truncated octahedron", all_images((0, 1, 2)),
                ["ties", "coplanar", "parallel-edges"], 1, 8, F(32), 14,
                "an octahedron of half-diagonal 3 (volume 36) minus six pyramids of volume 2/3 each",
                costs=[F(2, 3)] * 6, cost_why="each removed square gives back a pyramid of volume 2/3")
    yield Shape("truncated-tetrahedron", "Truncated tetrahedron",
                sorted({q for q in all_images((3, 1, 1)) if q[0] * q[1] * q[2] > 0}), ["ties", "coplanar"], 1, 4,
                F(184, 3), 8, "a tetrahedron in a cube of side 6 (volume 72) minus four of a third of its edge",
                costs=[F(8, 3)] * 4, cost_why="each removed triangle gives back a tetrahedron of 72/27")
    yield Shape("truncated-cube", "Cube with its corners cut at depth 2 of 6", all_images((1, 3, 3)),
                ["ties", "coplanar"], 1, 6, F(216) - 8 * F(8, 6), 14, "6^3 minus eight corners of volume 2^3/6",
                costs=[F(4, 3)] * 8, cost_why="each removed triangle gives back a corner of volume 2^3/6")
    yield Shape("rhombic-dodecahedron", "Rhombic dodecahedron", all_images((1, 1, 1)) + all_images((2, 0, 0)),
                ["ties", "valence", "parallel-edges"], 1, 6, F(16), 12, "a cube of volume 8 and six pyramids over its sides, 4/3 each")
    yield Shape("tetrakis-cube", "Cube with a low pyramid on each side", all_images((4, 4, 4)) + all_images((5, 0, 0)),
                ["ties", "valence"], 1, 12, F(512) + 6 * F(64, 3), 24, "8^3 and six pyramids of height 1 over 8 x 8")
    yield Shape("triakis-tetrahedron", "Tetrahedron with a low pyramid on each side",
                [(5, 5, 5), (5, -5, -5), (-5, 5, -5), (-5, -5, 5), (-3, -3, -3), (-3, 3, 3), (3, -3, 3), (3, 3, -3)],
                ["ties"], 1, 4, facets=12, why="three triangles on each of four sides")
    yield Shape("triakis-octahedron", "Octahedron with a low pyramid on each side", all_images((5, 0, 0)) + all_images((2, 2, 2)),
                ["ties", "valence"], 1, 8, facets=24, why="three triangles on each of eight sides")
    yield Shape("rhombicuboctahedron-like", "Cube, octahedron and dodecahedron cut each other", all_images((1, 1, 3)),
                ["ties", "coplanar", "parallel-edges"], 1, 6, facets=26, why="6 squares, 12 rectangles, 8 triangles")
    yield Shape("truncated-cuboctahedron-like", "48 corners, all images of (1, 3, 6)", all_images((1, 3, 6)),
                ["ties", "coplanar", "parallel-edges"], 2, 6, facets=26, why="6 octagons, 12 rectangles, 8 hexagons")
    yield Shape("deltoid-like", "Cube, octahedron and cuboctahedron of 26 corners, no two facets alike by chance",
                all_images((6, 0, 0)) + all_images((4, 4, 0)) + all_images((3, 3, 3)), ["ties", "valence"], 2, 8)
    for a, b in ((1, 2), (3, 5), (8, 13)):
        yield Shape(f"pseudo-icosahedron-{a}-{b}", f"Icosahedron of the points (0, {a}, {b})", cyclic_images((0, a, b)),
                    ["ties"], 1, 6, facets=20, why="20 triangles, by Euler's formula")
    yield Shape("stella-octangula", "Two tetrahedra and the eight points between, on the edges of a cube",
                all_images((2, 2, 2)) + all_images((2, 2, 0)) + all_images((2, 0, 0)) + [(0, 0, 0)],
                ["coplanar", "lattice", "duplicates"], 2, 4, F(64), 6, "4^3: the other points lie on edges and sides",
                costs=[], cost_why="no side of a box can go: what is left is unbounded")


def over_polygons():
    for n in (1, 2, 3, 4, 6, 9):
        polygon, area, k = parabola(n), parabola_area(n), 2 * n + 1
        height = n + 1
        yield Shape(f"prism-parabola-{k}", f"Prism over {k} points of a parabola", prism_over(polygon, height),
                    ["parallel-edges", "coplanar"] + (["unbounded"] if n == 1 else []), 1, max(5, n), area * height, k + 2,
                    f"the polygon's area (4 n^3 - n)/3 = {area} with n = {n}, times the height {height}")
        apex = (0, n * n - F(1, 2) if n == 1 else n * n - 1, 3 * n + 1)
        yield Shape(f"pyramid-parabola-{k}", f"Pyramid over {k} points of a parabola",
                    [(x, y, 0) for x, y in polygon] + [apex], ["valence", "coplanar"], 1 if n < 6 else 2,
                    max(4, n), area * (3 * n + 1) / 3, k + 1, f"the polygon's area {area} times a third of the height {3 * n + 1}")
        if n > 1:
            inner = (1, n * n // 2 + 1)
            yield Shape(f"bipyramid-parabola-{k}", f"Bipyramid over {k} points of a parabola",
                        [(x, y, 0) for x, y in polygon] + [(*inner, 2 * n), (*inner, -n)], ["valence"], 2,
                        2 * n, area * n, 2 * k, f"the polygon's area {area} times a third of the heights {2 * n} + {n}")
    for k in (5, 8, 12):
        polygon = [circle_point(i, k) for i in range(k)]
        yield Shape(f"prism-circle-{k}", f"Prism over a regular {k}-gon in nearest doubles", prism_over(polygon, 1),
                    ["parallel-edges", "ties" if k != 5 else "coplanar"], 1, k // 2 + 2, facets=k + 2, why="two polygons and a rectangle per side")
        yield Shape(f"antiprism-circle-{k}", f"Antiprism over a regular {k}-gon in nearest doubles",
                    [(c, s, -1) for c, s in polygon] + [(*circle_point(2 * i + 1, 2 * k), 1) for i in range(k)],
                    ["ties", "coplanar"], 2, k + 1, facets=2 * k + 2, why="two polygons and two triangles per side")
    yield Shape("pyramid-circle-24", "Pyramid over a regular 24-gon in nearest doubles: costs tie in mirror images, almost",
                [(*circle_point(i, 24), 0) for i in range(24)] + [(0, 0, 2)], ["valence", "ties"], 2, 8, facets=25, why="a base and a triangle per side")
    yield Shape("cone-32", "Pyramid over a 32-gon with points on its edges",
                [(*(F(r) * x for x in circle_point(i, 32)), 2 - 2 * r) for i in range(32) for r in (1, 0.5)] + [(0, 0, 2)],
                ["valence", "coplanar"], 2, 12, facets=33, why="a base and a triangle per side; the inner rings lie on edges")
    yield Shape("pyramid-parabola-201", "Pyramid of 201 sides: more than half of what one byte counts",
                [(x, y, 0) for x, y in parabola(100)] + [(0, 5000, 700)], ["valence", "coplanar"], 3, 0,
                parabola_area(100) * 700 / 3, 202, vertices=202, why="the polygon's area (4 n^3 - n)/3 with n = 100 times a third of the height 700")
    yield Shape("prism-parabola-301", "Prism with two facets of 301 corners: more than one byte counts",
                prism_over(parabola(150), 20000), ["parallel-edges", "valence", "coplanar"], 3, 0,
                parabola_area(150) * 20000, 303, vertices=602, why="the polygon's area (4 n^3 - n)/3 with n = 150 times the height 20000")
    hexagon = [(2, 0), (1, 2), (-1, 2), (-2, 0), (-1, -2), (1, -2)]
    yield Shape("hexagonal-prism", "Prism over a hexagon", prism_over(hexagon, 7), ["parallel-edges", "ties"], 1, 6,
                F(84), 8, "the hexagon's area 12 times the height 7")
    yield Shape("hexagonal-frustum", "Frustum over a hexagon", [(3 * x, 3 * y, 0) for x, y in hexagon] + [(x, y, 4) for x, y in hexagon],
                ["coplanar", "ties"], 1, 6, F(12 * 4 * (9 + 3 + 1), 3), 8, "height/3 (A + sqrt(A B) + B) with A = 9 * 12 and B = 12")
    yield Shape("sheared-prism", "Oblique prism over a hexagon", [(x, y, 0) for x, y in hexagon] + [(x + 5, y - 3, 4) for x, y in hexagon],
                ["parallel-edges", "coplanar"], 1, 6, F(48), 8, "shears keep the volume: area 12 times height 4")
    yield Shape("wedge", "Wedge: a roof of which one edge is parallel to the base", [(0, 0, 0), (6, 0, 0), (6, 4, 0), (0, 4, 0), (2, 2, 3), (3, 2, 3)],
                ["parallel-edges"], 1, 4, F(26), 5, "height * width (2 * base edge + roof edge)/6 = 3 * 4 * 13/6")
    yield Shape("integer-antiprism", "Antiprism over a square", [(2, 0, 0), (0, 2, 0), (-2, 0, 0), (0, -2, 0), (1, 1, 3), (-1, 1, 3), (-1, -1, 3), (1, -1, 3)],
                ["ties", "coplanar"], 1, 6, facets=10, why="two squares and eight triangles")


def boxes():
    yield Shape("brick", "Box of sides 3, 5, 7 with points on sides and edges and inside", box(3, 5, 7) + [(1, 0, 0), (2, 0, 0), (1, 1, 0), (3, 2, 4), (1, 2, 3), (0, 0, 6)],
                ["parallel-edges", "coplanar", "lattice", "unbounded"], 1, 4, F(105), 6, "3 * 5 * 7", costs=[], cost_why="no side of a box can go: what is left is unbounded")
    cuts = []
    for name, depths in (("one", [1]), ("two", [1, 2]), ("four", [1, 2, 3, 4]), ("ties", [2, 2, 2, 1]), ("eight", [1, 2, 3, 4, 4, 3, 2, 1])):
        cuts.append((name, depths))
    for name, depths in cuts:
        side = 10
        points = []
        for corner, (x, y, z) in enumerate(box(side, side, side)):
            if corner >= len(depths):
                points.append((x, y, z))
                continue
            d = depths[corner]
            points += [(x + (d if x == 0 else -d), y, z), (x, y + (d if y == 0 else -d), z), (x, y, z + (d if z == 0 else -d))]
        costs = sorted(F(d**3, 6) for d in depths)
        yield Shape(f"cut-cube-{name}", f"Cube of side 10 with corners cut at depths {depths}", points,
                    ["parallel-edges", "unbounded", "ties" if len(set(depths)) < len(depths) else "coplanar"], 1, 6, 1000 - sum(costs), 6 + len(depths),
                    "10^3 minus a corner of volume d^3/6 for each depth d", costs=costs, cost_why="each cut gives back its d^3/6; the least first")
    yield Shape("cut-brick-uneven", "Box with two corners cut by unequal legs", [(x, y, z) for x, y, z in box(8, 9, 10) if (x, y, z) not in ((0, 0, 0), (8, 9, 10))] +
                [(3, 0, 0), (0, 2, 0), (0, 0, 5), (8 - 4, 9, 10), (8, 9 - 1, 10), (8, 9, 10 - 2)], ["parallel-edges", "unbounded"], 1, 4, 720 - F(30 + 8, 6), 8,
                "8 * 9 * 10 minus corners of volume 3 * 2 * 5/6 and 4 * 1 * 2/6", costs=[F(8, 6), F(30, 6)], cost_why="the cuts give back what they took; then no side of a box can go")
    for half, radius, steps, level, k in (((1, 2, 3), 0.5, 1, 1, 12), ((1, 1, 1), 0.25, 2, 2, 24), ((3, 2, 2), 0.75, 2, 2, 20)):
        yield Shape(f"rounded-box-{steps}-{half[0]}{half[1]}{half[2]}", f"Rounded box, {steps} steps per octant, in nearest doubles", rounded_box(half, radius, steps),
                    ["parallel-edges", "near-coplanar" if steps > 1 else "coplanar"], level, k if steps == 1 else 0)
    yield Shape("chamfered-brick", "Box with flat edges and corners", sorted({q for p in ((4, 5, 8), (3, 6, 8), (3, 5, 9)) for q in signs(p)}),
                ["parallel-edges", "coplanar"], 1, 6, facets=26, why="6 rectangles, 12 bevels, 8 triangles")
    yield Shape("parallelepiped", "Sheared box", zonotope([(3, 1, 0), (0, 4, 1), (2, 0, 5)]), ["parallel-edges", "unbounded"], 1, 4,
                F(zonotope_volume([(3, 1, 0), (0, 4, 1), (2, 0, 5)])), 6, "the determinant of its three edges", costs=[], cost_why="no side of a parallelepiped can go")


def zonotopes():
    sets = {
        "four": [(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1)],
        "five": [(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 2, 0), (0, 1, 3)],
        "six-of-a-cube": [(1, 1, 0), (1, -1, 0), (1, 0, 1), (1, 0, -1), (0, 1, 1), (0, 1, -1)],
        "generic-four": [(5, 1, 2), (-1, 7, 3), (2, -2, 9), (4, 4, -3)],
        "generic-five": [(5, 0, 2), (-1, 6, 3), (1, -2, 8), (4, 3, -3), (-2, 3, 5)],
    }
    for name, generators in sets.items():
        yield Shape(f"zonotope-{name}", f"Sum of {len(generators)} segments", zonotope(generators), ["parallel-edges", "lattice", "ties"],
                    1 if len(generators) < 5 else 2, 6, F(zonotope_volume(generators)), why="the sum of |det| over all triples of segments")


def lattices():
    for square in (5, 6, 8, 11):
        r = 4
        yield Shape(f"lattice-ball-{square}", f"All integer points with x^2 + y^2 + z^2 <= {square}",
                    [p for p in product(range(-r, r + 1), repeat=3) if sum(x * x for x in p) <= square], ["lattice", "coplanar", "ties"], 2, 8)
    for seed, count, most in ((1, 12, 2), (2, 20, 2), (3, 30, 3), (4, 14, 5), (5, 16, 9), (6, 24, 4), (7, 40, 3)):
        yield Shape(f"lattice-random-{seed}", f"{count} random integer points of [-{most}, {most}]^3", random_lattice(seed, count, most), ["lattice", "coplanar"], 2, 6)
    for n in (2, 3):
        points = [p for p in product(range(n + 1), repeat=3) if sum(p) <= n + 1]
        yield Shape(f"lattice-corner-{n}", f"Integer points of the cube [0, {n}]^3 with x + y + z <= {n + 1}", points, ["lattice", "coplanar"], 2, 4)
    yield Shape("lattice-simplex-6", "All integer points of the simplex x, y, z >= 0, x + 2 y + 3 z <= 6", [p for p in product(range(7), repeat=3) if p[0] + 2 * p[1] + 3 * p[2] <= 6],
                ["lattice", "coplanar", "unbounded"], 2, 4, F(6), 4, "legs 6, 3, 2: 36/6", costs=[], cost_why="a simplex has four sides")


def spheres():
    for square in (9, 14, 17, 21, 26, 29, 41):
        points = sphere_points(square)
        yield Shape(f"sphere-{square}", f"All {len(points)} integer points with x^2 + y^2 + z^2 = {square}", points, ["cospherical", "lattice", "ties", "coplanar"], 2,
                    8 if square in (9, 14, 17, 21) else 0)
    for square, modulus in ((26, 3), (29, 4), (54, 5), (89, 7), (101, 11)):
        points = sphere_points(square, lambda index, m=modulus: index % m == 1)
        yield Shape(f"sphere-{square}-part", f"{len(points)} integer points with x^2 + y^2 + z^2 = {square}, no symmetry left", points, ["cospherical", "lattice"], 2, 10)
    for count in (6, 9, 12, 16, 20):
        points = [(t, t * t, t**3) for t in range(-(count // 2), count - count // 2)]
        yield Shape(f"moment-curve-{count}", f"{count} points (t, t^2, t^3): a cyclic polytope", points, ["valence", "lattice"], 2, 4 + count // 3,
                    facets=2 * count - 4, why="2n - 4 triangles, by Gale's evenness")


def simplex(a, b, c):
    return [(0, 0, 0), (a, 0, 0), (a, b, 0), (a, b, c)]


def thin():
    """Needles and slabs: lengths that differ by 1e3 to 1e300."""
    for name, a, level in (("1e3", 1000, 2), ("1e8", 10**8, 2), ("2-52", 2**52, 3), ("1e16", 10**16, 3), ("1e100", F(float(10**100)), 3)):
        a = F(a)
        yield Shape(f"needle-simplex-{name}", f"Simplex of legs {name}, 2, 3", simplex(a, 2, 3), ["needle"], level, 4, a, 4, "a * 2 * 3/6")
        yield Shape(f"slab-simplex-{name}", f"Simplex of legs 5, {name}, {name}", simplex(5, a, a), ["slab"], level, 4, 5 * a * a / 6, 4, "5 * a * a/6")
    for name, a, level in (("1e5", 10**5, 2), ("2-40", 2**40, 2), ("2-200", 2**200, 3), ("2-900", 2**900, 3)):
        hexagon = [(2, 0), (1, 3), (-1, 3), (-2, 0), (-1, -3), (1, -3)]
        yield Shape(f"needle-prism-{name}", f"Prism of height {name} over a hexagon", prism_over(hexagon, a), ["needle", "parallel-edges"], level, 6, F(18) * a, 8, "the hexagon's area 18 times the height")
        octagon = [(3, 1), (1, 3), (-1, 3), (-3, 1), (-3, -1), (-1, -3), (1, -3), (3, -1)]
        yield Shape(f"slab-octagon-{name}", f"Octagonal frustum of height 1 and width {name}", [(a * x, a * y, 0) for x, y in octagon] + [(a * x / F(2), a * y / F(2), 1) for x, y in octagon],
                    ["slab", "coplanar"], level, 6, F(28) * a * a * F(7, 12), 10, "height/3 (A + A/2 + A/4) with A = 28 a^2")
    for seed, power, level in ((11, 20, 2), (12, 60, 3), (13, 300, 3), (14, 900, 3)):
        points = random_lattice(seed, 12, 50)
        yield Shape(f"needle-random-2-{power}", f"Random integer points stretched by 2^{power} along x", stretched(points, (2**power, 1, 1)), ["needle"], level, 8)
        points = random_lattice(seed + 10, 12, 50)
        yield Shape(f"slab-random-2-{power}", f"Random integer points flattened by 2^-{power} along z", stretched(points, (1, 1, F(1, 2**power))), ["slab"], level, 8)
    yield Shape("needle-oblique", "Needle along (1, 2, 3) of length 1e10 and width 1", exact([(0, 0, 0), (1, 0, 0), (0, 1, 0), (10**10, 2 * 10**10, 3 * 10**10), (10**10 + 1, 2 * 10**10, 3 * 10**10), (10**10, 2 * 10**10 + 1, 3 * 10**10)]),
                ["needle", "parallel-edges"], 3, 4)
    yield Shape("slab-oblique", "Slab across (1, 1, 1), 1 thick and 1e9 wide", exact([(10**9, -10**9, 0), (0, 10**9, -10**9), (-10**9, 0, 10**9), (10**9 + 1, -10**9, 0), (0, 10**9 + 1, -10**9), (-10**9, 1, 10**9)]),
                ["slab"], 3, 4)


def far():
    for seed, power, level in ((31, 20, 2), (32, 30, 2), (33, 40, 2), (34, 50, 3), (35, 52, 3)):
        away = (2**power, -2**power, 2**power - 1)
        yield Shape(f"offset-lattice-2-{power}", f"Random integer points, 2^{power} from the origin", shifted(exact(random_lattice(seed, 14, 7)), away), ["offset"], level, 6)
    for seed, distance, level in ((41, 10**6, 2), (42, 10**8, 2), (43, 10**12, 3), (44, 10**15, 3)):
        points = rounded(shifted(random_ball(seed, 14), (distance, 3 * distance, -2 * distance)))
        yield Shape(f"offset-ball-{len(str(distance)) - 1}", f"Random points of the unit ball, rounded at a distance of 10^{len(str(distance)) - 1}", points, ["offset", "lattice" if distance == 10**15 else "near-coplanar"], level, 6)
    yield Shape("offset-one-axis", "Octahedron with one long way to the origin", [(2**40 + x, 3 * y, 5 * z) for x, y, z in cyclic_images((1, 0, 0))], ["offset", "ties"], 2, 4,
                F(4, 3) * 15, 8, "4/3 a b c with half-axes 1, 3, 5")


def scaled():
    for seed, power, level in ((51, 100, 2), (52, -100, 2), (53, 300, 3), (54, -300, 3), (55, 600, 3), (56, -600, 3), (57, 1000, 3), (58, -1000, 3)):
        points = stretched(exact(random_lattice(seed, 13, 20)), [F(2)**power] * 3)
        yield Shape(f"scale-2^{power}".replace("^", "-to-"), f"Random integer points times 2^{power}", points, ["scale"], level, 6)
    for name, a, b, c, level in (("1e150", 1e150, 3e150, 2e150, 3), ("1e-150", 1e-150, 5e-150, 2e-150, 3), ("1e300", 1e300, 1e300, 7e299, 3), ("1e-300", 3e-300, 1e-300, 1e-300, 3)):
        a, b, c = F(a), F(b), F(c)
        yield Shape(f"scale-simplex-{name}", f"Simplex with legs near {name}, whose volume no double holds", simplex(a, b, c), ["scale"], level, 4, a * b * c / 6, 4, "a b c/6 of the legs as doubles")
    least = F(1, 2**1074)
    for seed, most in ((61, 2), (62, 5), (63, 9), (64, 50), (65, 1000), (66, 2**30)):
        points = stretched(exact(random_lattice(seed, 12, most)), [least] * 3)
        yield Shape(f"subnormal-{seed}", f"Random multiples up to {most} of the least positive double", points, ["subnormal", "scale"], 3, 6)
    yield Shape("subnormal-simplex", "Simplex with legs 1, 2 and 5 times the least positive double", stretched(simplex(1, 2, 5), [least] * 3), ["subnormal", "scale"], 3, 4,
                F(10, 6) * least**3, 4, "a b c/6")
    yield Shape("subnormal-slab", "Box 1 x 3 and as thick as the least positive double", box(1, 3, least), ["subnormal", "slab", "mixed", "parallel-edges"], 3, 4, 3 * least, 6, "a b c", costs=[], cost_why="no side of a box can go")
    yield Shape("subnormal-edge", "Wedge whose roof edge is the least positive double wide", [(0, 0, 0), (7, 0, 0), (7, 4, 0), (0, 4, 0), (2, 2, 3), (2 + F(0), 2, 3), (0, 2, least)], ["subnormal", "mixed"], 3, 4)
    yield Shape("subnormal-to-normal", "Octahedron across the border of subnormal numbers", stretched(exact(cyclic_images((1, 0, 0)) + [(1, 1, 1)]), [F(1, 2**1022)] * 3), ["subnormal", "scale"], 3, 6)


def mixed():
    for name, a, b, c in (("500", F(2)**500, F(1), F(1, 2**500)), ("1000", F(2)**1000, F(1), F(1, 2**1000)), ("300", F(1e300), F(1e-300), F(1)), ("30", F(1e30), F(1e-20), F(1e5))):
        yield Shape(f"mixed-simplex-{name}", f"Simplex with legs of very different magnitude ({name})", simplex(a, b, c), ["mixed", "needle"], 3, 4, a * b * c / 6, 4, "a b c/6 of the legs as doubles")
        yield Shape(f"mixed-octahedron-{name}", f"Octahedron with half-axes of very different magnitude ({name})", [tuple(F(s) * l * e for l, e in zip((a, b, c), axis)) for axis in ((1, 0, 0), (0, 1, 0), (0, 0, 1)) for s in (1, -1)] ,
                    ["mixed", "ties"], 3, 4, F(4, 3) * a * b * c, 8, "4/3 a b c of the half-axes as doubles", costs=[a * b * c / 3] * 4, cost_why="each removed face gains a tetrahedron of a b c/3")
    for seed, most in ((71, 30), (72, 100), (73, 300), (74, 900)):
        draw, points = Draw(seed), []
        for p in random_lattice(seed, 11, 9):
            points.append(tuple(F(x) * F(2)**draw.integer(most) for x in p))
        yield Shape(f"mixed-random-2-{most}", f"Random integers, each times its own power of two up to 2^{most}", points, ["mixed"], 3, 6)
    yield Shape("mixed-corner", "A cube with one corner cut at depth 2^-60", [p for p in exact(box(1, 1, 1)) if p != (0, 0, 0)] + [(F(1, 2**60), 0, 0), (0, F(1, 2**60), 0), (0, 0, F(1, 2**60))],
                ["mixed", "parallel-edges", "unbounded"], 3, 4, 1 - F(1, 6 * 2**180), 7, "1 minus 2^-180/6", costs=[F(1, 6 * 2**180)], cost_why="the cut gives back 2^-180/6; then no side of a box can go")


def repeated():
    cuboid = box(2, 3, 4)
    yield Shape("duplicates-brick", "Every corner of a box three times", [p for p in cuboid for _ in range(3)], ["duplicates", "parallel-edges"], 1, 4, F(24), 6, "2 * 3 * 4", costs=[], cost_why="no side of a box can go")
    yield Shape("duplicates-simplex", "A simplex of which one corner comes forty times", simplex(3, 5, 7) + [(3, 5, 7)] * 39, ["duplicates"], 1, 4, F(105, 6), 4, "3 * 5 * 7/6", costs=[], cost_why="a simplex has four sides")
    yield Shape("duplicates-interior", "An octahedron with its centre thirty times", exact(cyclic_images((3, 0, 0)) + [(0, 0, 0)] * 30), ["duplicates", "ties"], 1, 4, F(36), 8, "4/3 * 3^3", costs=[F(9)] * 4, cost_why="each removed face gains a tetrahedron of 3^3/3")
    for seed, count, most in ((81, 10, 4), (82, 12, 6), (83, 8, 30), (84, 14, 3)):
        points = random_lattice(seed, count, most)
        yield Shape(f"duplicates-random-{seed}", f"{count} random integer points, each twice, in two orders", points + points[::-1], ["duplicates", "lattice"], 2, 5)
    ball = random_ball(85, 9)
    yield Shape("duplicates-ball", "Random points of a ball, the first of them seven times", ball + [ball[0]] * 6, ["duplicates"], 2, 6)
    yield Shape("duplicates-edge", "A tetrahedron with doubled points in the middle of every edge", [(8, 8, 8), (8, -8, -8), (-8, 8, -8), (-8, -8, 8)] + 2 * all_images((8, 0, 0)), ["duplicates", "coplanar"], 1, 4,
                F(8**3 * 8, 3), 4, "a cube of side 16 minus four corners: a third of it", costs=[], cost_why="a simplex has four sides")
    prism = prism_over(parabola(2), 5)
    yield Shape("duplicates-prism", "A prism twice, and once more shifted inside itself", prism + prism + [(0, 1, 1), (0, 1, 1), (0, 2, 2), (0, 2, 2)], ["duplicates", "parallel-edges"], 1, 6, parabola_area(2) * 5, 7, "the polygon's area 10 times the height 5")


def nearly():
    cube = exact(box(1, 1, 1))
    top = [i for i, p in enumerate(cube) if p == (1, 1, 1)][0]
    for ulps in (1, -1, 3, -1000):
        yield Shape(f"near-cube-{'up' if ulps > 0 else 'down'}-{abs(ulps)}", f"A cube of which one corner is {abs(ulps)} ulp{'s' if abs(ulps) > 1 else ''} {'above' if ulps > 0 else 'below'} its side",
                    nudged(cube, top, 2, ulps), ["near-coplanar"], 2, 6)
    for seed, ulps in ((91, 1), (92, 2), (93, 5)):
        draw = Draw(seed)
        lid = [(F(draw.below(1000), 1024), F(draw.below(1000), 1024), 1 + F(draw.below(ulps + 1), 2**52)) for _ in range(10)]
        yield Shape(f"near-lid-{ulps}", f"A pyramid under ten points that are within {ulps} ulp{'s' if ulps > 1 else ''} of a plane", lid + [(F(1, 2), F(1, 2), F(0))], ["near-coplanar", "valence"], 3, 5)
    for k, ulps in ((6, 1), (9, 1), (12, 2)):
        polygon = [circle_point(i, k) for i in range(k)]
        points = exact([(c, s, 1) for c, s in polygon] + [(2 * c, 2 * s, 0) for c, s in polygon])
        for i in range(0, k, 2):
            points = nudged(points, i, 2, ulps)
        yield Shape(f"near-frustum-{k}", f"Frustum over a {k}-gon, every second upper corner {ulps} ulp{'s' if ulps > 1 else ''} too high", points, ["near-coplanar", "ties"], 3, k)
    yield Shape("near-collinear-edge", "A simplex with a point one ulp off the middle of an edge", nudged(exact(simplex(4, 4, 4) + [(2, 0, 0)]), 4, 1, -1), ["near-coplanar", "mixed"], 3, 4)
    yield Shape("near-facet-centre", "An octahedron with a point one ulp above the middle of a face", exact(cyclic_images((3, 0, 0))) + nudged(exact([(1, 1, 1)]), 0, 0, 1), ["near-coplanar"], 3, 6)
    yield Shape("near-thirds", "A plane of slope 1/3 in nearest doubles", rounded([(x, y, F(x + y, 3)) for x in range(4) for y in range(4)]) + [(F(1), F(1), F(-5))], ["near-coplanar", "lattice"], 3, 5)
    yield Shape("near-tie", "A cube of side 1 with two corners cut, one deeper by one ulp of 1/4", [p for p in cube if p not in ((0, 0, 0), (1, 1, 1))] +
                exact([(0.25, 0, 0), (0, 0.25, 0), (0, 0, 0.25)]) + [(1 - F(1, 4) - F(1, 2**53), 1, 1), (1, 1 - F(1, 4) - F(1, 2**53), 1), (1, 1, 1 - F(1, 4) - F(1, 2**53))],
                ["near-coplanar", "parallel-edges", "unbounded"], 3, 4, 1 - F(1, 384) - (F(1, 4) + F(1, 2**53))**3 / 6, 8, "1 minus d^3/6 for both depths",
                costs=[F(1, 384), (F(1, 4) + F(1, 2**53))**3 / 6], cost_why="the cuts give back d^3/6; they differ by about 1e-17 of themselves")


def everyday():
    """Random solids of ordinary proportions."""
    for seed, count in ((101, 8), (102, 10), (103, 12), (104, 14), (105, 16), (106, 18)):
        yield Shape(f"random-ball-{count}", f"{count} random points of the unit ball", random_ball(seed, count), [], 1, 6)
    for a, b, c in ((1, 2, 3), (2, 3, 7)):
        yield Shape(f"cross-polytope-{a}{b}{c}", f"Octahedron with half-axes {a}, {b}, {c}", [tuple(s * l * e for l, e in zip((a, b, c), axis)) for axis in ((1, 0, 0), (0, 1, 0), (0, 0, 1)) for s in (1, -1)], ["ties"], 1, 4,
                    F(4 * a * b * c, 3), 8, "4/3 a b c", costs=[F(a * b * c, 3)] * 4, cost_why="each removed face gains a tetrahedron of a b c/3")
    yield Shape("cross-polytope-uneven", "Cross-polytope whose six arms have lengths 1 to 6", [(1, 0, 0), (-2, 0, 0), (0, 3, 0), (0, -4, 0), (0, 0, 5), (0, 0, -6)], [], 1, 4, F(3 * 7 * 11, 6), 8, "(1 + 2)(3 + 4)(5 + 6)/6")
    yield Shape("simplex-235", "Simplex with legs 2, 3, 5", simplex(2, 3, 5), [], 1, 4, F(5), 4, "2 * 3 * 5/6", costs=[], cost_why="a simplex has four sides")
    yield Shape("gem", "A cut gem: table, crown and pavilion", [(3 * c, 3 * s, 0) for c, s in ((1, 0), (0, 1), (-1, 0), (0, -1))] + [(1, 1, 1), (-1, 1, 1), (-1, -1, 1), (1, -1, 1), (0, 0, -4)], ["ties"], 1, 6)
    yield Shape("house", "A box with a roof", box(4, 6, 3) + [(2, 1, 5), (2, 5, 5)], ["coplanar"], 1, 5, facets=9, why="five sides of the box and four of the hipped roof")


def all_shapes():
    for family in (regular_solids, everyday, over_polygons, boxes, zonotopes, lattices, spheres, thin, far, scaled, mixed, repeated, nearly):
        for shape in family():
            shape.points = exact(shape.points)
            yield shape
