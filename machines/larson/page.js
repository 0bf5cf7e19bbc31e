// SPDX-License-Identifier: Apache-2.0
//
// The page of the stepper table: its path, what the interface tells the translators and what the
// rotors do, load angles and buffers over time, interrupts and switches, calls and their answers.
(function (T) {
  'use strict';

  const kStepMm = 0.0254;  // 0.001 inch
  const kAxes = ['x', 'y'];
  const kMostRows = 400;
  const kMostMarks = 24;

  const both = (of) => Object.fromEntries(kAxes.map((axis) => [axis, of(axis)]));
  const mm = (values) => values && values.map((v) => v * kStepMm);
  const line = (label, data, role, unit, digits, more) => ({ label, data, role, unit, digits,
    ...more });
  const text = (value, tag = 'td') => T.el(tag, { class: 'text' }, value);
  const note = (...parts) => T.el('p', { class: 'note' }, parts);
  const octal = (value, digits) => value.toString(8).padStart(digits, '0');

  function prepare(run) {
    const s = run.series;
    const d = { n: run.count };
    if (!s.x_at_step || !s.y_at_step || !s.x_step || !s.y_step || !s.x_asked_step ||
        !s.y_asked_step) {
      run.data = d;
      return;
    }
    d.command = both((axis) => mm(s[`${axis}_asked_step`]));
    d.model = both((axis) => mm(s[`${axis}_step`]));
    d.table = both((axis) => mm(s[`${axis}_at_step`]));
    d.names = ['interface', 'translators'];
    const hypot = (name) => s[`x_${name}`] && s[`y_${name}`] &&
      s[`x_${name}`].map((v, k) => Math.hypot(v, s[`y_${name}`][k]));
    d.colours = [{ button: 'speed', label: 'rotors, speed (step/s)',
      values: hypot('speed_step_s') },
      { button: 'load angle', label: 'rotors, load angle (step)', values: hypot('angle_step') }]
      .filter((one) => one.values);
    run.data = d;
  }

  function asides(m) {
    return {
      'script.time_s': `${m.script.calls} calls`,
      'x.max_angle_step': 'beyond 5 the rotor falls back by 10',
      'script.off_step': 'rotors from where WHRTBL has them',
      interrupts: `${m.event_count} events in all`,
    };
  }

  // ---- motion ----

  function motionSection(run) {
    const s = run.series;
    const section = T.section('motion', 'Motion', T.zoomLead(T.time.marks.length > 0 &&
      'Dashed: a switch or lost steps, and an interrupt where there are few.'));
    if (run.data.colours && run.data.colours.length > 0) {
      section.append(T.el('div', { class: 'grid path' }, T.pathPlot(run.data), T.el('div',
        { class: 'stack' }, kAxes.map((axis) => T.timePlot({ id: `angle-${axis}`, title:
          `${axis.toUpperCase()} load angle`, small: 'how far the rotor is behind', yLabel:
          'angle (step)', series: [line('rotor', s[`${axis}_angle_step`], axis, 'step', 3)] })))));
    }
    const plots = [
      (axis, name) => T.timePlot({ id: `position-${axis}`, title: `${name} position`, yLabel:
        'position (step)', series: [
        line('interface', s[`${axis}_asked_step`], 'asked', 'step', 0, { width: 3, steps: true }),
        line('translator', s[`${axis}_step`], 'model', 'step', 0, { steps: true }),
        line('rotor', s[`${axis}_at_step`], 'actual', 'step', 3)] }),
      (axis, name) => T.timePlot({ id: `rate-${axis}`, title: `${name} rate`, yLabel:
        'rate (step/s)', series: [
        line('rotor', s[`${axis}_speed_step_s`], 'actual', 'step/s', 1, { width: 1 }),
        line('translator', s[`${axis}_rate_step_s`], 'asked', 'step/s', 1, { width: 3 })] }),
      (axis, name) => T.timePlot({ id: `waiting-${axis}`, title: `${name} pulse buffer`, yLabel:
        'pulses that wait', series: [line('waiting', s[`${axis}_waiting`], 'model', '', 0,
        { steps: true })] })];
    section.append(T.el('div', { class: 'grid two' }, plots.flatMap((make) => kAxes.map((axis) =>
      make(axis, axis.toUpperCase())))));
  }

  // ---- interface ----

  const bitOf = (values, bit) => values && values.map((v) => (v >> bit & 1));

  function interfaceSection(run) {
    const s = run.series;
    const section = T.section('interface', 'Interface', 'Bits of the status words and the count ' +
      'registers; a count is the complement of the steps that are left.');
    const bits = (axis, name) => T.timePlot({ id: `bits-${axis}`, title: `${name} status bits`,
      small: '12 busy, 13 forward, 14 a switch is closed', yLabel: 'bit', series: [
        line('busy', bitOf(s[`${axis}_status`], 12), 'actual', '', 0, { steps: true }),
        line('forward', bitOf(s[`${axis}_status`], 13), 'model', '', 0, { steps: true,
          hidden: true }),
        line('switch', bitOf(s[`${axis}_status`], 14), 'x', '', 0, { steps: true })] });
    const left = (axis, name) => T.timePlot({ id: `left-${axis}`, title: `${name} steps left`,
      yLabel: 'steps', series: [line('left', s[`${axis}_count`] && s[`${axis}_count`].map((v) =>
        65535 - v), 'asked', 'steps', 0, { steps: true })] });
    section.append(T.el('div', { class: 'grid two' }, kAxes.map((axis) => left(axis,
      axis.toUpperCase())), kAxes.map((axis) => bits(axis, axis.toUpperCase()))));
    const { events } = run.metrics;
    const rows = events.slice(0, kMostRows).map((one, k) => [k + 1, T.num(one.time_s, 5),
      text(one.axis.toUpperCase()), text(one.what), T.num(one.at_step, 2), octal(one.count, 6),
      octal(one.status, 6)]);
    const card = T.el('div', { class: 'card long' }, rows.length > 0 ? T.el('div',
      { class: 'scroll' }, T.table(['Event', 'time in the run (s)', text('axis', 'th'),
      text('what', 'th'), 'rotor at (step)', 'count, octal', 'status, octal'], rows))
      : T.el('p', {}, 'No interrupt, no switch.'));
    if (run.metrics.event_count > rows.length) {
      card.append(note(`The first ${rows.length} of ${run.metrics.event_count} events.`));
    }
    section.append(card);
  }

  // ---- calls ----

  function callSection(run) {
    const { calls } = run.metrics;
    const rows = calls.slice(0, kMostRows).map((one) => [T.num(one.time_s, 4), one.line,
      text(T.el('code', {}, one.call)), text(one.answer || ''), T.num(one.x_step, 2),
      T.num(one.y_step, 2)]);
    const card = T.el('div', { class: 'card long' }, T.el('div', { class: 'scroll' }, T.table([
      'Ended at (s)', 'line', text('call', 'th'), text('answer', 'th'), 'rotor of X (step)',
      'rotor of Y (step)'], rows)));
    if (calls.length > rows.length) card.append(note(`The first ${rows.length} calls.`));
    T.section('calls', 'Calls', 'What the script asked of the routines of .TABLE, and where the ' +
      'rotors then were, from the calibration point.').append(card);
  }

  // ---- assumptions ----

  const kAssumed = [
    [['motor.damping_2', 'motor.damping_3'], 'Larson: damping is much stronger with three phases'],
    [['motor.friction_N_m'], 'not stated'],
    [['buffer.start_rate', 'buffer.rise', 'buffer.dead_s'], 'fitted to his multiple step times'],
    [['translator.width_us', 'translator.setup_us', 'translator.hold_us'],
      'not stated; his pulses are 2.08 us wide here'],
    [['buffer.brake_rate', 'buffer.idle_s'], 'ours: a ramp down, so that a long move ends at rest'],
    [['axis.switch_low_step', 'axis.switch_high_step', 'axis.switch_hysteresis_step',
      'axis.overtravel_step'], 'outside the 6 inches of travel'],
    [['table.soft_end_step', 'table.margin_step', 'table.seek_rate', 'table.back_rate'],
      'his listing of .TABLE is not in the paper'],
  ];

  const closing = (run) => T.section('assumptions', 'Assumptions', 'What Larson 1974 leaves ' +
    'open, and the value used in this run.').append(T.el('div', { class: 'card long' }, T.el('div',
    { class: 'scroll' }, T.table(['Assumed', 'value', text('because', 'th')],
    kAssumed.flatMap(([keys, reason]) => keys.map((key) => [key, T.valueText(
      run.metrics.options[key]), T.el('td', { class: 'text dim' }, reason)]))))));

  // Switches and losses; interrupts, of which each move has two, only where they are few.
  function marksOf(events) {
    const rare = events.filter((one) => one.what !== 'interrupt');
    return (events.length <= kMostMarks ? events : rare).slice(0, kMostMarks)
      .map((one) => one.time_s);
  }

  function sections(run) {
    if (run.count > 1) {
      T.time.start(run.series.t_s);
      T.time.marks = marksOf(run.metrics.events);
      motionSection(run);
      interfaceSection(run);
    }
    callSection(run);
  }

  const plot = (id, title, yLabel, unit, digits) => ({ id, title, yLabel, unit, digits });
  const compare = {
    kindOf: (run) => run.metrics.options.script,
    sample: (run) => 1e-3 * run.metrics.options['record.every_ms'],
    smallerIsBetter: (f) => /\.(time_s|off_step|lost_step|max_angle_step)$/.test(f.id),
    plots: (runs, overlay) => kAxes.flatMap((axis) => [
      overlay(plot(`position-${axis}`, `${axis.toUpperCase()} position`, 'position (step)', 'step',
        2), (run) => run.series[`${axis}_at_step`]),
      overlay(plot(`angle-${axis}`, `${axis.toUpperCase()} load angle`, 'angle (step)', 'step', 3),
        (run) => run.series[`${axis}_angle_step`])]),
    heading: 'Scripts',
    lead: 'Differences are to the first run of the same script.',
  };

  (T.machines = T.machines || {}).larson = { prepare, asides, sections, closing, compare,
    chips: (m) => [m.options['buffer.fitted'] ? 'pulse buffers' : 'no pulse buffer'] };
})(window.Trammel = window.Trammel || {});
