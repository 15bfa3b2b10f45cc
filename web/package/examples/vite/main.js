// SPDX-License-Identifier: MIT
// A page that Vite bundles: npm install convexact vite, then npx vite build.
import convexact, {ConvexactError} from "convexact";

const cx = await convexact();
const hull = await cx.hull([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]);
const flat = await cx.hull([[0, 0, 0], [1, 0, 0], [0, 1, 0]]).catch(error => error instanceof ConvexactError && error.kind);
document.getElementById("answer").textContent = `${hull.planes.length} facets, volume ${hull.volume.decimal}; three points: ${flat}`;
