// SPDX-License-Identifier: Apache-2.0
//
// The 35 steps of the position controller (rtl/control/afc.sv) in one sample: what multiplier and
// adder do in each, and the words they leave.
(function (T) {
  'use strict';

  // A word as a physical value; s: the units of the axis' words.
  const kCount = (w, s) => `${T.num(w * s.count_m * 1e3, 3)} mm`;
  const kModel = (w, s) => `${T.num(w / 16384 * s.count_m * 1e3, 4)} mm`;
  const kChange = (w, s) => `${T.num(w * s.speed_m_s * 16, 4)} m/s`;
  const kSpeed = (w, s) => `${T.num(w * s.speed_m_s, 4)} m/s`;
  const kIntegral = (w, s) => kSpeed(w / 4096, s);
  const kCurrent = (w, s) => `${T.num(w * s.command_A, 4)} A`;
  const kUnit = (w) => `${T.num(w / 256, 3)} units`;
  const kFine = (w) => kUnit(w / 4);
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
    ['fuzzify', '', 'DE, scaled and clipped', kFine],
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
    ['tune', 't \u00b7 d00', 't = ETA e, stored'],
    ['tune', 't \u00b7 d01', 'c00, written back', kRule],
    ['tune', 't \u00b7 d10', 'c01, written back', kRule],
    ['tune', 't \u00b7 d11', 'c10, written back', kRule],
    ['tune', '', 'c11, written back; e and x_p stored', kRule],
  ];
  // Of each group its name and the role that colours it.
  const kGroups = { model: ['Reference model', 'model'], error: ['Errors', 'asked'],
    fuzzify: ['Memberships', 'y'], infer: ['Inference', 'x'],
    control: ['PI, speed, current', 'actual'], tune: ['Tuning', 'other'] };
  const kStepNs = 40;
  const kLeft = 82;  // pixels before the first step

  // units: of the words of both axes; adapting: the rules were tuned.
  T.afcStrip = function (moment, units, adapting) {
    let picked = 29;
    const axes = ['x', 'y'];
    const cell = (width) => (width - 96) / 35;
    const wordOf = (axis, k, which) => moment[axis].steps[k][which];
    const physicalOf = (axis, k) => {
      const physical = kSteps[k][3];
      return physical && wordOf(axis, k, 1) !== null
        ? physical(wordOf(axis, k, 1), units[axis]) : '';
    };

    const plot = { id: 'afc', title: 'Position controller, 35 steps', print: 'wide',
      height: () => 172 };
    plot.scene = function (p, width, height, theme) {
      const w = cell(width);
      const at = (k) => kLeft + k * w;
      for (const [text, y] of [['multiplier', 40], ['adder, logic', 80]]) {
        p.text(kLeft - 10, y + 17, text, { fill: theme.muted, size: 12, align: 'right',
          middle: true });
      }
      for (const [group, [name, role]] of Object.entries(kGroups)) {
        const first = kSteps.findIndex((step) => step[0] === group);
        const count = kSteps.filter((step) => step[0] === group).length;
        p.rect(at(first) + 1, 28, count * w - 2, 3, { fill: theme[role] });
        if (count * w > 6.2 * name.length) {
          p.text(at(first + count / 2), 20, name, { fill: theme.muted, size: 12,
            align: 'center' });
        }
      }
      kSteps.forEach(([group, product, result], k) => {
        const color = theme[kGroups[group][1]];
        for (const [y, used, alpha] of [[40, product, 0.8], [80, result, 0.45]]) {
          p.rect(at(k) + 1, y, w - 2, 34, used ? { fill: color, alpha } : { fill: theme.soft });
        }
        if (w > 19 || k % 5 === 4 || k === 0) {
          p.text(at(k + 0.5), 132, `s${k}`, { fill: k === 29 ? theme.ink : theme.muted, size: 11,
            weight: k === 29 ? 600 : 400, align: 'center' });
        }
      });
      p.path([at(30), 34, at(30), 120], { stroke: theme.ink, width: 1.3 });
      p.text(at(30) - 5, height - 6, 'i_q* is ready after s29', { fill: theme.ink, size: 12,
        align: 'right' });
      if (w > 14) {
        const all = T.num(kStepNs * 35e-3, 1);
        p.text(kLeft, height - 6, `${kStepNs} ns per step, ${all} \u00b5s in all`, {
          fill: theme.muted, size: 12 });
      }
    };
    plot.overlay = function (p, width, height, theme) {
      const w = cell(width);
      p.rect(kLeft + picked * w, 37, w, 80, { stroke: theme.accent, width: 2 });
    };

    const detail = T.el('dl', { class: 'step' });
    const rows = kSteps.map(([, product, result], k) => T.el('tr', {},
      T.el('th', {}, `s${k}`), T.el('td', { class: 'text' }, product),
      T.el('td', { class: 'text' }, result),
      ...axes.flatMap((axis) => {
        const word = wordOf(axis, k, 1);
        return [T.el('td', {}, word === null ? '' : T.whole(word)),
          T.el('td', { class: 'dim' }, physicalOf(axis, k))];
      })));

    // What the picked step does: its words and, where they have one, their physical values.
    function showStep() {
      const [group, ...parts] = kSteps[picked];
      detail.replaceChildren(T.el('dt', {}, T.el('b', {}, `s${picked}`)),
        T.el('dd', {}, kGroups[group][0]), T.el('dt', {}, 'X'), T.el('dt', {}, 'Y'),
        ...['multiplier', 'adder, logic'].flatMap((where, which) => (
          !parts[which] || wordOf('x', picked, which) === null ? []
            : [T.el('dt', {}, where), T.el('dd', {}, parts[which]), ...axes.map((axis) => {
              const physical = which === 1 ? physicalOf(axis, picked) : '';
              return T.el('dd', {}, T.el('b', {}, T.whole(wordOf(axis, picked, which))),
                physical ? ` = ${physical}` : '');
            })])));
      rows.forEach((row, k) => row.classList.toggle('picked', k === picked));
    }

    const card = T.figure(plot, 'hover over a step');
    card.classList.add('long');
    plot.canvas.addEventListener('mousemove', (event) => {
      const k = Math.floor((event.offsetX - kLeft) / cell(plot.canvas.clientWidth));
      if (k < 0 || k > 34 || k === picked) return;
      picked = k;
      plot.redrawOver();
      showStep();
    });
    showStep();
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
