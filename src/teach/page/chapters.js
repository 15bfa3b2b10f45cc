// SPDX-License-Identifier: MIT
// The chapters: each is a list of steps, and each step has an id (its deep link), a title, a sentence that can
// be read aloud, what the two panes show, and below them the formulas with the numbers of the step put in.
// A step is made when it is shown: show() returns {say, solid, dual, more}.
"use strict";

const chapters = [];
const state = {picked: null, center: [0, 0, 0], drawnCenter: [0, 0, 0], grown: 1, magnified: null, isTold: false};  // what a reader changes
const pickedHalfspace = () => state.picked?.[0] === "h" ? Number(state.picked.slice(1)) : null;
const pickedTriangle = () => state.picked?.[0] === "t" ? state.picked.slice(1).split(",").map(Number) : null;
const first = lesson.topology ? () => surfaceAfter(0) : null;
const mark = (ids, name) => Object.fromEntries(ids.map(i => [i, name]));
const measureName = {volume: "volume", area: "surface area", "mean-width": "mean width"};

// --- hull: points inserted one by one --------------------------------------------------------------

function hullChapter({of, triangles, conflicts, inside, insertions, facets, rows}) {
  const isDual = of === "dual-points", points = isDual ? rows : lesson.input.points;
  const exactOf = isDual ? p => { const [a, b, c, w] = vector(rows[p].dual); return [a, b, c].map(x => x.over(w)); }
    : p => vector(points[p].exact);
  const beyond = (triangle, p) => {  // six times the signed volume: positive iff the triangle sees p
    const [a, b, c] = triangle.map(exactOf);
    return det(difference(b, a), difference(c, a), difference(exactOf(p), a));
  };
  // The surface and the waiting points before insertion k.
  const states = [{surface: new Map(triangles.map(t => [key(t), t])), waits: new Map(conflicts.map(([p, ...t]) => [p, t]))}];
  for (const step of insertions) {
    const {surface, waits} = states[states.length - 1], next = {surface: new Map(surface), waits: new Map(waits)};
    for (const t of step.visible) next.surface.delete(key(t));
    for (const t of step.added) next.surface.set(key(t), t);
    next.waits.delete(step.point);
    for (const [p, ...t] of step.conflicts) next.waits.set(p, t);
    for (const [p] of step.inside) next.waits.delete(p);
    states.push(next);
  }
  const at = p => points[p].at, name = isDual ? "dual point" : "point";
  const scene = (k, marks, extra) => {
    const {surface, waits} = states[k], corners = new Set([...surface.values()].flat());
    const middle = t => [0, 1, 2].map(c => (at(t[0])[c] + at(t[1])[c] + at(t[2])[c]) / 3);
    const few = points.length <= 60;
    return [
      {faces: [...surface.values()].map(t => ({points: t.map(at), mark: marks[key(t)] || ""}))},
      {lines: [...waits].filter(() => waits.size <= 80).map(([p, t]) => ({from: at(p), to: middle(t), mark: extra.moved?.has(p) ? "moved" : "conflict"})),
        dots: points.map((_, p) => p).filter(p => corners.has(p) || waits.has(p) || p === extra.point).map(p => ({at: at(p), size: few ? 4 : 2,
          mark: p === extra.point ? "chosen" : waits.has(p) ? "waiting" : "", label: p === extra.point || few ? p : undefined}))},
      {lines: extra.lines || []},
    ];
  };
  const radius = radiusOf([{dots: points.map((p) => ({at: p.at}))}]);
  const panes = items => isDual ? {solid: {items: first ? [solidItem(first())] : [], note: "The solid, whose halfspaces have these dual points."},
    dual: {items, radius}} : {solid: {items, radius, note: "Dotted: where a point waits."}, dual: {items: []}};
  const seen = (list, p) => table(["triangle a, b, c", "det(b \u2212 a, c \u2212 a, q \u2212 a)", "seen?"],
    list.map(t => { const d = beyond(t, p); return row([tags(t), computed(d), verdict(d.sign() > 0)]); }), "Triangles that see the point");
  const steps = [{id: "hull", title: "The first tetrahedron", show: () => ({
    say: `The hull begins with four ${name}s that span a volume: ${tags([...new Set(triangles.flat())].sort((a, b) => a - b))}. A ${name} <i>sees</i> a triangle if it lies strictly beyond its plane. Every other ${name} sees some triangle and waits there, or it lies inside and can be forgotten. ${
      many(conflicts.length, "point waits", "points wait")}, and ${many(inside.length, "is inside", "are inside")}.`,
    ...panes(scene(0, {}, {})),
    more: `<p>Whether point q sees the triangle of corners a, b, c, counter-clockwise from outside, is the sign of one determinant:</p>` +
      formula(word("det"), mo("("), mi("b"), mo("\u2212"), mi("a"), mo(","), mi("c"), mo("\u2212"), mi("a"), mo(","), mi("q"), mo("\u2212"), mi("a"), mo(")"), mo(">"), mn(0)),
  })}];
  insertions.forEach((step, k) => {
    const p = step.point;
    steps.push({id: `hull-${k + 1}`, title: `Insert ${p}: what it sees`, show: () => ({
      say: `${isDual ? "Dual point" : "Point"} ${tag(p)} comes next. It sees ${many(step.visible.length, "triangle")}, lit. The edges around ${step.visible.length === 1 ? "it" : "them"}, in a cycle of ${step.horizon.length}, are the horizon.`,
      ...panes(scene(k, Object.fromEntries(step.visible.map(t => [key(t), "lost"])), {point: p,
        lines: step.horizon.map((from, t) => ({from: at(from), to: at(step.horizon[(t + 1) % step.horizon.length]), mark: "horizon"}))})),
      more: `<p>The horizon is ${tags(step.horizon)}. The determinants, worked out by this page:</p>` + seen(step.visible, p),
    })}, {id: `hull-${k + 1}-joined`, title: `Insert ${p}: new triangles`, show: () => ({
      say: `The ${many(step.visible.length, "triangle")} that ${tag(p)} sees ${step.visible.length === 1 ? "goes" : "go"}, and ${many(step.added.length, "triangle comes", "triangles come")}: one from each edge of the horizon to ${tag(p)}. ${
        step.conflicts.length ? `${many(step.conflicts.length, "point that waited there moves", "points that waited there move")} to a new triangle. ` : ""}${
        step.inside.length ? `${many(step.inside.length, "point is", "points are")} inside now.` : ""}`,
      ...panes(scene(k + 1, Object.fromEntries(step.added.map(t => [key(t), "new"])), {point: p, moved: new Set(step.conflicts.map(([q]) => q))})),
      more: (step.conflicts.length ? "<h4>Conflicts that moved</h4>" + table(["point", "now waits at"], step.conflicts.map(([q, ...t]) => row([tag(q), tags(t)])), "Conflicts that moved") : "") +
        (step.inside.length ? "<h4>Proven inside</h4>" + table(["point", "by the triangle"], step.inside.map(([q, ...t]) => row([tag(q), t[0] === t[1] ? `the same as ${tag(t[0])}` : tags(t)])), "Points proven inside") : ""),
    })});
  });
  const last = states[states.length - 1];
  steps.push({id: "hull-facets", title: "The hull", show: () => ({
    say: `No point waits any more, so this is the hull: ${many(last.surface.size, "triangle")}. Triangles in one plane are merged, which leaves ${many(facets.length, "facet")}. Each facet lies on the boundary of one halfspace, and from here on numbers name these halfspaces, not points.`,
    ...panes(scene(states.length - 1, {}, {})),
    more: (isDual ? "" : "<p>(n1, n2, n3, d) stands for the halfspace of all points x with n\u00b7x + d \u2264 0, where n = (n1, n2, n3) points outward.</p>") + table(isDual ? ["vertex", "corners: halfspaces by row"] : ["halfspace", "corners", "(n1, n2, n3, d)"],
      facets.map((facet, f) => row(isDual ? [tag(f), tags(facet)] : [tag(f), tags(facet), planeText(f)])), "Facets") + (isDual ? "" : scaledNote(facets.map((_, f) => f))),
  })});
  return steps;
}

