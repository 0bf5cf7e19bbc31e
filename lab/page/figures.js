// SPDX-License-Identifier: Apache-2.0
//
// The figures of a run, from the list in metrics.json: the tiles that open the page, tables of all
// that are shown, and those that a source prints or that are expected beside ours.
(function (T) {
  'use strict';

  T.unit = (unit) => unit.replace(/([A-Za-z])2\b/g, '$1\u00b2').replace(/([A-Za-z])3\b/g,
    '$1\u00b3').replace(/\bum\b/, '\u00b5m');
  T.withUnit = (name, unit) => (unit ? `${name} (${T.unit(unit)})` : name);
  T.capital = (text) => text.charAt(0).toUpperCase() + text.slice(1);

  // A figure without digits is a whole number.
  T.figureText = (f, value = f.value) => (f.digits === undefined ? T.whole(value)
    : T.num(value, f.digits));

  const shownOf = (m) => m.figures.filter((f) => f.shown !== false);
  const isJudged = (f) => f.printed !== undefined || f.expected !== undefined;
  T.judged = (m) => m.figures.filter(isJudged);

  // Values of a source with the digits they came with, but no fewer than two where ours has them.
  function sourceDigits(f) {
    const decimals = (value) => (value === undefined ? 0
      : (String(value).split('.')[1] || '').length);
    return Math.max(decimals(f.printed), decimals(f.expected), Math.min(2, f.digits || 0));
  }

  const printedText = (f) => (f.printed === undefined ? '\u2013' : T.num(f.printed,
    sourceDigits(f)));
  const expectedText = (f) => (f.expected === undefined ? '\u2013'
    : `${T.num(f.expected, sourceDigits(f))} \u00b1 ${T.num(f.tolerance, sourceDigits(f))}`);
  const withinCell = (f) => (f.within === undefined ? T.el('td', { class: 'dim' }, '\u2013')
    : T.el('td', { class: f.within ? 'good' : 'bad' }, f.within ? 'within' : 'outside'));

  // ---- tiles ----

  // Below a tile's value: what the machine says, the source's value, or that of the runs beside.
  function asideOf(f, m, own) {
    if (own !== undefined) return own;
    if (f.printed !== undefined) return `printed ${printedText(f)}`;
    if (f.expected !== undefined) return `expected ${T.num(f.expected, sourceDigits(f))}`;
    return Object.entries(m.compared || {}).flatMap(([name, run]) => run.figures
      .filter((other) => other.id === f.id)
      .map((other) => `${name}: ${T.figureText(other)}`)).join(', ');
  }

  T.tiles = function (m, asides) {
    return T.el('dl', { class: 'tiles' }, m.figures.filter((f) => f.tile).map((f) => T.el('div',
      { class: 'tile' }, T.el('dt', {}, f.tile), T.el('dd', {}, T.figureText(f), T.el('small', {},
        T.unit(f.unit)), T.el('div', { class: 'aside' }, asideOf(f, m, asides[f.id]) ||
          '\u00a0')))));
  };

  // ---- all of them ----

  const kTable = 3;  // columns from which on rows make a table

  const rowName = (f) => (f.column ? f.name.slice(0, -f.column.length).replace(/[, ]+$/, '')
    : f.name);
  const like = (a, b) => a.length === b.length && a.every((f, k) => f.column === b[k].column);

  // Neighbours that are the same, in lists of their own.
  function grouped(items, same) {
    const groups = [];
    items.forEach((item, k) => {
      if (k > 0 && same(items[k - 1], item)) groups[groups.length - 1].push(item);
      else groups.push([item]);
    });
    return groups;
  }

  // Rows with the same columns; a unit stands in the heading, in the row's name, or in its cells.
  function matrix(rows) {
    const [first] = rows;
    const inHead = rows.every((row) => row.every((f, k) => f.unit === first[k].unit));
    const inName = !inHead && rows.every((row) => row.every((f) => f.unit === row[0].unit));
    const cell = (f) => (inHead || inName || !f.unit ? T.figureText(f)
      : `${T.figureText(f)} ${T.unit(f.unit)}`);
    return T.table(['', ...first.map((f) => T.withUnit(f.column || '', inHead ? f.unit : ''))],
      rows.map((row) => [T.capital(T.withUnit(rowName(row[0]), inName ? row[0].unit : '')),
        ...row.map(cell)]));
  }

  const list = (figures) => T.table(['Figure', 'value'], figures.map((f) => [
    T.capital(T.withUnit(f.name, f.unit)), T.figureText(f)]), { class: 'list' });

  // Tables of figures: rows with the same columns together, the others as a list.
  T.figureTables = function (figures) {
    const rows = grouped(figures, (a, b) => rowName(a) === rowName(b));
    const isTable = (group) => group.length > 1 && group[0].length >= kTable;
    return grouped(grouped(rows, like), (a, b) => !isTable(a) && !isTable(b)).map((part) => T.el(
      'div', { class: 'scroll' }, isTable(part[0]) ? matrix(part[0]) : list(part.flat(2))));
  };

  // ---- beside a source ----

  // Where ours lies in the permitted band around what is expected; a bar marks what is printed.
  function gauge(f) {
    if (f.expected === undefined) return '';
    const w = 150;
    const reach = Math.max(1.7 * f.tolerance, 1.15 * Math.abs(f.value - f.expected)) || 1;
    const at = (v) => w / 2 + Math.max(-1, Math.min(1, (v - f.expected) / reach)) * (w / 2 - 6);
    const color = f.within ? 'var(--good)' : 'var(--bad)';
    const [low, high] = [at(f.expected - f.tolerance), at(f.expected + f.tolerance)];
    const node = T.el('span', { class: 'gauge', 'aria-hidden': 'true' });
    node.innerHTML = T.svgOf((p) => {
      p.rect(0, 7, w, 2, { fill: 'var(--line)' });
      p.rect(low, 4, high - low, 8, { fill: color, alpha: 0.25 });
      if (f.printed !== undefined && Math.abs(f.printed - f.expected) <= reach) {
        p.rect(at(f.printed) - 1, 1, 2, 14, { fill: 'var(--muted)' });
      }
      p.circle(at(f.value), 8, 4.5, { fill: color });
    }, w, 16);
    return node;
  }

  function offText(f) {
    if (!f.printed) return '';
    return `${f.value >= f.printed ? '+' : ''}${T.num((f.value / f.printed - 1) * 100, 1)} %`;
  }

  // Where the values beside ours come from, and what else must be said wherever they are shown.
  T.sourceNote = function (runs, noteOf) {
    const notes = runs.flatMap((m) => [...T.judged(m).map((f) => f.source), noteOf(m)]);
    const text = [...new Set(notes.filter(Boolean))].map(T.capital);
    return text.length > 0 ? T.el('p', { class: 'note' }, `${text.join('. ')}.`) : null;
  };

  function judgedCard(m, machine) {
    const rows = T.judged(m).map((f) => [T.capital(T.withUnit(f.name, f.unit)), T.figureText(f),
      printedText(f), T.el('td', { class: 'dim' }, offText(f)), expectedText(f), withinCell(f),
      gauge(f)]);
    return T.el('div', { class: 'card' }, T.el('div', { class: 'scroll' }, T.table(['Figure',
      'ours', 'printed', 'difference', 'expected', '', 'tolerance band (bar: printed)'],
    rows)), T.sourceNote([m], machine.figureNote));
  }

  // The same of several runs: [{run, name(), metrics}].
  T.judgedTable = (runs) => T.tableCard(['Run', ['Figure', 'text'], 'ours', 'printed', 'expected',
    ''], runs.flatMap((run, k) => T.judged(run.metrics).map((f, n) => [n === 0 ? T.runName(run, k,
    true) : '', T.capital(T.withUnit(f.name, f.unit)), T.figureText(f), printedText(f),
  expectedText(f), withinCell(f)])));

  T.figureSection = function (m, machine) {
    const section = T.section('figures', 'Figures', '');
    if (T.judged(m).length > 0) section.append(judgedCard(m, machine));
    const tables = T.figureTables(shownOf(m).filter(machine.figures));
    if (tables.length > 0) section.append(T.el('div', { class: 'card' }, tables));
    if (section.children.length === 1) section.append(T.el('p', { class: 'lead' }, 'None.'));
  };

  // Those of several runs, once each: [[figure, [value or undefined, ...]], ...].
  T.commonFigures = function (runs, wanted) {
    const all = new Map();
    runs.forEach((run, k) => shownOf(run.metrics).filter(wanted).forEach((f) => {
      if (!all.has(f.id)) all.set(f.id, [f, runs.map(() => undefined)]);
      all.get(f.id)[1][k] = f.value;
    }));
    return [...all.values()];
  };
})(window.Trammel = window.Trammel || {});
