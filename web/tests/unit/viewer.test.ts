import { describe, expect, test } from 'vitest';
import type { Shape } from '../../src/core/protocol';
import { colourAt, magnitude, shortNumber, texels } from '../../src/viewer/colour';
import { connectivityOf, trianglesOf } from '../../src/viewer/connectivity';
import { counted } from '../../src/viewer/figures';
import { firstView, joined } from '../../src/viewer/fit';
import { dotFor, spacingOf } from '../../src/viewer/points';
import { solverLook } from '../../src/viewer/solvers';
import { defaultView, panesOf } from '../../src/viewer/views';
import { positionsOf, shapeOf, type PackedLayer } from '../../src/report/decode';
import { coloured, sections, titleOf } from '../../src/report/summary';
import { byItself, differences, iterates, mostLevels, settingsFor, solveOptions, suggestedLevels, withChosen, withScheme } from '../../src/studio/settings';
import { stem } from '../../src/studio/save';

/** A quad and two triangles on its right edge's end: 6 vertices. */
const kPatch: Shape = {
  positions: new Float32Array(18),
  offsets: Uint32Array.of(0, 4, 7, 10),
  corners: Uint32Array.of(0, 1, 2, 3, 1, 4, 2, 4, 5, 2),
  creases: new Uint32Array(0),
  channels: {},
};

describe('connectivity', () => {
  test('polygons become fans that keep their turn', () => {
    expect([...trianglesOf(kPatch)]).toEqual([0, 1, 2, 0, 2, 3, 1, 4, 2, 4, 5, 2]);
  });

  test('every edge once, and the boundary is what has one face', () => {
    const { edges, boundary } = connectivityOf(kPatch);
    const named = (pairs: Uint32Array) => Array.from({ length: pairs.length / 2 }, (_, i) => `${pairs[2 * i]}-${pairs[2 * i + 1]}`).sort();
    expect(named(edges)).toEqual(['0-1', '0-3', '1-2', '1-4', '2-3', '2-4', '2-5', '4-5']);
    expect(named(boundary)).toEqual(['0-1', '0-3', '1-4', '2-3', '2-5', '4-5']);
  });
});

describe('colours', () => {
  test('the sequential scale grows lighter all the way', () => {
    const lightness = Array.from({ length: 64 }, (_, i) => {
      const [r, g, b] = colourAt('sequential', i / 63);
      return 0.2126 * r + 0.7152 * g + 0.0722 * b;
    });
    for (let i = 1; i < lightness.length; ++i) expect(lightness[i]).toBeGreaterThan(lightness[i - 1]!);
  });

  test('the diverging scale is lightest in the middle, and its ends are blue and red', () => {
    const data = texels('diverging');
    const sum = (i: number) => data[4 * i]! + data[4 * i + 1]! + data[4 * i + 2]!;
    expect(sum(128)).toBeGreaterThan(sum(0));
    expect(sum(128)).toBeGreaterThan(sum(255));
    expect(data[2]!).toBeGreaterThan(data[0]!);
    expect(data[4 * 255]!).toBeGreaterThan(data[4 * 255 + 2]!);
  });

  test('the magnitude leaves out the largest few', () => {
    const values = Float32Array.from({ length: 100 }, (_, i) => (i % 2 ? i : -i));
    expect(magnitude([values], 1)).toBe(99);
    expect(magnitude([values], 0.9)).toBeCloseTo(89, -1);
    expect(magnitude([], 1)).toBeGreaterThan(0);
    expect(magnitude([Float32Array.of(1e-12, -1e-13)], 1, 1e-6)).toBe(1e-6);
  });

  test('numbers are short', () => {
    expect([0, 0.0192, 2.289645, 5.366e-13, -55.94, 123456].map(shortNumber))
      .toEqual(['0', '0.0192', '2.29', '5.4e\u221213', '\u221255.9', '1.2e5']);
  });
});

describe('the first view', () => {
  test('of a ball touches it all around', () => {
    // Points of a ball of radius 1: the eye sees its outline under the half angle, from 1 / sin of it.
    const angle = 0.3;
    const positions = Float32Array.from({ length: 3 * 4000 }, (_, i) => {
      const [k, u] = [Math.floor(i / 3), 1 - (2 * Math.floor(i / 3) + 1) / 4000];
      return [Math.sqrt(1 - u * u) * Math.cos(2.4 * k), u, Math.sqrt(1 - u * u) * Math.sin(2.4 * k)][i % 3]!;
    });
    for (const up of ['y', 'z'] as const) {
      const { distance, reach, radius } = firstView(positions, up, [0.46, 0.34, 0.82], Math.tan(angle));
      expect(distance).toBeCloseTo(1 / Math.sin(angle), 1);
      expect(reach).toBeCloseTo(1, 1);
      expect(radius).toBeCloseTo(1, 3);
    }
  });

  test('nothing is cut off, wherever around the upright axis the eye is', () => {
    const tangent = 0.3;
    const positions = Float32Array.of(0.5, 0.2, 0, -0.5, -0.2, 0.1, 0, 0.3, -0.2);
    const { distance, reach } = firstView(positions, 'y', [0, 0, 1], tangent);
    for (let turn = 0; turn < 12; ++turn) {
      const [s, c] = [Math.sin((Math.PI * turn) / 6), Math.cos((Math.PI * turn) / 6)];
      for (let i = 0; i < positions.length; i += 3) {
        const [x, y, z] = [positions[i]! * c - positions[i + 2]! * s, positions[i + 1]!, positions[i]! * s + positions[i + 2]! * c];
        expect(Math.abs(y) / (distance - z)).toBeLessThanOrEqual(tangent + 1e-6);
        expect(Math.abs(x) / (distance - z)).toBeLessThanOrEqual(tangent * reach + 1e-6);
      }
    }
  });
});

