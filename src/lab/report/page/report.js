// SPDX-License-Identifier: MIT
// Draws the report that the element #data carries: plots by Chart.js, tables of the same numbers.
"use strict";
const data = JSON.parse(document.getElementById("data").textContent);
const kExact = 4096;  // where a plot of correct bits shows what has no error at all
const kQuantities = [
  ["cost_worst", "costs, worst"], ["cost_median", "costs, median"], ["volume", "volume"],
  ["planes", "plane coordinates"], ["outside", "points outside"]];
const kWidestLaw = 0.3;  // an exponent that is known to 0.3
const kRuns = ["float", "filtered", "exact", "everything"];

// --- numbers and elements -----------------------------------------------------------------------

function text(x) {
  if (x === null || x === undefined) return "–";
  if (typeof x !== "number") return String(x);
  if (Number.isInteger(x) && Math.abs(x) < 1e6) return String(x);
  const size = Math.abs(x);
  const [digits, power] = x.toExponential(3).split("e");
  return size < 1e-3 || size >= 1e6 ? `${Number(digits)}e${Number(power)}` : String(Number(x.toPrecision(4)));
}
const seconds = x => x < 1e-3 ? `${text(x * 1e6)} µs` : x < 1 ? `${text(x * 1e3)} ms` : `${text(x)} s`;
const spread = s => s ? `${seconds(s.median)} (${seconds(s.least)} to ${seconds(s.most)}, ${s.repetitions}×)` : "over budget";
const errorText = e => !e ? "none computed" : e.bits === null ? "none" : `${text(e.value)} (${text(e.bits)} bits)`;

function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

// A cell that shows the number at a JSON pointer of the data, or at a place below `base`.
function at(pointer) {
  return pointer.split("/").slice(1).reduce((x, key) => x === null || x === undefined ? x : x[key], data);
}
function numberCell(pointer) {
  return element("td", {"data-pointer": pointer}, text(at(pointer)));
}
function wordsCell(words) { return element("td", {class: "words"}, words); }

// rows: arrays whose first entry is the row's heading, the others cells.
function table(caption, heads, rows) {
  const body = element("tbody");
  for (const [head, ...cells] of rows) {
    body.append(element("tr", {}, element("th", {scope: "row"}, text(head)), ...cells));
  }
  const head = element("tr", {}, ...heads.map(h => element("th", {scope: "col"}, h)));
  return element("div", {class: "scroll", tabindex: "0", role: "region", "aria-label": caption},
    element("table", {}, element("caption", {}, caption), element("thead", {}, head), body));
}
const spreadHeads = ["least, s", "median, s", "most, s", "repetitions"];
const spreadCells = pointer => ["least", "median", "most", "repetitions"].map(k => numberCell(`${pointer}/${k}`));

// --- colours, and plots that follow them ---------------------------------------------------------

const colour = name => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
const kMarks = ["circle", "rect", "triangle", "rectRot", "star", "crossRot", "rectRounded", "cross", "circle"];
const plots = [];  // {canvas, configure, chart}

// Whiskers from the least to the most of repeated measurements.
const whiskers = {
  id: "whiskers",
  afterDatasetsDraw(chart) {
    const {ctx, chartArea: area} = chart;
    chart.data.datasets.forEach((set, index) => {
      if (!chart.isDatasetVisible(index) || set.bare) return;
      const meta = chart.getDatasetMeta(index);
      set.data.forEach((point, i) => {
        if (!point || !point.spread) return;
        const along = point.spread.axis, scale = chart.scales[along];
        const [from, to] = [point.spread.least, point.spread.most].map(v => scale.getPixelForValue(v));
        const {x, y} = meta.data[i].getProps(["x", "y"], true);
        if (x < area.left - 1 || x > area.right + 1) return;
        ctx.save();
        ctx.strokeStyle = typeof set.borderColor === "string" ? set.borderColor : colour("ink");
        ctx.lineWidth = 1.2;
        ctx.beginPath();
        for (const end of [from, to]) {
          if (along === "y") { ctx.moveTo(x - 4, end); ctx.lineTo(x + 4, end); }
          else { ctx.moveTo(end, y - 4); ctx.lineTo(end, y + 4); }
        }
        if (along === "y") { ctx.moveTo(x, from); ctx.lineTo(x, to); } else { ctx.moveTo(from, y); ctx.lineTo(to, y); }
        ctx.stroke();
        ctx.restore();
      });
    });
  }
};

