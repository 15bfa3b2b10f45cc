// SPDX-License-Identifier: MIT
// The whole run as a film: the solid and its dual after any number of removals, and the curve of what they cost.
"use strict";

const film = {at: 0, playing: false, speed: 2};  // removals shown, and per second
const kCurve = {left: 60, right: 590, top: 14, low: 110};
const removalX = k => kCurve.left + (kCurve.right - kCurve.left) * (lesson.removals.length > 1 ? k / (lesson.removals.length - 1) : 0.5);

// Of a decimal of any size, such as "2.5e-400"; -Infinity of 0.
function log10Of(text) {
  const [digits, power = "0"] = text.split("e");
  return Math.log10(Number(digits)) + Number(power);
}
function shortPower(log) {
  if (log > -3 && log < 5) return String(Number((10 ** log).toPrecision(2)));
  return `${(10 ** (log - Math.floor(log))).toFixed(1)}e${Math.floor(log)}`;
}

// Points of the curve: costs on a logarithmic axis; one of 0 lies at the bottom.
function costCurve() {
  const logs = lesson.removals.map(removal => log10Of(removal.cost.decimal)), known = logs.filter(Number.isFinite);
  if (known.length === 0) return null;
  const least = Math.min(...known), most = Math.max(least + 1, ...known);
  const y = log => kCurve.low - (Number.isFinite(log) ? (kCurve.low - kCurve.top) * (log - least) / (most - least) : 0);
  return {points: logs.map((log, k) => [removalX(k), y(log)]), least, most};
}
function drawnCurve() {
  const curve = costCurve();
  if (!curve) return "";
  const [x, y] = curve.points[Math.min(film.at, curve.points.length - 1)];
  return `<svg id="film-curve" class="ruler" viewBox="0 0 620 140" role="img" aria-label="What each removal costs; the slider above moves the dot">
    <path class="tick" d="M${kCurve.left} ${kCurve.top}V${kCurve.low}H${kCurve.right}"/>
    <path class="curve" d="M${curve.points.map(([u, v]) => `${u.toFixed(1)} ${v.toFixed(1)}`).join("L")}"/>
    <circle class="dot chosen" cx="${x.toFixed(1)}" cy="${y.toFixed(1)}" r="6"/>
    <text x="30" y="${kCurve.top + 6}">${escaped(shortPower(curve.most))}</text><text x="30" y="${kCurve.low + 4}">${escaped(shortPower(curve.least))}</text>
    <text x="325" y="132">what each removal adds to the ${measureName[lesson.cost]}; the axis is logarithmic</text></svg>`;
}

function filmControls() {
  const last = lesson.removals.length, speeds = [1, 2, 5, 20, 60];
  return `<p><button type="button" data-play="1">${film.playing ? "pause" : film.at === last ? "play again" : "play"}</button>
    <label>removals <input type="range" data-film="1" min="0" max="${last}" value="${film.at}"> <output>${film.at} of ${last}</output></label>
    <label>per second <select data-speed="1">${speeds.map(speed => `<option${speed === film.speed ? " selected" : ""}>${speed}</option>`).join("")}</select></label></p>`;
}

function filmChapter() {
  if (lesson.removals.length === 0) return [];
  const {count, kind} = lesson.input, start = lesson.topology.present.length, skipped = lesson.topology.step;
  const given = `${many(count, kind === "points" ? "point" : "halfspace")}${kind === "points" ? "" : ", and what they hold together"}`;
  const dots = kind === "points" && lesson.input.points ? [{dots: lesson.input.points.map(({at}) => ({at, size: count > 60 ? 2 : 3, mark: "waiting"}))}] : [];
  return [{id: "film", title: "The whole run", show: () => {
    const k = film.at, removal = lesson.removals[k], marks = removal ? {...mark(removal.ring, "ring"), [removal.removed]: "chosen"} : {};
    return {
      say: `Given: ${given}. Wanted: a solid of few halfspaces that holds it all. One halfspace after another goes, always the one that lets the solid grow least. ${start - k} of ${start} are left${
        removal ? `; the next to go is ${tag(removal.removed)}` : ""}.`,
      solid: solidScene(k, marks, dots),
      dual: {items: [dualItem(surfaceAfter(k), marks)], radius: dualReach(), note: "A point for each halfspace, a triangle for each corner of the solid."},
      picture: filmControls() + drawnCurve(),
      more: (removal ? `<p><a href="#removal-${removal.step}">Explain this step</a>: why ${tag(removal.removed)}, and what happens to solid and dual.</p>` : "<p><a href=\"#removal-end\">Why it ends here</a></p>") +
        (skipped ? `<p>The film begins after ${many(skipped, "removal")}.</p>` : ""),
    };
  }}];
}

// --- what a reader does with it --------------------------------------------------------------------

function showFilm(at) {
  const radius = panes.solid.radius;
  film.at = Math.max(0, Math.min(lesson.removals.length, at));
  if (film.at === lesson.removals.length) film.playing = false;
  show();
  panes.solid.zoomFrom(radius);
}
function playFilm() {
  if (film.at === lesson.removals.length) film.at = 0;
  let before = performance.now(), due = 0;
  const frame = now => {
    if (!film.playing || steps[place].id !== "film") return void (film.playing = false);
    due += film.speed * (now - before) / 1000;
    before = now;
    if (due >= 1) showFilm(film.at + Math.floor(due));
    due %= 1;
    requestAnimationFrame(frame);
  };
  requestAnimationFrame(frame);
}
document.addEventListener("input", ({target}) => {
  if (target.dataset.film !== undefined) showFilm(Number(target.value));
  if (target.dataset.speed !== undefined) film.speed = Number(target.value);
});
document.addEventListener("click", ({target}) => {
  if (!target.closest("[data-play]")) return;
  film.playing = !film.playing;
  if (film.playing) playFilm();
  show();
});
// The dot follows a pointer along the curve, which is drawn anew at each step: so the page listens, not the curve.
let isOnCurve = false;
function followCurve({clientX}) {
  const curve = document.getElementById("film-curve");
  if (!curve) return;
  const box = curve.getBoundingClientRect(), x = (clientX - box.left) / box.width * 620;
  film.playing = false;
  showFilm(Math.round((x - kCurve.left) / (kCurve.right - kCurve.left) * (lesson.removals.length - 1)));
}
document.addEventListener("pointerdown", event => {
  isOnCurve = event.target.closest("#film-curve") !== null;
  if (isOnCurve) followCurve(event);
});
document.addEventListener("pointermove", event => { if (isOnCurve) followCurve(event); });
for (const end of ["pointerup", "pointercancel"]) document.addEventListener(end, () => { isOnCurve = false; });
