# SPDX-License-Identifier: MIT
"""Reads meshes and rows of halfspaces by the rules of docs/formats.md, for the independent judge.

Numbers stay what they mean: a coordinate is a double (or a Fraction where a row spells one), and with
`binary32` the nearest float32, found from the decimal itself and not by way of a double.
"""
import base64
import json
import math
import re
import struct
from fractions import Fraction
from pathlib import Path

DECIMAL = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")
INTEGER = re.compile(r"[+-]?\d+")
EXACT = re.compile(r"[+-]?\d+(/\d+)?")
OBJ_PASSED_OVER = set("""vt vn vp s usemtl mtllib l p cstype deg bmat step curv curv2 surf parm trim hole scrv
sp end con mg bevel c_interp d_interp lod maplib usemap shadow_obj trace_obj ctech stech res cdc cdp bzp bsp
bspp""".split())
PLY_TYPES = {"char": "b", "int8": "b", "uchar": "B", "uint8": "B", "short": "h", "int16": "h", "ushort": "H",
             "uint16": "H", "int": "i", "int32": "i", "uint": "I", "uint32": "I", "float": "f", "float32": "f",
             "double": "d", "float64": "d"}


class Malformed(Exception):
    """The bytes are not what the format asks for."""


class NotFinite(Exception):
    """A NaN, an infinity, or a decimal beyond the largest number of the format."""


def to_binary32(value):
    """The float32 nearest to a Fraction, ties to even, as a float."""
    if value == 0:
        return 0.0
    size = abs(value)
    exponent = size.numerator.bit_length() - size.denominator.bit_length()
    if Fraction(2) ** exponent > size:
        exponent -= 1
    unit = Fraction(2) ** max(exponent - 23, -149)
    rounded = round(size / unit) * unit
    if rounded >= 2 ** 128:
        raise NotFinite(str(value))
    return math.copysign(float(rounded), value)


class Numbers:
    """What a number in a file means: `binary64` (the nearest double), `binary32`, or `exact` (what a decimal spells)."""

    def __init__(self, kind="binary64"):
        self.single, self.exact = kind == "binary32", kind == "exact"

    def of_text(self, word):
        if word.lower().lstrip("+-") in ("nan", "inf", "infinity"):
            raise NotFinite(word)
        if not DECIMAL.fullmatch(word):
            raise Malformed(f"expected a number, found {word}")
        value = float(word)
        if math.isinf(value):
            raise NotFinite(word)
        if self.exact:
            return Fraction(word)
        # A decimal that is 0 as a double is 0 as a float32; the others have bounded exponents.
        return to_binary32(Fraction(word)) if self.single and value else value

    def of_double(self, value):
        if not math.isfinite(value):
            raise NotFinite(str(value))
        return to_binary32(Fraction(value)) if self.single else value


class Mesh:
    """Points as triples of numbers, faces as lists of indices from 0."""

    def __init__(self, points, faces):
        self.points, self.faces = points, faces
        for face in faces:
            if any(not 0 <= corner < len(points) for corner in face):
                raise Malformed("the index of a point that is not there")


class Rows:
    """Halfspaces n.x + d <= 0 as quadruples of Fractions, in the order of the file."""

    def __init__(self, rows):
        self.rows = rows


def text_lines(data):
    text = data.removeprefix(b"\xef\xbb\xbf").decode("latin-1")
    return text.replace("\r\n", "\n").replace("\r", "\n").split("\n")


def words_of(line):
    """The words before a comment, which starts where a word does."""
    words = []
    for word in line.split():
        if word.startswith("#"):
            break
        words.append(word)
    return words


def obj_index(word, count):
    parts = word.split("/")
    if len(parts) > 3 or not INTEGER.fullmatch(parts[0]) or int(parts[0]) == 0:
        raise Malformed(f"expected an index, found {word}")
    index = int(parts[0])
    return index - 1 if index > 0 else count + index


def read_obj(data, numbers):
    points, faces, pending = [], [], ""
    for line in [*text_lines(data), ""]:  # a last line may be joined with nothing
        if line.endswith("\\"):
            pending += line[:-1] + " "
            continue
        words, pending = words_of(pending + line), ""
        if not words:
            continue
        if words[0] == "v":
            if len(words) not in (4, 5, 7, 8):
                raise Malformed("a point needs 3, 4, 6 or 7 numbers")
            points.append(tuple([numbers.of_text(word) for word in words[1:]][:3]))
        elif words[0] == "f":
            if len(words) < 4:
                raise Malformed("a face needs 3 corners")
            faces.append([obj_index(word, len(points)) for word in words[1:]])
        elif words[0] not in OBJ_PASSED_OVER and words[0] not in ("o", "g"):
            raise Malformed(f"unknown word {words[0]}")
    return Mesh(points, faces)


def read_off(data, numbers):
    lines = [words for words in map(words_of, text_lines(data)) if words]
    if not lines or not re.fullmatch(r"(ST)?C?N?OFF", lines[0][0]):
        raise Malformed("expected OFF")
    counts = lines[0][1:]
    lines = lines[1:]
    if not counts:
        counts, lines = (lines[0], lines[1:]) if lines else ([], [])
    if len(counts) not in (2, 3) or not all(word.isdecimal() for word in counts):
        raise Malformed("expected the counts")
    point_count, face_count = int(counts[0]), int(counts[1])
    if len(lines) != point_count + face_count or any(len(line) < 3 for line in lines[:point_count]):
        raise Malformed("as many lines as declared")
    points = [tuple(numbers.of_text(word) for word in line[:3]) for line in lines[:point_count]]
    faces = []
    for line in lines[point_count:]:
        size = int(line[0]) if line[0].isdecimal() else 0
        if size < 3 or len(line) <= size or not all(word.isdecimal() for word in line[1:size + 1]):
            raise Malformed("expected a face")
        faces.append([int(word) for word in line[1:size + 1]])
    return Mesh(points, faces)


