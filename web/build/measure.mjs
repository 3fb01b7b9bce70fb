// Times of docs/performance.md: solving in the page and natively on one thread, and a frame of the picture.
//   node build/measure.mjs     after make studio and make build
// On a machine that does other things as well: as root, for the program and the page's worker then go first.
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
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

const kFirst = ['-n', '-10'];
const mayGoFirst = spawnSync('nice', [...kFirst, 'true']).stderr.length === 0;

/** Seconds for topology and solution, once. */
function native(file) {
  const report = join(folder, 'report.json');
  const command = [kProgram, 'interpolate', file, '-o', join(folder, 'control.obj'), '--force', '--tolerance', '1e-12', '--threads', '1',
    '--quiet', '--report', report];
  const [program, ...words] = mayGoFirst ? ['nice', ...kFirst, ...command] : command;
  execFileSync(program, words);
  const { seconds } = JSON.parse(readFileSync(report, 'utf8'));
  return seconds.topology + seconds.solve;
}

/** Lets the workers of pages go first, too: the browser starts them with the usual priority. */
function raiseWorkers() {
  if (!mayGoFirst) return;
  for (const process of readdirSync('/proc').filter((name) => /^\d+$/.test(name))) {
    try {
      for (const thread of readdirSync(`/proc/${process}/task`)) {
        if (/DedicatedWorker/.test(readFileSync(`/proc/${process}/task/${thread}/comm`, 'utf8'))) spawnSync('renice', [...kFirst, '-p', thread]);
      }
    } catch {
      // It has ended meanwhile.
    }
  }
}

/** Once: seconds of the solution, and of the whole answer as the page waits for it. */
async function inPage(page) {
  return page.evaluate(async () => {
    const { session } = window.surpassStudio;
    const options = { scheme: 'loop', boundary: 'edge-and-corner', method: 'progressive', solver: 'auto', tolerance: 1e-12,
      maxIterations: 10000, tension: 0, levels: session.settings.levels };
    const start = performance.now();
    const { seconds } = await session.core.solve(options);
    return { solve: seconds.solve, whole: (performance.now() - start) / 1000 };
  });
}

async function frames(page) {
  return page.evaluate(async () => {
    const { stage } = window.surpassStudio;
    const times = [];
    for (const view of [{ single: 'surface', shading: 'matte' }, { single: 'surface', shading: 'reflection' }, { mode: 'split', shading: 'mean' }]) {
      stage.change({ mode: 'single', ...view, points: true });
      stage.viewer.timeFrames(1);
      times.push(Math.min(...[1, 2, 3].map(() => stage.viewer.timeFrames(2))));
    }
    stage.change({ mode: 'single', shading: 'matte' });
    return times;
  });
}

async function measured(page, file, name) {
  await page.getByLabel('Mesh file').setInputFiles(file);
  await page.waitForFunction((n) => window.surpassStudio.session.name === n && window.surpassStudio.session.solved, name, { timeout: 120000 });
  // Drawing what was opened, in software, takes the cores for a while.
  await page.waitForTimeout(2000);
  raiseWorkers();
  const pairs = [];
  for (let i = 0; i < kRuns; ++i) pairs.push({ native: native(file), ...await inPage(page) });
  const best = (key) => Math.min(...pairs.map((pair) => pair[key]));
  const shown = await page.evaluate(() => window.surpassStudio.session.solved.surface.positions.length / 3);
  return { native: best('native'), solve: best('solve'), whole: best('whole'), frames: await frames(page), shown };
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
  const found = await measured(page, file, name);
  const ms = (s) => `${(1000 * s).toPrecision(3)} ms`;
  console.log(`| ${around * across} | ${ms(found.native)} | ${ms(found.solve)} | ${(found.solve / found.native).toFixed(2)} | ${ms(found.whole)} | ${found.shown} | ${
    found.frames.map((f) => `${f.toFixed(0)} ms`).join(' | ')} |`);
}
await browser.close();
