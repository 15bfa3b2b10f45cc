// SPDX-License-Identifier: MIT
// The page: its contents, the step that is shown, and how a reader goes from step to step.
"use strict";

const chapterNames = {film: "The whole run", hull: "The hull", center: "The center", polar: "Polar duality", topology: "The adjacency matrix",
  removal: "Removing halfspaces", verification: "Verification", storing: "Storing the result"};
const makers = {film: filmChapter, hull: hullChapter, center: centerChapter, polar: polarChapter, topology: topologyChapter,
  removal: removalChapter, verification: verificationChapter, storing: storingChapter};
for (const [id, make] of Object.entries(makers)) {
  const part = {film: lesson.failed ? null : lesson.removals, removal: lesson.removals, verification: lesson.removals, polar: lesson.topology}[id] || lesson[id];
  const steps = part ? make(part) : [];
  if (steps.length) chapters.push({id, name: chapterNames[id], steps});
}
const steps = chapters.flatMap(chapter => chapter.steps.map(step => ({...step, chapter})));
for (const step of steps) step.isEntry = /^[a-z]+$|^(removal|verification)-(\d+|end)$/.test(step.id);  // in the contents
const element = id => document.getElementById(id);
let place = 0;
// A walk leaves out details, but where one is shown it goes on to the next.
const isOnWalk = k => k >= 0 && k < steps.length && (!steps[k].isDetail || steps[place].isDetail);
function walk(by) {
  let to = place + by;
  while (to >= 0 && to < steps.length && !isOnWalk(to)) to += by;
  return Math.max(0, Math.min(steps.length - 1, to));
}
const walked = steps.filter(step => !step.isDetail);
const placeOnWalk = () => steps.slice(0, place + 1).filter(step => !step.isDetail).length;

// --- what is shown ---------------------------------------------------------------------------------

const panes = {solid: new Pane(element("solid"), pick, dragCenter), dual: new Pane(element("dual"), pick, dragCenter)};

function pick(what) {
  state.picked = what;
  show();
}

// A number that ends in dots ends its sentence, too.
const ended = text => text.replace(/\u2026((?:<\/\w+>)*)\.(?!\w)/g, "\u2026$1");

// Draws the step at hand; the element that has the focus keeps it, although tables are made anew.
function show() {
  const step = steps[place], {say, solid, dual, more, picture} = step.show(), had = document.activeElement;
  const again = had?.dataset && Object.entries(had.dataset).find(([name]) => ["pick", "center", "grow", "magnify", "picker", "home", "film", "play", "speed"].includes(name));
  for (const [name, {items, radius, note, name: title}] of Object.entries({solid, dual})) {
    element(name).hidden = items.length === 0;
    panes[name].show(items, radius || radiusOf(items));
    element(name).querySelector("figcaption b").textContent = title || name;
    element(name).querySelector("figcaption span").textContent = note || "";
  }
  element("stage").querySelector("h2").textContent = step.title === step.chapter.name ? step.title : `${step.chapter.name} \u2014 ${step.title}`;
  element("say").innerHTML = ended(say);
  element("picture").innerHTML = picture || "";
  element("more").innerHTML = ended(more);
  if (again) {
    const name = again[0].replace(/[A-Z]/g, c => "-" + c.toLowerCase());
    document.querySelector(`main [data-${name}="${again[1]}"]:not(svg *)`)?.focus();
  }
}

