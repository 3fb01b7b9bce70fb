// A report's page: the viewer, and beside it what the command found.
import '../viewer/viewer.css';
import './report.css';
import { connectivityOf } from '../viewer/connectivity';
import { element } from '../viewer/dom';
import { shortNumber } from '../viewer/colour';
import { figures } from '../viewer/figures';
import type { LayerSource } from '../viewer/layer';
import { plot } from '../viewer/plot';
import { Stage } from '../viewer/stage';
import { themeButton } from '../viewer/theme';
import type { Content } from '../viewer/viewer';
import { floatsOf, positionsOf, shapeOf, type Json, type PageData } from './decode';
import { coloured, sections, titleOf } from './summary';

declare global {
  interface Window {
    /** For tests. */
    surpassReport?: { stage: Stage };
  }
}

function contentOf(data: PageData): Content {
  const error = data.report.error;
  const largest = error && typeof error === 'object' && !Array.isArray(error) ? error.max : undefined;
  const layers = data.layers.map((layer): LayerSource => {
    const shape = shapeOf(layer, data.centre, data.side);
    const source: LayerSource = { id: layer.id, label: layer.label, kind: layer.kind, shape, connectivity: connectivityOf(shape) };
    return layer.id === 'surface' && typeof largest === 'number' ? { ...source, flatError: largest } : source;
  });
  const content: Content = { layers };
  if (data.points) {
    content.points = positionsOf(data.points.positions, data.centre, data.side);
    if (data.points.errors) content.pointErrors = floatsOf(data.points.errors);
  }
  return content;
}

function list(value: Json | undefined): string[] {
  return Array.isArray(value) ? value.filter((v) => typeof v === 'string') : [];
}

function aside(data: PageData): HTMLElement {
  const panel = element('aside', { class: 'panel', 'aria-label': 'Figures' },
    ...sections(data.report).map((s) => element('section', {}, element('h2', {}, s.title), figures(s.figures))));
  if (data.curves.length > 0) {
    panel.append(element('section', {}, element('h2', {}, 'Convergence'), plot(coloured(data.report, data.curves), 'Error against iteration, logarithmic')));
  }
  const notes = list(data.report.notes);
  if (notes.length > 0) {
    panel.append(element('section', {}, element('h2', {}, 'Notes'), element('ul', { class: 'notes' }, ...notes.map((n) => element('li', {}, n)))));
  }
  const step = Math.max(...data.layers.map((l) => l.positions.step)) / data.side;
  panel.append(element('p', { class: 'quiet fine' },
    `The pictures show positions rounded to 16 bits (steps of ${shortNumber(step)} of the box side), normals to 8 and colours from single precision. `
    + 'The figures are of the unrounded meshes.'));
  return panel;
}

function start(): void {
  const data = JSON.parse(document.getElementById('surpass-page-data')!.textContent!) as PageData | string;
  if (typeof data === 'string') {
    document.body.append(element('p', { class: 'empty' }, 'This is the empty frame of a report; surpass fills it with --html FILE.'));
    return;
  }
  const stage = new Stage();
  const content = contentOf(data);
  const command = String(data.report.command ?? 'report');
  document.title = `surpass ${command}: ${titleOf(data.report, data.layers.map((l) => l.label))}`;
  document.body.append(
    element('header', { class: 'top' }, element('h1', {}, 'Surpass ', element('span', { class: 'quiet' }, command)),
      element('span', { class: 'quiet' }, `version ${data.version}`), element('span', { class: 'space' }),
      themeButton((dark) => stage.setDark(dark))),
    element('main', {}, stage.root, aside(data)));
  // The files of `view` may lie anywhere; elsewhere the first mesh is what all the others are about.
  const fitted = content.layers.filter((l, i) => i === 0 || l.id.startsWith('file'));
  stage.viewer.fit(Float32Array.from(fitted.flatMap((l) => [...l.shape.positions])));
  stage.show(content);
  const ids = content.layers.map((l) => l.id);
  if (ids.includes('a-to-b')) stage.change({ mode: 'split', left: 'a-to-b', right: 'b-to-a', shading: 'distance' });
  window.surpassReport = { stage };
}

start();
