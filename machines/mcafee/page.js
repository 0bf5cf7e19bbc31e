// SPDX-License-Identifier: Apache-2.0
//
// The page of two LM628 with a leadscrew stage: the path coloured by its speed, the contour errors
// of the runs that are compared, feed rate, both axes, status bits.
(function (T) {
  'use strict';

  const sampleOf = (m) => 2048e-6 / (m.options['chip.clock_MHz'] || 6);  // [s]
  const kAxes = ['x', 'y'];

  const tracks = (m) => m.options.program === 'track';
  const scaled = (values, factor, offset = 0) => values && values.map((v) => v * factor + offset);
  const both = (of) => Object.fromEntries(kAxes.map((axis, k) => [axis, of(axis, k)]));
  const countMm = (o) => 1e3 * o['stage.pitch_m'] / (4 * o['encoder.lines']);
  const hypot = (of) => of.x && of.x.map((v, k) => Math.hypot(v, of.y[k]));
  const runName = (m) => (m.options['track.speed'] === 0 ? 'self-paced'
    : `v = ${m.options['track.speed']}`);

  // Columns of the table of a path, and the corners of its rows.
  function rowsOf(detail, mm) {
    const [c, cc, vx, vy, dx, dy] = Array.from({ length: 6 }, (v, n) => detail.rows.map((row) =>
      row[n]));
    const corners = (steps, begin) => {
      let counts = 0;
      return [begin, ...steps.map((step) => begin + (counts += step) * mm)];
    };
    const [x, y] = detail.origin_mm;
    return { c, cc, vx, vy, dx, dy, x: corners(dx, x), y: corners(dy, y) };
  }

  // The point of the rows nearest to where the table is, sought around the current row: the lag
  // is a few rows at most.
  function nearest(rows, row, x, y) {
    const kReach = 10;
    let best = Infinity;
    let found = [x, y];
    for (let k = Math.max(0, row - 1 - kReach); k < Math.min(rows.c.length, row + kReach); ++k) {
      const [ax, ay] = [rows.x[k], rows.y[k]];
      const [dx, dy] = [rows.x[k + 1] - ax, rows.y[k + 1] - ay];
      const part = Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy)));
      const [px, py] = [ax + part * dx, ay + part * dy];
      const distance = Math.hypot(x - px, y - py);
      if (distance < best) [best, found] = [distance, [px, py]];
    }
    return found;
  }

  function prepare(run) {
    const s = run.series;
    const mm = countMm(run.metrics.options);
    const rows = run.detail && rowsOf(run.detail, mm);
    const origin = rows ? { x: rows.x[0], y: rows.y[0] } : { x: 0, y: 0 };
    const d = { n: run.count, mm, rows };
    d.desired = both((a) => scaled(s[`${a}_desired_count`], mm, origin[a]));
    d.table = both((a) => scaled(s[`${a}_mm`], 1, origin[a]));
    d.counted = both((a) => scaled(s[`${a}_real_count`], mm, origin[a]));
    d.asked = both((a) => scaled(s[`${a}_desired_speed`], mm / sampleOf(run.metrics)));
    d.error = both((a) => scaled(s[`${a}_e`], mm));
    run.data = d;
    if (!tracks(run.metrics)) return;
    d.speed = hypot({ x: s.x_mm_s, y: s.y_mm_s });
    d.askedSpeed = hypot(d.asked);
    d.command = d.desired;
    if (!rows) return;
    const now = (values, more = 0) => s.row.map((row) => values[Math.min(rows.c.length - 1,
      Math.max(0, row - 1)) + more]);
    const points = Array.from(s.row, (row, k) => nearest(rows, row, d.table.x[k], d.table.y[k]));
    Object.assign(d, { t: s.t_s.map((t) => t - s.t_s[0]), c: now(rows.c), cc: now(rows.cc),
      from: both((a, k) => points.map((point) => point[k])), model: d.desired,
      command: both((a) => now(rows[a], 1)), polyline: rows,
      names: ['rows', 'desired'], colours: [
        { button: 'speed', label: 'table, speed (mm/s)', values: d.speed },
        { button: 'feed rate', label: 'table, v (0..255)', values: s.v },
        { button: 'contour error', label: 'table, contour (mm)', values: s.contour_mm }] });
  }

  function asides(m) {
    const { motion } = m;
    const mm = countMm(m.options);
    return {
      readings: 'RDRP of X, four bytes each',
      'real_count.0': `${T.num(m.real_count[0] * mm, 3)} mm from the start`,
      'motion.max_error_counts': `of an axis, ${T.num(motion.max_error_counts * mm, 3)} mm`,
      'motion.max_speed_mm_s': `of an axis, desired ${T.num(motion.max_desired_mm_s, 1)}`,
      'motion.max_current_A': `limit ${T.num(m.options['motor.current_limit_A'], 1)} A`,
    };
  }

  const note = (...parts) => T.el('p', { class: 'note' }, parts);

  // ---- tracking ----

  // All runs of the path: [name, figures of the motion].
  const runsOf = (m) => [[runName(m), m.motion], ...Object.entries(m.compared || {}).map(([name,
    one]) => [name, one.motion])];

  function contourPlot(run) {
    const { contours, contour_step_s: step } = run.detail;
    const count = Math.max(...contours.map((one) => one.mm.length));
    const figures = runsOf(run.metrics).map(([, motion]) => motion);
    const card = T.timePlot({ id: 'contour', title: 'Contour error', small:
      'of each run, from its first row on', yLabel: 'error (mm)', tall: 290,
    times: Float64Array.from({ length: count }, (v, k) => k * step),
    series: contours.map((one, k) => ({ run: [2, 0, 1][k], label: one.name, unit: 'mm', digits: 3,
      data: Array.from({ length: count }, (v, n) => (n < one.mm.length ? one.mm[n] : null)),
      peak: figures[k] && [figures[k].contour_max_s, figures[k].contour_max_mm] })) });
    card.append(note('Distance of the table, not of its encoder, from the exact lines and arcs ' +
      'of the path. Dots: the largest of each run.'));
    return card;
  }

  const kRunColumns = [['time (s)', 'time_s', 3],
    ['largest contour error (mm)', 'contour_max_mm', 4], ['when (s)', 'contour_max_s', 3],
    ['rms (mm)', 'contour_rms_mm', 4], ['at the end (mm)', 'contour_end_mm', 4],
    ['largest error of an axis (counts)', 'max_error_counts', 0],
    ['top speed of an axis (mm/s)', 'max_speed_mm_s', 2], ['desired', 'max_desired_mm_s', 2],
    ['peak current (A)', 'max_current_A', 2]];

  function runTable(m) {
    const runs = runsOf(m);
    const card = T.el('div', { class: 'card' }, T.lm628.table(['Run', ...kRunColumns.map(([head]) =>
      head)], runs.map(([name, motion]) => [name, ...kRunColumns.map(([, of, digits]) =>
      T.num(motion[of], digits))])));
    const [own, fast, slow] = runs;
    if (fast && slow) {
      const part = (of, one) => T.num(own[1][of] / one[1][of], 2);
      card.append(note(`The run ${own[0]} has ${part('contour_max_mm', fast)} of the largest ` +
        `contour error of ${fast[0]}, and takes ${part('time_s', slow)} of the time of ` +
        `${slow[0]}. McAfee gives no figures to compare with: his machine never moved.`));
    }
    return card;
  }

  function trackingSection(run) {
    const d = run.data;
    const section = T.section('tracking', 'Tracking', T.zoomLead(T.time.marks.length > 0 &&
      'Dashed: an interrupt of a part, or a limit switch.'));
    const speed = T.timePlot({ id: 'path-speed', title: 'Path speed', yLabel: 'speed (mm/s)',
      series: T.lm628.pair('table', 'mm/s', 2, d.askedSpeed, d.speed) });
    speed.append(note('\u221a(v_x\u00b2 + v_y\u00b2). Notches in the desired speed: a generator ' +
      'begins to slow down for the end of its row before the next row is sent.'));
    section.append(T.el('div', { class: 'grid path' }, T.pathPlot(d), T.el('div',
      { class: 'stack' }, contourPlot(run), speed)), runTable(run.metrics));
  }

  // ---- feed rate ----

  const kMostRows = 1000;

  function rowTable(run) {
    const { rows, t } = run.data;
    const begins = new Map();
    run.series.row.forEach((row, k) => {
      if (!begins.has(row)) begins.set(row, k);
    });
    const at = (row) => t[begins.get(row)];
    const shown = Math.min(kMostRows, rows.c.length);
    const table = T.lm628.table(['Row', 'x (mm)', 'y (mm)', 'dX (counts)', 'dY (counts)', 'C', 'CC',
      'Vx', 'Vy', 'v', 'begins (s)', 'mean speed (mm/s)'], Array.from({ length: shown }, (v, k) => [
      k, T.num(rows.x[k], 3), T.num(rows.y[k], 3), T.num(rows.dx[k], 0), T.num(rows.dy[k], 0),
      rows.c[k], rows.cc[k], rows.vx[k], rows.vy[k], begins.has(k + 1)
        ? run.series.v[begins.get(k + 1)] : '\u2013', T.num(at(k + 1), 3),
      T.num(run.detail.row_mm / (at(k + 2) - at(k + 1)), 2)]));
    if (shown < rows.c.length) {
      table.append(note(`The first ${shown} of ${rows.c.length} rows; all are in table.csv.`));
    }
    return table;
  }

  function feedSection(run) {
    const { line } = T.lm628;
    const d = run.data;
    const o = run.metrics.options;
    const shift = o['track.velocity_shift'];
    const ahead = o['path.preview_rows'];
    const section = T.section('feed', 'Feed rate', `${d.rows.c.length} rows of ${T.num(
      run.detail.row_mm, 5)} mm. Each takes its v from its curvature C and from CC, the change ` +
      `of C ${ahead} rows ahead.`);
    const curvature = T.timePlot({ id: 'curvature', title: 'Curvature', small:
      'of the current row', yLabel: 'C, CC (0..255)', series: [
      line('C', d.c, 'x', '', 0, { steps: true }),
      line('CC', d.cc, 'y', '', 0, { steps: true })] });
    curvature.append(note(`C = round(255 \u03ba / \u03ba_max), where \u03ba = |x\u2032y\u2033 ` +
      `\u2212 y\u2032x\u2033| / (x\u2032\u00b2 + y\u2032\u00b2)^1.5 and \u03ba_max = ` +
      `${o['path.kappa_max_1_mm']} 1/mm; CC = |C(row + ${ahead}) \u2212 C(row)|.` +
      ' Path data: McAfee 1994, Table 5; the curvature is ours, his formula is that of a length.'));
    const feed = T.timePlot({ id: 'feed', title: 'Feed rate', small: `no less than ${
      o['track.least_speed']}`, yLabel: 'v (0..255)', series: [line('v', run.series.v, 'actual', '',
      0, { steps: true })] });
    const most = (254 * 255 >> 8) * 0xF1 * 2 ** shift / 65536 * d.mm / sampleOf(run.metrics);
    feed.append(note('Seven fuzzy rules for C and CC, then v = 256 TU / SU (McAfee 1994, App. D).' +
      ` Speed of an axis (DECOMP): ((v V) >> 8) 241 \u00b7 2^${shift}, V = 255 |d| / ` +
      '\u221a(dX\u00b2 + dY\u00b2), in 2^\u221216 counts per sample; v = 254 along an axis is ' +
      `${T.num(most, 2)} mm/s.`));
    const table = T.el('div');
    const details = T.el('details', { ontoggle: () => {
      if (details.open && !table.firstChild) table.append(rowTable(run));
    } }, T.el('summary', {}, 'Commanded rows'), table);
    section.append(T.el('div', { class: 'grid two' }, feed, curvature), T.el('div',
      { class: 'card long' }, details));
  }

  // ---- axes ----

  function axesSection(run) {
    const s = run.series;
    const d = run.data;
    const axes = tracks(run.metrics) ? kAxes : ['x'];
    const lead = 'What the trajectory generator of each part asks for, what the part counts and ' +
      'where the table really is. ';
    const section = axes.length > 1 ? T.section('axes', 'Axes', lead) : T.section('axes', 'Motion',
      [lead, 'The program uses X only. ', T.zoomLead()]);
    const { line, pair } = T.lm628;
    const plot = (id, unit, series) => (a) => T.timePlot({ id: `${id}-${a}`, title:
      `${a.toUpperCase()} ${id}`, yLabel: `${id} (${unit})`, series: series(a) });
    const plots = [
      plot('position', 'mm', (a) => [...pair('table', 'mm', 3, d.desired[a], d.table[a], 4),
        line('real, as counted', d.counted[a], 'model', 'mm', 3, { hidden: axes.length > 1,
          steps: true })]),
      plot('speed', 'mm/s', (a) => pair('table', 'mm/s', 2, d.asked[a], s[`${a}_mm_s`])),
      ...['error', 'terms', 'voltage', 'current'].map((name) => (a) => T.lm628[`${name}Plot`](s,
        `${a}_`))];
    const o = run.metrics.options;
    section.append(T.el('div', { class: 'grid two' }, plots.flatMap((make) => axes.map(make))),
      T.el('div', { class: 'card' }, note(`A count is ${T.num(1e3 * d.mm, 4)} \u00b5m of travel, ` +
        `a sample ${T.num(1e6 * sampleOf(run.metrics), 1)} \u00b5s. Terms (data sheet ` +
        'SNVS781C): p = kp e, shown before its limit of 16 bits, i = ki \u03a3e / 256 within ' +
        '\u00b1il, d = kd (e ' +
        `\u2212 e\u2032); kp = ${o['filter.kp']}, ki = ${o['filter.ki']}, kd = ` +
        `${o['filter.kd']}. The output has 16 bits, of which the converter gets the upper 8: ` +
        `${T.num(o['motor.supply_V'] / 128, 3)} V a step.`)));
  }

  // ---- status ----

  function statusSection(run) {
    const axes = tracks(run.metrics) ? kAxes : ['x'];
    const several = axes.length > 1;
    const { events } = run.metrics;
    T.section('status', 'Status', 'A bar where the bit is set, if only in one of the samples ' +
      'that a pixel stands for. ' + (several ? 'Stage III never clears \u201ctrajectory ' +
      'complete\u201d: it asks for the desired position.' : '')).append(T.el('div',
      { class: several ? 'grid two' : 'grid' }, axes.map((a, k) => T.lm628.statusPlot(run, `${a}_`,
        ['low switch', 'high switch'].map((name, end) => [name, run.series.limits, 2 * k + end]),
        'and its limit switches'))),
    T.el('div', { class: 'card' }, events.length > 0 ? T.lm628.eventTable('Event', events, [
      ['axis', (one) => one.axis.toUpperCase()], ['what', (one) => one.what]])
      : T.el('p', {}, 'No part interrupted its host, and no limit switch opened.')));
  }

  // ---- assumptions ----

  const kMotor = 'the Aerotech 1075 has no public electrical data';
  const kAssumed = [
    [['motor.resistance_ohm', 'motor.inductance_H', 'motor.constant_N_m_A', 'motor.inertia_kg_m2',
      'motor.coulomb_N_m'], kMotor],
    [['motor.supply_V', 'motor.current_limit_A'], 'an amplifier of the LM675 class'],
    [['encoder.hysteresis_V', 'stage.switch_hysteresis_m', 'stage.overtravel_m'],
      'McAfee gives none'],
    [['stage.pitch_m'], 'the 0.158 in that are stated; 158 turns over 24 in would be 0.1519'],
    [['filter.ki', 'filter.kd'], 'none is listed; Stage II has kp = 255 alone'],
    [['trajectory.acceleration'], 'Stage III lists none; 60 000 is far above what 3 A can give'],
    [['track.least_speed'], 'ours: v = 0 in a corner would never end'],
    [['track.velocity_shift'], 'ours: DECOMP alone reaches 13.7 mm/s'],
    [['chip.clock_MHz'], 'not stated; the numbers of Stage II are round for 6 MHz alone'],
  ];

  function assumptionCard(m) {
    const why = (value) => T.el('td', { class: 'text dim' }, value);
    const rows = kAssumed.filter(([keys]) => tracks(m) || !/^(traj|track)/.test(keys[0]))
      .flatMap(([keys, reason]) => keys.map((key) => [key, T.valueText(m.options[key]),
        why(reason)]));
    return T.el('div', { class: 'card long' }, T.lm628.table(['Assumed', 'value',
      T.lm628.text('because', 'th')], rows));
  }

  function sections(run) {
    const m = run.metrics;
    if (run.count < 2) return;
    const begin = run.data.t ? run.series.t_s[0] : 0;
    T.time.start(run.data.t || run.series.t_s);
    if (run.data.t) T.time.label = 'Time since the first row (s)';
    T.time.marks = m.events.map((one) => one.time_s - begin);
    if (run.detail) {
      trackingSection(run);
      feedSection(run);
    }
    axesSection(run);
    statusSection(run);
  }

  const closing = (run) => T.section('assumptions', 'Assumptions', 'What McAfee 1994 leaves ' +
    'open, and the value used in this run.').append(assumptionCard(run.metrics));

  // ---- several runs ----

  function plots(runs, overlay) {
    const plot = (id, title, small, unit, digits) => ({ id, title, small, yLabel: `${id.split(
      '-')[0]} (${unit})`, unit, digits });
    const tracking = runs.some((run) => tracks(run.metrics)) ? [
      overlay(plot('error-contour', 'Contour error', 'to the path', 'mm', 3), (run) =>
        run.data.speed && run.series.contour_mm),
      overlay(plot('speed', 'Path speed', 'of the table', 'mm/s', 2), (run) => run.data.speed)]
      : [overlay(plot('position', 'X position', 'of the table', 'mm', 3), (run) =>
        run.data.table.x)];
    return [...tracking, ...kAxes.slice(0, tracking.length).map((a) => overlay(plot(`error-${a}`,
      `${a.toUpperCase()} error`, 'desired less real', 'mm', 3), (run) => run.data.error[a]))];
  }

  const compare = {
    kindOf: (run) => `${run.metrics.options.program} ${run.metrics.options['path.kind']}`,
    sample: (run) => sampleOf(run.metrics),
    smallerIsBetter: (f) => /\.(time_s|contour_\w+_mm|max_error_counts)$/.test(f.id),
    plots,
    sections(runs) {
      if (!runs.some((run) => run.data.command)) return;
      T.section('paths', 'Paths', 'From the start of each; desired in grey, table in the colour ' +
        'of its run.').append(T.el('div', { class: 'grid four' }, T.pathCards(runs, (run) =>
        runName(run.metrics))));
    },
    heading: 'Tracking',
    timeLabel: 'Time since the first row, or the start (s)',
    lead: 'Differences are to the first run of the same program and path.',
  };

  const kStages = { read: 'Stage I', move: 'Stage II', track: 'Stage III' };

  (T.machines = T.machines || {}).mcafee = { prepare, asides, sections, closing, compare,
    chips: (m) => [kStages[m.options.program], ...(tracks(m) ? [runName(m)] : [])] };
})(window.Trammel = window.Trammel || {});
