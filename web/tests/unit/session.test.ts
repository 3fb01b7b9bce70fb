// What the session makes of answers that come late, or not at all: with a core whose every answer the test gives.
import { describe, expect, test } from 'vitest';
import { Cancelled, CoreError, type CoreClient } from '../../src/core/client';
import type { Failure, Loaded, Shape, SolveOptions, Solved } from '../../src/core/protocol';
import { Session, type Page } from '../../src/studio/session';
import type { Settings } from '../../src/studio/settings';

function shape(vertices: number): Shape {
  return { positions: new Float32Array(3 * vertices), offsets: Uint32Array.of(0, 3), corners: Uint32Array.of(0, 1, 2),
    creases: new Uint32Array(0), channels: {} };
}
function mesh(vertices: number): Loaded {
  return { kind: 'mesh', format: 'obj', notices: [], vertices, faces: 1, triangles: true, scheme: 'loop', boxSide: 1, given: shape(vertices) };
}
const points = (vertices: number): Loaded => ({ ...mesh(vertices), kind: 'points' });
function surface(vertices: number): Solved {
  return { control: shape(vertices), plain: shape(vertices), surface: shape(vertices), pointErrors: new Float32Array(vertices),
    certificate: { max: 0, mean: 0, boxSide: 1, worstVertex: 0, evaluator: '' },
    report: { converged: true, solver: 'chebyshev', tolerance: 1e-12, iterations: 9, boundaryIterations: 0, history: [], boundaryHistory: [], notes: [] },
    seconds: { solve: 0, verify: 0, surfaces: 0 } };
}

interface Call {
  method: string;
  first: unknown;
  answer(value: unknown): Promise<void>;
  refuse(code: string): Promise<void>;
}
/** Until the promises that can go on have done so. */
const settled = () => new Promise<void>((done) => { setTimeout(done, 0); });

class FakeCore {
  readonly calls: Call[] = [];
  private waiting: ((error: Error) => void)[] = [];
  private call(method: string, first: unknown): Promise<unknown> {
    return new Promise((resolve, reject) => {
      this.waiting.push(reject);
      this.calls.push({ method, first,
        answer: (value) => { resolve(value); return settled(); },
        refuse: (code) => { reject(new CoreError({ code, message: code })); return settled(); } });
    });
  }
  load(_bytes: unknown, name: string) { return this.call('load', name); }
  solve(options: SolveOptions) { return this.call('solve', options); }
  rivals(options: SolveOptions) { return this.call('rivals', options); }
  written(what: string) { return this.call('written', what); }
  cancel() {
    for (const reject of this.waiting) reject(new Cancelled());
    this.waiting = [];
    this.calls.push({ method: 'cancel' } as Call);
  }
  get last(): Call { return this.calls.at(-1)!; }
  get methods(): string[] { return this.calls.map((c) => c.method); }
}

class FakePage implements Page {
  readonly failures: string[] = [];
  tried: Settings | undefined;
  cancels = 0;
  opened() { /* nothing is drawn */ }
  solved() { /* nothing is drawn */ }
  compared() { /* nothing is drawn */ }
  failed(failure: Failure, _session: Session, tried?: Settings) {
    this.failures.push(failure.code);
    this.tried = tried;
  }
  cancelled() { ++this.cancels; }
  busy() { /* nothing is drawn */ }
  idle() { /* nothing is drawn */ }
}

function fresh() {
  const [core, other, page] = [new FakeCore(), new FakeCore(), new FakePage()];
  const session = new Session(core as unknown as CoreClient, other as unknown as CoreClient, page);
  const open = (name: string) => { void session.open(new Uint8Array(1), name); };
  return { core, other, page, session, open };
}
async function withMesh(vertices = 8) {
  const all = fresh();
  all.open('first.obj');
  await all.core.last.answer(mesh(vertices));
  await all.core.last.answer(surface(vertices));
  expect(all.session.solved!.pointErrors.length).toBe(vertices);
  return all;
}

describe('while a file is opened', () => {
  test('settings wait for it, and are for it', async () => {
    const { core, session, open } = await withMesh();
    open('second.obj');
    const loading = core.last;
    await session.change({ tolerance: 1e-9, levels: 6 });
    expect(core.last).toBe(loading);
    expect(session.wished!.tolerance).toBe(1e-9);
    await loading.answer(mesh(90000));
    expect(session.name).toBe('second.obj');
    // As fine as a mesh of this size may be shown.
    expect(core.last.first).toMatchObject({ tolerance: 1e-9, levels: 1 });
    await core.last.answer(surface(90000));
    expect(session.solved!.pointErrors.length).toBe(90000);
  });

  test('settings are for the file of before, if it is refused', async () => {
    const { core, page, session, open } = await withMesh();
    open('broken.obj');
    const loading = core.last;
    await session.change({ method: 'fair' });
    await loading.refuse('syntax');
    expect(core.last).toMatchObject({ method: 'solve', first: { method: 'fair' } });
    await core.last.answer(surface(8));
    expect([session.name, session.refused!.name, session.shown!.method]).toEqual(['first.obj', 'broken.obj', 'fair']);
    expect(page.failures).toEqual(['syntax']);
  });

  test('nothing is exported under the name of the file of before', async () => {
    const { core, page, session, open } = await withMesh();
    open('second.obj');
    expect(await session.written('control', 'obj')).toBeUndefined();
    expect(page.failures.length).toBe(1);
    expect(core.methods).not.toContain('written');
  });

  test('a later file takes its place, however the first one ends', async () => {
    const { core, page, session, open } = await withMesh();
    open('broken.obj');
    const broken = core.last;
    open('third.obj');
    const third = core.last;
    await broken.refuse('syntax');
    await third.answer(mesh(20));
    await core.last.answer(surface(20));
    expect(session.name).toBe('third.obj');
    expect(session.solved!.pointErrors.length).toBe(20);
    expect(page.failures).toEqual([]);
    // Nothing was read behind the third file.
    expect(core.calls.filter((c) => c.method === 'load').map((c) => c.first)).toEqual(['first.obj', 'broken.obj', 'third.obj']);
  });
});

