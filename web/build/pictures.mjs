// The pictures of docs/studio.md: every view of five meshes on one sheet each, and the pages themselves.
//   node build/pictures.mjs FOLDER [pages]     after make studio and make web; without the sheets: pages
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdirSync, readdirSync, writeFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { chromium } from 'playwright-core';

const kRoot = resolve(import.meta.dirname, '../..');
const folder = resolve(process.argv[2] ?? resolve(kRoot, 'docs/images/studio'));
mkdirSync(folder, { recursive: true });

const kModels = ['jug.obj', 'trefoil.ply', 'crease_boundary.obj', 'mixed_polygons.obj', 'twisted_ring.obj'];
const single = (id, shading = 'matte', points = true) => ({ mode: 'single', single: id, shading, points });
const kViews = [
  ['Given mesh', single('given')], ['Control mesh', single('control')],
  ['Plain limit surface', single('plain')], ['Interpolating surface', single('surface')],
  ['Overlay', { mode: 'overlay', overlay: ['surface', 'control'], shading: 'matte', points: true }],
  ['Reflection lines', single('surface', 'reflection', false)], ['Mean curvature', single('surface', 'mean', false)],
  ['Gaussian curvature', single('surface', 'gauss', false)], ['Error of the plain surface', single('plain', 'error')],
  ['Split', { mode: 'split', left: 'plain', right: 'surface', shading: 'matte', points: true }],
];
// The other methods and schemes, where the mesh allows them.
const kSettings = [
  ['Similarity', { method: 'similarity' }], ['Fair', { method: 'fair', tension: 0 }], ['Fair, tension 0.9', { method: 'fair', tension: 0.9 }],
  ['Non-stationary Loop, round', { scheme: 'nonstationary-loop', shape: 'round' }],
  ['Non-stationary Loop, flat', { scheme: 'nonstationary-loop', shape: 'flat' }],
  ['Doo-Sabin', { scheme: 'doo-sabin', method: 'progressive' }], ['Catmull-Clark, fair', { scheme: 'catmull-clark', method: 'fair', tension: 0 }],
  ['Doo-Sabin, fair', { scheme: 'doo-sabin', method: 'fair', tension: 0 }],
];
const kColumns = 5;
const kCells = 15;

const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
  args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'],
});

async function studio(viewport, colorScheme = 'light', scale = 1) {
  const context = await browser.newContext({ viewport, colorScheme, deviceScaleFactor: scale });
  const page = await context.newPage();
  page.on('pageerror', (error) => { throw error; });
  await page.goto(`file://${kRoot}/build/studio/index.html`);
  await page.locator('.verdict').waitFor();
  return page;
}

async function open(page, model) {
  await page.getByLabel('Sample').selectOption(model);
  await page.waitForFunction((name) => window.surpassStudio.session.name === name && window.surpassStudio.session.solved, model);
}

/** In the page: one picture a view, each drawn twice as large as it is shown, which smooths it. */
async function sheet({ views, others, columns, cells }) {
  const { stage, session } = window.surpassStudio;
  const host = stage.viewer.canvas.parentElement;
  const [width, height] = [264, 220];
  host.style.cssText = `position:absolute;width:${width}px;height:${height}px`;
  await new Promise((done) => setTimeout(done, 300));
  const canvas = document.createElement('canvas');
  canvas.width = columns * width;
  canvas.height = Math.ceil(cells / columns) * (height + 22);
  const context = canvas.getContext('2d');
  context.imageSmoothingQuality = 'high';
  context.fillStyle = '#ffffff';
  context.fillRect(0, 0, canvas.width, canvas.height);
  // The ends of the colours, where there are some.
  const ends = (shading) => {
    const scale = Number((stage.viewer.scales[shading] ?? 0).toPrecision(2));
    if (shading === 'mean' || shading === 'gauss') return `, blue \u2212${scale}, red ${scale}`;
    return shading === 'error' ? `, yellow ${scale}` : '';
  };
  let cell = 0;
  const add = (label, view) => {
    stage.change({ ...view, marks: true, split: 0.5 });
    stage.viewer.insets = { top: 0, bottom: 0 };
    stage.viewer.draw();
    const [x, y] = [(cell % columns) * width, Math.floor(cell / columns) * (height + 22)];
    context.drawImage(stage.viewer.canvas, x, y, width, height);
    context.fillStyle = '#1a222c';
    context.font = '13px sans-serif';
    context.textAlign = 'center';
    context.fillText(label + ends(view.shading), x + width / 2, y + height + 15);
    ++cell;
  };
  for (const [label, view] of views) add(label, view);
  const shown = { mode: 'single', single: 'surface', shading: 'reflection', points: false };
  for (const [label, { ...part }] of others) {
    const ofTriangles = part.scheme === 'nonstationary-loop';
    // What the mesh does not take, or what was there already.
    if (cell === cells || (ofTriangles && !session.loaded.triangles) || part.scheme === session.loaded.scheme) continue;
    if (typeof part.shape === 'string') part.shape = session.loaded.shapes[part.shape];
    const levels = Math.max(1, session.settings.levels);
    const wished = { scheme: session.loaded.scheme, method: 'progressive', stopAfter: undefined, levels, ...part };
    await session.change(wished);
    if (Object.entries(wished).some(([name, value]) => session.shown[name] !== value)) continue;  // It was refused.
    add(label, shown);
  }
  host.style.cssText = '';
  return canvas.toDataURL('image/png');
}

