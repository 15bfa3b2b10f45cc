// SPDX-License-Identifier: MIT
// drop_test.mjs PROGRAM WEB - 2,000 mutated files dropped through the package, as the page does it: read, hull, a few
// halfspaces, a verdict. Each call has an answer or an error in words, the worker is never lost, and the process does
// not keep more memory in the second half than in the first.
import assert from "node:assert/strict";
import {data, packaged, random} from "./support.mjs";

const {default: convexact, ConvexactError} = await packaged("node.js");
const cx = await convexact();
const next = random(560);
const below = n => Math.floor(n * next());

const cube = [..."01234567"].map(k => [k & 1, k >> 1 & 1, k >> 2]);
const written = (await cx.hull(cube, {files: ["cube.stl", "cube.glb"]})).files;
const files = [...["bin", "cube", "needle", "pyramid"].map(name => [`${name}.obj`, data(`../docs/lessons/${name}.obj`)]),
  ...Object.entries(written)];
const text = (await cx.hull(cube, {files: ["cube.off", "cube.ply", "cube.ine", "cube.json"]})).files;
for (const [name, contents] of Object.entries(text)) files.push([name, new TextEncoder().encode(contents)]);

// Some bytes become others, and a piece may be cut out.
function mutated(bytes) {
  let copy = Uint8Array.from(bytes);
  for (let k = 1 + below(4); k > 0; --k) copy[below(copy.length)] = next() < 0.5 ? below(256) : copy[below(copy.length)];
  const from = below(copy.length);
  if (next() < 0.3) copy = Uint8Array.from([...copy.subarray(0, from), ...copy.subarray(from + below(12))]);
  return copy;
}

const found = {answers: 0, errors: 0};
async function tried(job) {
  try {
    const answer = await job;
    ++found.answers;
    return answer;
  } catch (error) {
    assert.ok(error instanceof ConvexactError, String(error));
    assert.ok(!["internal", "stopped"].includes(error.kind), `${error.kind}: ${error.sentence}`);
    ++found.errors;
  }
}

const most = [0, 0], start = performance.now();
for (let k = 0; k < 2000; ++k) {
  const [name, bytes] = files[k % files.length];
  const shape = await tried(cx.read(mutated(bytes), name));
  // Damaged numbers can be as long as the file; their hull would take minutes.
  const isShort = shape && JSON.stringify(shape).length < 5000;
  if (isShort && await tried(cx.hull(shape, {picture: true, name}))) {
    await tried(cx.simplify(shape, {faces: 5, files: [`${name}.obj`]}));
    await tried(cx.verify(shape.points ? {points: shape.points} : cube, shape, {asks: "hull"}));
  }
  if (k % 20 === 0) most[k < 1000 ? 0 : 1] = Math.max(most[k < 1000 ? 0 : 1], process.memoryUsage().rss);
}
const [first, second] = most.map(bytes => bytes >> 20);
assert.ok(found.answers > 800 && found.errors > 800, JSON.stringify(found));
assert.ok(second <= first + 16, `${first} MB in the first 1,000 files, ${second} MB in the second`);
console.log(`2,000 mutated files: ${found.answers} answers, ${found.errors} errors in words; at most ${first} MB in the first half, ` +
  `${second} MB in the second; ${((performance.now() - start) / 1000).toFixed(0)} s`);
