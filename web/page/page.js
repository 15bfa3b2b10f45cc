// SPDX-License-Identifier: MIT
// page.js - the page: what is dropped goes to the worker, and what comes back is shown. Everything it needs is in the
// page itself: from disk, a page may load neither modules nor workers.
const $ = id => document.getElementById(id);

// --- the worker

function startWorker(take, fail) {
  const url = URL.createObjectURL(new Blob([$("worker").textContent], {type: "text/javascript"}));
  const worker = new Worker(url);
  worker.onmessage = event => take(event.data);
  worker.onerror = event => fail(event.message ?? "the worker cannot be started");
  return {send: message => worker.postMessage(message), end: () => { worker.terminate(); URL.revokeObjectURL(url); }};
}

async function load() {
  const packed = Uint8Array.from(atob($("wasm").textContent), letter => letter.charCodeAt(0));
  const unpacked = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Uint8Array(await new Response(unpacked).arrayBuffer());
}

const started = Convexact.start(startWorker, load);

// --- what is shown

function say(sentence, detail = "", kind = "") {
  $("first").textContent = sentence;
  $("first").className = kind;
  $("detail").textContent = detail;
}

function showNumbers(rows) {
  $("numbers").replaceChildren(...rows.filter(row => row[1] !== undefined).map(([name, value]) => {
    const row = document.createElement("tr"), head = document.createElement("th"), cell = document.createElement("td");
    head.textContent = name;
    head.scope = "row";
    cell.textContent = value;
    row.append(head, cell);
    return row;
  }));
}

function download(name, contents) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([contents]));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

// A button for each file: its contents, or what makes them when they are asked for, from a worker.
function showDownloads(files) {
  const buttons = Object.entries(files).map(([name, contents]) => {
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = name;
    button.onclick = () => typeof contents !== "function" ? download(name, contents)
      : run(`Making ${name}`, async cx => download(name, await contents(cx)));
    return button;
  });
  $("downloads").hidden = buttons.length === 0;
  $("downloads").querySelector("p").replaceChildren(...buttons);
}

const show = page => { $("picture").srcdoc = page; };

// A lesson writes its step into its address, so it needs one of its own. @param step  Where it opens, such as "#polar".
let lessonAt;
function showLesson(page, step = "") {
  URL.revokeObjectURL(lessonAt);
  lessonAt = URL.createObjectURL(new Blob([page], {type: "text/html"}));
  $("picture").removeAttribute("srcdoc");
  $("picture").src = lessonAt + step;
}

// --- one job at a time

let running = 0;

// Runs a job, shows that it runs, and what went wrong; whether it ended well. A job that is started while another one runs ends that one.
async function run(doing, job) {
  const cx = await started;
  if (running > 0) cx.cancel();
  ++running;
  const start = performance.now();
  const tell = () => { $("doing").textContent = `${doing}, ${Math.round((performance.now() - start) / 1000)} s`; };
  tell();
  const clock = setInterval(tell, 500);
  $("work").hidden = false;
  try {
    await job(cx);
    return true;
  } catch (error) {
    if (running === 1) say(error.sentence ?? String(error), error.kind === "stopped" ? "Nothing else was changed." : "", "bad");
  } finally {
    clearInterval(clock);
    if (--running === 0) $("work").hidden = true;
  }
}

$("cancel").onclick = async () => (await started).cancel();

// --- the shape and what is asked of it

let input, candidate;
let isChosen = false;  // what is asked of the candidate, by hand
// GLB is binary32, which other files are not: a run of its own, for those who want it.
const glb = (name, ask) => ({[name]: async cx => (await ask(cx, {files: [name]})).files[name]});
const stem = () => input.name.replace(/\.[^.]*$/, "");
const drawn = () => ({picture: true, name: input.name});

function take(name, shape) {
  takeInput(name, shape);
  $("candidate").value = "";
  return run(`The hull of ${name}`, showHull);
}

function takeInput(name, {objects, ...shape}) {
  input = {name, shape};
  candidate = undefined;
  isChosen = false;
  offerParts(false);
}

