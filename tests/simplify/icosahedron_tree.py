#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every way to simplify the icosahedron, in exact numbers: what figure 16 of [Jacobson2026] samples.

Usage: icosahedron_tree.py [--table]

All faces of an icosahedron cost the same, and so do many removals later. This walks all choices among
equally cheap removals, with the probability of each end if ties are broken uniformly. It shares no code
with the program: it is the reference for `./dev reproduce icosahedron`.

The planes are v.x <= 1 for the 20 vertices v of a dodecahedron, so coordinates, volumes and squared
lengths are in Q(sqrt 5). All planes touch one sphere, so area is a constant times volume. Normals are
at four angles only, so that a mean width is a sum over Q(sqrt 5) of t1, sqrt(2) t2, pi, sqrt(2) pi
with cos t1 = sqrt(5)/3, cos t2 = 1/3. Equal coefficients prove a tie. Different mean widths are told
apart by enclosures, which never end on a tie of another kind: the walk would stop with an error.
"""
import argparse
import functools
import itertools
import math
import sys
from fractions import Fraction


@functools.total_ordering
class Golden:
    """a + b sqrt(5), a and b rational."""
    __slots__ = ('a', 'b')

    def __init__(self, a, b=0):
        self.a, self.b = Fraction(a), Fraction(b)

    def __add__(self, o):
        return Golden(self.a + o.a, self.b + o.b)

    def __sub__(self, o):
        return Golden(self.a - o.a, self.b - o.b)

    def __neg__(self):
        return Golden(-self.a, -self.b)

    def __mul__(self, o):
        return Golden(self.a * o.a + 5 * self.b * o.b, self.a * o.b + self.b * o.a)

    def __truediv__(self, o):
        norm = o.a * o.a - 5 * o.b * o.b
        return self * Golden(o.a / norm, -o.b / norm)

    def sign(self):
        a, b = self.a, self.b
        if a >= 0 and b >= 0:
            return int(a > 0 or b > 0)
        if a <= 0 and b <= 0:
            return -1
        return (1 if a > 0 else -1) * (1 if a * a > 5 * b * b else -1)

    def __abs__(self):
        return -self if self.sign() < 0 else self

    def __eq__(self, o):
        return self.a == o.a and self.b == o.b

    def __lt__(self, o):
        return (self - o).sign() < 0

    def __hash__(self):
        return hash((self.a, self.b))

    def __float__(self):
        return float(self.a) + float(self.b) * math.sqrt(5)


ZERO, ONE, ROOT5 = Golden(0), Golden(1), Golden(0, 1)
PHI = Golden(Fraction(1, 2), Fraction(1, 2))


def dot(u, v):
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def cross(u, v):
    return tuple(u[k - 2] * v[k - 1] - u[k - 1] * v[k - 2] for k in range(3))


def minus(u, v):
    return tuple(a - b for a, b in zip(u, v))


# --- the planes, the points where three of them meet, the symmetries -------------------------------

def dodecahedron():
    """The 20 vertices, each at distance sqrt(3)."""
    signs = (ONE, -ONE)
    cube = list(itertools.product(signs, repeat=3))
    others = [(ZERO, a * (ONE / PHI), b * PHI) for a in signs for b in signs]
    return cube + [tuple(v[(k + turn) % 3] for k in range(3)) for v in others for turn in range(3)]


NORMALS = dodecahedron()
COUNT = len(NORMALS)
PLANES = range(COUNT)
COSINES = {(i, j): dot(NORMALS[i], NORMALS[j]) for i in PLANES for j in PLANES}  # times 3


def bits_where(condition):
    return sum(1 << i for i in PLANES if condition(i))


def meeting_points():
    """Point -> (planes through it, planes that it is beyond), both as bits."""
    points = {}
    for i, j, k in itertools.combinations(PLANES, 3):
        u, v, w = NORMALS[i], NORMALS[j], NORMALS[k]
        det = dot(u, cross(v, w))
        if det == ZERO:
            continue
        sums = [cross(v, w), cross(w, u), cross(u, v)]
        point = tuple((sums[0][c] + sums[1][c] + sums[2][c]) / det for c in range(3))
        if point not in points:
            heights = [dot(n, point) for n in NORMALS]
            points[point] = (bits_where(lambda p: heights[p] == ONE),
                             bits_where(lambda p: heights[p] > ONE))
    return points


def ray_blockers():
    """For each direction in which two planes meet: the planes that bound it."""
    blockers = []
    for i, j in itertools.combinations(PLANES, 2):
        u = cross(NORMALS[i], NORMALS[j])
        if all(x == ZERO for x in u):
            continue
        for ray in (u, tuple(-x for x in u)):
            blockers.append((1 << i | 1 << j, bits_where(lambda p: dot(NORMALS[p], ray).sign() > 0)))
    return blockers


POINTS = meeting_points()
BLOCKERS = ray_blockers()


def symmetries():
    """The 120 permutations of the planes that keep all angles, from the images of three planes."""
    start = next((0, j, k) for j in PLANES for k in PLANES
                 if dot(NORMALS[0], cross(NORMALS[j], NORMALS[k])) != ZERO)
    rows = {tuple(COSINES[p, s] for s in start): p for p in PLANES}  # a plane by its angles to these
    found = []
    for images in itertools.permutations(PLANES, 3):
        if any(COSINES[images[a], images[b]] != COSINES[start[a], start[b]]
               for a, b in ((0, 1), (0, 2), (1, 2))):
            continue
        to = {tuple(COSINES[p, s] for s in images): p for p in PLANES}
        if len(to) == COUNT and to.keys() == rows.keys():
            found.append([to[row] for row, _ in sorted(rows.items(), key=lambda item: item[1])])
    return found


SYMMETRIES = symmetries()


def planes_of(state):
    return [p for p in PLANES if state >> p & 1]


@functools.lru_cache(None)
def canonical(state):
    planes = planes_of(state)
    return min(sum(1 << to[p] for p in planes) for to in SYMMETRIES)


# --- solids and their measures --------------------------------------------------------------------

def is_bounded(state):
    """Whether no ray, along which two of the planes meet, stays inside all: an unbounded solid with a
    vertex has such an edge, and one without has its line among them."""
    return not any(state & pair == pair and not state & blocked for pair, blocked in BLOCKERS)


def edges_of(state):
    """(plane, plane, end, end) of every edge."""
    by_pair = {}
    for point, (through, beyond) in POINTS.items():
        planes = planes_of(through & state)
        if beyond & state or len(planes) < 3:
            continue
        for pair in itertools.combinations(planes, 2):
            by_pair.setdefault(pair, []).append(point)
    return [(i, j, ends[0], ends[1]) for (i, j), ends in by_pair.items() if len(ends) == 2]


@functools.lru_cache(None)
def volume(state):
    """Cones from the origin over triangles from where a plane touches the sphere to its edges."""
    six_thirds = ZERO  # six times the volume, and v/3 is that point of plane v
    for i, j, p, q in edges_of(state):
        for n in (NORMALS[i], NORMALS[j]):
            six_thirds = six_thirds + abs(dot(n, cross(p, q)))
    return six_thirds * Golden(Fraction(1, 18))


# 4 pi b = c[0] t1 + c[1] sqrt(2) t2 + c[2] pi + c[3] sqrt(2) pi. An edge between planes i, j is
# parallel to v_i x v_j, of length sqrt(9 - (v_i.v_j)^2): 2 at the angle t1, 2 sqrt(2) at t2.
ANGLES = {ROOT5: (0, 1, 0), ONE: (1, 1, 0), -ONE: (1, -1, 1), -ROOT5: (0, -1, 1)}  # kind, t, pi


@functools.lru_cache(None)
def mean_width(state):
    sums = [ZERO] * 4
    for i, j, p, q in edges_of(state):
        along = cross(NORMALS[i], NORMALS[j])
        axis = next(k for k in range(3) if along[k] != ZERO)
        length = Golden(2) * abs(minus(p, q)[axis] / along[axis])
        kind, angles, turns = ANGLES[COSINES[i, j]]
        sums[kind] = sums[kind] + length * Golden(angles)
        sums[2 + kind] = sums[2 + kind] + length * Golden(turns)
    return tuple(sums)


class Enclosures:
    """Lower and upper ends of the four numbers of a mean width, times 2^bits."""

    def __init__(self, bits):
        self.one = 1 << bits
        root2 = self.root(2 * self.one * self.one)
        self.root5 = self.root(5 * self.one * self.one)
        # t1 = atan(sqrt(4/5)), t2 = 2 atan(sqrt(1/2))
        t1 = self.twice(self.atan(self.tangent_of_half(self.root(self.one * self.one * 4 // 5, 1))))
        pi = self.minus(self.times(16, self.atan(self.quotient(1, 5))),
                        self.times(4, self.atan(self.quotient(1, 239))))  # Machin
        t2 = self.times(4, self.atan(self.tangent_of_half(self.root(self.one * self.one // 2, 1))))
        self.basis = [t1, self.product(root2, t2), pi, self.product(root2, pi)]

    def root(self, square, slack=0):
        return math.isqrt(square), math.isqrt(square + slack) + 1

    def quotient(self, a, b):
        return a * self.one // b, -(-a * self.one // b)

    def times(self, factor, x):
        return factor * x[0], factor * x[1]

    def twice(self, x):
        return self.times(2, x)

    def minus(self, x, y):
        return x[0] - y[1], x[1] - y[0]

    def product(self, x, y):
        ends = [a * b for a in x for b in y]
        return min(ends) // self.one, -(-max(ends) // self.one)

    def tangent_of_half(self, x):
        """tan(a/2) = (sqrt(1 + x^2) - 1) / x rises with x = tan a > 0."""
        low = (math.isqrt(self.one**2 + x[0]**2) - self.one) * self.one // x[0]
        high = -(-(math.isqrt(self.one**2 + x[1]**2) + 1 - self.one) * self.one // x[1])
        return low, high

    def atan(self, x):
        """x - x^3/3 + ... for 0 < x < 1/2. Each term is off by less than two units, in a power and
        in its quotient, and the rest of the series is below its first term that is left out."""
        def at(end):
            total, power, n, terms = 0, end, 1, 0
            while power:
                total += (-1 if n & 2 else 1) * (power // n)
                power, n, terms = power * end // self.one * end // self.one, n + 2, terms + 1
            return total, 4 * terms + 4
        low, high = at(x[0]), at(x[1])
        return low[0] - low[1], high[0] + high[1]

    def sign(self, coefficients):
        """1 or -1; 0 if it takes more bits."""
        total = [0, 0]
        for c, base in zip(coefficients, self.basis):
            scale = math.lcm(c.a.denominator, c.b.denominator)
            by_root5 = self.times(int(c.b * scale), self.root5)
            whole = int(c.a * scale) * self.one
            ends = sorted([whole + by_root5[0], whole + by_root5[1]])
            low, high = self.product(ends, base)
            total = [total[0] + low // scale, total[1] - (-high // scale)]
        return (total[0] > 0) - (total[1] < 0)


ENCLOSURES = [Enclosures(128), Enclosures(256)]


def order_of_widths(x, y):
    difference = tuple(a - b for a, b in zip(x, y))
    if all(c == ZERO for c in difference):
        return 0
    for enclosures in ENCLOSURES:
        if sign := enclosures.sign(difference):
            return sign
    raise ArithmeticError('two mean widths agree to 256 bits, and nothing shows that they are equal')


def order_of_volumes(x, y):
    return (x - y).sign()


MEASURES = {'volume': (volume, order_of_volumes), 'mean-width': (mean_width, order_of_widths)}


# --- the walk -------------------------------------------------------------------------------------

def cheapest(state, measure):
    """The removals that leave the least measure; none if the walk ends here."""
    if state.bit_count() == 4:
        return []
    measure_of, order = MEASURES[measure]
    best, tied = None, []
    for p in planes_of(state):
        smaller = state & ~(1 << p)
        if not is_bounded(smaller):
            continue
        value = measure_of(canonical(smaller))
        against = -1 if best is None else order(value, best)
        if against < 0:
            best, tied = value, [smaller]
        elif against == 0:
            tied.append(smaller)
    return tied


def walk(measure):
    """State -> its children with their probabilities; all states up to symmetry."""
    start = (1 << COUNT) - 1
    children, queue = {}, [start]
    while queue:
        state = queue.pop()
        if state in children:
            continue
        shares = {}
        tied = cheapest(state, measure)
        for smaller in map(canonical, tied):
            shares[smaller] = shares.get(smaller, 0) + Fraction(1, len(tied))
        children[state] = shares
        queue.extend(shares)
    return children


def ends(children):
    """Last state -> the probability to end there."""
    probability = {(1 << COUNT) - 1: Fraction(1)}
    last = {}
    for state in sorted(children, key=int.bit_count, reverse=True):
        if not children[state]:
            last[state] = probability[state]
        for smaller, share in children[state].items():
            probability[smaller] = probability.get(smaller, 0) + probability[state] * share
    return last


# Volumes at inradius 1 over sqrt(3): from the closed forms of the solids, as the planes here touch a
# sphere of radius 1/sqrt(3), that is 3 times the volumes here.
ENDS = {
    'irregular tetrahedron': Golden(8, Fraction(16, 5)),
    'other tetrahedron': Golden(9, 4),
    'rhombohedron, least': Golden(0, Fraction(12, 5)),
    'regular tetrahedron': Golden(8),
    'rhombohedron, other': Golden(6),
}
# Worked out once by a walk in doubles, of which this is the exact repetition.
PROBABILITIES = {
    'volume': {'irregular tetrahedron': Fraction(2711563, 2830464),
               'other tetrahedron': Fraction(623761, 18869760),
               'rhombohedron, least': Fraction(31207, 8087040),
               'regular tetrahedron': Fraction(11, 2880),
               'rhombohedron, other': Fraction(11, 8640)},
    'mean-width': {'irregular tetrahedron': Fraction(651513349, 679311360),
                   'other tetrahedron': Fraction(623761, 18869760),
                   'rhombohedron, least': Fraction(1068523, 135862272)},
}
# Costs of the first twelve removals that the author's public program keeps as its own test values, at
# circumradius 1, as often as they occur.
AUTHORS = {
    'volume': {0.0433226262: 7, 0.1134201078: 3, 0.2969376972: 2},
    'mean-width': {0.0122495427: 7, 0.0638038177: 3, 0.1069034234: 1, 0.1136260209: 1},
}
AUTHORS_AREA = {0.1635526924: 7, 0.4281865077: 3, 0.8563730155: 1, 1.1210068307: 1}
INRADIUS = math.sqrt((5 + 2 * math.sqrt(5)) / 15)  # at circumradius 1
WIDTHS = [math.atan(2 / math.sqrt(5)), math.sqrt(2) * math.atan(math.sqrt(8)), math.pi,
          math.sqrt(2) * math.pi]


def in_doubles(state, measure):
    """At circumradius 1."""
    scale = INRADIUS * math.sqrt(3)
    if measure == 'mean-width':
        return scale * sum(float(c) * w for c, w in zip(mean_width(state), WIDTHS)) / (4 * math.pi)
    if measure == 'area':
        return scale**2 * 3 * math.sqrt(3) * float(volume(state))
    return scale**3 * float(volume(state))


def is_among_the_walks(children, measure, expected):
    """Whether some walk's first removals cost `expected`, in any order."""
    costs = sorted(expected)
    fronts = {((1 << COUNT) - 1, (0,) * len(costs))}
    for _ in range(sum(expected.values())):
        following = set()
        for state, used in fronts:
            for smaller in children[state]:
                cost = in_doubles(smaller, measure) - in_doubles(state, measure)
                near = [k for k, c in enumerate(costs) if abs(c - cost) < 1e-9]
                if near and used[near[0]] < expected[costs[near[0]]]:
                    count = list(used)
                    count[near[0]] += 1
                    following.add((smaller, tuple(count)))
        fronts = following
    return bool(fronts)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--table', action='store_true', help='print the ends and their probabilities')
    options = parser.parse_args()
    wrong = []

    def expect(holds, what):
        if not holds:
            wrong.append(what)

    expect(len(SYMMETRIES) == 120, f'{len(SYMMETRIES)} symmetries instead of 120')
    expect(volume((1 << COUNT) - 1) * Golden(3) == Golden(70, -30), 'the volume of the icosahedron')
    for measure in MEASURES:
        children = walk(measure)
        found = {}
        for state, share in ends(children).items():
            name = next((n for n, v in ENDS.items() if v == volume(state) * Golden(3)), hex(state))
            found[name] = found.get(name, 0) + share
        expect(found == PROBABILITIES[measure], f'ends by {measure}: {found}')
        expect(is_among_the_walks(children, measure, AUTHORS[measure]), f"the author's costs by {measure}")
        if measure == 'volume':  # the same walks by area
            expect(is_among_the_walks(children, 'area', AUTHORS_AREA), "the author's costs by area")
        print(f'by {measure}: {len(children)} states')
        if options.table:
            for name, share in sorted(found.items(), key=lambda item: -item[1]):
                print(f'  {name:24} {share}  = {float(share):.6f}')
    for what in wrong:
        print('wrong: ' + what)
    return bool(wrong)


if __name__ == '__main__':
    sys.exit(main())
