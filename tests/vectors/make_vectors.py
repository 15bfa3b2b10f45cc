#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the conformance vectors: the JSON files of this folder, from *_shapes.py and *_cases.py.

    make_vectors.py            writes them
    make_vectors.py --check    compares instead, and exits 1 if a file differs

Expected values come from closed forms, from the definition (exact_geometry.py: brute force in
integers and fractions) or from lrslib, never from convexact. Where there are two sources, they are
compared here. Only Python's standard library is used, and lrs where it is installed.
"""
import argparse
import base64
import json
import pathlib
import shutil
import subprocess
import sys
from fractions import Fraction as F

import box_shapes
import delicate_shapes
import integer_shapes
import polygon_shapes
import refuse_cases
import regular_shapes
import scaled_shapes
import shapes
import thin_shapes
import verify_cases
from exact_geometry import Arrangement, dimension, greedy, hull_measures, hull_planes, primitive_plane
from vector_text import coordinates, exact_text, normal_form, rows_text

HERE = pathlib.Path(__file__).parent
LRS = shutil.which("lrs")


# One vector.


# Why an input is refused.
REFUSAL_FLAGS = ("flat", "malformed", "unbounded")


class Collection:
    def __init__(self):
        self.vectors = []
        self.forms = {}

    def add(self, identifier, title, level, flags, given, question, expected, source, form):
        form = (question["ask"], form)
        assert form not in self.forms, f"{identifier} is a mere variant of {self.forms.get(form)}"
        self.forms[form] = identifier
        if question["ask"] == "refuse":  # how hard the input would be, were it usable, is not asked
            flags = [flag for flag in flags if flag in REFUSAL_FLAGS]
        assert all(v["id"] != identifier for v in self.vectors), f"{identifier} comes twice"
        self.vectors.append(
            {
                "id": identifier,
                "title": title,
                "level": level,
                "required": level < 3,
                "flags": flags,
                "input": given,
                "question": question,
                "expected": expected,
                "source": source,
            }
        )


# Sources.


def lrs_volume(points):
    """The volume of the hull by lrslib; nothing if it is not installed."""
    if LRS is None:
        return None
    rows = [" ".join(["1"] + [str(x) for x in p]) for p in points]
    text = f"v\nV-representation\nbegin\n{len(rows)} 4 rational\n" + "\n".join(rows) + "\nend\nvolume\n"
    said = subprocess.run([LRS], input=text, capture_output=True, text=True, check=True).stdout
    line = next(line for line in said.splitlines() if "*Volume=" in line)
    return F(line.split("=")[1])


def measured(shape):
    """Counts and volume of a shape's hull, and where they come from."""
    if shape.vertices is not None:
        return {"facets": shape.facets, "vertices": shape.vertices, "volume": shape.volume}, "closed-form", shape.why
    found = hull_measures(shape.points)
    if shape.facets is not None:
        assert found["facets"] == shape.facets, shape.name
    if shape.volume is not None:
        assert found["volume"] == shape.volume, shape.name
        return found, "closed-form", f"volume: {shape.why}; counts by definition, which gives the same volume"
    if "cospherical" in shape.flags or "lattice" in shape.flags:
        by_lrs = lrs_volume(shape.points)
        assert by_lrs in (None, found["volume"]), shape.name
        return found, "lrslib", "volume: lrs on the V-representation; counts by definition, which gives the same volume"
    return found, "definition", "planes through three points with all others on one side; tetrahedra over their faces"


def add_shapes(collection, family):
    for shape in family():
        shape.points = shapes.exact(shape.points)
        given = {"points": coordinates(shape.points)}
        form = normal_form(shape.points)
        found, kind, why = measured(shape)
        collection.add(
            f"{shape.name}-hull",
            f"{shape.title}: counts and volume of the hull",
            shape.level,
            shape.flags,
            given,
            {"ask": "hull"},
            {"facets": found["facets"], "vertices": found["vertices"], "volume": exact_text(found["volume"])},
            {"kind": kind, "why": why},
            form,
        )
        if not shape.faces:
            continue
        run = greedy(hull_planes(shape.points), shape.faces)
        kind, why = "definition", "the halfspaces intersected from scratch without each candidate, in fractions"
        if shape.costs is not None:
            assert run["costs"] == shape.costs, shape.name
            kind, why = "closed-form", f"{shape.cost_why}; ties by definition, which gives the same costs"
        collection.add(
            f"{shape.name}-simplify",
            f"{shape.title}: to {shape.faces} facets",
            shape.level,
            shape.flags,
            given,
            {"ask": "simplify", "faces": shape.faces},
            run_json(run),
            {"kind": kind, "why": why},
            form,
        )


