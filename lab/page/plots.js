// SPDX-License-Identifier: Apache-2.0
//
// All plots of the page: drawn as figures, saved as SVG or PNG, and printed. A plot is
// {id, title, scene(painter, width, height, theme), height(width)}.
(function (T) {
  'use strict';

  const kSaveWidth = 900;
  const kPngScale = 3;  // 2700 pixels wide: 300 dpi over two columns
  const kTitle = 26;    // pixels above a saved plot

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

  // For papers: white ground, light colours, the title above.
  T.svgText = function (plot) {
    const width = plot.saveWidth || kSaveWidth;
    const height = plot.saveHeight || plot.height(width);
    const ground = T.shapes((p) => {
      p.rect(0, 0, width, height + kTitle, { fill: T.light.surface });
      p.text(10, 18, plot.title, { fill: T.light.ink, size: 14, weight: 600 });
    });
    return T.svg(width, height + kTitle, `${ground}<g transform="translate(0 ${kTitle})">` +
      `${T.shapes(plot.scene, width, height, T.light)}</g>`);
  };

  T.pngBlob = async function (plot) {
    const image = T.el('img', { src: `data:image/svg+xml,${encodeURIComponent(T.svgText(plot))}` });
    await image.decode();
    const [width, height] = [image.naturalWidth * kPngScale, image.naturalHeight * kPngScale];
    const canvas = T.el('canvas', { width, height });
    canvas.getContext('2d').drawImage(image, 0, 0, width, height);
    return new Promise((done) => canvas.toBlob(done, 'image/png'));
  };

  T.save = async function (plot, kind) {
    const blob = kind === 'png' ? await T.pngBlob(plot)
      : new Blob([T.svgText(plot)], { type: 'image/svg+xml' });
    download(blob, `${T.fileStem}-${plot.id}.${kind}`);
  };

  // A plot drawn on plot.canvas, as wide as its card: its scene and, over it, an overlay that moves
  // with the cursor.
  T.figure = function (plot, small) {
    T.register(plot);
    const card = T.card(plot.title, small, plot);
    const [ground, over] = [T.el('div'), T.el('div', { class: 'over' })];
    plot.canvas = T.el('div', { class: 'plot screen-only', role: 'img', 'aria-label': plot.title },
      ground, over);
    card.append(plot.canvas);
    let width = 0;

    const draw = (target, scene) => {
      if (width > 0) target.innerHTML = T.svgOf(scene, width, plot.height(width), T.theme());
    };
    plot.redrawOver = () => plot.overlay && draw(over, plot.overlay);
    plot.redraw = () => {
      draw(ground, plot.scene);
      plot.redrawOver();
    };
    plot.resize = () => {
      const now = Math.floor(plot.canvas.clientWidth);
      if (now === width || now <= 0) return;
      width = now;
      plot.redraw();
    };
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

  // On paper plots have light colours and the width of their card on a page.
  const kPrintWidth = { wide: 760, half: 440, quarter: 240 };
  let opened = [];

  function beforePrint() {
    for (const plot of T.plots) {
      const card = document.querySelector(`[data-plot="${plot.id}"]`);
      const width = kPrintWidth[plot.print || 'half'];
      const picture = T.el('div', { class: 'print-only' });
      picture.innerHTML = T.svgOf(plot.scene, width, (plot.printHeight || plot.height)(width),
        T.light);
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
