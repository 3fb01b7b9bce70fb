// One mesh and what is known of it: asks the core, keeps the last answer, and tells the page.
import { Cancelled, CoreError, type CoreClient } from '../core/client';
import type { Exportable, Failure, Loaded, Mend, Progress, Rivals, Solved, Written } from '../core/protocol';
import type { Content } from '../viewer/viewer';
import { Comparison } from './comparison';
import { Scenery } from './scenery';
import { iterates, kLiveVertices, settingsFor, solveOptions, withChosen, type Settings, type Situation } from './settings';

type File = { bytes: Uint8Array<ArrayBuffer>; name: string; mend: Mend };

export interface Page {
  opened(session: Session): void;
  solved(session: Session): void;
  compared(session: Session): void;
  /** `tried` are the settings that were refused, if it was they. */
  failed(failure: Failure, session: Session, tried?: Settings): void;
  cancelled(session: Session): void;
  busy(progress: Progress | undefined, patient: boolean): void;
  idle(): void;
}

export class Session {
  loaded: Loaded | undefined;
  /** The file that is open. */
  file: File | undefined;
  settings: Settings | undefined;
  solved: Solved | undefined;
  rivals: Rivals | undefined;
  failure: Failure | undefined;
  /** The first solve was cancelled, so that there is no surface. */
  unsolved = false;
  /** The file that could not be opened. */
  refused: File | undefined;
  private running = false;
  private again = false;
  private opening = false;
  /** The open mesh was being solved when another file was to be opened. */
  private interrupted = false;
  /** What was chosen while a file was opened: meant for that one. */
  private chosen: Partial<Settings> = {};
  /** The settings of what is shown. */
  shown: Settings | undefined;
  private iterations = 0;
  private turn = 0;
  private readonly scenery = new Scenery();
  private readonly comparison: Comparison;

  /** `other` is a core for the comparison of solvers, which nothing else shall wait for. */
  constructor(private readonly core: CoreClient, other: CoreClient, private readonly page: Page) {
    this.comparison = new Comparison(other);
  }

  get name(): string {
    return this.file?.name ?? '';
  }
  get live(): boolean {
    return (this.loaded?.vertices ?? 0) <= kLiveVertices;
  }
  /** The settings with those that wait for a file. */
  get wished(): Settings | undefined {
    return this.settings && { ...this.settings, ...this.chosen };
  }
  get situation(): Situation | undefined {
    if (!this.loaded) return undefined;
    return { loaded: this.loaded, open: this.scenery.isOpen(this.loaded), iterations: this.iterations };
  }

  async open(bytes: Uint8Array<ArrayBuffer>, name: string, mend: Mend = {}): Promise<void> {
    this.stop();
    const turn = ++this.turn;
    const file = { bytes, name, mend };
    this.opening = true;
    this.page.busy(undefined, bytes.length > 2e6);
    try {
      const loaded = await this.core.load(bytes, name, mend);
      // A later file may have come in the meantime; then this one is nobody's.
      if (turn === this.turn) await this.take(file, loaded);
    } catch (error) {
      if (turn === this.turn && !(error instanceof Cancelled)) await this.refuse(file, error);
    }
  }

  private async take(file: File, loaded: Loaded): Promise<void> {
    const settings = withChosen(settingsFor(loaded), this.chosen, loaded);
    Object.assign(this, { loaded, file, settings, solved: undefined, shown: undefined, rivals: undefined,
      failure: undefined, refused: undefined, unsolved: false, iterations: 0, opening: false, interrupted: false, chosen: {} });
    this.scenery.clear();
    this.comparison.forget();
    this.page.opened(this);
    if (loaded.kind === 'mesh') await this.solve();
    else this.page.idle();
  }

  // What was open stays open, in the core as well; and is solved only if it was being solved, or is to be otherwise.
  private async refuse(file: File, error: unknown): Promise<void> {
    const unfinished = this.interrupted || Object.keys(this.chosen).length > 0;
    if (this.settings && this.loaded) this.settings = withChosen(this.settings, this.chosen, this.loaded);
    Object.assign(this, { refused: file, opening: false, interrupted: false, chosen: {} });
    this.page.idle();
    this.page.failed(failureOf(error), this);
    if (unfinished) await this.solve();
  }

