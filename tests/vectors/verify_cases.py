# SPDX-License-Identifier: MIT
"""Candidates to be verified, with what the definition says of them."""
from collections import Counter
from fractions import Fraction as F

from exact_geometry import (
    Surface,
    as_integers,
    cross,
    determinant,
    dimension,
    dot,
    farthest_outside,
    hull_planes,
    minus,
    primitive_plane,
)
from shapes import (
    all_images,
    box,
    exact,
    nudged,
    parabola,
    prism_over,
    random_ball,
    random_lattice,
    shifted,
    sphere_points,
    stretched,
)


def hull_mesh(points):
    """The hull's vertices, and its facets as rings of indices, counter-clockwise from outside."""
    planes = list(hull_planes(points))
    distinct = sorted(set(points))
    homogeneous = []
    for p in distinct:
        (row,), w = as_integers([p])
        homogeneous.append((*row, w))
    surface = Surface(planes, homogeneous)
    vertices = []
    for v in range(len(distinct)):
        normals = [plane[:3] for j, plane in enumerate(planes) if surface.tight[v] >> j & 1]
        if any(determinant(a, b, c) for a in normals for b in normals for c in normals):
            vertices.append(v)
    rings = []
    for j, plane in enumerate(planes):
        ring = surface.ring([v for v in vertices if surface.tight[v] >> j & 1], surface.all_alive() & ~(1 << j))
        a, b, c = (distinct[v] for v in ring[:3])
        if dot(cross(minus(b, a), minus(c, a)), plane[:3]) < 0:
            ring = [ring[0]] + ring[:0:-1]
        rings.append([vertices.index(v) for v in ring])
    return [distinct[v] for v in vertices], rings


def edges_of(faces):
    return Counter((face[i - 1], face[i]) for face in faces for i in range(len(face)))


def is_closed(faces):
    """Each edge, direction aside, belongs to exactly two faces."""
    count = Counter()
    for (a, b), n in edges_of(faces).items():
        count[min(a, b), max(a, b)] += n
    return all(n == 2 for n in count.values())


def is_plane(corners):
    return dimension(corners) == 2


def status(holds):
    return "holds" if holds else "violated"


def judged_mesh(points, vertices, faces, extra=None):
    """What the definition says of a mesh that stands for the hull of its vertices."""
    planes = list(hull_planes(vertices))
    outside, worst = farthest_outside(planes, points)
    claims = {
        "candidate-readable": "holds",
        "candidate-finite": "holds",
        "candidate-solid": "holds",
        "candidate-bounded": "holds",
        "mesh-closed": status(is_closed(faces)),
        "mesh-planar": status(all(is_plane([vertices[v] for v in face]) for face in faces)),
        "contains-input": status(outside == 0),
    }
    claims.update(extra or {})
    return {"claims": claims, "outside": {"points": outside, "squared_distance": worst}}


def judged_planes(points, rows, extra):
    outside, worst = farthest_outside([primitive_plane(row) for row in rows], points)
    claims = {"candidate-readable": "holds", "candidate-finite": "holds", "contains-input": status(outside == 0)}
    claims.update(extra)
    return {"claims": claims, "outside": {"points": outside, "squared_distance": worst}}