def soup(triangles):
    """STL repeats its points; those that are equal are one."""
    index, faces = {}, []
    for triangle in triangles:
        faces.append([index.setdefault(tuple(x + 0.0 for x in point), len(index)) for point in triangle])
    return Mesh(list(index), faces)


def read_stl(data, numbers):
    if len(data) >= 84 and len(data) == 84 + 50 * struct.unpack_from("<I", data, 80)[0]:
        triangles = []
        for at in range(84, len(data), 50):
            values = [numbers.of_double(x) for x in struct.unpack_from("<9f", data, at + 12)]
            triangles.append((values[0:3], values[3:6], values[6:9]))
        return soup(triangles)
    words = [word for line in text_lines(data) for word in line.split()]
    if not words or words[0].lower() != "solid":
        raise Malformed("expected solid")
    corners = []
    for at, word in enumerate(words):
        if word.lower() == "vertex" and len(words) > at + 3 and DECIMAL.fullmatch(words[at + 1]):
            corners.append([numbers.of_text(word) for word in words[at + 1:at + 4]])
        elif word.lower() == "vertex" and len(words) > at + 1 and words[at + 1].lower() in ("nan", "inf", "-inf"):
            raise NotFinite(words[at + 1])
    if len(corners) % 3:
        raise Malformed("expected three points in each facet")
    return soup([corners[at:at + 3] for at in range(0, len(corners), 3)])


def ply_header(data):
    end = data.find(b"end_header")
    stop = data.find(b"\n", end) + 1
    if not data.startswith(b"ply") or end < 0 or stop == 0:
        raise Malformed("expected a PLY header")
    form, elements = None, []
    for line in text_lines(data[:end])[1:]:
        words = line.split()
        if words[:1] == ["format"]:
            form = words[1]
        elif words[:1] == ["element"]:
            elements.append((words[1], int(words[2]), []))
        elif words[:1] == ["property"]:
            elements[-1][2].append(words[1:])
    return form, elements, data[stop:]


def ply_values(form, body):
    """A function that hands out the next value of a named type; text values as words."""
    if form == "ascii":
        words = iter(body.decode("latin-1").split())
        return lambda kind: next(words)
    order = {"binary_little_endian": "<", "binary_big_endian": ">"}[form]
    at = 0

    def take(kind):
        nonlocal at
        code = order + PLY_TYPES[kind]
        value = struct.unpack_from(code, body, at)[0]
        at += struct.calcsize(code)
        return value
    return take


def read_ply(data, numbers):
    form, elements, body = ply_header(data)
    points, faces = [], []
    try:
        take = ply_values(form, body)
        for name, count, properties in elements:
            for _ in range(count):
                row = {}
                for kind in properties:
                    if kind[0] == "list":
                        row[kind[3]] = [take(kind[2]) for _ in range(int(take(kind[1])))]
                    else:
                        row[kind[1]] = take(kind[0])
                if name == "vertex":
                    points.append(tuple(numbers.of_text(row[axis]) if form == "ascii" else
                                        numbers.of_double(float(row[axis])) for axis in "xyz"))
                elif name == "face":
                    faces += [[int(x) for x in row[key]] for key in ("vertex_indices", "vertex_index") if key in row]
    except (StopIteration, KeyError, struct.error, ValueError) as fault:
        raise Malformed(str(fault)) from fault
    if any(len(face) < 3 for face in faces):
        raise Malformed("a face needs 3 corners")
    return Mesh(points, faces)


def row_number(word, numbers):
    word = str(word)
    if EXACT.fullmatch(word):
        return Fraction(word)
    return Fraction(numbers.of_text(word))


def read_rows_json(data, numbers):
    try:
        document = json.loads(data, parse_float=str, parse_int=str)
    except ValueError as fault:
        raise Malformed(str(fault)) from fault
    rows = document.get("halfspaces") if isinstance(document, dict) else document
    if not isinstance(rows, list) or not rows or any(not isinstance(row, list) or len(row) != 4 for row in rows):
        raise Malformed("expected rows of four numbers")
    return Rows([tuple(row_number(word, numbers) for word in row) for row in rows])


def read_rows_text(data, numbers):
    rows = [words for words in map(words_of, text_lines(data)) if words]
    if not rows or any(len(row) != 4 for row in rows):
        raise Malformed("expected rows of four numbers")
    return Rows([tuple(row_number(word, numbers) for word in row) for row in rows])


READERS = {"obj": read_obj, "off": read_off, "stl": read_stl, "ply": read_ply, "json": read_rows_json,
           "txt": read_rows_text}


def read(path, kind="binary64"):
    """The Mesh or the Rows of a file whose extension names the format."""
    path = Path(path)
    return READERS[path.suffix[1:].lower()](path.read_bytes(), Numbers(kind))


def vector_number(number):
    return float.fromhex(number) if isinstance(number, str) else float(number)


def scaled_exact(text):
    """`p`, `p/q`, or either times a power of two, as the vectors spell exact values."""
    base, _, power = text.partition("*2^")
    return Fraction(base) * Fraction(2) ** int(power or 0)


def file_bytes(entry):
    return base64.b64decode(entry["base64"]) if "base64" in entry else entry["text"].encode()
