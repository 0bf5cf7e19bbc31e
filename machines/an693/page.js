// SPDX-License-Identifier: Apache-2.0
//
// The page of an LM628 with its motor: trajectory, filter, status bits and interrupts over time,
// and the script when one drove it.
(function (T) {
  'use strict';

  const sampleOf = (m) => 2048e-6 / (m.options['chip.clock_MHz'] || 8);  // [s]
  const kTurn = 2 * Math.PI;

  const pulses = (m) => m.options['chip.variant'] === 'lm629';
  const outputOf = (m) => (pulses(m) ? 'bridge gets the upper 8 as sign and pulse'
    : `converter gets the upper ${m.options['chip.dac_bits'] || 12}`);
  const perTurn = (m) => m.options['encoder.counts'];

  function prepare(run) {
    const s = run.series;
    const counts = perTurn(run.metrics);
    run.data = { position: s.theta_count, error: s.e, output: s.output,
      speed: s.omega_rad_s.map((v) => v / kTurn),
      asked: s.desired_speed && s.desired_speed.map((v) => v / counts / sampleOf(run.metrics)) };
  }

  function asides(m) {
    const { motion } = m;
    return {
      'motion.time_s': `${T.whole(motion.samples)} samples`,
      'motion.real_count': `desired ${T.whole(motion.desired_count)}; ${T.num(motion.real_count /
        perTurn(m), 2)} turns`,
      'motion.overshoot_counts': 'beyond the desired position',
      'motion.max_error_counts': 'as the part saw it',
      'motion.max_speed_rev_s': `${T.num(motion.max_speed_rev_s * 60, 0)} rev/min`,
      'motion.max_current_A': `voltage ${T.num(motion.max_voltage_V, 2)} V`,
    };
  }

  function motionSection(run) {
    const s = run.series;
    const d = run.data;
    const { line, pair } = T.lm628;
    const section = T.section('motion', 'Motion', T.zoomLead(T.time.marks.length > 0 &&
      'Dashed: the part interrupts its host.'));
    section.append(T.timePlot({ id: 'position', title: 'Position', yLabel: 'position (counts)',
      tall: 290, print: 'wide', series: [
        ...pair('shaft', 'counts', 1, s.desired_count, d.position, 4),
        line('real, as counted', s.real_count, 'model', 'counts', 0, { hidden: true,
          steps: true })] }),
    T.el('div', { class: 'grid two' },
      T.timePlot({ id: 'speed', title: 'Speed', yLabel: 'speed (rev/s)', series: pair('shaft',
        'rev/s', 3, d.asked, d.speed) }),
      T.lm628.errorPlot(s, '')));
  }

  function filterSection(run) {
    const s = run.series;
    const section = T.section('filter', 'Filter', 'The terms of each sample: the output has 16 ' +
      `bits, of which the ${outputOf(run.metrics)}; then what the motor does.`);
    section.append(T.lm628.termsPlot(s, '', 'wide'), T.el('div', { class: 'grid two' },
      T.lm628.voltagePlot(s, ''), T.lm628.currentPlot(s, '')));
  }

  function scriptCard(m) {
    const { text } = T.lm628;
    const reply = (one) => [one.hex || '', one.bits || (one.value === undefined ? ''
      : `${one.value} ${one.unit || ''}`), one.waited_s === undefined ? ''
      : `after ${T.num(one.waited_s, 6)} s`].filter(Boolean).join('  ');
    return T.el('div', { class: 'card long' }, T.lm628.table(['Time (s)', text('command', 'th'),
      text('answer', 'th')], m.script.map((one) => [T.num(one.time_s, 6), text(T.el('code', {},
      one.line)), text(reply(one))])));
  }

  function sections(run) {
    const m = run.metrics;
    if (run.count > 1) {
      T.time.start(run.series.t_s);
      T.time.marks = m.interrupts.map((one) => one.time_s);
      motionSection(run);
      filterSection(run);
      T.section('status', 'Status', '').append(T.lm628.statusPlot(run, '', [],
        'and the pin that interrupts the host'), T.el('div', { class: 'card' },
      m.interrupts.length > 0 ? T.lm628.eventTable('Interrupt', m.interrupts)
        : T.el('p', {}, 'The part never interrupted.')));
    }
    if (m.script) {
      T.section('script', 'Script', 'Simulated time at the end of each line, from the start of ' +
        'the run.').append(scriptCard(m));
    }
  }

  const plot = (id, title, yLabel, unit, digits) => ({ id, title, yLabel, unit, digits });
  const compare = {
    kindOf: (run) => run.metrics.options.program || 'script',
    sample: (run) => sampleOf(run.metrics),
    smallerIsBetter: (f) => /\.(overshoot_counts|settled_s|max_error_counts)$/.test(f.id),
    plots: (runs, overlay) => [
      overlay(plot('position', 'Position', 'position (counts)', 'counts', 1),
        (run) => run.data.position),
      overlay(plot('error', 'Error', 'error (counts)', 'counts', 0), (run) => run.data.error),
      overlay(plot('speed', 'Speed', 'speed (rev/s)', 'rev/s', 3), (run) => run.data.speed),
      overlay(plot('output', 'Output of the filter', 'output', '', 0), (run) => run.data.output)],
    heading: 'Motion',
    lead: 'Differences are to the first run of the same program.',
  };

  (T.machines = T.machines || {}).an693 = { prepare, asides, sections, compare,
    chips: (m) => [pulses(m) ? 'LM629' : 'LM628', ...(m.script ? ['script'] : [])] };
})(window.Trammel = window.Trammel || {});