def bases():
    """Inputs with the flags and the level of what is asked about them."""
    yield "octahedron", "An octahedron", exact(all_images((3, 0, 0)) + [(1, 0, 1)]), ["ties", "valence"], 1
    yield "brick", "A box", exact(box(2, 5, 9) + [(1, 1, 1)]), ["parallel-edges", "coplanar"], 1
    yield "prism", "A prism over five points of a parabola", exact(prism_over(parabola(2), 11)), [
        "parallel-edges",
        "coplanar",
    ], 1
    yield "ball", "Random points of a ball", random_ball(201, 16), [], 1
    yield "lattice", "Random integer points", exact(random_lattice(202, 15, 4)), ["lattice", "coplanar"], 2
    yield "sphere", "Integer points of a sphere", exact(sphere_points(30, lambda index: index % 3 == 0)), [
        "cospherical",
        "lattice",
    ], 2
    yield "needle", "A needle of aspect 2^70", exact(stretched(random_lattice(203, 10, 30), (2**70, 1, 1))), [
        "needle"
    ], 3
    yield "slab", "A slab of aspect 2^70", exact(stretched(random_lattice(204, 10, 30), (1, 1, F(1, 2**70)))), [
        "slab"
    ], 3
    yield "offset", "Random points far from the origin", shifted(
        exact(random_lattice(205, 12, 6)), (2**44, 2**45, -(2**44))
    ), ["offset"], 3
    yield "large", "Random points times 2^400", stretched(exact(random_lattice(206, 10, 11)), [F(2) ** 400] * 3), [
        "scale"
    ], 3
    yield "subnormal", "Random multiples of the least positive double", stretched(
        exact(random_lattice(207, 10, 12)), [F(1, 2**1074)] * 3
    ), ["subnormal", "scale"], 3
    yield "repeated", "Random integer points, each three times", exact(random_lattice(208, 9, 5) * 3), ["duplicates"], 2


def move_inward(points, vertices, ulps=1):
    """The first vertex with a coordinate that can be moved towards the middle, moved by an ulp."""
    middle = [sum(p[k] for p in vertices) / len(vertices) for k in range(3)]
    vertex, axis = max(
        ((v, k) for v in range(len(vertices)) for k in range(3)),
        key=lambda vk: (abs(vertices[vk[0]][vk[1]] - middle[vk[1]]), -vk[0]),
    )
    direction = 1 if vertices[vertex][axis] < middle[axis] else -1
    return nudged(vertices, vertex, axis, direction * ulps)


