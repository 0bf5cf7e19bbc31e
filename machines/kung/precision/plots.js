// SPDX-License-Identifier: Apache-2.0
//
// Plots of the errors of the precision controller: how often each is there, its spectrum, the path
// with its contour error drawn larger, and the laps.
(function (T) {
  'use strict';

  const kAxes = ['x', 'y'];
  const kUmMm = 1e-3;      // of a micrometre [mm]
  const kBins = 61;
  const kFactors = [2000, 5000, 10000, 20000];
  const kPart = 0.08;      // of the path's extent: the largest error as it is drawn at first
  const kMoves = 1e-6;     // [m/s] below which the command stands
  const kDecades = 4.5;    // of amplitudes shown

  // Positive to the left of the way of the command [um]; at a stop the way before it counts.
  function besidePath({ error, speed }) {
    const ways = [];
    let way = null;
    for (let k = 0; k < error.x.length; ++k) {
      const v = Math.hypot(speed.x[k], speed.y[k]);
      if (v > kMoves) way = [speed.x[k] / v, speed.y[k] / v];
      ways.push(way);
    }
    const first = ways.find((one) => one) || [1, 0];
    return ways.map((one, k) => {
      const [x, y] = one || first;
      return { way: [x, y], um: y * error.x[k] - x * error.y[k] };
    });
  }

  // precise: what precision.js has made of a run.
  T.besidePathPlot = function (run, precise) {
    const { command, n } = run.data;
    const beside = besidePath(precise);
    const error = Float64Array.from(beside, ({ um }, k) => (precise.counted[k] ? Math.abs(um) : 0));
    const moved = (axis) => command[axis].map((v, k) => {
      const { way: [x, y], um } = beside[k];
      return v + (precise.counted[k] ? (axis === 'x' ? -y : x) * um * kUmMm : 0);
    });
    const extent = Math.max(...kAxes.map((axis) => {
      const [low, high] = T.range(command[axis]);
      return high - low;
    }));
    const most = T.range(error, 0, 0)[1];
    const factor = kFactors.filter((one) => one * most * kUmMm <= kPart * extent).pop() ||
      kFactors[0];
    return T.pathPlot({ id: 'contour-large', title: 'Distance from the path, drawn larger', n,
      command, model: command, table: { x: moved('x'), y: moved('y') }, names: ['command'],
      magnify: kFactors, factor, bar: [10 * kUmMm, '10 \u00b5m'],
      colours: [{ label: 'from the path (\u00b5m)', values: error }] });
  };

  T.histogramPlot = function (run, precise) {
    const plot = { id: 'histogram', title: 'Histogram', height: (width) => (width < 420 ? 240
      : 270) };
    const counted = (axis) => precise.error[axis].filter((v, k) => precise.counted[k]);
    const errors = { x: counted('x'), y: counted('y') };
    const reach = Math.max(...kAxes.map((axis) => T.range(errors[axis].map(Math.abs), 0,
      0)[1])) || 1;
    const share = (axis) => {
      const bins = new Array(kBins).fill(0);
      for (const v of errors[axis]) {
        ++bins[Math.min(kBins - 1, Math.floor((v / reach + 1) / 2 * kBins))];
      }
      return bins.map((count) => 100 * count / Math.max(1, errors[axis].length));
    };
    const bins = { x: share('x'), y: share('y') };
    plot.bins = bins;
    plot.scene = function (p, width, height, theme) {
      const top = Math.max(...bins.x, ...bins.y) * 1.06 || 1;
      const frame = T.frame({ x: 60, y: 26, w: width - 74, h: height - 72 }, [-reach, reach],
        [0, top]);
      T.drawFrame(p, theme, frame, { xLabel: 'error (\u00b5m)', yLabel: 'samples (%)' });
      p.clip(frame.box.x, frame.box.y, frame.box.w, frame.box.h);
      for (const axis of kAxes) {
        const count = run.metrics.options[`plant.${axis}.encoder_count_m`] * 1e6;
        for (const v of [-count, count]) {
          p.path([frame.x(v), frame.box.y, frame.x(v), frame.box.y + frame.box.h],
            { stroke: theme.asked, dash: [5, 4] });
        }
        const steps = bins[axis].flatMap((v, k) => [k, k + 1].flatMap((edge) => [
          frame.x((2 * edge / kBins - 1) * reach), frame.y(v)]));
        const [first, last] = [frame.x(-reach), frame.x(reach)];
        p.path([first, frame.y(0), ...steps, last, frame.y(0)], { fill: theme[axis], alpha: 0.18 });
        p.path(steps, { stroke: theme[axis], width: 1.5 });
      }
      p.unclip();
      T.drawKey(p, theme, frame.box.x, 12, [{ label: 'X', stroke: theme.x },
        { label: 'Y', stroke: theme.y }, { label: 'one count', stroke: theme.asked,
          dash: [5, 4] }]);
    };
    return T.figure(plot, 'errors of X and Y at the samples of the path');
  };

  // Frequencies that follow the speed of an axis, at its mean and at its highest: [[name, low,
  // high], ...].
  T.speedMarks = function (run, precise, axis) {
    const o = run.metrics.options;
    const pitch = o[`plant.${axis}.pole_pitch_m`];
    const speeds = precise.speed[axis].filter((v, k) => precise.counted[k]).map(Math.abs);
    const highest = T.range(speeds, 0, 0)[1];
    const mean = speeds.reduce((sum, v) => sum + v, 0) / Math.max(1, speeds.length);
    const of = (name, times) => [name, mean * times / pitch, highest * times / pitch];
    const harmonic = o[`plant.${axis}.cogging_harmonic`];
    return highest < kMoves ? [] : [of('electrical', 0.5), of('cogging', 1),
      ...(o[`plant.${axis}.cogging_harmonic_N`] ? [of(`${harmonic}. harmonic`, harmonic)] : [])];
  };

  T.spectrumPlot = function (run, precise, axis) {
    const amplitudes = run.detail.spectrum[axis];
    const step = run.metrics.options['chip.position_Hz'] / 2 / (amplitudes.length - 1);
    const marks = T.speedMarks(run, precise, axis);
    const plot = { id: `spectrum-${axis}`, title: `Spectrum of the ${axis.toUpperCase()} error`,
      height: (width) => (width < 420 ? 270 : 300), marks };
    plot.scene = function (p, width, height, theme) {
      const rows = amplitudes.map((v, k) => [Math.log10(k * step), v]).slice(1);
      const high = Math.ceil(Math.log10(T.range(rows.map((row) => row[1]), 1e-9)[1]) * 2) / 2;
      const low = high - kDecades;
      const tops = 8 + 15 * marks.length;
      const frame = T.frame({ x: 74, y: tops, w: width - 90, h: height - tops - 46 },
        [Math.min(0, rows[0][0]), 3], [low, high]);
      const { box } = frame;
      const label = { fill: theme.muted, size: 11.5 };
      for (const [at, hz] of T.decades(frame.xRange)) {
        p.path([frame.x(at), box.y, frame.x(at), box.y + box.h], { stroke: theme.grid });
        p.text(frame.x(at), box.y + box.h + 16, String(Number(hz.toPrecision(1))), { ...label,
          align: 'center' });
      }
      for (let power = Math.ceil(low); power <= high; ++power) {
        p.path([box.x, frame.y(power), box.x + box.w, frame.y(power)], { stroke: theme.grid });
        p.text(box.x - 7, frame.y(power), T.num(10 ** power, Math.max(0, -power)), { ...label,
          align: 'right', middle: true });
      }
      p.path([box.x, box.y, box.x, box.y + box.h, box.x + box.w, box.y + box.h],
        { stroke: theme.axis });
      const name = { fill: theme.muted, size: 12, align: 'center' };
      p.text(box.x + box.w / 2, box.y + box.h + 34, 'Frequency (Hz)', name);
      p.text(16, box.y + box.h / 2, 'amplitude (\u00b5m)', { ...name, turn: true });
      drawMarks(p, theme, frame, marks);
      p.clip(box.x, box.y, box.w, box.h);
      p.path(rows.flatMap(([at, v]) => [frame.x(at), frame.y(Math.log10(Math.max(v, 1e-12)))]),
        { stroke: theme[axis], width: 1.3 });
      p.unclip();
    };
    return T.figure(plot, 'Hann windows of 2048 samples');
  };

  // A strip above the frame from the frequency at the mean speed to that at the highest.
  function drawMarks(p, theme, { box, x, xRange }, marks) {
    marks.forEach(([name, low, high], k) => {
      const [left, right] = [low, high].map((hz) => x(Math.min(xRange[1], Math.max(xRange[0],
        Math.log10(hz)))));
      const y = 8 + 15 * k;
      for (const at of [left, right]) {
        p.path([at, y, at, box.y + box.h], { stroke: theme.faint, dash: [2, 3] });
      }
      p.rect(left, y - 4, Math.max(2, right - left), 8, { fill: theme.faint, alpha: 0.6 });
      p.text(right + 6, y, `${name}, ${T.num(low, 1)} to ${T.num(high, 1)} Hz`,
        { fill: theme.muted, size: 11.5, middle: true });
    });
  }

  // Mean error of each lap [um].
  T.lapPlot = function (laps) {
    const plot = { id: 'laps', title: 'Mean error of each lap', height: () => 240 };
    plot.scene = function (p, width, height, theme) {
      const frame = T.frame({ x: 60, y: 22, w: width - 74, h: height - 68 }, [0.5, laps.length +
        0.5], [0, Math.max(...laps) * 1.12 || 1]);
      T.drawFrame(p, theme, frame, { xLabel: 'lap', yLabel: 'error (\u00b5m)',
        xCount: Math.min(laps.length, width / 60) });
      laps.forEach((v, k) => {
        const [left, right] = [frame.x(k + 0.7), frame.x(k + 1.3)];
        p.rect(left, frame.y(v), right - left, frame.y(0) - frame.y(v), { fill: theme.actual,
          alpha: 0.75 });
        if (right - left > 24) {
          p.text((left + right) / 2, frame.y(v) - 5, T.num(v, 2), { fill: theme.ink, size: 11.5,
            align: 'center' });
        }
      });
    };
    return T.figure(plot, 'to the command, both axes');
  };
})(window.Trammel = window.Trammel || {});
