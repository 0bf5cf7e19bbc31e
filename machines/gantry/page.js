// SPDX-License-Identifier: Apache-2.0
//
// The page of the gantry track: position, velocity, control, forces and backlash over time, the
// phase portrait of the stripes, and the calibration's polynomials.
(function (T) {
  'use strict';

  const kCentre = 512;  // code
  const kAmplitude = 400;  // [code] of an ideal sensor
  const kTurn = 16384;  // phase units of a period
  const kUnitUm = 5000 / kTurn;
  const kRegions = [0, 1, 2, 3];
  const kMostPoints = 6000;

  const line = (label, data, role, unit, digits, more) => ({ label, data, role, unit, digits,
    ...more });
  const note = (...parts) => T.el('p', { class: 'note' }, parts);

  function prepare(run) {
    run.data = { n: run.count };
  }

  function asides(m) {
    const { 'step.reference_mm': reference, 'step.from_mm': from, 'step.band_mm': band } =
      m.options;
    const settling = Math.round(20 * Math.abs(reference - from)) / 1000;
    return { 'step.overshoot_percent': `of ${reference} mm`, 'step.arrive_s': `within ${band} mm`,
      'step.settle_s': `within ${settling} mm, 2 %` };
  }

  // From the track's zero, as x_mm is.
  const onTrack = ({ origin_mm: origin }, place) => (place && origin
    ? place.map((x, k) => x + origin[k]) : place);

  const sums = { none: 'P', plain: 'PI', cancel: 'PI, sum cancelled', anti_windup:
    'PI, anti-windup' };

  // The controller that the host asks for, and its gain.
  function controllerOf(o) {
    if (o['control.open'] !== 'none') return `no controller, ${o['control.open']}`;
    const [gain, time] = [o['position.gain'], o['position.time_shift']];
    if (!/:21=/.test(o['host.sends']) && /:22=/.test(o['host.sends'])) {
      return `velocity PI, KIV = ${o['velocity.time_shift']}`;
    }
    if (o['control.cascade']) {
      return `cascade, K = ${o['control.cascade_gain']}` + (o['control.compensate']
        ? ', backlash compensated' : '');
    }
    if (o['position.bang_bang']) return `bang-bang, \u00b1${o['position.max_force']}`;
    const sum = o['position.sum'];
    if (sum === 'none') return `P, K = ${gain}`;
    const linear = sum === 'anti_windup' && o['position.min_force'] === 0;
    return `${linear ? 'PI, linear' : sums[sum]}, TI = ${time}`;
  }

  const figureOf = ({ published }) => (published.figure ? `figure ${published.figure}` : '');

  // ---- motion ----

  function motionSection(run) {
    const s = run.series;
    const { published } = run.metrics;
    const section = T.section('motion', 'Motion', T.zoomLead(published.figure
      ? `Brochier 2006, figure ${published.figure}: ${published.says}.` : ''));
    const two = (name, unit, digits, more) => [
      line('motor 1', s[`m1_${name}`], 'actual', unit, digits, more),
      line('motor 2', s[`m2_${name}`], 'model', unit, digits, more)];
    const plot = (id, title, yLabel, series, small) => T.timePlot({ id, title, yLabel, series,
      small });
    section.append(T.el('div', { class: 'grid two' },
      plot('position', 'Position', 'position (mm)', [
        line('asked', onTrack(s, s.goal_mm), 'asked', 'mm', 3, { width: 3, steps: true }),
        line('cart', s.x_mm, 'actual', 'mm', 3),
        line('observer', onTrack(s, s.position_mm), 'model', 'mm', 3, { hidden: true })]),
      plot('velocity', 'Velocity', 'velocity (mm/s)', [
        line('cart', s.v_mm_s, 'actual', 'mm/s', 1),
        line('filtered', s.filtered_mm_s, 'model', 'mm/s', 1),
        line('observer', s.velocity_mm_s, 'x', 'mm/s', 1, { hidden: true })]),
      plot('control', 'Control', 'force written (count)', two('u_count', 'count', 0,
        { steps: true }), 'positive to the right'),
      plot('force', 'Torque', 'force (count)', two('force_count', 'count', 1),
        'behind the winding, at the belt'),
      plot('apart', 'Gear wheels', 'from the cart (mm)', two('apart_mm', 'mm', 4)),
      plot('flank', 'Backlash', 'flank that pushes', two('flank', '', 0, { steps: true }),
        '0: within the backlash')));
  }

  // ---- stripes ----

  const signed = (w) => (w > 32767 ? w - 65536 : w);
  const cubicsOf = (words) => kRegions.map((r) => ({ middle: words[10 + r],
    c: [0, 1, 2, 3].map((k) => signed(words[14 + 4 * r + k])) }));
  // Phase of a code by a region's cubic, next to the region's centre.
  const phaseOf = ({ middle, c }, code) => {
    const x = (64 * (code - kCentre) - middle) / kTurn;
    return ((c[0] * x + c[1]) * x + c[2]) * x + c[3];
  };

  const square = (width) => Math.round(Math.min(width, 440) * 0.95);
  const boxOf = (width, height) => ({ x: 60, y: 30, w: width - 74, h: height - 78 });

  // A against B: a circle where the sensor is ideal.
  function portraitCard(s) {
    const plot = { id: 'portrait', title: 'Phase portrait', height: square, saveWidth: 520 };
    const n = s.sensor_a_code.length;
    const stride = Math.ceil(n / kMostPoints);
    plot.scene = function (p, width, height, theme) {
      const box = boxOf(width, height);
      const side = Math.min(box.w, box.h);
      const frame = T.frame({ ...box, w: side, h: side }, [0, 1023], [0, 1023]);
      T.drawFrame(p, theme, frame, { xLabel: 'A (code)', yLabel: 'B (code)', xCount: 4,
        yCount: 4 });
      const circle = Array.from({ length: 181 }, (v, k) => k * Math.PI / 90).flatMap((angle) => [
        frame.x(kCentre + kAmplitude * Math.cos(angle)),
        frame.y(kCentre + kAmplitude * Math.sin(angle))]);
      const dots = (a, b, fill) => {
        for (let k = 0; k < n; k += stride) {
          if (a[k] === 0 && b[k] === 0) continue;  // before the first conversion
          p.circle(frame.x(a[k]), frame.y(b[k]), 1.3, { fill, alpha: 0.5 });
        }
      };
      p.path(circle, { stroke: theme.asked, width: 5, alpha: 0.5 });
      dots(s.a_code, s.b_code, theme.model);
      dots(s.sensor_a_code, s.sensor_b_code, theme.actual);
      T.drawKey(p, theme, box.x, 11, [{ label: 'sensor', stroke: theme.actual },
        { label: 'converted', stroke: theme.model }, { label: 'ideal', stroke: theme.asked,
          width: 5 }]);
    };
    return T.figure(plot, 'the chip converts only the one that is steep: a square');
  }

  // Lines of the four regions: points [x, y, ...] of each.
  function regionPlot({ id, title, small, xLabel, yLabel, xRange, points }) {
    const lines = kRegions.map(points);
    const plot = { id, title, height: square, saveWidth: 520 };
    plot.scene = function (p, width, height, theme) {
      const ys = lines.flatMap((one) => one.filter((v, k) => k % 2 === 1));
      const frame = T.frame(boxOf(width, height), xRange, T.padded(T.range(ys), 0.06));
      T.drawFrame(p, theme, frame, { xLabel, yLabel, xCount: 4 });
      lines.forEach((one, r) => p.path(one.map((v, k) => (k % 2 === 0 ? frame.x(v) : frame.y(v))),
        { stroke: theme.runs[r], width: 2 }));
      T.drawKey(p, theme, 60, 11, kRegions.map((r) => ({ label: `${r}`, stroke: theme.runs[r],
        width: 2 })));
    };
    return T.figure(plot, small);
  }

  function stripeSection(run) {
    const words = run.metrics.calibration;
    const cubics = cubicsOf(words);
    const steps = Array.from({ length: 129 }, (v, k) => (k - 64) * 32);  // phase from the centre
    const codeAt = (r, phase) => kCentre + kAmplitude * (r % 2 === 0 ? Math.sin : Math.cos)(
      2 * Math.PI * phase / kTurn);
    const s = run.series;
    const plots = [
      regionPlot({ id: 'cubics', title: 'Cubics', small: 'by region', xLabel: 'code',
        yLabel: 'phase (2^-14 period)', xRange: [200, 824], points: (r) => steps.flatMap((off) => {
          const code = codeAt(r, r * kTurn / 4 + off);
          return [code, phaseOf(cubics[r], code)];
        }) }),
      regionPlot({ id: 'cubics-off', title: 'Cubics less an ideal sensor', small: 'by region',
        xLabel: 'phase from the centre (2^-14 period)', yLabel: 'off (\u00b5m)',
        xRange: [-2048, 2048], points: (r) => steps.flatMap((off) => [off, kUnitUm * (phaseOf(
          cubics[r], codeAt(r, r * kTurn / 4 + off)) - r * kTurn / 4 - off)]) })];
    if (run.count > 1 && s.sensor_a_code && s.sensor_b_code) plots.unshift(portraitCard(s));
    const rows = kRegions.map((r) => [r, r % 2 === 0 ? 'B' : 'A', ...cubics[r].c]);
    T.section('calibration', 'Stripes and calibration', 'Cubics of the four regions as the ' +
      'memory holds them at the end: phase of 2^14 a period over X = 64 (code \u2212 512) / 2^14.')
      .append(T.el('div', { class: 'grid two' }, plots), T.el('div', { class: 'card long' },
        T.el('div', { class: 'scroll' }, T.table(['Region', 'of', 'c3', 'c2', 'c1', 'c0'], rows)),
        note('Highest power first. What is off an ideal sensor is what a fitted sensor has of ' +
          'errors in amplitude, offset and phase.')));
  }

  function sections(run) {
    if (run.count > 1) {
      T.time.start(run.series.t_s);
      motionSection(run);
    }
    if (run.metrics.identified.models) T.identifiedSection(run.metrics.identified);
    stripeSection(run);
  }

  // ---- several runs ----

  const spanOf = (o) => o['step.reference_mm'] - o['step.from_mm'];

  // Per cent of the step, so that steps of any size lie over each other.
  function response({ series, metrics: { options } }) {
    if (!series.x_mm || spanOf(options) === 0) return null;
    return series.x_mm.map((x) => 100 * (x - options['step.zero_mm'] - options['step.from_mm']) /
      spanOf(options));
  }

  function publishedTable(runs) {
    const value = (m, id) => m.figures.find((f) => f.id === id);
    const text = (m, id) => (value(m, id) ? T.figureText(value(m, id)) : '\u2013');
    T.section('published', 'Beside the thesis', 'Brochier 2006, by its figures.').append(
      T.tableCard(['Run', ['controller', 'text'], ['figure', 'text'], ['published', 'text'],
        'overshoot (%)', 'arrived (s)', 'at the end (mm)', 'swing (mm)'], runs.map((run, k) => [
        T.runName(run, k, true), controllerOf(run.metrics.options), figureOf(run.metrics) ||
          '\u2013', run.metrics.published.says || '\u2013',
        ...['step.overshoot_percent', 'step.arrive_s', 'step.rest_mm', 'step.swing_mm'].map((id) =>
          text(run.metrics, id))])));
  }

  const plot = (id, title, yLabel, unit, digits) => ({ id, title, yLabel, unit, digits });
  const compare = {
    kindOf: (run) => `${run.metrics.options['step.reference_mm']} mm`,
    sample: (run) => 1e-3 * run.metrics.options['record.every_ms'],
    smallerIsBetter: (f) => /\.(overshoot_mm|overshoot_percent|arrive_s|settle_s|swing_mm)$/
      .test(f.id),
    plots: (runs, overlay) => [
      overlay(plot('response', 'Step', 'of the step (%)', '%', 2), response),
      overlay(plot('position', 'Position', 'position (mm)', 'mm', 3), (run) => run.series.x_mm),
      overlay(plot('velocity', 'Velocity', 'velocity (mm/s)', 'mm/s', 1),
        (run) => run.series.v_mm_s),
      overlay(plot('filtered', 'Filtered velocity', 'velocity (mm/s)', 'mm/s', 1),
        (run) => run.series.filtered_mm_s),
      overlay(plot('control', 'Control', 'force of motor 1 (count)', 'count', 0),
        (run) => run.series.m1_u_count)],
    sections: publishedTable,
    heading: 'Controllers',
    lead: 'Differences are to the first run of the same step.',
  };

  (T.machines = T.machines || {}).gantry = { prepare, asides, sections, closing: () => {},
    compare, chips: (m) => [controllerOf(m.options), figureOf(m)].filter(Boolean) };
})(window.Trammel = window.Trammel || {});
