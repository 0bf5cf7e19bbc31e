// SPDX-License-Identifier: Apache-2.0
//
// The page of a machine that brings none: every column over time, those of a unit together.
// What a machine's page.js puts into T.machines[its name] takes the place of what stands here.
(function (T) {
  'use strict';

  const kMostLines = 8;  // colours that can be told apart

  // The lead of a section of plots over time; paper needs no advice on how to use them.
  T.zoomLead = (more) => [T.el('span', { class: 'screen-only' }, 'Drag in a plot to zoom all of ' +
    'them, double-click to see everything. Click a name to hide its line. '), more || ''];

  const digitsOf = ({ lsb }) => Math.min(6, Math.max(0, Math.ceil(-Math.log10(lsb) - 1e-9)));
  const timeOf = (run) => run.channels.find((channel) => channel.unit === 's');

  const isWord = (channel) => channel.lsb === 1;
  const kMostRatio = 20;  // of the spans of lines in one plot

  // The channels of each plot: those of a unit whose spans are not too different to be seen. Words
  // without a unit have little in common, so each has its own.
  function groupsOf(run, channels) {
    const groups = [];
    for (const channel of channels) {
      const [low, high] = T.range(run.series[channel.name]);
      const span = high - low;
      const fits = (group) => group.unit === channel.unit && channel.unit !== '' &&
        group.channels.length < kMostLines && (span === 0 || group.span === 0 ||
        (span <= kMostRatio * group.span && group.span <= kMostRatio * span));
      let group = groups.find(fits);
      if (!group) groups.push(group = { unit: channel.unit, channels: [], span: 0 });
      group.channels.push(channel);
      group.span = Math.max(group.span, span);
    }
    return groups.map((group) => group.channels);
  }

  function titleOf(group) {
    const names = group.map((channel) => channel.name);
    return names.length > 3 ? `${names.slice(0, 2).join(', ')} and ${names.length - 2} more`
      : names.join(', ');
  }

  const kLongest = 22;  // characters beside an axis
  const label = ({ unit }) => (unit.length > kLongest ? '' : T.unit(unit));

  function plotOf(run, group, k) {
    return T.timePlot({ id: `columns-${k + 1}`, title: titleOf(group),
      small: group.length === 1 ? group[0].help : '', yLabel: label(group[0]),
      series: group.map((channel, n) => ({ run: group.length === 1 ? 1 : n, label: channel.name,
        unit: T.unit(channel.unit), digits: digitsOf(channel), data: run.series[channel.name],
        steps: isWord(channel), help: channel.help })) });
  }

  function sections(run) {
    const time = timeOf(run);
    if (run.count < 2) return;
    if (!time) T.time.label = 'Sample';
    T.time.start(time ? run.series[time.name] : Float64Array.from({ length: run.count }, (v, k) =>
      k * run.stride));
    const shown = run.channels.filter((channel) => channel !== time);
    T.section('traces', 'Traces', T.zoomLead()).append(T.el('div', { class: 'grid two' },
      groupsOf(run, shown).map((group, k) => plotOf(run, group, k))));
    T.section('columns', 'Columns', 'Unit and meaning of each line.').append(T.tableCard(['Column',
      ['unit', 'text'], ['meaning', 'text']], run.channels.map(({ name, unit, help }) => [name,
      T.unit(unit), help])));
  }

  // Time from one value to the next, of the first run, which has one a sample.
  function sampleOf(any, runs) {
    const [run] = runs;
    const time = timeOf(run);
    if (time && run.count > 1) {
      const t = run.series[time.name];
      return (t[run.count - 1] - t[0]) / (run.count - 1) / run.stride;
    }
    return run.metrics.run.simulated_s / Math.max(1, run.metrics.run.samples);
  }

  const plots = (runs, overlay) => runs[0].channels.filter((channel) => channel !== timeOf(runs[0]))
    .map((channel, k) => overlay({ id: `columns-${k + 1}`, title: channel.name,
      small: channel.help, yLabel: label(channel), unit: T.unit(channel.unit),
      digits: digitsOf(channel) }, (run) => run.series[channel.name]));

  const plain = {
    prepare() {},  // data of a run that its plots share, made once
    chips: () => [],  // words behind the title, of its metrics
    asides: () => ({}),  // what stands below a tile, by the figure's id, of its metrics
    sections,  // before the figures, of a run
    figures: () => true,  // which are in the tables of a run's page
    figureNote: () => '',  // what is said below printed and expected figures, of its metrics
    closing() {},  // sections between the figures and the parameters
    idle: () => false,  // keys that do nothing with these options
    compare: {
      kindOf: () => '',  // runs are compared with the first of their kind
      sample: sampleOf,  // [s]
      figures: () => true,
      smallerIsBetter: () => false,  // of a figure; of others it is neither good nor bad
      plots,
      sections() {},
      opening: () => null,  // [s] that the plots open with
      heading: 'Traces',
      timeLabel: 'Time since the first sample (s)',
      lead: 'Differences are to the first run.',
    },
  };

  T.machineOf = function (name) {
    const own = (T.machines || {})[name] || {};
    return { ...plain, ...own, compare: { ...plain.compare, ...own.compare } };
  };
})(window.Trammel = window.Trammel || {});