// Names beside the points of a dataset that asks for it: each in the first of these places that no mark and no
// other name has; where there is none, farther off, with a line that leads there. Boxes are [left, top, right,
// bottom].
const kPlaces = [[1, -1], [1, 1], [-1, -1], [-1, 1], [0, -1], [0, 1], [1, 0], [-1, 0]];
const meet = (a, b) => a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3];
const around = mark => [mark.x - 7, mark.y - 7, mark.x + 7, mark.y + 7];
function placeOf(mark, width, taken, area) {
  for (const away of [9, 16, 26, 40, 60, 84]) {
    for (const [right, down] of kPlaces) {
      const x = mark.x + right * away - (right < 0 ? width : right === 0 ? width / 2 : 0), y = mark.y + down * away - 7;
      const box = [x - 1, y, x + width + 1, y + 14];
      const isInside = box[0] >= area.left && box[2] <= area.right && box[1] >= area.top && box[3] <= area.bottom;
      if (isInside && !taken.some(other => meet(box, other))) return {box, far: away > 9};
    }
  }
  return null;
}
const names = {
  id: "names",
  afterDatasetsDraw(chart) {
    const {ctx, chartArea: area} = chart, visible = chart.data.datasets.map((set, k) => [set, k]).filter(([, k]) => chart.isDatasetVisible(k));
    const marks = visible.filter(([set]) => !set.line).flatMap(([, k]) => chart.getDatasetMeta(k).data).filter(mark => Number.isFinite(mark.x));
    const taken = marks.map(around);
    chart.named = [];  // for whoever asks where they are
    ctx.save();
    ctx.fillStyle = colour("ink");
    ctx.strokeStyle = colour("quiet");
    ctx.font = "12px system-ui, DejaVu Sans, sans-serif";
    ctx.textBaseline = "middle";
    ctx.textAlign = "left";
    for (const [set, k] of visible.filter(([set]) => set.named)) {
      chart.getDatasetMeta(k).data.forEach((mark, i) => {
        const name = set.data[i].name, place = placeOf(mark, ctx.measureText(name).width, taken, area);
        if (!place) return;  // the table below has all
        taken.push(place.box);
        chart.named.push({name, box: place.box});
        const middle = (place.box[1] + place.box[3]) / 2;
        ctx.fillText(name, place.box[0] + 1, middle);
        if (!place.far) return;
        ctx.beginPath();
        ctx.moveTo(mark.x, mark.y);
        ctx.lineTo(mark.x < place.box[0] ? place.box[0] : mark.x > place.box[2] ? place.box[2] : mark.x,
          mark.y < place.box[1] ? place.box[1] : mark.y > place.box[3] ? place.box[3] : middle);
        ctx.stroke();
      });
    }
    ctx.restore();
    chart.marks = marks.map(({x, y}) => [x, y]);
  }
};

const powerTick = x => {
  const power = Math.log10(x);
  return Math.abs(power - Math.round(power)) < 1e-9 ? (x >= 0.001 && x <= 10000 ? String(Number(x.toPrecision(1))) : `1e${Math.round(power)}`) : "";
};
// The least of 1, 1.5, 2, 3, 4, 5, 6, 8 times a power of ten that is not below.
function roundAbove(x) {
  const power = 10 ** Math.floor(Math.log10(x));
  return power * [1, 1.5, 2, 3, 4, 5, 6, 8, 10].find(k => k * power >= 0.9999999 * x);
}
const secondsTick = x => powerTick(x) === "" ? "" : seconds(x);
const countTick = x => [1, 2, 5].includes(Number((x / 10 ** Math.floor(Math.log10(x))).toPrecision(6))) ? String(x) : "";
const kBitTicks = [1, 2, 4, 8, 16, 24, 53, 113, 256, 1024, kExact];
const bits = e => !e ? null : e.bits === null ? kExact : Math.max(1, e.bits);

