// SPDX-License-Identifier: MIT
// requests.js - requests as lines of JSON, and answers as objects; numbers without loss in both directions.

// JSON has no NaN and no infinity; as texts they get the answer that names their place.
const spelled = x => Number.isFinite(x) || typeof x === "string" ? JSON.stringify(x) : `"${x}"`;

/** Rows of numbers as JSON, from a flat typed array or from rows. */
export function rows(numbers, width, what) {
  if (ArrayBuffer.isView(numbers)) {
    if (numbers.length % width !== 0) throw fault(`${what}: ${numbers.length} numbers are no rows of ${width}`);
    const texts = [];
    for (let k = 0; k < numbers.length; k += width) {
      texts.push(`[${Array.from(numbers.subarray(k, k + width), spelled).join()}]`);
    }
    return `[${texts.join()}]`;
  }
  if (!Array.isArray(numbers)) throw fault(`${what}: expected a typed array, or an array of rows`);
  const row = r => Array.isArray(r) || ArrayBuffer.isView(r) ? `[${Array.from(r, spelled).join()}]` : JSON.stringify(r) ?? "null";
  return `[${numbers.map(row).join()}]`;
}

export function fault(sentence, kind = "invalid-argument") {
  return Object.assign(new Error(sentence), {kind, sentence});
}

const isPoints = shape => ArrayBuffer.isView(shape) || Array.isArray(shape);

// The entries of a request that spell a shape, as text.
function shapeEntries(shape) {
  if (isPoints(shape)) return [`"points":${rows(shape, 3, "points")}`];
  if (shape?.planes) return [`"planes":${rows(shape.planes, 4, "planes")}`];
  if (!shape?.points) throw fault("expected points, {points, triangles}, or {planes}");
  const entries = [`"points":${rows(shape.points, 3, "points")}`];
  if (shape.triangles?.length > 0) entries.push(`"triangles":${rows(shape.triangles, 3, "triangles")}`);
  return entries;
}

function solidText(solid) {
  if (isPoints(solid)) return `{"vertices":${rows(solid, 3, "vertices")}}`;
  if (solid?.planes) return `{"planes":${rows(solid.planes, 4, "planes")}}`;
  const vertices = solid?.vertices ?? solid?.points, faces = solid?.faces ?? solid?.triangles;
  if (!vertices) throw fault("a candidate: expected points, {vertices, faces}, {planes}, or {parts}");
  const name = solid.name === undefined ? "" : `"name":${JSON.stringify(String(solid.name))},`;
  return `{${name}"vertices":${rows(vertices, 3, "vertices")}${faces?.length > 0 ? `,"faces":${rows(faces, 3, "faces")}` : ""}}`;
}

function candidateText(candidate) {
  if (!candidate?.parts) return solidText(candidate);
  // A document of a decomposition is taken as it is: it says more about its parts.
  if (candidate.decomposition !== undefined) return JSON.stringify(candidate, (key, x) => key === "picture" ? undefined : x);
  return `{"parts":[${candidate.parts.map(solidText).join()}]}`;
}

/** A request as a line. */
export function line({shape, candidate, options = {}}) {
  const entries = shapeEntries(shape);
  if (candidate !== undefined) entries.push(`"candidate":${candidateText(candidate)}`);
  for (const [key, value] of Object.entries(options)) {
    if (value !== undefined) entries.push(`${JSON.stringify(key)}:${JSON.stringify(value)}`);
  }
  return `{${entries.join()}}`;
}

/** The double nearest to a number as answers spell it: digits, or "p/q". Ties go to the even one. */
export function toNumber(text) {
  if (typeof text === "number") return text;
  const [p, q = "1"] = text.split("/");
  let over = BigInt(p), under = BigInt(q);
  const sign = over < 0n ? -1 : 1;
  if (over < 0n) over = -over;
  if (over === 0n) return 0;
  const bits = x => x.toString(2).length;
  // A quotient of 55 bits or more; what is left over makes it odd, so that no tie is seen where there is none.
  let shift = Math.min(55 - (bits(over) - bits(under)), 1076);
  if (shift >= 0) over <<= BigInt(shift); else under <<= BigInt(-shift);
  let quotient = over / under;
  if (over % under !== 0n) quotient |= 1n;
  // To the bits that a double of this size has, the even one on a tie.
  const least = Math.max(bits(quotient) - 53, shift - 1074);
  if (least > 0) {
    const unit = 1n << BigInt(least), rest = quotient % unit, half = unit >> 1n;
    quotient -= rest;
    if (rest > half || (rest === half && (quotient / unit) % 2n === 1n)) quotient += unit;
  }
  let value = Number(quotient);
  for (; shift > 1000; shift -= 1000) value /= 2 ** 1000;  // exact: the bits are as few as the result has
  for (; shift < -1000; shift += 1000) value *= 2 ** 1000;
  return sign * value / 2 ** shift;
}

// STL and GLB are bytes, in base64.
function withBytes(files) {
  for (const [name, file] of Object.entries(files ?? {})) {
    if (file.base64 !== undefined) files[name] = Uint8Array.from(atob(file.base64), letter => letter.charCodeAt(0));
  }
}

// Each object of a file as a solid with corners of its own.
function solids(objects, points, triangles) {
  return objects.map(({name, first, end, loose}) => {
    const faces = triangles.slice(first, end);
    const used = [...new Set([...faces.flat(), ...loose])], place = new Map(used.map((point, k) => [point, k]));
    const vertices = Float64Array.from(used.flatMap(point => Array.from(points.subarray(3 * point, 3 * point + 3))));
    return {name, vertices, faces: faces.map(face => face.map(point => place.get(point)))};
  });
}

const flat = table => table && Float64Array.from(table.flat(), toNumber);

/** The answer as an object: tables of doubles as Float64Array, exact numbers as they are spelled. */
export function parsed(kind, text) {
  const answer = typeof text === "string" ? JSON.parse(text) : text;
  if (answer.error) return answer;
  withBytes(answer.files);
  if (kind === "read" && answer.points) {
    const {triangles, objects} = answer, points = answer.points = flat(answer.points);
    answer.objects = objects ? solids(objects, points, triangles) : [{name: "", vertices: points, faces: triangles}];
  }
  if (kind === "hull") answer.points = flat(answer.vertices);
  if (kind === "simplify" && !answer.inner) answer.planes = flat(answer.output.planes_in_doubles);
  if (kind === "verify") {
    answer.ok = answer.verdict === "holds";
    const first = answer.claims.find(claim => claim.status === "violated" || claim.status === "undecided");
    answer.sentence = first?.sentence ?? (answer.ok ? "every claim holds" : "not all claims hold");
  }
  return answer;
}
