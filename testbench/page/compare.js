// SPDX-License-Identifier: Apache-2.0
//
// Several runs on one page: errors over time laid over each other, paths, figures with their
// differences from the first run, and the parameters that differ.
(function (T) {
  'use strict';

  const kSample = 0.5e-3;  // [s]

  // Name, unit, digits, where it is; true: more of it is neither good nor bad.
  const kFigures = [
    ['Mean tracking error', 'mm', 3, (m) => m.tracking.model.mean_mm],
    ['Standard deviation', 'mm', 3, (m) => m.tracking.model.std_mm],
    ['Variance', 'mm\u00b2', 3, (m) => m.tracking.model.variance_mm2],
    ['Rms tracking error', 'mm', 3, (m) => m.tracking.model.rms_mm],
    ['Largest tracking error', 'mm', 3, (m) => m.tracking.model.max_mm],
    ['Mean error to the command', 'mm', 3, (m) => m.tracking.command.mean_mm],
    ['Mean contour error', 'mm', 3, (m) => m.contour && m.contour.mean_mm],
    ['Largest contour error', 'mm', 3, (m) => m.contour && m.contour.max_mm],
    ['Overshoot X, first period', '%', 1, (m) => m.x.periods && m.x.periods[0].overshoot_percent],
    ['Overshoot X, last period', '%', 1, (m) => m.x.periods && m.x.periods[m.x.periods.length - 1]
      .overshoot_percent],
    ['Overshoot Y, first period', '%', 1, (m) => m.y.periods && m.y.periods[0].overshoot_percent],
    ['Overshoot Y, last period', '%', 1, (m) => m.y.periods && m.y.periods[m.y.periods.length - 1]
      .overshoot_percent],
    ['Peak current X', 'A', 2, (m) => m.x.peak_current_A, true],
    ['Peak current Y', 'A', 2, (m) => m.y.peak_current_A, true],
    ['Top speed X', 'm/s', 3, (m) => m.x.max_speed_m_s, true],
    ['Top speed Y', 'm/s', 3, (m) => m.y.max_speed_m_s, true],
  ];

  const swatch = (run) => {
    const mark = T.el('i');
    const paint = () => { mark.style.borderTopColor = T.theme().runs[run]; };
    T.onTheme(paint);
    paint();
    return mark;
  };

  const nameOf = (run, k, linked) => T.el('span', { class: 'key' }, T.el('span', {}, swatch(k),
    linked && run.page ? T.el('a', { href: run.page }, run.label) : T.el('b', {}, run.label)));

  // Differences are to the first run of the same path.
  const kindOf = (run) => run.metrics.options['path.kind'];
  const baseOf = (runs, k) => runs.findIndex((run) => kindOf(run) === kindOf(runs[k]));

  function difference(value, base, digits, neutral) {
    const by = value - base;
    if (Math.abs(by) < 0.5 * 10 ** -digits) return T.el('small', {}, '=');
    const part = base !== 0 ? `, ${by > 0 ? '+' : ''}${T.num(by / base * 100, 1)} %` : '';
    return T.el('small', { class: neutral ? null : by < 0 ? 'good-text'
      : 'bad-text' },
      `${by > 0 ? '+' : ''}${T.num(by, digits)}${part}`);
  }

  function figureTable(runs) {
    const rows = [];
    for (const [name, unit, digits, of, neutral] of kFigures) {
      const values = runs.map((run) => of(run.metrics));
      if (values.every((v) => typeof v !== 'number')) continue;
      rows.push([`${name} (${unit})`, ...values.map((v, k) => T.el('td', {},
        typeof v === 'number' ? T.num(v, digits) : '\u2013',
        baseOf(runs, k) < k && typeof v === 'number' ? T.el('div', {}, difference(v,
          values[baseOf(runs, k)], digits, neutral)) : null))]);
    }
    return T.el('div', { class: 'scroll' }, T.table(['Figure', ...runs.map((run, k) => T.el('th',
      {}, nameOf(run, k, true)))], rows));
  }

  function parameterTable(runs) {
    const names = [...new Set(runs.flatMap((run) => Object.keys(run.metrics.options)))]
      .filter((key) => key !== 'name' && key !== 'description');
    const differs = (key) => new Set(runs.map((run) => run.metrics.options[key])).size > 1;
    const rows = names.filter(differs)
      .map((key) => [key, ...runs.map((run) => {
        const value = run.metrics.options[key];
        const same = value === runs[0].metrics.options[key];
        return T.el('td', { class: same ? 'dim' : null }, value === undefined ? '\u2013'
          : T.valueText(value));
      })]);
    if (rows.length === 0) return T.el('p', { class: 'note' }, 'No parameter differs.');
    return T.el('div', { class: 'scroll' }, T.table(['Parameter', ...runs.map((run, k) => T.el('th',
      {}, nameOf(run, k, false)))], rows));
  }

  function paperTable(runs) {
    const rows = runs.flatMap((run, k) => (run.metrics.comparison || []).map((line, n) => T.el('tr',
      {}, T.el('th', {}, n === 0 ? nameOf(run, k, true) : ''), T.el('td', { class: 'text' },
        `${line.what} (${line.unit.replace('mm2', 'mm\u00b2')})`),
      T.el('td', {}, T.num(line.ours, 2)),
      T.el('td', {}, line.paper === undefined ? '\u2013' : T.num(line.paper, 2)),
      T.el('td', {}, line.expected === undefined ? '\u2013' : `${T.num(line.expected, 2)} \u00b1 ` +
        T.num(line.tolerance, 2)),
      T.el('td', { class: line.within === false ? 'bad' : 'good' }, line.within === undefined ? ''
        : line.within ? 'within' : 'outside'))));
    return T.el('div', { class: 'scroll' }, T.table(['Run', T.el('th', { class: 'text' }, 'Figure'),
      'ours', 'paper', 'expected', ''], rows));
  }

  // Runs on one base of time, the samples since point 0; where a run has none there is a gap.
  function alignedErrors(runs) {
    const stride = Math.max(...runs.map((run) => run.stride));
    const count = Math.max(...runs.map((run) => Math.ceil(run.count * run.stride / stride)));
    const times = Float64Array.from({ length: count }, (v, k) => k * stride * kSample);
    const spread = (run, values) => Array.from({ length: count }, (v, k) => {
      const at = Math.round(k * stride / run.stride);
      return at < run.count ? values[at] : null;
    });
    return { times, spread };
  }

  // The table's paths in small frames of one scale, the first run's in grey behind each.
  function pathCards(runs) {
      return runs.map((run, index) => {
      const plot = { id: `path-${index + 1}`, title: run.label, print: 'quarter', saveWidth: 520,
        height: (width) => Math.round(Math.min(width, 420) * 0.95), count: () => run.count };
      plot.scene = function (p, width, height, theme) {
        const box = { x: 54, y: 8, w: width - 64, h: height - 56 };
        const { x, y } = run.data.table;
        const xs = T.range(run.data.command.x, ...T.range(x));
        const ys = T.range(run.data.command.y, ...T.range(y));
        const scale = Math.max((xs[1] - xs[0]) / box.w, (ys[1] - ys[0]) / box.h) * 1.1 || 1;
        const around = ([a, b], n) => [(a + b - scale * n) / 2, (a + b + scale * n) / 2];
        const frame = T.frame(box, around(xs, box.w), around(ys, box.h));
        T.drawFrame(p, theme, frame, { xLabel: 'x (mm)', yLabel: 'y (mm)', xCount: 3, yCount: 3 });
        const line = (of) => Array.from({ length: 2 * run.count }, (v, k) => (k % 2 === 0
          ? frame.x(of.x[k >> 1]) : frame.y(of.y[k >> 1])));
        p.path(line(run.data.command), { stroke: theme.asked, width: 4, alpha: 0.5 });
        p.path(line(run.data.table), { stroke: theme.runs[index], width: 1.6 });
      };
      return T.figure(plot, T.controller(run.metrics));
    });
  }

  T.comparisonPage = function (runs) {
    const main = document.getElementById('top');
    main.append(T.el('div', { class: 'head' }, T.el('div', { class: 'head-title' },
      T.el('h1', {}, `${runs.length} runs compared`)),
    T.el('p', { class: 'lead' }, 'Differences are to the first run of the same path. The error ' +
      'T(k) is the distance of the table from the reference model.')));

    const { times, spread } = alignedErrors(runs);
    T.time.start(times);
    T.time.label = 'Time since the first point (s)';
    // One plot of some runs; a run keeps its colour everywhere.
    const overlay = (id, title, small, of, some) => T.timePlot({ id, title, small, yLabel:
      'error (mm)', tall: 260, series: some.filter((k) => of(runs[k])).map((k) => ({ run: k,
      label: runs[k].label, unit: 'mm', digits: 3, data: spread(runs[k], of(runs[k])) })) });

    const errors = T.section('errors', 'Errors', 'Drag in a plot to zoom all of them, ' +
      'double-click to see everything. A click on a name hides its line.');
    const kinds = [...new Set(runs.map(kindOf))];
    const all = runs.map((run, k) => k);
    const toModel = (run) => run.data.toModel;
    const cards = kinds.length > 1
      ? kinds.map((kind) => overlay(`tracking-${kind}`, `Tracking error T(k), ${kind}`,
        'to the reference model', toModel, all.filter((k) => kindOf(runs[k]) === kind)))
      : [overlay('tracking', 'Tracking error T(k)', 'to the reference model', toModel, all),
        ...(runs.some((run) => run.data.toPath) ? [overlay('contour', 'Contour error',
          'to the commanded path', (run) => run.data.toPath, all)] : []),
        overlay('error-x', 'X error', 'to the reference model', (run) => run.data.errorX, all),
        overlay('error-y', 'Y error', 'to the reference model', (run) => run.data.errorY, all)];
    errors.append(T.el('div', { class: 'grid two' }, cards));
    // Steps last long; beside them the paths would be a corner of their plots.
    const paths = runs.filter((run) => kindOf(run) !== 'square');
    T.time.opening = kinds.length > 1 && paths.length > 0 ? Math.max(...paths.map((run) =>
      (run.count - 1) * run.stride * kSample)) : null;

    T.section('figures', 'Figures', '').append(T.el('div', { class: 'card long' },
      figureTable(runs)));
    T.section('paths', 'Paths', 'Command in grey, table in the colour of its run.').append(T.el(
      'div', { class: 'grid four' }, pathCards(runs)));
    if (runs.some((run) => run.metrics.comparison)) {
      T.section('paper', 'Paper', 'Figures of Kung et al. 2012 (DOI 10.5772/48457), and those ' +
        'expected of a bit-exact model.').append(T.el('div', { class: 'card long' },
        paperTable(runs), T.paperNote(runs.map((run) => run.metrics))));
    }
    T.section('parameters', 'Changed parameters', '').append(T.el('div', { class: 'card long' },
      parameterTable(runs)));
    T.section('runs', 'Runs', '').append(T.el('div', { class: 'card long' }, T.el('div',
      { class: 'scroll' }, T.table(['Run', T.el('th', { class: 'text' }, 'Outcome'), T.el('th',
        { class: 'text' }, 'Command that repeats it')], runs.map((run, k) => T.el('tr', {},
        T.el('th', {}, nameOf(run, k, true)), T.el('td', { class: 'text' }, run.metrics.verdict),
        T.el('td', { class: 'text' }, T.el('code', {}, run.metrics.command))))))));
  };
})(window.Trammel = window.Trammel || {});
