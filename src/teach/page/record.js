// SPDX-License-Identifier: MIT
// What the engine recorded, and how its numbers are written: as text and in formulas. Every number of the
// record carries the place it comes from (data-at, a JSON pointer into the lesson); numbers that the page
// works out from them carry data-computed.
"use strict";

const lesson = JSON.parse(document.getElementById("lesson").textContent);
const recorded = place => place.split("/").slice(1).reduce((part, key) => part[key], lesson);
const display = {digits: false, doubles: false, labels: lesson.halfspaces.length <= 60};

// --- numbers as text and in formulas ---------------------------------------------------------------

const kShort = 11;  // characters; longer fractions are shown by their first digits unless all are asked for
const kDigits = 4;
const isShort = text => display.digits || text.length <= kShort;
// Costs of long fractions are shown again at every step.
const decimals = new Map();
function decimalOf(text) {
  if (!decimals.has(text)) decimals.set(text, Rational.of(text).decimal(kDigits));
  return decimals.get(text);
}
const inText = text => isShort(text) ? text.replace("-", "\u2212") : decimalOf(text);
const inFormula = text => {
  if (!isShort(text)) return `<mn>${decimalOf(text)}</mn>`;
  const [n, d] = text.replace("-", "").split("/");
  return (text[0] === "-" ? "<mo form='prefix'>\u2212</mo>" : "") + (d ? `<mfrac><mn>${n}</mn><mn>${d}</mn></mfrac>` : `<mn>${n}</mn>`);
};
const source = (place, text) => `${place === null ? "data-computed" : `data-at="${place}" data-exact`}="${text}"`;
// A number of the record, by its place, or one that the page computed.
const number = (place, text = recorded(place)) => `<span class="number" ${source(place, text)} title="${text}">${inText(text)}</span>`;
const computed = x => number(null, String(x));
const math = (place, text = recorded(place)) => `<mrow class="number" ${source(place, text)}>${inFormula(text)}</mrow>`;
const mathOf = x => math(null, String(x));
const list = (place, of = number) => recorded(place).map((_, k) => of(`${place}/${k}`)).join(", ");
const triple = place => `(${list(place)})`;
const column = place => `<mrow><mo>(</mo>${recorded(place).map((_, k) => math(`${place}/${k}`)).join("<mo>,</mo>")}<mo>)</mo></mrow>`;
// A cost: a fraction of volumes; of other measures certain digits, or the terms of the sum.
function cost(place, value = recorded(place)) {
  if (value === null) return "unbounded";
  if (value.exact !== undefined) return number(`${place}/exact`);
  const digits = `<span class="number" data-at="${place}/decimal" data-exact="${value.decimal}">${value.decimal}\u2026</span>`;
  if (!display.digits) return digits;
  return digits + (value.roots ? " = " + value.roots.map(([q, n]) => `${q} \u221a${n}`).join(" + ")
    : " = (" + value.edges.map(([f, l, c, d]) => `${f} \u221a(${l}) atan2(\u221a(${c}), ${d})`).join(" + ") + ") / 4\u03c0");
}

const formula = (...parts) => `<div class="formula"><math display="block"><mrow>${parts.join("")}</mrow></math></div>`;
const word = text => `<mtext>${text}</mtext>`;
const mi = name => `<mi>${name}</mi>`, mo = sign => `<mo>${sign}</mo>`, mn = text => `<mn>${text}</mn>`;
const sub = (name, index) => `<msub><mi>${name}</mi><mn>${index}</mn></msub>`;
const tag = id => `<b class="id">${id}</b>`;
const tags = ids => ids.map(tag).join(", ");
const many = (count, one, more = one + "s") => count === 1 ? `1 ${one}` : `${count} ${more}`;
const table = (head, rows, label) => `<div class="scroll" tabindex="0" role="region" aria-label="${label}"><table><thead><tr>${
  head.map(cell => `<th scope="col">${cell}</th>`).join("")}</tr></thead><tbody>${rows.join("")}</tbody></table></div>`;
const row = (cells, attributes = "") => `<tr ${attributes}>${cells.map(cell => `<td>${cell}</td>`).join("")}</tr>`;
const verdict = holds => holds ? '<span class="yes">\u2713 yes</span>' : '<span class="no">\u2717 NO</span>';

const plane = i => vector(lesson.halfspaces[i].plane);
// A plane as it is shown: its integers or, where these are long, divided by the largest entry of the normal.
const isScaled = i => !lesson.halfspaces[i].plane.every(isShort);
function shownPlane(i) {
  const p = plane(i), sizes = p.slice(0, 3).map(x => x.sign() < 0 ? x.negated() : x);
  return isScaled(i) ? p.map(x => x.over(sizes.reduce((a, b) => a.compare(b) > 0 ? a : b))) : p;
}
const planeText = i => `(${isScaled(i) ? shownPlane(i).map(computed).join(", ") : list(`/halfspaces/${i}/plane`)})`;
const scaledNote = ids => ids.some(isScaled) ? "<p>Planes of long integers are shown divided by the largest entry of n, which moves no plane; <i>all digits</i> shows the integers.</p>" : "";
// D = det(n_a, n_b, n_c), and H: the determinant of four rows (n, d).
const gap = ids => det(...ids.map(i => plane(i).slice(0, 3)));
const height = (ids, p) => det4([...ids, p].map(plane));

// --- the solid and its dual at any time ------------------------------------------------------------

const key = ids => {  // of a triangle, the same from each corner
  const k = ids.indexOf(Math.min(...ids));
  return [ids[k], ids[(k + 1) % 3], ids[(k + 2) % 3]].join(",");
};