function axis(title, options = {}) {
  return {
    type: "logarithmic", title: {display: true, text: title, color: colour("ink")},
    grid: {color: colour("line")}, border: {color: colour("quiet")},
    ...options,
    ticks: {color: colour("quiet"), callback: powerTick, maxRotation: 0, ...options.ticks}
  };
}
// Of times: with room for all whiskers.
function secondsAxis(title, spreads) {
  const least = Math.max(1e-7, Math.min(...spreads.map(s => s.least).filter(x => x > 0)));
  const most = Math.max(...spreads.map(s => s.most));
  return axis(title, {min: least / 1.3, max: most * 1.3, ticks: {callback: secondsTick}});
}
const bitsAxis = title => axis(title, {
  min: 1, max: kExact * 1.4,
  afterBuildTicks: scale => { scale.ticks = kBitTicks.map(value => ({value})); },
  ticks: {callback: x => x === kExact ? "exact" : String(x), autoSkip: false}
});

function series(label, index, points, options = {}) {
  const own = colour(`c${index % 9}`);
  return {
    label, data: points, borderColor: own, backgroundColor: own, pointStyle: kMarks[index % 9],
    pointRadius: 5, pointHoverRadius: 7, pointBorderWidth: 2, borderWidth: 1.5, ...options
  };
}

function options(scales, lines, more = {}) {
  return {
    responsive: true, maintainAspectRatio: false, animation: false, parsing: false, normalized: true,
    interaction: {mode: "nearest", intersect: true},
    scales,
    plugins: {
      legend: {position: "bottom", labels: {color: colour("ink"), usePointStyle: true, boxHeight: 7}},
      tooltip: {callbacks: {title: () => "", label: item => lines(item.raw, item.dataset)}},
      ...more
    }
  };
}

function draw(plot) {
  if (plot.chart) plot.chart.destroy();
  plot.chart = new Chart(plot.canvas, {plugins: [whiskers, names], ...plot.configure()});
}

let figures = 0;
// made: {commands}; tables are shown below <details>.
function figure(parent, {title, short = title, how, made, configure, tables, wide}) {
  const id = `figure-${++figures}`;
  const canvas = element("canvas", {role: "img", "aria-label": `${title}. ${how}`, id: `${id}-plot`});
  const commands = element("p", {class: "made"}, "Made by ");
  made.forEach((command, i) => commands.append(i ? " and, for single numbers, " : "", element("code", {}, command)));
  commands.append(`. Up to ${data.request.repetitions} repetitions; ${machine()}.`);
  const box = element("figure", {id, class: wide ? "wide" : "", "data-short": short},
    element("figcaption", {}, element("h3", {}, title), element("p", {}, how)),
    element("div", {class: "plot"}, canvas),
    element("details", {}, element("summary", {}, "The same numbers as a table"), ...tables), commands);
  parent.append(box);
  plots.push({canvas, configure});
  return id;
}

function machine() {
  const o = data.origin;
  return `${o.processor}, ${o.cores} cores, ${(o.memory / 2 ** 30).toFixed(0)} GiB; ${o.compiler}, ${o.flags}; commit ${o.commit}`;
}

// --- error against time --------------------------------------------------------------------------

function wayTables(ways, base) {
  const done = ways.map((way, i) => [way, `${base}/${i}`]);
  const errors = done.filter(([way]) => way.seconds).map(([way, p]) => [way.way,
    ...kQuantities.flatMap(([key]) => [numberCell(`${p}/${key}/value`), numberCell(`${p}/${key}/bits`)])]);
  const order = done.filter(([way]) => way.seconds).map(([way, p]) => [way.way, numberCell(`${p}/left`),
    wordsCell(way.stop), numberCell(`${p}/first_other`), wordsCell(way.first_other === null ? "–" : way.is_tied ? "equal costs" : "different costs"),
    numberCell(`${p}/first_wrong/step`), numberCell(`${p}/first_wrong/regret`), numberCell(`${p}/excess`),
    wordsCell(way.agrees_with_c === undefined ? "–" : way.agrees_with_c ? "yes, bit for bit" : "NO")]);
  const times = done.map(([way, p]) => [way.way, ...(way.seconds ? spreadCells(`${p}/seconds`) : [wordsCell("over budget")])]);
  return [
    table("Relative errors; bits: how many are right", ["way", ...kQuantities.flatMap(([, name]) => [name, "bits"])], errors),
    table("Order of removal. Steps count from 0; excess: volume at the end over that of exact, minus 1",
      ["way", "left", "end", "first other step", "there", "first wrong step", "regret there", "excess", "agrees with C"], order),
    table("Time of the removals", ["way", ...spreadHeads], times)];
}

