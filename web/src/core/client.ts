// The page's side of the core: calls become messages to the worker, and cancelling ends the worker.
import type {
  CoreMethods, Answer, Exportable, Failure, Loaded, Mend, Method, Progress, Reply, Request, Rivals, Solved,
  SolveOptions, Start, Written,
} from './protocol';

/** What the file core.js brings: the worker's source and the module, packed with gzip. */
export interface CoreFiles {
  worker: string;
  wasm: string;
}

export class CoreError extends Error {
  constructor(readonly failure: Failure) {
    super(failure.message);
  }
}
/** The call was given up by `cancel`. */
export class Cancelled extends Error {}

interface Waiting {
  resolve(value: unknown): void;
  reject(reason: Error): void;
  progress: ((progress: Progress) => void) | undefined;
}

function bytesOf(base64: string): Uint8Array<ArrayBuffer> {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

async function unpack(base64: string): Promise<ArrayBuffer> {
  const stream = new Blob([bytesOf(base64)]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Response(stream).arrayBuffer();
}

export class CoreClient {
  private readonly source: string;
  private wasm: Promise<ArrayBuffer> | undefined;
  private worker: Promise<Worker> | undefined;
  private readonly waiting = new Map<number, Waiting>();
  private next = 0;
  private file: { bytes: Uint8Array<ArrayBuffer>; name: string; mend: Mend } | undefined;
  private plain: Pick<Solved, 'plain' | 'pointErrors'> | undefined;
  private lastSolved: SolveOptions | undefined;
  /** The worker of now has read the file, and has found the last control mesh. */
  private hasFile = false;
  private hasSolution = false;

  constructor(private readonly files: CoreFiles) {
    // A URL of a blob serves pages opened from a folder, too, where workers cannot be loaded.
    this.source = URL.createObjectURL(new Blob([files.worker], { type: 'text/javascript' }));
  }

  /** A file that is refused leaves the one before it where it is. */
  async load(bytes: Uint8Array<ArrayBuffer>, name: string, mend: Mend = {}): Promise<Loaded> {
    const loaded = await this.call('load', [bytes, name, mend]);
    this.file = { bytes, name, mend };
    this.lastSolved = this.plain = undefined;
    this.hasFile = true;
    this.hasSolution = false;
    return loaded;
  }

  async solve(options: SolveOptions, progress?: (p: Progress) => void): Promise<Solved> {
    await this.restoreFile();
    const answer: Answer = await this.call('solve', [options], progress);
    const plain = answer.plain ?? this.plain?.plain;
    const pointErrors = answer.pointErrors ?? this.plain?.pointErrors;
    if (!plain || !pointErrors) throw new CoreError({ code: 'page', message: 'The answer lacks the plain surface. Open the file again.' });
    this.plain = { plain, pointErrors };
    this.lastSolved = options;
    this.hasSolution = true;
    return { ...answer, plain, pointErrors };
  }

  async rivals(options: SolveOptions, progress?: (p: Progress) => void): Promise<Rivals> {
    await this.restoreFile();
    return this.call('rivals', [options], progress);
  }

  async written(what: Exportable, format: string, progress?: (p: Progress) => void): Promise<Written> {
    await this.restoreFile();
    if (what !== 'given' && !this.hasSolution && this.lastSolved) await this.solve(this.lastSolved, progress);
    return this.call('written', [what, format]);
  }

  /** Gives up what is running. The next call starts a worker anew. */
  cancel(): void {
    const worker = this.worker;
    this.worker = undefined;
    this.hasFile = this.hasSolution = false;
    void worker?.then((w) => w.terminate());
    for (const waiting of this.waiting.values()) waiting.reject(new Cancelled());
    this.waiting.clear();
  }

  private async restoreFile(): Promise<void> {
    if (this.hasFile || !this.file) return;
    await this.call('load', [this.file.bytes, this.file.name, this.file.mend]);
    this.hasFile = true;
  }

  private async start(): Promise<Worker> {
    this.wasm ??= unpack(this.files.wasm);
    const wasm = (await this.wasm).slice(0);
    const worker = new Worker(this.source);
    worker.onmessage = ({ data }: MessageEvent<Reply>) => this.receive(data);
    worker.onerror = (event) => this.fail(event.message);
    worker.postMessage({ wasm } satisfies Start, [wasm]);
    return worker;
  }

  private async call<M extends Method>(
    method: M, args: Parameters<CoreMethods[M]>, progress?: (p: Progress) => void,
  ): Promise<ReturnType<CoreMethods[M]>> {
    const id = this.next++;
    const starting = this.worker ??= this.start();
    const worker = await starting;
    // Given up while the worker started: it answers no more.
    if (starting !== this.worker) throw new Cancelled();
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve: resolve as (value: unknown) => void, reject, progress });
      worker.postMessage({ id, method, arguments: args } satisfies Request);
    });
  }

  private receive(reply: Reply): void {
    const waiting = this.waiting.get(reply.id);
    if (!waiting) return;
    if ('progress' in reply) {
      waiting.progress?.(reply.progress);
      return;
    }
    this.waiting.delete(reply.id);
    if ('failure' in reply) waiting.reject(new CoreError(reply.failure));
    else waiting.resolve(reply.result);
  }

  private fail(message: string): void {
    const error = new CoreError({ code: 'worker', message: `The computation stopped: ${message}` });
    for (const waiting of this.waiting.values()) waiting.reject(error);
    this.waiting.clear();
    this.cancel();
  }
}
