// SPDX-License-Identifier: MIT
// A pane draws convex bodies, points, balls and arrows as SVG, which prints, needs no graphics card, and
// whose parts can be picked. All panes turn together: a dual point lies in the direction of its plane's
// normal, and that should be seen.
"use strict";

const camera = {
  turn: 0.6, tilt: 0.35, listeners: [],
  move(right, down) {
    this.turn += right;
    this.tilt = Math.max(-1.57, Math.min(1.57, this.tilt + down));
    for (const draw of this.listeners) draw();
  },
  // Three rows: to the right, up, towards the viewer.
  rows() {
    const [s, c] = [Math.sin(this.turn), Math.cos(this.turn)], [u, v] = [Math.sin(this.tilt), Math.cos(this.tilt)];
    return [[c, 0, s], [u * s, v, -u * c], [-v * s, u, v * c]];
  },
};

const times = (row, p) => row[0] * p[0] + row[1] * p[1] + row[2] * p[2];
const escaped = text => String(text).replace(/[&<>"]/g, c => ({"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;"})[c]);

class Pane {
  // What is picked goes to `pick` as the text of data-pick; a dot that can be dragged, to `drag` with the way that it
  // goes in space, parallel to the screen.
  constructor(figure, pick, drag) {
    this.svg = figure.querySelector("svg");
    this.items = [];
    this.zoom = 1;
    this.radius = 1;
    this.unit = null;
    camera.listeners.push(() => this.draw());
    this.follow(pick, drag);
  }

  // How long a drawn unit is in those of the input, for a scale bar.
  measureBy(unit) {
    this.unit = unit;
  }

  // What is to be seen, and the radius about the origin that must fit. Items are, from the outside to the inside:
  //   {faces: [{points, pick, mark, label}], mark}  a convex body, corners counter-clockwise from outside
  //   {dots: [{at, pick, drag, mark, label}]}, {lines: [{from, to, mark}]}, {ball: {at, radii}, mark}
  show(items, radius) {
    this.items = items;
    this.radius = radius || 1;
    this.draw();
  }

  // From the frame before to the one at hand, unless the reader prefers that nothing moves.
  zoomFrom(before) {
    const to = this.radius, items = this.items, from = performance.now();
    if (before === to || matchMedia("(prefers-reduced-motion: reduce)").matches) return;
    const frame = now => {
      if (this.items !== items) return;
      const share = Math.min(1, Math.max(0, (now - from) / 700));
      this.radius = before * (to / before) ** share;
      this.draw();
      if (share < 1) requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
  }

  draw() {
    const [right, up, near] = camera.rows(), scale = 180 * this.zoom / this.radius;
    const flat = p => [scale * times(right, p), -scale * times(up, p)];
    const text = ([x, y]) => `${x.toFixed(2)} ${y.toFixed(2)}`;
    const attributes = (kind, part) => `class="${kind} ${part.mark || ""}"` +
      (part.pick === undefined ? "" : ` data-pick="${escaped(part.pick)}"`) + (part.drag === undefined ? "" : ` data-drag="${escaped(part.drag)}"`);
    const labels = [], count = this.items.reduce((sum, item) => sum + (item.faces || []).length, 0);
    this.svg.classList.toggle("fine", count > 150);
    const label = (part, places) => {
      if (part.label !== undefined) labels.push({text: String(part.label), mark: part.mark || "", places});
    };
    const behind = [], within = [], front = [];
    for (const item of this.items) {
      const backs = [], fronts = [];
      for (const face of item.faces || []) {
        const corners = face.points.map(flat);
        let area = 0;
        corners.forEach(([x, y], k) => {
          const [u, v] = corners[(k + 1) % corners.length];
          area += x * v - u * y;
        });
        const isFront = area < 0;  // y points down
        const mark = {mark: `${item.mark || ""} ${face.mark || ""} ${isFront ? "front" : "back"}`, pick: isFront ? face.pick : undefined};
        (isFront ? fronts : backs).push(`<path ${attributes("face", mark)} d="M${corners.map(text).join("L")}z"/>`);
        label({...face, mark: mark.mark}, [[0, 1].map(k => corners.reduce((sum, p) => sum + p[k], 0) / corners.length)]);
      }
      behind.push(backs.join(""));
      front.unshift(fronts.join(""));
      for (const line of item.lines || []) {
        within.push(`<path ${attributes("line", line)} d="M${text(flat(line.from))}L${text(flat(line.to))}"/>`);
      }
      if (item.ball) within.push(this.outline(item, [right, up], scale, flat(item.ball.at)));
      for (let dot of item.dots || []) {
        const at = flat(dot.at);
        dot = {...dot, mark: `${dot.mark || ""} ${times(near, dot.at) < -1e-9 ? "far" : ""}`};
        within.push(`<circle ${attributes("dot", dot)} cx="${at[0].toFixed(2)}" cy="${at[1].toFixed(2)}" r="${dot.size || 4}"/>`);
        label(dot, [[7, -7], [-7, -7], [7, 16], [-7, 16]].map(([x, y]) => [at[0] + x, at[1] + y]));
      }
    }
    // Dots and lines can be seen through faces, so they may come last.
    const bar = this.bar(scale);
    this.svg.innerHTML = behind.join("") + front.join("") + within.join("") + bar.drawn + this.labels(labels, bar.boxes).join("");
  }

  // A length of one digit in the lower left corner, and the boxes that it takes; nothing without a unit.
  bar(scale) {
    const {x, y, height} = this.svg.viewBox.baseVal, most = 90 * this.unit / scale;
    if (!(most > 0 && isFinite(most))) return {drawn: "", boxes: []};
    const power = 10 ** Math.floor(Math.log10(most)), length = power * [5, 2, 1].find(digit => digit * power <= most || digit === 1);
    const width = length / this.unit * scale, text = String(Number(length.toPrecision(1))), left = x + 12, low = y + height - 12;
    const half = 4.1 * text.length + 2, middle = left + width + 6 + half;
    return {boxes: [[left, low - 16, middle + half, low + 6]], drawn: `<path class="bar" d="M${left} ${low - 4}v8m0 -4h${width.toFixed(2)}m0 -4v8"/>` +
      `<text class="bar" x="${middle.toFixed(1)}" y="${low + 4}">${escaped(text)}</text>`};
  }

  // Each where it covers no other one and lies in the pane; what is chosen goes first, what is hidden last, and what
  // finds no place is left out: the tables have all. Twice the same at one place is one.
  labels(wanted, taken) {
    const {x: left, y: top, width, height} = this.svg.viewBox.baseVal;
    const drawn = new Set();
    const rank = ({mark}) => /\bchosen\b/.test(mark) ? 0 : /\b(back|far)\b/.test(mark) ? 2 : 1;
    return [...wanted].sort((a, b) => rank(a) - rank(b)).flatMap(label => {
      const same = `${label.text} ${label.places[0].map(Math.round)}`;
      if (drawn.has(same)) return [];
      drawn.add(same);
      const size = rank(label) === 0 ? 16 : 13, half = 0.31 * size * label.text.length + 2;
      for (const place of label.places) {
        const x = Math.max(left + half, Math.min(left + width - half, place[0]));
        const y = Math.max(top + size, Math.min(top + height - 4, place[1]));
        const box = [x - half, y - size, x + half, y + 3];
        if (taken.some(other => box[0] < other[2] && other[0] < box[2] && box[1] < other[3] && other[1] < box[3])) continue;
        taken.push(box);
        return [`<text x="${x.toFixed(1)}" y="${y.toFixed(1)}" class="${label.mark}">${escaped(label.text)}</text>`];
      }
      return [];
    });
  }

  // A ball of the solid's space is an ellipsoid where axes are drawn to scales of their own. Its outline is the
  // ellipse {M u : |u| = 1} with M the two drawn rows, scaled.
  outline(item, rows, scale, [x, y]) {
    const m = rows.map(row => row.map((value, k) => scale * value * item.ball.radii[k]));
    const a = times(m[0], m[0]), b = -times(m[0], m[1]), c = times(m[1], m[1]);  // M M', y down
    const middle = (a + c) / 2, rest = Math.hypot((a - c) / 2, b), angle = Math.atan2(2 * b, a - c) / 2;
    return `<ellipse class="ball ${item.mark || ""}" rx="${Math.sqrt(middle + rest).toFixed(2)}" ry="${Math.sqrt(Math.max(0, middle - rest)).toFixed(2)}"` +
      ` transform="translate(${x.toFixed(2)} ${y.toFixed(2)}) rotate(${(angle * 180 / Math.PI).toFixed(2)})"/>`;
  }

  // A way on the screen, in space.
  inSpace(right, down) {
    const rows = camera.rows(), unit = this.svg.getScreenCTM().a * 180 * this.zoom / this.radius;
    return [0, 1, 2].map(k => (rows[0][k] * right - rows[1][k] * down) / unit);
  }

  // One finger or the mouse turns, two fingers zoom; a click that does not move picks.
  follow(pick, drag) {
    const fingers = new Map();
    let moved = 0, apart = 0, dragged = null;
    const span = () => {
      const [a, b] = [...fingers.values()];
      return Math.hypot(a[0] - b[0], a[1] - b[1]);
    };
    this.svg.onpointerdown = event => {
      fingers.set(event.pointerId, [event.clientX, event.clientY]);
      if (fingers.size === 1) [moved, dragged] = [0, event.target.dataset.drag ?? null];
      if (fingers.size === 2) apart = span();
    };
    this.svg.onpointermove = event => {
      const last = fingers.get(event.pointerId);
      if (!last) return;
      const by = [event.clientX - last[0], event.clientY - last[1]];
      fingers.set(event.pointerId, [event.clientX, event.clientY]);
      moved += Math.abs(by[0]) + Math.abs(by[1]);
      if (moved < 4) return;
      this.svg.setPointerCapture(event.pointerId);
      if (fingers.size === 2) {
        this.scale(span() / apart);
        apart = span();
      } else if (dragged !== null) {
        drag(dragged, this.inSpace(...by));
      } else if (fingers.size === 1) {
        camera.move(by[0] / 150, by[1] / 150);
      }
    };
    this.svg.onpointerup = this.svg.onpointercancel = event => fingers.delete(event.pointerId);
    this.svg.onclick = event => {
      const part = event.target.closest("[data-pick]");
      if (moved < 4) pick(part ? part.dataset.pick : null);
    };
    this.svg.onwheel = event => {
      if (document.activeElement !== this.svg) return;  // else the page scrolls
      event.preventDefault();
      this.scale(Math.exp(-event.deltaY / 800));
    };
    const keys = {ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1]};
    this.svg.onkeydown = event => {
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      if (keys[event.key]) camera.move(...keys[event.key]);
      else if (event.key === "+" || event.key === "=") this.scale(1.1);
      else if (event.key === "-") this.scale(1 / 1.1);
      else return;
      event.preventDefault();
      event.stopPropagation();
    };
  }

  scale(factor) {
    this.zoom = Math.max(0.2, Math.min(1e4, this.zoom * factor));
    this.draw();
  }
}
