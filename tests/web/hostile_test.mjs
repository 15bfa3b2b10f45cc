// SPDX-License-Identifier: MIT
// hostile_test.mjs PROGRAM WEB - 10,000 damaged files and requests: each has an answer, no trap ends the module, and the
// same ones once more do not make it keep more memory.
import assert from "node:assert/strict";
import {readdirSync} from "node:fs";
import {data, folder, random, startedModule} from "./support.mjs";

const module = await startedModule();
let next;
const below = n => Math.floor(n * next());

const files = [
  ...["bin", "cube", "needle", "pyramid"].map(name => [`${name}.obj`, data(`../docs/lessons/${name}.obj`)]),
  ...readdirSync(`${folder}data/cases`).slice(0, 12).filter(name => /\.(obj|off|ply|stl|json|ine|xyz)$/.test(name)).map(name => [name, data(`data/cases/${name}`)]),
  ["cube.off", Buffer.from("OFF\n8 6 12\n" + [..."01234567"].map(k => `${k & 1} ${k >> 1 & 1} ${k >> 2}\n`).join("") +
    "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n")],
  ["cube.ine", Buffer.from("H-representation\nbegin\n6 4 rational\n1 1 0 0\n1 0 1 0\n1 0 0 1\n1/2 -1 0 0\n1 0 -1 0\n1 0 0 -1\nend\n")],
  ["shape.stl", Buffer.concat([Buffer.alloc(80), Buffer.from([2, 0, 0, 0]), Buffer.alloc(100, 63)])],
  ["shape.glb", Buffer.from('glTF\x02\0\0\0\x40\0\0\0\x2c\0\0\0JSON{"asset":{"version":"2.0"},"meshes":[{}]}  ', "latin1")],
  ["shape.dae", Buffer.from('<COLLADA><library_geometries><geometry id="a"><mesh/></geometry></library_geometries></COLLADA>')],
];

// Bytes replaced, left out, repeated or cut off.
function damaged(bytes) {
  const copy = Buffer.from(bytes);
  for (let k = below(3); k > 0; --k) copy[below(copy.length)] = next() < 0.5 ? below(256) : copy[below(copy.length)];
  const from = below(copy.length), length = below(Math.min(40, copy.length - from));
  const kind = below(4);
  if (kind === 0) return copy.subarray(0, from);
  if (kind === 1) return Buffer.concat([copy.subarray(0, from), copy.subarray(from + length)]);
  if (kind === 2) return Buffer.concat([copy.subarray(0, from + length), copy.subarray(from)]);
  return copy;
}

const cube = [..."01234567"].map(k => [k & 1, k >> 1 & 1, k >> 2]);
const faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
const requests = [
  ["hull", {points: cube, digits: 12, measures: ["volume"], files: ["a.obj", "a.ine"]}],
  ["simplify", {points: [...cube, [3, 0.5, 0.25]], faces: 5, cost: "area", files: ["a.proof"], picture: true}],
  ["verify", {points: cube, candidate: {vertices: cube, faces}, asks: "hull", tolerance: "1e-9"}],
  ["verify", {points: cube, candidate: {planes: [[1, 0, 0, -1], ["-1/3", 0, 0, 0], [0, 1, 0, -1], [0, -1, 0, 0], [0, 0, 1, -1], [0, 0, -1, 0]]}}],
  ["decompose", {points: cube, triangles: faces, distance: "3%", tree: true}],
].map(([kind, request]) => [kind, Buffer.from(JSON.stringify(request))]);

const answers = {good: 0, error: 0};
function note(answer) {
  const {error} = JSON.parse(answer);
  if (error) {
    assert.equal(typeof error.message, "string");
    assert.notEqual(error.code, "internal", error.message);
  }
  ++answers[error ? "error" : "good"];
  return error === undefined;
}

function ask(round) {
  next = random(2604 + round);
  for (let k = 0; k < 1250; ++k) {
    const [name, bytes] = files[below(files.length)];
    const text = module.read(name, damaged(bytes));
    // What can be read goes on to the hull, unless damage has made a shape of it that takes minutes.
    if (note(text) && text.length < 20000) note(module.answer("hull", text.replace(/"notes":\[.*\]/s, '"name":"damaged"')));
    const [kind, line] = requests[below(requests.length)];
    note(module.answer(kind, damaged(line).toString("latin1").replaceAll("\n", " ")));
  }
}

for (let round = 0; round < 4; ++round) ask(round);
assert.ok(answers.good > 1000 && answers.error > 1000, JSON.stringify(answers));
const first = {...answers}, most = module.memory();
for (let round = 0; round < 4; ++round) ask(round);
assert.deepEqual(answers, {good: 2 * first.good, error: 2 * first.error});
assert.ok(module.memory() <= most, `${module.memory()} bytes in the end, after ${most}`);
console.log(`10,000 damaged inputs, twice: ${first.good} answers, ${first.error} errors in words, ${most >> 20} MB`);
