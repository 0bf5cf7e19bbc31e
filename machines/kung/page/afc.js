// SPDX-License-Identifier: Apache-2.0
//
// The 35 steps of the position controller (rtl/control/afc.sv) in one sample: what multiplier and
// adder do in each, and the words they leave.
(function (T) {
  'use strict';

  // A word as a physical value; s: what a step of the axis' words is.
  const kCount = (w, s) => `${T.num(w * s.count_m * 1e3, 3)} mm`;
  const kModel = (w, s) => `${T.num(w / 16384 * s.count_m * 1e3, 4)} mm`;
  const kChange = (w, s) => `${T.num(w * s.speed_m_s * 16, 4)} m/s`;
  const kSpeed = (w, s) => `${T.num(w * s.speed_m_s, 4)} m/s`;
  const kIntegral = (w, s) => kSpeed(w / 4096, s);
  const kCurrent = (w, s) => `${T.num(w * s.command_A, 4)} A`;
  const kUnit = (w) => `${T.num(w / 256, 3)} units`;
  const kWeight = (w) => T.num(w / 2048, 4);
  const kRule = (w) => `${T.num(w / 1048576, 4)} units`;
  // Group, product of the multiplier, what adder or logic leaves, its physical value.
  const kSteps = [
    ['model', 'B2 \u00b7 dx', 't = r(k) + r(k\u22122)'],
    ['model', '', 't + 2 r(k\u22121)'],
    ['model', '', 's = 64 t \u2212 x_m / 64'],
    ['model', 'A0 \u00b7 s', 'B2 product, rounded'],
    ['model', '', 'dx, increment of the model', kModel],
    ['model', '', 'x_m, position of the model', kModel],
    ['model', '', 'x_r, rounded to counts', kCount],
    ['error', '', 'v, speed', kSpeed],
    ['error', '', 'e = x_r \u2212 x_p', kCount],
    ['error', '', 'de = e \u2212 e(k\u22121)', kChange],
    ['fuzzify', '', 'membership of e in the lower set', kWeight],
    ['fuzzify', '', 'DE, scaled and clipped', kUnit],
    ['fuzzify', '', 'membership of de in the lower set', kWeight],
    ['fuzzify', '', ''],  // empty: the rules are read where they are used
    ['infer', '\u03bcA0 \u00b7 \u03bcB0', ''],
    ['infer', '\u03bcA1 \u00b7 \u03bcB0', 'd00', kWeight],
    ['infer', '\u03bcA0 \u00b7 \u03bcB1', 'd01', kWeight],
    ['infer', '\u03bcA1 \u00b7 \u03bcB1', 'd10', kWeight],
    ['infer', 'c00 \u00b7 d00', 'd11', kWeight],
    ['infer', 'c01 \u00b7 d01', 'sum, one term'],
    ['infer', 'c10 \u00b7 d10', 'sum, two terms'],
    ['infer', 'c11 \u00b7 d11', 'sum, three terms'],
    ['infer', '', 'u, output of the fuzzy system', kUnit],
    ['control', 'Kp \u00b7 u', 'feed-forward'],
    ['control', 'Ki \u00b7 u', 'Kp product, rounded', kSpeed],
    ['control', '', 'I, integrator', kIntegral],
    ['control', '', 'v*, speed command', kSpeed],
    ['control', '', 'v* \u2212 v', kSpeed],
    ['control', 'Kv \u00b7 (v* \u2212 v)', ''],
    ['control', 'ETA \u00b7 e', 'i_q*, published', kCurrent],
    ['tune', 't \u00b7 d00', 't = ETA e kept'],
    ['tune', 't \u00b7 d01', 'c00, written back', kRule],
    ['tune', 't \u00b7 d10', 'c01, written back', kRule],
    ['tune', 't \u00b7 d11', 'c10, written back', kRule],
    ['tune', '', 'c11, written back; e and x_p kept', kRule],
  ];
  const kGroups = { model: 'Reference model', error: 'Errors', fuzzify: 'Memberships',
    infer: 'Inference', control: 'PI, speed, current', tune: 'Tuning' };
  const kRoles = { model: 'model', error: 'asked', fuzzify: 'y', infer: 'x',
    control: 'actual', tune: 'other' };
  const kStepUs = 0.04;

  // steps: of the words of both axes; adapting: the rules were tuned.
  T.afcStrip = function (moment, steps, adapting) {
    const state = { step: 29 };
    const axes = ['x', 'y'];
    const word = (axis, step, which) => moment[axis].steps[step][which];
    const cell = (width) => (width - 96) / 35;

    const plot = { id: 'afc', title: 'Position controller, 35 steps', print: 'wide',
      height: () => 172 };
    plot.scene = function (p, width, height, theme) {
      const x0 = 82;
      const w = cell(width);
      const rows = { groups: 8, multiplier: 40, adder: 80 };
      for (const [text, y] of [['multiplier', 40], ['adder, logic', 80]]) {
        p.text(x0 - 10, y + 17, text, { fill: theme.muted, size: 12, align: 'right',
          middle: true });
      }
      for (let k = 0; k < 35;) {
        let end = k;
        while (end < 35 && kSteps[end][0] === kSteps[k][0]) ++end;
        const color = theme[kRoles[kSteps[k][0]]];
        p.rect(x0 + k * w + 1, rows.groups + 20, (end - k) * w - 2, 3, { fill: color });
        const name = kGroups[kSteps[k][0]];
        if (name && (end - k) * w > 6.2 * name.length) {
          p.text(x0 + (k + end) / 2 * w, rows.groups + 12, name, { fill: theme.muted, size: 12,
            align: 'center' });
        }
        k = end;
      }
      kSteps.forEach(([group, product, result], k) => {
        const color = theme[kRoles[group]];
        const at = x0 + k * w;
        p.rect(at + 1, rows.multiplier, w - 2, 34, product ? { fill: color, alpha: 0.8 }
          : { fill: theme.soft });
        p.rect(at + 1, rows.adder, w - 2, 34, result ? { fill: color, alpha: 0.45 }
          : { fill: theme.soft });
        if (w > 19 || k % 5 === 4 || k === 0) {
          p.text(at + w / 2, 132, `s${k}`, { fill: k === 29 ? theme.ink : theme.muted, size: 11,
            weight: k === 29 ? 600 : 400, align: 'center' });
        }
      });
      const done = x0 + 30 * w;
      p.path([done, 34, done, 120], { stroke: theme.ink, width: 1.3 });
      p.text(done - 5, height - 6, 'i_q* is out after s29', { fill: theme.ink, size: 12,
        align: 'right' });
      if (w > 14) {
        p.text(x0, height - 6, `${kStepUs * 1000} ns a step, 1.4 \u00b5s in all`, {
          fill: theme.muted, size: 12 });
      }
    };
    plot.overlay = function (p, width, height, theme) {
      const w = cell(width);
      p.rect(82 + state.step * w, 37, w, 80, { stroke: theme.accent, width: 2 });
    };

    const detail = T.el('dl', { class: 'step' });
    const rows = kSteps.map(([, product, result, physical], k) => T.el('tr', {},
      T.el('th', {}, `s${k}`), T.el('td', { class: 'text' }, product),
      T.el('td', { class: 'text' }, result),
      ...axes.flatMap((axis) => {
        const value = word(axis, k, 1);
        return [T.el('td', {}, value === null ? '' : T.whole(value)),
          T.el('td', { class: 'dim' }, value === null || !physical ? ''
            : physical(value, steps[axis]))];
      })));

    // What the chosen step does: its words and, where they have one, their physical values.
    function tell() {
      const [group, product, result, physical] = kSteps[state.step];
      const line = (what, which) => [T.el('dt', {}, which === 0 ? 'multiplier' : 'adder, logic'),
        T.el('dd', {}, what), ...axes.map((axis) => {
          const value = word(axis, state.step, which);
          return T.el('dd', {}, T.el('b', {}, T.whole(value)), which === 1 && physical
            ? ` = ${physical(value, steps[axis])}` : '');
        })];
      detail.replaceChildren(T.el('dt', {}, T.el('b', {}, `s${state.step}`)),
        T.el('dd', {}, kGroups[group]), T.el('dt', {}, 'X'), T.el('dt', {}, 'Y'),
        ...(product ? line(product, 0) : []),
        ...(result && word('x', state.step, 1) !== null ? line(result, 1) : []));
      rows.forEach((row, k) => row.classList.toggle('picked', k === state.step));
    }

    const card = T.figure(plot, 'point at a step');
    card.classList.add('long');
    plot.canvas.addEventListener('mousemove', (event) => {
      const k = Math.floor((event.offsetX - 82) / cell(plot.canvas.clientWidth));
      if (k < 0 || k > 34 || k === state.step) return;
      state.step = k;
      plot.redrawOver();
      tell();
    });
    tell();
    card.append(detail, T.el('details', {}, T.el('summary', {}, 'All 35 steps as a table'),
      T.el('div', { class: 'scroll' }, T.table([T.el('th', {}, 'Step'),
        T.el('th', { class: 'text' }, 'Multiplier'), T.el('th', { class: 'text' },
          'Adder, logic'), 'X word', '', 'Y word', ''], rows))));
    if (!adapting) {
      card.append(T.el('p', { class: 'note' },
        'FC: the rules are not tuned; s31 to s34 compute, but write nothing.'));
    }
    return card;
  };
})(window.Trammel = window.Trammel || {});
