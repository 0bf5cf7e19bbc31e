// SPDX-License-Identifier: Apache-2.0
//
// The figures of a run: the large ones at the top, the table of errors, the periods of a step
// response, and the paper's figures beside ours.
(function (T) {
  'use strict';

  const kErrors = [
    ['T(k) to reference model', (m) => m.tracking.model],
    ['T(k) to command', (m) => m.tracking.command],
    ['Contour', (m) => m.contour],
    ['X to reference model', (m) => m.x.error_to_model],
    ['Y to reference model', (m) => m.y.error_to_model],
  ];

  T.controller = (m) => (m.options.controller === 'fc' ? 'FC' : 'AFC');

  const paperLine = (m, what) => (m.comparison || []).find((line) => line.what === what);

  T.tile = (name, value, digits, unit, aside) => T.el('div', { class: 'tile' },
    T.el('dt', {}, name), T.el('dd', {}, T.num(value, digits), T.el('small', {}, unit),
      T.el('div', { class: 'aside' }, aside || '\u00a0')));

  T.tiles = function (m) {
    const { tile } = T;
    const compared = (what) => {
      const line = paperLine(m, what);
      if (!line) return '';
      if (line.paper !== undefined) return `paper ${T.num(line.paper, 2)}`;
      return line.expected !== undefined ? `expected ${T.num(line.expected, 2)}` : '';
    };
    const peak = Math.max(m.x.peak_current_A, m.y.peak_current_A);
    const speed = Math.max(m.x.max_speed_m_s, m.y.max_speed_m_s);
    const last = (axis) => m[axis].periods && m[axis].periods[m[axis].periods.length - 1];
    const list = [
      tile('Mean tracking error', m.tracking.model.mean_mm, 3, 'mm', compared('mean')),
      tile('Standard deviation', m.tracking.model.std_mm, 3, 'mm', compared('standard deviation')),
      tile('Largest error', m.tracking.model.max_mm, 3, 'mm', 'to the reference model'),
    ];
    if (last('x')) {
      const first = (axis) => T.num(m[axis].periods[0].overshoot_percent, 1);
      list.push(tile('Overshoot X', last('x').overshoot_percent, 1, '%',
        `last period; first ${first('x')}`));
      list.push(tile('Overshoot Y', last('y').overshoot_percent, 1, '%',
        `last period; first ${first('y')}`));
    } else if (m.contour) {
      list.push(tile('Mean contour error', m.contour.mean_mm, 3, 'mm',
        `largest ${T.num(m.contour.max_mm, 3)}`));
    }
    list.push(tile('Peak current', peak, 2, 'A', `X ${T.num(m.x.peak_current_A, 2)}, ` +
      `Y ${T.num(m.y.peak_current_A, 2)}`));
    if (!last('x')) {
      list.push(tile('Top speed', speed, 3, 'm/s', `X ${T.num(m.x.max_speed_m_s, 3)}, ` +
        `Y ${T.num(m.y.max_speed_m_s, 3)}`));
    }
    return T.el('dl', { class: 'tiles' }, list);
  };

  T.errorTable = function (m) {
    const rows = kErrors.filter(([, of]) => of(m) && of(m).samples > 0).map(([name, of]) => {
      const s = of(m);
      return [name, T.num(s.mean_mm, 3), T.num(s.std_mm, 3), T.num(s.variance_mm2, 3),
        T.num(s.rms_mm, 3), T.num(s.max_mm, 3)];
    });
    return T.el('div', { class: 'scroll' }, T.table(['Error', 'mean (mm)', 'std (mm)',
      'variance (mm\u00b2)', 'rms (mm)', 'largest (mm)'], rows));
  };

  T.periodTable = function (m) {
    const head = ['Period', ...m.x.periods.map((p, k) => k + 1)];
    const rows = [];
    for (const [axis, name] of [['x', 'X'], ['y', 'Y']]) {
      rows.push([`${name} overshoot (%)`, ...m[axis].periods.map((p) => T.num(p.overshoot_percent,
        1))]);
      rows.push([`${name} rms error (mm)`, ...m[axis].periods.map((p) => T.num(p.rms_mm, 2))]);
    }
    return T.el('div', { class: 'scroll' }, T.table(head, rows));
  };

  // Where ours lies in the permitted band around what is expected; a bar marks the paper.
  function gauge(line) {
    if (line.expected === undefined) return '';
    const w = 150;
    const reach = Math.max(1.7 * line.tolerance, 1.15 * Math.abs(line.ours - line.expected));
    const at = (v) => w / 2 + Math.max(-1, Math.min(1, (v - line.expected) / reach)) * (w / 2 - 6);
    const svg = (tag, attributes) => {
      const node = document.createElementNS('http://www.w3.org/2000/svg', tag);
      for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
      return node;
    };
    const node = svg('svg', { class: 'gauge', viewBox: `0 0 ${w} 16`, 'aria-hidden': 'true' });
    const [low, high] = [at(line.expected - line.tolerance), at(line.expected + line.tolerance)];
    node.append(svg('rect', { x: 0, y: 7, width: w, height: 2, rx: 1, fill: 'var(--line)' }),
      svg('rect', { x: low, y: 4, width: high - low, height: 8, rx: 4,
        fill: line.within ? 'var(--good)' : 'var(--bad)', opacity: 0.25 }));
    if (line.paper !== undefined && Math.abs(line.paper - line.expected) <= reach) {
      node.append(svg('rect', { x: at(line.paper) - 1, y: 1, width: 2, height: 14,
        fill: 'var(--muted)' }));
    }
    node.append(svg('circle', { cx: at(line.ours), cy: 8, r: 4.5,
      fill: line.within ? 'var(--good)' : 'var(--bad)' }));
    return node;
  }

  // Figures of a run by a machine's list: [name, unit, digits, of(metrics)].
  T.figureCard = (m, list) => T.el('div', { class: 'card' }, T.el('div', { class: 'scroll' },
    T.table(['Figure', 'value'], list.filter(([, , , of]) => of(m) !== undefined)
      .map(([name, unit, digits, of]) => [unit ? `${name} (${unit})` : name, T.num(of(m),
        digits)]))));

  // What must be said wherever these figures are shown.
  T.paperNote = function (list) {
    const notes = [...new Set(list.map((m) => m.comparison_note).filter(Boolean))];
    return notes.length ? T.el('p', { class: 'note' }, notes.join('; ') + '.') : null;
  };

  T.paperTable = function (m) {
    const rows = m.comparison.map((line) => {
      const off = line.paper === undefined || line.paper === 0 ? ''
        : `${line.ours >= line.paper ? '+' : ''}${T.num((line.ours / line.paper - 1) * 100, 1)} %`;
      const within = line.expected === undefined ? T.el('td', { class: 'dim' }, '\u2013')
        : T.el('td', { class: line.within ? 'good' : 'bad' }, line.within ? 'within' : 'outside');
      const unit = line.unit.replace('mm2', 'mm\u00b2');
      return T.el('tr', {}, T.el('th', {}, `${line.what} (${unit})`),
        T.el('td', {}, T.num(line.ours, 2)),
        T.el('td', {}, line.paper === undefined ? '\u2013' : T.num(line.paper, 2)),
        T.el('td', { class: 'dim' }, off),
        T.el('td', {}, line.expected === undefined ? '\u2013' : `${T.num(line.expected, 2)} ` +
          `\u00b1 ${T.num(line.tolerance, 2)}`),
        within, T.el('td', {}, gauge(line)));
    });
    return [T.el('div', { class: 'scroll' }, T.table(['Figure', 'ours', 'paper', 'to the paper',
      'expected', '', 'band of the expected (bar: paper)'], rows)), T.paperNote([m])];
  };

  // ---- parameters ----

  // "plant.x.mass_kg" -> ["plant", "x", "mass_kg"]
  T.keyParts = function (key) {
    const parts = key.split('.');
    if (parts.length === 3) return parts;
    return parts.length === 2 ? [parts[0], '', parts[1]] : ['run', '', key];
  };

  T.valueText = (value) => (typeof value === 'string' ? value || '\u2013'
    : typeof value === 'number' && !Number.isInteger(value) ? String(Number(value.toPrecision(10)))
      : String(value));

  T.parameterCard = function (m, keys) {
    const lines = new Map();  // section and name -> {values, changed}
    for (const [key, value] of Object.entries(m.options)) {
      if (key === 'name' || key === 'description') continue;
      const [section, axis, name] = T.keyParts(key);
      const id = `${section}.${name}`;
      const known = keys[key] || {};
      const line = lines.get(id) || { section, name, help: known.help || '', values: {},
        changed: false };
      line.values[axis || 'both'] = value;
      line.default = known.default;
      line.changed = line.changed || (known.default !== undefined && known.default !== value);
      lines.set(id, line);
    }
    const kind = m.options['path.kind'];
    const kinds = ['circle', 'window', 'star', 'square', 'line', 'points'];
    const idle = (line) => line.section === 'path' && kinds.some((other) => other !== kind &&
      line.name.startsWith(other + '_'));
    const rows = [];
    const axes = [...lines.values()].some((line) => line.values.both === undefined);
    let section = '';
    for (const line of [...lines.values()].filter((l) => !idle(l))) {
      if (line.section !== section) {
        section = line.section;
        rows.push(T.el('tr', { class: 'group' }, T.el('th', { colspan: axes ? 5 : 4 }, section)));
      }
      const { both, x, y } = line.values;
      const cells = !axes ? [T.el('td', {}, T.valueText(both))] : both !== undefined
        ? [T.el('td', { colspan: 2, class: 'both' }, T.valueText(both))]
        : [T.el('td', {}, T.valueText(x)), T.el('td', {}, T.valueText(y))];
      rows.push(T.el('tr', { class: line.changed ? 'changed' : null,
        'data-find': `${line.section}.${line.name} ${line.help}`.toLowerCase() },
      T.el('th', {}, line.name), ...cells,
      T.el('td', { class: 'dim' }, line.default === undefined ? '' : T.valueText(line.default)),
      T.el('td', { class: 'text dim' }, line.help)));
    }
    const table = T.table([T.el('th', {}, 'Parameter'), ...(axes ? ['X', 'Y'] : ['value']),
      'default', T.el('th', { class: 'text' }, 'meaning')], rows);
    const search = T.el('input', { type: 'search', placeholder: 'Find a parameter',
      'aria-label': 'Find a parameter' });
    const only = T.el('input', { type: 'checkbox' });
    const sift = () => {
      const word = search.value.trim().toLowerCase();
      let group = null;
      for (const row of rows) {
        if (row.classList.contains('group')) {
          group = row;
          group.hidden = true;
          continue;
        }
        row.hidden = !row.dataset.find.includes(word) ||
          (only.checked && !row.classList.contains('changed'));
        if (!row.hidden) group.hidden = false;
      }
    };
    search.addEventListener('input', sift);
    only.addEventListener('change', sift);
    const card = T.el('div', { class: 'card long' }, T.el('div', { class: 'filter' }, search,
      T.el('label', {}, only, 'only what differs from the default')),
    T.el('div', { class: 'scroll' }, table));
    return card;
  };
})(window.Trammel = window.Trammel || {});