// --- center: the linear program of the largest ball ------------------------------------------------

function centerChapter(center) {
  const place = "/center", isLast = r => r === "t>=0";
  const name = r => isLast(r) ? "r \u2265 0" : tag(r);
  const norm = r => isLast(r) ? new Rational(-1n) : Rational.of(center.norms[r]);
  const line = r => isLast(r) ? [0n, 0n, 0n, 0n].map(x => new Rational(x)) : plane(r);
  // n.x + d + U r at x + M direction: the finite part, and the factor of M.
  const valueAt = (r, {x, direction}) => {
    const part = v => dot(line(r).slice(0, 3), v.slice(0, 3)).plus(norm(r).times(v[3]));
    return {finite: part(vector(x)).plus(line(r)[3]), infinite: part(vector(direction))};
  };
  const isFinite = v => v.direction.every(x => x === "0");
  const scale = vector(lesson.frame.scale), middle = vector(lesson.frame.center);
  const drawn = v => vector(v.x.slice(0, 3)).map((x, k) => x.minus(middle[k]).times(scale[k]).toNumber());
  const ball = (v, name) => isFinite(v) ? [{ball: {at: drawn(v), radii: scale.map(s => s.times(Rational.of(v.x[3])).toNumber())}, mark: name}] : [];
  const items = (v, tight, now) => [first ? {...solidItem(first(), {...mark(tight.filter(r => !isLast(r)), "tight"), ...(now === undefined ? {} : {[now]: "chosen"})}), mark: "glass"} : {},
    ...ball(v, ""), {dots: isFinite(v) ? [{at: drawn(v), mark: "center"}] : []}];
  // The tight constraints' normals as arrows: a ball is pinned when they can balance.
  const tip = r => {
    const normal = lesson.halfspaces[r].drawn, length = Math.hypot(...normal.slice(0, 3));
    return normal.slice(0, 3).map(v => v / length);
  };
  const arrows = rows => [{
    lines: rows.map(r => ({from: [0, 0, 0], to: tip(r), mark: "arrow"})),
    dots: rows.map(r => ({at: tip(r), label: r, mark: "arrow"})),
  }];
  const asBall = (where, v) => isFinite(v) ? `<p>center ${middleOf(`${where}/x`)}, radius ${number(`${where}/x/3`)}</p>`
    : `<p>Not bounded yet: from (x, y, z, r) = (${list(`${where}/x`)}) it may go M times (${list(`${where}/direction`)}), for any M.</p>`;
  const middleOf = where => `(${[0, 1, 2].map(k => number(`${where}/${k}`)).join(", ")})`;
  const statement = "<p>The ball with center x and radius r lies in the halfspace n\u00b7x + d \u2264 0 if and only if n\u00b7x + d + |n| r \u2264 0. Lengths |n| are often irrational, so U, a rational that is at least |n|, stands in their place. The largest r is a linear program in four unknowns:</p>" +
    formula(word("max"), mi("r"), mo("\u2003:\u2003"), sub("n", "i"), mo("\u00b7"), mi("x"), mo("+"), sub("d", "i"), mo("+"), sub("U", "i"), mi("r"), mo("\u2264"), mn(0));
  const steps = [{id: "center", title: "The largest ball", show: () => ({
    say: "The dual needs a center, strictly inside; any such point will do, so you may skip to polar duality. We take the center of the largest ball that fits. Each halfspace is one constraint on the ball. They are taken up one after another, in random order, and each time we ask whether the best ball so far sticks out. Without any, a ball may grow in any direction, and the program takes one.",
    solid: {items: items(center.start, []), note: "Without any constraint, the ball is as large as you like."}, dual: {items: []},
    more: statement + asBall(`${place}/start`, center.start),
  })}];
  let current = center.start, currentAt = `${place}/start`, tight = [], counted = 0;
  center.insertions.forEach((step, k) => {
    const at = `${place}/insertions/${k}`;
    if (step.unmoved) {
      counted += step.unmoved;
      return;
    }
    ++counted;
    const before = current, rank = counted;
    if (step.moved) [current, currentAt, tight] = [step, at, step.tight];
    const after = current, afterAt = currentAt, afterTight = tight;
    steps.push({id: `center-${rank}`, title: isLast(step.row) ? "Not a negative radius" : `Halfspace ${step.row}`, show: () => {
      const value = valueAt(step.row, before), grows = value.infinite.sign();
      const broken = grows > 0 || (grows === 0 && value.finite.sign() > 0);
      return {
        say: isLast(step.row) ? `One more constraint asks that the radius is not negative. The best ball so far ${step.moved ? "breaks it" : "satisfies it"}.`
          : step.moved ? `The best ball so far sticks out of halfspace ${tag(step.row)}, so another takes its place, which plane ${tag(step.row)} holds. ${isFinite(after) ? `It is held by ${many(afterTight.length, "plane")} now; those that held the ball before may let go.` : "There is still no largest ball: it goes on growing."}`
          : `The best ball so far does not stick out of halfspace ${tag(step.row)}, so nothing changes.`,
        solid: {items: items(after, afterTight, isLast(step.row) ? undefined : step.row)},
        dual: {items: [...arrows(afterTight.filter(r => !isLast(r))), origin], radius: 1.2, name: "normals", note: "Directions of the planes that hold the ball."},
        more: (isLast(step.row) ? "" : `<p>Halfspace ${tag(step.row)} and the ball before:</p>` +
          formula(mi("n"), mo("\u00b7"), mi("x"), mo("+"), mi("d"), mo("+"), mi("U"), mi("r"), mo("="),
            grows ? mathOf(value.infinite) + mi("M") + (value.finite.sign() < 0 ? "" : mo("+")) : "", mathOf(value.finite), mo(broken ? ">" : "\u2264"), mn(0)) +
            (grows ? "<p>M stands for a number as large as you like, since with a few constraints only there is no largest ball.</p>" : "")) +
          "<h4>The best ball now</h4>" + asBall(afterAt, after) + `<p>Held by: ${afterTight.map(name).join(", ") || "nothing"}. (It may touch others, too.)</p>`,
      };
    }});
  });
  steps.push({id: "center-end", title: "The certificate", show: () => {
    const touching = center.touching, y = touching.map(([, value]) => Rational.of(value));
    const sums = [0, 1, 2].map(k => touching.reduce((sum, [r], t) => sum.plus(plane(r)[k].times(y[t])), new Rational(0n)));
    const depth = touching.reduce((sum, [r], t) => sum.minus(plane(r)[3].times(y[t])), new Rational(0n));
    const weight = touching.reduce((sum, [r], t) => sum.plus(Rational.of(center.norms[r]).times(y[t])), new Rational(0n));
    return {
      say: `No ball is larger, and these few numbers prove it: the normals of ${tags(touching.map(([r]) => r))}, multiplied by positive factors \u03bb, cancel out. So moving the ball away from one of these planes moves it towards another.`,
      solid: {items: items({x: [...center.optimum, center.optimum_radius], direction: ["0", "0", "0", "0"]}, touching.map(([r]) => r))},
      dual: {items: [...arrows(touching.map(([r]) => r)), origin], radius: 1.2, name: "normals", note: "Weighted by the factors, they are in balance."},
      more: table(["halfspace", "factor \u03bb", "(n1, n2, n3, d)", "U"], touching.map(([r], t) => row([tag(r), number(`${place}/touching/${t}/1`), planeText(r), number(`${place}/norms/${r}`)])), "Certificate") +
        formula(mo("\u2211"), mi("\u03bb"), mi("n"), mo("="), mo("("), sums.map(mathOf).join(mo(",")), mo(")")) +
        formula(mi("r"), mo("="), mo("\u2212"), mo("\u2211"), mi("\u03bb"), mi("d"), mo("/"), mo("\u2211"), mi("\u03bb"), mi("U"), mo("="), mathOf(depth.over(weight))) +
        `<p>Add up the constraints of any ball, each times its λ: x drops out, and r is at most this. Is it the radius that was found? ${verdict(depth.over(weight).compare(Rational.of(center.optimum_radius)) === 0)}</p>` +
        `<p>Center ${triple(`${place}/optimum`)}. Any deep point serves as well, so it is rounded to short numbers: <b>c</b> = ${triple(`${place}/center`)}, around which a ball of radius ${number(`${place}/radius_low`)} still fits. The true largest radius is at most ${number(`${place}/radius_high`)}.</p>`,
    };
  }});
  return steps;
}

