// From faces to what a graphics card draws: triangles, edges, boundary edges.
import type { Shape } from '../core/protocol';

export interface Connectivity {
  triangles: Uint32Array;
  /** 2 an edge. */
  edges: Uint32Array;
  boundary: Uint32Array;
}

/** Polygons as fans. */
export function trianglesOf(shape: Shape): Uint32Array {
  const { offsets, corners } = shape;
  const faces = offsets.length - 1;
  const triangles = new Uint32Array(3 * Math.max(0, corners.length - 2 * faces));
  let at = 0;
  for (let f = 0; f < faces; ++f) {
    const begin = offsets[f]!;
    for (let c = begin + 1; c + 1 < offsets[f + 1]!; ++c) {
      triangles[at++] = corners[begin]!;
      triangles[at++] = corners[c]!;
      triangles[at++] = corners[c + 1]!;
    }
  }
  return triangles.subarray(0, at);
}

/** Half-edges are sorted into buckets by their smaller vertex; a bucket is short, and searched. */
function visitEdges(shape: Shape, visit: (a: number, b: number, faces: number) => void): void {
  const { offsets, corners, positions } = shape;
  const vertices = positions.length / 3;
  const start = new Uint32Array(vertices + 1);
  const eachHalfEdge = (take: (low: number, high: number) => void) => {
    for (let f = 0; f + 1 < offsets.length; ++f) {
      for (let c = offsets[f]!; c < offsets[f + 1]!; ++c) {
        const a = corners[c]!;
        const b = corners[c + 1 === offsets[f + 1] ? offsets[f]! : c + 1]!;
        take(Math.min(a, b), Math.max(a, b));
      }
    }
  };
  eachHalfEdge((low) => { start[low + 1]!++; });
  for (let v = 0; v < vertices; ++v) start[v + 1]! += start[v]!;
  const other = new Uint32Array(corners.length);
  const count = new Uint8Array(corners.length);
  const used = new Uint32Array(vertices);
  eachHalfEdge((low, high) => {
    const begin = start[low]!;
    const end = begin + used[low]!;
    for (let i = begin; i < end; ++i) {
      if (other[i] !== high) continue;
      count[i]!++;
      return;
    }
    other[end] = high;
    count[end] = 1;
    used[low]!++;
  });
  for (let v = 0; v < vertices; ++v) {
    for (let i = start[v]!; i < start[v]! + used[v]!; ++i) visit(v, other[i]!, count[i]!);
  }
}

export function connectivityOf(shape: Shape): Connectivity {
  const edges: number[] = [];
  const boundary: number[] = [];
  visitEdges(shape, (a, b, faces) => {
    edges.push(a, b);
    if (faces === 1) boundary.push(a, b);
  });
  return {
    triangles: trianglesOf(shape),
    edges: Uint32Array.from(edges),
    boundary: Uint32Array.from(boundary),
  };
}
