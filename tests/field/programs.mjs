// SPDX-License-Identifier: MIT
// The npm programs of ./dev field: node programs.mjs NAME INPUT.obj OUTPUT.obj [FACES]
// Each takes the input's points and writes its hull as a mesh, or takes its faces and writes convex parts, an
// object for each, in the digits its users print. The seconds of the library's own call go to OUTPUT.obj.json.
// It runs from build/field, beside node_modules. Exit code 4: the library found no hull.
import { readFileSync, writeFileSync } from "node:fs";
import { createRequire, register } from "node:module";

// quickhull3d leaves ".js" out of its imports, as bundlers allow.
register("data:text/javascript," + encodeURIComponent(`
  export async function resolve(name, context, next) {
    try { return await next(name, context); } catch (error) { return next(name + ".js", context); }
  }`));

function readObj(path) {
  const points = [], faces = [];
  for (const line of readFileSync(path, "utf8").split("\n")) {
    const words = line.trim().split(/\s+/);
    if (words[0] === "v") points.push(words.slice(1, 4).map(Number));
    if (words[0] === "f") faces.push(words.slice(1).map((word) => parseInt(word) - 1));
  }
  return { points, faces };
}

// binary32 is printed as %.9g, binary64 as the shortest decimal.
function writeObj(path, { points, faces, single }) {
  writeFileSync(path, meshLines(points, faces, single, 0).join("\n") + "\n");
}

function meshLines(points, faces, single, first) {
  const number = (x) => (single ? String(Number(Math.fround(x).toPrecision(9))) : String(x));
  const lines = points.map((point) => "v " + point.map(number).join(" "));
  for (const face of faces) lines.push("f " + face.map((corner) => first + corner + 1).join(" "));
  return lines;
}

function writeParts(path, { parts, single }) {
  const lines = [];
  let first = 0;
  parts.forEach(({ points, faces }, k) => {
    lines.push("o part_" + String(k).padStart(3, "0"), ...meshLines(points, faces, single, first));
    first += points.length;
  });
  writeFileSync(path, lines.join("\n") + "\n");
}

// The call that is measured: the library's own, after it was loaded and has its input. Short calls are made a second
// time, and that counts, because the first one compiles. The processor's time counts if it is less than the clock's, as
// on a busy machine.
let seconds = null;
function timed(call) {
  for (let turn = 0; ; ++turn) {
    const start = performance.now(), used = process.cpuUsage();
    const result = call();
    const { user, system } = process.cpuUsage(used);
    seconds = Math.min((performance.now() - start) / 1000, (user + system) / 1e6);
    if (turn > 0 || seconds > 0.2) return result;
  }
}

const triples = (flat) => Array.from({ length: flat.length / 3 }, (_, k) => [...flat.slice(3 * k, 3 * k + 3)]);

const triangles = (faces) => faces.flatMap((face) => face.slice(2).map((_, k) => [face[0], face[k + 1], face[k + 2]]));

// Corners that the library repeats for each face stay repeated.
const soup = (corners, single) => ({ points: corners, faces: triples(corners.map((_, k) => k)), single });

// Without the points that no face uses: judges take all points of a file for the solid, so that a library which returns
// indices into its input would hold every point by the input's own.
function usedOnly(points, faces) {
  const used = [...new Set(faces.flat())], index = new Map(used.map((corner, k) => [corner, k]));
  return { points: used.map((corner) => points[corner]), faces: faces.map((face) => face.map((corner) => index.get(corner))) };
}

// physx-js-webidl has no name for vertexLimit. In PxConvexMeshDesc it follows three PxBoundedData of 12 bytes and two
// bytes of flags, and its default is 255: another value there means another layout.
function setVertexLimit(description, limit, arrays) {
  const place = 38 / 2, words = arrays.voidToU16Ptr(description);
  if (arrays.getU16At(words, place) !== 255) throw new Error("no vertexLimit where it was");
  arrays.setU16At(description, place, limit);
  if (arrays.getU16At(words, place) !== limit) throw new Error("vertexLimit cannot be set");
}