// --- polar: a halfspace is a point, a vertex is a face ---------------------------------------------

const centerStep = () => Rational.of(lesson.center?.radius_low ?? depthOfCenter()).over(new Rational(16n));
function depthOfCenter() {  // a length that the center may move, if there is no ball: by planes' depths
  const depths = lesson.halfspaces.map(({dual, plane: p}) => {
    const [a, b, c] = vector(p), value = dot([a, b, c], vector(lesson.frame.center)).plus(Rational.of(p[3])).negated();
    return value.over([a, b, c].reduce((sum, x) => sum.plus(x.sign() < 0 ? x.negated() : x), new Rational(0n)));
  });
  return String(depths.reduce((least, x) => x.compare(least) < 0 ? x : least));
}
const movedCenter = () => vector(lesson.frame.center).map((x, k) => x.plus(centerStep().times(new Rational(BigInt(state.center[k])))));
const weightAt = (i, c, [a, b, d, e] = plane(i)) => dot([a, b, d], c).plus(e).negated();  // w = -(n.c + d)

function polarChapter() {
  const present = () => first().present();
  // What is picked, or else what the step is about.
  const show = (say, usual) => {
    const c = movedCenter(), isMoved = state.center.some(x => x !== 0), picked = state.picked ?? usual;
    const scale = vector(lesson.frame.scale), shift = c.map((x, k) => x.minus(Rational.of(lesson.frame.center[k])).times(scale[k]).toNumber());
    const i = picked[0] === "h" ? Number(picked.slice(1)) : null, t = picked[0] === "t" ? picked.slice(1).split(",").map(Number) : null, marks = {}, triangles = {};
    if (i !== null) {
      const ring = first().ring(i);
      for (const j of ring) marks[j] = "ring";
      marks[i] = "chosen";
      ring.forEach((j, k) => { triangles[key([i, j, ring[(k + 1) % ring.length]])] = "lit"; });
      say += ` Halfspace ${tag(i)} is a facet of the solid and a point of the dual. Across the facet's edges lie its ${ring.length} neighbours, and to their points the dual point is joined.`;
    } else {
      for (const j of t) marks[j] = "ring";
      triangles[key(t)] = "chosen";
      say += ` The planes ${tags(t)} meet in a vertex of the solid, and their three dual points span a triangle of the dual.`;
    }
    if (isMoved) say += " You have moved the center: dual points moved, but no neighbour, no sign and no cost has changed.";
    const at = t && recorded(first().vertex(t[0], t[1])).at;
    const ray = i === null ? null : drawnDual(i, shift), foot = i === null ? null : footOf(i, shift);
    const dual = [dualItem(first(), marks, triangles, shift), {lines: ray ? [{from: [0, 0, 0], to: ray, mark: "normal"}] : [], dots: [{at: [0, 0, 0], mark: "center", label: "origin"}]}];
    return {say, solid: {items: [{...solidItem(first(), marks), mark: "glass"}, {lines: foot ? [{from: shift, to: foot, mark: "normal"}] : [],
      dots: [{at: shift, mark: "center", label: "c", size: 6, drag: "center"}, ...(at ? [{at, mark: "chosen", size: 6}] : [])]}], note: foot ? `From the center to the plane, at right angles${isStretched ? " before the axes were stretched" : ""}.` : "The vertex is marked."},
      dual: {items: dual, radius: radiusOf(dual), note: ray ? "The same direction, at distance 1 / (distance of the plane)." : "The face of that vertex."}, more: details(i, t, c)};
  };
  const details = (i, t, c) => {
    const sliders = `<fieldset><legend>Move the center, or drag c in the picture</legend>${["x", "y", "z"].map((axis, k) =>
      `<label>${axis} <input type="range" data-center="${k}" min="-24" max="24" step="1" value="${state.center[k]}"></label>`).join(" ")} <button type="button" data-home>reset</button>
      <p>c = (${c.map(computed).join(", ")})</p></fieldset>`;
    const options = present().map(j => `<option value="h${j}"${j === i ? " selected" : ""}>halfspace ${j}</option>`).join("") +
      first().triangles().map(({corners}) => `<option value="t${key(corners)}"${t && key(corners) === key(t) ? " selected" : ""}>vertex of ${corners.join(", ")}</option>`).join("");
    const chooser = `<p><label>Pick <select data-picker><option value="">nothing</option>${options}</select></label></p>`;
    let formulas = "";
    if (i !== null) {
      const p = shownPlane(i), w = weightAt(i, c, p), n = p.slice(0, 3);
      formulas = "<p>w divided by the length of n is the distance from the center to the plane, so the dual point lies in direction n at the distance 1 / (distance of the plane):</p>" + formula(mi("w"), mo("="), mo("\u2212"), mo("("), mi("n"), mo("\u00b7"), mi("c"), mo("+"), mi("d"), mo(")"), mo("="), mo("\u2212"), mo("("),
        n.map((x, k) => mo("(") + mathOf(x) + mo(")") + mo("\u00b7") + mo("(") + mathOf(c[k]) + mo(")")).join(mo("+")), mo("+"), mo("("), isScaled(i) ? mathOf(p[3]) : math(`/halfspaces/${i}/plane/3`), mo(")"), mo(")"), mo("="), mathOf(w)) +
        formula(word("dual point"), mo("="), mi("n"), mo("/"), mi("w"), mo("="), mo("("), n.map(x => mathOf(x.over(w))).join(mo(",")), mo(")"));
    }
    if (t) formulas += vertexFormulas(t, c);
    const same = lesson.polar?.other.costs.every((value, k) => JSON.stringify(value) === JSON.stringify(lesson.polar.costs[k]));
    return sliders + chooser + formulas +
      (lesson.polar ? `<p>The program was run a second time, from the center ${triple("/polar/other/center")}. Is what each removal adds the same as from the first center, for all ${lesson.halfspaces.length} halfspaces? ${verdict(same)}</p>` : "") +
      table(["", "(n1, n2, n3, d)", "w", "dual point n / w"], present().map(j => {
        const p = shownPlane(j), w = weightAt(j, c, p);
        return row([`<button type="button" class="link" data-pick="h${j}">${j}</button>`, planeText(j), computed(w),
          `(${p.slice(0, 3).map(x => computed(x.over(w))).join(", ")})`], j === i ? 'class="chosen"' : "");
      }), "Halfspaces and dual points") + scaledNote(present());
  };
  const usual = lesson.removals?.[0], facet = usual ? usual.removed : 0;
  const corner = () => { const ring = first().ring(facet); return key([facet, ring[0], ring[1]]); };
  const steps = [
    {id: "polar", title: "A halfspace is a point", show: () => show("Every halfspace becomes a point, its dual point: the nearer the plane to the center, the farther the point from the origin. Pick any facet, or any point of the dual, and its partner lights up.", `h${facet}`)},
    {id: "polar-vertex", title: "A vertex is a face", show: () => show("And every vertex of the solid becomes a face of the dual, the hull of all dual points: a triangle if exactly three planes meet in it. (A face of more corners is cut into triangles.)", `t${corner()}`)},
    {id: "polar-center", title: "Any center will do", show: () => show("Move the center with the sliders. The dual points move, but who is joined to whom stays. So the choice of the center is free.", `t${corner()}`)},
  ];
  if (usual) steps.push({id: "polar-why", title: "Fewer points, more solid", show: () => withoutOne(usual)});
  return steps;
}

