// SPDX-License-Identifier: MIT
// What lessons in the plane share: numbers and words, the panes, questions, and what hands do. A lesson calls begin().
"use strict";

const given = JSON.parse(document.getElementById("lesson").textContent);
const byId = id => document.getElementById(id);
const start = given.points.map(vector);

// ---- Numbers and words

const kDigits = 5;
// A fraction if it is short, else its first digits; all of it as the title. `what` names it for whoever checks it.
function num(x, what) {
  const exact = x.toString(), text = exact.length <= 8 ? exact.replace("-", "\u2212") : x.decimal(kDigits);
  return `<span class="number" data-what="${what}" data-exact="${exact}" title="${exact}">${text}</span>`;
}
const pair = (p, what) => `(${num(p[0], `${what}/0`)}, ${num(p[1], `${what}/1`)})`;
const name = id => `<b class="id">${id}</b>`;
const list = ids => ids.map(name).join(ids.length === 2 ? " and " : ", ");
const rows = (heads, body) => `<div class="scroll"><table><thead><tr>${heads.map(h => `<th>${h}</th>`).join("")}</tr></thead><tbody>${
  body.map(({cells, mark = ""}) => `<tr class="${mark}">${cells.map(c => `<td>${c}</td>`).join("")}</tr>`).join("")}</tbody></table></div>`;

// ---- The grid on which things lie that are dragged, and the frame, which stays

const extent = [0, 1].map(k => start.map(p => p[k].toNumber())).map(xs => [Math.min(...xs), Math.max(...xs)]);
const powerOfTwo = e => e >= 0 ? new Rational(1n << BigInt(e)) : new Rational(1n, 1n << BigInt(-e));
const size = Math.max(...extent.map(([a, b]) => b - a)), gridExponent = Math.floor(Math.log2(size / 12));
const pointGrid = powerOfTwo(gridExponent), centerGrid = powerOfTwo(gridExponent - 2);
const onGrid = (x, grid) => grid.times(new Rational(BigInt(Math.round(x / grid.toNumber()))));

// The frame is that of the first polygon and stays.
const middle = extent.map(([a, b]) => (a + b) / 2), scale = 125 / (size / 2);
const toSolid = p => [(p[0].toNumber() - middle[0]) * scale, -(p[1].toNumber() - middle[1]) * scale];
const path = points => points.map(([x, y]) => `${x.toFixed(2)} ${y.toFixed(2)}`).join("L");
const label = ([x, y], text, mark = "") => `<text x="${x.toFixed(1)}" y="${(y + 4).toFixed(1)}" class="${mark}">${text}</text>`;
const dotAt = ([x, y], mark, more = "", r = 5) => `<circle cx="${x.toFixed(2)}" cy="${y.toFixed(2)}" r="${r}" class="dot ${mark}" ${more}/>`;

// ---- What is asked: never blocks, and tells why an answer is right or wrong

// @param words  To choose from; none: the answer is clicked in a picture.
function ask(id, question, isRight, why, words = []) {
  const answer = state.answered[id], buttons = words.map(word => `<button type="button" data-answer="${word}">${word}</button> `).join("");
  return `<fieldset data-question="${id}"><legend>Before you read on</legend><p>${question}</p>` +
    (answer === undefined ? `<p>${buttons}<button type="button" class="link" data-tell="1">I give up, tell me</button></p>`
      : `<p>${answer === "told" ? "" : isRight(answer) ? "<b class=\"yes\">Right.</b> " : "<b class=\"wrong\">Not so.</b> "}${why(answer)}</p>`) + "</fieldset>";
}

// ---- The lesson at hand, and what hands do

// start(): the state at first. modelOf(state): all that follows from it; null if it cannot be. forget: the changes
// of a new chapter. pick(target, pane, at): what was clicked. canMove(what, pane), moveTo(what, at): what is dragged,
// `at` in the pane. whereIs(what): where it is, and the grid of its steps by keys. input(data, value): a slider.
// settled(): after a change that is not in the middle of dragging.
let lesson = null, state = null, model = null;

const near = (a, b, far) => Math.hypot(a[0] - b[0], a[1] - b[1]) <= far;
function answer(id, what) {
  if (state.answered[id] === undefined) state.answered[id] = what;
}
function set(changes) {
  const made = lesson.modelOf({...state, ...changes});
  if (!made) return;  // it stays as it was
  Object.assign(state, changes);
  model = made;
  if (!state.drag) lesson.settled?.();
  draw();
}
const chapterId = () => lesson.chapters[state.chapter].id;
// What a chapter begins with.
const fresh = chapter => ({...lesson.forget, ...lesson.chapters[chapter].begin});
function go(to) {
  const chapter = Math.max(0, Math.min(lesson.chapters.length - 1, to));
  set({chapter, ...fresh(chapter)});
}

