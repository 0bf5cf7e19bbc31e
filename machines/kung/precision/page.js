// SPDX-License-Identifier: Apache-2.0
//
// Sections of a run of the precision controller: its error against the command, in micrometres, the
// other controllers beside it, what i_q* is made of, and what the axes were taken for.
(function (T) {
  'use strict';

  const kAxes = ['x', 'y'];
  const kMostTwo = 100;  // [um] from which on errors are whole

  const flat = (run, value) => new Float64Array(run.count).fill(value);
  const title = (axis, text) => `${axis.toUpperCase()} ${text}`;
  const two = (...cards) => T.el('div', { class: 'grid two' }, ...cards);

  // Of the series of precision.csv, by axis; a page of several runs has none.
  T.preciseData = function (run) {
    const s = run.series;
    const axes = (name) => ({ x: s[`x_${name}`], y: s[`y_${name}`] });
    return { counted: s.counted, error: axes('error_um'), speed: axes('command_m_s'),
      accel: axes('command_m_s2'), d: axes('d_m_s2') };
  };

  const isDriven = (run) => run.metrics.run.feed_m_s !== undefined;

  // ---- errors ----

  function errorPlots(run, precise) {
    const { error } = precise;
    const line = (label, data, role, more) => ({ label, data, role, unit: '\u00b5m', digits: 2,
      ...more });
    const both = T.timePlot({ id: 'precision-both', title: 'Distance from the command',
      small: 'both axes', yLabel: 'error (\u00b5m)', tall: 270, series: [
        line('distance', error.x.map((v, k) => Math.hypot(v, error.y[k])), 'total')] });
    const plots = kAxes.map((axis) => {
      const count = run.metrics.options[`plant.${axis}.encoder_count_m`] * 1e6;
      return T.timePlot({ id: `precision-${axis}`, title: title(axis, 'error'),
        small: 'to the command', yLabel: 'error (\u00b5m)', series: [
          line('error', error[axis], axis),
          line('one count', flat(run, count), 'asked', { width: 1 }),
          line('minus one count', flat(run, -count), 'asked', { width: 1 })] });
    });
    return [both, plots];
  }

  T.precisionSection = function (run, precise) {
    const lead = isDriven(run) ? 'True position of the table against the command in double ' +
      'precision. Its identification move before the path is not shown, and figures count the ' +
      'samples from its first point to its last one.'
      : 'True position of the table against the set point: points with times of their own have ' +
      'no other command.';
    const section = T.section('precision', 'Error in micrometres',
      [`${lead} The lines of one count are a step of the encoder away. `, T.zoomLead()]);
    const [both, plots] = errorPlots(run, precise);
    section.append(T.el('div', { class: 'grid path' }, T.besidePathPlot(run, precise), T.el('div',
      { class: 'stack' }, both, T.histogramPlot(run, precise))), two(plots));
    if (kAxes.every((axis) => run.detail.spectrum[axis].length > 0)) {
      section.append(two(kAxes.map((axis) => T.spectrumPlot(run, precise, axis))));
    }
    const laps = run.metrics.figures.filter((f) => /^lap_error_um\./.test(f.id));
    if (laps.length > 0) section.append(two(T.lapPlot(laps.map((f) => f.value))));
    section.append(comparison(run.metrics));
  };

  // ---- the other controllers ----

  const umText = (value) => (value >= kMostTwo ? T.whole(value) : T.num(value, 2));

  // This run, the others on its feed profile, and what the paper prints.
  function comparison(m) {
    const value = (figures, id) => (figures.find((f) => f.id === id) || {}).value;
    const ids = ['error_um.mean', 'error_um.rms', 'error_um.p99', 'error_um.max',
      'contour_um.mean', 'contour_um.max'];
    const row = (name, figures) => [name, ...ids.map((id) => umText(value(figures, id))),
      T.num(value(figures, 'tracking.model.mean_mm'), 3), T.num(value(figures, 'peak_current_A'),
        2)];
    const paper = Object.entries(m.paper || {}).map(([name, { mean_mm: mean }]) => [
      `${name}, the paper's`, ...ids.map(() => '\u2013'), T.num(mean, 2), '\u2013']);
    const card = T.tableCard(['', 'error, mean (\u00b5m)', 'rms', '99 % below', 'max',
      'from the path, mean (\u00b5m)', 'max', 'to its model, mean (mm)', 'peak current (A)'],
    [row('precision, this run', m.figures), ...Object.entries(m.compared || {}).map(([name, run]) =>
      row(`${name}, same command`, run.figures)), ...paper]);
    card.prepend(T.el('header', {}, T.el('h3', {}, 'Beside the other controllers')));
    card.append(T.el('p', { class: 'note' }, 'FC and AFC follow a reference model that lags ' +
      'behind the command; the precision controller\u2019s is its set point.' +
      (paper.length > 0 ? ' The paper (Kung Table 2) prints the error to the model alone, of ' +
      'this path at constant speed without a payload.' : '')));
    card.id = 'beside';
    return card;
  }

  // ---- command and current ----

  function commandPlots(run, precise) {
    const o = run.metrics.options;
    const { speed } = precise;
    const line = (label, data, role, unit, more) => ({ label, data, role, unit, digits: 3,
      ...more });
    const limits = (value, unit) => (value === undefined ? [] : [line('limit', flat(run, value),
      'asked', unit, { dash: [6, 4] })]);
    const along = T.timePlot({ id: 'command-speed', title: 'Speed along the path',
      small: 'limit: the highest feed', yLabel: 'speed (m/s)', series: [
        line('command', speed.x.map((v, k) => Math.hypot(v, speed.y[k])), 'total', 'm/s'),
        ...limits(run.metrics.run.feed_m_s, 'm/s')] });
    return [along, ...kAxes.flatMap((axis) => [
      T.timePlot({ id: `command-speed-${axis}`, title: title(axis, 'speed'), yLabel: 'speed (m/s)',
        series: [line('command', speed[axis], 'asked', 'm/s', { width: 2.5 }),
          line('table', run.series[`${axis}_v_m_s`], 'actual', 'm/s')] }),
      T.timePlot({ id: `command-accel-${axis}`, title: title(axis, 'acceleration'),
        small: `limit: path.${axis}.accel_m_s2`, yLabel: 'acceleration (m/s\u00b2)', series: [
          line('command', precise.accel[axis], axis, 'm/s\u00b2'),
          ...[1, -1].flatMap((sign) => limits(isDriven(run) ? sign *
            o[`path.${axis}.accel_m_s2`] : undefined, 'm/s\u00b2'))] })])];
  }

  // Name in precision.csv, label, colour of the parts of i_q*.
  const kParts = [['accel', 'acceleration', 'model'], ['speed', 'speed', 'x'],
    ['friction', 'friction', 'y'], ['force', 'IFF', 'other'], ['feedback', 'feedback', 'actual']];

  function currentPlots(run, precise, commandA) {
    return [...kAxes.map((axis) => T.timePlot({ id: `parts-${axis}`,
      title: title(axis, 'i_q*, its parts'), yLabel: 'current (A)', tall: 250, series: [
        { label: 'i_q*', data: run.series[`${axis}_i_q_ref`].map((v) => v * commandA[axis]),
          role: 'asked', unit: 'A', digits: 3, width: 3 },
        ...kParts.map(([name, label, role]) => ({ label, role, unit: 'A', digits: 3,
          data: run.series[`${axis}_iq_${name}_A`] }))] })),
    ...kAxes.map((axis) => T.timePlot({ id: `d-${axis}`, title: title(axis, 'd'),
      small: 'disturbance that the observer sees', yLabel: 'd (m/s\u00b2)', series: [
        { label: 'd', data: precise.d[axis], role: axis, unit: 'm/s\u00b2', digits: 3 }] }))];
  }

  // commandA: LSB of i_q* of each axis [A].
  T.effortSection = function (run, precise, commandA) {
    const section = T.section('effort', 'Command and current', 'The command that is followed, ' +
      'and i_q* as the sum of its parts at the tick of each sample: computed from words of the ' +
      'chip by docs/precision.md, section 4. Feedback includes d; IFF is the firmware\u2019s ' +
      'current for cogging and constant forces.');
    const [along, ...plots] = commandPlots(run, precise);
    section.append(along, two(plots), two(currentPlots(run, precise, commandA)));
  };

  // ---- estimates ----

  T.estimateSection = function (run) {
    const o = run.metrics.options;
    const plant = (axis, key) => o[`plant.${axis}.${key}`];
    // Id, title, label and unit of the axis, what the chip was told, the truth of the plant.
    const kinds = [
      ['mass', 'mass', 'mass', 'kg', 'mass_kg', (axis) => flat(run, plant(axis, 'mass_kg') +
        plant(axis, 'payload_kg'))],
      ['coulomb', 'Coulomb friction', 'force', 'N', 'coulomb_N', (axis) => flat(run, plant(axis,
        'coulomb_N'))],
      ['viscous', 'viscous friction', 'friction', 'N s/m', 'viscous_N_s_m', (axis) => flat(run,
        plant(axis, 'viscous_N_s_m'))],
      ['force', 'cogging and force', 'force', 'N', 'iff_N', (axis) => run.series[
        `${axis}_held_N`]],
    ];
    const section = T.section('estimates', 'Estimates', 'What the firmware took the axes for, as ' +
      'it told the chip (KM, FC, KB, IFF), beside what the plant is.');
    section.append(two(kinds.flatMap(([id, name, label, unit, column, truth]) => kAxes.map(
      (axis) => T.timePlot({ id: `estimate-${id}-${axis}`, title: title(axis, name),
        yLabel: `${label} (${unit})`, series: [
          { label: 'plant', data: truth(axis), role: 'asked', unit, digits: 2, width: 2.5 },
          { label: 'estimate', data: run.series[`${axis}_${column}`], role: 'actual', unit,
            digits: 2 }] })))));
  };
})(window.Trammel = window.Trammel || {});
