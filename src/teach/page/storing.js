// SPDX-License-Identifier: MIT
// The chapter on storing: what rounding to nearest would cut off, magnified until one sees the numbers of the format.
"use strict";

// A ruler along a plane's normal: where the input ends, where the plane would be if its offset were rounded to nearest,
// and where it is stored. Positions are exact until they are drawn, in steps of the format.
function ruler(stored, magnify) {
  const step = Rational.of(stored.ulp), origin = Rational.of(stored.support);
  const place = x => x.minus(origin).over(step);  // in steps, outward
  const width = 10 ** magnify * 6, scale = 360 / width, x = steps => -60 + steps * scale;
  const nearest = place(Rational.of(stored.naive).negated()).toNumber(), kept = place(Rational.of(stored.stored).negated()).toNumber();
  const parts = [`<rect class="inside" x="-200" y="-70" width="${(140).toFixed(2)}" height="140"/>`];
  if (width < 200) {
    // A stored number is a multiple of the step.
    const offset = Rational.of(stored.stored).negated().minus(origin).over(step).toNumber();
    for (let t = Math.ceil(-140 / scale - offset); t <= Math.floor(260 / scale - offset); ++t) {
      parts.push(`<path class="tick" d="M${x(t + offset).toFixed(2)} 70V${84}"/>`);
    }
  }
  const line = (steps, name, text, y) => Math.abs(x(steps)) > 199 ? "" : `<path class="${name}" d="M${x(steps).toFixed(2)} -90V84"/><text class="${name}" x="${x(steps).toFixed(2)}" y="${y}">${text}</text>`;
  parts.push(line(0, "needed", "the input ends", -96), line(nearest, "lost", "nearest", -112), line(kept, "new", "stored", -128));
  return `<svg class="ruler" viewBox="-200 -150 400 250" role="img" aria-label="A ruler along the normal"><g>${parts.join("")}</g></svg>`;
}

function storingChapter(storing) {
  const digits = storing.precision === "binary32" ? 24 : 53;
  const cut = storing.planes.filter(p => p.cut !== "0").length, end = lesson.removals ? surfaceAfter(lesson.removals.length) : null;
  const panes = (i, note) => ({solid: {items: end ? [solidItem(end, i === undefined ? {} : {[i]: "chosen"})] : [], note},
    dual: {items: end ? [dualItem(end, i === undefined ? {} : {[i]: "chosen"})] : []}});
  // Planes that are stored as they are teach nothing about rounding.
  const rounded = storing.planes.map((p, n) => ({p, n})).filter(({p}) => p.cut !== "0" || p.normal.some((x, k) => x !== p.scaled[k]) ||
    p.stored !== p.scaled[3]);
  const steps = [{id: "storing", title: "Numbers of a format", show: () => ({
    say: `A file holds numbers of a format, here ${storing.precision}, floating point with ${digits} binary digits, and most exact planes cannot be written in it. ${storing.naive_outside ? `Rounding each of their numbers to the nearest one would cut ${many(storing.naive_outside, "input point")} off.` : rounded.length ? "Here rounding to nearest happens to cut no input point off, but in general it does." : "Here every plane fits the format exactly, so nothing has to be pushed."}${rounded.length ? " So the normals are rounded first, and then each plane is pushed outward: its offset d is lowered to the next number with which it holds every input point." : ""}`,
    ...panes(),
    more: `<p>${cut} of ${storing.planes.length} planes would cut into the input if their offset were the nearest number. ${storing.push === null ? "How far the push moved the solid is beyond the largest double." : storing.push === 0 ? "The stored solid is the exact one." : `The push moved the solid by at most ${storing.push.toExponential(2)} of the input's diameter, and its volume is at most ${storing.volume_ratio} times the exact one.`} Normals are scaled by powers of two, to a largest entry of at least 1/2 and below 1, which moves no plane: so no number is too large for the format.</p>` +
      (storing.mesh ? `<p>The solid can be stored by its corners, too, as a mesh. If each corner is rounded to nearest, the hull of the corners leaves ${many(storing.mesh.naive_outside, "input point")} out; the mesh that the program stores leaves out none.</p>` : "") +
      table(["halfspace", "stored normal", "stored offset", "what nearest would cut off"], storing.planes.map((p, n) => row([`<button type="button" class="link" data-pick="h${p.halfspace}">${p.halfspace}</button>`,
        triple(`/storing/planes/${n}/normal`) + (p.turned ? " (turned)" : ""), number(`/storing/planes/${n}/stored`), number(`/storing/planes/${n}/cut`)])), "Stored planes"),
  })}];
  rounded.forEach(({p, n}) => steps.push({id: `storing-${n + 1}`, title: `Plane ${p.halfspace}, stored`, show: () => {
    const at = `/storing/planes/${n}`, needed = Rational.of(p.support).negated(), isEqual = p.stored === p.naive;
    const magnify = state.magnified ?? (isEqual ? 0 : 0.3);
    return {
      say: `Plane ${tag(p.halfspace)}: the farthest input point along its rounded normal asks for an offset of at most ${computed(needed)}. ${isEqual ? "The nearest number is small enough already, and it is stored."
        : p.cut === "0" ? "The offset rounded to nearest would do; the stored one fits more closely." : `The exact offset rounded to nearest is ${number(`${at}/naive`)}: it would cut ${number(`${at}/cut`)} off. Stored is ${number(`${at}/stored`)}.`}`,
      ...panes(p.halfspace, "The plane is lit."), picture: `<label>Magnify <input type="range" data-magnify min="-5" max="80" value="${Math.round(80 - 10 * magnify)}"></label>` + ruler(p, magnify),
      more: formula(word("support"), mo("="), word("max"), mi("n"), mo("\u00b7"), mi("x"), mo("="), math(`${at}/support`)) +
        formula(mi("d"), mo("\u2264"), mo("\u2212"), word("support"), mo("="), mathOf(needed)) +
        `<p>It is attained at ${triple(`${at}/witness`)}. Stored: ${number(`${at}/stored`)}. Neighbouring numbers of the format are ${number(`${at}/ulp`)} apart there; the ticks of the ruler are such numbers.</p>` +
        `<p>Does the stored plane hold the input? stored + support = ${computed(Rational.of(p.stored).plus(Rational.of(p.support)))} \u2264 0: ${verdict(Rational.of(p.stored).plus(Rational.of(p.support)).sign() <= 0)}</p>`,
    };
  }}));
  return steps;
}
