// Times of docs/studio.md: solving in the page and natively on one thread, and a frame of the picture.
//   node build/measure.mjs     after make studio and make build
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { chromium } from 'playwright-core';

const kRoot = resolve(import.meta.dirname, '../..');
const kProgram = process.env.SURPASS_EXECUTABLE ?? resolve(kRoot, 'build/release/surpass');
const kRuns = 7;
const folder = mkdtempSync(join(tmpdir(), 'surpass-measure-'));

/** A bumpy torus of triangles. */
function torus(around, across) {
  const lines = [];
  for (let i = 0; i < around; ++i) {
    for (let j = 0; j < across; ++j) {
      const [u, v] = [(2 * Math.PI * i) / around, (2 * Math.PI * j) / across];
      const r = 0.4 + 0.03 * Math.sin(7 * u + 3 * v) + 0.004 * Math.sin(97 * u) * Math.cos(61 * v);
      lines.push(`v ${(1 + r * Math.cos(v)) * Math.cos(u)} ${r * Math.sin(v)} ${-(1 + r * Math.cos(v)) * Math.sin(u)}`);
    }
  }
  const at = (i, j) => (i % around) * across + (j % across) + 1;
  for (let i = 0; i < around; ++i) {
    for (let j = 0; j < across; ++j) {
      lines.push(`f ${at(i, j)} ${at(i + 1, j)} ${at(i + 1, j + 1)}`, `f ${at(i, j)} ${at(i + 1, j + 1)} ${at(i, j + 1)}`);
    }
  }
  return lines.join('\n');
}

/** Seconds for topology and solution, the best of several runs. */
function native(file) {
  const times = Array.from({ length: kRuns }, () => {
    const report = join(folder, 'report.json');
    execFileSync(kProgram, ['interpolate', file, '-o', join(folder, 'control.obj'), '--tolerance', '1e-12', '--threads', '1',
      '--quiet', '--report', report]);
    const { seconds } = JSON.parse(readFileSync(report, 'utf8'));
    return seconds.topology + seconds.solve;
  });
  return Math.min(...times);
}

async function inPage(page, file, name) {
  await page.getByLabel('Mesh file').setInputFiles(file);
  await page.waitForFunction((n) => window.surpassStudio.session.name === n && window.surpassStudio.session.solved, name, { timeout: 120000 });
  return page.evaluate(async (runs) => {
    const { session, stage } = window.surpassStudio;
    const options = { scheme: 'loop', boundary: 'edge-and-corner', method: 'progressive', solver: 'auto', tolerance: 1e-12,
      maxIterations: 10000, tension: 0, levels: session.settings.levels };
    // Drawing what was opened, in software, takes the cores for a while.
    await new Promise((done) => setTimeout(done, 2000));
    stage.viewer.timeFrames(1);
    const whole = [];
    const solves = [];
    for (let i = 0; i < runs; ++i) {
      const start = performance.now();
      const { seconds } = await session.core.solve(options);
      whole.push((performance.now() - start) / 1000);
      solves.push(seconds.solve);
    }
    const frames = {};
    for (const [label, view] of [['matte', { single: 'surface', shading: 'matte' }], ['reflection', { single: 'surface', shading: 'reflection' }],
      ['split', { mode: 'split', shading: 'mean' }]]) {
      stage.change({ mode: 'single', ...view, points: true });
      stage.viewer.draw();
      frames[label] = stage.viewer.timeFrames(4);
    }
    stage.change({ mode: 'single', shading: 'matte' });
    return { solve: Math.min(...solves), whole: Math.min(...whole), frames, shown: session.solved.surface.positions.length / 3 };
  }, kRuns);
}

const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
  args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'],
});
const page = await browser.newPage({ viewport: { width: 1360, height: 860 } });
await page.goto(`file://${kRoot}/build/studio/index.html`);
await page.locator('.verdict').waitFor();
console.log('| vertices | native, one thread | in the page | ratio | answer with surfaces | shown vertices | frame: matte | reflection | split |');
console.log('|---|---|---|---|---|---|---|---|---|');
for (const [around, across] of [[40, 25], [200, 100], [625, 400]]) {
  const name = `torus${around * across}.obj`;
  const file = join(folder, name);
  writeFileSync(file, torus(around, across));
  const program = native(file);
  const found = await inPage(page, file, name);
  const ms = (s) => `${(1000 * s).toPrecision(3)} ms`;
  console.log(`| ${around * across} | ${ms(program)} | ${ms(found.solve)} | ${(found.solve / program).toFixed(2)} | ${ms(found.whole)} | ${found.shown} | ${
    Object.values(found.frames).map((f) => `${f.toFixed(0)} ms`).join(' | ')} |`);
}
await browser.close();
