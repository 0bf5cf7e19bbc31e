// SPDX-License-Identifier: Apache-2.0
//
// The X-Y path: command, what the controllers follow and the table, with equal axes; the table's
// line is coloured by what is chosen, and its error can be drawn larger than it is.
(function (T) {
  'use strict';

  const kBins = 32;
  const kFoot = (width) => (width < 460 ? 126 : 100);  // pixels below the frame: labels and key

  // Square boxes of pixels for equal lengths: the range that is too short is widened.
  function equalFrame(box, xRange, yRange) {
    const scale = Math.max((xRange[1] - xRange[0]) / box.w, (yRange[1] - yRange[0]) / box.h) || 1;
    const around = ([low, high], pixels) => {
      const middle = (low + high) / 2;
      return [middle - scale * pixels / 2, middle + scale * pixels / 2];
    };
    return T.frame(box, around(xRange, box.w), around(yRange, box.h));
  }

  const line = (frame, { x, y }) => Array.from(x).flatMap((v, k) => [frame.x(v), frame.y(y[k])]);

  // data: {n, command, model, table, names, colours} and optionally polyline, the command as a
  // line; from, where errors begin instead of the model; id and title; magnify, factors to choose
  // from, the first of them factor; bar: [mm, text], an error drawn for comparison. Points are
  // {x, y} in millimetres. names: of command and model, which is not drawn without one. A colour
  // is {button, label, values}.
  T.pathPlot = function (data) {
    const { n, command, model, table, names, colours } = data;
    const polyline = data.polyline || command;
    const from = data.from || model;
    const factors = data.magnify || [1, 5, 20];
    const state = { magnify: data.factor || factors[0], by: colours[0], range: null,
      cursor: null };
    const enlarged = (axis) => Array.from({ length: n }, (v, k) => from[axis][k] +
      state.magnify * (table[axis][k] - from[axis][k]));
    const shown = () => ({ x: enlarged('x'), y: enlarged('y') });

    const plot = { id: data.id || 'path', title: data.title || 'Path', saveWidth: 760,
      height: (width) => Math.round(Math.min(width + kFoot(width) - 74, 664)) };

    plot.frame = function (width, height) {
      const box = { x: 60, y: 14, w: width - 74, h: height - kFoot(width) };
      const range = (axis) => T.padded(T.range(polyline[axis], ...T.range(model[axis],
        ...T.range(enlarged(axis)))), 0.04);
      return equalFrame(box, range('x'), range('y'));
    };

    const inRange = (k) => state.range === null ||
      (T.time.values[k] >= state.range[0] && T.time.values[k] <= state.range[1]);

    plot.top = () => T.range(state.by.values)[1] || 1;  // of the colours

    plot.scene = function (p, width, height, theme) {
      const frame = plot.frame(width, height);
      const { box } = frame;
      T.drawFrame(p, theme, frame, { xLabel: 'x (mm)', yLabel: 'y (mm)', yCount: box.w / 90 });
      p.clip(box.x, box.y, box.w, box.h);
      p.path(line(frame, polyline), { stroke: theme.asked, width: 4, alpha: 0.5, cap: 'round' });
      if (names[1]) p.path(line(frame, model), { stroke: theme.model, width: 1.4 });
      const { values } = state.by;
      const top = plot.top();
      const bin = (k) => Math.min(kBins - 1, Math.floor(values[k] / top * kBins)) + (inRange(k) ? 0
        : kBins);
      const points = line(frame, shown());
      for (let k = 0; k + 1 < n;) {
        const [now, begin] = [bin(k), k];
        do ++k; while (k + 1 < n && bin(k) === now);
        p.path(points.slice(2 * begin, 2 * k + 2), { width: 2.4, alpha: now >= kBins ? 0.15 : 1,
          stroke: T.ramp(theme, (now % kBins) / (kBins - 1)) });
      }
      if (data.bar) {
        const [length, text] = [data.bar[0] * state.magnify * box.w / (frame.xRange[1] -
          frame.xRange[0]), `${data.bar[1]}, \u00d7${T.whole(state.magnify)}`];
        p.rect(box.x + 6, box.y + 8, length + 18 + 7 * text.length, 20, { fill: theme.surface,
          alpha: 0.85 });
        p.path([box.x + 12, box.y + 18, box.x + 12 + length, box.y + 18], { stroke: theme.ink,
          width: 2 });
        p.text(box.x + 18 + length, box.y + 18, text, { fill: theme.ink, size: 12, middle: true });
      }
      p.unclip();
      key(p, theme, frame, height, top);
    };

    function key(p, theme, frame, height, top) {
      const { box } = frame;
      const y = height - 22;
      T.drawKey(p, theme, box.x, kFoot(box.w + 74) > 100 ? y - 26 : y, [
        { label: names[0], stroke: theme.asked, width: 4 },
        ...(names[1] ? [{ label: names[1], stroke: theme.model }] : [])]);
      const wide = Math.min(190, box.w);
      const x = kFoot(box.w + 74) > 100 ? box.x : box.x + box.w - wide;
      const parts = 48;
      for (let k = 0; k < parts; ++k) {
        p.rect(x + wide * k / parts, y - 7, wide / parts + 0.6, 8,
          { fill: T.ramp(theme, k / (parts - 1)) });
      }
      const text = { fill: theme.muted, size: 11.5 };
      p.text(x, y + 15, '0', text);
      p.text(x + wide / 2, y + 15, state.by.label, { ...text, align: 'center' });
      p.text(x + wide, y + 15, T.num(top, top < 1 ? 3 : top < 10 ? 2 : 0), { ...text,
        align: 'right' });
    }

    plot.overlay = function (p, width, height, theme) {
      const k = state.cursor;
      if (k === null || k >= n) return;
      const frame = plot.frame(width, height);
      const at = ({ x, y }) => [frame.x(x[k]), frame.y(y[k])];
      p.path([...at(from), ...at(shown())], { stroke: theme.ink, width: 1 });
      for (const [of, fill] of [[command, theme.asked], ...(names[1] ? [[model, theme.model]] : []),
        [shown(), theme.actual]]) {
        p.circle(...at(of), 5, { fill, stroke: theme.surface, width: 1.5 });
      }
    };

    const card = T.figure(plot, 'equal scales');
    const controls = T.el('div', { class: 'controls' },
      T.segments('Error drawn', factors.map((one) => [one, `\u00d7${T.whole(one)}`]),
        state.magnify, (value) => {
          state.magnify = value;
          plot.redraw();
        }),
      colours.length > 1 ? T.segments('Colour', colours.map((one) => [one, one.button]), colours[0],
        (value) => {
          state.by = value;
          plot.redraw();
        }) : null);
    card.insertBefore(controls, card.children[1]);

    T.time.follow((cursor, range) => {
      const before = state.range;
      state.cursor = cursor;
      state.range = range[0] <= T.time.full[0] && range[1] >= T.time.full[1] ? null : range;
      if (String(before) !== String(state.range)) plot.redraw();
      else plot.redrawOver();
    });
    // The nearest sample of the table under the pointer becomes the cursor of all time plots.
    plot.canvas.addEventListener('mousemove', (event) => {
      const frame = plot.frame(plot.canvas.clientWidth, plot.canvas.clientHeight);
      const points = line(frame, shown());
      let best = 30;  // pixels
      let nearest = null;
      for (let k = 0; k < n; ++k) {
        const d = Math.hypot(points[2 * k] - event.offsetX, points[2 * k + 1] - event.offsetY);
        if (d < best) [best, nearest] = [d, k];
      }
      T.time.point(nearest, null);
    });
    plot.canvas.addEventListener('mouseleave', () => T.time.point(null, null));
    return card;
  };

  // The table's paths of runs that have one in small frames, the command in grey behind each.
  T.pathCards = (runs, small) => runs.flatMap((run, index) => {
    const { command, table } = run.data;
    if (!command) return [];
    const plot = { id: `path-${index + 1}`, title: run.label, print: 'quarter', saveWidth: 520,
      height: (width) => Math.round(Math.min(width, 420) * 0.95) };
    plot.scene = function (p, width, height, theme) {
      const box = { x: 54, y: 8, w: width - 64, h: height - 56 };
      const range = (axis) => T.padded(T.range(command[axis], ...T.range(table[axis])), 0.05);
      const frame = equalFrame(box, range('x'), range('y'));
      T.drawFrame(p, theme, frame, { xLabel: 'x (mm)', yLabel: 'y (mm)', xCount: 3, yCount: 3 });
      p.path(line(frame, command), { stroke: theme.asked, width: 4, alpha: 0.5 });
      p.path(line(frame, table), { stroke: T.runColour(theme, index), dash: T.runDash(index),
        width: 1.6 });
    };
    return T.figure(plot, small(run));
  });
})(window.Trammel = window.Trammel || {});
