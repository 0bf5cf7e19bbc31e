// SPDX-License-Identifier: Apache-2.0
//
// Models of the track that a run without controller has given, beside its own responses: figures
// 22 to 26 of the thesis.
(function (T) {
  'use strict';

  const kSample_s = 0.01;
  const kNyquist_Hz = 50;
  const kModels = (found) => found.models.map(({ a }) => `order ${a.length}`);

  // Output of y[k] = a1 y[k-1] + ... + b1 u[k-dead] + ... for u[k], which is 0 before 0.
  function simulate({ a, b }, dead, u, count) {
    const y = [];
    for (let k = 0; k < count; ++k) {
      y.push(a.reduce((sum, one, n) => sum + one * (k > n ? y[k - 1 - n] : 0), 0) +
        b.reduce((sum, one, n) => sum + one * (k - dead - n >= 0 ? u(k - dead - n) : 0), 0));
    }
    return y;
  }

  // Gain [dB] of an impulse response at a frequency [Hz].
  function gain(h, hz) {
    const turn = 2 * Math.PI * hz * kSample_s;
    const part = (wave) => h.reduce((sum, one, k) => sum + one * wave(turn * k), 0);
    return 20 * Math.log10(Math.hypot(part(Math.cos), part(Math.sin)));
  }

  // lines: [{label, x, y, dash}]; the first is the track's own.
  function linesPlot({ id, title, small, xLabel, yLabel, lines }) {
    const plot = { id, title, height: () => 300, saveWidth: 520 };
    plot.scene = function (p, width, height, theme) {
      const range = (values) => T.range(values.filter(Number.isFinite));
      const frame = T.frame({ x: 66, y: 30, w: width - 80, h: height - 78 },
        range(lines.flatMap(({ x }) => x)), T.padded(range(lines.flatMap(({ y }) => y)), 0.06));
      T.drawFrame(p, theme, frame, { xLabel, yLabel, xCount: 5 });
      const look = (k) => (k === 0 ? { stroke: theme.actual, width: 2.5 }
        : { stroke: theme.runs[k % theme.runs.length], width: 1.4 });
      lines.forEach(({ x, y, dash }, k) => p.path(x.flatMap((v, n) => (Number.isFinite(y[n])
        ? [frame.x(v), frame.y(y[n])] : [])), { ...look(k), dash }));
      T.drawKey(p, theme, 66, 11, lines.map(({ label, dash }, k) => ({ label, dash, ...look(k) })));
    };
    return T.figure(plot, small);
  }

  T.identifiedSection = function (found) {
    const { impulse, deviation, dead, validation } = found;
    const lags = impulse.map((v, k) => k);
    const limit = deviation.map((one) => 3 * one);
    const sums = (h) => h.reduce((all, one) => [...all, (all[all.length - 1] || 0) + one], []);
    const responses = found.models.map((m) => simulate(m, dead, (k) => (k === 0 ? 1 : 0),
      impulse.length));
    const each = (x, own, made) => [{ label: 'track', x, y: own }, ...made.map((y, k) => ({
      label: kModels(found)[k], x, y }))];
    const hz = Array.from({ length: 60 }, (v, k) => 0.5 * (kNyquist_Hz / 0.5) ** (k / 60));
    const t = validation.y.map((v, k) => k * kSample_s);
    const simulated = found.models.map((m) => simulate(m, dead, (k) => validation.u[k],
      validation.y.length));
    T.section('identified', 'Models of the track', 'Identified from the first half of the run, ' +
      'judged by the second; Brochier 2006, figures 22 to 26.').append(T.el('div', {
      class: 'grid two' }, [
      linesPlot({ id: 'confidence', title: 'Impulse response', small:
        'seen; three standard deviations', xLabel: 'samples of 10 ms', yLabel: 'mm/s per count',
      lines: [{ label: 'track', x: lags, y: impulse },
        { label: '+3 deviations', x: lags, y: limit, dash: [5, 4] },
        { label: '\u22123', x: lags, y: limit.map((one) => -one), dash: [5, 4] }] }),
      linesPlot({ id: 'validation', title: 'Measured and simulated', small:
        'the first 3 s of the second half', xLabel: 'time (s)', yLabel: 'velocity (mm/s)',
      lines: each(t, validation.y, simulated) }),
      linesPlot({ id: 'step-responses', title: 'Step responses', small: '', xLabel:
        'samples of 10 ms', yLabel: 'mm/s per count', lines: each(lags, sums(impulse),
        responses.map(sums)) }),
      linesPlot({ id: 'impulse-responses', title: 'Impulse responses', small: '', xLabel:
        'samples of 10 ms', yLabel: 'mm/s per count', lines: each(lags, impulse, responses) }),
      linesPlot({ id: 'gains', title: 'Gain', small: 'mm/s per count', xLabel:
        'frequency (Hz, logarithm to base 10)', yLabel: 'gain (dB)', lines: each(hz.map(Math.log10),
        hz.map((f) => gain(impulse, f)), responses.map((h) => hz.map((f) => gain(h, f)))) })]));
  };
})(window.Trammel = window.Trammel || {});
