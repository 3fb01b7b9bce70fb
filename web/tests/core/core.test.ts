// The WebAssembly module against the program: same files, same errors, same control meshes.
import { createRequire } from 'node:module';
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { beforeAll, describe, expect, test } from 'vitest';
import type { Answer, Failure, Loaded, SolveOptions, Written } from '../../src/core/protocol';
import { kRoot, positionsOf, sample, surpass } from '../support';

interface Core {
  load(file: Uint8Array, name: string, mend: object): Loaded & { error?: Failure };
  solve(options: SolveOptions, progress: unknown): Answer & { error?: Failure };
  written(what: string, format: string): Written & { error?: Failure };
}

const folder = mkdtempSync(join(tmpdir(), 'surpass-core-'));
let module: { Core: new () => Core };

beforeAll(async () => {
  const make = createRequire(import.meta.url)(resolve(kRoot, 'build/wasm/surpass_core.js'));
  module = await make({ wasmBinary: readFileSync(resolve(kRoot, 'build/wasm/surpass_core.wasm')) });
});

function options(part: Partial<SolveOptions>): SolveOptions {
  return { scheme: 'loop', boundary: 'edge-and-corner', method: 'progressive', solver: 'auto', tolerance: 1e-12,
    maxIterations: 10000, tension: 0, shape: -1.5, levels: 1, ...part };
}

function largestDifference(a: readonly number[], b: readonly number[]): number {
  expect(a.length).toBe(b.length);
  expect(a.length).toBeGreaterThan(0);
  return a.reduce((most, x, i) => Math.max(most, Math.abs(x - b[i]!)), 0);
}

describe('control meshes equal the program’s to 1e-12 of the box side', () => {
  const cases: [string, Partial<SolveOptions>][] = [
    ['jug.obj', {}],
    ['sphere_irregular.obj', { solver: 'richardson' }],
    ['patch_irregular.obj', { boundary: 'hoppe' }],
    ['crease_corners.obj', {}],
    ['mixed_polygons.obj', { scheme: 'doo-sabin' }],
    ['quad_torus.obj', { scheme: 'catmull-clark' }],
    ['mixed_polygons.obj', { scheme: 'catmull-clark', method: 'similarity' }],
    ['cube.obj', { scheme: 'catmull-clark', method: 'fair', tension: 0.25 }],
    ['double_torus.obj', { method: 'similarity' }],
    ['mixed_polygons.obj', { scheme: 'doo-sabin', method: 'similarity' }],
    ['sphere_irregular.obj', { method: 'fair', tension: 0.25 }],
  ];
  test.each(cases)('%s %o', (name, part) => {
    const wanted = options(part);
    const core = new module.Core();
    const loaded = core.load(sample(name), name, {});
    expect(loaded.error).toBeUndefined();
    const solved = core.solve(wanted, null);
    expect(solved.error).toBeUndefined();
    expect(solved.certificate.max).toBeLessThanOrEqual(1e-12);
    const here = new TextDecoder().decode(core.written('control', 'obj').bytes);

    const file = join(folder, `${wanted.scheme}-${wanted.method}-${name}`);
    const fair = wanted.method === 'fair' ? ['--thin-plate', `${1 - wanted.tension}`, '--membrane', `${wanted.tension}`] : [];
    const solver = wanted.method === 'progressive' ? ['--solver', wanted.solver] : [];
    const ran = surpass('interpolate', resolve(kRoot, 'data', name), '-o', file, '--scheme', wanted.scheme, '--boundary',
      wanted.boundary, '--method', wanted.method, '--tolerance', '1e-12', ...solver, ...fair);
    expect(ran.err).toContain('error');
    expect(ran.status).toBe(0);
    const there = readFileSync(file, 'utf8');
    expect(largestDifference(positionsOf(here), positionsOf(there)) / loaded.boxSide).toBeLessThanOrEqual(1e-12);
    // All else is the same, byte for byte: faces, creases, and what the file records of its rules.
    const others = (text: string) => text.split('\n').filter((l) => !l.startsWith('v ')).join('\n');
    expect(others(here)).toBe(others(there));
  });
});

