// SPDX-License-Identifier: MIT
// The lesson in the plane: what is drawn and said, what can be dragged, and what is asked.
"use strict";

function rowText(plane) {
  const sign = x => x.sign() < 0 ? "\u2212" : "+", size = x => (x.sign() < 0 ? x.negated() : x).toString();
  const term = (x, letter) => `${size(x) === "1" ? "" : size(x)}${letter}`;
  const terms = [[plane.n[0], "x"], [plane.n[1], "y"]].filter(([x]) => x.sign() !== 0);
  const left = terms.map(([x, letter], k) => (k === 0 ? (x.sign() < 0 ? "\u2212" : "") : ` ${sign(x)} `) + term(x, letter)).join("");
  return `${left} \u2264 ${plane.d.negated().toString().replace("-", "\u2212")}`;
}

// ---- The model: all that follows from points, center and what was moved

// A place on the grid near the mean of the corners.
function middleOf(points) {
  const hull = hullOf(points), sum = hull.reduce((s, k) => s.map((x, i) => x.plus(points[k][i])), [zero, zero]);
  return sum.map(x => onGrid(x.over(new Rational(BigInt(hull.length))).toNumber(), centerGrid));
}
// Null if the points have no area, or the center is not inside.
function modelOf({points, center, picked, stretch}) {
  if (hullOf(points).length < 3) return null;
  const planes = halfplanesOf(points);
  if (!isInside(planes, center)) return null;
  const polygon = polygonOf(planes, center), caps = capsOf(polygon);
  const side = polygon.sides.find(s => s.id === picked) ?? null;
  const moved = side && planes.map(p => p.id === picked ? {...p, d: stretch.times(value(p, center)).minus(dot(p.n, center))} : p);
  return {planes, polygon, caps, side, cap: side && caps.find(cap => cap.side.id === picked), next: cheapest(caps), run: runOf(planes, center),
    moved: moved && {polygon: polygonOf(moved, center), plane: moved.find(p => p.id === picked)}};
}

// ---- Drawing

let dualScale = 1;
const toDual = p => [p[0].toNumber() * dualScale, -p[1].toNumber() * dualScale];
// A side with a broad strip around it that takes the pointer.
const strip = (a, b, mark, more) => `<path class="line side ${mark}" d="M${path([a, b])}"/><path class="grip" d="M${path([a, b])}" ${more}/>`;
const outward = (a, b, far) => {
  const [u, v] = [b[0] - a[0], b[1] - a[1]], length = Math.hypot(u, v) || 1;
  return [(a[0] + b[0]) / 2 + v / length * far, (a[1] + b[1]) / 2 - u / length * far];
};
const isOff = ([x, y]) => Math.abs(x) > 195 || Math.abs(y) > 195;

function drawPolygon(polygon, {marks = {}, areas = null, isGhost = false, picks = true} = {}) {
  const corners = polygon.corners.map(toSolid), m = corners.length;
  if (isGhost) return `<path class="line ghost" d="M${path(corners)}Z"/>`;
  let text = `<path class="face front" d="M${path(corners)}Z"/>`, labels = "";
  polygon.sides.forEach((side, k) => {
    const a = corners[(k + m - 1) % m], b = corners[k], mark = marks[side.id] ?? "", at = outward(b, a, areas ? -13 : 15);
    text += strip(a, b, mark, picks ? `data-side="${side.id}" tabindex="0" role="button" aria-label="side ${side.id}"` : "");
    if (!isOff(at)) labels += label(at, side.id, mark);
    if (areas?.[side.id] && !isOff(outward(b, a, 20))) labels += label(outward(b, a, 20), areas[side.id], "cost");
  });
  return text + labels;
}

