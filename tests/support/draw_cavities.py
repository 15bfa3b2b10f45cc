#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws docs/cavities.svg: bin, cup, tube and house, as hacd and as cut take them apart at their defaults.

Usage: draw_cavities.py PROGRAM > docs/cavities.svg

A part has a colour; its facets that look towards the eye are filled, half transparent, the edges of the others are dashed.
"""
import pathlib
import subprocess
import sys
import tempfile

CASES = pathlib.Path(__file__).resolve().parents[1] / 'data' / 'cases'
SHAPES, METHODS = ('bin', 'cup', 'tube', 'house'), ('hacd', 'cut')
COLOURS = ('#56b4e9', '#e69f00', '#009e73', '#cc79a7', '#0072b2', '#d55e00', '#f0e442', '#999999')
RIGHT, UP, TO_EYE = (0.866, 0.5, 0), (-0.35, 0.606, 0.714), (0.357, -0.619, 0.7)  # of the picture; z is up
SIZE, MARGIN = 2840, 30  # of a drawing, in its own units
COLUMN, ROW = 440, 520


def dot(u, v):
    return sum(a * b for a, b in zip(u, v))


def parts_of(program, method, shape, folder):
    """By part, its facets: lists of points."""
    path = pathlib.Path(folder) / 'parts.obj'
    subprocess.run([program, 'decompose', CASES / f'{shape}.obj', '--method', method, '-o', path], check=True, capture_output=True)
    points, parts = [], []
    for words in map(str.split, path.read_text(encoding='utf-8').splitlines()):
        if words[:1] == ['v']:
            points.append(tuple(map(float, words[1:4])))
        elif words[:1] == ['o']:
            parts.append([])
        elif words[:1] == ['f']:
            if not parts:
                parts.append([])
            parts[-1].append([points[int(word.split('/')[0]) - 1] for word in words[1:]])
    return parts


def normal(facet):
    sides = [[b - a for a, b in zip(facet[0], corner)] for corner in facet[1:]]
    total = [0.0, 0.0, 0.0]
    for u, v in zip(sides, sides[1:]):
        for k in range(3):
            total[k] += u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3]
    return total


def drawing(parts):
    """The view box, and the paths, the parts that are farthest from the eye first."""
    corners = [corner for part in parts for facet in part for corner in facet]
    flat = [(dot(corner, RIGHT), -dot(corner, UP)) for corner in corners]
    low, high = [min(axis) for axis in zip(*flat)], [max(axis) for axis in zip(*flat)]
    scale = (SIZE - 2 * MARGIN) / max(b - a for a, b in zip(low, high))

    def path(facets):
        at = [[[round((x - (a + b) / 2) * scale) for x, a, b in zip((dot(corner, RIGHT), -dot(corner, UP)), low, high)]
               for corner in facet] for facet in facets]
        return ''.join('M' + 'L'.join(f'{x} {y}' for x, y in facet) + 'z' for facet in at)
    lines = []
    order = sorted(range(len(parts)), key=lambda k: max(dot(corner, TO_EYE) for facet in parts[k] for corner in facet))
    for k in order:
        colour, seen = COLOURS[k % len(COLOURS)], [dot(normal(facet), TO_EYE) > 0 for facet in parts[k]]
        hidden = [facet for facet, is_seen in zip(parts[k], seen) if not is_seen]
        shown = [facet for facet, is_seen in zip(parts[k], seen) if is_seen]
        lines.append(f'<path fill="none" stroke="{colour}" stroke-width="4" stroke-dasharray="16 14" d="{path(hidden)}"/>')
        lines.append(f'<path fill="{colour}" fill-opacity="0.5" stroke="{colour}" stroke-width="8" stroke-linejoin="round" d="{path(shown)}"/>')
    width, height = ((b - a) * scale + 2 * MARGIN for a, b in zip(low, high))
    return f'{-width / 2:.0f} {-height / 2:.0f} {width:.0f} {height:.0f}', lines


def main(program):
    print(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {len(SHAPES) * COLUMN + 80} {len(METHODS) * ROW + 20}" width="920" role="img" '
          'aria-label="bin, cup, tube and house, as hacd and as cut take them apart" font-family="system-ui, sans-serif" '
          'font-size="34" fill="#666">')
    with tempfile.TemporaryDirectory() as folder:
        for row, method in enumerate(METHODS):
            top = 20 + row * ROW
            print(f'<text transform="translate(40 {top + 250}) rotate(-90)" text-anchor="middle">{method}</text>')
            for column, shape in enumerate(SHAPES):
                parts = parts_of(program, method, shape, folder)
                box, lines = drawing(parts)
                left, count = 60 + column * COLUMN, '1 part' if len(parts) == 1 else f'{len(parts)} parts'
                print(f'<svg x="{left}" y="{top}" width="{COLUMN - 20}" height="{ROW - 80}" viewBox="{box}">', *lines, '</svg>', sep='\n')
                print(f'<text x="{left + COLUMN / 2 - 10:.0f}" y="{top + ROW - 40}" text-anchor="middle">{shape}: {count}</text>')
    print('</svg>')


if __name__ == '__main__':
    main(sys.argv[1])
