// SPDX-License-Identifier: MIT
// The npm programs of ./dev field: node programs.mjs NAME INPUT.obj OUTPUT.obj
// Each takes the input's points and writes its hull as a mesh, in the digits its users print.
// It runs from build/field, beside node_modules. Exit code 4: the library found no hull.
import { readFileSync, writeFileSync } from "node:fs";
import { register } from "node:module";

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
  const number = (x) => (single ? String(Number(Math.fround(x).toPrecision(9))) : String(x));
  const lines = points.map((point) => "v " + point.map(number).join(" "));
  for (const face of faces) lines.push("f " + face.map((corner) => corner + 1).join(" "));
  writeFileSync(path, lines.join("\n") + "\n");
}

const triples = (flat) => Array.from({ length: flat.length / 3 }, (_, k) => [...flat.slice(3 * k, 3 * k + 3)]);

// Corners that the library repeats for each face stay repeated.
const soup = (corners, single) => ({ points: corners, faces: triples(corners.map((_, k) => k)), single });

const programs = {
  async "three-hull"({ points }) {
    const { Vector3 } = await import("three");
    const { ConvexHull } = await import("three/addons/math/ConvexHull.js");
    const hull = new ConvexHull().setFromPoints(points.map((point) => new Vector3(...point)));
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
    const geometry = new ConvexGeometry(points.map((point) => new Vector3(...point)));
    return soup(triples(geometry.getAttribute("position").array), true);
  },

  async quickhull3d({ points }) {
    const { default: quickhull } = await import("quickhull3d");
    return { points, faces: quickhull(points) };
  },

  async "quickhull3d-polygons"({ points }) {
    const { default: quickhull } = await import("quickhull3d");
    return { points, faces: quickhull(points, { skipTriangulation: true }) };
  },

  async jolt({ points }) {
    const { default: start } = await import("jolt-physics");
    const Jolt = await start();
    const settings = new Jolt.ConvexHullShapeSettings();
    for (const [x, y, z] of points) settings.mPoints.push_back(new Jolt.Vec3(x, y, z));
    settings.mMaxConvexRadius = 0;
    const result = settings.Create();
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
    const description = RAPIER.ColliderDesc.convexHull(new Float32Array(points.flat()));
    if (!description) throw new Error("no hull");
    const collider = new RAPIER.World({ x: 0, y: 0, z: 0 }).createCollider(description);
    return { points: triples(collider.vertices()), faces: triples(collider.indices()), single: true };
  },

  async manifold({ points }) {
    const { default: start } = await import("manifold-3d");
    const module = await start();
    module.setup();
    const mesh = module.Manifold.hull(points).getMesh();
    if (mesh.numVert === 0) throw new Error("no hull");
    const width = mesh.numProp;
    const corners = Array.from({ length: mesh.numVert }, (_, k) => [...mesh.vertProperties.slice(width * k, width * k + 3)]);
    return { points: corners, faces: triples(mesh.triVerts), single: true };
  },

  async physx({ points }, shifting = false) {
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
    const mesh = top.CreateConvexMesh(new PhysX.PxCookingParams(new PhysX.PxTolerancesScale()), description);
    if (!mesh || !mesh.ptr) throw new Error("no convex mesh");
    const read = PhysX.NativeArrayHelpers.prototype;
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
    return programs.physx(input, true);
  },

  async vhacd({ points, faces }) {
    const { ConvexMeshDecomposition } = await import("./node_modules/vhacd-js/lib/vhacd.js");
    const triangles = faces.flatMap((face) => face.slice(2).map((_, k) => [face[0], face[k + 1], face[k + 2]]));
    const decomposer = await ConvexMeshDecomposition.create();
    const hulls = decomposer.computeConvexHulls(
      { positions: new Float64Array(points.flat()), indices: new Uint32Array(triangles.flat()) },
      { maxHulls: 1, voxelResolution: 20000, maxVerticesPerHull: 64 });
    if (hulls.length === 0) throw new Error("no hull");
    return { points: triples(hulls[0].positions), faces: triples(hulls[0].indices) };
  },
};

const [name, input, output] = process.argv.slice(2);
try {
  writeObj(output, await programs[name](readObj(input)));
  process.exit(0);
} catch (error) {
  process.stderr.write(`${name}: ${error?.message ?? error}\n`);
  process.exit(4);
}
