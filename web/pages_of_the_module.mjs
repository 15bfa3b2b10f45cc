// SPDX-License-Identifier: MIT
// pages_of_the_module.mjs PACKAGE - one page of each kind that the module makes, as a list in JSON: a picture, a lesson on a
// solid, and the two in the plane.
import {pathToFileURL} from "node:url";

const {default: convexact} = await import(pathToFileURL(`${process.argv[2]}/node.js`));
const cx = await convexact();
const corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0]], tetrahedron = [...corners, [0, 0, 1]];
const pages = [
  (await cx.hull(tetrahedron, {picture: true})).picture,
  (await cx.teach(tetrahedron)).page,
  (await cx.teach(corners, {plane: true})).page,
  (await cx.teach({points: corners, triangles: [[0, 1, 2]]}, {plane: true})).page,
];
process.stdout.write(JSON.stringify(pages));
