// SPDX-License-Identifier: Apache-2.0
//
// Plots over time, drawn by uPlot. All of a page share one cursor and one range of time: what the
// pointer does in one of them happens in all. A series is {label, data, role, unit, digits} and
// optionally width, dash, steps, hidden, help, peak: [time, value], which is marked; `role` names
// its colour in theme.js. A plot with `times` has its own time base of any length: it
// follows the others' cursor and zoom, and they follow it as far as they reach.
(function (T) {
  'use strict';

  const kFace = 'px system-ui, "Segoe UI", Roboto, "Liberation Sans", Arial, sans-serif';
  const kHeight = 210;
  const kKeyLine = 16;   // pixels
  const all = [];        // every time plot
  const followers = [];  // called with the cursor (an index, or null) and the range
  let busy = false;
  let cursor = null;

  T.time = {
    plots: all,
    full: [0, 1],
    range: [0, 1],
    values: null,
    label: 'Time (s)',
    marks: [],  // times of events: a dashed line in every plot
    follow: (follower) => followers.push(follower),
  };

  function notify() {
    const now = document.getElementById('time-now');
    now.textContent = cursor === null ? ''
      : `t = ${T.num(T.time.values[cursor], 4)} s`;
    for (const follower of followers) follower(cursor, T.time.range);
  }

  const timesOf = (plot) => plot.times || T.time.values;
  const fullOf = ({ times }) => (times ? [times[0], times[times.length - 1]] : T.time.full);

  // The sample nearest to a time, null outside of all.
  T.time.at = function (t) {
    const { values, full } = T.time;
    if (!(t >= full[0] && t <= full[1])) return null;
    const next = values.findIndex((v) => v >= t);
    return next > 0 && t - values[next - 1] < values[next] - t ? next - 1 : next;
  };

  // The cursor of all plots at sample `index`; null takes it away.
  T.time.point = function (index, source) {
    if (busy || index === cursor) return;
    busy = true;
    cursor = index;
    for (const plot of all) {
      const u = plot.uplot;
      if (plot === source || !u) continue;
      const left = index === null ? -10 : u.valToPos(T.time.values[index], 'x');
      u.setCursor({ left, top: index === null ? -10 : 1 }, false);
    }
    busy = false;
    notify();
  };

  T.time.zoom = function (low, high, source) {
    if (busy) return;
    const [first, last] = T.time.full;
    const [begin, end] = fullOf(source || {});
    const everything = low <= begin && high >= end;
    const range = everything ? [first, last] : [Math.max(first, low), Math.min(last, high)];
    const whole = range[0] <= first && range[1] >= last;
    document.getElementById('zoom-reset').disabled = everything;
    if (!(range[1] > range[0])) return;
    busy = true;
    T.time.range = range;
    for (const plot of all) {
      if (plot !== source && plot.uplot) {
        const [min, max] = whole ? fullOf(plot) : range;
        plot.uplot.setScale('x', { min, max });
      }
    }
    busy = false;
    notify();
  };

  // The base of all plots: its values, and the tools in the bar.
  T.time.start = function (values) {
    T.time.values = values;
    if (values.length < 2) return;
    T.time.full = T.time.range = [values[0], values[values.length - 1]];
    document.getElementById('time-tools').hidden = false;
    document.getElementById('zoom-reset').addEventListener('click', () => T.time.zoom(
      ...T.time.full));
  };

  const color = (theme, series) => theme[series.role] || T.runColour(theme, series.run);

  // Of a line in the legend: its colour, in the parts of a dash.
  function marker({ role, run, dash }) {
    const fill = role ? `var(--${role})` : `var(--run${run % T.light.runs.length})`;
    return dash ? `repeating-linear-gradient(90deg, ${fill} 0 4px, transparent 4px 6px)` : fill;
  }

  // uPlot's own, but that a flat line has a range of its size.
  function yRange(u, low, high) {
    if (low === null || low === undefined) return [null, null];
    return low === high ? [low - 1, high + 1] : uPlot.rangeNum(low, high, 0.1, true);
  }

  function options(plot, width) {
    const axis = {
      stroke: () => T.theme().muted,
      grid: { stroke: () => T.theme().grid, width: 1 },
      ticks: { stroke: () => T.theme().grid, width: 1, size: 4 },
      font: '11.5' + kFace,
      labelFont: '12' + kFace,
      labelGap: 0,
      gap: 4,
    };
    const values = (u, splits) => splits.map((v) => T.tickText(v, splits));
    return {
      width,
      height: plot.height(width),
      padding: [8, 10, 0, 0],
      scales: { x: { time: false, range: (u, low, high) => [low, high] },
        y: { range: yRange } },
      axes: [
        { ...axis, label: T.time.label, labelSize: 18, size: 26, values },
        { ...axis, label: plot.yLabel, labelSize: 20, values,
          size: (u, texts) => (texts ? T.tickRoom(texts) : 46) },
      ],
      cursor: { y: false, drag: { x: true, y: false, dist: 4 }, points: { size: 7 } },
      legend: { live: true, markers: { width: 0, fill: (u, k) => (k > 0
        ? marker(plot.series[k - 1]) : null) } },
      series: [{ label: 't' }, ...plot.series.map((s) => ({
        label: s.label,
        show: !s.hidden,
        stroke: () => color(T.theme(), s),
        width: s.width || 1.5,
        dash: s.dash,
        points: { show: false },
        paths: s.steps ? uPlot.paths.stepped({ align: 1 }) : undefined,
        value: (u, v) => (v === null || v === undefined ? '\u2013'
          : `${T.num(v, s.digits)}${s.unit ? ' ' + s.unit : ''}`),
      }))],
      hooks: {
        draw: [(u) => drawNotes(u, plot)],
        setCursor: [(u) => T.time.point(u.cursor.left < 0 ? null : plot.times
          ? T.time.at(plot.times[u.cursor.idx]) : u.cursor.idx, plot)],
        setScale: [(u, key) => {
          const { min, max } = u.scales.x;
          const known = min === T.time.range[0] && max === T.time.range[1];
          if (key === 'x' && !(plot.times && known)) T.time.zoom(min, max, plot);
        }],
      },
    };
  }

  // Events as dashed lines in a frame.
  T.markEvents = function (p, theme, { box, x, xRange }) {
    for (const t of T.time.marks.filter((t) => t >= xRange[0] && t <= xRange[1])) {
      p.path([x(t), box.y, x(t), box.y + box.h], { stroke: theme.muted, dash: [4, 4] });
    }
  };

  // Events, and the peaks of the lines that are shown.
  function annotate(p, u, plot, theme, frame) {
    if (!plot.times) T.markEvents(p, theme, frame);
    plot.series.filter((s, k) => s.peak && u.series[k + 1].show).forEach((s) => {
      const [x, y] = [frame.x(s.peak[0]), frame.y(s.peak[1])];
      p.circle(x, y, 4.5, { fill: color(theme, s), stroke: theme.surface, width: 1.5 });
      p.text(x + 8, y + 1, `${T.num(s.peak[1], s.digits)} ${s.unit}`, { fill: color(theme, s),
        size: 11.5, weight: 600, middle: true });
    });
  }

  // The same over the lines that uPlot has drawn.
  function drawNotes(u, plot) {
    const { clientWidth: w, clientHeight: h } = u.over;
    const { x, y } = u.scales;
    const frame = T.frame({ x: 0, y: 0, w, h }, [x.min, x.max], [y.min, y.max]);
    plot.notes = plot.notes || u.over.appendChild(T.el('div', { class: 'over' }));
    plot.notes.innerHTML = T.svgOf((p) => annotate(p, u, plot, T.theme(), frame), w, h);
  }

  // The same for papers, from the data and the ranges that are on the screen.
  function scene(plot, p, width, height, theme) {
    const u = plot.uplot;
    const shown = plot.series.filter((s, k) => u.series[k + 1].show);
    const y = u.scales.y;
    const yRange = y.min === null || y.min === undefined ? [0, 1] : [y.min, y.max];
    const ticks = T.ticks(...yRange, Math.max(2, (height - 72) / 45));
    const left = 14 + T.tickRoom(ticks.map((v) => T.tickText(v, ticks)));
    const key = T.keyLines(shown.map((s) => ({ label: s.label, stroke: color(theme, s),
      width: s.width, dash: s.dash })), width - left + 4);
    const more = kKeyLine * (key.length - 1);
    const box = { x: left, y: 26 + more, w: width - left - 14, h: height - 72 - more };
    const xRange = plot.times ? [u.scales.x.min, u.scales.x.max] : T.time.range;
    const frame = T.frame(box, xRange, yRange);
    T.drawFrame(p, theme, frame, { xLabel: T.time.label, yLabel: plot.yLabel });
    key.forEach((line, k) => T.drawKey(p, theme, box.x, 12 + kKeyLine * k, line));
    const times = timesOf(plot);
    const first = Math.max(0, times.findIndex((t) => t > xRange[0]) - 1);
    const after = times.findIndex((t) => t > xRange[1]);
    const last = after < 0 ? times.length - 1 : after;
    p.clip(box.x, box.y, box.w, box.h);
    for (const s of shown) {
      const style = { stroke: color(theme, s), width: s.width || 1.5, dash: s.dash };
      let line = [];
      for (let k = first; k <= last; ++k) {
        if (s.data[k] !== null) {
          const x = frame.x(times[k]);
          if (s.steps && line.length > 0) line.push(x, line[line.length - 1]);
          line.push(x, frame.y(s.data[k]));
        }
        if ((s.data[k] === null || k === last) && line.length > 0) {
          p.path(line, style);
          line = [];
        }
      }
    }
    annotate(p, u, plot, theme, frame);
    p.unclip();
  }

  // spec: {id, title, small, yLabel, series}; the card of the plot.
  T.timePlot = function (spec) {
    const plot = T.register({ ...spec, saveHeight: 400,
      height: (width) => spec.tall || (width < 420 ? 180 : kHeight),
      printHeight: () => (spec.tall ? 230 : 138) + kKeyLine * Math.floor(spec.series.length / 4) });
    all.push(plot);
    const card = T.card(plot.title, plot.small, plot);
    const frame = T.el('div', { class: 'plot screen-only' });
    card.append(frame);
    plot.scene = (p, width, height, theme) => scene(plot, p, width, height, theme);
    plot.redraw = () => plot.uplot && plot.uplot.redraw(false, true);
    plot.resize = () => {
      const width = Math.floor(frame.clientWidth);
      if (width <= 0) return;
      if (!plot.uplot) {
        busy = true;  // its first ranges are not the reader's choice
        plot.uplot = new uPlot(options(plot, width), [timesOf(plot),
          ...plot.series.map((s) => s.data)], frame);
        busy = false;
        frame.querySelectorAll('.u-series').forEach((row, k) => {
          if (k > 0 && plot.series[k - 1].help) row.title = plot.series[k - 1].help;
        });
      } else if (width !== plot.uplot.width) {
        plot.uplot.setSize({ width, height: plot.height(width) });
      }
    };
    return card;
  };
})(window.Trammel = window.Trammel || {});
