// SPDX-License-Identifier: Apache-2.0
//
// What a page of several runs of the X-Y table compares.
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

  function paperTable(runs) {
    const rows = runs.flatMap((run, k) => (run.metrics.comparison || []).map((line, n) => T.el('tr',
      {}, T.el('th', {}, n === 0 ? T.runName(run, k, true) : ''), T.el('td', { class: 'text' },
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

  const kindOf = (run) => run.metrics.options['path.kind'];

  function errorCards(runs, overlay) {
    const plot = (id, title, small) => ({ id, title, small, yLabel: 'error (mm)', unit: 'mm',
      digits: 3 });
    const kinds = [...new Set(runs.map(kindOf))];
    const toModel = (run) => run.data.toModel;
    if (kinds.length > 1) {
      return kinds.map((kind) => overlay(plot(`tracking-${kind}`, `Tracking error T(k), ${kind}`,
        'to the reference model'), toModel, (run) => kindOf(run) === kind));
    }
    return [overlay(plot('tracking', 'Tracking error T(k)', 'to the reference model'), toModel),
      ...(runs.some((run) => run.data.toPath) ? [overlay(plot('contour', 'Contour error',
        'to the commanded path'), (run) => run.data.toPath)] : []),
      overlay(plot('error-x', 'X error', 'to the reference model'), (run) => run.data.errorX),
      overlay(plot('error-y', 'Y error', 'to the reference model'), (run) => run.data.errorY)];
  }

  function sections(runs) {
    T.section('paths', 'Paths', 'Command in grey, table in the colour of its run.').append(T.el(
      'div', { class: 'grid four' }, T.pathCards(runs, (run) => T.controller(run.metrics))));
    if (runs.some((run) => run.metrics.comparison)) {
      T.section('paper', 'Paper', 'Figures of Kung et al. 2012 (DOI 10.5772/48457), and those ' +
        'expected of a bit-exact model.').append(T.el('div', { class: 'card long' },
        paperTable(runs), T.paperNote(runs.map((run) => run.metrics))));
    }
  }

  // Steps last long; beside them the paths would be a corner of their plots.
  function opening(runs) {
    const paths = runs.filter((run) => kindOf(run) !== 'square');
    return new Set(runs.map(kindOf)).size > 1 && paths.length > 0 ? Math.max(...paths.map((run) =>
      (run.count - 1) * run.stride * kSample)) : null;
  }

  T.kungComparison = { kindOf, sample: kSample, figures: kFigures, plots: errorCards, sections,
    opening, heading: 'Errors', timeLabel: 'Time since the first point (s)',
    lead: 'Differences are to the first run of the same path. The error T(k) is the distance of ' +
      'the table from the reference model.' };
})(window.Trammel = window.Trammel || {});
