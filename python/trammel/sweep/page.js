// SPDX-License-Identifier: Apache-2.0
//
// The page of a sweep. Everything is drawn from the JSON in the page; nothing is loaded.
"use strict";

const data = JSON.parse(document.getElementById("data").textContent);
const byId = (name) => document.getElementById(name);
const kRows = 200;
const kMostLabels = 12;
let chosen = -1;
const places = { scatter: [], parallel: [] };  // what a click can hit: {x, y, n}
let picture = null;  // drawn into instead of a canvas

// Words are an axis too, of places with labels, where they are few.
function labelled(word) {
  const words = word.values.map((v) => (v === null ? "" : String(v)));
  const labels = [...new Set(words)].filter((v) => v !== "").sort();
  const values = words.map((v) => (v === "" ? null : labels.indexOf(v)));
  return { name: word.name, key: word.key, labels, values };
}

const varies = (axis) => new Set(axis.values.filter((v) => v !== null)).size > 1;
const few = (axis) => axis.labels.length <= kMostLabels;
const words = [...data.words, { name: "end", values: data.end }].map(labelled);
const all = [...data.axes, ...words.filter(few)].filter(varies);
const keys = all.filter((axis) => axis.key);
const figures = all.filter((axis) => !axis.key);
const axes = [...keys, ...figures];
const axisOf = (name) => axes.find((axis) => axis.name === name);
let sorted = { name: (figures[0] || axes[0] || { name: "run" }).name, down: false };

function extent(values) {
  let low = Infinity, high = -Infinity;
  for (const v of values) {
    if (v === null) continue;
    low = Math.min(low, v);
    high = Math.max(high, v);
  }
  if (low > high) return [0, 1];
  return low === high ? [low - 0.5, high + 0.5] : [low, high];
}

function text(value) {
  if (value === null || value === undefined) return "-";
  return typeof value === "number" ? String(Number(value.toPrecision(5))) : String(value);
}

// Some round numbers between two others.
function roundBetween(low, high) {
  const least = (high - low) / 6, ten = 10 ** Math.floor(Math.log10(least));
  const step = [1, 2, 5, 10].map((n) => n * ten).find((s) => s >= least);
  const found = [];
  for (let k = Math.ceil(low / step); k * step <= high; ++k) found.push(k * step);
  return found;
}

// Where on an axis a value is, 0 to 1, and its ticks, [place, text]: round numbers, or both ends.
function scaleOf(axis, round = true) {
  if (axis.labels) {
    const count = axis.labels.length, at = (v) => (v + 0.5) / count;
    return { at, ticks: axis.labels.map((label, k) => [at(k), label]) };
  }
  const [low, high] = extent(axis.values), at = (v) => (v - low) / (high - low);
  const marks = round ? roundBetween(low, high) : [low, high];
  return { at, ticks: marks.map((v) => [at(v), text(v)]) };
}

const kColors = ["#1f77b4", "#d9731a", "#2ca02c", "#9467bd", "#c23b3b", "#8c564b", "#e377c2",
                 "#7f7f7f", "#a0a022", "#17becf", "#111199", "#000000"];

function hue(share) {
  return `hsl(${Math.round(240 - 240 * share)}, 75%, 45%)`;
}

function colors() {
  const axis = axisOf(byId("color").value);
  if (!axis) return () => "#335577";
  const scale = scaleOf(axis);
  const of = (v) => (axis.labels ? kColors[v] : hue(scale.at(v)));
  return (n) => (axis.values[n] === null ? "#bbbbbb" : of(axis.values[n]));
}

