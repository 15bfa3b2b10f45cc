// SPDX-License-Identifier: MIT
// Makes shapes for three.js from layers of a picture: surfaces, lit and flat, and points.
"use strict";
const shapes = (() => {

// --- the layers ----------------------------------------------------------------------------------

const numbersOf = picture.numbersOf;
function indicesOf(layer, base64) {
  return numbersOf(base64, layer.wide ? Uint32Array : Uint16Array);
}

function geometryOf(data) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(
    Float32Array.from(numbersOf(data.points, Int16Array), x => x / 32767), 3));
  if (data.triangles !== undefined) {
    geometry.setIndex(new THREE.BufferAttribute(indicesOf(data, data.triangles), 1));
  }
  return geometry;
}

// Flat faces take their normals from what is drawn, so they need no winding; the light comes from the
// viewer's left shoulder and from above. The library's own lights take twice as long in software. Faces
// lie a little behind edges at the same place.
const kVertex = `
  #include <clipping_planes_pars_vertex>
  varying vec3 place;
  varying vec3 shade;
  void main() {
    #ifdef USE_COLOR
      shade = color;
    #else
      shade = vec3(1.0);
    #endif
    vec4 mvPosition = modelViewMatrix * vec4(position, 1.0);
    place = mvPosition.xyz;
    gl_Position = projectionMatrix * mvPosition;
    #include <clipping_planes_vertex>
  }`;
const kFragment = `
  #include <clipping_planes_pars_fragment>
  uniform vec3 paint;
  uniform float opacity;
  varying vec3 place;
  varying vec3 shade;
  void main() {
    #include <clipping_planes_fragment>
    vec3 normal = normalize(cross(dFdx(place), dFdy(place)));
    float light = 0.62 + 0.08 * normal.y + 0.42 * max(0.0, dot(normal, vec3(-0.36, 0.58, 0.73)));
    gl_FragColor = vec4(light * paint * shade, opacity);
  }`;
// A layer of a higher rank lies behind one of a lower rank that has the same place: by more than the grid of
// the coordinates, 1/32767 of half the scene, moves a plane, and by less than is seen.
function faceMaterial(layer, more) {
  const rank = layer.rank || 0;
  return new THREE.ShaderMaterial({vertexShader: kVertex, fragmentShader: kFragment,
    uniforms: {paint: {value: new THREE.Color(layer.color)}, opacity: {value: layer.opacity}},
    side: THREE.DoubleSide, polygonOffset: true, polygonOffsetFactor: 1 + 0.1 * rank, polygonOffsetUnits: 1 + 600 * rank,
    clipping: true, ...more});
}

// --- polygons with colours of their own ------------------------------------------------------------

// From blue over yellow to red.
function heatColor(x, color) {
  const stops = [[0.17, 0.48, 0.71], [1, 1, 0.75], [0.84, 0.1, 0.11]];
  const k = x < 0.5 ? 0 : 1, rest = 2 * x - k;
  return color.setRGB(...[0, 1, 2].map(i => stops[k][i] + rest * (stops[k + 1][i] - stops[k][i])));
}
// Names that are close get hues that are not: the golden section spreads them.
function groupColor(name, color) {
  return color.setHSL(0.618034 * name % 1, 0.55, 0.45 + 0.2 * (0.754878 * name % 1));
}
// The name of each polygon's group after so many merges, and so many of others that follow them.
function groupsAfter(merges, steps, count, others = [], otherSteps = 0) {
  const parent = Uint32Array.from({length: count}, (_, k) => k);
  for (let k = 0; k < 2 * steps; k += 2) parent[merges[k + 1]] = merges[k];
  for (let k = 0; k < 2 * otherSteps; k += 2) parent[others[k + 1]] = others[k];
  // A parent is lower than its child, so one pass in this order leads all to the top.
  for (let k = 0; k < count; ++k) parent[k] = parent[parent[k]];
  return parent;
}
function coloredGroup(layer) {
  const geometry = geometryOf(layer).toNonIndexed(), of = numbersOf(layer.polygonOf, Uint32Array);
  const colors = new THREE.BufferAttribute(new Float32Array(9 * of.length), 3), color = new THREE.Color();
  geometry.setAttribute("color", colors);
  const count = of.reduce((most, k) => Math.max(most, k + 1), 0);
  const paint = colorOf => {
    of.forEach((polygon, t) => {
      colorOf(polygon);
      for (let k = 0; k < 3; ++k) colors.setXYZ(3 * t + k, color.r, color.g, color.b);
    });
    colors.needsUpdate = true;
  };
  const group = new THREE.Group();
  group.add(new THREE.Mesh(geometry, faceMaterial({...layer, color: "#ffffff"}, {vertexColors: true})));
  if (layer.heat) {
    const heat = numbersOf(layer.heat, Uint8Array);
    paint(polygon => heatColor(heat[polygon] / 255, color));
  }
  if (layer.merges) {
    const merges = numbersOf(layer.merges, Uint32Array), all = merges.length / 2;
    const joined = layer.joined ? numbersOf(layer.joined, Uint32Array) : [];
    const showAfter = (steps, joins = 0) => {
      const names = groupsAfter(merges, Math.max(0, Math.min(steps, all)), count, joined, joins);
      paint(polygon => groupColor(names[polygon], color));
    };
    if (layer.splits === undefined) {
      group.userData.merge = steps => {
        showAfter(steps);
        return steps;
      };
      showAfter(all);
    } else {
      group.userData.split = steps => {
        const splits = Math.min(steps, layer.splits);
        showAfter(all - splits, steps - splits);
        return joined.length > 0 ? `${splits} and ${steps - splits}` : splits;
      };
      group.userData.split(layer.splits + joined.length / 2);
    }
  }
  return group;
}