function precisionFigure(parent, input, base) {
  const {ways, reference, commands} = input.precision;
  figure(parent, {
    title: `Error against time: ${input.name}`, short: "Error against time",
    how: "Each mark is one way of computing: marks further right have more correct bits, and lower marks are faster. " +
      (reference === "exact" ? "Errors are against the rationals of the exact engine." : "Errors are against the exact rationals of the filtered engine, because the exact one took longer than the budget."),
    made: commands, wide: true, tables: wayTables(ways, `${base}/precision/ways`),
    configure: () => ({
      type: "scatter",
      data: {datasets: kQuantities.map(([key, label], k) => series(label, k,
        ways.flatMap((way, i) => way.seconds && way[key] ? [{
          x: bits(way[key]), y: way.seconds.median, name: way.way, way, error: way[key],
          spread: {axis: "y", ...way.seconds}, pointer: `${base}/precision/ways/${i}/seconds/median`}] : []),
        {named: key === "cost_worst", showLine: false}))},
      options: options({x: bitsAxis("correct bits"), y: secondsAxis("time of the removals", ways.map(way => way.seconds).filter(s => s))},
        (p, set) => [`${p.name}: ${set.label}`, `error ${errorText(p.error)}`, spread(p.way.seconds)])
    })
  });
}

function excessText(excess) {
  if (Math.abs(excess) < 1e-12) return "its result is equal to that of exact in volume, to 12 digits";
  return `its result is ${text(Math.abs(excess) * 100)}% ${excess > 0 ? "larger" : "smaller"} than that of exact`;
}

// What every way did to the order, in words.
function orderSummary(input) {
  const list = element("ul");
  for (const way of input.precision.ways) {
    let words = "removes what exact removes, step by step";
    if (!way.seconds) words = "took longer than the budget";
    else if (way.first_wrong) words = `first removes a halfspace that is not the cheapest in step ${way.first_wrong.step + 1}, with a regret of ${text(way.first_wrong.regret)}; ${excessText(way.excess)}`;
    else if (way.first_other !== null) words = `chooses among equal costs differently from step ${way.first_other + 1} on; each choice is one of the cheapest`;
    if (way.seconds && way.left > data.request.faces) words += `; ends with ${way.left} halfspaces, because every further removal is unbounded or uncertain`;
    if (way.agrees_with_c !== undefined) words += `; ${way.agrees_with_c ? "agrees bit for bit" : "DOES NOT AGREE"} with the same loop in C's ${way.bits === 24 ? "float" : "double"}`;
    list.append(element("li", {}, element("b", {}, way.way), `: ${words}.`));
  }
  return list;
}

// --- tightness ------------------------------------------------------------------------------------

function tightnessFigures(parent, input, base) {
  const {points, commands} = input.tightness;
  const measure = input.tightness.measure.replace("-", " "), growth = `growth of ${measure}`;
  const p = `${base}/tightness/points`;
  const tables = () => [table("Tightness of k halfspaces", ["k", growth, "Hausdorff distance / diameter", ...spreadHeads],
    points.map((point, i) => [point.faces, numberCell(`${p}/${i}/growth`), numberCell(`${p}/${i}/hausdorff`), ...spreadCells(`${p}/${i}/seconds`)]))];
  const mark = (i, x, y, more = {}) => y > 0 && x > 0 ? [{x, y, point: points[i], ...more}] : [];
  const lines = point => [`k = ${point.faces}`, `growth ${text(point.growth)}`, `Hausdorff ${text(point.hausdorff)} diameters`, spread(point.seconds)];
  figure(parent, {
    title: `Tightness against the number of halfspaces: ${input.name}`, short: "Tightness against the number of halfspaces",
    how: `Lower is tighter: the ${measure} that k halfspaces add, and how far out they reach; both are 0 with all planes.`,
    made: commands, tables: tables(),
    configure: () => ({
      type: "scatter",
      data: {datasets: [
        series(growth, 0, points.flatMap((point, i) => mark(i, point.faces, point.growth, {pointer: `${p}/${i}/growth`})), {showLine: true}),
        series("Hausdorff distance / diameter", 1, points.flatMap((point, i) => mark(i, point.faces, point.hausdorff, {pointer: `${p}/${i}/hausdorff`})), {showLine: true})]},
      options: options({x: axis("halfspaces k", {ticks: {callback: countTick}}), y: axis("relative to the input")}, m => lines(m.point))
    })
  });
  figure(parent, {
    title: `Tightness against time: ${input.name}`, short: "Tightness against time",
    how: "One run passes every k on its way from all planes to few; each mark is the tightness reached after a time. Labels give k.",
    made: commands, tables: tables(),
    configure: () => ({
      type: "scatter",
      data: {datasets: [series(growth, 0, points.flatMap((point, i) => mark(i, point.seconds.median, point.growth,
        {name: String(point.faces), spread: {axis: "x", ...point.seconds}, pointer: `${p}/${i}/growth`})), {named: true, showLine: true})]},
      options: options({x: axis("time since the dual hull was complete", {type: "linear", min: 0, max: roundAbove(Math.max(...points.map(point => point.seconds.most))), ticks: {callback: x => x === 0 ? "0" : seconds(x), maxTicksLimit: 6}}), y: axis(growth)}, m => lines(m.point))
    })
  });
}