// What the colors mean, from `right` to the left.
function legend(draw, right, y) {
  const axis = axisOf(byId("color").value);
  if (!axis) return;
  draw.textAlign = "right";
  const ticks = scaleOf(axis, false).ticks;
  const write = (label) => {
    draw.fillStyle = "#444444";
    draw.fillText(label, right, y);
    right -= draw.measureText(label).width + 5;
  };
  if (axis.labels) {
    for (let k = axis.labels.length - 1; k >= 0; --k) {
      write(axis.labels[k]);
      draw.fillStyle = kColors[k];
      draw.fillRect(right - 8, y - 8, 8, 8);
      right -= 20;
    }
  } else {
    write(ticks[1][1]);
    for (let k = 0; k < 20; ++k) {
      draw.fillStyle = hue(1 - k / 19);
      draw.fillRect(right - 3 * (k + 1), y - 8, 3, 8);
    }
    right -= 65;
    write(ticks[0][1]);
  }
  write(`${axis.name}:`);
}

function canvas(name) {
  const element = byId(name), scale = window.devicePixelRatio || 1;
  const width = element.clientWidth, height = Number(element.dataset.height);
  if (picture) return { draw: picture, width, height };
  element.style.height = `${height}px`;
  element.width = width * scale;
  element.height = height * scale;
  const draw = element.getContext("2d");
  draw.scale(scale, scale);
  draw.font = "12px sans-serif";
  return { draw, width, height };
}

function frame(draw, box, x, y, xName, yName) {
  draw.strokeStyle = "#888888";
  draw.lineWidth = 1;
  draw.strokeRect(box.left, box.top, box.width, box.height);
  draw.fillStyle = "#444444";
  draw.textAlign = "center";
  const every = box.width < 60 * x.ticks.length ? 2 : 1;
  x.ticks.forEach(([at, label], k) => {
    if (k % every === 0) {
      draw.fillText(label, box.left + box.width * at, box.top + box.height + 15);
    }
  });
  draw.textAlign = "right";
  for (const [at, label] of y.ticks) {
    draw.fillText(label, box.left - 5, box.top + box.height * (1 - at) + 4);
  }
  draw.textAlign = "center";
  draw.fillText(xName, box.left + box.width / 2, box.top + box.height + 31);
  draw.textAlign = "left";
  draw.fillText(yName, box.left + 5, box.top - 5);
}

function scatter() {
  const x = axisOf(byId("x").value), y = axisOf(byId("y").value);
  const { draw, width, height } = canvas("scatter");
  places.scatter = [];
  if (!x || !y) return;
  const box = { left: 80, top: 36, width: width - 110, height: height - 76 };
  const xs = scaleOf(x), ys = scaleOf(y), color = colors();
  legend(draw, width - 30, 14);
  frame(draw, box, xs, ys, x.name, y.name);
  for (let n = 0; n < data.runs.length; ++n) {
    if (x.values[n] === null || y.values[n] === null) continue;
    const at = { n, x: box.left + box.width * xs.at(x.values[n]),
                 y: box.top + box.height * (1 - ys.at(y.values[n])) };
    places.scatter.push(at);
    draw.fillStyle = color(n);
    draw.beginPath();
    draw.arc(at.x, at.y, n === chosen ? 6 : 2.5, 0, 7);
    draw.fill();
  }
}

function histogram() {
  const axis = axisOf(byId("y").value);
  const { draw, width, height } = canvas("histogram");
  if (!axis) return;
  const box = { left: 80, top: 20, width: width - 110, height: height - 60 };
  const scale = scaleOf(axis);
  const values = axis.values.filter((v) => v !== null);
  const bins = axis.labels ? axis.labels.length
    : Math.max(5, Math.min(60, Math.round(Math.sqrt(values.length))));
  const counts = new Array(bins).fill(0);
  for (const v of values) ++counts[Math.min(bins - 1, Math.floor(scale.at(v) * bins))];
  const most = Math.max(1, ...counts);
  frame(draw, box, scale, scaleOf({ values: [0, most] }), axis.name, "runs");
  draw.fillStyle = "#335577";
  counts.forEach((count, k) => {
    const tall = box.height * count / most;
    draw.fillRect(box.left + box.width * k / bins + 0.5, box.top + box.height - tall,
                  box.width / bins - 1, tall);
  });
}

