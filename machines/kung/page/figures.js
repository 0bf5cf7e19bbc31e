// SPDX-License-Identifier: Apache-2.0
//
// What is said of the figures of the X-Y table beside their values, and the periods of a step
// response.
(function (T) {
  'use strict';

  const kLine = 'path.kind';
  const kLines = ['circle', 'window', 'star', 'square', 'line', 'points'];

  T.controller = (m) => (m.options.controller === 'fc' ? 'FC' : 'AFC');

  // Keys of another line than the one that is drawn.
  T.idleKey = (key, options) => kLines.some((line) => line !== options[kLine] &&
    key.startsWith(`path.${line}_`));

  T.isPeriod = (f) => /^[xy]\.periods\./.test(f.id);

  T.kungAsides = function (m) {
    const asides = { 'tracking.model.max_mm': 'to the reference model' };
    for (const [name, digits] of [['peak_current_A', 2], ['max_speed_m_s', 3]]) {
      asides[name] = `X ${T.num(m.x[name], digits)}, Y ${T.num(m.y[name], digits)}`;
    }
    if (m.contour) asides['contour.mean_mm'] = `largest ${T.num(m.contour.max_mm, 3)}`;
    for (const axis of ['x', 'y']) {
      const { periods } = m[axis];
      if (!periods || periods.length === 0) continue;
      asides[`${axis}.periods.${periods.length - 1}.overshoot_percent`] =
        `last period; first ${T.num(periods[0].overshoot_percent, 1)}`;
    }
    return asides;
  };

  T.periodTables = (m) => T.figureTables(m.figures.filter(T.isPeriod));
})(window.Trammel = window.Trammel || {});