// --- parts of decompositions ------------------------------------------------------------------------

const kMethods = ["cut", "hacd", "acd"];
const kNothing = 1e-9;  // volumes are enclosures, so that none at all is a little

function partsFigures(parent, input, base) {
  const {points, commands} = input.parts, p = `${base}/parts/points`;
  const done = points.map((point, i) => [point, i]).filter(([point]) => point.seconds);
  const percent = x => x === null ? "unknown" : `${text(100 * x)}%`;
  const tables = () => [table("Limit: the distance of cut, the concavity of hacd and acd, over the diameter; excess and uncovered: shares of the solid's volume",
    ["method", "limit", "parts", "distance / diameter", "excess", "uncovered", ...spreadHeads],
    points.map((point, i) => [point.method, numberCell(`${p}/${i}/limit`), ...(point.seconds
      ? [...["parts", "distance", "excess", "uncovered"].map(key => numberCell(`${p}/${i}/${key}`)), ...spreadCells(`${p}/${i}/seconds`)]
      : [wordsCell("over budget")])]))];
  const lines = point => [`${point.method}, limit ${percent(point.limit)}: ${point.parts} parts`, `distance ${percent(point.distance)} of the diameter`,
    `excess ${percent(point.excess)}, uncovered ${percent(point.uncovered)} of the solid`, spread(point.seconds)];
  const plot = (key, title, how, yTitle) => figure(parent, {
    title: `${title}: ${input.name}`, short: title, how, made: commands, tables: key === "distance" ? tables() : [],
    configure: () => ({
      type: "scatter",
      data: {datasets: kMethods.map((method, k) => series(method, k,
        done.filter(([point]) => point.method === method && point[key] > kNothing).map(([point, i]) => ({
          x: point.seconds.median, y: point[key], name: percent(point.limit), point,
          spread: {axis: "x", ...point.seconds}, pointer: `${p}/${i}/${key}`})), {named: true, showLine: true}))},
      options: options({x: secondsAxis("time of the decomposition", done.map(([point]) => point.seconds)),
        y: key === "parts" ? axis(yTitle, {ticks: {callback: countTick}}) : axis(yTitle)}, m => lines(m.point))
    })
  });
  plot("distance", "Distance of parts against time", "Lower is nearer: the larger distance of surface and parts from each other, as convexact verify measures it. Labels give the limit that was asked for.", "distance / diameter");
  plot("excess", "Excess of parts against time", "Lower is tighter: the volume of the parts outside of the solid; without a mark there is none. What parts leave uncovered is in the table.", "excess / volume of the solid");
  plot("parts", "Number of parts against time", "Lower is fewer.", "parts");
}

// --- stages and sizes -----------------------------------------------------------------------------

