// SPDX-License-Identifier: Apache-2.0
//
// The page of the X-Y table. Data shared by its plots are computed here once, in millimetres.
(function (T) {
  'use strict';

  const kMm = 1e3;

  const kKinds = ['circle', 'window', 'star', 'square', 'line', 'points',
    'sweep', 'gcode'];

  T.controller = (m) => ({ fc: 'FC', afc: 'AFC' })[m.options.controller] || m.options.controller;
  T.isResponse = (f) => /^[xy]\.response\./.test(f.id);
  T.isPeriod = (f) => /^[xy]\.periods\./.test(f.id);

  const precise = (run) => run.metrics.options.controller === 'precision';
  const scaled = (values, factor) => values.map((v) => v * factor);

  // The unit of each kind of word of an axis (specification section 3).
  function unitsOf(o, axis) {
    const count = o[`plant.${axis}.encoder_count_m`];
    const current = o[`plant.${axis}.current_full_scale_A`] / 2048;
    return { count_m: count, speed_m_s: count / 16 * o['chip.position_Hz'], current_A: current,
      command_A: current / 2, voltage_V: o[`plant.${axis}.dc_link_V`] / Math.sqrt(3) / 2048,
      fuzzy: 1 / 256 };
  }

  // What stands below the tiles, by the figure's id.
  function asidesOf(m) {
    const asides = { 'tracking.model.max_mm': 'to the reference model' };
    for (const [name, digits] of [['peak_current_A', 2], ['max_speed_m_s', 3]]) {
      asides[name] = `X ${T.num(m.x[name], digits)}, Y ${T.num(m.y[name], digits)}`;
    }
    if (m.contour) asides['contour.mean_mm'] = `largest ${T.num(m.contour.max_mm, 3)}`;
    if (m.contour_um) asides['contour_um.mean'] = `largest ${T.num(m.contour_um.max, 2)}`;
    for (const axis of ['x', 'y']) {
      const { periods } = m[axis];
      if (!periods || periods.length === 0) continue;
      asides[`${axis}.periods.${periods.length - 1}.overshoot_percent`] =
        `last period; first ${T.num(periods[0].overshoot_percent, 1)}`;
    }
    return asides;
  }

  function prepare(run) {
    const s = run.series;
    const axes = (name) => ({ x: scaled(s[`x_${name}`], kMm), y: scaled(s[`y_${name}`], kMm) });
    const data = { n: run.count, t: s.t_s, command: axes('command_m'), model: axes('model_m'),
      table: axes('position_m') };
    const less = (a, b) => a.map((v, k) => v - b[k]);
    data.errorX = less(data.model.x, data.table.x);
    data.errorY = less(data.model.y, data.table.y);
    data.toModel = data.errorX.map((v, k) => Math.hypot(v, data.errorY[k]));
    data.toCommand = data.command.x.map((v, k) => Math.hypot(v - data.table.x[k],
      data.command.y[k] - data.table.y[k]));
    data.toPath = s.contour_m ? scaled(s.contour_m, kMm) : null;
    data.names = ['command', 'reference'];
    data.colours = [{ button: 'to reference', label: 'table, error (mm)', values: data.toModel },
      ...(data.toPath ? [{ button: 'to path', label: 'table, contour (mm)', values: data.toPath }]
        : [])];
    run.data = data;
  }

  function pathSection(run) {
    const d = run.data;
    const section = T.section('tracking', 'Tracking', T.zoomLead());
    const error = (label, data, role, width) => ({ label, data, role, unit: 'mm', digits: 3,
      width });
    const errors = T.timePlot({ id: 'error', title: 'Tracking error', small:
      'to the reference model', yLabel: 'error (mm)', tall: 270, series: [
      error('T(k)', d.toModel, 'total', 2), error('x', d.errorX, 'x'),
      error('y', d.errorY, 'y')] });
    const other = T.timePlot({ id: 'contour', title: d.toPath ? 'Contour error'
      : 'Distance from the command', small: d.toPath ? 'to the commanded path' : '',
    yLabel: 'error (mm)', tall: 270, series: d.toPath ? [
      error('contour', d.toPath, 'actual', 2),
      { ...error('distance from the command', d.toCommand, 'asked'), hidden: true }]
      : [error('to command', d.toCommand, 'actual')] });
    section.append(T.el('div', { class: 'grid path' }, T.pathPlot(d), T.el('div',
      { class: 'stack' }, errors, other)));
  }

  function preciseSections(run) {
    const data = T.preciseData(run);
    const command = (axis) => unitsOf(run.metrics.options, axis).command_A;
    T.precisionSection(run, data);
    T.effortSection(run, data, { x: command('x'), y: command('y') });
    T.estimateSection(run);
  }

  function responseSection(run) {
    const section = T.section('response', 'Frequency response', 'Measured tone by tone. The open ' +
      'loop L is computed from the closed one, T / (1 - T): its phase margin is read where its ' +
      'gain falls through 0 dB, its gain margin where its phase falls through -180 degrees.');
    const plots = Object.entries(run.detail.response).flatMap(([loop, axes]) => ['x', 'y']
      .filter((axis) => axes[axis].length > 0)
      .map((axis) => T.bodePlot({ id: `bode-${loop}-${axis}`,
        title: `${axis.toUpperCase()} ${loop} loop`, rows: axes[axis] })));
    section.append(T.el('div', { class: 'grid two' }, plots), T.el('div', { class: 'card' },
      T.figureTables(run.metrics.figures.filter(T.isResponse))));
  }

  function axesSection(run) {
    const s = run.series;
    const d = run.data;
    const o = run.metrics.options;
    const section = T.section('axes', 'Axes', 'What each axis was commanded to do, what it did, ' +
      'and with what effort: words of the chip in physical units, or true values of the plant.');
    const units = { x: unitsOf(o, 'x'), y: unitsOf(o, 'y') };
    const word = (a, name, unit) => scaled(s[`${a}_${name}`], units[a][unit]);
    // Title, what stands beside it, label and unit of the vertical axis, digits, lines of an axis:
    // label, data, role, more.
    const plots = {
      position: ['position', '', 'position', 'mm', 2, (a) => [
        ['command', d.command[a], 'asked', { steps: true, width: 2.5 }],
        ['reference', d.model[a], 'model'],
        ['table', d.table[a], 'actual']]],
      speed: ['speed', 'v* is the effort of the position controller', 'speed', 'm/s', 3, (a) => [
        ['v*', word(a, 'v_star', 'speed_m_s'), 'asked', { width: 2 }],
        ['v (encoder)', word(a, 'v', 'speed_m_s'), 'other', { width: 1 }],
        ['v (plant)', s[`${a}_v_m_s`], 'actual']]],
      current: ['currents', '', 'current', 'A', 3, (a) => [
        ['i_q*', word(a, 'i_q_ref', 'command_A'), 'asked', { width: 2 }],
        ['i_q', word(a, 'i_q', 'current_A'), 'actual'],
        ['i_d', word(a, 'i_d', 'current_A'), 'model'],
        ['i_q (plant)', s[`${a}_i_q_A`], 'x', { hidden: true }],
        ['i_d (plant)', s[`${a}_i_d_A`], 'y', { hidden: true }]]],
      voltage: ['voltages', 'output of the current controllers', 'voltage', 'V', 1, (a) => [
        ['v_q', word(a, 'v_q', 'voltage_V'), 'actual'],
        ['v_d', word(a, 'v_d', 'voltage_V'), 'model']]],
      fuzzy: ['fuzzy output', 'one unit is 1.28 mm of error at the default scale', 'u', 'units', 3,
        (a) => [['u', word(a, 'u', 'fuzzy'), 'actual', { unit: '' }]]],
      force: ['force', 'of the motor', 'force', 'N', 2, (a) => [
        ['force', s[`${a}_force_N`], 'actual']]],
    };
    if (precise(run)) {  // the fuzzy controller rests; speed stands with the command
      delete plots.fuzzy;
      delete plots.speed;
    }
    section.append(T.el('div', { class: 'grid two' }, Object.entries(plots).flatMap(([id, [title,
      small, label, unit, digits, lines]]) => ['x', 'y'].map((axis) => T.timePlot({
      id: `${id}-${axis}`, title: `${axis.toUpperCase()} ${title}`, small,
      yLabel: `${label} (${unit})`, series: lines(axis).map(([name, data, role, more]) => ({
        label: name, data, role, unit, digits, ...more })) })))));
  }

  function sampleSection(run) {
    const { moment, gates } = run.detail;
    if (!moment && !gates) return;
    const o = run.metrics.options;
    const clockUs = run.metrics.run.clock_ps * 1e-6;
    const speed = (axis) => {
      const at = run.series.tick.findIndex((tick) => moment && tick >= moment.tick);
      return at < 0 ? 0 : Math.abs(run.series[`${axis}_v_m_s`][at]);
    };
    const axis = speed('y') > speed('x') ? 1 : 0;
    const when = (edge) => `t = ${T.num(edge * clockUs * 1e-6, 4)} s`;
    const lead = moment ? `The sample at which an axis moved fastest: tick ${moment.tick}, ` +
      `${when(moment.edge)}.` : '';
    const section = T.section('sample', 'One sample', gates && gates.trip !== undefined
      ? `${lead} The gates are shown around the trip, ${when(gates.trip)}.` : lead);
    if (gates) section.append(T.gatePlots(gates, axis, clockUs));
    if (moment) section.append(T.afcStrip(moment, { x: unitsOf(o, 'x'), y: unitsOf(o, 'y') },
      T.controller(run.metrics) === 'AFC'));
  }

  function rulesSection(run) {
    const adapting = T.controller(run.metrics) === 'AFC';
    const section = T.section('rules', 'Rules', adapting
      ? 'The 49 fuzzy rules, tuned while the table moved; the line traces e and de over the run.'
      : 'The 49 fuzzy rules, fixed; the line traces e and de over the run.');
    const o = run.metrics.options;
    section.append(T.el('div', { class: 'grid four' }, ['x', 'y'].flatMap((axis) => {
      const units = (word, shift) => scaled(run.series[`${axis}_${word}`], 2 ** shift / 256)
        .map((v) => Math.max(-6, Math.min(6, v)));
      return T.ruleCards(axis, run.detail.rules[axis], { e: units('e',
        o[`gains.${axis}.shift_e`]), de: units('de', o[`gains.${axis}.shift_de`]) }, adapting);
    })));
  }

  (T.machines = T.machines || {}).kung = {
    prepare,
    get compare() { return T.kungComparison; },
    chips: (m) => [T.controller(m)],
    asides: asidesOf,
    figures: (f) => !T.isPeriod(f) && !T.isResponse(f),  // they stand beside their plots
    figureNote: (m) => m.comparison_note && m.comparison_note.replace('->', '\u2192'),
    idle: (key, options) => kKinds.some((kind) => kind !== options['path.kind'] &&
      key.startsWith(`path.${kind}_`)),
    sections(run) {
      if (run.count > 1) {
        T.time.start(run.data.t);
        if (run.metrics.x.periods) T.stepSection(run);
        if (run.metrics.figures.some(T.isResponse)) responseSection(run);
        if (precise(run)) {
          preciseSections(run);
        } else if (!(run.detail.response && run.detail.response.current)) {
          pathSection(run);
        }
        axesSection(run);
      }
      sampleSection(run);
      if (!precise(run)) rulesSection(run);
    },
  };
})(window.Trammel = window.Trammel || {});
