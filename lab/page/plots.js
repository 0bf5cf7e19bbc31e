// SPDX-License-Identifier: Apache-2.0
//
// All plots of the page: drawn as figures, saved as SVG or PNG, and printed. A plot is
// {id, scene(painter, width, height, theme), height(width), count()}.
(function (T) {
  'use strict';

  const kSaveWidth = 900;
  const kPngScale = 3;  // 2700 pixels wide: 300 dpi over two columns

  T.plots = [];

  T.register = function (plot) {
    T.plots.push(plot);
    return plot;
  };

  // A picture the reader can save: a link that is clicked once.
  function download(blob, name) {
    const link = T.el('a', { href: URL.createObjectURL(blob), download: name });
    document.body.append(link);
    link.click();
    link.remove();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  }

  function saveSize(plot) {
    const width = plot.saveWidth || kSaveWidth;
    return [width, (plot.saveHeight || plot.height(width)) + kTitle];
  }

  T.svgText = function (plot) {
    const [width, height] = saveSize(plot);
    return T.svgOf(T.titled(plot), width, height);
  };

  T.pngBlob = function (plot) {
    const [width, height] = saveSize(plot);
    const canvas = T.el('canvas');
    T.paint(canvas, width, height, kPngScale, (p) => T.titled(plot).scene(p, width, height,
      T.light));
    return new Promise((done) => canvas.toBlob(done, 'image/png'));
  };

  // For papers: white ground, light colours, the title above.
  const kTitle = 26;
  class Lowered {
    constructor(p, by) {
      Object.assign(this, { p, by });
    }

    rect(x, y, w, h, style) { this.p.rect(x, y + this.by, w, h, style); }
    circle(x, y, r, style) { this.p.circle(x, y + this.by, r, style); }
    text(x, y, text, style) { this.p.text(x, y + this.by, text, style); }
    clip(x, y, w, h) { this.p.clip(x, y + this.by, w, h); }
    unclip() { this.p.unclip(); }
    path(points, style) {
      this.p.path(points.map((v, k) => (k % 2 === 0 ? v : v + this.by)), style);
    }
  }

  T.titled = (plot) => ({
    scene(p, width, height, theme) {
      p.rect(0, 0, width, height, { fill: theme.surface });
      p.text(10, 18, plot.title, { fill: theme.ink, size: 14, weight: 600 });
      plot.scene(new Lowered(p, kTitle), width, height - kTitle, theme);
    },
  });

  T.save = async function (plot, kind) {
    const name = `${T.fileStem}-${plot.id}.${kind}`;
    if (kind === 'svg') {
      download(new Blob([T.svgText(plot)], { type: 'image/svg+xml' }), name);
    } else {
      download(await T.pngBlob(plot), name);
    }
  };

  // A plot drawn by its scene on a canvas that follows the card's width, with a second one above it
  // for what moves with the cursor.
  T.figure = function (plot, small) {
    T.register(plot);
    const card = T.card(plot.title, small, plot);
    const canvas = T.el('canvas', { role: 'img', 'aria-label': plot.title });
    const over = plot.overlay ? T.el('canvas', { class: 'over' }) : null;
    const frame = T.el('div', { class: 'plot screen-only' }, canvas, over);
    card.append(frame);
    let width = 0;

    const place = (target, draw) => {
      const height = plot.height(width);
      target.style.height = `${height}px`;
      target.style.width = `${width}px`;
      T.paint(target, width, height, window.devicePixelRatio || 1, (p) => draw.call(plot, p,
        width, height, T.theme()));
    };
    plot.redrawOver = () => {
      if (over && width > 0) place(over, plot.overlay);
    };
    plot.redraw = () => {
      if (width <= 0) return;
      place(canvas, plot.scene);
      plot.redrawOver();
    };
    plot.resize = () => {
      const now = Math.floor(frame.clientWidth);
      if (now === width || now <= 0) return;
      width = now;
      plot.redraw();
    };
    plot.canvas = canvas;
    plot.count = plot.count || (() => 1);
    return card;
  };

  T.startPlots = function () {
    for (const plot of T.plots) plot.resize();
    const observer = new ResizeObserver(() => {
      for (const plot of T.plots) plot.resize();
    });
    observer.observe(document.getElementById('top'));
    T.onTheme(() => {
      for (const plot of T.plots) plot.redraw();
    });
    window.addEventListener('beforeprint', beforePrint);
    window.addEventListener('afterprint', afterPrint);
  };

  // Paper gets vectors in light colours, each as wide as its card is on a page.
  const kPrintWidth = { wide: 760, half: 440, quarter: 240 };
  let opened = [];

  function beforePrint() {
    for (const plot of T.plots) {
      const card = document.querySelector(`[data-plot="${plot.id}"]`);
      const width = kPrintWidth[plot.print || 'half'];
      const picture = T.el('div', { class: 'print-only' });
      picture.innerHTML = T.svgOf(plot, width, plot.printHeight ? plot.printHeight(width)
        : plot.height(width));
      card.insertBefore(picture, card.children[1] || null);
    }
    opened = [...document.querySelectorAll('details:not([open])')];
    for (const details of opened) details.open = true;
  }

  function afterPrint() {
    for (const picture of document.querySelectorAll('.card > .print-only')) picture.remove();
    for (const details of opened) details.open = false;
  }
})(window.Trammel = window.Trammel || {});