function parallel() {
  const taken = [...byId("axes").selectedOptions].map((option) => axisOf(option.value));
  byId("parallel").style.minWidth = `${100 * taken.length}px`;
  const { draw, width, height } = canvas("parallel");
  places.parallel = [];
  if (taken.length < 2) return;
  const top = 44, tall = height - 60, color = colors(), last = taken.length - 1;
  const left = (k) => 60 + (width - 120) * k / last;
  const scales = taken.map((axis) => scaleOf(axis, false));
  const at = (k, n) => top + tall * (1 - scales[k].at(taken[k].values[n]));
  const step = Math.max(1, Math.ceil(data.runs.length / 3000));
  const line = (n, wide) => {
    if (taken.some((axis) => axis.values[n] === null)) return;
    draw.strokeStyle = color(n);
    draw.lineWidth = wide;
    draw.globalAlpha = wide > 1 ? 1 : 0.4;
    draw.beginPath();
    taken.forEach((_, k) => {
      draw.lineTo(left(k), at(k, n));
      places.parallel.push({ x: left(k), y: at(k, n), n });
    });
    draw.stroke();
  };
  for (let n = 0; n < data.runs.length; n += step) line(n, 1);
  if (chosen >= 0) line(chosen, 3);
  draw.globalAlpha = 1;
  draw.fillStyle = "#222222";
  draw.strokeStyle = "#222222";
  draw.lineWidth = 1;
  taken.forEach((axis, k) => {
    draw.beginPath();
    draw.moveTo(left(k), top);
    draw.lineTo(left(k), top + tall);
    draw.stroke();
    // Names of neighbours are not at the same height.
    draw.textAlign = k === 0 ? "left" : k === last ? "right" : "center";
    draw.fillText(axis.name, left(k) + (k === 0 ? -50 : k === last ? 50 : 0), k % 2 ? 26 : 12);
    draw.textAlign = "left";
    for (const [place, label] of scales[k].ticks) {
      draw.fillText(label, left(k) + 4, top + tall * (1 - place) + (place === 0 ? 13 : -3));
    }
  });
}

// What a canvas is told, as SVG: of its functions those that are used here.
class Picture {
  constructor(width, height) {
    this.size = [width, height];
    this.parts = [];
    this.path = [];
    this.globalAlpha = 1;
  }
  round(value) { return Math.round(10 * value) / 10; }
  put(name, given, inside) {
    const words = Object.entries(given).map(([key, value]) =>
      ` ${key}="${typeof value === "number" ? this.round(value) : value}"`).join("");
    this.parts.push(`<${name}${words}${inside === undefined ? "/>" : `>${inside}</${name}>`}`);
  }
  strokeRect(x, y, width, height) {
    this.put("rect", { x, y, width, height, fill: "none", stroke: this.strokeStyle });
  }
  fillRect(x, y, width, height) {
    this.put("rect", { x, y, width, height, fill: this.fillStyle });
  }
  measureText(label) { return { width: 6.2 * label.length }; }
  fillText(label, x, y) {
    const anchor = { left: "start", center: "middle", right: "end" }[this.textAlign];
    const inside = label.replace(/&/g, "&amp;").replace(/</g, "&lt;");
    this.put("text", { x, y, fill: this.fillStyle, "text-anchor": anchor }, inside);
  }
  beginPath() { this.path = []; }
  moveTo(x, y) { this.path.push([x, y]); }
  lineTo(x, y) { this.path.push([x, y]); }
  arc(x, y, radius) { this.circle = { cx: x, cy: y, r: radius }; }
  fill() { this.put("circle", { ...this.circle, fill: this.fillStyle }); }
  stroke() {
    const points = this.path.map((at) => at.map(this.round).join(",")).join(" ");
    this.put("polyline", { points, fill: "none", stroke: this.strokeStyle,
                           "stroke-width": this.lineWidth, "stroke-opacity": this.globalAlpha });
  }
  toString() {
    const [width, height] = this.size;
    return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" ` +
      `font-family="sans-serif" font-size="12">\n<rect width="100%" height="100%" ` +
      `fill="#ffffff"/>\n${this.parts.join("\n")}\n</svg>\n`;
  }
}

