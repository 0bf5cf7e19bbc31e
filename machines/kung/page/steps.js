// SPDX-License-Identifier: Apache-2.0
//
// Step response to a square wave, its periods superimposed, so that what the rules learn from one
// to the next can be seen.
(function (T) {
  'use strict';

  const kMm = 1e3;

  function periodPlot(run, axis) {
    const d = run.data;
    const o = run.metrics.options;
    // Whole points under the feed profile.
    const point = o['path.profile'] === 'feed' ? o['chip.irq_period_ticks'] : 1;
    const samples = Math.ceil(o['path.square_half_samples'] / point) * point;
    const length = Math.max(2, Math.round(2 * samples / run.stride));
    const periods = Math.max(1, Math.floor(d.n / length));
    const half = samples / o['chip.position_Hz'];
    const plot = { id: `periods-${axis}`, title: `${axis.toUpperCase()} all periods`,
      height: (width) => (width < 420 ? 240 : 300) };
    plot.scene = function (p, width, height, theme) {
      const used = (of) => of.subarray(0, periods * length);
      const ys = T.range(used(d.model[axis]), ...T.range(used(d.table[axis])));
      const frame = T.frame({ x: 60, y: 24, w: width - 74, h: height - 70 }, [0, 2 * half],
        T.padded(ys, 0.05));
      T.drawFrame(p, theme, frame, { xLabel: 'Time since the period began (s)',
        yLabel: 'position (mm)' });
      const step = 2 * half / length;
      const line = (of, period) => {
        const points = [];
        for (let k = 0; k < length; ++k) {
          points.push(frame.x(k * step), frame.y(of[period * length + k]));
        }
        return points;
      };
      p.clip(frame.box.x, frame.box.y, frame.box.w, frame.box.h);
      const [low, high] = [o['path.square_low_m'] * kMm, o['path.square_high_m'] * kMm];
      const levels = [frame.x(0), frame.y(high), frame.x(half), frame.y(high), frame.x(half),
        frame.y(low), frame.x(2 * half), frame.y(low)];
      p.path(levels, { stroke: theme.asked, width: 2, dash: [5, 4] });
      for (let k = 0; k < periods; ++k) {
        const part = periods > 1 ? k / (periods - 1) : 1;
        p.path(line(d.table[axis], k), { stroke: T.mix(theme.soft, theme.actual, 0.3 + 0.7 * part),
          width: k === periods - 1 ? 2 : 1.2 });
      }
      p.path(line(d.model[axis], periods - 1), { stroke: theme.model, width: 1.6 });
      p.unclip();
      const narrow = width < 430;
      const name = (period) => (narrow ? String(period) : `period ${period}`);
      T.drawKey(p, theme, narrow ? 8 : frame.box.x, 11, [
        { label: 'command', stroke: theme.asked, dash: [5, 4] },
        { label: 'reference', stroke: theme.model },
        { label: name(1), stroke: T.mix(theme.soft, theme.actual, 0.3) },
        { label: name(periods), stroke: theme.actual }]);
    };
    return T.figure(plot, 'superimposed');
  }

  T.stepSection = function (run) {
    if (run.metrics.x.periods.length === 0) return;
    const section = T.section('step', 'Step response', 'Early periods are pale, late ones ' +
      'strong: the last shows what the rules have learnt.');
    section.append(T.el('div', { class: 'grid two' }, periodPlot(run, 'x'), periodPlot(run, 'y')),
      T.el('div', { class: 'card' }, T.figureTables(run.metrics.figures
        .filter(T.isPeriod))));
  };
})(window.Trammel = window.Trammel || {});
