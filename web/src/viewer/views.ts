// What the picture shows, and how: plain values, changed by the toolbar.
import type { Shading } from './materials';

export type Mode = 'single' | 'overlay' | 'split';
export type Up = 'y' | 'z';

export interface View {
  mode: Mode;
  /** What each mode shows. */
  single: string;
  overlay: readonly string[];
  left: string;
  right: string;
  /** The divider of a split, from 0 to 1. */
  split: number;
  shading: Shading;
  points: boolean;
  marks: boolean;
  up: Up;
}

export interface Pane {
  ids: readonly string[];
  /** From the left, in parts of the width. */
  from: number;
  to: number;
}

export function panesOf(view: View): Pane[] {
  if (view.mode === 'single') return [{ ids: [view.single], from: 0, to: 1 }];
  if (view.mode === 'overlay') return [{ ids: view.overlay, from: 0, to: 1 }];
  return [
    { ids: [view.left], from: 0, to: view.split },
    { ids: [view.right], from: view.split, to: 1 },
  ];
}

export function defaultView(): View {
  return {
    mode: 'single', single: 'surface', overlay: ['surface', 'control'], left: 'plain', right: 'surface',
    split: 0.5, shading: 'matte', points: true, marks: true, up: 'y',
  };
}
