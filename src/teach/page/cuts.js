// SPDX-License-Identifier: MIT
// The lesson on parts: why one hull fills a bin, and how cuts and merges give few parts that hold it and stay near it.
"use strict";

const outline = areaOf(start).sign() < 0 ? [...start].reverse() : start;
const kPalette = ["ring", "tight", "new", "lost", "chosen", "lit"];
const diameter = Math.hypot(...extent.map(([a, b]) => b - a));
const quarters = k => pointGrid.times(new Rational(BigInt(k), 4n));

// A corner that turns inward.
const isNotch = (polygon, k) => {
  const [a, b, c] = [k + polygon.length - 1, k, k + 1].map(i => polygon[i % polygon.length]);
  return cross2(difference(b, a), difference(c, b)).sign() < 0;
};
const piecesOf = lines => lines.reduce((pieces, line) => pieces.flatMap(piece => cutBy(line, piece)), [outline]);
// Cut along the side before a notch, as long as a piece has one.
const convexPieces = polygon => {
  const k = polygon.findIndex((_, i) => isNotch(polygon, i));
  return k < 0 ? [polygon] : cutBy([polygon[(k + polygon.length - 1) % polygon.length], polygon[k]], polygon).flatMap(convexPieces);
};

function modelOf({chapter, line, cuts, quarter, wide, depth, probe, joined, picked}) {
  const id = chapters[chapter].id, hull = hullPolygon(outline), distance = quarters(id === "squares" ? wide : quarter);
  const pieces = id === "cut" ? piecesOf([...cuts, line]) : id === "merge" || id === "guarantee" ? convexPieces(outline) : [outline];
  // Pieces that share a part.
  let groups = pieces.map((_, k) => [k]);
  for (const [a, b] of id === "merge" || id === "guarantee" ? joined : []) {
    const both = groups.filter(group => group.includes(a) || group.includes(b));
    groups = [both.flat(), ...groups.filter(group => !both.includes(group))].sort((x, y) => Math.min(...x) - Math.min(...y));
  }
  const parts = groups.map(group => hullPolygon(group.flatMap(k => pieces[k])));
  const over = part => squaresOver(part, outline, distance, id === "squares" ? depth : 7);
  const common = id === "merge" && picked.length === 2 ? hullPolygon(picked.flatMap(k => parts[k])) : null;
  return {hull, distance, pieces, groups, parts, common, commonVerdict: common && verdictOf(over(common)), far: farPoint(hull, outline),
    squares: id === "squares" ? over(hull) : null, verdicts: id === "hull" || id === "ball" || id === "squares" ? null : parts.map(part => verdictOf(over(part))),
    squared: probe && squaredTo(outline, probe)};
}

// ---- Drawing

const drawOutline = (mark = "") => `<path class="face front ${mark}" d="M${path(outline.map(toSolid))}Z"/>`;
const drawPart = (part, k, more = "") => `<path class="face front part ${kPalette[k % kPalette.length]}" d="M${path(part.map(toSolid))}Z" ${more}/>`;
function drawBall(at, squared) {
  const [x, y] = toSolid(at);
  return `<circle class="ball" cx="${x.toFixed(2)}" cy="${y.toFixed(2)}" r="${(Math.sqrt(squared.toNumber()) * scale).toFixed(2)}"/>`;
}
const drawProbe = at => dotAt(toSolid(at), "handle", "", 10) + dotAt(toSolid(at), "center", "data-probe=\"1\" tabindex=\"0\" role=\"button\" aria-label=\"the middle of the ball\"", 6);
function drawLine(line) {
  const [a, b] = line.map(toSolid), [u, v] = [b[0] - a[0], b[1] - a[1]], far = 500 / (Math.hypot(u, v) || 1);
  return `<path class="line gone" d="M${path([[a[0] - u * far, a[1] - v * far], [b[0] + u * far, b[1] + v * far]])}"/>` +
    [a, b].map((at, k) => dotAt(at, "handle", "", 10) + dotAt(at, "chosen", `data-end="${k}" tabindex="0" role="button" aria-label="end ${k} of the cut"`, 6)).join("");
}
const drawSquares = squares => squares.map(({middle: m, half, state: how}) => {
  const [x, y] = toSolid(m), r = half.toNumber() * scale;
  return `<rect class="cell ${how}" x="${(x - r).toFixed(2)}" y="${(y - r).toFixed(2)}" width="${(2 * r).toFixed(2)}" height="${(2 * r).toFixed(2)}"/>`;
}).join("");
const centerOf = part => part.reduce((s, p) => s.map((x, k) => x + toSolid(p)[k] / part.length), [0, 0]);

