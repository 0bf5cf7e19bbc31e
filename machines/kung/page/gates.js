// SPDX-License-Identifier: Apache-2.0
//
// The gates of one axis at clock resolution: about two PWM periods with carrier and compare values,
// and one edge enlarged until single clocks and the dead time can be read.
(function (T) {
  'use strict';

  const kPhases = ['A', 'B', 'C'];

  // A leg as spans {begin, end, levels: [upper, lower]}, in clocks from the start of the window.
  function legOf(gates, axis, phase) {
    const spans = [];
    for (const [edge, word] of gates.edges) {
      const levels = [6 * axis + phase, 6 * axis + 3 + phase].map((bit) => (word >> bit) & 1);
      const last = spans[spans.length - 1];
      if (last && last.levels.join() === levels.join()) continue;
      if (last) last.end = edge - gates.begin;
      spans.push({ begin: edge - gates.begin, end: gates.end - gates.begin, levels });
    }
    return spans;
  }

  const deadOf = (spans) => spans.filter(({ levels }) => !levels[0] && !levels[1]);

  // Of spans, [from, to, span] of those that a frame shows.
  const shown = (spans, { xRange: [low, high] }) => spans.map((span) => [Math.max(span.begin, low),
    Math.min(span.end, high), span]).filter(([from, to]) => to > from);

  // Dead times in grey, and both gates of the leg.
  function drawLeg(p, theme, frame, spans, { y, h, name, dead, deadY, deadH }) {
    for (const [from, to] of shown(dead, frame)) {
      p.rect(frame.x(from), deadY, Math.max(1, frame.x(to) - frame.x(from)), deadH,
        { fill: theme.faint, alpha: 0.28 });
    }
    [['hi', theme.actual], ['lo', theme.model]].forEach(([what, color], gate) => {
      const high = y + gate * h / 2 + 4;
      const low = y + (gate + 1) * h / 2 - 4;
      const points = shown(spans, frame).flatMap(([from, to, { levels }]) => [frame.x(from),
        levels[gate] ? high : low, frame.x(to), levels[gate] ? high : low]);
      p.path([frame.box.x, low, ...points, frame.box.x + frame.box.w, low],
        { fill: color, alpha: 0.14, close: true });
      p.path(points, { stroke: color, width: 1.6 });
      p.text(frame.box.x - 8, (high + low) / 2, `${name} ${what}`, { fill: theme.muted, size: 12,
        align: 'right', middle: true });
    });
  }

  function drawTime(p, theme, frame, bottom, clockUs, label) {
    const us = T.ticks(...frame.xRange.map((clock) => clock * clockUs),
      Math.max(3, frame.box.w / 80));
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

  function drawCarrier(p, theme, frame, y, h, compare, axis, clocks) {
    const peak = Math.floor(clocks / 2);
    const level = (v) => y + h - 4 - v / peak * (h - 10);
    const corners = compare.flatMap((axes, period) => [[period, 0], [period + 0.5, peak]]);
    p.path([...corners, [compare.length, 0]].flatMap(([at, v]) => [frame.x(at * clocks),
      level(v)]), { stroke: theme.faint, width: 1.2 });
    compare.forEach((axes, period) => axes[axis].forEach((value, phase) => {
      const color = [theme.x, theme.y, theme.other][phase];
      const [x0, x1] = [frame.x(period * clocks), frame.x((period + 1) * clocks)];
      p.path([x0, level(value), x1, level(value)], { stroke: color, width: 1.3, dash: [5, 3] });
      if (period > 0) return;
      p.text(x0 + 4 + phase * 22, level(value) - 3, kPhases[phase], { fill: color, size: 11,
        weight: 600 });
    }));
    p.text(frame.box.x - 8, y + h / 2, 'carrier', { fill: theme.muted, size: 12, align: 'right',
      middle: true });
  }

  T.gatePlots = function (gates, axisIndex, clockUs) {
    const state = { axis: axisIndex, phase: 0 };
    const length = gates.end - gates.begin;
    const hasCarrier = gates.compare.length > 0;
    const legs = () => kPhases.map((name, phase) => legOf(gates, state.axis, phase));
    // Dead times that begin and end inside the window.
    const wholeOf = (leg) => deadOf(leg).filter((s) => s.begin > 0 && s.end < length);

    const overview = { id: 'pwm', title: 'Gates over two PWM periods', print: 'half',
      height: () => (hasCarrier ? 372 : 302) };
    overview.scene = function (p, width, height, theme) {
      const frame = T.frame({ x: 62, y: 6, w: width - 76, h: height - 50 }, [0, length], [0, 1]);
      const bottom = height - 44;
      drawTime(p, theme, frame, bottom, clockUs, gates.trip === undefined
        ? 'Time since the position tick (\u00b5s)' : 'Time since the window began (\u00b5s)');
      const top = hasCarrier ? 76 : 6;
      if (hasCarrier) drawCarrier(p, theme, frame, 4, 70, gates.compare, state.axis, length / 2);
      const h = (bottom - top) / 3;
      legs().forEach((leg, phase) => {
        const y = top + phase * h;
        drawLeg(p, theme, frame, leg, { y, h, name: kPhases[phase], dead: deadOf(leg),
          deadY: y + 2, deadH: h - 4 });
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
      const off = ({ begin }) => Math.abs(begin - length / 2);
      const [span] = wholeOf(legs()[state.phase]).sort((a, b) => off(a) - off(b));
      if (!span) return null;
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
      drawTime(p, theme, frame, bottom, clockUs, 'Time (\u00b5s)');
      const each = box.w / (z.to - z.from);
      const every = [1, 5, 10, 50].find((n) => n * each >= 4) || 100;
      for (let k = Math.ceil(z.from / every) * every; k <= z.to; k += every) {
        const x = frame.x(k);
        p.path([x, bottom, x, bottom - (k % (5 * every) === 0 ? 8 : 4)], { stroke: theme.axis });
      }
      p.text(box.x + box.w, bottom - 12, `a tick is ${every} clock${every > 1 ? 's' : ''}`, {
        fill: theme.faint, size: 11, align: 'right' });
      drawLeg(p, theme, frame, legs()[state.phase], { y: 46, h: bottom - 76,
        name: kPhases[state.phase], dead: [z.span], deadY: 40, deadH: bottom - 40 });
      const [x0, x1] = [frame.x(z.span.begin), frame.x(z.span.end)];
      p.path([x0, 30, x1, 30], { stroke: theme.ink, width: 1.2 });
      for (const [x, d] of [[x0, 5], [x1, -5]]) {
        p.path([x + d, 26.5, x, 30, x + d, 33.5], { stroke: theme.ink, width: 1.2 });
        p.path([x, 24, x, bottom], { stroke: theme.ink, width: 0.8, dash: [2, 2] });
      }
      p.text((x0 + x1) / 2, 18, timeOf(z.span), { fill: theme.ink, size: 13, weight: 600,
        align: 'center' });
    };

    const timeOf = ({ begin, end }) => `${end - begin} clocks = ` +
      `${T.num((end - begin) * clockUs, 2)} \u00b5s`;
    const note = T.el('p', { class: 'note' });
    const update = () => {
      overview.redraw();
      zoom.redraw();
      const [shortest, ...others] = legs().flatMap(wholeOf)
        .sort((a, b) => a.end - a.begin - (b.end - b.begin));
      note.textContent = !shortest ? 'No leg switches in this window.' : `${others.length + 1} ` +
        `dead times in the window (grey), the shortest ${timeOf(shortest)}.`;
    };
    const left = T.figure(overview, 'upper and lower switch of each leg');
    const right = T.figure(zoom);
    const choice = (label, names, key) => T.segments(label, names.map((name, k) => [k, name]),
      state[key], (chosen) => {
        state[key] = chosen;
        update();
      });
    left.insertBefore(T.el('div', { class: 'controls' }, choice('Axis', ['X', 'Y'], 'axis'),
      choice('Enlarged leg', kPhases, 'phase')), left.children[1]);
    left.append(note);
    update();
    return T.el('div', { class: 'grid pwm' }, left, right);
  };
})(window.Trammel = window.Trammel || {});
