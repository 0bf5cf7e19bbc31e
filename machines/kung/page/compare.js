// SPDX-License-Identifier: Apache-2.0
//
// What a page of several runs of the X-Y table compares.
(function (T) {
  'use strict';

  const sampleOf = (run) => 1 / run.metrics.options['chip.position_Hz'];  // [s]

  const kFigures = [/^tracking\.(model\.|command\.mean)/, /^contour\.(mean|max)/,
    /^(error|contour)_um\.(mean|max)/,
    /^[xy]\.(periods\.0\.overshoot|peak_current|max_speed)/];

  // Of the periods the first and the last, which is a tile.
  const figures = (f) => kFigures.some((form) => form.test(f.id)) ||
    T.isResponse(f) || (T.isPeriod(f) && f.tile !== undefined);
  const smallerIsBetter = (f) => /_mm2?$|_percent$|_um\.\w+$/.test(f.id);

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
  }

  // A square wave lasts long: on its time scale the paths would fill a corner of their plots.
  function opening(runs) {
    const paths = runs.filter((run) => kindOf(run) !== 'square');
    return new Set(runs.map(kindOf)).size > 1 && paths.length > 0 ? Math.max(...paths.map((run) =>
      (run.count - 1) * run.stride * sampleOf(run))) : null;
  }

  T.kungComparison = { kindOf, sample: sampleOf, figures, smallerIsBetter, plots: errorCards,
    sections, opening, heading: 'Errors', timeLabel: 'Time since the first point (s)',
    lead: 'Differences are to the first run of the same path. The error T(k) is the distance of ' +
      'the table from the reference model, with the precision controller from its set point.' };
})(window.Trammel = window.Trammel || {});
