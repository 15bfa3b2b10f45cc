// SPDX-License-Identifier: MIT
// Exact rationals, so that the page can put the numbers of a step into its formulas and check them.
"use strict";

const kLarge = 1n << 20000n;  // of larger numbers a common divisor takes longer than it saves

class Rational {
  // n / d, d != 0.
  constructor(n, d = 1n) {
    [this.n, this.d] = d < 0n ? [-n, -d] : [n, d];
    if (this.d !== 1n && this.d < kLarge) this.reduce();
  }
  // Of a number in lowest terms.
  static of(text) {
    const [n, d = "1"] = String(text).split("/"), x = new Rational(BigInt(n));
    x.d = BigInt(d);
    return x;
  }
  reduce() {
    let a = this.n < 0n ? -this.n : this.n, b = this.d;
    while (b) [a, b] = [b, a % b];
    this.n /= a;
    this.d /= a;
    return this;
  }
  plus(x) { return new Rational(this.n * x.d + x.n * this.d, this.d * x.d); }
  minus(x) { return new Rational(this.n * x.d - x.n * this.d, this.d * x.d); }
  times(x) { return new Rational(this.n * x.n, this.d * x.d); }
  over(x) { return new Rational(this.n * x.d, this.d * x.n); }
  negated() { return new Rational(-this.n, this.d); }
  sign() { return this.n > 0n ? 1 : this.n < 0n ? -1 : 0; }
  compare(x) {
    const a = this.n * x.d, b = x.n * this.d;
    return a > b ? 1 : a < b ? -1 : 0;
  }
  toString() {
    this.reduce();
    return this.d === 1n ? String(this.n) : `${this.n}/${this.d}`;
  }
  // The first significant digits, cut off, not rounded: each one is a digit of the number, and dots say
  // that there are more.
  decimal(digits) {
    if (this.n === 0n) return "0";
    const n = this.n < 0n ? -this.n : this.n;
    const shifted = e => e >= 0 ? [n, this.d * 10n ** BigInt(e)] : [n * 10n ** BigInt(-e), this.d];
    let exponent = String(n).length - String(this.d).length;  // of the first digit, or one more
    if (shifted(exponent).reduce((a, b) => a < b)) --exponent;
    const [top, bottom] = shifted(exponent - digits + 1), isAll = top % bottom === 0n;
    let text = String(top / bottom), point = exponent + 1, power = "";
    if (exponent < -5 || exponent >= digits) {
      power = `e${exponent}`;
      point = 1;
    }
    if (point < 1) [text, point] = ["0".repeat(1 - point) + text, 1];
    const rest = isAll ? text.slice(point).replace(/0+$/, "") : text.slice(point);
    return (this.n < 0n ? "\u2212" : "") + text.slice(0, point) + (rest && "." + rest) + (isAll ? "" : "\u2026") + power;
  }
  // The nearest double but for a unit or so of its last place; for drawing, and to show what doubles make of it.
  toNumber() {
    const n = this.n < 0n ? -this.n : this.n;
    if (n === 0n) return 0;
    const shift = n.toString(2).length - this.d.toString(2).length - 60;
    const q = shift >= 0 ? n / (this.d << BigInt(shift)) : (n << BigInt(-shift)) / this.d;
    const x = Number(q) * 2 ** Math.max(shift, -1000) * 2 ** Math.min(0, shift + 1000);
    return this.n < 0n ? -x : x;
  }
}

const dot = (a, b) => a.reduce((sum, x, k) => sum.plus(x.times(b[k])), new Rational(0n));
const cross = (a, b) => [0, 1, 2].map(k => {
  const i = (k + 1) % 3, j = (k + 2) % 3;
  return a[i].times(b[j]).minus(a[j].times(b[i]));
});
const det = (a, b, c) => dot(a, cross(b, c));
const vector = texts => texts.map(Rational.of);
const difference = (a, b) => a.map((x, k) => x.minus(b[k]));
// Of four rows of four.
const det4 = rows => rows.reduce((sum, row, k) => {
  const rest = rows.filter((_, i) => i !== k).map(r => r.slice(0, 3));
  const term = row[3].times(det(...rest));
  return k % 2 ? sum.plus(term) : sum.minus(term);
}, new Rational(0n));