// Why taking a halfspace away is taking a dual point away, with the numbers of a corner that is new then.
function withoutOne(removal) {
  const {removed: i, ring} = removal, c = vector(lesson.frame.center), corner = removal.triangles[0], y = difference(vector(corner.vertex.exact), c);
  const point = j => { const [a, b, d, w] = vector(lesson.halfspaces[j].dual); return [a, b, d].map(x => x.over(w)); };
  const rows = first().present().map(j => {
    const value = dot(point(j), y), isOver = value.compare(new Rational(1n)) > 0;
    return row([tag(j), `(${point(j).map(computed).join(", ")})`, computed(value), isOver ? "<b>more than 1</b>: outside" : "at most 1: inside"], j === i ? 'class="chosen"' : "");
  });
  const marks = {...mark(ring, "ring"), [i]: "chosen"};
  return {
    say: `Seen from the center, the solid is everything that passes the tests p\u00b7y \u2264 1, one test for each dual point p. One halfspace, one test, one point. Taking the halfspace away takes its test away, and that is deleting p; no other point moves. With one test fewer, whatever passed before still passes: so the solid can only grow. Here is a point y that fails only the test of ${tag(i)}.`,
    solid: {items: [{...solidItem(surfaceAfter(1)), mark: "cap"}, solidItem(first(), marks), {dots: [{at: corner.vertex.at, mark: "new", size: 6, label: "y"}, {at: [0, 0, 0], mark: "center", label: "c"}]}]},
    dual: {items: [{...dualItem(first(), marks), mark: "cap"}, {...dualItem(surfaceAfter(1), mark(ring, "ring"), Object.fromEntries(removal.triangles.map(t => [key(t.corners), "new"])))}],
      note: `Outside: with ${i}. Inside: the hull of the points that are left.`},
    more: formula(mi("y"), mo("="), mo("("), corner.vertex.exact.map((_, k) => math(`/removals/0/triangles/0/vertex/exact/${k}`)).join(mo(",")), mo(")"), mo("\u2212"), mi("c"), mo("="), mo("("), y.map(mathOf).join(mo(",")), mo(")")) +
      table(["halfspace", "dual point p", "p\u00b7y", ""], rows, "The corner against every halfspace") +
      `<p>Without ${tag(i)}, y is a corner of the solid. It lies on the planes with p\u00b7y = 1, which are neighbours of ${tag(i)}: they belong to its <i>ring</i>. And p\u00b7y = 1 can be read two ways: y lies on the plane of p, and p lies on the plane of y. So the corner y is a triangle of the dual without ${tag(i)}, a green one, and the point of ${tag(i)} lies above it.</p><p>A dual point that is no corner of the dual hull brings no test of its own: its halfspace is redundant.</p>`,
  };
}

