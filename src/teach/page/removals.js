// SPDX-License-Identifier: MIT
// The chapters of the greedy loop: each removal with its candidates, its ring being closed and its cap; and the
// checks of each step.
"use strict";

// --- doubles, to show beside exact numbers what they make of them ------------------------------------

const doubles = {
  known: new Map(),
  // As a program in doubles has a plane: its numbers to nearest, scaled so that the largest entry of the normal is 1.
  plane(i) {
    if (this.known.has(i)) return this.known.get(i);
    const numbers = plane(i), size = x => x.sign() < 0 ? x.negated() : x;
    const largest = numbers.slice(0, 3).map(size).reduce((a, b) => a.compare(b) > 0 ? a : b);
    this.known.set(i, numbers.map(x => x.over(largest).toNumber()));
    return this.known.get(i);
  },
  det: (a, b, c) => a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]),
  gap(i, j, k) { return this.det(this.plane(i), this.plane(j), this.plane(k)); },
  height(t, p) {
    const [a, b, c, d] = [...t, p].map(i => this.plane(i));
    return -a[3] * this.det(b, c, d) + b[3] * this.det(a, c, d) - c[3] * this.det(a, b, d) + d[3] * this.det(a, b, c);
  },
  // The volume of the cap of i by the closed formula over its new triangles.
  volume(i, triangles) {
    return triangles.reduce((sum, [a, b, c]) => sum + this.height([a, b, c], i) ** 3 /
      (6 * this.gap(a, b, c) * this.gap(i, a, b) * this.gap(i, b, c) * this.gap(i, c, a)), 0);
  },
};

// Where they are far off, they are shown from the start.
display.doubles = (lesson.removals || []).some(removal => {
  const near = doubles.volume(removal.removed, removal.triangles.map(t => t.corners)), exact = Rational.of(removal.cap_volume).toNumber();
  return !(Math.abs(near - exact) <= 0.01 * exact);
});

// --- removal ---------------------------------------------------------------------------------------

const volumeBefore = k => k === 0 ? "/topology/volume" : `/removals/${k - 1}/volume_after`;
const stepName = removal => `Removal ${removal.step}`;
const firstSolid = () => solidItem(surfaceAfter(0));
let wholeReach = null;  // how far the largest solid reaches
// The frame stays; where all solids do not fit in one that shows the first one well, it doubles when the next does not.
function frameOf(k) {
  const last = lesson.removals.length, start = radiusOf([firstSolid()]);
  wholeReach ??= Math.max(...Array.from({length: last + 1}, (_, n) => radiusOf([solidItem(surfaceAfter(n))])));
  if (wholeReach <= 2.2 * start) return wholeReach;
  const next = radiusOf([solidItem(surfaceAfter(Math.min(k + 1, last)))]);
  return start * 2 ** Math.max(0, Math.ceil(Math.log2(next / start)));
}
let ghost = null;
function edgesOf({faces}) {
  const seen = new Set();
  return faces.flatMap(({points}) => points.map((from, k) => ({from, to: points[(k + 1) % points.length], mark: "ghost"})))
    .filter(({from, to}) => !seen.has(`${to};${from}`) && seen.add(`${from};${to}`));
}
// The solid after k removals, the first one as a ghost in it, and other things, in a frame that changes seldom.
function solidScene(k, marks, others = [], note = "") {
  const radius = frameOf(k), smaller = Math.round(radius / frameOf(0));
  if (k > 0) ghost ??= {lines: edgesOf(firstSolid())};
  const zoomed = smaller > 1 ? `Drawn ${smaller} times smaller than at first, as the solid outgrew the frame. ` : "";
  return {items: [...others.filter(item => item.mark === "cap"), solidItem(surfaceAfter(k), marks), ...(k > 0 ? [ghost] : []),
    ...others.filter(item => item.mark !== "cap")], radius, note: note || zoomed + (k > 0 ? "Thin lines: the first solid." : "")};
}
const dualReach = () => radiusOf([dualItem(surfaceAfter(0))]);