def run_json(run):
    return {
        "facets": run["facets"],
        "reached": run["reached"],
        "volume": exact_text(run["volume"]),
        "costs": [exact_text(cost) for cost in run["costs"]],
        "ties": [rows_text(tie) if len(tie) > 1 else [] for tie in run["ties"]],
    }


def add_halfspaces(collection):
    for name, title, rows, faces, flags, level in refuse_cases.solid_halfspaces():
        planes = needed_planes(rows)
        collection.add(
            f"halfspaces-{name}",
            f"{title}: to {faces} facets",
            level,
            flags,
            {"halfspaces": rows_text(rows)},
            {"ask": "simplify", "faces": faces},
            run_json(greedy(planes, faces)),
            {
                "kind": "definition",
                "why": "the halfspaces intersected from scratch without each candidate, in fractions",
            },
            tuple(sorted(map(tuple, planes))),
        )


def needed_planes(rows):
    """The distinct planes that hold a facet: at least three vertices not on one line."""
    planes = sorted({primitive_plane(row) for row in rows})
    arrangement = Arrangement(planes)
    inside, _ = arrangement.levels(arrangement.all_alive())
    assert arrangement.is_bounded(arrangement.all_alive())
    needed = []
    for j, plane in enumerate(planes):
        corners = [arrangement.points[v] for v in inside if arrangement.tight[v] >> j & 1]
        if dimension([tuple(F(x, p[3]) for x in p[:3]) for p in corners]) == 2:
            needed.append(plane)
    return needed


def candidate_json(candidate):
    if "points" in candidate:
        return {"points": coordinates(candidate["points"]), "faces": candidate["faces"]}
    if "halfspaces" in candidate:
        return {"halfspaces": rows_text(candidate["halfspaces"])}
    return candidate


def add_verify(collection):
    for family in (
        verify_cases.verify_cases,
        verify_cases.broken_candidates,
        verify_cases.dented,
        verify_cases.sharp_edges,
        verify_cases.surfaces,
        verify_cases.inner_solids,
    ):
        for name, title, points, candidate, request, expected, flags, level, why in family():
            if "outside" in expected:
                expected["outside"]["squared_distance"] = exact_text(expected["outside"]["squared_distance"])
            form = (
                normal_form(points, candidate.get("points", ())),
                json.dumps(candidate_json(candidate)),
                json.dumps(request),
            )
            collection.add(
                f"verify-{name}",
                title,
                level,
                flags,
                {"points": coordinates(points)},
                {"ask": "verify", "candidate": candidate_json(candidate), **request},
                expected,
                {"kind": "definition", "why": why},
                form,
            )


def add_refusals(collection):
    for name, title, content, form, error in refuse_cases.malformed_inputs():
        given = (
            {"text": content, "format": form}
            if isinstance(content, str)
            else {"base64": base64.b64encode(content).decode(), "format": form}
        )
        collection.add(
            f"malformed-{name}",
            title,
            1,
            ["malformed"],
            given,
            {"ask": "refuse"},
            {"error": error, "exit": 3}
            | ({"points": coordinates(refuse_cases.SOUND_POINTS)} if name in refuse_cases.MALFORMED_FACES else {}),
            {"kind": "definition", "why": "the format's own rules"},
            (content, form),
        )
    for name, title, points, flags, level in refuse_cases.flat_inputs():
        points = shapes.exact(points)
        collection.add(
            f"flat-{name}",
            title,
            level,
            ["flat", *flags],
            {"points": coordinates(points)},
            {"ask": "refuse"},
            {"error": "no-interior", "exit": 4, "dimension": dimension(points)},
            {"kind": "definition", "why": "the rank of the differences of the points, in fractions"},
            normal_form(points),
        )
    for name, title, rows, reason, flags, level, why in refuse_cases.bad_halfspaces():
        collection.add(
            f"halfspaces-{name}",
            title,
            level,
            flags,
            {"halfspaces": rows_text(rows)},
            {"ask": "refuse"},
            {"error": "no-interior", "exit": 4, "reason": reason},
            {"kind": "closed-form", "why": why},
            tuple(map(tuple, rows)),
        )