function stagesFigure(parent, input, base) {
  const {runs, commands} = input.stages;
  const stageNames = [];
  for (const run of runs) for (const stage of run.stages) if (stage.seconds && !stageNames.includes(stage.name)) stageNames.push(stage.name);
  const find = (run, name) => run.stages.findIndex(stage => stage.name === name);
  const tables = runs.map((run, r) => table(`Run: ${run.run}`, ["stage", ...spreadHeads, "left out, because"], [
    ["all", ...(run.seconds ? spreadCells(`${base}/stages/runs/${r}/seconds`) : [wordsCell("over budget")])],
    ...run.stages.map((stage, i) => stage.seconds ? [stage.name, ...spreadCells(`${base}/stages/runs/${r}/stages/${i}/seconds`)]
      : [stage.name, ...spreadHeads.map(() => wordsCell("")), wordsCell(stage.skipped)])]));
  figure(parent, {
    title: `Time by stage: ${input.name}`, short: "Time by stage",
    how: `A mark for each stage of each run, from left to right on a logarithmic scale; a stage without a mark was skipped. ${saved(runs)}`,
    made: commands, wide: true, tables,
    configure: () => ({
      type: "scatter",
      data: {datasets: runs.map((run, r) => series(run.run, kRuns.indexOf(run.run), stageNames.flatMap((name, n) => {
        const i = find(run, name), time = i < 0 ? null : run.stages[i].seconds;
        return time ? [{x: Math.max(time.median, 1e-6), y: n + 0.16 * (r - (runs.length - 1) / 2), stage: name, time,
          spread: {axis: "x", least: Math.max(time.least, 1e-6), most: Math.max(time.most, 1e-6)},
          pointer: `${base}/stages/runs/${r}/stages/${i}/seconds/median`}] : [];
      }), {showLine: false}))},
      options: options({x: secondsAxis("time", runs.flatMap(run => run.stages.map(stage => stage.seconds)).filter(s => s && s.median > 0).map(s => ({least: 1.3e-6, most: s.most}))),
        y: {type: "linear", reverse: true, min: -0.5, max: stageNames.length - 0.5, grid: {color: colour("line")},
          afterBuildTicks: scale => { scale.ticks = stageNames.map((name, value) => ({value})); },
          ticks: {color: colour("ink"), autoSkip: false, callback: n => stageNames[n]}}},
        (m, set) => [`${set.label}: ${m.stage}`, spread(m.time)])
    })
  });
}

function saved(runs) {
  const [planned, everything] = ["filtered", "everything"].map(name => (runs.find(run => run.run === name) || {}).seconds);
  if (!planned || !everything) return "";
  return `The needed stages take ${seconds(planned.median)}; all stages take ${seconds(everything.median)}, ${text(Number((everything.median / planned.median).toPrecision(3)))} times as long.`;
}

function scalingFigure(parent, title, {series: list, commands}, base) {
  // Without a line where twice its standard error is more than kWidestLaw to either side: then it says nothing.
  const isLaw = s => s.law && 2 * s.law.standard_error <= kWidestLaw;
  const law = s => isLaw(s) ? `: size^${s.law.exponent.toFixed(2)} (${[-2, 2].map(k => (s.law.exponent + k * s.law.standard_error).toFixed(2)).join(" to ")})`
    : s.law ? ": no power of the size" : "";
  const label = s => `${s.run === "hull" ? "hull, by points" : `removals, ${s.run}, by halfspaces`}${law(s)}`;
  figure(parent, {
    title, short: "Time by size", wide: true, how: "Both axes are logarithmic, so a straight line is a power of the size; the legend has its exponent, fitted to the least times, with twice its standard error to either side; where that is over 0.3, it has none.",
    made: commands,
    tables: [
      ...list.map((s, k) => table(`${label(s)}`, [s.counts, ...spreadHeads], s.points.map((point, i) => [point.size, ...spreadCells(`${base}/series/${k}/points/${i}/seconds`)]))),
      table("Fitted powers", ["stage", "exponent", "standard error", "factor, s"], list.map((s, k) => [label(s).split(":")[0],
        ...["exponent", "standard_error", "factor"].map(key => numberCell(`${base}/series/${k}/law/${key}`))]))],
    configure: () => ({
      type: "scatter",
      data: {datasets: list.flatMap((s, k) => {
        const marks = s.points.filter(point => point.seconds.median > 0).map(point => ({x: point.size, y: point.seconds.median, size: point.size, time: point.seconds,
          spread: {axis: "y", ...point.seconds}, pointer: `${base}/series/${k}/points/${s.points.indexOf(point)}/seconds/median`}));
        const fitted = isLaw(s) ? [series(`${label(s)} (line)`, k, marks.map(m => ({x: m.x, y: s.law.factor * m.x ** s.law.exponent})),
          {showLine: true, pointRadius: 0, pointHitRadius: 0, borderDash: [5, 4], bare: true, line: true})] : [];
        return [series(label(s), k, marks, {showLine: false}), ...fitted];
      })},
      options: options({x: axis("size", {ticks: {callback: countTick}}), y: secondsAxis("time", list.flatMap(s => s.points.map(point => point.seconds)))}, (m, set) => [set.label, `size ${m.size}`, spread(m.time)],
        {legend: {position: "bottom", labels: {color: colour("ink"), usePointStyle: true, boxHeight: 7, filter: (item, all) => !all.datasets[item.datasetIndex].line}}})
    })
  });
}