  async change(part: Partial<Settings>): Promise<void> {
    if (!this.settings) return;
    if (this.opening) {
      this.chosen = { ...this.chosen, ...part };
      return;
    }
    this.refused = undefined;
    this.settings = { ...this.settings, ...part };
    if (this.running && !this.live) this.stop();
    await this.solve();
  }

  cancel(): void {
    ++this.turn;
    this.stop();
    Object.assign(this, { again: false, opening: false, interrupted: false, chosen: {} });
    if (this.shown) this.settings = this.shown;
    this.unsolved = this.loaded?.kind === 'mesh' && !this.shown && !this.failure;
    this.page.idle();
    this.page.cancelled(this);
  }

  /** The same file, mended. */
  async reopen(mend: Mend): Promise<void> {
    if (this.file) await this.open(this.file.bytes, this.file.name, mend);
  }

  /** The bytes of a file of what was last solved; nothing, and a message, where it cannot be. */
  async written(what: Exportable, format: string): Promise<Written | undefined> {
    if (this.opening) {
      this.page.failed({ code: 'page', message: 'Another file is being opened. Export again once it is there.' }, this);
      return undefined;
    }
    this.comparison.cancel();
    this.page.busy(undefined, false);
    try {
      return await this.core.written(what, format, (p) => this.page.busy(p, false));
    } catch (error) {
      if (!(error instanceof Cancelled)) this.page.failed(failureOf(error), this);
      return undefined;
    } finally {
      if (!this.running && !this.opening) this.page.idle();
    }
  }

  /** Ends what the core is doing. */
  private stop(): void {
    this.comparison.cancel();
    if (this.running) this.interrupted = true;
    if (this.running || this.opening) this.core.cancel();
    this.running = this.again = false;  // or else the next solve would wait for the one that was cancelled
  }

  /** Only the latest wish counts: while one is worked on, at most one waits. */
  async solve(): Promise<void> {
    if (this.loaded?.kind !== 'mesh') return;
    if (this.running) {
      this.again = true;
      return;
    }
    this.comparison.cancel();
    this.running = true;
    this.unsolved = false;
    const turn = ++this.turn;
    const settings = this.settings!;
    this.page.busy(undefined, !this.live);
    try {
      const solved = await this.core.solve(solveOptions(settings), (p) => this.page.busy(p, !this.live));
      if (turn !== this.turn) return;
      this.keep(solved, settings);
    } catch (error) {
      if (error instanceof Cancelled || turn !== this.turn) return;
      if (!this.again) this.giveUp(failureOf(error), settings);
    }
    this.running = this.interrupted = false;
    if (this.again) {
      this.again = false;
      await this.solve();
      return;
    }
    this.page.idle();
    if (this.shown === settings) await this.compare(turn, settings);
  }

  private keep(solved: Solved, settings: Settings): void {
    if (solved.pointErrors.length !== this.loaded!.vertices) {
      throw new Error('The surface that came is of another mesh. Open the file again.');
    }
    this.solved = solved;
    this.shown = settings;
    this.failure = undefined;
    this.rivals = this.comparison.known(settings);
    if (iterates(settings) && settings.stopAfter === undefined) this.iterations = solved.report.iterations;
    this.page.solved(this);
  }

  // Where a surface is shown, the settings are again those of it.
  private giveUp(failure: Failure, tried: Settings): void {
    if (this.shown) this.settings = this.shown;
    else this.failure = failure;
    // What was said of a file that could not be opened is not said over.
    if (!this.refused) this.page.failed(failure, this, tried);
  }

  private async compare(turn: number, settings: Settings): Promise<void> {
    const rivals = await this.comparison.of(this.file!, this.loaded!, settings);
    if (turn !== this.turn || rivals === this.rivals) return;
    this.rivals = rivals;
    this.page.compared(this);
  }

  /** What there is to see. */
  content(): Content {
    return this.scenery.content(this.loaded, this.solved);
  }
}

function failureOf(error: unknown): Failure {
  if (error instanceof CoreError) return error.failure;
  return { code: 'page', message: error instanceof Error ? error.message : String(error) };
}
