// The figures of a command's report, by section, in words.
import { shortNumber } from '../viewer/colour';
import { count, type Figure } from '../viewer/figures';
import type { PlotCurve } from '../viewer/plot';
import { solverLook } from '../viewer/solvers';
import type { Json } from './decode';

type Fields = { [key: string]: Json };

export interface Section {
  title: string;
  figures: Figure[];
}

function fieldsOf(value: Json | undefined): Fields {
  return value !== null && typeof value === 'object' && !Array.isArray(value) ? value : {};
}

/** The rows whose values are there. */
function rows(from: Fields, names: Record<string, string>): Figure[] {
  return Object.entries(names).flatMap(([key, name]) => {
    const value = from[key];
    if (typeof value === 'number') return [{ name, value: Number.isInteger(value) ? count(value) : shortNumber(value) }];
    if (typeof value === 'string') return [{ name, value }];
    return [];
  });
}

function inputs(report: Fields): Section[] {
  const of = (title: string, value: Json | undefined) => ({
    title,
    figures: rows(fieldsOf(value), { path: 'File', vertices: 'Vertices', points: 'Points', faces: 'Faces', box_side: 'Box side' }),
  });
  const files = Array.isArray(report.files) ? report.files : [];
  return [of('Input', report.input), of('A', report.a), of('B', report.b), ...files.map((f) => of('File', f))];
}

function distance(value: Json | undefined): Section[] {
  const d = fieldsOf(value);
  const side = (title: string, one: Json | undefined) => ({
    title, figures: rows(fieldsOf(one), { max: 'Largest', max_bound: 'At most', mean: 'Mean', rms: 'RMS', percentile99: '99 % below' }),
  });
  return [
    { title: 'Hausdorff distance', figures: rows(d, { hausdorff: 'Found', hausdorff_bound: 'At most', box_side: 'Box side of A' }) },
    side('From A to B', d.a_to_b), side('From B to A', d.b_to_a),
    side('All points to the surface, of the box side', d.all), side('Used points', d.used),
  ];
}

export function sections(report: Fields): Section[] {
  const error = fieldsOf(report.error);
  const certificate: Section = {
    title: 'Certificate, of the box side',
    figures: [
      ...rows(error, { max: 'Largest error', mean: 'Mean error', initial_max: 'Plain surface’s error' }),
      ...rows(fieldsOf(report.error_stored), { max: 'As stored in the file' }),
      ...rows(fieldsOf(report.oracle), { max: 'By another evaluator', evaluator: 'Evaluator' }),
      ...rows(report, { tolerance: 'Tolerance' }),
    ],
  };
  const surface: Section = {
    title: 'Surface',
    figures: rows(report, { scheme: 'Scheme', boundary: 'Boundary', method: 'Method', solver: 'Solver', iterations: 'Iterations',
      // Most meshes have no curves.
      ...(report.boundary_iterations === 0 ? {} : { boundary_iterations: 'Iterations on curves' }), levels: 'Refinements' }),
  };
  const made: Section = {
    title: 'Reconstruction',
    figures: rows(fieldsOf(report.reconstruction), { points: 'Points', duplicates: 'Duplicates', outliers: 'Outliers',
      unused: 'Unused', spacing: 'Spacing', noise: 'Noise, in spacings', pieces: 'Pieces', genus: 'Genus', open_loops: 'Open loops' }),
  };
  const solved: Section = {
    title: 'Interpolation, of the box side',
    figures: rows(fieldsOf(report.interpolation), { max: 'Largest error', mean: 'Mean error', solver: 'Solver', iterations: 'Iterations' }),
  };
  return [...inputs(report), certificate, surface, made, solved, ...distance(report.distance)].filter((s) => s.figures.length > 0);
}

/** What the page is called: the file that it is about, or else what it shows. */
export function titleOf(report: Fields, shown: readonly string[]): string {
  const paths = [report.input, report.a, report.b].flatMap((value) => fieldsOf(value).path ?? []);
  const names = paths.filter((path) => typeof path === 'string').map((path) => path.replace(/^.*[\\/]/, ''));
  return (names.length > 0 ? names : shown.slice(0, 2)).join(', ');
}

/** Curves in their solvers' colours. */
export function coloured(report: Fields, curves: readonly { name: string; points: [number, number][] }[]): PlotCurve[] {
  return curves.map((curve) => {
    const own = curve.name === 'This solver';
    const [solver = '', dashed] = curve.name.toLowerCase().split(', ');
    const { name, colour } = solverLook(own ? String(report.solver) : solver);
    return { ...curve, name: own ? name : curve.name, colour: dashed ? colour.dashed : colour.full };
  });
}
