// SPDX-License-Identifier: Apache-2.0
//
// Builds the page of a run, or of several. What is special to a machine is in T.machines, by its
// name; plain.js lists what that can be, and the defaults.
(function (T) {
  'use strict';

  function head(run, machine) {
    const m = run.metrics;
    const good = m.end === 'done';
    const copy = T.el('button', { type: 'button', onclick: async (event) => {
      try {
        await navigator.clipboard.writeText(m.command);
        event.target.textContent = 'Copied';
      } catch (error) {
        event.target.textContent = 'Select and copy it';
      }
    } }, 'Copy');
    document.getElementById('top').append(T.el('div', { class: 'head' },
      T.el('div', {}, T.el('div', { class: 'head-title' }, T.el('h1', {}, m.scenario),
        machine.chips(m).map((text) => T.el('span', { class: 'chip' }, text)),
        T.el('span', { class: `chip ${good ? 'good' : 'bad'}` }, T.capital(m.verdict))),
      T.el('p', { class: 'lead' }, m.options.description || '')),
      T.tiles(m, machine.asides(m)),
      T.el('div', { class: 'repeat' }, T.el('span', {}, 'Repeat it'), T.el('code', {}, m.command),
        copy),
      run.stride > 1 ? T.el('p', { class: 'lead' }, `The run has ${T.whole(m.run.samples)} ` +
        `samples; the plots show one in ${run.stride}.`) : null));
  }

  // Shares of the clocks at which each clock domain of the chip was awake.
  const awake = ({ activity, clocks }) => Object.entries(activity || {})
    .map(([domain, count]) => `${domain} ${T.num(100 * count / clocks, 3)} %`).join(', ');

  function foot(m) {
    const facts = { ...m.versions, 'event hash': m.run.event_hash };
    if (m.run.real_time_factor) facts['real-time factor'] = m.run.real_time_factor.toFixed(3);
    if (awake(m.run)) facts['clock domains awake'] = awake(m.run);
    document.getElementById('foot').append(T.el('dl', {}, Object.entries(facts).map(
      ([name, value]) => T.el('div', {}, T.el('dt', {}, name), T.el('dd', {}, String(value))))));
  }

  // The values of a channel: in the page they are whole steps of its resolution, each less the one
  // before it, as JSON packed by zlib.
  async function unpack({ lsb, data }) {
    const packed = Uint8Array.from(atob(data), (c) => c.charCodeAt(0));
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
    // A division by a power of ten rounds right, a product does not.
    const steps = Number((1 / lsb).toPrecision(12));
    let sum = 0;
    return Float64Array.from(await new Response(stream).json(), (by) => (sum += by) / steps);
  }

  async function show() {
    const page = JSON.parse(document.getElementById('run-data').textContent);
    T.page = page;
    T.startTheme();
    const machine = T.machineOf(page.machine);
    for (const run of page.runs) {
      run.series = {};
      for (const channel of run.channels) run.series[channel.name] = await unpack(channel);
      machine.prepare(run);
    }
    if (page.runs.length === 1) {
      T.fileStem = page.runs[0].metrics.scenario.replace(/[^\w-]+/g, '_');
      head(page.runs[0], machine);
      machine.sections(page.runs[0]);
      T.figureSection(page.runs[0].metrics, machine);
      machine.closing(page.runs[0]);
      T.parameterSection(page.runs[0].metrics, machine);
    } else {
      T.fileStem = 'compare';
      T.comparisonPage(page.runs, machine);
    }
    foot(page.runs[0].metrics);
    T.startPlots();
    if (T.time.opening) T.time.zoom(0, T.time.opening);
    requestAnimationFrame(() => setTimeout(() => {
      performance.mark('painted');
      document.documentElement.dataset.ready = 'yes';
    }));
  }

  T.start = function () {
    show().catch((error) => {
      document.getElementById('top').prepend(T.el('p', { class: 'chip bad' },
        typeof DecompressionStream === 'undefined' ? 'This browser is too old for this page: it ' +
          'needs DecompressionStream (2023).' : `The page could not be drawn: ${error.message}`));
      throw error;
    });
  };
})(window.Trammel = window.Trammel || {});