// Where the digits that are shown do not tell: by how much one costs more than the cheapest.
function dearer(value, cheapest) {
  if (!value?.exact || !cheapest?.exact) return "";
  const [own, lowest] = [value, cheapest].map(({decimal}) => log10Of(decimal));
  if (own - lowest > 1e-3) return "";
  const least = Rational.of(cheapest.exact), more = Rational.of(value.exact).minus(least).toNumber();
  return more > 0 && more < 1e-4 * least.toNumber() ? `dearer by ${more.toPrecision(2)}` : "";
}

function candidateTable(k, removal) {
  const all = candidates(k), measures = lesson.measures || [], ties = new Set(removal?.tie || []);
  const withDoubles = display.doubles && lesson.cost === "volume";
  const head = ["", "halfspace", `what its removal adds to the ${measureName[lesson.cost]}`, ...measures.map(m => measureName[m]),
    ...(withDoubles ? ["in doubles", "off by"] : []), ""];
  const rows = all.map(({i, e, cost: value}, rank) => {
    const at = `/evaluations/${e}`, others = measures.map(m => lesson.evaluations[e].others?.[m] ? cost(`${at}/others/${m}`) : "");
    let float = [];
    if (withDoubles) {
      const near = value && doubles.volume(i, lesson.evaluations[e].triangles), exact = value && Rational.of(value.exact).toNumber();
      float = value ? Number.isFinite(near) ? [String(near), `${(100 * Math.abs(near - exact) / exact).toPrecision(2)}%`] : ["no number", ""] : ["", ""];
    }
    const note = i === removal?.removed ? "<b>goes</b>" : ties.has(i) ? "tie" : dearer(value, removal?.cost);
    return row([value ? rank + 1 : "", `<button type="button" class="link" data-pick="h${i}">${i}</button>`, cost(`${at}/cost`), ...others, ...float, note],
      i === removal?.removed ? 'class="chosen"' : ties.has(i) ? 'class="tie"' : "");
  });
  return table(head, rows, "Costs of all candidates");
}

// The triangles over the ring of a halfspace that cannot go.
const gapTable = ({halfspace, triangles}) => table([`triangle without ${halfspace}`, "D", "corner?"], triangles.map(t => {
  const d = planeThrough(t).D;
  return row([tags(t), computed(d), d.sign() > 0 ? "yes" : "none"]);
}), "Triangles that would close the hole");
// x and D of the plane through three dual points, as the record has them: in primitive integers.
function planeThrough(t) {
  const [a, b, c] = t.map(i => vector(lesson.halfspaces[i].dual)), n = v => v.slice(0, 3);
  const x = [cross(n(b), n(c)).map(v => v.times(a[3])), cross(n(c), n(a)).map(v => v.times(b[3])), cross(n(a), n(b)).map(v => v.times(c[3]))]
    .reduce((u, v) => u.map((value, k) => value.plus(v[k])));
  return {x, D: det(n(a), n(b), n(c))};
}
const over = ({x, D}, i) => {
  const p = vector(lesson.halfspaces[i].dual);
  return dot(x, p.slice(0, 3)).minus(D.times(p[3]));
};

// Where three planes meet, to be drawn; null for a gap to infinity.
function cornerOf(t) {
  const {x, D} = planeThrough(t), scale = vector(lesson.frame.scale);
  return D.sign() > 0 ? x.map((value, k) => value.over(D).times(scale[k]).toNumber()) : null;
}

// The dual hull without the star of i, with the triangles that close the ring so far.
function openDual(k, i, ring, closed, marks) {
  const item = dualItem(surfaceAfter(k), marks), isStar = face => face.pick.slice(1).split(",").map(Number).includes(i);
  item.faces = item.faces.filter(face => !isStar(face));
  for (const {corners, mark: name} of closed) item.faces.push({points: corners.map(j => drawnDual(j)), mark: name, pick: `t${key(corners)}`});
  return item;
}