def verify_cases():
    """Yields name, title, input, candidate, request, expected, flags, level, why."""
    for name, title, points, flags, level in bases():
        vertices, faces = hull_mesh(points)
        planes = list(hull_planes(points))
        mesh = lambda v, f: {"points": v, "faces": f}
        whole = {"mesh-oriented": "holds", "mesh-convex": "holds"}
        facets, corners, most = len(faces), len(vertices), max(len(face) for face in faces)

        yield (
            f"{name}-hull",
            f"{title}: its own hull, budgets just met",
            points,
            mesh(vertices, faces),
            {"max_facets": facets, "max_vertices": corners, "max_facet_vertices": most},
            judged_mesh(
                points,
                vertices,
                faces,
                whole | {"max-facets": "holds", "max-vertices": "holds", "max-facet-vertices": "holds"},
            ),
            flags,
            level,
            "the facets of the hull by definition contain every point; their numbers are the budgets",
        )
        yield (
            f"{name}-budgets",
            f"{title}: its own hull, every budget one too small",
            points,
            mesh(vertices, faces[1:] + faces[:1]),
            {"max_facets": facets - 1, "max_vertices": corners - 1, "max_facet_vertices": most - 1}
            if most > 3
            else {"max_facets": facets - 1, "max_vertices": corners - 1},
            judged_mesh(
                points,
                vertices,
                faces,
                whole
                | {"max-facets": "violated", "max-vertices": "violated"}
                | ({"max-facet-vertices": "violated"} if most > 3 else {}),
            ),
            flags,
            level,
            "counted by definition",
        )
        inside = move_inward(points, vertices)
        yield (
            f"{name}-one-ulp",
            f"{title}: one corner of its hull moved inward by one ulp",
            points,
            mesh(inside, faces),
            {},
            judged_mesh(points, inside, faces),
            flags,
            level,
            "every input point against every facet plane of the candidate's hull, in fractions",
        )
        yield (
            f"{name}-hole",
            f"{title}: its own hull without its last face",
            points,
            mesh(vertices, faces[:-1]),
            {},
            judged_mesh(points, vertices, faces[:-1], {"mesh-closed": "violated"}),
            flags,
            level,
            "the edges of the missing face belong to one face only; the corners are all there",
        )
        yield (
            f"{name}-one-reversed",
            f"{title}: its own hull with the first face reversed",
            points,
            mesh(vertices, [faces[0][::-1]] + faces[1:]),
            {},
            judged_mesh(points, vertices, faces, {"mesh-oriented": "violated", "mesh-closed": "holds"}),
            flags,
            level,
            "one face looks inward; every edge still has two faces",
        )
        yield (
            f"{name}-inside-out",
            f"{title}: its own hull inside out",
            points,
            mesh(vertices, [face[::-1] for face in faces]),
            {},
            judged_mesh(points, vertices, faces, {"mesh-oriented": "violated", "mesh-closed": "holds"}),
            flags,
            level,
            "all faces look inward",
        )
        rows = [list(plane) for plane in planes]
        yield (
            f"{name}-planes",
            f"{title}: the planes of its hull",
            points,
            {"halfspaces": rows},
            {"max_facets": facets},
            judged_planes(
                points, rows, {"candidate-solid": "holds", "candidate-bounded": "holds", "max-facets": "holds"}
            ),
            flags,
            level,
            "the facet planes by definition",
        )
        tight = [row[:] for row in rows]
        tight[0] = [F(x) for x in tight[0]]
        tight[0][3] += abs(tight[0][3]) / 2**60 or F(1, 2**60)
        yield (
            f"{name}-plane-pushed",
            f"{title}: one plane of its hull pushed inward by 2^-60 of its offset",
            points,
            {"halfspaces": tight},
            {},
            judged_planes(points, tight, {"candidate-solid": "holds", "candidate-bounded": "holds"}),
            flags,
            level,
            "every input point against every plane, in fractions",
        )
        least = [min(p[k] for p in points) for k in range(3)]
        most_ = [max(p[k] for p in points) for k in range(3)]
        walls = [
            [-1, 0, 0, least[0]],
            [1, 0, 0, -most_[0]],
            [0, -1, 0, least[1]],
            [0, 1, 0, -most_[1]],
            [0, 0, -1, least[2]],
            [0, 0, 1, -most_[2]],
        ]
        if name != "brick":
            yield (
                f"{name}-walls",
                f"{title}: the walls of its bounding box",
                points,
                {"halfspaces": walls},
                {"max_facets": 6, "max_vertices": 8, "max_facet_vertices": 4},
                judged_planes(
                    points,
                    walls,
                    {
                        "candidate-solid": "holds",
                        "candidate-bounded": "holds",
                        "max-facets": "holds",
                        "max-vertices": "holds",
                        "max-facet-vertices": "holds",
                    },
                ),
                flags,
                level,
                "a box has 6 facets of 4 corners, and 8 vertices",
            )
        yield (
            f"{name}-five-walls",
            f"{title}: five walls of its bounding box",
            points,
            {"halfspaces": walls[:5]},
            {},
            judged_planes(points, walls[:5], {"candidate-bounded": "violated", "candidate-solid": "holds"}),
            flags + ["unbounded"],
            level,
            "the direction (0, 0, 1) leaves no wall behind",
        )
        flat = [tuple([p[0], p[1], least[2]]) for p in vertices]
        if dimension(flat) == 2:
            yield (
                f"{name}-flattened",
                f"{title}: its hull flattened",
                points,
                mesh(flat, faces),
                {},
                {"claims": {"candidate-readable": "holds", "candidate-finite": "holds", "candidate-solid": "violated"}},
                flags + ["flat"],
                level,
                "all corners have the same z",
            )


def text_of_obj(vertices, faces, last=""):
    lines = ["v " + " ".join(repr(float(x)) for x in p) for p in vertices] + [
        "f " + " ".join(str(v + 1) for v in face) for face in faces
    ]
    return "\n".join(lines) + "\n" + last


