// SPDX-License-Identifier: Apache-2.0
//
// Rule tables as heat maps: before, after, what changed, and the fuzzy surface they span.
(function (T) {
  'use strict';

  const kUnit = 1 << 20;
  const kKnots = [-6, -4, -2, 0, 2, 4, 6];
  const kGrid = 24;  // facets of the surface, each way

  function heatMap(id, title, small, values, top, digits, visited) {
    const plot = { id, title, print: 'quarter', saveWidth: 460, height: (width) => Math.min(width,
      340) };
    plot.scene = function (p, width, height, theme) {
      const side = Math.min(width - 44, height - 44);
      const x0 = 40 + (width - 44 - side) / 2;
      const cell = side / 7;
      // Pixels of e and de in units; a knot lies in the middle of its cell.
      const x = (e) => x0 + (e / 2 + 3.5) * cell;
      const y = (de) => 4 + side - (de / 2 + 3.5) * cell;
      const at = (n) => [x(kKnots[n % 7]), y(kKnots[Math.floor(n / 7)])];
      const color = (value) => T.diverge(theme, top > 0 ? value / top : 0);
      for (const knot of kKnots) {
        const text = T.num(knot, 0);
        p.text(x0 - 6, y(knot), text, { fill: theme.muted, size: 11, align: 'right',
          middle: true });
        p.text(x(knot), side + 18, text, { fill: theme.muted, size: 11, align: 'center' });
      }
      values.forEach((value, n) => {
        const [cx, cy] = at(n);
        p.rect(cx - cell / 2 + 0.5, cy - cell / 2 + 0.5, cell - 1, cell - 1,
          { fill: color(value) });
      });
      if (visited && visited.e.length > 1) {
        p.path(Array.from(visited.e, (e, k) => [x(e), y(visited.de[k])]).flat(),
          { stroke: theme.ink, width: 1, alpha: 0.7 });
      }
      values.forEach((value, n) => {
        if (cell <= 24 || (digits > 1 && Math.abs(value) < 0.005)) return;
        const [cx, cy] = at(n);
        p.text(cx, cy - (visited ? 0.26 * cell : 0), T.num(value, digits), { align: 'center',
          middle: true, fill: T.inkOn(color(value)), size: cell > 36 ? 11 : 10 });
      });
      p.text(x0 + side / 2, side + 36, 'e (units)', { fill: theme.muted, size: 12,
        align: 'center' });
      p.text(x0 - 32, 4 + side / 2, 'de (units)', { fill: theme.muted, size: 12, align: 'center',
        turn: true });
    };
    return T.figure(plot, small);
  }

  // Output of the fuzzy system at E, DE in units, each -6..6 (specification section 5).
  function output(rules, e, de) {
    const place = (v) => {
      const at = Math.min(5.999, Math.max(0, (v + 6) / 2));
      return [Math.floor(at), at - Math.floor(at)];
    };
    const [i, a] = place(e);
    const [j, b] = place(de);
    const c = (dj, di) => rules[7 * (j + dj) + i + di];
    return (1 - b) * ((1 - a) * c(0, 0) + a * c(0, 1)) + b * ((1 - a) * c(1, 0) + a * c(1, 1));
  }

  function surface(id, title, rules) {
    const plot = { id, title, print: 'quarter', saveWidth: 460, height: (width) => Math.min(width,
      340) };
    plot.scene = function (p, width, height, theme) {
      const scale = Math.min(width / 10.9, height / 7.6);
      const cx = width / 2;
      const cy = height / 2 - scale;
      // e grows to the lower right, de to the upper right, u upward.
      const at = (e, de, u) => [cx + (e + de) * 0.37 * scale,
        cy + (e - de) * 0.185 * scale - u * 0.27 * scale];
      const step = 12 / kGrid;
      const base = [at(-6, -6, -8), at(6, -6, -8), at(6, 6, -8), at(-6, 6, -8)];
      p.path(base.flat(), { stroke: theme.axis, fill: theme.soft, close: true });
      for (let b = kGrid - 1; b >= 0; --b) {
        for (let a = 0; a < kGrid; ++a) {
          const [e, de] = [-6 + a * step, -6 + b * step];
          const corner = (x, y) => at(x, y, output(rules, x, y));
          const fill = T.diverge(theme, output(rules, e + step / 2, de + step / 2) / 7);
          p.path([corner(e, de), corner(e + step, de), corner(e + step, de + step),
            corner(e, de + step)].flat(), { fill, stroke: T.mix(fill, theme.ink, 0.16), width: 0.5,
            close: true });
        }
      }
      const label = { fill: theme.muted, size: 12 };
      const text = ([x, y], dx, dy, words, style) => p.text(x + dx, y + dy, words, { ...label,
        ...style });
      const top = (e, de) => at(e, de, output(rules, e, de));
      const value = (e, de) => T.num(output(rules, e, de), 1);
      for (const de of [-6, 6]) {
        p.path([...at(6, de, -8), ...top(6, de)], { stroke: theme.axis, dash: [3, 3] });
      }
      text(at(1, -6, -8), -10, 16, 'e', { align: 'right' });
      text(at(6, 1, -8), 10, 16, 'de');
      text(top(6, 6), 2, -8, value(6, 6), { size: 11, align: 'center' });
      text(top(-6, -6), 2, -8, value(-6, -6), { size: 11, align: 'center' });
      text(top(-6, 6), 0, -10, 'u (units)', { align: 'center' });
    };
    return T.figure(plot);
  }

  // The cards of one axis; adapting: the rules were tuned.
  T.ruleCards = function (axis, rules, visited, adapting) {
    const name = axis.toUpperCase();
    const before = rules.first.map((c) => c / kUnit);
    const after = rules.last.map((c) => c / kUnit);
    const change = after.map((c, k) => c - before[k]);
    const map = (id, title, small, values, top, digits, line) => heatMap(`rules-${axis}-${id}`,
      `${name} ${title}`, small, values, top, digits, line);
    const last = surface(`surface-${axis}`, `${name} fuzzy surface`, after);
    if (!adapting) return [map('fixed', 'rules', '', before, 7, 1, visited), last];
    const changed = change.filter((c) => c !== 0).length;
    return [map('before', 'rules before', '', before, 7, 1, null),
      map('after', 'rules after', '', after, 7, 1, null),
      map('change', 'change', `${changed} of 49`, change, Math.max(...change.map(Math.abs)), 2,
        visited), last];
  };
})(window.Trammel = window.Trammel || {});
