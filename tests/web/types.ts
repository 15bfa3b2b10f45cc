// SPDX-License-Identifier: MIT
// types.ts - what the manual shows, and what the compiler is to refuse; it is not run.
import convexact, {ConvexactError, toNumber, type Convexact, type Enclosure, type Mesh} from "convexact";

const cx: Convexact = await convexact();
const points = new Float64Array([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]);
const mesh: Mesh = {points: [["1/3", 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], triangles: [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]};

const hull = await cx.hull(points, {exact_values: true, measures: ["volume"]});
const volume: number = toNumber(hull.volume?.exact ?? "0");
const small: Enclosure = await cx.simplify({planes: [[1, 0, 0, -1]]}, {faces: 6, keep: ["id:0"], trace: true, files: ["a.glb"]});
const planes: Float64Array | undefined = small.planes;
const file: string | Uint8Array | undefined = small.files?.["a.glb"];
const inner = await cx.simplify(mesh, {inner: true, max_loss: "5%"});
const kept: number[] = inner.output.points;
const verdict = await cx.verify(points, {vertices: points}, {asks: "hull"});
const page: string = (await cx.teach(points, {faces: 4})).page + (await cx.teach(mesh, {plane: true})).page;
const parts = await cx.decompose(mesh, {distance: "3%"});
await cx.verify(mesh, parts, {distance: "3%"});
const conformance = await cx.conform(given => given.slice(3), {asks: "hull", level: 1});
const failed: string[] = conformance.failures.map(failure => failure.sentence);
export const all = [volume, planes, file, kept, verdict.ok, page, failed];

try {
  await cx.read(new Uint8Array(0), "a.obj");
} catch (error) {
  if (error instanceof ConvexactError && error.line !== undefined) error.line.toFixed();
}
// @ts-expect-error: there is no such option
await cx.hull(points, {fases: 3});
// @ts-expect-error: halfspaces have no vertices of the input
await cx.simplify({planes: [[1, 0, 0, -1]]}, {inner: true, vertices: 7});
// @ts-expect-error: a lesson in the plane removes nothing
await cx.teach(points, {plane: true, faces: 4});
// @ts-expect-error: no word of the list
await cx.simplify(points, {faces: 6, cost: "width"});
