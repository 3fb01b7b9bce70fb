// The data of a report as the command line packs it, and the shapes that come out.
import type { Shape } from '../core/protocol';
import type { Kind } from '../viewer/layer';

interface Quantised {
  low: [number, number, number];
  step: number;
  /** 3 unsigned 16-bit numbers a point, in base64. */
  values: string;
}

export interface PackedLayer {
  id: string;
  label: string;
  kind: Kind;
  positions: Quantised;
  /** 3 signed bytes a vertex. */
  normals?: string;
  /** Corners of every face, or of each. */
  degree?: number;
  degrees?: string;
  /** Bytes of a vertex number in the two that follow. */
  index_bytes: 2 | 4;
  corners: string;
  creases: string;
  channels: Record<string, string>;
}

/** Nested values as the JSON report of the command has them (docs/report.schema.json). */
export type Json = null | boolean | number | string | Json[] | { [key: string]: Json };

export interface PageData {
  version: string;
  centre: [number, number, number];
  side: number;
  layers: PackedLayer[];
  points: { positions: Quantised; errors?: string } | null;
  curves: { name: string; points: [number, number][] }[];
  report: { [key: string]: Json };
}

function bytesOf(base64: string): ArrayBuffer {
  return Uint8Array.from(atob(base64), (c) => c.charCodeAt(0)).buffer;
}

export function positionsOf(packed: Quantised, centre: readonly number[], side: number): Float32Array {
  const numbers = new Uint16Array(bytesOf(packed.values));
  const positions = new Float32Array(numbers.length);
  for (let i = 0; i < numbers.length; ++i) {
    const c = i % 3;
    positions[i] = (packed.low[c]! + numbers[i]! * packed.step - centre[c]!) / side;
  }
  return positions;
}

export function floatsOf(base64: string): Float32Array {
  return new Float32Array(bytesOf(base64));
}

function offsetsOf(layer: PackedLayer, corners: number): Uint32Array {
  if (layer.degree !== undefined) {
    return Uint32Array.from({ length: corners / layer.degree + 1 }, (_, f) => f * layer.degree!);
  }
  const degrees = new Uint32Array(bytesOf(layer.degrees ?? ''));
  const offsets = new Uint32Array(degrees.length + 1);
  for (let f = 0; f < degrees.length; ++f) offsets[f + 1] = offsets[f]! + degrees[f]!;
  return offsets;
}

function indicesOf(base64: string, layer: PackedLayer): Uint32Array {
  const bytes = bytesOf(base64);
  return layer.index_bytes === 4 ? new Uint32Array(bytes) : Uint32Array.from(new Uint16Array(bytes));
}

export function shapeOf(layer: PackedLayer, centre: readonly number[], side: number): Shape {
  const corners = indicesOf(layer.corners, layer);
  const shape: Shape = {
    positions: positionsOf(layer.positions, centre, side),
    offsets: offsetsOf(layer, corners.length),
    corners,
    creases: indicesOf(layer.creases, layer),
    channels: Object.fromEntries(Object.entries(layer.channels).map(([name, values]) => [name, floatsOf(values)])),
  };
  if (layer.normals) shape.normals = Float32Array.from(new Int8Array(bytesOf(layer.normals)), (x) => x / 127);
  return shape;
}
