// SPDX-License-Identifier: MIT
// node examples/node.mjs: a hull, few halfspaces that hold everything, a verdict, parts.
import convexact from "convexact";

const cx = await convexact();
const cube = new Float64Array([0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1]);

const hull = await cx.hull(cube);
console.log(`${hull.planes.length} facets, volume ${hull.volume.decimal}`);

const points = Float64Array.from({length: 300}, (_, k) => Math.sin(k * k));
const small = await cx.simplify(points, {faces: 8});
console.log(`8 halfspaces, volume times ${small.volume.ratio}: ${small.planes.slice(0, 4)} ...`);

const verdict = await cx.verify(cube, cube.slice(3), {asks: "hull"});
console.log(verdict.ok, verdict.sentence);

try {
  await cx.hull([[0, 0, 0], [1, 0, 0], [0, 1, 0]]);
} catch (error) {
  console.log(error.kind, error.sentence);
}
