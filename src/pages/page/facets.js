// SPDX-License-Identifier: MIT
// Reads the picture, and tells the exact plane of a facet that is picked. It needs no WebGL: a list of
// the facets stands on the page in any case.
"use strict";
const picture = (() => {

function numbersOf(base64, Type) {
  return new Type(Uint8Array.from(atob(base64), c => c.charCodeAt(0)).buffer);
}

const layers = JSON.parse(document.getElementById("picture").textContent);

// The facets of a solid. The neighbour at an edge has this edge the other way round.
function facetsOf({name, planes, polygons}, place) {
  const left = new Map(), edge = (corners, k) => [corners[k], corners[(k + 1) % corners.length]];
  polygons.forEach((corners, number) => {
    corners.forEach((_, k) => left.set(edge(corners, k).join(), number));
  });
  return polygons.map((corners, number) => ({place, name, number, corners, plane: planes[number],
    neighbours: corners.map((_, k) => left.get(edge(corners, k).reverse().join())).filter(x => x !== undefined)}));
}
const facets = layers.flatMap((layer, place) => (layer.solids || []).flatMap(solid => facetsOf(solid, place)));

// --- the facet that is picked --------------------------------------------------------------------

const list = document.getElementById("facet"), told = document.getElementById("told");
let picked = -1;
const self = {layers, facets, numbersOf, pick, next, onpick: () => {}};

function pick(index, byPointer = false) {
  picked = index;
  list.value = index;
  const facet = facets[index];
  told.textContent = facet ? `Facet ${facet.number} of ${facet.name}: ${facet.corners.length} corners, ` +
    `next to ${facet.neighbours.join(", ")}. Plane ${facet.plane}.` : "";
  told.tabIndex = facet ? 0 : -1;  // long numbers are scrolled by keys, too
  self.onpick(facet, byPointer);
}
// The next facet of a layer that is shown, or the one before.
function next(step) {
  const isShown = index => document.querySelectorAll("#layers input")[facets[index].place].checked;
  let index = picked < 0 && step < 0 ? 0 : picked;
  for (let tries = facets.length; tries > 0; --tries) {
    index = (index + step + facets.length) % facets.length;
    if (isShown(index)) return pick(index);
  }
}

if (facets.length > 0) {
  const names = new Set(facets.map(facet => facet.name));
  for (const name of names) {
    const group = document.createElement("optgroup");
    group.label = name;
    list.append(group);
    facets.forEach((facet, index) => {
      if (facet.name === name) group.append(new Option(facet.number, index));
    });
  }
  list.onchange = () => pick(Number(list.value));
  document.getElementById("facets").hidden = false;
}
document.addEventListener("keydown", event => {
  if (event.key === "Escape" && picked >= 0) pick(-1);
});
return self;
})();
