import { cpSync, mkdtempSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { gzipSync } from 'node:zlib';
import type { Browser } from 'playwright-core';
import { afterAll, afterEach, beforeAll, expect, test } from 'vitest';
import type { Stage } from '../../src/viewer/stage';
import type { Session } from '../../src/studio/session';
import { kRoot, offBy, surpass, torus } from '../support';
import { changedFrom, colours, difference, halves, launch, open, picture, radio, verdict, type Opened } from './pages';

declare global {
  interface Window {
    surpassStudio?: { stage: Stage; session: Session };
  }
}

const folder = mkdtempSync(join(tmpdir(), 'surpass studio-'));
let browser: Browser;
let opened: Opened;

beforeAll(async () => {
  browser = await launch();
  // From a folder with a blank in its name, without a server.
  cpSync(resolve(kRoot, 'build/studio'), join(folder, 'any where'), { recursive: true });
  opened = await studio();
});
afterAll(async () => browser.close());
afterEach(() => expect(opened.complaints).toEqual([]));

async function studio(options: Parameters<Browser['newContext']>[0] = {}): Promise<Opened> {
  const found = await open(browser, pathToFileURL(join(folder, 'any where/index.html')).href, options);
  await verdict(found.page).waitFor();
  return found;
}

async function choose(name: string, value: string): Promise<void> {
  await opened.page.getByLabel(name, { exact: true }).selectOption(value);
}

async function load(name: string, text: string): Promise<void> {
  await opened.page.getByLabel('Mesh file').setInputFiles({ name, mimeType: 'text/plain', buffer: Buffer.from(text) });
}

test('a sample is there at once, and passes through its points', async () => {
  const { page } = opened;
  expect(await verdict(page).textContent()).toContain('Passes through every point');
  expect(colours(await picture(page))).toBeGreaterThan(20);
  await page.locator('.key', { hasText: 'Richardson' }).waitFor();
  await page.locator('.key', { hasText: 'Chebyshev' }).waitFor();
  expect(await page.locator('.plot .curve').count()).toBe(2);
});

test('every layout, layer and shading has a picture of its own', async () => {
  const { page } = opened;
  await page.getByLabel('Fineness').fill('1');
  await expect.poll(() => page.evaluate(() => window.surpassStudio!.session.settings!.levels)).toBe(1);
  let before = await picture(page);
  for (const layer of ['Given mesh', 'Control mesh', 'Plain limit surface', 'Interpolating surface']) {
    await radio(page, layer).check();
    before = await changedFrom(page, before);
    expect(await page.locator('.pane-label').textContent()).toBe(layer);
  }
  for (const shading of ['Reflection', 'Mean', 'Gauss', 'Matte']) {
    await radio(page, shading).check();
    before = await changedFrom(page, before);
    expect(await page.locator('.legend').isVisible()).toBe(shading === 'Mean' || shading === 'Gauss');
  }
  await radio(page, 'Plain limit surface').check();
  before = await picture(page);
  await radio(page, 'Error').check();
  before = await changedFrom(page, before);
  await radio(page, 'Overlay').check();
  before = await changedFrom(page, before);
  await radio(page, 'Split').check();
  before = await changedFrom(page, before);
  await page.getByLabel('Points').uncheck();
  before = await changedFrom(page, before);
  expect(await page.locator('.pane-label').allTextContents()).toEqual(['Plain limit surface', 'Interpolating surface']);
});

test('the divider moves by hand and by keys, and the cameras turn together', async () => {
  const { page } = opened;
  const divider = page.getByRole('separator');
  const box = (await divider.boundingBox())!;
  await page.mouse.move(box.x + box.width / 2, box.y + 200);
  await page.mouse.down();
  await page.mouse.move(box.x + 130, box.y + 200, { steps: 3 });
  await page.mouse.up();
  expect(Number(await divider.getAttribute('aria-valuenow'))).toBeGreaterThan(60);
  await divider.press('ArrowLeft');
  await divider.dblclick();
  expect(await divider.getAttribute('aria-valuenow')).toBe('50');
  const before = await picture(page);
  await page.locator('canvas').press('ArrowRight');
  const after = await changedFrom(page, before);
  const half = (pixels: number[], right: boolean) => pixels.filter((_, i) => (Math.floor(i / 4) % 96 >= 48) === right);
  for (const right of [false, true]) expect(difference(half(before, right), half(after, right))).toBeGreaterThan(0.004);
  await radio(page, 'One').check();
  await radio(page, 'Interpolating surface').check();
  await radio(page, 'Matte').check();
});

test('the surface follows the sliders', async () => {
  const { page } = opened;
  await page.getByLabel('Sample').selectOption('cube.obj');
  await page.locator('.file', { hasText: 'cube.obj' }).waitFor();
  await choose('Method', 'fair');
  const tension = page.getByLabel('Tension');
  await tension.waitFor();
  let before = await picture(page);
  await tension.fill('0.9');
  before = await changedFrom(page, before, 0.002);
  await page.getByLabel('Fineness').fill('1');
  await changedFrom(page, before, 0.002);

  await page.getByLabel('Sample').selectOption('jug.obj');
  const iterations = page.getByLabel('Iterations', { exact: true });
  await iterations.waitFor();
  before = await picture(page);
  await iterations.fill('1');
  await changedFrom(page, before, 0.002);
  expect(await verdict(page).textContent()).toContain('Off by');
});

test('the shape parameter moves the surface that interpolates by itself', async () => {
  const { page } = opened;
  await page.getByLabel('Sample').selectOption('double_torus.obj');
  await page.locator('.file', { hasText: 'double_torus.obj' }).waitFor();
  await choose('Scheme', 'nonstationary-loop');
  const shape = page.getByLabel('Shape', { exact: true });
  await shape.waitFor();
  await page.getByRole('button', { name: 'Export surface' }).waitFor();
  expect(await verdict(page).textContent()).toContain('Passes through every point');
  // What only other schemes need is not there.
  for (const name of ['Method', 'Solver', 'Tolerance']) expect(await page.getByLabel(name, { exact: true }).count()).toBe(0);
  expect(await page.locator('.plot').count()).toBe(0);
  expect(await radio(page, 'Control mesh').count()).toBe(0);
  expect(await page.locator('.panel.left').textContent()).toContain('by itself');

  let before = await picture(page);
  const shapeSolved = (value: string) => expect.poll(() => page.evaluate(() => {
    const { session } = window.surpassStudio!;
    return `${session.settings!.shape} ${session.solved!.control === undefined}`;
  })).toBe(`${value} true`);
  expect(await shape.getAttribute('max')).toBe('1.99');  // The mesh has vertices of valence 3.
  await shape.fill('1.5');
  await shapeSolved('1.5');
  before = await changedFrom(page, before, 0.002);
  await page.getByRole('button', { name: 'Round', exact: true }).click();
  await shapeSolved('-3');
  expect(await shape.inputValue()).toBe('-3');
  await changedFrom(page, before, 0.002);
  expect(await verdict(page).textContent()).toContain('Passes through every point');

  await page.getByLabel('Format of: Surface').selectOption('obj');
  const [download] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'Export surface' }).click()]);
  const here = join(folder, download.suggestedFilename());
  await download.saveAs(here);
  const there = join(folder, 'itself.obj');
  const levels = await page.evaluate(() => window.surpassStudio!.session.settings!.levels);
  expect(surpass('interpolate', resolve(kRoot, 'data/double_torus.obj'), '-o', there, '--scheme', 'nonstationary-loop',
    '--shape', '-3', '--levels', String(levels)).status).toBe(0);
  expect(offBy(here, there)).toBeLessThanOrEqual(1e-12);
  await choose('Scheme', 'loop');
  await page.getByRole('button', { name: 'Export control mesh' }).waitFor();
  await page.locator('.key', { hasText: 'Chebyshev' }).waitFor();
  await choose('Method', 'fair');
  await page.getByLabel('Tension').waitFor();
  await verdict(page).filter({ hasText: 'Passes' }).waitFor();
  await choose('Method', 'progressive');
});

