// Figures as pairs of a name and a value.
import { element } from './dom';

export interface Figure {
  name: string;
  value: string;
  /** What it means, as a tooltip. */
  title?: string;
}

export function figures(list: readonly Figure[]): HTMLElement {
  return element('dl', { class: 'figures' }, ...list.map((f) =>
    element('div', { title: f.title }, element('dt', {}, f.name), element('dd', {}, f.value))));
}

export function count(n: number): string {
  return n.toLocaleString('en').replaceAll(',', '\u202f');
}
/** "1 face", "2 faces". */
export function counted(n: number, one: string, several: string): string {
  return `${count(n)} ${n === 1 ? one : several}`;
}
export function seconds(s: number): string {
  return s < 0.9995 ? `${(1000 * s).toPrecision(s < 0.01 ? 2 : 3)} ms` : `${s.toPrecision(3)} s`;
}
