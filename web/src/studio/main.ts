// The studio's page: header, settings to the left, picture in the middle, results to the right.
import '../viewer/viewer.css';
import './studio.css';
import { CoreClient, type CoreFiles } from '../core/client';
import type { Exportable, Failure, Progress } from '../core/protocol';
import { element } from '../viewer/dom';
import { counted } from '../viewer/figures';
import { Stage } from '../viewer/stage';
import { themeButton } from '../viewer/theme';
import { Message, remedy } from './message';
import { good, results, verdict } from './results';
import { save, stem } from './save';
import { Session, type Page } from './session';
import { differences, settingsForm, type Settings } from './settings';
import { Sources, type Receiver } from './sources';

declare global {
  interface Window {
    /** By core.js, which is loaded before this script. */
    surpassCoreFiles: CoreFiles;
    /** For measurements and tests. */
    surpassStudio?: { stage: Stage; session: Session };
  }
}

const kTagline = 'Smooth surfaces through your mesh’s vertices: drop a file.';
/** A solve that is over sooner shows no progress. */
const kPatience = 350;
/** Settings that decide on no other control. */
const kSliders = ['levels', 'stopAfter', 'tension', 'shape'];

class Studio implements Page, Receiver {
  private readonly stage = new Stage();
  private readonly session = new Session(
    new CoreClient(window.surpassCoreFiles), new CoreClient(window.surpassCoreFiles), this);
  private readonly sources = new Sources(this);
  private readonly meshBox = element('section');
  private readonly settingsBox = element('section');
  private readonly exportBox = element('section');
  private readonly resultsBox = element('aside', { class: 'panel right', 'aria-label': 'Results' });
  private readonly status = element('p', { class: 'status', role: 'status', 'aria-live': 'polite' });
  private readonly message = new Message(() => { this.session.refused = undefined; });
  private readonly bar = element('div', { class: 'bar' });
  private readonly stageName = element('span');
  private readonly progress = element('div', { class: 'progress', hidden: '' });
  private readonly exportButton = element('button', { type: 'button', class: 'primary', disabled: '' }, 'Export control mesh');
  /** What else is to be said of the file. */
  private note = '';
  private format = 'obj';
  private surfaceFormat = 'ply';
  private shown: ReturnType<typeof setTimeout> | undefined;

  constructor() {
    document.body.append(this.header(), element('main', {},
      element('aside', { class: 'panel left', 'aria-label': 'Settings' }, this.meshBox, this.settingsBox, this.exportBox),
      this.stage.root, this.resultsBox));
    const cancel = element('button', { type: 'button', class: 'small' }, 'Cancel');
    cancel.addEventListener('click', () => this.session.cancel());
    this.progress.append(element('div', { class: 'progress-text' }, this.stageName, cancel),
      element('div', { class: 'track', role: 'progressbar', 'aria-label': 'Progress', 'aria-valuemin': '0', 'aria-valuemax': '100' }, this.bar));
    this.stage.frame.append(this.message.root, this.progress, element('div', { class: 'drop', 'aria-hidden': 'true' }, 'Drop to open'));
    this.stage.root.append(this.status);
    this.drawMeshBox();
    this.sources.start();
    window.surpassStudio = { stage: this.stage, session: this.session };
  }

  private header(): HTMLElement {
    this.exportButton.addEventListener('click', () => void (this.session.solved?.control
      ? this.exportMesh('control', this.format) : this.exportMesh('surface', this.surfaceFormat)));
    return element('header', { class: 'top' },
      element('h1', {}, 'Surpass ', element('span', { class: 'quiet' }, 'Studio')),
      this.sources.samples, this.sources.button, this.exportButton, this.sources.chooser, element('p', { class: 'tagline quiet' }, kTagline),
      themeButton((dark) => this.stage.setDark(dark)));
  }

  open(bytes: Uint8Array<ArrayBuffer>, name: string, note: string): void {
    this.note = note;
    void this.session.open(bytes, name);
  }
  unreadable(words: string): void {
    this.message.show(words, undefined, []);
  }

  // What the session tells.

  opened(session: Session): void {
    this.sources.opened();
    this.message.hide();
    const { given } = session.loaded!;
    this.stage.viewer.fit(given.positions);
    this.stage.show(session.content());
    this.exportButton.disabled = true;
    this.drawMeshBox();
    this.drawSettings();
    this.drawExports();
    this.resultsBox.replaceChildren(...results(session));
  }

  solved(session: Session): void {
    // What is said of a file that was refused stays, though the one before it is shown again.
    if (session.refused === undefined) this.message.hide();
    this.exportButton.disabled = false;
    this.exportButton.textContent = session.solved!.control ? 'Export control mesh' : 'Export surface';
    this.stage.show(session.content());
    this.drawSettings();
    this.drawExports();
    this.resultsBox.replaceChildren(...results(session));
    this.status.textContent = `${this.summary()}. ${verdict(session.solved!).textContent}.`;
  }

  compared(session: Session): void {
    this.resultsBox.replaceChildren(...results(session));
  }

  failed(failure: Failure, session: Session, tried?: Settings): void {
    if (session.refused) {
      this.note = '';
      this.sources.stayed();
    }
    this.message.show(failure.message, this.whatStays(session, tried), this.remedies(failure, session, tried));
    this.drawSettings();
  }

  private whatStays(session: Session, tried: Settings | undefined): string | undefined {
    if (session.refused) return session.loaded && `${session.name} stays open.`;
    if (!tried || !session.shown) return undefined;
    return `Refused: ${differences(tried, session.shown)}. The settings are again those of what is shown.`;
  }