const programs = {
  async "three-hull"({ points }) {
    const { Vector3 } = await import("three");
    const { ConvexHull } = await import("three/addons/math/ConvexHull.js");
    const vectors = points.map((point) => new Vector3(...point));
    const hull = timed(() => new ConvexHull().setFromPoints(vectors));
    const corners = [], faces = [];
    for (const face of hull.faces) {
      const polygon = [];
      for (let edge = face.edge; ; edge = edge.next) {
        polygon.push(corners.push(edge.head().point.toArray()) - 1);
        if (edge.next === face.edge) break;
      }
      faces.push(polygon);
    }
    return { points: corners, faces };
  },

  async "three-geometry"({ points }) {
    const { Vector3 } = await import("three");
    const { ConvexGeometry } = await import("three/addons/geometries/ConvexGeometry.js");
    const vectors = points.map((point) => new Vector3(...point));
    const geometry = timed(() => new ConvexGeometry(vectors));
    return soup(triples(geometry.getAttribute("position").array), true);
  },

  async quickhull3d({ points }, options = undefined) {
    const { default: quickhull } = await import("quickhull3d");
    return usedOnly(points, timed(() => quickhull(points, options)));
  },

  async "quickhull3d-polygons"(input) {
    return programs.quickhull3d(input, { skipTriangulation: true });
  },

  async jolt({ points }) {
    const { default: start } = await import("jolt-physics");
    const Jolt = await start();
    const settings = new Jolt.ConvexHullShapeSettings();
    for (const [x, y, z] of points) settings.mPoints.push_back(new Jolt.Vec3(x, y, z));
    settings.mMaxConvexRadius = 0;
    const result = timed(() => {
      settings.ClearCachedResult();
      return settings.Create();
    });
    if (!result.IsValid()) throw new Error(result.HasError() ? result.GetError().c_str() : "no shape");
    const shape = result.Get();
    const everything = new Jolt.AABox(new Jolt.Vec3(-3e38, -3e38, -3e38), new Jolt.Vec3(3e38, 3e38, 3e38));
    const triangles = new Jolt.ShapeGetTriangles(shape, everything, shape.GetCenterOfMass(),
      new Jolt.Quat(0, 0, 0, 1), new Jolt.Vec3(1, 1, 1));
    const bytes = triangles.GetVerticesSize();
    return soup(triples(new Float32Array(Jolt.HEAPF32.buffer, triangles.GetVerticesData(), bytes / 4)), true);
  },

  async rapier({ points }) {
    const { default: RAPIER } = await import("@dimforge/rapier3d-compat");
    await RAPIER.init();
    // The hull is made when the collider is, from the points of the description.
    const description = RAPIER.ColliderDesc.convexHull(new Float32Array(points.flat()));
    if (!description) throw new Error("no hull");
    const world = new RAPIER.World({ x: 0, y: 0, z: 0 });
    const collider = timed(() => world.createCollider(description));
    return { points: triples(collider.vertices()), faces: triples(collider.indices()), single: true };
  },

  async manifold({ points }) {
    const { default: start } = await import("manifold-3d");
    const module = await start();
    module.setup();
    const mesh = timed(() => module.Manifold.hull(points).getMesh());
    if (mesh.numVert === 0) throw new Error("no hull");
    const width = mesh.numProp;
    const corners = Array.from({ length: mesh.numVert }, (_, k) => [...mesh.vertProperties.slice(width * k, width * k + 3)]);
    return { points: corners, faces: triples(mesh.triVerts), single: true };
  },

  async physx({ points }, { shifting = false, limit = null } = {}) {
    const { default: start } = await import("physx-js-webidl");
    // Built for browsers only, so node has to look like one while it starts, and to read the file itself.
    const wasmBinary = readFileSync(new URL(import.meta.resolve("physx-js-webidl/physx-js-webidl.wasm")));
    const node = globalThis.process;
    globalThis.window = globalThis;
    globalThis.process = undefined;
    const PhysX = await start({ wasmBinary });
    globalThis.process = node;
    const top = PhysX.PxTopLevelFunctions.prototype;
    PhysX.CreateFoundation(PhysX.PHYSICS_VERSION, new PhysX.PxDefaultAllocator(), new PhysX.PxDefaultErrorCallback());
    const input = new PhysX.PxArray_PxVec3(points.length);
    points.forEach(([x, y, z], k) => input.set(k, new PhysX.PxVec3(x, y, z)));
    const description = new PhysX.PxConvexMeshDesc();
    description.flags = new PhysX.PxConvexFlags(PhysX.PxConvexFlagEnum.eCOMPUTE_CONVEX |
      (shifting ? PhysX.PxConvexFlagEnum.ePLANE_SHIFTING : 0));
    description.points.count = points.length;
    description.points.stride = 12;
    description.points.data = input.begin();
    const read = PhysX.NativeArrayHelpers.prototype;
    if (limit) setVertexLimit(description, limit, read);
    const parameters = new PhysX.PxCookingParams(new PhysX.PxTolerancesScale());
    const mesh = timed(() => top.CreateConvexMesh(parameters, description));
    if (!mesh || !mesh.ptr) throw new Error("no convex mesh");
    const corners = Array.from({ length: mesh.getNbVertices() }, (_, k) => {
      const { x, y, z } = read.getVec3At(mesh.getVertices(), k);
      return [x, y, z];
    });
    const faces = [], polygon = new PhysX.PxHullPolygon();
    for (let f = 0; f < mesh.getNbPolygons(); ++f) {
      mesh.getPolygonData(f, polygon);
      faces.push(Array.from({ length: polygon.mNbVerts }, (_, k) => read.getU8At(mesh.getIndexBuffer(), polygon.mIndexBase + k)));
    }
    return { points: corners, faces, single: true };
  },

  async "physx-shifting"(input) {
    return programs.physx(input, { shifting: true });
  },

  // PhysX takes no limit below 8 without plane shifting.
  async "physx-limit"(input, faces) {
    return programs.physx(input, { limit: Math.min(Math.max(8, Number(faces)), 255) });
  },

  async vhacd({ points, faces }) {
    const { ConvexMeshDecomposition } = await import("./node_modules/vhacd-js/lib/vhacd.js");
    const decomposer = await ConvexMeshDecomposition.create();
    const mesh = { positions: new Float64Array(points.flat()), indices: new Uint32Array(triangles(faces).flat()) };
    const hulls = timed(() => decomposer.computeConvexHulls(
      mesh, { maxHulls: 1, voxelResolution: 20000, maxVerticesPerHull: 64 }));
    if (hulls.length === 0) throw new Error("no hull");
    return { points: triples(hulls[0].positions), faces: triples(hulls[0].indices) };
  },

  async ammo({ points }) {
    const require = createRequire(import.meta.url);
    const Ammo = await require("ammojs-typed").call({});
    const hull = new Ammo.btConvexHullShape();
    hull.setMargin(0);
    for (const [x, y, z] of points) hull.addPoint(new Ammo.btVector3(x, y, z), false);
    timed(() => hull.initializePolyhedralFeatures(0));
    const polyhedron = hull.getConvexPolyhedron();
    const vertices = polyhedron.get_m_vertices(), polygons = polyhedron.get_m_faces();
    const corners = Array.from({ length: vertices.size() }, (_, k) => {
      const vertex = vertices.at(k);
      return [vertex.x(), vertex.y(), vertex.z()];
    });
    const faces = Array.from({ length: polygons.size() }, (_, k) => {
      const indices = polygons.at(k).get_m_indices();
      return Array.from({ length: indices.size() }, (_, c) => indices.at(c));
    });
    if (faces.length === 0) throw new Error("no hull");
    return { points: corners, faces, single: true };
  },

  // The decomposers. V-HACD's and Rapier's other options stay as their authors set them.
  async "vhacd-parts"({ points, faces }, options = {}) {
    const { ConvexMeshDecomposition } = await import("./node_modules/vhacd-js/lib/vhacd.js");
    const decomposer = await ConvexMeshDecomposition.create();
    const mesh = { positions: new Float64Array(points.flat()), indices: new Uint32Array(triangles(faces).flat()) };
    const hulls = timed(() => decomposer.computeConvexHulls(mesh, options));
    return { parts: hulls.map((hull) => ({ points: triples(hull.positions), faces: triples(hull.indices) })) };
  },

  async "vhacd-16"(input) {
    return programs["vhacd-parts"](input, { maxHulls: 16 });
  },

  async "vhacd-24"(input) {
    return programs["vhacd-parts"](input, { maxHulls: 24 });
  },

  async "rapier-parts"({ points, faces }, options = undefined) {
    const { default: RAPIER } = await import("@dimforge/rapier3d-compat");
    await RAPIER.init();
    const vertices = new Float32Array(points.flat()), indices = new Uint32Array(triangles(faces).flat());
    const description = timed(() => RAPIER.ColliderDesc.convexDecomposition(vertices, indices, options));
    if (!description) throw new Error("no parts");
    return { parts: description.shape.shapes.map((part) => ({ points: triples(part.vertices), faces: triples(part.indices) })),
      single: true };
  },

  async "rapier-16"(input) {
    return programs["rapier-parts"](input, { maxConvexHulls: 16 });
  },
};

const [name, input, output, ...more] = process.argv.slice(2);
try {
  const result = await programs[name](readObj(input), ...more);
  if (result.parts?.length === 0) throw new Error("no parts");
  (result.parts ? writeParts : writeObj)(output, result);
  writeFileSync(output + ".json", JSON.stringify({ seconds }) + "\n");
  process.exit(0);
} catch (error) {
  process.stderr.write(`${name}: ${error?.message ?? error}\n`);
  process.exit(4);
}