// The part of the cap below the plane of i pushed outward by a share of the cap's height: its sides, cut, and the top.
function grownCap(removal, share) {
  const at = [...removal.base, ...removal.triangles.map(t => t.vertex)].map(v => v.at), [a, b, c, d] = lesson.halfspaces[removal.removed].drawn;
  const over = p => a * p[0] + b * p[1] + c * p[2] + d, most = Math.max(...at.map(over)) * share, cut = [];
  const faces = removal.sides.map((side, t) => {
    const points = [];
    side.forEach((corner, e) => {
      const p = at[corner], q = at[side[(e + 1) % side.length]], hp = over(p) - most, hq = over(q) - most;
      if (hp <= 1e-12) points.push(p);
      if ((hp < -1e-12 && hq > 1e-12) || (hp > 1e-12 && hq < -1e-12)) {
        const r = p.map((x, j) => x + (q[j] - x) * hp / (hp - hq));
        points.push(r);
        if (hp > 0) cut.push(r);
      }
    });
    return {points, mark: "new", pick: `h${removal.ring[t]}`};
  }).filter(face => face.points.length > 2);
  const middle = cut.reduce((sum, p) => sum.map((x, k) => x + p[k] / cut.length), [0, 0, 0]);
  const side = Math.abs(a) < 0.5 ? [1, 0, 0] : [0, 1, 0], u = [b * side[2] - c * side[1], c * side[0] - a * side[2], a * side[1] - b * side[0]];
  const v = [b * u[2] - c * u[1], c * u[0] - a * u[2], a * u[1] - b * u[0]];
  const angle = p => Math.atan2(times(v, p.map((x, k) => x - middle[k])), times(u, p.map((x, k) => x - middle[k])));
  cut.sort((p, q) => angle(p) - angle(q));
  if (cut.length > 2) faces.push({points: cut, mark: "chosen", pick: `h${removal.removed}`});
  return {faces, mark: "cap"};
}

// After so many removals a walk goes from one to the next: what follows is like what was seen, and its steps are reached
// by a link, from the contents, or by their address.
const kInDetail = 3;
const detailLink = (k, id, text) => k < kInDetail ? "" : `<p><a href="#${id}">${text}</a></p>`;

// Asked before it is told: which halfspace goes first. Any answer opens the step, and so does "tell me".
function guessFirst(removal, picked, around) {
  const isSure = picked !== null && surfaceAfter(0).rows().has(picked), isRight = removal.tie.includes(picked) || picked === removal.removed;
  return {
    say: `Before you read on: ${removal.left + 1} halfspaces, and one of them goes, the one whose removal lets the solid grow least. Which one? Pick a facet of the solid, or a point of the dual.`,
    solid: solidScene(0, isSure ? around : {}), dual: {items: [dualItem(surfaceAfter(0), isSure ? around : {})], radius: dualReach()},
    more: (isSure ? `<p>You picked ${tag(picked)}. ${isRight ? "<b class=\"yes\">Right.</b>" : "<b class=\"wrong\">Not so.</b>"} <button type="button" data-told="1">Why?</button></p>`
      : "<p><button type=\"button\" data-told=\"1\">Tell me</button></p>"),
  };
}

