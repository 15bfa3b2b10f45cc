// SPDX-License-Identifier: MIT
// conform.js - a function of the caller over inputs with known answers, judged exactly.

/**
 * @param program  From the points of an input (Float64Array, x y z) to a candidate, or a promise of one.
 * @param options  `asks`: "hull" or "enclosure"; `only`: beginnings of names; `level`: the hardest one, 1 to 3;
 *                 `tolerance` as for verify().
 */
export async function conform(cx, vectors, program, {asks = "hull", only = [""], level = 3, tolerance} = {}) {
  const results = [];
  for (const vector of vectors) {
    if (vector.level > level || !only.some(name => vector.id.startsWith(name))) continue;
    const points = Float64Array.from(vector.points);
    const result = {id: vector.id, level: vector.level, points, ok: false};
    results.push(result);
    try {
      result.candidate = await program(points.slice());
    } catch (error) {
      result.sentence = `threw ${error}`;
      continue;
    }
    try {
      const verdict = await cx.verify(points, result.candidate, {asks, tolerance});
      Object.assign(result, {ok: verdict.ok, sentence: verdict.sentence, verdict});
    } catch (error) {
      if (error.kind === undefined || error.kind === "stopped") throw error;
      result.sentence = error.sentence;
    }
  }
  const failures = results.filter(result => !result.ok);
  return {ok: failures.length === 0, passed: results.length - failures.length, results, failures};
}