  private remedies(failure: Failure, session: Session, tried: Settings | undefined): HTMLElement[] {
    if (tried && failure.code === 'singular') {
      return [remedy('Use similarity instead', () => void session.change({ ...tried, method: 'similarity', stopAfter: undefined }))];
    }
    const mendable = ['non-manifold-edge', 'inconsistent-orientation', 'repeated-vertex', 'degenerate-face', 'duplicate-face'];
    const file = session.refused;
    if (file && mendable.includes(failure.code)) {
      return [remedy('Repair and open', () => {
        this.sources.retrying();
        void session.open(file.bytes, file.name, { repair: true });
      })];
    }
    return [];
  }

  cancelled(session: Session): void {
    this.sources.stayed();
    this.drawMeshBox();
    this.drawSettings();
    this.status.textContent = session.unsolved
      ? 'Cancelled. There is no surface yet: Solve makes one.' : 'Cancelled. The picture shows what was found before.';
  }

  busy(progress: Progress | undefined, patient: boolean): void {
    const percent = progress ? Math.round(100 * progress.fraction) : 0;
    this.bar.style.width = `${percent}%`;
    this.bar.parentElement!.setAttribute('aria-valuenow', String(percent));
    this.stageName.textContent = progress ? `${progress.stage} ${percent} %` : 'Working';
    if (patient) this.progress.hidden = false;
    else this.shown ??= setTimeout(() => { this.progress.hidden = false; }, kPatience);
  }

  idle(): void {
    clearTimeout(this.shown);
    this.shown = undefined;
    this.progress.hidden = true;
  }

  // The left-hand column.

  private drawMeshBox(): void {
    const { loaded, name } = this.session;
    if (!loaded) {
      this.meshBox.replaceChildren(element('h2', {}, 'Mesh'), element('p', { class: 'quiet' }, 'None yet'));
      return;
    }
    this.meshBox.replaceChildren(element('h2', {}, 'Mesh'), element('p', { class: 'file' }, name),
      element('p', { class: 'quiet' }, this.sizes()));
    if (loaded.kind === 'mesh' && !loaded.triangles) {
      const cut = element('button', { type: 'button', class: 'small', title: 'Then Loop surfaces are possible, too' }, 'Cut into triangles');
      cut.addEventListener('click', () => {
        this.sources.reopening();
        void this.session.reopen({ triangulate: true });
      });
      this.meshBox.append(cut);
    }
    this.status.textContent = this.summary();
  }

  private sizes(): string {
    const { kind, vertices, faces } = this.session.loaded!;
    return kind === 'points' ? counted(vertices, 'point', 'points')
      : `${counted(vertices, 'vertex', 'vertices')}, ${counted(faces, 'face', 'faces')}`;
  }
  private summary(): string {
    return `${this.note}${this.session.name}: ${this.sizes()}`;
  }

  private drawSettings(): void {
    const { wished: settings, situation, loaded } = this.session;
    if (!settings || !situation || loaded?.kind !== 'mesh') {
      this.settingsBox.replaceChildren();
      return;
    }
    const focused = (document.activeElement as HTMLElement | null)?.id;
    // A slider that is held must not be replaced under the hand.
    if (focused && this.settingsBox.querySelector(`#${focused}:active`)) return;
    this.settingsBox.replaceChildren(element('h2', {}, 'Surface'), settingsForm(settings, situation, (part) => {
      void this.session.change(part);
      if (!Object.keys(part).every((name) => kSliders.includes(name))) this.drawSettings();
    }));
    if (this.session.unsolved) {
      const solve = element('button', { type: 'button', class: 'primary', id: 'solve' }, 'Solve');
      solve.addEventListener('click', () => {
        void this.session.solve();
        this.drawSettings();
      });
      this.settingsBox.append(solve);
    }
    if (focused) this.settingsBox.querySelector<HTMLElement>(`#${focused}`)?.focus();
  }

  private drawExports(): void {
    const { loaded, solved } = this.session;
    const row = (label: string, formats: readonly string[], chosen: string, choose: (f: string) => void, act: () => void) => {
      const input = element('select', { 'aria-label': `Format of: ${label}` }, ...formats.map((f) => element('option', { value: f }, f.toUpperCase())));
      input.value = chosen;
      input.addEventListener('change', () => choose(input.value));
      const button = element('button', { type: 'button', class: 'small' }, label);
      button.addEventListener('click', act);
      return element('div', { class: 'export-row' }, button, input);
    };
    const parts: HTMLElement[] = [element('h2', {}, 'Export')];
    if (loaded?.kind === 'mesh' && solved) {
      if (solved.control) {
        parts.push(row('Control mesh', ['obj', 'ply', 'off'], this.format, (f) => { this.format = f; }, () => void this.exportMesh('control', this.format)));
      }
      parts.push(row('Surface', ['ply', 'obj', 'off', 'stl'], this.surfaceFormat, (f) => { this.surfaceFormat = f; }, () => void this.exportMesh('surface', this.surfaceFormat)));
    }
    const picture = element('button', { type: 'button', class: 'small' }, 'Picture (PNG)');
    picture.addEventListener('click', async () => save(await this.stage.viewer.png(), `${stem(this.session.name)}.png`));
    parts.push(element('div', { class: 'export-row' }, picture));
    this.exportBox.replaceChildren(...parts);
  }

  private async exportMesh(what: Exportable, format: string): Promise<void> {
    const name = `${stem(this.session.name)}.${what}.${format}`;
    const written = await this.session.written(what, format);
    if (!written) return;
    save(new Blob([written.bytes]), name);
    const doubt = good(this.session.solved!) ? '' : ` ${verdict(this.session.solved!).textContent}.`;
    const lost = written.notices.length > 0 ? ` ${written.notices.join('; ')}.` : '';
    this.status.textContent = `Saved ${name}.${doubt}${lost}`;
  }
}

new Studio();