def broken_candidates():
    """Candidates whose bytes are no solid, for one input each."""
    points = exact([(0, 0, 0), (7, 0, 0), (0, 6, 0), (0, 0, 5), (1, 1, 1)])
    vertices, faces = hull_mesh(points)
    good = text_of_obj(vertices, faces)
    readable = lambda code: {"claims": {code: "violated"}}
    for name, what, text, form, code in (
        ("nan", "NaN for a coordinate", good.replace("7.0", "nan"), "obj", "candidate-finite"),
        ("infinity", "infinity for a coordinate", good.replace("7.0", "inf"), "obj", "candidate-finite"),
        ("overflow", "a coordinate beyond the largest double", good.replace("7.0", "7e308"), "obj", "candidate-finite"),
        ("index", "a face that names a fifth corner", good.replace("f 1 ", "f 5 ", 1), "obj", "candidate-readable"),
        (
            "truncated",
            "the end of the file cut off",
            good[:-5] if good[-5:-1].count(" ") == 2 else good.rsplit(" ", 1)[0].rsplit(" ", 1)[0],
            "obj",
            "candidate-readable",
        ),
        ("binary", "bytes that are no text", "\x00\x01\x02\x7f\x00", "obj", "candidate-readable"),
        ("no-points", "an empty file", "", "obj", "candidate-solid"),
        ("one-point", "one point", "v 1 1 1\n", "obj", "candidate-solid"),
        (
            "off-count",
            "an OFF file with one point fewer than announced",
            "OFF\n5 0 0\n0 0 0\n7 0 0\n0 6 0\n0 0 5\n",
            "off",
            "candidate-readable",
        ),
        ("rows-three", "rows of three numbers", "1 0 0\n0 1 0\n0 0 1\n", "txt", "candidate-readable"),
        ("json-null", "null for a number", '{"halfspaces": [[1, 0, null, -9]]}', "json", "candidate-readable"),
        (
            "contradiction",
            "halfspaces that nothing satisfies",
            '{"halfspaces": [[1,0,0,1],[-1,0,0,0],[0,1,0,-9],[0,-1,0,0],[0,0,1,-9],[0,0,-1,0]]}',
            "json",
            "candidate-solid",
        ),
        (
            "sheet",
            "halfspaces that leave a square only",
            '{"halfspaces": [[1,0,0,-1],[-1,0,0,1],[0,1,0,-9],[0,-1,0,0],[0,0,1,-9],[0,0,-1,0]]}',
            "json",
            "candidate-solid",
        ),
    ):
        flags = ["flat"] if code == "candidate-solid" else ["malformed"]
        yield f"candidate-{name}", f"A candidate with {what}", points, {"text": text, "format": form}, {}, readable(
            code
        ), flags, 2, "the file formats: " + what


def dented():
    """An octahedron with a dent in each of some faces: closed and oriented, not convex."""
    points = exact(all_images((6, 0, 0)))
    vertices, faces = hull_mesh(points)
    for name, count, depth in (("one", 1, F(1)), ("all", 8, F(3, 2))):
        new_vertices, new_faces = list(vertices), []
        for index, face in enumerate(faces):
            if index >= count:
                new_faces.append(face)
                continue
            dent = tuple(sum(vertices[v][k] for v in face) / 3 * depth / 2 for k in range(3))
            new_vertices.append(dent)
            new_faces += [[face[i - 1], face[i], len(new_vertices) - 1] for i in range(3)]
        yield (
            f"dented-{name}",
            f"An octahedron with {count} dent{'s' if count > 1 else ''}",
            points,
            {"points": new_vertices, "faces": new_faces},
            {"max_facets": 8},
            judged_mesh(
                points,
                new_vertices,
                new_faces,
                {"mesh-oriented": "holds", "mesh-convex": "violated", "max-facets": "holds"},
            ),
            ["ties"],
            2,
            "the dents lie strictly inside the hull of the corners, so the faces are not its surface",
        )
    cube = exact(box(4, 4, 4))
    vertices, faces = hull_mesh(cube)
    bent = nudged(vertices, vertices.index((4, 4, 4)), 2, 1)
    yield (
        "bent-side",
        "A cube one corner of which is an ulp too high: its quadrilaterals are not plane",
        cube,
        {"points": bent, "faces": faces},
        {},
        judged_mesh(cube, bent, faces, {"mesh-planar": "violated"}),
        ["near-coplanar", "coplanar"],
        3,
        "four corners of a side span a volume",
    )
    spread = [tuple(x * 5 for x in p) for p in exact(all_images((1, 1, 1)))]
    outer, rings = hull_mesh(spread)
    ball = random_ball(301, 40)
    yield (
        "cube-around-ball",
        "A cube around random points of the unit ball",
        ball,
        {"points": outer, "faces": rings},
        {"max_facets": 6, "max_vertices": 8},
        judged_mesh(
            ball,
            outer,
            rings,
            {"mesh-oriented": "holds", "mesh-convex": "holds", "max-facets": "holds", "max-vertices": "holds"},
        ),
        [],
        1,
        "each point has coordinates of at most 1, the cube's sides are at 5",
    )