function removalSteps(removal, k) {
  const {removed: i, ring} = removal, at = `/removals/${k}`, id = `removal-${removal.step}`, before = removal.left + 1;
  const marks = {...mark(ring, "ring"), [i]: "chosen"};
  const measured = measureName[lesson.cost];
  const steps = [{id, title: `${stepName(removal)}: the cheapest`, show: () => {
    const picked = pickedHalfspace(), shown = picked !== null && surfaceAfter(k).rows().has(picked) ? picked : i;
    const around = {...mark(surfaceAfter(k).ring(shown), "ring"), [shown]: "chosen"};
    if (k === 0 && !state.isTold) return guessFirst(removal, picked, around);
    const all = candidates(k), able = all.filter(candidate => candidate.cost !== null).length, other = shown === i ? null : all.find(candidate => candidate.i === shown);
    return {
      say: `There are ${before} halfspaces, and ${able === before ? "each" : able} of them could go. Removing one lets the solid grow, and its cost is how much ${measured} that adds. ${all.length > able ? `Without ${all.length - able === 1 ? "the other one" : `one of the other ${all.length - able}`} the solid would become unbounded. ` : ""}The cheapest is ${tag(i)}, which adds ${cost(`${at}/cost`)}${
        removal.tie.length > 1 ? `. That is an exact tie of ${tags(removal.tie)}; the first in canonical order goes` : ""}.${other ? ` If ${tag(shown)} went instead, ${other.cost ? `that would add ${cost(`/evaluations/${other.e}/cost`)}` : "the solid would be unbounded"}.` : ""}`,
      solid: solidScene(k, around),
      dual: {items: [dualItem(surfaceAfter(k), around)], radius: dualReach()},
      more: detailLink(k, `${id}-ring`, "In detail: its ring, how the hole is closed, and the cap") + (removal.tie.length > 1 ? `<p>Why they count as equal: ${escaped(removal.tie_proof || "rational")}.</p>` : "") + candidateTable(k, removal) +
        (all.length > able ? `<p>Unbounded: without such a halfspace the solid would run off to infinity. In the dual, the origin would no longer lie inside of the hull of the other points: one of the triangles that close the hole has D \u2264 0, and so no corner.</p>${other && other.cost === null ? gapTable(lesson.evaluations[other.e]) : ""}` : ""),
    };
  }}];
  const closed = new Map([[key(removal.first), removal.first]]);
  const fill = [{corner: null, lost: [], gained: [removal.first], all: [...closed.values()]}];
  for (const step of removal.insertions) {
    for (const t of step.lost) closed.delete(key(t));
    for (const t of step.gained) closed.set(key(t), t);
    fill.push({...step, all: [...closed.values()]});
  }
  fill.forEach((step, j) => steps.push({isDetail: k >= kInDetail, id: j === 0 ? `${id}-ring` : `${id}-fill-${j}`,
    title: j === 0 ? `${stepName(removal)}: its ring` : `${stepName(removal)}: close the ring, corner ${step.corner}`, show: () => {
      const gained = new Set(step.gained.map(key)), corners = new Set(step.all.flat());
      const closing = step.all.map(t => ({corners: t, mark: gained.has(key(t)) ? "new" : "kept"}));
      const roof = step.all.map(cornerOf), missing = roof.filter(p => p === null).length;
      const say = j === 0
        ? `Taking ${tag(i)} away takes away its dual point and the ${ring.length} triangles around it. That leaves a hole. Its rim is the <i>ring</i> ${tags(ring)}, the neighbours of facet ${tag(i)}. Nothing else of the dual changes. ${ring.length === 3 ? "One triangle closes the hole; a longer ring is closed by several, faces of the hull of the points that are left." : `To close the hole we begin with the triangle ${tags(removal.first)}.`}`
        : `Corner ${tag(step.corner)} of the ring joins. ${step.lost.length ? `It lies beyond ${many(step.lost.length, "triangle")}, so ${step.lost.length === 1 ? "that goes" : "those go"}, and ` : "It lies beyond no triangle, so none goes, and "}${many(step.gained.length, "triangle comes", "triangles come")}.`;
      const heights = step.lost.length === 0 ? "" : table(["triangle", "x", "D", `height of ${step.corner} over it`, "beyond?"], step.lost.map(t => {
        const p = planeThrough(t), h = over(p, step.corner);
        return row([tags(t), `(${p.x.map(computed).join(", ")})`, computed(p.D), computed(h), verdict(h.sign() > 0)]);
      }), "Triangles that go");
      return {
        say,
        solid: solidScene(k, marks, [{dots: roof.filter(Boolean).map((p, n) => ({at: p, mark: "new", label: step.all.filter((_, m) => roof[m])[n].join("\u00b7")}))}],
          missing ? `${many(missing, "triangle has", "triangles have")} no corner yet: D is not positive, so these three planes leave a gap.` : "Dots: where the three planes of each new triangle meet."),
        dual: {items: [openDual(k, i, ring, closing, {...marks, ...(step.corner === null ? {} : {[step.corner]: "tight"})}),
          {lines: ring.map((from, t) => ({from: drawnDual(from), to: drawnDual(ring[(t + 1) % ring.length]), mark: "horizon"}))}], radius: dualReach()},
        more: (j === 0 && ring.length > 3 ? `<p>How is a hole closed so that the surface is the hull of the points that are left? Corner by corner, in random order: a new corner is beyond some triangles, those go, and new ones join it to the rim of what went. Here ${corners.size} of ${ring.length} corners are joined.</p>` : "") +
          (step.lost.length ? formula(word("height"), mo("="), mi("x"), mo("\u00b7"), sub("n", step.corner), mo("\u2212"), mi("D"), sub("w", step.corner), mo(">"), mn(0)) : "") + heights,
      };
    }}));
  steps.push({isDetail: k >= kInDetail, id: `${id}-cap`, title: `${stepName(removal)}: the cap`, grows: true, show: () => ({
    say: `On the solid's side, plane ${tag(i)} is gone and the planes of its ring meet further out. What is added is the cap. Its volume is ${number(`${at}/cap_volume`)}, and so the solid grows from ${number(volumeBefore(k))} to ${number(`${at}/volume_after`)}.`,
    solid: solidScene(k, marks, [grownCap(removal, state.grown)]),
    dual: {items: [dualItem(surfaceAfter(k + 1), mark(ring, "ring"), Object.fromEntries(removal.triangles.map(t => [key(t.corners), "new"]))),
      {lines: ring.map(j => ({from: drawnDual(i), to: drawnDual(j), mark: "gone"})), dots: [{at: drawnDual(i), mark: "chosen", label: i}]}], radius: dualReach(),
      note: "Dashed: the triangles that went. Below them the new ones."},
    more: capDetails(removal, k),
  })});
  return steps;
}

