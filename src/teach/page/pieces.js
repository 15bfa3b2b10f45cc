// SPDX-License-Identifier: MIT
// Parts of a polygon, in exact rationals: pieces that a line leaves, hulls, distances, and the proof by squares that
// no point of a part is farther from the polygon than a given distance. Nothing is drawn here.
"use strict";

// Beyond the line from a to b: on its right.
const beyond = (line, x) => cross2(difference(x, line[0]), difference(line[1], line[0])).sign() > 0;

// The pieces of a simple polygon, corners counter-clockwise, on both sides of a line. Corners on the line count as if
// the line were moved by less than anything, to the side on which more pieces come apart.
function cutBy(line, polygon) {
  const reversed = [line[1], line[0]], [a, b] = [cutOnce(line, polygon), cutOnce(reversed, polygon)];
  return a.length >= b.length ? a : b;
}
function cutOnce(line, polygon) {
  const n = polygon.length, along = difference(line[1], line[0]), nodes = [], crossings = [];
  for (let k = 0; k < n; ++k) {
    const a = polygon[k], b = polygon[(k + 1) % n], isBeyond = beyond(line, a);
    nodes.push({at: a, isBeyond});
    if (isBeyond === beyond(line, b)) continue;
    const u = cross2(difference(a, line[0]), along), v = cross2(difference(b, line[0]), along), t = u.over(u.minus(v));
    const at = a.map((x, i) => x.plus(b[i].minus(x).times(t)));
    crossings.push({place: nodes.push({at, isBeyond: null, goesBeyond: !isBeyond}) - 1, s: dot(difference(at, line[0]), along)});
  }
  if (crossings.length === 0) return [polygon];
  crossings.sort((p, q) => p.s.compare(q.s));
  // Between the first and the second crossing along the line lies the polygon, then a gap, and so on.
  for (let k = 0; k + 1 < crossings.length; k += 2) {
    const [p, q] = [crossings[k].place, crossings[k + 1].place];
    [nodes[p].across, nodes[q].across] = [q, p];
  }
  const pieces = [], taken = new Set();
  for (const {place} of crossings) {
    if (taken.has(place)) continue;  // each crossing begins one piece: the one that the boundary enters there
    const piece = [];
    let k = place;
    do {
      taken.add(k);
      piece.push(nodes[k].at);
      for (k = (k + 1) % nodes.length; nodes[k].isBeyond !== null; k = (k + 1) % nodes.length) piece.push(nodes[k].at);
      piece.push(nodes[k].at);
      k = nodes[k].across;
    } while (k !== place);
    pieces.push(piece.filter((p, i) => p.some((x, j) => x.compare(piece[(i + 1) % piece.length][j]) !== 0)));
  }
  return pieces.filter(piece => piece.length > 2 && areaOf(piece).sign() > 0);
}

const hullPolygon = points => hullOf(points).map(k => points[k]);

function isInPolygon(polygon, x) {
  let isIn = false;
  polygon.forEach((a, k) => {
    const b = polygon[(k + 1) % polygon.length], up = a[1].compare(x[1]) > 0;
    if (up === b[1].compare(x[1]) > 0) return;
    const turn = cross2(difference(b, a), difference(x, a)).sign();
    if (up ? turn < 0 : turn > 0) isIn = !isIn;
  });
  return isIn;
}
function squaredToSegment(x, a, b) {
  const along = difference(b, a), s = dot(difference(x, a), along), length = dot(along, along);
  const t = s.sign() <= 0 ? zero : s.compare(length) >= 0 ? one : s.over(length);
  const away = difference(x, a.map((c, i) => c.plus(along[i].times(t))));
  return dot(away, away);
}
// Of the distance to the nearest point of the polygon; 0 inside.
const squaredTo = (polygon, x) => isInPolygon(polygon, x) ? zero
  : polygon.map((a, k) => squaredToSegment(x, a, polygon[(k + 1) % polygon.length])).reduce((a, b) => a.compare(b) <= 0 ? a : b);
