// What tests of the built things share: the command line, the sample files, a large mesh.
import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';

export const kRoot = resolve(import.meta.dirname, '../..');
export const kProgram = process.env.SURPASS_EXECUTABLE ?? resolve(kRoot, 'build/release/surpass');

export interface Ran {
  status: number;
  out: string;
  err: string;
}
export function surpass(...words: string[]): Ran {
  const ran = spawnSync(kProgram, words, { encoding: 'utf8', maxBuffer: 1 << 28 });
  if (ran.error) throw ran.error;
  return { status: ran.status ?? -1, out: ran.stdout, err: ran.stderr };
}

export function sample(name: string): Uint8Array {
  return readFileSync(resolve(kRoot, 'data', name));
}

/** The positions of an OBJ file. */
export function positionsOf(obj: string): number[] {
  return obj.split('\n').filter((l) => l.startsWith('v ')).flatMap((l) => l.split(' ').slice(1, 4).map(Number));
}

/** A torus of triangles with a bumpy tube: `around` times `across` vertices. */
export function torus(around: number, across: number): string {
  const lines: string[] = [];
  for (let i = 0; i < around; ++i) {
    for (let j = 0; j < across; ++j) {
      const [u, v] = [(2 * Math.PI * i) / around, (2 * Math.PI * j) / across];
      const r = 0.4 + 0.03 * Math.sin(7 * u + 3 * v) + 0.004 * Math.sin(97 * u) * Math.cos(61 * v);
      lines.push(`v ${(1 + r * Math.cos(v)) * Math.cos(u)} ${r * Math.sin(v)} ${-(1 + r * Math.cos(v)) * Math.sin(u)}`);
    }
  }
  const at = (i: number, j: number) => (i % around) * across + (j % across) + 1;
  for (let i = 0; i < around; ++i) {
    for (let j = 0; j < across; ++j) {
      lines.push(`f ${at(i, j)} ${at(i + 1, j)} ${at(i + 1, j + 1)}`, `f ${at(i, j)} ${at(i + 1, j + 1)} ${at(i, j + 1)}`);
    }
  }
  return `${lines.join('\n')}\n`;
}

/** How far positions of two OBJ files are apart, of the second one's box side. */
export function offBy(here: string, there: string): number {
  const [a, b] = [here, there].map((file) => positionsOf(readFileSync(file, 'utf8')));
  if (a!.length !== b!.length) throw new Error(`${a!.length / 3} and ${b!.length / 3} positions`);
  const largest = (numbers: number[]) => numbers.reduce((most, x) => Math.max(most, x), -Infinity);
  const side = largest([0, 1, 2].map((c) => {
    const of = b!.filter((_, i) => i % 3 === c);
    return largest(of) + largest(of.map((x) => -x));
  }));
  return largest(a!.map((x, i) => Math.abs(x - b![i]!))) / side;
}