function capDetails(removal, k) {
  const at = `/removals/${k}`, {removed: i} = removal;
  const six = removal.tetrahedra.reduce((sum, t) => sum.plus(Rational.of(t.six)), new Rational(0n)), volume = six.over(new Rational(6n));
  const sum = Rational.of(recorded(volumeBefore(k))).plus(volume);
  const few = removal.tetrahedra.length <= 6;
  return `<label>Let the cap grow <input type="range" data-grow min="0" max="100" value="${Math.round(100 * state.grown)}"></label>` +
    "<h4>The new corners</h4>" + table(["triangle of the dual", "x", "D", `height of ${i}`, "corner c + x / D", "D > 0, height \u2265 0?"], removal.triangles.map((t, n) => row([tags(t.corners), `(${list(`${at}/triangles/${n}/x`)})`,
      number(`${at}/triangles/${n}/d`), number(`${at}/triangles/${n}/height`), triple(`${at}/triangles/${n}/vertex/exact`),
      verdict(Rational.of(t.d).sign() > 0 && Rational.of(t.height).sign() >= 0)])), "New corners") +
    `<p>D &gt; 0: there is such a corner. Height \u2265 0: the dual point of ${tag(i)} lies above the triangle or on it, so plane ${tag(i)} used to cut this corner off, or just touched it.</p>` +
    `<p>Here the program writes dual points as whole numbers (n : w): ${[i, ...removal.ring].map(j => `${tag(j)} = (${[0, 1, 2].map(c => number(`/halfspaces/${j}/dual/${c}`)).join(", ")} : ${number(`/halfspaces/${j}/dual/3`)})`).join(", ")}. From these follow x, D and height, divided by common factors: positive multiples of those from the planes, so the same corner and the same signs.</p>` +
    `<h4>Its volume</h4><p>The base of the cap is facet ${tag(i)}. From one corner a of it, the cap is cut into tetrahedra with corners a, u, v, w, where u, v, w is a triangle of its surface without a, counter-clockwise from outside:</p>` +
    formula(mn(6), mi("V"), mo("="), mo("\u2211"), word("det"), mo("("), mi("u"), mo("\u2212"), mi("a"), mo(","), mi("v"), mo("\u2212"), mi("a"), mo(","), mi("w"), mo("\u2212"), mi("a"), mo(")"),
      few && removal.tetrahedra.length > 1 ? mo("=") + removal.tetrahedra.map((_, n) => math(`${at}/tetrahedra/${n}/six`)).join(mo("+")) : "", mo("="), mathOf(six)) +
    formula(mi("V"), mo("="), mathOf(six), mo("/"), mn(6), mo("="), math(`${at}/cap_volume`)) +
    formula(math(volumeBefore(k)), mo("+"), math(`${at}/cap_volume`), mo("="), math(`${at}/volume_after`)) +
    `<p>Do these agree with what the program recorded? ${verdict(volume.compare(Rational.of(removal.cap_volume)) === 0 && sum.compare(Rational.of(removal.volume_after)) === 0)}</p>` +
    (lesson.cost === "volume" ? "" : `<p>By ${measureName[lesson.cost]} it costs ${cost(`${at}/cost`)}.</p>`) +
    (lesson.measures || []).map(m => removal.others?.[m] ? `<p>The same step adds ${cost(`${at}/others/${m}`)} to the ${measureName[m]}.</p>` : "").join("") + convexity(removal);
}