test('creases and boundaries are marked', async () => {
  const { page } = opened;
  await page.getByLabel('Sample').selectOption('crease_boundary.obj');
  await page.locator('.file', { hasText: 'crease_boundary.obj' }).waitFor();
  await verdict(page).filter({ hasText: 'Passes' }).waitFor();
  await page.getByLabel('Points').uncheck();
  const marked = await picture(page);
  await page.getByLabel('Creases and boundary').uncheck();
  const bare = await changedFrom(page, marked, 0.002);
  // Pink lines and green ones went away: nothing else here is more blue, or more green, than red.
  const more = (pixels: number[], c: number, than: number) =>
    pixels.filter((x, i) => i % 4 === c && x - pixels[i - c + than]! > 25).length;
  expect(more(marked, 1, 0)).toBeGreaterThan(more(bare, 1, 0) + 10);
  expect(more(marked, 2, 1)).toBeGreaterThan(more(bare, 2, 1) + 10);
  await page.getByLabel('Creases and boundary').check();
  await page.getByLabel('Points').check();
});

test('overlays show what is ticked, with room for the control mesh', async () => {
  const { page } = opened;
  await page.getByLabel('Sample').selectOption('cube.obj');
  await page.locator('.file', { hasText: 'cube.obj' }).waitFor();
  await verdict(page).filter({ hasText: 'Passes' }).waitFor();
  await page.getByRole('button', { name: 'Reset view' }).click();
  await radio(page, 'Overlay').check();
  // The control mesh of a cube is nearly twice as large as the cube.
  const tall = async () => Math.max(...(await page.evaluate(halves)).map((half) => half[1]!));
  await expect.poll(tall).toBeLessThan(0.97);
  await expect.poll(tall).toBeGreaterThan(0.6);
  const overlay = () => page.evaluate(() => [...window.surpassStudio!.stage.view.overlay].sort());
  const box = (name: string) => page.locator('.checks').getByLabel(name, { exact: true });
  await box('Given mesh').check();
  expect(await overlay()).toEqual(['control', 'given', 'surface']);
  for (const name of ['Given mesh', 'Control mesh', 'Interpolating surface']) await box(name).uncheck();
  expect(await overlay()).toEqual([]);
  expect(await page.locator('.checks :checked').count()).toBe(0);
  for (const name of ['Control mesh', 'Interpolating surface']) await box(name).check();
  expect(await overlay()).toEqual(['control', 'surface']);
  await radio(page, 'One').check();
});

