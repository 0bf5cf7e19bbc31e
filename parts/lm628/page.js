// SPDX-License-Identifier: Apache-2.0
//
// What the pages of machines with LM628s share: plots of a part's filter and of its status bits.
// `prefix` begins the names of the series of a part: '' or 'x_'.
(function (T) {
  'use strict';

  const kBits = ['busy', 'command error', 'trajectory complete', 'index pulse', 'wraparound',
    'position error', 'breakpoint', 'motor off'];

  const line = (label, data, role, unit, digits, more) => ({ label, data, role, unit, digits,
    ...more });
  // What is wanted and what is done.
  const pair = (name, unit, digits, desired, actual, width = 3) => [
    line('desired', desired, 'asked', unit, digits, { width }),
    line(name, actual, 'actual', unit, digits)];
  const table = (head, rows) => T.el('div', { class: 'scroll' }, T.table(head, rows));
  const text = (value, tag = 'td') => T.el(tag, { class: 'text' }, value);

  // Names of the bits of a status that are set, but busy.
  const bitsText = (status) => kBits.filter((name, bit) => bit > 0 && status >> bit & 1).reverse()
    .join(', ') || '\u2013';

  // Events of parts; `more` are columns of text behind the number: [title, of(event)].
  const eventTable = (name, events, more = []) => table([name, ...more.map(([title]) => text(title,
    'th')), 'sample', 'time in the run (s)', 'desired (counts)', 'real (counts)', text('status',
    'th')], events.map((one, k) => [k + 1, ...more.map(([, of]) => text(of(one))),
    one.sample === 0 ? 'before the motion' : T.whole(one.sample), T.num(one.time_s, 5),
    T.whole(one.desired_count), T.whole(one.real_count), text(bitsText(one.status))]));

  const named = (prefix, spec) => (prefix === '' ? spec : { ...spec, id: `${spec.id}-${prefix[0]}`,
    title: `${prefix[0].toUpperCase()} ${spec.title.toLowerCase()}` });

  // A plot of columns of a part: [label, column, role, unit, digits, more].
  const plotOf = (spec, columns) => (s, prefix, print) => T.timePlot(named(prefix, { ...spec, print,
    series: columns.map(([label, column, ...how]) => line(label, s[prefix + column], ...how)) }));
  const thin = { width: 1 };
  const errorPlot = plotOf({ id: 'error', title: 'Error', small: 'desired less real', yLabel:
    'error (counts)' }, [['e', 'e', 'actual', 'counts', 0]]);
  const termsPlot = plotOf({ id: 'terms', title: 'Terms', yLabel: 'terms' }, [
    ['output', 'output', 'asked', '', 0, thin], ['d', 'd', 'y', '', 0, thin],
    ['p', 'p', 'model', '', 0], ['i', 'i', 'x', '', 0]]);
  const voltagePlot = plotOf({ id: 'voltage', title: 'Voltage', small: 'of the amplifier', yLabel:
    'voltage (V)' }, [['u', 'u_V', 'model', 'V', 2, thin]]);
  const currentPlot = plotOf({ id: 'current', title: 'Current', small: 'of the motor', yLabel:
    'current (A)' }, [['i', 'i_A', 'actual', 'A', 3, thin]]);

  // A row for the pin HI, for each status bit and for what else is given: [name, values, bit]; a
  // bar where it is set.
  function statusPlot(run, prefix, more, small) {
    const s = run.series;
    const rows = [['HI', s[`${prefix}host_irq`], 0], ...[7, 6, 5, 4, 3, 2, 1].map((bit) => [
      kBits[bit], s[`${prefix}status`], bit]), ...more];
    const card = named(prefix, { id: 'status', title: 'Status bits', print: prefix ? 'half'
      : 'wide', height: () => 50 + 25 * rows.length, cursor: null });
    const times = () => T.time.values;
    const frameOf = (width, height) => T.frame({ x: 146, y: 8, w: width - 160, h: height - 52 },
      T.time.range, [0, rows.length]);
    card.scene = function (p, width, height, theme) {
      const frame = frameOf(width, height);
      const { box } = frame;
      const ticks = T.ticks(...frame.xRange, Math.max(2, box.w / 90));
      const end = times()[run.count - 1];
      rows.forEach(([name], n) => {
        const y = box.y + (n + 0.5) * box.h / rows.length;
        p.text(box.x - 10, y, name, { fill: theme.muted, size: 12, align: 'right', middle: true });
        p.path([box.x, y, box.x + box.w, y], { stroke: theme.grid });
      });
      for (const v of ticks) {
        p.text(frame.x(v), box.y + box.h + 16, T.tickText(v, ticks), { fill: theme.muted,
          size: 11.5, align: 'center' });
      }
      p.text(box.x + box.w / 2, box.y + box.h + 34, T.time.label, { fill: theme.muted, size: 12,
        align: 'center' });
      T.markEvents(p, theme, frame);
      p.clip(box.x, box.y, box.w, box.h);
      rows.forEach(([, values, bit], n) => {
        const top = box.y + (n + 0.22) * box.h / rows.length;
        for (let k = 0; k < run.count; ++k) {
          if (!(values[k] >> bit & 1)) continue;
          const from = times()[k];
          while (k + 1 < run.count && values[k + 1] >> bit & 1) ++k;
          const to = k + 1 < run.count ? times()[k + 1] : end;
          if (to < frame.xRange[0] || from > frame.xRange[1]) continue;
          p.rect(frame.x(from), top, Math.max(2, frame.x(to) - frame.x(from)),
            0.56 * box.h / rows.length, { fill: n === 0 ? theme.actual : theme.model });
        }
      });
      p.unclip();
    };
    card.overlay = function (p, width, height, theme) {
      if (card.cursor === null) return;
      const frame = frameOf(width, height);
      const x = frame.x(times()[card.cursor]);
      p.path([x, frame.box.y, x, frame.box.y + frame.box.h], { stroke: theme.faint });
    };
    const node = T.figure(card, small);
    let shown = '';
    T.time.follow((cursor, range) => {
      card.cursor = cursor;
      if (shown === String(range)) return card.redrawOver();
      shown = String(range);
      return card.redraw();
    });
    card.canvas.addEventListener('mousemove', (event) => {
      const { box, xRange } = frameOf(card.canvas.clientWidth, card.canvas.clientHeight);
      const part = (event.offsetX - box.x) / box.w;
      T.time.point(part < 0 || part > 1 ? null
        : T.time.at(xRange[0] + part * (xRange[1] - xRange[0])), null);
    });
    card.canvas.addEventListener('mouseleave', () => T.time.point(null, null));
    return node;
  }

  T.lm628 = { line, pair, table, text, eventTable, errorPlot, termsPlot, voltagePlot, currentPlot,
    statusPlot };
})(window.Trammel = window.Trammel || {});