def sharp_edges():
    """Points that are close to every plane of a candidate and far from the candidate itself."""
    slope = F(1, 2**20)
    sides = [(-slope, 0, 1, 0), (-slope, 0, -1, 0)]
    for name, what, input_point, rows, corners, distance in (
        (
            "wedge",
            "A wedge, and a point half a unit before its edge",
            (F(-1, 2), 0, 0),
            sides + [(1, 0, 0, -1), (0, 1, 0, -1), (0, -1, 0, -1)],
            [(0, -1, 0), (0, 1, 0)] + [(1, y, z) for y in (-1, 1) for z in (-slope, slope)],
            F(1, 4),
        ),
        (
            "spike",
            "A spike, and a point a quarter of a unit before its tip",
            (F(-1, 4), 0, 0),
            sides + [(-slope, 1, 0, 0), (-slope, -1, 0, 0), (1, 0, 0, -1)],
            [(0, 0, 0)] + [(1, y, z) for y in (-slope, slope) for z in (-slope, slope)],
            F(1, 16),
        ),
    ):
        points = exact([input_point, (F(1, 2), 0, 0), (F(3, 4), 0, slope / 4), (F(3, 4), slope / 4, 0)])
        vertices, faces = hull_mesh(exact(corners))
        for form, candidate, expected in (
            (
                "mesh",
                {"points": vertices, "faces": faces},
                judged_mesh(points, vertices, faces, {"mesh-oriented": "holds", "mesh-convex": "holds"}),
            ),
            (
                "planes",
                {"halfspaces": [list(row) for row in rows]},
                judged_planes(points, rows, {"candidate-solid": "holds", "candidate-bounded": "holds"}),
            ),
        ):
            assert expected["outside"] == {"points": 1, "squared_distance": distance}
            yield (
                f"{name}-{form}",
                what,
                points,
                candidate,
                {},
                expected,
                [],
                2,
                "the nearest point is the origin; to the planes the distance is less than a millionth",
            )


def surfaces():
    """Surfaces of a cube with faces that count for nothing, or that are no polygons."""
    cube = exact(box(2, 2, 2))
    corner = lambda x, y, z: cube.index((x, y, z))
    low, high = min(p[0] for p in cube), max(p[0] for p in cube)
    middle = (low + high) / 2
    a, b, c, d = (corner(x, y, high) for x, y in ((low, low), (high, low), (high, high), (low, high)))
    e, f, g, h = (corner(x, y, low) for x, y in ((low, low), (high, low), (high, high), (low, high)))
    sides = [[a, e, f, b], [b, f, g, c], [c, g, h, d], [d, h, e, a], [h, g, f, e]]
    center, edge, twin = 8, 9, 10
    points = cube + [(middle, middle, high), (middle, low, high), cube[a]]
    names = ("mesh-closed", "mesh-oriented", "mesh-planar", "mesh-convex")
    fine = dict.fromkeys(names, "holds")
    for name, title, faces, claims, why in (
        (
            "zero-edge",
            "a corner twice in a row, under two numbers",
            [[a, e, f, b, twin]] + sides[1:] + [[a, b, c, d]],
            fine,
            "the edge from a point to its repeat has length zero",
        ),
        (
            "zero-face",
            "triangles that are an edge or a point",
            sides + [[a, b, c, d], [a, b, a], [a, twin, b], [a, a, twin]],
            fine,
            "faces with fewer than three different corners are no faces",
        ),
        (
            "sliver",
            "a T-junction closed by a triangle without area",
            sides + [[a, edge, b, c, d], [a, b, edge]],
            fine,
            "the sliver has the edge of the side on one hand, its two halves on the other",
        ),
        (
            "t-junction",
            "a T-junction left open",
            sides + [[a, edge, b, c, d]],
            {"mesh-closed": "violated", "mesh-planar": "holds"},
            "the edge of the side has one face, and so have its halves",
        ),
        (
            "bow-tie",
            "a bow-tie for its top",
            sides + [[a, c, b, d]],
            {"mesh-planar": "violated"},
            "the diagonals cross in the middle",
        ),
        (
            "bow-ties",
            "two bow-ties over two triangles for its top",
            sides + [[a, b, c], [b, c, d, a], [a, c, b, d], [b, d, a]],
            {"mesh-planar": "violated"},
            "the diagonals cross in the middle",
        ),
        (
            "spike",
            "a top that runs out to its middle and back",
            sides + [[a, b, c, center, c, d]],
            {"mesh-closed": "violated", "mesh-planar": "violated"},
            "the edge to the middle belongs to one face, twice",
        ),
        (
            "pinched",
            "a top that visits its middle twice",
            sides + [[a, b, center, c, d, center]],
            {"mesh-planar": "violated"},
            "a corner that is visited twice is none of a simple polygon",
        ),
        (
            "notched",
            "a top of two polygons, one of them not convex",
            sides + [[a, b, c, center], [c, d, a, center]],
            fine,
            "both are simple, and share the two edges to the middle",
        ),
    ):
        judged = judged_mesh(cube, points, faces)
        for code in names:
            judged["claims"].pop(code, None)
        judged["claims"].update(claims)
        yield f"surface-{name}", f"A cube with {title}", cube, {"points": points, "faces": faces}, {}, judged, [
            "coplanar",
            "duplicates",
        ], 2, why