function draw() {
  const chapter = lesson.chapters[state.chapter], shown = chapter.show();
  byId("contents").querySelector("ol").innerHTML = lesson.chapters.map(({id, title}, k) => `<li><a href="#${id}"${k === state.chapter ? " aria-current=\"step\"" : ""}>${title}</a></li>`).join("");
  document.querySelector("#stage h2").textContent = chapter.title;
  byId("say").innerHTML = shown.say;
  byId("solid").querySelector("svg").innerHTML = shown.solid;
  byId("dual").hidden = !shown.dual;
  byId("dual").querySelector("svg").innerHTML = shown.dual ?? "";
  byId("question").innerHTML = shown.question;
  byId("more").innerHTML = shown.more;
  byId("have").innerHTML = `<b>Now you have:</b> ${shown.have}`;
  byId("back").disabled = state.chapter === 0;
  byId("next").disabled = state.chapter === lesson.chapters.length - 1;
  if (location.hash.slice(1) !== chapter.id) history.replaceState(null, "", `#${chapter.id}`);
}

const placeIn = (svg, event) => {
  const {x, y} = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
  return [x, y];
};
const fromSolid = ([x, y], grid) => [onGrid(x / scale + middle[0], grid), onGrid(-y / scale + middle[1], grid)];

function take(pane) {
  const svg = byId(pane).querySelector("svg");
  svg.addEventListener("pointerdown", event => {
    const what = {...event.target.dataset};
    state.drag = null;
    lesson.pick(event.target, pane, placeIn(svg, event));
    if (!lesson.canMove(what, pane)) return;
    state.drag = what;
    svg.setPointerCapture(event.pointerId);
  });
  svg.addEventListener("pointermove", event => { if (state.drag) lesson.moveTo(state.drag, placeIn(svg, event)); });
  svg.addEventListener("pointerup", () => {
    if (!state.drag) return;
    state.drag = null;
    set({});
  });
  svg.addEventListener("keydown", event => {
    const what = {...event.target.dataset}, arrow = {ArrowLeft: [-1n, 0n], ArrowRight: [1n, 0n], ArrowUp: [0n, 1n], ArrowDown: [0n, -1n]}[event.key];
    if (event.key === "Enter" || event.key === " ") lesson.pick(event.target, pane, null);
    else if (!arrow || !event.shiftKey || !lesson.canMove(what, pane)) return;
    else {
      const {from, grid} = lesson.whereIs(what);
      lesson.moveTo(what, toSolid(from.map((x, k) => x.plus(grid.times(new Rational(arrow[k]))))));
      const [key, name] = Object.entries(what)[0];
      svg.querySelector(`[data-${key}="${name}"]`)?.focus();
    }
    event.preventDefault();
    event.stopPropagation();
  });
}

function begin(theLesson) {
  lesson = theLesson;
  const first = () => ({chapter: 0, answered: {}, drag: null, ...lesson.start()});
  const fromAddress = () => go(Math.max(0, lesson.chapters.findIndex(({id}) => id === location.hash.slice(1))));
  state = first();
  ["solid", "dual"].forEach(take);
  byId("back").addEventListener("click", () => go(state.chapter - 1));
  byId("next").addEventListener("click", () => go(state.chapter + 1));
  byId("reset").addEventListener("click", () => set({...first(), chapter: state.chapter, ...lesson.chapters[state.chapter].begin}));
  byId("question").addEventListener("click", event => {
    const id = event.target.closest("[data-question]")?.dataset.question;
    if (event.target.dataset.tell) answer(id, "told");
    if (event.target.dataset.answer) answer(id, event.target.dataset.answer);
    set({});
  });
  for (const kind of ["input", "click"]) {
    byId("more").addEventListener(kind, event => {
      const isSlider = event.target.localName === "input";
      if (isSlider !== (kind === "input") || Object.keys(event.target.dataset).length === 0) return;
      lesson.input(event.target.dataset, event.target.value);
      if (isSlider) byId("more").querySelector("input")?.focus();
    });
  }
  document.addEventListener("keydown", event => {
    if (event.target.closest("input")) return;
    if (event.key === "ArrowRight") go(state.chapter + 1);
    if (event.key === "ArrowLeft") go(state.chapter - 1);
    if (event.key === "Escape") set(fresh(state.chapter));
  });
  addEventListener("hashchange", fromAddress);
  fromAddress();
}