function drawDual(polygon, {marks = {}, ghost = null, picks = true} = {}) {
  const at = polygon.sides.map(side => toDual(side.dual)), m = at.length;
  let text = ghost ? `<path class="line ghost" d="M${path(ghost.sides.map(side => toDual(side.dual)))}Z"/>` : "";
  text += `<path class="face front" d="M${path(at)}Z"/>` + dotAt([0, 0], "center", "", 4);
  polygon.sides.forEach((side, k) => {
    const corner = `${side.id}-${polygon.sides[(k + 1) % m].id}`;
    text += strip(at[k], at[(k + 1) % m], marks[corner] ?? "", picks ? `data-corner="${corner}" tabindex="0" role="button" aria-label="side of the dual between points ${corner.replace("-", " and ")}"` : "");
  });
  polygon.sides.forEach((side, k) => {
    const [x, y] = at[k], length = Math.hypot(x, y) || 1;
    text += dotAt(at[k], marks[side.id] ?? "", picks ? `data-side="${side.id}"` : "") + label([x + 15 * x / length, y + 15 * y / length], side.id, marks[side.id] ?? "");
  });
  return text;
}

const drawPoints = (drags, marks = {}) => state.points.map((p, k) => {
  const more = drags ? `data-point="${k}" tabindex="0" role="button" aria-label="point ${k}"` : "";
  return (drags ? dotAt(toSolid(p), "handle", "", 9) : "") + dotAt(toSolid(p), `waiting ${marks[k] ?? ""}`, more, 4);
}).join("");
const drawCenter = () => dotAt(toSolid(state.center), "handle", "", 10) + dotAt(toSolid(state.center), "center", "data-center=\"1\" tabindex=\"0\" role=\"button\" aria-label=\"center\"", 6) +
  label(toSolid(state.center).map((x, k) => x + (k ? 16 : 12)), "c");
function drawCap(cap) {
  if (!cap.tip) return "";
  const m = model.polygon.sides.length, k = model.polygon.sides.findIndex(side => side.id === cap.side.id);
  const corners = [model.polygon.corners[(k + m - 1) % m], cap.tip, model.polygon.corners[k]].map(toSolid);
  return `<path class="face tight" d="M${path(corners)}Z"/>`;
}

// ---- Chapters: what is wanted, what is seen, what one has in the end

