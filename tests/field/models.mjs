// SPDX-License-Identifier: MIT
// What readers of models make of them: node models.mjs READER MODEL OUTPUT.json
// Writes the list of the parts that the reader has in memory: each with its "name", its "points" in the frame of the
// file, and of MuJoCo the number of corners of the hull that it collides with. It runs from build/field, beside
// node_modules. Exit code 4: the reader refused the model; its words go to standard error.
import { readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";

const triples = (flat) => Array.from({ length: flat.length / 3 }, (_, k) => [...flat.slice(3 * k, 3 * k + 3)]);

// Of the unit quaternion (w, x, y, z), which MuJoCo keeps in doubles.
function rotated([w, x, y, z], [a, b, c]) {
  return [
    (1 - 2 * (y * y + z * z)) * a + 2 * (x * y - w * z) * b + 2 * (x * z + w * y) * c,
    2 * (x * y + w * z) * a + (1 - 2 * (x * x + z * z)) * b + 2 * (y * z - w * x) * c,
    2 * (x * z - w * y) * a + 2 * (y * z + w * x) * b + (1 - 2 * (x * x + y * y)) * c,
  ];
}

const readers = {
  // The mesh of each geom, turned and moved to where the geom is.
  async mujoco(path) {
    const { default: start } = await import("@mujoco/mujoco");
    const mujoco = await start();
    const text = readFileSync(path, "utf8"), files = new mujoco.MjVFS();
    for (const [, , file] of text.matchAll(/ (file|filename)="([^"]*)"/g)) {
      files.addBuffer(file, readFileSync(join(dirname(path), file)));
    }
    const model = mujoco.MjModel.from_xml_string(text, files);
    return Array.from(model.geom_dataid, (mesh, geom) => {
      const first = 3 * model.mesh_vertadr[mesh], last = first + 3 * model.mesh_vertnum[mesh];
      const turn = [...model.geom_quat.slice(4 * geom, 4 * geom + 4)], move = model.geom_pos.slice(3 * geom, 3 * geom + 3);
      const points = triples(model.mesh_vert.slice(first, last)).map(
        (point) => rotated(turn, point).map((x, axis) => x + move[axis]));
      const name = mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_GEOM.value, geom);
      return { name, points, corners: model.mesh_graph[model.mesh_graphadr[mesh]] };
    });
  },

  async tinyusdz(path) {
    const bytes = readFileSync(path), wasmBinary = readFileSync(new URL("node_modules/tinyusdz/tinyusdz.wasm", import.meta.url));
    // Built for browsers only, so node has to look like one while it starts.
    const node = globalThis.process;
    globalThis.window = globalThis;
    globalThis.process = undefined;
    const { default: start } = await import("tinyusdz");
    const usd = await start({ wasmBinary });
    globalThis.process = node;
    const scene = new usd.TinyUSDZLoaderNative();
    if (!scene.loadFromBinary(bytes, "model.usda")) throw new Error(scene.error());
    return Array.from({ length: scene.numMeshes() }, (_, k) => {
      const { primName, displayName, points } = scene.getMesh(k);
      return { name: displayName || primName, points: triples(points) };
    });
  },

  // The parser of three.js keeps numbers as doubles; three.js stores them as floats later.
  async "three-usd"(path) {
    const { USDAParser } = await import("three/addons/loaders/usd/USDAParser.js");
    const { specsByPath: prims } = new USDAParser().parseData(readFileSync(path, "utf8"));
    return Object.keys(prims).filter((prim) => prims[prim].fields.typeName === "Mesh").map(
      (prim) => ({ name: prim.split("/").pop(), points: triples(prims[prim + ".points"].fields.default) }));
  },
};

const [, , reader, model, output] = process.argv;
try {
  writeFileSync(output, JSON.stringify(await readers[reader](model)));
} catch (error) {
  console.error(String(error.message ?? error));
  process.exitCode = 4;
}