async function showHull(cx) {
  const {name, shape} = input, files = [`${stem()}-hull.obj`, `${stem()}-hull.json`];
  const hull = await cx.hull(shape, {...drawn(), files});
  const facets = hull.planes.length;
  say(`${name}: a hull of ${facets} facets and ${hull.vertices.length} vertices`,
    [`Volume ${hull.volume.decimal}; every digit is certain.`, ...shape.notes ?? []].join(" "));
  showNumbers([["points", hull.input.points || undefined], ["hull vertices", hull.vertices.length], ["hull facets", facets],
    ["edges", hull.edges], ["volume", hull.volume.decimal], ["area", hull.area.decimal], ["mean width", hull.mean_width.decimal],
    ["diameter of the box", hull.diameter.decimal]]);
  showDownloads({...hull.files, ...glb(`${stem()}-hull.glb`, (cx, more) => cx.hull(shape, {measures: [], ...more}))});
  show(input.picture = hull.picture);
  $("faces").max = facets;
  $("faces").value = Math.min(18, facets);
  $("count").textContent = $("faces").value;
  for (const form of ["enclose", "judge", "teach"]) $(form).hidden = false;
  $("decompose").hidden = !(input.shape.triangles?.length > 0);
  $("candidate").disabled = false;
  document.querySelector("[data-example=wrong]").hidden = input.name !== "ball";
  $("judge").querySelector("button").disabled = true;
}

async function enclose(cx) {
  const name = `${stem()}-${$("faces").value}`;
  const {shape} = input, asked = {faces: Number($("faces").value), cost: $("cost").value};
  const found = await cx.simplify(shape, {...drawn(), ...asked,
    files: [`${name}.obj`, `${name}.json`, ...(asked.cost === "mean-width" ? [] : [`${name}.proof`])]});
  const percent = growth => `${(100 * (growth.ratio - 1)).toPrecision(4)}%`;
  say(`${found.output.halfspaces} halfspaces hold every point; the volume grows by ${percent(found.volume)}`,
    found.output.reached ? "Proven on the numbers that are saved." : "No further halfspace can go: the solid would be unbounded.");
  showNumbers([["halfspaces", `${found.output.halfspaces} of ${found.input.halfspaces}`],
    ["volume of the hull", found.volume.input.decimal], ["volume of the solid", found.volume.output.decimal],
    ["area grows by", found.area && percent(found.area)], ["mean width grows by", found.mean_width && percent(found.mean_width)]]);
  showDownloads({...found.files, ...glb(`${name}.glb`, (cx, more) => cx.simplify(shape, {...asked, ...more}))});
  show(found.picture);
}

// Several objects are taken for parts of a mesh with faces, unless something else was chosen.
function takeCandidate(name, shape) {
  candidate = {name, shape};
  offerParts(shape.objects?.length > 1 && input.shape.triangles?.length > 0);
  $("judge").querySelector("button").disabled = false;
}

function offerParts(areParts) {
  const option = $("asks").querySelector("[value=parts]"), wereParts = $("asks").value === "parts";
  option.hidden = option.disabled = !areParts;
  if (areParts && !isChosen) $("asks").value = "parts";
  if (!areParts && wereParts) $("asks").value = "hull";
}

function ask(cx) {
  const {points, triangles, planes, objects} = candidate.shape, asks = $("asks").value;
  if (asks === "parts") return cx.verify(input.shape, {parts: objects});
  return cx.verify(input.shape, planes ? {planes} : {vertices: points, faces: triangles}, {...drawn(), asks, tightness: true});
}

async function judge(cx) {
  const verdict = await ask(cx);
  const is = $("asks").selectedOptions[0].textContent;
  say(`${candidate.name} is ${verdict.ok ? "" : "not "}${is} of ${input.name}: ${verdict.sentence}`, "", verdict.ok ? "good" : "bad");
  showNumbers(verdict.claims.map(claim => [claim.code, `${claim.status}${claim.sentence ? `: ${claim.sentence}` : ""}`]));
  showDownloads({});
  show(verdict.picture ?? input.picture ?? "");  // of parts there is none
}

async function decompose(cx) {
  const found = await cx.decompose(input.shape, {...drawn(), distance: $("distance").value});
  say(`${found.parts.length} convex parts hold ${input.name}`, `No point of them is farther from it than ${$("distance").value}.`);
  showNumbers([["parts", found.parts.length]]);
  showDownloads({[`${stem()}-parts.obj`]: objOf(found.parts), [`${stem()}-parts.json`]: JSON.stringify({...found, picture: undefined})});
  show(found.picture);
}

function sayLesson(name, lesson, file) {
  say(`A lesson on ${name}, step by step`, ["The keys left and right go one step, once the lesson is clicked on. Saved, it opens from disk.",
    ...lesson.left_out.map(({chapter, why}) => `Without the chapter ${chapter}: ${why}.`)].join(" "));
  showNumbers([]);
  showDownloads({[file]: lesson.page});
}

async function teach(cx) {
  const lesson = await cx.teach(input.shape, {name: input.name, faces: Number($("left").value)});
  sayLesson(input.name, lesson, `${stem()}-lesson.html`);
  showLesson(lesson.page);
}