describe('points on the screen', () => {
  test('have their usual size where there is room, and less than their space elsewhere', () => {
    expect(dotFor(6, 40, 1, true)).toEqual({ size: 6, opacity: 1 });
    expect(dotFor(6, 8, 1, true).size).toBeCloseTo(3.6, 12);
    expect(dotFor(12, 16, 2, true).size).toBeCloseTo(7.2, 12);
  });
  test('fade away before they cover a surface, and never where they are all there is', () => {
    const faded = [12, 6, 4.5, 3, 1].map((spacing) => dotFor(3, spacing, 1, true).opacity);
    expect(faded).toEqual([1, 1, 0.5, 0, 0]);
    expect(dotFor(3, 1, 1, false)).toEqual({ size: 1.5, opacity: 1 });
  });
  test('are as far apart as on a ball', () => {
    const positions = Float32Array.from({ length: 3 * 400 }, (_, i) => (i % 3 === 0 ? 2 : 0));
    expect(spacingOf(positions)).toBeCloseTo(2 * Math.sqrt((4 * Math.PI) / 400), 6);
  });
});

test('several lists of positions are one', () => {
  expect([...joined([Float32Array.of(1, 2, 3), new Float32Array(), Float32Array.of(4, 5, 6)])]).toEqual([1, 2, 3, 4, 5, 6]);
});

test('a solver has one name and one colour, and one that was not needed says so', () => {
  expect(solverLook('chebyshev')).toEqual({ name: 'Chebyshev', colour: { full: 1, dashed: 3 } });
  expect(solverLook('').name).toBe('none needed');
  expect([counted(1, 'face', 'faces'), counted(2, 'face', 'faces')]).toEqual(['1 face', '2 faces']);
});

test('the panes of a split meet at the divider', () => {
  const view = { ...defaultView(), mode: 'split' as const, split: 0.3 };
  expect(panesOf(view)).toEqual([{ ids: ['plain'], from: 0, to: 0.3 }, { ids: ['surface'], from: 0.3, to: 1 }]);
});

describe('a report’s data', () => {
  const base64 = (bytes: ArrayBufferLike) => Buffer.from(bytes as ArrayBuffer).toString('base64');
  test('positions come back within half a step', () => {
    const step = 4 / 65535;
    const points = [0.1, -1, 2, 3.9, 0, 1];
    const packed = { low: [0, -1, 0] as [number, number, number], step,
      values: base64(Uint16Array.from(points, (x, i) => Math.round((x - [0, -1, 0][i % 3]!) / step)).buffer) };
    const found = positionsOf(packed, [2, 0, 1], 4);
    points.forEach((x, i) => expect(Math.abs(found[i]! * 4 + [2, 0, 1][i % 3]! - x)).toBeLessThan(0.51 * step));
  });

  test('faces of one size and of several', () => {
    const layer: PackedLayer = { id: 'a', label: 'A', kind: 'mesh', positions: { low: [0, 0, 0], step: 1, values: '' },
      corners: base64(Uint32Array.of(0, 1, 2, 2, 1, 3).buffer), creases: '', channels: {}, degree: 3, index_bytes: 4 };
    expect([...shapeOf(layer, [0, 0, 0], 1).offsets]).toEqual([0, 3, 6]);
    const mixed: PackedLayer = { ...layer, degrees: base64(Uint32Array.of(4, 2).buffer) };
    delete mixed.degree;
    expect([...shapeOf({ ...layer, corners: base64(Uint16Array.of(3, 1, 2).buffer), index_bytes: 2 }, [0, 0, 0], 1).corners]).toEqual([3, 1, 2]);
    expect([...shapeOf(mixed, [0, 0, 0], 1).offsets]).toEqual([0, 4, 6]);
  });

  test('figures are those that the report has', () => {
    const found = sections({ command: 'interpolate', scheme: 'loop', error: { max: 2e-13, mean: 1e-14 } });
    expect(found.map((s) => s.title)).toEqual(['Certificate, of the box side', 'Surface']);
    expect(found[0]!.figures[0]).toEqual({ name: 'Largest error', value: '2e\u221213' });
  });
});