// The cap of the solid is convex. That of the dual, between the triangles that went and those that came, need not be:
// two corners of it whose middle lies below a new triangle are a witness.
function convexity(removal) {
  const triangles = removal.triangles.map(t => t.corners);
  for (const t of triangles) {
    const p = planeThrough(t);
    for (const s of triangles) {
      const shared = s.filter(j => t.includes(j)), [a] = s.filter(j => !t.includes(j)), [b] = t.filter(j => !s.includes(j));
      if (shared.length !== 2 || over(p, a).sign() >= 0) continue;
      return `<h4>Two caps</h4><p>The cap of the solid is convex: it is an intersection of halfspaces. In the dual, the region between the old triangles and the new ones is not: ${tag(a)} and ${tag(b)} belong to it, and the middle between them does not, since ${tag(b)} is level with triangle ${tags(t)} and the height of ${tag(a)} over it is ${computed(over(p, a))}, below.</p>`;
    }
  }
  return "";
}

// Of one that cannot go: the triangles that would close the hole, of which one has no corner.
function whyStuck(end) {
  const stuck = lesson.stop.startsWith("all") && candidates(end).find(({cost: value}) => value === null);
  return stuck ? `<p>Without ${tag(stuck.i)}, for instance, the planes of its ring would have to meet in corners:</p>${gapTable(lesson.evaluations[stuck.e])}` : "";
}

function lastSteps() {
  const end = lesson.removals.length, reasons = {reached: "as many are left as were asked for", "growth-limit": "the next removal would exceed the growth that was allowed",
    "all-unbounded": "every further removal would open a gap to infinity", "all-kept-or-unbounded": "every further removal would open a gap to infinity, or is to be kept"};
  return [{id: "removal-end", title: "The end", show: () => ({
    say: `The run ends with ${lesson.end.present.length} halfspaces, since ${reasons[lesson.stop] || lesson.stop}. Every solid on the way holds the input: a halfspace that stays has never moved.`,
    solid: {items: [{...solidItem(surfaceAfter(end)), mark: "cap"}, solidItem(surfaceAfter(0))], radius: end ? frameOf(end - 1) : undefined, note: lesson.topology.step === 0 ? "Inside: the solid before removal 1." : `Inside: the solid after removal ${lesson.topology.step}.`},
    dual: {items: [dualItem(surfaceAfter(end))], radius: dualReach()},
    more: candidateTable(end, null) + whyStuck(end) + (lesson.removals.length && lesson.stop.startsWith("all") ? "<p>A halfspace that could go before may be needed now: one that is gone used to close the gap.</p>" : ""),
  })}];
}

function removalChapter() {
  return [...lesson.removals.flatMap(removalSteps), ...(lesson.failed ? [] : lastSteps())];
}

// --- verification ----------------------------------------------------------------------------------