// The plane through three dual points, the vertex that it is polar to, and the height of a fourth over it.
function vertexFormulas(t, c) {
  const [a, b, d] = t.map(i => ({n: plane(i).slice(0, 3), w: weightAt(i, c)})), D = gap(t);
  const x = [cross(b.n, d.n).map(v => v.times(a.w)), cross(d.n, a.n).map(v => v.times(b.w)), cross(a.n, b.n).map(v => v.times(d.w))]
    .reduce((u, v) => u.map((value, k) => value.plus(v[k])));
  const p = first().third(t[1], t[0]), q = plane(p).slice(0, 3), h = dot(x, q).minus(D.times(weightAt(p, c)));
  const brackets = v => mo("(") + v.map(mathOf).join(mo(",")) + mo(")");
  return "<p>Moved to the center, the three planes read n\u00b7y = w. Cramer's rule solves these equations, y = x / D:</p>" +
    formula(mi("D"), mo("="), word("det"), mo("("), t.map(i => sub("n", i)).join(mo(",")), mo(")"), mo("="), mathOf(D)) +
    formula(mi("x"), mo("="), t.map((_, k) => sub("w", t[k]) + sub("n", t[(k + 1) % 3]) + mo("\u00d7") + sub("n", t[(k + 2) % 3])).join(mo("+")), mo("="), brackets(x)) +
    formula(word("vertex"), mo("="), mi("c"), mo("+"), mi("x"), mo("/"), mi("D"), mo("="), brackets(x.map((value, k) => c[k].plus(value.over(D))))) +
    `<p>D &gt; 0 says that the planes meet in one point, and that the triangle faces away from the origin. It is a vertex of the solid unless another plane cuts it off. Take a halfspace across an edge of this triangle, ${tag(p)}. Its dual point may lie above the triangle or below; that is its <i>height</i>:</p>` +
    formula(word("height"), mo("="), mi("x"), mo("\u00b7"), sub("n", p), mo("\u2212"), mi("D"), sub("w", p), mo("="), mathOf(h)) +
    `<p>With y = x / D and the dual point p = n / w, the height is D w (p\u00b7y \u2212 1). D and w are positive. So a positive height says p\u00b7y &gt; 1: plane ${tag(p)} would cut the vertex off. A negative one says that the vertex is inside, and 0 that it lies on the plane.</p>` +
    `<p>The height is also the determinant whose four rows are (n1, n2, n3, d) of the planes ${tags([...t, p])}, which is ${computed(height(t, p))}. Are they equal? ${verdict(height(t, p).compare(h) === 0)} No center occurs in it. So move the center: x and the w change, but D, the height and the vertex stay.</p>`;
}

