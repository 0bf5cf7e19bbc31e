// SPDX-License-Identifier: Apache-2.0
//
// One drawing, two outcomes: a scene is drawn on a painter, which is a canvas for the screen and
// for PNG, or SVG text for papers and print.
(function (T) {
  'use strict';

  const kFont = 'system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", ' +
    '"Liberation Sans", Arial, sans-serif';

  // points: [x0, y0, x1, y1, ...]
  class CanvasPainter {
    constructor(context) {
      this.c = context;
    }

    rect(x, y, w, h, style) {
      this.c.globalAlpha = style.alpha === undefined ? 1 : style.alpha;
      if (style.fill) {
        this.c.fillStyle = style.fill;
        this.c.fillRect(x, y, w, h);
      }
      if (style.stroke) {
        this.c.strokeStyle = style.stroke;
        this.c.lineWidth = style.width || 1;
        this.c.strokeRect(x, y, w, h);
      }
      this.c.globalAlpha = 1;
    }

    path(points, style) {
      const c = this.c;
      c.globalAlpha = style.alpha === undefined ? 1 : style.alpha;
      c.beginPath();
      c.moveTo(points[0], points[1]);
      for (let k = 2; k < points.length; k += 2) c.lineTo(points[k], points[k + 1]);
      if (style.close) c.closePath();
      if (style.fill) {
        c.fillStyle = style.fill;
        c.fill();
      }
      if (style.stroke) {
        c.strokeStyle = style.stroke;
        c.lineWidth = style.width || 1;
        c.lineJoin = 'round';
        c.lineCap = style.cap || 'butt';
        c.setLineDash(style.dash || []);
        c.stroke();
        c.setLineDash([]);
      }
      c.globalAlpha = 1;
    }

    circle(x, y, radius, style) {
      this.c.beginPath();
      this.c.arc(x, y, radius, 0, 2 * Math.PI);
      if (style.fill) {
        this.c.fillStyle = style.fill;
        this.c.fill();
      }
      if (style.stroke) {
        this.c.strokeStyle = style.stroke;
        this.c.lineWidth = style.width || 1;
        this.c.stroke();
      }
    }

    text(x, y, text, style) {
      const c = this.c;
      c.font = `${style.weight || 400} ${style.size || 12}px ${kFont}`;
      c.fillStyle = style.fill;
      c.textAlign = style.align || 'left';
      c.textBaseline = 'alphabetic';
      const drop = style.middle ? 0.35 * (style.size || 12) : 0;
      if (style.turn) {
        c.save();
        c.translate(x, y);
        c.rotate(-Math.PI / 2);
        c.fillText(text, 0, drop);
        c.restore();
      } else {
        c.fillText(text, x, y + drop);
      }
    }

    clip(x, y, w, h) {
      this.c.save();
      this.c.beginPath();
      this.c.rect(x, y, w, h);
      this.c.clip();
    }

    unclip() {
      this.c.restore();
    }
  }

  const escapes = { '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' };
  const safe = (text) => String(text).replace(/[&<>"]/g, (c) => escapes[c]);
  const short = (value) => String(Math.round(value * 100) / 100);
  let clips = 0;

  class SvgPainter {
    constructor(width, height) {
      this.parts = [`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" ` +
        `width="${width}" height="${height}" font-family="${safe(kFont)}">`];
    }

    style(style) {
      let text = ` fill="${style.fill || 'none'}"`;
      if (style.stroke) text += ` stroke="${style.stroke}" stroke-width="${style.width || 1}"`;
      if (style.dash) text += ` stroke-dasharray="${style.dash.join(' ')}"`;
      if (style.stroke) text += ' stroke-linejoin="round"';
      if (style.cap) text += ` stroke-linecap="${style.cap}"`;
      if (style.alpha !== undefined) text += ` opacity="${style.alpha}"`;
      return text;
    }

    rect(x, y, w, h, style) {
      this.parts.push(`<rect x="${short(x)}" y="${short(y)}" width="${short(w)}" ` +
        `height="${short(h)}"${this.style(style)}/>`);
    }

    path(points, style) {
      let d = `M${short(points[0])} ${short(points[1])}L`;
      for (let k = 2; k < points.length; k += 2) {
        d += `${short(points[k])} ${short(points[k + 1])} `;
      }
      this.parts.push(`<path d="${d.trim()}${style.close ? 'Z' : ''}"${this.style(style)}/>`);
    }

    circle(x, y, radius, style) {
      this.parts.push(`<circle cx="${short(x)}" cy="${short(y)}" r="${short(radius)}"` +
        `${this.style(style)}/>`);
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

    end() {
      return this.parts.join('') + '</svg>';
    }
  }

  // Draws into a canvas of that size in CSS pixels.
  T.paint = function (canvas, width, height, ratio, draw) {
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
    const context = canvas.getContext('2d');
    context.scale(ratio, ratio);
    draw(new CanvasPainter(context));
  };

  T.svgOf = function (plot, width, height) {
    const painter = new SvgPainter(width, height);
    plot.scene(painter, width, height, T.light);
    return painter.end();
  };
})(window.Trammel = window.Trammel || {});
