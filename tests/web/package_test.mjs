// SPDX-License-Identifier: MIT
// package_test.mjs PROGRAM WEB - the package as npm installs it from its file: every method, arrays, exact numbers,
// errors, cancelling.
import assert from "node:assert/strict";
import {execFileSync} from "node:child_process";
import {mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {pathToFileURL} from "node:url";
import {data, folder, web} from "./support.mjs";

const place = mkdtempSync(join(tmpdir(), "convexact-"));
process.on("exit", () => rmSync(place, {recursive: true}));
writeFileSync(join(place, "package.json"), '{"private": true}');
const packed = readdirSync(web).find(name => name.endsWith(".tgz"));
execFileSync("npm", ["install", "--offline", "--no-audit", "--no-fund", "--silent", join(web, packed)], {cwd: place});
const installed = join(place, "node_modules", "convexact");
const {default: convexact, ConvexactError, toNumber} = await import(pathToFileURL(join(installed, "node.js")));
const cx = await convexact();

const claims = {
  "toNumber rounds to nearest, ties to even, down to the least double": () => {
    assert.equal(toNumber("1/3"), 1 / 3);
    assert.equal(toNumber("-2/3"), -2 / 3);
    assert.equal(toNumber(-7), -7);
    assert.equal(toNumber("9007199254740993"), 9007199254740992);   // 2^53 + 1
    assert.equal(toNumber("9007199254740995"), 9007199254740996);
    assert.equal(toNumber("18014398509481985/2"), 9007199254740992);
    assert.equal(toNumber(`1/${2n ** 1074n}`), Number.MIN_VALUE);
    assert.equal(toNumber(`1/${2n ** 1075n}`), 0);
    assert.equal(toNumber(`3/${2n ** 1075n}`), 2 * Number.MIN_VALUE);
    assert.equal(toNumber(`${2n ** 1023n}`), 2 ** 1023);
    assert.equal(toNumber(`${2n ** 1024n}`), Infinity);
    assert.equal(toNumber(`${3n * 2n ** 1000n}/${2n ** 1060n}`), 3 * 2 ** -60);
    for (let k = 1; k < 2000; ++k) assert.equal(toNumber(`${k * k + 1}/${7 * k + 3}`), (k * k + 1) / (7 * k + 3));  // correctly rounded by IEEE 754
  },
  "a cube: its counts and measures, from every kind of array": async () => {
    const rows = [..."01234567"].map(k => [k & 1, k >> 1 & 1, k >> 2]);
    for (const points of [rows, Float64Array.from(rows.flat()), Float32Array.from(rows.flat()), {points: rows}]) {
      const hull = await cx.hull(points, {exact_values: true});
      assert.deepEqual([hull.planes.length, hull.vertices.length, hull.edges, hull.volume.exact], [6, 8, 12, "1"]);
      assert.equal(hull.area.value, 6);
      assert.equal(hull.mean_width.value, 1.5);
      assert.ok(hull.points instanceof Float64Array);
      assert.deepEqual([...hull.points].sort(), rows.flat().sort());
    }
    const third = await cx.hull([["1/3", 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], {exact_values: true});
    assert.equal(third.volume.exact, "1/9");                        // 2/3 * 1/2 * 1/3
  },
  "halfspaces in, halfspaces out": async () => {
    const planes = new Float64Array([1, 0, 0, -1, -1, 0, 0, -1, 0, 1, 0, -1, 0, -1, 0, -1, 0, 0, 1, -1, 0, 0, -1, -1, 1, 1, 0, -1.5]);
    assert.equal((await cx.hull({planes})).volume.value, 7.75);     // 8, less a wedge of 1/2 * 1/2 * 1/2 * 2
    const found = await cx.simplify({planes}, {faces: 6});
    assert.equal(found.volume.output.value, 8);
    assert.equal(found.planes.length, 24);
  },
  "a simplification holds every point, and its files are there": async () => {
    const {points, triangles} = await cx.read(data("data/spot.obj"), "spot.obj");
    assert.equal(points.length, 3 * 2930);
    assert.deepEqual([...points.slice(0, 3)], data("data/spot.obj").toString().match(/^v (.*)$/m)[1].split(" ").map(Number));
    assert.ok(triangles.every(t => t.length >= 3));
    const found = await cx.simplify(points, {faces: 18, files: ["a.obj"]});
    assert.equal(found.planes.length, 72);
    assert.ok((await cx.verify(points, {planes: found.planes}, {asks: "enclosure"})).ok);
    const mesh = await cx.read(new TextEncoder().encode(found.files["a.obj"]), "a.obj");
    assert.ok((await cx.verify(points, mesh, {asks: "enclosure"})).ok);
  },
  "the objects of a file are parts of its mesh": async () => {
    // Two cubes side by side; a point that no face uses is of the second, and no part without it holds all.
    const corners = x => [0, 1, 2, 3, 4, 5, 6, 7].map(k => `v ${x + (k & 1)} ${k >> 1 & 1} ${k >> 2}\n`).join("");
    const faces = n => [[1, 3, 4, 2], [5, 6, 8, 7], [1, 2, 6, 5], [3, 7, 8, 4], [1, 5, 7, 3], [2, 4, 8, 6]]
      .map(face => `f ${face.map(k => k + n).join(" ")}\n`).join("");
    const text = `o a\n${corners(0)}${faces(0)}o b\n${corners(1)}v 2.5 0.5 0.5\n${faces(8)}`;
    const mesh = await cx.read(new TextEncoder().encode(text), "two.obj"), [a, b] = mesh.objects;
    assert.deepEqual([mesh.objects.length, a.name, b.name, a.vertices.length, b.vertices.length], [2, "a", "b", 24, 27]);
    assert.deepEqual([Math.max(...a.vertices.filter((_, k) => k % 3 === 0)), Math.max(...b.faces.flat())], [1, 7]);
    const judged = await cx.verify(mesh, {parts: mesh.objects});
    assert.equal(judged.claims.find(claim => claim.code === "covers-surface").status, "holds");
    const alone = await cx.verify(mesh, {parts: [a]});
    assert.equal(alone.claims.find(claim => claim.code === "covers-points").status, "violated");
    const one = await cx.read(new TextEncoder().encode(corners(0) + faces(0)), "one.obj");
    assert.deepEqual([one.objects.length, one.objects[0].vertices.length], [1, 24]);
    assert.ok((await cx.verify(one, {parts: one.objects})).ok);
  },
  "STL and GLB are bytes, and hold every point": async () => {
    const points = Float64Array.from({length: 90}, (_, k) => Math.sin(k * k));
    const {files} = await cx.simplify(points, {faces: 9, files: ["a.stl", "a.glb"]});
    assert.equal(files["a.stl"].length, 84 + 50 * new DataView(files["a.stl"].buffer).getUint32(80, true));
    for (const [name, bytes] of Object.entries(files)) {
      assert.ok(bytes instanceof Uint8Array);
      assert.ok((await cx.verify(points, await cx.read(bytes, name), {asks: "enclosure"})).ok, name);
    }
    await assert.rejects(cx.hull(points, {files: ["a.obj", "a.glb"]}), /precision 32 with a.glb/);
  },
  "a cut that is kept, its trace, and a solid inside": async () => {
    // A cube of edge 2 less the corner beyond x + y + z = 2, of volume 1/6.
    const planes = [[1, 0, 0, -1], [-1, 0, 0, -1], [0, 1, 0, -1], [0, -1, 0, -1], [0, 0, 1, -1], [0, 0, -1, -1], [1, 1, 1, -2]];
    const found = await cx.simplify({planes}, {faces: 6, trace: true, exact_values: true});
    assert.equal(found.trace.steps[0].cost.exact, "1/6");
    const kept = await cx.simplify({planes}, {faces: 6, keep: ["plane:1,1,1,-2"], exact_values: true});
    assert.equal(kept.volume.output.exact, "12");                   // 47/6, and a cap of 25/6
    const cube = [..."01234567"].map(k => [k & 1, k >> 1 & 1, k >> 2]);
    const inner = await cx.simplify(cube, {inner: true, vertices: 7, exact_values: true});
    assert.equal(inner.volume.output.exact, "5/6");
    assert.equal(inner.output.points.length, 7);
  },
  "a lesson is a page": async () => {
    const {page, left_out} = await cx.teach([..."01234567"].map(k => [k & 1, k >> 1 & 1, k >> 2]), {faces: 6, name: "a <cube>"});
    assert.match(page, /^<!DOCTYPE html>[^]*<title>a &lt;cube&gt;: polar duality/);
    assert.deepEqual(left_out, []);
  },
  "a missing corner of a cube has a witness": async () => {
    const cube = Float64Array.from([..."01234567"].flatMap(k => [k & 1, k >> 1 & 1, k >> 2]));
    const verdict = await cx.verify(cube, cube.slice(0, 21), {asks: "hull"});
    assert.equal(verdict.ok, false);
    const claim = verdict.claims.find(claim => claim.code === "contains-input");
    assert.equal(claim.witness.input_point, 7);
    assert.equal(claim.witness.distance.squared, "1/3");
    assert.equal(verdict.sentence, claim.sentence);
    assert.ok((await cx.verify(cube, cube, {asks: "hull"})).ok);
  },
  "an L in two parts": async () => {
    const side = [[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]];
    const mesh = {points: [0, 1].flatMap(z => side.map(([x, y]) => [x, y, z])),
      triangles: [[5, 4, 3, 2, 1, 0], [6, 7, 8, 9, 10, 11], ...side.map((_, k) => [k, (k + 1) % 6, 6 + (k + 1) % 6, 6 + k])]};
    const found = await cx.decompose(mesh, {distance: "1%", picture: true});
    assert.equal(found.parts.length, 2);
    assert.ok(found.picture.startsWith("<!DOCTYPE html>"));
    assert.ok((await cx.verify(mesh, found, {distance: "1%"})).ok);
  },
  "errors have a kind, a line and a sentence": async () => {
    const fails = (asked, kind, line) => assert.rejects(asked, error => {
      assert.ok(error instanceof ConvexactError);
      assert.equal(error.kind, kind, error.sentence);
      assert.equal(error.line, line);
      assert.ok(error.sentence.length > 10 && error.message === error.sentence);
      return true;
    });
    await fails(cx.read(new TextEncoder().encode("v 0 0 0\nv 1 2 x\n"), "a.obj"), "malformed", 2);
    await fails(cx.hull(new Float64Array([0, 0, NaN])), "not-finite");
    await fails(cx.hull(new Float64Array([0, 0, Infinity])), "not-finite");
    await fails(cx.hull(new Float64Array([0, 0, 1, 2])), "invalid-argument");
    await fails(cx.hull("a"), "invalid-argument");
    await fails(cx.hull([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]), "no-interior");
    await fails(cx.simplify([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], {faces: 3}), "invalid-argument");
    await fails(cx.hull([[0, 0, 0]], {fases: 3}), "malformed");
    await fails(cx.hull([[0, 0, 0]], {fases: () => 3}), "invalid-argument");
  },
  "cancelling ends what runs, and the next job gets a new worker": async () => {
    const points = Float64Array.from({length: 90000}, (_, k) => Math.sin(k * k + k / 3));
    const start = performance.now();
    const asked = [cx.simplify(points, {faces: 4, engine: "exact"}), cx.hull(points)];
    setTimeout(() => cx.cancel(), 300);
    for (const {reason} of await Promise.allSettled(asked)) assert.equal(reason.kind, "stopped");
    assert.ok(performance.now() - start < 5000);
    assert.equal((await cx.hull([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])).planes.length, 4);
  },
  "conform: a hull that rounds loses points, and one that is asked of convexact does not": async () => {
    const only = ["random-ball", "tetrahedron"];
    const right = await cx.conform(async points => ({planes: (await cx.hull(points)).planes}), {only});
    assert.ok(right.ok && right.passed >= 3, JSON.stringify(right.failures.map(f => f.sentence)));
    const wrong = await cx.conform(points => points.map(x => Math.round(8 * x) / 8), {only: ["random-ball"]});
    assert.ok(!wrong.ok && wrong.failures[0].sentence.length > 10);
    const thrown = await cx.conform(() => { throw new Error("none"); }, {only, level: 1});
    assert.ok(thrown.failures.every(failure => failure.sentence === "threw Error: none"));
  },
  "the example for Node ends by itself, and says what the cube is": () => {
    const printed = execFileSync("node", [join(installed, "examples", "node.mjs")], {cwd: place, encoding: "utf8", timeout: 60000});
    assert.match(printed, /^6 facets, volume 1\n8 halfspaces/);
    assert.match(printed, /\nfalse .*\nno-interior /);
  },
  "no folder of the machine that compiled it is in the module": () => {
    assert.ok(!readFileSync(join(installed, "convexact.wasm"), "latin1").includes(join(folder, "..")));
  },
  "what is linked in is named": () => {
    assert.match(readFileSync(join(installed, "NOTICE.md"), "utf8"), /gmp_[0-9.]+.*\n- `mpfr4_/);
    assert.match(readFileSync(join(installed, "licenses", "LGPL-3.0.txt"), "utf8"), /GNU LESSER GENERAL PUBLIC LICENSE/);
  },
};

for (const [name, claim] of Object.entries(claims)) {
  await claim();
  console.log(`ok: ${name}`);
}
