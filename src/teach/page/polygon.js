// SPDX-License-Identifier: MIT
// The construction for a polygon, in exact rationals: halfplanes of points, their dual points, what a removal
// adds, and the greedy run. Everything follows from the points and the center; nothing is drawn here.
"use strict";

const zero = new Rational(0n), one = new Rational(1n), two = new Rational(2n);
const cross2 = (a, b) => a[0].times(b[1]).minus(a[1].times(b[0]));
const scaled = (a, factor) => a.map(x => x.times(factor));

// The corners of the convex hull, as indices, counter-clockwise; no three in line.
function hullOf(points) {
  const order = points.map((_, k) => k).sort((a, b) => points[a][0].compare(points[b][0]) || points[a][1].compare(points[b][1]));
  const chain = list => {
    const corners = [];
    for (const p of list) {
      const turns = () => cross2(difference(points[corners.at(-1)], points[corners.at(-2)]), difference(points[p], points[corners.at(-1)])).sign();
      while (corners.length > 1 && turns() <= 0) corners.pop();
      if (corners.length === 0 || points[corners.at(-1)].some((x, k) => x.compare(points[p][k]) !== 0)) corners.push(p);
    }
    return corners.slice(0, -1);
  };
  return [...chain(order), ...chain(order.reverse())];
}

// n.x + d <= 0 through a and b, with the polygon on the left of a -> b; in integers without a common divisor.
function halfplaneThrough(a, b) {
  const along = difference(b, a), n = [along[1], along[0].negated()], row = [...n, dot(n, a).negated()];
  const factor = row.reduce((product, x) => product.times(new Rational(x.reduce().d)), one);
  const whole = row.map(x => x.times(factor).reduce().n), divisor = whole.reduce((u, v) => {
    [u, v] = [u < 0n ? -u : u, v < 0n ? -v : v];
    while (v) [u, v] = [v, u % v];
    return u;
  });
  const [x, y, d] = whole.map(z => new Rational(z / divisor));
  return {n: [x, y], d};
}

// Of the hull of points, in canonical order: by n, lexicographically. Their places are their ids.
function halfplanesOf(points) {
  const hull = hullOf(points);
  return hull.map((p, k) => halfplaneThrough(points[p], points[hull[(k + 1) % hull.length]]))
    .sort((a, b) => a.n[0].compare(b.n[0]) || a.n[1].compare(b.n[1])).map((plane, id) => ({...plane, id}));
}

const value = (plane, x) => dot(plane.n, x).plus(plane.d);
const isInside = (planes, x) => planes.every(plane => value(plane, x).sign() < 0);
// Where two lines meet; they are not parallel.
function meet(p, q) {
  const w = cross2(p.n, q.n);
  return [p.n[1].times(q.d).minus(q.n[1].times(p.d)).over(w), q.n[0].times(p.d).minus(p.n[0].times(q.d)).over(w)];
}
// p with the line at p.y = 1, seen from the center.
const dualPoint = (plane, center) => scaled(plane.n, one.over(value(plane, center).negated()));

// The polygon of halfplanes around a center, found on the dual: those that bound it, counter-clockwise, and the
// corner between each and the next one. Not bounded: corners beyond infinity are null.
function polygonOf(planes, center) {
  const dual = planes.map(plane => dualPoint(plane, center));
  const sides = hullOf(dual).map(k => ({...planes[k], dual: dual[k]}));
  const corners = sides.map((side, k) => {
    const next = sides[(k + 1) % sides.length];
    return cross2(side.dual, next.dual).sign() > 0 ? meet(side, next) : null;
  });
  return {sides, corners, isBounded: !corners.includes(null), redundant: planes.filter(plane => !sides.some(side => side.id === plane.id))};
}

const areaOf = corners => corners.reduce((sum, a, k) => sum.plus(cross2(a, corners[(k + 1) % corners.length])), zero).over(two);

// What the polygon gains where a side goes: a triangle between the side and its neighbours' lines. They meet if the
// segment between the neighbours' dual points passes the center on the side of this one: D > 0.
function capOf(polygon, k) {
  const m = polygon.sides.length, side = polygon.sides[k], before = polygon.sides[(k + m - 1) % m], after = polygon.sides[(k + 1) % m];
  const D = cross2(before.dual, after.dual), cap = {side, before, after, D, tip: null, area: null};
  if (m < 4 || D.sign() <= 0) return cap;
  const tip = meet(before, after), corners = [polygon.corners[(k + m - 1) % m], tip, polygon.corners[k]];
  const area = areaOf(corners);
  return {...cap, tip, area: area.sign() < 0 ? area.negated() : area};
}
const capsOf = polygon => polygon.sides.map((_, k) => capOf(polygon, k));

// The cheapest removal, the first in canonical order of equal ones; null if all are unbounded.
function cheapest(caps) {
  const bounded = caps.filter(cap => cap.area !== null);
  if (bounded.length === 0) return null;
  const least = bounded.map(cap => cap.area).reduce((a, b) => a.compare(b) <= 0 ? a : b);
  const tied = bounded.filter(cap => cap.area.compare(least) === 0).sort((a, b) => a.side.id - b.side.id);
  return {...tied[0], tied: tied.map(cap => cap.side.id)};
}

// The least area that so many of the halfplanes bound, by trying all choices.
function leastArea(planes, center, count) {
  let least = null;
  const choose = (from, chosen) => {
    if (chosen.length === count) {
      const {isBounded, corners} = polygonOf(chosen, center), area = isBounded && areaOf(corners);
      if (area && (least === null || area.compare(least) < 0)) least = area;
      return;
    }
    for (let k = from; k < planes.length; ++k) choose(k + 1, [...chosen, planes[k]]);
  };
  choose(0, []);
  return least;
}

// All removals, each with the polygon before it.
function runOf(planes, center) {
  const steps = [];
  let left = planes, polygon = polygonOf(left, center);
  for (let next = cheapest(capsOf(polygon)); next; next = cheapest(capsOf(polygon))) {
    steps.push({polygon, ...next});
    left = left.filter(plane => plane.id !== next.side.id);
    polygon = polygonOf(left, center);
  }
  return {steps, last: polygon};
}
