// SPDX-License-Identifier: MIT
// A page that a bundler makes: npm install convexact, and then
//   Vite      npx vite build
//   webpack   npx webpack ./main.js --mode production && cp index.html dist
//   esbuild   npx esbuild main.js worker=node_modules/convexact/worker.js convexact=node_modules/convexact/convexact.wasm \
//               vectors=node_modules/convexact/vectors.json --bundle --format=esm --loader:.wasm=copy --loader:.json=copy \
//               --outdir=dist && cp index.html dist
import convexact, {ConvexactError} from "convexact";

const cx = await convexact();
const hull = await cx.hull([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]);
const flat = await cx.hull([[0, 0, 0], [1, 0, 0], [0, 1, 0]]).catch(error => error instanceof ConvexactError && error.kind);
const judged = await cx.conform(points => points, {asks: "hull", only: ["tetrahedron"]});
document.getElementById("answer").textContent =
  `${hull.planes.length} facets, volume ${hull.volume.decimal}; three points: ${flat}; tetrahedra right: ${judged.ok}`;
