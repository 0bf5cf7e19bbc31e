// SPDX-License-Identifier: Apache-2.0
//
// The page of a sweep. Everything is drawn from the JSON in the page; nothing is loaded.
"use strict";

const data = JSON.parse(document.getElementById("data").textContent);
const byId = (name) => document.getElementById(name);
const axisOf = (name) => data.axes.find((axis) => axis.name === name);
const varies = (axis) => new Set(axis.values.filter((v) => v !== null)).size > 1;
const shown = data.axes.filter(varies);
const keys = shown.filter((axis) => axis.key);
const figures = shown.filter((axis) => !axis.key);
const kRows = 200;
let chosen = -1;
let sorted = { name: (figures[0] || shown[0] || { name: "run" }).name, down: false };
const places = { scatter: [], parallel: [] };  // what a click can hit: {x, y, n}

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

function hue(share) {
  return `hsl(${Math.round(240 - 240 * share)}, 75%, 45%)`;
}

function colors() {
  const axis = axisOf(byId("color").value);
  if (!axis) return () => "#357";
  const [low, high] = extent(axis.values);
  return (n) => (axis.values[n] === null ? "#bbb" : hue((axis.values[n] - low) / (high - low)));
}

function canvas(name) {
  const element = byId(name);
  const scale = window.devicePixelRatio || 1;
  const width = element.clientWidth, height = Number(element.getAttribute("height"));
  element.style.height = `${height}px`;
  if (!element.dataset.height) element.dataset.height = height;
  const tall = Number(element.dataset.height);
  element.style.height = `${tall}px`;
  element.width = width * scale;
  element.setAttribute("height", tall);
  element.height = tall * scale;
  const draw = element.getContext("2d");
  draw.scale(scale, scale);
  draw.font = "12px sans-serif";
  element.setAttribute("data-height", tall);
  return { draw, width, height: tall };
}

function frame(draw, box, xs, ys, xName, yName) {
  draw.strokeStyle = "#888";
  draw.strokeRect(box.left, box.top, box.width, box.height);
  draw.fillStyle = "#444";
  for (let k = 0; k <= 4; ++k) {
    draw.textAlign = "center";
    draw.fillText(text(xs[0] + (xs[1] - xs[0]) * k / 4), box.left + box.width * k / 4,
                  box.top + box.height + 15);
    draw.textAlign = "right";
    draw.fillText(text(ys[0] + (ys[1] - ys[0]) * k / 4), box.left - 5,
                  box.top + box.height * (1 - k / 4) + 4);
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
  const box = { left: 80, top: 20, width: width - 100, height: height - 60 };
  const xs = extent(x.values), ys = extent(y.values), color = colors();
  frame(draw, box, xs, ys, x.name, y.name);
  for (let n = 0; n < data.runs.length; ++n) {
    if (x.values[n] === null || y.values[n] === null) continue;
    const at = { n, x: box.left + box.width * (x.values[n] - xs[0]) / (xs[1] - xs[0]),
                 y: box.top + box.height * (1 - (y.values[n] - ys[0]) / (ys[1] - ys[0])) };
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
  const box = { left: 80, top: 20, width: width - 100, height: height - 60 };
  const [low, high] = extent(axis.values);
  const values = axis.values.filter((v) => v !== null);
  const bins = Math.max(5, Math.min(60, Math.round(Math.sqrt(values.length))));
  const counts = new Array(bins).fill(0);
  for (const v of values) {
    ++counts[Math.min(bins - 1, Math.floor((v - low) / (high - low) * bins))];
  }
  const most = Math.max(...counts);
  frame(draw, box, [low, high], [0, most], axis.name, "runs");
  draw.fillStyle = "#357";
  counts.forEach((count, k) => {
    const tall = box.height * count / most;
    draw.fillRect(box.left + box.width * k / bins + 0.5, box.top + box.height - tall,
                  box.width / bins - 1, tall);
  });
}

function parallel() {
  const names = [...byId("axes").selectedOptions].map((option) => option.value);
  const axes = names.map(axisOf);
  const { draw, width, height } = canvas("parallel");
  places.parallel = [];
  if (axes.length < 2) return;
  const top = 30, tall = height - 60, color = colors();
  const left = (k) => 60 + (width - 120) * k / (axes.length - 1);
  const extents = axes.map((axis) => extent(axis.values));
  const at = (k, n) => {
    const [low, high] = extents[k];
    return top + tall * (1 - (axes[k].values[n] - low) / (high - low));
  };
  const step = Math.max(1, Math.ceil(data.runs.length / 3000));
  const line = (n, wide) => {
    if (axes.some((axis) => axis.values[n] === null)) return;
    draw.strokeStyle = color(n);
    draw.lineWidth = wide;
    draw.globalAlpha = wide > 1 ? 1 : 0.4;
    draw.beginPath();
    axes.forEach((_, k) => {
      draw.lineTo(left(k), at(k, n));
      places.parallel.push({ x: left(k), y: at(k, n), n });
    });
    draw.stroke();
  };
  for (let n = 0; n < data.runs.length; n += step) line(n, 1);
  if (chosen >= 0) line(chosen, 3);
  draw.globalAlpha = 1;
  draw.fillStyle = "#222";
  draw.strokeStyle = "#222";
  draw.lineWidth = 1;
  axes.forEach((axis, k) => {
    draw.beginPath();
    draw.moveTo(left(k), top);
    draw.lineTo(left(k), top + tall);
    draw.stroke();
    draw.textAlign = k === 0 ? "left" : k === axes.length - 1 ? "right" : "center";
    draw.fillText(axis.name, left(k) + (k === 0 ? -50 : k === axes.length - 1 ? 50 : 0), 12);
    draw.fillText(text(extents[k][1]), left(k), 26);
    draw.fillText(text(extents[k][0]), left(k), height - 14);
  });
}

function table() {
  const columns = [{ name: "run", values: data.runs }, { name: "end", values: data.end },
                   ...data.words, ...keys, ...figures];
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
  const order = data.runs.map((_, n) => n).filter((n) => by[n] !== null && by[n] !== undefined);
  order.sort((a, b) => (by[a] < by[b] ? -1 : by[a] > by[b] ? 1 : a - b) * (sorted.down ? -1 : 1));
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
  document.title = `Sweep ${data.title}`;
  byId("title").textContent = `Sweep ${data.title}`;
  const bad = data.end.filter((end) => end !== "done").length;
  byId("about").textContent = `${data.runs.length} of ${data.of} runs are shown; ` +
    `${bad} of these did not end as they should.`;
  for (const name of ["x", "y", "color", "axes"]) {
    for (const axis of shown) byId(name).append(new Option(axis.name, axis.name));
    byId(name).onchange = draw;
  }
  byId("color").prepend(new Option("none", ""));
  byId("x").value = (keys[0] || shown[0] || {}).name;
  byId("y").value = (figures[0] || shown[0] || {}).name;
  byId("color").value = (keys[1] || keys[0] || { name: "" }).name;
  const first = new Set([...keys.slice(0, 6), ...figures.slice(0, 3)].map((axis) => axis.name));
  for (const option of byId("axes").options) option.selected = first.has(option.value);
  hit("scatter");
  hit("parallel");
  window.onresize = draw;
  draw();
}

start();
