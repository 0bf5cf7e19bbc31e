// SPDX-License-Identifier: Apache-2.0
//
// Elements and numbers. All text enters the page as text, never as mark-up.
(function (T) {
  'use strict';

  // el('td', {class: 'dim'}, 'text', child, ...)
  T.el = function (tag, attributes, ...children) {
    const node = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes || {})) {
      if (name.startsWith('on')) {
        node.addEventListener(name.slice(2), value);
      } else if (value !== null && value !== undefined && value !== false) {
        node.setAttribute(name, value === true ? '' : value);
      }
    }
    node.append(...children.flat(2).filter((c) => c !== null && c !== undefined));
    return node;
  };

  const minus = (text) => (/^-0(\.0*)?$/.test(text) ? text.slice(1) : text.replace('-', '\u2212'));

  T.num = (value, digits) => (Number.isFinite(value) ? minus(value.toFixed(digits)) : '\u2013');

  // A whole number with thin spaces between groups of three digits.
  T.whole = (value) => minus(String(Math.round(value))).replace(/\B(?=(\d{3})+$)/g, '\u2009');

  T.section = function (id, title, lead) {
    const node = T.el('section', { id }, T.el('h2', {}, title), lead ? T.el('p', { class: 'lead' },
      lead) : null);
    document.getElementById('top').append(node);
    document.getElementById('sections').append(T.el('a', { href: '#' + id }, title));
    return node;
  };

  // A card with a title and, when it can be exported, its two buttons.
  T.card = function (title, small, plot) {
    const head = T.el('header', {}, T.el('h3', {}, title, small ? T.el('small', {}, small) : null));
    if (plot) {
      const save = (kind) => T.el('button', {
        type: 'button', 'data-save': kind, 'aria-label': `Save ${title} as ${kind}`,
        onclick: () => T.save(plot, kind),
      }, kind.toUpperCase());
      head.append(T.el('div', { class: 'save' }, save('svg'), save('png')));
    }
    return T.el('div', { class: 'card', 'data-plot': plot ? plot.id : null }, head);
  };

  // A group of buttons, one of them pressed; `choose` is called with its value.
  T.segments = function (label, options, chosen, choose) {
    const group = T.el('div', { class: 'segments', role: 'group', 'aria-label': label });
    for (const [value, text] of options) {
      group.append(T.el('button', {
        type: 'button', 'aria-pressed': String(value === chosen),
        onclick: (event) => {
          for (const b of group.children) b.setAttribute('aria-pressed', 'false');
          event.currentTarget.setAttribute('aria-pressed', 'true');
          choose(value);
        },
      }, text));
    }
    return T.el('span', {}, label, group);
  };

  const isCell = (c) => c instanceof HTMLTableCellElement;

  // A column whose head is [name, class] has that class. Cells are what stands in them, or ready.
  T.table = function (head, rows, attributes) {
    const columns = head.map((one) => (Array.isArray(one) ? one : [one, null]));
    const cell = (tag, c, k) => (isCell(c) ? c : T.el(tag, { class: columns[k][1] }, c));
    return T.el('table', attributes || {},
      T.el('thead', {}, T.el('tr', {}, columns.map(([name], k) => cell('th', name, k)))),
      T.el('tbody', {}, rows.map((row) => (row instanceof Node ? row
        : T.el('tr', {}, row.map((c, k) => cell(k === 0 ? 'th' : 'td', c, k)))))));
  };

  // A table in a card that may be broken over pages.
  T.tableCard = (...table) => T.el('div', { class: 'card long' }, T.el('div', { class: 'scroll' },
    T.table(...table)));
})(window.Trammel = window.Trammel || {});
