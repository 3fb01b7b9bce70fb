// The curves of the other solvers, for the plot. They have a worker of their own, so that nothing waits for them,
// and are given up as soon as anything else is wanted.
import type { CoreClient } from '../core/client';
import type { Loaded, Mend, Rivals } from '../core/protocol';
import { iterates, solveOptions, type Settings } from './settings';

const kMostVertices = 100000;

const keyOf = (s: Settings): string => JSON.stringify([s.scheme, s.boundary, s.tolerance]);
const comparable = (s: Settings): boolean => iterates(s) && s.stopAfter === undefined;

export class Comparison {
  private found: { key: string; rivals: Rivals } | undefined;
  private hasFile = false;
  private running = false;

  constructor(private readonly core: CoreClient) {}

  /** Another file was opened. */
  forget(): void {
    this.cancel();
    this.found = undefined;
    this.hasFile = false;
  }

  cancel(): void {
    if (this.running) this.core.cancel();
    this.running = false;
  }

  /** What was found before for such settings. */
  known(settings: Settings): Rivals | undefined {
    return comparable(settings) && this.found?.key === keyOf(settings) ? this.found.rivals : undefined;
  }

  /** Nothing where there is nothing to compare: the plot goes without. */
  async of(file: { bytes: Uint8Array<ArrayBuffer>; name: string; mend: Mend }, loaded: Loaded, settings: Settings): Promise<Rivals | undefined> {
    if (!comparable(settings) || loaded.vertices > kMostVertices) return undefined;
    const known = this.known(settings);
    if (known) return known;
    this.running = true;
    try {
      if (!this.hasFile) await this.core.load(file.bytes, file.name, file.mend);
      this.hasFile = true;
      const rivals = await this.core.rivals({ ...solveOptions(settings), solver: 'auto' });
      this.found = { key: keyOf(settings), rivals };
      this.running = false;
      return rivals;
    } catch {
      return undefined;
    }
  }
}
