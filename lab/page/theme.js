// SPDX-License-Identifier: Apache-2.0
//
// Colours, light and dark, and the choice between them; in style sheets they are --surface, --ink
// and so on. The hues of the plots can be told apart with every kind of colour vision (after Okabe
// and Ito); a role keeps its hue in all plots: the command is grey, the model blue, the table
// vermilion.
(function (T) {
  'use strict';

  const light = {
    name: 'light', surface: '#ffffff', ink: '#161a21', muted: '#5c6675', faint: '#8b95a3',
    grid: '#e9ecf0', axis: '#c3cad3', soft: '#eef1f5', page: '#f5f6f8', line: '#e2e6eb',
    good: '#00795a', bad: '#b43a00', goodSoft: '#e2f3ee', badSoft: '#fbe9df',
    asked: '#98a2b0', model: '#0072b2', actual: '#d55e00', x: '#00916a', y: '#b04f94',
    other: '#4aa6dc', total: '#161a21', accent: '#0b62b8',
    ramp: ['#f3c65a', '#ee8a33', '#d1481d', '#7c1023'],
    cold: '#0b5fa5', middle: '#f4f5f7', warm: '#c4580a',
    runs: ['#161a21', '#0072b2', '#d55e00', '#00916a', '#b04f94', '#4aa6dc', '#b58900', '#7a7f87'],
  };
  const dark = {
    name: 'dark', surface: '#161b22', ink: '#e9edf2', muted: '#9ba6b4', faint: '#707b8a',
    grid: '#232a33', axis: '#3d4754', soft: '#1f262f', page: '#0e1116', line: '#29303a',
    good: '#45cfa4', bad: '#ff9a62', goodSoft: '#12312a', badSoft: '#3a2114',
    asked: '#7d8896', model: '#4fa9ea', actual: '#ff8b45', x: '#35c79d', y: '#e08cc6',
    other: '#8fd0f7', total: '#e9edf2', accent: '#5ab0f5',
    ramp: ['#7a4fa3', '#c8447c', '#f57d3f', '#fde26b'],
    cold: '#4a9fe0', middle: '#232a33', warm: '#f08a3c',
    runs: ['#e9edf2', '#4fa9ea', '#ff8b45', '#35c79d', '#e08cc6', '#8fd0f7', '#e5bd3f', '#8b95a3'],
  };
  T.light = light;

  const listeners = [];
  const system = window.matchMedia('(prefers-color-scheme: dark)');
  let chosen = null;  // 'light' or 'dark', when the reader chose

  T.theme = () => ((chosen || (system.matches ? 'dark' : 'light')) === 'dark' ? dark : light);
  T.onTheme = (listener) => listeners.push(listener);

  function setColours(theme) {
    const { style } = document.documentElement;
    style.colorScheme = theme.name;
    for (const [name, value] of Object.entries(theme)) style.setProperty(`--${name}`, value);
    theme.runs.forEach((value, k) => style.setProperty(`--run${k}`, value));
  }

  function apply() {
    setColours(T.theme());
    for (const listener of listeners) listener();
  }

  // A page that is a file may have no storage.
  function stored(use) {
    try {
      return use(localStorage);
    } catch (error) {
      return null;
    }
  }

  T.startTheme = function () {
    chosen = stored((storage) => storage.getItem('trammel-theme'));
    system.addEventListener('change', apply);
    window.addEventListener('beforeprint', () => setColours(light));
    window.addEventListener('afterprint', () => setColours(T.theme()));
    document.getElementById('theme').addEventListener('click', () => {
      chosen = T.theme() === dark ? 'light' : 'dark';
      stored((storage) => storage.setItem('trammel-theme', chosen));
      apply();
    });
    apply();
  };

  const channels = (hex) => [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16));

  T.mix = function (from, to, part) {
    const a = channels(from);
    const b = channels(to);
    const mixed = a.map((value, k) => Math.round(value + (b[k] - value) * part));
    return '#' + mixed.map((value) => value.toString(16).padStart(2, '0')).join('');
  };

  // Colour and dash of one of several lines: behind the last colour they begin again, dashed.
  T.runColour = (theme, k) => theme.runs[k % theme.runs.length];
  T.runDash = (k) => (k < T.light.runs.length ? undefined : [6, 4]);

  // 0..1 along the ramp of errors.
  T.ramp = function (theme, part) {
    const at = Math.min(1, Math.max(0, part)) * (theme.ramp.length - 1);
    const k = Math.min(theme.ramp.length - 2, Math.floor(at));
    return T.mix(theme.ramp[k], theme.ramp[k + 1], at - k);
  };

  // -1..1: cold, middle, warm.
  T.diverge = (theme, part) => T.mix(theme.middle, part < 0 ? theme.cold : theme.warm,
    Math.min(1, Math.abs(part)));

  // Black or white, whichever reads better on that colour.
  T.inkOn = function (hex) {
    const [r, g, b] = channels(hex).map((v) => (v / 255) ** 2.2);
    return 0.2126 * r + 0.7152 * g + 0.0722 * b > 0.36 ? '#161a21' : '#ffffff';
  };
})(window.Trammel = window.Trammel || {});
