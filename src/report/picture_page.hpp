// SPDX-License-Identifier: MIT
// picture_page.hpp - the page that picture_html() fills in at the words between @ signs.
#pragma once

namespace convexact {

inline constexpr const char* kPicturePage = R"html(<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>@TITLE@</title>
<style>
  body { margin: 0; font: 15px/1.5 system-ui, sans-serif; color: #223; background: #f4f5f7; }
  header { padding: 12px 20px; }
  h1 { font-size: 18px; margin: 0; }
  canvas { display: block; margin: auto; width: min(96vw, 86vh); height: min(96vw, 86vh); cursor: grab; }
</style>
<header><h1>@HEADING@</h1>@CAPTION@ <em>Drag to turn, wheel to scale.</em></header>
<canvas width="1000" height="1000"></canvas>
<script>
"use strict";
// Input: x, y, z and normal (in hundredths) of each point. Proxy: corners and facets.
const points = [@POINTS@], corners = [@CORNERS@], facets = [@FACETS@], grid = 10000;
const canvas = document.querySelector("canvas"), pen = canvas.getContext("2d");
const size = canvas.width;
let turn = 0.6, tilt = 0.35, scale = 0.29 * size;

// Turns about the y axis, then tilts towards the viewer, who looks along -z.
function view(x, y, z) {
  const c = Math.cos(turn), s = Math.sin(turn), u = Math.cos(tilt), v = Math.sin(tilt);
  const a = c * x + s * z, b = c * z - s * x;
  return [a, u * y - v * b, v * y + u * b];
}

function drawPoints() {
  const image = pen.createImageData(size, size), depth = new Float32Array(size * size).fill(-1e9);
  const half = Math.max(1, Math.round(scale / 160));
  for (let i = 0; i < points.length; i += 6) {
    const [x, y, z] = view(points[i] / grid, points[i + 1] / grid, points[i + 2] / grid);
    const n = view(points[i + 3] / 99, points[i + 4] / 99, points[i + 5] / 99);
    if (n[2] < 0) continue;  // faces away; points without faces have no normal and are all drawn
    const light = 0.35 + 0.65 * Math.abs(0.3 * n[0] + 0.5 * n[1] + 0.81 * n[2]);
    const column = Math.round(size / 2 + scale * x), row = Math.round(size / 2 - scale * y);
    for (let r = row - half; r <= row + half; ++r) {
      for (let c = column - half; c <= column + half; ++c) {
        if (r < 0 || c < 0 || r >= size || c >= size || depth[r * size + c] > z) continue;
        depth[r * size + c] = z;
        image.data.set([205 * light, 150 * light, 90 * light, 255], 4 * (r * size + c));
      }
    }
  }
  pen.putImageData(image, 0, 0);
}

function drawFacets(front) {
  for (const facet of facets) {
    const seen = facet.map(k => view(corners[3 * k] / grid, corners[3 * k + 1] / grid, corners[3 * k + 2] / grid))
                      .map(([x, y]) => [size / 2 + scale * x, size / 2 - scale * y]);
    let area = 0;  // counter-clockwise on the page (y down: negative) means facing the viewer
    seen.forEach(([x, y], k) => { const [p, q] = seen[(k + 1) % seen.length]; area += x * q - p * y; });
    if ((area < 0) !== front) continue;
    pen.beginPath();
    seen.forEach(([x, y]) => pen.lineTo(x, y));
    pen.closePath();
    if (front) { pen.fillStyle = "rgba(60, 110, 200, 0.16)"; pen.fill(); }
    pen.strokeStyle = front ? "#1c4fa0" : "rgba(28, 79, 160, 0.35)";
    pen.lineWidth = front ? 2 : 1;
    pen.stroke();
  }
}

function draw() {
  drawPoints();
  pen.globalCompositeOperation = "destination-over";
  drawFacets(false);
  pen.globalCompositeOperation = "source-over";
  drawFacets(true);
}

canvas.onpointermove = event => {
  if (!event.buttons) return;
  turn += event.movementX / 150;
  tilt = Math.max(-1.6, Math.min(1.6, tilt + event.movementY / 150));
  draw();
};
canvas.onwheel = event => {
  event.preventDefault();
  scale *= Math.exp(-event.deltaY / 800);
  draw();
};
draw();
</script>
</html>
)html";

}  // namespace convexact