INNER_BASES = ("octahedron", "brick", "ball", "lattice", "needle", "offset")


def judged_inner(points, corners, extra=None):
    """What the definition says of a solid that is meant to lie inside the hull of the points."""
    outside, worst = farthest_outside(list(hull_planes(points)), corners)
    claims = {
        "candidate-readable": "holds",
        "candidate-finite": "holds",
        "candidate-solid": "holds",
        "candidate-bounded": "holds",
        "inside-input": status(outside == 0),
    }
    claims.update(extra or {})
    return {"claims": claims, "outside": {"points": outside, "squared_distance": worst}}


def inner_solids():
    """Candidates that shall lie inside. Yields name, title, input, candidate, request, expected, flags, level, why."""
    why = "every vertex of the candidate against every facet plane of the input's hull, in fractions"
    inner = {"inner": True}
    for name, title, points, flags, level in bases():
        if name not in INNER_BASES:
            continue
        vertices, faces = hull_mesh(points)
        yield (
            f"{name}-inner-hull",
            f"{title}: its own hull, as an inner solid",
            points,
            {"points": vertices, "faces": faces},
            inner,
            judged_inner(points, vertices),
            flags,
            level,
            why,
        )
        rest, rest_faces = hull_mesh(vertices[1:])
        yield (
            f"{name}-inner-less-one",
            f"{title}: the hull of all its vertices but the first",
            points,
            {"points": rest, "faces": rest_faces},
            inner,
            judged_inner(points, rest),
            flags,
            level,
            why,
        )
        beyond = move_inward(points, rest, -1)
        beyond_vertices, beyond_faces = hull_mesh(beyond)
        yield (
            f"{name}-inner-one-ulp",
            f"{title}: the same with one corner moved outward by an ulp",
            points,
            {"points": beyond_vertices, "faces": beyond_faces},
            inner,
            judged_inner(points, beyond_vertices),
            flags,
            level,
            why,
        )
        if name == "brick":
            continue
        least = [min(p[k] for p in points) for k in range(3)]
        most = [max(p[k] for p in points) for k in range(3)]
        walls = [[-(k == j) for k in range(3)] + [least[j]] for j in range(3)]
        walls += [[int(k == j) for k in range(3)] + [-most[j]] for j in range(3)]
        corners = [tuple((least, most)[m >> k & 1][k] for k in range(3)) for m in range(8)]
        yield (
            f"{name}-inner-walls",
            f"{title}: the walls of its bounding box, which lie outside",
            points,
            {"halfspaces": walls},
            inner,
            judged_inner(points, corners),
            flags,
            level,
            why,
        )
