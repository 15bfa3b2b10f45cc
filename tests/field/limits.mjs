// SPDX-License-Identifier: MIT
// npm programs of ./dev field that are asked for a number of vertices: node limits.mjs NAME INPUT.obj OUTPUT.obj FACES
// It runs from build/field, beside node_modules, and ends as programs.mjs does. It is a file of its own because
// what is known of an output counts only as long as the script that made it has the same bytes.
import { readFileSync, writeFileSync } from "node:fs";

function readPoints(path) {
  const lines = readFileSync(path, "utf8").split("\n").filter((line) => line.startsWith("v "));
  return lines.map((line) => line.trim().split(/\s+/).slice(1, 4).map(Number));
}

// Binary32, printed as %.9g.
function writeObj(path, points, faces) {
  const number = (x) => String(Number(Math.fround(x).toPrecision(9)));
  const lines = points.map((point) => "v " + point.map(number).join(" "));
  for (const face of faces) lines.push("f " + face.map((corner) => corner + 1).join(" "));
  writeFileSync(path, lines.join("\n") + "\n");
}

// The second of two calls counts, and the processor's time if it is less than the clock's.
function timed(call) {
  call();
  const start = performance.now(), used = process.cpuUsage();
  const result = call();
  const { user, system } = process.cpuUsage(used);
  return [result, Math.min((performance.now() - start) / 1000, (user + system) / 1e6)];
}

// The package has no name for vertexLimit. In PxConvexMeshDesc it follows three PxBoundedData of 12 bytes and two bytes
// of flags, and its default is 255: another value there means another layout.
const VERTEX_LIMIT = 38 / 2;

const programs = {
  async "physx-limit"(points, limit) {
    const { default: start } = await import("physx-js-webidl");
    // Built for browsers only, so node has to look like one while it starts, and to read the file itself.
    const wasmBinary = readFileSync(new URL(import.meta.resolve("physx-js-webidl/physx-js-webidl.wasm")));
    const node = globalThis.process;
    globalThis.window = globalThis;
    globalThis.process = undefined;
    const PhysX = await start({ wasmBinary });
    globalThis.process = node;
    PhysX.CreateFoundation(PhysX.PHYSICS_VERSION, new PhysX.PxDefaultAllocator(), new PhysX.PxDefaultErrorCallback());
    const input = new PhysX.PxArray_PxVec3(points.length), arrays = PhysX.NativeArrayHelpers.prototype;
    points.forEach(([x, y, z], k) => input.set(k, new PhysX.PxVec3(x, y, z)));
    const description = new PhysX.PxConvexMeshDesc();
    description.flags = new PhysX.PxConvexFlags(PhysX.PxConvexFlagEnum.eCOMPUTE_CONVEX);
    description.points.count = points.length;
    description.points.stride = 12;
    description.points.data = input.begin();
    const words = arrays.voidToU16Ptr(description);
    if (arrays.getU16At(words, VERTEX_LIMIT) !== 255) throw new Error("no vertexLimit where it was");
    arrays.setU16At(description, VERTEX_LIMIT, limit);
    if (arrays.getU16At(words, VERTEX_LIMIT) !== limit) throw new Error("vertexLimit cannot be set");
    const parameters = new PhysX.PxCookingParams(new PhysX.PxTolerancesScale());
    const [mesh, seconds] = timed(() => PhysX.PxTopLevelFunctions.prototype.CreateConvexMesh(parameters, description));
    if (!mesh || !mesh.ptr) throw new Error("no convex mesh");
    const corners = Array.from({ length: mesh.getNbVertices() }, (_, k) => {
      const { x, y, z } = arrays.getVec3At(mesh.getVertices(), k);
      return [x, y, z];
    });
    const faces = [], polygon = new PhysX.PxHullPolygon();
    for (let f = 0; f < mesh.getNbPolygons(); ++f) {
      mesh.getPolygonData(f, polygon);
      faces.push(Array.from({ length: polygon.mNbVerts }, (_, k) => arrays.getU8At(mesh.getIndexBuffer(), polygon.mIndexBase + k)));
    }
    return [corners, faces, seconds];
  },
};

const [name, input, output, faces] = process.argv.slice(2);
try {
  // PhysX takes no limit below 8 without plane shifting.
  const [points, polygons, seconds] = await programs[name](readPoints(input), Math.min(Math.max(8, Number(faces)), 255));
  writeObj(output, points, polygons);
  writeFileSync(output + ".json", JSON.stringify({ seconds }) + "\n");
  process.exit(0);
} catch (error) {
  process.stderr.write(`${name}: ${error?.message ?? error}\n`);
  process.exit(4);
}