// ---- Words

const kVerdict = {within: "<b class=\"yes\">within</b>, proven", beyond: "<b class=\"wrong\">farther</b>", open: "not decided with squares so large"};
const share = x => `${(100 * x.toNumber() / diameter).toFixed(1)}% of the diameter`;
const distanceSlider = (key = "quarter") => `<p><label>allowed distance <input type="range" data-${key}="1" min="1" max="${Math.max(8, Math.round(diameter / pointGrid.toNumber() * 1.4))}" value="${state[key]}"> ${num(model.distance, "distance")}, ${share(model.distance)}</label></p>`;
const partsTable = () => rows(["part", "area of what it holds", "its area", "from the bin"], model.parts.map((part, k) => ({cells: [`<i class="${kPalette[k % kPalette.length]}"></i> ${name(k)}`,
  num(model.groups[k].map(i => areaOf(model.pieces[i])).reduce((a, b) => a.plus(b)), `held/${k}`), num(areaOf(part), `part/${k}`), kVerdict[model.verdicts[k]]]})));
const total = () => model.parts.map(areaOf).reduce((a, b) => a.plus(b));

// ---- Chapters

const chapters = [
  {id: "hull", title: "The hull fills the bin", show() {
    const {hull, far} = model, isTold = state.answered.hull !== undefined, area = areaOf(outline), excess = areaOf(hull).minus(area);
    return {
      say: "Given: a bin, seen from the side. Wanted: convex parts that hold it, because collisions with convex parts are easy to compute. One convex part is enough, the hull. But nothing can be put into that bin any more.",
      solid: drawPart(hull, 0) + drawOutline() + (isTold ? drawBall(far.at, far.squared) + (state.probe ? dotAt(toSolid(state.probe), "chosen") : "") : ""),
      question: ask("hull", "Which point of the hull is farthest from the bin? Click it.", at => at >= 0.9,
        at => `The ball shows one that nearly is: ${num(far.squared, "far")} is the square of its radius. How large the largest one can be is proven in chapter 3.${typeof at === "number" ? ` Yours has ${(100 * at).toFixed(0)}% of that distance.` : ""} How far a part reaches away from the solid is its <b>reach</b>.`),
      more: `<p>The bin has the area ${num(area, "area/polygon")}, the hull ${num(areaOf(hull), "area/hull")}: ${num(excess, "excess")} too much.</p>`,
      have: "Two ways to say how bad a part is: the area that it adds, and its reach. A slot that is filled adds little area; half its width, its reach, tells what no longer fits into it."};
  }},

  {id: "ball", title: "A ball that grows", show() {
    const at = state.probe ?? model.far.at, squared = squaredTo(outline, at);
    return {
      say: "Wanted: the distance of a point from the bin. A ball grows around it until it touches. Drag its middle, and look for the largest ball whose middle lies in the hull.",
      solid: drawPart(model.hull, 0) + drawOutline() + drawBall(at, squared) + drawProbe(at),
      question: ask("ball", "Must the largest ball have its middle at a corner of the hull?", a => a === "no",
        () => "No. From a convex shape the distance is largest at some corner of the part. From this bin it can be largest in the middle of a side, or inside, where several walls are equally far. So looking at corners proves nothing.", ["yes", "no"]),
      more: `<p>Middle ${pair(at, "probe")}, squared distance ${num(squared, "squared")}${isInConvex(model.hull, at) ? "" : ", outside the hull"}.</p>`,
      have: "The distance of any one point, exactly: the nearest point of a side has fractions as coordinates, and distances are kept squared, which avoids roots. But a part has infinitely many points."};
  }},

  {id: "squares", title: "A proof from squares", show() {
    const count = how => model.squares.filter(square => square.state === how).length, verdict = verdictOf(model.squares);
    return {
      say: `Wanted: a proof for all points at once. Cover the hull with squares; those that miss it are left out. A square is <b>within</b> if its middle is so near that the rest of it cannot be too far, and <b>farther</b> if its middle is a point of the hull that is too far; otherwise it is open, and divided. ${
        verdict === "within" ? "All are within: no point of the hull is farther than allowed." : verdict === "beyond" ? "A middle in the hull is farther than allowed: that is a witness." : "Some are open: divide once more. The proof is complete when all are within."}`,
      solid: drawOutline() + drawSquares(model.squares) + drawPart(model.hull, 0, "fill-opacity=\"0\""),
      question: ask("squares", "The middle of a square is nearer than allowed. Is all of the square?", a => a === "no",
        () => "Not yet. Its corners may be farther, by at most half its diagonal. So the middle must be nearer than the allowed distance less that. To stay exact, the diagonal is taken as 99/70 of the side, a little more than the root of 2.", ["yes", "no"]),
      more: distanceSlider("wide") + `<p><label>divided at most <input type="range" data-depth="1" min="0" max="7" value="${state.depth}"> ${state.depth} times</label></p>
        <p>${model.squares.length} squares: <span class="colors"><i class="new"></i> ${count("within")} within <i class="tight"></i> ${count("open")} open <i class="chosen"></i> ${count("beyond")} farther</span></p>`,
      have: "Where all squares are within, a proof that anybody can check: a list of squares that cover the part, and one distance for each. In space they are cubes, and <code>--proof</code> writes them down."};
  }},

  {id: "cut", title: "Cut", show() {
    return {
      say: `Wanted: parts that reach less. A line cuts the bin into ${model.pieces.length} pieces, and each gets a hull of its own. Drag the ends of the line; keep it if you like it, and cut again.`,
      solid: model.parts.map((part, k) => drawPart(part, k)).join("") + drawOutline("thin") + model.parts.map((part, k) => label(centerOf(part), k)).join("") +
        outline.map((p, k) => `<circle class="dot corner" cx="${toSolid(p)[0].toFixed(2)}" cy="${toSolid(p)[1].toFixed(2)}" r="5" data-corner="${k}" tabindex="0" role="button" aria-label="corner ${k}"/>`).join("") + drawLine(state.line),
      question: ask("cut", "Through which corner of the bin would a good cut go? Click one.", k => isNotch(outline, k),
        () => "Through a <b>notch</b>, a corner that turns inward. Without notches a piece is convex, its hull is itself, and nothing is left to do."),
      more: distanceSlider() + partsTable() + `<p><button type="button" data-keep="1">keep this cut</button> <button type="button" data-forget="1"${state.cuts.length ? "" : " disabled"}>forget the ${state.cuts.length} kept</button> All parts together: ${num(total(), "total")}, the bin ${num(areaOf(outline), "area/polygon")}.</p>`,
      have: "A <b>piece</b> is cut from the bin, and a <b>part</b> is its hull. Whatever the line, each point of the bin is in a piece, and each piece in its part. How far parts reach, what area they add and how many there are depends on how well one cuts."};
  }},

  {id: "merge", title: "Merge", show() {
    const pairs = model.parts.flatMap((_, a) => model.parts.slice(a + 1).map((_, i) => `${a} and ${a + 1 + i}`)), two = state.picked.length === 2;
    const ok = words => {
      const both = hullPolygon(words.split(" and ").flatMap(k => model.parts[k]));
      return verdictOf(squaresOver(both, outline, model.distance, 7)) === "within";
    };
    return {
      say: `Cut at every notch, the bin has ${model.pieces.length} pieces, all convex: exact, but more parts than one needs. Wanted: fewer. Two parts become one if their common hull stays within the allowed distance. Pick two.`,
      solid: (model.common ? drawPart(model.common, 4, "fill-opacity=\"0.15\"") : "") + model.parts.map((part, k) => drawPart(part, k, `data-part="${k}" tabindex="0" role="button" aria-label="part ${k}"`)).join("") + drawOutline("thin quiet") +
        model.parts.map((part, k) => label(centerOf(part), k, state.picked.includes(k) ? "chosen" : "")).join(""),
      question: pairs.length && pairs.length <= 10 ? ask("merge", `Which two may be joined, if ${share(model.distance)} is allowed?`, words => words === "none" ? !pairs.some(ok) : ok(words),
        () => `${pairs.filter(ok).length ? `Allowed: ${pairs.filter(ok).join("; ")}.` : "None: each common hull reaches farther."} Move the slider and see when others are.`, [...pairs, "none"]) : "",
      more: distanceSlider() + (two ? `<p>The common hull of ${list(state.picked)} has the area ${num(areaOf(model.common), "common")}; from the bin: ${kVerdict[model.commonVerdict]}. <button type="button" data-join="1"${model.commonVerdict === "within" ? "" : " disabled"}>join them</button></p>` : "") +
        partsTable() + (state.joined.length ? "<p><button type=\"button\" data-apart=\"1\">take all apart again</button></p>" : ""),
      have: "Fewer parts for the distance that you can afford: this is the only number that has to be chosen. (The diameter here is that of the box around the bin. 3% of it is usual; this lesson exaggerates.)"};
  }},

  {id: "guarantee", title: "The guarantee", show() {
    const corners = model.groups.flatMap((group, k) => group.flatMap(i => model.pieces[i].map(p => isInConvex(model.parts[k], p))));
    const isNear = model.verdicts.every(v => v === "within");
    return {
      say: `${model.parts.length} parts. Two sentences are proven: the parts hold the whole bin, and no point of them is farther from it than ${num(model.distance, "distance")}${isNear ? "" : ", but here the second one fails"}.`,
      solid: model.parts.map((part, k) => drawPart(part, k)).join("") + drawOutline("thin") + model.parts.map((part, k) => label(centerOf(part), k)).join(""),
      question: ask("guarantee", "All corners of the bin lie in parts. Do the parts then hold the bin?", a => a === "no",
        () => "No. A side between two corners may run through a gap between parts, and a hole inside touches no corner at all. That is why the pieces matter: they cover the bin, and each lies in one part with all its corners, and so with all its points.", ["yes", "no"]),
      more: distanceSlider() + rows(["claim", "how it is proven", "here"], [
        {cells: ["The pieces cover the bin.", "They lie in it, without overlap; so equal area means that nothing is missing.", `${num(model.pieces.map(areaOf).reduce((a, b) => a.plus(b)), "pieces")} = ${num(areaOf(outline), "area/polygon")}`]},
        {cells: ["Each piece lies in its part.", "Each corner of it does (those where pieces meet count in each), and parts are convex.", `${corners.filter(Boolean).length} of ${corners.length} corners`]},
        {cells: ["No part reaches farther.", "Squares.", `${model.verdicts.filter(v => v === "within").length} of ${model.parts.length} parts`]}]) + partsTable(),
      have: "What <code>convexact decompose FILE --distance 3%</code> does in space, with cubes for squares and planes for lines, and what <code>convexact verify FILE PARTS --distance 3%</code> decides about anybody's parts. (It knows no pieces of theirs, and finds itself what of the surface and of the inside is in no part.)"};
  }},
];

