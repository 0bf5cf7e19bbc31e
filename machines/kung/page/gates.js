// SPDX-License-Identifier: Apache-2.0
//
// The gates of one axis at clock resolution: about two PWM periods with carrier and compare values,
// and one edge enlarged until single clocks and the dead time can be read.
(function (T) {
  'use strict';

  const kPhases = ['A', 'B', 'C'];
  const kPeriod = 3125;

  const carrier = (clock) => {
    const k = ((clock % kPeriod) + kPeriod) % kPeriod;
    return k <= 1562 ? k : kPeriod - k;
  };

  // Both gates of a leg as [[clock, level], ...], clocks counted from the begin of the window.
  function leg(gates, axis, phase) {
    const bits = [6 * axis + phase, 6 * axis + 3 + phase];
    return bits.map((bit) => {
      const line = [];
      for (const [edge, word] of gates.edges) {
        const level = (word >> bit) & 1;
        if (line.length === 0 || line[line.length - 1][1] !== level) {
          line.push([edge - gates.begin, level]);
        }
      }
      return line;
    });
  }

  const levelAt = (line, clock) => {
    let level = 0;
    for (const [at, value] of line) if (at <= clock) level = value;
    return level;
  };

  // Spans with both gates off that begin and end inside the window.
  function deadSpans([hi, lo], length) {
    const edges = [...new Set([...hi, ...lo].map(([at]) => at))].sort((a, b) => a - b);
    const spans = [];
    for (let k = 0; k < edges.length; ++k) {
      const end = k + 1 < edges.length ? edges[k + 1] : length;
      if (levelAt(hi, edges[k]) === 0 && levelAt(lo, edges[k]) === 0) {
        spans.push({ begin: edges[k], end, whole: edges[k] > 0 && end < length });
      }
    }
    return spans;
  }

  // Steps of a line between two clocks, as pixels.
  function steps(line, frame, high, low) {
    const [from, to] = frame.xRange;
    const points = [frame.x(from), levelAt(line, from) ? high : low];
    for (const [at, level] of line) {
      if (at <= from || at >= to) continue;
      const x = frame.x(at);
      points.push(x, points[points.length - 1], x, level ? high : low);
    }
    points.push(frame.x(to), points[points.length - 1]);
    return points;
  }

  function drawLeg(p, theme, frame, lines, y, h, name) {
    const rows = [['hi', lines[0], y], ['lo', lines[1], y + h / 2]];
    for (const [what, line, top] of rows) {
      const high = top + 4;
      const low = top + h / 2 - 4;
      const points = steps(line, frame, high, low);
      p.path([frame.box.x, low, ...points, frame.box.x + frame.box.w, low],
        { fill: what === 'hi' ? theme.actual : theme.model, alpha: 0.14, close: true });
      p.path(points, { stroke: what === 'hi' ? theme.actual : theme.model, width: 1.6 });
      p.text(frame.box.x - 8, (high + low) / 2, `${name} ${what}`, { fill: theme.muted, size: 12,
        align: 'right', middle: true });
    }
  }

  function drawDead(p, theme, frame, spans, y, h) {
    for (const span of spans) {
      const from = Math.max(span.begin, frame.xRange[0]);
      const to = Math.min(span.end, frame.xRange[1]);
      if (to <= from) continue;
      p.rect(frame.x(from), y, Math.max(1, frame.x(to) - frame.x(from)), h, { fill: theme.faint,
        alpha: 0.28 });
    }
  }

  function axisOfTime(p, theme, frame, bottom, clockUs, label) {
    const [from, to] = frame.xRange;
    const us = T.ticks(from * clockUs, to * clockUs, Math.max(3, frame.box.w / 80));
    for (const t of us) {
      const x = frame.x(t / clockUs);
      p.path([x, frame.box.y, x, bottom], { stroke: theme.grid });
      p.text(x, bottom + 16, T.tickText(t, us), { fill: theme.muted, size: 11.5,
        align: 'center' });
    }
    p.path([frame.box.x, bottom, frame.box.x + frame.box.w, bottom], { stroke: theme.axis });
    p.text(frame.box.x + frame.box.w / 2, bottom + 34, label, { fill: theme.muted, size: 12,
      align: 'center' });
  }

  function drawCarrier(p, theme, frame, y, h, compare, axis) {
    const level = (v) => y + h - 4 - v / 1562 * (h - 10);
    const points = [];
    const [from, to] = frame.xRange;
    for (let k = from; k <= to; k += (to - from) / 1200) {
      points.push(frame.x(k), level(carrier(Math.round(k))));
    }
    p.path(points, { stroke: theme.faint, width: 1.2 });
    compare.forEach((axes, period) => {
      axes[axis].forEach((value, phase) => {
        const [x0, x1] = [frame.x(period * kPeriod), frame.x((period + 1) * kPeriod)];
        p.path([x0, level(value), x1, level(value)], { stroke: [theme.x, theme.y,
          theme.other][phase], width: 1.3, dash: [5, 3] });
        if (period === 0) {
          p.text(x0 + 4 + phase * 22, level(value) - 3, kPhases[phase], { fill: [theme.x, theme.y,
            theme.other][phase], size: 11, weight: 600 });
        }
      });
    });
    p.text(frame.box.x - 8, y + h / 2, 'carrier', { fill: theme.muted, size: 12, align: 'right',
      middle: true });
  }

  T.gatePlots = function (gates, axisIndex, clockUs) {
    const state = { axis: axisIndex, phase: 0 };
    const length = gates.end - gates.begin;
    const hasCarrier = gates.compare.length > 0;
    const legs = () => [0, 1, 2].map((phase) => leg(gates, state.axis, phase));

    const overview = { id: 'pwm', title: 'Gates over two PWM periods', print: 'half',
      height: () => (hasCarrier ? 372 : 302) };
    overview.scene = function (p, width, height, theme) {
      const frame = T.frame({ x: 62, y: 6, w: width - 76, h: height - 50 }, [0, length], [0, 1]);
      const bottom = height - 44;
      axisOfTime(p, theme, frame, bottom, clockUs, gates.trip === undefined
        ? 'Time since the 2 kHz tick (\u00b5s)' : 'Time since the window began (\u00b5s)');
      const top = hasCarrier ? 76 : 6;
      if (hasCarrier) drawCarrier(p, theme, frame, 4, 70, gates.compare, state.axis);
      const h = (bottom - top) / 3;
      legs().forEach((lines, phase) => {
        const y = top + phase * h;
        drawDead(p, theme, frame, deadSpans(lines, length), y + 2, h - 4);
        drawLeg(p, theme, frame, lines, y, h, kPhases[phase]);
        if (phase > 0) p.path([62, y, width - 14, y], { stroke: theme.grid });
      });
      if (gates.trip !== undefined) {
        const x = frame.x(gates.trip - gates.begin);
        p.path([x, 6, x, bottom], { stroke: theme.ink, width: 1.5, dash: [4, 3] });
        p.text(x + 5, 16, 'trip', { fill: theme.ink, size: 12, weight: 600 });
      }
      const z = zoomed();
      if (z) {
        const y = top + state.phase * h;
        p.rect(frame.x(z.from), y + 1, Math.max(3, frame.x(z.to) - frame.x(z.from)), h - 2,
          { stroke: theme.accent, width: 1.5 });
      }
    };

    // One whole dead time of the chosen leg, the one nearest the middle, with some clocks around.
    function zoomed() {
      const spans = deadSpans(legs()[state.phase], length).filter((s) => s.whole);
      if (spans.length === 0) return null;
      const middle = length / 2;
      const span = spans.reduce((a, b) => (Math.abs(a.begin - middle) <= Math.abs(b.begin - middle)
        ? a : b));
      const around = Math.max(8, Math.round(0.35 * (span.end - span.begin)));
      return { span, from: span.begin - around, to: span.end + around };
    }

    const zoom = { id: 'dead-time', title: 'One edge, clock by clock', print: 'half',
      height: overview.height };
    zoom.scene = function (p, width, height, theme) {
      const z = zoomed();
      const bottom = height - 44;
      if (!z) {
        p.text(width / 2, height / 2, 'this leg does not switch here', { fill: theme.muted,
          align: 'center' });
        return;
      }
      const box = { x: 52, y: 40, w: width - 66, h: bottom - 40 };
      const frame = T.frame(box, [z.from, z.to], [0, 1]);
      axisOfTime(p, theme, frame, bottom, clockUs, 'Time (\u00b5s)');
      const each = frame.box.w / (z.to - z.from);
      const every = [1, 5, 10, 50].find((n) => n * each >= 4) || 100;
      for (let k = Math.ceil(z.from / every) * every; k <= z.to; k += every) {
        const x = frame.x(k);
        p.path([x, bottom, x, bottom - (k % (5 * every) === 0 ? 8 : 4)], { stroke: theme.axis });
      }
      p.text(box.x + box.w, bottom - 12, `a tick is ${every} clock${every > 1 ? 's' : ''}`, {
        fill: theme.faint, size: 11, align: 'right' });
      drawDead(p, theme, frame, [z.span], 40, bottom - 40);
      drawLeg(p, theme, frame, legs()[state.phase], 46, bottom - 76, kPhases[state.phase]);
      const [x0, x1] = [frame.x(z.span.begin), frame.x(z.span.end)];
      p.path([x0, 30, x1, 30], { stroke: theme.ink, width: 1.2 });
      for (const [x, d] of [[x0, 5], [x1, -5]]) {
        p.path([x + d, 26.5, x, 30, x + d, 33.5], { stroke: theme.ink, width: 1.2 });
        p.path([x, 24, x, bottom], { stroke: theme.ink, width: 0.8, dash: [2, 2] });
      }
      const clocks = z.span.end - z.span.begin;
      p.text((x0 + x1) / 2, 18, `${clocks} clocks = ${T.num(clocks * clockUs, 2)} \u00b5s`,
        { fill: theme.ink, size: 13, weight: 600, align: 'center' });
    };

    const read = T.el('p', { class: 'note' });
    const tell = () => {
      const spans = legs().flatMap((lines) => deadSpans(lines, length)).filter((s) => s.whole);
      const least = spans.length ? Math.min(...spans.map((s) => s.end - s.begin)) : 0;
      read.textContent = spans.length === 0 ? 'No leg switches in this window.'
        : `${spans.length} dead times in the window (grey), the shortest ${least} clocks = ` +
        `${T.num(least * clockUs, 2)} \u00b5s.`;
    };
    const again = () => {
      overview.redraw();
      zoom.redraw();
      tell();
    };
    const left = T.figure(overview, 'upper and lower switch of each leg');
    const right = T.figure(zoom);
    left.insertBefore(T.el('div', { class: 'controls' },
      T.segments('Axis', [[0, 'X'], [1, 'Y']], state.axis, (v) => {
        state.axis = v;
        again();
      }),
      T.segments('Enlarged leg', [[0, 'A'], [1, 'B'], [2, 'C']], 0, (v) => {
        state.phase = v;
        again();
      })), left.children[1]);
    left.append(read);
    tell();
    return T.el('div', { class: 'grid pwm' }, left, right);
  };
})(window.Trammel = window.Trammel || {});