async function sheets() {
  const page = await studio({ width: 1000, height: 560 }, 'light', 2);
  for (const model of kModels) {
    await open(page, model);
    const url = await page.evaluate(sheet, { views: kViews, others: kSettings, columns: kColumns, cells: kCells });
    writeFileSync(resolve(folder, `${model.replace(/\..*/, '')}.png`), Buffer.from(url.split(',')[1], 'base64'));
  }
  await page.context().close();
}

/** Of a page of two pixels a pixel, made half as large, which smooths what software draws. */
async function shot(page, name) {
  await page.waitForTimeout(400);
  const large = (await page.screenshot()).toString('base64');
  const url = await page.evaluate(async (base64) => {
    const picture = new Image();
    picture.src = `data:image/png;base64,${base64}`;
    await picture.decode();
    const canvas = document.createElement('canvas');
    [canvas.width, canvas.height] = [picture.width / 2, picture.height / 2];
    const context = canvas.getContext('2d');
    context.imageSmoothingQuality = 'high';
    context.drawImage(picture, 0, 0, canvas.width, canvas.height);
    return canvas.toDataURL('image/png');
  }, large);
  writeFileSync(resolve(folder, `${name}.png`), Buffer.from(url.split(',')[1], 'base64'));
}

async function pages() {
  const page = await studio({ width: 1360, height: 800 }, 'light', 2);
  await page.evaluate(() => window.surpassStudio.stage.change({ mode: 'split', shading: 'reflection', points: false }));
  await page.locator('.plot .curve').nth(1).waitFor();
  await shot(page, 'jug-split-reflection');
  await open(page, 'double_torus.obj');
  await page.getByLabel('Scheme', { exact: true }).selectOption('nonstationary-loop');
  await page.getByLabel('Shape', { exact: true }).waitFor();
  await page.getByRole('button', { name: 'Export surface' }).waitFor();
  await page.evaluate(() => window.surpassStudio.stage.change({ mode: 'split', shading: 'mean', points: true }));
  await shot(page, 'nonstationary');
  await page.context().close();

  const dark = await studio({ width: 1180, height: 760 }, 'dark', 2);
  await open(dark, 'crease_boundary.obj');
  await dark.evaluate(() => window.surpassStudio.stage.change({ shading: 'mean' }));
  await shot(dark, 'dark-curvature');
  await dark.context().close();

  const phone = await studio({ width: 390, height: 844 }, 'light', 2);
  await shot(phone, 'phone');
  await phone.context().close();

  const html = resolve(kRoot, 'build/report/example.html');
  execFileSync(resolve(kRoot, 'build/release/surpass'), ['interpolate', `${kRoot}/data/trefoil.ply`, '-o', `${kRoot}/build/report/example.obj`,
    '--tolerance', '1e-12', '--html', html, '--quiet']);
  const context = await browser.newContext({ viewport: { width: 1240, height: 760 }, deviceScaleFactor: 2 });
  const report = await context.newPage();
  await report.goto(`file://${html}`);
  await report.locator('canvas').waitFor();
  await report.evaluate(() => window.surpassReport.stage.change({ mode: 'overlay', overlay: ['surface', 'control'], shading: 'gauss' }));
  await shot(report, 'report');
  await context.close();
}

/** Sixty-four colours are enough for these, and a quarter of the bytes. */
function shrink() {
  const files = readdirSync(folder).filter((f) => f.endsWith('.png')).map((f) => resolve(folder, f));
  const ran = spawnSync('pngquant', ['--force', '--skip-if-larger', '--speed', '1', '--ext', '.png', '64', ...files]);
  if (ran.error) console.error('pngquant is not there, so the pictures stay large');
}

if (process.argv[3] !== 'pages') await sheets();
await pages();
await browser.close();
shrink();