def add_scans(collection):
    why = "any 18 halfspaces of the hull that bound a solid; what is written is judged exactly"
    for name, file, scale, faces, flags in (
        ("bunny-millimetres", "bunny.obj", 1000, 18, ["near-coplanar"]),
        ("spot-micrometres", "spot.obj", 1000000, 12, ["ties"]),
        ("teapot-inches", "teapot.obj", 12, 20, ["valence"]),
    ):
        collection.add(
            f"scan-{name}",
            f"{file} times {scale}: to {faces} facets",
            1,
            flags,
            {"file": file, "scale": scale},
            {"ask": "simplify", "faces": faces},
            {"facets": faces, "reached": True},
            {"kind": "definition", "why": why},
            (file,),
        )


FILES = {
    "regular": [regular_shapes.regular_solids],
    "everyday": [regular_shapes.everyday],
    "over-polygons": [polygon_shapes.over_polygons],
    "boxes": [box_shapes.boxes],
    "zonotopes": [regular_shapes.zonotopes],
    "lattices": [integer_shapes.lattices],
    "spheres": [integer_shapes.spheres],
    "thin": [thin_shapes.thin],
    "far": [thin_shapes.far],
    "scales": [scaled_shapes.scaled],
    "mixed": [scaled_shapes.mixed],
    "repeated": [delicate_shapes.repeated],
    "nearly": [delicate_shapes.nearly],
}


def collect():
    """File name -> the vectors in it."""
    collection, files = Collection(), {}

    def cut(name):
        files[name] = collection.vectors[sum(map(len, files.values())) :]

    for name, families in FILES.items():
        for family in families:
            add_shapes(collection, family)
        cut(name)
    for name, add in (
        ("halfspaces", add_halfspaces),
        ("verify", add_verify),
        ("refuse", add_refusals),
        ("scans", add_scans),
    ):
        add(collection)
        cut(name)
    return files


def file_text(vectors):
    """JSON with a line for each part of a vector."""
    entries = []
    for vector in vectors:
        head = {key: vector[key] for key in ("id", "title", "level", "required", "flags")}
        lines = [json.dumps(head)[:-1]] + [
            f'"{key}": {json.dumps(vector[key])}' for key in ("input", "question", "expected", "source")
        ]
        entries.append(",\n  ".join(lines) + "}")
    return '{"vectors": [\n' + ",\n".join(entries) + "\n]}\n"


def check_rules(files):
    vectors = [v for each in files.values() for v in each]
    assert len(vectors) >= 300, f"only {len(vectors)} vectors"
    flags = {}
    for vector in vectors:
        assert len(set(vector["flags"])) == len(vector["flags"]), vector["id"]
        for flag in vector["flags"]:
            flags[flag] = flags.get(flag, 0) + 1
    text = (HERE / "../../docs/flags.md").read_text(encoding="utf-8")
    headings = {line[3:] for line in text.splitlines() if line.startswith("## ")}
    assert set(flags) == headings, f"flags and headings of flags.md differ: {set(flags) ^ headings}"
    for flag, count in flags.items():
        assert count >= 10, f"only {count} vectors are flagged {flag}"
    return len(vectors), flags


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--check", action="store_true")
    arguments = parser.parse_args()
    files = collect()
    count, flags = check_rules(files)
    differ = []
    for name, vectors in files.items():
        path, text = HERE / f"{name}.json", file_text(vectors)
        if arguments.check and (not path.exists() or path.read_text(encoding="utf-8") != text):
            differ.append(path.name)
        if not arguments.check:
            path.write_text(text, encoding="utf-8")
    unknown = {p.stem for p in HERE.glob("*.json")} - set(files)
    print(f"{count} vectors; " + ", ".join(f"{flag} {n}" for flag, n in sorted(flags.items())))
    for name in [*differ, *unknown]:
        print(f"{name} is not what make_vectors.py makes")
    return 1 if differ or unknown else 0


if __name__ == "__main__":
    sys.exit(main())