// --- stability ------------------------------------------------------------------------------------

function stabilityFigures(parent, family, base) {
  const measured = family.points.map((point, i) => [point, `${base}/points/${i}`]).filter(([point]) => point.ways);
  const ways = measured.length ? measured[0][0].ways.map(way => way.way) : [];
  const values = measured.map(([point]) => point.value);
  const xAxis = () => axis(`${family.parameter} (values evenly spaced)`, {type: "linear", min: -0.3, max: values.length - 0.7,
    afterBuildTicks: scale => { scale.ticks = values.map((value, i) => ({value: i})); },
    ticks: {callback: (x, i) => text(values[i]), maxRotation: 60}});
  const marks = (name, k, y, spreadOf) => series(name, k, measured.flatMap(([point, p], at) => {
    const i = point.ways.findIndex(way => way.way === name), way = point.ways[i];
    return way && way.seconds && y(way) !== null ? [{x: at, y: y(way), way, value: point.value, ...spreadOf(way, `${p}/ways/${i}`)}] : [];
  }), {showLine: true});
  const lines = m => [`${m.way.way} at ${family.parameter} ${text(m.value)}`, `worst cost: error ${errorText(m.way.cost_worst)}`,
    m.way.first_wrong ? `wrong removal at step ${m.way.first_wrong.step + 1}` : "no wrong removal", `${m.way.left} halfspaces left`, spread(m.way.seconds)];
  const tables = measured.flatMap(([point, p]) => wayTables(point.ways, `${p}/ways`).map(t => {
    t.querySelector("caption").prepend(`${family.parameter} ${text(point.value)}: `);
    return t;
  }));
  const missing = family.points.filter(point => point.why_not).map(point => text(point.value));
  const note = missing.length ? ` No solid at ${missing.join(", ")}.` : "";
  figure(parent, {
    title: `Stability: ${family.family}, error`, short: `${family.family}: error`, made: family.commands, tables,
    how: `Higher marks have more correct bits of the worst cost. A filled mark means a removal that was not the cheapest, or an early end; a mark at the bottom means no removal, or no correct bit.${note}`,
    configure: () => ({
      type: "scatter",
      data: {datasets: ways.map((name, k) => {
        const set = marks(name, k, way => way.cost_worst ? bits(way.cost_worst) : 1,
          (way, p) => ({pointer: way.cost_worst && way.cost_worst.bits !== null ? `${p}/cost_worst/bits` : null}));
        set.pointBackgroundColor = set.data.map(m => m.way.first_wrong || m.way.left > data.request.faces ? set.borderColor : colour("paper"));
        return set;
      })},
      options: options({x: xAxis(), y: bitsAxis("correct bits")}, lines)
    })
  });
  figure(parent, {
    title: `Stability: ${family.family}, time`, short: `${family.family}: time`, made: family.commands, tables: [],
    how: "Lower is faster: the time that stiffness costs each way of computing.",
    configure: () => ({
      type: "scatter",
      data: {datasets: ways.map((name, k) => marks(name, k, way => way.seconds.median, (way, p) => ({spread: {axis: "y", ...way.seconds}, pointer: `${p}/seconds/median`})))},
      options: options({x: xAxis(), y: secondsAxis("time of the removals", measured.flatMap(([point]) => point.ways.map(way => way.seconds)).filter(s => s))}, lines)
    })
  });
}

// --- the page -------------------------------------------------------------------------------------

