// Error against iteration, with a logarithmic axis: one curve a solver.
import { element, svg } from './dom';
import { shortNumber } from './colour';

export interface PlotCurve {
  name: string;
  /** N of --curve-N in viewer.css; otherwise its place in the plot. */
  colour?: number;
  /** (iteration, value) */
  points: readonly (readonly [number, number])[];
}

const kWidth = 300;
const kHeight = 190;
const kLeft = 42;
const kRight = 10;
const kTop = 10;
const kBottom = 32;
/** Values below are drawn as this: no double says less of a mesh of size one. */
const kFloor = 1e-17;

function niceStep(range: number, most: number): number {
  const rough = Math.max(range / most, 1e-9);
  const power = 10 ** Math.floor(Math.log10(rough));
  return [1, 2, 5, 10].map((m) => m * power).find((s) => s >= rough) ?? 10 * power;
}

const kSuperscripts = '⁰¹²³⁴⁵⁶⁷⁸⁹';
function powerLabel(exponent: number): string {
  const digits = [...String(Math.abs(exponent))].map((d) => kSuperscripts[Number(d)]).join('');
  return `10${exponent < 0 ? '⁻' : ''}${digits}`;
}

/** A figure with a caption; a table of the same numbers serves those who cannot see it. */
export function plot(curves: readonly PlotCurve[], label: string): HTMLElement {
  const all = curves.flatMap((c) => c.points.map(([i, v]) => [i, Math.max(v, kFloor)] as const));
  if (all.length < 2) return element('p', { class: 'quiet' }, 'No iterations to plot.');
  const most = Math.max(...all.map(([i]) => i), 1);
  const first = Math.min(...all.map(([i]) => i));
  const high = Math.ceil(Math.log10(Math.max(...all.map(([, v]) => v))) + 1e-9);
  const low = Math.min(Math.floor(Math.log10(Math.min(...all.map(([, v]) => v)))), high - 1);
  const x = (i: number) => kLeft + ((i - first) / Math.max(most - first, 1)) * (kWidth - kLeft - kRight);
  const y = (v: number) =>
    kTop + ((high - Math.log10(Math.max(v, kFloor))) / (high - low)) * (kHeight - kTop - kBottom);

  const picture = svg('svg', { viewBox: `0 0 ${kWidth} ${kHeight}`, role: 'img', 'aria-label': label, class: 'plot' });
  const every = Math.max(1, Math.ceil((high - low) / 6));
  for (let e = high; e >= low; e -= every) {
    const at = y(10 ** e);
    picture.append(
      svg('line', { x1: kLeft, x2: kWidth - kRight, y1: at, y2: at, class: 'grid' }),
      svg('text', { x: kLeft - 6, y: at + 3.5, 'text-anchor': 'end' }, powerLabel(e)));
  }
  const step = Math.max(1, niceStep(most - first, 5));
  for (let i = Math.ceil(first / step) * step; i <= most; i += step) {
    picture.append(
      svg('line', { x1: x(i), x2: x(i), y1: kHeight - kBottom, y2: kHeight - kBottom + 4, class: 'tick' }),
      svg('text', { x: x(i), y: kHeight - kBottom + 15, 'text-anchor': 'middle' }, String(i)));
  }
  picture.append(
    svg('line', { x1: kLeft, x2: kWidth - kRight, y1: kHeight - kBottom, y2: kHeight - kBottom, class: 'tick' }),
    svg('text', { x: (kLeft + kWidth - kRight) / 2, y: kHeight - 3, 'text-anchor': 'middle' }, 'iteration'));
  curves.forEach((curve, place) => {
    const k = curve.colour ?? place;
    const path = curve.points.map(([i, v], n) => `${n === 0 ? 'M' : 'L'}${x(i).toFixed(1)} ${y(v).toFixed(1)}`).join('');
    picture.append(svg('path', { d: path, class: `curve curve-${k}` }));
    if (curve.points.length > 60) return;
    for (const [i, v] of curve.points) {
      picture.append(svg('circle', { cx: x(i), cy: y(v), r: 1.8, class: `dot curve-${k}` },
        svg('title', {}, `${curve.name}, iteration ${i}: ${shortNumber(v)}`)));
    }
  });

  const keys = element('div', { class: 'keys' }, ...curves.map((curve, k) =>
    element('span', { class: `key key-${curve.colour ?? k}` }, `${curve.name} (${curve.points.at(-1)?.[0] ?? 0})`)));
  return element('figure', { class: 'plot-figure' }, picture as unknown as HTMLElement, keys, tableOf(curves));
}

function tableOf(curves: readonly PlotCurve[]): HTMLElement {
  const rows = curves.flatMap((curve) => curve.points.map(([i, v]) =>
    element('tr', {}, element('td', {}, curve.name), element('td', {}, String(i)), element('td', {}, shortNumber(v)))));
  const head = element('tr', {}, ...['Solver', 'Iteration', 'Error'].map((t) => element('th', { scope: 'col' }, t)));
  return element('details', { class: 'numbers' }, element('summary', {}, 'The numbers'),
    element('table', {}, element('thead', {}, head), element('tbody', {}, ...rows)));
}