// Goes to a step, by its place in the whole lesson.
function go(to, isNew = true) {
  const before = steps[place];
  place = Math.max(0, Math.min(steps.length - 1, to));
  const step = steps[place];
  if (before.chapter !== step.chapter) state.picked = null;
  state.isTold ||= before !== step && before.chapter.id === "removal";  // the question before the first removal was seen
  state.grown = 1;
  state.magnified = null;
  for (const text of document.querySelectorAll(".chapter-text")) {
    const isLast = text.dataset.after !== undefined, own = isLast ? step.chapter.steps.at(-1) : step.chapter.steps[0];
    text.hidden = (text.dataset.chapter ?? text.dataset.after) !== step.chapter.id || own.id !== step.id;
  }
  element("timeline").value = placeOnWalk() - 1;
  element("timeline").setAttribute("aria-valuetext", `${step.chapter.name}, ${step.title}`);
  element("count").textContent = `${placeOnWalk()} of ${walked.length}${step.isDetail ? ", in detail" : ""}`;
  element("back").disabled = place === 0;
  element("next").disabled = place === steps.length - 1;
  for (const link of document.querySelectorAll("#contents a")) {
    const isHere = link.hash === `#${entryOf(step).id}`;
    link.toggleAttribute("aria-current", isHere);
    if (isHere) for (const group of document.querySelectorAll("#contents ol details")) group.open = group.contains(link);
    if (isHere && link.offsetParent) element("contents").scrollTop = link.offsetTop - element("contents").clientHeight / 2;
  }
  if (isNew) history.replaceState(null, "", `#${step.id}`);
  const radius = panes.solid.radius;
  show();
  if (step.grows) grow();
  else if (before.chapter === step.chapter) panes.solid.zoomFrom(radius);
}

// The cap grows once when its step is shown, unless the reader prefers that nothing moves.
function grow() {
  if (matchMedia("(prefers-reduced-motion: reduce)").matches) return;
  const from = performance.now(), at = place;
  const frame = now => {
    if (at !== place) return;
    state.grown = Math.min(1, (now - from) / 900);
    show();
    if (state.grown < 1) requestAnimationFrame(frame);
  };
  requestAnimationFrame(frame);
}

// Moves the center as far towards a place as it stays strictly inside.
function moveCenter(axis, to) {
  const isInside = () => lesson.topology.present.every(i => weightAt(i, movedCenter()).sign() > 0);
  state.center[axis] = to;
  while (!isInside() && state.center[axis] !== 0) state.center[axis] -= Math.sign(state.center[axis]);
  if (!isInside()) state.center = [0, 0, 0];
}

// The center follows the hand on its grid, so that all numbers stay exact.
function dragCenter(_, by) {
  const step = centerStep().toNumber();
  by.forEach((x, k) => {
    state.drawnCenter[k] += x / (step * Rational.of(lesson.frame.scale[k]).toNumber());
    moveCenter(k, Math.max(-24, Math.min(24, Math.round(state.drawnCenter[k]))));
  });
  show();
}

// --- contents --------------------------------------------------------------------------------------

function entryOf(step) {
  for (let k = steps.indexOf(step); k >= 0; --k) if (steps[k].isEntry) return steps[k];
  return steps[0];
}
const shortTitle = step => step.title.replace(/: the cheapest$/, "");
// So many entries of a chapter share a line that opens: a chapter has at most two dozen lines.
const groupSize = entries => entries <= 24 ? 1 : [5, 10, 20, 50, 100, 200, 500].find(size => entries <= 12 * size) ?? Math.ceil(entries / 12);

function fillContents() {
  const contents = chapters.map(chapter => {
    const entries = steps.filter(step => step.chapter === chapter && step.isEntry);
    const link = (id, name) => `<a href="#${id}">${escaped(name)}</a>`;
    if (entries.length < 2) return `<li>${link(chapter.steps[0].id, chapter.name)}</li>`;
    const lines = entries.map(step => `<li>${link(step.id, shortTitle(step))}</li>`), size = groupSize(entries.length);
    const groups = Array.from({length: Math.ceil(entries.length / size)}, (_, k) => k * size).map(k => {
      const last = Math.min(k + size, entries.length) - 1;
      const [from, to] = [entries[k], entries[last]].map(shortTitle), word = from.split(" ")[0];
      return `<li><details><summary>${escaped(from.replace(/,.*/, ""))} \u2026 ${escaped(to.replace(/,.*/, "").replace(word, "").trim())}</summary><ol>${lines.slice(k, last + 1).join("")}</ol></details></li>`;
    });
    return `<li>${escaped(chapter.name)}<ol>${(size > 1 ? groups : lines).join("")}</ol></li>`;
  });
  element("contents").querySelector("ol").innerHTML = contents.join("");
  if (lesson.left_out.length === 0) return;
  element("missing").hidden = false;
  element("missing").querySelector("ul").innerHTML = lesson.left_out.map(({chapter, why}) => `<li><b>${escaped(chapterNames[chapter] || chapter)}</b>: ${escaped(why)}</li>`).join("");
}