test('a flat mesh has no curvature, and what misses its points is not saved in silence', async () => {
  const { page } = opened;
  await load('flat.obj', 'v 0 0 0\nv 1 0 0\nv 0.3 1 0\nf 1 2 3\n');
  await page.getByRole('status').filter({ hasText: 'flat.obj: 3 vertices, 1 face. Passes' }).waitFor();
  await radio(page, 'Mean').check();
  expect(await page.locator('.legend-ticks').textContent()).toBe('0');
  await radio(page, 'Matte').check();
  await page.getByLabel('Sample').selectOption('jug.obj');
  await page.getByLabel('Iterations', { exact: true }).fill('1');
  await verdict(page).filter({ hasText: 'Off by' }).waitFor();
  await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'Export control mesh' }).click()]);
  await page.getByRole('status').filter({ hasText: /Saved jug\.control\.obj\. Off by .* the tolerance is/ }).waitFor();
});

test('from a dropped file to an exported control mesh in two actions, equal to the program’s', async () => {
  const { page } = opened;
  const text = readFileSync(resolve(kRoot, 'data/double_torus.obj'), 'utf8');
  const data = await page.evaluateHandle((content) => {
    const transfer = new DataTransfer();
    transfer.items.add(new File([content], 'mine.obj'));
    return transfer;
  }, text);
  await page.dispatchEvent('body', 'drop', { dataTransfer: data });
  await page.locator('.file', { hasText: 'mine.obj' }).waitFor();
  const [download] = await Promise.all([
    page.waitForEvent('download'), page.getByRole('button', { name: 'Export control mesh' }).click()]);
  expect(download.suggestedFilename()).toBe('mine.control.obj');
  const here = join(folder, 'mine.control.obj');
  await download.saveAs(here);

  const given = resolve(kRoot, 'data/double_torus.obj');
  const checked = surpass('check', here, '--against', given, '--tolerance', '1e-12');
  expect(checked.status).toBe(0);
  const there = join(folder, 'native.obj');
  expect(surpass('interpolate', given, '-o', there, '--tolerance', '1e-12').status).toBe(0);
  expect(offBy(here, there)).toBeLessThanOrEqual(1e-12);
});

