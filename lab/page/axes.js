// SPDX-License-Identifier: Apache-2.0
//
// Ticks, frames and labels of the plots that are drawn as scenes.
(function (T) {
  'use strict';

  // About `count` round values from low to high.
  T.ticks = function (low, high, count) {
    const span = high - low;
    if (!(span > 0)) return [low];
    const raw = span / Math.max(1, count);
    const power = 10 ** Math.floor(Math.log10(raw));
    const step = [1, 2, 5, 10].map((m) => m * power).find((s) => s >= raw * 0.999);
    const all = [];
    for (let k = Math.ceil(low / step - 1e-9); k * step <= high + step * 1e-9; ++k) {
      all.push(k === 0 ? 0 : k * step);
    }
    return all;
  };

  T.tickText = function (value, ticks) {
    const step = ticks.length > 1 ? Math.abs(ticks[1] - ticks[0]) : Math.abs(value) || 1;
    let digits = 0;  // as many as the step has
    while (digits < 9 && Math.abs(step * 10 ** digits - Math.round(step * 10 ** digits)) > 1e-6) {
      ++digits;
    }
    return T.num(value, digits);
  };

  // Pixels that labels of a vertical axis need.
  T.tickRoom = (texts) => Math.max(46, 14 + 7 * Math.max(...texts.map((text) => text.length)));

  // A frame: box {x, y, w, h} in pixels, ranges [low, high] of both axes; y grows upward.
  T.frame = function (box, xRange, yRange) {
    return {
      box, xRange, yRange,
      x: (v) => box.x + (v - xRange[0]) / (xRange[1] - xRange[0]) * box.w,
      y: (v) => box.y + box.h - (v - yRange[0]) / (yRange[1] - yRange[0]) * box.h,
    };
  };

  // Grid, ticks and labels of a frame. style: {xLabel, yLabel, xCount, yCount}.
  T.drawFrame = function (p, theme, frame, style) {
    const { box } = frame;
    const xs = T.ticks(...frame.xRange, style.xCount || Math.max(2, box.w / 90));
    const ys = T.ticks(...frame.yRange, style.yCount || Math.max(2, box.h / 45));
    for (const v of xs) {
      const x = frame.x(v);
      p.path([x, box.y, x, box.y + box.h], { stroke: theme.grid });
      p.text(x, box.y + box.h + 16, T.tickText(v, xs), { fill: theme.muted, size: 11.5,
        align: 'center' });
    }
    for (const v of ys) {
      const y = frame.y(v);
      p.path([box.x, y, box.x + box.w, y], { stroke: theme.grid });
      p.text(box.x - 7, y, T.tickText(v, ys), { fill: theme.muted, size: 11.5, align: 'right',
        middle: true });
    }
    p.path([box.x, box.y, box.x, box.y + box.h, box.x + box.w, box.y + box.h],
      { stroke: theme.axis });
    const label = { fill: theme.muted, size: 12, align: 'center' };
    p.text(box.x + box.w / 2, box.y + box.h + 34, style.xLabel, label);
    p.text(box.x - T.tickRoom(ys.map((v) => T.tickText(v, ys))), box.y + box.h / 2, style.yLabel,
      { ...label, turn: true });
  };

  const keyWidth = (entry) => 22 + 7.4 * entry.label.length + 18;

  // The entries of a legend in lines that are no longer than `width`.
  T.keyLines = function (entries, width) {
    const lines = [[]];
    let used = 0;
    for (const entry of entries) {
      if (used > 0 && used + keyWidth(entry) > width) {
        lines.push([]);
        used = 0;
      }
      lines[lines.length - 1].push(entry);
      used += keyWidth(entry);
    }
    return lines;
  };

  // A line of a legend from x on.
  T.drawKey = function (p, theme, x, y, entries) {
    for (const entry of entries) {
      p.path([x, y, x + 16, y], { stroke: entry.stroke, width: Math.max(2, entry.width || 2),
        dash: entry.dash });
      p.text(x + 22, y, entry.label, { fill: theme.muted, size: 12, middle: true });
      x += keyWidth(entry);
    }
  };

  T.range = function (values, low = Infinity, high = -Infinity) {
    for (const v of values) {
      if (v < low) low = v;
      if (v > high) high = v;
    }
    return [low, high];
  };

  T.padded = function ([low, high], part) {
    const pad = (high - low || Math.abs(high) || 1) * part;
    return [low - pad, high + pad];
  };
})(window.Trammel = window.Trammel || {});