describe('the non-stationary surface is the program’s to 1e-12 of the box side, and meets the points', () => {
  const cases: [string, Partial<SolveOptions>][] = [
    ['double_torus.obj', { shape: -1.5, levels: 2 }],
    ['jug.obj', { shape: 0.75, levels: 1, boundary: 'edge-only' }],
    ['crease_loop.obj', { shape: -3, levels: 2 }],
    ['octahedron.obj', { shape: 3.99, levels: 3 }],
  ];
  test.each(cases)('%s %o', (name, part) => {
    const wanted = options({ scheme: 'nonstationary-loop', ...part });
    const core = new module.Core();
    const loaded = core.load(sample(name), name, {});
    const solved = core.solve(wanted, null);
    expect(solved.error).toBeUndefined();
    expect(solved.report.converged).toBe(true);
    expect(solved.certificate.max).toBeLessThanOrEqual(1e-12);
    expect(solved.control).toBeUndefined();
    expect(core.written('control', 'obj').error?.message).toContain('no other control mesh');
    const here = positionsOf(new TextDecoder().decode(core.written('surface', 'obj').bytes));

    const file = join(folder, `itself-${name}`);
    const ran = surpass('interpolate', resolve(kRoot, 'data', name), '-o', file, '--scheme', wanted.scheme, '--boundary',
      wanted.boundary, '--shape', `${wanted.shape}`, '--levels', `${wanted.levels}`);
    expect(ran.err).toContain('shape parameter');
    expect(ran.status).toBe(0);
    expect(largestDifference(here, positionsOf(readFileSync(file, 'utf8'))) / loaded.boxSide).toBeLessThanOrEqual(1e-12);
    // What is shown is what is written, in single precision.
    const shown = [...solved.surface.positions];
    const centre = [0, 1, 2].map((c) => {
      const of = positionsOf(new TextDecoder().decode(core.written('given', 'obj').bytes)).filter((_, i) => i % 3 === c);
      return (Math.min(...of) + Math.max(...of)) / 2;
    });
    expect(largestDifference(shown, here.map((x, i) => (x - centre[i % 3]!) / loaded.boxSide))).toBeLessThan(1e-6);
  });

  test('the range is the mesh’s, and beyond it the library’s words', () => {
    const tetrahedron = 'v 1 1 1\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n';
    const core = new module.Core();
    const { shapes } = core.load(new TextEncoder().encode(tetrahedron), 'tetrahedron.obj', {});
    expect(shapes).toEqual({ lowest: -3.99, highest: 1.99, round: -3, standard: -1.5, flat: 0 });
    const solved = core.solve(options({ scheme: 'nonstationary-loop', shape: 2.5 }), null);
    expect(solved.report.notes.join()).toContain('1.99');
    expect(core.solve(options({ scheme: 'nonstationary-loop', shape: 1.99 }), null).report.notes).toEqual([]);
    expect(core.load(sample('octahedron.obj'), 'octahedron.obj', {}).shapes!.highest).toBe(3.99);
    // Boundary vertices of three neighbours, and vertices on creases, have rules of their own.
    const { shapes: open } = core.load(new TextEncoder().encode(tetrahedron.replace('f 2 4 3\n', '')), 'open.obj', {});
    expect(open!.highest).toBe(1.99);
    expect(core.load(sample('triangle.off'), 'triangle.off', {}).shapes!.highest).toBe(3.99);
    core.load(sample('crease_semi_sharp.obj'), 'crease_semi_sharp.obj', {});
    expect(core.solve(options({ scheme: 'nonstationary-loop' }), null).error?.code).toBe('unsuitable-for-scheme');
  });
});

describe('broken files are refused in the program’s words', () => {
  const broken: [string, string][] = [
    ['short.obj', 'v 0 0\n'],
    ['range.off', 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n'],
    ['ends.ply', 'ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty double x\nproperty double y\nproperty double z\nend_header\n0 0 0\n'],
    ['huge.ply', 'ply\nformat binary_little_endian 1.0\nelement vertex 3000000000\nproperty double x\nproperty double y\nproperty double z\nend_header\n'],
    ['manifold.obj', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 0 -1\nf 1 2 3\nf 2 1 4\nf 1 2 5\n'],
  ];
  test.each(broken)('%s', (name, text) => {
    const core = new module.Core();
    const { error } = core.load(new TextEncoder().encode(text), name, {});
    writeFileSync(join(folder, name), text);
    const ran = surpass('interpolate', join(folder, name), '-o', join(folder, 'never.obj'));
    expect([2, 3]).toContain(ran.status);
    expect(error).toBeDefined();
    // The program says the whole path, and may add what to try.
    const said = error!.message.replace(`${name}:`, '').trim();
    expect(ran.err).toContain(said.split(' (')[0]!);
  });
});

test('curvature of a finely sampled torus is that of the torus', () => {
  const [R, r, n, m] = [1, 0.4, 60, 40];
  const lines: string[] = [];
  for (let i = 0; i < n; ++i) {
    for (let j = 0; j < m; ++j) {
      const [u, v] = [(2 * Math.PI * i) / n, (2 * Math.PI * j) / m];
      lines.push(`v ${(R + r * Math.cos(v)) * Math.cos(u)} ${r * Math.sin(v)} ${-(R + r * Math.cos(v)) * Math.sin(u)}`);
    }
  }
  const at = (i: number, j: number) => (i % n) * m + (j % m) + 1;
  for (let i = 0; i < n; ++i) for (let j = 0; j < m; ++j) lines.push(`f ${at(i, j)} ${at(i + 1, j)} ${at(i + 1, j + 1)} ${at(i, j + 1)}`);
  const core = new module.Core();
  const loaded = core.load(new TextEncoder().encode(lines.join('\n')), 'torus.obj', {});
  const { surface } = core.solve(options({ scheme: 'catmull-clark', levels: 2 }), null);
  const side = loaded.boxSide;
  let [worstMean, worstGauss] = [0, 0];
  for (let i = 0; i < n; ++i) {
    for (let j = 0; j < m; ++j) {
      const v = (2 * Math.PI * j) / m;
      const [k1, k2] = [1 / r, Math.cos(v) / (R + r * Math.cos(v))];
      worstMean = Math.max(worstMean, Math.abs(surface.channels.mean![i * m + j]! / side - (k1 + k2) / 2));
      worstGauss = Math.max(worstGauss, Math.abs(surface.channels.gauss![i * m + j]! / side ** 2 - k1 * k2));
    }
  }
  expect(worstMean).toBeLessThan(0.02 / r);
  expect(worstGauss).toBeLessThan(0.04 / r / r);
});