const isInConvex = (part, x) => part.every((a, k) => cross2(difference(part[(k + 1) % part.length], a), difference(x, a)).sign() >= 0);
// Whether one side of the part has all corners of the square strictly outside.
const isApart = (part, corners) => part.some((a, k) => {
  const along = difference(part[(k + 1) % part.length], a);
  return corners.every(x => cross2(along, difference(x, a)).sign() < 0);
});

// The left and the lower end, and the side, of a square that holds the points.
function squareAround(points) {
  const [[left, right], [low, high]] = [0, 1].map(k => points.map(p => p[k]).reduce(([a, b], x) => [a.compare(x) <= 0 ? a : x, b.compare(x) >= 0 ? b : x], [points[0][k], points[0][k]]));
  const width = right.minus(left), height = high.minus(low);
  return [left, low, width.compare(height) >= 0 ? width : height];
}

const kDiagonal = new Rational(99n, 70n);  // more than the root of 2, so half a square's diagonal is less than this times half its side

// Squares that cover a part, divided until each is proven or as small as 2^-depth of the first. "within": the middle is so
// near that the whole square is; "beyond": the middle is a point of the part that is farther; "open": neither.
function squaresOver(part, polygon, distance, depth) {
  const [begin, low, side] = squareAround(part), half = side.over(two), found = [];
  const visit = (middle, r, left) => {
    const corners = [[-1n, -1n], [1n, -1n], [1n, 1n], [-1n, 1n]].map(signs => middle.map((x, k) => x.plus(r.times(new Rational(signs[k])))));
    if (isApart(part, corners)) return;
    const squared = squaredTo(polygon, middle), room = distance.minus(r.times(kDiagonal)), square = {middle, half: r, squared};
    if (room.sign() >= 0 && squared.compare(room.times(room)) <= 0) found.push({...square, state: "within"});
    else if (squared.compare(distance.times(distance)) > 0 && isInConvex(part, middle)) found.push({...square, state: "beyond"});
    else if (left === 0) found.push({...square, state: "open"});
    else for (const corner of corners) visit(middle.map((x, k) => x.plus(corner[k]).over(two)), r.over(two), left - 1);
  };
  visit([begin, low].map(x => x.plus(half)), half, depth);
  return found;
}
// "within" if all squares are; "beyond" if one is; else "open".
const verdictOf = squares => ["beyond", "open"].find(state => squares.some(square => square.state === state)) ?? "within";

// A point of the part far from the polygon, on a grid of 2^-6 of its width; by bounds in doubles, the distance exact.
function farPoint(part, polygon) {
  let best = {at: part[0], squared: zero};
  const consider = at => {
    if (!isInConvex(part, at)) return;
    const squared = squaredTo(polygon, at);
    if (squared.compare(best.squared) > 0) best = {at, squared};
  };
  part.forEach((a, k) => {
    const b = part[(k + 1) % part.length];
    for (let i = 0n; i < 16n; ++i) consider(a.map((x, j) => x.plus(b[j].minus(x).times(new Rational(i, 16n)))));
  });
  const [left, low, whole] = squareAround(part), queue = [{u: 0n, v: 0n, level: 0n}];
  while (queue.length) {
    const {u, v, level} = queue.pop(), side = whole.over(new Rational(1n << level)), middle = [left, low].map((x, k) => x.plus(side.times(new Rational(2n * [u, v][k] + 1n, 2n))));
    const corners = [[0n, 0n], [1n, 0n], [1n, 1n], [0n, 1n]].map(([i, j]) => [left.plus(side.times(new Rational(u + i))), low.plus(side.times(new Rational(v + j)))]);
    if (isApart(part, corners)) continue;
    consider(middle);
    const reach = Math.sqrt(squaredTo(polygon, middle).toNumber()) + side.toNumber() * 0.7072;
    if (level < 6n && reach > Math.sqrt(best.squared.toNumber()) * 1.01) {
      for (const [i, j] of [[0n, 0n], [1n, 0n], [0n, 1n], [1n, 1n]]) queue.push({u: 2n * u + i, v: 2n * v + j, level: level + 1n});
    }
  }
  return best;
}
