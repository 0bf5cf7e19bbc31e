// SPDX-License-Identifier: Apache-2.0
//
// The parameters of a run with their defaults and meanings, to be searched and filtered.
(function (T) {
  'use strict';

  T.valueText = (value) => (typeof value === 'string' ? value || '\u2013'
    : typeof value === 'number' && !Number.isInteger(value) ? String(Number(value.toPrecision(10)))
      : String(value));

  // "plant.x.mass_kg" -> ["plant", "x", "mass_kg"]
  function keyParts(key) {
    const parts = key.split('.');
    const name = parts.pop();
    const axis = /^[xy]$/.test(parts[parts.length - 1]) ? parts.pop() : '';
    return [parts.join('.') || 'run', axis, name];
  }

  // [{section, name, help, values: axis -> value, default, changed}], in the keys' order.
  function linesOf(m, keys, idle) {
    const lines = new Map();
    for (const [key, value] of Object.entries(m.options)) {
      if (key === 'name' || key === 'description' || idle(key, m.options)) continue;
      const [section, axis, name] = keyParts(key);
      const id = `${section}.${name}`;
      const known = keys[key] || {};
      const line = lines.get(id) || { section, name, help: known.help || '', values: {},
        changed: false };
      line.values[axis] = value;
      line.default = known.default;
      line.changed = line.changed || (known.default !== undefined && known.default !== value);
      lines.set(id, line);
    }
    return [...lines.values()];
  }

  // A cell a column, or one over all where the parameter has but one value.
  function valueCells(line, columns) {
    if (columns.length === 0) return [T.el('td', {}, T.valueText(line.values['']))];
    if ('' in line.values) {
      return [T.el('td', { colspan: columns.length, class: 'both' }, T.valueText(line.values['']))];
    }
    return columns.map((column) => T.el('td', {}, column in line.values ? T.valueText(
      line.values[column]) : ''));
  }

  function filterOf(rows) {
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
    return T.el('div', { class: 'filter' }, search, T.el('label', {}, only,
      'only those that differ from the default'));
  }

  function parameterCard(m, keys, idle) {
    const lines = linesOf(m, keys, idle);
    const columns = [...new Set(lines.flatMap((line) => Object.keys(line.values)))].filter(Boolean);
    const rows = [];
    let section = '';
    for (const line of lines) {
      if (line.section !== section) {
        section = line.section;
        rows.push(T.el('tr', { class: 'group' }, T.el('th', { colspan: 3 + Math.max(1,
          columns.length) }, section)));
      }
      rows.push(T.el('tr', { class: line.changed ? 'changed' : null,
        'data-find': `${line.section}.${line.name} ${line.help}`.toLowerCase() },
      T.el('th', {}, line.name), ...valueCells(line, columns),
      T.el('td', { class: 'dim' }, line.default === undefined ? '' : T.valueText(line.default)),
      T.el('td', { class: 'text dim' }, line.help)));
    }
    const heads = columns.length > 0 ? columns.map((column) => column.toUpperCase()) : ['value'];
    const card = T.tableCard(['Parameter', ...heads, 'default', ['meaning', 'text']], rows);
    card.prepend(filterOf(rows));
    return card;
  }

  T.parameterSection = function (m, machine) {
    T.section('parameters', 'Parameters', 'Marked: those that differ from the default.').append(
      parameterCard(m, T.page.keys, machine.idle));
  };
})(window.Trammel = window.Trammel || {});