// A link to any step; one to a step that is not there leads to its chapter, as "removal" alone does.
function land(isNew) {
  const id = location.hash.slice(1), at = steps.findIndex(step => step.id === id);
  const chapter = steps.findIndex(step => step.chapter.id === id.split("-")[0]);
  go(at >= 0 ? at : Math.max(0, chapter), isNew);
}

// --- the reader ------------------------------------------------------------------------------------

element("back").onclick = () => go(walk(-1));
element("next").onclick = () => go(walk(1));
element("timeline").max = walked.length - 1;
element("timeline").oninput = event => go(steps.indexOf(walked[event.target.value]));
for (const name of ["digits", "doubles", "labels"]) {
  element(name).checked = display[name];
  element(name).onchange = event => {
    display[name] = event.target.checked;
    show();
  };
}
document.addEventListener("input", ({target}) => {
  if (target.dataset.center !== undefined) {
    moveCenter(target.dataset.center, Number(target.value));
    state.drawnCenter = [...state.center];
  }
  else if (target.dataset.grow !== undefined) state.grown = target.value / 100;
  else if (target.dataset.magnify !== undefined) state.magnified = (80 - target.value) / 10;
  else if (target.dataset.picker !== undefined) state.picked = target.value || null;
  else return;
  show();
});
document.addEventListener("click", ({target}) => {
  const button = target.closest("button[data-pick], button[data-home], button[data-told]");
  if (!button) return;
  if (button.dataset.told !== undefined) state.isTold = true;
  else if (button.dataset.home !== undefined) [state.center, state.drawnCenter] = [[0, 0, 0], [0, 0, 0]];
  else state.picked = button.dataset.pick;
  show();
});
document.addEventListener("keydown", event => {
  if (event.ctrlKey || event.metaKey || event.altKey || /^(INPUT|SELECT)$/.test(event.target.tagName) && event.key !== "Escape") return;
  const chapter = chapters.indexOf(steps[place].chapter), startOf = c => steps.findIndex(step => step.chapter === chapters[c]);
  const keys = {
    ArrowLeft: () => go(walk(-1)), ArrowRight: () => go(walk(1)), Home: () => go(0), End: () => go(steps.length - 1),
    PageUp: () => go(startOf(Math.max(0, chapter - 1))), PageDown: () => go(startOf(Math.min(chapters.length - 1, chapter + 1))),
    Escape: () => pick(null),
  };
  if (!keys[event.key]) return;
  event.preventDefault();
  keys[event.key]();
});
window.addEventListener("hashchange", () => land(false));

element("how").textContent = "Coordinates are rounded to be drawn; numbers in the text are exact, and one that ends in dots is cut off there." +
  (isStretched ? " The solid is long and thin, so each axis is drawn to a scale of its own." : "");
if (!isStretched) panes.solid.measureBy(1 / Rational.of(lesson.frame.scale[0]).toNumber());
// A link to a step or a chapter leads to the top of the page, where the panes are.
element("anchors").innerHTML = [...new Set([...steps, ...chapters].map(({id}) => id))].map(id => `<i id="${id}"></i>`).join("");
fillContents();
element("contents").querySelector("details").open = innerWidth > 960;
land(true);
