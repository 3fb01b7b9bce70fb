// Where meshes come from: samples, the system's dialogue, and files that are dropped on the page.
import { element } from '../viewer/dom';

declare global {
  interface Window {
    /** By samples.js, which is loaded before this script. */
    surpassSamples: Record<string, string>;
  }
}

const kSampleNames: Record<string, string> = {
  'jug.obj': 'Jug', 'twisted_ring.obj': 'Twisted ring', 'trefoil.ply': 'Trefoil knot',
  'mixed_polygons.obj': 'Mixed polygons', 'crease_boundary.obj': 'Creases and boundary',
  'double_torus.obj': 'Double torus', 'cube.obj': 'Cube', 'blob.stl': 'Blob',
};
const kFirstSample = 'jug.obj';
const kAccepted = '.obj,.ply,.off,.stl,.xyz,.pwn,.pts';

export interface Receiver {
  /** `note` is what else is to be said of it. */
  open(bytes: Uint8Array<ArrayBuffer>, name: string, note: string): void;
  unreadable(words: string): void;
}

export class Sources {
  readonly samples = element('select', { 'aria-label': 'Sample' });
  readonly chooser = element('input', { type: 'file', accept: kAccepted, hidden: '', 'aria-label': 'Mesh file' });
  readonly button = element('button', { type: 'button' }, 'Open mesh…');
  /** The sample that is open, or none; and the one that is being opened. */
  private sample = '';
  private next = '';
  private turn = 0;

  constructor(private readonly receiver: Receiver) {
    this.button.addEventListener('click', () => this.chooser.click());
    this.chooser.addEventListener('change', () => {
      const file = this.chooser.files?.[0];
      if (file) void this.read(file, '');
      this.chooser.value = '';
    });
    this.samples.append(element('option', { value: '', disabled: '' }, 'Samples'),
      ...Object.keys(window.surpassSamples).map((file) => element('option', { value: file }, kSampleNames[file] ?? file)));
    this.samples.addEventListener('change', () => this.openSample(this.samples.value));
    this.acceptDrops();
  }

  /** The page opens with a sample. */
  start(): void {
    this.openSample(kFirstSample);
  }

  opened(): void {
    this.samples.value = this.sample = this.next;
  }
  /** What was open before is so still; `again` will be opened with the same source. */
  stayed(): void {
    this.samples.value = this.sample;
  }
  /** The file that is open is opened anew. */
  reopening(): void {
    this.next = this.sample;
  }
  /** The file that was refused is opened after all. */
  retrying(): void {
    this.next = '';
  }

  private openSample(file: string): void {
    ++this.turn;
    this.samples.value = this.next = file;
    const text = atob(window.surpassSamples[file]!);
    this.receiver.open(Uint8Array.from(text, (c) => c.charCodeAt(0)), file, '');
  }

  private async read(file: File, note: string): Promise<void> {
    // Only the latest choice counts, however long its reading takes.
    const turn = ++this.turn;
    let bytes: ArrayBuffer;
    try {
      bytes = await file.arrayBuffer();
    } catch {
      if (turn === this.turn) this.receiver.unreadable(`${file.name} cannot be read. If it is a folder, drop a file that is in it.`);
      return;
    }
    if (turn !== this.turn) return;
    this.samples.value = this.next = '';
    this.receiver.open(new Uint8Array(bytes), file.name, note);
  }

  private acceptDrops(): void {
    const over = (on: boolean) => document.body.classList.toggle('dropping', on);
    window.addEventListener('dragover', (event) => {
      event.preventDefault();
      over(true);
    });
    window.addEventListener('dragleave', (event) => {
      if (event.relatedTarget === null) over(false);
    });
    window.addEventListener('drop', (event) => {
      event.preventDefault();
      over(false);
      const files = event.dataTransfer?.files ?? [];
      const note = files.length > 1 ? `Of ${files.length} files the first is opened. ` : '';
      if (files[0]) void this.read(files[0], note);
      else this.receiver.unreadable('There was no file in what was dropped.');
    });
  }
}