const wanted = {">0": x => x > 0, ">=0": x => x >= 0, "<=0": x => x <= 0, "=0": x => x === 0};
function verificationChapter() {
  const steps = lesson.removals.map((removal, k) => ({isDetail: k >= kInDetail, id: k === 0 ? "verification" : `verification-${removal.step}`, title: `Step ${removal.step}, checked`, show: () => {
    const failures = removal.checks.filter(check => !check.holds).length, marks = {...mark(removal.ring, "ring"), [removal.removed]: "chosen"};
    const rows = removal.checks.map((check, n) => {
      const at = `/removals/${k}/checks/${n}`;
      let own = "";
      if (check.value !== null && check.triangle) {
        const value = check.plane === null ? gap(check.triangle) : height(check.triangle, check.plane);
        const agrees = value.sign() === Rational.of(check.value).sign() && wanted[check.wants](value.sign()) === check.holds;
        own = verdict(agrees);
        if (display.doubles && !check.triangle.includes(check.plane)) {
          const near = check.plane === null ? doubles.gap(...check.triangle) : doubles.height(check.triangle, check.plane);
          own += ` <span class="${Math.sign(near) === value.sign() ? "" : "wrong"}">doubles: ${Number.isNaN(near) ? "no number" : String(near).replace("-", "\u2212")}${Math.sign(near) === value.sign() ? "" : " \u2014 the wrong sign"}</span>`;
        }
      }
      return row([escaped(check.check), check.triangle ? tags(check.triangle) : "", check.plane === null ? "" : tag(check.plane),
        check.value === null ? "" : `${number(`${at}/value`)} ${escaped(check.wants.replace(">=", "\u2265 ").replace("<=", "\u2264 ").replace(/^>0/, "> 0"))}`, verdict(check.holds), own], check.holds ? "" : 'class="failed"');
    });
    return {
      say: failures ? `Step ${removal.step} FAILS: ${many(failures, "check does", "checks do")} not hold. The program would stop here with an internal error.`
        : `Step ${removal.step} removed ${tag(removal.removed)}. A part of the program that shares nothing with the one that made the step, and knows no center, proved it again by ${many(removal.checks.length, "check")}. All hold.`,
      solid: {items: [{...solidItem(surfaceAfter(k + 1), mark(removal.ring, "ring")), mark: "cap"}, solidItem(surfaceAfter(k), marks)], radius: frameOf(k)},
      dual: {items: [dualItem(surfaceAfter(k + 1), marks, Object.fromEntries(removal.triangles.map(t => [key(t.corners), "new"])))], radius: dualReach()},
      more: "<p>Three questions are asked. <b>Is the surface closed?</b> The new triangles fill the hole along the ring exactly, as a disk. <b>Is it convex?</b> No neighbouring dual point lies above a new triangle: a closed surface once around the center that is convex at every edge is convex, and no sign depends on which point inside the center is. <b>Has the solid only grown?</b> Each new corner exists, lies on or beyond the plane that went, and is inside the planes that stay. (The one-ring of a halfspace: its neighbours, in order. Outside: the old triangle across an edge of the ring. Of a ring of three no other planes are left, so these values are 0. Modulo two primes: both sides of an equation of long numbers have the same remainders, which makes an error very unlikely; the signs are what proves the step.)</p>" +
        "<p>A value is D of the three normals, or the height as a determinant of four planes, from the numbers (n1, n2, n3, d) as they are. The last column is this page's own arithmetic.</p>" +
        table(["check", "triangle", "plane", "value", "holds?", "same here?"], rows, "Checks of this step"),
    };
  }}));
  if (lesson.end && !lesson.failed) {
    steps.push({id: steps.length ? "verification-end" : "verification", title: "Every plane touches", show: () => ({
      say: "Each halfspace that is left is one of the first ones, and all of the input lies inside of it. At the end each is tested at its witness, a vertex of the input that lies on its plane: so none of the planes could be moved inward.",
      solid: solidScene(lesson.removals.length, {}), dual: {items: [dualItem(surfaceAfter(lesson.removals.length))], radius: dualReach()},
      more: table(["halfspace", "witness", "n\u00b7x + d", "= 0?"], lesson.end.witness.map(([i, x], n) => {
        const value = dot(plane(i).slice(0, 3), vector(x)).plus(plane(i)[3]);
        return row([tag(i), `(${x.map((_, c) => number(`/end/witness/${n}/1/${c}`)).join(", ")})`, computed(value), verdict(value.sign() === 0)]);
      }), "Witnesses"),
    })});
  }
  return steps;
}
