// SPDX-License-Identifier: Apache-2.0
//
// A Bode plot of measured responses: rows [Hz, dB and degree closed, dB and degree open].
(function (T) {
  'use strict';

  const kWidth = 74;  // of labels beside a frame
  const kClosed = 1;  // column of the closed loop's gain; its phase stands behind it
  const kOpen = 3;

  const log = Math.log10;

  // 1, 2 and 5 of every decade within a range of logarithms: [[logarithm, value], ...].
  T.decades = function ([low, high]) {
    const all = [];
    for (let power = Math.floor(low); power <= high; ++power) {
      for (const step of [1, 2, 5]) {
        const at = power + log(step);
        if (at >= low - 1e-9 && at <= high + 1e-9) all.push([at, step * 10 ** power]);
      }
    }
    return all;
  };

  function drawPart(p, theme, frame, style, lines) {
    const { box } = frame;
    const ys = T.ticks(...frame.yRange, Math.max(2, box.h / 40));
    for (const [at, hz] of T.decades(frame.xRange)) {
      p.path([frame.x(at), box.y, frame.x(at), box.y + box.h], { stroke: theme.grid });
      if (style.xLabel) {
        p.text(frame.x(at), box.y + box.h + 16, String(Number(hz.toPrecision(1))),
          { fill: theme.muted, size: 11.5, align: 'center' });
      }
    }
    for (const v of ys) {
      p.path([box.x, frame.y(v), box.x + box.w, frame.y(v)],
        { stroke: v === style.mark ? theme.axis : theme.grid });
      p.text(box.x - 7, frame.y(v), T.tickText(v, ys), { fill: theme.muted, size: 11.5,
        align: 'right', middle: true });
    }
    p.path([box.x, box.y, box.x, box.y + box.h, box.x + box.w, box.y + box.h],
      { stroke: theme.axis });
    const label = { fill: theme.muted, size: 12, align: 'center' };
    p.text(box.x - 50, box.y + box.h / 2, style.yLabel, { ...label, turn: true });
    if (style.xLabel) p.text(box.x + box.w / 2, box.y + box.h + 34, style.xLabel, label);
    for (const { rows, column, look } of lines) {
      p.path(rows.flatMap((row) => [frame.x(log(row[0])), frame.y(row[column])]), look);
      for (const row of rows) {
        p.circle(frame.x(log(row[0])), frame.y(row[column]), 2, { fill: look.stroke });
      }
    }
  }

  // plot: {id, title}; rows: of one loop.
  T.bodePlot = function ({ id, title, rows }) {
    const plot = { id, title, height: () => 420 };
    plot.scene = function (p, width, height, theme) {
      const xRange = [log(rows[0][0]), log(rows[rows.length - 1][0])];
      if (xRange[0] === xRange[1]) xRange[1] += 1;
      const looks = { [kClosed]: { stroke: theme.actual, width: 2 },
        [kOpen]: { stroke: theme.model, width: 1.6, dash: [5, 4] } };
      const part = (y, tall, shift) => {
        const lines = [kClosed, kOpen].map((column) => ({ rows, column: column + shift,
          look: looks[column] }));
        const values = lines.flatMap(({ column }) => rows.map((row) => row[column]));
        return [T.frame({ x: kWidth, y, w: width - kWidth - 16, h: tall }, xRange,
          T.padded(T.range(values), 0.06)), lines];
      };
      const tall = (height - 24 - 14 - 44) / 2;
      const [gain, gains] = part(24, tall, 0);
      const [phase, phases] = part(24 + tall + 14, tall, 1);
      drawPart(p, theme, gain, { yLabel: 'gain (dB)', mark: 0 }, gains);
      drawPart(p, theme, phase, { yLabel: 'phase (degree)', mark: -180,
        xLabel: 'Frequency (Hz)' }, phases);
      T.drawKey(p, theme, kWidth, 11, [{ label: 'closed', ...looks[kClosed] },
        { label: 'open', ...looks[kOpen] }]);
    };
    return T.figure(plot, 'measured');
  };
})(window.Trammel = window.Trammel || {});