const chapters = [
  {id: "points", title: "Points and halfplanes", show() {
    const hull = hullOf(state.points), corners = new Set(hull);
    const inner = state.points.map((_, k) => k).filter(k => !corners.has(k)), answer = state.answered.points;
    return {
      say: `Wanted: a convex polygon around ${state.points.length} points with as few sides as we like, and as little to spare as possible. We begin with the tightest one, their hull: ${model.planes.length} sides. Drag a point and see which sides care.`,
      solid: drawPolygon(model.polygon) + drawPoints(true, typeof answer === "number" ? {[answer]: "chosen"} : {}), dual: null,
      question: ask("points", "Which point could you take away without any side moving? Click one in the picture.",
        k => !corners.has(k), k => k === "told" || !corners.has(k)
          ? `The points that are no corners of the hull: ${inner.length} of them. They lie inside or on a side, so no side needs them.`
          : `Sides ${list(model.planes.filter(p => value(p, state.points[k]).sign() === 0).map(p => p.id))} go through it, and would move.`),
      more: rows(["halfplane", "its points x, y"], model.planes.map(p => ({cells: [name(p.id), rowText(p)]}))),
      have: "Each side is a <b>halfplane</b>: the points on one side of a line. The polygon is what all of them have in common. We choose among these halfplanes only: to have fewer sides, some must go, and the polygon grows: a point that satisfies all conditions satisfies any selection of them."};
  }},

  {id: "polar", title: "A halfplane becomes a point", begin: {picked: 0}, show() {
    const {side, moved} = model, answer = state.answered.polar;
    const seen = moved ? moved.polygon : model.polygon, isRedundant = moved && moved.polygon.redundant.length > 0;
    const marks = side ? {[side.id]: "chosen"} : {}, at = side && toDual(dualPoint(moved.plane, state.center));
    return {
      say: `Wanted: a picture in which it is easy to see what happens when a halfplane goes. Seen from a center c inside, each line becomes a point, its <b>dual point</b>, in the same direction. How far out? Drag c, and drag side ${name(side.id)} or move it with the slider${
        state.answered.polar === undefined ? "." : ": a line at distance r has its dual point at distance 1/r."}`,
      solid: (moved ? drawPolygon(model.polygon, {isGhost: true}) : "") + drawPolygon(seen, {marks}) + drawPoints(false) + drawCenter(),
      dual: drawDual(seen, {marks, ghost: moved ? model.polygon : null}) + (side ? `<path class="line arrow" d="M0 0L${path([at])}"/>` + dotAt(at, "chosen") : "") +
        (Array.isArray(answer) ? `<circle class="guess" cx="${answer[0]}" cy="${answer[1]}" r="9"/>` : ""),
      question: side ? ask("polar", `Side ${name(side.id)} moves to twice its distance from c. Where will its dual point be? Click in the right pane.`,
        guess => near(guess, toDual(scaled(side.dual, new Rational(1n, 2n))), 14),
        () => "At half its distance from the center, on the same ray: p = n / s, and s, which is the distance r times the length of n, doubles. Try it with the slider. A line that goes away for good becomes the center itself.") : "",
      more: (side ? `<p><label>distance of side ${side.id}, times <input type="range" data-stretch="1" min="2" max="16" value="${Math.round(state.stretch.toNumber() * 4)}"> ${num(state.stretch, "stretch")}</label> ${
        isRedundant ? "Now its dual point lies inside the dual polygon, and the line bounds nothing any more." : state.stretch.compare(one) < 0 ? "Nearer than before, it cuts the input." : ""}</p>` : "") +
        rows(["halfplane n\u00b7x + d \u2264 0", "s = \u2212(n\u00b7c + d)", "dual point p = n / s"], (moved ? model.planes.map(p => p.id === side.id ? moved.plane : p) : model.planes)
          .map(p => ({cells: [`${name(p.id)} ${rowText(p)}`, num(value(p, state.center).negated(), `s/${p.id}`), pair(dualPoint(p, state.center), `dual/${p.id}`)], mark: side?.id === p.id ? "chosen" : ""}))),
      have: `c = ${pair(state.center, "center")}. Halfplanes are <b>points</b> now; the hull of these points is a second polygon, the <b>dual</b>. The dual depends on c; which sides meet, which can go, and what that costs does not.`};
  }},

  {id: "swap", title: "Sides and corners change places", show() {
    const {sides, corners} = model.polygon, m = sides.length, asked = Math.floor(m / 2), [p, q] = [sides[asked], sides[(asked + 1) % m]];
    const chosen = state.picked, k = sides.findIndex((side, i) => `${side.id}-${sides[(i + 1) % m].id}` === chosen);
    const marks = k < 0 ? {} : {[sides[k].id]: "ring", [sides[(k + 1) % m].id]: "ring", [chosen]: "chosen"};
    return {
      say: "Wanted: to read the polygon off its dual. A side became a point; so what becomes of a corner, where two sides meet? Pick sides of the dual, and drag c." + (state.answered.swap === undefined ? "" : " It is the side between their two dual points."),
      solid: drawPolygon(model.polygon, {marks, picks: false}) + (k < 0 ? dotAt(toSolid(corners[asked]), "tight", "", 7) : dotAt(toSolid(corners[k]), "chosen", "", 7)) + drawCenter(),
      dual: drawDual(model.polygon, {marks}),
      question: ask("swap", `One corner is marked, between sides ${list([p.id, q.id])}. Which side of the dual is it? Click it in the right pane.`,
        corner => corner === `${p.id}-${q.id}`, () => `The one between points ${list([p.id, q.id])}. Let y be the corner less c. Both of its sides say p\u00b7y = 1, one with each dual point p; and all p with p\u00b7y = 1 are a line, the one through these two points. The other halfplanes hold y with room to spare, p\u00b7y &lt; 1, so their points lie on the center's side of it.`),
      more: k < 0 ? "" : `<p>The corner y, seen from c, is ${pair(difference(corners[k], state.center), "corner")}. For both dual points p\u00b7y = ${num(dot(sides[k].dual, difference(corners[k], state.center)), "incidence/0")} and ${
        num(dot(sides[(k + 1) % m].dual, difference(corners[k], state.center)), "incidence/1")}: "y lies on the line of p" and "p lies on the line of y" are one equation.</p>`,
      have: "Two polygons with as many corners as the other has sides, in the same cyclic order. So whatever we do to halfplanes, we may do to points, and a hull of points is what programs can compute."};
  }},

  {id: "cap", title: "A halfplane goes", show() {
    const {cap} = model, unbounded = model.caps.filter(c => !c.area).map(c => c.side.id), open = unbounded[0];
    const marks = cap ? {[cap.side.id]: "chosen", [cap.before.id]: "ring", [cap.after.id]: "ring"} : {}, asked = open ?? model.caps[0].side.id;
    return {
      say: cap ? `Side ${name(cap.side.id)} goes. Its neighbours, ${list([cap.before.id, cap.after.id])}, are prolonged until they meet${cap.tip ? ": the polygon gains a triangle, the <b>cap</b>" : ", and they never do: without this side the polygon has no end"}. In the dual, a point goes, and one segment closes the gap.`
        : "Wanted: what a removal costs. Pick a side, and see what happens without it.",
      solid: (cap ? drawCap(cap) : "") + drawPolygon(model.polygon, {marks}) + (cap?.tip ? dotAt(toSolid(cap.tip), "new") : "") + drawPoints(false) + drawCenter(),
      dual: drawDual(model.polygon, {marks}) + (cap ? `<path class="line added ${cap.tip ? "new" : "no"}" d="M${path([toDual(cap.before.dual), toDual(cap.after.dual)])}"/>` : ""),
      question: ask("cap", `Can side ${name(asked)} go, so that the rest still bounds a polygon?`, answer => (answer === "no") === unbounded.includes(asked),
        () => `${unbounded.includes(asked) ? "No" : "Yes"}. In the dual: the segment between its neighbours' points must pass the center on the outer side, so that the center stays inside. (With the center outside, some direction u has p\u00b7u \u2264 0 for all p, and nothing stops the polygon there.) That is the sign of D, the determinant of the two points: positive if the turn from the first to the second, counter-clockwise, is less than half a turn.`, ["yes", "no"]),
      more: cap ? `<p>D = p<sub>${cap.before.id}</sub> \u00d7 p<sub>${cap.after.id}</sub> = ${num(cap.D, "D")}, so the cap is ${cap.D.sign() > 0 && cap.area ? `bounded. Its tip is ${pair(cap.tip, "tip")}, its area ${num(cap.area, "area")}` : "not bounded, and this side has to stay"}.</p>` : "",
      have: "A removal is local: it needs the side and its two neighbours, and one sign that says whether it is possible at all."};
  }},

  {id: "choice", title: "Which one goes first", show() {
    const isTold = state.answered.choice !== undefined, {next, caps} = model, ring = next && [next.before.id, next.after.id];
    const marks = isTold && next ? {[next.side.id]: "chosen", ...(state.answered.ring !== undefined ? Object.fromEntries(ring.map(id => [id, "ring"])) : {})} : {};
    const areas = Object.fromEntries(caps.filter(c => c.area).map(c => [c.side.id, c.area.decimal(3)]));
    return {
      say: `Wanted: few sides, and little to spare. The cap of a side is what the polygon gains without it, so the side with the smallest cap goes first. ${isTold ? "Each side shows the area of its cap." : "Look before you compute."} Drag c: no area changes, as the costs are those of the polygon, however we look at it.`,
      solid: (isTold ? caps.map(drawCap).join("") : "") + drawPolygon(model.polygon, {marks, areas: isTold ? areas : null}) + drawCenter(), dual: drawDual(model.polygon, {marks}),
      question: next === null ? "" : ask("choice", "Which side has the smallest cap? Click it.", id => next.tied.includes(id), () => `Side ${name(next.side.id)} adds ${num(next.area, "least")}${
        next.tied.length > 1 ? `, and ${list(next.tied.slice(1))} exactly as much. Of equal ones the first goes, so that everybody gets the same result` : ""}.`) +
        (isTold ? ask("ring", "When it has gone: whose caps are not what they were? Click one.", id => ring.includes(id),
          () => `Its two neighbours, ${list(ring)}. All other caps stay as they are. So a step costs little, however many sides there are.`) : ""),
      more: isTold ? rows(["side", "D", "area of its cap"], caps.toSorted((a, b) => a.side.id - b.side.id).map(c => ({
        cells: [name(c.side.id), num(c.D, `D/${c.side.id}`), c.area ? num(c.area, `area/${c.side.id}`) : "not bounded"], mark: next?.side.id === c.side.id ? "chosen" : ""}))) : "",
      have: "One rule: the smallest cap, of equal ones the first. And one fact that makes it fast: only the neighbours are computed anew."};
  }},

  {id: "run", title: "One after another", show() {
    const {steps, last} = model.run, k = Math.min(state.at, steps.length), step = steps[k], polygon = step ? step.polygon : last;
    const first = areaOf(model.polygon.corners), now = areaOf(polygon.corners), growth = now.minus(first).over(first);
    const marks = step ? {[step.side.id]: "chosen", [step.before.id]: "ring", [step.after.id]: "ring"} : {};
    return {
      say: `${polygon.sides.length} of ${model.planes.length} sides are left; the polygon has grown by ${num(growth.times(new Rational(100n)), "growth")} percent. ${
        step ? `Next goes side ${name(step.side.id)}, for ${num(step.area, "step")}.` : last.sides.length === 3 ? "Fewer than three sides bound nothing." : "No other side can go: each cap is unbounded."}`,
      solid: drawPolygon(model.polygon, {isGhost: true}) + drawPolygon(polygon, {marks, picks: false}) + drawPoints(false), dual: drawDual(polygon, {marks, ghost: model.polygon, picks: false}),
      question: ask("run", "Each step takes the smallest cap. Is the result of several steps then always the smallest polygon that so many of the first sides can bound?", answer => answer === "no",
        () => `No. A cheap first step may make the next ones dear.${bestText(polygon)} Greedy is a good rule, not the best of all: <code>convexact simplify --search local</code> looks for better choices afterwards, and <code>--search optimal</code> proves which is the best.`, ["yes", "no"]),
      more: `<p><label>removals <input type="range" data-at-step="1" min="0" max="${steps.length}" value="${k}"> ${k} of ${steps.length}</label></p>` +
        rows(["step", "side", "adds", "equal ones", "area after"], steps.map((s, i) => ({cells: [i + 1, name(s.side.id), num(s.area, `run/${i}/area`), s.tied.slice(1).map(name).join(" "),
          num(areaOf((steps[i + 1]?.polygon ?? last).corners), `run/${i}/after`)], mark: i === k ? "chosen" : ""}))),
      have: "This is the whole algorithm. The polygon only grows, so it holds the points at every step, and the dual only shrinks."};
  }},

  {id: "space", title: "And in space", show() {
    return {
      say: "In space the ideas stay, and each gets a little harder. The lessons on solids take them one by one.",
      solid: drawPolygon(model.run.last, {picks: false}) + drawPoints(false), dual: drawDual(model.run.last, {picks: false}), question: "",
      more: rows(["in the plane", "in space", "why it is harder"], [
        ["halfplanes, sides", "halfspaces, facets", "a facet has any number of corners"],
        ["the hull, by sorting", "the hull, point by point", "a new point sees several triangles of the hull so far; they are replaced along their common rim"],
        ["two neighbours", "a ring of k neighbours", "their order has to be kept"],
        ["one segment closes the gap, D &gt; 0", "k \u2212 2 triangles close the hole, each with D &gt; 0", "which triangles they are is itself a small hull"],
        ["the cap is a triangle", "the cap is a polytope", "its volume is a sum over those triangles"],
        ["bounded or not: one sign", "bounded or not: one sign for each triangle", "one wrong sign, and triangles overlap or leave a gap: so signs are computed exactly"],
      ].map(cells => ({cells}))),
      have: `Go on with ${toLesson("cube.html", "the cube without a corner")}, where every number still fits on the board.`};
  }},
];