test('a surface of another mesh is an error, and is not shown', async () => {
  const { core, page, session } = await withMesh();
  const before = session.solved;
  void session.change({ method: 'fair' });
  await core.last.answer(surface(9));
  expect(session.solved).toBe(before);
  expect(page.failures).toEqual(['page']);
});

describe('settings are those of what is shown', () => {
  test('after a choice that was refused', async () => {
    const { core, page, session } = await withMesh();
    void session.change({ scheme: 'doo-sabin' });
    await core.last.refuse('singular');
    expect(session.settings!.scheme).toBe('loop');
    expect(page.failures).toEqual(['singular']);
    expect(page.tried!.scheme).toBe('doo-sabin');
  });

  test('after a solve that was cancelled', async () => {
    const { page, session } = await withMesh();
    void session.change({ method: 'similarity' });
    session.cancel();
    await settled();
    expect([session.settings!.method, session.unsolved, page.cancels]).toEqual(['progressive', false, 1]);
  });

  test('or stay, and wait to be solved, where nothing was shown before', async () => {
    const { core, session, open } = fresh();
    open('first.obj');
    await core.last.answer(mesh(8));
    session.cancel();
    await settled();
    expect(session.unsolved).toBe(true);
    void session.solve();
    await core.last.answer(surface(8));
    expect([session.unsolved, session.solved!.pointErrors.length]).toEqual([false, 8]);
  });
});

describe('a file that is refused', () => {
  test('leaves points as they are', async () => {
    const { core, page, open } = fresh();
    open('cloud.xyz');
    await core.last.answer(points(50));
    open('broken.obj');
    await core.last.refuse('syntax');
    expect(core.methods).toEqual(['load', 'load']);
    expect(page.failures).toEqual(['syntax']);
  });

  test('is what the message is about, though the mesh of before has no surface', async () => {
    const { core, page, session, open } = fresh();
    open('pillow.obj');
    await core.last.answer(mesh(8));
    await core.last.refuse('singular');
    open('broken.obj');
    await core.last.refuse('syntax');
    expect(core.methods).toEqual(['load', 'solve', 'load']);
    expect(page.failures).toEqual(['singular', 'syntax']);
    expect(session.refused!.name).toBe('broken.obj');
  });

  test('does not keep the mesh of before from being solved to the end', async () => {
    const { core, page, session, open } = fresh();
    open('first.obj');
    await core.last.answer(mesh(8));
    open('broken.obj');
    open('broken.off');
    await core.last.refuse('syntax');
    await core.last.answer(surface(8));
    expect([session.name, session.solved!.pointErrors.length, page.failures]).toEqual(['first.obj', 8, ['syntax']]);
  });
});

describe('the comparison of solvers', () => {
  test('has a core of its own, and is given up for whatever else is wanted', async () => {
    const { core, other, session, open } = await withMesh();
    await other.last.answer(mesh(8));
    expect(other.last.method).toBe('rivals');
    void session.written('control', 'obj');
    expect(other.last.method).toBe('cancel');
    expect(core.last.method).toBe('written');
    await core.last.answer({ bytes: new Uint8Array(1), notices: [] });
    void session.change({ tolerance: 1e-9 });
    await core.last.answer(surface(8));
    expect(other.last).toMatchObject({ method: 'rivals', first: { tolerance: 1e-9 } });
    open('second.obj');
    expect(other.last.method).toBe('cancel');
  });

  test('is not made again for another fineness', async () => {
    const { core, other, session } = await withMesh();
    await other.last.answer(mesh(8));
    await other.last.answer({ chebyshev: { history: [], boundaryHistory: [] } });
    void session.change({ levels: 1 });
    await core.last.answer(surface(8));
    expect(session.rivals).toHaveProperty('chebyshev');
    expect(other.methods).toEqual(['load', 'rivals']);
    void session.change({ scheme: 'catmull-clark' });
    await core.last.answer(surface(8));
    expect(session.rivals).toBeUndefined();
  });
});
