// SPDX-License-Identifier: Apache-2.0
//
// How far the table is from the set point of the precision controller, in um, beside a count of the
// encoder.
(function (T) {
  'use strict';

  const kUm = 1e3;  // in a millimetre

  // Error of the axes [mm] as they are shown elsewhere.
  T.precisionSection = function (run) {
    const d = run.data;
    const section = T.section('precision', 'Error in micrometres', 'Distance of the true ' +
      'position from the set point, which is the command to some hundredths of a micrometre; the ' +
      'lines of one count are the width of a step of the encoder.');
    const um = (values) => values.map((v) => v * kUm);
    const line = (label, data, role, more) => ({ label, data, role, unit: 'um', digits: 2,
      ...more });
    const plots = ['x', 'y'].map((axis) => {
      const count = run.metrics.options[`plant.${axis}.encoder_count_m`] * 1e6;
      const band = (sign) => new Array(run.count).fill(sign * count);
      return T.timePlot({ id: `precision-${axis}`, title: `${axis.toUpperCase()} error`,
        small: 'to the set point', yLabel: 'error (um)', series: [
          line('error', um(axis === 'x' ? d.errorX : d.errorY), axis, { width: 1.5 }),
          line('one count', band(1), 'asked', { width: 1 }),
          line('minus one count', band(-1), 'asked', { width: 1 })] });
    });
    const both = T.timePlot({ id: 'precision-both', title: 'Distance from the set point',
      small: 'both axes', yLabel: 'error (um)', tall: 270, series: [
        line('distance', um(d.toModel), 'total', { width: 1.5 })] });
    section.append(both, T.el('div', { class: 'grid two' }, plots));
  };
})(window.Trammel = window.Trammel || {});
