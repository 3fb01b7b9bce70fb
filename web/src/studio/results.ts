// The right-hand column: is it proved, how did it go, and what is in the file.
import type { Iteration, SolveReport, Solved } from '../core/protocol';
import { shortNumber } from '../viewer/colour';
import { element } from '../viewer/dom';
import { count, figures, seconds, type Figure } from '../viewer/figures';
import { plot, type PlotCurve } from '../viewer/plot';
import { solverLook } from '../viewer/solvers';
import type { Session } from './session';
import { iterates } from './settings';

function solverFigures({ report, seconds: { solve } }: Solved): Figure[] {
  const solves = report.boundaryIterations > 0
    ? `${report.iterations} + ${report.boundaryIterations} on curves` : String(report.iterations);
  return [{ name: 'Solver', value: solverLook(report.solver).name }, { name: 'Iterations', value: solves }, { name: 'Solved in', value: seconds(solve) }];
}

function certificateFigures(session: Session, solved: Solved): Figure[] {
  const { certificate } = solved;
  const { loaded } = session;
  return [
    { name: 'Largest error', value: shortNumber(certificate.max), title: 'Of the box side, from the surface evaluated anew' },
    { name: 'Mean error', value: shortNumber(certificate.mean) },
    { name: 'Worst vertex', value: count(certificate.worstVertex) },
    { name: 'Plain surface’s error', value: shortNumber(solved.pointErrors.reduce((a, b) => Math.max(a, b), 0)), title: 'The given mesh taken as control mesh' },
    { name: 'Box side', value: shortNumber(loaded!.boxSide), title: 'Largest side of the given points’ box: the unit of all errors here' },
    ...(solved.control ? solverFigures(solved) : []),
    { name: 'Surfaces in', value: seconds(solved.seconds.surfaces) },
  ];
}

export function good({ report, certificate }: Solved): boolean {
  return report.converged && certificate.max <= report.tolerance;
}

/** Whether the surface passes through the points, in one glance. */
export function verdict(solved: Solved): HTMLElement {
  const { report, certificate } = solved;
  return element('p', { class: good(solved) ? 'verdict good' : 'verdict bad' }, good(solved)
    ? `Passes through every point, to ${shortNumber(certificate.max)} of the box side`
    : `Off by ${shortNumber(certificate.max)} of the box side; the tolerance is ${shortNumber(report.tolerance)}`);
}

/** The curves of one solver, in its own colour whatever else is in the plot. */
function curves(solver: string, history: readonly Iteration[], onCurves: readonly Iteration[], what = ''): PlotCurve[] {
  const { name, colour } = solverLook(solver);
  const one = (label: string, values: readonly Iteration[], dashed: boolean): PlotCurve[] => (values.length > 1
    ? [{ name: what + label, colour: dashed ? colour.dashed : colour.full, points: values.map((i) => [i.iteration, i.max] as const) }] : []);
  return [...one(name, history, false), ...one(`${name}, on curves`, onCurves, true)];
}

function ownCurves(report: SolveReport, method: string): PlotCurve[] {
  return curves(report.solver, report.history, report.boundaryHistory, method === 'progressive' ? '' : 'Residual, ');
}

function rivalCurves({ rivals }: Session): PlotCurve[] {
  return ['richardson', 'chebyshev'].flatMap((solver) => {
    const found = rivals?.[solver];
    return found ? curves(solver, found.history, found.boundaryHistory) : [];
  });
}

function convergence(session: Session, solved: Solved): HTMLElement {
  const compared = rivalCurves(session);
  const shown = compared.length > 0 ? compared : ownCurves(solved.report, session.shown!.method);
  const progressive = iterates(session.shown!);
  return element('section', {}, element('h2', {}, 'Convergence'),
    element('p', { class: 'quiet caption' }, progressive
      ? 'Largest error, of the box side, at each evaluation of the limit'
      : 'Residual of the free vertices; the surface interpolates at every iteration'),
    plot(shown, 'Error against iteration, logarithmic'));
}

export function results(session: Session): HTMLElement[] {
  const { loaded, solved } = session;
  if (!loaded) return [];
  if (loaded.kind === 'points') {
    return [element('section', {}, element('h2', {}, 'Points'),
      element('p', {}, 'This file has points and no faces. A mesh of them is made by'),
      element('p', {}, element('code', {}, `surpass reconstruct ${session.name} -o mesh.ply`)),
      figures([{ name: 'Points', value: count(loaded.vertices) }, { name: 'Box side', value: shortNumber(loaded.boxSide) }]))];
  }
  if (!solved) return [];
  const parts = [
    element('section', {}, element('h2', {}, 'Certificate'), verdict(solved), figures(certificateFigures(session, solved))),
    ...(solved.control ? [convergence(session, solved)] : []),
  ];
  const notes = [...loaded.notices, ...solved.report.notes];
  if (notes.length > 0) {
    parts.push(element('section', {}, element('h2', {}, 'Notes'),
      element('ul', { class: 'notes' }, ...notes.map((n) => element('li', {}, n)))));
  }
  return parts;
}
