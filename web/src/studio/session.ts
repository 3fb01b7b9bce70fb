// One mesh and what is known of it: asks the core, keeps the last answer, and tells the page.
import { Cancelled, CoreError, type CoreClient } from '../core/client';
import type { Exportable, Failure, Loaded, Mend, Progress, Rivals, Shape, Solved, Written } from '../core/protocol';
import { connectivityOf, type Connectivity } from '../viewer/connectivity';
import type { LayerSource } from '../viewer/layer';
import type { Content } from '../viewer/viewer';
import { iterates, kLiveVertices, settingsFor, solveOptions, type Settings, type Situation } from './settings';

const kRivalVertices = 100000;

export interface Page {
  opened(session: Session): void;
  solved(session: Session): void;
  compared(session: Session): void;
  failed(failure: Failure, session: Session): void;
  busy(progress: Progress | undefined, patient: boolean): void;
  idle(): void;
}

export class Session {
  loaded: Loaded | undefined;
  name = '';
  settings: Settings | undefined;
  solved: Solved | undefined;
  rivals: Rivals | undefined;
  mend: Mend = {};
  failure: Failure | undefined;
  /** The file that could not be opened. */
  refused: { bytes: Uint8Array<ArrayBuffer>; name: string } | undefined;
  private bytes: Uint8Array<ArrayBuffer> | undefined;
  private iterations = 0;
  private running = false;
  private again = false;
  private turn = 0;
  private readonly known = new Map<string, { corners: Uint32Array; connectivity: Connectivity }>();

  constructor(private readonly core: CoreClient, private readonly page: Page) {}

  get live(): boolean {
    return (this.loaded?.vertices ?? 0) <= kLiveVertices;
  }

  get situation(): Situation | undefined {
    if (!this.loaded) return undefined;
    return { loaded: this.loaded, open: this.connectivity('given', this.loaded.given).boundary.length > 0, iterations: this.iterations };
  }

  async open(bytes: Uint8Array<ArrayBuffer>, name: string, mend: Mend = {}): Promise<void> {
    if (this.running) this.core.cancel();
    this.running = false;  // or else the new file's solve would wait for the one that was cancelled
    const turn = ++this.turn;
    this.again = false;
    this.page.busy(undefined, bytes.length > 2e6);
    try {
      const loaded = await this.core.load(bytes, name, mend);
      if (turn !== this.turn) return;
      this.refused = undefined;
      Object.assign(this, { loaded, name, mend, bytes, solved: undefined, rivals: undefined, failure: undefined, iterations: 0 });
      this.known.clear();
      this.settings = settingsFor(loaded);
      this.page.opened(this);
      if (loaded.kind === 'mesh') await this.solve();
      else this.page.idle();
    } catch (error) {
      if (error instanceof Cancelled) return;
      this.refused = { bytes, name };
      this.page.idle();
      this.page.failed(failureOf(error), this);
      // What was open stays open.
      if (this.bytes) await this.core.load(this.bytes, this.name, this.mend).then(() => this.solve(), () => undefined);
    }
  }

  async change(part: Partial<Settings>): Promise<void> {
    if (!this.settings) return;
    this.refused = undefined;
    this.settings = { ...this.settings, ...part };
    if (this.running && !this.live) {
      this.core.cancel();
      this.running = false;
    }
    await this.solve();
  }

  cancel(): void {
    ++this.turn;
    this.again = this.running = false;
    this.core.cancel();
    this.page.idle();
  }

  /** The same file, mended. */
  async reopen(mend: Mend): Promise<void> {
    if (this.bytes) await this.open(this.bytes, this.name, mend);
  }

  /** The bytes of a file of what was last solved; nothing, and a message, where it cannot be. */
  async written(what: Exportable, format: string): Promise<Written | undefined> {
    try {
      return await this.core.written(what, format);
    } catch (error) {
      if (!(error instanceof Cancelled)) this.page.failed(failureOf(error), this);
      return undefined;
    }
  }

  /** Only the latest wish counts: while one is worked on, at most one waits. */
  private async solve(): Promise<void> {
    if (this.running) {
      this.again = true;
      return;
    }
    this.running = true;
    const turn = ++this.turn;
    const settings = this.settings!;
    this.page.busy(undefined, !this.live);
    try {
      const solved = await this.core.solve(solveOptions(settings), (p) => this.page.busy(p, !this.live));
      if (turn !== this.turn) return;
      this.solved = solved;
      this.failure = undefined;
      if (iterates(settings) && settings.stopAfter === undefined) this.iterations = solved.report.iterations;
      this.page.solved(this);
    } catch (error) {
      if (error instanceof Cancelled || turn !== this.turn) return;
      this.failure = failureOf(error);
      this.page.failed(this.failure, this);
    }
    this.running = false;
    if (this.again) {
      this.again = false;
      await this.solve();
      return;
    }
    this.page.idle();
    if (!this.failure) await this.compare(turn, settings);
  }

  private async compare(turn: number, settings: Settings): Promise<void> {
    this.rivals = undefined;
    if (!iterates(settings) || settings.stopAfter !== undefined || this.loaded!.vertices > kRivalVertices) return;
    try {
      const rivals = await this.core.rivals({ ...solveOptions(settings), solver: 'auto' });
      if (turn !== this.turn) return;
      this.rivals = rivals;
      this.page.compared(this);
    } catch {
      // The plot goes without; the surface is there.
    }
  }

  /** What there is to see. */
  content(): Content {
    const { loaded, solved } = this;
    if (!loaded) return { layers: [] };
    if (loaded.kind === 'points') {
      return { layers: [this.layer('points', 'Points', 'points', loaded.given)] };
    }
    const layers = [this.layer('given', 'Given mesh', 'mesh', loaded.given)];
    if (!solved) return { layers, points: loaded.given.positions };
    if (solved.control) layers.push(this.layer('control', 'Control mesh', 'cage', solved.control));
    layers.push(
      this.layer('plain', 'Plain limit surface', 'surface', solved.plain),
      { ...this.layer('surface', 'Interpolating surface', 'surface', solved.surface), flatError: solved.certificate.max });
    return { layers, points: loaded.given.positions, pointErrors: solved.pointErrors };
  }

  private layer(id: string, label: string, kind: LayerSource['kind'], shape: Shape): LayerSource {
    return { id, label, kind, shape, connectivity: this.connectivity(id, shape) };
  }

  // Positions change with every slider, faces hardly ever.
  private connectivity(id: string, shape: Shape): Connectivity {
    const before = this.known.get(id);
    if (before && before.corners.length === shape.corners.length && before.corners.every((c, i) => c === shape.corners[i])) {
      return before.connectivity;
    }
    const connectivity = connectivityOf(shape);
    this.known.set(id, { corners: shape.corners, connectivity });
    return connectivity;
  }
}

function failureOf(error: unknown): Failure {
  if (error instanceof CoreError) return error.failure;
  return { code: 'page', message: error instanceof Error ? error.message : String(error) };
}