test('a report is called by its file, and its curves are coloured by their solver', () => {
  expect(titleOf({ input: { path: 'a/b/jug.obj' } }, ['Given mesh'])).toBe('jug.obj');
  expect(titleOf({ a: { path: 'x.obj' }, b: { path: 'y.obj' } }, [])).toBe('x.obj, y.obj');
  expect(titleOf({}, ['One', 'Two', 'Three'])).toBe('One, Two');
  const points: [number, number][] = [[0, 1], [1, 0.1]];
  expect(coloured({ solver: 'chebyshev' }, ['This solver', 'Richardson', 'Chebyshev, on curves'].map((name) => ({ name, points }))))
    .toEqual([{ name: 'Chebyshev', points, colour: 1 }, { name: 'Richardson', points, colour: 0 }, { name: 'Chebyshev, on curves', points, colour: 3 }]);
  const iterations = (on: number) => sections({ scheme: 'loop', iterations: 5, boundary_iterations: on })[0]!.figures.map((f) => f.name);
  expect(iterations(0)).toEqual(['Scheme', 'Iterations']);
  expect(iterations(2)).toContain('Iterations on curves');
});

describe('settings', () => {
  const loaded = { kind: 'mesh' as const, format: 'obj', notices: [], vertices: 900, faces: 1800, triangles: true,
    scheme: 'loop', boxSide: 1, given: kPatch,
    shapes: { lowest: -3.99, highest: 3.99, round: -3, standard: -1.5, flat: 0 } };
  test('what is shown stays within what a page can hold', () => {
    expect(suggestedLevels(8)).toBe(4);
    expect(suggestedLevels(900)).toBe(2);
    expect(suggestedLevels(250000)).toBe(0);
    expect(mostLevels(250000)).toBe(1);
  });
  test('only the progressive method is stopped early', () => {
    const settings = { ...settingsFor(loaded), stopAfter: 3 };
    expect(solveOptions(settings).maxIterations).toBe(3);
    expect(solveOptions({ ...settings, method: 'fair' }).maxIterations).toBe(1000);
    expect(solveOptions({ ...settings, stopAfter: undefined }).maxIterations).toBe(10000);
  });
  test('the shape parameter starts at the library’s own, and a scheme that interpolates by itself does not iterate', () => {
    const settings = settingsFor(loaded);
    expect(solveOptions(settings).shape).toBe(-1.5);
    expect(settingsFor({ ...loaded, shapes: { ...loaded.shapes, standard: -2 } }).shape).toBe(-2);
    const itself = { ...settings, scheme: 'nonstationary-loop' };
    expect([iterates(settings), iterates(itself), iterates({ ...settings, method: 'fair' })]).toEqual([true, false, false]);
    expect([byItself(settings), byItself(itself)]).toEqual([false, true]);
  });
  test('a scheme keeps what it can of the other choices', () => {
    const settings = { ...settingsFor(loaded), boundary: 'hoppe', method: 'fair', levels: 0 };
    expect(withScheme(settings, 'catmull-clark', 900)).toMatchObject({ boundary: 'edge-and-corner', method: 'fair', levels: 0 });
    expect(withScheme(settings, 'doo-sabin', 900)).toMatchObject({ boundary: 'edge-and-corner', method: 'fair', levels: 0 });
    expect(withScheme(settings, 'nonstationary-loop', 20000)).toMatchObject({ boundary: 'edge-and-corner', method: 'progressive', levels: 1 });
    expect(withScheme(settings, 'nonstationary-loop', 2000000).levels).toBe(0);
    expect(withScheme({ ...settings, levels: 3 }, 'nonstationary-loop', 900).levels).toBe(3);
  });
  test('a visit to a scheme without methods does not forget the method', () => {
    const settings = { ...settingsFor(loaded), method: 'fair' };
    const away = { ...settings, ...withScheme(settings, 'nonstationary-loop', 900) };
    expect([away.method, withScheme(away, 'loop', 900).method]).toEqual(['progressive', 'fair']);
  });
  test('what was chosen before a mesh was there is taken as far as the mesh allows it', () => {
    const settings = settingsFor(loaded);
    expect(withChosen(settings, {}, loaded)).toBe(settings);
    expect(withChosen(settings, { levels: 6, shape: -9, stopAfter: 3, method: 'fair' }, { ...loaded, vertices: 90000 }))
      .toMatchObject({ levels: 1, shape: -3.99, stopAfter: undefined, method: 'fair', scheme: 'loop' });
    const quads = { ...loaded, triangles: false, scheme: 'catmull-clark' };
    expect(withChosen(settingsFor(quads), { scheme: 'loop', boundary: 'hoppe' }, quads))
      .toMatchObject({ scheme: 'catmull-clark', boundary: 'edge-and-corner' });
  });
  test('what was refused is said in the words of the form', () => {
    const settings = settingsFor(loaded);
    expect(differences({ ...settings, scheme: 'doo-sabin', method: 'similarity', levels: 5 }, settings)).toBe('Doo-Sabin, Similarity, fineness 5');
  });
  test('names of files', () => {
    expect(['a/b/jug.obj', 'x', 'my.mesh.ply', '.obj'].map(stem)).toEqual(['jug', 'x', 'my.mesh', 'mesh']);
  });
});