// --- surfaces and points ---------------------------------------------------------------------------

// Edges are thin prisms of four sides: WebGL draws lines one pixel wide only.
function prismsOf(pairs, points, thickness) {
  const corners = [], indices = [];
  const ends = [new THREE.Vector3(), new THREE.Vector3()], across = new THREE.Vector3();
  for (let k = 0; k < pairs.length; k += 2) {
    const first = corners.length / 3;
    ends.forEach((end, i) => end.fromBufferAttribute(points, pairs[k + i]));
    const along = new THREE.Vector3().subVectors(ends[1], ends[0]).normalize();
    across.set(along.z, along.x, along.y).cross(along);  // zero only if all three are equal
    if (across.lengthSq() < 1e-6) across.set(1, -1, 0);
    across.setLength(thickness);
    for (let side = 0; side < 4; ++side) {
      for (const end of ends) corners.push(end.x + across.x, end.y + across.y, end.z + across.z);
      const [a, b, c, d] = [0, 1, 2, 3].map(i => first + (2 * side + i) % 8);
      indices.push(a, b, c, c, b, d);
      across.applyAxisAngle(along, Math.PI / 2);
    }
  }
  const prisms = new THREE.BufferGeometry();
  prisms.setAttribute("position", new THREE.Float32BufferAttribute(corners, 3));
  prisms.setIndex(indices);
  return prisms;
}
function edgesOf(layer, points) {
  const pairs = indicesOf(layer, layer.edges);
  const prisms = prismsOf(pairs, points, pairs.length < 1000 ? 0.004 : 0.0015);
  return more => {
    const edges = new THREE.Mesh(prisms, new THREE.MeshBasicMaterial(
      {color: new THREE.Color(layer.color).multiplyScalar(0.55), side: THREE.DoubleSide, ...more}));
    edges.userData.areEdges = true;
    return edges;
  };
}

// Layers that can be seen through are drawn after the others, in the order of the list: faces that
// look away, edges, faces in front, edges once more. So edges behind a face are fainter than those in
// front.
function groupOf(layer, place) {
  if (layer.polygonOf) return coloredGroup(layer);
  const group = new THREE.Group(), clear = layer.opacity < 1;
  const geometry = geometryOf(layer), turning = layer.turning ? geometryOf(layer.turning) : geometry;
  const add = (object, order) => {
    object.renderOrder = clear ? 10 * place + order : 0;
    if (object.geometry === geometry) object.userData = {geometry, turning};
    group.add(object);
  };
  if (layer.triangles === undefined) {
    add(new THREE.Points(geometry, new THREE.PointsMaterial(
      {color: layer.color, size: 3.5, sizeAttenuation: false})), 0);
    return group;
  }
  const edges = layer.edges ? edgesOf(layer, geometry.attributes.position) : null;
  if (clear) {
    const seen = {transparent: true, depthWrite: false};
    add(new THREE.Mesh(geometry, faceMaterial(layer, {...seen, side: THREE.BackSide})), 0);
    if (edges) add(edges({...seen, opacity: 0.4}), 1);
    add(new THREE.Mesh(geometry, faceMaterial(layer, {...seen, side: THREE.FrontSide, depthWrite: true})), 2);
  } else {
    add(new THREE.Mesh(geometry, faceMaterial(layer, {})), 0);
  }
  if (edges) add(edges({transparent: clear}), 3);
  return group;
}

// --- a facet that is picked ------------------------------------------------------------------------

// White with a black rim, told from every colour of a layer by its lightness. It is drawn between the
// two sides of a layer that can be seen through, so it can be seen from behind, too.
function litFacet(corners, place) {
  const points = new THREE.BufferAttribute(new Float32Array(corners.flatMap(c => c.toArray())), 3);
  const face = new THREE.BufferGeometry(), pairs = [], fan = [];
  corners.forEach((_, k) => {
    pairs.push(k, (k + 1) % corners.length);
    if (k > 1) fan.push(0, k - 1, k);
  });
  face.setAttribute("position", points);
  face.setIndex(fan);
  const lit = new THREE.Group(), seen = {side: THREE.DoubleSide, transparent: true, depthWrite: false};
  lit.add(new THREE.Mesh(face, new THREE.MeshBasicMaterial({...seen, color: "#ffffff", opacity: 0.85})),
    new THREE.Mesh(prismsOf(pairs, points, 0.013), new THREE.MeshBasicMaterial({...seen, color: "#000000"})));
  for (const part of lit.children) part.renderOrder = 10 * place + 1.5;
  return lit;
}

// Opaque faces become glass, or what they were.
function setGlass(group, on) {
  group.traverse(part => {
    const material = part.material;
    if (!material?.uniforms?.opacity || (material.transparent && !material.userData.isGlass)) return;
    material.userData.isGlass = true;
    material.uniforms.opacity.value = on ? 0.3 : 1;
    material.transparent = on;
    material.depthWrite = !on;
  });
}

return {groupOf, litFacet, setGlass};
})();