function svgOf(name) {
  const element = byId(name);
  picture = new Picture(element.clientWidth, Number(element.dataset.height));
  ({ scatter, histogram, parallel })[name]();
  const made = String(picture);
  picture = null;
  return made;
}

function save(name) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([svgOf(name)], { type: "image/svg+xml" }));
  link.download = `${data.title}-${name}.svg`;
  link.click();
  URL.revokeObjectURL(link.href);
}

function table() {
  const columns = [{ name: "run", values: data.runs }, { name: "end", values: data.end },
                   ...data.words, ...data.axes.filter(varies)];
  const head = byId("table").tHead, body = byId("table").tBodies[0];
  head.replaceChildren(document.createElement("tr"));
  for (const column of columns) {
    const cell = document.createElement("th");
    const mark = sorted.down ? " v" : " ^";
    cell.textContent = column.name + (column.name === sorted.name ? mark : "");
    cell.onclick = () => {
      sorted = { name: column.name, down: sorted.name === column.name && !sorted.down };
      table();
    };
    head.rows[0].append(cell);
  }
  const by = (columns.find((column) => column.name === sorted.name) || columns[0]).values;
  const there = (n) => by[n] !== null && by[n] !== undefined;  // what has no value comes last
  const order = data.runs.map((_, n) => n);
  order.sort((a, b) => there(b) - there(a) ||
    (by[a] < by[b] ? -1 : by[a] > by[b] ? 1 : a - b) * (sorted.down ? -1 : 1));
  body.replaceChildren();
  for (const n of order.slice(0, kRows)) {
    const row = document.createElement("tr");
    row.className = n === chosen ? "chosen" : "";
    row.title = data.message[n] || "";
    for (const column of columns) {
      const cell = document.createElement("td");
      cell.textContent = text(column.values[n]);
      row.append(cell);
    }
    row.onclick = () => choose(n);
    body.append(row);
  }
}

function choose(n) {
  chosen = n;
  byId("command").textContent = data.commands[n];
  draw();
}

function draw() {
  scatter();
  histogram();
  parallel();
  table();
}

function hit(name) {
  byId(name).onclick = (event) => {
    const box = byId(name).getBoundingClientRect();
    const x = event.clientX - box.left, y = event.clientY - box.top;
    let best = null, least = 12 * 12;
    for (const at of places[name]) {
      const far = (at.x - x) ** 2 + (at.y - y) ** 2;
      if (far < least) [best, least] = [at.n, far];
    }
    if (best !== null) choose(best);
  };
}

function start() {
  document.title = `${data.kind} ${data.title}`;
  byId("title").textContent = document.title;
  const bad = data.end.filter((end) => end !== "done").length;
  byId("about").textContent = `${data.runs.length} of ${data.of} ${data.what} are shown; ` +
    `${bad} of these did not end as they should.`;
  byId("rows").textContent = data.what[0].toUpperCase() + data.what.slice(1);
  for (const name of ["x", "y", "color", "axes"]) {
    for (const axis of axes) byId(name).append(new Option(axis.name, axis.name));
    byId(name).onchange = draw;
  }
  const numeric = (axis) => !axis.labels;
  byId("color").prepend(new Option("none", ""));
  byId("x").value = (keys.find(numeric) || axes[0] || {}).name;
  byId("y").value = (figures[0] || axes[0] || {}).name;
  byId("color").value = (keys.find((axis) => axis.labels) || keys.filter(numeric)[1] || keys[0] ||
                         { name: "" }).name;
  const some = [...keys.slice(0, 6), ...figures.filter(numeric).slice(0, 3)];
  const first = new Set(some.map((axis) => axis.name));
  for (const option of byId("axes").options) option.selected = first.has(option.value);
  hit("scatter");
  hit("parallel");
  for (const button of document.querySelectorAll("[data-save]")) {
    button.onclick = () => save(button.dataset.save);
  }
  window.onresize = draw;
  const best = data.words.find((word) => word.name === "best");
  if (best && best.values.includes("best")) {
    choose(best.values.indexOf("best"));
  } else {
    draw();
  }
}

start();