// The dual hull as its triangles: third(i, j) is the corner to the left of i -> j, as in the adjacency matrix.
class Surface {
  constructor(edges = new Map()) {
    this.edges = edges;
  }
  static edge(i, j) { return i * lesson.halfspaces.length + j; }
  third(i, j) { return this.edges.get(Surface.edge(i, j))?.third; }
  vertex(i, j) { return this.edges.get(Surface.edge(i, j)).vertex; }
  add([a, b, c], vertex) {
    for (const [i, j, third] of [[a, b, c], [b, c, a], [c, a, b]]) this.edges.set(Surface.edge(i, j), {third, vertex});
  }
  remove([a, b, c]) {
    for (const [i, j] of [[a, b], [b, c], [c, a]]) this.edges.delete(Surface.edge(i, j));
  }
  after(removal, place) {
    const next = new Surface(new Map(this.edges)), k = removal.ring.length;
    removal.ring.forEach((from, t) => next.remove([removal.removed, from, removal.ring[(t + 1) % k]]));
    removal.triangles.forEach((triangle, t) => next.add(triangle.corners, `${place}/triangles/${t}/vertex`));
    return next;
  }
  rows() {
    if (this.known) return this.known;
    this.known = new Map();
    const n = lesson.halfspaces.length;
    for (const edge of this.edges.keys()) {
      const i = Math.floor(edge / n), j = edge % n;
      if (!this.known.has(i)) this.known.set(i, j);
      else this.known.set(i, Math.min(j, this.known.get(i)));
    }
    return this.known;
  }
  present() { return [...this.rows().keys()].sort((a, b) => a - b); }
  ring(i) {
    const first = this.rows().get(i), ring = [first];
    for (let j = this.third(i, first); j !== first && ring.length <= lesson.halfspaces.length; j = this.third(i, j)) ring.push(j);
    return ring;
  }
  triangles() {
    const found = [];
    for (const [edge, {third, vertex}] of this.edges) {
      const n = lesson.halfspaces.length, i = Math.floor(edge / n), j = edge % n;
      if (i < j && i < third) found.push({corners: [i, j, third], vertex});
    }
    return found.sort((x, y) => x.corners[0] - y.corners[0] || x.corners[1] - y.corners[1]);
  }
}

const surfaces = [];  // before the first removal shown, after it, and so on
function surfaceAfter(count) {
  if (surfaces.length === 0) {
    const start = new Surface(), {triangles, vertex_of} = lesson.topology;
    triangles.forEach((triangle, t) => start.add(triangle, `/topology/vertices/${vertex_of[t]}`));
    surfaces.push(start);
  }
  while (surfaces.length <= count) {
    const k = surfaces.length - 1;
    surfaces.push(surfaces[k].after(lesson.removals[k], `/removals/${k}`));
  }
  return surfaces[count];
}

// Costs of all candidates before a removal: the latest evaluation of each, by its place in the record.
function candidates(k) {
  const done = lesson.topology.step + k, latest = new Map();
  lesson.evaluations.forEach((evaluation, e) => {
    if (evaluation.step <= done) latest.set(evaluation.halfspace, e);
  });
  const gone = new Set(lesson.removals.slice(0, k).map(removal => removal.removed));
  const list = [...latest].filter(([i]) => !gone.has(i)).map(([i, e]) => ({i, e, cost: lesson.evaluations[e].cost}));
  const exact = list.every(({cost}) => cost === null || cost.exact !== undefined);
  const value = new Map(list.map(({i, cost}) => [i, cost && (exact ? Rational.of(cost.exact) : Number(cost.decimal))]));
  const order = (a, b) => exact ? value.get(a).compare(value.get(b)) : value.get(a) - value.get(b);
  return list.sort((a, b) => a.cost === null || b.cost === null
    ? (a.cost === null) - (b.cost === null) || a.i - b.i : order(a.i, b.i) || a.i - b.i);
}

// --- what is drawn ---------------------------------------------------------------------------------

// Whether each axis of the solid is drawn to a scale of its own: angles are not what they were.
const isStretched = new Set(lesson.frame.scale).size > 1;
const drawnDual = (i, center = [0, 0, 0]) => {
  const [a, b, c, d] = lesson.halfspaces[i].drawn, w = -(a * center[0] + b * center[1] + c * center[2] + d);
  return [a / w, b / w, c / w];
};
const labelOf = id => display.labels ? id : undefined;

function solidItem(surface, marks = {}, item = {}) {
  const faces = surface.present().map(i => {
    const ring = surface.ring(i), corners = ring.map(j => surface.vertex(i, j)), texts = corners.map(at => String(recorded(at).exact));
    const points = corners.filter((_, t) => texts[t] !== texts[(t + 1) % texts.length]).map(at => recorded(at).at);
    return {points, pick: `h${i}`, mark: marks[i] || "", label: marks[i] ? i : labelOf(i)};
  });
  return {faces, ...item};
}
function dualItem(surface, marks = {}, triangles = {}, center) {
  const at = i => drawnDual(i, center);
  return {
    faces: surface.triangles().map(({corners}) => ({points: corners.map(at), pick: `t${key(corners)}`, mark: triangles[key(corners)] || ""})),
    dots: surface.present().map(i => ({at: at(i), pick: `h${i}`, mark: marks[i] || "", label: marks[i] ? i : labelOf(i)})),
  };
}
const origin = {dots: [{at: [0, 0, 0], mark: "center", label: "origin"}]};
const radiusOf = items => Math.max(1e-300, ...items.flatMap(item => [
  ...(item.faces || []).flatMap(face => face.points), ...(item.dots || []).map(dot => dot.at),
  ...(item.lines || []).flatMap(line => [line.from, line.to])]).map(p => Math.hypot(...p)));