// The ready lessons whose inputs the page has, with their options. Lessons name each other as files.
const readyLessons = {polygon: {plane: true}, bin: {plane: true}, cube: {}, pyramid: {}, needle: {precision: 64}};

function openLesson(name, step) {
  return run(`Writing the lesson ${name}`, async cx => {
    const file = `${name}.obj`, {notes, ...shape} = await cx.read(new TextEncoder().encode(JSON.parse($("lessons").textContent)[name]), file);
    const lesson = await cx.teach(shape, {name: file, ...readyLessons[name]});
    sayLesson(file, lesson, `${name}.html`);
    showLesson(lesson.page, step);
  });
}

addEventListener("message", event => {
  const [, name, step] = event.source === $("picture").contentWindow && /^(\w+)\.html(#[\w-]+)?$/.exec(event.data?.lesson) || [];
  if (Object.hasOwn(readyLessons, name)) openLesson(name, step);
});

// JavaScript spells a double so that reading it gives the double again.
function objOf(parts) {
  let text = "", first = 1;
  for (const {name, vertices, faces} of parts) {
    text += `o ${name}\n${vertices.map(v => `v ${v.join(" ")}\n`).join("")}`;
    text += faces.map(face => `f ${face.map(corner => corner + first).join(" ")}\n`).join("");
    first += vertices.length;
  }
  return text;
}

// --- files and examples

const read = async (cx, file) => cx.read(new Uint8Array(await file.arrayBuffer()), file.name);

function takeFile(file, asCandidate) {
  if (!file) return;
  return run(`Reading ${file.name}`, async cx => {
    const shape = await read(cx, file);
    if (!asCandidate) {
      takeInput(file.name, shape);
      return showHull(cx);
    }
    takeCandidate(file.name, shape);
    return judge(cx);
  });
}

// Points of a spiral on a ball, the same everywhere: multiples of 1/1024.
function ball() {
  const points = [];
  for (let k = 0; k < 200; ++k) {
    const z = 1 - (2 * k + 1) / 200, r = Math.sqrt(1 - z * z), angle = 2.399963 * k;
    points.push(...[r * Math.cos(angle), r * Math.sin(angle), z].map(x => Math.round(1024 * x) / 1024));
  }
  return {points: Float64Array.from(points)};
}

// Three steps: the polygon of their side, and the same one unit farther.
function stairs() {
  const side = [[0, 0], [3, 0], [3, 1], [2, 1], [2, 2], [1, 2], [1, 3], [0, 3]], n = side.length;
  const points = [0, 2].flatMap(z => side.flatMap(([x, y]) => [x, y, z]));
  const front = side.map((_, k) => n + k), back = side.map((_, k) => n - 1 - k);
  const walls = side.map((_, k) => [k, (k + 1) % n, n + (k + 1) % n, n + k]);
  return {points: Float64Array.from(points), triangles: [front, back, ...walls]};
}

const examples = {
  ball: () => take("ball", ball()),
  stairs: () => take("stairs", stairs()),
  wrong: () => run("Judging", cx => {
    takeCandidate("a hull that misses a point", {points: ball().points.slice(3)});
    return judge(cx);
  }),
};

for (const button of document.querySelectorAll("[data-example]")) button.onclick = () => examples[button.dataset.example]();
for (const button of document.querySelectorAll("[data-lesson]")) button.onclick = () => openLesson(button.dataset.lesson);
$("shape").onchange = () => takeFile($("shape").files[0], false);
$("candidate").onchange = () => takeFile($("candidate").files[0], true);
$("asks").onchange = () => { isChosen = true; };
$("faces").oninput = () => { $("count").textContent = $("faces").value; };
$("faces").onchange = () => run("Removing halfspaces", enclose);
for (const [form, doing, job] of [["enclose", "Removing halfspaces", enclose], ["judge", "Judging", judge], ["decompose", "Cutting", decompose],
  ["teach", "Writing the lesson", teach]]) {
  $(form).onsubmit = event => { event.preventDefault(); run(doing, job); };
}

// Two files at once are a shape and an output; one more file after a shape is an output.
addEventListener("dragover", event => { event.preventDefault(); document.body.classList.add("over"); });
addEventListener("dragleave", event => { if (!event.relatedTarget) document.body.classList.remove("over"); });
addEventListener("drop", async event => {
  event.preventDefault();
  document.body.classList.remove("over");
  const [first, second] = event.dataTransfer.files;
  if (input && !second) return takeFile(first, event.target.closest?.(".drop")?.contains($("shape")) !== true);
  if (await takeFile(first, false)) await takeFile(second, true);
});
