// SPDX-License-Identifier: Apache-2.0
//
// The series of a run out of the page: base64, zlib, seven bits a byte, zigzag, differences. The
// inverse of lab/delta_code.cpp.
(function (T) {
  'use strict';

  async function inflate(text) {
    const packed = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
    return new Uint8Array(await new Response(stream).arrayBuffer());
  }

  // Values of one channel from byte `at` on; doubles hold every one of them exactly.
  function channel(bytes, at, count, order, lsb) {
    const values = new Float64Array(count);
    const scale = 1 / lsb;  // a division by a power of ten rounds right, a product does not
    const whole = Math.abs(Math.round(scale) - scale) < 1e-6 ? Math.round(scale) : 0;
    let last = 0;
    let before = 0;
    for (let k = 0; k < count; ++k) {
      let rest = 0;
      let weight = 1;
      let byte = bytes[at++];
      while (byte >= 128) {
        rest += (byte - 128) * weight;
        weight *= 128;
        byte = bytes[at++];
      }
      rest += byte * weight;
      const half = Math.floor(rest / 2);
      const difference = rest % 2 === 0 ? half : -half - 1;
      const value = (order === 1 ? last : 2 * last - before) + difference;
      before = last;
      last = value;
      values[k] = whole > 0 ? value / whole : value * lsb;
    }
    return { values, at };
  }

  // Adds run.series: name -> Float64Array of run.count values.
  T.decode = async function (run) {
    const bytes = await inflate(run.data);
    let at = 0;
    run.series = {};
    for (const c of run.channels) {
      const result = channel(bytes, at, run.count, c.order, c.lsb);
      run.series[c.name] = result.values;
      at = result.at;
    }
    delete run.data;
  };
})(window.Trammel = window.Trammel || {});
