// What the visitor chooses about the surface: the form, and the options that it stands for.
import type { Loaded, SolveOptions } from '../core/protocol';
import { shortNumber } from '../viewer/colour';
import { element, select, type Choice } from '../viewer/dom';

export interface Settings {
  scheme: string;
  boundary: string;
  method: string;
  /** The method to come back to from a scheme that has none. */
  resting: string | undefined;
  solver: string;
  tolerance: number;
  /** Refinements of the shown surface. */
  levels: number;
  /** Evaluations to stop after; undefined: as many as it takes. */
  stopAfter: number | undefined;
  tension: number;
  /** Shape parameter of the scheme that interpolates by itself. */
  shape: number;
}

/** What of the mesh decides which choices there are. */
export interface Situation {
  loaded: Loaded;
  open: boolean;
  /** Evaluations that the last solve without a stop took. */
  iterations: number;
}

/** Vertices up to which the surface follows the sliders while they move. */
export const kLiveVertices = 20000;
const kShownVertices = 30000;
const kMostShown = 1200000;
const kMostIterations = 10000;

export function suggestedLevels(vertices: number): number {
  let levels = 0;
  while (levels < 4 && vertices * 4 ** (levels + 1) <= kShownVertices) ++levels;
  return levels;
}
export function mostLevels(vertices: number): number {
  let levels = 0;
  while (levels < 6 && vertices * 4 ** (levels + 1) <= kMostShown) ++levels;
  return levels;
}

export function settingsFor(loaded: Loaded): Settings {
  return {
    scheme: loaded.scheme, boundary: 'edge-and-corner', method: 'progressive', resting: undefined, solver: 'auto',
    tolerance: 1e-12, levels: suggestedLevels(loaded.vertices), stopAfter: undefined, tension: 0,
    shape: loaded.shapes?.standard ?? 0,
  };
}

const kByItself = 'nonstationary-loop';
/** The scheme needs no control mesh, so there is nothing to solve. */
export const byItself = (s: Settings): boolean => s.scheme === kByItself;
export const iterates = (s: Settings): boolean => !byItself(s) && s.method === 'progressive';

export function solveOptions(s: Settings): SolveOptions {
  return {
    scheme: s.scheme, boundary: s.boundary, method: s.method, solver: s.solver, tolerance: s.tolerance,
    maxIterations: s.method === 'progressive' ? (s.stopAfter ?? kMostIterations) : 1000,
    tension: s.tension, shape: s.shape, levels: s.levels,
  };
}

const kSchemes: Choice<string>[] = [
  { value: 'loop', label: 'Loop' },
  { value: 'catmull-clark', label: 'Catmull-Clark' },
  { value: 'doo-sabin', label: 'Doo-Sabin' },
  { value: kByItself, label: 'Non-stationary Loop' },
];
const kOfTriangles = ['loop', kByItself];
/** The schemes with the methods similarity and fair. */
const kWithFreedom = ['loop', 'catmull-clark', 'doo-sabin'];
const kMethods: Choice<string>[] = [
  { value: 'progressive', label: 'Progressive' },
  { value: 'similarity', label: 'Similarity' },
  { value: 'fair', label: 'Fair' },
];
const kSolvers: Choice<string>[] = [
  { value: 'auto', label: 'Automatic' }, { value: 'chebyshev', label: 'Chebyshev' },
  { value: 'richardson', label: 'Richardson (the paper’s)' },
  { value: 'conjugate-gradient', label: 'Conjugate gradients' },
  { value: 'gauss-seidel', label: 'Gauss-Seidel' }, { value: 'minres', label: 'MINRES' },
  { value: 'bicgstab', label: 'BiCGSTAB' },
];
const kTolerances: Choice<string>[] = [
  { value: '1e-6', label: '1e−6' }, { value: '1e-9', label: '1e−9' }, { value: '1e-12', label: '1e−12' },
];

