// SPDX-License-Identifier: Apache-2.0
//
// What a plot's scene draws on: shapes in pixels, collected as the text of an SVG. The same text is
// shown on the screen, saved for papers and printed.
(function (T) {
  'use strict';

  const kFont = 'system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", ' +
    '"Liberation Sans", Arial, sans-serif';

  const escapes = { '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' };
  const safe = (text) => String(text).replace(/[&<>"]/g, (c) => escapes[c]);
  const short = (value) => String(Math.round(value * 100) / 100);
  let clips = 0;

  function looks(style) {
    let text = ` fill="${style.fill || 'none'}"`;
    if (style.stroke) text += ` stroke="${style.stroke}" stroke-width="${style.width || 1}"`;
    if (style.dash) text += ` stroke-dasharray="${style.dash.join(' ')}"`;
    if (style.cap) text += ` stroke-linecap="${style.cap}"`;
    if (style.alpha !== undefined) text += ` opacity="${style.alpha}"`;
    return text;
  }

  class Painter {
    constructor() {
      this.parts = [];
    }

    rect(x, y, w, h, style) {
      this.parts.push(`<rect x="${short(x)}" y="${short(y)}" width="${short(w)}" ` +
        `height="${short(h)}"${looks(style)}/>`);
    }

    // points: [x0, y0, x1, y1, ...]
    path(points, style) {
      this.parts.push(`<path d="M${Array.from(points, short).join(' ')}${style.close ? 'Z' : ''}"` +
        `${looks(style)}/>`);
    }

    circle(x, y, radius, style) {
      this.parts.push(`<circle cx="${short(x)}" cy="${short(y)}" r="${short(radius)}"` +
        `${looks(style)}/>`);
    }

    text(x, y, text, style) {
      const size = style.size || 12;
      const anchor = { center: 'middle', right: 'end' }[style.align] || 'start';
      const drop = style.middle ? 0.35 * size : 0;
      const at = style.turn ? `transform="translate(${short(x)} ${short(y)}) rotate(-90)" y="` +
        `${short(drop)}"` : `x="${short(x)}" y="${short(y + drop)}"`;
      this.parts.push(`<text ${at} font-size="${size}" font-weight="${style.weight || 400}" ` +
        `text-anchor="${anchor}" fill="${style.fill}">${safe(text)}</text>`);
    }

    clip(x, y, w, h) {
      const id = `clip${++clips}`;
      this.parts.push(`<clipPath id="${id}"><rect x="${short(x)}" y="${short(y)}" ` +
        `width="${short(w)}" height="${short(h)}"/></clipPath><g clip-path="url(#${id})">`);
    }

    unclip() {
      this.parts.push('</g>');
    }
  }

  // What scene(painter, width, height, theme) draws, and an SVG of such shapes.
  T.shapes = function (scene, width, height, theme) {
    const painter = new Painter();
    scene(painter, width, height, theme);
    return painter.parts.join('');
  };

  T.svg = (width, height, shapes) => `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ` +
    `${width} ${height}" width="${width}" height="${height}" font-family="${safe(kFont)}" ` +
    'stroke-linejoin="round">' +
    `${shapes}</svg>`;

  T.svgOf = (scene, width, height, theme) => T.svg(width, height, T.shapes(scene, width, height,
    theme));
})(window.Trammel = window.Trammel || {});
