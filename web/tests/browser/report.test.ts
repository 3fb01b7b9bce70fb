import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import type { Browser } from 'playwright-core';
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { Stage } from '../../src/viewer/stage';
import { kRoot, surpass } from '../support';
import { changedFrom, colours, launch, open, picture, radio } from './pages';

declare global {
  interface Window {
    surpassReport?: { stage: Stage };
  }
}

const folder = mkdtempSync(join(tmpdir(), 'surpass-report-'));
const data = (name: string) => resolve(kRoot, 'data', name);
const file = (name: string) => join(folder, name);
let browser: Browser;

beforeAll(async () => { browser = await launch(); });
afterAll(async () => browser.close());

async function show(path: string) {
  const opened = await open(browser, pathToFileURL(path).href);
  await opened.page.locator('canvas').waitFor();
  expect(colours(await picture(opened.page))).toBeGreaterThan(8);
  return opened;
}

test('interpolate: one file, without a network, with every view and the figures', async () => {
  const ran = surpass('interpolate', data('sphere_irregular.obj'), '-o', file('c.obj'), '--html', file('i.html'),
    '--tolerance', '1e-12', '--report', file('i.json'));
  expect(ran.err).not.toContain('make web');
  expect(ran.status).toBe(0);
  const report = JSON.parse(readFileSync(file('i.json'), 'utf8'));
  expect(report.html).toBe(file('i.html'));
  const { page, complaints } = await show(file('i.html'));
  let before = await picture(page);
  for (const name of ['Given mesh', 'Control mesh', 'Plain limit surface', 'Reflection', 'Mean', 'Gauss', 'Error', 'Split']) {
    await radio(page, name).check();
    before = await changedFrom(page, before);
  }
  const panel = (await page.locator('.panel').textContent())!;
  expect(panel).toContain('Largest error');
  expect(panel).toContain('rounded to 16 bits');
  expect(await page.locator('.plot .curve').count()).toBe(2);
  expect(complaints).toEqual([]);
  await page.context().close();
});

test('subdivide, compare and reconstruct write one, too', async () => {
  const torus = data('quad_torus.obj');
  expect(surpass('subdivide', torus, '-o', file('s.ply'), '--levels', '2', '--limit', '--html', file('s.html')).status).toBe(0);
  expect(surpass('interpolate', torus, '-o', file('n.ply'), '--html', file('n.html')).status).toBe(0);
  expect(surpass('compare', torus, file('s.ply'), '--accuracy', '1e-3', '--html', file('k.html')).status).toBe(0);
  expect(surpass('reconstruct', data('sphere_irregular.obj'), '-o', file('r.ply'), '--html', file('r.html')).status).toBe(0);
  const wanted: [string, string, string][] = [
    ['s.html', 'Limit surface', 'Refinements'], ['n.html', 'Given mesh', 'Input'], ['k.html', 'B', 'Hausdorff'], ['r.html', 'Surface', 'Spacing']];
  for (const [name, layer, figure] of wanted) {
    const { page, complaints } = await show(file(name));
    await radio(page, 'One').check();
    await radio(page, layer).check();
    expect(await page.locator('.panel').textContent()).toContain(figure);
    expect(complaints).toEqual([]);
    await page.context().close();
  }
});

test('a surface that interpolates by itself is no finer in the page than others are', async () => {
  const torus = data('double_torus.obj');
  const ran = surpass('interpolate', torus, '-o', file('fine.ply'), '--scheme', 'nonstationary-loop', '--levels', '5', '--html', file('fine.html'));
  expect(ran.status).toBe(0);
  const { page, complaints } = await show(file('fine.html'));
  const vertices = await page.evaluate(() => window.surpassReport!.stage.viewer.shown.find((l) => l.id === 'surface')!.shape.positions.length / 3);
  expect(vertices).toBeLessThanOrEqual(30000);
  expect(vertices).toBeGreaterThan(4000);
  expect(await page.title()).toBe('surpass interpolate: double_torus.obj');
  expect(complaints).toEqual([]);
  await page.context().close();
});

test('compare colours both meshes by their distance', async () => {
  // A square at height 0, and a much larger one whose height is a tenth of x, as two triangles of another cut.
  const slope = 0.1;
  const square = (low: number, high: number, rise: number, faces: string) =>
    [[low, low], [high, low], [high, high], [low, high]].map(([x, y]) => `v ${x} ${y} ${rise * x!}\n`).join('') + faces;
  writeFileSync(file('flat.obj'), square(0, 1, 0, 'f 1 2 3 4\n'));
  writeFileSync(file('steep.obj'), square(-9, 9, slope, 'f 1 2 4\nf 2 3 4\n'));
  const ran = surpass('compare', file('flat.obj'), file('steep.obj'), '--html', file('distance.html'), '--report', file('distance.json'));
  expect(ran.status).toBe(0);
  const largest = JSON.parse(readFileSync(file('distance.json'), 'utf8')).distance.a_to_b.max;
  const { page, complaints } = await show(file('distance.html'));
  const found = await page.evaluate(() => {
    const data = JSON.parse(document.getElementById('surpass-page-data')!.textContent!);
    const layer = window.surpassReport!.stage.viewer.shown.find((l) => l.id === 'a-to-b')!;
    return { positions: [...layer.shape.positions], distances: [...layer.shape.channels.distance!], centre: data.centre, side: data.side };
  });
  // Many more places than the square's four corners, each at x * slope / sqrt(1 + slope^2) from the plane.
  expect(found.distances.length).toBeGreaterThan(5000);
  found.distances.forEach((distance, v) => {
    const x = found.positions[3 * v]! * found.side + found.centre[0];
    expect(Math.abs(distance - (x * slope) / Math.hypot(1, slope))).toBeLessThan(2e-6);
  });
  expect(Math.max(...found.distances)).toBeCloseTo(largest, 6);
  expect(await page.locator('.pane-label').allTextContents()).toEqual(['A, distance to B', 'B, distance to A']);
  expect(await page.locator('.legend').textContent()).toContain('Distance to the other mesh');
  const coloured = await picture(page);
  await radio(page, 'Matte').check();
  await changedFrom(page, coloured);
  expect(await page.locator('.legend').isVisible()).toBe(false);
  expect(complaints).toEqual([]);
  await page.context().close();
});

test('view writes a page and says where', async () => {
  const ran = surpass('view', file('c.obj'), data('sphere_irregular.obj'), '--no-browser');
  expect(ran.status).toBe(0);
  const { page, complaints } = await show(ran.out.trim());
  expect(await page.getByRole('radio', { name: 'c.obj, limit surface' }).count()).toBe(1);
  expect(complaints).toEqual([]);
  await page.context().close();
});

test('names from outside stay text', async () => {
  const evil = file('<img src=x onerror=alert(1)>.obj');
  writeFileSync(evil, readFileSync(data('cube.obj')));
  const path = surpass('view', evil, '--html', file('evil.html'), '--no-browser').out.trim();
  const { page, complaints } = await show(path);
  expect(await page.locator('img').count()).toBe(0);
  expect(complaints).toEqual([]);
  await page.context().close();
});

test('the same input gives the same page', () => {
  const write = (name: string) => {
    surpass('interpolate', data('cube.obj'), '-o', file('same.obj'), '--html', file(name));
    return readFileSync(file(name), 'utf8');
  };
  expect(write('one.html')).toBe(write('two.html'));
});
