// SPDX-License-Identifier: Apache-2.0
//
// Several runs on one page: errors over time laid over each other, paths, figures with their
// differences from the first run, and the parameters that differ.
(function (T) {
  'use strict';

  T.runName = (run, k, linked) => T.el('span', { class: 'key' }, T.el('span', {},
    T.el('i', { style: `border-top-color: var(--run${k % T.light.runs.length});` +
      (T.runDash(k) ? 'border-top-style: dashed' : '') }),
    linked && run.page ? T.el('a', { href: run.page }, run.label) : T.el('b', {}, run.label)));

  // Differences are to the first run of the same kind.
  const baseOf = (runs, kindOf, k) => runs.findIndex((run) => kindOf(run) === kindOf(runs[k]));

  function difference(value, base, digits, neutral) {
    const by = value - base;
    if (Math.abs(by) < 0.5 * 10 ** -digits) return T.el('small', {}, '=');
    const part = base !== 0 ? `, ${by > 0 ? '+' : ''}${T.num(by / base * 100, 1)} %` : '';
    return T.el('small', { class: neutral ? null : by < 0 ? 'good-text'
      : 'bad-text' },
      `${by > 0 ? '+' : ''}${T.num(by, digits)}${part}`);
  }

  function figureTable(runs, machine) {
    const base = (k) => baseOf(runs, machine.kindOf, k);
    const rows = T.commonFigures(runs, machine.figures).map(([f, values]) => {
      const known = (k) => values[k] !== undefined;
      return [T.capital(T.withUnit(f.name, f.unit)), ...values.map((v, k) => [
        known(k) ? T.figureText(f, v) : '\u2013',
        base(k) < k && known(k) && known(base(k)) ? T.el('div', {}, difference(v, values[base(k)],
          f.digits || 0, !machine.smallerIsBetter(f))) : null])];
    });
    return T.tableCard(['Figure', ...runs.map((run, k) => T.el('th', {}, T.runName(run, k,
      true)))], rows);
  }

  function parameterTable(runs) {
    const [{ metrics: { options: first } }] = runs;
    const names = [...new Set(runs.flatMap((run) => Object.keys(run.metrics.options)))]
      .filter((key) => key !== 'name' && key !== 'description');
    const differs = (key) => runs.some((run) => run.metrics.options[key] !== first[key]);
    const rows = names.filter(differs).map((key) => [key, ...runs.map((run) => {
      const value = run.metrics.options[key];
      return T.el('td', { class: value === first[key] ? 'dim' : null }, value === undefined
        ? '\u2013' : T.valueText(value));
    })]);
    if (rows.length === 0) return T.el('p', { class: 'note' }, 'No parameter differs.');
    return T.tableCard(['Parameter', ...runs.map((run, k) => T.el('th', {}, T.runName(run, k,
      false)))], rows);
  }

  // Runs on one base of time, the samples since their first; where a run has none there is a gap.
  function aligned(runs, sample) {
    const stepOf = (run) => run.stride * (typeof sample === 'number' ? sample : sample(run, runs));
    const step = Math.max(...runs.map(stepOf));
    const count = Math.max(...runs.map((run) => Math.ceil(run.count * stepOf(run) / step)));
    const times = Float64Array.from({ length: count }, (v, k) => k * step);
    const spread = (run, values) => Array.from({ length: count }, (v, k) => {
      const at = Math.round(k * step / stepOf(run));
      return at < run.count ? values[at] : null;
    });
    return { times, spread };
  }

  T.comparisonPage = function (runs, { compare: machine, figureNote }) {
    const main = document.getElementById('top');
    main.append(T.el('div', { class: 'head' }, T.el('div', { class: 'head-title' },
      T.el('h1', {}, `${runs.length} runs compared`)), T.el('p', { class: 'lead' }, machine.lead)));

    const { times, spread } = aligned(runs, machine.sample);
    T.time.start(times);
    T.time.label = machine.timeLabel;
    // One plot of some runs; a run keeps its colour everywhere.
    const overlay = (plot, of, some = () => true) => T.timePlot({ ...plot, tall: 260,
      series: runs.map((run, k) => [run, k]).filter(([run]) => some(run) && of(run)).map(([run,
        k]) => ({ run: k, dash: T.runDash(k), label: run.label, unit: plot.unit,
        digits: plot.digits, data: spread(run, of(run)) })) });

    if (times.length > 1) {
      T.section('errors', machine.heading, T.zoomLead()).append(T.el('div', { class: 'grid two' },
        machine.plots(runs, overlay)));
      T.time.opening = machine.opening(runs);
    }

    T.section('figures', 'Figures', '').append(figureTable(runs, machine));
    machine.sections(runs);
    if (runs.some((run) => T.judged(run.metrics).length > 0)) {
      const judged = T.judgedTable(runs);
      const note = T.sourceNote(runs.map((run) => run.metrics), figureNote);
      if (note) judged.append(note);
      T.section('judged', 'Printed and expected', '').append(judged);
    }
    T.section('parameters', 'Parameters that differ', '').append(parameterTable(runs));
    T.section('runs', 'Runs', '').append(T.tableCard(['Run', ['Outcome', 'text'], [
      'Command to repeat it', 'text']], runs.map((run, k) => [T.runName(run, k, true),
      run.metrics.verdict, T.el('code', {}, run.metrics.command)])));
  };
})(window.Trammel = window.Trammel || {});