// Where the line from the center at right angles to plane i meets it, drawn.
function footOf(i, from) {
  const scale = vector(lesson.frame.scale), n = plane(i).slice(0, 3), share = weightAt(i, movedCenter()).over(dot(n, n));
  return from.map((x, k) => x + n[k].times(share).times(scale[k]).toNumber());
}

// --- topology: the adjacency matrix ----------------------------------------------------------------

function topologyChapter() {
  const show = () => {
    const ids = first().present(), t = pickedTriangle(), i = pickedHalfspace();
    const marks = t ? mark(t, "ring") : i !== null && first().rows().has(i) ? {...mark(first().ring(i), "ring"), [i]: "chosen"} : {};
    const at = t && recorded(first().vertex(t[0], t[1])).at;
    const cell = (r, s) => {
      const k = first().third(r, s);
      if (k === undefined) return "<td>\u00b7</td>";
      const isPart = t && key([r, s, k]) === key(t) && [[0, 1], [1, 2], [2, 0]].some(([a, b]) => t[a] === r && t[b] === s);
      return `<td${isPart ? ' class="chosen"' : ""}><button type="button" class="link" data-pick="t${key([r, s, k])}" aria-label="row ${r}, column ${s}: ${k}">${k}</button></td>`;
    };
    const closed = ids.every(r => first().ring(r).every(s => {
      const k = first().third(r, s);
      return first().third(s, r) !== undefined && first().third(s, k) === r && first().third(k, r) === s;
    })) && first().edges.size === ids.reduce((sum, r) => sum + first().ring(r).length, 0);
    const edges = first().edges.size / 2, faces = first().triangles().length;
    const matrix = ids.length > 64 ? "" : `<div class="scroll" tabindex="0" role="region" aria-label="The matrix"><table class="matrix"><thead><tr><th></th>${ids.map(s => `<th scope="col">${s}</th>`).join("")}</tr></thead><tbody>${
      ids.map(r => `<tr><th scope="row"><button type="button" class="link" data-pick="h${r}">${r}</button></th>${ids.map(s => cell(r, s)).join("")}</tr>`).join("")}</tbody></table></div>`;
    return {
      say: t ? `Entry (${t[0]}, ${t[1]}) is ${tag(t[2])}: walking from ${tag(t[0])} to ${tag(t[1])} on the outside of the dual, the triangle with ${tag(t[2])} lies on the left. It stands in the matrix three times, once for each of its edges.`
        : i !== null ? `Row ${tag(i)} holds the one-ring of its dual point: ${tags(first().ring(i))}, in this order around it.`
        : "Which triangles the dual has is kept in a matrix. Entry (i, j) = k says: seen from outside, the triangle i, j, k lies to the left of the edge from i to j. So in row i the entry under j is the neighbour that follows j around i. Pick an entry.",
      solid: {items: [{...solidItem(first(), marks), mark: "glass"}, {dots: at ? [{at, mark: "chosen", size: 6}] : []}]},
      dual: {items: [dualItem(first(), marks, t ? {[key(t)]: "chosen"} : {})]},
      more: (matrix || `<p>With ${ids.length} rows the table would be larger than the page; pick a point of the dual to see its row.</p>`) +
        `<p>Is the surface closed, and does every entry agree with the two others of its triangle? ${verdict(closed)}</p>` +
        `<p>${ids.length} points \u2212 ${edges} edges + ${faces} triangles = ${ids.length - edges + faces}, as Euler has it for a surface like a sphere. n points have 2n \u2212 4 triangles: 2 \u00b7 ${ids.length} \u2212 4 = ${2 * ids.length - 4}.</p>`,
    };
  };
  return [{id: "topology", title: "The adjacency matrix", show}];
}