// The point of a plane that is nearest to the center.
function foot(plane) {
  const s = value(plane, state.center).negated();
  return state.center.map((x, k) => x.plus(plane.n[k].times(s).over(dot(plane.n, plane.n))));
}

// What the best choice of as many sides would have, where all choices can be tried.
function bestText(polygon) {
  if (model.planes.length > 9 || polygon.sides.length === model.planes.length) return "";
  const best = leastArea(model.planes, state.center, polygon.sides.length), now = areaOf(polygon.corners);
  return ` Of all choices of ${polygon.sides.length} of these sides, the best has the area ${num(best, "best")}; here it is ${num(now, "now")}${best.compare(now) === 0 ? ", as good" : ""}.`;
}

function pick(target, pane, at) {
  const id = chapterId(), {side, corner, point} = target.dataset;
  if (pane === "dual" && id === "polar" && model.side && at && state.answered.polar === undefined) {
    answer("polar", at);
    return set({});
  }
  if (point !== undefined && id === "points") answer("points", Number(point));
  if (corner !== undefined && id === "swap") {
    answer("swap", corner);
    return set({picked: corner});
  }
  if (side === undefined) return set({});
  if (id === "choice") answer(state.answered.choice === undefined ? "choice" : "ring", Number(side));
  return set(id === "polar" || id === "cap" ? {picked: Number(side), stretch: one} : {});
}