const kNoControl = 'This surface passes through the points by itself: no control mesh, nothing to solve. Export the surface.';

function boundaries(scheme: string): Choice<string>[] {
  const loop = scheme === 'loop';
  return [
    { value: 'edge-and-corner', label: 'Edge and corner' }, { value: 'edge-only', label: 'Edge only' },
    ...(loop ? [{ value: 'hoppe', label: 'Hoppe' }, { value: 'interior', label: 'Interior mask (no surface)', disabled: true }] : []),
  ];
}

/** What follows from the choice of a scheme. */
export function withScheme(s: Settings, scheme: string, vertices: number): Partial<Settings> {
  // The given vertices stay where they are whatever the shape: only new ones show it.
  const levels = scheme === kByItself ? Math.max(s.levels, Math.min(1, mostLevels(vertices))) : s.levels;
  return {
    scheme, levels, stopAfter: undefined,
    boundary: boundaries(scheme).some((b) => b.value === s.boundary) ? s.boundary : 'edge-and-corner',
    method: kWithFreedom.includes(scheme) ? (s.resting ?? s.method) : 'progressive',
    resting: kWithFreedom.includes(scheme) ? undefined : (s.resting ?? s.method),
  };
}

/** Settings with choices that were made before the mesh was there, as far as it allows them. */
export function withChosen(s: Settings, chosen: Partial<Settings>, loaded: Loaded): Settings {
  if (Object.keys(chosen).length === 0) return s;
  const wanted = chosen.scheme ?? s.scheme;
  const scheme = loaded.triangles || !kOfTriangles.includes(wanted) ? wanted : s.scheme;
  const next = { ...s, ...chosen, scheme };
  const all = { ...next, ...withScheme(next, scheme, loaded.vertices) };
  const { lowest, highest } = loaded.shapes ?? { lowest: s.shape, highest: s.shape };
  return { ...all, levels: Math.min(all.levels, mostLevels(loaded.vertices)), shape: Math.min(Math.max(all.shape, lowest), highest) };
}

const labelIn = (choices: readonly Choice<string>[], value: string): string => choices.find((c) => c.value === value)?.label ?? value;

/** In words, what of the settings is not as it is in others. */
export function differences(s: Settings, from: Settings): string {
  const words: string[] = [];
  if (s.scheme !== from.scheme) words.push(labelIn(kSchemes, s.scheme));
  if (s.method !== from.method) words.push(labelIn(kMethods, s.method));
  if (s.boundary !== from.boundary) words.push(`boundary ${labelIn(boundaries('loop'), s.boundary)}`);
  if (s.solver !== from.solver) words.push(labelIn(kSolvers, s.solver));
  if (s.tolerance !== from.tolerance) words.push(`tolerance ${shortNumber(s.tolerance)}`);
  if (s.levels !== from.levels) words.push(`fineness ${s.levels}`);
  if (s.shape !== from.shape) words.push(`shape ${shortNumber(s.shape)}`);
  if (s.tension !== from.tension) words.push(`tension ${shortNumber(s.tension)}`);
  if (s.stopAfter !== from.stopAfter && s.stopAfter !== undefined) words.push(`${s.stopAfter} iterations`);
  return words.join(', ');
}

interface SliderOptions {
  id: string;
  label: string;
  min: number;
  max: number;
  step: number;
  value: number;
  text: (value: number) => string;
  title: string;
  /** Values with a name, each a button. */
  named?: { name: string; value: number }[];
}

