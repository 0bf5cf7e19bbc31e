// SPDX-License-Identifier: Apache-2.0
//
// The page of the gantry track: position, velocity, control, forces and backlash over time, the
// phase portrait of the stripes, and the calibration's polynomials.
(function (T) {
  'use strict';

  const line = (label, data, role, unit, digits, more) => ({ label, data, role, unit, digits,
    ...more });

  function prepare(run) {
    run.data = { n: run.count };
  }

  function asides(m) {
    return { 'step.overshoot_percent': `of ${m.options['step.reference_mm']} mm` };
  }

  function motionSection(run) {
    const s = run.series;
    const section = T.section('motion', 'Motion', T.zoomLead(false));
    const two = (name, unit, digits, more) => [
      line('motor 1', s[`m1_${name}`], 'actual', unit, digits, more),
      line('motor 2', s[`m2_${name}`], 'model', unit, digits, more)];
    const plot = (id, title, yLabel, series) => T.timePlot({ id, title, yLabel, series });
    section.append(T.el('div', { class: 'grid two' },
      plot('position', 'Position', 'position (mm)', [
        line('asked', s.goal_mm, 'asked', 'mm', 3, { width: 3, steps: true }),
        line('cart', s.x_mm, 'actual', 'mm', 3),
        line('observer', s.position_mm, 'model', 'mm', 3, { hidden: true })]),
      plot('velocity', 'Velocity', 'velocity (mm/s)', [
        line('cart', s.v_mm_s, 'actual', 'mm/s', 1),
        line('filtered', s.filtered_mm_s, 'model', 'mm/s', 1),
        line('observer', s.velocity_mm_s, 'x', 'mm/s', 1, { hidden: true })]),
      plot('control', 'Control', 'force written (count)', two('u_count', 'count', 0,
        { steps: true })),
      plot('force', 'Motors', 'force (count)', two('force_count', 'count', 1)),
      plot('apart', 'Gear wheels', 'from the cart (mm)', two('apart_mm', 'mm', 4)),
      plot('flank', 'Backlash', 'flank that pushes', two('flank', '', 0, { steps: true }))));
  }

  // A against B, in codes: a circle where the sensor is ideal.
  function stripeSection(run) {
    const words = run.metrics.calibration;
    const signed = (w) => (w > 32767 ? w - 65536 : w);
    const rows = [0, 1, 2, 3].map((r) => [r, r % 2 === 0 ? 'B' : 'A',
      ...[0, 1, 2, 3].map((k) => signed(words[14 + 4 * r + k]))]);
    T.section('calibration', 'Calibration', 'Cubics of the four regions as the memory holds them ' +
      'at the end, highest power first; phase of 2^14 a period over X = 64 (code - 512) / 2^14.')
      .append(T.el('div', { class: 'card long' }, T.el('div', { class: 'scroll' }, T.table([
        'Region', 'of', 'c3', 'c2', 'c1', 'c0'], rows))));
  }

  function sections(run) {
    if (run.count > 1) {
      T.time.start(run.series.t_s);
      motionSection(run);
    }
    stripeSection(run);
  }

  const plot = (id, title, yLabel, unit, digits) => ({ id, title, yLabel, unit, digits });
  const compare = {
    kindOf: (run) => `${run.metrics.options['step.reference_mm']} mm`,
    sample: (run) => 1e-3 * run.metrics.options['record.every_ms'],
    smallerIsBetter: (f) => /\.(overshoot_mm|overshoot_percent|arrive_s|settle_s|swing_mm)$/
      .test(f.id),
    plots: (runs, overlay) => [
      overlay(plot('position', 'Position', 'position (mm)', 'mm', 3), (run) => run.series.x_mm),
      overlay(plot('velocity', 'Velocity', 'velocity (mm/s)', 'mm/s', 1),
        (run) => run.series.v_mm_s)],
    heading: 'Controllers',
    lead: 'Differences are to the first run of the same step.',
  };

  (T.machines = T.machines || {}).gantry = { prepare, asides, sections, closing: () => {},
    compare, chips: (m) => [m.options['control.cascade'] ? 'cascade' : m.options['position.sum']] };
})(window.Trammel = window.Trammel || {});