// ---- What hands do

const toggled = (list, k) => list.includes(k) ? list.filter(x => x !== k) : [...list, k].slice(-2);

function pick(target, pane, at) {
  const id = chapterId(), {part, corner} = target.dataset;
  if (id === "hull" && at && state.answered.hull === undefined) {
    const probe = fromSolid(at, centerGrid);
    answer("hull", isInConvex(model.hull, probe) ? Math.sqrt(squaredTo(outline, probe).over(model.far.squared).toNumber()) : 0);
    return set({probe});
  }
  if (id === "cut" && corner !== undefined) answer("cut", Number(corner));
  return set(id === "merge" && part !== undefined ? {picked: toggled(state.picked, Number(part))} : {});
}

function moveTo(what, at) {
  const to = fromSolid(at, centerGrid);
  if (toSolid(to).some(x => Math.abs(x) > 190)) return;
  if (what.probe) set({probe: to});
  else if (what.end !== undefined) {
    const line = state.line.map((p, k) => k === Number(what.end) ? to : p);
    if (line[0].some((x, k) => x.compare(line[1][k]) !== 0)) set({line});
  }
}

begin({
  chapters, modelOf, pick, moveTo,
  // The line is no good one, the distance for squares can be proven, and the other one allows some merges.
  start: () => ({line: [0.55, 0.2].map((share, k) => [onGrid(extent[0][k], centerGrid), onGrid(extent[1][0] + share * (extent[1][1] - extent[1][0]), centerGrid)]), cuts: [],
    quarter: Math.max(1, Math.round(diameter / pointGrid.toNumber() * 0.64)), wide: Math.ceil(4.6 * Math.sqrt(farPoint(hullPolygon(outline), outline).squared.toNumber()) / pointGrid.toNumber()),
    depth: 2, probe: null, joined: [], picked: []}),
  forget: {picked: []},
  canMove: (what, pane) => pane === "solid" && (what.probe !== undefined || what.end !== undefined),
  whereIs: what => ({from: what.probe ? state.probe ?? model.far.at : state.line[what.end], grid: centerGrid}),
  input(data, value) {
    if (data.quarter) set({quarter: Number(value)});
    if (data.wide) set({wide: Number(value)});
    if (data.depth) set({depth: Number(value)});
    if (data.keep) set({cuts: [...state.cuts, state.line]});
    if (data.forget) set({cuts: []});
    if (data.join) set({joined: [...state.joined, state.picked.map(k => model.groups[k][0])], picked: []});
    if (data.apart) set({joined: [], picked: []});
  },
});
