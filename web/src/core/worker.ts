// The worker: the core's glue code, which defines surpassCore, stands before this in its source.
import type { Failure, Progress, Reply, Request, Start } from './protocol';

interface Core {
  load(file: Uint8Array, name: string, mend: unknown): object;
  solve(options: unknown, progress: ProgressCall): object;
  rivals(options: unknown, progress: ProgressCall): object;
  written(what: string, format: string): object;
}
type ProgressCall = (stage: string, fraction: number, iteration: number, error: number) => void;
declare function surpassCore(options: { wasmBinary: ArrayBuffer }): Promise<{ Core: new () => Core }>;
declare const self: DedicatedWorkerGlobalScope;

/** Progress is told at most this often, in milliseconds. */
const kPause = 60;

/** The buffers of every typed array in there, to be moved and not copied. */
function buffersOf(value: unknown, found: Transferable[] = []): Transferable[] {
  if (ArrayBuffer.isView(value)) found.push(value.buffer as ArrayBuffer);
  else if (Array.isArray(value)) return found;
  else if (value !== null && typeof value === 'object') {
    for (const part of Object.values(value)) buffersOf(part, found);
  }
  return found;
}

function teller(id: number): ProgressCall {
  let last = 0;
  return (stage, fraction, iteration, error) => {
    const now = performance.now();
    if (now - last < kPause) return;
    last = now;
    const progress: Progress = { stage, fraction, iteration, error };
    self.postMessage({ id, progress } satisfies Reply);
  };
}

function call(core: Core, request: Request): object {
  const [first, second, third] = request.arguments;
  switch (request.method) {
    case 'load':
      return core.load(first as Uint8Array, second as string, third);
    case 'solve':
      return core.solve(first, teller(request.id));
    case 'rivals':
      return core.rivals(first, teller(request.id));
    case 'written':
      return core.written(first as string, second as string);
  }
}

/** An exception from the core is memory that ran out: all else comes as a value. */
function explain(thrown: unknown): Failure {
  const words = thrown instanceof Error ? thrown.message : String(thrown);
  return {
    code: 'out-of-memory',
    message: `The browser's memory did not suffice (${words.slice(0, 120)}). Take fewer refinement steps, or a smaller mesh.`,
  };
}

let core: Promise<Core> | undefined;

self.onmessage = async ({ data }: MessageEvent<Start | Request>) => {
  if ('wasm' in data) {
    core = surpassCore({ wasmBinary: data.wasm }).then((module) => new module.Core());
    return;
  }
  try {
    const result = call(await core!, data);
    if ('error' in result) {
      self.postMessage({ id: data.id, failure: result.error as Failure } satisfies Reply);
    } else {
      self.postMessage({ id: data.id, result } satisfies Reply, buffersOf(result));
    }
  } catch (thrown) {
    self.postMessage({ id: data.id, failure: explain(thrown) } satisfies Reply);
  }
};
