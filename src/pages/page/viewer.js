// SPDX-License-Identifier: MIT
// Draws the picture by three.js, turns and zooms it, numbers its facets and picks them. Without WebGL 2
// it leaves the static drawing of the page in its place.
"use strict";
(() => {
const view = document.getElementById("view"), canvas = document.createElement("canvas");
const context = canvas.getContext("webgl2", {alpha: true, antialias: false});
if (!context) return;

// --- the scene -----------------------------------------------------------------------------------

const renderer = new THREE.WebGLRenderer({canvas, context});
// From the front to the back, so that few pixels are painted twice; the library would go by materials first.
renderer.setOpaqueSort((a, b) => a.renderOrder - b.renderOrder || a.z - b.z);
const scene = new THREE.Scene(), camera = new THREE.PerspectiveCamera(30, 1, 0.01, 100);
const boxOf = document.querySelectorAll("#layers input");
let radius = 0, radiusTogether = 0, radiusApart = 0;
picture.layers.forEach((layer, place) => {
  const group = shapes.groupOf(layer, place), box = boxOf[place];
  scene.add(group);
  for (const part of group.children) {
    part.geometry.computeBoundingSphere();
    const sphere = part.geometry.boundingSphere;
    radiusTogether = Math.max(radiusTogether, sphere.center.length() + sphere.radius);
    group.userData.away = new THREE.Vector3(...(layer.away || [0, 0, 0])).divideScalar(32767);
    radiusApart = Math.max(radiusApart, sphere.center.clone().add(group.userData.away).length() + sphere.radius);
  }
  group.userData.right = layer.right === true;
  group.userData.box = box;
  box.hidden = false;
  box.onchange = redraw;
});

radius = radiusTogether;
function control(id, act) {
  const input = document.getElementById(id);
  if (!input) return;
  input.parentElement.hidden = false;
  input.oninput = () => {
    act(input.type === "checkbox" ? input.checked : Number(input.value));
    redraw();
  };
}
control("apart", share => {
  for (const group of scene.children) group.position.copy(group.userData.away).multiplyScalar(share / 100);
  radius = radiusTogether + Math.max(0, radiusApart - radiusTogether) * share / 100;
});
// What is nearer to the reader than this plane is cut away; it stays where it is when the picture turns.
let cutting = null;
control("cut", share => {
  if (share === 0) cutting = null;
  else cutting ||= new THREE.Plane(towardsReader().negate(), 0);
  if (cutting) cutting.constant = radius * (1 - share / 50);
  renderer.clippingPlanes = cutting ? [cutting] : [];
});

// The parts as glass, and the input in them.
control("glass", on => {
  for (const group of scene.children) {
    if (!group.userData.right) group.userData.box.checked ||= on && group === scene.children[0];
    else shapes.setGlass(group, on);
  }
});

// One layer alone, until its button is pressed again; and the list in another order.
const list = document.getElementById("layers"), entries = [...list.children];
let alone = null, before = [];
entries.forEach((entry, place) => {
  const button = entry.querySelector("button"), boxes = scene.children.map(group => group.userData.box);
  button.hidden = entries.length < 3;
  button.setAttribute("aria-pressed", "false");
  button.setAttribute("aria-label", "only " + entry.querySelector("label").innerText.trim());
  button.onclick = () => {
    if (alone) alone.setAttribute("aria-pressed", "false");
    else before = boxes.map(box => box.checked);
    alone = alone === button ? null : button;
    alone?.setAttribute("aria-pressed", "true");
    boxes.forEach((box, k) => box.checked = alone ? k === place : before[k]);
    redraw();
  };
});
list.classList.toggle("long", entries.length > 12);
const sort = document.getElementById("sort");
if (sort) {
  sort.parentElement.hidden = false;
  sort.onchange = () => {
    const key = entry => sort.value ? -Number(entry.dataset[sort.value]) : 0;
    list.append(...[...entries].sort((a, b) => key(a) - key(b)));  // stable
  };
}

for (const [id, step] of [["merges", "merge"], ["splits", "split"]]) {
  control(id, steps => {
    const told = scene.children.map(group => group.userData[step]?.(steps)).filter(text => text !== undefined);
    document.querySelector(`#${id} + output`).textContent = told[0];
  });
}

// --- one pane, or two --------------------------------------------------------------------------------

let pair = false;
control("pair", on => {
  pair = on;
  view.classList.toggle("pair", on);
  // What was hidden at first, such as the input of a decomposition, is why there are two panes.
  for (const right of [false, true]) {
    const boxes = scene.children.filter(group => group.userData.right === right).map(group => group.userData.box);
    if (on && !boxes.some(box => box.checked)) boxes[0].checked = true;
  }
});

// In pixels of the page, from the upper left corner of the view; in a narrow one they are stacked.
function panes() {
  const width = view.clientWidth, height = view.clientHeight, stacked = width < 700;
  if (!pair) return [{left: 0, top: 0, width, height}];
  return [false, true].map(right => stacked
    ? {right, left: 0, top: right ? height / 2 : 0, width, height: height / 2}
    : {right, left: right ? width / 2 : 0, top: 0, width: width / 2, height});
}
// The camera as it sees a pane, with the layers of this pane alone.
function aim(pane) {
  camera.aspect = pane.width / Math.max(1, pane.height);
  const half = Math.atan(Math.tan(Math.PI * camera.fov / 360) * Math.min(1, camera.aspect));
  const distance = 1.03 * radius / Math.sin(half);
  camera.position.copy(towardsReader()).multiplyScalar(distance);
  camera.up.set(0, isZUp ? 0 : 1, isZUp ? 1 : 0);
  camera.lookAt(0, 0, 0);
  camera.near = Math.max(0.01, distance - 1.1 * radius);
  camera.far = distance + 1.1 * radius;
  camera.zoom = zoom;
  camera.updateProjectionMatrix();
  camera.updateMatrixWorld();
  for (const group of scene.children) {
    const {right, box} = group.userData;
    group.visible = box.checked && (pane.right === undefined || pane.right === right);
  }
}

// --- facets: their numbers, and the one that is picked -----------------------------------------------

for (const facet of picture.facets) {
  const layer = picture.layers[facet.place];
  layer.places ||= picture.numbersOf(layer.corners, Int16Array);
  facet.group = scene.children[facet.place];
  facet.points = facet.corners.map(k => new THREE.Vector3().fromArray(layer.places, 3 * k).divideScalar(32767));
  facet.middle = facet.points.reduce((sum, p) => sum.add(p), new THREE.Vector3()).divideScalar(facet.points.length);
  facet.normal = new THREE.Vector3();  // twice the area long: the sum of a fan around the middle
  facet.points.forEach((p, k) => {
    const next = facet.points[(k + 1) % facet.points.length].clone().sub(facet.middle);
    facet.normal.add(p.clone().sub(facet.middle).cross(next));
  });
}
// Whether it is drawn and looks at the camera.
function isSeen({group, middle, normal}) {
  return group.visible && normal.dot(camera.position.clone().sub(group.position).sub(middle)) > 0;
}

let labels = [];
control("numbers", on => {
  for (const label of labels) label.remove();
  labels = on ? picture.facets.map(facet => document.createElement("b")) : [];
  labels.forEach((label, k) => label.textContent = picture.facets[k].number);
  view.append(...labels);
});
function placeLabels(pane) {
  labels.forEach((label, k) => {
    const {group, middle} = picture.facets[k];
    if (pane.right !== undefined && pane.right !== group.userData.right) return;
    const place = middle.clone().add(group.position).project(camera);
    label.hidden = !isSeen(picture.facets[k]) || Math.abs(place.x) > 1 || Math.abs(place.y) > 1;
    label.style.left = pane.left + (1 + place.x) / 2 * pane.width + "px";
    label.style.top = pane.top + (1 - place.y) / 2 * pane.height + "px";
  });
}

// The index of the nearest facet at a place of the view, or -1.
function facetAt(x, y) {
  const pane = panes().find(({left, top, width, height}) =>
    x >= left && x < left + width && y >= top && y < top + height);
  if (!pane) return -1;
  aim(pane);
  const caster = new THREE.Raycaster(), ray = new THREE.Ray(), hit = new THREE.Vector3();
  caster.setFromCamera(new THREE.Vector2(2 * (x - pane.left) / pane.width - 1,
    1 - 2 * (y - pane.top) / pane.height), camera);
  let nearest = -1, least = Infinity;
  picture.facets.forEach((facet, index) => {
    if (!isSeen(facet)) return;
    ray.copy(caster.ray).origin.sub(facet.group.position);
    for (let k = 2; k < facet.points.length; ++k) {
      if (!ray.intersectTriangle(facet.points[0], facet.points[k - 1], facet.points[k], false, hit)) continue;
      const distance = hit.distanceTo(ray.origin);
      if (distance < least) [nearest, least] = [index, distance];
    }
  });
  return nearest;
}

let lit = null;
picture.onpick = (facet, byPointer) => {
  if (lit) {
    lit.removeFromParent();
    for (const part of lit.children) part.geometry.dispose();
  }
  lit = null;
  if (facet) {
    lit = shapes.litFacet(facet.points, facet.place);
    facet.group.add(lit);
    if (!byPointer) turnTo(facet.normal.clone().normalize());
  }
  redraw();
};

// --- turning and zooming -------------------------------------------------------------------------

let turn = 0.6, tilt = 0.35, zoom = 1;  // as the static drawing sees it
let slow = false, waiting = false, rest = 0;

// At rest every layer is drawn in full, with four pixels for one of the screen. Where that takes long,
// pixels and coarser layers of their own do while the picture moves, and of many layers the faces.
const kMostWithEdges = 100;
function setQuality(full) {
  const ratio = full ? Math.max(2, window.devicePixelRatio) : 1;
  if (renderer.getPixelRatio() !== ratio) renderer.setPixelRatio(ratio);
  scene.traverse(part => {
    if (part.userData.geometry) part.geometry = full ? part.userData.geometry : part.userData.turning;
    if (part.userData.areEdges) part.visible = full || picture.layers.length <= kMostWithEdges;
  });
}
function draw() {
  renderer.setScissorTest(pair);
  for (const pane of panes()) {
    const fromBelow = view.clientHeight - pane.top - pane.height;
    renderer.setViewport(pane.left, fromBelow, pane.width, pane.height);
    renderer.setScissor(pane.left, fromBelow, pane.width, pane.height);
    aim(pane);
    renderer.render(scene, camera);
    placeLabels(pane);
  }
}
function drawAtRest() {
  setQuality(true);
  draw();
}
function redraw() {
  clearTimeout(rest);
  if (slow) rest = setTimeout(() => requestAnimationFrame(drawAtRest), 250);
  if (waiting) return;
  waiting = true;
  requestAnimationFrame(() => {
    waiting = false;
    setQuality(!slow);
    draw();
  });
}
// y is up, or z. Angles are those of a scene with y up; there, (x, y, z) of a scene with z up is (x, z, -y).
let isZUp = false;
control("z-up", on => isZUp = on);
function towardsReader() {
  const [x, y, z] = [Math.sin(-turn) * Math.cos(tilt), Math.sin(tilt), Math.cos(turn) * Math.cos(tilt)];
  return isZUp ? new THREE.Vector3(x, -z, y) : new THREE.Vector3(x, y, z);
}
function move(right, down, factor) {
  turn += right;
  tilt = Math.max(-1.57, Math.min(1.57, tilt + down));
  zoom = Math.max(0.2, Math.min(50, zoom * factor));
  redraw();
}

// Only if this side cannot be seen well; at once, as nothing here moves by itself.
function turnTo(normal) {
  if (normal.dot(towardsReader()) > 0.5) return;
  if (isZUp) normal = new THREE.Vector3(normal.x, normal.z, -normal.y);
  if (Math.hypot(normal.x, normal.z) > 0.01) turn = Math.atan2(-normal.x, normal.z);
  tilt = Math.asin(Math.max(-1, Math.min(1, normal.y)));
}

// One finger, or the mouse, turns; two zoom. One that goes up where it went down picks.
const pointers = new Map();
let travelled = 0;
canvas.onpointerdown = event => {
  canvas.setPointerCapture(event.pointerId);
  travelled = pointers.size > 0 ? Infinity : 0;
  pointers.set(event.pointerId, {x: event.clientX, y: event.clientY});
};
canvas.onpointermove = event => {
  const before = pointers.get(event.pointerId), now = {x: event.clientX, y: event.clientY};
  if (!before) return;
  pointers.set(event.pointerId, now);
  if (pointers.size === 1) {
    travelled += Math.hypot(now.x - before.x, now.y - before.y);
    move((now.x - before.x) / 150, (now.y - before.y) / 150, 1);
  } else if (pointers.size === 2) {
    const [other] = [...pointers].filter(([id]) => id !== event.pointerId).map(([, place]) => place);
    const apart = place => Math.max(1, Math.hypot(place.x - other.x, place.y - other.y));
    move(0, 0, apart(now) / apart(before));
  }
};
canvas.onpointerup = canvas.onpointercancel = event => {
  const isTap = event.type === "pointerup" && event.button === 0 && travelled < 6;
  if (!pointers.delete(event.pointerId) || !isTap || picture.facets.length === 0) return;
  const box = canvas.getBoundingClientRect();
  picture.pick(facetAt(event.clientX - box.left, event.clientY - box.top), true);
};
canvas.onwheel = event => {
  event.preventDefault();
  move(0, 0, Math.exp(-event.deltaY / 800));
};
const kMoves = {ArrowLeft: [-0.1, 0, 1], ArrowRight: [0.1, 0, 1], ArrowUp: [0, -0.1, 1], ArrowDown: [0, 0.1, 1],
  "+": [0, 0, 1.1], "=": [0, 0, 1.1], "-": [0, 0, 1 / 1.1]};
// Enter and the space bar pick the facet in the middle.
function pickMiddle() {
  const {left, top, width, height} = panes().at(-1);
  picture.pick(facetAt(left + width / 2, top + height / 2), true);
}
const kPicks = {n: () => picture.next(1), p: () => picture.next(-1), Enter: pickMiddle, " ": pickMiddle};
canvas.onkeydown = event => {
  const act = kMoves[event.key] ? () => move(...kMoves[event.key]) : picture.facets.length && kPicks[event.key];
  if (!act || event.ctrlKey || event.metaKey || event.altKey) return;
  event.preventDefault();
  act();
};

// A long body is seen from its side; what fills less than the window is brought nearer.
const extent = new THREE.Box3().setFromObject(scene).getSize(new THREE.Vector3());
if (extent.z > 1.2 * extent.x) turn += Math.PI / 2;
function fillWindow() {
  aim({width: view.clientWidth, height: view.clientHeight});
  let most = 0.5;  // no closer than twice
  const place = new THREE.Vector3();
  scene.children.filter(group => group.visible).forEach(group => group.traverse(part => {
    const points = part.geometry?.attributes.position, step = Math.ceil((points?.count || 1) / 2000);
    for (let k = 0; points && k < points.count; k += step) {
      place.fromBufferAttribute(points, k).project(camera);
      most = Math.max(most, Math.abs(place.x), Math.abs(place.y));
    }
  }));
  zoom *= 0.95 / most;
}

// The side that is to be seen first.
picture.layers.forEach((layer, place) => {
  if (!layer.facesReader) return;
  const middle = new THREE.Box3().setFromObject(scene.children[place]).getCenter(new THREE.Vector3());
  if (middle.length() > 0.1) turnTo(middle.normalize());
});

canvas.tabIndex = 0;
canvas.setAttribute("role", "application");  // or screen readers would keep the keys for themselves
canvas.setAttribute("aria-describedby", "how");
canvas.setAttribute("aria-label", document.title + ": a picture that can be turned");
document.getElementById("how").hidden = false;
document.getElementById("how-to-pick").hidden = picture.facets.length === 0;
view.className = "live";
view.append(canvas);
fillWindow();
new ResizeObserver(() => {
  renderer.setSize(view.clientWidth, view.clientHeight);
  drawAtRest();
}).observe(view);

// The second drawing is timed to its end: the first one compiles.
requestAnimationFrame(() => requestAnimationFrame(() => {
  const start = performance.now();
  draw();
  context.readPixels(0, 0, 1, 1, context.RGBA, context.UNSIGNED_BYTE, new Uint8Array(4));
  slow = performance.now() - start > 20;
}));
})();