function slider(o: SliderOptions, change: (value: number) => void): HTMLElement {
  const output = element('output', { for: o.id }, o.text(o.value));
  const input = element('input', {
    type: 'range', id: o.id, min: String(o.min), max: String(o.max), step: String(o.step), 'aria-valuetext': o.text(o.value),
  });
  input.value = String(o.value);
  input.addEventListener('input', () => {
    output.textContent = o.text(input.valueAsNumber);
    input.setAttribute('aria-valuetext', o.text(input.valueAsNumber));
    change(input.valueAsNumber);
  });
  const named = (o.named ?? []).map(({ name, value }) => {
    const button = element('button', { type: 'button', class: 'small', id: `${o.id}-${name.toLowerCase()}`, title: o.text(value) }, name);
    button.addEventListener('click', () => {
      input.value = String(value);
      input.dispatchEvent(new Event('input'));
    });
    return button;
  });
  return element('div', { class: 'slider', title: o.title }, element('label', { for: o.id }, o.label), output, input,
    named.length > 0 ? element('div', { class: 'named' }, ...named) : undefined);
}

/** The sliders that change the shape. */
function shapeSliders(s: Settings, situation: Situation, change: (part: Partial<Settings>) => void): HTMLElement[] {
  if (byItself(s)) {
    const { lowest, highest, round, standard, flat } = situation.loaded.shapes!;
    return [slider({
      id: 'shape', label: 'Shape', min: lowest, max: highest, step: 0.01, value: s.shape,
      text: (v) => v.toFixed(2).replace('-', '−'), title: 'Shape parameter: the smaller, the rounder',
      named: [{ name: 'Round', value: round }, { name: 'Default', value: standard }, { name: 'Flat', value: flat }],
    }, (shape) => change({ shape }))];
  }
  if (s.method === 'fair') {
    return [slider({
      id: 'tension', label: 'Tension', min: 0, max: 0.99, step: 0.01, value: s.tension,
      text: (v) => v.toFixed(2), title: 'From a thin plate (0) to a stretched membrane',
    }, (tension) => change({ tension }))];
  }
  const most = situation.iterations;
  if (!iterates(s) || most < 2) return [];
  return [slider({
    id: 'stop-after', label: 'Iterations', min: 1, max: most, step: 1, value: Math.min(s.stopAfter ?? most, most),
    text: (v) => (v >= most ? `all ${most}` : `${v} of ${most}`),
    title: 'Stop the iteration early, to see how it gets there',
  }, (v) => change({ stopAfter: v >= most ? undefined : v }))];
}

/** How the control mesh is found. */
function solverFields(s: Settings, change: (part: Partial<Settings>) => void): HTMLElement[] {
  const methods = kMethods.map((c) => ({ ...c, disabled: c.value !== 'progressive' && !kWithFreedom.includes(s.scheme) }));
  return [
    select('Method', methods, s.method, (method) => change({ method, stopAfter: undefined })),
    ...(s.method === 'progressive' ? [select('Solver', kSolvers, s.solver, (solver) => change({ solver, stopAfter: undefined }))] : []),
    select('Tolerance', kTolerances, kTolerances.find((t) => Number(t.value) === s.tolerance)!.value,
      (tolerance) => change({ tolerance: Number(tolerance), stopAfter: undefined })),
  ];
}

export function settingsForm(s: Settings, situation: Situation, change: (part: Partial<Settings>) => void): HTMLElement {
  const { loaded } = situation;
  const schemes = kSchemes.map((c) => ({ ...c, disabled: kOfTriangles.includes(c.value) && !loaded.triangles }));
  const form = element('div', { class: 'form' },
    select('Scheme', schemes, s.scheme, (scheme) => change(withScheme(s, scheme, loaded.vertices))));
  if (situation.open) {
    form.append(select('Boundary', boundaries(s.scheme), s.boundary, (boundary) => change({ boundary, stopAfter: undefined })));
  }
  form.append(
    ...(byItself(s) ? [element('p', { class: 'quiet' }, kNoControl)] : solverFields(s, change)),
    ...shapeSliders(s, situation, change),
    slider({
      id: 'levels', label: 'Fineness', min: 0, max: mostLevels(loaded.vertices), step: 1,
      value: s.levels, text: (v) => `${v} ${v === 1 ? 'refinement' : 'refinements'}`,
      title: 'How often the shown surfaces are refined',
    }, (levels) => change({ levels })));
  return form;
}