function moveTo(what, at) {
  if (what.point !== undefined) {
    const to = fromSolid(at, pointGrid);
    if (toSolid(to).every(x => Math.abs(x) < 190)) set({points: state.points.map((p, k) => k === Number(what.point) ? to : p)});
  } else if (what.center) {
    set({center: fromSolid(at, centerGrid)});
  } else {
    const plane = model.planes.find(p => p.id === state.picked), x = fromSolid(at, centerGrid);
    const along = value(plane, x).minus(value(plane, state.center)).over(value(plane, state.center).negated()).toNumber();
    set({stretch: new Rational(BigInt(Math.max(2, Math.min(16, Math.round(along * 4)))), 4n)});
  }
}

begin({
  chapters, modelOf, pick, moveTo,
  start: () => ({points: start, center: middleOf(start), picked: null, stretch: one, at: 0}),
  forget: {picked: null, stretch: one},
  canMove: (what, pane) => pane === "solid" && (what.point !== undefined || what.center !== undefined || (what.side !== undefined && chapterId() === "polar")),
  whereIs: what => what.point !== undefined ? {from: state.points[what.point], grid: pointGrid}
    : what.center ? {from: state.center, grid: centerGrid} : {from: foot(model.moved.plane), grid: pointGrid},
  input(data, value) {
    if (data.stretch) set({stretch: new Rational(BigInt(value), 4n)});
    if (data.atStep) set({at: Number(value)});
  },
  // The dual fills its pane, but not while the center moves: then it would not be seen to change.
  settled() { dualScale = 150 / Math.max(...model.polygon.sides.map(side => Math.hypot(...side.dual.map(x => x.toNumber())))); },
});