test('the same by the keyboard alone: three keys that act, and Tab', async () => {
  const { page } = opened;
  const tabTo = async (name: string) => {
    for (let i = 0; i < 60; ++i) {
      await page.keyboard.press('Tab');
      const words = await page.evaluate(() => document.activeElement?.textContent?.trim());
      if (words === name) return;
    }
    throw new Error(`${name} is not reached`);
  };
  await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
  await tabTo('Open mesh…');
  const choosing = page.waitForEvent('filechooser');
  await page.evaluate(() => undefined);  // A key is quicker than the browser is told to hand over the dialogue.
  await page.keyboard.press('Enter');
  const chooser = await choosing;
  await chooser.setFiles(resolve(kRoot, 'data/octahedron.obj'));
  // What a screen reader is told: the file, and whether the surface meets its points.
  await page.getByRole('status').filter({ hasText: /octahedron\.obj: 6 vertices, 8 faces\. Passes through every point/ }).waitFor();
  await tabTo('Export control mesh');
  const [download] = await Promise.all([page.waitForEvent('download'), page.keyboard.press('Enter')]);
  expect(download.suggestedFilename()).toBe('octahedron.control.obj');

  // Shadings, layouts and points have keys of their own; radio buttons and sliders follow the arrows.
  const view = () => page.evaluate(() => window.surpassStudio!.stage.view);
  await page.keyboard.press('3');
  expect((await view()).shading).toBe('mean');
  await page.keyboard.press('1');
  await page.keyboard.press('s');
  expect((await view()).mode).toBe('split');
  await page.keyboard.press('s');
  await page.keyboard.press('p');
  expect((await view()).points).toBe(false);
  await page.keyboard.press('p');
  await radio(page, 'One').focus();
  await page.keyboard.press('ArrowRight');
  expect((await view()).mode).toBe('overlay');
  expect(await page.evaluate(() => document.activeElement?.getAttribute('value'))).toBe('overlay');
  await page.keyboard.press('ArrowLeft');
  await page.getByLabel('Fineness').focus();
  await page.keyboard.press('ArrowLeft');
  await expect.poll(() => page.getByLabel('Fineness').getAttribute('aria-valuetext')).toBe('3 refinements');
  await load('mine.obj', readFileSync(resolve(kRoot, 'data/double_torus.obj'), 'utf8'));
  await page.getByRole('status').filter({ hasText: /mine\.obj: .* Passes/ }).waitFor();
});

test('the page is below a megabyte packed, without the samples', () => {
  const sizes = readdirSync(join(folder, 'any where')).filter((name) => name !== 'samples.js')
    .map((name) => gzipSync(readFileSync(join(folder, 'any where', name))).length);
  expect(sizes.length).toBeGreaterThanOrEqual(3);
  expect(sizes.reduce((sum, size) => sum + size, 0)).toBeLessThan(1e6);
});

test('both halves of a split show the model at the same size, as large as they can', async () => {
  const { page } = opened;
  await page.getByLabel('Points').uncheck();
  await radio(page, 'Split').check();
  for (const size of [{ width: 1190, height: 620 }, { width: 900, height: 1100 }]) {
    await page.setViewportSize(size);
    await expect.poll(async () => Math.min(...(await page.evaluate(halves)).map((half) => Math.max(...half))), { timeout: 30000 })
      .toBeGreaterThan(0.62);
    const [left, right] = await page.evaluate(halves);
    expect(left![0]).toBeCloseTo(right![0]!, 1);
    for (const [wide, tall] of [left!, right!]) {
      expect(wide).toBeLessThan(1);
      expect(tall).toBeLessThan(1);
    }
  }
  await page.setViewportSize({ width: 1190, height: 620 });
  await radio(page, 'One').check();
  await page.getByLabel('Points').check();
});

test('surfaces and pictures are saved, too', async () => {
  const { page } = opened;
  const saved = async (name: string) => {
    const [download] = await Promise.all([page.waitForEvent('download'), page.locator('.export-row').getByRole('button', { name }).click()]);
    const file = join(folder, download.suggestedFilename());
    await download.saveAs(file);
    return file;
  };
  const surface = await saved('Surface');
  expect(surpass('inspect', surface).out).toContain('vertices');
  const png = readFileSync(await saved('Picture'));
  expect(png.subarray(1, 4).toString()).toBe('PNG');
  expect(png.length).toBeGreaterThan(5000);
});