function section(title, words) {
  const id = `section-${document.querySelectorAll("main > section").length + 1}`;
  const made = element("section", {id}, element("h2", {}, title), ...words);
  document.getElementById("content").append(made);
  return made;
}
function grid(parent) { const made = element("div", {class: "figures"}); parent.append(made); return made; }

function contents() {
  const list = document.getElementById("contents");
  for (const part of document.querySelectorAll("main > section")) {
    const items = element("ol");
    for (const box of part.querySelectorAll("figure")) {
      items.append(element("li", {}, element("a", {href: `#${box.id}`}, box.dataset.short)));
    }
    list.append(element("li", {}, element("a", {href: `#${part.id}`}, part.querySelector("h2").textContent), items));
  }
}

// What a reader wants to know first, as far as it was measured: at most three sentences.
function conclusions() {
  const said = [];
  for (const input of data.inputs) {
    const way = name => input.precision?.ways.find(each => each.way === name && each.seconds);
    const [exact, filtered, float] = ["exact", "filtered", "float"].map(way);
    if (exact && filtered) {
      const times = exact.seconds.median / filtered.seconds.median;
      const same = filtered.first_other === null ? "removes what the exact one removes" : "DOES NOT REMOVE what the exact one removes";
      said.push(`${input.name}: the filtered engine ${same}, in ${seconds(filtered.seconds.median)} instead of ${seconds(exact.seconds.median)}${times > 1.05 ? `, ${text(Number(times.toPrecision(2)))} times faster` : ""}.`);
    }
    if (float) {
      said.push(`Doubles take ${seconds(float.seconds.median)}; ${float.first_wrong ? `in step ${float.first_wrong.step + 1} they remove a halfspace that is not the cheapest, and ${excessText(float.excess).replace("its", "their")}` : "each of their removals is one of the cheapest"}.`);
    }
    const few = input.tightness?.points.filter(each => each.faces <= 18) ?? [];
    const point = few.reduce((most, each) => most && most.faces > each.faces ? most : each, null);
    if (point) said.push(`${point.faces} halfspaces add ${text(100 * point.growth)}% of the ${input.tightness.measure.replace("-", " ")} of the hull.`);
    const parts = input.parts?.points.filter(each => each.seconds && each.method === "cut" && each.distance !== null);
    if (parts?.length) {
      const last = parts.reduce((best, each) => each.distance < best.distance ? each : best);
      said.push(`${last.parts} parts by cut are within ${text(100 * last.distance)}% of the diameter of ${input.name}, in ${seconds(last.seconds.median)}.`);
    }
    if (said.length) break;
  }
  return said.slice(0, 3).join(" ");
}

function build() {
  document.getElementById("origin").textContent = `${data.origin.version}, commit ${data.origin.commit}. Measured on ${machine()}. ` +
    `Runs end at ${data.request.faces} halfspaces; up to ${data.request.repetitions} repetitions within ${data.request.budget} s each; marks are medians, whiskers reach from the least to the most.`;
  document.getElementById("conclusions").textContent = conclusions();
  data.inputs.forEach((input, i) => {
    const base = `/inputs/${i}`;
    const part = section(input.name, [element("p", {}, `${input.points ? `${input.points} points; ` : ""}${input.hull_vertices} hull vertices, ${input.halfspaces} halfspaces.`)]);
    const figures = grid(part);
    if (input.precision) { precisionFigure(figures, input, base); part.insertBefore(orderSummary(input), figures); }
    if (input.tightness) tightnessFigures(figures, input, base);
    if (input.parts) partsFigures(figures, input, base);
    if (input.stages) stagesFigure(figures, input, base);
    if (input.scaling) scalingFigure(figures, `Time by size: subsets of ${input.name}`, input.scaling, `${base}/scaling`);
  });
  if (data.spheres) {
    scalingFigure(grid(section("Spheres", [])), "Time by size: points on a sphere", data.spheres, "/spheres");
  }
  if (data.stability) {
    const figures = grid(section("Stability", [element("p", {}, "Families of shapes that become stiff or extreme, and the loss of correct bits in each arithmetic. The engines filtered and exact lose none.")]));
    data.stability.forEach((family, i) => stabilityFigures(figures, family, `/stability/${i}`));
  }
  contents();
  plots.forEach(draw);
}

build();
const redraw = () => plots.forEach(draw);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw);
matchMedia("print").addEventListener("change", redraw);
