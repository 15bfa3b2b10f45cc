// SPDX-License-Identifier: MIT
// peers_test.mjs PROGRAM WEB - hulls of three.js and quickhull3d over the vectors, judged exactly; skipped if npm cannot
// bring them.
import assert from "node:assert/strict";
import {spawnSync} from "node:child_process";
import {existsSync, mkdirSync, writeFileSync} from "node:fs";
import {register} from "node:module";
import {join} from "node:path";
import {pathToFileURL} from "node:url";
import {packaged, skip, web} from "./support.mjs";

const place = join(web, "peers");
mkdirSync(place, {recursive: true});
writeFileSync(join(place, "package.json"), JSON.stringify({private: true, dependencies: {quickhull3d: "3.1.2", three: "0.187.0"}}));
if (!existsSync(join(place, "node_modules", "three"))) {
  const ran = spawnSync("npm", ["install", "--ignore-scripts", "--no-audit", "--no-fund", "--loglevel=error"], {cwd: place, timeout: 120000});
  if (ran.status !== 0) skip("npm cannot bring three and quickhull3d");
}
// quickhull3d leaves ".js" out of its imports, as bundlers allow.
const resolving = `export async function resolve(name, context, next) {
  try { return await next(name, context); } catch (error) { return next(name + ".js", context); }
}`;
register(`data:text/javascript,${encodeURIComponent(resolving)}`);
const from = path => import(pathToFileURL(join(place, "node_modules", path)));
const {default: convexact} = await packaged("node.js");
const cx = await convexact();

const {ConvexHull} = await from("three/examples/jsm/math/ConvexHull.js");
const {Vector3} = await from("three/build/three.module.js");
const {default: quickHull} = await from("quickhull3d/dist/index.js");

const peers = {
  three: points => {
    const hull = new ConvexHull().setFromPoints(Array.from({length: points.length / 3}, (_, k) => new Vector3().fromArray(points, 3 * k)));
    const vertices = [], corner = vertex => vertices.push(vertex.point.toArray()) - 1;
    const faces = hull.faces.map(({edge}) => [edge.prev, edge, edge.next].map(each => corner(each.head())));
    return {vertices, faces};
  },
  quickhull3d: points => {
    const vertices = Array.from({length: points.length / 3}, (_, k) => [...points.subarray(3 * k, 3 * k + 3)]);
    return {vertices, faces: quickHull(vertices)};
  },
};

for (const [name, program] of Object.entries(peers)) {
  const found = await cx.conform(program, {asks: "hull"});
  const easy = await cx.conform(program, {asks: "hull", only: ["tetrahedron"]});
  assert.ok(easy.passed > 0, easy.failures[0]?.sentence);
  assert.ok(found.results.length > 100);
  console.log(`${name}: ${found.passed} of ${found.results.length} vectors`);
  for (const failure of found.failures.slice(0, 3)) console.log(`  ${failure.id}: ${failure.sentence}`);
}