test('a broken file shows the library’s own words, and what was open stays', async () => {
  const { page } = opened;
  const broken = 'v 0 0 0\nv 1 0 0\nv 0 1 zero\nf 1 2 3\n';
  await load('broken.obj', broken);
  const alert = page.getByRole('alert');
  await alert.waitFor();
  writeFileSync(join(folder, 'broken.obj'), broken);
  const words = surpass('inspect', join(folder, 'broken.obj')).err;
  const said = (await alert.locator('p').textContent())!;
  expect(said).toContain('broken.obj:3:7');
  expect(words).toContain(said.replace('broken.obj', '').slice(1));
  expect(await page.locator('.file').textContent()).toBe('mine.obj');
  await alert.getByRole('button', { name: 'Close' }).click();

  // What can be mended is mended on request.
  await page.getByLabel('Sample').selectOption('cube.obj');
  await page.locator('.file', { hasText: 'cube.obj' }).waitFor();
  await load('folded.obj', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 0 -1\nf 1 2 3\nf 2 1 4\nf 1 2 5\n');
  await alert.getByRole('button', { name: 'Repair and open' }).click();
  await page.locator('.file', { hasText: 'folded.obj' }).waitFor();
  expect(await alert.isVisible()).toBe(false);
  expect(await page.getByLabel('Sample').inputValue()).toBe('');
});

test('the keyboard stays where it is when a choice is made, and Escape closes a message', async () => {
  const { page } = opened;
  const focused = () => page.evaluate(() => document.activeElement?.getAttribute('aria-label') ?? document.activeElement?.tagName);
  await page.getByLabel('Sample').selectOption('cube.obj');
  await page.locator('.file', { hasText: 'cube.obj' }).waitFor();
  await verdict(page).filter({ hasText: 'Passes' }).waitFor();
  const before = await page.evaluate(() => window.surpassStudio!.session.settings!.method);
  await page.getByLabel('Method', { exact: true }).focus();
  await page.keyboard.press('ArrowDown');
  await page.waitForFunction((method) => window.surpassStudio!.session.shown?.method !== method, before);
  expect(await focused()).toBe('Method');

  // A choice that is refused: said so, and taken back.
  await load('pillow.obj', readFileSync(resolve(kRoot, 'data/octahedron.obj'), 'utf8'));
  await page.locator('.file', { hasText: 'pillow.obj' }).waitFor();
  await verdict(page).filter({ hasText: 'Passes' }).waitFor();
  const shown = await verdict(page).textContent();
  await page.evaluate(() => window.surpassStudio!.session.change({ solver: 'no such solver' }));
  const alert = page.getByRole('alert');
  expect(await alert.textContent()).toContain('Refused: no such solver');
  expect(await page.getByLabel('Solver', { exact: true }).inputValue()).toBe('auto');
  expect(await verdict(page).textContent()).toBe(shown);
  await page.getByLabel('Solver', { exact: true }).focus();
  await alert.getByRole('button', { name: 'Close' }).focus();
  await page.keyboard.press('Escape');
  expect(await alert.isVisible()).toBe(false);
  expect(await focused()).toBe('Solver');
});

test('what is no file is said to be none; of several the first is opened', async () => {
  const { page } = opened;
  const drop = async (files: Record<string, string>) => page.dispatchEvent('body', 'drop', {
    dataTransfer: await page.evaluateHandle((texts) => {
      const transfer = new DataTransfer();
      for (const [name, text] of Object.entries(texts)) transfer.items.add(new File([text], name));
      return transfer;
    }, files) });
  const alert = page.getByRole('alert');
  await drop({});
  expect(await alert.textContent()).toContain('no file');
  const cube = readFileSync(resolve(kRoot, 'data/cube.obj'), 'utf8');
  await drop({ 'one.obj': cube, 'two.obj': cube });
  await page.getByRole('status').filter({ hasText: /Of 2 files the first is opened\. one\.obj: .* Passes/ }).waitFor();
  expect(await alert.isVisible()).toBe(false);
});

test('points show as points', async () => {
  const { page } = opened;
  await load('cloud.xyz', Array.from({ length: 400 }, (_, i) => `${Math.cos(i)} ${i / 200} ${Math.sin(i)}`).join('\n'));
  await page.locator('.panel.right', { hasText: 'surpass reconstruct cloud.xyz' }).waitFor();
  expect(colours(await picture(page))).toBeGreaterThan(3);
});

test('a long solve tells how far it is, and can be cancelled', async () => {
  const { page } = opened;
  await load('large.obj', torus(180, 120));
  await page.locator('.file', { hasText: 'large.obj' }).waitFor();
  await verdict(page).filter({ hasText: 'Passes' }).waitFor();
  await choose('Scheme', 'catmull-clark');
  await choose('Method', 'similarity');
  const progress = page.getByRole('progressbar');
  await progress.waitFor();
  await page.locator('.progress-text', { hasText: '%' }).waitFor();
  // At once: a click by mouse waits for two pictures of a page that is busy.
  await page.getByRole('button', { name: 'Cancel' }).dispatchEvent('click');
  expect(await progress.isVisible()).toBe(false);
  expect(await page.locator('.status').textContent()).toContain('Cancelled');
  expect(await page.evaluate(() => window.surpassStudio!.session.solved?.report.solver)).toBe('chebyshev');
  // And then goes on.
  await choose('Method', 'progressive');
  await choose('Scheme', 'loop');
  await page.waitForFunction(() => window.surpassStudio!.session.settings!.scheme === 'loop');
  await progress.waitFor({ state: 'hidden' });
  await verdict(page).filter({ hasText: 'Passes' }).waitFor();
});

test('everything that can be operated has a name', async () => {
  const { page } = opened;
  const nameless = await page.evaluate(() => [...document.querySelectorAll('button, select, input, canvas, [role=separator]')]
    .filter((e) => {
      const labels = (e as HTMLInputElement).labels;
      return !e.getAttribute('aria-label') && !(labels && labels.length > 0) && !e.textContent?.trim();
    }).map((e) => e.outerHTML));
  expect(nameless).toEqual([]);
});

test('in a small window the picture does not lie over what is used', async () => {
  const { page } = opened;
  await page.setViewportSize({ width: 680, height: 430 });
  await page.getByLabel('Fineness').focus();
  const slider = (await page.getByLabel('Fineness').boundingBox())!;
  const stage = (await page.locator('.stage').boundingBox())!;
  expect(slider.y).toBeGreaterThanOrEqual(stage.y + stage.height);
  expect(slider.y + slider.height).toBeLessThanOrEqual(430);
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(680);
  expect((await page.locator('header').boundingBox())!.height).toBeLessThan(60);
  await page.setViewportSize({ width: 1190, height: 620 });
});

test('dark colours, and a phone', async () => {
  await opened.context.close();
  opened = await studio({ viewport: { width: 390, height: 844 }, colorScheme: 'dark', isMobile: true, hasTouch: true });
  const { page } = opened;
  expect(await page.evaluate(() => document.documentElement.dataset.theme)).toBe('dark');
  expect((await picture(page)).slice(0, 3)).toEqual([20, 24, 29]);
  const widths = await page.evaluate(() => [document.documentElement.scrollWidth, window.innerWidth]);
  expect(widths[0]).toBeLessThanOrEqual(widths[1]!);
  const canvas = (await page.locator('canvas').boundingBox())!;
  expect(canvas.width).toBeGreaterThan(380);
  expect(canvas.height).toBeGreaterThan(300);
  await page.getByRole('button', { name: 'Export control mesh' }).waitFor();

  // The toolbar is one row that scrolls: what is shown is in view, and the edges tell that there is more.
  const bar = (await page.locator('.toolbar').boundingBox())!;
  const chosen = (await page.locator('.toolbar .shown label', { hasText: 'Interpolating surface' }).boundingBox())!;
  expect(chosen.x).toBeGreaterThanOrEqual(bar.x);
  expect(chosen.x + chosen.width).toBeLessThanOrEqual(bar.x + bar.width);
  expect(await page.locator('.toolbar.more-left.more-right').count()).toBe(1);
  // Settings lie below the picture, not under it.
  await page.getByLabel('Fineness').focus();
  const stage = (await page.locator('.stage').boundingBox())!;
  expect((await page.getByLabel('Fineness').boundingBox())!.y).toBeGreaterThanOrEqual(stage.y + stage.height);
});
