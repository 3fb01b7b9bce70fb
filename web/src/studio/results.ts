// The right-hand column: is it proved, how did it go, and what is in the file.
import type { Iteration, SolveReport, Solved } from '../core/protocol';
import { shortNumber } from '../viewer/colour';
import { element } from '../viewer/dom';
import { count, figures, seconds, type Figure } from '../viewer/figures';
import { plot, type PlotCurve } from '../viewer/plot';
import type { Session } from './session';
import { iterates } from './settings';

function solverFigures({ report, seconds: { solve } }: Solved): Figure[] {
  const solves = report.boundaryIterations > 0
    ? `${report.iterations} + ${report.boundaryIterations} on curves` : String(report.iterations);
  return [{ name: 'Solver', value: report.solver }, { name: 'Iterations', value: solves }, { name: 'Solved in', value: seconds(solve) }];
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

/** Whether the surface passes through the points, in one glance. */
export function verdict(solved: Solved): HTMLElement {
  const { report, certificate } = solved;
  const good = report.converged && certificate.max <= report.tolerance;
  return element('p', { class: good ? 'verdict good' : 'verdict bad' }, good
    ? `Passes through every point, to ${shortNumber(certificate.max)} of the box side`
    : `Off by ${shortNumber(certificate.max)} of the box side; the tolerance is ${shortNumber(report.tolerance)}`);
}

function curve(name: string, history: readonly Iteration[]): PlotCurve[] {
  return history.length > 1 ? [{ name, points: history.map((i) => [i.iteration, i.max] as const) }] : [];
}

function ownCurves(report: SolveReport, method: string): PlotCurve[] {
  const what = method === 'progressive' ? report.solver : `residual, ${report.solver}`;
  return [...curve(what, report.history), ...curve(`${what}, on curves`, report.boundaryHistory)];
}

function rivalCurves(session: Session): PlotCurve[] {
  const { rivals } = session;
  if (!rivals) return [];
  const names: [string, string][] = [['richardson', 'Richardson'], ['chebyshev', 'Chebyshev']];
  return names.flatMap(([key, name]) => curve(name, rivals[key]?.history ?? []))
    .concat(names.flatMap(([key, name]) => curve(`${name}, on curves`, rivals[key]?.boundaryHistory ?? [])));
}

function convergence(session: Session, solved: Solved): HTMLElement {
  const compared = rivalCurves(session);
  const curves = compared.length > 0 ? compared : ownCurves(solved.report, session.shown!.method);
  const progressive = iterates(session.shown!);
  return element('section', {}, element('h2', {}, 'Convergence'),
    element('p', { class: 'quiet caption' }, progressive
      ? 'Largest error, of the box side, at each evaluation of the limit'
      : 'Residual of the free vertices; the surface interpolates at every iteration'),
    plot(curves, 'Error against iteration, logarithmic'));
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
