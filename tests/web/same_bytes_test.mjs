// SPDX-License-Identifier: MIT
// same_bytes_test.mjs PROGRAM WEB - every answer of the module is that of the native program, byte for byte: on the
// shipped meshes for every kind of request, and on the conformance vectors; and its lessons are those of teach.
import assert from "node:assert/strict";
import {execFileSync, spawnSync} from "node:child_process";
import {mkdtempSync, readdirSync, readFileSync, rmSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {data, folder, program, startedModule, vectors} from "./support.mjs";

const module = await startedModule();

// A shape as a request spells it.
const shape = name => JSON.parse(module.read(name, data(`data/${name}`)));
const requests = {hull: [], simplify: [], verify: [], decompose: []};
const ask = (kind, request) => requests[kind].push(JSON.stringify({id: requests[kind].length, ...request}));

for (const name of ["bunny.obj", "spot.obj", "teapot.obj"]) {
  const {points, triangles} = shape(name);
  ask("hull", {points, triangles, name, picture: true, files: ["a.obj", "a.ply", "a.off", "a.json", "a.ine", "a.txt"], exact_values: true});
  ask("hull", {points, measures: ["inertia", "volume"], digits: 60, precision: 32, files: ["a.obj", "a.json"]});
  ask("simplify", {points, triangles, name, faces: 18, picture: true, files: ["a.obj", "a.json"]});
  const enclosure = JSON.parse(answered("simplify", JSON.stringify({points, faces: 18}))).output.planes;
  for (const asks of ["enclosure", "hull", "inner"]) ask("verify", {points, triangles, candidate: {planes: enclosure}, asks, tightness: true});
  ask("verify", {points, triangles, name, picture: true, candidate: {vertices: points.slice(9), faces: triangles.filter(t => Math.min(...t) >= 9).map(t => t.map(k => k - 9))}});
}
const spot = shape("spot.obj");
for (const kind of ["hull", "simplify"]) ask(kind, {points: spot.points, files: ["a.stl", "a.glb"], faces: kind === "hull" ? undefined : 12});
ask("simplify", {points: spot.points, files: ["a.stl", "a.obj"], precision: 32, faces: 12, keep: ["normal:0,-1,0", "id:3"], trace: true});
ask("simplify", {points: spot.points, triangles: spot.triangles, inner: true, vertices: 32, trace: true, picture: true, files: ["a.obj", "a.ine"]});
ask("simplify", {points: spot.points, inner: true, max_loss: "5%", engine: "exact", verify: "full", exact_values: true});
// By area and by mean width, and with everything proven twice: few steps, as each takes long.
for (const cost of ["area", "mean-width"]) ask("simplify", {points: shape("spot.obj").points, faces: 580, cost});
ask("simplify", {points: shape("spot.obj").points, faces: 585, engine: "exact"});
ask("simplify", {points: shape("spot.obj").points, faces: 580, verify: "full", exact_values: true, files: ["a.proof"]});
ask("simplify", {points: shape("spot.obj").points, faces: 18, engine: "float"});
ask("simplify", {points: shape("spot.obj").points, faces: 18, search: "local", moves: 20});
ask("decompose", {...spot, notes: undefined, distance: "3%", tree: true});
ask("decompose", {...spot, notes: undefined, distance: "10%", jobs: 4});
// Distances that only volumes or clear cells decide, and faces of rounded corners.
for (const [name, ...distances] of [["bin", 0, "0.3%"], ["house", 0, "0.3%"], ["tube", "3%"]]) {
  for (const distance of distances) ask("decompose", {...shape(`cases/${name}.obj`), notes: undefined, method: "cut", distance, tree: true});
}
ask("decompose", {...shape("teapot.obj"), notes: undefined, method: "hacd", max_parts: 20});
ask("decompose", {...shape("teapot.obj"), notes: undefined, method: "acd", picture: true, name: "a teapot"});

for (const file of readdirSync(`${folder}vectors`).filter(name => name.endsWith(".json"))) {
  for (const {input, question} of vectors(file.replace(".json", ""))) {
    const given = input.points ? {points: input.points} : input.halfspaces ? {planes: input.halfspaces} : undefined;
    if (!given) continue;
    if (question.ask === "verify") {
      const {points: vertices, faces, halfspaces: planes, text} = question.candidate;
      if (text === undefined) ask("verify", {...given, candidate: planes ? {planes} : {vertices, faces}, inner: question.inner});
    } else {
      ask("hull", given);
      const isSmall = (input.points ?? input.halfspaces).length <= 12;
      ask("simplify", {...given, faces: question.faces ?? 8, cost: isSmall ? ["volume", "area", "mean-width"][requests.hull.length % 3] : "volume"});
    }
  }
}
// Faults, which have answers, too.
for (const line of ["", "{", "[]", '{"points":[]}', '{"points":[[0,0,0],[1,0,0],[0,1,0]]}', '{"points":[["NaN",0,0]]}', '{"points":[[1e999,0,0]]}',
  '{"planes":[[1,0,0,-1]]}', '{"points":[[0,0,0]],"faces":3}', '{"points":[[0,0,0]],"files":["a.stl"]}', '{"id":1.50,"frob":1}']) {
  for (const kind in requests) if (line.trim() !== "") requests[kind].push(line);
}

function answered(kind, lines) {
  const ran = spawnSync(program, [kind, "--stdio"], {input: `${lines}\n`, encoding: "utf8", maxBuffer: 1 << 30});
  assert.equal(ran.status, 0, ran.stderr);
  return ran.stdout;
}

let different = 0;
for (const [kind, lines] of Object.entries(requests)) {
  const begin = performance.now();
  const native = answered(kind, lines.join("\n")).split("\n");
  const start = performance.now();
  lines.forEach((line, k) => {
    const answer = module.answer(kind, line), wanted = native[k];
    if (answer === wanted) return;
    let at = 0;
    while (answer[at] === wanted[at]) ++at;
    ++different;
    console.log(`${kind} ${line.slice(0, 150)}: from byte ${at}\nmodule: ${answer.slice(at - 60, at + 100)}\nnative: ${wanted.slice(at - 60, at + 100)}`);
  });
  assert.equal(native.length, lines.length + 1);
  const seconds = (from, to) => `${((to - from) / 1000).toFixed(1)} s`;
  console.log(`${kind}: ${lines.length} answers; ${seconds(start, performance.now())}, native ${seconds(begin, start)}; ${module.memory() >> 20} MB`);
}
// The pages of lessons, which no request of the program asks for.
const place = mkdtempSync(join(tmpdir(), "convexact-"));
process.on("exit", () => rmSync(place, {recursive: true}));
for (const [name, options, ...words] of [["cube", {}], ["pyramid", {}], ["needle", {precision: 64}, "--precision", "64"],
  ["polygon", {plane: true}, "--plane"], ["bin", {plane: true}, "--plane"]]) {
  const file = `${folder}../docs/lessons/${name}.obj`, page = join(place, "lesson.html");
  execFileSync(program, ["teach", file, ...words, "-o", page]);
  const request = {...JSON.parse(module.read(`${name}.obj`, readFileSync(file))), notes: undefined, name: `${name}.obj`, ...options};
  assert.equal(JSON.parse(module.answer("teach", JSON.stringify(request))).page, readFileSync(page, "utf8"), name);
}
assert.equal(different, 0);
console.log("all are the native program's, byte for byte");
